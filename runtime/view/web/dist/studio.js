"use strict";(()=>{var Ct,Ep,pv,Vs,_h,fl,Tp,cl,Ap,vh,xh,mv,Zo=Symbol.for("pv"),pl={},ml=[],gv=/^m(i|n|o|s|text|space)$/,yh=Array.isArray,Rp=ml.slice,cr=Object.assign;function lr(n){n&&n.parentNode&&n.remove()}function ul(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Zo,__v:s||++Ep,__i:-1,__u:0};return!s&&Ct.vnode&&Ct.vnode(r),r}function Lt(n){return n.children}function hl(n,e){this.props=n,this.context=e,this.__g=0}function Hs(n,e){if(e==null)return n.__&&Hs(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:Hs(n)}function _v(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=cr({constructor:Zo},t)).__v=t.__v+1,Ct.vnode&&Ct.vnode(e),bh(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||Hs(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,Np(s,e,r),t.__=t.__e=null,e.__e!=i&&Cp(e))}function Cp(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),Cp(n)}function Mp(n){(8&n.__g||(n.__g|=8,Vs.push(n),fl++))&&_h==Ct.debounceRendering||((_h=Ct.debounceRendering)||queueMicrotask)(Pp)}function Pp(){try{for(var n,e=1;Vs.length;)Vs.length>e&&Vs.sort(Tp),n=Vs.shift(),e=Vs.length,8&n.__g&&_v(n)}finally{(fl=Vs.length)&&(_h||queueMicrotask)(Pp)}}function Ip(n,e,t,i,s,r,o,a,l,c,u){var h,d,f,g,v,m,p=i.__k||ml,y=e.length;for(l=xv(t,e,p,l,y),h=0;h<y;h++)(f=t.__k[h])!=null&&(d=~f.__i&&p[f.__i]||pl,f.__i=h,m=bh(n,f,d,s,r,o,a,l,c,u),g=f.__e,(d.ref!=f.ref||8&d.__u)&&(d.ref&&Sh(d.ref,null,f,d),f.ref&&u.push(f.ref,f.__c||g,f)),v=v||g,4&f.__u?(l=Lp(f,l,n,!d.__v),d.__e&&(d.__e=null)):typeof f.type=="function"&&m!==void 0?l=m:g&&(l=g.nextSibling),f.__u&=-21);return t.__e=v,l}function xv(n,e,t,i,s){var r,o,a,l,c,u,h,d,f,g=t.length,v=g,m=0,p=0,y=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=y[r]=ul(null,o):yh(o)?o=y[r]=ul(Lt,{children:o}):o.constructor===Zo&&o.__b?o=y[r]=ul(o.type,o.props,o.key,o.ref,o.__v):y[r]=o,l=r+m,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=vv(o,t,l,v))&&(v--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?m--:c==l+1?m++:c!=l&&(c>l?m--:m++,p=1)):(~c||(s>g?m--:s<g&&m++),typeof o.type!="function"&&(o.__u|=4))):y[r]=null;if(p){for(u=[],h=[],r=0;r<s;r++)if((o=y[r])&&16&o.__u){for(m=0,d=u.length;m<d;)u[f=m+d>>1]<o.__i?m=f+1:d=f;u[m]=o.__i,h[r]=m+1}for(m=u.length;r--;)h[r]&&(h[r]==m?m--:y[r].__u|=4)}if(v)for(r=0;r<g;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=Hs(a)),Mh(a,a));return i}function Lp(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=Lp(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=Hs(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function vv(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function wp(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function ll(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||wp(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||wp(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=xh[e]||(xh[e]=yv(e)),(n.__a||(n.__a={}))[e]=vh,r=e!=(e=e.replace(Ap,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function yv(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[cl]==null)e[cl]=vh++;else if(e[cl]<this.__a[n])return;return t(Ct.event?Ct.event(e):e)}}}function bh(n,e,t,i,s,r,o,a,l,c){var u,h,d,f,g,v,m,p,y,A,S,C,R,x,E,U,D,L,k=e.type;if(e.constructor!==Zo)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,h=r=[],u.nodeType==8?a=dl(u,r):r.push(u),a=r[0]||a),(u=Ct.__b)&&u(e);e:if(typeof k=="function"){d=o.length;try{if(p=e.props,y=(u=k.prototype)&&u.render,A=(u=k.contextType)&&i[u.__c],S=u?A?A.props.value:u.__:i,(f=t.__c)?(e.__c=f,2&f.__g&&(f.__g|=1)):(y?e.__c=f=new k(p,S):(e.__c=f=new hl(p,S),f.constructor=k,f.render=Sv),A&&A.sub(f),f.state||(f.state={}),f.__n=i,f.__g|=8,f.__h=[],f.__k=[]),y&&(f.__s||(f.__s=f.state),k.getDerivedStateFromProps&&(f.__s==f.state&&(f.__s=cr({},f.__s)),cr(f.__s,k.getDerivedStateFromProps(p,f.__s)))),g=f.props,v=f.state,f.__v=e,t.__c){if(p!==g&&y&&!k.getDerivedStateFromProps&&f.componentWillReceiveProps&&f.componentWillReceiveProps(p,S),e.__v==t.__v&&!(8&f.__g)||!(4&f.__g)&&f.shouldComponentUpdate&&f.shouldComponentUpdate(p,f.__s,S)===!1){e.__v!=t.__v&&(f.props=p,f.state=f.__s,f.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(z){z&&(z.__=e)}),ml.push.apply(f.__h,f.__k),f.__k=[],f.__h.length&&o.push(f),a=Hs(t);break e}f.componentWillUpdate&&f.componentWillUpdate(p,f.__s,S),y&&f.componentDidUpdate&&f.__h.push(function(){f.componentDidUpdate(g,v,m)})}else y&&!k.getDerivedStateFromProps&&f.componentWillMount&&f.componentWillMount(),y&&f.componentDidMount&&f.__h.push(f.componentDidMount);f.context=S,f.props=p,f.__P=n,f.__g&=-5,C=Ct.__r,R=y?25:0;do f.__g&=-9,C&&C(e),u=f.render(f.props,f.state=f.__s,f.context);while(8&f.__g&&++R<25);y&&(ml.push.apply(f.__h,f.__k),f.__k=[]),f.state=f.__s,f.getChildContext&&(i=cr({},i,f.getChildContext())),y&&t.__c&&f.getSnapshotBeforeUpdate&&(m=f.getSnapshotBeforeUpdate(g,v)),x=u&&u.type===Lt&&u.key==null?u.props.children:u,p.__P&&(u=a,s=(n=p.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(z){z&&Mh(z,z)}),t.__k=null),a=t.__k?Hs(t,0):null),a=Ip(n,yh(x)?x:[x],e,t,i,s,r,o,a,l,c),p.__P&&(e.__e=null,a=u),e.__u&=-161,h&&h.some(lr),f.__h.length&&o.push(f),1&f.__g&&(f.__g&=-4)}catch(z){if(o.length=d,e.__v=null,l||r)if(z&&z.then){if(e.__u|=128|l,r){for(~(D=r.indexOf(a||void 0))||(D=r.length);(L=r[D-1])&&L.nodeType==8;)D--;for(;D<r.length;D++)if(L=r[D])if(r[D]=null,E){if(L==U)break}else{if(L.nodeType!=8)break;L.data.startsWith("$s")&&(U=dl(E=L))}}if(!E){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;E=a}(u=dl(E=e.__c.__z||(e.__c.__z=E)))?(e.__e=E,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(lr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),z&&z.then||Dp(e),Ct.__e(z,e,t)}}else a=e.__e=bv(t.__e,e,t,i,s,r,o,l,c,n);return(u=Ct.diffed)&&u(e),a}function dl(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function Dp(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(Dp))}function Np(n,e,t){for(var i=0;i<t.length;)Sh(t[i++],t[i++],t[i++]);Ct.__c&&Ct.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Ct.__e(r,s.__v)}})}function bv(n,e,t,i,s,r,o,a,l,c){var u,h,d,f,g,v,m,p,y=t.props||pl,A=e.props,S=e.type;if(S=="svg"?s="http://www.w3.org/2000/svg":S=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((g=r[u])&&(S?g.localName==S:g.nodeType==3)){n=g,r[u]=null;break}}if(!n){if(p=c.ownerDocument||document,!S)return p.createTextNode(A);n=p.createElementNS(s,S,A.is?A:c),a&&(Ct.__m&&Ct.__m(e,r),a=!1),r=null}if(S){if(c=S=="template"&&n.content||n,r=S=="textarea"&&A.defaultValue!=null?null:r&&Rp.call(c.childNodes),!a&&r)for(y={},u=0;u<n.attributes.length;u++)y[(g=n.attributes[u]).name]=g.value;for(u in y)g=y[u],u=="dangerouslySetInnerHTML"?d=g:u=="children"||u in A||u=="value"&&"defaultValue"in A||u=="checked"&&"defaultChecked"in A||ll(n,u,null,g,s);for(u in A)g=A[u],u=="children"?f=g:u=="dangerouslySetInnerHTML"?h=g:u=="value"?v=g:u=="checked"?m=g:a&&typeof g!="function"||y[u]===g||ll(n,u,g,y[u],s);h?(a||d&&(h.__html==d.__html||h.__html==n.innerHTML)||(n.innerHTML=h.__html),e.__k=[]):(d&&(n.textContent=""),(S=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&gv.test(S))&&(s="http://www.w3.org/1999/xhtml"),Ip(c,yh(f)?f:[f],e,t,i,s,r,o,r?r[0]:t.__k&&Hs(t,0),a,l),r&&r.some(lr)),a&&S!="textarea"||(u="value",S=="progress"&&v==null?n.removeAttribute(u):v==null||v===n[u]&&(S!="progress"||v)||ll(n,u,v,y[u],s),u="checked",m!=null&&m!=n[u]&&ll(n,u,m,y[u],s))}else y===A||a&&n.data==A||(n.data=A);return n}function Sh(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Ct.__e(s,t)}}function Mh(n,e,t){var i,s,r,o;if(Ct.unmount&&Ct.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||Sh(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Ct.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&Mh(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=dl(i,r=[]))&&(i==n.__e&&r.some(lr),lr(s),lr(i)),t||lr(n.__e),n.__e=n.__c=n.__=null}function Sv(n,e,t){return this.constructor(n,t)}function Ko(n,e){var t,i,s,r;Ct.__&&Ct.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=ul(Lt,{children:[n]}),s=[],r=[],bh(e,e.__k,i||pl,pl,e.namespaceURI,i?null:e.firstChild?Rp.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),Np(s,e.__k,r),e.__k.props.children=null}Ct={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw fl=0,n}},Ep=0,pv=function(n){return n!=null&&n.constructor===Zo},hl.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=cr({},this.state)),typeof n=="function"&&(n=n(cr({},t),this.props)),n&&(cr(t,n),this.__v&&(e&&this.__k.push(e),Mp(this)))},hl.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),Mp(this))},hl.prototype.render=Lt,Vs=[],fl=0,Tp=function(n,e){return n.__v.__b-e.__v.__b},cl=Symbol(),Ap=/(PointerCapture)$|Capture$/i,vh=0,xh={},mv=0;var Hr,_n,wh,Fp,Eh=Object.is,gl=0,Wp=[],Th=[],ln=Ct,Up=ln.__b,Op=ln.__r,kp=ln.diffed,Bp=ln.__c,zp=ln.unmount,Vp=ln.__;function _l(n,e){ln.__h&&ln.__h(_n,n,gl||e),gl=0;var t=_n.__H||(_n.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function Ut(n){return gl=1,Rh(qp,n)}function Rh(n,e,t){var i=_l(Hr++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):qp(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);Eh(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=_n,!_n.__f)){_n.__f=!0;var s=_n.shouldComponentUpdate;_n.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(d){d.__N&&(c=!0,Eh(d.__[0],d.__N[0])||(u=!0))}),s){var h=s.call(this,r,o,a);return c?h||u:h}return!c||u}}return i.__}function Dt(n,e){var t=_l(Hr++,3);!ln.__s&&Ch(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,_n.__H.__h.push(t))}function Xp(n,e){var t=_l(Hr++,4);!ln.__s&&Ch(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,_n.__h.push(t))}function jt(n){return gl=5,Mv(function(){return{current:n}},[])}function Mv(n,e){var t=_l(Hr++,7);return Ch(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function wv(){var n;do{for(;n=Th.shift();)try{jo(n)}catch(t){ln.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=Wp.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(jo),e.__h.some(Ah),e.__h=[]}catch(t){e.__h=[],ln.__e(t,n.__v)}}}while(Th.length)}ln.__b=function(n){_n=null,Up&&Up(n)},ln.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),Vp&&Vp(n,e)},ln.__r=function(n){Op&&Op(n),Hr=0;var e=(_n=n.__c).__H;e&&(wh==_n?_n.__h=[]:(e.__h.some(jo),e.__h.some(Ah),Hr=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),wh=_n},ln.diffed=function(n){kp&&kp(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&Gp(Wp.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),wh=_n=null},ln.__c=function(n,e){e.some(function(t){try{t.__h.some(jo),t.__h=t.__h.filter(function(i){return!i.__||Ah(i)})}catch(i){t.__h=[function(){throw i}]}}),Bp&&Bp(n,e)},ln.unmount=function(n){zp&&zp(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,Gp(Th.push(s))}else jo(s)}catch(r){e=r}}),i.__H=void 0,e&&ln.__e(e,i.__v))};var Hp=typeof requestAnimationFrame=="function";function Ev(n){var e,t=function(){clearTimeout(i),Hp&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Hp&&(e=requestAnimationFrame(t))}function Gp(n){n!=1&&Fp==ln.requestAnimationFrame||((Fp=ln.requestAnimationFrame)||Ev)(wv)}function jo(n){var e=_n,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),_n=e}function Ah(n){var e=_n;n.__c=n.__(),_n=e}function Ch(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!Eh(t,n[i])})}function qp(n,e){return typeof e=="function"?e(n):e}function ii(n){if(n==null||Number.isNaN(n))return"–";if(n===0)return"0";let e=Math.abs(n);return e>=1e6||e<1e-4?n.toExponential(3).replace("e+","e"):String(Number(n.toPrecision(5)))}function Qo(n){return n<.095?`${Math.ceil(1e3*n)} ms`:n<9.5?`${n.toFixed(1)} s`:n<600?`${Math.round(n)} s`:n<7200?`${Math.round(n/60)} min`:`${(n/3600).toFixed(1)} h`}function $p(n){return n<1e6?"below 1 MB":n<1e9?`${Math.ceil(1e-6*n)} MB`:`${(1e-9*n).toFixed(1)} GB`}function Yp(n){let e=100*n;return e>=1?`${e.toFixed(1)} %`:`${Number(e.toPrecision(1))} %`}function xl(n){if(n===null)return"";let e=new Date(1e3*n),t=e.toDateString()===new Date().toDateString(),i=e.toLocaleTimeString(void 0,{hour:"2-digit",minute:"2-digit"});return t?i:`${e.toLocaleDateString()} ${i}`}function rn(n){return n==="preview"?"Automatic run":n==="model"?"Run from the command line":n==="opened"?"Opened run":`Run ${Number(n.replace("run-",""))}`}function cn(n){return n.replaceAll("_"," ")}function Gr(n){return n.replace(/([^\n])\n(?!\n)/g,"$1 ")}function Wr(n){return n.split("/").pop()??n}function Jp(n,e){return e?`${n} ${e}`:n}function ea(n){return/^\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*$/.test(n)}function ta(n){let e=n.positions??0;return n.incomplete?n.total!==null&&n.total>=e?`${e} of ${n.total}`:String(e):n.positions===null?"":String(e)}function ts(n){let e=n.total===null?n.positions===1:n.total===1;return`${ta(n)} ${e?"position":"positions"}`}function vl(n){return n==="vtu"?"meshes with stresses":cn(n)}function yl(n){return n==="TRUE"?"yes":n==="FALSE"?"no":n}var Tv=Symbol.for("pv"),Av=0;function _(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Tv,__v:--Av,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),Ct.vnode&&Ct.vnode(c),c}function Mi({text:n}){return _(Lt,{children:n.split("`").map((e,t)=>t%2===1?_("code",{children:e},t):e)})}function bl({text:n,isError:e}){return _("pre",{class:`rendered ${e?"error":"warning"}`,role:e?"alert":void 0,tabIndex:0,"aria-label":"Diagnostics of the model",children:n.trim()})}function Ph({messages:n}){return n.length===0?null:_("ul",{class:"messages",children:n.map((e,t)=>_("li",{class:e.severity,children:[e.code&&_("code",{children:e.code})," ",_(Mi,{text:e.message}),e.primary&&_("span",{class:"place",children:[" ",Wr(e.primary.file),":",e.primary.line]}),e.help&&_("span",{class:"help",children:_(Mi,{text:e.help})})]},t))})}var Rv=200,Cv=1e3,Zp=24;function Kp({studio:n,param:e}){let t=n.value(e),i=e.name in n.values,s=n.check?.errors[e.name],r=`param-${e.name}`,a=e.kind==="number"||e.kind==="integer"||e.kind==="array"?e.domain:"",l=cn(e.name.split(".").pop()??e.name),c=l.length+a.length<Zp+12&&a.length<=Zp,u=[a&&c&&`${r}-range`,`${r}-doc`,s&&`${r}-error`].filter(Boolean).join(" ");return _("div",{class:`field ${i?"changed":""} ${s?"invalid":""}`,"data-param":e.name,children:[_(Ih,{id:r,label:l,title:e.name,range:c&&a?a:void 0,reset:i?`Reset ${cn(e.name)} to ${e.default??"its default"}`:null,onReset:()=>n.reset(e.name),children:e.kind==="boolean"&&_("input",{id:r,type:"checkbox",checked:t.toUpperCase()==="TRUE","aria-describedby":u,onChange:h=>n.setValue(e.name,h.currentTarget.checked?"TRUE":"FALSE")})}),e.kind!=="boolean"&&_(Pv,{studio:n,param:e,id:r,text:t,describedBy:u,isInvalid:!!s}),_(Iv,{studio:n,param:e,text:t}),_("p",{class:"doc",id:`${r}-doc`,children:[Gr(e.doc),!e.independent&&_("span",{class:"note",children:" Default and range follow other params."}),a&&!c&&_("span",{class:"range",children:a})]}),s&&_(Lh,{id:`${r}-error`,error:s})]})}function Ih({id:n,label:e,title:t,range:i,reset:s,onReset:r,children:o}){return _("div",{class:"field-head",children:[o,_("label",{for:n,title:t,children:e}),i&&_("span",{class:"range",id:`${n}-range`,children:i}),s!==null&&_("button",{type:"button",class:"quiet small","aria-label":s,title:s,onClick:r,children:"reset"})]})}function Lh({id:n,error:e}){return _("p",{class:"field-error",id:n,role:"alert",children:[_(Mi,{text:e.message}),e.help&&_("span",{class:"help",children:_(Mi,{text:e.help})})]})}function Pv({studio:n,param:e,id:t,text:i,describedBy:s,isInvalid:r}){let o=l=>n.setValue(e.name,l);if(e.kind==="choice"){let l=e.choices.includes(i)?e.choices:[i,...e.choices];return _("div",{class:"control",children:_("select",{id:t,value:i,"aria-describedby":s,"aria-invalid":r,onChange:c=>o(c.currentTarget.value),children:l.map(c=>_("option",{value:c,children:c},c))})})}let a=e.unit!==""&&(ea(i)||i===""||/^\s*\[[^\]]*\]\s*$/.test(i));return _("div",{class:"control",children:[_("input",{id:t,type:"text",inputMode:e.kind==="integer"?"numeric":void 0,value:i,placeholder:e.default??"",autocomplete:"off",spellcheck:!1,"aria-describedby":s,"aria-invalid":r,onInput:l=>o(l.currentTarget.value)}),e.unit&&_("span",{class:`unit ${a?"":"off"}`,children:e.unit})]})}function Iv({studio:n,param:e,text:t}){let{low:i,high:s}=e;if(e.kind!=="number"&&e.kind!=="integer"||!e.independent||i===null||s===null||!(s>i)||!ea(t)||i>0&&s/i>Rv||e.kind==="integer"&&s-i>Cv)return null;let r=e.kind==="integer"?1:10**Math.floor(Math.log10((s-i)/100));return _("input",{type:"range",class:"slider",min:i,max:s,step:r,value:t,"aria-label":`${cn(e.name)}, slider`,onInput:o=>n.setValue(e.name,String(Number(o.currentTarget.value)))})}function Qp({studio:n}){let{analysisSettings:e,analysis:t}=n,i=e.filter(u=>u.detail),s=n.check?.setting_errors??{},r=Object.keys(t).length,o=n.settings.analysisOpen||Object.keys(s).length>0,[a,l]=Ut(!1),c=i.some(({name:u})=>u in t||u in s);return Dt(()=>{c&&l(!0)},[c]),e.length===0?null:_("details",{class:"analysis",open:o,onToggle:u=>{u.target===u.currentTarget&&n.setAnalysisOpen(u.currentTarget.open)},children:[_("summary",{children:["Analysis settings",r>0&&_("span",{class:"summary-value",children:[r," changed"]})]}),_("fieldset",{children:[_("legend",{class:"hidden-text",children:"Analysis settings"}),e.filter(u=>!u.detail).map(u=>_(jp,{studio:n,setting:u},u.name)),_("details",{open:a,onToggle:u=>l(u.currentTarget.open),children:[_("summary",{children:"Positions, mesh and contact grid"}),i.map(u=>_(jp,{studio:n,setting:u},u.name))]})]})]})}function jp({studio:n,setting:e}){let{name:t,label:i,doc:s,domain:r}=e,o=n.analysis[t]??"",a=n.check?.setting_errors[t],l=`setting-${t}`,c=[`${l}-doc`,a&&`${l}-error`].filter(Boolean).join(" "),u=t in n.analysis;return _("div",{class:`field ${u?"changed":""} ${a?"invalid":""}`,"data-setting":t,children:[_(Ih,{id:l,label:i,title:t,reset:u?`Reset ${i} to the model's own`:null,onReset:()=>n.setAnalysis(t,""),children:e.kind==="boolean"&&_("input",{id:l,type:"checkbox",checked:o==="TRUE","aria-describedby":c,onChange:h=>n.setAnalysis(t,h.currentTarget.checked?"TRUE":"")})}),e.kind!=="boolean"&&_("div",{class:"control",children:_(Lv,{studio:n,setting:e,id:l,text:o,describedBy:c,isInvalid:!!a})}),_("p",{class:"doc",id:`${l}-doc`,children:[s,r&&_("span",{class:"range",children:r})]}),a&&_(Lh,{id:`${l}-error`,error:a})]})}function Lv({studio:n,setting:e,id:t,text:i,describedBy:s,isInvalid:r}){let{name:o,choices:a}=e;if(e.kind==="choice"){let l=o==="fidelity"&&i===""?n.check?.plan?.fidelity:void 0;return _("select",{id:t,value:i,"aria-describedby":s,"aria-invalid":r,onChange:c=>n.setAnalysis(o,c.currentTarget.value),children:[_("option",{value:"",children:["As in the model",l&&`: ${l}`]}),a.map(c=>_("option",{value:c.name,children:[c.name,": ",c.doc]},c.name))]})}return _("input",{id:t,type:"text",value:i,placeholder:"as in the model",autocomplete:"off",spellcheck:!1,"aria-describedby":s,"aria-invalid":r,onInput:l=>n.setAnalysis(o,l.currentTarget.value)})}var ns=class extends Error{constructor(t,i,s,r){super(t);this.status=i;this.help=s;this.body=r}status;help;body};async function Sl(n,e={}){let t;try{t=await fetch(n,e)}catch(o){throw o instanceof DOMException&&o.name==="AbortError"?o:new ns("the studio does not respond",0,"start `calyx studio` again",null)}if(t.ok)return t;let i=await t.json().catch(()=>null),{message:s,help:r}=i??{};throw new ns(s??t.statusText,t.status,r??"",i)}async function is(n,e){return(await Sl(n,{signal:e})).json()}async function Dh(n){return(await Sl(n)).arrayBuffer()}async function em(n,e){let t=await xs("POST","/api/scene",n,e),i=s=>Uint8Array.from(atob(s),r=>r.charCodeAt(0)).buffer;return{parts:i(t.parts),position:i(t.position)}}var Dv=6e4;async function tm(n){let e=JSON.stringify(n);await Sl("/api/session",{method:"PUT",keepalive:new Blob([e]).size<Dv,headers:{"Content-Type":"application/json"},body:e})}async function xs(n,e,t,i){let r=await(await Sl(e,{method:n,signal:i,headers:{"Content-Type":"application/json"},body:JSON.stringify(t??{})})).text();return r?JSON.parse(r):null}function wi(n,e=""){return`/api/runs/${encodeURIComponent(n)}${e}`}async function nm(n){let e=await n.text(),{params:t}=await xs("POST","/api/params",{name:n.name,text:e});return t}function Nv(n){let e=(n.model?.params??[]).filter(t=>t.independent||t.name in n.values).map(t=>{let i=n.value(t).trim();if(t.kind==="boolean")return[t.name,i.toUpperCase()==="TRUE"];let s=(t.kind==="number"||t.kind==="integer")&&ea(i);return[t.name,s?Number(i):i]});return`${JSON.stringify(Object.fromEntries(e),null,2)}
`}function im(n,e){let t=URL.createObjectURL(new Blob([Nv(n)],{type:"application/json"})),i=document.createElement("a");i.href=t,i.download=e,i.click(),URL.revokeObjectURL(t)}var Fv=20;function sm({studio:n}){let[e,t]=Ut(""),i=n.model;if(!i)return _("p",{class:"empty",children:n.withoutModel?"The model of this run is not known.":"Loading …"});let s=i.params.length>Fv,r=s?i.params.filter(o=>Uv(n,o,e)):i.params;return _("form",{class:"params","aria-label":"Params",onSubmit:o=>o.preventDefault(),children:[_(kv,{studio:n}),_(Qp,{studio:n}),i.params.length===0&&_("p",{class:"empty",children:"The model has no params."}),s&&_("input",{type:"search",class:"search",placeholder:`Find one of ${i.params.length} params`,"aria-label":"Find a param",value:e,onInput:o=>t(o.currentTarget.value)}),i.params.length>0&&r.length===0&&_("p",{class:"empty",role:"status",children:"No param contains these words."}),Ov(r).map(([o,a])=>_("fieldset",{children:[_("legend",{class:o?"":"hidden-text",children:o||"Params"}),a.map(l=>_(Kp,{studio:n,param:l},l.name))]},o))]})}function Uv(n,e,t){let i=`${e.name} ${cn(e.name)} ${e.group} ${e.doc}`.toLowerCase();return t.toLowerCase().split(/\s+/).every(r=>i.includes(r))||n.check?.errors[e.name]!==void 0}function Ov(n){let e=new Map;for(let t of n){let i=e.get(t.group);i?i.push(t):e.set(t.group,[t])}return[...e]}function kv({studio:n}){let e=n.changes,t=jt(null),i=async s=>{if(s)try{n.setValues(await nm(s))}catch(r){n.fail(r)}};return _("div",{class:"toolbar",children:[_("span",{class:"count",role:"status",children:e===0?"Defaults":`${e} changed`}),_("button",{type:"button",class:"quiet",disabled:e===0,onClick:()=>n.resetAll(),children:"Reset all"}),_("button",{type:"button",class:"quiet",onClick:()=>t.current?.click(),children:"Load …"}),_("button",{type:"button",class:"quiet",onClick:()=>im(n,`${Wr(n.model?.model??"model")}.json`),children:"Save"}),_("input",{ref:t,type:"file",accept:".json,.toml",class:"hidden-text",tabIndex:-1,"aria-label":"Params file",onChange:s=>{let r=s.currentTarget;i(r.files?.[0]).finally(()=>r.value="")}})]})}var Nh=["#2f6fb3","#c8641b","#2c8a57","#8c4fa8","#b3324b","#6b7280","#0f8b8d","#a8861b"],rm=Nh.length;function Xr(n){return Nh[n%Nh.length]??"#2f6fb3"}var Bv=[["max","Maximum"],["mean","Mean"],["min","Minimum"],["peak_to_peak","Peak to peak"]],zv=6;function om({studio:n}){let e=n.settings.selected,t=e.flatMap(i=>n.results[i]??[]);return _("section",{class:"panel","aria-labelledby":"outputs-heading",children:[_("h2",{id:"outputs-heading",children:"Outputs"}),e.length<=1&&_(Vv,{studio:n,results:t[0]}),e.length>1&&_(qv,{runs:t,places:e})]})}function Vv({studio:n,results:e}){return e?.run?.outputs?_(Wv,{results:e}):e?.so_far&&(e.positions??0)>0?_(Hv,{results:e}):_(Gv,{studio:n})}function Hv({results:n}){return _(Lt,{children:[_("p",{class:"incomplete",children:["Incomplete: ",ts(n)]}),_("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Table of outputs at the solved positions",children:_("table",{class:"outputs","data-testid":"so-far",children:[_("thead",{children:_("tr",{children:[_("th",{scope:"col",children:"Output"}),_("th",{scope:"col",children:"Min so far"}),_("th",{scope:"col",children:"Max so far"}),_("th",{scope:"col",children:"Last"})]})}),_("tbody",{children:Object.entries(n.so_far??{}).map(([e,t])=>_("tr",{children:[_("th",{scope:"row",title:t.doc,children:[cn(e)," ",_("span",{class:"unit",children:t.unit})]}),_("td",{children:ii(t.min)}),_("td",{children:ii(t.max)}),_("td",{children:ii(t.last)})]},e))})]})}),_("p",{class:"muted small-text",children:"The remaining positions may have smaller and larger values. Means and errors need all positions."})]})}function Gv({studio:n}){let e=n.model?.outputs??[];return n.model?.broken?_("p",{class:"muted",children:"The model has errors."}):e.length===0?_("p",{class:"muted",children:"The model has no outputs."}):_("details",{open:e.length<=zv,children:[_("summary",{children:[e.length===1?"1 output":`${e.length} outputs`," of a run"]}),_("dl",{class:"declared",children:e.map(t=>_("div",{children:[_("dt",{children:[cn(t.name)," ",t.unit&&_("span",{class:"unit",children:t.unit})]}),_("dd",{children:Gr(t.doc)})]},t.name))})]})}function Wv({results:n}){let e=Object.entries(n.run?.outputs??{}),t=e.some(([,i])=>i.error_estimate?.includes_level===!1);return _("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Table of outputs",children:[_("table",{class:"outputs","data-testid":"outputs",children:[_("thead",{children:_("tr",{children:[_("th",{scope:"col",children:"Output"}),_("th",{scope:"col",children:"Min"}),_("th",{scope:"col",children:"Mean"}),_("th",{scope:"col",children:"Max"}),_("th",{scope:"col",children:"Error"})]})}),_("tbody",{children:e.map(([i,s])=>_("tr",{children:[_("th",{scope:"row",title:s.doc,children:[cn(i)," ",_("span",{class:"unit",children:s.display.unit})]}),_("td",{children:ii(s.display.min)}),_("td",{children:ii(s.display.mean)}),_("td",{children:ii(s.display.max)}),_("td",{children:Xv(s)})]},i))})]}),_("p",{class:"muted small-text",children:["Error: estimated, relative to the largest magnitude.",t&&" The error of the fidelity level itself is not included."]})]})}function Xv(n){let e=n.error_estimate;return e?e.is_rounding?"rounding":e.relative==null?"–":Yp(e.relative):"–"}function qv({runs:n,places:e}){let[t,i]=Ut("max"),s=[...new Set(n.flatMap($v))],r=n[0],o=n.some(na);return _(Lt,{children:[_("label",{class:"inline",children:["Value",_("select",{value:t,onChange:a=>i(a.currentTarget.value),children:Bv.map(([a,l])=>_("option",{value:a,children:l},a))})]}),_("p",{class:"muted small-text",children:["Changes are relative to ",rn(r?.id??""),".",o&&" Values of incomplete runs are those of their solved positions, without mean and change."]}),_("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Table of compared outputs",children:_("table",{class:"outputs","data-testid":"compared",children:[_("thead",{children:_("tr",{children:[_("th",{scope:"col",children:"Output"}),n.map(a=>_("th",{scope:"col",children:[_("span",{class:"swatch",style:{background:Xr(e.indexOf(a.id))}}),rn(a.id),na(a)&&_("span",{class:"incomplete",children:[ta(a)," solved"]})]},a.id))]})}),_("tbody",{children:s.map(a=>_("tr",{children:[_("th",{scope:"row",children:[cn(a)," ",_("span",{class:"unit",children:Yv(n,a)})]}),n.map(l=>{let c=l!==r&&r&&!na(l)&&!na(r);return _("td",{class:na(l)?"so-far":"",children:[ii(Fh(l,a,t)),c&&_(Jv,{from:Fh(r,a,t),to:Fh(l,a,t)})]},l.id)})]},a))})]})})]})}function na(n){return!n.run?.outputs}function $v(n){return Object.keys(n.run?.outputs??n.so_far??{})}function Yv(n,e){return n.map(i=>i.run?.outputs?.[e]?.display.unit??i.so_far?.[e]?.unit).find(i=>i!==void 0)??""}function Fh(n,e,t){let i=n.run?.outputs?.[e]?.display;if(i)return i[t];let s=n.so_far?.[e];return s&&(t==="min"||t==="max")?s[t]:null}function Jv({from:n,to:e}){if(n===null||e===null||n===0)return null;let t=100*(e-n)/Math.abs(n),i=Math.abs(t)<.005?"±0":`${t>0?"+":"−"}${Math.abs(t).toFixed(Math.abs(t)<10?2:1)}`;return _("span",{class:"change",children:[i," %"]})}var Zv="uplot",Kv="u-hz",jv="u-vt",Qv="u-title",ey="u-wrap",ty="u-under",ny="u-over",iy="u-axis",dr="u-off",sy="u-select",ry="u-cursor-x",oy="u-cursor-y",ay="u-cursor-pt",ly="u-legend",cy="u-live",uy="u-inline",hy="u-series",dy="u-marker",am="u-label",fy="u-value",sa="width",ra="height";var lm="bottom",qr="left",Uh="right",Qh="#000",cm=Qh+"0",Oh="mousemove",um="mousedown",kh="mouseup",hm="mouseenter",dm="mouseleave",fm="dblclick",py="resize",my="scroll",pm="change",Al="dppxchange",ed="--",Qr=typeof window<"u",Gh=Qr?document:null,Yr=Qr?window:null,gy=Qr?navigator:null,Mt,Ml;function Wh(){let n=devicePixelRatio;Mt!=n&&(Mt=n,Ml&&qh(pm,Ml,Wh),Ml=matchMedia(`(min-resolution: ${Mt-.001}dppx) and (max-resolution: ${Mt+.001}dppx)`),fr(pm,Ml,Wh),Yr.dispatchEvent(new CustomEvent(Al)))}function ui(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Xh(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Xt(n,e,t){n.style[e]=t+"px"}function Ui(n,e,t,i){let s=Gh.createElement(n);return e!=null&&ui(s,e),t?.insertBefore(s,i),s}function Ei(n,e){return Ui("div",n,e)}var mm=new WeakMap;function ss(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=mm.get(n);r!=o&&(n.style.transform=r,mm.set(n,r),e<0||t<0||e>i||t>s?ui(n,dr):Xh(n,dr))}var gm=new WeakMap;function _m(n,e,t){let i=e+t,s=gm.get(n);i!=s&&(gm.set(n,i),n.style.background=e,n.style.borderColor=t)}var xm=new WeakMap;function vm(n,e,t,i){let s=e+""+t,r=xm.get(n);s!=r&&(xm.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var td={passive:!0},_y={...td,capture:!0};function fr(n,e,t,i){e.addEventListener(n,t,i?_y:td)}function qh(n,e,t,i){e.removeEventListener(n,t,td)}Qr&&Wh();function Oi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:hi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function $m(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var Ym=n=>n!=null,Jm=n=>n!=null&&n>0,Pl=$m(Ym),xy=$m(Jm);function vy(n,e,t,i=0,s=!1){let r=s?xy:Pl,o=s?Jm:Ym;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ot,l??-Ot]}function Il(n,e,t,i){let s=Sm(n),r=Sm(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?vs:Zm,a=s==1?hi:Ti,l=r==1?Ti:hi,c=a(o(Tn(n))),u=l(o(Tn(e))),h=Jr(t,c),d=Jr(t,u);return t==10&&(c<0&&(h=kt(h,-c)),u<0&&(d=kt(d,-u))),i||t==2?(n=h*s,e=d*r):(n=eg(n,h),e=Ll(e,d)),[n,e]}function nd(n,e,t,i){let s=Il(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var id=.1,ym={mode:3,pad:id},aa={pad:0,soft:null,mode:0},yy={min:aa,max:aa};function Rl(n,e,t,i){return Dl(t)?bm(n,e,t):(aa.pad=t,aa.soft=i?0:null,aa.mode=i?3:0,bm(n,e,yy))}function bt(n,e){return n??e}function by(n,e,t){for(e=bt(e,0),t=bt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function bm(n,e,t){let i=t.min,s=t.max,r=bt(i.pad,0),o=bt(s.pad,0),a=bt(i.hard,-Ot),l=bt(s.hard,Ot),c=bt(i.soft,Ot),u=bt(s.soft,-Ot),h=bt(i.mode,0),d=bt(s.mode,0),f=e-n,g=vs(f),v=jn(Tn(n),Tn(e)),m=vs(v),p=Tn(m-g);(f<1e-24||p>10)&&(f=0,(n==0||e==0)&&(f=1e-24,h==2&&c!=Ot&&(r=0),d==2&&u!=-Ot&&(o=0)));let y=f||v||1e3,A=vs(y),S=Jr(10,hi(A)),C=y*(f==0?n==0?.1:1:r),R=kt(eg(n-C,S/10),24),x=n>=c&&(h==1||h==3&&R<=c||h==2&&R>=c)?c:Ot,E=jn(a,R<x&&n>=x?x:ki(x,R)),U=y*(f==0?e==0?.1:1:o),D=kt(Ll(e+U,S/10),24),L=e<=u&&(d==1||d==3&&D>=u||d==2&&D<=u)?u:-Ot,k=ki(l,D>L&&e<=L?L:jn(L,D));return E==k&&E==0&&(k=100),[E,k]}var Sy=new Intl.NumberFormat(Qr?gy.language:"en-US"),sd=n=>Sy.format(n),di=Math,Tl=di.PI,Tn=di.abs,hi=di.floor,En=di.round,Ti=di.ceil,ki=di.min,jn=di.max,Jr=di.pow,Sm=di.sign,vs=di.log10,Zm=di.log2,My=(n,e=1)=>di.sinh(n)*e,Bh=(n,e=1)=>di.asinh(n/e),Ot=1/0;function Mm(n){return(vs((n^n>>31)-(n>>31))|0)+1}function $h(n,e,t){return ki(jn(n,e),t)}function Km(n){return typeof n=="function"}function pt(n){return Km(n)?n:()=>n}var wy=()=>{},jm=n=>n,Qm=(n,e)=>e,Ey=n=>null,wm=n=>!0,Em=(n,e)=>n==e,Ty=/\.\d*?(?=9{6,}|0{6,})/gm,pr=n=>{if(ng(n)||Ws.has(n))return n;let e=`${n}`,t=e.match(Ty);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${pr(s)}e${r}`}return kt(n,i)};function ur(n,e){return pr(kt(pr(n/e))*e)}function Ll(n,e){return pr(Ti(pr(n/e))*e)}function eg(n,e){return pr(hi(pr(n/e))*e)}function kt(n,e=0){if(ng(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return En(i)/t}var Ws=new Map;function tg(n){return((""+n).split(".")[1]||"").length}function ca(n,e,t,i){let s=[],r=i.map(tg);for(let o=e;o<t;o++){let a=Tn(o),l=kt(Jr(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:kt(u,h);s.push(d),Ws.set(d,h)}}return s}var la={},rd=[],Zr=[null,null],Gs=Array.isArray,ng=Number.isInteger,Ay=n=>n===void 0;function Tm(n){return typeof n=="string"}function Dl(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Ry(n){return n!=null&&typeof n=="object"}var Cy=Object.getPrototypeOf(Uint8Array),ig="__proto__";function Kr(n,e=Dl){let t;if(Gs(n)){let i=n.find(s=>s!=null);if(Gs(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Kr(n[s],e)}else t=n.slice()}else if(n instanceof Cy)t=n.slice();else if(e(n)){t={};for(let i in n)i!=ig&&(t[i]=Kr(n[i],e))}else t=n;return t}function xn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=ig&&(Dl(n[s])?xn(n[s],Kr(i[s])):n[s]=Kr(i[s]))}return n}var Py=0,Iy=1,Ly=2;function Dy(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function Ny(n,e){if(Oy(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return ky(o[0])||(o=Uy(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=e?e[o][c]:Iy,f=[];for(let g=0;g<u.length;g++){let v=u[g],m=r.get(l[g]);v===null?d!=Py&&(h[m]=v,d==Ly&&f.push(m)):h[m]=v}Dy(h,f,s),i.push(h)}}return i}var Fy=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Uy(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function Oy(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function ky(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=jn(1,hi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var sg=["January","February","March","April","May","June","July","August","September","October","November","December"],rg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function og(n){return n.slice(0,3)}var By=rg.map(og),zy=sg.map(og),Vy={MMMM:sg,MMM:zy,WWWW:rg,WWW:By};function ia(n){return(n<10?"0":"")+n}function Hy(n){return(n<10?"00":n<100?"0":"")+n}var Gy={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>ia(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ia(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>ia(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ia(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ia(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Hy(n.getMilliseconds())};function od(n,e){e=e||Vy;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?Gy[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Wy=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Xy(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==Wy?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var ag=n=>n%1==0,Cl=[1,2,2.5,5],qy=ca(10,-32,0,Cl),lg=ca(10,0,32,Cl),$y=lg.filter(ag),hr=qy.concat(lg),ad=`
`,cg="{YYYY}",Am=ad+cg,ug="{M}/{D}",oa=ad+ug,wl=oa+"/{YY}",hg="{aa}",Yy="{h}:{mm}",$r=Yy+hg,Rm=ad+$r,Cm=":{ss}",wt=null;function dg(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?ca(10,0,3,Cl).filter(ag):ca(10,-3,0,Cl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,cg,wt,wt,wt,wt,wt,wt,1],[s*28,"{MMM}",Am,wt,wt,wt,wt,wt,1],[s,ug,Am,wt,wt,wt,wt,wt,1],[i,"{h}"+hg,wl,wt,oa,wt,wt,wt,1],[t,$r,wl,wt,oa,wt,wt,wt,1],[e,Cm,wl+" "+$r,wt,oa+" "+$r,wt,Rm,wt,1],[n,Cm+".{fff}",wl+" "+$r,wt,oa+" "+$r,wt,Rm,wt,1]];function u(h){return(d,f,g,v,m,p)=>{let y=[],A=m>=o,S=m>=r&&m<o,C=h(g),R=kt(C*n,3),x=zh(C.getFullYear(),A?0:C.getMonth(),S||A?1:C.getDate()),E=kt(x*n,3);if(S||A){let U=S?m/r:0,D=A?m/o:0,L=R==E?R:kt(zh(x.getFullYear()+D,x.getMonth()+U,1)*n,3),k=new Date(En(L/n)),z=k.getFullYear(),N=k.getMonth();for(let G=0;L<=v;G++){let $=zh(z+D*G,N+U*G,1),H=$-h(kt($*n,3));L=kt((+$+H)*n,3),L<=v&&y.push(L)}}else{let U=m>=s?s:m,D=hi(g)-hi(R),L=E+D+Ll(R-E,U);y.push(L);let k=h(L),z=k.getHours()+k.getMinutes()/t+k.getSeconds()/i,N=m/i,G=d.axes[f]._space,$=p/G;for(;L=kt(L+m,n==1?0:3),!(L>v);)if(N>1){let H=hi(kt(z+N,6))%24,Q=h(L).getHours()-H;Q>1&&(Q=-1),L-=Q*i,z=(z+N)%24;let ie=y[y.length-1];kt((L-ie)/m,3)*$>=.7&&y.push(L)}else y.push(L)}return y}}return[l,c,u]}var[Jy,Zy,Ky]=dg(1),[jy,Qy,eb]=dg(.001);ca(2,-53,53,[1]);function Pm(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Im(n,e){return(t,i,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,u,h,d,f;return i.map(g=>{let v=n(g),m=v.getFullYear(),p=v.getMonth(),y=v.getDate(),A=v.getHours(),S=v.getMinutes(),C=v.getSeconds(),R=m!=l&&a[2]||p!=c&&a[3]||y!=u&&a[4]||A!=h&&a[5]||S!=d&&a[6]||C!=f&&a[7]||a[1];return l=m,c=p,u=y,h=A,d=S,f=C,R(v)})}}function tb(n,e){let t=od(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function zh(n,e,t){return new Date(n,e,t)}function Lm(n,e){return e(n)}var nb="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Dm(n,e){return(t,i,s,r)=>r==null?ed:e(n(i))}function ib(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function sb(n,e){return n.series[e].fill(n,e)}var rb={show:!0,live:!0,isolate:!1,mount:wy,markers:{show:!0,width:2,stroke:ib,fill:sb,dash:"solid"},idx:null,idxs:null,values:[]};function ob(n,e){let t=n.cursor.points,i=Ei(),s=t.size(n,e);Xt(i,sa,s),Xt(i,ra,s);let r=s/-2;Xt(i,"marginLeft",r),Xt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Xt(i,"borderWidth",o),i}function ab(n,e){let t=n.series[e].points;return t._fill||t._stroke}function lb(n,e){let t=n.series[e].points;return t._stroke||t._fill}function cb(n,e){return n.series[e].points.size}var Vh=[0,0];function ub(n,e,t){return Vh[0]=e,Vh[1]=t,Vh}function El(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Hh(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var hb={show:!0,x:!0,y:!0,lock:!1,move:ub,points:{one:!1,show:ob,size:cb,width:0,stroke:lb,fill:ab},bind:{mousedown:El,mouseup:El,click:El,dblclick:El,mousemove:Hh,mouseleave:Hh,mouseenter:Hh},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},fg={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},ld=xn({},fg,{filter:Qm}),pg=xn({},ld,{size:10}),mg=xn({},fg,{show:!1}),cd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',gg="bold "+cd,_g=1.5,Nm={show:!0,scale:"x",stroke:Qh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:gg,side:2,grid:ld,ticks:pg,border:mg,font:cd,lineGap:_g,rotate:0},db="Value",fb="Time",Fm={show:!0,scale:"x",auto:!1,sorted:1,min:Ot,max:-Ot,idxs:[]};function pb(n,e,t,i,s){return e.map(r=>r==null?"":sd(r))}function mb(n,e,t,i,s,r,o){let a=[],l=Ws.get(s)||0;t=o?t:kt(Ll(t,s),l);for(let c=t;c<=i;c=kt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Yh(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?vs:Zm,u=hi(c(t));s=Jr(l,u),l==10&&(s=hr[Oi(s,hr)]);let h=t,d=s*l;l==10&&(d=hr[Oi(d,hr)]);do a.push(h),h=h+s,l==10&&!Ws.has(h)&&(h=kt(h,Ws.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=hr[Oi(d,hr)]));while(h<=i);return a}function gb(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Yh(n,e,jn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Yh(n,e,jn(l,-i),-t,s):[l]).reverse().map(d=>-d).concat(u,c)}var xg=/./,_b=/[12357]/,xb=/[125]/,Um=/1/,Jh=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function vb(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?xg:l(7,o)-u>=c?_b:l(5,o)-u>=c?xb:Um;if(h==Um){let d=Tn(l(1,o)-u);if(d<c)return Jh(e.slice().reverse(),a.distr,h,Ti(c/d)).reverse()}return Jh(e,a.distr,h,1)}function yb(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Tn(l(1,o)-l(2,o));return c<a?Jh(e.slice().reverse(),3,xg,Ti(a/c)).reverse():e}function bb(n,e,t,i){return i==null?ed:e==null?"":sd(e)}var Om={show:!0,scale:"y",stroke:Qh,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:gg,side:3,grid:ld,ticks:pg,border:mg,font:cd,lineGap:_g,rotate:0};function Sb(n,e){let t=3+(n||1)*2;return kt(t*e,3)}function Mb(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Tn(o-r),l=n.series[e],c=a/(l.points.space*Mt);return i[1]-i[0]<=c}var km={scale:null,auto:!0,sorted:0,min:Ot,max:-Ot},vg=(n,e,t,i,s)=>s,Bm={show:!0,auto:!0,sorted:0,gaps:vg,alpha:1,facets:[xn({},km,{scale:"x"}),xn({},km,{scale:"y"})]},zm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:vg,alpha:1,points:{show:Mb,filter:null},values:null,min:Ot,max:-Ot,idxs:[],path:null,clip:null};function wb(n,e,t,i,s){return t/10}var yg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Eb=xn({},yg,{time:!1,ori:1}),Vm={};function bg(n,e){let t=Vm[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Vm[n]=t)),t}var jr=1,Zh=2;function mr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,v=a.height,m=n.valToPosH,p=n.valToPosV;return u.ori==0?t(s,l,c,u,h,m,p,d,f,g,v,Fl,eo,Ol,Mg,Eg):t(s,l,c,u,h,p,m,f,d,v,g,Ul,to,dd,wg,Tg)}function ud(n,e){let t=0,i=0,s=bt(n.bands,rd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Tb(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ys(n,e,t,i,s,r){return mr(n,e,(o,a,l,c,u,h,d,f,g,v,m)=>{let p=o.pxRound,y=c.dir*(c.ori==0?1:-1),A=c.ori==0?eo:to,S,C;y==1?(S=t,C=i):(S=i,C=t);let R=p(h(a[S],c,v,f)),x=p(d(l[S],u,m,g)),E=p(h(a[C],c,v,f)),U=p(d(r==1?u.max:u.min,u,m,g)),D=new Path2D(s);return A(D,E,U),A(D,R,U),A(D,R,x),D})}function Nl(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Ol:dd,l=t;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Ab(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function hd(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(n[h]),g=d==h?f:r(n[d]),v=h-s;f=o<=0&&v>=0&&v<l?r(n[v]):f;let p=d+s;g=o>=0&&p>=0&&p<l?r(n[p]):g,g>=f&&a.push([f,g])}return a}function Hm(n){return n==0?jm:n==1?En:e=>ur(e,n)}function Sg(n){let e=n==0?Fl:Ul,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=ki(c,a/2,l/2),u=ki(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Fl=(n,e,t)=>{n.moveTo(e,t)},Ul=(n,e,t)=>{n.moveTo(t,e)},eo=(n,e,t)=>{n.lineTo(e,t)},to=(n,e,t)=>{n.lineTo(t,e)},Ol=Sg(0),dd=Sg(1),Mg=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},wg=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Eg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Tg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function Ag(n){return(e,t,i,s,r)=>mr(e,t,(o,a,l,c,u,h,d,f,g,v,m)=>{let{pxRound:p,points:y}=o,A,S;c.ori==0?(A=Fl,S=Mg):(A=Ul,S=wg);let C=kt(y.width*Mt,3),R=(y.size-y.width)/2*Mt,x=kt(R*2,3),E=new Path2D,U=new Path2D,{left:D,top:L,width:k,height:z}=e.bbox;Ol(U,D-x,L-x,k+x*2,z+x*2);let N=G=>{if(l[G]!=null){let $=p(h(a[G],c,v,f)),H=p(d(l[G],u,m,g));A(E,$+R,H),S(E,$,H,R,0,Tl*2)}};if(r)r.forEach(N);else for(let G=i;G<=s;G++)N(G);return{stroke:C>0?E:null,fill:E,clip:U,flags:jr|Zh}})}function Rg(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var Rb=Rg(eo),Cb=Rg(to);function Cg(n){let e=bt(n?.alignGaps,0);return(t,i,s,r)=>mr(t,i,(o,a,l,c,u,h,d,f,g,v,m)=>{[s,r]=Pl(l,s,r);let p=o.pxRound,y=z=>p(h(z,c,v,f)),A=z=>p(d(z,u,m,g)),S,C;c.ori==0?(S=eo,C=Rb):(S=to,C=Cb);let R=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:jr},E=x.stroke,U=!1;if(r-s>=v*4){let z=he=>t.posToVal(he,c.key,!0),N=null,G=null,$,H,le,Z=y(a[R==1?s:r]),Q=y(a[s]),ie=y(a[r]),de=z(R==1?Q+1:ie-1);for(let he=R==1?s:r;he>=s&&he<=r;he+=R){let ee=a[he],ge=(R==1?ee<de:ee>de)?Z:y(ee),Me=l[he];ge==Z?Me!=null?(H=Me,N==null?(S(E,ge,A(H)),$=N=G=H):H<N?N=H:H>G&&(G=H)):Me===null&&(U=!0):(N!=null&&C(E,Z,A(N),A(G),A($),A(H)),Me!=null?(H=Me,S(E,ge,A(H)),N=G=$=H):(N=G=null,Me===null&&(U=!0)),Z=ge,de=z(Z+R))}N!=null&&N!=G&&le!=Z&&C(E,Z,A(N),A(G),A($),A(H))}else for(let z=R==1?s:r;z>=s&&z<=r;z+=R){let N=l[z];N===null?U=!0:N!=null&&S(E,y(a[z]),A(N))}let[L,k]=ud(t,i);if(o.fill!=null||L!=0){let z=x.fill=new Path2D(E),N=o.fillTo(t,i,o.min,o.max,L),G=A(N),$=y(a[s]),H=y(a[r]);R==-1&&([H,$]=[$,H]),S(z,H,G),S(z,$,G)}if(!o.spanGaps){let z=[];U&&z.push(...hd(a,l,s,r,R,y,e)),x.gaps=z=o.gaps(t,i,s,r,z),x.clip=Nl(z,c.ori,f,g,v,m)}return k!=0&&(x.band=k==2?[ys(t,i,s,r,E,-1),ys(t,i,s,r,E,1)]:ys(t,i,s,r,E,k)),x})}function Pb(n){let e=bt(n.align,1),t=bt(n.ascDesc,!1),i=bt(n.alignGaps,0),s=bt(n.extend,!1);return(r,o,a,l)=>mr(r,o,(c,u,h,d,f,g,v,m,p,y,A)=>{[a,l]=Pl(h,a,l);let S=c.pxRound,{left:C,width:R}=r.bbox,x=Q=>S(g(Q,d,y,m)),E=Q=>S(v(Q,f,A,p)),U=d.ori==0?eo:to,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:jr},L=D.stroke,k=d.dir*(d.ori==0?1:-1),z=E(h[k==1?a:l]),N=x(u[k==1?a:l]),G=N,$=N;s&&e==-1&&($=C,U(L,$,z)),U(L,N,z);for(let Q=k==1?a:l;Q>=a&&Q<=l;Q+=k){let ie=h[Q];if(ie==null)continue;let de=x(u[Q]),he=E(ie);e==1?U(L,de,z):U(L,G,he),U(L,de,he),z=he,G=de}let H=G;s&&e==1&&(H=C+R,U(L,H,z));let[le,Z]=ud(r,o);if(c.fill!=null||le!=0){let Q=D.fill=new Path2D(L),ie=c.fillTo(r,o,c.min,c.max,le),de=E(ie);U(Q,H,de),U(Q,$,de)}if(!c.spanGaps){let Q=[];Q.push(...hd(u,h,a,l,k,x,i));let ie=c.width*Mt/2,de=t||e==1?ie:-ie,he=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=de,ee[1]+=he}),D.gaps=Q=c.gaps(r,o,a,l,Q),D.clip=Nl(Q,d.ori,m,p,y,A)}return Z!=0&&(D.band=Z==2?[ys(r,o,a,l,L,-1),ys(r,o,a,l,L,1)]:ys(r,o,a,l,L,Z)),D})}function Gm(n,e,t,i,s,r,o=Ot){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Tn(n[l]-n[a]);u<c&&(c=u,o=Tn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Ib(n){n=n||la;let e=bt(n.size,[.6,Ot,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=pt(s),o=1-e[0],a=bt(e[1],Ot),l=bt(e[2],1),c=bt(n.disp,la),u=bt(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,g,v,m)=>mr(f,g,(p,y,A,S,C,R,x,E,U,D,L)=>{let k=p.pxRound,z=t,N=i*Mt,G=a*Mt,$=l*Mt,H,le;S.ori==0?[H,le]=r(f,g):[le,H]=r(f,g);let Z=S.dir*(S.ori==0?1:-1),Q=S.ori==0?Ol:dd,ie=S.ori==0?u:(Ce,qe,it,we,Ft,Ve,Xe)=>{u(Ce,qe,it,Ft,we,Xe,Ve)},de=bt(f.bands,rd).find(Ce=>Ce.series[0]==g),he=de!=null?de.dir:0,ee=p.fillTo(f,g,p.min,p.max,he),me=k(x(ee,C,L,U)),ge,Me,ve,He=D,Je=k(p.width*Mt),Oe=!1,ct=null,ot=null,tt=null,Yt=null;h!=null&&(Je==0||d!=null)&&(Oe=!0,ct=h.values(f,g,v,m),ot=new Map,new Set(ct).forEach(Ce=>{Ce!=null&&ot.set(Ce,new Path2D)}),Je>0&&(tt=d.values(f,g,v,m),Yt=new Map,new Set(tt).forEach(Ce=>{Ce!=null&&Yt.set(Ce,new Path2D)})));let{x0:Bt,size:hn}=c;if(Bt!=null&&hn!=null){z=1,y=Bt.values(f,g,v,m),Bt.unit==2&&(y=y.map(it=>f.posToVal(E+it*D,S.key,!0)));let Ce=hn.values(f,g,v,m);hn.unit==2?Me=Ce[0]*D:Me=R(Ce[0],S,D,E)-R(0,S,D,E),He=Gm(y,A,R,S,D,E,He),ve=He-Me+N}else He=Gm(y,A,R,S,D,E,He),ve=He*o+N,Me=He-ve;ve<1&&(ve=0),Je>=Me/2&&(Je=0),ve<5&&(k=jm);let Pt=ve>0,Cn=He-ve-(Pt?Je:0);Me=k($h(Cn,$,G)),ge=(z==0?Me/2:z==Z?0:Me)-z*Z*((z==0?N/2:0)+(Pt?Je/2:0));let xt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Mn=Oe?null:new Path2D,Qt=null;if(de!=null)Qt=f.data[de.series[1]];else{let{y0:Ce,y1:qe}=c;Ce!=null&&qe!=null&&(A=qe.values(f,g,v,m),Qt=Ce.values(f,g,v,m))}let dn=H*Me,B=le*Me;for(let Ce=Z==1?v:m;Ce>=v&&Ce<=m;Ce+=Z){let qe=A[Ce];if(qe==null)continue;if(Qt!=null){let q=Qt[Ce]??0;if(qe-q==0)continue;me=x(q,C,L,U)}let it=S.distr!=2||c!=null?y[Ce]:Ce,we=R(it,S,D,E),Ft=x(bt(qe,ee),C,L,U),Ve=k(we-ge),Xe=k(jn(Ft,me)),P=k(ki(Ft,me)),M=Xe-P;if(qe!=null){let q=qe<0?B:dn,ue=qe<0?dn:B;Oe?(Je>0&&tt[Ce]!=null&&Q(Yt.get(tt[Ce]),Ve,P+hi(Je/2),Me,jn(0,M-Je),q,ue),ct[Ce]!=null&&Q(ot.get(ct[Ce]),Ve,P+hi(Je/2),Me,jn(0,M-Je),q,ue)):Q(Mn,Ve,P+hi(Je/2),Me,jn(0,M-Je),q,ue),ie(f,g,Ce,Ve-Je/2,P,Me+Je,M)}}return Je>0?xt.stroke=Oe?Yt:Mn:Oe||(xt._fill=p.width==0?p._fill:p._stroke??p._fill,xt.width=0),xt.fill=Oe?ot:Mn,xt})}function Lb(n,e){let t=bt(e?.alignGaps,0);return(i,s,r,o)=>mr(i,s,(a,l,c,u,h,d,f,g,v,m,p)=>{[r,o]=Pl(c,r,o);let y=a.pxRound,A=H=>y(d(H,u,m,g)),S=H=>y(f(H,h,p,v)),C,R,x;u.ori==0?(C=Fl,x=eo,R=Eg):(C=Ul,x=to,R=Tg);let E=u.dir*(u.ori==0?1:-1),U=A(l[E==1?r:o]),D=U,L=[],k=[];for(let H=E==1?r:o;H>=r&&H<=o;H+=E)if(c[H]!=null){let Z=l[H],Q=A(Z);L.push(D=Q),k.push(S(c[H]))}let z={stroke:n(L,k,C,x,R,y),fill:null,clip:null,band:null,gaps:null,flags:jr},N=z.stroke,[G,$]=ud(i,s);if(a.fill!=null||G!=0){let H=z.fill=new Path2D(N),le=a.fillTo(i,s,a.min,a.max,G),Z=S(le);x(H,D,Z),x(H,U,Z)}if(!a.spanGaps){let H=[];H.push(...hd(l,c,r,o,E,A,t)),z.gaps=H=a.gaps(i,s,r,o,H),z.clip=Nl(H,u.ori,g,v,m,p)}return $!=0&&(z.band=$==2?[ys(i,s,r,o,N,-1),ys(i,s,r,o,N,1)]:ys(i,s,r,o,N,$)),z})}function Db(n){return Lb(Nb,n)}function Nb(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,e[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,e[d+1]-l[d+1]*h[d]/3,n[d+1],e[d+1])}return a}var Kh=new Set;function Wm(){for(let n of Kh)n.syncRect(!0)}Qr&&(fr(py,Yr,Wm),fr(my,Yr,Wm,!0),fr(Al,Yr,()=>{vn.pxRatio=Mt}));var Fb=Cg(),Ub=Ag();function Xm(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>jh(r,o,e,t))}function Ob(n,e){return n.map((t,i)=>i==0?{}:xn({},e,t))}function jh(n,e,t,i){return xn({},e==0?t:i,n)}function Pg(n,e,t){return e==null?Zr:[e,t]}var kb=Pg;function Bb(n,e,t){return e==null?Zr:Rl(e,t,id,!0)}function Ig(n,e,t,i){return e==null?Zr:Il(e,t,n.scales[i].log,!1)}var zb=Ig;function Lg(n,e,t,i){return e==null?Zr:nd(e,t,n.scales[i].log,!1)}var Vb=Lg;function Hb(n,e,t,i,s){let r=jn(Mm(n),Mm(e)),o=e-n,a=Oi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Ws.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function qm(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=En((t=+s)*Mt))+"px"),[n,e,t]}function Gb(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=kt(e[2]*Mt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function vn(n,e,t){let i={mode:bt(n.mode,1)},s=i.mode;function r(b,w,I,F){let W=w.valToPct(b);return F+I*(w.dir==-1?1-W:W)}function o(b,w,I,F){let W=w.valToPct(b);return F+I*(w.dir==-1?W:1-W)}function a(b,w,I,F){return w.ori==0?r(b,w,I,F):o(b,w,I,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ei(Zv);if(n.id!=null&&(c.id=n.id),ui(c,n.class),n.title){let b=Ei(Qv,c);b.textContent=n.title}let u=Ui("canvas"),h=i.ctx=u.getContext("2d"),d=Ei(ey,c);fr("click",d,b=>{b.target===g&&(Ht!=Or||Jt!=kr)&&On.click(i,b)},!0);let f=i.under=Ei(ty,d);d.appendChild(u);let g=i.over=Ei(ny,d);n=Kr(n);let v=+bt(n.pxAlign,1),m=Hm(v);(n.plugins||[]).forEach(b=>{b.opts&&(n=b.opts(i,n)||n)});let p=n.ms||.001,y=i.series=s==1?Xm(n.series||[],Fm,zm,!1):Ob(n.series||[null],Bm),A=i.axes=Xm(n.axes||[],Nm,Om,!0),S=i.scales={},C=i.bands=n.bands||[];C.forEach(b=>{b.fill=pt(b.fill||null),b.dir=bt(b.dir,-1)});let R=s==2?y[1].facets[0].scale:y[0].scale,x={axes:gs,series:ht},E=(n.drawOrder||["axes","series"]).map(b=>x[b]);function U(b){let w=b.distr==3?I=>vs(I>0?I:b.clamp(i,I,b.min,b.max,b.key)):b.distr==4?I=>Bh(I,b.asinh):b.distr==100?I=>b.fwd(I):I=>I;return I=>{let F=w(I),{_min:W,_max:K}=b,ae=K-W;return(F-W)/ae}}function D(b){let w=S[b];if(w==null){let I=(n.scales||la)[b]||la;if(I.from!=null){D(I.from);let F=xn({},S[I.from],I,{key:b});F.valToPct=U(F),S[b]=F}else{w=S[b]=xn({},b==R?yg:Eb,I),w.key=b;let F=w.time,W=w.range,K=Gs(W);if((b!=R||s==2&&!F)&&(K&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?ym:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?ym:{mode:1,hard:W[1],soft:W[1]}},K=!1),!K&&Dl(W))){let ae=W;W=(fe,be,De)=>be==null?Zr:Rl(be,De,ae)}w.range=pt(W||(F?kb:b==R?w.distr==3?zb:w.distr==4?Vb:Pg:w.distr==3?Ig:w.distr==4?Lg:Bb)),w.auto=pt(K?!1:w.auto),w.clamp=pt(w.clamp||wb),w._min=w._max=null,w.valToPct=U(w)}}}D("x"),D("y"),s==1&&y.forEach(b=>{D(b.scale)}),A.forEach(b=>{D(b.scale)});for(let b in n.scales)D(b);let L=S[R],k=L.distr,z,N;L.ori==0?(ui(c,Kv),z=r,N=o):(ui(c,jv),z=o,N=r);let G={};for(let b in S){let w=S[b];(w.min!=null||w.max!=null)&&(G[b]={min:w.min,max:w.max},w.min=w.max=null)}let $=n.tzDate||(b=>new Date(En(b/p))),H=n.fmtDate||od,le=p==1?Ky($):eb($),Z=Im($,Pm(p==1?Zy:Qy,H)),Q=Dm($,Lm(nb,H)),ie=[],de=i.legend=xn({},rb,n.legend),he=i.cursor=xn({},hb,{drag:{y:s==2}},n.cursor),ee=de.show,me=he.show,ge=de.markers;de.idxs=ie,ge.width=pt(ge.width),ge.dash=pt(ge.dash),ge.stroke=pt(ge.stroke),ge.fill=pt(ge.fill);let Me,ve,He,Je=[],Oe=[],ct,ot=!1,tt={};if(de.live){let b=y[1]?y[1].values:null;ot=b!=null,ct=ot?b(i,1,0):{_:0};for(let w in ct)tt[w]=ed}if(ee)if(Me=Ui("table",ly,c),He=Ui("tbody",null,Me),de.mount(i,Me),ot){ve=Ui("thead",null,Me,He);let b=Ui("tr",null,ve);Ui("th",null,b);for(var Yt in ct)Ui("th",am,b).textContent=Yt}else ui(Me,uy),de.live&&ui(Me,cy);let Bt={show:!0},hn={show:!1};function Pt(b,w){if(w==0&&(ot||!de.live||s==2))return Zr;let I=[],F=Ui("tr",hy,He,He.childNodes[w]);ui(F,b.class),b.show||ui(F,dr);let W=Ui("th",null,F);if(ge.show){let fe=Ei(dy,W);if(w>0){let be=ge.width(i,w);be&&(fe.style.border=be+"px "+ge.dash(i,w)+" "+ge.stroke(i,w)),fe.style.background=ge.fill(i,w)}}let K=Ei(am,W);b.label instanceof HTMLElement?K.appendChild(b.label):K.textContent=b.label,w>0&&(ge.show||(K.style.color=b.width>0?ge.stroke(i,w):ge.fill(i,w)),xt("click",W,fe=>{if(he._lock)return;Ze(fe);let be=y.indexOf(b);if((fe.ctrlKey||fe.metaKey)!=de.isolate){let De=y.some((Ne,Ue)=>Ue>0&&Ue!=be&&Ne.show);y.forEach((Ne,Ue)=>{Ue>0&&Ki(Ue,De?Ue==be?Bt:hn:Bt,!0,gn.setSeries)})}else Ki(be,{show:!b.show},!0,gn.setSeries)},!1),Ke&&xt(hm,W,fe=>{he._lock||(Ze(fe),Ki(y.indexOf(b),zr,!0,gn.setSeries))},!1));for(var ae in ct){let fe=Ui("td",fy,F);fe.textContent="--",I.push(fe)}return[F,I]}let Cn=new Map;function xt(b,w,I,F=!0){let W=Cn.get(w)||{},K=he.bind[b](i,w,I,F);K&&(fr(b,w,W[b]=K),Cn.set(w,W))}function Mn(b,w,I){let F=Cn.get(w)||{};for(let W in F)(b==null||W==b)&&(qh(W,w,F[W]),delete F[W]);b==null&&Cn.delete(w)}let Qt=0,dn=0,B=0,Ce=0,qe=0,it=0,we=qe,Ft=it,Ve=B,Xe=Ce,P=0,M=0,q=0,ue=0;i.bbox={};let oe=!1,xe=!1,ye=!1,te=!1,se=!1,pe=!1;function O(b,w,I){(I||b!=i.width||w!=i.height)&&re(b,w),at(!1),ye=!0,xe=!0,Gn()}function re(b,w){i.width=Qt=B=b,i.height=dn=Ce=w,qe=it=0,Se(),Ge();let I=i.bbox;P=I.left=ur(qe*Mt,.5),M=I.top=ur(it*Mt,.5),q=I.width=ur(B*Mt,.5),ue=I.height=ur(Ce*Mt,.5)}let ne=3;function Ee(){let b=!1,w=0;for(;!b;){w++;let I=Nr(w),F=Zi(w);b=w==ne||I&&F,b||(re(i.width,i.height),xe=!0)}}function _e({width:b,height:w}){O(b,w)}i.setSize=_e;function Se(){let b=!1,w=!1,I=!1,F=!1;A.forEach((W,K)=>{if(W.show&&W._show){let{side:ae,_size:fe}=W,be=ae%2,De=W.label!=null?W.labelSize:0,Ne=fe+De;Ne>0&&(be?(B-=Ne,ae==3?(qe+=Ne,F=!0):I=!0):(Ce-=Ne,ae==0?(it+=Ne,b=!0):w=!0))}}),Yi[0]=b,Yi[1]=I,Yi[2]=w,Yi[3]=F,B-=Di[1]+Di[3],qe+=Di[3],Ce-=Di[2]+Di[0],it+=Di[0]}function Ge(){let b=qe+B,w=it+Ce,I=qe,F=it;function W(K,ae){switch(K){case 1:return b+=ae,b-ae;case 2:return w+=ae,w-ae;case 3:return I-=ae,I+ae;case 0:return F-=ae,F+ae}}A.forEach((K,ae)=>{if(K.show&&K._show){let fe=K.side;K._pos=W(fe,K._size),K.label!=null&&(K._lpos=W(fe,K.labelSize))}})}if(he.dataIdx==null){let b=he.hover,w=b.skip=new Set(b.skip??[]);w.add(void 0);let I=b.prox=pt(b.prox),F=b.bias??=0;he.dataIdx=(W,K,ae,fe)=>{if(K==0)return ae;let be=ae,De=I(W,K,ae,fe)??Ot,Ne=De>=0&&De<Ot,Ue=L.ori==0?B:Ce,nt=he.left,St=e[0],yt=e[K];if(w.has(yt[ae])){be=null;let dt=null,Ye=null,We;if(F==0||F==-1)for(We=ae;dt==null&&We-- >0;)w.has(yt[We])||(dt=We);if(F==0||F==1)for(We=ae;Ye==null&&We++<yt.length;)w.has(yt[We])||(Ye=We);if(dt!=null||Ye!=null)if(Ne){let Wt=dt==null?-1/0:z(St[dt],L,Ue,0),nn=Ye==null?1/0:z(St[Ye],L,Ue,0),Dn=nt-Wt,It=nn-nt;Dn<=It?Dn<=De&&(be=dt):It<=De&&(be=Ye)}else be=Ye==null?dt:dt==null?Ye:ae-dt<=Ye-ae?dt:Ye}else Ne&&Tn(nt-z(St[ae],L,Ue,0))>De&&(be=null);return be}}let Ze=b=>{he.event=b};he.idxs=ie,he._lock=!1;let ce=he.points;ce.show=pt(ce.show),ce.size=pt(ce.size),ce.stroke=pt(ce.stroke),ce.width=pt(ce.width),ce.fill=pt(ce.fill);let ke=i.focus=xn({},n.focus||{alpha:.3},he.focus),Ke=ke.prox>=0,Re=Ke&&ce.one,st=[],Vt=[],$n=[];function Ho(b,w){let I=ce.show(i,w);if(I instanceof HTMLElement)return ui(I,ay),ui(I,b.class),ss(I,-10,-10,B,Ce),g.insertBefore(I,st[w]),I}function Ir(b,w){if(s==1||w>0){let I=s==1&&S[b.scale].time,F=b.value;b.value=I?Tm(F)?Dm($,Lm(F,H)):F||Q:F||bb,b.label=b.label||(I?fb:db)}if(Re||w>0){b.width=b.width==null?1:b.width,b.paths=b.paths||Fb||Ey,b.fillTo=pt(b.fillTo||Tb),b.pxAlign=+bt(b.pxAlign,v),b.pxRound=Hm(b.pxAlign),b.stroke=pt(b.stroke||null),b.fill=pt(b.fill||null),b._stroke=b._fill=b._paths=b._focus=null;let I=Sb(jn(1,b.width),1),F=b.points=xn({},{size:I,width:jn(1,I*.2),stroke:b.stroke,space:I*2,paths:Ub,_stroke:null,_fill:null},b.points);F.show=pt(F.show),F.filter=pt(F.filter),F.fill=pt(F.fill),F.stroke=pt(F.stroke),F.paths=pt(F.paths),F.pxAlign=b.pxAlign}if(ee){let I=Pt(b,w);Je.splice(w,0,I[0]),Oe.splice(w,0,I[1]),de.values.push(null)}if(me){ie.splice(w,0,null);let I=null;Re?w==0&&(I=Ho(b,w)):w>0&&(I=Ho(b,w)),st.splice(w,0,I),Vt.splice(w,0,0),$n.splice(w,0,0)}Ln("addSeries",w)}function ah(b,w){w=w??y.length,b=s==1?jh(b,w,Fm,zm):jh(b,w,{},Bm),y.splice(w,0,b),Ir(y[w],w)}i.addSeries=ah;function sl(b){if(y.splice(b,1),ee){de.values.splice(b,1),Oe.splice(b,1);let w=Je.splice(b,1)[0];Mn(null,w.firstChild),w.remove()}me&&(ie.splice(b,1),st.splice(b,1)[0].remove(),Vt.splice(b,1),$n.splice(b,1)),Ln("delSeries",b)}i.delSeries=sl;let Yi=[!1,!1,!1,!1];function fs(b,w){if(b._show=b.show,b.show){let I=b.side%2,F=S[b.scale];F==null&&(b.scale=I?y[1].scale:R,F=S[b.scale]);let W=F.time;b.size=pt(b.size),b.space=pt(b.space),b.rotate=pt(b.rotate),Gs(b.incrs)&&b.incrs.forEach(ae=>{!Ws.has(ae)&&Ws.set(ae,tg(ae))}),b.incrs=pt(b.incrs||(F.distr==2?$y:W?p==1?Jy:jy:hr)),b.splits=pt(b.splits||(W&&F.distr==1?le:F.distr==3?Yh:F.distr==4?gb:mb)),b.stroke=pt(b.stroke),b.grid.stroke=pt(b.grid.stroke),b.ticks.stroke=pt(b.ticks.stroke),b.border.stroke=pt(b.border.stroke);let K=b.values;b.values=Gs(K)&&!Gs(K[0])?pt(K):W?Gs(K)?Im($,Pm(K,H)):Tm(K)?tb($,K):K||Z:K||pb,b.filter=pt(b.filter||(F.distr>=3&&F.log==10?vb:F.distr==3&&F.log==2?yb:Qm)),b.font=qm(b.font),b.labelFont=qm(b.labelFont),b._size=b.size(i,null,w,0),b._space=b._rotate=b._incrs=b._found=b._splits=b._values=null,b._size>0&&(Yi[w]=!0,b._el=Ei(iy,d))}}function ps(b,w,I,F){let[W,K,ae,fe]=I,be=w%2,De=0;return be==0&&(fe||K)&&(De=w==0&&!W||w==2&&!ae?En(Nm.size/3):0),be==1&&(W||ae)&&(De=w==1&&!K||w==3&&!fe?En(Om.size/2):0),De}let Go=i.padding=(n.padding||[ps,ps,ps,ps]).map(b=>pt(bt(b,ps))),Di=i._padding=Go.map((b,w)=>b(i,w,Yi,0)),en,on=null,an=null,Ji=s==1?y[0].idxs:null,oi=null,Fs=!1;function Wo(b,w){if(e=b??[],i.data=i._data=e,s==2){en=0;for(let I=1;I<y.length;I++)en+=e[I][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),oi=e[0],en=oi.length;let I=e;if(k==2){I=e.slice();let F=I[0]=Array(en);for(let W=0;W<en;W++)F[W]=W}i._data=e=I}if(at(!0),Ln("setData"),k==2&&(ye=!0),w!==!1){let I=L;I.auto(i,Fs)?Xo():ks(R,I.min,I.max),te=te||he.left>=0,pe=!0,Gn()}}i.setData=Wo;function Xo(){Fs=!0;let b,w;s==1&&(en>0?(on=Ji[0]=0,an=Ji[1]=en-1,b=e[0][on],w=e[0][an],k==2?(b=on,w=an):b==w&&(k==3?[b,w]=Il(b,b,L.log,!1):k==4?[b,w]=nd(b,b,L.log,!1):L.time?w=b+En(86400/p):[b,w]=Rl(b,w,id,!0))):(on=Ji[0]=b=null,an=Ji[1]=w=null)),ks(R,b,w)}let Lr,Us,Dr,T,V,j,Y,J,Te,Pe;function Ae(b,w,I,F,W,K){b??=cm,I??=rd,F??="butt",W??=cm,K??="round",b!=Lr&&(h.strokeStyle=Lr=b),W!=Us&&(h.fillStyle=Us=W),w!=Dr&&(h.lineWidth=Dr=w),K!=V&&(h.lineJoin=V=K),F!=j&&(h.lineCap=j=F),I!=T&&h.setLineDash(T=I)}function Ie(b,w,I,F){w!=Us&&(h.fillStyle=Us=w),b!=Y&&(h.font=Y=b),I!=J&&(h.textAlign=J=I),F!=Te&&(h.textBaseline=Te=F)}function ze(b,w,I,F,W=0){if(F.length>0&&b.auto(i,Fs)&&(w==null||w.min==null)){let K=bt(on,0),ae=bt(an,F.length-1),fe=I.min==null?vy(F,K,ae,W,b.distr==3):[I.min,I.max];b.min=ki(b.min,I.min=fe[0]),b.max=jn(b.max,I.max=fe[1])}}let je={min:null,max:null};function ut(){for(let F in S){let W=S[F];G[F]==null&&(W.min==null||G[R]!=null&&W.auto(i,Fs))&&(G[F]=je)}for(let F in S){let W=S[F];G[F]==null&&W.from!=null&&G[W.from]!=null&&(G[F]=je)}G[R]!=null&&at(!0);let b={};for(let F in G){let W=G[F];if(W!=null){let K=b[F]=Kr(S[F],Ry);if(W.min!=null)xn(K,W);else if(F!=R||s==2)if(en==0&&K.from==null){let ae=K.range(i,null,null,F);K.min=ae[0],K.max=ae[1]}else K.min=Ot,K.max=-Ot}}if(en>0){y.forEach((F,W)=>{if(s==1){let K=F.scale,ae=G[K];if(ae==null)return;let fe=b[K];if(W==0){let be=fe.range(i,fe.min,fe.max,K);fe.min=be[0],fe.max=be[1],on=Oi(fe.min,e[0]),an=Oi(fe.max,e[0]),an-on>1&&(e[0][on]<fe.min&&on++,e[0][an]>fe.max&&an--),F.min=oi[on],F.max=oi[an]}else F.show&&F.auto&&ze(fe,ae,F,e[W],F.sorted);F.idxs[0]=on,F.idxs[1]=an}else if(W>0&&F.show&&F.auto){let[K,ae]=F.facets,fe=K.scale,be=ae.scale,[De,Ne]=e[W],Ue=b[fe],nt=b[be];Ue!=null&&ze(Ue,G[fe],K,De,K.sorted),nt!=null&&ze(nt,G[be],ae,Ne,ae.sorted),F.min=ae.min,F.max=ae.max}});for(let F in b){let W=b[F],K=G[F];if(W.from==null&&(K==null||K.min==null)){let ae=W.range(i,W.min==Ot?null:W.min,W.max==-Ot?null:W.max,F);W.min=ae[0],W.max=ae[1]}}}for(let F in b){let W=b[F];if(W.from!=null){let K=b[W.from];if(K.min==null)W.min=W.max=null;else{let ae=W.range(i,K.min,K.max,F);W.min=ae[0],W.max=ae[1]}}}let w={},I=!1;for(let F in b){let W=b[F],K=S[F];if(K.min!=W.min||K.max!=W.max){K.min=W.min,K.max=W.max;let ae=K.distr;K._min=ae==3?vs(K.min):ae==4?Bh(K.min,K.asinh):ae==100?K.fwd(K.min):K.min,K._max=ae==3?vs(K.max):ae==4?Bh(K.max,K.asinh):ae==100?K.fwd(K.max):K.max,w[F]=I=!0}}if(I){y.forEach((F,W)=>{s==2?W>0&&w.y&&(F._paths=null):w[F.scale]&&(F._paths=null)});for(let F in w)ye=!0,Ln("setScale",F);me&&he.left>=0&&(te=pe=!0)}for(let F in G)G[F]=null}function Be(b){let w=$h(on-1,0,en-1),I=$h(an+1,0,en-1);for(;b[w]==null&&w>0;)w--;for(;b[I]==null&&I<en-1;)I++;return[w,I]}function ht(){if(en>0){let b=y.some(w=>w._focus)&&Pe!=ke.alpha;b&&(h.globalAlpha=Pe=ke.alpha),y.forEach((w,I)=>{if(I>0&&w.show&&(Kt(I,!1),Kt(I,!0),w._paths==null)){let F=Pe;Pe!=w.alpha&&(h.globalAlpha=Pe=w.alpha);let W=s==2?[0,e[I][0].length-1]:Be(e[I]);w._paths=w.paths(i,I,W[0],W[1]),Pe!=F&&(h.globalAlpha=Pe=F)}}),y.forEach((w,I)=>{if(I>0&&w.show){let F=Pe;Pe!=w.alpha&&(h.globalAlpha=Pe=w.alpha),w._paths!=null&&Tt(I,!1);{let W=w._paths!=null?w._paths.gaps:null,K=w.points.show(i,I,on,an,W),ae=w.points.filter(i,I,K,W);(K||ae)&&(w.points._paths=w.points.paths(i,I,on,an,ae),Tt(I,!0))}Pe!=F&&(h.globalAlpha=Pe=F),Ln("drawSeries",I)}}),b&&(h.globalAlpha=Pe=1)}}function Kt(b,w){let I=w?y[b].points:y[b];I._stroke=I.stroke(i,b),I._fill=I.fill(i,b)}function Tt(b,w){let I=w?y[b].points:y[b],{stroke:F,fill:W,clip:K,flags:ae,_stroke:fe=I._stroke,_fill:be=I._fill,_width:De=I.width}=I._paths;De=kt(De*Mt,3);let Ne=null,Ue=De%2/2;w&&be==null&&(be=De>0?"#fff":fe);let nt=I.pxAlign==1&&Ue>0;if(nt&&h.translate(Ue,Ue),!w){let St=P-De/2,yt=M-De/2,dt=q+De,Ye=ue+De;Ne=new Path2D,Ne.rect(St,yt,dt,Ye)}w?Fe(fe,De,I.dash,I.cap,be,F,W,ae,K):At(b,fe,De,I.dash,I.cap,be,F,W,ae,Ne,K),nt&&h.translate(-Ue,-Ue)}function At(b,w,I,F,W,K,ae,fe,be,De,Ne){let Ue=!1;be!=0&&C.forEach((nt,St)=>{if(nt.series[0]==b){let yt=y[nt.series[1]],dt=e[nt.series[1]],Ye=(yt._paths||la).band;Gs(Ye)&&(Ye=nt.dir==1?Ye[0]:Ye[1]);let We,Wt=null;yt.show&&Ye&&by(dt,on,an)?(Wt=nt.fill(i,St)||K,We=yt._paths.clip):Ye=null,Fe(w,I,F,W,Wt,ae,fe,be,De,Ne,We,Ye),Ue=!0}}),Ue||Fe(w,I,F,W,K,ae,fe,be,De,Ne)}let wn=jr|Zh;function Fe(b,w,I,F,W,K,ae,fe,be,De,Ne,Ue){Ae(b,w,I,F,W),(be||De||Ue)&&(h.save(),be&&h.clip(be),De&&h.clip(De)),Ue?(fe&wn)==wn?(h.clip(Ue),Ne&&h.clip(Ne),ft(W,ae),fn(b,K,w)):fe&Zh?(ft(W,ae),h.clip(Ue),fn(b,K,w)):fe&jr&&(h.save(),h.clip(Ue),Ne&&h.clip(Ne),ft(W,ae),h.restore(),fn(b,K,w)):(ft(W,ae),fn(b,K,w)),(be||De||Ue)&&h.restore()}function fn(b,w,I){I>0&&(w instanceof Map?w.forEach((F,W)=>{h.strokeStyle=Lr=W,h.stroke(F)}):w!=null&&b&&h.stroke(w))}function ft(b,w){w instanceof Map?w.forEach((I,F)=>{h.fillStyle=Us=F,h.fill(I)}):w!=null&&b&&h.fill(w)}function ms(b,w,I,F){let W=A[b],K;if(F<=0)K=[0,0];else{let ae=W._space=W.space(i,b,w,I,F),fe=W._incrs=W.incrs(i,b,w,I,F,ae);K=Hb(w,I,fe,F,ae)}return W._found=K}function pn(b,w,I,F,W,K,ae,fe,be,De){let Ne=ae%2/2;v==1&&h.translate(Ne,Ne),Ae(fe,ae,be,De,fe),h.beginPath();let Ue,nt,St,yt,dt=W+(F==0||F==3?-K:K);I==0?(nt=W,yt=dt):(Ue=W,St=dt);for(let Ye=0;Ye<b.length;Ye++)w[Ye]!=null&&(I==0?Ue=St=b[Ye]:nt=yt=b[Ye],h.moveTo(Ue,nt),h.lineTo(St,yt));h.stroke(),v==1&&h.translate(-Ne,-Ne)}function Nr(b){let w=!0;return A.forEach((I,F)=>{if(!I.show)return;let W=S[I.scale];if(W.min==null){I._show&&(w=!1,I._show=!1,at(!1));return}else I._show||(w=!1,I._show=!0,at(!1));let K=I.side,ae=K%2,{min:fe,max:be}=W,[De,Ne]=ms(F,fe,be,ae==0?B:Ce);if(Ne==0)return;let Ue=W.distr==2,nt=I._splits=I.splits(i,F,fe,be,De,Ne,Ue),St=W.distr==2?nt.map(We=>oi[We]):nt,yt=W.distr==2?oi[nt[1]]-oi[nt[0]]:De,dt=I._values=I.values(i,I.filter(i,St,F,Ne,yt),F,Ne,yt);I._rotate=K==2?I.rotate(i,dt,F,Ne):0;let Ye=I._size;I._size=Ti(I.size(i,dt,F,b)),Ye!=null&&I._size!=Ye&&(w=!1)}),w}function Zi(b){let w=!0;return Go.forEach((I,F)=>{let W=I(i,F,Yi,b);W!=Di[F]&&(w=!1),Di[F]=W}),w}function gs(){for(let b=0;b<A.length;b++){let w=A[b];if(!w.show||!w._show)continue;let I=w.side,F=I%2,W,K,ae=w.stroke(i,b),fe=I==0||I==3?-1:1,[be,De]=w._found;if(w.label!=null){let Zn=w.labelGap*fe,ci=En((w._lpos+Zn)*Mt);Ie(w.labelFont[0],ae,"center",I==2?"top":lm),h.save(),F==1?(W=K=0,h.translate(ci,En(M+ue/2)),h.rotate((I==3?-Tl:Tl)/2)):(W=En(P+q/2),K=ci);let ar=Km(w.label)?w.label(i,b,be,De):w.label;h.fillText(ar,W,K),h.restore()}if(De==0)continue;let Ne=S[w.scale],Ue=F==0?q:ue,nt=F==0?P:M,St=w._splits,yt=Ne.distr==2?St.map(Zn=>oi[Zn]):St,dt=Ne.distr==2?oi[St[1]]-oi[St[0]]:be,Ye=w.ticks,We=w.border,Wt=Ye.show?Ye.size:0,nn=En(Wt*Mt),Dn=En((w.alignTo==2?w._size-Wt-w.gap:w.gap)*Mt),It=w._rotate*-Tl/180,sn=m(w._pos*Mt),ai=(nn+Dn)*fe,Jn=sn+ai;K=F==0?Jn:0,W=F==1?Jn:0;let bi=w.font[0],Ni=w.align==1?qr:w.align==2?Uh:It>0?qr:It<0?Uh:F==0?"center":I==3?Uh:qr,Qi=It||F==1?"middle":I==2?"top":lm;Ie(bi,ae,Ni,Qi);let li=w.font[1]*w.lineGap,Si=St.map(Zn=>m(a(Zn,Ne,Ue,nt))),Fi=w._values;for(let Zn=0;Zn<Fi.length;Zn++){let ci=Fi[Zn];if(ci!=null){F==0?W=Si[Zn]:K=Si[Zn],ci=""+ci;let ar=ci.indexOf(`
`)==-1?[ci]:ci.split(/\n/gm);for(let Kn=0;Kn<ar.length;Kn++){let Sp=ar[Kn];It?(h.save(),h.translate(W,K+Kn*li),h.rotate(It),h.fillText(Sp,0,0),h.restore()):h.fillText(Sp,W,K+Kn*li)}}}Ye.show&&pn(Si,Ye.filter(i,yt,b,De,dt),F,I,sn,nn,kt(Ye.width*Mt,3),Ye.stroke(i,b),Ye.dash,Ye.cap);let es=w.grid;es.show&&pn(Si,es.filter(i,yt,b,De,dt),F,F==0?2:1,F==0?M:P,F==0?ue:q,kt(es.width*Mt,3),es.stroke(i,b),es.dash,es.cap),We.show&&pn([sn],[1],F==0?1:0,F==0?1:2,F==1?M:P,F==1?ue:q,kt(We.width*Mt,3),We.stroke(i,b),We.dash,We.cap)}Ln("drawAxes")}function at(b){y.forEach((w,I)=>{I>0&&(w._paths=null,b&&(s==1?(w.min=null,w.max=null):w.facets.forEach(F=>{F.min=null,F.max=null})))})}let tn=!1,Yn=!1,Rt=[];function mn(){Yn=!1;for(let b=0;b<Rt.length;b++)Ln(...Rt[b]);Rt.length=0}function Gn(){tn||(Fy(sp),tn=!0)}function rl(b,w=!1){tn=!0,Yn=w,b(i),sp(),w&&Rt.length>0&&queueMicrotask(mn)}i.batch=rl;function sp(){if(oe&&(ut(),oe=!1),ye&&(Ee(),ye=!1),xe){if(Xt(f,qr,qe),Xt(f,"top",it),Xt(f,sa,B),Xt(f,ra,Ce),Xt(g,qr,qe),Xt(g,"top",it),Xt(g,sa,B),Xt(g,ra,Ce),Xt(d,sa,Qt),Xt(d,ra,dn),u.width=En(Qt*Mt),u.height=En(dn*Mt),A.forEach(({_el:b,_show:w,_size:I,_pos:F,side:W})=>{if(b!=null)if(w){let K=W===3||W===0?I:0,ae=W%2==1;Xt(b,ae?"left":"top",F-K),Xt(b,ae?"width":"height",I),Xt(b,ae?"top":"left",ae?it:qe),Xt(b,ae?"height":"width",ae?Ce:B),Xh(b,dr)}else ui(b,dr)}),Lr=Us=Dr=V=j=Y=J=Te=T=null,Pe=1,Yo(!0),qe!=we||it!=Ft||B!=Ve||Ce!=Xe){at(!1);let b=B/Ve,w=Ce/Xe;if(me&&!te&&he.left>=0){he.left*=b,he.top*=w,Fr&&ss(Fr,En(he.left),0,B,Ce),Ur&&ss(Ur,0,En(he.top),B,Ce);for(let I=0;I<st.length;I++){let F=st[I];F!=null&&(Vt[I]*=b,$n[I]*=w,ss(F,Ti(Vt[I]),Ti($n[I]),B,Ce))}}if(Gt.show&&!se&&Gt.left>=0&&Gt.width>0){Gt.left*=b,Gt.width*=b,Gt.top*=w,Gt.height*=w;for(let I in fh)Xt(Br,I,Gt[I])}we=qe,Ft=it,Ve=B,Xe=Ce}Ln("setSize"),xe=!1}Qt>0&&dn>0&&(h.clearRect(0,0,u.width,u.height),Ln("drawClear"),E.forEach(b=>b()),Ln("draw")),Gt.show&&se&&(ol(Gt),se=!1),me&&te&&(or(null,!0,!1),te=!1),de.show&&de.live&&pe&&(hh(),pe=!1),l||(l=!0,i.status=1,Ln("ready")),Fs=!1,tn=!1}i.redraw=(b,w)=>{ye=w||!1,b!==!1?ks(R,L.min,L.max):Gn()};function lh(b,w){let I=S[b];if(I.from==null){if(en==0){let F=I.range(i,w.min,w.max,b);w.min=F[0],w.max=F[1]}if(w.min>w.max){let F=w.min;w.min=w.max,w.max=F}if(en>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;b==R&&I.distr==2&&en>0&&(w.min=Oi(w.min,e[0]),w.max=Oi(w.max,e[0]),w.min==w.max&&w.max++),G[b]=w,oe=!0,Gn()}}i.setScale=lh;let ch,uh,Fr,Ur,rp,op,Or,kr,ap,lp,Ht,Jt,Os=!1,On=he.drag,Pn=On.x,In=On.y;me&&(he.x&&(ch=Ei(ry,g)),he.y&&(uh=Ei(oy,g)),L.ori==0?(Fr=ch,Ur=uh):(Fr=uh,Ur=ch),Ht=he.left,Jt=he.top);let Gt=i.select=xn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Br=Gt.show?Ei(sy,Gt.over?g:f):null;function ol(b,w){if(Gt.show){for(let I in b)Gt[I]=b[I],I in fh&&Xt(Br,I,b[I]);w!==!1&&Ln("setSelect")}}i.setSelect=ol;function nv(b){if(y[b].show)ee&&Xh(Je[b],dr);else if(ee&&ui(Je[b],dr),me){let I=Re?st[0]:st[b];I!=null&&ss(I,-10,-10,B,Ce)}}function ks(b,w,I){lh(b,{min:w,max:I})}function Ki(b,w,I,F){w.focus!=null&&av(b),w.show!=null&&y.forEach((W,K)=>{K>0&&(b==K||b==null)&&(W.show=w.show,nv(K),s==2?(ks(W.facets[0].scale,null,null),ks(W.facets[1].scale,null,null)):ks(W.scale,null,null),Gn())}),I!==!1&&Ln("setSeries",b,w),F&&Jo("setSeries",i,b,w)}i.setSeries=Ki;function iv(b,w){xn(C[b],w)}function sv(b,w){b.fill=pt(b.fill||null),b.dir=bt(b.dir,-1),w=w??C.length,C.splice(w,0,b)}function rv(b){b==null?C.length=0:C.splice(b,1)}i.addBand=sv,i.setBand=iv,i.delBand=rv;function ov(b,w){y[b].alpha=w,me&&st[b]!=null&&(st[b].style.opacity=w),ee&&Je[b]&&(Je[b].style.opacity=w)}let _s,Bs,rr,zr={focus:!0};function av(b){if(b!=rr){let w=b==null,I=ke.alpha!=1;y.forEach((F,W)=>{if(s==1||W>0){let K=w||W==0||W==b;F._focus=w?null:K,I&&ov(W,K?1:ke.alpha)}}),rr=b,I&&Gn()}}ee&&Ke&&xt(dm,Me,b=>{he._lock||(Ze(b),rr!=null&&Ki(null,zr,!0,gn.setSeries))});function ji(b,w,I){let F=S[w];I&&(b=b/Mt-(F.ori==1?it:qe));let W=B;F.ori==1&&(W=Ce,b=W-b),F.dir==-1&&(b=W-b);let K=F._min,ae=F._max,fe=b/W,be=K+(ae-K)*fe,De=F.distr;return De==3?Jr(10,be):De==4?My(be,F.asinh):De==100?F.bwd(be):be}function lv(b,w){let I=ji(b,R,w);return Oi(I,e[0],on,an)}i.valToIdx=b=>Oi(b,e[0]),i.posToIdx=lv,i.posToVal=ji,i.valToPos=(b,w,I)=>S[w].ori==0?r(b,S[w],I?q:B,I?P:0):o(b,S[w],I?ue:Ce,I?M:0),i.setCursor=(b,w,I)=>{Ht=b.left,Jt=b.top,or(null,w,I)};function cp(b,w){Xt(Br,qr,Gt.left=b),Xt(Br,sa,Gt.width=w)}function up(b,w){Xt(Br,"top",Gt.top=b),Xt(Br,ra,Gt.height=w)}let qo=L.ori==0?cp:up,$o=L.ori==1?cp:up;function cv(){if(ee&&de.live)for(let b=s==2?1:0;b<y.length;b++){if(b==0&&ot)continue;let w=de.values[b],I=0;for(let F in w)Oe[b][I++].firstChild.nodeValue=w[F]}}function hh(b,w){if(b!=null&&(b.idxs?b.idxs.forEach((I,F)=>{ie[F]=I}):Ay(b.idx)||ie.fill(b.idx),de.idx=ie[0]),ee&&de.live){for(let I=0;I<y.length;I++)(I>0||s==1&&!ot)&&uv(I,ie[I]);cv()}pe=!1,w!==!1&&Ln("setLegend")}i.setLegend=hh;function uv(b,w){let I=y[b],F=b==0&&k==2?oi:e[b],W;ot?W=I.values(i,b,w)??tt:(W=I.value(i,w==null?null:F[w],b,w),W=W==null?tt:{_:W}),de.values[b]=W}function or(b,w,I){ap=Ht,lp=Jt,[Ht,Jt]=he.move(i,Ht,Jt),he.left=Ht,he.top=Jt,me&&(Fr&&ss(Fr,En(Ht),0,B,Ce),Ur&&ss(Ur,0,En(Jt),B,Ce));let F,W=on>an;_s=Ot,Bs=null;let K=L.ori==0?B:Ce,ae=L.ori==1?B:Ce;if(Ht<0||en==0||W){F=he.idx=null;for(let fe=0;fe<y.length;fe++){let be=st[fe];be!=null&&ss(be,-10,-10,B,Ce)}Ke&&Ki(null,zr,!0,b==null&&gn.setSeries),de.live&&(ie.fill(F),pe=!0)}else{let fe,be,De;s==1&&(fe=L.ori==0?Ht:Jt,be=ji(fe,R),F=he.idx=Oi(be,e[0],on,an),De=z(e[0][F],L,K,0));let Ne=-10,Ue=-10,nt=0,St=0,yt=!0,dt="",Ye="";for(let We=s==2?1:0;We<y.length;We++){let Wt=y[We],nn=ie[We],Dn=nn==null?null:s==1?e[We][nn]:e[We][1][nn],It=he.dataIdx(i,We,F,be),sn=It==null?null:s==1?e[We][It]:e[We][1][It];if(pe=pe||sn!=Dn||It!=nn,ie[We]=It,We>0&&Wt.show){let ai=It==null?-10:It==F?De:z(s==1?e[0][It]:e[We][0][It],L,K,0),Jn=sn==null?-10:N(sn,s==1?S[Wt.scale]:S[Wt.facets[1].scale],ae,0);if(Ke&&sn!=null){let bi=L.ori==1?Ht:Jt,Ni=Tn(ke.dist(i,We,It,Jn,bi));if(Ni<_s){let Qi=ke.bias;if(Qi!=0){let li=ji(bi,Wt.scale),Si=sn>=0?1:-1,Fi=li>=0?1:-1;Fi==Si&&(Fi==1?Qi==1?sn>=li:sn<=li:Qi==1?sn<=li:sn>=li)&&(_s=Ni,Bs=We)}else _s=Ni,Bs=We}}if(pe||Re){let bi,Ni;L.ori==0?(bi=ai,Ni=Jn):(bi=Jn,Ni=ai);let Qi,li,Si,Fi,es,Zn,ci=!0,ar=ce.bbox;if(ar!=null){ci=!1;let Kn=ar(i,We);Si=Kn.left,Fi=Kn.top,Qi=Kn.width,li=Kn.height}else Si=bi,Fi=Ni,Qi=li=ce.size(i,We);if(Zn=ce.fill(i,We),es=ce.stroke(i,We),Re)We==Bs&&_s<=ke.prox&&(Ne=Si,Ue=Fi,nt=Qi,St=li,yt=ci,dt=Zn,Ye=es);else{let Kn=st[We];Kn!=null&&(Vt[We]=Si,$n[We]=Fi,vm(Kn,Qi,li,ci),_m(Kn,Zn,es),ss(Kn,Ti(Si),Ti(Fi),B,Ce))}}}}if(Re){let We=ke.prox,Wt=rr==null?_s<=We:_s>We||Bs!=rr;if(pe||Wt){let nn=st[0];nn!=null&&(Vt[0]=Ne,$n[0]=Ue,vm(nn,nt,St,yt),_m(nn,dt,Ye),ss(nn,Ti(Ne),Ti(Ue),B,Ce))}}}if(Gt.show&&Os)if(b!=null){let[fe,be]=gn.scales,[De,Ne]=gn.match,[Ue,nt]=b.cursor.sync.scales,St=b.cursor.drag;if(Pn=St._x,In=St._y,Pn||In){let{left:yt,top:dt,width:Ye,height:We}=b.select,Wt=b.scales[Ue].ori,nn=b.posToVal,Dn,It,sn,ai,Jn,bi=fe!=null&&De(fe,Ue),Ni=be!=null&&Ne(be,nt);bi&&Pn?(Wt==0?(Dn=yt,It=Ye):(Dn=dt,It=We),sn=S[fe],ai=z(nn(Dn,Ue),sn,K,0),Jn=z(nn(Dn+It,Ue),sn,K,0),qo(ki(ai,Jn),Tn(Jn-ai))):qo(0,K),Ni&&In?(Wt==1?(Dn=yt,It=Ye):(Dn=dt,It=We),sn=S[be],ai=N(nn(Dn,nt),sn,ae,0),Jn=N(nn(Dn+It,nt),sn,ae,0),$o(ki(ai,Jn),Tn(Jn-ai))):$o(0,ae)}else ph()}else{let fe=Tn(ap-rp),be=Tn(lp-op);if(L.ori==1){let nt=fe;fe=be,be=nt}Pn=On.x&&fe>=On.dist,In=On.y&&be>=On.dist;let De=On.uni;De!=null?Pn&&In&&(Pn=fe>=De,In=be>=De,!Pn&&!In&&(be>fe?In=!0:Pn=!0)):On.x&&On.y&&(Pn||In)&&(Pn=In=!0);let Ne,Ue;Pn&&(L.ori==0?(Ne=Or,Ue=Ht):(Ne=kr,Ue=Jt),qo(ki(Ne,Ue),Tn(Ue-Ne)),In||$o(0,ae)),In&&(L.ori==1?(Ne=Or,Ue=Ht):(Ne=kr,Ue=Jt),$o(ki(Ne,Ue),Tn(Ue-Ne)),Pn||qo(0,K)),!Pn&&!In&&(qo(0,0),$o(0,0))}if(On._x=Pn,On._y=In,b==null){if(I){if(bp!=null){let[fe,be]=gn.scales;gn.values[0]=fe!=null?ji(L.ori==0?Ht:Jt,fe):null,gn.values[1]=be!=null?ji(L.ori==1?Ht:Jt,be):null}Jo(Oh,i,Ht,Jt,B,Ce,F)}if(Ke){let fe=I&&gn.setSeries,be=ke.prox;rr==null?_s<=be&&Ki(Bs,zr,!0,fe):_s>be?Ki(null,zr,!0,fe):Bs!=rr&&Ki(Bs,zr,!0,fe)}}pe&&(de.idx=F,hh()),w!==!1&&Ln("setCursor")}let zs=null;Object.defineProperty(i,"rect",{get(){return zs==null&&Yo(!1),zs}});function Yo(b=!1){b?zs=null:(zs=g.getBoundingClientRect(),Ln("syncRect",zs))}function hp(b,w,I,F,W,K,ae){he._lock||Os&&b!=null&&b.movementX==0&&b.movementY==0||(dh(b,w,I,F,W,K,ae,!1,b!=null),b!=null?or(null,!0,!0):or(w,!0,!1))}function dh(b,w,I,F,W,K,ae,fe,be){if(zs==null&&Yo(!1),Ze(b),b!=null)I=b.clientX-zs.left,F=b.clientY-zs.top;else{if(I<0||F<0){Ht=-10,Jt=-10;return}let[De,Ne]=gn.scales,Ue=w.cursor.sync,[nt,St]=Ue.values,[yt,dt]=Ue.scales,[Ye,We]=gn.match,Wt=w.axes[0].side%2==1,nn=L.ori==0?B:Ce,Dn=L.ori==1?B:Ce,It=Wt?K:W,sn=Wt?W:K,ai=Wt?F:I,Jn=Wt?I:F;if(yt!=null?I=Ye(De,yt)?a(nt,S[De],nn,0):-10:I=nn*(ai/It),dt!=null?F=We(Ne,dt)?a(St,S[Ne],Dn,0):-10:F=Dn*(Jn/sn),L.ori==1){let bi=I;I=F,F=bi}}be&&(w==null||w.cursor.event.type==Oh)&&((I<=1||I>=B-1)&&(I=ur(I,B)),(F<=1||F>=Ce-1)&&(F=ur(F,Ce))),fe?(rp=I,op=F,[Or,kr]=he.move(i,I,F)):(Ht=I,Jt=F)}let fh={width:0,height:0,left:0,top:0};function ph(){ol(fh,!1)}let dp,fp,pp,mp;function gp(b,w,I,F,W,K,ae){Os=!0,Pn=In=On._x=On._y=!1,dh(b,w,I,F,W,K,ae,!0,!1),b!=null&&(xt(kh,Gh,_p,!1),Jo(um,i,Or,kr,B,Ce,null));let{left:fe,top:be,width:De,height:Ne}=Gt;dp=fe,fp=be,pp=De,mp=Ne}function _p(b,w,I,F,W,K,ae){Os=On._x=On._y=!1,dh(b,w,I,F,W,K,ae,!1,!0);let{left:fe,top:be,width:De,height:Ne}=Gt,Ue=De>0||Ne>0,nt=dp!=fe||fp!=be||pp!=De||mp!=Ne;if(Ue&&nt&&ol(Gt),On.setScale&&Ue&&nt){let St=fe,yt=De,dt=be,Ye=Ne;if(L.ori==1&&(St=be,yt=Ne,dt=fe,Ye=De),Pn&&ks(R,ji(St,R),ji(St+yt,R)),In)for(let We in S){let Wt=S[We];We!=R&&Wt.from==null&&Wt.min!=Ot&&ks(We,ji(dt+Ye,We),ji(dt,We))}ph()}else he.lock&&(he._lock=!he._lock,or(w,!0,b!=null));b!=null&&(Mn(kh,Gh),Jo(kh,i,Ht,Jt,B,Ce,null))}function hv(b,w,I,F,W,K,ae){if(he._lock)return;Ze(b);let fe=Os;if(Os){let be=!0,De=!0,Ne=10,Ue,nt;L.ori==0?(Ue=Pn,nt=In):(Ue=In,nt=Pn),Ue&&nt&&(be=Ht<=Ne||Ht>=B-Ne,De=Jt<=Ne||Jt>=Ce-Ne),Ue&&be&&(Ht=Ht<Or?0:B),nt&&De&&(Jt=Jt<kr?0:Ce),or(null,!0,!0),Os=!1}Ht=-10,Jt=-10,ie.fill(null),or(null,!0,!0),fe&&(Os=fe)}function xp(b,w,I,F,W,K,ae){he._lock||(Ze(b),Xo(),ph(),b!=null&&Jo(fm,i,Ht,Jt,B,Ce,null))}function vp(){A.forEach(Gb),O(i.width,i.height,!0)}fr(Al,Yr,vp);let Vr={};Vr.mousedown=gp,Vr.mousemove=hp,Vr.mouseup=_p,Vr.dblclick=xp,Vr.setSeries=(b,w,I,F)=>{let W=gn.match[2];I=W(i,w,I),I!=-1&&Ki(I,F,!0,!1)},me&&(xt(um,g,gp),xt(Oh,g,hp),xt(hm,g,b=>{Ze(b),Yo(!1)}),xt(dm,g,hv),xt(fm,g,xp),Kh.add(i),i.syncRect=Yo);let al=i.hooks=n.hooks||{};function Ln(b,w,I){Yn?Rt.push([b,w,I]):b in al&&al[b].forEach(F=>{F.call(null,i,w,I)})}(n.plugins||[]).forEach(b=>{for(let w in b.hooks)al[w]=(al[w]||[]).concat(b.hooks[w])});let yp=(b,w,I)=>I,gn=xn({key:null,setSeries:!1,filters:{pub:wm,sub:wm},scales:[R,y[1]?y[1].scale:null],match:[Em,Em,yp],values:[null,null]},he.sync);gn.match.length==2&&gn.match.push(yp),he.sync=gn;let bp=gn.key,mh=bg(bp);function Jo(b,w,I,F,W,K,ae){gn.filters.pub(b,w,I,F,W,K,ae)&&mh.pub(b,w,I,F,W,K,ae)}mh.sub(i);function dv(b,w,I,F,W,K,ae){gn.filters.sub(b,w,I,F,W,K,ae)&&Vr[b](null,w,I,F,W,K,ae)}i.pub=dv;function fv(){mh.unsub(i),Kh.delete(i),Cn.clear(),qh(Al,Yr,vp),c.remove(),Me?.remove(),Ln("destroy")}i.destroy=fv;function gh(){Ln("init",n,e),Wo(e||n.data,!1),G[R]?lh(R,G[R]):Xo(),se=Gt.show&&(Gt.width>0||Gt.height>0),te=pe=!0,O(n.width,n.height)}return y.forEach(Ir),A.forEach(fs),t?t instanceof HTMLElement?(t.appendChild(c),gh()):t(i,gh):gh(),i}vn.assign=xn;vn.fmtNum=sd;vn.rangeNum=Rl;vn.rangeLog=Il;vn.rangeAsinh=nd;vn.orient=mr;vn.pxRatio=Mt;vn.join=Ny;vn.fmtDate=od,vn.tzDate=Xy;vn.sync=bg;{vn.addGap=Ab,vn.clipGaps=Nl;let n=vn.paths={points:Ag};n.linear=Cg,n.stepped=Pb,n.bars=Ib,n.spline=Db}var fd="calyx-theme",Dg="(prefers-color-scheme: dark)";function Bl(){let n=localStorage.getItem(fd);return n==="light"||n==="dark"?n:"system"}function zl(n){n==="system"?localStorage.removeItem(fd):localStorage.setItem(fd,n),n==="system"?delete document.documentElement.dataset.theme:document.documentElement.dataset.theme=n,window.dispatchEvent(new Event("calyx-theme"))}function kl(){let n=document.documentElement.dataset.theme;return n==="light"||n==="dark"?n:matchMedia(Dg).matches?"dark":"light"}function Vl(){let[n,e]=Ut(kl());return Dt(()=>{let t=()=>e(kl()),i=matchMedia(Dg);return i.addEventListener("change",t),window.addEventListener("calyx-theme",t),()=>{i.removeEventListener("change",t),window.removeEventListener("calyx-theme",t)}},[]),n}var Ng=[["cycle","Mesh cycle"],["roll_angle","Roll angle in deg"],["time","Time in s"],["step","Position"]],Fg=190,Wb=[void 0,[7,4],[2,3],[12,3,2,3]],Xb=2;function Ug({studio:n}){let[e,t]=Ut("cycle"),[i,s]=Ut(null),r=n.settings.selected,o=r.flatMap(u=>n.results[u]??[]).filter(u=>u.steps),a=$b(o);if(a.length===0)return null;let l=(i??a.slice(0,Xb)).filter(u=>a.includes(u)),c=u=>s(l.includes(u)?l.filter(h=>h!==u):[...l,u]);return _("details",{class:"plots",open:!0,children:[_("summary",{children:["Plots",o.filter(u=>u.incomplete).map(u=>_("span",{class:"incomplete",children:[rn(u.id),": ",ts(u)]},u.id))]}),_("div",{class:"plot-settings",children:[_("div",{class:"chips",role:"group","aria-label":"Plotted outputs",children:a.map(u=>_("button",{type:"button",class:"chip","aria-pressed":l.includes(u),onClick:()=>c(u),children:cn(u)},u))}),o.some(u=>u.stride>1)&&_("span",{class:"muted small-text",children:["one of ",Math.max(...o.map(u=>u.stride))," positions"]}),_("label",{class:"inline",children:["over",_("select",{value:e,onChange:u=>t(u.currentTarget.value),children:Ng.map(([u,h])=>_("option",{value:u,children:h},u))})]})]}),_("div",{class:"plot-grid",children:l.map(u=>_(Zb,{title:cn(u),unit:Yb(n,o,u),label:Ng.find(([h])=>h===e)?.[1]??"",curves:o.flatMap(h=>Jb(n,h,u,e,r.indexOf(h.id)))},u))})]})}var qb=new Set(["step","time","cycle","roll_angle","point"]);function $b(n){return[...new Set(n.flatMap(e=>Object.keys(e.steps??{})))].filter(e=>!qb.has(e))}function Og(n,e,t){let i=e.run?.outputs?.[t]?.display??e.run?.columns?.[t]?.display,s=n.model?.outputs.find(r=>r.name===t);return{unit:i?.unit??s?.unit??"SI",factor:i?.factor??s?.factor??1}}function Yb(n,e,t){let i=e.find(s=>s.steps?.[t]);return i?Og(n,i,t).unit:""}function Jb(n,e,t,i,s){let[r,o]=[e.steps?.[i],e.steps?.[t]];if(!r||!o)return[];let{factor:a}=Og(n,e,t),l=i==="roll_angle"?180/Math.PI:1,c=r.map((h,d)=>d).filter(h=>typeof r[h]=="number");c.sort((h,d)=>Number(r[h])-Number(r[d]));let u=h=>typeof h=="number"?h/a:null;return[{run:rn(e.id),colour:Xr(s),x:c.map(h=>l*Number(r[h])),y:c.map(h=>u(o[h]))}]}function Zb({title:n,unit:e,label:t,curves:i}){let s=jt(null),r=Vl(),o=JSON.stringify([n,e,t,i,r]);return Dt(()=>{let a=s.current;if(!a)return;let l=new vn(Qb(a,n,e,t,i),jb(i),a),c=new ResizeObserver(()=>{a.clientWidth>0&&l.setSize({width:a.clientWidth,height:Fg})});return c.observe(a),()=>{c.disconnect(),l.destroy()}},[o]),_("figure",{class:"plot",children:[_("figcaption",{children:[n," ",e&&_("span",{class:"unit",children:e})]}),_("div",{ref:s,class:"canvas",role:"img","aria-label":Kb(n,e,i)})]})}function Kb(n,e,t){let i=t.map(({run:s,y:r})=>{let o=r.filter(a=>a!==null);return`${s} from ${ii(Math.min(...o))} to ${ii(Math.max(...o))}`});return`Plot of ${n}${e&&` in ${e}`}: ${i.join(", ")}`}function jb(n){return n.length===0?[[]]:vn.join(n.map(({x:e,y:t})=>[e,t]))}function Qb(n,e,t,i,s){let r=getComputedStyle(n),[o,a]=[r.color,r.borderTopColor],l="12px system-ui, sans-serif",u={values:(h,d)=>d.map(f=>String(Number(f.toPrecision(6)))),stroke:o,font:l,labelFont:l,grid:{stroke:a,width:1},ticks:{stroke:a,width:1,size:4}};return{width:Math.max(n.clientWidth,100),height:Fg,cursor:{sync:{key:"positions"},points:{size:6}},legend:{live:!0},scales:{x:{time:!1}},axes:[{...u,label:i,labelSize:18,size:34},{...u,size:58}],series:[{label:i},...s.map(({run:h,colour:d},f)=>({label:s.length>1?h:e,stroke:d,width:1.6,dash:Wb[f%2+2*(Math.floor(f/rm)%2)],spanGaps:!0,points:{show:(s[0]?.x.length??0)<60,size:4,fill:d},value:(g,v)=>v===null?"–":`${ii(v)} ${t}`}))]}}function pd(n){let e=n.run;return[["Directory",n.directory],["Started",xl(n.started)],["Model",e?.model],["Hash of the source",e?.source?.sha256?.slice(0,16)],["Calyx",e?.calyx],["Fidelity",e?.fidelity],["Positions",ta(n)],...Object.entries(n.settings??{}).map(([i,s])=>[`Set: ${vl(i)}`,yl(s)]),...Object.entries(e?.certificate??{}).map(([i,s])=>[`Residual: ${cn(i)}`,ii(s)])].filter(i=>!!i[1])}function kg({studio:n}){let e=n.settings.selected.flatMap(t=>n.results[t]??[]);return e.length===0?null:_("section",{class:"panel","aria-labelledby":"provenance-heading",children:[_("h2",{id:"provenance-heading",children:"Provenance"}),e.map(t=>_("details",{open:e.length===1,children:[_("summary",{children:rn(t.id)}),_("dl",{class:"provenance",children:pd(t).map(([i,s])=>_("div",{children:[_("dt",{children:i}),_("dd",{children:s})]},i))}),_(eS,{results:t}),t.printed&&_("pre",{class:"plain",tabIndex:0,"aria-label":"Text that the model prints",children:t.printed}),_("p",{class:"links",children:[t.has_report&&_("a",{href:wi(t.id,"/files/report.html"),target:"_blank",rel:"noreferrer",children:"Report"}),t.steps&&_("a",{href:wi(t.id,"/files/steps.csv"),download:`${t.id}-steps.csv`,children:"steps.csv"}),t.run&&_("a",{href:wi(t.id,"/files/run.json"),download:`${t.id}.json`,children:"run.json"}),!n.withoutModel&&t.params&&_("button",{type:"button",class:"quiet",onClick:()=>n.useForm(t),children:"Use these params and settings"})]})]},t.id))]})}function eS({results:n}){let e=Object.entries(n.run?.ignored_inputs??{}),t=Object.entries(n.run?.refused_outputs??{});return e.length+t.length===0?null:_("ul",{class:"messages",children:[e.map(([i,s])=>_("li",{class:"warning",children:[_("code",{children:i})," is not used as given: ",s]},i)),t.map(([i,s])=>_("li",{class:"warning",children:[_("code",{children:i})," has no value: ",s]},i))]})}function zg({studio:n}){if(n.withoutModel)return null;let{check:e,model:t}=n,i=n.runs.filter(s=>s.status==="running");return _("section",{class:"panel","aria-labelledby":"run-heading",children:[_("h2",{id:"run-heading",children:"Run"}),_(nS,{studio:n}),_("div",{class:"run-row",children:[_("button",{type:"button",class:"primary",disabled:!n.canRun,onClick:()=>{n.run()},children:"Run"}),_("label",{class:"switch",children:[_("input",{type:"checkbox",checked:n.settings.automatic,onChange:s=>n.setAutomatic(s.currentTarget.checked)}),"Run after changes if the predicted time is below 1 s"]})]}),_(tS,{studio:n}),e?.refused&&_("p",{class:"field-error",role:"alert",children:[_(Mi,{text:e.refused.message}),_("span",{class:"help",children:_(Mi,{text:e.refused.help})})]}),e&&!t?.broken&&e.rendered&&_("details",{open:!e.runnable,children:[_("summary",{children:e.runnable?"Warnings of the model":"Errors of the model with these params"}),_(bl,{text:e.rendered,isError:!e.runnable})]}),i.map(s=>_(iS,{studio:n,run:s},s.id)),n.settings.selected.slice(0,1).map(s=>_(rS,{studio:n,id:s},s))]})}function tS({studio:n}){let{errors:e={},setting_errors:t={}}=n.check??{},i=r=>n.analysisSettings.find(o=>o.name===r)?.label??r,s=[...Object.keys(t).map(r=>({id:`setting-${r}`,label:i(r)})),...Object.keys(e).map(r=>({id:`param-${r}`,label:cn(r)}))];return s.length===0?null:_("p",{class:"fields-with-errors",children:[s.length===1?"One field has an error:":`${s.length} fields have errors:`,s.map(({id:r,label:o})=>_("button",{type:"button",class:"quiet",onClick:()=>document.getElementById(r)?.focus(),children:o},r))]})}function nS({studio:n}){let{check:e}=n,t=e?.plan;if(!t){let i=e?.runnable?"The model analyses nothing.":n.isChecking?"Checking …":"No plan: the model or its params have errors.";return _("p",{class:"muted","aria-busy":n.isChecking,children:i})}return _("div",{"aria-busy":n.isChecking,children:[_("dl",{class:"facts",children:[_("div",{children:[_("dt",{children:"Predicted time"}),_("dd",{"data-testid":"predicted-time",children:Qo(t.time)})]}),_("div",{children:[_("dt",{children:"Memory"}),_("dd",{children:$p(t.memory)})]}),_("div",{children:[_("dt",{children:"Fidelity"}),_("dd",{"data-testid":"fidelity",children:t.fidelity})]}),_("div",{children:[_("dt",{children:"Positions"}),_("dd",{children:t.positions})]})]}),_("details",{children:[_("summary",{children:"Plan and gear data"}),_("pre",{class:"plain",tabIndex:0,"aria-label":"Plan",children:`${t.cost}
${t.text}
${e.gear_data}`.trim()})]})]})}function iS({studio:n,run:e}){let t=n.progress[e.id]??e.progress;return _("div",{class:"progress-card",children:[_("div",{class:"progress-head",children:[_("span",{children:rn(e.id)}),_("button",{type:"button",class:"quiet",disabled:!n.isConnected,onClick:()=>{n.cancel(e.id)},"aria-label":`Cancel ${rn(e.id)}`,children:"Cancel"})]}),_(sS,{name:rn(e.id),progress:t})]})}function sS({name:n,progress:e}){let t=e?.total??null,i=e?.seconds_left;return _(Lt,{children:[_("progress",{"aria-label":`Progress of ${n}`,max:t??void 0,value:t===null?void 0:e?.done}),_("p",{class:"muted small-text",children:[e?.stage??"starting",t!==null&&` ${e?.done} of ${t}`,i!=null&&i>0&&`, ${Qo(i)} left`]})]})}function rS({studio:n,id:e}){let t=n.results[e];if(!t||t.status==="running")return null;let s=(t.messages??[]).filter(c=>c.severity!=="note"),r=t.run?.warnings??[],o=new Set(s.map(c=>c.message)),a=r.filter(c=>![...o].some(u=>c.includes(u))),l=[...s,...a.map(c=>({severity:"warning",code:null,message:c,help:null}))];return t.status==="finished"&&l.length===0?null:t.status==="cancelled"?_("div",{class:"ended",children:[_(Bg,{studio:n,results:t}),_(Ph,{messages:l.filter(c=>c.severity==="warning")})]}):_("div",{class:"ended",children:[_(Bg,{studio:n,results:t,reason:s.length===0?t.message:null}),_(Ph,{messages:l})]})}function Bg({studio:n,results:e,reason:t}){let{id:i,status:s,incomplete:r,resumable:o}=e,a=rn(i);return _("div",{class:"ended-early",children:[_("p",{children:[a,": ",s,r&&` after ${ts(e)}`,t&&`, ${t}`]}),o&&_("button",{type:"button",disabled:!n.isConnected,"aria-label":`Continue ${a}`,title:"Solves the remaining positions with the params and settings of this run",onClick:()=>{n.continue(i)},children:"Continue"})]})}var md=4;function Vg({studio:n}){let e=[...n.runs].reverse(),t=Hg(n.runs);return _("section",{class:"panel","aria-labelledby":"runs-heading",children:[_("h2",{id:"runs-heading",children:"Runs"}),e.length===0&&_("p",{class:"muted",children:"No runs yet."}),_("ul",{class:"runs",children:e.map(i=>_(oS,{studio:n,run:i,differing:t},i.id))}),e.length>1&&_("p",{class:"muted small-text",children:"Check two or more runs to compare them."})]})}function oS({studio:n,run:e,differing:t}){let i=n.settings.selected.indexOf(e.id),s=rn(e.id);return _("li",{class:i>=0?"selected":"","data-run":e.id,children:[_("input",{type:"checkbox","aria-label":`Compare ${s}`,checked:i>=0,style:i>=0?{accentColor:Xr(i)}:void 0,onChange:()=>n.toggle(e.id)}),_("button",{type:"button",class:"run-name","aria-pressed":i>=0,title:e.directory,onClick:()=>n.select([e.id]),children:[_("span",{class:"run-title",children:[s,_("span",{class:`status ${e.status}`,children:aS(n,e)}),_("span",{class:"when",children:xl(e.started)})]}),_("span",{class:"differences",children:lS(e,t)})]})]})}function aS(n,e){if(e.status==="elsewhere")return"written by another process";let t=n.progress[e.id]?.seconds_left;return e.status==="running"&&t?`running, ${Qo(t)} left`:e.incomplete&&e.status!=="running"?`${e.status}, ${ts(e)}`:e.status}function Hg(n){return["params","settings"].flatMap(t=>{let i=n.filter(o=>o[t]!==null);return[...new Set(i.flatMap(o=>Object.keys(o[t]??{})))].filter(o=>new Set(i.map(a=>gd(a,{kind:t,name:o}))).size>1).map(o=>({kind:t,name:o}))})}function gd(n,{kind:e,name:t}){if(e==="settings"){let s=n.settings?.[t];return s===void 0?t==="vtu"?"no":"as in the model":yl(s)}let i=n.params?.[t];return i?Jp(i.text,i.unit):"default"}function Gg({kind:n,name:e}){return n==="settings"?vl(e):cn(e)}function lS(n,e){let t=n.params??{},i=[...Object.keys(t).filter(a=>t[a]?.at_default!==!0).map(a=>({kind:"params",name:a})),...Object.keys(n.settings??{}).map(a=>({kind:"settings",name:a}))],s=a=>e.some(({kind:l,name:c})=>l===a.kind&&c===a.name);i.sort((a,l)=>Number(s(l))-Number(s(a)));let r=i.slice(0,md).map(a=>`${Gg(a)} ${gd(n,a)}`),o=i.length>md?[`${i.length-md} more`]:[];return[...r,...o].join(", ")||(n.params?"defaults":"")}function Wg({studio:n}){let e=n.settings.selected.flatMap(i=>n.runs.filter(s=>s.id===i));if(e.length<2)return null;let t=Hg(e);return _("section",{class:"panel","aria-labelledby":"differences-heading",children:[_("h2",{id:"differences-heading",children:"Different params and settings"}),t.length===0&&_("p",{class:"muted",children:"These runs have the same params and settings."}),t.length>0&&_("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Table of different params and settings",children:_("table",{children:[_("thead",{children:_("tr",{children:[_("th",{scope:"col",children:"Param"}),e.map(i=>_("th",{scope:"col",children:rn(i.id)},i.id))]})}),_("tbody",{children:t.map(i=>_("tr",{children:[_("th",{scope:"row",children:Gg(i)}),e.map(s=>_("td",{children:gd(s,i)},s.id))]},`${i.kind}.${i.name}`))})]})})]})}var g0=0,Xd=1,_0=2;var Na=1,x0=2,Co=3,Ii=0,Bn=1,zn=2,Mr=0,Po=1,qd=2,$d=3,Yd=4,v0=5;var wr=100,y0=101,b0=102,S0=103,M0=104,w0=200,E0=201,T0=202,A0=203,Jd=204,Zd=205,R0=206,C0=207,P0=208,I0=209,L0=210,D0=211,N0=212,F0=213,U0=214,dc=0,fc=1,pc=2,_o=3,mc=4,gc=5,xo=6,_c=7,Kd=0,O0=1,k0=2,cs=0,jd=1,Qd=2,ef=3,tf=4,nf=5,sf=6,rf=7;var of=300,Er=301,Io=302,Hc=303,Gc=304,xc=1e3,os=1001,vc=1002,bn=1003,B0=1004;var Fa=1005;var kn=1006,Wc=1007;var Is=1008;var xi=1009,af=1010,lf=1011,Lo=1012,Xc=1013,Gi=1014,Wi=1015,Xi=1016,qc=1017,$c=1018,Tr=1020,cf=35902,uf=35899,hf=1021,df=1022,vi=1023,As=1026,Ls=1027,ff=1028,Yc=1029,ir=1030,Jc=1031;var Zc=1033,Ua=33776,Oa=33777,ka=33778,Ba=33779,Kc=35840,jc=35841,Qc=35842,eu=35843,tu=36196,nu=37492,iu=37496,su=37488,ru=37489,za=37490,ou=37491,au=37808,lu=37809,cu=37810,uu=37811,hu=37812,du=37813,fu=37814,pu=37815,mu=37816,gu=37817,_u=37818,xu=37819,vu=37820,yu=37821,bu=36492,Su=36494,Mu=36495,wu=36283,Eu=36284,Va=36285,Tu=36286;var ga=2300,yc=2301,uc=2302,Bd=2303,zd=2400,Vd=2401,Hd=2402;var z0=3200;var pf=0,V0=1,Ds="",Qn="srgb",_a="srgb-linear",xa="linear",Et="srgb";var hc=7680,Ha=7681;var mf=34055,gf=34056;var _f=517;var Au=519,H0=512,G0=513,W0=514,xf=515,X0=516,q0=517,vf=518,yf=519,$0=35044,bf=35048;var Sf="300 es",Ri=2e3,va=2001;function cS(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function uS(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ya(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Y0(){let n=ya("canvas");return n.style.display="block",n}var Xg={},vo=null;function Mf(...n){let e="THREE."+n.shift();vo?vo("log",e,...n):console.log(e,...n)}function J0(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function $e(...n){n=J0(n);let e="THREE."+n.shift();if(vo)vo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function Qe(...n){n=J0(n);let e="THREE."+n.shift();if(vo)vo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function ma(...n){let e=n.join(" ");e in Xg||(Xg[e]=!0,$e(...n))}function Z0(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var K0={[dc]:dc,[pc]:xo,[mc]:mc,[_o]:gc,[fc]:fc,[xo]:pc,[_c]:_c,[gc]:_o},as=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Wn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var _d=Math.PI/180,bc=180/Math.PI;function Ga(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Wn[n&255]+Wn[n>>8&255]+Wn[n>>16&255]+Wn[n>>24&255]+"-"+Wn[e&255]+Wn[e>>8&255]+"-"+Wn[e>>16&15|64]+Wn[e>>24&255]+"-"+Wn[t&63|128]+Wn[t>>8&255]+"-"+Wn[t>>16&255]+Wn[t>>24&255]+Wn[i&255]+Wn[i>>8&255]+Wn[i>>16&255]+Wn[i>>24&255]).toLowerCase()}function gt(n,e,t){return Math.max(e,Math.min(t,n))}function hS(n,e){return(n%e+e)%e}function xd(n,e,t){return(1-t)*n+t*e}function j0(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function wf(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function dS(n,e){if(e.constructor===Float32Array)return n;let t=wf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function fS(n,e){if(e.constructor===Float32Array)return n;let t=wf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var _t=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(gt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(gt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ci=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],g=r[o+2],v=r[o+3];if(h!==v||l!==d||c!==f||u!==g){let m=l*d+c*f+u*g+h*v;m<0&&(d=-d,f=-f,g=-g,v=-v,m=-m);let p=1-a;if(m<.9995){let y=Math.acos(m),A=Math.sin(y);p=Math.sin(p*y)/A,a=Math.sin(a*y)/A,l=l*p+d*a,c=c*p+f*a,u=u*p+g*a,h=h*p+v*a}else{l=l*p+d*a,c=c*p+f*a,u=u*p+g*a,h=h*p+v*a;let y=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=y,c*=y,u*=y,h*=y}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+u*h+l*f-c*d,e[t+1]=l*g+u*d+c*h-a*f,e[t+2]=c*g+u*f+a*d-l*h,e[t+3]=u*g-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h-d*f*g;break;case"YXZ":this._x=d*u*h+c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h+d*f*g;break;case"ZXY":this._x=d*u*h-c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h-d*f*g;break;case"ZYX":this._x=d*u*h-c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h+d*f*g;break;case"YZX":this._x=d*u*h+c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h-d*f*g;break;case"XZY":this._x=d*u*h-c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h+d*f*g;break;default:$e("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(gt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},X=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(qg.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(qg.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this.z=gt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this.z=gt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(gt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return vd.copy(this).projectOnVector(e),this.sub(vd)}reflect(e){return this.sub(vd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(gt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},vd=new X,qg=new Ci,et=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],g=i[8],v=s[0],m=s[3],p=s[6],y=s[1],A=s[4],S=s[7],C=s[2],R=s[5],x=s[8];return r[0]=o*v+a*y+l*C,r[3]=o*m+a*A+l*R,r[6]=o*p+a*S+l*x,r[1]=c*v+u*y+h*C,r[4]=c*m+u*A+h*R,r[7]=c*p+u*S+h*x,r[2]=d*v+f*y+g*C,r[5]=d*m+f*A+g*R,r[8]=d*p+f*S+g*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,g=t*h+i*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/g;return e[0]=h*v,e[1]=(s*c-u*i)*v,e[2]=(a*i-s*o)*v,e[3]=d*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=f*v,e[7]=(i*l-c*t)*v,e[8]=(o*t-i*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return ma("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(yd.makeScale(e,t)),this}rotate(e){return ma("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(yd.makeRotation(-e)),this}translate(e,t){return ma("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(yd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},yd=new et,$g=new et().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Yg=new et().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function pS(){let n={enabled:!0,workingColorSpace:_a,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Et&&(s.r=Ts(s.r),s.g=Ts(s.g),s.b=Ts(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Et&&(s.r=go(s.r),s.g=go(s.g),s.b=go(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ds?xa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[_a]:{primaries:e,whitePoint:i,transfer:xa,toXYZ:$g,fromXYZ:Yg,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Qn},outputColorSpaceConfig:{drawingBufferColorSpace:Qn}},[Qn]:{primaries:e,whitePoint:i,transfer:Et,toXYZ:$g,fromXYZ:Yg,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Qn}}}),n}var mt=pS();function Ts(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function go(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var no,Sc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{no===void 0&&(no=ya("canvas")),no.width=e.width,no.height=e.height;let s=no.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=no}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=ya("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ts(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Ts(t[i]/255)*255):t[i]=Ts(t[i]);return{data:t,width:e.width,height:e.height}}else return $e("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},mS=0,yo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:mS++}),this.uuid=Ga(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(bd(s[o].image)):r.push(bd(s[o]))}else r=bd(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function bd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Sc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:($e("Texture: Unable to serialize Texture."),{})}var gS=0,Sd=new X,si=class n extends as{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=os,s=os,r=kn,o=Is,a=vi,l=xi,c=n.DEFAULT_ANISOTROPY,u=Ds){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:gS++}),this.uuid=Ga(),this.name="",this.source=new yo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new _t(0,0),this.repeat=new _t(1,1),this.center=new _t(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new et,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Sd).x}get height(){return this.source.getSize(Sd).y}get depth(){return this.source.getSize(Sd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){$e(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==of)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case xc:e.x=e.x-Math.floor(e.x);break;case os:e.x=e.x<0?0:1;break;case vc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case xc:e.y=e.y-Math.floor(e.y);break;case os:e.y=e.y<0?0:1;break;case vc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};si.DEFAULT_IMAGE=null;si.DEFAULT_MAPPING=of;si.DEFAULT_ANISOTROPY=1;var $t=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],g=l[9],v=l[2],m=l[6],p=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-v)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+v)<.1&&Math.abs(g+m)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(c+1)/2,S=(f+1)/2,C=(p+1)/2,R=(u+d)/4,x=(h+v)/4,E=(g+m)/4;return A>S&&A>C?A<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(A),s=R/i,r=x/i):S>C?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=R/s,r=E/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=x/r,s=E/r),this.set(i,s,r,t),this}let y=Math.sqrt((m-g)*(m-g)+(h-v)*(h-v)+(d-u)*(d-u));return Math.abs(y)<.001&&(y=1),this.x=(m-g)/y,this.y=(h-v)/y,this.z=(d-u)/y,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this.z=gt(this.z,e.z,t.z),this.w=gt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this.z=gt(this.z,e,t),this.w=gt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(gt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Mc=class extends as{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:kn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new $t(0,0,e,t),this.scissorTest=!1,this.viewport=new $t(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new si({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:kn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new yo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},mi=class extends Mc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},ba=class extends si{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=bn,this.minFilter=bn,this.wrapR=os,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var wc=class extends si{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=bn,this.minFilter=bn,this.wrapR=os,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var vt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,d,f,g,v,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,d,f,g,v,m)}set(e,t,i,s,r,o,a,l,c,u,h,d,f,g,v,m){let p=this.elements;return p[0]=e,p[4]=t,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=d,p[3]=f,p[7]=g,p[11]=v,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/io.setFromMatrixColumn(e,0).length(),r=1/io.setFromMatrixColumn(e,1).length(),o=1/io.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,f=o*h,g=a*u,v=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+g*c,t[5]=d-v*c,t[9]=-a*l,t[2]=v-d*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,g=c*u,v=c*h;t[0]=d+v*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-g,t[6]=v+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,g=c*u,v=c*h;t[0]=d-v*a,t[4]=-o*h,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*u,t[9]=v-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,g=a*u,v=a*h;t[0]=l*u,t[4]=g*c-f,t[8]=d*c+v,t[1]=l*h,t[5]=v*c+d,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,g=a*l,v=a*c;t[0]=l*u,t[4]=v-d*h,t[8]=g*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+g,t[10]=d-v*h}else if(e.order==="XZY"){let d=o*l,f=o*c,g=a*l,v=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+v,t[5]=o*u,t[9]=f*h-g,t[2]=g*h-f,t[6]=a*u,t[10]=v*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(_S,e,xS)}lookAt(e,t,i){let s=this.elements;return fi.subVectors(e,t),fi.lengthSq()===0&&(fi.z=1),fi.normalize(),Xs.crossVectors(i,fi),Xs.lengthSq()===0&&(Math.abs(i.z)===1?fi.x+=1e-4:fi.z+=1e-4,fi.normalize(),Xs.crossVectors(i,fi)),Xs.normalize(),Hl.crossVectors(fi,Xs),s[0]=Xs.x,s[4]=Hl.x,s[8]=fi.x,s[1]=Xs.y,s[5]=Hl.y,s[9]=fi.y,s[2]=Xs.z,s[6]=Hl.z,s[10]=fi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],g=i[2],v=i[6],m=i[10],p=i[14],y=i[3],A=i[7],S=i[11],C=i[15],R=s[0],x=s[4],E=s[8],U=s[12],D=s[1],L=s[5],k=s[9],z=s[13],N=s[2],G=s[6],$=s[10],H=s[14],le=s[3],Z=s[7],Q=s[11],ie=s[15];return r[0]=o*R+a*D+l*N+c*le,r[4]=o*x+a*L+l*G+c*Z,r[8]=o*E+a*k+l*$+c*Q,r[12]=o*U+a*z+l*H+c*ie,r[1]=u*R+h*D+d*N+f*le,r[5]=u*x+h*L+d*G+f*Z,r[9]=u*E+h*k+d*$+f*Q,r[13]=u*U+h*z+d*H+f*ie,r[2]=g*R+v*D+m*N+p*le,r[6]=g*x+v*L+m*G+p*Z,r[10]=g*E+v*k+m*$+p*Q,r[14]=g*U+v*z+m*H+p*ie,r[3]=y*R+A*D+S*N+C*le,r[7]=y*x+A*L+S*G+C*Z,r[11]=y*E+A*k+S*$+C*Q,r[15]=y*U+A*z+S*H+C*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],g=e[3],v=e[7],m=e[11],p=e[15],y=l*f-c*d,A=a*f-c*h,S=a*d-l*h,C=o*f-c*u,R=o*d-l*u,x=o*h-a*u;return t*(v*y-m*A+p*S)-i*(g*y-m*C+p*R)+s*(g*A-v*C+p*x)-r*(g*S-v*R+m*x)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],g=e[12],v=e[13],m=e[14],p=e[15],y=t*a-i*o,A=t*l-s*o,S=t*c-r*o,C=i*l-s*a,R=i*c-r*a,x=s*c-r*l,E=u*v-h*g,U=u*m-d*g,D=u*p-f*g,L=h*m-d*v,k=h*p-f*v,z=d*p-f*m,N=y*z-A*k+S*L+C*D-R*U+x*E;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/N;return e[0]=(a*z-l*k+c*L)*G,e[1]=(s*k-i*z-r*L)*G,e[2]=(v*x-m*R+p*C)*G,e[3]=(d*R-h*x-f*C)*G,e[4]=(l*D-o*z-c*U)*G,e[5]=(t*z-s*D+r*U)*G,e[6]=(m*S-g*x-p*A)*G,e[7]=(u*x-d*S+f*A)*G,e[8]=(o*k-a*D+c*E)*G,e[9]=(i*D-t*k-r*E)*G,e[10]=(g*R-v*S+p*y)*G,e[11]=(h*S-u*R-f*y)*G,e[12]=(a*U-o*L-l*E)*G,e[13]=(t*L-i*U+s*E)*G,e[14]=(v*A-g*C-m*y)*G,e[15]=(u*C-h*A+d*y)*G,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,g=r*h,v=o*u,m=o*h,p=a*h,y=l*c,A=l*u,S=l*h,C=i.x,R=i.y,x=i.z;return s[0]=(1-(v+p))*C,s[1]=(f+S)*C,s[2]=(g-A)*C,s[3]=0,s[4]=(f-S)*R,s[5]=(1-(d+p))*R,s[6]=(m+y)*R,s[7]=0,s[8]=(g+A)*x,s[9]=(m-y)*x,s[10]=(1-(d+v))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=io.set(s[0],s[1],s[2]).length(),a=io.set(s[4],s[5],s[6]).length(),l=io.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Bi.copy(this);let c=1/o,u=1/a,h=1/l;return Bi.elements[0]*=c,Bi.elements[1]*=c,Bi.elements[2]*=c,Bi.elements[4]*=u,Bi.elements[5]*=u,Bi.elements[6]*=u,Bi.elements[8]*=h,Bi.elements[9]*=h,Bi.elements[10]*=h,t.setFromRotationMatrix(Bi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Ri,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),d=(t+e)/(t-e),f=(i+s)/(i-s),g,v;if(l)g=r/(o-r),v=o*r/(o-r);else if(a===Ri)g=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===va)g=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ri,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),d=-(t+e)/(t-e),f=-(i+s)/(i-s),g,v;if(l)g=1/(o-r),v=o/(o-r);else if(a===Ri)g=-2/(o-r),v=-(o+r)/(o-r);else if(a===va)g=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},io=new X,Bi=new vt,_S=new X(0,0,0),xS=new X(1,1,1),Xs=new X,Hl=new X,fi=new X,Jg=new vt,Zg=new Ci,Ks=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(gt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-gt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(gt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-gt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(gt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-gt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:$e("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Jg.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Jg,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Zg.setFromEuler(this),this.setFromQuaternion(Zg,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ks.DEFAULT_ORDER="XYZ";var Sa=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},vS=0,Kg=new X,so=new Ci,bs=new vt,Gl=new X,ua=new X,yS=new X,bS=new Ci,jg=new X(1,0,0),Qg=new X(0,1,0),e0=new X(0,0,1),t0={type:"added"},SS={type:"removed"},ro={type:"childadded",child:null},Md={type:"childremoved",child:null},gi=class n extends as{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:vS++}),this.uuid=Ga(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new X,t=new Ks,i=new Ci,s=new X(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new vt},normalMatrix:{value:new et}}),this.matrix=new vt,this.matrixWorld=new vt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Sa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return so.setFromAxisAngle(e,t),this.quaternion.multiply(so),this}rotateOnWorldAxis(e,t){return so.setFromAxisAngle(e,t),this.quaternion.premultiply(so),this}rotateX(e){return this.rotateOnAxis(jg,e)}rotateY(e){return this.rotateOnAxis(Qg,e)}rotateZ(e){return this.rotateOnAxis(e0,e)}translateOnAxis(e,t){return Kg.copy(e).applyQuaternion(this.quaternion),this.position.add(Kg.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(jg,e)}translateY(e){return this.translateOnAxis(Qg,e)}translateZ(e){return this.translateOnAxis(e0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(bs.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Gl.copy(e):Gl.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ua.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?bs.lookAt(ua,Gl,this.up):bs.lookAt(Gl,ua,this.up),this.quaternion.setFromRotationMatrix(bs),s&&(bs.extractRotation(s.matrixWorld),so.setFromRotationMatrix(bs),this.quaternion.premultiply(so.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Qe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(t0),ro.child=e,this.dispatchEvent(ro),ro.child=null):Qe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(SS),Md.child=e,this.dispatchEvent(Md),Md.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),bs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),bs.multiply(e.parent.matrixWorld)),e.applyMatrix4(bs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(t0),ro.child=e,this.dispatchEvent(ro),ro.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ua,e,yS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ua,bS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};gi.DEFAULT_UP=new X(0,1,0);gi.DEFAULT_MATRIX_AUTO_UPDATE=!0;gi.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var un=class extends gi{constructor(){super(),this.isGroup=!0,this.type="Group"}},MS={type:"move"},bo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new un,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new un,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new un,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let m=t.getJointPose(v,i),p=this._getHandJoint(c,v);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(MS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new un;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Q0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},qs={h:0,s:0,l:0},Wl={h:0,s:0,l:0};function wd(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var rt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Qn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,mt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=mt.workingColorSpace){return this.r=e,this.g=t,this.b=i,mt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=mt.workingColorSpace){if(e=hS(e,1),t=gt(t,0,1),i=gt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=wd(o,r,e+1/3),this.g=wd(o,r,e),this.b=wd(o,r,e-1/3)}return mt.colorSpaceToWorking(this,s),this}setStyle(e,t=Qn){function i(r){r!==void 0&&parseFloat(r)<1&&$e("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:$e("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);$e("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Qn){let i=Q0[e.toLowerCase()];return i!==void 0?this.setHex(i,t):$e("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ts(e.r),this.g=Ts(e.g),this.b=Ts(e.b),this}copyLinearToSRGB(e){return this.r=go(e.r),this.g=go(e.g),this.b=go(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Qn){return mt.workingToColorSpace(Xn.copy(this),e),Math.round(gt(Xn.r*255,0,255))*65536+Math.round(gt(Xn.g*255,0,255))*256+Math.round(gt(Xn.b*255,0,255))}getHexString(e=Qn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=mt.workingColorSpace){mt.workingToColorSpace(Xn.copy(this),t);let i=Xn.r,s=Xn.g,r=Xn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=mt.workingColorSpace){return mt.workingToColorSpace(Xn.copy(this),t),e.r=Xn.r,e.g=Xn.g,e.b=Xn.b,e}getStyle(e=Qn){mt.workingToColorSpace(Xn.copy(this),e);let t=Xn.r,i=Xn.g,s=Xn.b;return e!==Qn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(qs),this.setHSL(qs.h+e,qs.s+t,qs.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(qs),e.getHSL(Wl);let i=xd(qs.h,Wl.h,t),s=xd(qs.s,Wl.s,t),r=xd(qs.l,Wl.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Xn=new rt;rt.NAMES=Q0;var Ma=class extends gi{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ks,this.environmentIntensity=1,this.environmentRotation=new Ks,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},zi=new X,Ss=new X,Ed=new X,Ms=new X,oo=new X,ao=new X,n0=new X,Td=new X,Ad=new X,Rd=new X,Cd=new $t,Pd=new $t,Id=new $t,Zs=class n{constructor(e=new X,t=new X,i=new X){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),zi.subVectors(e,t),s.cross(zi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){zi.subVectors(s,t),Ss.subVectors(i,t),Ed.subVectors(e,t);let o=zi.dot(zi),a=zi.dot(Ss),l=zi.dot(Ed),c=Ss.dot(Ss),u=Ss.dot(Ed),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,g=(o*u-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Ms)===null?!1:Ms.x>=0&&Ms.y>=0&&Ms.x+Ms.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Ms)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ms.x),l.addScaledVector(o,Ms.y),l.addScaledVector(a,Ms.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Cd.setScalar(0),Pd.setScalar(0),Id.setScalar(0),Cd.fromBufferAttribute(e,t),Pd.fromBufferAttribute(e,i),Id.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Cd,r.x),o.addScaledVector(Pd,r.y),o.addScaledVector(Id,r.z),o}static isFrontFacing(e,t,i,s){return zi.subVectors(i,t),Ss.subVectors(e,t),zi.cross(Ss).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return zi.subVectors(this.c,this.b),Ss.subVectors(this.a,this.b),zi.cross(Ss).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;oo.subVectors(s,i),ao.subVectors(r,i),Td.subVectors(e,i);let l=oo.dot(Td),c=ao.dot(Td);if(l<=0&&c<=0)return t.copy(i);Ad.subVectors(e,s);let u=oo.dot(Ad),h=ao.dot(Ad);if(u>=0&&h<=u)return t.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(oo,o);Rd.subVectors(e,r);let f=oo.dot(Rd),g=ao.dot(Rd);if(g>=0&&f<=g)return t.copy(r);let v=f*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(i).addScaledVector(ao,a);let m=u*g-f*h;if(m<=0&&h-u>=0&&f-g>=0)return n0.subVectors(r,s),a=(h-u)/(h-u+(f-g)),t.copy(s).addScaledVector(n0,a);let p=1/(m+v+d);return o=v*p,a=d*p,t.copy(i).addScaledVector(oo,o).addScaledVector(ao,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ri=class{constructor(e=new X(1/0,1/0,1/0),t=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Vi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Vi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Vi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Vi):Vi.fromBufferAttribute(r,o),Vi.applyMatrix4(e.matrixWorld),this.expandByPoint(Vi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Xl.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Xl.copy(i.boundingBox)),Xl.applyMatrix4(e.matrixWorld),this.union(Xl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Vi),Vi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ha),ql.subVectors(this.max,ha),lo.subVectors(e.a,ha),co.subVectors(e.b,ha),uo.subVectors(e.c,ha),$s.subVectors(co,lo),Ys.subVectors(uo,co),gr.subVectors(lo,uo);let t=[0,-$s.z,$s.y,0,-Ys.z,Ys.y,0,-gr.z,gr.y,$s.z,0,-$s.x,Ys.z,0,-Ys.x,gr.z,0,-gr.x,-$s.y,$s.x,0,-Ys.y,Ys.x,0,-gr.y,gr.x,0];return!Ld(t,lo,co,uo,ql)||(t=[1,0,0,0,1,0,0,0,1],!Ld(t,lo,co,uo,ql))?!1:($l.crossVectors($s,Ys),t=[$l.x,$l.y,$l.z],Ld(t,lo,co,uo,ql))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Vi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Vi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ws[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ws[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ws[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ws[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ws[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ws[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ws[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ws[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ws),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ws=[new X,new X,new X,new X,new X,new X,new X,new X],Vi=new X,Xl=new ri,lo=new X,co=new X,uo=new X,$s=new X,Ys=new X,gr=new X,ha=new X,ql=new X,$l=new X,_r=new X;function Ld(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){_r.fromArray(n,r);let a=s.x*Math.abs(_r.x)+s.y*Math.abs(_r.y)+s.z*Math.abs(_r.z),l=e.dot(_r),c=t.dot(_r),u=i.dot(_r);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var yn=new X,Yl=new _t,wS=0,Zt=class extends as{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:wS++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=$0,this.updateRanges=[],this.gpuType=Wi,this.version=0,this._normalizationScale=e!==void 0?wf(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Yl.fromBufferAttribute(this,t),Yl.applyMatrix3(e),this.setXY(t,Yl.x,Yl.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)yn.fromBufferAttribute(this,t),yn.applyMatrix3(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)yn.fromBufferAttribute(this,t),yn.applyMatrix4(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)yn.fromBufferAttribute(this,t),yn.applyNormalMatrix(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)yn.fromBufferAttribute(this,t),yn.transformDirection(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):dS(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):fS(e,this.array)}};var wa=class extends Zt{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Ea=class extends Zt{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var zt=class extends Zt{constructor(e,t,i){super(new Float32Array(e),t,i)}},ES=new ri,da=new X,Dd=new X,ti=class{constructor(e=new X,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):ES.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;da.subVectors(e,this.center);let t=da.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(da,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Dd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(da.copy(e.center).add(Dd)),this.expandByPoint(da.copy(e.center).sub(Dd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},TS=0,Ai=new vt,Nd=new gi,ho=new X,pi=new ri,fa=new ri,Nn=new X,Fn=class n extends as{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:TS++}),this.uuid=Ga(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(cS(e)?Ea:wa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new et().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ai.makeRotationFromQuaternion(e),this.applyMatrix4(Ai),this}rotateX(e){return Ai.makeRotationX(e),this.applyMatrix4(Ai),this}rotateY(e){return Ai.makeRotationY(e),this.applyMatrix4(Ai),this}rotateZ(e){return Ai.makeRotationZ(e),this.applyMatrix4(Ai),this}translate(e,t,i){return Ai.makeTranslation(e,t,i),this.applyMatrix4(Ai),this}scale(e,t,i){return Ai.makeScale(e,t,i),this.applyMatrix4(Ai),this}lookAt(e){return Nd.lookAt(e),Nd.updateMatrix(),this.applyMatrix4(Nd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ho).negate(),this.translate(ho.x,ho.y,ho.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new zt(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&$e("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ri);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];pi.setFromBufferAttribute(r),this.morphTargetsRelative?(Nn.addVectors(this.boundingBox.min,pi.min),this.boundingBox.expandByPoint(Nn),Nn.addVectors(this.boundingBox.max,pi.max),this.boundingBox.expandByPoint(Nn)):(this.boundingBox.expandByPoint(pi.min),this.boundingBox.expandByPoint(pi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ti);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(e){let i=this.boundingSphere.center;if(pi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];fa.setFromBufferAttribute(a),this.morphTargetsRelative?(Nn.addVectors(pi.min,fa.min),pi.expandByPoint(Nn),Nn.addVectors(pi.max,fa.max),pi.expandByPoint(Nn)):(pi.expandByPoint(fa.min),pi.expandByPoint(fa.max))}pi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Nn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Nn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Nn.fromBufferAttribute(a,c),l&&(ho.fromBufferAttribute(e,c),Nn.add(ho)),s=Math.max(s,i.distanceToSquared(Nn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Qe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Zt(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new X,l[U]=new X;let u=new X,h=new X,d=new X,f=new _t,g=new _t,v=new _t,m=new X,p=new X;function y(U,D,L){c[U]=c[D]=c[L]=1,u.fromBufferAttribute(i,U),h.fromBufferAttribute(i,D),d.fromBufferAttribute(i,L),f.fromBufferAttribute(r,U),g.fromBufferAttribute(r,D),v.fromBufferAttribute(r,L),h.sub(u),d.sub(u),g.sub(f),v.sub(f);let k=1/(g.x*v.y-v.x*g.y);isFinite(k)&&(m.copy(h).multiplyScalar(v.y).addScaledVector(d,-g.y).multiplyScalar(k),p.copy(d).multiplyScalar(g.x).addScaledVector(h,-v.x).multiplyScalar(k),a[U].add(m),a[D].add(m),a[L].add(m),l[U].add(p),l[D].add(p),l[L].add(p))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let U=0,D=A.length;U<D;++U){let L=A[U],k=L.start,z=L.count;for(let N=k,G=k+z;N<G;N+=3)y(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let S=new X,C=new X,R=new X,x=new X;function E(U){R.fromBufferAttribute(s,U),x.copy(R);let D=a[U];S.copy(D),S.sub(R.multiplyScalar(R.dot(D))).normalize(),C.crossVectors(x,D);let k=C.dot(l[U])<0?-1:1;o.setXYZW(U,S.x,S.y,S.z,k)}for(let U=0,D=i.count;U<D;++U)c[U]&&E(U);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Zt(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new X,r=new X,o=new X,a=new X,l=new X,c=new X,u=new X,h=new X;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),v=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Nn.fromBufferAttribute(e,t),Nn.normalize(),e.setXYZ(t,Nn.x,Nn.y,Nn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,g=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?f=l[v]*a.data.stride+a.offset:f=l[v]*u;for(let p=0;p<u;p++)d[g++]=c[f++]}return new Zt(d,u,h)}if(this.index===null)return $e("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Fd=new X,AS=new X,RS=new et,Hi=class{constructor(e=new X(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Fd.subVectors(i,t).cross(AS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Fd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||RS.getNormalMatrix(e),s=this.coplanarPoint(Fd).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},CS=0,js=class extends as{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:CS++}),this.uuid=Ga(),this.name="",this.type="Material",this.blending=Po,this.side=Ii,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Jd,this.blendDst=Zd,this.blendEquation=wr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new rt(0,0,0),this.blendAlpha=0,this.depthFunc=_o,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Au,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=hc,this.stencilZFail=hc,this.stencilZPass=hc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){$e(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new rt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Hi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new _t().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new _t().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Es=new X,Ud=new X,Jl=new X,Zl=new X,ls=class{constructor(e=new X,t=new X(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Es)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Es.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Es.copy(this.origin).addScaledVector(this.direction,t),Es.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Ud.copy(e).add(t).multiplyScalar(.5),Jl.copy(t).sub(e).normalize(),Zl.copy(this.origin).sub(Ud);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Jl),a=Zl.dot(this.direction),l=-Zl.dot(Jl),c=Zl.lengthSq(),u=Math.abs(1-o*o),h,d,f,g;if(u>0)if(h=o*l-a,d=o*a-l,g=r*u,h>=0)if(d>=-g)if(d<=g){let v=1/u;h*=v,d*=v,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-g?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=g?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Ud).addScaledVector(Jl,d),f}intersectSphere(e,t){if(e.radius<0)return null;Es.subVectors(e.center,this.origin);let i=Es.dot(this.direction),s=Es.dot(Es)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Es)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,f=e.z-o.z,g=t.x-o.x,v=t.y-o.y,m=t.z-o.z,p=i.x-o.x,y=i.y-o.y,A=i.z-o.z,S=Math.abs(l),C=Math.abs(c),R=Math.abs(u),x,E,U,D,L,k,z,N,G,$,H,le;if(S>=C&&S>=R?(U=l,k=h,G=g,le=p,l>=0?(x=c,E=u,D=d,L=f,z=v,N=m,$=y,H=A):(x=u,E=c,D=f,L=d,z=m,N=v,$=A,H=y)):C>=R?(U=c,k=d,G=v,le=y,c>=0?(x=u,E=l,D=f,L=h,z=m,N=g,$=A,H=p):(x=l,E=u,D=h,L=f,z=g,N=m,$=p,H=A)):(U=u,k=f,G=m,le=A,u>=0?(x=l,E=c,D=h,L=d,z=g,N=v,$=p,H=y):(x=c,E=l,D=d,L=h,z=v,N=g,$=y,H=p)),U===0)return null;let Z=x/U,Q=E/U,ie=1/U,de=D-Z*k,he=L-Q*k,ee=z-Z*G,me=N-Q*G,ge=$-Z*le,Me=H-Q*le,ve=ge*me-Me*ee,He=de*Me-he*ge,Je=ee*he-me*de;if(s){if(ve<0||He<0||Je<0)return null}else if((ve<0||He<0||Je<0)&&(ve>0||He>0||Je>0))return null;let Oe=ve+He+Je;if(Oe===0)return null;let ct=ie*(ve*k+He*G+Je*le);return(Oe>0?ct<0:ct>0)?null:this.at(ct/Oe,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Qs=class extends js{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new rt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ks,this.combine=Kd,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},i0=new vt,xr=new ls,Kl=new ti,s0=new X,jl=new X,Ql=new X,ec=new X,Od=new X,tc=new X,r0=new X,nc=new X,Nt=class extends gi{constructor(e=new Fn,t=new Qs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){tc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Od.fromBufferAttribute(h,e),o?tc.addScaledVector(Od,u):tc.addScaledVector(Od.sub(t),u))}t.add(tc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Kl.copy(i.boundingSphere),Kl.applyMatrix4(r),xr.copy(e.ray).recast(e.near),!(Kl.containsPoint(xr.origin)===!1&&(xr.intersectSphere(Kl,s0)===null||xr.origin.distanceToSquared(s0)>(e.far-e.near)**2))&&(i0.copy(r).invert(),xr.copy(e.ray).applyMatrix4(i0),!(i.boundingBox!==null&&xr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,xr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=d.length;g<v;g++){let m=d[g],p=o[m.materialIndex],y=Math.max(m.start,f.start),A=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let S=y,C=A;S<C;S+=3){let R=a.getX(S),x=a.getX(S+1),E=a.getX(S+2);s=ic(this,p,e,i,c,u,h,R,x,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let m=g,p=v;m<p;m+=3){let y=a.getX(m),A=a.getX(m+1),S=a.getX(m+2);s=ic(this,o,e,i,c,u,h,y,A,S),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=d.length;g<v;g++){let m=d[g],p=o[m.materialIndex],y=Math.max(m.start,f.start),A=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let S=y,C=A;S<C;S+=3){let R=S,x=S+1,E=S+2;s=ic(this,p,e,i,c,u,h,R,x,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let m=g,p=v;m<p;m+=3){let y=m,A=m+1,S=m+2;s=ic(this,o,e,i,c,u,h,y,A,S),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function PS(n,e,t,i,s,r,o,a){let l;if(e.side===Bn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Ii,a),l===null)return null;nc.copy(a),nc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(nc);return c<t.near||c>t.far?null:{distance:c,point:nc.clone(),object:n}}function ic(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,jl),n.getVertexPosition(l,Ql),n.getVertexPosition(c,ec);let u=PS(n,e,t,i,jl,Ql,ec,r0);if(u){let h=new X;Zs.getBarycoord(r0,jl,Ql,ec,h),s&&(u.uv=Zs.getInterpolatedAttribute(s,a,l,c,h,new _t)),r&&(u.uv1=Zs.getInterpolatedAttribute(r,a,l,c,h,new _t)),o&&(u.normal=Zs.getInterpolatedAttribute(o,a,l,c,h,new X),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new X,materialIndex:0};Zs.getNormal(jl,Ql,ec,d.normal),u.face=d,u.barycoord=h}return u}var So=class extends si{constructor(e=null,t=1,i=1,s,r,o,a,l,c=bn,u=bn,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var yr=class extends Zt{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var vr=new ti,IS=new _t(.5,.5),sc=new X,Rs=class{constructor(e=new Hi,t=new Hi,i=new Hi,s=new Hi,r=new Hi,o=new Hi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ri,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],g=r[8],v=r[9],m=r[10],p=r[11],y=r[12],A=r[13],S=r[14],C=r[15];if(s[0].setComponents(c-o,f-u,p-g,C-y).normalize(),s[1].setComponents(c+o,f+u,p+g,C+y).normalize(),s[2].setComponents(c+a,f+h,p+v,C+A).normalize(),s[3].setComponents(c-a,f-h,p-v,C-A).normalize(),i)s[4].setComponents(l,d,m,S).normalize(),s[5].setComponents(c-l,f-d,p-m,C-S).normalize();else if(s[4].setComponents(c-l,f-d,p-m,C-S).normalize(),t===Ri)s[5].setComponents(c+l,f+d,p+m,C+S).normalize();else if(t===va)s[5].setComponents(l,d,m,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),vr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),vr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(vr)}intersectsSprite(e){vr.center.set(0,0,0);let t=IS.distanceTo(e.center);return vr.radius=.7071067811865476+t,vr.applyMatrix4(e.matrixWorld),this.intersectsSphere(vr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(sc.x=s.normal.x>0?e.max.x:e.min.x,sc.y=s.normal.y>0?e.max.y:e.min.y,sc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(sc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},o0=new vt,Ec=class n{constructor(){this.coordinateSystem=Ri,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];o0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Rs),i[s].setFromProjectionMatrix(o0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Rs),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Mo=class extends js{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new rt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Tc=new X,Ac=new X,a0=new vt,pa=new ls,rc=new ti,kd=new X,l0=new X,Ta=class extends gi{constructor(e=new Fn,t=new Mo){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Tc.fromBufferAttribute(t,s-1),Ac.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Tc.distanceTo(Ac);e.setAttribute("lineDistance",new zt(i,1))}else $e("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),rc.copy(i.boundingSphere),rc.applyMatrix4(s),rc.radius+=r,e.ray.intersectsSphere(rc)===!1)return;a0.copy(s).invert(),pa.copy(e.ray).applyMatrix4(a0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let v=f,m=g-1;v<m;v+=c){let p=u.getX(v),y=u.getX(v+1),A=oc(this,e,pa,l,p,y,v);A&&t.push(A)}if(this.isLineLoop){let v=u.getX(g-1),m=u.getX(f),p=oc(this,e,pa,l,v,m,g-1);p&&t.push(p)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let v=f,m=g-1;v<m;v+=c){let p=oc(this,e,pa,l,v,v+1,v);p&&t.push(p)}if(this.isLineLoop){let v=oc(this,e,pa,l,g-1,f,g-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function oc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Tc.fromBufferAttribute(a,s),Ac.fromBufferAttribute(a,r),t.distanceSqToSegment(Tc,Ac,kd,l0)>i)return;kd.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(kd);if(!(c<e.near||c>e.far))return{distance:c,point:l0.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var c0=new X,u0=new X,wo=class extends Ta{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)c0.fromBufferAttribute(t,s),u0.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+c0.distanceTo(u0);e.setAttribute("lineDistance",new zt(i,1))}else $e("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},Aa=class extends Ta{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}};var Ra=class extends si{constructor(e=[],t=Er,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Cs=class extends si{constructor(e,t,i=Gi,s,r,o,a=bn,l=bn,c,u=As,h=1){if(u!==As&&u!==Ls)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new yo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ca=class extends Cs{constructor(e,t=Gi,i=Er,s,r,o=bn,a=bn,l,c=As){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Pa=class extends si{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Eo=class n extends Fn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;g("z","y","x",-1,-1,i,t,e,o,r,0),g("z","y","x",1,-1,i,t,-e,o,r,1),g("x","z","y",1,1,e,i,t,s,o,2),g("x","z","y",1,-1,e,i,-t,s,o,3),g("x","y","z",1,-1,e,t,i,s,r,4),g("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new zt(c,3)),this.setAttribute("normal",new zt(u,3)),this.setAttribute("uv",new zt(h,2));function g(v,m,p,y,A,S,C,R,x,E,U){let D=S/x,L=C/E,k=S/2,z=C/2,N=R/2,G=x+1,$=E+1,H=0,le=0,Z=new X;for(let Q=0;Q<$;Q++){let ie=Q*L-z;for(let de=0;de<G;de++){let he=de*D-k;Z[v]=he*y,Z[m]=ie*A,Z[p]=N,c.push(Z.x,Z.y,Z.z),Z[v]=0,Z[m]=0,Z[p]=R>0?1:-1,u.push(Z.x,Z.y,Z.z),h.push(de/x),h.push(1-Q/E),H+=1}}for(let Q=0;Q<E;Q++)for(let ie=0;ie<x;ie++){let de=d+ie+G*Q,he=d+ie+G*(Q+1),ee=d+(ie+1)+G*(Q+1),me=d+(ie+1)+G*Q;l.push(de,he,me),l.push(he,ee,me),le+=6}a.addGroup(f,le,U),f+=le,d+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var To=class n extends Fn{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],g=0,v=[],m=i/2,p=0;y(),o===!1&&(e>0&&A(!0),t>0&&A(!1)),this.setIndex(u),this.setAttribute("position",new zt(h,3)),this.setAttribute("normal",new zt(d,3)),this.setAttribute("uv",new zt(f,2));function y(){let S=new X,C=new X,R=0,x=(t-e)/i;for(let E=0;E<=r;E++){let U=[],D=E/r,L=D*(t-e)+e;for(let k=0;k<=s;k++){let z=k/s,N=z*l+a,G=Math.sin(N),$=Math.cos(N);C.x=L*G,C.y=-D*i+m,C.z=L*$,h.push(C.x,C.y,C.z),S.set(G,x,$).normalize(),d.push(S.x,S.y,S.z),f.push(z,1-D),U.push(g++)}v.push(U)}for(let E=0;E<s;E++)for(let U=0;U<r;U++){let D=v[U][E],L=v[U+1][E],k=v[U+1][E+1],z=v[U][E+1];(e>0||U!==0)&&(u.push(D,L,z),R+=3),(t>0||U!==r-1)&&(u.push(L,k,z),R+=3)}c.addGroup(p,R,0),p+=R}function A(S){let C=g,R=new _t,x=new X,E=0,U=S===!0?e:t,D=S===!0?1:-1;for(let k=1;k<=s;k++)h.push(0,m*D,0),d.push(0,D,0),f.push(.5,.5),g++;let L=g;for(let k=0;k<=s;k++){let N=k/s*l+a,G=Math.cos(N),$=Math.sin(N);x.x=U*$,x.y=m*D,x.z=U*G,h.push(x.x,x.y,x.z),d.push(0,D,0),R.x=G*.5+.5,R.y=$*.5*D+.5,f.push(R.x,R.y),g++}for(let k=0;k<s;k++){let z=C+k,N=L+k;S===!0?u.push(N,N+1,z):u.push(N+1,N,z),E+=3}c.addGroup(p,E,S===!0?1:2),p+=E}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},br=class n extends To{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Sr=class n extends Fn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,f=[],g=[],v=[],m=[];for(let p=0;p<u;p++){let y=p*d-o;for(let A=0;A<c;A++){let S=A*h-r;g.push(S,-y,0),v.push(0,0,1),m.push(A/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let y=0;y<a;y++){let A=y+c*p,S=y+c*(p+1),C=y+1+c*(p+1),R=y+1+c*p;f.push(A,S,R),f.push(S,C,R)}this.setIndex(f),this.setAttribute("position",new zt(g,3)),this.setAttribute("normal",new zt(v,3)),this.setAttribute("uv",new zt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Ia=class n extends Fn{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new X,d=new X,f=[],g=[],v=[],m=[];for(let p=0;p<=i;p++){let y=[],A=p/i,S=o+A*a,C=e*Math.cos(S),R=Math.sqrt(e*e-C*C),x=0;p===0&&o===0?x=.5/t:p===i&&l===Math.PI&&(x=-.5/t);for(let E=0;E<=t;E++){let U=E/t,D=s+U*r;h.x=-R*Math.cos(D),h.y=C,h.z=R*Math.sin(D),g.push(h.x,h.y,h.z),d.copy(h).normalize(),v.push(d.x,d.y,d.z),m.push(U+x,1-A),y.push(c++)}u.push(y)}for(let p=0;p<i;p++)for(let y=0;y<t;y++){let A=u[p][y+1],S=u[p][y],C=u[p+1][y],R=u[p+1][y+1];(p!==0||o>0)&&f.push(A,S,R),(p!==i-1||l<Math.PI)&&f.push(S,C,R)}this.setIndex(f),this.setAttribute("position",new zt(g,3)),this.setAttribute("normal",new zt(v,3)),this.setAttribute("uv",new zt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Ar(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(h0(s))s.isRenderTargetTexture?($e("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(h0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function qn(n){let e={};for(let t=0;t<n.length;t++){let i=Ar(n[t]);for(let s in i)e[s]=i[s]}return e}function h0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function LS(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Ef(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:mt.workingColorSpace}var e_={clone:Ar,merge:qn},DS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,NS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Pi=class extends js{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=DS,this.fragmentShader=NS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Ar(e.uniforms),this.uniformsGroups=LS(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new rt().setHex(s.value);break;case"v2":this.uniforms[i].value=new _t().fromArray(s.value);break;case"v3":this.uniforms[i].value=new X().fromArray(s.value);break;case"v4":this.uniforms[i].value=new $t().fromArray(s.value);break;case"m3":this.uniforms[i].value=new et().fromArray(s.value);break;case"m4":this.uniforms[i].value=new vt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Rc=class extends Pi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Cc=class extends js{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=z0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Pc=class extends js{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function fo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function ac(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var er=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ic=class extends er{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:zd,endingEnd:zd}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Vd:r=e,a=2*t-i;break;case Hd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Vd:o=e,l=2*i-t;break;case Hd:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(i-t)/(s-t),v=g*g,m=v*g,p=-d*m+2*d*v-d*g,y=(1+d)*m+(-1.5-2*d)*v+(-.5+d)*g+1,A=(-1-f)*m+(1.5+f)*v+.5*g,S=f*m-f*v;for(let C=0;C!==a;++C)r[C]=p*o[u+C]+y*o[c+C]+A*o[l+C]+S*o[h+C];return r}},Lc=class extends er{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},Dc=class extends er{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Nc=class extends er{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let g=(i-t)/(s-t),v=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*v+o[l+m]*g;return r}let d=a*2,f=e-1;for(let g=0;g!==a;++g){let v=o[c+g],m=o[l+g],p=f*d+g*2,y=h[p],A=h[p+1],S=e*d+g*2,C=u[S],R=u[S+1],x=US(i,t,y,C,s);r[g]=t_(x,v,A,R,m)}return r}};function t_(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function FS(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function US(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=t_(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=FS(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var _i=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=fo(t,this.TimeBufferType),this.values=fo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:fo(e.times,Array),values:fo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),ac(e.settings)&&(i.settings={inTangents:fo(e.settings.inTangents,Array),outTangents:fo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Dc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Lc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Ic(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Nc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ga:t=this.InterpolantFactoryMethodDiscrete;break;case yc:t=this.InterpolantFactoryMethodLinear;break;case uc:t=this.InterpolantFactoryMethodSmooth;break;case Bd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return $e("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ga;case this.InterpolantFactoryMethodLinear:return yc;case this.InterpolantFactoryMethodSmooth:return uc;case this.InterpolantFactoryMethodBezier:return Bd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;ac(this.settings)&&(d0(this.settings.inTangents,e),d0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;ac(this.settings)&&(f0(this.settings.inTangents,e),f0(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Qe("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Qe("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Qe("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Qe("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&uS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Qe("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===uc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let g=0;g!==i;++g){let v=t[h+g];if(v!==t[d+g]||v!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)t[d+f]=t[h+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,ac(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function d0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function f0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}_i.prototype.ValueTypeName="";_i.prototype.TimeBufferType=Float32Array;_i.prototype.ValueBufferType=Float32Array;_i.prototype.DefaultInterpolation=yc;var tr=class extends _i{constructor(e,t,i){super(e,t,i)}};tr.prototype.ValueTypeName="bool";tr.prototype.ValueBufferType=Array;tr.prototype.DefaultInterpolation=ga;tr.prototype.InterpolantFactoryMethodLinear=void 0;tr.prototype.InterpolantFactoryMethodSmooth=void 0;var Fc=class extends _i{constructor(e,t,i,s){super(e,t,i,s)}};Fc.prototype.ValueTypeName="color";var Uc=class extends _i{constructor(e,t,i,s){super(e,t,i,s)}};Uc.prototype.ValueTypeName="number";var Oc=class extends er{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Ci.slerpFlat(r,0,o,c-a,o,c,l);return r}},La=class extends _i{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Oc(this.times,this.values,this.getValueSize(),e)}};La.prototype.ValueTypeName="quaternion";La.prototype.InterpolantFactoryMethodSmooth=void 0;var nr=class extends _i{constructor(e,t,i){super(e,t,i)}};nr.prototype.ValueTypeName="string";nr.prototype.ValueBufferType=Array;nr.prototype.DefaultInterpolation=ga;nr.prototype.InterpolantFactoryMethodLinear=void 0;nr.prototype.InterpolantFactoryMethodSmooth=void 0;var kc=class extends _i{constructor(e,t,i,s){super(e,t,i,s)}};kc.prototype.ValueTypeName="vector";var Bc=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],g=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},n_=new Bc,zc=class{constructor(e){this.manager=e!==void 0?e:n_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};zc.DEFAULT_MATERIAL_NAME="__DEFAULT";var lc=new X,cc=new Ci,rs=new X,Da=class extends gi{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new vt,this.projectionMatrix=new vt,this.projectionMatrixInverse=new vt,this.coordinateSystem=Ri,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(lc,cc,rs),rs.x===1&&rs.y===1&&rs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(lc,cc,rs.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(lc,cc,rs),rs.x===1&&rs.y===1&&rs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(lc,cc,rs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Js=new X,p0=new _t,m0=new _t,ei=class extends Da{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=bc*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(_d*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return bc*2*Math.atan(Math.tan(_d*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Js.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Js.x,Js.y).multiplyScalar(-e/Js.z),Js.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Js.x,Js.y).multiplyScalar(-e/Js.z)}getViewSize(e,t){return this.getViewBounds(e,p0,m0),t.subVectors(m0,p0)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(_d*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ao=class extends Da{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Ps=class extends Fn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var po=-90,mo=1,Ro=class extends gi{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ei(po,mo,e,t);s.layers=this.layers,this.add(s);let r=new ei(po,mo,e,t);r.layers=this.layers,this.add(r);let o=new ei(po,mo,e,t);o.layers=this.layers,this.add(o);let a=new ei(po,mo,e,t);a.layers=this.layers,this.add(a);let l=new ei(po,mo,e,t);l.layers=this.layers,this.add(l);let c=new ei(po,mo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ri)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===va)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let v=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=v,e.setRenderTarget(i,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},Vc=class extends ei{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Tf="\\[\\]\\.:\\/",OS=new RegExp("["+Tf+"]","g"),Af="[^"+Tf+"]",kS="[^"+Tf.replace("\\.","")+"]",BS=/((?:WC+[\/:])*)/.source.replace("WC",Af),zS=/(WCOD+)?/.source.replace("WCOD",kS),VS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Af),HS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Af),GS=new RegExp("^"+BS+zS+VS+HS+"$"),WS=["material","materials","bones","map"],Gd=class{constructor(e,t,i){let s=i||qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},qt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(OS,"")}static parseTrackName(e){let t=GS.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);WS.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){$e("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Qe("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Qe("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Qe("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){Qe("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){Qe("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Qe("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qt.Composite=Gd;qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qt.prototype.GetterByBindingType=[qt.prototype._getValue_direct,qt.prototype._getValue_array,qt.prototype._getValue_arrayElement,qt.prototype._getValue_toArray];qt.prototype.SetterByBindingTypeAndVersioning=[[qt.prototype._setValue_direct,qt.prototype._setValue_direct_setNeedsUpdate,qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_array,qt.prototype._setValue_array_setNeedsUpdate,qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_arrayElement,qt.prototype._setValue_arrayElement_setNeedsUpdate,qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_fromArray,qt.prototype._setValue_fromArray_setNeedsUpdate,qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var RC=new Float32Array(1);var Wd=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};function Rf(n,e,t,i){let s=XS(i);switch(t){case hf:return n*e;case ff:return n*e/s.components*s.byteLength;case Yc:return n*e/s.components*s.byteLength;case ir:return n*e*2/s.components*s.byteLength;case Jc:return n*e*2/s.components*s.byteLength;case df:return n*e*3/s.components*s.byteLength;case vi:return n*e*4/s.components*s.byteLength;case Zc:return n*e*4/s.components*s.byteLength;case Ua:case Oa:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case ka:case Ba:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case jc:case eu:return Math.max(n,16)*Math.max(e,8)/4;case Kc:case Qc:return Math.max(n,8)*Math.max(e,8)/2;case tu:case nu:case su:case ru:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case iu:case za:case ou:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case au:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case lu:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case cu:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case uu:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case hu:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case du:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case fu:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case pu:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case mu:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case gu:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case _u:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case xu:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case vu:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case yu:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case bu:case Su:case Mu:return Math.ceil(n/4)*Math.ceil(e/4)*16;case wu:case Eu:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Va:case Tu:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function XS(n){switch(n){case xi:case af:return{byteLength:1,components:1};case Lo:case lf:case Xi:return{byteLength:2,components:1};case qc:case $c:return{byteLength:2,components:4};case Gi:case Xc:case Wi:return{byteLength:4,components:1};case cf:case uf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?$e("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function w_(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function $S(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<h.length;f++){let g=h[d],v=h[f];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++d,h[d]=v)}h.length=d+1;for(let f=0,g=h.length;f<g;f++){let v=h[f];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var YS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,JS=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,ZS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,KS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,jS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,QS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,eM=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,tM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,nM=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,iM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,sM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,rM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,oM=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,aM=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,lM=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,cM=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,uM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,hM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,dM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,fM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,pM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,mM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,gM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,_M=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,xM=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,vM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,yM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,bM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,SM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,MM="gl_FragColor = linearToOutputTexel( gl_FragColor );",wM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,EM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,TM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,AM=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,RM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,CM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,PM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,IM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,LM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,DM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,NM=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,FM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,UM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,OM=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,kM=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,BM=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,zM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,VM=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,HM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,GM=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,WM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,XM=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,qM=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,$M=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,YM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,JM=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,ZM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,KM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,jM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,QM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,ew=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,tw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,nw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,iw=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,sw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,rw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,ow=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,aw=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,lw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,cw=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,uw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,hw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,dw=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,fw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,pw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,mw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,gw=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,_w=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,xw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,vw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,yw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,bw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Sw=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Mw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,ww=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Ew=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Tw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Aw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Rw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Cw=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Pw=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Iw=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Lw=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Dw=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Nw=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Fw=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Uw=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Ow=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,kw=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Bw=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,zw=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,Vw=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Hw=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Gw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Ww=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Xw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,qw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,$w=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Yw=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Jw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Zw=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Kw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,jw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Qw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,e1=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,t1=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,n1=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,i1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,s1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,r1=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,o1=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,a1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,l1=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,c1=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,u1=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,h1=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,d1=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,f1=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,p1=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,m1=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,g1=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,_1=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,x1=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,v1=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,y1=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,b1=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,S1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,M1=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,w1=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,E1=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,T1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,lt={alphahash_fragment:YS,alphahash_pars_fragment:JS,alphamap_fragment:ZS,alphamap_pars_fragment:KS,alphatest_fragment:jS,alphatest_pars_fragment:QS,aomap_fragment:eM,aomap_pars_fragment:tM,batching_pars_vertex:nM,batching_vertex:iM,begin_vertex:sM,beginnormal_vertex:rM,bsdfs:oM,iridescence_fragment:aM,bumpmap_pars_fragment:lM,clipping_planes_fragment:cM,clipping_planes_pars_fragment:uM,clipping_planes_pars_vertex:hM,clipping_planes_vertex:dM,color_fragment:fM,color_pars_fragment:pM,color_pars_vertex:mM,color_vertex:gM,common:_M,defaultnormal_vertex:xM,displacementmap_pars_vertex:vM,displacementmap_vertex:yM,emissivemap_fragment:bM,emissivemap_pars_fragment:SM,colorspace_fragment:MM,colorspace_pars_fragment:wM,envmap_fragment:EM,envmap_common_pars_fragment:TM,envmap_pars_fragment:AM,envmap_pars_vertex:RM,envmap_physical_pars_fragment:BM,envmap_vertex:CM,fog_vertex:PM,fog_pars_vertex:IM,fog_fragment:LM,fog_pars_fragment:DM,gradientmap_pars_fragment:NM,lightmap_pars_fragment:FM,lights_lambert_fragment:UM,lights_lambert_pars_fragment:OM,lights_pars_begin:kM,lights_toon_fragment:zM,lights_toon_pars_fragment:VM,lights_phong_fragment:HM,lights_phong_pars_fragment:GM,lights_physical_fragment:WM,lights_physical_pars_fragment:XM,lights_fragment_begin:qM,lights_fragment_maps:$M,lights_fragment_end:YM,lightprobes_pars_fragment:JM,logdepthbuf_fragment:ZM,logdepthbuf_pars_fragment:KM,logdepthbuf_pars_vertex:jM,logdepthbuf_vertex:QM,map_fragment:ew,map_pars_fragment:tw,map_particle_fragment:nw,map_particle_pars_fragment:iw,metalnessmap_fragment:sw,metalnessmap_pars_fragment:rw,morphinstance_vertex:ow,morphcolor_vertex:aw,morphnormal_vertex:lw,morphtarget_pars_vertex:cw,morphtarget_vertex:uw,normal_fragment_begin:hw,normal_fragment_maps:dw,normal_pars_fragment:fw,normal_pars_vertex:pw,normal_vertex:mw,normalmap_pars_fragment:gw,clearcoat_normal_fragment_begin:_w,clearcoat_normal_fragment_maps:xw,clearcoat_pars_fragment:vw,iridescence_pars_fragment:yw,opaque_fragment:bw,packing:Sw,premultiplied_alpha_fragment:Mw,project_vertex:ww,dithering_fragment:Ew,dithering_pars_fragment:Tw,roughnessmap_fragment:Aw,roughnessmap_pars_fragment:Rw,shadowmap_pars_fragment:Cw,shadowmap_pars_vertex:Pw,shadowmap_vertex:Iw,shadowmask_pars_fragment:Lw,skinbase_vertex:Dw,skinning_pars_vertex:Nw,skinning_vertex:Fw,skinnormal_vertex:Uw,specularmap_fragment:Ow,specularmap_pars_fragment:kw,tonemapping_fragment:Bw,tonemapping_pars_fragment:zw,transmission_fragment:Vw,transmission_pars_fragment:Hw,uv_pars_fragment:Gw,uv_pars_vertex:Ww,uv_vertex:Xw,worldpos_vertex:qw,background_vert:$w,background_frag:Yw,backgroundCube_vert:Jw,backgroundCube_frag:Zw,cube_vert:Kw,cube_frag:jw,depth_vert:Qw,depth_frag:e1,distance_vert:t1,distance_frag:n1,equirect_vert:i1,equirect_frag:s1,linedashed_vert:r1,linedashed_frag:o1,meshbasic_vert:a1,meshbasic_frag:l1,meshlambert_vert:c1,meshlambert_frag:u1,meshmatcap_vert:h1,meshmatcap_frag:d1,meshnormal_vert:f1,meshnormal_frag:p1,meshphong_vert:m1,meshphong_frag:g1,meshphysical_vert:_1,meshphysical_frag:x1,meshtoon_vert:v1,meshtoon_frag:y1,points_vert:b1,points_frag:S1,shadow_vert:M1,shadow_frag:w1,sprite_vert:E1,sprite_frag:T1},Le={common:{diffuse:{value:new rt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new et}},envmap:{envMap:{value:null},envMapRotation:{value:new et},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new et}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new et}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new et},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new et},normalScale:{value:new _t(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new et},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new et}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new et}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new et}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new rt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new rt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0},uvTransform:{value:new et}},sprite:{diffuse:{value:new rt(16777215)},opacity:{value:1},center:{value:new _t(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}}},hs={basic:{uniforms:qn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:lt.meshbasic_vert,fragmentShader:lt.meshbasic_frag},lambert:{uniforms:qn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new rt(0)},envMapIntensity:{value:1}}]),vertexShader:lt.meshlambert_vert,fragmentShader:lt.meshlambert_frag},phong:{uniforms:qn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new rt(0)},specular:{value:new rt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:lt.meshphong_vert,fragmentShader:lt.meshphong_frag},standard:{uniforms:qn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new rt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:lt.meshphysical_vert,fragmentShader:lt.meshphysical_frag},toon:{uniforms:qn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new rt(0)}}]),vertexShader:lt.meshtoon_vert,fragmentShader:lt.meshtoon_frag},matcap:{uniforms:qn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:lt.meshmatcap_vert,fragmentShader:lt.meshmatcap_frag},points:{uniforms:qn([Le.points,Le.fog]),vertexShader:lt.points_vert,fragmentShader:lt.points_frag},dashed:{uniforms:qn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:lt.linedashed_vert,fragmentShader:lt.linedashed_frag},depth:{uniforms:qn([Le.common,Le.displacementmap]),vertexShader:lt.depth_vert,fragmentShader:lt.depth_frag},normal:{uniforms:qn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:lt.meshnormal_vert,fragmentShader:lt.meshnormal_frag},sprite:{uniforms:qn([Le.sprite,Le.fog]),vertexShader:lt.sprite_vert,fragmentShader:lt.sprite_frag},background:{uniforms:{uvTransform:{value:new et},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:lt.background_vert,fragmentShader:lt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new et}},vertexShader:lt.backgroundCube_vert,fragmentShader:lt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:lt.cube_vert,fragmentShader:lt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:lt.equirect_vert,fragmentShader:lt.equirect_frag},distance:{uniforms:qn([Le.common,Le.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:lt.distance_vert,fragmentShader:lt.distance_frag},shadow:{uniforms:qn([Le.lights,Le.fog,{color:{value:new rt(0)},opacity:{value:1}}]),vertexShader:lt.shadow_vert,fragmentShader:lt.shadow_frag}};hs.physical={uniforms:qn([hs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new et},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new et},clearcoatNormalScale:{value:new _t(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new et},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new et},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new et},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new et},sheen:{value:0},sheenColor:{value:new rt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new et},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new et},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new et},transmissionSamplerSize:{value:new _t},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new et},attenuationDistance:{value:0},attenuationColor:{value:new rt(0)},specularColor:{value:new rt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new et},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new et},anisotropyVector:{value:new _t},anisotropyMap:{value:null},anisotropyMapTransform:{value:new et}}]),vertexShader:lt.meshphysical_vert,fragmentShader:lt.meshphysical_frag};var Ru={r:0,b:0,g:0},A1=new vt,E_=new et;E_.set(-1,0,0,0,1,0,0,0,1);function R1(n,e,t,i,s,r){let o=new rt(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(y){let A=y.isScene===!0?y.background:null;if(A&&A.isTexture){let S=y.backgroundBlurriness>0;A=e.get(A,S)}return A}function g(y){let A=!1,S=f(y);S===null?m(o,a):S&&S.isColor&&(m(S,1),A=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function v(y,A){let S=f(A);S&&S.isCubeTexture?(c===void 0&&(c=new Nt(new Eo(1,1,1),new Pi({name:"BackgroundCubeMaterial",uniforms:Ar(hs.backgroundCube.uniforms),vertexShader:hs.backgroundCube.vertexShader,fragmentShader:hs.backgroundCube.fragmentShader,side:Bn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,R,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(A1.makeRotationFromEuler(A.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(E_),c.material.toneMapped=mt.getTransfer(S.colorSpace)!==Et,(u!==S||h!==S.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,h=S.version,d=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Nt(new Sr(2,2),new Pi({name:"BackgroundMaterial",uniforms:Ar(hs.background.uniforms),vertexShader:hs.background.vertexShader,fragmentShader:hs.background.fragmentShader,side:Ii,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=mt.getTransfer(S.colorSpace)!==Et,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||h!==S.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,h=S.version,d=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function m(y,A){y.getRGB(Ru,Ef(n)),t.buffers.color.setClear(Ru.r,Ru.g,Ru.b,A,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,A=1){o.set(y),a=A,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,m(o,a)},render:g,addToRenderList:v,dispose:p}}function C1(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(L,k,z,N,G){let $=!1,H=h(L,N,z,k);r!==H&&(r=H,c(r.object)),$=f(L,N,z,G),$&&g(L,N,z,G),G!==null&&e.update(G,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,S(L,k,z,N),G!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function h(L,k,z,N){let G=N.wireframe===!0,$=i[k.id];$===void 0&&($={},i[k.id]=$);let H=L.isInstancedMesh===!0?L.id:0,le=$[H];le===void 0&&(le={},$[H]=le);let Z=le[z.id];Z===void 0&&(Z={},le[z.id]=Z);let Q=Z[G];return Q===void 0&&(Q=d(l()),Z[G]=Q),Q}function d(L){let k=[],z=[],N=[];for(let G=0;G<t;G++)k[G]=0,z[G]=0,N[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:z,attributeDivisors:N,object:L,attributes:{},index:null}}function f(L,k,z,N){let G=r.attributes,$=k.attributes,H=0,le=z.getAttributes();for(let Z in le)if(le[Z].location>=0){let ie=G[Z],de=$[Z];if(de===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(de=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(de=L.instanceColor)),ie===void 0||ie.attribute!==de||de&&ie.data!==de.data)return!0;H++}return r.attributesNum!==H||r.index!==N}function g(L,k,z,N){let G={},$=k.attributes,H=0,le=z.getAttributes();for(let Z in le)if(le[Z].location>=0){let ie=$[Z];ie===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(ie=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(ie=L.instanceColor));let de={};de.attribute=ie,ie&&ie.data&&(de.data=ie.data),G[Z]=de,H++}r.attributes=G,r.attributesNum=H,r.index=N}function v(){let L=r.newAttributes;for(let k=0,z=L.length;k<z;k++)L[k]=0}function m(L){p(L,0)}function p(L,k){let z=r.newAttributes,N=r.enabledAttributes,G=r.attributeDivisors;z[L]=1,N[L]===0&&(n.enableVertexAttribArray(L),N[L]=1),G[L]!==k&&(n.vertexAttribDivisor(L,k),G[L]=k)}function y(){let L=r.newAttributes,k=r.enabledAttributes;for(let z=0,N=k.length;z<N;z++)k[z]!==L[z]&&(n.disableVertexAttribArray(z),k[z]=0)}function A(L,k,z,N,G,$,H){H===!0?n.vertexAttribIPointer(L,k,z,G,$):n.vertexAttribPointer(L,k,z,N,G,$)}function S(L,k,z,N){v();let G=N.attributes,$=z.getAttributes(),H=k.defaultAttributeValues;for(let le in $){let Z=$[le];if(Z.location>=0){let Q=G[le];if(Q===void 0&&(le==="instanceMatrix"&&L.instanceMatrix&&(Q=L.instanceMatrix),le==="instanceColor"&&L.instanceColor&&(Q=L.instanceColor)),Q!==void 0){let ie=Q.normalized,de=Q.itemSize,he=e.get(Q);if(he===void 0)continue;let ee=he.buffer,me=he.type,ge=he.bytesPerElement,Me=me===n.INT||me===n.UNSIGNED_INT||Q.gpuType===Xc;if(Q.isInterleavedBufferAttribute){let ve=Q.data,He=ve.isInterleavedBuffer===!0?ve.stride:ve.itemSize,Je=Q.offset;if(ve.isInstancedInterleavedBuffer||ve.isInstancedBufferAttribute){for(let Oe=0;Oe<Z.locationSize;Oe++)p(Z.location+Oe,ve.meshPerAttribute);L.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=ve.meshPerAttribute*ve.count)}else for(let Oe=0;Oe<Z.locationSize;Oe++)m(Z.location+Oe);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Oe=0;Oe<Z.locationSize;Oe++)A(Z.location+Oe,de/Z.locationSize,me,ie,He*ge,(Je+de/Z.locationSize*Oe)*ge,Me)}else{if(Q.isInstancedBufferAttribute){for(let ve=0;ve<Z.locationSize;ve++)p(Z.location+ve,Q.meshPerAttribute);L.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let ve=0;ve<Z.locationSize;ve++)m(Z.location+ve);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let ve=0;ve<Z.locationSize;ve++)A(Z.location+ve,de/Z.locationSize,me,ie,de*ge,de/Z.locationSize*ve*ge,Me)}}else if(H!==void 0){let ie=H[le];if(ie!==void 0)switch(ie.length){case 2:n.vertexAttrib2fv(Z.location,ie);break;case 3:n.vertexAttrib3fv(Z.location,ie);break;case 4:n.vertexAttrib4fv(Z.location,ie);break;default:n.vertexAttrib1fv(Z.location,ie)}}}}y()}function C(){U();for(let L in i){let k=i[L];for(let z in k){let N=k[z];for(let G in N){let $=N[G];for(let H in $)u($[H].object),delete $[H];delete N[G]}}delete i[L]}}function R(L){if(i[L.id]===void 0)return;let k=i[L.id];for(let z in k){let N=k[z];for(let G in N){let $=N[G];for(let H in $)u($[H].object),delete $[H];delete N[G]}}delete i[L.id]}function x(L){for(let k in i){let z=i[k];for(let N in z){let G=z[N];if(G[L.id]===void 0)continue;let $=G[L.id];for(let H in $)u($[H].object),delete $[H];delete G[L.id]}}}function E(L){for(let k in i){let z=i[k],N=L.isInstancedMesh===!0?L.id:0,G=z[N];if(G!==void 0){for(let $ in G){let H=G[$];for(let le in H)u(H[le].object),delete H[le];delete G[$]}delete z[N],Object.keys(z).length===0&&delete i[k]}}}function U(){D(),o=!0,r!==s&&(r=s,c(r.object))}function D(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:D,dispose:C,releaseStatesOfGeometry:R,releaseStatesOfObject:E,releaseStatesOfProgram:x,initAttributes:v,enableAttribute:m,disableUnusedAttributes:y}}function P1(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function I1(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==vi&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let E=x===Xi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==xi&&x!==Wi&&!E&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&($e("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&$e("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&$e("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),R=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:y,maxVaryings:A,maxFragmentUniforms:S,maxSamples:C,samples:R}}function L1(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Hi,a=new et,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let g=h.clippingPlanes,v=h.clipIntersection,m=h.clipShadows,p=n.get(h);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{let y=r?0:i,A=y*4,S=p.clippingState||null;l.value=S,S=u(g,d,A,f);for(let C=0;C!==A;++C)S[C]=t[C];p.clippingState=S,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,d,f,g){let v=h!==null?h.length:0,m=null;if(v!==0){if(m=l.value,g!==!0||m===null){let p=f+v*4,y=d.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<p)&&(m=new Float32Array(p));for(let A=0,S=f;A!==v;++A,S+=4)o.copy(h[A]).applyMatrix4(y,a),o.normal.toArray(m,S),m[S+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,m}}var qa=class extends mi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Ra(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Eo(5,5,5),r=new Pi({name:"CubemapFromEquirect",uniforms:Ar(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Bn,blending:Mr});r.uniforms.tEquirect.value=t;let o=new Nt(s,r),a=t.minFilter;return t.minFilter===Is&&(t.minFilter=kn),new Ro(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},i_=256,D1=3,N1=20,T_=256,A_=16,F1=3,U1=new X,O1=new rt,Pu=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ro(1,10,null),this._boxMesh=new Nt(new Eo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=U1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(O1));let m=new Ro(i,s,u);return m.position.copy(a),m.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=g,e.background=v,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=o_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=r_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(i_,j0(e))}_fromTexture(e,t){e.mapping===Er||e.mapping===Io?this._setSize(e.image.length===0?i_:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=s_(e,!1,!1),i=Math.log2(e)-D1;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=s_(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Er||e.mapping===Io?(this._cubemapMaterial===null&&(this._cubemapMaterial=o_()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=r_()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=k1(),this._integrationMaterial=B1());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/A_);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-F1)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(T_*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=z1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function s_(n,e,t){return new qa(n,{minFilter:Is,generateMipmaps:e,type:Xi,colorSpace:_a,depthBuffer:t})}function $a(n,e,t){return new Pi({name:n,uniforms:e,vertexShader:lt.cube_vert,fragmentShader:t,side:Bn,blending:Mr,depthTest:!1,depthWrite:!1})}function k1(){return $a("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${T_}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function B1(){return $a("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:A_}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function z1(){return $a("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${N1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function r_(){return $a("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function o_(){return $a("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function V1(n){let e=new WeakMap,t=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Hc||f===Gc)if(e.has(d)){let g=e.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let v=new qa(g.height);return v.fromEquirectangularTexture(n,d),e.set(d,v),d.addEventListener("dispose",c),a(v.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===Hc||f===Gc,v=f===Er||f===Io;if(g||v){let m=t.get(d),p=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==p)return i===null&&(i=new Pu(n)),m=g?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),m.texture;if(m!==void 0)return m.texture;{let y=d.image;return g&&y&&y.height>0||v&&y&&l(y)?(i===null&&(i=new Pu(n)),m=g?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),d.addEventListener("dispose",u),m.texture):null}}}return d}function a(d,f){return f===Hc?d.mapping=Er:f===Gc&&(d.mapping=Io),d}function l(d){let f=0,g=6;for(let v=0;v<g;v++)d[v]!==void 0&&f++;return f===g}function c(d){let f=d.target;f.removeEventListener("dispose",c);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function H1(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&ma("WebGLRenderer: "+i+" extension not supported."),s}}}function G1(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let m in g.attributes)e.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let v=r.get(g);v&&(e.remove(v),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function u(g){let v=g.attributes;for(let m in v)e.update(v[m],n.ARRAY_BUFFER)}function h(g){let v=g.index,m=g.attributes.position,p=0;if(m===void 0)return;let y=v!==null?v.array.length:m.array.length/3-1,A=m.count>=65535?Ea:wa,S=new A(Math.ceil(y/3)*6,1),C=S.array;if(v!==null){let x=v.array;p=v.version;for(let E=0,U=0;E<y;E+=3){let D=x[E+0],L=x[E+1],k=x[E+2];C[U++]=D,C[U++]=L,C[U++]=L,C[U++]=k,C[U++]=k,C[U++]=D}}else{p=m.version;for(let x=0,E=0;x<y;x+=3){let U=x+0,D=x+1,L=x+2;C[E++]=U,C[E++]=D,C[E++]=D,C[E++]=L,C[E++]=L,C[E++]=U}}S.version=p;let R=r.get(g);R&&e.remove(R),r.set(g,S)}function d(g){let v=r.get(g);if(v){let m=g.index;m!==null&&v.version<m.version&&h(g)}else h(g);return r.get(g)}function f(){for(let g in s){let v=s[g].deref();v!==void 0&&l(v)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function W1(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),t.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),t.update(d,i,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let v=0;for(let m=0;m<f;m++)v+=d[m];t.update(v,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function X1(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:Qe("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function q1(n,e,t){let i=new WeakMap,s=new $t;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let U=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",U)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],A=0;f===!0&&(A=1),g===!0&&(A=2),v===!0&&(A=3);let S=a.attributes.position.count*A,C=1;S>e.maxTextureSize&&(C=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let R=new Float32Array(S*C*4*h),x=new ba(R,S,C,h);x.type=Wi,x.needsUpdate=!0;let E=A*4;for(let D=0;D<h;D++){let L=m[D],k=p[D],z=y[D],N=S*C*4*D;for(let G=0;G<L.count;G++){let $=G*E;f===!0&&(s.fromBufferAttribute(L,G),R[N+$+0]=s.x,R[N+$+1]=s.y,R[N+$+2]=s.z,R[N+$+3]=0),g===!0&&(s.fromBufferAttribute(k,G),R[N+$+4]=s.x,R[N+$+5]=s.y,R[N+$+6]=s.z,R[N+$+7]=0),v===!0&&(s.fromBufferAttribute(z,G),R[N+$+8]=s.x,R[N+$+9]=s.y,R[N+$+10]=s.z,R[N+$+11]=z.itemSize===4?s.w:1)}}d={count:h,texture:x,size:new _t(S,C)},i.set(a,d),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function $1(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=e.get(c,h);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var Y1={[jd]:"LINEAR_TONE_MAPPING",[Qd]:"REINHARD_TONE_MAPPING",[ef]:"CINEON_TONE_MAPPING",[tf]:"ACES_FILMIC_TONE_MAPPING",[sf]:"AGX_TONE_MAPPING",[rf]:"NEUTRAL_TONE_MAPPING",[nf]:"CUSTOM_TONE_MAPPING"};function J1(n,e,t,i,s,r){let o=new mi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Fn;u.setAttribute("position",new zt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new zt([0,2,0,0,2,0],2));let h=new Rc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Nt(u,h),f=new Ao(-1,1,1,-1,0,1),g=null,v=null,m=!1,p,y=null,A=[],S=!1;this.setSize=function(C,R){o.setSize(C,R),a!==null&&a.setSize(C,R),l!==null&&l.setSize(C,R);for(let x=0;x<A.length;x++){let E=A[x];E.setSize&&E.setSize(C,R)}},this.setEffects=function(C){A=C,S=A.length>0&&A[0].isRenderPass===!0;let R=o.width,x=o.height;A.length>0&&a===null&&(a=new mi(R,x,{type:Xi,depthBuffer:!1,stencilBuffer:!1}),l=new mi(R,x,{type:Xi,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&A.some(U=>U.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new Cs(R,x),r===!0&&(c.format=Ls,c.type=Tr)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let U=0;U<A.length;U++){let D=A[U];D.setSize&&D.setSize(R,x),E&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(c)}},this.begin=function(C,R){if(m||C.toneMapping===cs&&A.length===0)return!1;if(y=R,R!==null){let x=R.width,E=R.height;(o.width!==x||o.height!==E)&&this.setSize(x,E)}return S===!1&&C.setRenderTarget(o),p=C.toneMapping,C.toneMapping=cs,!0},this.hasRenderPass=function(){return S},this.end=function(C,R){C.toneMapping=p,m=!0;let x=o,E=a;for(let U=0;U<A.length;U++){let D=A[U];D.enabled!==!1&&(D.render(C,E,x,R),D.needsSwap!==!1&&(x=E,E=E===a?l:a))}if(g!==C.outputColorSpace||v!==C.toneMapping){g=C.outputColorSpace,v=C.toneMapping,h.defines={},mt.getTransfer(g)===Et&&(h.defines.SRGB_TRANSFER="");let U=Y1[v];U&&(h.defines[U]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(y),C.render(d,f),y=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var R_=new si,C_=new Cs(1,1),P_=new Ca(1),I_=new ba,L_=new wc,D_=new Ra,a_=[],l_=[],c_=new Float32Array(16),u_=new Float32Array(9),h_=new Float32Array(4);function No(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=a_[s];if(r===void 0&&(r=new Float32Array(s),a_[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function An(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Rn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Lu(n,e){let t=l_[e];t===void 0&&(t=new Int32Array(e),l_[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function Z1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function K1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(An(t,e))return;n.uniform2fv(this.addr,e),Rn(t,e)}}function j1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(An(t,e))return;n.uniform3fv(this.addr,e),Rn(t,e)}}function Q1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(An(t,e))return;n.uniform4fv(this.addr,e),Rn(t,e)}}function eE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(An(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Rn(t,e)}else{if(An(t,i))return;h_.set(i),n.uniformMatrix2fv(this.addr,!1,h_),Rn(t,i)}}function tE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(An(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Rn(t,e)}else{if(An(t,i))return;u_.set(i),n.uniformMatrix3fv(this.addr,!1,u_),Rn(t,i)}}function nE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(An(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Rn(t,e)}else{if(An(t,i))return;c_.set(i),n.uniformMatrix4fv(this.addr,!1,c_),Rn(t,i)}}function iE(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function sE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(An(t,e))return;n.uniform2iv(this.addr,e),Rn(t,e)}}function rE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(An(t,e))return;n.uniform3iv(this.addr,e),Rn(t,e)}}function oE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(An(t,e))return;n.uniform4iv(this.addr,e),Rn(t,e)}}function aE(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function lE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(An(t,e))return;n.uniform2uiv(this.addr,e),Rn(t,e)}}function cE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(An(t,e))return;n.uniform3uiv(this.addr,e),Rn(t,e)}}function uE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(An(t,e))return;n.uniform4uiv(this.addr,e),Rn(t,e)}}function Du(n){return n.version===0&&(n.compareFunction=yf,n.needsUpdate=!0),n}function hE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Du(C_):r=R_,t.setTexture2D(e||r,s)}function dE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||L_,s)}function fE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Du(P_):r=D_,t.setTextureCube(e||r,s)}function pE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||I_,s)}function mE(n){switch(n){case 5126:return Z1;case 35664:return K1;case 35665:return j1;case 35666:return Q1;case 35674:return eE;case 35675:return tE;case 35676:return nE;case 5124:case 35670:return iE;case 35667:case 35671:return sE;case 35668:case 35672:return rE;case 35669:case 35673:return oE;case 5125:return aE;case 36294:return lE;case 36295:return cE;case 36296:return uE;case 35678:case 36198:case 36298:case 36306:case 35682:return hE;case 35679:case 36299:case 36307:return dE;case 35680:case 36300:case 36308:case 36293:return fE;case 36289:case 36303:case 36311:case 36292:return pE}}function gE(n,e){n.uniform1fv(this.addr,e)}function _E(n,e){let t=No(e,this.size,2);n.uniform2fv(this.addr,t)}function xE(n,e){let t=No(e,this.size,3);n.uniform3fv(this.addr,t)}function vE(n,e){let t=No(e,this.size,4);n.uniform4fv(this.addr,t)}function yE(n,e){let t=No(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function bE(n,e){let t=No(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function SE(n,e){let t=No(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function ME(n,e){n.uniform1iv(this.addr,e)}function wE(n,e){n.uniform2iv(this.addr,e)}function EE(n,e){n.uniform3iv(this.addr,e)}function TE(n,e){n.uniform4iv(this.addr,e)}function AE(n,e){n.uniform1uiv(this.addr,e)}function RE(n,e){n.uniform2uiv(this.addr,e)}function CE(n,e){n.uniform3uiv(this.addr,e)}function PE(n,e){n.uniform4uiv(this.addr,e)}function IE(n,e,t){let i=this.cache,s=e.length,r=Lu(t,s);An(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Du(C_):o=R_;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function LE(n,e,t){let i=this.cache,s=e.length,r=Lu(t,s);An(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||L_,r[o])}function DE(n,e,t){let i=this.cache,s=e.length,r=Lu(t,s);An(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Du(P_):o=D_;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function NE(n,e,t){let i=this.cache,s=e.length,r=Lu(t,s);An(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||I_,r[o])}function FE(n){switch(n){case 5126:return gE;case 35664:return _E;case 35665:return xE;case 35666:return vE;case 35674:return yE;case 35675:return bE;case 35676:return SE;case 5124:case 35670:return ME;case 35667:case 35671:return wE;case 35668:case 35672:return EE;case 35669:case 35673:return TE;case 5125:return AE;case 36294:return RE;case 36295:return CE;case 36296:return PE;case 35678:case 36198:case 36298:case 36306:case 35682:return IE;case 35679:case 36299:case 36307:return LE;case 35680:case 36300:case 36308:case 36293:return DE;case 36289:case 36303:case 36311:case 36292:return NE}}var If=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=mE(t.type)}},Lf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=FE(t.type)}},Df=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Cf=/(\w+)(\])?(\[|\.)?/g;function d_(n,e){n.seq.push(e),n.map[e.id]=e}function UE(n,e,t){let i=n.name,s=i.length;for(Cf.lastIndex=0;;){let r=Cf.exec(i),o=Cf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){d_(t,c===void 0?new If(a,n,e):new Lf(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new Df(a),d_(t,h)),t=h}}}var Do=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);UE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function f_(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var OE=37297,kE=0;function BE(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var p_=new et;function zE(n){mt._getMatrix(p_,mt.workingColorSpace,n);let e=`mat3( ${p_.elements.map(t=>t.toFixed(4))} )`;switch(mt.getTransfer(n)){case xa:return[e,"LinearTransferOETF"];case Et:return[e,"sRGBTransferOETF"];default:return $e("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function m_(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+BE(n.getShaderSource(e),a)}else return r}function VE(n,e){let t=zE(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var HE={[jd]:"Linear",[Qd]:"Reinhard",[ef]:"Cineon",[tf]:"ACESFilmic",[sf]:"AgX",[rf]:"Neutral",[nf]:"Custom"};function GE(n,e){let t=HE[e];return t===void 0?($e("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Cu=new X;function WE(){mt.getLuminanceCoefficients(Cu);let n=Cu.x.toFixed(4),e=Cu.y.toFixed(4),t=Cu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function XE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Xa).join(`
`)}function qE(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function $E(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Xa(n){return n!==""}function g_(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function __(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var YE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Nf(n){return n.replace(YE,JE)}function JE(n,e){let t=lt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Nf(t)}var ZE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function x_(n){return n.replace(ZE,KE)}function KE(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function v_(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var jE={[Na]:"SHADOWMAP_TYPE_PCF",[Co]:"SHADOWMAP_TYPE_VSM"};function QE(n){return jE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var eT={[Io]:"ENVMAP_MODE_REFRACTION"};function tT(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":eT[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var nT={[Kd]:"ENVMAP_BLENDING_MULTIPLY",[O0]:"ENVMAP_BLENDING_MIX",[k0]:"ENVMAP_BLENDING_ADD"};function iT(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":nT[n.combine]||"ENVMAP_BLENDING_NONE"}function sT(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=QE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=tT(t),h=iT(t),d=XE(t),f=qE(r),g=s.createProgram(),v,m,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Xa).join(`
`),v.length>0&&(v+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Xa).join(`
`),m.length>0&&(m+=`
`)):(v=[v_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Xa).join(`
`),m=[v_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==cs?"#define TONE_MAPPING":"",t.toneMapping!==cs?lt.tonemapping_pars_fragment:"",t.toneMapping!==cs?GE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",lt.colorspace_pars_fragment,VE("linearToOutputTexel",t.outputColorSpace),WE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Xa).join(`
`)),o=Nf(o),o=g_(o,t),o=__(o,t),a=Nf(a),a=g_(a,t),a=__(a,t),o=x_(o),a=x_(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,v=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,m=["#define varying in",t.glslVersion===Sf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Sf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let y=p+v+o,A=p+m+a,S=f_(s,s.VERTEX_SHADER,y),C=f_(s,s.FRAGMENT_SHADER,A);s.attachShader(g,S),s.attachShader(g,C),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function R(D){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(g)||"",k=s.getShaderInfoLog(S)||"",z=s.getShaderInfoLog(C)||"",N=L.trim(),G=k.trim(),$=z.trim(),H=!0,le=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,S,C);else{let Z=m_(s,S,"vertex"),Q=m_(s,C,"fragment");Qe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+N+`
`+Z+`
`+Q)}else N!==""?$e("WebGLProgram: Program Info Log:",N):(G===""||$==="")&&(le=!1);le&&(D.diagnostics={runnable:H,programLog:N,vertexShader:{log:G,prefix:v},fragmentShader:{log:$,prefix:m}})}s.deleteShader(S),s.deleteShader(C),x=new Do(s,g),E=$E(s,g)}let x;this.getUniforms=function(){return x===void 0&&R(this),x};let E;this.getAttributes=function(){return E===void 0&&R(this),E};let U=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(g,OE)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=kE++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=C,this}var rT=0,Ff=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Uf(e),t.set(e,i)),i}},Uf=class{constructor(e){this.id=rT++,this.code=e,this.usedTimes=0}};function oT(n){return n===ir||n===za||n===Va}function aT(n,e,t,i,s,r){let o=new Sa,a=new Ff,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,E,U,D,L,k){let z=D.fog,N=L.geometry,G=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?D.environment:null,$=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,H=e.get(x.envMap||G,$),le=d[x.type],Z=i.precision;x.precision!==null&&(Z=i.getMaxPrecision(x.precision),Z!==x.precision&&$e("WebGLProgram.getParameters:",x.precision,"not supported, using",Z,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ie=Q!==void 0?Q.length:0,de=0;N.morphAttributes.position!==void 0&&(de=1),N.morphAttributes.normal!==void 0&&(de=2),N.morphAttributes.color!==void 0&&(de=3);let he,ee,me,ge;if(le){let Re=hs[le];he=Re.vertexShader,ee=Re.fragmentShader}else{he=x.vertexShader,ee=x.fragmentShader;let Re=a.getVertexShaderStage(x),st=a.getFragmentShaderStage(x);a.update(x,Re,st),me=Re.id,ge=st.id}let Me=n.getRenderTarget(),ve=n.state.buffers.depth.getReversed(),He=L.isInstancedMesh===!0,Je=L.isBatchedMesh===!0,Oe=!!x.map,ct=!!x.matcap,ot=!!H,tt=ot&&H.isPMREMTexture===!0,Yt=!!x.aoMap,Bt=!!x.lightMap,hn=!!x.bumpMap&&x.wireframe===!1,Pt=!!x.normalMap,Cn=!!x.displacementMap,xt=!!x.emissiveMap,Mn=!!x.metalnessMap,Qt=!!x.roughnessMap,dn=x.anisotropy>0,B=x.clearcoat>0,Ce=x.diffuseRoughness>0,qe=x.dispersion>0,it=x.retroreflectivity>0,we=x.iridescence>0,Ft=x.sheen>0,Ve=x.transmission>0,Xe=dn&&!!x.anisotropyMap,P=B&&!!x.clearcoatMap,M=B&&!!x.clearcoatNormalMap,q=B&&!!x.clearcoatRoughnessMap,ue=Ce&&!!x.diffuseRoughnessMap,oe=we&&!!x.iridescenceMap,xe=we&&!!x.iridescenceThicknessMap,ye=Ft&&!!x.sheenColorMap,te=Ft&&!!x.sheenRoughnessMap,se=!!x.specularMap,pe=!!x.specularColorMap,O=!!x.specularIntensityMap,re=Ve&&!!x.transmissionMap,ne=Ve&&!!x.thicknessMap,Ee=!!x.gradientMap,_e=!!x.alphaMap,Se=x.alphaTest>0,Ge=!!x.alphaHash,Ze=!!x.extensions,ce=cs;x.toneMapped&&(Me===null||Me.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ke=tt?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,Ke={shaderID:le,shaderType:x.type,shaderName:x.name,vertexShader:he,fragmentShader:ee,defines:x.defines,customVertexShaderID:me,customFragmentShaderID:ge,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Z,batching:Je,batchingColor:Je&&L._colorsTexture!==null,instancing:He,instancingColor:He&&L.instanceColor!==null,instancingMorph:He&&L.morphTexture!==null,outputColorSpace:Me===null?n.outputColorSpace:Me.isXRRenderTarget===!0?Me.texture.colorSpace:mt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Oe,matcap:ct,envMap:ot,envMapMode:ot&&H.mapping,envMapPMREM:tt,envMapMaxLod:tt?ke.length-1:null,envMapSize:tt?ke[0].width:null,aoMap:Yt,lightMap:Bt,bumpMap:hn,normalMap:Pt,displacementMap:Cn,emissiveMap:xt,normalMapObjectSpace:Pt&&x.normalMapType===V0,normalMapTangentSpace:Pt&&x.normalMapType===pf,packedNormalMap:Pt&&x.normalMapType===pf&&oT(x.normalMap.format),metalnessMap:Mn,roughnessMap:Qt,anisotropy:dn,anisotropyMap:Xe,clearcoat:B,clearcoatMap:P,clearcoatNormalMap:M,clearcoatRoughnessMap:q,diffuseRoughness:Ce,diffuseRoughnessMap:ue,dispersion:qe,retroreflection:it,iridescence:we,iridescenceMap:oe,iridescenceThicknessMap:xe,sheen:Ft,sheenColorMap:ye,sheenRoughnessMap:te,specularMap:se,specularColorMap:pe,specularIntensityMap:O,transmission:Ve,transmissionMap:re,thicknessMap:ne,gradientMap:Ee,opaque:x.transparent===!1&&x.blending===Po&&x.alphaToCoverage===!1,alphaMap:_e,alphaTest:Se,alphaHash:Ge,combine:x.combine,mapUv:Oe&&f(x.map.channel),aoMapUv:Yt&&f(x.aoMap.channel),lightMapUv:Bt&&f(x.lightMap.channel),bumpMapUv:hn&&f(x.bumpMap.channel),normalMapUv:Pt&&f(x.normalMap.channel),displacementMapUv:Cn&&f(x.displacementMap.channel),emissiveMapUv:xt&&f(x.emissiveMap.channel),metalnessMapUv:Mn&&f(x.metalnessMap.channel),roughnessMapUv:Qt&&f(x.roughnessMap.channel),anisotropyMapUv:Xe&&f(x.anisotropyMap.channel),clearcoatMapUv:P&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(x.sheenRoughnessMap.channel),specularMapUv:se&&f(x.specularMap.channel),specularColorMapUv:pe&&f(x.specularColorMap.channel),specularIntensityMapUv:O&&f(x.specularIntensityMap.channel),transmissionMapUv:re&&f(x.transmissionMap.channel),thicknessMapUv:ne&&f(x.thicknessMap.channel),alphaMapUv:_e&&f(x.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Pt||dn),vertexNormals:!!N.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!N.attributes.uv&&(Oe||_e),fog:!!z,useFog:x.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||N.attributes.normal===void 0&&Pt===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:ve,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:de,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:k.filter(Re=>Re.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:Oe&&x.map.isVideoTexture===!0&&mt.getTransfer(x.map.colorSpace)===Et,decodeVideoTextureEmissive:xt&&x.emissiveMap.isVideoTexture===!0&&mt.getTransfer(x.emissiveMap.colorSpace)===Et,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===zn,flipSided:x.side===Bn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Ze&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ze&&x.extensions.multiDraw===!0||Je)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Ke.vertexUv1s=l.has(1),Ke.vertexUv2s=l.has(2),Ke.vertexUv3s=l.has(3),l.clear(),Ke}function v(x){let E=[];if(x.shaderID?E.push(x.shaderID):(E.push(x.customVertexShaderID),E.push(x.customFragmentShaderID)),x.defines!==void 0)for(let U in x.defines)E.push(U),E.push(x.defines[U]);return x.isRawShaderMaterial===!1&&(m(E,x),p(E,x),E.push(n.outputColorSpace)),E.push(x.customProgramCacheKey),E.join()}function m(x,E){x.push(E.precision),x.push(E.outputColorSpace),x.push(E.envMapMode),x.push(E.envMapPMREM),x.push(E.envMapMaxLod),x.push(E.envMapSize),x.push(E.mapUv),x.push(E.alphaMapUv),x.push(E.lightMapUv),x.push(E.aoMapUv),x.push(E.bumpMapUv),x.push(E.normalMapUv),x.push(E.displacementMapUv),x.push(E.emissiveMapUv),x.push(E.metalnessMapUv),x.push(E.roughnessMapUv),x.push(E.anisotropyMapUv),x.push(E.clearcoatMapUv),x.push(E.clearcoatNormalMapUv),x.push(E.clearcoatRoughnessMapUv),x.push(E.diffuseRoughnessMapUv),x.push(E.iridescenceMapUv),x.push(E.iridescenceThicknessMapUv),x.push(E.sheenColorMapUv),x.push(E.sheenRoughnessMapUv),x.push(E.specularMapUv),x.push(E.specularColorMapUv),x.push(E.specularIntensityMapUv),x.push(E.transmissionMapUv),x.push(E.thicknessMapUv),x.push(E.combine),x.push(E.fogExp2),x.push(E.sizeAttenuation),x.push(E.morphTargetsCount),x.push(E.numSunLights),x.push(E.numDirLights),x.push(E.numPointLights),x.push(E.numSpotLights),x.push(E.numSpotLightMaps),x.push(E.numHemiLights),x.push(E.numRectAreaLights),x.push(E.numSunLightShadows),x.push(E.numDirLightShadows),x.push(E.numPointLightShadows),x.push(E.numSpotLightShadows),x.push(E.numSpotLightShadowsWithMaps),x.push(E.numLightProbes),x.push(E.numLightProbeGrids),x.push(E.shadowMapType),x.push(E.toneMapping),x.push(E.numClippingPlanes),x.push(E.numClipIntersection),x.push(E.depthPacking)}function p(x,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function y(x){let E=d[x.type],U;if(E){let D=hs[E];U=e_.clone(D.uniforms)}else U=x.uniforms;return U}function A(x,E){let U=u.get(E);return U!==void 0?++U.usedTimes:(U=new sT(n,E,x,s),c.push(U),u.set(E,U)),U}function S(x){if(--x.usedTimes===0){let E=c.indexOf(x);c[E]=c[c.length-1],c.pop(),u.delete(x.cacheKey),x.destroy()}}function C(x){a.remove(x)}function R(){a.dispose()}return{getParameters:g,getProgramCacheKey:v,getUniforms:y,acquireProgram:A,releaseProgram:S,releaseShaderCache:C,programs:c,dispose:R}}function lT(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function cT(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function y_(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function b_(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,v,m,p){let y=n[e];return y===void 0?(y={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:v,renderOrder:d.renderOrder,z:m,group:p},n[e]=y):(y.id=d.id,y.object=d,y.geometry=f,y.material=g,y.materialVariant=o(d),y.groupOrder=v,y.renderOrder=d.renderOrder,y.z=m,y.group=p),e++,y}function l(d,f,g,v,m,p,y){y.reversedDepth===!0&&(m=-m);let A=a(d,f,g,v,m,p);g.transmission>0?i.push(A):g.transparent===!0?s.push(A):t.push(A)}function c(d,f,g,v,m,p){let y=a(d,f,g,v,m,p);g.transmission>0?i.unshift(y):g.transparent===!0?s.unshift(y):t.unshift(y)}function u(d,f){t.length>1&&t.sort(d||cT),i.length>1&&i.sort(f||y_),s.length>1&&s.sort(f||y_)}function h(){for(let d=e,f=n.length;d<f;d++){let g=n[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function uT(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new b_,n.set(i,[o])):s>=r.length?(o=new b_,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function hT(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new X,color:new rt};break;case"SpotLight":t={position:new X,direction:new X,color:new rt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new X,color:new rt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new X,skyColor:new rt,groundColor:new rt};break;case"RectAreaLight":t={color:new rt,position:new X,halfWidth:new X,halfHeight:new X};break}return n[e.id]=t,t}}}function dT(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var fT=0;function pT(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function mT(n){let e=new hT,t=dT(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new X);let s=new X,r=new vt,o=new vt;function a(c){let u=0,h=0,d=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let f=0,g=0,v=0,m=0,p=0,y=0,A=0,S=0,C=0,R=0,x=0,E=0,U=0,D=0;c.sort(pT);for(let k=0,z=c.length;k<z;k++){let N=c[k],G=N.color,$=N.intensity,H=N.distance,le=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===ir?le=N.shadow.map.texture:le=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=G.r*$,h+=G.g*$,d+=G.b*$;else if(N.isLightProbe){for(let Z=0;Z<9;Z++)i.probe[Z].addScaledVector(N.sh.coefficients[Z],$);D++}else if(N.isSunLight){let Z=e.get(N);if(Z.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[g]=ie,i.sunShadowMap[g]=le;let de=Q.getViewportCount();for(let he=0;he<de;he++)i.sunShadowMatrix[v+he]=Q.getMatrix(he),i.sunShadowCascade[v+he]=Q._cascadeData[he];v+=de,g++}i.sun[f]=Z,f++}else if(N.isDirectionalLight){let Z=e.get(N);if(Z.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.directionalShadow[m]=ie,i.directionalShadowMap[m]=le,i.directionalShadowMatrix[m]=N.shadow.matrix,C++}i.directional[m]=Z,m++}else if(N.isSpotLight){let Z=e.get(N);Z.position.setFromMatrixPosition(N.matrixWorld),Z.color.copy(G).multiplyScalar($),Z.distance=H,Z.coneCos=Math.cos(N.angle),Z.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),Z.decay=N.decay,i.spot[y]=Z;let Q=N.shadow;if(N.map&&(i.spotLightMap[E]=N.map,E++,Q.updateMatrices(N),N.castShadow&&U++),i.spotLightMatrix[y]=Q.matrix,N.castShadow){let ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.spotShadow[y]=ie,i.spotShadowMap[y]=le,x++}y++}else if(N.isRectAreaLight){let Z=e.get(N);Z.color.copy(G).multiplyScalar($),Z.halfWidth.set(N.width*.5,0,0),Z.halfHeight.set(0,N.height*.5,0),i.rectArea[A]=Z,A++}else if(N.isPointLight){let Z=e.get(N);if(Z.color.copy(N.color).multiplyScalar(N.intensity),Z.distance=N.distance,Z.decay=N.decay,N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,i.pointShadow[p]=ie,i.pointShadowMap[p]=le,i.pointShadowMatrix[p]=N.shadow.matrix,R++}i.point[p]=Z,p++}else if(N.isHemisphereLight){let Z=e.get(N);Z.skyColor.copy(N.color).multiplyScalar($),Z.groundColor.copy(N.groundColor).multiplyScalar($),i.hemi[S]=Z,S++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let L=i.hash;(L.sunLength!==f||L.directionalLength!==m||L.pointLength!==p||L.spotLength!==y||L.rectAreaLength!==A||L.hemiLength!==S||L.numSunShadows!==g||L.numDirectionalShadows!==C||L.numPointShadows!==R||L.numSpotShadows!==x||L.numSpotMaps!==E||L.numLightProbes!==D)&&(i.sun.length=f,i.directional.length=m,i.spot.length=y,i.rectArea.length=A,i.point.length=p,i.hemi.length=S,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=v,i.sunShadowCascade.length=v,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=R,i.pointShadowMap.length=R,i.pointShadowMatrix.length=R,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+E-U,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=D,L.sunLength=f,L.directionalLength=m,L.pointLength=p,L.spotLength=y,L.rectAreaLength=A,L.hemiLength=S,L.numSunShadows=g,L.numDirectionalShadows=C,L.numPointShadows=R,L.numSpotShadows=x,L.numSpotMaps=E,L.numLightProbes=D,i.version=fT++)}function l(c,u){let h=0,d=0,f=0,g=0,v=0,m=0,p=u.matrixWorldInverse;for(let y=0,A=c.length;y<A;y++){let S=c[y];if(S.isSunLight){let C=i.sun[h];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(p),h++}else if(S.isDirectionalLight){let C=i.directional[d];C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),d++}else if(S.isSpotLight){let C=i.spot[g];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(p),C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),g++}else if(S.isRectAreaLight){let C=i.rectArea[v];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(p),o.identity(),r.copy(S.matrixWorld),r.premultiply(p),o.extractRotation(r),C.halfWidth.set(S.width*.5,0,0),C.halfHeight.set(0,S.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),v++}else if(S.isPointLight){let C=i.point[f];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(p),f++}else if(S.isHemisphereLight){let C=i.hemi[m];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(p),m++}}}return{setup:a,setupView:l,state:i}}function S_(n){let e=new mT(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function gT(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new S_(n),e.set(s,[a])):r>=o.length?(a=new S_(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var _T=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,xT=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,vT=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],yT=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],M_=new vt,Wa=new X,Pf=new X;function bT(n,e,t){let i=new Rs,s=new _t,r=new _t,o=new $t,a=new Cc,l=new Pc,c={},u=t.maxTextureSize,h={[Ii]:Bn,[Bn]:Ii,[zn]:zn},d=new Pi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new _t},radius:{value:4}},vertexShader:_T,fragmentShader:xT}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new Fn;g.setAttribute("position",new Zt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Nt(g,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Na;let p=this.type;this.render=function(R,x,E){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||R.length===0)return;this.type===x0&&($e("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Na);let U=n.getRenderTarget(),D=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),k=n.state;k.setBlending(Mr),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let z=p!==this.type;z&&x.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(G=>G.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,G=R.length;N<G;N++){let $=R[N],H=$.shadow;if(H===void 0){$e("WebGLShadowMap:",$,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let le=H.getFrameExtents();s.multiply(le),r.copy(H.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,H.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,H.mapSize.y=r.y));let Z=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=Z,H.map===null||z===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===Co){if($.isPointLight){$e("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new mi(s.x,s.y,{format:ir,type:Xi,minFilter:kn,magFilter:kn,generateMipmaps:!1}),H.map.texture.name=$.name+".shadowMap",H.map.depthTexture=new Cs(s.x,s.y,Wi),H.map.depthTexture.name=$.name+".shadowMapDepth",H.map.depthTexture.format=As,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=bn,H.map.depthTexture.magFilter=bn}else $.isPointLight?(H.map=new qa(s.x),H.map.depthTexture=new Ca(s.x,Gi)):(H.map=new mi(s.x,s.y),H.map.depthTexture=new Cs(s.x,s.y,Gi)),H.map.depthTexture.name=$.name+".shadowMap",H.map.depthTexture.format=As,this.type===Na?(H.map.depthTexture.compareFunction=Z?vf:xf,H.map.depthTexture.minFilter=kn,H.map.depthTexture.magFilter=kn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=bn,H.map.depthTexture.magFilter=bn);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();$.isPointLight!==!0&&H.updateMatrices($,E);let ie=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:E.layers;for(let de=0;de<Q;de++){let he=H.getCamera(de);if($.isPointLight){let ee=H.camera,me=H.matrix,ge=$.distance||ee.far;ge!==ee.far&&(ee.far=ge,ee.updateProjectionMatrix()),Wa.setFromMatrixPosition($.matrixWorld),ee.position.copy(Wa),Pf.copy(ee.position),Pf.add(vT[de]),ee.up.copy(yT[de]),ee.lookAt(Pf),ee.updateMatrixWorld(),me.makeTranslation(-Wa.x,-Wa.y,-Wa.z),M_.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),H._frustum.setFromProjectionMatrix(M_,ee.coordinateSystem,ee.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,de),n.clear();else{de===0&&(n.setRenderTarget(H.map),n.clear());let ee=H.getViewport(de);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),k.viewport(o)}i=H.getFrustum(de),S(x,E,he,$,ie,this.type)}H.isPointLightShadow!==!0&&this.type===Co&&y(H,E),H.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(U,D,L)};function y(R,x){let E=e.update(v);d.defines.VSM_SAMPLES!==R.blurSamples&&(d.defines.VSM_SAMPLES=R.blurSamples,f.defines.VSM_SAMPLES=R.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),R.mapPass===null?R.mapPass=new mi(s.x,s.y,{format:ir,type:Xi}):(R.mapPass.width!==R.map.width||R.mapPass.height!==R.map.height)&&R.mapPass.setSize(R.map.width,R.map.height),d.uniforms.shadow_pass.value=R.map.depthTexture,d.uniforms.resolution.value.set(R.map.width,R.map.height),d.uniforms.radius.value=R.radius,n.setRenderTarget(R.mapPass),n.clear(),n.renderBufferDirect(x,null,E,d,v,null),f.uniforms.shadow_pass.value=R.mapPass.texture,f.uniforms.resolution.value.set(R.map.width,R.map.height),f.uniforms.radius.value=R.radius,n.setRenderTarget(R.map),n.clear(),n.renderBufferDirect(x,null,E,f,v,null)}function A(R,x,E,U){let D=null,L=E.isPointLight===!0?R.customDistanceMaterial:R.customDepthMaterial;if(L!==void 0)D=L;else if(D=E.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let k=D.uuid,z=x.uuid,N=c[k];N===void 0&&(N={},c[k]=N);let G=N[z];G===void 0&&(G=D.clone(),N[z]=G,x.addEventListener("dispose",C)),D=G}if(D.visible=x.visible,D.wireframe=x.wireframe,U===Co?D.side=x.shadowSide!==null?x.shadowSide:x.side:D.side=x.shadowSide!==null?x.shadowSide:h[x.side],D.alphaMap=x.alphaMap,D.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,D.map=x.map,D.clipShadows=x.clipShadows,D.clippingPlanes=x.clippingPlanes,D.clipIntersection=x.clipIntersection,D.displacementMap=x.displacementMap,D.displacementScale=x.displacementScale,D.displacementBias=x.displacementBias,D.wireframeLinewidth=x.wireframeLinewidth,D.linewidth=x.linewidth,E.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let k=n.properties.get(D);k.light=E}return D}function S(R,x,E,U,D,L){if(R.visible===!1)return;if(R.layers.test(D)&&(R.isMesh||R.isLine||R.isPoints)&&(R.castShadow||R.receiveShadow&&L===Co)&&(!R.frustumCulled||R.intersectsFrustum(i))){R.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,R.matrixWorld);let N=e.update(R),G=R.material;if(Array.isArray(G)){let $=N.groups;for(let H=0,le=$.length;H<le;H++){let Z=$[H],Q=G[Z.materialIndex];if(Q&&Q.visible){let ie=A(R,Q,U,L);R.onBeforeShadow(n,R,x,E,N,ie,Z),n.renderBufferDirect(E,null,N,ie,R,Z),R.onAfterShadow(n,R,x,E,N,ie,Z)}}}else if(G.visible){let $=A(R,G,U,L);R.onBeforeShadow(n,R,x,E,N,$,null),n.renderBufferDirect(E,null,N,$,R,null),R.onAfterShadow(n,R,x,E,N,$,null)}}let z=R.children;for(let N=0,G=z.length;N<G;N++)S(z[N],x,E,U,D,L)}function C(R){R.target.removeEventListener("dispose",C);for(let E in c){let U=c[E],D=R.target.uuid;D in U&&(U[D].dispose(),delete U[D])}}}function ST(n,e){function t(){let O=!1,re=new $t,ne=null,Ee=new $t(0,0,0,0);return{setMask:function(_e){ne!==_e&&!O&&(n.colorMask(_e,_e,_e,_e),ne=_e)},setLocked:function(_e){O=_e},setClear:function(_e,Se,Ge,Ze,ce){ce===!0&&(_e*=Ze,Se*=Ze,Ge*=Ze),re.set(_e,Se,Ge,Ze),Ee.equals(re)===!1&&(n.clearColor(_e,Se,Ge,Ze),Ee.copy(re))},reset:function(){O=!1,ne=null,Ee.set(-1,0,0,0)}}}function i(){let O=!1,re=!1,ne=null,Ee=null,_e=null;return{setReversed:function(Se){if(re!==Se){let Ge=e.get("EXT_clip_control");Se?Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.ZERO_TO_ONE_EXT):Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.NEGATIVE_ONE_TO_ONE_EXT),re=Se;let Ze=_e;_e=null,this.setClear(Ze)}},getReversed:function(){return re},setTest:function(Se){Se?ve(n.DEPTH_TEST):He(n.DEPTH_TEST)},setMask:function(Se){ne!==Se&&!O&&(n.depthMask(Se),ne=Se)},setFunc:function(Se){if(re&&(Se=K0[Se]),Ee!==Se){switch(Se){case dc:n.depthFunc(n.NEVER);break;case fc:n.depthFunc(n.ALWAYS);break;case pc:n.depthFunc(n.LESS);break;case _o:n.depthFunc(n.LEQUAL);break;case mc:n.depthFunc(n.EQUAL);break;case gc:n.depthFunc(n.GEQUAL);break;case xo:n.depthFunc(n.GREATER);break;case _c:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ee=Se}},setLocked:function(Se){O=Se},setClear:function(Se){_e!==Se&&(_e=Se,re&&(Se=1-Se),n.clearDepth(Se))},reset:function(){O=!1,ne=null,Ee=null,_e=null,re=!1}}}function s(){let O=!1,re=null,ne=null,Ee=null,_e=null,Se=null,Ge=null,Ze=null,ce=null;return{setTest:function(ke){O||(ke?ve(n.STENCIL_TEST):He(n.STENCIL_TEST))},setMask:function(ke){re!==ke&&!O&&(n.stencilMask(ke),re=ke)},setFunc:function(ke,Ke,Re){(ne!==ke||Ee!==Ke||_e!==Re)&&(n.stencilFunc(ke,Ke,Re),ne=ke,Ee=Ke,_e=Re)},setOp:function(ke,Ke,Re){(Se!==ke||Ge!==Ke||Ze!==Re)&&(n.stencilOp(ke,Ke,Re),Se=ke,Ge=Ke,Ze=Re)},setLocked:function(ke){O=ke},setClear:function(ke){ce!==ke&&(n.clearStencil(ke),ce=ke)},reset:function(){O=!1,re=null,ne=null,Ee=null,_e=null,Se=null,Ge=null,Ze=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,g=[],v=null,m=!1,p=null,y=null,A=null,S=null,C=null,R=null,x=null,E=new rt(0,0,0),U=0,D=!1,L=null,k=null,z=null,N=null,G=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,le=0,Z=n.getParameter(n.VERSION);Z.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(Z)[1]),H=le>=1):Z.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),H=le>=2);let Q=null,ie={},de=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),ee=new $t().fromArray(de),me=new $t().fromArray(he);function ge(O,re,ne,Ee){let _e=new Uint8Array(4),Se=n.createTexture();n.bindTexture(O,Se),n.texParameteri(O,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(O,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ge=0;Ge<ne;Ge++)O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,Ee,0,n.RGBA,n.UNSIGNED_BYTE,_e):n.texImage2D(re+Ge,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_e);return Se}let Me={};Me[n.TEXTURE_2D]=ge(n.TEXTURE_2D,n.TEXTURE_2D,1),Me[n.TEXTURE_CUBE_MAP]=ge(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Me[n.TEXTURE_2D_ARRAY]=ge(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Me[n.TEXTURE_3D]=ge(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ve(n.DEPTH_TEST),o.setFunc(_o),hn(!1),Pt(Xd),ve(n.CULL_FACE),Yt(Mr);function ve(O){u[O]!==!0&&(n.enable(O),u[O]=!0)}function He(O){u[O]!==!1&&(n.disable(O),u[O]=!1)}function Je(O,re){return d[O]!==re?(n.bindFramebuffer(O,re),d[O]=re,O===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=re),O===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Oe(O,re){let ne=g,Ee=!1;if(O){ne=f.get(re),ne===void 0&&(ne=[],f.set(re,ne));let _e=O.textures;if(ne.length!==_e.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,Ge=_e.length;Se<Ge;Se++)ne[Se]=n.COLOR_ATTACHMENT0+Se;ne.length=_e.length,Ee=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,Ee=!0);Ee&&n.drawBuffers(ne)}function ct(O){return v!==O?(n.useProgram(O),v=O,!0):!1}let ot={[wr]:n.FUNC_ADD,[y0]:n.FUNC_SUBTRACT,[b0]:n.FUNC_REVERSE_SUBTRACT};ot[S0]=n.MIN,ot[M0]=n.MAX;let tt={[w0]:n.ZERO,[E0]:n.ONE,[T0]:n.SRC_COLOR,[Jd]:n.SRC_ALPHA,[L0]:n.SRC_ALPHA_SATURATE,[P0]:n.DST_COLOR,[R0]:n.DST_ALPHA,[A0]:n.ONE_MINUS_SRC_COLOR,[Zd]:n.ONE_MINUS_SRC_ALPHA,[I0]:n.ONE_MINUS_DST_COLOR,[C0]:n.ONE_MINUS_DST_ALPHA,[D0]:n.CONSTANT_COLOR,[N0]:n.ONE_MINUS_CONSTANT_COLOR,[F0]:n.CONSTANT_ALPHA,[U0]:n.ONE_MINUS_CONSTANT_ALPHA};function Yt(O,re,ne,Ee,_e,Se,Ge,Ze,ce,ke){if(O===Mr){m===!0&&(He(n.BLEND),m=!1);return}if(m===!1&&(ve(n.BLEND),m=!0),O!==v0){if(O!==p||ke!==D){if((y!==wr||C!==wr)&&(n.blendEquation(n.FUNC_ADD),y=wr,C=wr),ke)switch(O){case Po:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case qd:n.blendFunc(n.ONE,n.ONE);break;case $d:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Yd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Qe("WebGLState: Invalid blending: ",O);break}else switch(O){case Po:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case qd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case $d:Qe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Yd:Qe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qe("WebGLState: Invalid blending: ",O);break}A=null,S=null,R=null,x=null,E.set(0,0,0),U=0,p=O,D=ke}return}_e=_e||re,Se=Se||ne,Ge=Ge||Ee,(re!==y||_e!==C)&&(n.blendEquationSeparate(ot[re],ot[_e]),y=re,C=_e),(ne!==A||Ee!==S||Se!==R||Ge!==x)&&(n.blendFuncSeparate(tt[ne],tt[Ee],tt[Se],tt[Ge]),A=ne,S=Ee,R=Se,x=Ge),(Ze.equals(E)===!1||ce!==U)&&(n.blendColor(Ze.r,Ze.g,Ze.b,ce),E.copy(Ze),U=ce),p=O,D=!1}function Bt(O,re){O.side===zn?He(n.CULL_FACE):ve(n.CULL_FACE);let ne=O.side===Bn;re&&(ne=!ne),hn(ne),O.blending===Po&&O.transparent===!1?Yt(Mr):Yt(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let Ee=O.stencilWrite;a.setTest(Ee),Ee&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),xt(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?ve(n.SAMPLE_ALPHA_TO_COVERAGE):He(n.SAMPLE_ALPHA_TO_COVERAGE)}function hn(O){L!==O&&(O?n.frontFace(n.CW):n.frontFace(n.CCW),L=O)}function Pt(O){O!==g0?(ve(n.CULL_FACE),O!==k&&(O===Xd?n.cullFace(n.BACK):O===_0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):He(n.CULL_FACE),k=O}function Cn(O){O!==z&&(H&&n.lineWidth(O),z=O)}function xt(O,re,ne){O?(ve(n.POLYGON_OFFSET_FILL),(N!==re||G!==ne)&&(N=re,G=ne,o.getReversed()&&(re=-re,ne=-ne),n.polygonOffset(re,ne))):He(n.POLYGON_OFFSET_FILL)}function Mn(O){O?ve(n.SCISSOR_TEST):He(n.SCISSOR_TEST)}function Qt(O){O===void 0&&(O=n.TEXTURE0+$-1),Q!==O&&(n.activeTexture(O),Q=O)}function dn(O,re,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+$-1:ne=Q);let Ee=ie[ne];Ee===void 0&&(Ee={type:void 0,texture:void 0},ie[ne]=Ee),(Ee.type!==O||Ee.texture!==re)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(O,re||Me[O]),Ee.type=O,Ee.texture=re)}function B(){let O=ie[Q];O!==void 0&&O.type!==void 0&&(n.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Ce(){try{n.compressedTexImage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function qe(){try{n.compressedTexImage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function it(){try{n.texSubImage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function we(){try{n.texSubImage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function Ft(){try{n.compressedTexSubImage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function Ve(){try{n.compressedTexSubImage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function Xe(){try{n.texStorage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function P(){try{n.texStorage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function M(){try{n.texImage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function q(){try{n.texImage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function ue(O){return h[O]!==void 0?h[O]:n.getParameter(O)}function oe(O,re){h[O]!==re&&(n.pixelStorei(O,re),h[O]=re)}function xe(O){ee.equals(O)===!1&&(n.scissor(O.x,O.y,O.z,O.w),ee.copy(O))}function ye(O){me.equals(O)===!1&&(n.viewport(O.x,O.y,O.z,O.w),me.copy(O))}function te(O,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let Ee=ne.get(O);Ee===void 0&&(Ee=n.getUniformBlockIndex(re,O.name),n.uniformBlockBinding(re,Ee,Ee),ne.set(O,Ee))}function se(O,re,ne){let _e=c.get(re).get(O);l[_e]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,_e,ne),l[_e]=ne)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Q=null,ie={},d={},l={},f=new WeakMap,g=[],v=null,m=!1,p=null,y=null,A=null,S=null,C=null,R=null,x=null,E=new rt(0,0,0),U=0,D=!1,L=null,k=null,z=null,N=null,G=null,ee.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ve,disable:He,bindFramebuffer:Je,drawBuffers:Oe,useProgram:ct,setBlending:Yt,setMaterial:Bt,setFlipSided:hn,setCullFace:Pt,setLineWidth:Cn,setPolygonOffset:xt,setScissorTest:Mn,activeTexture:Qt,bindTexture:dn,unbindTexture:B,compressedTexImage2D:Ce,compressedTexImage3D:qe,texImage2D:M,texImage3D:q,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:Xe,texStorage3D:P,texSubImage2D:it,texSubImage3D:we,compressedTexSubImage2D:Ft,compressedTexSubImage3D:Ve,scissor:xe,viewport:ye,reset:pe}}function MT(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new _t,u=new WeakMap,h=new Set,d,f=new WeakMap,g=new Set,v=new FinalizationRegistry(P=>g.delete(P)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(P,M){return m?new OffscreenCanvas(P,M):ya("canvas")}function y(P,M,q){let ue=1,oe=Xe(P);if((oe.width>q||oe.height>q)&&(ue=q/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let xe=Math.floor(ue*oe.width),ye=Math.floor(ue*oe.height);d===void 0&&(d=p(xe,ye));let te=M?p(xe,ye):d;return te.width=xe,te.height=ye,te.getContext("2d").drawImage(P,0,0,xe,ye),$e("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+xe+"x"+ye+")."),te}else return"data"in P&&$e("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),P;return P}function A(P){return P.generateMipmaps}function S(P){n.generateMipmap(P)}function C(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function R(P,M,q,ue,oe,xe=!1){if(P!==null){if(n[P]!==void 0)return n[P];$e("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||$e("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=M;if(M===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.R16_EXT),q===n.SHORT&&ye&&(te=ye.R16_SNORM_EXT)),M===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),M===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RG16_EXT),q===n.SHORT&&ye&&(te=ye.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),M===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),M===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),M===n.RGB&&(q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGB16_EXT),q===n.SHORT&&ye&&(te=ye.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),M===n.RGBA){let se=xe?xa:mt.getTransfer(oe);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=se===Et?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGBA16_EXT),q===n.SHORT&&ye&&(te=ye.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(P,M){let q;return P?M===null||M===Gi||M===Tr?q=n.DEPTH24_STENCIL8:M===Wi?q=n.DEPTH32F_STENCIL8:M===Lo&&(q=n.DEPTH24_STENCIL8,$e("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Gi||M===Tr?q=n.DEPTH_COMPONENT24:M===Wi?q=n.DEPTH_COMPONENT32F:M===Lo&&(q=n.DEPTH_COMPONENT16),q}function E(P,M){return A(P)===!0||P.isFramebufferTexture&&P.minFilter!==bn&&P.minFilter!==kn?Math.log2(Math.max(M.width,M.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?M.mipmaps.length:1}function U(P){let M=new WeakRef(P);i.get(P).__ref=M,g.add(M),v.register(P,M,M)}function D(P){let M=i.get(P).__ref;M!==void 0&&(g.delete(M),v.unregister(M))}function L(P){z(P.target)}function k(P){N(P.target)}function z(P){P.removeEventListener("dispose",L),D(P),$(P),P.isVideoTexture&&u.delete(P),P.isHTMLTexture&&h.delete(P)}function N(P){P.removeEventListener("dispose",k),D(P),le(P)}function G(){for(let P of g){let M=P.deref();M!==void 0&&(M.isRenderTarget===!0?N(M):z(M))}g.clear(),h.clear()}function $(P){let M=i.get(P);if(M.__webglInit===void 0)return;let q=P.source,ue=f.get(q);if(ue){let oe=ue[M.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&H(P),Object.keys(ue).length===0&&f.delete(q)}i.remove(P)}function H(P){let M=i.get(P);n.deleteTexture(M.__webglTexture);let q=P.source,ue=f.get(q);delete ue[M.__cacheKey],o.memory.textures--}function le(P){let M=i.get(P);M.__depthDisposeCallback&&M.__depthDisposeCallback();let q=P.depthTexture;if(q&&q.renderTarget===P&&z(q),P.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(M.__webglFramebuffer[oe]))for(let xe=0;xe<M.__webglFramebuffer[oe].length;xe++)n.deleteFramebuffer(M.__webglFramebuffer[oe][xe]);else n.deleteFramebuffer(M.__webglFramebuffer[oe]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[oe])}else{if(Array.isArray(M.__webglFramebuffer))for(let oe=0;oe<M.__webglFramebuffer.length;oe++)n.deleteFramebuffer(M.__webglFramebuffer[oe]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let oe=0;oe<M.__webglColorRenderbuffer.length;oe++)M.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[oe]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ue=P.textures;for(let oe=0,xe=ue.length;oe<xe;oe++){let ye=i.get(ue[oe]);ye.__webglTexture&&(n.deleteTexture(ye.__webglTexture),o.memory.textures--),i.remove(ue[oe])}i.remove(P)}let Z=0;function Q(){Z=0}function ie(){return Z}function de(P){Z=P}function he(){let P=Z;return P>=s.maxTextures&&$e("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,P}function ee(P){let M=[];return M.push(P.wrapS),M.push(P.wrapT),M.push(P.wrapR||0),M.push(P.magFilter),M.push(P.minFilter),M.push(P.anisotropy),M.push(P.internalFormat),M.push(P.format),M.push(P.type),M.push(P.generateMipmaps),M.push(P.mipmapsAutoUpdate),M.push(P.premultiplyAlpha),M.push(P.flipY),M.push(P.unpackAlignment),M.push(P.colorSpace),M.join()}function me(P,M){let q=i.get(P);if(P.isVideoTexture&&Ft(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&q.__version!==P.version){let ue=P.image;if(ue===null)$e("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)$e("WebGLRenderer: Texture marked for update but image is incomplete");else{Bt(q,P,M);return}}else P.isExternalTexture&&(q.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+M)}function ge(P,M){let q=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&q.__version!==P.version){Bt(q,P,M);return}else P.isExternalTexture&&(q.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+M)}function Me(P,M){let q=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&q.__version!==P.version){Bt(q,P,M);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+M)}function ve(P,M){let q=i.get(P);if(P.version>0&&q.__version!==P.version){hn(q,P,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+M)}let He={[xc]:n.REPEAT,[os]:n.CLAMP_TO_EDGE,[vc]:n.MIRRORED_REPEAT},Je={[bn]:n.NEAREST,[B0]:n.NEAREST_MIPMAP_NEAREST,[Fa]:n.NEAREST_MIPMAP_LINEAR,[kn]:n.LINEAR,[Wc]:n.LINEAR_MIPMAP_NEAREST,[Is]:n.LINEAR_MIPMAP_LINEAR},Oe={[H0]:n.NEVER,[yf]:n.ALWAYS,[G0]:n.LESS,[xf]:n.LEQUAL,[W0]:n.EQUAL,[vf]:n.GEQUAL,[X0]:n.GREATER,[q0]:n.NOTEQUAL};function ct(P,M){if(M.type===Wi&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===kn||M.magFilter===Wc||M.magFilter===Fa||M.magFilter===Is||M.minFilter===kn||M.minFilter===Wc||M.minFilter===Fa||M.minFilter===Is)&&$e("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,He[M.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,He[M.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,He[M.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,Je[M.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,Je[M.minFilter]),M.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,Oe[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===bn||M.minFilter!==Fa&&M.minFilter!==Is||M.type===Wi&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(P,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ot(P,M){let q=!1;P.__webglInit===void 0&&(P.__webglInit=!0,M.addEventListener("dispose",L),U(M));let ue=M.source,oe=f.get(ue);oe===void 0&&(oe={},f.set(ue,oe));let xe=ee(M);if(xe!==P.__cacheKey){oe[xe]===void 0&&(oe[xe]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[xe].usedTimes++;let ye=oe[P.__cacheKey];ye!==void 0&&(oe[P.__cacheKey].usedTimes--,ye.usedTimes===0&&H(M)),P.__cacheKey=xe,P.__webglTexture=oe[xe].texture}return q}function tt(P,M,q){return Math.floor(Math.floor(P/q)/M)}function Yt(P,M,q,ue){let xe=P.updateRanges;if(xe.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,q,ue,M.data);else{xe.sort((O,re)=>O.start-re.start);let ye=0;for(let O=1;O<xe.length;O++){let re=xe[ye],ne=xe[O],Ee=re.start+re.count,_e=tt(ne.start,M.width,4),Se=tt(re.start,M.width,4);ne.start<=Ee+1&&_e===Se&&tt(ne.start+ne.count-1,M.width,4)===_e?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++ye,xe[ye]=ne)}xe.length=ye+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),se=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let O=0,re=xe.length;O<re;O++){let ne=xe[O],Ee=Math.floor(ne.start/4),_e=Math.ceil(ne.count/4),Se=Ee%M.width,Ge=Math.floor(Ee/M.width),Ze=_e,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,Ge),t.texSubImage2D(n.TEXTURE_2D,0,Se,Ge,Ze,ce,q,ue,M.data)}P.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,se),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function Bt(P,M,q){let ue=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ue=n.TEXTURE_3D);let oe=ot(P,M),xe=M.source;t.bindTexture(ue,P.__webglTexture,n.TEXTURE0+q);let ye=i.get(xe);if(xe.version!==ye.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ce=mt.getPrimaries(mt.workingColorSpace),ke=M.colorSpace===Ds?null:mt.getPrimaries(M.colorSpace),Ke=M.colorSpace===Ds||ce===ke?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ke)}t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let se=y(M.image,!1,s.maxTextureSize);se=Ve(M,se);let pe=r.convert(M.format,M.colorSpace),O=r.convert(M.type),re=R(M.internalFormat,pe,O,M.normalized,M.colorSpace,M.isVideoTexture);ct(ue,M);let ne,Ee=M.mipmaps,_e=M.isVideoTexture!==!0,Se=ye.__version===void 0||oe===!0,Ge=xe.dataReady,Ze=E(M,se);if(M.isDepthTexture)re=x(M.format===Ls,M.type),Se&&(_e?t.texStorage2D(n.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,O,null));else if(M.isDataTexture)if(Ee.length>0){_e&&Se&&t.texStorage2D(n.TEXTURE_2D,Ze,re,Ee[0].width,Ee[0].height);for(let ce=0,ke=Ee.length;ce<ke;ce++)ne=Ee[ce],_e?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,O,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,O,ne.data);M.generateMipmaps=!1}else _e?(Se&&t.texStorage2D(n.TEXTURE_2D,Ze,re,se.width,se.height),Ge&&Yt(M,se,pe,O)):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,O,se.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){_e&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ze,re,Ee[0].width,Ee[0].height,se.depth);for(let ce=0,ke=Ee.length;ce<ke;ce++)if(ne=Ee[ce],M.format!==vi)if(pe!==null)if(_e){if(Ge)if(M.layerUpdates.size>0){let Ke=Rf(ne.width,ne.height,M.format,M.type);for(let Re of M.layerUpdates){let st=ne.data.subarray(Re*Ke/ne.data.BYTES_PER_ELEMENT,(Re+1)*Ke/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Re,ne.width,ne.height,1,pe,st)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,ne.data,0,0);else $e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?Ge&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,O,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,pe,O,ne.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{_e&&Se&&t.texStorage2D(n.TEXTURE_2D,Ze,re,Ee[0].width,Ee[0].height);for(let ce=0,ke=Ee.length;ce<ke;ce++)ne=Ee[ce],M.format!==vi?pe!==null?_e?Ge&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,O,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,O,ne.data)}else if(M.isDataArrayTexture)if(_e){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ze,re,se.width,se.height,se.depth),Ge)if(M.layerUpdates.size>0){let ce=Rf(se.width,se.height,M.format,M.type);for(let ke of M.layerUpdates){let Ke=se.data.subarray(ke*ce/se.data.BYTES_PER_ELEMENT,(ke+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ke,se.width,se.height,1,pe,O,Ke)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,pe,O,se.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,pe,O,se.data);else if(M.isData3DTexture)_e?(Se&&t.texStorage3D(n.TEXTURE_3D,Ze,re,se.width,se.height,se.depth),Ge&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,pe,O,se.data)):t.texImage3D(n.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,pe,O,se.data);else if(M.isFramebufferTexture){if(Se)if(_e)t.texStorage2D(n.TEXTURE_2D,Ze,re,se.width,se.height);else{let ce=se.width,ke=se.height;for(let Ke=0;Ke<Ze;Ke++)t.texImage2D(n.TEXTURE_2D,Ke,re,ce,ke,0,pe,O,null),ce>>=1,ke>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),h.add(M),ce.onpaint=ke=>{let Ke=ke.changedElements;for(let Re of h)Ke.includes(Re.image)&&(Re.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,se);else{let Ke=n.RGBA,Re=n.RGBA,st=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Ke,Re,st,se)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ee.length>0){if(_e&&Se){let ce=Xe(Ee[0]);t.texStorage2D(n.TEXTURE_2D,Ze,re,ce.width,ce.height)}for(let ce=0,ke=Ee.length;ce<ke;ce++)ne=Ee[ce],_e?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,pe,O,ne):t.texImage2D(n.TEXTURE_2D,ce,re,pe,O,ne);M.generateMipmaps=!1}else if(_e){if(Se){let ce=Xe(se);t.texStorage2D(n.TEXTURE_2D,Ze,re,ce.width,ce.height)}Ge&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,O,se)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,O,se);A(M)&&M.mipmapsAutoUpdate===!0&&S(ue),ye.__version=xe.version,M.onUpdate&&M.onUpdate(M)}P.__version=M.version}function hn(P,M,q){if(M.image.length!==6)return;let ue=ot(P,M),oe=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+q);let xe=i.get(oe);if(oe.version!==xe.__version||ue===!0){t.activeTexture(n.TEXTURE0+q);let ye=mt.getPrimaries(mt.workingColorSpace),te=M.colorSpace===Ds?null:mt.getPrimaries(M.colorSpace),se=M.colorSpace===Ds||ye===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let pe=M.isCompressedTexture||M.image[0].isCompressedTexture,O=M.image[0]&&M.image[0].isDataTexture,re=[];for(let Re=0;Re<6;Re++)!pe&&!O?re[Re]=y(M.image[Re],!0,s.maxCubemapSize):re[Re]=O?M.image[Re].image:M.image[Re],re[Re]=Ve(M,re[Re]);let ne=re[0],Ee=r.convert(M.format,M.colorSpace),_e=r.convert(M.type),Se=R(M.internalFormat,Ee,_e,M.normalized,M.colorSpace),Ge=M.isVideoTexture!==!0,Ze=xe.__version===void 0||ue===!0,ce=oe.dataReady,ke=E(M,ne);ct(n.TEXTURE_CUBE_MAP,M);let Ke;if(M.isDepthTexture){if(Se=x(M.format===Ls,M.type),Ze)if(Ge)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,ne.width,ne.height);else for(let Re=0;Re<6;Re++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,ne.width,ne.height,0,Ee,_e,null)}else if(pe){Ge&&Ze&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,Se,ne.width,ne.height);for(let Re=0;Re<6;Re++){Ke=re[Re].mipmaps;for(let st=0;st<Ke.length;st++){let Vt=Ke[st];M.format!==vi?Ee!==null?Ge?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st,0,0,Vt.width,Vt.height,Ee,Vt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st,Se,Vt.width,Vt.height,0,Vt.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st,0,0,Vt.width,Vt.height,Ee,_e,Vt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st,Se,Vt.width,Vt.height,0,Ee,_e,Vt.data)}}}else{if(Ke=M.mipmaps,Ge&&Ze){Ke.length>0&&ke++;let Re=Xe(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,Se,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(O){Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,re[Re].width,re[Re].height,Ee,_e,re[Re].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,re[Re].width,re[Re].height,0,Ee,_e,re[Re].data);for(let st=0;st<Ke.length;st++){let $n=Ke[st].image[Re].image;Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st+1,0,0,$n.width,$n.height,Ee,_e,$n.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st+1,Se,$n.width,$n.height,0,Ee,_e,$n.data)}}else{Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,Ee,_e,re[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,Ee,_e,re[Re]);for(let st=0;st<Ke.length;st++){let Vt=Ke[st];Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st+1,0,0,Ee,_e,Vt.image[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st+1,Se,Ee,_e,Vt.image[Re])}}}A(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),xe.__version=oe.version,M.onUpdate&&M.onUpdate(M)}P.__version=M.version}function Pt(P,M,q,ue,oe,xe){let ye=r.convert(q.format,q.colorSpace),te=r.convert(q.type),se=R(q.internalFormat,ye,te,q.normalized,q.colorSpace),pe=i.get(M),O=i.get(q);if(O.__renderTarget=M,!pe.__hasExternalTextures){let re=Math.max(1,M.width>>xe),ne=Math.max(1,M.height>>xe);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,xe,se,re,ne,M.depth,0,ye,te,null):t.texImage2D(oe,xe,se,re,ne,0,ye,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,P),we(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,oe,O.__webglTexture,0,it(M)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,oe,O.__webglTexture,xe),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Cn(P,M,q){if(n.bindRenderbuffer(n.RENDERBUFFER,P),M.depthBuffer){let ue=M.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,xe=x(M.stencilBuffer,oe),ye=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,it(M),xe,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,it(M),xe,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,xe,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ye,n.RENDERBUFFER,P)}else{let ue=M.textures;for(let oe=0;oe<ue.length;oe++){let xe=ue[oe],ye=r.convert(xe.format,xe.colorSpace),te=r.convert(xe.type),se=R(xe.internalFormat,ye,te,xe.normalized,xe.colorSpace);we(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,it(M),se,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,it(M),se,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,se,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function xt(P,M,q){let ue=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,P),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(M.depthTexture);oe.__renderTarget=M;let xe=ue?M.depthTexture.image[0]:M.depthTexture.image;(!oe.__webglTexture||xe.width!==M.width||xe.height!==M.height)&&(xe.width=M.width,xe.height=M.height,M.depthTexture.needsUpdate=!0),ue?ve(M.depthTexture,0):me(M.depthTexture,0);let ye=oe.__webglTexture,te=it(M),se=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,pe=M.depthTexture.format===Ls?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===As)we(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,ye,0);else if(M.depthTexture.format===Ls)we(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Mn(P){let M=i.get(P),q=P.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==P.depthTexture){let ue=P.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ue){let oe=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),M.__depthDisposeCallback=oe}M.__boundDepthTexture=ue}if(P.depthTexture&&!M.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)xt(M.__webglFramebuffer[ue],P,ue);else P.texture.mipmaps.length>0?xt(M.__webglFramebuffer[0],P,0):xt(M.__webglFramebuffer,P,0);else if(q){M.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ue]),M.__webglDepthbuffer[ue]===void 0)M.__webglDepthbuffer[ue]=n.createRenderbuffer(),Cn(M.__webglDepthbuffer[ue],P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=M.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,xe)}}else if(P.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),Cn(M.__webglDepthbuffer,P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,xe)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Qt(P,M,q){let ue=i.get(P);M!==void 0&&Pt(ue.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&Mn(P)}function dn(P){let M=P.texture,q=i.get(P),ue=i.get(M);P.addEventListener("dispose",k),U(P);let oe=P.textures,xe=P.isWebGLCubeRenderTarget===!0,ye=oe.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=M.version,o.memory.textures++),xe){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(M.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let se=0;se<M.mipmaps.length;se++)q.__webglFramebuffer[te][se]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(M.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<M.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ye)for(let te=0,se=oe.length;te<se;te++){let pe=i.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&we(P)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let se=oe[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let pe=r.convert(se.format,se.colorSpace),O=r.convert(se.type),re=R(se.internalFormat,pe,O,se.normalized,se.colorSpace,P.isXRRenderTarget===!0),ne=it(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),Cn(q.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xe){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),ct(n.TEXTURE_CUBE_MAP,M);for(let te=0;te<6;te++)if(M.mipmaps.length>0)for(let se=0;se<M.mipmaps.length;se++)Pt(q.__webglFramebuffer[te][se],P,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else Pt(q.__webglFramebuffer[te],P,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);A(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let te=0,se=oe.length;te<se;te++){let pe=oe[te],O=i.get(pe),re=n.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(re=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,O.__webglTexture),ct(re,pe),Pt(q.__webglFramebuffer,P,pe,n.COLOR_ATTACHMENT0+te,re,0),A(pe)&&S(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(te=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),ct(te,M),M.mipmaps.length>0)for(let se=0;se<M.mipmaps.length;se++)Pt(q.__webglFramebuffer[se],P,M,n.COLOR_ATTACHMENT0,te,se);else Pt(q.__webglFramebuffer,P,M,n.COLOR_ATTACHMENT0,te,0);A(M)?S(te):M.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}P.depthBuffer&&Mn(P)}function B(P){let M=P.textures;for(let q=0,ue=M.length;q<ue;q++){let oe=M[q];if(A(oe)&&oe.mipmapsAutoUpdate===!0){let xe=C(P),ye=i.get(oe).__webglTexture;t.bindTexture(xe,ye),S(xe),t.unbindTexture()}}}let Ce=[];function qe(P){if(P.samples>0){if(we(P)===!1){let M=P.textures,q=P.width,ue=P.height,oe=n.COLOR_BUFFER_BIT,xe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=i.get(P),te=M.length>1;if(te)for(let pe=0;pe<M.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let pe=0;pe<M.length;pe++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let O=i.get(M[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,O,0)}n.blitFramebuffer(0,0,q,ue,0,0,q,ue,oe,n.NEAREST),l===!0&&(Ce.length=0,Ce.push(n.COLOR_ATTACHMENT0+pe),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Ce.push(xe),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ce))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<M.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let O=i.get(M[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,O,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let M=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function it(P){return Math.min(s.maxSamples,P.samples)}function we(P){let M=i.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Ft(P){let M=o.render.frame;u.get(P)!==M&&(u.set(P,M),P.update())}function Ve(P,M){let q=P.colorSpace,ue=P.format,oe=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||q!==_a&&q!==Ds&&(mt.getTransfer(q)===Et?(ue!==vi||oe!==xi)&&$e("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qe("WebGLTextures: Unsupported texture color space:",q)),M}function Xe(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=de,this.setTexture2D=me,this.setTexture2DArray=ge,this.setTexture3D=Me,this.setTextureCube=ve,this.rebindTextures=Qt,this.setupRenderTarget=dn,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=qe,this.setupDepthRenderbuffer=Mn,this.setupFrameBufferTexture=Pt,this.useMultisampledRTT=we,this.dispose=G}function wT(n,e){function t(i,s=Ds){let r,o=mt.getTransfer(s);if(i===xi)return n.UNSIGNED_BYTE;if(i===qc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===$c)return n.UNSIGNED_SHORT_5_5_5_1;if(i===cf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===uf)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===af)return n.BYTE;if(i===lf)return n.SHORT;if(i===Lo)return n.UNSIGNED_SHORT;if(i===Xc)return n.INT;if(i===Gi)return n.UNSIGNED_INT;if(i===Wi)return n.FLOAT;if(i===Xi)return n.HALF_FLOAT;if(i===hf)return n.ALPHA;if(i===df)return n.RGB;if(i===vi)return n.RGBA;if(i===As)return n.DEPTH_COMPONENT;if(i===Ls)return n.DEPTH_STENCIL;if(i===ff)return n.RED;if(i===Yc)return n.RED_INTEGER;if(i===ir)return n.RG;if(i===Jc)return n.RG_INTEGER;if(i===Zc)return n.RGBA_INTEGER;if(i===Ua||i===Oa||i===ka||i===Ba)if(o===Et)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ua)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Oa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===ka)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ba)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ua)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Oa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===ka)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ba)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Kc||i===jc||i===Qc||i===eu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Kc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===jc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Qc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===eu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===tu||i===nu||i===iu||i===su||i===ru||i===za||i===ou)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===tu||i===nu)return o===Et?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===iu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===su)return r.COMPRESSED_R11_EAC;if(i===ru)return r.COMPRESSED_SIGNED_R11_EAC;if(i===za)return r.COMPRESSED_RG11_EAC;if(i===ou)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===au||i===lu||i===cu||i===uu||i===hu||i===du||i===fu||i===pu||i===mu||i===gu||i===_u||i===xu||i===vu||i===yu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===au)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===lu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===cu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===uu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===hu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===du)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===fu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===pu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===mu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===gu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===_u)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===xu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===vu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===yu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===bu||i===Su||i===Mu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===bu)return o===Et?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Su)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Mu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===wu||i===Eu||i===Va||i===Tu)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===wu)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Eu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Va)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Tu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Tr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var ET=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,TT=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Of=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Pa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Pi({vertexShader:ET,fragmentShader:TT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Nt(new Sr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},kf=class extends as{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,g=null,v=typeof XRWebGLBinding<"u",m=new Of,p={},y=t.getContextAttributes(),A=null,S=null,C=[],R=[],x=new _t,E=null,U=null,D=new ei;D.viewport=new $t;let L=new ei;L.viewport=new $t;let k=[D,L],z=new Vc,N=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=C[ee];return me===void 0&&(me=new bo,C[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=C[ee];return me===void 0&&(me=new bo,C[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=C[ee];return me===void 0&&(me=new bo,C[ee]=me),me.getHandSpace()};function $(ee){let me=R.indexOf(ee.inputSource);if(me===-1)return;let ge=C[me];ge!==void 0&&(ge.update(ee.inputSource,ee.frame,c||o),ge.dispatchEvent({type:ee.type,data:ee.inputSource}))}function H(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",le);for(let ee=0;ee<C.length;ee++){let me=R[ee];me!==null&&(R[ee]=null,C[ee].disconnect(me))}N=null,G=null,m.reset();for(let ee in p)delete p[ee];if(e.setRenderTarget(A),f=null,d=null,h=null,s=null,S=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(E),e.setSize(x.width,x.height,!1),U!==null){let ee=U.camera;ee.fov=U.fov,ee.zoom=U.zoom,ee.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&$e("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&$e("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&v&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",H),s.addEventListener("inputsourceschange",le),y.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(x),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,Me=null,ve=null;y.depth&&(ve=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=y.stencil?Ls:As,Me=y.stencil?Tr:Gi);let He={colorFormat:t.RGBA8,depthFormat:ve,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(He),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),S=new mi(d.textureWidth,d.textureHeight,{format:vi,type:xi,depthTexture:new Cs(d.textureWidth,d.textureHeight,Me,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ge={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new mi(f.framebufferWidth,f.framebufferHeight,{format:vi,type:xi,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function le(ee){for(let me=0;me<ee.removed.length;me++){let ge=ee.removed[me],Me=R.indexOf(ge);Me>=0&&(R[Me]=null,C[Me].disconnect(ge))}for(let me=0;me<ee.added.length;me++){let ge=ee.added[me],Me=R.indexOf(ge);if(Me===-1){for(let He=0;He<C.length;He++)if(He>=R.length){R.push(ge),Me=He;break}else if(R[He]===null){R[He]=ge,Me=He;break}if(Me===-1)break}let ve=C[Me];ve&&ve.connect(ge)}}function Z(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ge=ee.far;m.texture!==null&&(m.depthNear>0&&(me=m.depthNear),m.depthFar>0&&(ge=m.depthFar)),z.near=L.near=D.near=me,z.far=L.far=D.far=ge,(N!==z.near||G!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),N=z.near,G=z.far),z.layers.mask=ee.layers.mask|6,D.layers.mask=z.layers.mask&-5,L.layers.mask=z.layers.mask&-3;let Me=ee.parent,ve=z.cameras;Z(z,Me);for(let He=0;He<ve.length;He++)Z(ve[He],Me);z.projectionMatrix.copy(D.projectionMatrix),z.projectionMatrixInverse.copy(D.projectionMatrixInverse),U===null&&ee.isPerspectiveCamera&&(U={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,z,Me)};function Q(ee,me,ge){ge===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ge.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=bc*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(z)},this.getCameraTexture=function(ee){return p[ee]};let ie=null;function de(ee,me){if(u=me.getViewerPose(c||o),g=me,u!==null){let ge=u.views;f!==null&&(e.setRenderTargetFramebuffer(S,f.framebuffer),e.setRenderTarget(S));let Me=!1;ge.length!==z.cameras.length&&(z.cameras.length=0,Me=!0);for(let Oe=0;Oe<ge.length;Oe++){let ct=ge[Oe],ot=null;if(f!==null)ot=f.getViewport(ct);else{let Yt=h.getViewSubImage(d,ct);ot=Yt.viewport,Oe===0&&(e.setRenderTargetTextures(S,Yt.colorTexture,Yt.depthStencilTexture),e.setRenderTarget(S))}let tt=k[Oe];tt===void 0&&(tt=new ei,tt.layers.enable(Oe),tt.viewport=new $t,k[Oe]=tt),tt.matrix.fromArray(ct.transform.matrix),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.projectionMatrix.fromArray(ct.projectionMatrix),tt.projectionMatrixInverse.copy(tt.projectionMatrix).invert(),tt.viewport.set(ot.x,ot.y,ot.width,ot.height),Oe===0&&(z.matrix.copy(tt.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),Me===!0&&z.cameras.push(tt)}let ve=s.enabledFeatures;if(ve&&ve.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){h=i.getBinding();let Oe=h.getDepthInformation(ge[0]);Oe&&Oe.isValid&&Oe.texture&&m.init(Oe,s.renderState)}if(ve&&ve.includes("camera-access")&&v){e.state.unbindTexture(),h=i.getBinding();for(let Oe=0;Oe<ge.length;Oe++){let ct=ge[Oe].camera;if(ct){let ot=p[ct];ot||(ot=new Pa,p[ct]=ot);let tt=h.getCameraImage(ct);ot.sourceTexture=tt}}}}for(let ge=0;ge<C.length;ge++){let Me=R[ge],ve=C[ge];Me!==null&&ve!==void 0&&ve.update(Me,me,c||o)}ie&&ie(ee,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),g=null}let he=new w_;he.setAnimationLoop(de),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},AT=new vt,N_=new et;N_.set(-1,0,0,0,1,0,0,0,1);function RT(n,e){function t(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,Ef(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,y,A,S){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),h(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),d(m,p),p.isMeshPhysicalMaterial&&f(m,p,S)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),v(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,y,A):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,t(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Bn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,t(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Bn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,t(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,t(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let y=e.get(p),A=y.envMap,S=y.envMapRotation;A&&(m.envMap.value=A,m.envMapRotation.value.setFromMatrix4(AT.makeRotationFromEuler(S)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(N_),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,y,A){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*y,m.scale.value=A*.5,p.map&&(m.map.value=p.map,t(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function h(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function d(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,y){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Bn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function v(m,p){let y=e.get(p).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function CT(n,e,t,i){let s={},r={};function o(y,A){let S=A.program;i.uniformBlockBinding(y,S,s[y.id])}function a(y,A){let S=s[y.id];S===void 0&&(g(y),S=l(y),s[y.id]=S,y.addEventListener("dispose",m));let C=A.program;i.updateUBOMapping(y,C);let R=e.render.frame;r[y.id]!==R&&(c(y),r[y.id]=R)}function l(y){let A=n.createBuffer(),S=y.__size,C=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,S,C),n.bindBuffer(n.UNIFORM_BUFFER,null),A}function c(y){let A=s[y.id],S=y.uniforms,C=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let R=0,x=S.length;R<x;R++){let E=S[R];if(Array.isArray(E))for(let U=0,D=E.length;U<D;U++)u(E[U],R,U,C);else u(E,R,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(y,A,S,C){if(d(y,A,S,C)===!0){let R=y.__offset,x=y.value;if(Array.isArray(x)){let E=0;for(let U=0;U<x.length;U++){let D=x[U],L=v(D,!0);h(D,y.__data,E),E+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else h(x,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,R,y.__data)}}function h(y,A,S){typeof y=="number"||typeof y=="boolean"?A[S]=y:y.isMatrix3?(A[S]=y.elements[0],A[S+1]=y.elements[1],A[S+2]=y.elements[2],A[S+3]=0,A[S+4]=y.elements[3],A[S+5]=y.elements[4],A[S+6]=y.elements[5],A[S+7]=0,A[S+8]=y.elements[6],A[S+9]=y.elements[7],A[S+10]=y.elements[8],A[S+11]=0):ArrayBuffer.isView(y)?A.set(y.subarray(0,A.length-S),S):y.toArray(A,S)}function d(y,A,S,C){let R=y.value,x=A+"_"+S;if(Array.isArray(R)){C[x]===void 0&&(C[x]=[]);let E=C[x],U=!1;for(let D=0;D<R.length;D++)f(R[D],E,D)===!0&&(U=!0);return U}return f(R,C,x)}function f(y,A,S){if(A[S]===void 0)return typeof y=="number"||typeof y=="boolean"?A[S]=y:ArrayBuffer.isView(y)?A[S]=y.slice():A[S]=y.clone(),!0;{let C=A[S];if(typeof y=="number"||typeof y=="boolean"){if(C!==y)return A[S]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(C.equals(y)===!1)return C.copy(y),!0}}return!1}function g(y){let A=y.uniforms,S=0,C=16;for(let x=0,E=A.length;x<E;x++){let U=Array.isArray(A[x])?A[x]:[A[x]];for(let D=0,L=U.length;D<L;D++){let k=U[D],z=Array.isArray(k.value)?k.value:[k.value],N=Array.isArray(A[x])||Array.isArray(k.value),G=S;for(let H=0,le=z.length;H<le;H++){let Z=z[H],Q=v(Z,N),ie=S%C,de=ie%Q.boundary,he=ie+de;S+=de,he!==0&&C-he<Q.storage&&(S+=C-he),H===0&&(G=S),S+=Q.storage}let $=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new $((S-G)/Float32Array.BYTES_PER_ELEMENT),k.__offset=G}}let R=S%C;return R>0&&(S+=C-R),y.__size=S,y.__cache={},this}function v(y,A){let S={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(S.boundary=4,S.storage=4):y.isVector2?(S.boundary=8,S.storage=8):y.isVector3||y.isColor?(S.boundary=16,S.storage=12):y.isVector4?(S.boundary=16,S.storage=16):y.isMatrix3?(S.boundary=16,S.storage=48):y.isMatrix4?(S.boundary=16,S.storage=64):y.isTexture?$e("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(S.boundary=16,S.storage=y.byteLength):$e("WebGLRenderer: Unsupported uniform value type.",y),A===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function m(y){let A=y.target;A.removeEventListener("dispose",m),n.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function p(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:p}}var PT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),us=null;function IT(){return us===null&&(us=new So(PT,16,16,ir,Xi),us.name="DFG_LUT",us.minFilter=kn,us.magFilter=kn,us.wrapS=os,us.wrapT=os,us.generateMipmaps=!1,us.needsUpdate=!0),us}var Iu=class{constructor(e={}){let{canvas:t=Y0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=xi}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let v=f,m=new Set([Zc,Jc,Yc]),p=new Set([xi,Gi,Lo,Tr,qc,$c]),y=new Uint32Array(4),A=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},C=null,R=null,x=[],E=[],U=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=cs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,L=!1,k=null,z=null,N=null,G=null;this._outputColorSpace=Qn;let $=0,H=0,le=null,Z=-1,Q=null,ie=new $t,de=new $t,he=null,ee=new rt(0),me=0,ge=t.width,Me=t.height,ve=1,He=null,Je=null,Oe=new $t(0,0,ge,Me),ct=new $t(0,0,ge,Me),ot=!1,tt=new Rs,Yt=new Ec,Bt=!1,hn=!1,Pt=new vt,Cn=new X,xt=new $t,Mn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Qt=!1;function dn(){return le===null?ve:1}let B=i;function Ce(T,V){return t.getContext(T,V)}let qe,it,we,Ft,Ve,Xe,P,M,q,ue,oe,xe,ye,te,se,pe,O,re,ne,Ee,_e,Se,Ge;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",Ke,!1),t.addEventListener("webglcontextcreationerror",Re,!1),B===null){let V="webgl2";if(B=Ce(V,T),B===null)throw Ce(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ze()}catch(T){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",Ke,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),Qe("WebGLRenderer: "+T.message),T}function Ze(){qe=new H1(B),qe.init(),_e=new wT(B,qe),it=new I1(B,qe,e,_e),we=new ST(B,qe),it.reversedDepthBuffer&&d&&we.buffers.depth.setReversed(!0),z=B.createFramebuffer(),N=B.createFramebuffer(),G=B.createFramebuffer(),Ft=new X1(B),Ve=new lT,Xe=new MT(B,qe,we,Ve,it,_e,Ft),P=new V1(D),M=new $S(B),Se=new C1(B,M),q=new G1(B,M,Ft,Se),ue=new $1(B,q,M,Se,Ft),re=new q1(B,it,Xe),se=new L1(Ve),oe=new aT(D,P,qe,it,Se,se),xe=new RT(D,Ve),ye=new uT,te=new gT(qe),O=new R1(D,P,we,ue,g,l),pe=new bT(D,ue,it),Ge=new CT(B,Ft,it,we),ne=new P1(B,qe,Ft),Ee=new W1(B,qe,Ft),Ft.programs=oe.programs,D.capabilities=it,D.extensions=qe,D.properties=Ve,D.renderLists=ye,D.shadowMap=pe,D.state=we,D.info=Ft}v!==xi&&(U=new J1(v,t.width,t.height,a,s,r));let ce=new kf(D,B);this.xr=ce,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let T=qe.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=qe.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return ve},this.setPixelRatio=function(T){T!==void 0&&(ve=T,this.setSize(ge,Me,!1))},this.getSize=function(T){return T.set(ge,Me)},this.setSize=function(T,V,j=!0){if(ce.isPresenting){$e("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=T,Me=V,t.width=Math.floor(T*ve),t.height=Math.floor(V*ve),j===!0&&(t.style.width=T+"px",t.style.height=V+"px"),U!==null&&U.setSize(t.width,t.height),this.setViewport(0,0,T,V)},this.getDrawingBufferSize=function(T){return T.set(ge*ve,Me*ve).floor()},this.setDrawingBufferSize=function(T,V,j){ge=T,Me=V,ve=j,t.width=Math.floor(T*j),t.height=Math.floor(V*j),this.setViewport(0,0,T,V)},this.setEffects=function(T){if(v===xi){Qe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let V=0;V<T.length;V++)if(T[V].isOutputPass===!0){$e("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(ie)},this.getViewport=function(T){return T.copy(Oe)},this.setViewport=function(T,V,j,Y){T.isVector4?Oe.set(T.x,T.y,T.z,T.w):Oe.set(T,V,j,Y),we.viewport(ie.copy(Oe).multiplyScalar(dn()).round())},this.getScissor=function(T){return T.copy(ct)},this.setScissor=function(T,V,j,Y){T.isVector4?ct.set(T.x,T.y,T.z,T.w):ct.set(T,V,j,Y),we.scissor(de.copy(ct).multiplyScalar(dn()).round())},this.getScissorTest=function(){return ot},this.setScissorTest=function(T){we.setScissorTest(ot=T)},this.setOpaqueSort=function(T){He=T},this.setTransparentSort=function(T){Je=T},this.getClearColor=function(T){return T.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(T=!0,V=!0,j=!0){let Y=0;if(T){let J=!1;if(le!==null){let Te=le.texture.format;J=m.has(Te)}if(J){let Te=le.texture.type,Pe=p.has(Te),Ae=O.getClearColor(),Ie=O.getClearAlpha(),ze=Ae.r,je=Ae.g,ut=Ae.b;Pe?(y[0]=ze,y[1]=je,y[2]=ut,y[3]=Ie,B.clearBufferuiv(B.COLOR,0,y)):(A[0]=ze,A[1]=je,A[2]=ut,A[3]=Ie,B.clearBufferiv(B.COLOR,0,A))}else Y|=B.COLOR_BUFFER_BIT}V&&(Y|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&B.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),k=T},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",Ke,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),O.dispose(),ye.dispose(),te.dispose(),Xe.dispose(),Ve.dispose(),P.dispose(),ue.dispose(),q.dispose(),Se.dispose(),Ge.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",sl),ce.removeEventListener("sessionend",Yi),fs.stop()};function ke(T){T.preventDefault(),Mf("WebGLRenderer: Context Lost."),L=!0}function Ke(){Mf("WebGLRenderer: Context Restored."),L=!1;let T=Ft.autoReset,V=pe.enabled,j=pe.autoUpdate,Y=pe.needsUpdate,J=pe.type;Ze(),Ft.autoReset=T,pe.enabled=V,pe.autoUpdate=j,pe.needsUpdate=Y,pe.type=J}function Re(T){Qe("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function st(T){let V=T.target;V.removeEventListener("dispose",st),Vt(V)}function Vt(T){$n(T),Ve.remove(T)}function $n(T){let V=Ve.get(T).programs;V!==void 0&&(V.forEach(function(j){oe.releaseProgram(j)}),T.isShaderMaterial&&oe.releaseShaderCache(T))}this.renderBufferDirect=function(T,V,j,Y,J,Te){V===null&&(V=Mn);let Pe=J.isMesh&&J.matrixWorld.determinantAffine()<0,Ae=Xo(T,V,j,Y,J);we.setMaterial(Y,Pe);let Ie=j.index,ze=1;if(Y.wireframe===!0){if(Ie=q.getWireframeAttribute(j),Ie===void 0)return;ze=2}let je=j.drawRange,ut=j.attributes.position,Be=je.start*ze,ht=(je.start+je.count)*ze;Te!==null&&(Be=Math.max(Be,Te.start*ze),ht=Math.min(ht,(Te.start+Te.count)*ze)),Ie!==null?(Be=Math.max(Be,0),ht=Math.min(ht,Ie.count)):ut!=null&&(Be=Math.max(Be,0),ht=Math.min(ht,ut.count));let Kt=ht-Be;if(Kt<0||Kt===1/0)return;Se.setup(J,Y,Ae,j,Ie);let Tt,At=ne;if(Ie!==null&&(Tt=M.get(Ie),At=Ee,At.setIndex(Tt)),J.isMesh)Y.wireframe===!0?(we.setLineWidth(Y.wireframeLinewidth*dn()),At.setMode(B.LINES)):At.setMode(B.TRIANGLES);else if(J.isLine){let wn=Y.linewidth;wn===void 0&&(wn=1),we.setLineWidth(wn*dn()),J.isLineSegments?At.setMode(B.LINES):J.isLineLoop?At.setMode(B.LINE_LOOP):At.setMode(B.LINE_STRIP)}else J.isPoints?At.setMode(B.POINTS):J.isSprite&&At.setMode(B.TRIANGLES);if(J.isBatchedMesh)if(qe.get("WEBGL_multi_draw"))At.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let wn=J._multiDrawStarts,Fe=J._multiDrawCounts,fn=J._multiDrawCount,ft=Ie?M.get(Ie).bytesPerElement:1,ms=Ve.get(Y).currentProgram.getUniforms();for(let pn=0;pn<fn;pn++)ms.setValue(B,"_gl_DrawID",pn),At.render(wn[pn]/ft,Fe[pn])}else if(J.isInstancedMesh)At.renderInstances(Be,Kt,J.count);else if(j.isInstancedBufferGeometry){let wn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Fe=Math.min(j.instanceCount,wn);At.renderInstances(Be,Kt,Fe)}else At.render(Be,Kt)};function Ho(T,V,j,Y){k!==null&&T.isNodeMaterial&&k.setObject(Y,T),Bt===!0&&se.setState(T,j,!1),T.transparent===!0&&T.side===zn&&T.forceSinglePass===!1?(T.side=Bn,T.needsUpdate=!0,Ji(T,V,Y),T.side=Ii,T.needsUpdate=!0,Ji(T,V,Y),T.side=zn):Ji(T,V,Y)}this.compile=function(T,V,j=null){j===null&&(j=T),k!==null&&k.renderStart(T,V,j),R=te.get(j),R.init(V),E.push(R),j.traverseVisible(function(J){J.isLight&&J.layers.test(V.layers)&&(R.pushLight(J),J.castShadow&&R.pushShadow(J))}),T!==j&&T.traverseVisible(function(J){J.isLight&&J.layers.test(V.layers)&&(R.pushLight(J),J.castShadow&&R.pushShadow(J))}),R.setupLights(),k!==null&&k.updateLights(R.state.lightsArray),hn=this.localClippingEnabled,Bt=se.init(this.clippingPlanes,hn),Bt===!0&&se.setGlobalState(this.clippingPlanes,V),k!==null&&pe.render(R.state.shadowsArray,j,V);let Y=new Set;return T.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Te=J.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let Ae=Te[Pe];Ho(Ae,j,V,J),Y.add(Ae)}else Ho(Te,j,V,J),Y.add(Te)}),R=E.pop(),k!==null&&k.renderEnd(),Y},this.compileAsync=function(T,V,j=null){let Y=this.compile(T,V,j);return new Promise(J=>{function Te(){if(Y.forEach(function(Pe){let Ie=Ve.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&Y.delete(Pe)}),Y.size===0){J(T);return}setTimeout(Te,10)}qe.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let Ir=null;function ah(T){Ir&&Ir(T)}function sl(){fs.stop()}function Yi(){fs.start()}let fs=new w_;fs.setAnimationLoop(ah),typeof self<"u"&&fs.setContext(self),this.setAnimationLoop=function(T){Ir=T,ce.setAnimationLoop(T),T===null?fs.stop():fs.start()},ce.addEventListener("sessionstart",sl),ce.addEventListener("sessionend",Yi),this.render=function(T,V){if(V!==void 0&&V.isCamera!==!0){Qe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;k!==null&&k.renderStart(T,V);let j=ce.enabled===!0&&ce.isPresenting===!0,Y=U!==null&&(le===null||j)&&U.begin(D,le);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(V),V=ce.getCamera()),T.isScene===!0&&T.onBeforeRender(D,T,V,le),R=te.get(T,E.length),R.init(V),R.state.textureUnits=Xe.getTextureUnits(),E.push(R),Pt.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?Yt.setFromArrayCamera(V):tt.setFromProjectionMatrix(Pt,Ri,V.reversedDepth),hn=this.localClippingEnabled,Bt=se.init(this.clippingPlanes,hn),C=ye.get(T,x.length),C.init(),x.push(C),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Pe=D.xr.getDepthSensingMesh();Pe!==null&&ps(Pe,V,-1/0,D.sortObjects)}ps(T,V,0,D.sortObjects),C.finish(),k!==null&&k.updateLights(R.state.lightsArray),D.sortObjects===!0&&C.sort(He,Je),Qt=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,Qt&&O.addToRenderList(C,T),this.info.autoReset===!0&&this.info.reset(),Bt===!0&&se.beginShadows();let J=R.state.shadowsArray;if(pe.render(J,T,V),Bt===!0&&se.endShadows(),(Y&&U.hasRenderPass())===!1){let Pe=C.opaque,Ae=C.transmissive;if(R.setupLights(),V.isArrayCamera){let Ie=V.cameras;if(Ae.length>0)for(let ze=0,je=Ie.length;ze<je;ze++){let ut=Ie[ze];Di(Pe,Ae,T,ut)}Qt&&O.render(T);for(let ze=0,je=Ie.length;ze<je;ze++){let ut=Ie[ze];Go(C,T,ut,ut.viewport)}}else Ae.length>0&&Di(Pe,Ae,T,V),Qt&&O.render(T),Go(C,T,V)}le!==null&&H===0&&(Xe.updateMultisampleRenderTarget(le),Xe.updateRenderTargetMipmap(le)),Y&&U.end(D),T.isScene===!0&&T.onAfterRender(D,T,V),Se.resetDefaultState(),Z=-1,Q=null,E.pop(),E.length>0?(R=E[E.length-1],Xe.setTextureUnits(R.state.textureUnits),Bt===!0&&se.setGlobalState(D.clippingPlanes,R.state.camera)):R=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,k!==null&&k.renderEnd()};function ps(T,V,j,Y){if(T.visible===!1)return;if(T.layers.test(V.layers)){if(T.isGroup)j=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(V);else if(T.isLight)R.pushLight(T),T.castShadow&&R.pushShadow(T);else if(T.isSprite){let Pe=V.isArrayCamera?Yt:tt;if(!T.frustumCulled||T.intersectsFrustum(Pe)){Y&&xt.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Pt);let Ae=ue.update(T),Ie=T.material;Ie.visible&&C.push(T,Ae,Ie,j,xt.z,null,V)}}else if(T.isMesh||T.isLine||T.isPoints){let Pe=V.isArrayCamera?Yt:tt;if(!T.frustumCulled||T.intersectsFrustum(Pe)){let Ae=ue.update(T),Ie=T.material;if(Y&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),xt.copy(T.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),xt.copy(Ae.boundingSphere.center)),xt.applyMatrix4(T.matrixWorld).applyMatrix4(Pt)),Array.isArray(Ie)){let ze=Ae.groups;for(let je=0,ut=ze.length;je<ut;je++){let Be=ze[je],ht=Ie[Be.materialIndex];ht&&ht.visible&&C.push(T,Ae,ht,j,xt.z,Be,V)}}else Ie.visible&&C.push(T,Ae,Ie,j,xt.z,null,V)}}}let Te=T.children;for(let Pe=0,Ae=Te.length;Pe<Ae;Pe++)ps(Te[Pe],V,j,Y)}function Go(T,V,j,Y){let{opaque:J,transmissive:Te,transparent:Pe}=T;R.setupLightsView(j),Bt===!0&&se.setGlobalState(D.clippingPlanes,j),Y&&we.viewport(ie.copy(Y)),J.length>0&&en(J,V,j),Te.length>0&&en(Te,V,j),Pe.length>0&&en(Pe,V,j),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Di(T,V,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(R.state.transmissionRenderTarget[Y.id]===void 0){let Be=qe.has("EXT_color_buffer_half_float")||qe.has("EXT_color_buffer_float");R.state.transmissionRenderTarget[Y.id]=new mi(1,1,{generateMipmaps:!0,type:Be?Xi:xi,minFilter:Is,samples:Math.max(4,it.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:mt.workingColorSpace})}let Te=R.state.transmissionRenderTarget[Y.id],Pe=Y.viewport||ie;Te.setSize(Pe.z*D.transmissionResolutionScale,Pe.w*D.transmissionResolutionScale);let Ae=D.getRenderTarget(),Ie=D.getActiveCubeFace(),ze=D.getActiveMipmapLevel();D.setRenderTarget(Te),D.getClearColor(ee),me=D.getClearAlpha(),me<1&&D.setClearColor(16777215,.5),D.clear(),Qt&&O.render(j);let je=D.toneMapping;D.toneMapping=cs;let ut=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),R.setupLightsView(Y),Bt===!0&&se.setGlobalState(D.clippingPlanes,Y),en(T,j,Y),Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te),qe.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let ht=0,Kt=V.length;ht<Kt;ht++){let Tt=V[ht],{object:At,geometry:wn,material:Fe,group:fn}=Tt;if(Fe.side===zn&&At.layers.test(Y.layers)){let ft=Fe.side;Fe.side=Bn,Fe.needsUpdate=!0,on(At,j,Y,wn,Fe,fn),Fe.side=ft,Fe.needsUpdate=!0,Be=!0}}Be===!0&&(Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te))}D.setRenderTarget(Ae,Ie,ze),D.setClearColor(ee,me),ut!==void 0&&(Y.viewport=ut),D.toneMapping=je}function en(T,V,j){let Y=V.isScene===!0?V.overrideMaterial:null;for(let J=0,Te=T.length;J<Te;J++){let Pe=T[J],{object:Ae,geometry:Ie,group:ze}=Pe,je=Pe.material;je.allowOverride===!0&&Y!==null&&(je=Y),Ae.layers.test(j.layers)&&on(Ae,V,j,Ie,je,ze)}}function on(T,V,j,Y,J,Te){k!==null&&J.isNodeMaterial&&k.setObject(T,J),T.onBeforeRender(D,V,j,Y,J,Te),T.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),J.onBeforeRender(D,V,j,Y,T,Te),J.transparent===!0&&J.side===zn&&J.forceSinglePass===!1?(J.side=Bn,J.needsUpdate=!0,D.renderBufferDirect(j,V,Y,J,T,Te),J.side=Ii,J.needsUpdate=!0,D.renderBufferDirect(j,V,Y,J,T,Te),J.side=zn):D.renderBufferDirect(j,V,Y,J,T,Te),T.onAfterRender(D,V,j,Y,J,Te)}function an(T){let V=0;for(let j of T)j.texture!==null&&V++;return V}function Ji(T,V,j){V.isScene!==!0&&(V=Mn);let Y=Ve.get(T),J=R.state.lights,Te=R.state.shadowsArray,Pe=J.state.version,Ae=oe.getParameters(T,J.state,Te,V,j,R.state.lightProbeGridArray),Ie=oe.getProgramCacheKey(Ae),ze=Y.programs;Y.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?V.environment:null,Y.fog=V.fog;let je=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;Y.envMap=P.get(T.envMap||Y.environment,je),Y.envMapRotation=Y.environment!==null&&T.envMap===null?V.environmentRotation:T.envMapRotation,ze===void 0&&(T.addEventListener("dispose",st),ze=new Map,Y.programs=ze,Y.programVariants=new Map);let ut=ze.get(Ie);if(ut!==void 0){if(Y.currentProgram===ut&&Y.lightsStateVersion===Pe)return Wo(T,Ae),ut}else Ae.uniforms=oe.getUniforms(T),k!==null&&T.isNodeMaterial&&k.build(T,j,Ae),T.onBeforeCompile(Ae,D),ut=oe.acquireProgram(Ae,Ie),ze.set(Ie,ut),Y.uniforms=Ae.uniforms;let Be=Y.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Be.clippingPlanes=se.uniform),Wo(T,Ae),Y.needsLights=Us(T),Y.lightsStateVersion=Pe,Y.needsLights&&(Be.ambientLightColor.value=J.state.ambient,Be.lightProbe.value=J.state.probe,Be.sunLights.value=J.state.sun,Be.sunLightShadows.value=J.state.sunShadow,Be.directionalLights.value=J.state.directional,Be.directionalLightShadows.value=J.state.directionalShadow,Be.spotLights.value=J.state.spot,Be.spotLightShadows.value=J.state.spotShadow,Be.rectAreaLights.value=J.state.rectArea,Be.ltc_1.value=J.state.rectAreaLTC1,Be.ltc_2.value=J.state.rectAreaLTC2,Be.pointLights.value=J.state.point,Be.pointLightShadows.value=J.state.pointShadow,Be.hemisphereLights.value=J.state.hemi,Be.sunShadowMatrix.value=J.state.sunShadowMatrix,Be.sunShadowCascade.value=J.state.sunShadowCascade,Be.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Be.spotLightMatrix.value=J.state.spotLightMatrix,Be.spotLightMap.value=J.state.spotLightMap,Be.pointShadowMatrix.value=J.state.pointShadowMatrix),Y.numLightProbeGrids=an(R.state.lightProbeGridArray),Y.currentProgram=ut,Y.uniformsList=null,ut}function oi(T,V,j,Y,J){let Te=Ve.get(T),Pe=Te.currentProgram.id+","+Y+","+J,Ae=Te.programVariants.get(Pe);return Ae===void 0?(Ae=Ji(T,V,j),Te.programVariants.set(Pe,Ae)):(Te.currentProgram=Ae,Te.uniformsList=null,Te.outputColorSpace=Y,Te.toneMapping=J),Ae}function Fs(T){if(T.uniformsList===null){let V=T.currentProgram.getUniforms();T.uniformsList=Do.seqWithValue(V.seq,T.uniforms)}return T.uniformsList}function Wo(T,V){let j=Ve.get(T);j.outputColorSpace=V.outputColorSpace,j.batching=V.batching,j.batchingColor=V.batchingColor,j.instancing=V.instancing,j.instancingColor=V.instancingColor,j.instancingMorph=V.instancingMorph,j.skinning=V.skinning,j.morphTargets=V.morphTargets,j.morphNormals=V.morphNormals,j.morphColors=V.morphColors,j.morphTargetsCount=V.morphTargetsCount,j.numClippingPlanes=V.numClippingPlanes,j.numIntersection=V.numClipIntersection,j.vertexAlphas=V.vertexAlphas,j.vertexTangents=V.vertexTangents,j.toneMapping=V.toneMapping}function Xo(T,V,j,Y,J){V.isScene!==!0&&(V=Mn),Xe.resetTextureUnits();let Te=V.fog,Pe=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?V.environment:null,Ae=le===null?D.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:mt.workingColorSpace,Ie=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,ze=P.get(Y.envMap||Pe,Ie),je=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,ut=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Be=!!j.morphAttributes.position,ht=!!j.morphAttributes.normal,Kt=!!j.morphAttributes.color,Tt=cs;Y.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Tt=D.toneMapping);let At=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,wn=At!==void 0?At.length:0,Fe=Ve.get(Y),fn=R.state.lights;if(Bt===!0&&(hn===!0||T!==Q)){let Rt=T===Q&&Y.id===Z;se.setState(Y,T,Rt)}let ft=!1,ms=!1;Y.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==fn.state.version||J.isBatchedMesh&&Fe.batching===!1||!J.isBatchedMesh&&Fe.batching===!0||J.isBatchedMesh&&Fe.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&Fe.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&Fe.instancing===!1||!J.isInstancedMesh&&Fe.instancing===!0||J.isSkinnedMesh&&Fe.skinning===!1||!J.isSkinnedMesh&&Fe.skinning===!0||J.isInstancedMesh&&Fe.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Fe.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Fe.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Fe.instancingMorph===!1&&J.morphTexture!==null||Fe.envMap!==ze||Y.fog===!0&&Fe.fog!==Te||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==se.numPlanes||Fe.numIntersection!==se.numIntersection)||Fe.vertexAlphas!==je||Fe.vertexTangents!==ut||Fe.morphTargets!==Be||Fe.morphNormals!==ht||Fe.morphColors!==Kt||Fe.morphTargetsCount!==wn||Fe.numLightProbeGrids!==an(R.state.lightProbeGridArray)?ft=!0:(Fe.outputColorSpace!==Ae||Fe.toneMapping!==Tt)&&(ms=!0):(ft=!0,Fe.__version=Y.version);let pn=Fe.currentProgram;(ft===!0||ms===!0)&&(pn=ms===!0?oi(Y,V,J,Ae,Tt):Ji(Y,V,J),k&&Y.isNodeMaterial&&k.onUpdateProgram(Y,pn,Fe));let Nr=!1,Zi=!1,gs=!1,at=pn.getUniforms(),tn=Fe.uniforms;if(we.useProgram(pn.program)&&(Nr=!0,Zi=!0,gs=!0),Y.id!==Z&&(Z=Y.id,Zi=!0),Nr||Q!==T){we.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),at.setValue(B,"projectionMatrix",T.projectionMatrix),at.setValue(B,"viewMatrix",T.matrixWorldInverse);let mn=at.map.cameraPosition;mn!==void 0&&mn.setValue(B,Cn.setFromMatrixPosition(T.matrixWorld)),it.logarithmicDepthBuffer&&at.setValue(B,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&at.setValue(B,"isOrthographic",T.isOrthographicCamera===!0),Q!==T&&(Q=T,Zi=!0,gs=!0)}if(Fe.needsLights&&(fn.state.sunShadowMap.length>0&&at.setValue(B,"sunShadowMap",fn.state.sunShadowMap,Xe),fn.state.directionalShadowMap.length>0&&at.setValue(B,"directionalShadowMap",fn.state.directionalShadowMap,Xe),fn.state.spotShadowMap.length>0&&at.setValue(B,"spotShadowMap",fn.state.spotShadowMap,Xe),fn.state.pointShadowMap.length>0&&at.setValue(B,"pointShadowMap",fn.state.pointShadowMap,Xe)),J.isSkinnedMesh){at.setOptional(B,J,"bindMatrix"),at.setOptional(B,J,"bindMatrixInverse");let Rt=J.skeleton;Rt&&(Rt.boneTexture===null&&Rt.computeBoneTexture(),at.setValue(B,"boneTexture",Rt.boneTexture,Xe))}J.isBatchedMesh&&(at.setOptional(B,J,"batchingTexture"),at.setValue(B,"batchingTexture",J._matricesTexture,Xe),at.setOptional(B,J,"batchingIdTexture"),at.setValue(B,"batchingIdTexture",J._indirectTexture,Xe),at.setOptional(B,J,"batchingColorTexture"),J._colorsTexture!==null&&at.setValue(B,"batchingColorTexture",J._colorsTexture,Xe));let Yn=j.morphAttributes;if((Yn.position!==void 0||Yn.normal!==void 0||Yn.color!==void 0)&&re.update(J,j,pn),(Zi||Fe.receiveShadow!==J.receiveShadow)&&(Fe.receiveShadow=J.receiveShadow,at.setValue(B,"receiveShadow",J.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&V.environment!==null&&(tn.envMapIntensity.value=V.environmentIntensity),tn.dfgLUT!==void 0&&(tn.dfgLUT.value=IT()),Zi){if(at.setValue(B,"toneMappingExposure",D.toneMappingExposure),Fe.needsLights&&Lr(tn,gs),Te&&Y.fog===!0&&xe.refreshFogUniforms(tn,Te),xe.refreshMaterialUniforms(tn,Y,ve,Me,R.state.transmissionRenderTarget[T.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Rt=S,mn=0;for(let Gn of R.state.lightProbeGridArray)Gn.texture!==null&&(Rt.textures[mn]=Gn.texture,Rt.min[mn]=Gn.boundingBox.min,Rt.max[mn]=Gn.boundingBox.max,Rt.resolution[mn]=Gn.resolution,mn++);for(let Gn in Rt)Rt[Gn].length=mn;tn.probesSH.value=Rt.textures,tn.probesMin.value=Rt.min,tn.probesMax.value=Rt.max,tn.probesResolution.value=Rt.resolution}Do.upload(B,Fs(Fe),tn,Xe)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(Do.upload(B,Fs(Fe),tn,Xe),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&at.setValue(B,"center",J.center),at.setValue(B,"modelViewMatrix",J.modelViewMatrix),at.setValue(B,"normalMatrix",J.normalMatrix),at.setValue(B,"modelMatrix",J.matrixWorld),Y.uniformsGroups!==void 0){let Rt=Y.uniformsGroups;for(let mn=0,Gn=Rt.length;mn<Gn;mn++){let rl=Rt[mn];Ge.update(rl,pn),Ge.bind(rl,pn)}}return pn}function Lr(T,V){T.ambientLightColor.needsUpdate=V,T.lightProbe.needsUpdate=V,T.sunLights.needsUpdate=V,T.sunLightShadows.needsUpdate=V,T.directionalLights.needsUpdate=V,T.directionalLightShadows.needsUpdate=V,T.pointLights.needsUpdate=V,T.pointLightShadows.needsUpdate=V,T.spotLights.needsUpdate=V,T.spotLightShadows.needsUpdate=V,T.rectAreaLights.needsUpdate=V,T.hemisphereLights.needsUpdate=V}function Us(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(T,V,j){let Y=Ve.get(T);Y.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Ve.get(T.texture).__webglTexture=V,Ve.get(T.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,V){let j=Ve.get(T);j.__webglFramebuffer=V,j.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(T,V=0,j=0){le=T,$=V,H=j;let Y=null,J=!1,Te=!1;if(T){let Ae=Ve.get(T);if(Ae.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(B.FRAMEBUFFER,Ae.__webglFramebuffer),ie.copy(T.viewport),de.copy(T.scissor),he=T.scissorTest,we.viewport(ie),we.scissor(de),we.setScissorTest(he),Z=-1;return}else if(Ae.__webglFramebuffer===void 0)Xe.setupRenderTarget(T);else if(Ae.__hasExternalTextures)Xe.rebindTextures(T,Ve.get(T.texture).__webglTexture,Ve.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let je=T.depthTexture;if(Ae.__boundDepthTexture!==je){if(je!==null&&Ve.has(je)&&(T.width!==je.image.width||T.height!==je.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xe.setupDepthRenderbuffer(T)}}let Ie=T.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Te=!0);let ze=Ve.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(ze[V])?Y=ze[V][j]:Y=ze[V],J=!0):T.samples>0&&Xe.useMultisampledRTT(T)===!1?Y=Ve.get(T).__webglMultisampledFramebuffer:Array.isArray(ze)?Y=ze[j]:Y=ze,ie.copy(T.viewport),de.copy(T.scissor),he=T.scissorTest}else ie.copy(Oe).multiplyScalar(ve).floor(),de.copy(ct).multiplyScalar(ve).floor(),he=ot;if(j!==0&&(Y=z),we.bindFramebuffer(B.FRAMEBUFFER,Y)&&we.drawBuffers(T,Y),we.viewport(ie),we.scissor(de),we.setScissorTest(he),J){let Ae=Ve.get(T.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+V,Ae.__webglTexture,j)}else if(Te){let Ae=V;for(let Ie=0;Ie<T.textures.length;Ie++){let ze=Ve.get(T.textures[Ie]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ie,ze.__webglTexture,j,Ae)}}else if(T!==null&&j!==0){let Ae=Ve.get(T.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ae.__webglTexture,j)}Z=-1};function Dr(T){let V=Ve.get(T);return(V.__readFormat!==T.format||V.__readType!==T.type)&&(V.__readFormat=T.format,V.__readType=T.type,V.__formatReadable=it.textureFormatReadable(T.format),V.__typeReadable=it.textureTypeReadable(T.type)),V}this.readRenderTargetPixels=function(T,V,j,Y,J,Te,Pe,Ae=0){if(!(T&&T.isWebGLRenderTarget)){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=Ve.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){we.bindFramebuffer(B.FRAMEBUFFER,Ie);try{let ze=T.textures[Ae],je=ze.format,ut=ze.type;T.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ae);let Be=Dr(ze);if(Be.__formatReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=T.width-Y&&j>=0&&j<=T.height-J&&B.readPixels(V,j,Y,J,_e.convert(je),_e.convert(ut),Te)}finally{let ze=le!==null?Ve.get(le).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(T,V,j,Y,J,Te,Pe,Ae=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=Ve.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(V>=0&&V<=T.width-Y&&j>=0&&j<=T.height-J){we.bindFramebuffer(B.FRAMEBUFFER,Ie);let ze=T.textures[Ae],je=ze.format,ut=ze.type;T.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ae);let Be=Dr(ze);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ht=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,ht),B.bufferData(B.PIXEL_PACK_BUFFER,Te.byteLength,B.STREAM_READ),B.readPixels(V,j,Y,J,_e.convert(je),_e.convert(ut),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let Kt=le!==null?Ve.get(le).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,Kt);let Tt=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await Z0(B,Tt,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,ht),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Te),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(ht),B.deleteSync(Tt),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,V=null,j=0){let Y=Math.pow(2,-j),J=Math.floor(T.image.width*Y),Te=Math.floor(T.image.height*Y),Pe=V!==null?V.x:0,Ae=V!==null?V.y:0;Xe.setTexture2D(T,0),B.copyTexSubImage2D(B.TEXTURE_2D,j,0,0,Pe,Ae,J,Te),we.unbindTexture()},this.copyTextureToTexture=function(T,V,j=null,Y=null,J=0,Te=0){let Pe,Ae,Ie,ze,je,ut,Be,ht,Kt,Tt=T.isCompressedTexture?T.mipmaps[Te]:T.image;if(j!==null)Pe=j.max.x-j.min.x,Ae=j.max.y-j.min.y,Ie=j.isBox3?j.max.z-j.min.z:1,ze=j.min.x,je=j.min.y,ut=j.isBox3?j.min.z:0;else{let at=Math.pow(2,-J);Pe=Math.floor(Tt.width*at),Ae=Math.floor(Tt.height*at),T.isDataArrayTexture?Ie=Tt.depth:T.isData3DTexture?Ie=Math.floor(Tt.depth*at):Ie=1,ze=0,je=0,ut=0}Y!==null?(Be=Y.x,ht=Y.y,Kt=Y.z):(Be=0,ht=0,Kt=0);let At=_e.convert(V.format),wn=_e.convert(V.type),Fe;V.isData3DTexture?(Xe.setTexture3D(V,0),Fe=B.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(Xe.setTexture2DArray(V,0),Fe=B.TEXTURE_2D_ARRAY):(Xe.setTexture2D(V,0),Fe=B.TEXTURE_2D),we.activeTexture(B.TEXTURE0),we.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,V.flipY),we.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),we.pixelStorei(B.UNPACK_ALIGNMENT,V.unpackAlignment);let fn=we.getParameter(B.UNPACK_ROW_LENGTH),ft=we.getParameter(B.UNPACK_IMAGE_HEIGHT),ms=we.getParameter(B.UNPACK_SKIP_PIXELS),pn=we.getParameter(B.UNPACK_SKIP_ROWS),Nr=we.getParameter(B.UNPACK_SKIP_IMAGES);we.pixelStorei(B.UNPACK_ROW_LENGTH,Tt.width),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Tt.height),we.pixelStorei(B.UNPACK_SKIP_PIXELS,ze),we.pixelStorei(B.UNPACK_SKIP_ROWS,je),we.pixelStorei(B.UNPACK_SKIP_IMAGES,ut);let Zi=T.isDataArrayTexture||T.isData3DTexture,gs=V.isDataArrayTexture||V.isData3DTexture;if(T.isDepthTexture){let at=Ve.get(T),tn=Ve.get(V),Yn=Ve.get(at.__renderTarget),Rt=Ve.get(tn.__renderTarget);we.bindFramebuffer(B.READ_FRAMEBUFFER,Yn.__webglFramebuffer),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,Rt.__webglFramebuffer);for(let mn=0;mn<Ie;mn++)Zi&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ve.get(T).__webglTexture,J,ut+mn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ve.get(V).__webglTexture,Te,Kt+mn)),B.blitFramebuffer(ze,je,ze+Pe,je+Ae,Be,ht,Be+Pe,ht+Ae,B.DEPTH_BUFFER_BIT,B.NEAREST);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(J!==0||T.isRenderTargetTexture||Ve.has(T)){let at=Ve.get(T),tn=Ve.get(V);we.bindFramebuffer(B.READ_FRAMEBUFFER,N),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,G);for(let Yn=0;Yn<Ie;Yn++)Zi?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,at.__webglTexture,J,ut+Yn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,at.__webglTexture,J),gs?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,tn.__webglTexture,Te,Kt+Yn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,tn.__webglTexture,Te),J!==0?B.blitFramebuffer(ze,je,ze+Pe,je+Ae,Be,ht,Be+Pe,ht+Ae,B.COLOR_BUFFER_BIT,B.NEAREST):gs?B.copyTexSubImage3D(Fe,Te,Be,ht,Kt+Yn,ze,je,Pe,Ae):B.copyTexSubImage2D(Fe,Te,Be,ht,ze,je,Pe,Ae);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else gs?T.isDataTexture||T.isData3DTexture?B.texSubImage3D(Fe,Te,Be,ht,Kt,Pe,Ae,Ie,At,wn,Tt.data):V.isCompressedArrayTexture?B.compressedTexSubImage3D(Fe,Te,Be,ht,Kt,Pe,Ae,Ie,At,Tt.data):B.texSubImage3D(Fe,Te,Be,ht,Kt,Pe,Ae,Ie,At,wn,Tt):T.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Te,Be,ht,Pe,Ae,At,wn,Tt.data):T.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Te,Be,ht,Tt.width,Tt.height,At,Tt.data):B.texSubImage2D(B.TEXTURE_2D,Te,Be,ht,Pe,Ae,At,wn,Tt);we.pixelStorei(B.UNPACK_ROW_LENGTH,fn),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,ft),we.pixelStorei(B.UNPACK_SKIP_PIXELS,ms),we.pixelStorei(B.UNPACK_SKIP_ROWS,pn),we.pixelStorei(B.UNPACK_SKIP_IMAGES,Nr),Te===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&B.generateMipmap(Fe),we.unbindTexture()},this.initRenderTarget=function(T){Ve.get(T).__webglFramebuffer===void 0&&Xe.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Xe.setTextureCube(T,0):T.isData3DTexture?Xe.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Xe.setTexture2DArray(T,0):Xe.setTexture2D(T,0),we.unbindTexture()},this.resetState=function(){$=0,H=0,le=null,we.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ri}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=mt._getDrawingBufferColorSpace(e),t.unpackColorSpace=mt._getUnpackColorSpace()}};var Bf=1e30,LT="1e20",DT=`
#ifdef COPIES
attribute vec2 copyRotation;
#endif
#ifdef DEFORMED
attribute vec3 displacement;
uniform float deformation;
#endif
#ifdef FIELD
attribute float field;
varying float vField;
#endif
#ifdef LIT
varying vec3 vNormal;
varying vec3 vEye;
#endif
#ifdef CUT
uniform vec4 cutPlane;
varying float vCut;
#endif
uniform float bias;

void main() {
  vec3 p = position;
  #ifdef COPIES
  p = vec3(copyRotation.x * p.x - copyRotation.y * p.y, copyRotation.y * p.x + copyRotation.x * p.y, p.z);
  #endif
  #ifdef DEFORMED
  // Displacements are in coordinates of the part, not of copy 0.
  p += deformation * displacement;
  #endif
  vec4 world = modelMatrix * vec4(p, 1.0);
  #ifdef CUT
  vCut = dot(cutPlane.xyz, world.xyz) + cutPlane.w;
  #endif
  vec4 eye = viewMatrix * world;
  #ifdef LIT
  vec3 n = normal;
  #ifdef COPIES
  n = vec3(copyRotation.x * n.x - copyRotation.y * n.y, copyRotation.y * n.x + copyRotation.x * n.y, n.z);
  #endif
  vNormal = normalMatrix * n;
  vEye = isOrthographic ? vec3(0.0, 0.0, 1.0) : -eye.xyz;
  #endif
  #ifdef FIELD
  vField = field;
  #endif
  // Moves the point towards the eye, so that it appears in front of the surface below it.
  eye.xyz += bias * (isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(-eye.xyz));
  gl_Position = projectionMatrix * eye;
}
`,NT=`
uniform vec3 colour;
uniform float opacity;
#ifdef FIELD
uniform bool useField;
uniform sampler2D scale;
uniform vec2 limits;
uniform vec3 noValue;
varying float vField;
#endif
#ifdef LIT
varying vec3 vNormal;
varying vec3 vEye;
#endif
#ifdef CUT
varying float vCut;
#endif
#ifdef CAP
uniform float pixelRatio;
#endif

void main() {
  #ifdef CUT
  if (vCut > 0.0) discard;
  #endif
  vec3 base = colour;
  float gloss = 1.0;
  #ifdef FIELD
  if (useField) {
    gloss = 0.0;
    float fraction = (vField - limits.x) / max(limits.y - limits.x, 1e-30);
    base = vField > ${LT} ? noValue : texture2D(scale, vec2(clamp(fraction, 0.0, 1.0) * 0.99609375 + 0.001953125, 0.5)).rgb;
  }
  #endif
  #ifdef LIT
  vec3 n = normalize(vNormal);
  if (!gl_FrontFacing) n = -n;
  vec3 toEye = normalize(vEye);
  // The lights are fixed to the camera: a soft sky, a key light from the upper left, and a fill light.
  float sky = 0.5 + 0.5 * n.y;
  float key = max(dot(n, vec3(-0.387, 0.560, 0.733)), 0.0);
  float fill = max(dot(n, vec3(0.707, -0.141, 0.693)), 0.0);
  vec3 ambient = mix(vec3(0.36, 0.36, 0.38), vec3(0.58, 0.60, 0.63), sky);
  vec3 light = ambient + vec3(0.62, 0.61, 0.59) * key + vec3(0.13, 0.14, 0.16) * fill;
  // Colours of a field must match the legend: less contrast, and no gloss.
  light = mix(vec3(0.55) + 0.45 * light, light, gloss);
  vec3 halfway = normalize(toEye + vec3(-0.387, 0.560, 0.733));
  float gleam = pow(max(dot(n, halfway), 0.0), 38.0);
  float rim = pow(1.0 - max(dot(n, toEye), 0.0), 3.0);
  base = base * light * (1.0 - 0.22 * rim) + gloss * 0.13 * gleam;
  #endif
  #ifdef CAP
  // Hatching at 45 degrees, as in a sectional drawing.
  float stripe = abs(fract((gl_FragCoord.x + gl_FragCoord.y) / (9.0 * pixelRatio)) - 0.5) * 9.0;
  float hatch = mix(0.80, 1.0, smoothstep(0.35, 1.1, stripe));
  #ifdef FIELD
  if (useField) hatch = 1.0;
  #endif
  base *= hatch;
  #endif
  gl_FragColor = vec4(base, opacity);
  #include <colorspace_fragment>
}
`,qi=class extends Pi{cuttable;constructor(e,t,i={},s){super({vertexShader:DT,fragmentShader:NT,defines:Object.fromEntries(t.map(r=>[r,""])),...i}),this.uniforms={cutPlane:e.cutPlane,deformation:e.deformation,limits:e.limits,scale:e.scale,noValue:e.noValue,pixelRatio:e.pixelRatio,colour:s??{value:new rt},opacity:{value:1},useField:{value:!1},bias:{value:0}},this.cuttable=!t.includes("CAP")}get colour(){return this.uniforms.colour.value}set alpha(e){this.uniforms.opacity.value=e,this.transparent=e<1}set useField(e){this.uniforms.useField.value=e}set bias(e){this.uniforms.bias.value=e}set cut(e){!this.cuttable||e==="CUT"in this.defines||(e?this.defines.CUT="":delete this.defines.CUT,this.needsUpdate=!0)}};function F_(n){return{cutPlane:{value:new $t(0,0,1,0)},deformation:{value:0},limits:{value:new _t(0,1)},scale:{value:n},noValue:{value:new rt("#9a9a9a")},lineColour:{value:new rt("#1c2733")},edgeColour:{value:new rt("#1c2733")},pixelRatio:{value:1}}}function zf(n,e){let t=e?["DEFORMED"]:["COPIES"],i=(r,o)=>new qi(n,t,{side:r,colorWrite:!1,depthWrite:!1,depthTest:!1,stencilWrite:!0,stencilFunc:Au,stencilFail:o,stencilZFail:o,stencilZPass:o}),s=(r,o)=>{let a=new qi(n,t,{depthWrite:!1},r);return a.alpha=o,a};return{surface:new qi(n,e?["DEFORMED","FIELD","LIT"]:["COPIES","LIT"],{polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),features:s(n.lineColour,.55),edges:s(n.edgeColour,.3),stencilBack:i(Bn,mf),stencilFront:i(Ii,gf)}}function U_(n){return new qi(n,["CAP"],{side:zn,stencilWrite:!0,stencilRef:0,stencilFunc:_f,stencilFail:Ha,stencilZFail:Ha,stencilZPass:Ha})}var Nu=class{group=new un;materials;#e=new Fn;#t;#n=null;#i;constructor(e){let t=new qi(e,["FIELD"],{side:zn}),i=new qi(e,["FIELD"],{side:zn,depthFunc:xo,depthWrite:!1});i.alpha=.5,t.useField=i.useField=!0,this.#i=i,this.materials=[t,i];let s=this.materials.map(r=>new Nt(this.#e,r));for(let r of s)r.frustumCulled=!1,r.matrixAutoUpdate=!1,this.group.add(r);this.#t=s[1],this.#t.renderOrder=99999,s[0].renderOrder=5}setBias(e){for(let t of this.materials)t.bias=e;this.#i.bias=0}setBehind(e){this.#t.visible=e}get contacts(){return this.#n}set(e,t){if(this.#n=e,this.#e.dispose(),this.group.visible=e!==null,!e)return;let i=[];for(let a=0;a<e.count;a++)e.pressures[a]>0&&t(a)&&i.push(a);let s=new Float32Array(12*i.length),r=new Float32Array(4*i.length),o=new Uint32Array(6*i.length);i.forEach((a,l)=>{s.set(e.corners.subarray(12*a,12*a+12),12*l),r.fill(e.pressures[a],4*l,4*l+4);let c=4*l;o.set([c,c+1,c+2,c,c+2,c+3],6*l)}),this.#e.setAttribute("position",new Zt(s,3)),this.#e.setAttribute("field",new Zt(r,1)),this.#e.setIndex(new Zt(o,1))}dispose(){this.#e.dispose();for(let e of this.materials)e.dispose()}};function O_(n){let e=new Map,t=n.corners;for(let i=0;i<n.count;i++){let s=12*i,r=t[s+6]-t[s],o=t[s+7]-t[s+1],a=t[s+8]-t[s+2],l=t[s+9]-t[s+3],c=t[s+10]-t[s+4],u=t[s+11]-t[s+5],h=.5*Math.hypot(o*u-a*c,a*l-r*u,r*c-o*l),d=`${n.parts[2*i]} ${n.parts[2*i+1]}`;e.set(d,(e.get(d)??0)+n.pressures[i]*h)}return e}var Fu=class{constructor(e){this.core=e}core;playing=!1;#e=0;toggle(){this.playing?this.stop():this.start()}start(){let e=this.core.positions?.list.length??0;this.playing||e<2||(this.playing=!0,this.play(++this.#e),this.core.changed(!1))}stop(){this.playing&&(this.playing=!1,this.#e++,this.core.changed(!1))}step(e){this.stop();let t=this.next(e,!0);t!==null&&this.core.goTo(t)}next(e,t){let i=this.core.positions?.list.length??0;if(i===0)return null;let s=this.core.state.position+e;return s>=0&&s<i?s:t?(s+i)%i:null}async play(e){let{core:t}=this,i=t.positions?.list.length??0;for(!t.state.animation.loop&&t.state.position===i-1&&await t.goTo(0);e===this.#e;){let s=performance.now()+1e3/Math.max(.1,t.state.animation.speed),r=this.next(1,t.state.animation.loop);if(r===null)break;if(await t.positions?.load(r).catch(()=>null),await new Promise(o=>setTimeout(o,Math.max(0,s-performance.now()))),e!==this.#e)return;await t.goTo(r),await new Promise(requestAnimationFrame)}e===this.#e&&this.stop()}};var k_="CALYXARR";var Sn=class extends Error{constructor(t,i){super(`${t}: ${i}`);this.file=t;this.reason=i;this.name="FileError"}file;reason},Ya=class n{constructor(e,t,i,s){this.name=e;this.header=t;this.buffer=i;this.start=s}name;header;buffer;start;static parse(e,t){if(t.byteLength<16)throw new Sn(e,`the file is truncated: it has ${t.byteLength} bytes, the header needs 16`);let i=new DataView(t);if(new TextDecoder("latin1").decode(new Uint8Array(t,0,8))!==k_)throw new Sn(e,`not an array file: it does not begin with ${k_}`);let r=i.getUint32(8,!0);if(r!==1)throw new Sn(e,`version ${r} of the format is not supported; this viewer reads version 1`);let o=i.getUint32(12,!0),a=16+o;if(a>t.byteLength)throw new Sn(e,`the file is truncated: it has ${t.byteLength} bytes, the header ends at ${a}`);let l;try{l=JSON.parse(new TextDecoder("utf-8",{fatal:!0}).decode(new Uint8Array(t,16,o)))}catch{throw new Sn(e,"the header is not valid JSON")}if(typeof l!="object"||l===null||Array.isArray(l))throw new Sn(e,"the header is not a JSON object");return new n(e,l,t,a)}f32(e,t,i){let{offset:s,length:r}=this.locate(e,"f32",t,i);return new Float32Array(this.buffer,s,r)}f64(e,t,i){let{offset:s,length:r}=this.locate(e,"f64",t,i);return s%8===0?new Float64Array(this.buffer,s,r):new Float64Array(this.buffer.slice(s,s+8*r))}u32(e,t,i){let{offset:s,length:r}=this.locate(e,"u32",t,i);return new Uint32Array(this.buffer,s,r)}locate(e,t,i,s){let r=g=>{throw new Sn(this.name,`${s}: ${g}`)};if(typeof e!="object"||e===null)return r("the array is missing");let o=e;if(o.type!==t)return r(`the array has type ${String(o.type)}, expected ${t}`);if(o.components!==i)return r(`the array has ${String(o.components)} components, expected ${i}`);let{count:a,offset:l}=o,c=g=>Number.isSafeInteger(g)&&g>=0;if(!c(a)||!c(l))return r("the size or the offset of the array is not a whole number");let u=t==="f64"?8:4;if(l%u!==0)return r(`the offset ${l} is not aligned`);let h=a*i,d=this.start+l+h*u;if(d>this.buffer.byteLength)return r(`the file is truncated: it has ${this.buffer.byteLength} bytes, the array ends at ${d}`);let f=this.start+l;return f%u!==0?r("the header's length is not a multiple of 8"):{offset:f,length:h}}};var Uu=256,Vf={viridis:{label:"Viridis",colours:["#440154","#482475","#414487","#355f8d","#2a788e","#21918c","#22a884","#44bf70","#7ad151","#bddf26","#fde725"]},cividis:{label:"Cividis",colours:["#00224e","#123570","#3b496c","#575d6d","#707173","#8a8678","#a59c74","#c3b369","#e1cc55","#fee838"]},turbo:{label:"Turbo",colours:["#30123b","#4145ab","#4675ed","#39a2fc","#1bcfd4","#24eca6","#61fc6c","#a4fc3b","#d1e834","#f3c63a","#fe9b2d","#f36315","#d93806","#b11901","#7a0402"]},grey:{label:"Grey",colours:["#1a1a1a","#f2f2f2"]}},z_=Object.entries(Vf).map(([n,{label:e}])=>({name:n,label:e}));function B_(n){let e=parseInt(n.slice(1),16);return[e>>16&255,e>>8&255,e&255]}function Fo(n,e){let{colours:t}=Vf[n]??Vf.viridis,i=Math.min(Math.max(e,0),1)*(t.length-1),s=Math.min(Math.floor(i),t.length-2),r=B_(t[s]),o=B_(t[s+1]),a=i-s;return r.map((l,c)=>Math.round(l+a*(o[c]-l)))}function Ja(n,e){if(e<1)return n;let t=Math.min(Math.max(Math.floor(n*e),0),e-1);return e===1?.5:t/(e-1)}function Za([n,e,t]){return`rgb(${n} ${e} ${t})`}function V_(n,e,t){let i=n.image.data;for(let r=0;r<Uu;r++){let[o,a,l]=Fo(e,Ja(r/(Uu-1),t));i.set([o,a,l,255],4*r)}let s=t>0?bn:kn;n.minFilter=s,n.magFilter=s,n.needsUpdate=!0}function H_(){let n=new So(new Uint8Array(4*Uu),Uu,1,vi);return n.colorSpace=Qn,n}var G_=["#7f9db9","#c9a66b","#8fb09a","#b58a9b","#9a95bd","#b9b08a","#76a9ae","#c08f76"],FT={gear:G_,shaft:["#a9adb3","#b7b2aa","#9ea6ac"],bearing:["#8a8f98","#969089"],body:["#b4bcc4","#c0b9ae","#aab7b0"]};function W_(n,e){let t=FT[n]??G_;return t[e%t.length]}var X_={x:[1,0,0],y:[0,1,0],z:[0,0,1]},Ou=class{group=new un;capGeometry=new Sr(2,2);capMatrix=new vt;normal=new X(0,0,1);range=[-1,1];offset=0;#e;#t=new un;#n=new X;#i=1;#r=new X;constructor(){let e=[-1,-1,0,1,-1,0,1,1,0,-1,1,0],t=new Fn;t.setAttribute("position",new zt(e,3)),this.#e=new Aa(t,new Mo({color:"#e07b1f",transparent:!0,opacity:.8}));let i=new Qs({color:"#e07b1f",transparent:!0,depthTest:!1}),s=new br(.022,.05,20).rotateX(Math.PI/2),r=new Nt(s.clone().translate(0,0,.062),i),o=new Nt(s.clone().rotateY(Math.PI).translate(0,0,-.062),i),a=new Nt(new Ia(.021,20,14),i);this.#t.add(r,o,a);for(let l of this.#t.children)l.renderOrder=3e5;this.group.add(this.#e,this.#t),this.group.visible=!1}setBounds(e,t){this.#n.copy(e),this.#i=t}apply(e,t){let i=typeof e.normal=="string"?X_[e.normal]??X_.z:e.normal;this.normal.set(i[0],i[1],i[2]),this.normal.lengthSq()>0||this.normal.set(0,0,1),this.normal.normalize();let s=this.normal.dot(this.#n);this.range=[s-this.#i,s+this.#i],this.offset=e.offset??s;let r=e.flipped?-1:1;t.set(r*this.normal.x,r*this.normal.y,r*this.normal.z,-r*this.offset),this.group.visible=e.on;let o=this.#n.clone().addScaledVector(this.normal,this.offset-s),a=new Ci().setFromUnitVectors(new X(0,0,1),this.normal),l=1.02*this.#i;this.capMatrix.compose(o,a,new X(1.5*l,1.5*l,1)),this.#e.position.copy(o),this.#e.quaternion.copy(a),this.#e.scale.set(.86*l,.86*l,1),this.#t.quaternion.copy(a),this.#t.position.set(.86*l,.86*l,0).applyQuaternion(a).add(o),this.#t.scale.setScalar(l)}get handle(){return this.#t.position}setHighlight(e){for(let t of this.#t.children)t.material.color.set(e?"#ffa648":"#e07b1f")}drag(e,t,i,s,r){let o=.01*this.#i,a=this.#r.copy(this.handle).project(i),l=a.x,c=a.y,u=this.#r.copy(this.handle).addScaledVector(this.normal,o).project(i),h=(u.x-l)*s/2,d=-(u.y-c)*r/2,f=h*h+d*d;return f<.02?-t*o/2:(e*h+t*d)/f*o}};function UT(n,e,t,i,s,r){let o=Math.max(Math.abs(n),Math.abs(e),Math.abs(t),Math.abs(i),Math.abs(s),Math.abs(r));if(!Number.isFinite(o))return[NaN,NaN,NaN];if(o===0)return[0,0,0];let a=(n+e+t)/3,l=(n-e)/o,c=(e-t)/o,u=(t-n)/o,h=(l-u)/3,d=(c-l)/3,f=(u-c)/3,g=i/o,v=s/o,m=r/o,p=(l*l+c*c+u*u)/6+g*g+v*v+m*m;if(p===0)return[a,a,a];let y=h*(d*f-g*g)-m*(m*f-g*v)+v*(m*g-d*v),A=2*p/3,S=Math.SQRT2,C=h*h+m*m+v*v-A,R=d*d+m*m+g*g-A,x=f*f+g*g+v*v-A,E=S*(v*m-h*g),U=S*(g*m-d*v),D=S*(g*v-f*m),L=S*g,k=S*v,z=S*m,N=(h*R-d*C)**2+(h*x-f*C)**2+(d*x-f*R)**2+(h*E-L*C)**2+(h*U-k*C)**2+(h*D-z*C)**2+(d*E-L*R)**2+(d*U-k*R)**2+(d*D-z*R)**2+(f*E-L*x)**2+(f*U-k*x)**2+(f*D-z*x)**2+(L*U-k*E)**2+(L*D-z*E)**2+(k*D-z*U)**2,G=Math.atan2(Math.sqrt(3*N),Math.sqrt(27)*y)/3,$=2*Math.sqrt(p/3)*o,H=2*Math.PI/3;return[a+$*Math.cos(G),a+$*Math.cos(G-H),a+$*Math.cos(G+H)]}function OT(n,e,t,i,s,r){let o=n-e,a=e-t,l=t-n;return Math.sqrt(.5*(o*o+a*a+l*l)+3*(i*i+s*s+r*r))}function $i(n){return n!=="plain"&&n!=="contact_pressure"}var yi={plain:{label:"Plain",quantity:"none"},contact_pressure:{label:"Contact pressure",quantity:"stress"},max_principal:{label:"Maximum principal stress",quantity:"stress"},min_principal:{label:"Minimum principal stress",quantity:"stress"},von_mises:{label:"Von Mises stress",quantity:"stress"},displacement:{label:"Displacement",quantity:"length"}};function kT(n,e,t){if(e==="displacement"){let d=n.displacements;return Math.hypot(d[3*t],d[3*t+1],d[3*t+2])}let i=n.stresses,s=6*t,[r,o,a,l,c,u]=[i[s],i[s+1],i[s+2],i[s+3],i[s+4],i[s+5]];if(e==="von_mises")return OT(r,o,a,l,c,u);let h=UT(r,o,a,l,c,u);return e==="max_principal"?h[0]:h[2]}function q_(n){let e={min:1/0,max:-1/0,minIndex:-1,maxIndex:-1};for(let t=0;t<n.length;t++){let i=n[t];i<e.min&&i!==-1/0&&(e.min=i,e.minIndex=t),i>e.max&&i!==1/0&&(e.max=i,e.maxIndex=t)}return e.minIndex<0||e.maxIndex<0?null:e}function $_(n){let e=new Uint8Array(n.points.length/3);for(let t=0;t<n.triangles.length;t++)e[n.triangles[t]]=1;return e}function Y_(n,e){let t=n.points.length/3,i=new Float64Array(t);for(let s=0;s<t;s++)i[s]=kT(n,e,s);return i}var BT={Pa:[[1e6,"MPa",1e-6],[1e3,"kPa",.001],[0,"Pa",1]],m:[[1e-4,"mm",1e3],[1e-7,"µm",1e6],[0,"nm",1e9]],N:[[1e3,"kN",.001],[0,"N",1]],"N m":[[1e3,"kN m",.001],[0,"N m",1]],W:[[1e3,"kW",.001],[0,"W",1]],s:[[1,"s",1],[.001,"ms",1e3],[0,"µs",1e6]],rad:[[.1,"rad",1],[1e-4,"mrad",1e3],[0,"µrad",1e6]]},zT={Pa:[[0,"psi",1/6894.757293168361]],m:[[0,"inch",1/.0254]],N:[[0,"lbf",1/4.4482216152605]],"N m":[[0,"lbf inch",1/.1129848290276167]]},J_=!1;function Z_(n){J_=/^(inch|ft|foot)_/.test(n)}function Li(n,e){let t=n.replace("·"," "),i=(J_?zT[t]:void 0)??BT[t];if(!i)return{symbol:n==="1"?"":n,factor:1};let s=Math.abs(e);if(!(s>0))return{symbol:i[0][1],factor:i[0][2]};let r=i.find(([o])=>s>=o)??i[i.length-1];return{symbol:r[1],factor:r[2]}}function ku(){return Li("Pa",0)}var VT="−";function Vn(n,e=4){if(Number.isNaN(n))return"no value";if(n===0)return"0";let t=Math.abs(n),i;if(t>=1e6||t<1e-4)i=n.toExponential(e-1).replace("e+","e");else{let s=Math.max(0,e-1-Math.floor(Math.log10(t)));i=n.toFixed(Math.min(s,12)),i.includes(".")&&(i=i.replace(/\.?0+$/,""))}return i.replaceAll("-",VT)}function K_(n,e,t=4){if(!Number.isFinite(n))return"no value";let i=Li(e,n);return`${Vn(n*i.factor,t)} ${i.symbol}`.trim()}function j_(n){if(!(n>0)||!Number.isFinite(n))return n;let e=10**Math.floor(Math.log10(n)),t=n/e,i=t>=5?5:t>=2?2:1;return Number((i*e).toPrecision(3))}var Q_={bearing:"#2f6fb5",mesh:"#c2502b"},HT=new X(0,1,0),Bu=class{group=new un;labels=[];#e=new To(1,1,1,20).translate(0,.5,0);#t=new br(1,1,24).translate(0,.5,0);#n;#i=new Nt(new Fn,new Qs({transparent:!0}));constructor(e){let t=i=>{let s=new qi(e,["LIT"],{transparent:!0});return s.colour.set(i),s};this.#n={bearing:t(Q_.bearing),mesh:t(Q_.mesh)},this.#i.renderOrder=2e5,this.#i.frustumCulled=!1,this.#i.onBeforeRender=i=>i.clearDepth()}set(e,t){this.group.clear(),this.labels=[];let i=0;for(let{force:s}of e)i=Math.max(i,Math.hypot(...s));if(i>0){this.group.add(this.#i);for(let s of e){if(s.kind==="bearing"?!t.bearings:!t.meshes)continue;let r=Math.hypot(...s.force);if(!(r>0))continue;let o=t.scale*.5*t.radius*r/i,a=this.arrow(s,o,t.radius*.011);this.group.add(a);let l=new X(...s.force).multiplyScalar(o/r).add(new X(...s.point));if(t.labels){let c=s.kind==="mesh"?t.names[s.parts[0]??-1]:void 0,u=`${s.name?`${s.name}: `:""}${K_(r,"N",3)}${c?` on ${c}`:""}`;this.labels.push({text:u,point:l,kind:s.kind})}}}}arrow(e,t,i){let s=this.#n[e.kind],r=new un,o=Math.min(5.2*i,.45*t),a=new Nt(this.#e,s);a.scale.set(.55*i,t-o,.55*i);let l=new Nt(this.#t,s);l.scale.set(.33*o,o,.33*o),l.position.y=t-o,r.add(a,l),r.position.set(...e.point),r.quaternion.setFromUnitVectors(HT,new X(...e.force).normalize());for(let c of[a,l])c.renderOrder=200001;return r}dispose(){this.#e.dispose(),this.#t.dispose(),this.#i.geometry.dispose(),this.#i.material.dispose();for(let e of Object.values(this.#n))e.dispose()}};var Hf=[48,32,16,8],GT=1.6;function ex(n){let e=-1;return Hf.forEach((t,i)=>{n<=GT*t&&(e=i)}),e}function WT(n,e,t){let[i,s,r]=[Math.abs(n),Math.abs(e),Math.abs(t)];return i>=s&&i>=r?n>0?0:1:s>=r?e>0?2:3:t>0?4:5}function tx(n,e,t){let{nodes:i,normals:s,triangles:r,open:o}=e,a=XT(n),l=new Map,c=[],u=new Map,h=[],d=[],f=new Uint32Array(i.length);for(let p=0;p<i.length;p++){let y=3*i[p],[A,S,C]=[n[y],n[y+1],n[y+2]],R=o[i[p]]?`${qT(A,S,a)} ${Math.floor(Math.hypot(A,S)/t+1e-6)} ${Math.floor(C/t+1e-6)}`:`${Math.floor(A/t)},${Math.floor(S/t)},${Math.floor(C/t)}`,x=l.get(R);x===void 0&&(x=l.size,l.set(R,x),c.push(0,0,0,0)),c[4*x]+=A,c[4*x+1]+=S,c[4*x+2]+=C,c[4*x+3]+=1;let[E,U,D]=[s[3*p],s[3*p+1],s[3*p+2]],L=6*x+WT(E,U,D),k=u.get(L);k===void 0&&(k=u.size,u.set(L,k),h.push(x),d.push(0,0,0)),d[3*k]+=E,d[3*k+1]+=U,d[3*k+2]+=D,f[p]=k}let g=new Float32Array(3*h.length),v=new Float32Array(3*h.length);h.forEach((p,y)=>{let A=Math.hypot(d[3*y],d[3*y+1],d[3*y+2])||1;for(let S=0;S<3;S++)g[3*y+S]=c[4*p+S]/c[4*p+3],v[3*y+S]=d[3*y+S]/A});let m=[];for(let p=0;p<r.length;p+=3){let[y,A,S]=[f[r[p]],f[r[p+1]],f[r[p+2]]];h[y]===h[A]||h[A]===h[S]||h[S]===h[y]||m.push(y,A,S)}return{points:g,normals:v,triangles:Uint32Array.from(m)}}function XT(n){let e=0,t=0;for(let i=0;i<n.length;i+=3)e+=n[i],t+=n[i+1];return Math.atan2(t,e)}function qT(n,e,t){return Math.sin(Math.atan2(e,n)-t)>0?"l":"r"}function nx(n,e,t){let i={points:[],displacements:[]},s=a=>[0,1,2].map(l=>n.reduce((c,u)=>c+a[3*u+l],0)/Math.max(n.length,1)),r=s(e),o=t?s(t):[];for(let a=0;a<n.length;a+=2){for(let l of[n[a+1],n[a]])i.points.push(e[3*l],e[3*l+1],e[3*l+2]),t&&i.displacements.push(...t.subarray(3*l,3*l+3));i.points.push(...r),i.displacements.push(...o)}return i}function $T(n){let e=new Map,t=s=>{let r=s;for(let o=e.get(r);o!==void 0&&o!==r;o=e.get(r))r=o;return e.set(s,r),r};for(let s=0;s<n.length;s+=2)e.set(t(n[s]),t(n[s+1]));let i=new Map;for(let s=0;s<n.length;s+=2){let r=t(n[s]),o=i.get(r)??[];o.push(n[s],n[s+1]),i.set(r,o)}return[...i.values()]}function ix(n,e){return[e.stencilBack,e.stencilFront].map(t=>{let i=new Nt(n,t);return i.frustumCulled=!1,i.matrixAutoUpdate=!1,i})}function sx(n,e,t,i){let s=$T(n.openEdges).map(o=>nx(o,e,t)),r=new Ps;return r.setAttribute("position",new zt(s.flatMap(o=>o.points),3)),r.setAttribute("displacement",new zt(s.flatMap(o=>o.displacements),3)),r.instanceCount=s.length>0?1:0,{geometry:r,meshes:ix(r,i)}}var zu=class{constructor(e,t,i,s){this.copies=i;let r=0,o=0;for(let l=0;l<t.length;l+=3)r+=t[l],o+=t[l+1];let{openEdges:a}=e;this.#e=[1,-1].map(l=>{let c=[];for(let d=0;d<a.length;d+=2){let[f,g]=[3*a[d],3*a[d+1]],[v,m]=[t[f]+t[g],t[f+1]+t[g+1]];Math.sign(r*m-o*v)===l&&c.push(a[d],a[d+1])}let u=new Ps;u.setAttribute("position",new zt(nx(c,t).points,3));let h=new yr(new Float32Array(2*i),2);return u.setAttribute("copyRotation",h),u.instanceCount=0,{geometry:u,rotation:h,next:l}}),this.meshes=this.#e.flatMap(({geometry:l})=>ix(l,s))}copies;meshes;#e;set(e){for(let{geometry:t,rotation:i,next:s}of this.#e){let r=0;if(e.size>0){for(let o=0;o<this.copies;o++){if(e.has(o)||!e.has((o+s+this.copies)%this.copies))continue;let a=2*Math.PI*o/this.copies;i.setXY(r++,Math.cos(a),Math.sin(a))}i.needsUpdate=!0}t.instanceCount=r}}dispose(){for(let{geometry:e}of this.#e)e.dispose()}};var Gf=Math.cos(32*Math.PI/180),Uo=n=>n===2147483648?0:n;function YT(n){let e=n.length/3,t=new Uint32Array(n.buffer,n.byteOffset,n.length),i=1;for(;i<2*e;)i*=2;let s=new Uint32Array(i),r=new Uint32Array(e);for(let o=0;o<e;o++){let[a,l,c]=[Uo(t[3*o]),Uo(t[3*o+1]),Uo(t[3*o+2])],u=Math.imul(a,2654435761)^Math.imul(l,2246822507)^Math.imul(c,3266489909);for(u=(u^u>>>15)&i-1;;){let h=s[u];if(h===0){s[u]=o+1,r[o]=o;break}let d=3*(h-1);if(Uo(t[d])===a&&Uo(t[d+1])===l&&Uo(t[d+2])===c){r[o]=h-1;break}u=u+1&i-1}}return r}function JT(n,e){let t=new Uint32Array(e+1);for(let r=0;r<n.length;r++)t[n[r]+1]++;for(let r=0;r<e;r++)t[r+1]+=t[r];let i=t.slice(0,e),s=new Uint32Array(n.length);for(let r=0;r<n.length;r++)s[i[n[r]]++]=r;return{starts:t,corners:s}}function ZT(n,e){let t=new Float32Array(e.length);for(let i=0;i<e.length;i+=3){let s=3*e[i],r=3*e[i+1],o=3*e[i+2],a=n[r]-n[s],l=n[r+1]-n[s+1],c=n[r+2]-n[s+2],u=n[o]-n[s],h=n[o+1]-n[s+1],d=n[o+2]-n[s+2];t[i]=l*d-c*h,t[i+1]=c*u-a*d,t[i+2]=a*h-l*u}return t}function KT(n,e,t,i,s){for(let r=e[i];r<e[i+1];r++){let o=t[r],a=o-o%3;if(n[a+(o+1)%3]===s)return a}return-1}function jT(n,e,t){let i=new Map,s=[],r=0;for(let c=0;c<e.length;c++)e[c]&&(s.push(c),r=Math.max(r,Math.abs(n[3*c]),Math.abs(n[3*c+1]),Math.abs(n[3*c+2])));if(s.length===0||!(r>0))return i;let o=r*2e-5,a=(c,u,h)=>`${Math.round(c/o)},${Math.round(u/o)},${Math.round(h/o)}`,l=new Map;for(let c of s)l.set(a(n[3*c],n[3*c+1],n[3*c+2]),c);for(let c of[1,-1]){let u=c*2*Math.PI/t,h=Math.cos(u),d=Math.sin(u);for(let f of s){let g=h*n[3*f]-d*n[3*f+1],v=d*n[3*f]+h*n[3*f+1],m=n[3*f+2],p;for(let y=0;y<27&&p===void 0;y++){let A=(y%3-1)*o*.5,S=(Math.floor(y/3)%3-1)*o*.5,C=(Math.floor(y/9)-1)*o*.5;p=l.get(a(g+A,v+S,m+C))}p!==void 0&&i.set(f,[...i.get(f)??[],[p,-c]])}}return i}function Vu(n,e,t){let i=n.length/3,s=YT(n),r=e.map(v=>s[v]),{starts:o,corners:a}=JT(r,i),l=ZT(n,e),c=new Uint8Array(i),u=[],h=[];for(let v=0;v<e.length;v++){let m=v-v%3,p=r[v],y=r[m+(v+1)%3];if(p===y)continue;let A=KT(r,o,a,y,p);A<0?(c[p]=c[y]=1,h.push(p,y),t===1&&u.push(v)):m<A&&Wf(l,m,l,A)<Gf&&u.push(v)}let d=t>1?jT(n,c,t):new Map,f=QT(e,s,t,o,a,l,d),g=new Uint32Array(2*u.length);u.forEach((v,m)=>{let p=v-v%3;g[2*m]=f.triangles[v],g[2*m+1]=f.triangles[p+(v+1)%3]});for(let v=0;v<i;v++)c[v]=c[s[v]];return{...f,features:g,open:c,openEdges:Uint32Array.from(h)}}function Wf(n,e,t,i){let s=n[e]*t[i]+n[e+1]*t[i+1]+n[e+2]*t[i+2],r=Math.hypot(n[e],n[e+1],n[e+2])*Math.hypot(t[i],t[i+1],t[i+2]);return r>0?s/r:1}function QT(n,e,t,i,s,r,o){let a=e.length,l=[],c=[],u=new Uint32Array(a),h=new Uint32Array(n.length),d=2*Math.PI/t;for(let f=0;f<a;f++){let g=l.length;u[f]=g;let v=e[f],m=tA(v,o,i,s,r,d);for(let p=i[v];p<i[v+1];p++){let y=s[p];if(n[y]!==f)continue;let A=y-y%3,S=0,C=0,R=0;for(let U=i[v];U<i[v+1];U++){let D=s[U]-s[U]%3;D!==A&&Wf(r,A,r,D)<Gf||(S+=r[D],C+=r[D+1],R+=r[D+2])}for(let U=0;U<m.length;U+=3)Wf(r,A,m,U)<Gf||(S+=m[U],C+=m[U+1],R+=m[U+2]);let x=Math.hypot(S,C,R)||1;S/=x,C/=x,R/=x;let E=g;for(;E<l.length;){let U=3*E;if(c[U]*S+c[U+1]*C+c[U+2]*R>.99999)break;E++}E===l.length&&(l.push(f),c.push(S,C,R)),h[y]=E}l.length===g&&(l.push(f),c.push(0,0,1))}return{nodes:Uint32Array.from(l),firstVertex:u,normals:Float32Array.from(c),triangles:h}}var eA=[];function tA(n,e,t,i,s,r){let o=e.get(n);if(!o)return eA;let a=[];for(let[l,c]of o){let u=Math.cos(c*r),h=Math.sin(c*r);for(let d=t[l];d<t[l+1];d++){let f=i[d]-i[d]%3;a.push(u*s[f]-h*s[f+1],h*s[f]+u*s[f+1],s[f+2])}}return a}function rx(n,e){let t=new Float32Array(3*e.length);for(let i=0;i<e.length;i++){let s=3*e[i];t[3*i]=n[s],t[3*i+1]=n[s+1],t[3*i+2]=n[s+2]}return t}var Oo=class{constructor(e,t,i){this.input=e;let{surface:s,points:r}=e;this.#r=i??1,this.#s=s.nodes,this.triangleCount=s.triangles.length/3;let o=new Zt(rx(r,s.nodes),3),a={position:o};e.displacements&&(a.displacement=new Zt(rx(e.displacements,s.nodes),3),this.#o=new Zt(new Float32Array(s.nodes.length).fill(Bf),1),a.field=this.#o),this.box=new ri().setFromBufferAttribute(o),this.sphere=this.box.getBoundingSphere(new ti),i!==null&&(this.#u=i,this.#l=new yr(new Float32Array(2*i),2),this.#l.setUsage(bf),a.copyRotation=this.#l);let l=(f,g=!1)=>{let v=new Ps;for(let[m,p]of Object.entries(a))v.setAttribute(m,p);return g&&v.setAttribute("normal",new Zt(s.normals,3)),v.setIndex(new Zt(f,1)),v.instanceCount=i??1,v},c=Uint32Array.from(e.edges,f=>s.firstVertex[f]),u=l(s.triangles,!0),h=l(s.features),d=l(c);if(this.#e=[u,h,d],this.#t=u,this.surface=new Nt(u,t.surface),this.features=new wo(h,t.features),this.edges=new wo(d,t.edges),this.stencils=[new Nt(u,t.stencilBack),new Nt(u,t.stencilFront)],e.displacements){let f=sx(s,r,e.displacements,t);this.#e.push(f.geometry),this.closures=f.meshes}for(let f of[this.surface,this.features,this.edges,...this.stencils,...this.closures])f.frustumCulled=!1,f.matrixAutoUpdate=!1,this.group.add(f);this.group.matrixAutoUpdate=!1,i!==null&&this.setCopies(Array.from({length:i},(f,g)=>g),i)}input;group=new un;surface;features;edges;stencils;closures=[];triangleCount;sphere;box;#e;#t;#n=[];#i=-1;#r;#s;#o=null;#l=null;#u=1;setLevel(e){if(e===this.#i||!this.#l)return;this.#i=e;let t=e<0?this.#t:this.#n[e];if(!t){let i=2*this.sphere.radius/Hf[e],s=tx(this.input.points,this.input.surface,i);t=new Ps,t.setAttribute("position",new Zt(s.points,3)),t.setAttribute("normal",new Zt(s.normals,3)),t.setAttribute("copyRotation",this.#l),t.setIndex(new Zt(s.triangles,1)),this.#n[e]=t,this.#e.push(t)}t.instanceCount=this.#r;for(let i of[this.surface,...this.stencils])i.geometry=t}get drawnTriangles(){return this.surface.geometry.index.count/3}setCopies(e,t){let i=this.#l;if(!i)return;let s=i.array;for(let r=0;r<t;r++){let o=2*Math.PI*e[r]/this.#u;s[2*r]=Math.cos(o),s[2*r+1]=Math.sin(o)}i.clearUpdateRanges(),i.addUpdateRange(0,2*t),i.needsUpdate=!0,this.#r=t;for(let r of this.#e)r.instanceCount=t;this.group.visible=t>0}setField(e){if(!this.#o)return;let t=this.#o.array;for(let i=0;i<this.#s.length;i++){let s=e?e[this.#s[i]]:NaN;t[i]=Number.isFinite(s)?s:Bf}this.#o.needsUpdate=!0}dispose(){for(let e of this.#e)e.dispose()}};var nA=.28,ox=7,iA=6e4,Gu=class{constructor(e,t,i,s){this.part=e;this.#i=new rt(s),this.#r=new rt("#b4b9bf").lerp(this.#i,.4),this.#e=zf(t,!1),this.#t=zf(t,!0),this.#n=U_(t),this.surface=Vu(e.points,e.triangles,e.copies),this.copies=new Oo({...e,surface:this.surface},this.#e,e.copies),this.#s=Array.from({length:e.copies},(o,a)=>a),this.#l=new Uint32Array(e.copies);let r=0;for(let o=0;o<e.points.length;o+=3)r=Math.max(r,e.points[o]**2+e.points[o+1]**2+e.points[o+2]**2);this.radius=Math.sqrt(r),this.group.matrixAutoUpdate=!1,this.#o=new zu(this.surface,e.points,e.copies,this.#e),this.group.add(this.copies.group,...this.#o.meshes),this.cap=new Nt(i,this.#n),this.cap.frustumCulled=!1,this.cap.matrixAutoUpdate=!1,this.cap.onAfterRender=o=>o.clearStencil(),this.#g=e.index,this.refresh()}part;group=new un;cap;copies;surface;radius;meshes=[];visibility="visible";present=!0;#e;#t;#n;#i;#r;#s;#o;#l;#u=-1;#h=NaN;#c=!1;#d=!1;#a=!1;#g;get materials(){return[...Object.values(this.#e),...Object.values(this.#t),this.#n]}setMeshes(e,t){for(let i of this.meshes)this.group.remove(i.group);this.meshes=e;for(let i of e)this.group.add(i.group);this.#s=[];for(let i=0;i<this.part.copies;i++)t.has(i)||this.#s.push(i);this.#h=NaN,this.#o.set(t),this.refresh()}get meshMaterials(){return this.#t}get presentCopies(){return this.#s}setVisibility(e){this.visibility=e,this.refresh()}setFieldMode(e){this.#c=e,this.refresh()}setEdges(e){this.#d=e,this.refresh()}setCut(e){this.#a=e;for(let t of this.materials)t.cut=e;this.refresh()}setPresent(e){this.present=e,this.refresh()}refresh(){let e=this.visibility==="translucent",t=this.visibility!=="hidden"&&this.present;this.group.visible=t,this.cap.visible=t&&this.#a&&!this.part.open;let i=e?nA:1;for(let r of[this.#e,this.#t]){r.surface.alpha=i,r.surface.depthWrite=!e;let o=this.part.open||this.#a||this.meshes.length>0;r.surface.side=o&&!e?zn:Ii,r.surface.colour.copy(this.#c?this.#r:this.#i),r.features.alpha=e?.25:.5,r.edges.alpha=e?.12:.34,r.stencilBack.transparent=r.stencilFront.transparent=e}this.#t.surface.useField=this.#c,this.#n.alpha=e?.5:1,this.#n.depthWrite=!e,this.#n.colour.copy(this.#c?this.#r:this.#i).multiplyScalar(.86);let s=10+3*this.#g;this.cap.renderOrder=s+2;for(let r of[this.copies,...this.meshes]){r.edges.visible=this.#d,r.surface.renderOrder=e?1e5:0,r.features.renderOrder=r.edges.renderOrder=100001;for(let o of[r.stencils,r.closures])o.forEach((a,l)=>{a.visible=this.#a&&!this.part.open,a.renderOrder=s+l})}this.#o.meshes.forEach((r,o)=>{r.visible=this.#a&&this.meshes.length>0&&!this.part.open,r.renderOrder=s+o%2})}prepare(e,t){if(!this.group.visible)return 0;let{sphere:i}=this.copies,s=0,r=0,o=0,a=this.group.matrixWorld;Hu.radius=i.radius;for(let h of this.#s){let d=2*Math.PI*h/this.part.copies,f=Math.cos(d),g=Math.sin(d),{x:v,y:m,z:p}=i.center;Hu.center.set(f*v-g*m,g*v+f*m,p).applyMatrix4(a),e.intersectsSphere(Hu)&&(this.#l[s++]=h,r=(r*31+h+1)%4294967291,o=Math.max(o,i.radius*2*t(Hu.center)))}(s!==this.#u||r!==this.#h)&&(this.copies.setCopies(this.#l,s),this.#u=s,this.#h=r);let l=this.part.copies>1?2*Math.PI*this.radius/this.part.copies:2*i.radius,c=o*Math.min(l,2*i.radius)/(2*i.radius||1);this.copies.features.visible=c>ox,this.copies.edges.visible=this.#d&&c>2*ox,this.copies.setLevel(s*this.copies.triangleCount>iA?ex(o):-1);let u=s*this.copies.drawnTriangles;for(let h of this.meshes)u+=h.triangleCount;return u}dispose(){this.copies.dispose(),this.#o.dispose();for(let e of this.materials)e.dispose()}},Hu=new ti;function Wu(){return{version:1,camera:null,parts:{},colours:{field:"plain",scale:"viridis",bands:0,limits:"position",min:0,max:1},deformation:{mode:"automatic",factor:1},mesh_edges:!1,hidden_contacts:!0,extremes:!0,forces:{bearings:!1,meshes:!1,labels:!0,scale:1},cut:{on:!1,normal:"z",offset:null,flipped:!1},frame:null,position:0,animation:{speed:10,loop:!0},theme:"system",panels:{parts:!0,settings:!1,plots:!1},plotted:[]}}function Xu(n,e=Wu()){let t=structuredClone(e),i=n??{};for(let[s,r]of Object.entries(t)){let o=i[s];if(o===void 0||s==="version")continue;Xf(r)&&s!=="parts"&&s!=="camera"?Xf(o)&&(t[s]=sA(r,o)):s==="camera"?rA(o)&&(t[s]=o):s==="frame"?(o===null||typeof o=="string")&&(t[s]=o):typeof o==typeof r&&o!==null&&(t[s]=o)}return structuredClone(t)}function Xf(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)}function sA(n,e){let t={...n};for(let i of Object.keys(n)){let s=e[i];s!==void 0&&(i==="normal"||i==="offset"||typeof s==typeof n[i])&&(t[i]=s)}return t}function rA(n){return!Xf(n)||!Array.isArray(n.target)||n.target.length!==3?!1:[...n.target,n.azimuth,n.elevation,n.height].every(t=>typeof t=="number"&&Number.isFinite(t))&&(n.projection==="perspective"||n.projection==="orthographic")}function Ka(n,e){return n.parts[e.name]??(e.kind==="body"?"translucent":"visible")}var oA=.05,$u=class{constructor(e){this.scene=e;this.contacts=new Nu(e.uniforms),this.forces=new Bu(e.uniforms),e.root.add(this.contacts.group,this.forces.group),e.scene.add(this.cut.group)}scene;views=[];position=null;meshes=[];colours=[];factor=0;limits=null;triangles=0;cut=new Ou;contacts;forces;centre=new X;radius=1;#e=new WeakMap;#t=new WeakMap;#n=new WeakMap;#i=null;#r=new vt;#s=!1;setParts(e,t){this.clear();let i=new Map;this.#i=t?.poses??null,this.colours=e.map(({kind:r})=>{let o=i.get(r)??0;return i.set(r,o+1),W_(r,o)}),this.views=e.map((r,o)=>{let a=new Gu(r,this.scene.uniforms,this.cut.capGeometry,this.colours[o]);return this.scene.root.add(a.group),this.scene.scene.add(a.cap),a}),this.meshes=e.map(()=>[]);let s=new ri().setFromPoints(this.views.flatMap(r=>this.outline(r))).getBoundingSphere(new ti);this.centre.copy(s.center),this.radius=s.radius>0?s.radius:1,this.contacts.setBias(8e-4*this.radius),this.cut.setBounds(this.centre,this.radius),this.updateBounds()}updateBounds(){let e=this.views.filter(i=>i.visibility!=="hidden"),t=(e.length>0?e:this.views).flatMap(i=>this.outline(i));this.scene.camera.setBounds(this.centre,this.radius*1.1,t)}outline(e){let t=Rr(this.#i,e.part.index,new vt),{min:i,max:s}=e.copies.box,r=[];if(e.part.points.length===0||!qu(this.#i,e.part.index))return r;if(e.part.copies>1){let o=0,a=e.part.points;for(let l=0;l<a.length;l+=3)o=Math.max(o,Math.hypot(a[l],a[l+1]));for(let l=0;l<24;l++){let c=2*Math.PI*l/24;for(let u of[i.z,s.z])r.push(new X(o*Math.cos(c),o*Math.sin(c),u))}}else for(let o=0;o<8;o++)r.push(new X(o&1?s.x:i.x,o&2?s.y:i.y,o&4?s.z:i.z));return r.map(o=>o.applyMatrix4(t))}setPosition(e){this.position=e,this.meshes=this.views.map(()=>[]);let t=this.views.map(()=>[]),i=this.views.map(()=>new Set);if(e){let{views:s}=this.prepare(e);e.meshes.forEach((r,o)=>{this.meshes[r.part].push(r),t[r.part].push(s[o]);for(let a of r.copies)i[r.part].add(a)})}this.views.forEach((s,r)=>{Rr(e?.poses??null,r,s.group.matrix),s.setPresent(qu(e?.poses??null,r)),s.setMeshes(t[r],i[r])})}prepare(e){let t=this.#e.get(e);return t||(t={views:e.meshes.map(s=>{let r=Vu(s.points,s.triangles,1);return new Oo({...s,surface:r},this.views[s.part].meshMaterials,null)}),field:null},this.#e.set(e,t)),t}release(e){for(let t of this.#e.get(e)?.views??[])t.dispose()}values(e,t){let i=this.#t.get(e);i||this.#t.set(e,i=new Map);let s=i.get(t);return s||i.set(t,s=Y_(e,t)),s}limitsOf(e,t){let i=this.extremes(e,t);return i?[i.min.value,i.max.value]:null}shown(e,t){let i=this.views[t]?.part.name;return i!==void 0&&e.parts[i]!=="hidden"}cellShown(e,t,i){let s=t.contacts.parts;return this.shown(e,s[2*i])||this.shown(e,s[2*i+1])}extremes(e,t){let{field:i}=t.colours,s=null,r=null;if($i(i))for(let o of e.meshes){if(!this.shown(t,o.part))continue;let a=this.values(o,i),l=this.#n.get(o);l||this.#n.set(o,l=$_(o));for(let c=0;c<a.length;c++){let u=a[c];!l[c]||!Number.isFinite(u)||((!s||u<s.value)&&(s={value:u,mesh:o,index:c}),(!r||u>r.value)&&(r={value:u,mesh:o,index:c}))}}else if(i==="contact_pressure"&&e.contacts){let o=Float64Array.from(e.contacts.pressures,(l,c)=>l>0&&this.cellShown(t,e,c)?l:NaN),a=q_(o);a&&(s={value:0,mesh:null,index:a.minIndex},r={value:a.max,mesh:null,index:a.maxIndex})}return s&&r?{min:s,max:r}:null}extremePoint(e,t){let i=new X,{mesh:s,index:r}=e;if(s){let a=new X().fromArray(s.displacements,3*r).multiplyScalar(this.factor);return i.fromArray(s.points,3*r).add(a).applyMatrix4(Rr(t.poses,s.part,this.#r))}let o=t.contacts.corners;for(let a=0;a<4;a++)i.x+=o[12*r+3*a]/4,i.y+=o[12*r+3*a+1]/4,i.z+=o[12*r+3*a+2]/4;return i}apply(e,t){let{uniforms:i}=this.scene,{colours:s}=e,r=this.position,o=$i(s.field);for(let h of this.views)h.setVisibility(Ka(e,h.part)),h.setFieldMode(o),h.setEdges(e.mesh_edges);if(this.applyFrame(e),this.factor=this.deformationFactor(e),i.deformation.value=this.factor,r&&o){let h=this.prepare(r);h.field!==s.field&&(h.field=s.field,h.views.forEach((d,f)=>d.setField(this.values(r.meshes[f],h.field))))}let a=r&&s.field==="contact_pressure"?r.contacts:null;this.contacts.set(a,h=>this.cellShown(e,r,h)),this.contacts.setBehind(e.hidden_contacts);let l=r?this.extremes(r,e):null;this.limits=this.chooseLimits(e,l,t),this.limits&&i.limits.value.set(...this.limits),V_(this.scene.scaleTexture,s.scale,s.bands);let c=this.views.map(({part:h})=>h.name);this.forces.set(r?.forces??[],{...e.forces,radius:this.radius,names:c}),this.applyCut(e);let u=[...this.forces.labels];if(r&&l&&e.extremes){let h=Math.max(Math.abs(l.min.value),Math.abs(l.max.value)),d=yi[s.field].quantity==="length"?Li("m",h):ku(),f=(g,v,m)=>{let p=Math.abs(g.value)<1e-9*h?0:g.value*d.factor,y=this.extremePoint(g,r);this.isCutAway(y)||u.push({kind:v,text:`${m} ${Vn(p)} ${d.symbol}`,point:y})};f(l.max,"maximum","max"),o&&f(l.min,"minimum","min")}return u}chooseLimits(e,t,i){let{colours:s}=e;return s.field==="plain"?null:s.limits==="fixed"?[Math.min(s.min,s.max),Math.max(s.min,s.max)]:s.limits==="all"&&i?i:t?[t.min.value,t.max.value]:null}deformationFactor(e){let{mode:t,factor:i}=e.deformation;if(t==="factor")return Number.isFinite(i)?i:0;if(!$i(e.colours.field))return 0;let s=0;for(let{displacements:r}of this.position?.meshes??[])for(let o=0;o<r.length;o+=3){let a=r[o]**2+r[o+1]**2+r[o+2]**2;a>s&&(s=a)}return s>0?j_(oA*2*this.radius/Math.sqrt(s)):1}applyFrame(e){let{root:t}=this.scene;t.matrix.identity();let i=this.views.findIndex(r=>r.part.name===e.frame),s=r=>r&&qu(r,i);i>=0&&this.position&&s(this.#i)&&s(this.position.poses)&&(Rr(this.#i,i,t.matrix),t.matrix.multiply(Rr(this.position.poses,i,this.#r).invert())),t.updateMatrixWorld(!0)}applyCut(e){this.cut.apply(e.cut,this.scene.uniforms.cutPlane.value);for(let t of this.views)t.cap.matrix.copy(this.cut.capMatrix),t.cap.updateMatrixWorld(!0);if(this.#s!==e.cut.on){this.#s=e.cut.on;for(let t of this.views)t.setCut(this.#s);for(let t of this.contacts.materials)t.cut=this.#s}}isCutAway(e){let t=this.cutPlane,i=ax.copy(e).applyMatrix4(this.scene.root.matrix);return t!==null&&t.x*i.x+t.y*i.y+t.z*i.z+t.w>0}get cutPlane(){return this.#s?this.scene.uniforms.cutPlane.value:null}prepareFrame(){let e=this.scene.frustum(),{active:t,state:i,direction:s}=this.scene.camera,r=this.scene.height/i.height,o=t.position.distanceTo(aA.fromArray(i.target)),a=i.projection==="orthographic",l=c=>{if(a)return r;let u=ax.copy(t.position).sub(c).dot(s);return u>0?r*o/u:r};this.triangles=0;for(let c of this.views)this.triangles+=c.prepare(e,l)}clear(){for(let e of this.views)e.group.removeFromParent(),e.cap.removeFromParent(),e.dispose();this.views=[],this.position=null,this.#s=!1;for(let e of this.contacts.materials)e.cut=!1}dispose(){this.clear(),this.contacts.dispose(),this.forces.dispose()}},aA=new X,ax=new X;function qu(n,e){return!n||n.subarray(12*e,12*e+12).every(Number.isFinite)}function Rr(n,e,t){if(!n||!qu(n,e))return t.identity();let[i,s,r,o,a,l,c,u,h,d,f,g]=n.subarray(12*e,12*e+12);return t.set(i,s,r,d,o,a,l,f,c,u,h,g,0,0,0,1)}var Yu=class{element=document.createElement("div");#e=[];#t=[];#n=new X;constructor(){this.element.className="cv-labels"}set(e){for(this.#e=e;this.#t.length>e.length;)this.#t.pop().remove();e.forEach((t,i)=>{let s=this.#t[i];s||(s=document.createElement("div"),s.append(document.createElement("i"),document.createElement("span")),this.#t.push(s),this.element.append(s)),s.className=`cv-label cv-label-${t.kind}`,s.lastElementChild.textContent=t.text})}update(e,t,i,s){this.#e.forEach((r,o)=>{let a=this.#n.copy(r.point).applyMatrix4(t).project(e),l=a.z>-1&&a.z<1&&Math.abs(a.x)<1.02&&Math.abs(a.y)<1.02,{style:c}=this.#t[o];c.display=l?"":"none",l&&(c.transform=`translate(${(.5+.5*a.x)*i}px, ${(.5-.5*a.y)*s}px)`)})}placed(e,t,i,s){return this.#e.map(r=>{let o=r.point.clone().applyMatrix4(t).project(e);return{...r,x:(.5+.5*o.x)*i,y:(.5-.5*o.y)*s,depth:o.z}}).filter(r=>r.depth>-1&&r.depth<1&&r.x>0&&r.x<i&&r.y>0&&r.y<s)}};function $f(n,e,t,i,s,r){let[o,a,l]=n.origin,[c,u,h]=n.direction,d=i!==null&&s!==0,f=null,g=1/0;for(let v=0;v<t.length;v+=3){let m=3*t[v],p=3*t[v+1],y=3*t[v+2],A=e[m],S=e[m+1],C=e[m+2],R=e[p],x=e[p+1],E=e[p+2],U=e[y],D=e[y+1],L=e[y+2];d&&(A+=s*i[m],S+=s*i[m+1],C+=s*i[m+2],R+=s*i[p],x+=s*i[p+1],E+=s*i[p+2],U+=s*i[y],D+=s*i[y+1],L+=s*i[y+2]);let k=R-A,z=x-S,N=E-C,G=U-A,$=D-S,H=L-C,le=u*H-h*$,Z=h*G-c*H,Q=c*$-u*G,ie=k*le+z*Z+N*Q;if(ie===0)continue;let de=1/ie,he=o-A,ee=a-S,me=l-C,ge=(he*le+ee*Z+me*Q)*de;if(ge<-1e-9||ge>1+1e-9)continue;let Me=ee*N-me*z,ve=me*k-he*N,He=he*z-ee*k,Je=(c*Me+u*ve+h*He)*de;if(Je<-1e-9||ge+Je>1+1e-9)continue;let Oe=(G*Me+$*ve+H*He)*de;Oe<=r||Oe>=g||(g=Oe,f={distance:Oe,triangle:v,u:ge,v:Je,facing:ie>0})}return f}function Jf(n,e,t){if(!t)return[0,1/0];let i=t.x*n.x+t.y*n.y+t.z*n.z+t.w,s=t.x*e.x+t.y*e.y+t.z*e.z;if(s===0)return i>0?[1/0,1/0]:[0,1/0];let r=-i/s;return s<0?[Math.max(0,r),1/0]:[0,r]}var qf=new vt,Cr=new X,Pr=new X,sr=new ls,lx=new ti;function cx(n,e,t,i,s){let[r,o]=Jf(n.origin,n.direction,s),a=null,l=(c,u,h,d,f)=>{if(!d||d.distance>o||a&&d.distance>=a.distance)return;let g=d.triangle;a={view:c,copy:u,mesh:h,nodes:[f[g],f[g+1],f[g+2]],weights:[1-d.u-d.v,d.u,d.v],distance:d.distance,point:n.at(d.distance,new X),cap:s!==null&&!d.facing}};for(let c of e){if(c.visibility!=="visible"||!c.present)continue;qf.copy(c.group.matrixWorld).invert(),Cr.copy(n.origin).applyMatrix4(qf),Pr.copy(n.direction).transformDirection(qf);let u=c.copies.sphere;for(let d of c.presentCopies){let f=-2*Math.PI*d/c.part.copies,g=Math.cos(f),v=Math.sin(f);if(sr.origin.set(g*Cr.x-v*Cr.y,v*Cr.x+g*Cr.y,Cr.z),sr.direction.set(g*Pr.x-v*Pr.y,v*Pr.x+g*Pr.y,Pr.z),lx.copy(u),!sr.intersectsSphere(lx)||!sr.intersectsBox(c.copies.box))continue;let m=$f(Yf(sr),c.part.points,c.part.triangles,null,0,r);l(c,d,-1,m,c.part.triangles)}sr.origin.copy(Cr),sr.direction.copy(Pr),(t[c.part.index]??[]).forEach((d,f)=>{let g=$f(Yf(sr),d.points,d.triangles,d.displacements,i,r);l(c,-1,f,g,d.triangles)})}return a}function Yf(n){return{origin:[n.origin.x,n.origin.y,n.origin.z],direction:[n.direction.x,n.direction.y,n.direction.z]}}function ux(n,e,t,i){let s=null,r=Yf(n);for(let o=0;o<e.count;o++){if(!(e.pressures[o]>0)||!t(o))continue;let a=e.corners.subarray(12*o,12*o+12),l=$f(r,a,lA,null,0,i[0]);l&&l.distance<i[1]&&(!s||l.distance<s.distance)&&(s={cell:o,distance:l.distance})}return s}var lA=new Uint32Array([0,1,2,0,2,3]);var cA=6,ja=new ls,Zf=new ls,fx=new vt;function px(n,e,t){let{scene:i,display:s,state:r}=n;if(!i||!s)return null;i.ray(e,t,ja);let o=s.cutPlane,a=cx(ja,s.views,s.meshes,s.factor,o),l=fA(n,e,t,a?.distance??1/0);if(l)return l;if(!a)return null;let{part:c}=a.view,u=new X,h=s.meshes[c.index]?.[a.mesh],d=r.colours.field==="plain"?null:NaN,f=null,g=null;if(a.cap)return u.copy(a.point),{x:e,y:t,part:c.name,tooth:g,value:null,node:f,point:u};if(h){if(hx(h.points,a,u),f=hA(n,h,a,e,t),f!==null&&u.fromArray(h.points,3*f),$i(r.colours.field)){let v=s.values(h,r.colours.field);d=f!==null?v[f]:a.nodes.reduce((m,p,y)=>m+a.weights[y]*v[p],0)}g=dA(h,a,u)}else hx(c.points,a,u),u.applyAxisAngle(uA,2*Math.PI*a.copy/c.copies),g=c.copies>1?a.copy:null;return u.applyMatrix4(Rr(s.position?.poses??null,c.index,fx)),{x:e,y:t,part:c.name,tooth:g,value:d,node:f,point:u}}var uA=new X(0,0,1);function hx(n,e,t){t.set(0,0,0),e.nodes.forEach((i,s)=>{let r=e.weights[s];t.x+=r*n[3*i],t.y+=r*n[3*i+1],t.z+=r*n[3*i+2]})}function hA(n,e,t,i,s){let r=n.scene,o=n.display.factor,a=null,l=cA,c=new X;for(let u of t.nodes){c.fromArray(e.displacements,3*u).multiplyScalar(o),c.x+=e.points[3*u],c.y+=e.points[3*u+1],c.z+=e.points[3*u+2],c.applyMatrix4(t.view.group.matrixWorld).project(r.camera.active);let h=Math.hypot((.5+.5*c.x)*r.width-i,(.5-.5*c.y)*r.height-s);h<=l&&(l=h,a=u)}return a}function dA(n,e,t){let{part:i,copies:s}=e.view;if(i.copies<=1)return null;let{center:r}=s.sphere,o=Math.atan2(t.y,t.x)-Math.atan2(r.y,r.x),a=2*Math.PI/i.copies,l=null,c=1/0;for(let u of n.copies){let h=Math.abs(Math.atan2(Math.sin(o-u*a),Math.cos(o-u*a)));h<c&&(c=h,l=u)}return l}function fA(n,e,t,i){let{display:s,state:r}=n,o=s?.position,a=r.colours.field==="contact_pressure"?o?.contacts:null;if(!a||!o||!s)return null;let l=fx.copy(n.scene.root.matrixWorld).invert();Zf.copy(ja).applyMatrix4(l);let c=Jf(ja.origin,ja.direction,s.cutPlane);r.hidden_contacts||(c[1]=Math.min(c[1],i+.002*s.radius));let u=ux(Zf,a,g=>s.cellShown(r,o,g),c);if(!u)return null;let h=Zf.at(u.distance,new X),d=r.parts[dx(n,a.parts[2*u.cell])]==="hidden"?1:0,f=a.parts[2*u.cell+d];return{x:e,y:t,part:dx(n,f),tooth:a.teeth[2*u.cell+d],value:a.pressures[u.cell],node:null,point:h}}function dx(n,e){return n.parts?.parts[e]?.name??`part ${e}`}var pA=["gear","shaft","bearing","body"];function Ku(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)?n:null}function Ju(n){return Array.isArray(n)?n:[]}function Zu(n,e,t,i){for(let s=0;s<t.length;s++)if(t[s]>=i)throw new Sn(n,`${e}: index ${t[s]} exceeds the ${i} points`)}function mx(n){let e=Ya.parse("parts.bin",n);if(!Array.isArray(e.header.parts))throw new Sn(e.name,"the list of parts is missing");let t=e.header.parts.map((i,s)=>{let r=Ku(i);if(!r)throw new Sn(e.name,`part ${s} is not an object`);let o=typeof r.name=="string"?r.name:`part ${s}`,a=Number(r.copies??1);if(!Number.isInteger(a)||a<1)throw new Sn(e.name,`${o}: the number of copies is not valid`);let l=e.f32(r.points,3,`${o}, points`),c=e.u32(r.triangles,3,`${o}, triangles`),u=r.edges?e.u32(r.edges,2,`${o}, edges`):new Uint32Array;Zu(e.name,`${o}, triangles`,c,l.length/3),Zu(e.name,`${o}, edges`,u,l.length/3);let h=pA.includes(String(r.kind))?r.kind:"body";return{index:s,name:o,kind:h,copies:a,open:r.open===!0,points:l,triangles:c,edges:u}});return{model:String(e.header.model??""),units:String(e.header.units??""),parts:t}}function Kf(n){if(!Array.isArray(n)||n.length!==3)return null;let e=n.map(t=>typeof t=="number"?t:NaN);return e.every(Number.isFinite)?e:null}function mA(n,e){let t=Ku(n),i=Kf(t?.point),s=Kf(t?.force);return!t||!i||!s?null:{kind:t.kind==="mesh"?"mesh":"bearing",name:String(t.name??""),point:i,force:s,moment:Kf(t.moment)??[0,0,0],parts:Ju(t.parts).filter(r=>typeof r=="number"&&r>=0&&r<e)}}function gA(n,e){let t=Ku(e);if(!t)return null;let i=n.f32(t.corners,12,"contacts, corners"),s=n.f32(t.pressures,1,"contacts, pressures"),r=n.u32(t.parts,2,"contacts, parts"),o=n.u32(t.teeth,2,"contacts, teeth"),a=s.length;if(i.length!==12*a||r.length!==2*a||o.length!==2*a)throw new Sn(n.name,"contacts: the arrays have different lengths");return a>0?{count:a,corners:i,pressures:s,parts:r,teeth:o}:null}function _A(n,e,t,i){let s=Ku(e),r=i[Number(s?.part)];if(!s||!r)throw new Sn(n.name,`mesh ${t}: the part does not exist`);let o=`mesh of ${r.name}`,a=n.f32(s.points,3,`${o}, points`),l=n.f32(s.displacements,3,`${o}, displacements`),c=n.f32(s.stresses,6,`${o}, stresses`),u=n.u32(s.triangles,3,`${o}, triangles`),h=s.edges?n.u32(s.edges,2,`${o}, edges`):new Uint32Array,d=a.length/3;if(l.length!==3*d||c.length!==6*d)throw new Sn(n.name,`${o}: the arrays have different lengths`);Zu(n.name,`${o}, triangles`,u,d),Zu(n.name,`${o}, edges`,h,d);let f=Ju(s.copies).filter(g=>typeof g=="number"&&g>=0&&g<r.copies);return{part:r.index,copies:f,points:a,displacements:l,stresses:c,triangles:u,edges:h}}function gx(n,e,t){let i=Ya.parse(n,e),{header:s}=i,r=i.f64(s.poses,12,"poses");if(r.length!==12*t.length)throw new Sn(n,`${r.length/12} poses for ${t.length} parts; the files are from different runs`);return{position:Number(s.position??0),time:Number(s.time??0),poses:r,contacts:gA(i,s.contacts),forces:Ju(s.forces).map(o=>mA(o,t.length)).filter(o=>o!==null),meshes:Ju(s.meshes).map((o,a)=>_A(i,o,a,t)),bytes:e.byteLength}}function Qa(n){return`position-${String(n).padStart(4,"0")}.bin`}var xA=384e6,ju=class{constructor(e,t){this.source=e;this.parts=t}source;parts;list=[];onEvict=null;#e=new Map;#t=new Map;#n=0;async update(){this.list=await this.source.positions()}cached(e){return this.#e.get(e)}load(e){let t=this.#e.get(e);if(t)return this.#e.delete(e),this.#e.set(e,t),Promise.resolve(t);let i=this.#t.get(e);if(i)return i;let s=this.read(e).finally(()=>this.#t.delete(e));return this.#t.set(e,s),s}async read(e){let t=this.list[e],i=Qa(t?.position??e),s=gx(i,await this.source.position(e),this.parts);this.#e.set(e,s),this.#n+=s.bytes;for(let[r,o]of this.#e){if(this.#n<=xA||r===e)break;this.#e.delete(r),this.#n-=o.bytes,this.onEvict?.(o)}return s}dispose(){for(let e of this.#e.values())this.onEvict?.(e);this.#e.clear(),this.#n=0}};var jf=24,vA=260,yA={front:[-90,0],back:[90,0],left:[180,0],right:[0,0],top:[-90,90],bottom:[-90,-90],isometric:[-50,30]},Qu=class{perspective=new ei(jf);orthographic=new Ao;onChange=null;#e={projection:"perspective",target:[0,0,0],azimuth:-50,elevation:30,height:1};#t=1;#n=new X;#i=1;#r=[];#s=!1;#o=!1;#l=0;#u=new X;#h=new X;#c=new X;get active(){return this.#e.projection==="perspective"?this.perspective:this.orthographic}get state(){let e={...this.#e,target:[...this.#e.target]};return this.#s?e.fitted=!0:delete e.fitted,e}setBounds(e,t,i){this.#n.copy(e),this.#i=t>0?t:1,this.#r=i,this.update()}setFitPoints(e){this.#r=e}setAspect(e){this.#t=e>0?e:1,this.#s&&Object.assign(this.#e,this.fitted(this.#e.azimuth,this.#e.elevation)),this.update()}set(e,t=!1){this.interrupt(),this.#e={...e,target:[...e.target]},e.fitted&&(Object.assign(this.#e,this.fitted(e.azimuth,e.elevation)),this.#s=!0),this.changed(t)}setProjection(e){this.#e.projection=e,this.changed(!0)}orbit(e,t){this.interrupt(),this.#e.azimuth=ep(this.#e.azimuth+e),this.#e.elevation=Qf(this.#e.elevation+t,-90,90),this.changed(!0)}pan(e,t){this.interrupt(),this.shift(e,t),this.changed(!0)}zoom(e,t=0,i=0){this.interrupt();let s=Qf(this.#e.height*e,this.#i*1e-4,this.#i*40),r=s/this.#e.height;this.shift(-t*(1-r),-i*(1-r)),this.#e.height=s,this.changed(!0)}view(e,t=!0){let[i,s]=yA[e],r={...this.#e,azimuth:i,elevation:s};this.#o=t,t&&Object.assign(r,this.fitted(i,s)),this.animateTo(r)}fit(e=!0){let t={...this.#e,...this.fitted(this.#e.azimuth,this.#e.elevation)};this.#o=!0,e?this.animateTo(t):(this.set(t,!0),this.#s=!0)}interrupt(){cancelAnimationFrame(this.#l),this.#s=!1}fitted(e,t){if(this.#r.length===0){let f=2.1*this.#i/Math.min(1,this.#t);return{target:[this.#n.x,this.#n.y,this.#n.z],height:f}}let[i,s,r]=[new X,new X,new X];_x(e,t,i,s,r);let o=new ri,a=new X,l=this.#r.map(f=>new X(f.dot(i),f.dot(s),f.dot(r)));for(let f of l)o.expandByPoint(f);let c=o.getCenter(a),u=this.#e.projection==="perspective"?Math.tan(jf*Math.PI/360):0,h=.001*this.#i;for(let f of l){let g=(f.z-c.z)*u;h=Math.max(h,2*(Math.abs(f.y-c.y)+g),2*(Math.abs(f.x-c.x)/this.#t+g))}h*=1.1;let d=i.multiplyScalar(c.x).addScaledVector(s,c.y).addScaledVector(r,c.z);return{target:[d.x,d.y,d.z],height:h}}animateTo(e){if(cancelAnimationFrame(this.#l),matchMedia("(prefers-reduced-motion: reduce)").matches){this.set(e,!0),this.#s=this.#o;return}let t=this.state,i=ep(e.azimuth-t.azimuth),s=performance.now(),r=o=>{let a=Qf((o-s)/vA,0,1),l=a*a*(3-2*a);this.#e.azimuth=ep(t.azimuth+l*i),this.#e.elevation=t.elevation+l*(e.elevation-t.elevation),this.#e.height=t.height*(e.height/t.height)**l;for(let c=0;c<3;c++)this.#e.target[c]=t.target[c]+l*(e.target[c]-t.target[c]);a===1&&(this.#e={...e,target:[...e.target]},this.#s=this.#o),this.changed(!0),a<1&&(this.#l=requestAnimationFrame(r))};this.#l=requestAnimationFrame(r)}shift(e,t){let{height:i,target:s}=this.#e;for(let r=0;r<3;r++){let o=this.#u.getComponent(r),a=this.#h.getComponent(r);s[r]-=i*(e*o+t*a)}}changed(e){this.update(),this.onChange?.(e)}get direction(){return this.#c}update(){let{azimuth:e,elevation:t,height:i,target:s}=this.#e;_x(e,t,this.#u,this.#h,this.#c);let r=i/(2*Math.tan(jf*Math.PI/360)),o=s[0],a=s[1],l=s[2],c=r-(this.#n.x-o)*this.#c.x-(this.#n.y-a)*this.#c.y-(this.#n.z-l)*this.#c.z,u=1.3*this.#i+.02*i;for(let d of[this.perspective,this.orthographic])d.position.set(o+r*this.#c.x,a+r*this.#c.y,l+r*this.#c.z),d.matrix.makeBasis(this.#u,this.#h,this.#c),d.quaternion.setFromRotationMatrix(d.matrix),d.updateMatrixWorld();this.perspective.near=Math.max(c-u,r*.02),this.perspective.far=Math.max(c+u,this.perspective.near*1.1),this.perspective.aspect=this.#t,this.perspective.updateProjectionMatrix();let h=this.orthographic;h.near=c-u,h.far=c+u,h.top=i/2,h.bottom=-i/2,h.right=i/2*this.#t,h.left=-h.right,h.updateProjectionMatrix()}};function _x(n,e,t,i,s){let r=n*Math.PI/180,o=e*Math.PI/180;t.set(-Math.sin(r),Math.cos(r),0),s.set(Math.cos(o)*Math.cos(r),Math.cos(o)*Math.sin(r),Math.sin(o)),i.crossVectors(s,t)}function Qf(n,e,t){return Math.min(Math.max(n,e),t)}function ep(n){return((n+180)%360+360)%360-180}var ko=class extends Error{constructor(){super("This browser cannot draw three-dimensional pictures: WebGL 2 is not available. Turn on hardware acceleration in the browser's settings, or use another browser."),this.name="NoWebGlError"}},eh=class{constructor(e){this.container=e;this.uniforms=F_(this.scaleTexture);let t=this.canvas.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0,depth:!0,powerPreference:"high-performance"});if(!t)throw new ko;this.#e=new Iu({canvas:this.canvas,context:t,stencil:!0,alpha:!0}),this.#e.setClearColor(0,0),this.root.matrixAutoUpdate=!1,this.scene.add(this.root),e.append(this.canvas),this.#t=new ResizeObserver(()=>this.resize()),this.#t.observe(e),this.canvas.addEventListener("webglcontextrestored",()=>this.invalidate()),this.resize()}container;canvas=document.createElement("canvas");camera=new Qu;scene=new Ma;root=new un;uniforms;scaleTexture=H_();onPrepare=null;onFrame=null;frames=0;width=1;height=1;#e;#t;#n=0;#i=new Rs;#r=new vt;resize(){this.width=Math.max(this.container.clientWidth,1),this.height=Math.max(this.container.clientHeight,1);let e=Math.min(window.devicePixelRatio||1,2);this.uniforms.pixelRatio.value=e,this.#e.setPixelRatio(e),this.#e.setSize(this.width,this.height),this.camera.setAspect(this.width/this.height),this.draw()}invalidate(){this.#n||(this.#n=requestAnimationFrame(()=>{this.#n=0,this.draw()}))}frustum(){let{active:e}=this.camera;return this.#r.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this.#i.setFromProjectionMatrix(this.#r)}draw(){this.scene.updateMatrixWorld(),this.onPrepare?.(),this.#e.render(this.scene,this.camera.active),this.frames++,this.onFrame?.()}snapshot(e){let t=this.#e.getPixelRatio(),i=document.createElement("canvas");try{this.uniforms.pixelRatio.value=e,this.#e.setPixelRatio(e),this.#e.setSize(this.width,this.height,!1),this.draw(),i.width=this.canvas.width,i.height=this.canvas.height,i.getContext("2d").drawImage(this.canvas,0,0)}finally{this.uniforms.pixelRatio.value=t,this.#e.setPixelRatio(t),this.#e.setSize(this.width,this.height),this.draw()}return i}ray(e,t,i){let{active:s}=this.camera,r=2*e/this.width-1,o=1-2*t/this.height;return i.origin.set(r,o,-1).unproject(s),i.direction.set(r,o,1).unproject(s).sub(i.origin).normalize(),i}dispose(){cancelAnimationFrame(this.#n),this.#t.disconnect(),this.scaleTexture.dispose(),this.#e.dispose(),this.#e.forceContextLoss(),this.canvas.remove()}};var th=class{constructor(e,t){this.element=e;this.changed=t;this.#t.addEventListener("change",this.#n)}element;changed;theme="light";#e="system";#t=matchMedia("(prefers-color-scheme: dark)");#n=()=>{this.set(this.#e),this.changed()};set(e){this.#e=e,this.theme=e==="system"?this.#t.matches?"dark":"light":e,this.element.dataset.theme=this.theme}dispose(){this.#t.removeEventListener("change",this.#n)}};var ih=class{constructor(e,t,i){this.element=e;this.state=Xu(i,Wu()),this.#i=i.colours?.field!==void 0,this.theme=new th(e,()=>this.changed()),this.theme.set(this.state.theme);try{this.scene=new eh(t),this.display=new $u(this.scene)}catch(o){this.fail(o instanceof ko?o:new ko);return}let{scene:s,display:r}=this;t.append(this.labels.element),s.onPrepare=()=>r.prepareFrame(),s.onFrame=()=>this.labels.update(s.camera.active,s.root.matrix,s.width,s.height),s.camera.onChange=o=>{this.state.camera=s.camera.state,this.probe=null,s.invalidate(),this.changed(o)}}element;state;status="empty";failure="";notice="";source=null;parts=null;positions=null;probe=null;help=!1;progress=null;scene=null;display=null;labels=new Yu;animation=new Fu(this);theme;onChange=null;#e=new Set;#t=0;#n=0;#i;#r=new Map;#s="";subscribe(e){return this.#e.add(e),()=>this.#e.delete(e)}changed(e=!0){e&&(this.#o=!0),!this.#t&&(this.#t=requestAnimationFrame(()=>{this.#t=0;for(let t of this.#e)t();this.#o&&this.onChange?.(structuredClone(this.state)),this.#o=!1}))}#o=!1;fail(e){this.status="failed",this.failure=e instanceof Error?e.message:String(e),this.changed(!1)}async show(e){this.scene&&(this.source=e,this.status!=="ready"&&(this.status="loading"),this.notice="",this.changed(!1),await this.load(!0))}async reload(){this.source&&this.scene&&await this.load(!1)}async load(e){let{source:t,display:i,scene:s}=this;if(!t||!i||!s)return;let r=++this.#n,o=()=>r!==this.#n;e&&this.animation.stop();try{let a=mx(await t.parts()),l=new ju(t,a.parts),c="";try{await l.update()}catch(h){c=`The list of positions cannot be read: ${nh(h)}`}let u=l.list.length>0?await l.load(0).catch(h=>(c=nh(h),null)):null;if(o())return;this.positions?.dispose(),this.parts=a,Z_(a.units),this.positions=l,l.onEvict=h=>i.release(h),this.#r.clear(),this.notice=c,i.setParts(a.parts,u),i.setPosition(u),!this.#i&&(u?.meshes.length||u?.contacts)&&(this.#i=!0,this.state.colours.field=u.meshes.length?"von_mises":"contact_pressure"),this.state.position=Math.min(Math.max(0,Math.trunc(this.state.position)),Math.max(0,l.list.length-1)),this.status="ready",this.apply(),i.updateBounds(),this.state.camera?s.camera.set(this.state.camera):a.parts.length>0&&s.camera.fit(!1),this.state.position>0&&await this.goTo(this.state.position),this.changed()}catch(a){o()||this.fail(a)}}async updatePositions(){let{positions:e}=this;if(!e)return;let t=e.list.length===0;try{await e.update()}catch(i){this.notice=`The list of positions cannot be read: ${nh(i)}`}this.#r.clear(),t&&e.list.length>0?await this.load(!0):this.update({})}update(e){let t=this.state;this.state=Xu(e,t),e.colours?.field&&(this.#i=!0),this.probe=null,this.theme.set(this.state.theme),e.camera&&this.scene&&this.scene.camera.set(this.state.camera),this.apply(),e.parts&&this.display?.updateBounds(),e.position!==void 0&&this.goTo(this.state.position),this.changed()}apply(){let{display:e,scene:t}=this;if(!e||!t||this.status!=="ready")return;let i=e.apply(this.state,this.#r.get(this.limitsKey())??null);this.labels.set(i),t.invalidate(),this.state.colours.limits==="all"&&this.findAllLimits()}setVisibility(e,t){let i={...this.state.parts};for(let s of e)i[s]=t;this.update({parts:i})}async goTo(e){let{positions:t,display:i}=this;if(!t||!i||t.list.length===0)return;let s=Math.min(Math.max(0,e),t.list.length-1);this.state.position=s,this.changed();try{let r=await t.load(s);if(t!==this.positions||this.state.position!==s)return;this.notice="",i.position!==r&&i.setPosition(r),this.probe=null,this.apply()}catch(r){if(t!==this.positions||this.state.position!==s)return;this.animation.stop(),this.notice=`${nh(r)}. The picture shows another position.`}this.changed()}limitsKey(){let e=Object.entries(this.state.parts).filter(([,t])=>t==="hidden");return JSON.stringify([this.state.colours.field,e.map(([t])=>t).sort()])}async findAllLimits(){let{positions:e,display:t,state:i}=this,s=this.limitsKey();if(!e||!t||i.colours.field==="plain"||this.#r.has(s)||this.#s===s)return;this.#s=s;let r=()=>this.#s===s&&e===this.positions&&this.state.colours.limits==="all",o=null;for(let l=0;l<e.list.length&&r();l++){this.progress=l/e.list.length,this.changed(!1);let c=await e.load(l).catch(()=>null),u=c&&r()?t.limitsOf(c,this.state):null;u&&(o=o?[Math.min(o[0],u[0]),Math.max(o[1],u[1])]:u)}if(this.#s!==s)return;let a=r();this.#s="",this.progress=null,a&&(o?this.#r.set(s,o):this.#r.set(s,[0,1]),this.apply()),this.changed(!1)}probePointer(e,t){this.probe=this.status==="ready"?px(this,e,t):null,this.changed(!1)}clearProbe(){this.probe&&(this.probe=null,this.changed(!1))}get hasMeshes(){return(this.display?.position?.meshes.length??0)>0}get missingField(){let{field:e}=this.state.colours,t=this.display?.position;return e==="plain"||this.status!=="ready"?!1:$i(e)?!t?.meshes.length:!t?.contacts}project(e,t){let{scene:i,display:s}=this,r=s?.views.find(l=>l.part.name===e);if(!i||!r)return null;let o=new X(...t).applyMatrix4(r.group.matrixWorld).project(i.camera.active),a=i.canvas.getBoundingClientRect();return{x:a.left+(.5+.5*o.x)*i.width,y:a.top+(.5-.5*o.y)*i.height}}nodalValue(e,t){let{display:i,parts:s}=this,r=s?.parts.findIndex(l=>l.name===e)??-1,o=i?.meshes[r]?.[0],{field:a}=this.state.colours;return o&&i&&$i(a)?i.values(o,a)[t]??NaN:NaN}dispose(){this.#n++,cancelAnimationFrame(this.#t),this.animation.stop(),this.positions?.dispose(),this.display?.dispose(),this.scene?.dispose(),this.theme.dispose(),this.#e.clear()}};function nh(n){return n instanceof Sn||n instanceof Error?n.message:String(n)}var xx=.35,bA=18;function vx(n,e){let t=n.scene,i=new Map,s=null,r=0,o=0,a=0,l=new X,c=f=>{let g=e.getBoundingClientRect();return{x:f.clientX-g.left,y:f.clientY-g.top}},u=(f,g)=>{if(!n.state.cut.on)return!1;let v=l.copy(n.display.cut.handle).project(t.camera.active);return Math.hypot((.5+.5*v.x)*t.width-f,(.5-.5*v.y)*t.height-g)<bA};e.addEventListener("pointerdown",f=>{e.setPointerCapture(f.pointerId),e.focus({preventScroll:!0});let{x:g,y:v}=c(f);i.set(f.pointerId,{x:g,y:v}),i.size>1?s="pan":f.button===0&&u(g,v)?s="cut":s=f.button===0&&!f.shiftKey?"orbit":"pan",n.clearProbe(),e.dataset.drag=s}),e.addEventListener("pointermove",f=>{let{x:g,y:v}=c(f),m=i.get(f.pointerId);if(!m||!s){let A=u(g,v);e.dataset.handle=String(A),n.display?.cut.setHighlight(A),o=g,a=v,r||=requestAnimationFrame(()=>{r=0,n.probePointer(o,a)});return}let p=g-m.x,y=v-m.y;if(i.size===2){let A=[...i].find(([R])=>R!==f.pointerId)[1],S=Math.hypot(m.x-A.x,m.y-A.y),C=Math.hypot(g-A.x,v-A.y);t.camera.pan(p/2/t.height,-y/2/t.height),S>0&&C>0&&t.camera.zoom(S/C,...d((g+A.x)/2,(v+A.y)/2))}else if(s==="orbit")t.camera.orbit(-p*xx,y*xx);else if(s==="pan")t.camera.pan(p/t.height,-y/t.height);else{let{cut:A}=n.display;yx(n,A.drag(p,y,t.camera.active,t.width,t.height))}m.x=g,m.y=v});let h=f=>{i.delete(f.pointerId),i.size===0&&(s=null,delete e.dataset.drag)};e.addEventListener("pointerup",h),e.addEventListener("pointercancel",h),e.addEventListener("pointerleave",()=>{cancelAnimationFrame(r),r=0,n.clearProbe()}),e.addEventListener("contextmenu",f=>f.preventDefault()),e.addEventListener("dblclick",()=>t.camera.fit());let d=(f,g)=>[(f-t.width/2)/t.height,(t.height/2-g)/t.height];e.addEventListener("wheel",f=>{f.preventDefault();let{x:g,y:v}=c(f),m=f.deltaY*(f.deltaMode===1?16:1);t.camera.zoom(Math.exp(Math.min(Math.max(m,-240),240)*.0016),...d(g,v))},{passive:!1})}function yx(n,e){let{cut:t}=n.display,i=Math.min(Math.max(t.offset+e,t.range[0]),t.range[1]);n.update({cut:{offset:i}})}function Bo(n,e){let t=e.normal??n.state.cut.normal,i=n.scene.camera.direction,s=typeof t=="string"?i[t]:i.x*t[0]+i.y*t[1]+i.z*t[2];n.update({cut:{...e,...e.normal?{offset:null}:{},...e.on===!1?{}:{flipped:s<0}}})}var bx=[["View",[{keys:"F",label:"Fit the parts into the picture"},{keys:"1 … 6",label:"Front, back, left, right, top, bottom"},{keys:"7",label:"Isometric"},{keys:"P",label:"Perspective or orthographic"},{keys:"Arrow keys",label:"Orbit (picture focused)"},{keys:"Shift + arrow keys",label:"Pan (picture focused)"},{keys:"+ −",label:"Zoom"}]],["Display",[{keys:"M",label:"Edges of the finite elements"},{keys:"V",label:"Force vectors"},{keys:"C",label:"Cutting plane"},{keys:"[ ]",label:"Move the cutting plane"},{keys:"D",label:"Undeformed, true or automatic deformation"}]],["Animation",[{keys:"K",label:"Play or pause"},{keys:", .",label:"Previous or next position"}]],["Panels",[{keys:"B",label:"Parts"},{keys:"S",label:"Settings"},{keys:"G",label:"Plots"},{keys:"?",label:"This help"},{keys:"Esc",label:"Close"}]],["Pointer",[{keys:"Drag",label:"Orbit"},{keys:"Right or Shift + drag",label:"Pan"},{keys:"Wheel",label:"Zoom at the pointer"},{keys:"Double click",label:"Fit"}]]],SA={1:"front",2:"back",3:"left",4:"right",5:"top",6:"bottom",7:"isometric"};function Sx(n,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let t=e.target;if(t.closest("input:not([type=checkbox]):not([type=range]), select, textarea"))return!1;let{scene:i,state:s,animation:r}=n;if(e.key==="?")return n.help=!n.help,n.changed(!1),!0;if(e.key==="Escape"&&n.help)return n.help=!1,n.changed(!1),!0;if(!i||n.status!=="ready")return!1;let{camera:o}=i;if(t===i.canvas&&e.key.startsWith("Arrow")){let u=e.key==="ArrowRight"?1:e.key==="ArrowLeft"?-1:0,h=e.key==="ArrowUp"?1:e.key==="ArrowDown"?-1:0;return e.shiftKey?o.pan(.05*u,.05*h):o.orbit(-6*u,-6*h),!0}let a=SA[e.key];if(a)return o.view(a),!0;let{panels:l,forces:c}=s;switch(e.key.toLowerCase()){case"f":o.fit();break;case"p":o.setProjection(s.camera?.projection==="orthographic"?"perspective":"orthographic");break;case"+":case"=":o.zoom(.85);break;case"-":case"_":o.zoom(1/.85);break;case"m":n.update({mesh_edges:!s.mesh_edges});break;case"v":{let u=!(c.bearings||c.meshes);n.update({forces:{bearings:u,meshes:u}});break}case"c":Bo(n,{on:!s.cut.on});break;case"[":case"]":s.cut.on&&yx(n,(e.key==="["?-.04:.04)*n.display.radius);break;case"d":n.update({deformation:MA(n)});break;case"k":r.toggle();break;case",":r.step(-1);break;case".":r.step(1);break;case"b":n.update({panels:{parts:!l.parts}});break;case"s":n.update({panels:{settings:!l.settings}});break;case"g":n.update({panels:{plots:!l.plots}});break;default:return!1}return!0}function MA(n){let{mode:e,factor:t}=n.state.deformation;return e==="automatic"?{mode:"factor",factor:0}:t===0?{mode:"factor",factor:1}:{mode:"automatic",factor:1}}function el(n){let{field:e}=n.state.colours;if(yi[e].quantity==="stress")return ku();if(yi[e].quantity==="none")return{symbol:"",factor:1};let t=n.display?.limits;return Li("m",t?Math.max(Math.abs(t[0]),Math.abs(t[1])):0)}function zo(n){return yi[n.state.colours.field].label}function sh(n){let e=el(n),t=n.display?.limits;if(!t)return{ticks:[],unit:e.symbol};let{bands:i}=n.state.colours,s=i>0&&i<=12?i:5,r=t[0]*e.factor,o=t[1]*e.factor;return r===o?{ticks:[{fraction:.5,text:Vn(r)}],unit:e.symbol}:{ticks:Array.from({length:s+1},(l,c)=>{let u=c/s,h=r+u*(o-r);return{fraction:u,text:Vn(Math.abs(h)<1e-9*Math.abs(o-r)?0:h,4)}}),unit:e.symbol}}function Mx(n,e,t,i){let s=new TextEncoder,r=[],o=[],a=0,l=f=>{let g=typeof f=="string"?s.encode(f):f;r.push(g),a+=g.length},c=(f,g)=>{o.push(a),l(`${o.length} 0 obj
${f}
`),g!==void 0&&(l(`stream
`),l(g),l(`
endstream
`)),l(`endobj
`)},u=Math.round(842*t/e),h=`q 842 0 0 ${u} 0 0 cm /Picture Do Q`;l(`%PDF-1.4
`),c("<< /Type /Catalog /Pages 2 0 R >>"),c("<< /Type /Pages /Kids [3 0 R] /Count 1 >>"),c(`<< /Type /Page /Parent 2 0 R /MediaBox [0 0 842 ${u}] /Resources << /XObject << /Picture 4 0 R >> >> /Contents 5 0 R >>`),c(`<< /Type /XObject /Subtype /Image /Width ${e} /Height ${t} /ColorSpace /DeviceRGB /BitsPerComponent 8 /Filter /DCTDecode /Length ${n.length} >>`,n),c(`<< /Length ${h.length} >>`,h),c(`<< /Title <${wA(i)}> /Producer (Calyx) >>`);let d=a;l(`xref
0 ${o.length+1}
0000000000 65535 f 
`);for(let f of o)l(`${String(f).padStart(10,"0")} 00000 n 
`);return l(`trailer
<< /Size ${o.length+1} /Root 1 0 R /Info 6 0 R >>
startxref
${d}
%%EOF
`),new Blob(r,{type:"application/pdf"})}function wA(n){let e="FEFF";for(let t=0;t<n.length;t++)e+=n.charCodeAt(t).toString(16).padStart(4,"0").toUpperCase();return e}var EA=2,TA="system-ui, -apple-system, 'Segoe UI', Roboto, Helvetica, Arial, sans-serif",Ns={width:16,height:200,right:92,top:56};function AA(n){let{width:e,height:t}=n.scene,i=getComputedStyle(n.element),s=r=>i.getPropertyValue(r).trim();return{width:e,height:t,text:s("--cv-text"),muted:s("--cv-muted"),background:s("--cv-stage"),halo:s("--cv-stage")}}function Ex(n,e){let{scene:t,labels:i,state:s,display:r}=n,o=[],a=(d,f,g,v="")=>o.push(`<text x="${d.toFixed(1)}" y="${f.toFixed(1)}" fill="${e.text}" stroke="${e.halo}" stroke-width="3" stroke-linejoin="round" paint-order="stroke" ${v}>${RA(g)}</text>`);for(let d of i.placed(t.camera.active,t.root.matrix,e.width,e.height))(d.kind==="maximum"||d.kind==="minimum")&&o.push(`<circle cx="${d.x.toFixed(1)}" cy="${d.y.toFixed(1)}" r="4" fill="none" stroke="${e.text}" stroke-width="1.6"/>`),a(d.x+9,d.y+4,d.text,'font-weight="600"');let{limits:l}=r,{colours:c}=s;if(l&&c.field!=="plain"){let d=e.width-Ns.right,f=c.bands>0?c.bands:64;for(let m=0;m<f;m++){let p=Za(Fo(c.scale,c.bands>0?Ja((m+.5)/f,f):m/(f-1))),y=Ns.height/f,A=Ns.top+Ns.height-(m+1)*y;o.push(`<rect x="${d}" y="${A.toFixed(2)}" width="${Ns.width}" height="${(y+.4).toFixed(2)}" fill="${p}"/>`)}let{ticks:g,unit:v}=sh(n);for(let m of g)a(d+Ns.width+7,Ns.top+Ns.height*(1-m.fraction)+4,m.text);a(e.width-16,Ns.top-18,`${zo(n)}${v?` in ${v}`:""}`,'text-anchor="end" font-weight="600"')}let u=n.positions?.list[s.position],h=[n.source?.title,u?`position ${u.position}`:""].filter(Boolean).join(", ");return h&&a(16,e.height-16,h),n.hasMeshes&&a(16,e.height-36,`deformation × ${r.factor}`),o.join(`
`)}function RA(n){return n.replace(/[&<>"]/g,e=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[e])}function Tx(n,e){return`<svg xmlns="http://www.w3.org/2000/svg" width="${n.width}" height="${n.height}" viewBox="0 0 ${n.width} ${n.height}" font-family="${TA}" font-size="12">
${e}
</svg>
`}function Ax(n,e){let t=n.display.cut.group,i=t.visible;t.visible=!1;let s=n.scene.snapshot(EA);t.visible=i,n.scene.invalidate();let r=document.createElement("canvas");r.width=s.width,r.height=s.height;let o=r.getContext("2d");return o.fillStyle=e.background,o.fillRect(0,0,r.width,r.height),o.drawImage(s,0,0),r}async function CA(n,e){let t=Ax(n,e),i=new Image;return i.src=`data:image/svg+xml;charset=utf-8,${encodeURIComponent(Tx(e,Ex(n,e)))}`,await i.decode(),t.getContext("2d").drawImage(i,0,0,t.width,t.height),t}function wx(n,e,t){return new Promise((i,s)=>{n.toBlob(r=>r?i(r):s(new Error("the picture cannot be encoded")),e,t)})}async function tp(n,e){if(!n.scene||n.status!=="ready")throw new Error("there is no picture to export");let t=AA(n);if(e==="svg"){let r=Ax(n,t).toDataURL("image/png"),o=`<image width="${t.width}" height="${t.height}" href="${r}"/>
${Ex(n,t)}`;return new Blob([Tx(t,o)],{type:"image/svg+xml"})}let i=await CA(n,t);if(e==="png")return wx(i,"image/png");let s=await wx(i,"image/jpeg",.94);return Mx(new Uint8Array(await s.arrayBuffer()),i.width,i.height,n.source?.title??"")}async function Rx(n,e){let t=await tp(n,e),i=document.createElement("a"),s=(n.source?.title??"view").replace(/[^\p{L}\p{N}._-]+/gu,"_")||"view";i.href=URL.createObjectURL(t),i.download=`${s}.${e}`,i.click(),setTimeout(()=>URL.revokeObjectURL(i.href),1e4)}function Cx(n){let[,e]=Rh(t=>t+1,0);Dt(()=>(e(0),n.subscribe(()=>e(0))),[n])}var PA={parts:"M2.5 3.5h4M2.5 8h4M2.5 12.5h4M9 3.5h4.5M9 8h4.5M9 12.5h4.5",settings:"M2 4.5h7M12 4.5h2M2 11.5h2M7 11.5h7M10.5 3v3M5.5 10v3",fit:"M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10",cube:"M8 1.8l5.5 3v6.4L8 14.2l-5.5-3V4.8zM2.5 4.8L8 8l5.5-3.2M8 8v6.2",perspective:"M2 3.5l12 2v5l-12 2zM8 4.5v7",orthographic:"M2.5 3.5h11v9h-11zM8 3.5v9",mesh:"M2.5 2.5h11v11h-11zM2.5 6.2h11M2.5 9.8h11M6.2 2.5v11M9.8 2.5v11",force:"M3 13L12.5 3.5M7.5 3h5.5v5.5",cut:"M1.5 10.5l5-7h8l-5 7zM3 13.5h4M9.5 13.5h4",plot:"M2.5 2.5v11h11M4.5 10.5l3-4 2.5 2 3.5-5",download:"M8 2v8M4.8 7L8 10.2 11.2 7M2.5 13.5h11",help:"M5.5 6a2.5 2.5 0 1 1 3.6 2.2c-.8.4-1.1.9-1.1 1.8M8 12.6v.4",sun:"M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6M8 1.2v1.6M8 13.2v1.6M1.2 8h1.6M13.2 8h1.6M3.2 3.2l1.1 1.1M11.7 11.7l1.1 1.1M12.8 3.2l-1.1 1.1M4.3 11.7l-1.1 1.1",moon:"M13.2 9.6A5.8 5.8 0 0 1 6.4 2.8a5.6 5.6 0 1 0 6.8 6.8",play:"M5 3l8 5-8 5z",pause:"M5 3v10M11 3v10",next:"M4 3.5l6 4.5-6 4.5zM12.2 3.5v9",previous:"M12 3.5L6 8l6 4.5zM3.8 3.5v9",loop:"M11.5 2l2 2-2 2M13.5 4H5a3 3 0 0 0-3 3M4.5 14l-2-2 2-2M2.5 12H11a3 3 0 0 0 3-3",eye:"M1.5 8S4 3.8 8 3.8 14.5 8 14.5 8 12 12.2 8 12.2 1.5 8 1.5 8M8 6.2a1.8 1.8 0 1 0 0 3.6 1.8 1.8 0 0 0 0-3.6",half:"M8 2.5a5.5 5.5 0 1 0 0 11zM8 2.5a5.5 5.5 0 0 1 0 11M8 5h4.6M8 8h5.5M8 11h4.6",hidden:"M2 2l12 12M6.2 4.1A6 6 0 0 1 8 3.8c4 0 6.5 4.2 6.5 4.2a12 12 0 0 1-1.9 2.3M4 5.2A11 11 0 0 0 1.5 8S4 12.2 8 12.2a6 6 0 0 0 3-.8",pin:"M8 9.5V14M5 9.5h6l-1.3-2V3.3h.8M6.3 7.5L5 9.5M6.3 7.5V3.3h-.8M6.3 3.3h3.4",chevron:"M5.5 3.5L10 8l-4.5 4.5",close:"M3.5 3.5l9 9M12.5 3.5l-9 9"};function tl({name:n}){return _("svg",{class:"cv-icon",viewBox:"0 0 16 16","aria-hidden":"true",children:_("path",{d:PA[n]})})}function Un({icon:n,label:e,shortcut:t,pressed:i,disabled:s,onClick:r}){return _("button",{type:"button",class:"cv-tool","aria-label":e,"aria-pressed":i,disabled:s,title:t?`${e} (${t})`:e,onClick:r,children:_(tl,{name:n})})}function Hn({label:n,value:e,options:t,onChange:i,quiet:s}){return _("label",{class:"cv-field",children:[_("span",{class:s?"cv-hidden":"",children:n}),_("select",{"aria-label":n,value:e,onChange:r=>i(r.currentTarget.value),children:t.map(r=>_("option",{value:r.value,disabled:r.disabled,selected:r.value===e,children:r.label},r.value))})]})}function ds({label:n,value:e,onChange:t}){return _("label",{class:"cv-check",children:[_("input",{type:"checkbox",checked:e,onChange:i=>t(i.currentTarget.checked)}),_("span",{children:n})]})}function nl({label:n,value:e,unit:t,min:i,max:s,disabled:r,onChange:o}){let a=Number.isFinite(e)?String(Number(e.toPrecision(6))):"",[l,c]=Ut(null),u=()=>{if(l===null)return;let h=Number(l.trim().replace(",",".").replace("−","-"));c(null),!(l.trim()===""||!Number.isFinite(h))&&o(Math.min(Math.max(h,i??-1/0),s??1/0))};return _("label",{class:"cv-field",children:[_("span",{children:n}),_("span",{class:"cv-number",children:[_("input",{type:"text",inputMode:"decimal",value:l??a,disabled:r,onInput:h=>c(h.currentTarget.value),onBlur:u,onKeyDown:h=>{h.key==="Enter"&&u(),h.key==="Escape"&&c(null)}}),t?_("span",{class:"cv-unit",children:t}):null]})]})}function np({label:n,value:e,min:t,max:i,step:s="any",text:r,onInput:o}){return _("label",{class:"cv-field cv-slider",children:[_("span",{children:n}),_("input",{type:"range",min:t,max:i,step:s,value:e,"aria-valuetext":r,onInput:a=>o(Number(a.currentTarget.value))})]})}function Vo({title:n,children:e}){return _("section",{class:"cv-section",children:[_("h3",{children:n}),e]})}function Px({core:n}){let e=jt(null);Xp(()=>{e.current.showModal()},[]);let t=()=>{n.help=!1,n.changed(!1)};return _("dialog",{class:"cv-help",ref:e,"aria-labelledby":"cv-help-title",onClose:t,onClick:i=>i.target===e.current&&t(),children:[_("div",{class:"cv-help-head",children:[_("h2",{id:"cv-help-title",children:"Shortcuts"}),_(Un,{icon:"close",label:"Close",onClick:t})]}),_("div",{class:"cv-help-grid",children:bx.map(([i,s])=>_("section",{children:[_("h3",{children:i}),_("dl",{children:s.map(({keys:r,label:o})=>_("div",{children:[_("dt",{children:_("kbd",{children:r})}),_("dd",{children:o})]},r))})]},i))})]})}function IA(n){let{scale:e,bands:t}=n.state.colours,i=[];if(t>0)for(let s=0;s<t;s++){let r=Za(Fo(e,Ja((s+.5)/t,t)));i.push(`${r} ${100*s/t}% ${100*(s+1)/t}%`)}else for(let s=0;s<=20;s++)i.push(`${Za(Fo(e,s/20))} ${5*s}%`);return`linear-gradient(to top, ${i.join(", ")})`}function Ix({core:n}){let{field:e}=n.state.colours;if(e==="plain")return null;let{ticks:t,unit:i}=sh(n);if(n.missingField||t.length===0)return _("div",{class:"cv-legend cv-legend-empty",role:"note",children:[_("strong",{children:zo(n)}),_("span",{children:"No values in this position"})]});let{limits:s}=n.state.colours,r=s==="all"?"all positions":s==="fixed"?"fixed limits":"this position";return _("button",{type:"button",class:"cv-legend","aria-label":`Legend: ${zo(n)} from ${t[0].text} to ${t[t.length-1].text} ${i}. Opens the settings.`,title:"Settings of the colours",onClick:()=>n.update({panels:{settings:!n.state.panels.settings}}),children:[_("span",{class:"cv-legend-title",children:[_("strong",{children:zo(n)}),i?_("span",{class:"cv-legend-unit",children:i}):null]}),_("span",{class:"cv-scale",children:[_("span",{class:"cv-bar",style:{background:IA(n)}}),_("span",{class:"cv-ticks",children:t.map((o,a)=>_("span",{style:{bottom:`${100*o.fraction}%`},children:o.text},a))})]}),_("span",{class:"cv-range",children:[e==="contact_pressure"?"of cells, edges included; ":"",n.progress!==null?`reading … ${Math.round(100*n.progress)} %`:r]})]})}var LA=[{kind:"gear",label:"Gears"},{kind:"shaft",label:"Shafts"},{kind:"bearing",label:"Bearings"},{kind:"body",label:"Bodies"}],Lx={mixed:"visible",visible:"translucent",translucent:"hidden",hidden:"visible"},DA={mixed:"half",visible:"eye",translucent:"half",hidden:"hidden"};function Dx({core:n}){let e=n.parts?.parts??[];return _("aside",{class:"cv-panel cv-parts","aria-label":"Parts",children:[_("div",{class:"cv-scroll",children:LA.map(({kind:t,label:i})=>{let s=e.filter(r=>r.kind===t);return s.length>0?_(NA,{core:n,label:i,parts:s},t):null})}),_("div",{class:"cv-foot",children:_(Hn,{label:"Fixed frame",value:n.state.frame??"",options:[{value:"",label:"Ground"},...e.map(({name:t})=>({value:t,label:t}))],onChange:t=>n.update({frame:t||null})})}),n.source?.provenance?.length?_("details",{class:"cv-provenance",children:[_("summary",{children:"Provenance"}),_("dl",{children:n.source.provenance.map(([t,i])=>_("div",{children:[_("dt",{children:t}),_("dd",{title:i,children:i})]},t))})]}):null]})}function NA({core:n,label:e,parts:t}){let[i,s]=Ut(!0),r=t.map(({name:l})=>l),o=new Set(t.map(l=>Ka(n.state,l))),a=o.size===1?[...o][0]:"mixed";return _("div",{class:"cv-group",role:"group","aria-label":e,children:[_("div",{class:"cv-row cv-row-group",children:[_("button",{type:"button",class:"cv-fold","aria-expanded":i,onClick:()=>s(!i),children:[_(tl,{name:"chevron"}),_("span",{children:e}),_("span",{class:"cv-count",children:t.length})]}),_(Nx,{name:e,value:a,onChange:l=>n.setVisibility(r,l)})]}),i?t.map(l=>_(FA,{core:n,part:l},l.name)):null]})}function FA({core:n,part:e}){let t=Ka(n.state,e);return _("div",{class:`cv-row cv-row-${t}`,children:[_("span",{class:"cv-swatch",style:{background:n.display?.colours[e.index]}}),_("span",{class:"cv-name",title:e.name,children:e.name}),e.copies>1?_("span",{class:"cv-count",title:`${e.copies} teeth`,children:["z ",e.copies]}):null,n.state.frame===e.name?_("span",{class:"cv-pin",title:"Fixed frame",children:_(tl,{name:"pin"})}):null,_(Nx,{name:e.name,value:t,onChange:i=>n.setVisibility([e.name],i)})]})}function Nx({name:n,value:e,onChange:t}){return _("button",{type:"button",class:"cv-eye","aria-label":`${n}: ${e}`,title:`${e}; click for ${Lx[e]}, Alt and click for hidden`,onClick:i=>t(i.altKey?e==="hidden"?"visible":"hidden":Lx[e]),children:_(tl,{name:DA[e]})})}var UA=new Set(["step","time","cycle","roll_angle","position"]);function ip(n){return n.values.reduce((e,t)=>t!==null&&Number.isFinite(t)?Math.max(e,Math.abs(t)):e,0)}function Fx({core:n}){let e=n.source?.outputs?.columns??[],t=e.filter(o=>!UA.has(o.name)&&o.values.some(a=>typeof a=="number"&&Number.isFinite(a))),i=t.find(o=>n.state.plotted.includes(o.name))?.name??t[0]?.name??"",s=t.find(o=>o.name===i),r=e.find(o=>o.name==="time");return _("section",{class:"cv-plots","aria-label":"Plots",children:s?_(Lt,{children:[_("div",{class:"cv-plots-head",children:[_(Hn,{quiet:!0,label:"Output",value:i,options:t.map(o=>({value:o.name,label:o.name.replaceAll("_"," ")})),onChange:o=>n.update({plotted:[o]})}),_(OA,{core:n,column:s,time:r})]}),_(kA,{core:n,column:s,time:r})]}):_("div",{class:"cv-muted",children:"This run has no outputs over the positions."})})}function Ux(n,e){let t=n.positions?.list[n.state.position];if(!t||!e)return n.state.position;let i=0;return e.values.forEach((s,r)=>{Math.abs((s??1/0)-t.time)<Math.abs((e.values[i]??1/0)-t.time)&&(i=r)}),i}function OA({core:n,column:e,time:t}){let i=e.values[Ux(n,t)]??NaN,s=Li(e.unit,ip(e));return _("output",{class:"cv-muted",children:Number.isFinite(i)?`${Vn(i*s.factor,5)} ${s.symbol}`:"no value"})}function kA({core:n,column:e,time:t}){let i=jt(null),s=jt(null),r=Ux(n,t),{theme:o}=n.theme;return Dt(()=>{let a=i.current,l=getComputedStyle(n.element),c=p=>l.getPropertyValue(p).trim(),u=Li(e.unit,ip(e)),h=Li("s",t?ip(t):0),d=t?t.values.map(p=>(p??NaN)*h.factor):e.values.map((p,y)=>y),f=e.values.map(p=>p===null||!Number.isFinite(p)?null:p*u.factor),g=p=>({label:p,labelSize:18,size:44,font:"11px system-ui, sans-serif",labelFont:"11px system-ui, sans-serif",stroke:c("--cv-muted"),grid:{stroke:c("--cv-line"),width:1},ticks:{stroke:c("--cv-line"),width:1,size:4}}),v=new vn({width:a.clientWidth,height:a.clientHeight,scales:{x:{time:!1}},legend:{show:!1},cursor:{y:!1,points:{size:7},drag:{x:!1,y:!1}},series:[{},{stroke:c("--cv-accent"),width:1.75,points:{show:d.length<60}}],axes:[{...g(t?`time in ${h.symbol}`:"position"),size:30},{...g(u.symbol),size:56}],hooks:{drawAxes:[p=>BA(p,c("--cv-mark"))]}},[d,f],a);s.current=v,v.over.addEventListener("click",()=>{let p=v.cursor.idx,y=n.positions?.list??[];if(p==null||y.length===0)return;let A=t?t.values[p]??0:p,S=0;y.forEach((C,R)=>{let x=E=>Math.abs((t?y[E].time:E)-A);x(R)<x(S)&&(S=R)}),n.animation.stop(),n.goTo(S)});let m=new ResizeObserver(()=>v.setSize({width:a.clientWidth,height:a.clientHeight}));return m.observe(a),()=>{m.disconnect(),v.destroy(),s.current=null}},[n,e,t,o]),Dt(()=>{Ox.set(s.current,r),s.current?.redraw(!1)},[r,e,t,o]),_("div",{class:"cv-plot",ref:i,role:"img","aria-label":`${e.name.replaceAll("_"," ")} over ${t?"time":"positions"}`})}var Ox=new WeakMap;function BA(n,e){let t=Ox.get(n),i=t===void 0?void 0:n.data[0][t];if(i===void 0)return;let s=Math.round(n.valToPos(i,"x",!0))+.5,{ctx:r,bbox:o}=n;r.save(),r.strokeStyle=e,r.lineWidth=1.5*(window.devicePixelRatio||1),r.beginPath(),r.moveTo(s,o.top),r.lineTo(s,o.top+o.height),r.stroke(),r.restore()}function kx({core:n}){return _("aside",{class:"cv-panel cv-settings","aria-label":"Settings",children:_("div",{class:"cv-scroll",children:[n.state.colours.field!=="plain"?_(zA,{core:n}):null,n.hasMeshes?_(VA,{core:n}):null,_(HA,{core:n}),_(GA,{core:n}),_(Vo,{title:"Display",children:[_(ds,{label:"Mesh edges",value:n.state.mesh_edges,onChange:e=>n.update({mesh_edges:e})}),_(Hn,{label:"Theme",value:n.state.theme,options:[{value:"system",label:"As the system"},{value:"light",label:"Light"},{value:"dark",label:"Dark"}],onChange:e=>n.update({theme:e})})]})]})})}function zA({core:n}){let{colours:e}=n.state,t=el(n),[i,s]=n.display?.limits??[0,1],r=1e-9*Math.max(Math.abs(i),Math.abs(s)),o=[Math.abs(i)<r?0:i,Math.abs(s)<r?0:s],a=(l,c)=>n.update({colours:{limits:"fixed",min:l,max:c}});return _(Vo,{title:"Colours",children:[_(Hn,{label:"Limits",value:e.limits,options:[{value:"position",label:"This position"},{value:"all",label:"All positions"},{value:"fixed",label:"Fixed"}],onChange:l=>l==="fixed"?a(o[0],o[1]):n.update({colours:{limits:l}})}),_(nl,{label:"Maximum",unit:t.symbol,value:o[1]*t.factor,onChange:l=>a(o[0],l/t.factor)}),_(nl,{label:"Minimum",unit:t.symbol,value:o[0]*t.factor,onChange:l=>a(l/t.factor,o[1])}),_(Hn,{label:"Scale",value:e.scale,options:z_.map(({name:l,label:c})=>({value:l,label:c})),onChange:l=>n.update({colours:{scale:l}})}),_(Hn,{label:"Bands",value:String(e.bands),options:["0","6","8","10","12","16","24"].map(l=>({value:l,label:l==="0"?"Continuous":l})),onChange:l=>n.update({colours:{bands:Number(l)}})}),_(ds,{label:"Mark the extreme values",value:n.state.extremes,onChange:l=>n.update({extremes:l})}),$i(e.field)?null:_(ds,{label:"Show contacts behind surfaces",value:n.state.hidden_contacts,onChange:l=>n.update({hidden_contacts:l})})]})}function VA({core:n}){let{mode:e}=n.state.deformation;return _(Vo,{title:"Deformation",children:[_(ds,{label:"Automatic factor",value:e==="automatic",onChange:t=>n.update({deformation:{mode:t?"automatic":"factor",factor:n.display.factor}})}),_(nl,{label:"Factor",unit:"×",value:n.display.factor,onChange:t=>n.update({deformation:{mode:"factor",factor:t}})})]})}function HA({core:n}){let{cut:e}=n.state,t=n.display.cut,i=()=>{let r=n.scene.camera.direction;return[r.x,r.y,r.z]},s=typeof e.normal=="string"?e.normal:"view";return _(Vo,{title:"Cutting plane",children:[_(ds,{label:"Cut",value:e.on,onChange:r=>Bo(n,{on:r})}),e.on?_(Lt,{children:[_(Hn,{label:"Normal",value:s,options:[{value:"x",label:"x"},{value:"y",label:"y"},{value:"z",label:"z"},{value:"view",label:"View direction"}],onChange:r=>Bo(n,{normal:r==="view"?i():r})}),_(np,{label:"Location",min:t.range[0],max:t.range[1],value:t.offset,text:`${Vn(t.offset*1e3,4)} mm`,onInput:r=>n.update({cut:{offset:r}})}),_(nl,{label:"Coordinate",unit:"mm",value:t.offset*1e3,onChange:r=>n.update({cut:{offset:r/1e3}})}),_(ds,{label:"Flip",value:e.flipped,onChange:r=>n.update({cut:{flipped:r}})})]}):null]})}function GA({core:n}){let{forces:e}=n.state,t=e.bearings||e.meshes;return _(Vo,{title:"Forces",children:[_(ds,{label:"At bearings",value:e.bearings,onChange:i=>n.update({forces:{bearings:i}})}),_(ds,{label:"At meshes",value:e.meshes,onChange:i=>n.update({forces:{meshes:i}})}),t?_(Lt,{children:[_(ds,{label:"Labels",value:e.labels,onChange:i=>n.update({forces:{labels:i}})}),_(np,{label:"Length",min:.2,max:4,value:e.scale,onInput:i=>n.update({forces:{scale:i}})})]}):null]})}var WA=[1,2,5,10,20,30,60];function Bx({core:n}){let e=n.positions?.list??[],{state:t,animation:i}=n;if(e.length===0)return _("div",{class:"cv-timeline cv-muted",children:"No positions yet"});let s=e[Math.min(t.position,e.length-1)],r=e[e.length-1],o=Li("s",Math.max(Math.abs(r.time),Math.abs(e[0].time))),a=`${Vn(s.time*o.factor)} ${o.symbol}`,l=e.length>1;return _("div",{class:"cv-timeline",role:"group","aria-label":"Animation",children:[_(Un,{icon:"previous",label:"Previous position",shortcut:",",disabled:!l,onClick:()=>i.step(-1)}),_(Un,{icon:i.playing?"pause":"play",label:i.playing?"Pause":"Play",shortcut:"K",disabled:!l,onClick:()=>i.toggle()}),_(Un,{icon:"next",label:"Next position",shortcut:".",disabled:!l,onClick:()=>i.step(1)}),_("input",{class:"cv-time",type:"range",min:0,max:e.length-1,step:1,value:t.position,disabled:!l,"aria-label":"Position","aria-valuetext":`position ${s.position}, ${a}`,onInput:c=>{i.stop(),n.goTo(Number(c.currentTarget.value))}}),_("output",{class:"cv-clock",children:[_("span",{children:s.position}),_("span",{class:"cv-muted",children:[" / ",r.position]}),_("span",{class:"cv-clock-time",children:a})]}),_(Hn,{quiet:!0,label:"Speed, positions per second",value:String(t.animation.speed),options:[...new Set([...WA,t.animation.speed])].sort((c,u)=>c-u).map(c=>({value:String(c),label:`${c} / s`})),onChange:c=>n.update({animation:{speed:Number(c)}})}),_(Un,{icon:"loop",label:"Loop",pressed:t.animation.loop,onClick:()=>n.update({animation:{loop:!t.animation.loop}})})]})}var XA=[{value:"",label:"View"},{value:"isometric",label:"Isometric"},{value:"front",label:"Front"},{value:"back",label:"Back"},{value:"left",label:"Left"},{value:"right",label:"Right"},{value:"top",label:"Top"},{value:"bottom",label:"Bottom"}],qA=Object.keys(yi);function zx({core:n,showTitle:e,showTheme:t}){let{state:i,scene:s,status:r}=n,o=r==="ready"&&s!==null,a=i.camera?.projection==="orthographic",l=i.forces.bearings||i.forces.meshes,c=n.theme.theme==="dark";return _("div",{class:"cv-toolbar",role:"toolbar","aria-label":"View",children:[_(Un,{icon:"parts",label:"Parts",shortcut:"B",pressed:i.panels.parts,onClick:()=>n.update({panels:{parts:!i.panels.parts}})}),e?_("h1",{class:"cv-title",title:n.source?.title,children:n.source?.title??"Calyx"}):null,o?_(Lt,{children:[_("span",{class:"cv-rule"}),_(Un,{icon:"fit",label:"Fit",shortcut:"F",onClick:()=>s.camera.fit()}),_(Hn,{quiet:!0,label:"Standard view",value:"",options:XA,onChange:u=>{u&&s.camera.view(u),n.changed(!1)}}),_(Un,{icon:a?"orthographic":"perspective",label:"Orthographic projection",shortcut:"P",pressed:a,onClick:()=>s.camera.setProjection(a?"perspective":"orthographic")}),_("span",{class:"cv-rule"}),_(Hn,{quiet:!0,label:"Colours",value:i.colours.field,options:qA.map(u=>({value:u,label:yi[u].label})),onChange:u=>n.update({colours:{field:u,limits:i.colours.limits==="fixed"?"position":i.colours.limits}})}),n.hasMeshes?_($A,{core:n}):null,_("span",{class:"cv-rule"}),_(Un,{icon:"mesh",label:"Mesh edges",shortcut:"M",pressed:i.mesh_edges,onClick:()=>n.update({mesh_edges:!i.mesh_edges})}),_(Un,{icon:"force",label:"Force vectors",shortcut:"V",pressed:l,onClick:()=>n.update({forces:{bearings:!l,meshes:!l}})}),_(Un,{icon:"cut",label:"Cutting plane",shortcut:"C",pressed:i.cut.on,onClick:()=>{let u=!i.cut.on;Bo(n,{on:u}),u&&n.update({panels:{settings:!0}})}})]}):null,_("span",{class:"cv-space"}),o?_(Lt,{children:[_(Un,{icon:"plot",label:"Plots",shortcut:"G",pressed:i.panels.plots,onClick:()=>n.update({panels:{plots:!i.panels.plots}})}),_(YA,{core:n}),_(Un,{icon:"settings",label:"Settings",shortcut:"S",pressed:i.panels.settings,onClick:()=>n.update({panels:{settings:!i.panels.settings}})})]}):null,t?_(Un,{icon:c?"sun":"moon",label:c?"Light theme":"Dark theme",onClick:()=>n.update({theme:c?"light":"dark"})}):null,_(Un,{icon:"help",label:"Help",shortcut:"?",pressed:n.help,onClick:()=>{n.help=!n.help,n.changed(!1)}})]})}function $A({core:n}){let{mode:e,factor:t}=n.state.deformation,i=e==="automatic"?"automatic":t===0||t===1?String(t):"other";return _(Lt,{children:[_(Hn,{quiet:!0,label:"Deformation",value:i,options:[{value:"automatic",label:"Deformation: automatic"},{value:"0",label:"Undeformed"},{value:"1",label:"True deformation"},{value:"other",label:"Other factor …"}],onChange:s=>{s==="automatic"?n.update({deformation:{mode:"automatic"}}):s==="other"?n.update({deformation:{mode:"factor",factor:n.display.factor||10},panels:{settings:!0}}):n.update({deformation:{mode:"factor",factor:Number(s)}})}}),_("output",{class:"cv-factor","aria-label":"Factor of the deformation",title:"Factor of the displayed deformation",children:["× ",Vn(n.display.factor,3)]})]})}function YA({core:n}){let[e,t]=Ut("");return _("span",{class:"cv-export",children:_(Hn,{quiet:!0,label:e?`Export. ${e}`:"Export the picture",value:"",options:[{value:"",label:"Export"},{value:"png",label:"PNG"},{value:"svg",label:"SVG"},{value:"pdf",label:"PDF"}],onChange:i=>{i&&Rx(n,i).catch(s=>t(String(s))),n.changed(!1)}})})}function Vx({core:n}){let{probe:e,scene:t}=n;if(!e||!t)return null;let i=el(n),{x:s,y:r,z:o}=e.point,a=e.x>t.width-240?{right:t.width-e.x+16}:{left:e.x+16},l=e.y>t.height-120?{bottom:t.height-e.y+12}:{top:e.y+16},c=e.value!==null&&Number.isFinite(e.value);return _("div",{class:"cv-tooltip",role:"status","aria-label":"Value at the pointer","data-value":e.value===null?"":String(e.value),style:{...a,...l},children:[e.value!==null?_("div",{class:"cv-tooltip-value",children:[_("span",{class:"cv-muted",children:yi[n.state.colours.field].label}),_("strong",{children:c?`${Vn(e.value*i.factor,6)} ${i.symbol}`:"no value"})]}):null,_("div",{children:[e.part,e.tooth!==null?`, tooth ${e.tooth}`:"",e.node!==null?`, node ${e.node}`:""]}),_("div",{class:"cv-muted",children:[[s,r,o].map(u=>Vn(Math.round(u*1e6)/1e3,6)).join("  ")," mm"]})]})}var Hx=[{name:"x",azimuth:0,elevation:0,v:[1,0,0]},{name:"y",azimuth:90,elevation:0,v:[0,1,0]},{name:"z",azimuth:-90,elevation:90,v:[0,0,1]}];function Gx({core:n}){let e=jt(null);return Dt(()=>JA(n,e.current)),_("svg",{class:"cv-triad",viewBox:"-34 -34 68 68",ref:e,"aria-hidden":"true",children:Hx.map(({name:t})=>_("g",{class:`cv-axis-${t}`,children:[_("line",{}),_("text",{"text-anchor":"middle","dominant-baseline":"central",children:t})]},t))})}function JA(n,e){let t=n.state.camera??n.scene?.camera.state;if(!t)return;let i=t.azimuth*Math.PI/180,s=t.elevation*Math.PI/180,r=[-Math.sin(i),Math.cos(i),0],o=[-Math.sin(s)*Math.cos(i),-Math.sin(s)*Math.sin(i),Math.cos(s)];Hx.forEach(({v:a},l)=>{let c=a[0]*r[0]+a[1]*r[1]+a[2]*r[2],u=-(a[0]*o[0]+a[1]*o[1]+a[2]*o[2]),h=e.children[l],[d,f]=[h.children[0],h.children[1]];d.setAttribute("x2",String(20*c)),d.setAttribute("y2",String(20*u)),f.setAttribute("x",String(28*c)),f.setAttribute("y",String(28*u)),h.setAttribute("opacity",Math.hypot(c,u)<.12?"0.15":"1")})}function Wx({core:n,stage:e,showTitle:t,showTheme:i}){Cx(n);let{status:s,state:r}=n,o=s==="ready";return _(Lt,{children:[_(zx,{core:n,showTitle:t,showTheme:i}),_("div",{class:"cv-body",children:[o&&r.panels.parts?_(Dx,{core:n}):null,_("div",{class:"cv-centre",children:[_("div",{class:"cv-view",children:[_(ZA,{stage:e}),o?_(Gx,{core:n}):null,o?_(Ix,{core:n}):null,o?_(Vx,{core:n}):null,n.notice?_("div",{class:"cv-notice",role:"alert",children:n.notice}):null,s==="loading"?_("div",{class:"cv-message",role:"status",children:"Reading the shapes …"}):null,o&&n.parts?.parts.length===0?_("div",{class:"cv-message",children:"This run has no parts to display."}):null,s==="failed"?_("div",{class:"cv-message",role:"alert",children:[_("strong",{children:"The view cannot be displayed."}),_("span",{children:n.failure})]}):null]}),o&&r.panels.plots?_(Fx,{core:n}):null,o?_(Bx,{core:n}):null]}),o&&r.panels.settings?_(kx,{core:n}):null]}),n.help?_(Px,{core:n}):null]})}function ZA({stage:n}){let e=jt(null);return Dt(()=>{e.current.append(n)},[n]),_("div",{class:"cv-holder",ref:e})}var il=class{onChange=null;#e;#t;#n=new AbortController;#i=new Set;constructor(e,t={}){let i=document.createElement("div");i.className="calyx-viewer";let s=document.createElement("div");s.className="cv-stage",e.append(i),this.#t=i;let r=new ih(i,s,t.state??{});if(this.#e=r,r.onChange=a=>this.onChange?.(a),Ko(_(Wx,{core:r,stage:s,showTitle:t.showTitle??!0,showTheme:t.showTheme??!0}),i),r.scene){let{canvas:a,camera:l}=r.scene;a.tabIndex=0,a.setAttribute("role","img"),a.setAttribute("aria-label","Three-dimensional view. Arrow keys orbit, plus and minus zoom, question mark shows all shortcuts."),vx(r,a);let c=l.onChange;l.onChange=u=>{if(c?.(u),u)for(let h of this.#i)h.#e.scene?.camera.set(l.state)}}let o=a=>{Sx(r,a)&&a.preventDefault()};i.addEventListener("keydown",o),t.pageKeys&&document.addEventListener("keydown",a=>a.target===document.body&&o(a),{signal:this.#n.signal})}fail(e){this.#e.fail(new Error(e))}show(e){return this.#e.show(e)}reload(){return this.#e.reload()}updatePositions(){return this.#e.updatePositions()}get state(){return structuredClone(this.#e.state)}restore(e){this.#e.update(e)}linkCamera(e){this.#i.add(e),e.#i.add(this);let{camera:t}=this.#e.state;return t&&e.#e.scene?.camera.set(t),()=>{this.#i.delete(e),e.#i.delete(this)}}image(e){return tp(this.#e,e)}get frames(){return this.#e.scene?.frames??0}get triangles(){return this.#e.display?.triangles??0}draw(){this.#e.scene?.draw()}project(e,t){return this.#e.project(e,t)}nodalValue(e,t){return this.#e.nodalValue(e,t)}contactLoads(){let e=this.#e.display?.position?.contacts,t=this.#e.parts?.parts.map(({name:i})=>i)??[];return e?[...O_(e)].map(([i,s])=>{let[r,o]=i.split(" ").map(Number);return{parts:[t[r]??"",t[o]??""],load:s}}):[]}dispose(){for(let e of this.#i)e.#i.delete(this);this.#i.clear(),this.#n.abort(),Ko(null,this.#t),this.#e.dispose(),this.#t.remove()}};var KA=1.4;function Xx(n,{width:e,height:t},i){let s={columns:Math.max(1,Math.floor(e/i.width)),rows:Math.max(1,Math.floor(t/i.height))},r=Math.max(1,Math.min(n,s.columns*s.rows)),o={columns:Math.min(s.columns,r),rows:1},a=0;for(let l=1;l<=Math.min(s.columns,r);l++){let c=Math.ceil(r/l);if(c>s.rows)continue;let u=Math.min(t/c,e/l/KA);u>a&&(a=u,o={columns:l,rows:c})}return o}function qx(n){let[e,t]=Ut({width:0,height:0});return Dt(()=>{if(!n.current)return;let i=new ResizeObserver(([s])=>{if(!s)return;let{width:r,height:o}=s.contentRect;t(a=>a.width===r&&a.height===o?a:{width:r,height:o})});return i.observe(n.current),()=>i.disconnect()},[]),e}function $x({viewers:n,state:e,positions:t}){let[i,s]=Ut(e.colours?.field??"plain"),[r,o]=Ut(e.position??0),a=Math.max(t-1,0),l=Math.min(r,a),c=h=>n().forEach(d=>d.restore(h)),u=h=>{o(h),c({position:h})};return _("div",{class:"scene-bar",role:"group","aria-label":"All scenes",children:[_("select",{"aria-label":"Displayed field",value:i,onChange:h=>{let d=h.currentTarget.value;s(d),c({colours:{field:d}})},children:Object.entries(yi).map(([h,{label:d}])=>_("option",{value:h,children:d},h))}),_("label",{class:"inline position",children:["Position",_("input",{type:"range",min:0,max:a,value:l,disabled:t<2,onInput:h=>u(Number(h.currentTarget.value))}),_("output",{children:[l," / ",a]})]})]})}var Yx=9,jA={width:200,height:150},QA=620,eR=480,tR=500;function Jx({studio:n}){let e=jt(null),t=qx(e),i=n.settings.selected.flatMap(u=>n.runs.filter(h=>h.id===u)),s=i.filter(u=>u.has_view),{modelScene:r}=n,o=r!==null&&(n.scene==="model"||s.length===0),a=Xx(Math.min(s.length,Yx),t,jA),c=t.width>0||s.length===1?s.slice(0,Math.min(a.columns*a.rows,Yx)):[];return _("div",{class:"scene-area",children:[_("div",{class:"scene-bar",children:[r&&s.length>0&&_("div",{class:"chips",role:"group","aria-label":"Displayed scene",children:[_("button",{type:"button",class:"chip","aria-pressed":o,onClick:()=>n.showScene("model"),children:"Model"}),_("button",{type:"button",class:"chip","aria-pressed":!o,onClick:()=>n.showScene("runs"),children:"Results"})]}),!o&&c.length>1&&_("label",{class:"switch",children:[_("input",{type:"checkbox",checked:n.settings.linked,onChange:u=>n.setLinked(u.currentTarget.checked)}),"Link cameras"]}),!o&&c.length===1&&c[0]?.incomplete&&_(Zx,{run:c[0]}),!o&&_(nR,{runs:i,drawn:c})]}),_("div",{class:"scene-space",ref:e,children:[o&&_(oR,{studio:n,scene:r}),!o&&c.length>0&&_(iR,{studio:n,runs:c,columns:a.columns,isCompact:c.length>1&&t.width/a.columns<eR}),!o&&s.length===0&&_(aR,{studio:n,runs:i})]})]})}function Zx({run:n}){return _("span",{class:"incomplete",children:["Incomplete: ",ts(n)]})}function nR({runs:n,drawn:e}){if(e.length===0)return null;let t=n.filter(r=>!e.includes(r)),i=(r,o)=>o.length>0?[`${o.map(a=>rn(a.id)).join(", ")} (${r})`]:[],s=[...i("no space",t.filter(r=>r.has_view)),...i("no view files",t.filter(r=>!r.has_view))];return s.length===0?null:_("span",{class:"not-drawn",role:"status",children:["Not drawn: ",s.join(", ")]})}function iR({studio:n,runs:e,columns:t,isCompact:i}){let s=jt(new Map),[r,o]=Ut(0),{linked:a}=n.settings;return Dt(()=>{if(!a)return;let l=[...s.current.values()],c=l.slice(1).map(u=>l[0]?.linkCamera(u));return()=>c.forEach(u=>u?.())},[r,a,e.map(l=>l.id).join()]),_(Lt,{children:[i&&_($x,{viewers:()=>[...s.current.values()],state:n.settings.scene??{},positions:Math.max(...e.map(l=>l.positions??0))}),_("div",{class:`scenes ${i?"compact":""}`,style:{gridTemplateColumns:`repeat(${t}, minmax(0, 1fr))`},children:e.map(l=>_(sR,{studio:n,run:l,hasTitle:e.length>1,onViewer:c=>{c?s.current.set(l.id,c):s.current.delete(l.id),o(u=>u+1)}},l.id))})]})}function sR({studio:n,run:e,hasTitle:t,onViewer:i}){let s=jt(null),r=jt(null);Dt(()=>{if(!s.current)return;let a=Kx(s.current,n,!t);return r.current=a,i(a),a.show(rR(n,e.id)),()=>{r.current=null,i(null),a.dispose()}},[e.id,t]),jx(r);let o=jt(!0);return Dt(()=>{o.current?o.current=!1:e.id==="preview"?r.current?.reload():r.current?.updatePositions()},[e.status,e.positions,e.id==="preview"?n.results[e.id]:null]),_("figure",{class:"scene",children:[t&&_("figcaption",{children:[rn(e.id),e.incomplete&&_(Zx,{run:e})]}),_("div",{ref:s,class:"viewer"})]})}function Kx(n,e,t){let i=e.settings.scene??{},s=t&&n.clientWidth>=QA,r=s?i.panels:{parts:!1,settings:!1,plots:!1},o=new il(n,{state:{...i,theme:kl(),...r&&{panels:r}},showTheme:!1,showTitle:!1}),a=0;return o.onChange=l=>{window.clearTimeout(a),a=window.setTimeout(()=>e.setScene(s?l:{...l,panels:i.panels}),tR)},o}function jx(n){let e=Vl();Dt(()=>n.current?.restore({theme:e}),[e])}function rR(n,e){let t=[],i=n.results[e];return{title:rn(e),provenance:i?pd(i):[],outputs:null,parts:()=>Dh(wi(e,"/files/view/parts.bin")),positions:async()=>(t=(await is(wi(e,"/view"))).positions.map(({position:r,time:o})=>({position:r,time:o??r})),t),position:s=>{let r=t[s];return r?Dh(wi(e,`/files/view/${Qa(r.position)}`)):Promise.reject(new Error(`position ${s} does not exist`))}}}function oR({studio:n,scene:e}){let t=jt(null),i=jt(null),s=jt(e);s.current=e,jx(i),Dt(()=>{if(!t.current)return;let o=Kx(t.current,n,!0);return i.current=o,o.show({title:"Model",parts:async()=>s.current.parts,positions:async()=>[{position:0,time:0}],position:async()=>s.current.position}),()=>{i.current=null,o.dispose()}},[]);let r=jt(e);return Dt(()=>{r.current!==e&&i.current?.reload(),r.current=e},[e]),_("div",{ref:t,class:"viewer"})}function aR({studio:n,runs:e}){let t=e[0]?.status;return _("div",{class:"no-scene",children:[_("p",{children:lR(n,t)}),t==="finished"&&_("p",{class:"muted",children:"Runs without positions, and runs of older versions, have none."})]})}function lR(n,e){return e==="running"||e==="elsewhere"?"This run has not written view files yet.":e==="finished"?"This run has no view files.":e?"This run ended before its first position.":n.model?.broken?"The model has errors.":n.check&&!n.check.runnable?"The params in the form have errors.":"Run the model to see its parts."}function Qx({studio:n}){let[,e]=Ut(0);Dt(()=>n.subscribe(()=>e(i=>i+1)),[]),cR(n);let t=n.model;return _(Lt,{children:[_(uR,{studio:n}),_(dR,{studio:n}),_("main",{class:"columns",children:[_("aside",{class:"left","aria-label":"Params",children:[t?.broken&&_(bl,{text:t.rendered,isError:!0}),(!t?.broken||t.params.length>0)&&_(sm,{studio:n})]}),_("div",{class:"centre",children:[_(Jx,{studio:n}),_(Ug,{studio:n})]}),_("aside",{class:"right","aria-label":"Runs and results",children:[_(zg,{studio:n}),_(om,{studio:n}),_(Wg,{studio:n}),_(Vg,{studio:n}),_(kg,{studio:n})]})]})]})}function cR(n){Dt(()=>{let e=t=>{t.key==="Enter"&&(t.ctrlKey||t.metaKey)&&n.canRun&&n.run()};return window.addEventListener("keydown",e),()=>window.removeEventListener("keydown",e)},[])}function uR({studio:n}){let e=n.model?.model??"",t=Wr(e)||"Calyx studio";return Dt(()=>{document.title=e?`${t} – Calyx studio`:"Calyx studio"},[t]),_("header",{class:"top",children:[_("h1",{title:e,children:t}),_("p",{class:"about",children:Gr(n.model?.doc??"").split(`
`)[0]}),_(hR,{})]})}function hR(){let[n,e]=Ut(Bl());return _("label",{class:"inline theme",children:["Theme",_("select",{value:n,onChange:t=>{let i=t.currentTarget.value;e(i),zl(i)},children:[_("option",{value:"system",children:"System"}),_("option",{value:"light",children:"Light"}),_("option",{value:"dark",children:"Dark"})]})]})}function dR({studio:n}){return n.isConnected?n.notice?_("div",{class:"notice",role:"alert",children:[_("span",{children:[_(Mi,{text:n.notice.message}),n.notice.help&&_("span",{class:"help",children:[" ",_(Mi,{text:n.notice.help})]})]}),_("button",{type:"button",class:"quiet",onClick:()=>n.dismiss(),children:"Dismiss"})]}):null:_(fR,{studio:n})}function fR({studio:n}){let e=_("code",{children:n.command});return _("div",{class:"notice error",role:"alert",children:[n.connection==="ended"&&_("span",{children:["The studio has ended; this page keeps the form. To go on, start ",e," and open the address that it prints. This page then reconnects."]}),n.connection==="refused"&&_("span",{children:"A new studio runs at this address. Open the address that it printed, in this browser: this page then reconnects, with its form."}),n.connection==="other"&&_("span",{children:["The studio at this address is another one: of another model, or of another version of Calyx. This page reconnects to"," ",e," of its own version; ",_("a",{href:"/",children:"reload"})," it for the other studio."]})]})}var pR=1e3,rh=class{constructor(e,t,i){this.about=e;this.listen=t;this.onChange=i;this.#t()}about;listen;onChange;state="connected";#e=0;#t(){let e=new EventSource("/api/events");this.listen(e),e.onopen=()=>this.#n("connected"),e.onerror=()=>{e.close(),this.#i()}}#n(e){this.state=e,this.onChange()}async#i(){window.clearTimeout(this.#e);let e=await this.#r();if(e==="connected"){this.#t();return}e!==this.state&&this.#n(e),this.#e=window.setTimeout(()=>{this.#i()},pR)}async#r(){try{let{subject:e,calyx:t}=await is("/api/studio");return e===this.about.subject&&t===this.about.calyx?"connected":"other"}catch(e){return e instanceof ns&&e.status===401?"refused":"ended"}}};var mR=1,ev=180,gR=700,_R=300,oh=class{model=null;withoutModel=!1;values={};analysis={};analysisSettings=[];check=null;isChecking=!1;runs=[];progress={};results={};settings={automatic:!0,linked:!0,analysisOpen:!0,selected:[],scene:null};modelScene=null;scene="runs";notice=null;isStarting=!1;#e=new Set;#t=0;#n=0;#i=!1;#r=!1;#s=null;#o=null;#l=new Map;#u=null;#h=!1;#c="";#d=new Set;subscribe(e){return this.#e.add(e),()=>this.#e.delete(e)}#a(){for(let e of this.#e)e()}async load(){await this.#f(async()=>{let e=await is("/api/studio");this.#s=e,this.withoutModel=e.model===null,this.analysisSettings=e.settings,this.withoutModel||await this.#g(),e.opened&&(this.settings.selected=[e.opened])}),this.#h=!0,window.addEventListener("pagehide",()=>this.#_()),document.addEventListener("visibilitychange",()=>{document.visibilityState==="hidden"&&this.#_()}),this.#S()}async#g(){let e=await is("/api/session");this.values={...e.params};let t=new Set(this.analysisSettings.map(s=>s.name));this.analysis=Object.fromEntries(Object.entries(e.settings??{}).filter(([s])=>t.has(s))),this.#r=!0;let i=e.view??{};typeof i.automatic=="boolean"&&(this.settings.automatic=i.automatic),typeof i.linked=="boolean"&&(this.settings.linked=i.linked),typeof i.analysisOpen=="boolean"&&(this.settings.analysisOpen=i.analysisOpen),Array.isArray(i.selected)&&(this.settings.selected=i.selected.filter(s=>typeof s=="string"&&s!=="preview")),this.settings.scene=i.scene??null}#S(){if(!this.#s)return;let e=!0;this.#o=new rh(this.#s,t=>this.#M(t),()=>{this.isConnected&&!e&&(this.notice=null,this.#c=""),e=this.isConnected,this.#_(),this.#a()})}get connection(){return this.#o?.state??"connected"}get isConnected(){return this.connection==="connected"}#M(e){e.addEventListener("model",()=>{this.#y()}),e.addEventListener("runs",()=>{this.#w()}),e.addEventListener("progress",t=>{let{id:i,...s}=JSON.parse(t.data);this.progress[i]=s,this.settings.selected.includes(i)&&this.#E(i),this.#a()})}async#y(){this.withoutModel||await this.#f(async()=>{let e=await is("/api/model");if(e.broken){let{params:s,outputs:r,doc:o}=this.model??e;this.model={...e,params:s,outputs:r,doc:o},this.#u?.abort(),this.check=null,this.isChecking=!1;return}this.model=e,this.#r&&(this.values=this.#b()),this.#r=!1;let t=new Set(e.params.map(s=>s.name)),i=Object.keys(this.values).filter(s=>!t.has(s));for(let s of i)delete this.values[s];if(i.length>0){let s=`the model has no param ${i.map(r=>`\`${r}\``).join(", ")} any more`;this.notice={message:s,help:"its value in the form was dropped"}}this.#p(0)})}async#w(){await this.#f(async()=>{let{runs:e}=await is("/api/runs"),t=new Map(this.runs.map(r=>[r.id,JSON.stringify(r)]));this.runs=e;let i=new Set(e.map(r=>r.id));for(let r of[...this.#d])i.has(r)?this.#d.delete(r):i.add(r);let s=this.settings.selected.filter(r=>!i.has(r)&&t.has(r)&&r!=="preview");s.length>0&&(this.notice={message:`${s.map(rn).join(", ")}: the directory was deleted`,help:""}),this.settings.selected=this.settings.selected.filter(r=>i.has(r));for(let r of Object.keys(this.results))i.has(r)||delete this.results[r];for(let r of e){r.progress&&(this.progress[r.id]=r.progress);let o=t.get(r.id)!==JSON.stringify(r)||r.id==="preview";this.settings.selected.includes(r.id)&&(o||!this.results[r.id])&&this.#x(r.id)}if(this.settings.selected.length===0){let r=e.findLast(o=>o.status==="finished");r&&this.select([r.id])}})}#E(e){if(this.#l.has(e))return;let t=window.setTimeout(()=>{this.#l.delete(e),this.#x(e)},gR);this.#l.set(e,t)}async#x(e){try{this.results[e]=await is(wi(e))}catch(t){t instanceof ns&&t.status===404||this.#v(t),delete this.results[e]}this.#a()}param(e){return this.model?.params.find(t=>t.name===e)}value(e){return this.values[e.name]??e.default??""}setValue(e,t){let i=this.param(e);i?.independent&&i.default===t?delete this.values[e]:this.values[e]=t,this.#p(ev),this.#a()}reset(e){delete this.values[e],this.#p(0),this.#a()}get form(){return{params:{...this.values},settings:{...this.analysis}}}get changes(){return Object.keys(this.values).length+Object.keys(this.analysis).length}setAnalysis(e,t){t===""?delete this.analysis[e]:this.analysis[e]=t,this.#p(ev),this.#a()}resetAll(){this.analysis={},this.setValues({})}setValues(e){this.values={};for(let[t,i]of Object.entries(e)){let s=this.param(t);(!s?.independent||s.default!==i)&&(this.values[t]=i)}this.#p(0),this.#a()}#p(e){this.modelScene&&(this.scene="model"),window.clearTimeout(this.#t),this.isChecking=!0,this.#t=window.setTimeout(()=>{this.#T()},e),this.#m()}async#T(){if(!this.model||this.model.broken){this.isChecking=!1;return}this.#u?.abort();let e=new AbortController;this.#u=e;let{form:t}=this;await this.#f(async()=>{let i=await xs("POST","/api/check",t,e.signal);e.signal.aborted||(this.check=i,this.isChecking=!1,i.version!==this.model?.version&&await this.#y(),await Promise.all([this.#R(t),this.#A(t,e.signal)]))}),this.#u===e&&(this.isChecking=!1),this.#a()}get canRun(){return this.isConnected&&!this.isStarting&&!!this.check?.runnable}get command(){let e=this.#s?.model||(this.runs.find(i=>i.id==="opened")?.directory??"");return`calyx studio ${/^[\w./@%+,:=-]*$/.test(e)?e:`'${e.replaceAll("'","'\\''")}'`}`.trim()+(location.port&&` --port ${location.port}`)}get isQuick(){return this.check?.plan!=null&&this.check.plan.time<mR}async#A(e,t){let{errors:i,setting_errors:s}=this.check??{};if(!(Object.keys({...i,...s}).length>0))try{this.modelScene=await em(e,t)}catch(r){if(!(r instanceof ns))throw r;this.modelScene=null}}showScene(e){this.scene=e,this.#a()}async#R(e){let t=JSON.stringify([this.check?.version,e]);if(!this.settings.automatic||!this.check?.runnable||!this.isQuick||this.#c===t)return;this.#c=t,await xs("POST","/api/preview",e),this.#d.add("preview"),this.settings.selected.length<=1&&this.select(["preview"])}setAutomatic(e){this.settings.automatic=e,this.#m(),this.#a(),e&&this.#p(0)}setAnalysisOpen(e){e!==this.settings.analysisOpen&&(this.settings.analysisOpen=e,this.#m())}setLinked(e){this.settings.linked=e,this.#m(),this.#a()}setScene(e){this.settings.scene=e,this.#m()}async run(){this.isStarting=!0,this.#a(),await this.#f(async()=>{let{id:e}=await xs("POST","/api/runs",this.form);this.#d.add(e),this.select([e])}),this.isStarting=!1,this.#a()}async cancel(e){await this.#f(()=>xs("POST",wi(e,"/cancel"),{}))}async continue(e){await this.#f(async()=>{await xs("POST",wi(e,"/continue"),{}),delete this.progress[e]})}select(e){this.settings.selected=e,this.scene="runs";for(let t of e)this.results[t]||this.#x(t);this.#m(),this.#a()}toggle(e){let{selected:t}=this.settings;this.select(t.includes(e)?t.filter(i=>i!==e):[...t,e])}useForm(e){let t={};for(let[i,s]of Object.entries(e.params??{}))this.param(i)&&s.at_default!==!0&&(t[i]=s.text);this.analysis={...e.settings},this.setValues(t)}dismiss(){this.notice=null,this.#a()}fail(e){this.#v(e),this.#a()}#v(e){if(e instanceof DOMException&&e.name==="AbortError")return;let t=e instanceof ns?e.help:"";this.notice={message:e instanceof Error?e.message:String(e),help:t}}async#f(e){try{await e()}catch(t){this.#v(t)}this.#a()}#m(){!this.#h||this.withoutModel||(this.#i=!0,window.clearTimeout(this.#n),this.#n=window.setTimeout(()=>this.#_(),_R))}#_(){if(window.clearTimeout(this.#n),!this.#i||!this.isConnected)return;this.#i=!1;let e={version:1,params:this.#b(),settings:this.analysis,view:{...this.settings}};this.#f(async()=>{try{await tm(e)}catch(t){throw this.#i=!0,t}})}#b(){let e=([t,i])=>i.trim()!==""||this.param(t)?.kind==="text";return Object.fromEntries(Object.entries(this.values).filter(e))}};var tv=document.getElementById("studio");if(tv){zl(Bl());let n=new oh;Ko(_(Qx,{studio:n}),tv),n.load()}})();
/*! three

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
/*! preact

The MIT License (MIT)

Copyright (c) 2015-present Jason Miller

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.
*/
/*! uplot

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
