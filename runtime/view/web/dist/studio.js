"use strict";(()=>{var Dt,Vm,xb,$s,od,Ul,Hm,Ll,Gm,ld,ad,vb,ma=Symbol.for("pv"),Ol={},kl=[],yb=/^m(i|n|o|s|text|space)$/,cd=Array.isArray,Wm=kl.slice,br=Object.assign;function _r(n){n&&n.parentNode&&n.remove()}function Nl(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:ma,__v:s||++Vm,__i:-1,__u:0};return!s&&Dt.vnode&&Dt.vnode(r),r}function ot(n){return n.children}function Dl(n,e){this.props=n,this.context=e,this.__g=0}function qs(n,e){if(e==null)return n.__&&qs(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:qs(n)}function _b(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=br({constructor:ma},t)).__v=t.__v+1,Dt.vnode&&Dt.vnode(e),ud(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||qs(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,Zm(s,e,r),t.__=t.__e=null,e.__e!=i&&Xm(e))}function Xm(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),Xm(n)}function Bm(n){(8&n.__g||(n.__g|=8,$s.push(n),Ul++))&&od==Dt.debounceRendering||((od=Dt.debounceRendering)||queueMicrotask)($m)}function $m(){try{for(var n,e=1;$s.length;)$s.length>e&&$s.sort(Hm),n=$s.shift(),e=$s.length,8&n.__g&&_b(n)}finally{(Ul=$s.length)&&(od||queueMicrotask)($m)}}function qm(n,e,t,i,s,r,o,a,l,c,u){var f,h,d,p,v,g,m=i.__k||kl,y=e.length;for(l=bb(t,e,m,l,y),f=0;f<y;f++)(d=t.__k[f])!=null&&(h=~d.__i&&m[d.__i]||Ol,d.__i=f,g=ud(n,d,h,s,r,o,a,l,c,u),p=d.__e,(h.ref!=d.ref||8&h.__u)&&(h.ref&&hd(h.ref,null,d,h),d.ref&&u.push(d.ref,d.__c||p,d)),v=v||p,4&d.__u?(l=Ym(d,l,n,!h.__v),h.__e&&(h.__e=null)):typeof d.type=="function"&&g!==void 0?l=g:p&&(l=p.nextSibling),d.__u&=-21);return t.__e=v,l}function bb(n,e,t,i,s){var r,o,a,l,c,u,f,h,d,p=t.length,v=p,g=0,m=0,y=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=y[r]=Nl(null,o):cd(o)?o=y[r]=Nl(ot,{children:o}):o.constructor===ma&&o.__b?o=y[r]=Nl(o.type,o.props,o.key,o.ref,o.__v):y[r]=o,l=r+g,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=Sb(o,t,l,v))&&(v--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?g--:c==l+1?g++:c!=l&&(c>l?g--:g++,m=1)):(~c||(s>p?g--:s<p&&g++),typeof o.type!="function"&&(o.__u|=4))):y[r]=null;if(m){for(u=[],f=[],r=0;r<s;r++)if((o=y[r])&&16&o.__u){for(g=0,h=u.length;g<h;)u[d=g+h>>1]<o.__i?g=d+1:h=d;u[g]=o.__i,f[r]=g+1}for(g=u.length;r--;)f[r]&&(f[r]==g?g--:y[r].__u|=4)}if(v)for(r=0;r<p;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=qs(a)),dd(a,a));return i}function Ym(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=Ym(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=qs(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Sb(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function zm(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Il(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||zm(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||zm(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=ad[e]||(ad[e]=Mb(e)),(n.__a||(n.__a={}))[e]=ld,r=e!=(e=e.replace(Gm,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function Mb(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[Ll]==null)e[Ll]=ld++;else if(e[Ll]<this.__a[n])return;return t(Dt.event?Dt.event(e):e)}}}function ud(n,e,t,i,s,r,o,a,l,c){var u,f,h,d,p,v,g,m,y,M,b,R,T,_,E,U,N,L,B=e.type;if(e.constructor!==ma)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,f=r=[],u.nodeType==8?a=Fl(u,r):r.push(u),a=r[0]||a),(u=Dt.__b)&&u(e);e:if(typeof B=="function"){h=o.length;try{if(m=e.props,y=(u=B.prototype)&&u.render,M=(u=B.contextType)&&i[u.__c],b=u?M?M.props.value:u.__:i,(d=t.__c)?(e.__c=d,2&d.__g&&(d.__g|=1)):(y?e.__c=d=new B(m,b):(e.__c=d=new Dl(m,b),d.constructor=B,d.render=Eb),M&&M.sub(d),d.state||(d.state={}),d.__n=i,d.__g|=8,d.__h=[],d.__k=[]),y&&(d.__s||(d.__s=d.state),B.getDerivedStateFromProps&&(d.__s==d.state&&(d.__s=br({},d.__s)),br(d.__s,B.getDerivedStateFromProps(m,d.__s)))),p=d.props,v=d.state,d.__v=e,t.__c){if(m!==p&&y&&!B.getDerivedStateFromProps&&d.componentWillReceiveProps&&d.componentWillReceiveProps(m,b),e.__v==t.__v&&!(8&d.__g)||!(4&d.__g)&&d.shouldComponentUpdate&&d.shouldComponentUpdate(m,d.__s,b)===!1){e.__v!=t.__v&&(d.props=m,d.state=d.__s,d.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(z){z&&(z.__=e)}),kl.push.apply(d.__h,d.__k),d.__k=[],d.__h.length&&o.push(d),a=qs(t);break e}d.componentWillUpdate&&d.componentWillUpdate(m,d.__s,b),y&&d.componentDidUpdate&&d.__h.push(function(){d.componentDidUpdate(p,v,g)})}else y&&!B.getDerivedStateFromProps&&d.componentWillMount&&d.componentWillMount(),y&&d.componentDidMount&&d.__h.push(d.componentDidMount);d.context=b,d.props=m,d.__P=n,d.__g&=-5,R=Dt.__r,T=y?25:0;do d.__g&=-9,R&&R(e),u=d.render(d.props,d.state=d.__s,d.context);while(8&d.__g&&++T<25);y&&(kl.push.apply(d.__h,d.__k),d.__k=[]),d.state=d.__s,d.getChildContext&&(i=br({},i,d.getChildContext())),y&&t.__c&&d.getSnapshotBeforeUpdate&&(g=d.getSnapshotBeforeUpdate(p,v)),_=u&&u.type===ot&&u.key==null?u.props.children:u,m.__P&&(u=a,s=(n=m.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(z){z&&dd(z,z)}),t.__k=null),a=t.__k?qs(t,0):null),a=qm(n,cd(_)?_:[_],e,t,i,s,r,o,a,l,c),m.__P&&(e.__e=null,a=u),e.__u&=-161,f&&f.some(_r),d.__h.length&&o.push(d),1&d.__g&&(d.__g&=-4)}catch(z){if(o.length=h,e.__v=null,l||r)if(z&&z.then){if(e.__u|=128|l,r){for(~(N=r.indexOf(a||void 0))||(N=r.length);(L=r[N-1])&&L.nodeType==8;)N--;for(;N<r.length;N++)if(L=r[N])if(r[N]=null,E){if(L==U)break}else{if(L.nodeType!=8)break;L.data.startsWith("$s")&&(U=Fl(E=L))}}if(!E){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;E=a}(u=Fl(E=e.__c.__z||(e.__c.__z=E)))?(e.__e=E,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(_r);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),z&&z.then||Jm(e),Dt.__e(z,e,t)}}else a=e.__e=wb(t.__e,e,t,i,s,r,o,l,c,n);return(u=Dt.diffed)&&u(e),a}function Fl(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function Jm(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(Jm))}function Zm(n,e,t){for(var i=0;i<t.length;)hd(t[i++],t[i++],t[i++]);Dt.__c&&Dt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Dt.__e(r,s.__v)}})}function wb(n,e,t,i,s,r,o,a,l,c){var u,f,h,d,p,v,g,m,y=t.props||Ol,M=e.props,b=e.type;if(b=="svg"?s="http://www.w3.org/2000/svg":b=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((p=r[u])&&(b?p.localName==b:p.nodeType==3)){n=p,r[u]=null;break}}if(!n){if(m=c.ownerDocument||document,!b)return m.createTextNode(M);n=m.createElementNS(s,b,M.is?M:c),a&&(Dt.__m&&Dt.__m(e,r),a=!1),r=null}if(b){if(c=b=="template"&&n.content||n,r=b=="textarea"&&M.defaultValue!=null?null:r&&Wm.call(c.childNodes),!a&&r)for(y={},u=0;u<n.attributes.length;u++)y[(p=n.attributes[u]).name]=p.value;for(u in y)p=y[u],u=="dangerouslySetInnerHTML"?h=p:u=="children"||u in M||u=="value"&&"defaultValue"in M||u=="checked"&&"defaultChecked"in M||Il(n,u,null,p,s);for(u in M)p=M[u],u=="children"?d=p:u=="dangerouslySetInnerHTML"?f=p:u=="value"?v=p:u=="checked"?g=p:a&&typeof p!="function"||y[u]===p||Il(n,u,p,y[u],s);f?(a||h&&(f.__html==h.__html||f.__html==n.innerHTML)||(n.innerHTML=f.__html),e.__k=[]):(h&&(n.textContent=""),(b=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&yb.test(b))&&(s="http://www.w3.org/1999/xhtml"),qm(c,cd(d)?d:[d],e,t,i,s,r,o,r?r[0]:t.__k&&qs(t,0),a,l),r&&r.some(_r)),a&&b!="textarea"||(u="value",b=="progress"&&v==null?n.removeAttribute(u):v==null||v===n[u]&&(b!="progress"||v)||Il(n,u,v,y[u],s),u="checked",g!=null&&g!=n[u]&&Il(n,u,g,y[u],s))}else y===M||a&&n.data==M||(n.data=M);return n}function hd(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Dt.__e(s,t)}}function dd(n,e,t){var i,s,r,o;if(Dt.unmount&&Dt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||hd(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Dt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&dd(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=Fl(i,r=[]))&&(i==n.__e&&r.some(_r),_r(s),_r(i)),t||_r(n.__e),n.__e=n.__c=n.__=null}function Eb(n,e,t){return this.constructor(n,t)}function ga(n,e){var t,i,s,r;Dt.__&&Dt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=Nl(ot,{children:[n]}),s=[],r=[],ud(e,e.__k,i||Ol,Ol,e.namespaceURI,i?null:e.firstChild?Wm.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),Zm(s,e.__k,r),e.__k.props.children=null}Dt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw Ul=0,n}},Vm=0,xb=function(n){return n!=null&&n.constructor===ma},Dl.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=br({},this.state)),typeof n=="function"&&(n=n(br({},t),this.props)),n&&(br(t,n),this.__v&&(e&&this.__k.push(e),Bm(this)))},Dl.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),Bm(this))},Dl.prototype.render=ot,$s=[],Ul=0,Hm=function(n,e){return n.__v.__b-e.__v.__b},Ll=Symbol(),Gm=/(PointerCapture)$|Capture$/i,ld=0,ad={},vb=0;var ro,bn,fd,Km,pd=Object.is,Bl=0,og=[],md=[],pn=Dt,jm=pn.__b,Qm=pn.__r,eg=pn.diffed,tg=pn.__c,ng=pn.unmount,ig=pn.__;function zl(n,e){pn.__h&&pn.__h(bn,n,Bl||e),Bl=0;var t=bn.__H||(bn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function Tt(n){return Bl=1,xd(lg,n)}function xd(n,e,t){var i=zl(ro++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):lg(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);pd(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=bn,!bn.__f)){bn.__f=!0;var s=bn.shouldComponentUpdate;bn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(h){h.__N&&(c=!0,pd(h.__[0],h.__N[0])||(u=!0))}),s){var f=s.call(this,r,o,a);return c?f||u:f}return!c||u}}return i.__}function At(n,e){var t=zl(ro++,3);!pn.__s&&vd(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,bn.__H.__h.push(t))}function ag(n,e){var t=zl(ro++,4);!pn.__s&&vd(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,bn.__h.push(t))}function Gt(n){return Bl=5,Tb(function(){return{current:n}},[])}function Tb(n,e){var t=zl(ro++,7);return vd(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function Ab(){var n;do{for(;n=md.shift();)try{xa(n)}catch(t){pn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=og.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(xa),e.__h.some(gd),e.__h=[]}catch(t){e.__h=[],pn.__e(t,n.__v)}}}while(md.length)}pn.__b=function(n){bn=null,jm&&jm(n)},pn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),ig&&ig(n,e)},pn.__r=function(n){Qm&&Qm(n),ro=0;var e=(bn=n.__c).__H;e&&(fd==bn?bn.__h=[]:(e.__h.some(xa),e.__h.some(gd),ro=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),fd=bn},pn.diffed=function(n){eg&&eg(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&rg(og.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),fd=bn=null},pn.__c=function(n,e){e.some(function(t){try{t.__h.some(xa),t.__h=t.__h.filter(function(i){return!i.__||gd(i)})}catch(i){t.__h=[function(){throw i}]}}),tg&&tg(n,e)},pn.unmount=function(n){ng&&ng(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,rg(md.push(s))}else xa(s)}catch(r){e=r}}),i.__H=void 0,e&&pn.__e(e,i.__v))};var sg=typeof requestAnimationFrame=="function";function Cb(n){var e,t=function(){clearTimeout(i),sg&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);sg&&(e=requestAnimationFrame(t))}function rg(n){n!=1&&Km==pn.requestAnimationFrame||((Km=pn.requestAnimationFrame)||Cb)(Ab)}function xa(n){var e=bn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),bn=e}function gd(n){var e=bn;n.__c=n.__(),bn=e}function vd(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!pd(t,n[i])})}function lg(n,e){return typeof e=="function"?e(n):e}function ti(n){if(n==null||Number.isNaN(n))return"–";if(n===0)return"0";let e=Math.abs(n);return e>=1e6||e<1e-4?n.toExponential(3).replace("e+","e"):String(Number(n.toPrecision(5)))}function va(n){return n<.095?`${Math.ceil(1e3*n)} ms`:n<9.5?`${n.toFixed(1)} s`:n<600?`${Math.round(n)} s`:n<7200?`${Math.round(n/60)} min`:`${(n/3600).toFixed(1)} h`}function yd(n){return n<1e6?"below 1 MB":n<1e9?`${Math.ceil(1e-6*n)} MB`:`${(1e-9*n).toFixed(1)} GB`}function cg(n){let e=100*n;return e>=1?`${e.toFixed(1)} %`:`${Number(e.toPrecision(1))} %`}function ug(n){if(n===null)return"";let e=new Date(1e3*n);return`${e.toLocaleDateString(void 0,{year:"numeric",month:"short",day:"numeric"})} ${e.toLocaleTimeString()}`}function hg(n){if(n===null)return"";let e=new Date(1e3*n),t=e.toDateString()===new Date().toDateString(),i=e.toLocaleTimeString(void 0,{hour:"2-digit",minute:"2-digit"});return t?i:`${e.toLocaleDateString()} ${i}`}function en(n){return n==="preview"?"Automatic run":n==="model"?"Run from the command line":n==="opened"?"Opened run":`Run ${Number(n.replace("run-",""))}`}function tn(n){return n.replaceAll("_"," ")}function oo(n){return n.replace(/([^\n])\n(?!\n)/g,"$1 ")}function Sr(n){return n.split("/").pop()??n}function Vl(n,e){return e?`${n} ${e}`:n}function Hl({entered:n,text:e,unit:t}){return n!==void 0?_s(n)?Vl(n.trim(),t):n.trim():Vl(_s(e)&&e.length>8?ti(Number(e)):e,t)}function _s(n){return/^\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*$/.test(n)}function ya(n){let e=n.positions??0;return n.incomplete?n.total!==null&&n.total>=e?`${e} of ${n.total}`:String(e):n.positions===null?"":String(e)}function os(n){let e=n.total===null?n.positions===1:n.total===1;return`${ya(n)} ${e?"position":"positions"}`}function Gl(n){return n==="vtu"?"meshes with stresses":tn(n)}function Wl(n){return n==="TRUE"?"yes":n==="FALSE"?"no":n}function Ys(n,e){let[t,i]=[n.trim(),e.trim()];return t===i||_s(t)&&_s(i)&&Number(t)===Number(i)}var Rb=Symbol.for("pv"),Pb=0;function x(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Rb,__v:--Pb,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),Dt.vnode&&Dt.vnode(c),c}function oi({text:n}){return x(ot,{children:n.split("`").map((e,t)=>t%2===1?x("code",{children:e},t):e)})}function Xl({text:n,isError:e}){return x("pre",{class:`rendered ${e?"error":"warning"}`,role:e?"alert":void 0,tabIndex:0,"aria-label":"Diagnostics of the model",children:n.trim()})}function _d({messages:n}){return n.length===0?null:x("ul",{class:"messages",children:n.map((e,t)=>x("li",{class:e.severity,children:[e.code&&x("code",{children:e.code})," ",x(oi,{text:e.message}),e.primary&&x("span",{class:"place",children:[" ",Sr(e.primary.file),":",e.primary.line]}),e.help&&x("span",{class:"help",children:x(oi,{text:e.help})})]},t))})}var Ib=200,Lb=1e3,dg=24;function fg({studio:n,param:e}){let t=n.value(e),i=n.isChanged(e.name),s=n.check?.errors[e.name],r=`param-${e.name}`,a=e.kind==="number"||e.kind==="integer"||e.kind==="array"?e.domain:"",l=tn(e.name.split(".").pop()??e.name),c=l.length+a.length<dg+12&&a.length<=dg,u=[a&&c&&`${r}-range`,`${r}-doc`,s&&`${r}-error`].filter(Boolean).join(" ");return x("div",{class:`field ${i?"changed":""} ${s?"invalid":""}`,"data-param":e.name,children:[x(bd,{id:r,label:l,title:e.name,range:c&&a?a:void 0,reset:i?`Reset ${tn(e.name)} to ${e.default??"its default"}`:null,onReset:()=>n.reset(e.name),children:e.kind==="boolean"&&x("input",{id:r,type:"checkbox",checked:t.toUpperCase()==="TRUE","aria-describedby":u,onChange:f=>n.setValue(e.name,f.currentTarget.checked?"TRUE":"FALSE")})}),e.kind!=="boolean"&&x(Nb,{studio:n,param:e,id:r,text:t,describedBy:u,isInvalid:!!s}),x(Db,{studio:n,param:e,text:t}),x("p",{class:"doc",id:`${r}-doc`,children:[oo(e.doc),!e.independent&&x("span",{class:"note",children:" Default and range follow other params."}),a&&!c&&x("span",{class:"range",children:a})]}),s&&x(Sd,{id:`${r}-error`,error:s})]})}function bd({id:n,label:e,title:t,range:i,reset:s,onReset:r,children:o}){return x("div",{class:"field-head",children:[o,x("label",{for:n,title:t,children:e}),i&&x("span",{class:"range",id:`${n}-range`,children:i}),s!==null&&x("button",{type:"button",class:"quiet small","aria-label":s,title:s,onClick:r,children:"reset"})]})}function Sd({id:n,error:e}){return x("p",{class:"field-error",id:n,role:"alert",children:[x(oi,{text:e.message}),e.help&&x("span",{class:"help",children:x(oi,{text:e.help})})]})}function Nb({studio:n,param:e,id:t,text:i,describedBy:s,isInvalid:r}){let o=l=>n.setValue(e.name,l);if(e.kind==="choice"){let l=e.choices.includes(i)?e.choices:[i,...e.choices];return x("div",{class:"control",children:x("select",{id:t,value:i,"aria-describedby":s,"aria-invalid":r,onChange:c=>o(c.currentTarget.value),children:l.map(c=>x("option",{value:c,children:c},c))})})}let a=e.unit!==""&&(_s(i)||i===""||/^\s*\[[^\]]*\]\s*$/.test(i));return x("div",{class:"control",children:[x("input",{id:t,type:"text",inputMode:e.kind==="integer"?"numeric":void 0,value:i,placeholder:e.default??"",autocomplete:"off",spellcheck:!1,"aria-describedby":s,"aria-invalid":r,onInput:l=>o(l.currentTarget.value)}),e.unit&&x("span",{class:`unit ${a?"":"off"}`,children:e.unit})]})}function Db({studio:n,param:e,text:t}){let{low:i,high:s}=e;if(e.kind!=="number"&&e.kind!=="integer"||!e.independent||i===null||s===null||!(s>i)||!_s(t)||i>0&&s/i>Ib||e.kind==="integer"&&s-i>Lb)return null;let r=e.kind==="integer"?1:10**Math.floor(Math.log10((s-i)/100));return x("input",{type:"range",class:"slider",min:i,max:s,step:r,value:t,"aria-label":`${tn(e.name)}, slider`,onInput:o=>n.setValue(e.name,String(Number(o.currentTarget.value)))})}function mg({studio:n}){let{analysisSettings:e,analysis:t}=n,i=e.filter(u=>u.detail),s=n.check?.setting_errors??{},r=Object.keys(t).length,o=n.settings.analysisOpen||Object.keys(s).length>0,[a,l]=Tt(!1),c=i.some(({name:u})=>u in t||u in s);return At(()=>{c&&l(!0)},[c]),e.length===0?null:x("details",{class:"analysis",open:o,onToggle:u=>{u.target===u.currentTarget&&n.setAnalysisOpen(u.currentTarget.open)},children:[x("summary",{children:["Analysis settings",r>0&&x("span",{class:"summary-value",children:[r," changed"]})]}),x("fieldset",{children:[x("legend",{class:"hidden-text",children:"Analysis settings"}),e.filter(u=>!u.detail).map(u=>x(pg,{studio:n,setting:u},u.name)),x("details",{open:a,onToggle:u=>l(u.currentTarget.open),children:[x("summary",{children:"Positions, mesh and contact grid"}),i.map(u=>x(pg,{studio:n,setting:u},u.name))]})]})]})}function pg({studio:n,setting:e}){let{name:t,label:i,doc:s,domain:r}=e,o=n.analysis[t]??"",a=n.check?.setting_errors[t],l=`setting-${t}`,c=Ob(n,t),u=[`${l}-doc`,a&&`${l}-error`,!a&&c&&`${l}-effect`].filter(Boolean).join(" "),f=t in n.analysis;return x("div",{class:`field ${f?"changed":""} ${a?"invalid":""}`,"data-setting":t,children:[x(bd,{id:l,label:i,title:t,reset:f?`Reset ${i} to the model's own`:null,onReset:()=>n.setAnalysis(t,""),children:e.kind==="boolean"&&x("input",{id:l,type:"checkbox",checked:o==="TRUE","aria-describedby":u,onChange:h=>n.setAnalysis(t,h.currentTarget.checked?"TRUE":"")})}),e.kind!=="boolean"&&x("div",{class:"control",children:x(kb,{studio:n,setting:e,id:l,text:o,describedBy:u,isInvalid:!!a})}),x("p",{class:"doc",id:`${l}-doc`,children:[s,r&&x("span",{class:"range",children:r})]}),a&&x(Sd,{id:`${l}-error`,error:a}),!a&&c&&x("p",{class:"field-note",id:`${l}-effect`,role:"status",children:x(oi,{text:c})})]})}var Fb=new Set(["vtu","refinement","element_order","face_elements","displacement_order"]),Ub=new Set(["face_elements","displacement_order","contact_slices"]);function Ob(n,e){let t=n.check?.plan;if(!t||!(e in n.analysis))return null;let i=t.ignored_inputs[e];return i?`This setting has no effect: ${i}.`:Fb.has(e)&&(t.fidelity==="rigid"||t.fidelity==="analytic")?`This setting has no effect on gears: at the fidelity "${t.fidelity}" they have no finite-element meshes.`:Ub.has(e)&&t.fidelity==="plane"?"This setting has no effect: a two-dimensional model has no face-width direction.":null}function kb({studio:n,setting:e,id:t,text:i,describedBy:s,isInvalid:r}){let{name:o,choices:a}=e;if(e.kind==="choice"){let l=o==="fidelity"&&i===""?n.check?.plan?.fidelity:void 0;return x("select",{id:t,value:i,"aria-describedby":s,"aria-invalid":r,onChange:c=>n.setAnalysis(o,c.currentTarget.value),children:[x("option",{value:"",children:["As in the model",l&&`: ${l}`]}),a.map(c=>x("option",{value:c.name,children:[c.name,": ",c.doc]},c.name))]})}return x("input",{id:t,type:"text",value:i,placeholder:"as in the model",autocomplete:"off",spellcheck:!1,"aria-describedby":s,"aria-invalid":r,onInput:l=>n.setAnalysis(o,l.currentTarget.value)})}var ai=class extends Error{constructor(t,i,s,r){super(t);this.status=i;this.help=s;this.body=r}status;help;body};async function $l(n,e={}){let t;try{t=await fetch(n,e)}catch(o){throw o instanceof DOMException&&o.name==="AbortError"?o:new ai("the studio does not respond",0,"start `calyx studio` again",null)}if(t.ok)return t;let i=await t.json().catch(()=>null),{message:s,help:r}=i??{};throw new ai(s??t.statusText,t.status,r??"",i)}async function Vi(n,e){return(await $l(n,{signal:e})).json()}async function ql(n){return(await $l(n)).arrayBuffer()}async function gg(n,e){let t=await bs("POST","/api/scene",n,e),i=s=>Uint8Array.from(atob(s),r=>r.charCodeAt(0)).buffer;return{parts:i(t.parts),position:i(t.position)}}var Bb=6e4;async function xg(n){let e=JSON.stringify(n);await $l("/api/session",{method:"PUT",keepalive:new Blob([e]).size<Bb,headers:{"Content-Type":"application/json"},body:e})}async function bs(n,e,t,i){let r=await(await $l(e,{method:n,signal:i,headers:{"Content-Type":"application/json"},body:JSON.stringify(t??{})})).text();return r?JSON.parse(r):null}function pi(n,e=""){return`/api/runs/${encodeURIComponent(n)}${e}`}async function vg(n){let e=await n.text();try{let{params:t}=await bs("POST","/api/params",{name:n.name,text:e});return t}catch(t){throw!(t instanceof ai)||t.message.includes(n.name)?t:new ai(`${n.name}: ${t.message}`,t.status,t.help,t.body)}}function zb(n){let e=(n.model?.params??[]).filter(t=>t.independent||t.name in n.values).map(t=>{let i=n.value(t).trim();if(t.kind==="boolean")return[t.name,i.toUpperCase()==="TRUE"];let s=(t.kind==="number"||t.kind==="integer")&&_s(i);return[t.name,s?Number(i):i]});return`${JSON.stringify(Object.fromEntries(e),null,2)}
`}function yg(n,e){let t=URL.createObjectURL(new Blob([zb(n)],{type:"application/json"})),i=document.createElement("a");i.href=t,i.download=e,i.click(),URL.revokeObjectURL(t)}var Vb=20;function _g({studio:n}){let[e,t]=Tt(""),i=n.model;if(!i)return x("p",{class:"empty",children:n.withoutModel?"The model of this run is not known.":"Loading …"});let s=i.params.length>Vb,r=s?i.params.filter(o=>Hb(n,o,e)):i.params;return x("form",{class:"params","aria-label":"Params",onSubmit:o=>o.preventDefault(),children:[x(Wb,{studio:n}),x(mg,{studio:n}),i.params.length===0&&x("p",{class:"empty",children:"The model has no params."}),s&&x("input",{type:"search",class:"search",placeholder:`Find one of ${i.params.length} params`,"aria-label":"Find a param",value:e,onInput:o=>t(o.currentTarget.value)}),i.params.length>0&&r.length===0&&x("p",{class:"empty",role:"status",children:"No param contains these words."}),Gb(r).map(([o,a])=>x("fieldset",{children:[x("legend",{class:o?"":"hidden-text",children:o||"Params"}),a.map(l=>x(fg,{studio:n,param:l},l.name))]},o))]})}function Hb(n,e,t){let i=`${e.name} ${tn(e.name)} ${e.group} ${e.doc}`.toLowerCase();return t.toLowerCase().split(/\s+/).every(r=>i.includes(r))||n.check?.errors[e.name]!==void 0}function Gb(n){let e=new Map;for(let t of n){let i=e.get(t.group);i?i.push(t):e.set(t.group,[t])}return[...e]}function Wb({studio:n}){let e=n.changes,t=Gt(null),i=async s=>{if(s)try{n.setValues(await vg(s))}catch(r){n.fail(r)}};return x("div",{class:"toolbar",children:[x("span",{class:"count",role:"status",children:e===0?"Defaults":`${e} changed`}),x("button",{type:"button",class:"quiet",disabled:e===0,onClick:()=>n.resetAll(),children:"Reset all"}),x("button",{type:"button",class:"quiet",onClick:()=>t.current?.click(),children:"Load …"}),x("button",{type:"button",class:"quiet",onClick:()=>yg(n,`${Sr(n.model?.model??"model")}.json`),children:"Save"}),x("input",{ref:t,type:"file",accept:".json,.toml",class:"hidden-text",tabIndex:-1,"aria-label":"Params file",onChange:s=>{let r=s.currentTarget;i(r.files?.[0]).finally(()=>r.value="")}})]})}var Md=4;function Xb(n,e){let{model:t,check:i}=n;if(!t||t.broken||!e.params)return[];let s=t.params.filter(a=>$b(n,a,e)).map(({name:a})=>tn(a)),r=n.analysisSettings.filter(({name:a})=>{let[l,c]=[n.analysis[a],e.settings?.[a]].map(u=>u==="FALSE"?"":u??"");return e.settings!==null&&!Ys(l,c)});return[...i?.source!=null&&e.source!==null&&i.source!==e.source?["the text of the model"]:[],...r.map(({label:a})=>a.toLowerCase()),...s]}function $b(n,e,t){let i=t.params?.[e.name],s=n.values[e.name];if(s===void 0)return!i||i.at_default===!0?!1:e.default===null||!Ys(e.default,i.text);let r=n.check?.values[e.name]??s,o=i?.text??e.default;return o===null||!(Ys(r,o)||Ys(s,o))}function bg({studio:n}){let{selected:e,automatic:t}=n.settings,i=n.runs.find(({id:a})=>a===e[0]);if(!i||e.length!==1||n.isChecking||i.id==="preview"&&t&&n.isQuick&&n.check?.runnable)return null;let s=Xb(n,i);if(s.length===0)return null;let r=s.slice(0,Md).join(", "),o=s.length>Md?` and ${s.length-Md} more`:"";return x("div",{class:"form-changed",role:"status","data-testid":"form-changed",children:[x("span",{children:[x("strong",{children:["Form changed since ",en(i.id),":"]})," ",r,o,". Results are those of the run."]}),x("span",{class:"form-changed-actions",children:[x("button",{type:"button",disabled:!n.canRun,onClick:()=>{n.run()},children:"Run with this form"}),x("button",{type:"button",class:"quiet",onClick:()=>n.useForm(i),children:"Back to the values of the run"})]})]})}var wd=["#2f6fb3","#c8641b","#2c8a57","#8c4fa8","#b3324b","#6b7280","#0f8b8d","#a8861b"],Sg=wd.length;function ao(n){return wd[n%wd.length]??"#2f6fb3"}var qb=[["max","Maximum"],["mean","Mean"],["min","Minimum"],["peak_to_peak","Peak to peak"]],Yb=6;function Mg({studio:n}){let e=n.settings.selected,t=e.flatMap(i=>n.results[i]??[]);return x("section",{class:"panel","aria-labelledby":"outputs-heading",children:[x("h2",{id:"outputs-heading",children:"Outputs"}),e.length<=1&&x(Jb,{studio:n,results:t[0]}),e.length>1&&x(eS,{runs:t,places:e})]})}function Jb({studio:n,results:e}){return e?.run?.outputs?x(jb,{results:e}):e?.so_far&&(e.positions??0)>0?x(Zb,{results:e}):x(Kb,{studio:n})}function Zb({results:n}){return x(ot,{children:[x("p",{class:"incomplete",children:["Incomplete: ",os(n)]}),x("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Table of outputs at the solved positions",children:x("table",{class:"outputs","data-testid":"so-far",children:[x("thead",{children:x("tr",{children:[x("th",{scope:"col",children:"Output"}),x("th",{scope:"col",children:"Min so far"}),x("th",{scope:"col",children:"Max so far"}),x("th",{scope:"col",children:"Last"})]})}),x("tbody",{children:Object.entries(n.so_far??{}).map(([e,t])=>x("tr",{children:[x("th",{scope:"row",title:t.doc,children:[tn(e)," ",x("span",{class:"unit",children:t.unit})]}),x("td",{children:ti(t.min)}),x("td",{children:ti(t.max)}),x("td",{children:ti(t.last)})]},e))})]})}),x("p",{class:"muted small-text",children:"The remaining positions may have smaller and larger values. Means and errors need all positions."})]})}function Kb({studio:n}){let e=n.model?.outputs??[];return n.model?.broken?x("p",{class:"muted",children:"The model has errors."}):e.length===0?x("p",{class:"muted",children:"The model has no outputs."}):x("details",{open:e.length<=Yb,children:[x("summary",{children:[e.length===1?"1 output":`${e.length} outputs`," of a run"]}),x("dl",{class:"declared",children:e.map(t=>x("div",{children:[x("dt",{children:[tn(t.name)," ",t.unit&&x("span",{class:"unit",children:t.unit})]}),x("dd",{children:oo(t.doc)})]},t.name))})]})}function jb({results:n}){let e=Object.entries(n.run?.outputs??{}),t=e.some(([,i])=>i.error_estimate?.includes_level===!1);return x("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Table of outputs",children:[x("table",{class:"outputs","data-testid":"outputs",children:[x("thead",{children:x("tr",{children:[x("th",{scope:"col",children:"Output"}),x("th",{scope:"col",children:"Min"}),x("th",{scope:"col",children:"Mean"}),x("th",{scope:"col",children:"Max"}),x("th",{scope:"col",children:"Error"})]})}),x("tbody",{children:e.map(([i,s])=>x("tr",{children:[x("th",{scope:"row",title:s.doc,children:[tn(i)," ",x("span",{class:"unit",children:s.display.unit})]}),x("td",{children:ti(s.display.min)}),x("td",{children:ti(s.display.mean)}),x("td",{children:ti(s.display.max)}),x("td",{children:Qb(s)})]},i))})]}),x("p",{class:"muted small-text",children:["Error: estimated, relative to the largest magnitude.",t&&" The error of the fidelity level itself is not included."]})]})}function Qb(n){let e=n.error_estimate;return e?e.is_rounding?"rounding":e.relative==null?"–":cg(e.relative):"–"}function eS({runs:n,places:e}){let[t,i]=Tt("max"),s=[...new Set(n.flatMap(tS))],r=n[0],o=n.some(_a);return x(ot,{children:[x("label",{class:"inline",children:["Value",x("select",{value:t,onChange:a=>i(a.currentTarget.value),children:qb.map(([a,l])=>x("option",{value:a,children:l},a))})]}),x("p",{class:"muted small-text",children:["Changes are relative to ",en(r?.id??""),".",o&&" Values of incomplete runs are those of their solved positions, without mean and change."]}),x("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Table of compared outputs",children:x("table",{class:"outputs","data-testid":"compared",children:[x("thead",{children:x("tr",{children:[x("th",{scope:"col",children:"Output"}),n.map(a=>x("th",{scope:"col",children:[x("span",{class:"swatch",style:{background:ao(e.indexOf(a.id))}}),en(a.id),_a(a)&&x("span",{class:"incomplete",children:[ya(a)," solved"]})]},a.id))]})}),x("tbody",{children:s.map(a=>x("tr",{children:[x("th",{scope:"row",children:[tn(a)," ",x("span",{class:"unit",children:nS(n,a)})]}),n.map(l=>{let c=l!==r&&r&&!_a(l)&&!_a(r);return x("td",{class:_a(l)?"so-far":"",children:[ti(Ed(l,a,t)),c&&x(iS,{from:Ed(r,a,t),to:Ed(l,a,t)})]},l.id)})]},a))})]})})]})}function _a(n){return!n.run?.outputs}function tS(n){return Object.keys(n.run?.outputs??n.so_far??{})}function nS(n,e){return n.map(i=>i.run?.outputs?.[e]?.display.unit??i.so_far?.[e]?.unit).find(i=>i!==void 0)??""}function Ed(n,e,t){let i=n.run?.outputs?.[e]?.display;if(i)return i[t];let s=n.so_far?.[e];return s&&(t==="min"||t==="max")?s[t]:null}function iS({from:n,to:e}){if(n===null||e===null||n===0)return null;let t=100*(e-n)/Math.abs(n),i=Math.abs(t)<.005?"±0":`${t>0?"+":"−"}${Math.abs(t).toFixed(Math.abs(t)<10?2:1)}`;return x("span",{class:"change",children:[i," %"]})}var sS="uplot",rS="u-hz",oS="u-vt",aS="u-title",lS="u-wrap",cS="u-under",uS="u-over",hS="u-axis",Er="u-off",dS="u-select",fS="u-cursor-x",pS="u-cursor-y",mS="u-cursor-pt",gS="u-legend",xS="u-live",vS="u-inline",yS="u-series",_S="u-marker",wg="u-label",bS="u-value",Sa="width",Ma="height";var Eg="bottom",lo="left",Td="right",Gd="#000",Tg=Gd+"0",Ad="mousemove",Ag="mousedown",Cd="mouseup",Cg="mouseenter",Rg="mouseleave",Pg="dblclick",SS="resize",MS="scroll",Ig="change",jl="dppxchange",Wd="--",go=typeof window<"u",Nd=go?document:null,uo=go?window:null,wS=go?navigator:null,Ct,Yl;function Dd(){let n=devicePixelRatio;Ct!=n&&(Ct=n,Yl&&Ud(Ig,Yl,Dd),Yl=matchMedia(`(min-resolution: ${Ct-.001}dppx) and (max-resolution: ${Ct+.001}dppx)`),Tr(Ig,Yl,Dd),uo.dispatchEvent(new CustomEvent(jl)))}function mi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Fd(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Yt(n,e,t){n.style[e]=t+"px"}function Hi(n,e,t,i){let s=Nd.createElement(n);return e!=null&&mi(s,e),t?.insertBefore(s,i),s}function Ci(n,e){return Hi("div",n,e)}var Lg=new WeakMap;function as(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Lg.get(n);r!=o&&(n.style.transform=r,Lg.set(n,r),e<0||t<0||e>i||t>s?mi(n,Er):Fd(n,Er))}var Ng=new WeakMap;function Dg(n,e,t){let i=e+t,s=Ng.get(n);i!=s&&(Ng.set(n,i),n.style.background=e,n.style.borderColor=t)}var Fg=new WeakMap;function Ug(n,e,t,i){let s=e+""+t,r=Fg.get(n);s!=r&&(Fg.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Xd={passive:!0},ES={...Xd,capture:!0};function Tr(n,e,t,i){e.addEventListener(n,t,i?ES:Xd)}function Ud(n,e,t,i){e.removeEventListener(n,t,Xd)}go&&Dd();function Gi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:gi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function u0(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var h0=n=>n!=null,d0=n=>n!=null&&n>0,tc=u0(h0),TS=u0(d0);function AS(n,e,t,i=0,s=!1){let r=s?TS:tc,o=s?d0:h0;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??zt,l??-zt]}function nc(n,e,t,i){let s=Bg(n),r=Bg(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Ss:f0,a=s==1?gi:Ri,l=r==1?Ri:gi,c=a(o(In(n))),u=l(o(In(e))),f=ho(t,c),h=ho(t,u);return t==10&&(c<0&&(f=Vt(f,-c)),u<0&&(h=Vt(h,-u))),i||t==2?(n=f*s,e=h*r):(n=x0(n,f),e=ic(e,h)),[n,e]}function $d(n,e,t,i){let s=nc(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var qd=.1,Og={mode:3,pad:qd},Ea={pad:0,soft:null,mode:0},CS={min:Ea,max:Ea};function Ql(n,e,t,i){return sc(t)?kg(n,e,t):(Ea.pad=t,Ea.soft=i?0:null,Ea.mode=i?3:0,kg(n,e,CS))}function Mt(n,e){return n??e}function RS(n,e,t){for(e=Mt(e,0),t=Mt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function kg(n,e,t){let i=t.min,s=t.max,r=Mt(i.pad,0),o=Mt(s.pad,0),a=Mt(i.hard,-zt),l=Mt(s.hard,zt),c=Mt(i.soft,zt),u=Mt(s.soft,-zt),f=Mt(i.mode,0),h=Mt(s.mode,0),d=e-n,p=Ss(d),v=ni(In(n),In(e)),g=Ss(v),m=In(g-p);(d<1e-24||m>10)&&(d=0,(n==0||e==0)&&(d=1e-24,f==2&&c!=zt&&(r=0),h==2&&u!=-zt&&(o=0)));let y=d||v||1e3,M=Ss(y),b=ho(10,gi(M)),R=y*(d==0?n==0?.1:1:r),T=Vt(x0(n-R,b/10),24),_=n>=c&&(f==1||f==3&&T<=c||f==2&&T>=c)?c:zt,E=ni(a,T<_&&n>=_?_:Wi(_,T)),U=y*(d==0?e==0?.1:1:o),N=Vt(ic(e+U,b/10),24),L=e<=u&&(h==1||h==3&&N>=u||h==2&&N<=u)?u:-zt,B=Wi(l,N>L&&e<=L?L:ni(L,N));return E==B&&E==0&&(B=100),[E,B]}var PS=new Intl.NumberFormat(go?wS.language:"en-US"),Yd=n=>PS.format(n),xi=Math,Kl=xi.PI,In=xi.abs,gi=xi.floor,Pn=xi.round,Ri=xi.ceil,Wi=xi.min,ni=xi.max,ho=xi.pow,Bg=xi.sign,Ss=xi.log10,f0=xi.log2,IS=(n,e=1)=>xi.sinh(n)*e,Rd=(n,e=1)=>xi.asinh(n/e),zt=1/0;function zg(n){return(Ss((n^n>>31)-(n>>31))|0)+1}function Od(n,e,t){return Wi(ni(n,e),t)}function p0(n){return typeof n=="function"}function gt(n){return p0(n)?n:()=>n}var LS=()=>{},m0=n=>n,g0=(n,e)=>e,NS=n=>null,Vg=n=>!0,Hg=(n,e)=>n==e,DS=/\.\d*?(?=9{6,}|0{6,})/gm,Ar=n=>{if(y0(n)||Zs.has(n))return n;let e=`${n}`,t=e.match(DS);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Ar(s)}e${r}`}return Vt(n,i)};function Mr(n,e){return Ar(Vt(Ar(n/e))*e)}function ic(n,e){return Ar(Ri(Ar(n/e))*e)}function x0(n,e){return Ar(gi(Ar(n/e))*e)}function Vt(n,e=0){if(y0(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Pn(i)/t}var Zs=new Map;function v0(n){return((""+n).split(".")[1]||"").length}function Aa(n,e,t,i){let s=[],r=i.map(v0);for(let o=e;o<t;o++){let a=In(o),l=Vt(ho(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Vt(u,f);s.push(h),Zs.set(h,f)}}return s}var Ta={},Jd=[],fo=[null,null],Js=Array.isArray,y0=Number.isInteger,FS=n=>n===void 0;function Gg(n){return typeof n=="string"}function sc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function US(n){return n!=null&&typeof n=="object"}var OS=Object.getPrototypeOf(Uint8Array),_0="__proto__";function po(n,e=sc){let t;if(Js(n)){let i=n.find(s=>s!=null);if(Js(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=po(n[s],e)}else t=n.slice()}else if(n instanceof OS)t=n.slice();else if(e(n)){t={};for(let i in n)i!=_0&&(t[i]=po(n[i],e))}else t=n;return t}function Sn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=_0&&(sc(n[s])?Sn(n[s],po(i[s])):n[s]=po(i[s]))}return n}var kS=0,BS=1,zS=2;function VS(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function HS(n,e){if(XS(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return $S(o[0])||(o=WS(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),h=e?e[o][c]:BS,d=[];for(let p=0;p<u.length;p++){let v=u[p],g=r.get(l[p]);v===null?h!=kS&&(f[g]=v,h==zS&&d.push(g)):f[g]=v}VS(f,d,s),i.push(f)}}return i}var GS=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function WS(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function XS(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function $S(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=ni(1,gi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var b0=["January","February","March","April","May","June","July","August","September","October","November","December"],S0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function M0(n){return n.slice(0,3)}var qS=S0.map(M0),YS=b0.map(M0),JS={MMMM:b0,MMM:YS,WWWW:S0,WWW:qS};function ba(n){return(n<10?"0":"")+n}function ZS(n){return(n<10?"00":n<100?"0":"")+n}var KS={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>ba(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ba(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>ba(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ba(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ba(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>ZS(n.getMilliseconds())};function Zd(n,e){e=e||JS;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?KS[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var jS=new Intl.DateTimeFormat().resolvedOptions().timeZone;function QS(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==jS?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var w0=n=>n%1==0,ec=[1,2,2.5,5],eM=Aa(10,-32,0,ec),E0=Aa(10,0,32,ec),tM=E0.filter(w0),wr=eM.concat(E0),Kd=`
`,T0="{YYYY}",Wg=Kd+T0,A0="{M}/{D}",wa=Kd+A0,Jl=wa+"/{YY}",C0="{aa}",nM="{h}:{mm}",co=nM+C0,Xg=Kd+co,$g=":{ss}",Rt=null;function R0(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Aa(10,0,3,ec).filter(w0):Aa(10,-3,0,ec)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,T0,Rt,Rt,Rt,Rt,Rt,Rt,1],[s*28,"{MMM}",Wg,Rt,Rt,Rt,Rt,Rt,1],[s,A0,Wg,Rt,Rt,Rt,Rt,Rt,1],[i,"{h}"+C0,Jl,Rt,wa,Rt,Rt,Rt,1],[t,co,Jl,Rt,wa,Rt,Rt,Rt,1],[e,$g,Jl+" "+co,Rt,wa+" "+co,Rt,Xg,Rt,1],[n,$g+".{fff}",Jl+" "+co,Rt,wa+" "+co,Rt,Xg,Rt,1]];function u(f){return(h,d,p,v,g,m)=>{let y=[],M=g>=o,b=g>=r&&g<o,R=f(p),T=Vt(R*n,3),_=Pd(R.getFullYear(),M?0:R.getMonth(),b||M?1:R.getDate()),E=Vt(_*n,3);if(b||M){let U=b?g/r:0,N=M?g/o:0,L=T==E?T:Vt(Pd(_.getFullYear()+N,_.getMonth()+U,1)*n,3),B=new Date(Pn(L/n)),z=B.getFullYear(),D=B.getMonth();for(let W=0;L<=v;W++){let q=Pd(z+N*W,D+U*W,1),H=q-f(Vt(q*n,3));L=Vt((+q+H)*n,3),L<=v&&y.push(L)}}else{let U=g>=s?s:g,N=gi(p)-gi(T),L=E+N+ic(T-E,U);y.push(L);let B=f(L),z=B.getHours()+B.getMinutes()/t+B.getSeconds()/i,D=g/i,W=h.axes[d]._space,q=m/W;for(;L=Vt(L+g,n==1?0:3),!(L>v);)if(D>1){let H=gi(Vt(z+D,6))%24,Q=f(L).getHours()-H;Q>1&&(Q=-1),L-=Q*i,z=(z+D)%24;let ie=y[y.length-1];Vt((L-ie)/g,3)*q>=.7&&y.push(L)}else y.push(L)}return y}}return[l,c,u]}var[iM,sM,rM]=R0(1),[oM,aM,lM]=R0(.001);Aa(2,-53,53,[1]);function qg(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Yg(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,f,h,d;return i.map(p=>{let v=n(p),g=v.getFullYear(),m=v.getMonth(),y=v.getDate(),M=v.getHours(),b=v.getMinutes(),R=v.getSeconds(),T=g!=l&&a[2]||m!=c&&a[3]||y!=u&&a[4]||M!=f&&a[5]||b!=h&&a[6]||R!=d&&a[7]||a[1];return l=g,c=m,u=y,f=M,h=b,d=R,T(v)})}}function cM(n,e){let t=Zd(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Pd(n,e,t){return new Date(n,e,t)}function Jg(n,e){return e(n)}var uM="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Zg(n,e){return(t,i,s,r)=>r==null?Wd:e(n(i))}function hM(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function dM(n,e){return n.series[e].fill(n,e)}var fM={show:!0,live:!0,isolate:!1,mount:LS,markers:{show:!0,width:2,stroke:hM,fill:dM,dash:"solid"},idx:null,idxs:null,values:[]};function pM(n,e){let t=n.cursor.points,i=Ci(),s=t.size(n,e);Yt(i,Sa,s),Yt(i,Ma,s);let r=s/-2;Yt(i,"marginLeft",r),Yt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Yt(i,"borderWidth",o),i}function mM(n,e){let t=n.series[e].points;return t._fill||t._stroke}function gM(n,e){let t=n.series[e].points;return t._stroke||t._fill}function xM(n,e){return n.series[e].points.size}var Id=[0,0];function vM(n,e,t){return Id[0]=e,Id[1]=t,Id}function Zl(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Ld(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var yM={show:!0,x:!0,y:!0,lock:!1,move:vM,points:{one:!1,show:pM,size:xM,width:0,stroke:gM,fill:mM},bind:{mousedown:Zl,mouseup:Zl,click:Zl,dblclick:Zl,mousemove:Ld,mouseleave:Ld,mouseenter:Ld},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},P0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},jd=Sn({},P0,{filter:g0}),I0=Sn({},jd,{size:10}),L0=Sn({},P0,{show:!1}),Qd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',N0="bold "+Qd,D0=1.5,Kg={show:!0,scale:"x",stroke:Gd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:N0,side:2,grid:jd,ticks:I0,border:L0,font:Qd,lineGap:D0,rotate:0},_M="Value",bM="Time",jg={show:!0,scale:"x",auto:!1,sorted:1,min:zt,max:-zt,idxs:[]};function SM(n,e,t,i,s){return e.map(r=>r==null?"":Yd(r))}function MM(n,e,t,i,s,r,o){let a=[],l=Zs.get(s)||0;t=o?t:Vt(ic(t,s),l);for(let c=t;c<=i;c=Vt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function kd(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Ss:f0,u=gi(c(t));s=ho(l,u),l==10&&(s=wr[Gi(s,wr)]);let f=t,h=s*l;l==10&&(h=wr[Gi(h,wr)]);do a.push(f),f=f+s,l==10&&!Zs.has(f)&&(f=Vt(f,Zs.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=wr[Gi(h,wr)]));while(f<=i);return a}function wM(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?kd(n,e,ni(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?kd(n,e,ni(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var F0=/./,EM=/[12357]/,TM=/[125]/,Qg=/1/,Bd=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function AM(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?F0:l(7,o)-u>=c?EM:l(5,o)-u>=c?TM:Qg;if(f==Qg){let h=In(l(1,o)-u);if(h<c)return Bd(e.slice().reverse(),a.distr,f,Ri(c/h)).reverse()}return Bd(e,a.distr,f,1)}function CM(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=In(l(1,o)-l(2,o));return c<a?Bd(e.slice().reverse(),3,F0,Ri(a/c)).reverse():e}function RM(n,e,t,i){return i==null?Wd:e==null?"":Yd(e)}var e0={show:!0,scale:"y",stroke:Gd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:N0,side:3,grid:jd,ticks:I0,border:L0,font:Qd,lineGap:D0,rotate:0};function PM(n,e){let t=3+(n||1)*2;return Vt(t*e,3)}function IM(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=In(o-r),l=n.series[e],c=a/(l.points.space*Ct);return i[1]-i[0]<=c}var t0={scale:null,auto:!0,sorted:0,min:zt,max:-zt},U0=(n,e,t,i,s)=>s,n0={show:!0,auto:!0,sorted:0,gaps:U0,alpha:1,facets:[Sn({},t0,{scale:"x"}),Sn({},t0,{scale:"y"})]},i0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:U0,alpha:1,points:{show:IM,filter:null},values:null,min:zt,max:-zt,idxs:[],path:null,clip:null};function LM(n,e,t,i,s){return t/10}var O0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},NM=Sn({},O0,{time:!1,ori:1}),s0={};function k0(n,e){let t=s0[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(s0[n]=t)),t}var mo=1,zd=2;function Cr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,d=a.top,p=a.width,v=a.height,g=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,f,g,m,h,d,p,v,oc,xo,lc,z0,H0):t(s,l,c,u,f,m,g,d,h,v,p,ac,vo,nf,V0,G0)}function ef(n,e){let t=0,i=0,s=Mt(n.bands,Jd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function DM(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ms(n,e,t,i,s,r){return Cr(n,e,(o,a,l,c,u,f,h,d,p,v,g)=>{let m=o.pxRound,y=c.dir*(c.ori==0?1:-1),M=c.ori==0?xo:vo,b,R;y==1?(b=t,R=i):(b=i,R=t);let T=m(f(a[b],c,v,d)),_=m(h(l[b],u,g,p)),E=m(f(a[R],c,v,d)),U=m(h(r==1?u.max:u.min,u,g,p)),N=new Path2D(s);return M(N,E,U),M(N,T,U),M(N,T,_),N})}function rc(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?lc:nf,l=t;for(let f=0;f<n.length;f++){let h=n[f];if(h[1]>h[0]){let d=h[0]-l;d>0&&a(o,l,i,d,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function FM(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function tf(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let f=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let d=r(n[f]),p=h==f?d:r(n[h]),v=f-s;d=o<=0&&v>=0&&v<l?r(n[v]):d;let m=h+s;p=o>=0&&m>=0&&m<l?r(n[m]):p,p>=d&&a.push([d,p])}return a}function r0(n){return n==0?m0:n==1?Pn:e=>Mr(e,n)}function B0(n){let e=n==0?oc:ac,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Wi(c,a/2,l/2),u=Wi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var oc=(n,e,t)=>{n.moveTo(e,t)},ac=(n,e,t)=>{n.moveTo(t,e)},xo=(n,e,t)=>{n.lineTo(e,t)},vo=(n,e,t)=>{n.lineTo(t,e)},lc=B0(0),nf=B0(1),z0=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},V0=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},H0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},G0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function W0(n){return(e,t,i,s,r)=>Cr(e,t,(o,a,l,c,u,f,h,d,p,v,g)=>{let{pxRound:m,points:y}=o,M,b;c.ori==0?(M=oc,b=z0):(M=ac,b=V0);let R=Vt(y.width*Ct,3),T=(y.size-y.width)/2*Ct,_=Vt(T*2,3),E=new Path2D,U=new Path2D,{left:N,top:L,width:B,height:z}=e.bbox;lc(U,N-_,L-_,B+_*2,z+_*2);let D=W=>{if(l[W]!=null){let q=m(f(a[W],c,v,d)),H=m(h(l[W],u,g,p));M(E,q+T,H),b(E,q,H,T,0,Kl*2)}};if(r)r.forEach(D);else for(let W=i;W<=s;W++)D(W);return{stroke:R>0?E:null,fill:E,clip:U,flags:mo|zd}})}function X0(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var UM=X0(xo),OM=X0(vo);function $0(n){let e=Mt(n?.alignGaps,0);return(t,i,s,r)=>Cr(t,i,(o,a,l,c,u,f,h,d,p,v,g)=>{[s,r]=tc(l,s,r);let m=o.pxRound,y=z=>m(f(z,c,v,d)),M=z=>m(h(z,u,g,p)),b,R;c.ori==0?(b=xo,R=UM):(b=vo,R=OM);let T=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:mo},E=_.stroke,U=!1;if(r-s>=v*4){let z=he=>t.posToVal(he,c.key,!0),D=null,W=null,q,H,le,Z=y(a[T==1?s:r]),Q=y(a[s]),ie=y(a[r]),de=z(T==1?Q+1:ie-1);for(let he=T==1?s:r;he>=s&&he<=r;he+=T){let ee=a[he],ge=(T==1?ee<de:ee>de)?Z:y(ee),Me=l[he];ge==Z?Me!=null?(H=Me,D==null?(b(E,ge,M(H)),q=D=W=H):H<D?D=H:H>W&&(W=H)):Me===null&&(U=!0):(D!=null&&R(E,Z,M(D),M(W),M(q),M(H)),Me!=null?(H=Me,b(E,ge,M(H)),D=W=q=H):(D=W=null,Me===null&&(U=!0)),Z=ge,de=z(Z+T))}D!=null&&D!=W&&le!=Z&&R(E,Z,M(D),M(W),M(q),M(H))}else for(let z=T==1?s:r;z>=s&&z<=r;z+=T){let D=l[z];D===null?U=!0:D!=null&&b(E,y(a[z]),M(D))}let[L,B]=ef(t,i);if(o.fill!=null||L!=0){let z=_.fill=new Path2D(E),D=o.fillTo(t,i,o.min,o.max,L),W=M(D),q=y(a[s]),H=y(a[r]);T==-1&&([H,q]=[q,H]),b(z,H,W),b(z,q,W)}if(!o.spanGaps){let z=[];U&&z.push(...tf(a,l,s,r,T,y,e)),_.gaps=z=o.gaps(t,i,s,r,z),_.clip=rc(z,c.ori,d,p,v,g)}return B!=0&&(_.band=B==2?[Ms(t,i,s,r,E,-1),Ms(t,i,s,r,E,1)]:Ms(t,i,s,r,E,B)),_})}function kM(n){let e=Mt(n.align,1),t=Mt(n.ascDesc,!1),i=Mt(n.alignGaps,0),s=Mt(n.extend,!1);return(r,o,a,l)=>Cr(r,o,(c,u,f,h,d,p,v,g,m,y,M)=>{[a,l]=tc(f,a,l);let b=c.pxRound,{left:R,width:T}=r.bbox,_=Q=>b(p(Q,h,y,g)),E=Q=>b(v(Q,d,M,m)),U=h.ori==0?xo:vo,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:mo},L=N.stroke,B=h.dir*(h.ori==0?1:-1),z=E(f[B==1?a:l]),D=_(u[B==1?a:l]),W=D,q=D;s&&e==-1&&(q=R,U(L,q,z)),U(L,D,z);for(let Q=B==1?a:l;Q>=a&&Q<=l;Q+=B){let ie=f[Q];if(ie==null)continue;let de=_(u[Q]),he=E(ie);e==1?U(L,de,z):U(L,W,he),U(L,de,he),z=he,W=de}let H=W;s&&e==1&&(H=R+T,U(L,H,z));let[le,Z]=ef(r,o);if(c.fill!=null||le!=0){let Q=N.fill=new Path2D(L),ie=c.fillTo(r,o,c.min,c.max,le),de=E(ie);U(Q,H,de),U(Q,q,de)}if(!c.spanGaps){let Q=[];Q.push(...tf(u,f,a,l,B,_,i));let ie=c.width*Ct/2,de=t||e==1?ie:-ie,he=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=de,ee[1]+=he}),N.gaps=Q=c.gaps(r,o,a,l,Q),N.clip=rc(Q,h.ori,g,m,y,M)}return Z!=0&&(N.band=Z==2?[Ms(r,o,a,l,L,-1),Ms(r,o,a,l,L,1)]:Ms(r,o,a,l,L,Z)),N})}function o0(n,e,t,i,s,r,o=zt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=In(n[l]-n[a]);u<c&&(c=u,o=In(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function BM(n){n=n||Ta;let e=Mt(n.size,[.6,zt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=gt(s),o=1-e[0],a=Mt(e[1],zt),l=Mt(e[2],1),c=Mt(n.disp,Ta),u=Mt(n.each,d=>{}),{fill:f,stroke:h}=c;return(d,p,v,g)=>Cr(d,p,(m,y,M,b,R,T,_,E,U,N,L)=>{let B=m.pxRound,z=t,D=i*Ct,W=a*Ct,q=l*Ct,H,le;b.ori==0?[H,le]=r(d,p):[le,H]=r(d,p);let Z=b.dir*(b.ori==0?1:-1),Q=b.ori==0?lc:nf,ie=b.ori==0?u:(Re,qe,it,we,Bt,He,$e)=>{u(Re,qe,it,Bt,we,$e,He)},de=Mt(d.bands,Jd).find(Re=>Re.series[0]==p),he=de!=null?de.dir:0,ee=m.fillTo(d,p,m.min,m.max,he),me=B(_(ee,R,L,U)),ge,Me,ve,Ve=N,Xe=B(m.width*Ct),De=!1,ut=null,at=null,tt=null,jt=null;f!=null&&(Xe==0||h!=null)&&(De=!0,ut=f.values(d,p,v,g),at=new Map,new Set(ut).forEach(Re=>{Re!=null&&at.set(Re,new Path2D)}),Xe>0&&(tt=h.values(d,p,v,g),jt=new Map,new Set(tt).forEach(Re=>{Re!=null&&jt.set(Re,new Path2D)})));let{x0:Ht,size:mn}=c;if(Ht!=null&&mn!=null){z=1,y=Ht.values(d,p,v,g),Ht.unit==2&&(y=y.map(it=>d.posToVal(E+it*N,b.key,!0)));let Re=mn.values(d,p,v,g);mn.unit==2?Me=Re[0]*N:Me=T(Re[0],b,N,E)-T(0,b,N,E),Ve=o0(y,M,T,b,N,E,Ve),ve=Ve-Me+D}else Ve=o0(y,M,T,b,N,E,Ve),ve=Ve*o+D,Me=Ve-ve;ve<1&&(ve=0),Xe>=Me/2&&(Xe=0),ve<5&&(B=m0);let Ut=ve>0,Dn=Ve-ve-(Ut?Xe:0);Me=B(Od(Dn,q,W)),ge=(z==0?Me/2:z==Z?0:Me)-z*Z*((z==0?D/2:0)+(Ut?Xe/2:0));let _t={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Cn=De?null:new Path2D,rn=null;if(de!=null)rn=d.data[de.series[1]];else{let{y0:Re,y1:qe}=c;Re!=null&&qe!=null&&(M=qe.values(d,p,v,g),rn=Re.values(d,p,v,g))}let gn=H*Me,k=le*Me;for(let Re=Z==1?v:g;Re>=v&&Re<=g;Re+=Z){let qe=M[Re];if(qe==null)continue;if(rn!=null){let $=rn[Re]??0;if(qe-$==0)continue;me=_($,R,L,U)}let it=b.distr!=2||c!=null?y[Re]:Re,we=T(it,b,N,E),Bt=_(Mt(qe,ee),R,L,U),He=B(we-ge),$e=B(ni(Bt,me)),P=B(Wi(Bt,me)),w=$e-P;if(qe!=null){let $=qe<0?k:gn,ue=qe<0?gn:k;De?(Xe>0&&tt[Re]!=null&&Q(jt.get(tt[Re]),He,P+gi(Xe/2),Me,ni(0,w-Xe),$,ue),ut[Re]!=null&&Q(at.get(ut[Re]),He,P+gi(Xe/2),Me,ni(0,w-Xe),$,ue)):Q(Cn,He,P+gi(Xe/2),Me,ni(0,w-Xe),$,ue),ie(d,p,Re,He-Xe/2,P,Me+Xe,w)}}return Xe>0?_t.stroke=De?jt:Cn:De||(_t._fill=m.width==0?m._fill:m._stroke??m._fill,_t.width=0),_t.fill=De?at:Cn,_t})}function zM(n,e){let t=Mt(e?.alignGaps,0);return(i,s,r,o)=>Cr(i,s,(a,l,c,u,f,h,d,p,v,g,m)=>{[r,o]=tc(c,r,o);let y=a.pxRound,M=H=>y(h(H,u,g,p)),b=H=>y(d(H,f,m,v)),R,T,_;u.ori==0?(R=oc,_=xo,T=H0):(R=ac,_=vo,T=G0);let E=u.dir*(u.ori==0?1:-1),U=M(l[E==1?r:o]),N=U,L=[],B=[];for(let H=E==1?r:o;H>=r&&H<=o;H+=E)if(c[H]!=null){let Z=l[H],Q=M(Z);L.push(N=Q),B.push(b(c[H]))}let z={stroke:n(L,B,R,_,T,y),fill:null,clip:null,band:null,gaps:null,flags:mo},D=z.stroke,[W,q]=ef(i,s);if(a.fill!=null||W!=0){let H=z.fill=new Path2D(D),le=a.fillTo(i,s,a.min,a.max,W),Z=b(le);_(H,N,Z),_(H,U,Z)}if(!a.spanGaps){let H=[];H.push(...tf(l,c,r,o,E,M,t)),z.gaps=H=a.gaps(i,s,r,o,H),z.clip=rc(H,u.ori,p,v,g,m)}return q!=0&&(z.band=q==2?[Ms(i,s,r,o,D,-1),Ms(i,s,r,o,D,1)]:Ms(i,s,r,o,D,q)),z})}function VM(n){return zM(HM,n)}function HM(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],f[h]=n[h+1]-n[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+f[h]/3,e[h]+l[h]*f[h]/3,n[h+1]-f[h]/3,e[h+1]-l[h+1]*f[h]/3,n[h+1],e[h+1])}return a}var Vd=new Set;function a0(){for(let n of Vd)n.syncRect(!0)}go&&(Tr(SS,uo,a0),Tr(MS,uo,a0,!0),Tr(jl,uo,()=>{Mn.pxRatio=Ct}));var GM=$0(),WM=W0();function l0(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Hd(r,o,e,t))}function XM(n,e){return n.map((t,i)=>i==0?{}:Sn({},e,t))}function Hd(n,e,t,i){return Sn({},e==0?t:i,n)}function q0(n,e,t){return e==null?fo:[e,t]}var $M=q0;function qM(n,e,t){return e==null?fo:Ql(e,t,qd,!0)}function Y0(n,e,t,i){return e==null?fo:nc(e,t,n.scales[i].log,!1)}var YM=Y0;function J0(n,e,t,i){return e==null?fo:$d(e,t,n.scales[i].log,!1)}var JM=J0;function ZM(n,e,t,i,s){let r=ni(zg(n),zg(e)),o=e-n,a=Gi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Zs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function c0(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Pn((t=+s)*Ct))+"px"),[n,e,t]}function KM(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Vt(e[2]*Ct,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Mn(n,e,t){let i={mode:Mt(n.mode,1)},s=i.mode;function r(S,A,I,F){let X=A.valToPct(S);return F+I*(A.dir==-1?1-X:X)}function o(S,A,I,F){let X=A.valToPct(S);return F+I*(A.dir==-1?X:1-X)}function a(S,A,I,F){return A.ori==0?r(S,A,I,F):o(S,A,I,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ci(sS);if(n.id!=null&&(c.id=n.id),mi(c,n.class),n.title){let S=Ci(aS,c);S.textContent=n.title}let u=Hi("canvas"),f=i.ctx=u.getContext("2d"),h=Ci(lS,c);Tr("click",h,S=>{S.target===p&&(Xt!=eo||Qt!=to)&&Gn.click(i,S)},!0);let d=i.under=Ci(cS,h);h.appendChild(u);let p=i.over=Ci(uS,h);n=po(n);let v=+Mt(n.pxAlign,1),g=r0(v);(n.plugins||[]).forEach(S=>{S.opts&&(n=S.opts(i,n)||n)});let m=n.ms||.001,y=i.series=s==1?l0(n.series||[],jg,i0,!1):XM(n.series||[null],n0),M=i.axes=l0(n.axes||[],Kg,e0,!0),b=i.scales={},R=i.bands=n.bands||[];R.forEach(S=>{S.fill=gt(S.fill||null),S.dir=Mt(S.dir,-1)});let T=s==2?y[1].facets[0].scale:y[0].scale,_={axes:vs,series:dt},E=(n.drawOrder||["axes","series"]).map(S=>_[S]);function U(S){let A=S.distr==3?I=>Ss(I>0?I:S.clamp(i,I,S.min,S.max,S.key)):S.distr==4?I=>Rd(I,S.asinh):S.distr==100?I=>S.fwd(I):I=>I;return I=>{let F=A(I),{_min:X,_max:K}=S,ae=K-X;return(F-X)/ae}}function N(S){let A=b[S];if(A==null){let I=(n.scales||Ta)[S]||Ta;if(I.from!=null){N(I.from);let F=Sn({},b[I.from],I,{key:S});F.valToPct=U(F),b[S]=F}else{A=b[S]=Sn({},S==T?O0:NM,I),A.key=S;let F=A.time,X=A.range,K=Js(X);if((S!=T||s==2&&!F)&&(K&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Og:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Og:{mode:1,hard:X[1],soft:X[1]}},K=!1),!K&&sc(X))){let ae=X;X=(fe,be,Ne)=>be==null?fo:Ql(be,Ne,ae)}A.range=gt(X||(F?$M:S==T?A.distr==3?YM:A.distr==4?JM:q0:A.distr==3?Y0:A.distr==4?J0:qM)),A.auto=gt(K?!1:A.auto),A.clamp=gt(A.clamp||LM),A._min=A._max=null,A.valToPct=U(A)}}}N("x"),N("y"),s==1&&y.forEach(S=>{N(S.scale)}),M.forEach(S=>{N(S.scale)});for(let S in n.scales)N(S);let L=b[T],B=L.distr,z,D;L.ori==0?(mi(c,rS),z=r,D=o):(mi(c,oS),z=o,D=r);let W={};for(let S in b){let A=b[S];(A.min!=null||A.max!=null)&&(W[S]={min:A.min,max:A.max},A.min=A.max=null)}let q=n.tzDate||(S=>new Date(Pn(S/m))),H=n.fmtDate||Zd,le=m==1?rM(q):lM(q),Z=Yg(q,qg(m==1?sM:aM,H)),Q=Zg(q,Jg(uM,H)),ie=[],de=i.legend=Sn({},fM,n.legend),he=i.cursor=Sn({},yM,{drag:{y:s==2}},n.cursor),ee=de.show,me=he.show,ge=de.markers;de.idxs=ie,ge.width=gt(ge.width),ge.dash=gt(ge.dash),ge.stroke=gt(ge.stroke),ge.fill=gt(ge.fill);let Me,ve,Ve,Xe=[],De=[],ut,at=!1,tt={};if(de.live){let S=y[1]?y[1].values:null;at=S!=null,ut=at?S(i,1,0):{_:0};for(let A in ut)tt[A]=Wd}if(ee)if(Me=Hi("table",gS,c),Ve=Hi("tbody",null,Me),de.mount(i,Me),at){ve=Hi("thead",null,Me,Ve);let S=Hi("tr",null,ve);Hi("th",null,S);for(var jt in ut)Hi("th",wg,S).textContent=jt}else mi(Me,vS),de.live&&mi(Me,xS);let Ht={show:!0},mn={show:!1};function Ut(S,A){if(A==0&&(at||!de.live||s==2))return fo;let I=[],F=Hi("tr",yS,Ve,Ve.childNodes[A]);mi(F,S.class),S.show||mi(F,Er);let X=Hi("th",null,F);if(ge.show){let fe=Ci(_S,X);if(A>0){let be=ge.width(i,A);be&&(fe.style.border=be+"px "+ge.dash(i,A)+" "+ge.stroke(i,A)),fe.style.background=ge.fill(i,A)}}let K=Ci(wg,X);S.label instanceof HTMLElement?K.appendChild(S.label):K.textContent=S.label,A>0&&(ge.show||(K.style.color=S.width>0?ge.stroke(i,A):ge.fill(i,A)),_t("click",X,fe=>{if(he._lock)return;Ze(fe);let be=y.indexOf(S);if((fe.ctrlKey||fe.metaKey)!=de.isolate){let Ne=y.some((Fe,Oe)=>Oe>0&&Oe!=be&&Fe.show);y.forEach((Fe,Oe)=>{Oe>0&&ns(Oe,Ne?Oe==be?Ht:mn:Ht,!0,_n.setSeries)})}else ns(be,{show:!S.show},!0,_n.setSeries)},!1),Ke&&_t(Cg,X,fe=>{he._lock||(Ze(fe),ns(y.indexOf(S),io,!0,_n.setSeries))},!1));for(var ae in ut){let fe=Hi("td",bS,F);fe.textContent="--",I.push(fe)}return[F,I]}let Dn=new Map;function _t(S,A,I,F=!0){let X=Dn.get(A)||{},K=he.bind[S](i,A,I,F);K&&(Tr(S,A,X[S]=K),Dn.set(A,X))}function Cn(S,A,I){let F=Dn.get(A)||{};for(let X in F)(S==null||X==S)&&(Ud(X,A,F[X]),delete F[X]);S==null&&Dn.delete(A)}let rn=0,gn=0,k=0,Re=0,qe=0,it=0,we=qe,Bt=it,He=k,$e=Re,P=0,w=0,$=0,ue=0;i.bbox={};let oe=!1,ye=!1,_e=!1,te=!1,se=!1,pe=!1;function O(S,A,I){(I||S!=i.width||A!=i.height)&&re(S,A),lt(!1),_e=!0,ye=!0,$n()}function re(S,A){i.width=rn=k=S,i.height=gn=Re=A,qe=it=0,Se(),Ge();let I=i.bbox;P=I.left=Mr(qe*Ct,.5),w=I.top=Mr(it*Ct,.5),$=I.width=Mr(k*Ct,.5),ue=I.height=Mr(Re*Ct,.5)}let ne=3;function Ee(){let S=!1,A=0;for(;!S;){A++;let I=Kr(A),F=ts(A);S=A==ne||I&&F,S||(re(i.width,i.height),ye=!0)}}function xe({width:S,height:A}){O(S,A)}i.setSize=xe;function Se(){let S=!1,A=!1,I=!1,F=!1;M.forEach((X,K)=>{if(X.show&&X._show){let{side:ae,_size:fe}=X,be=ae%2,Ne=X.label!=null?X.labelSize:0,Fe=fe+Ne;Fe>0&&(be?(k-=Fe,ae==3?(qe+=Fe,F=!0):I=!0):(Re-=Fe,ae==0?(it+=Fe,S=!0):A=!0))}}),Qi[0]=S,Qi[1]=I,Qi[2]=A,Qi[3]=F,k-=ki[1]+ki[3],qe+=ki[3],Re-=ki[2]+ki[0],it+=ki[0]}function Ge(){let S=qe+k,A=it+Re,I=qe,F=it;function X(K,ae){switch(K){case 1:return S+=ae,S-ae;case 2:return A+=ae,A-ae;case 3:return I-=ae,I+ae;case 0:return F-=ae,F+ae}}M.forEach((K,ae)=>{if(K.show&&K._show){let fe=K.side;K._pos=X(fe,K._size),K.label!=null&&(K._lpos=X(fe,K.labelSize))}})}if(he.dataIdx==null){let S=he.hover,A=S.skip=new Set(S.skip??[]);A.add(void 0);let I=S.prox=gt(S.prox),F=S.bias??=0;he.dataIdx=(X,K,ae,fe)=>{if(K==0)return ae;let be=ae,Ne=I(X,K,ae,fe)??zt,Fe=Ne>=0&&Ne<zt,Oe=L.ori==0?k:Re,nt=he.left,Et=e[0],St=e[K];if(A.has(St[ae])){be=null;let ft=null,Je=null,We;if(F==0||F==-1)for(We=ae;ft==null&&We-- >0;)A.has(St[We])||(ft=We);if(F==0||F==1)for(We=ae;Je==null&&We++<St.length;)A.has(St[We])||(Je=We);if(ft!=null||Je!=null)if(Fe){let qt=ft==null?-1/0:z(Et[ft],L,Oe,0),ln=Je==null?1/0:z(Et[Je],L,Oe,0),kn=nt-qt,Ot=ln-nt;kn<=Ot?kn<=Ne&&(be=ft):Ot<=Ne&&(be=Je)}else be=Je==null?ft:ft==null?Je:ae-ft<=Je-ae?ft:Je}else Fe&&In(nt-z(Et[ae],L,Oe,0))>Ne&&(be=null);return be}}let Ze=S=>{he.event=S};he.idxs=ie,he._lock=!1;let ce=he.points;ce.show=gt(ce.show),ce.size=gt(ce.size),ce.stroke=gt(ce.stroke),ce.width=gt(ce.width),ce.fill=gt(ce.fill);let ke=i.focus=Sn({},n.focus||{alpha:.3},he.focus),Ke=ke.prox>=0,Ce=Ke&&ce.one,st=[],Wt=[],Zn=[];function aa(S,A){let I=ce.show(i,A);if(I instanceof HTMLElement)return mi(I,mS),mi(I,S.class),as(I,-10,-10,k,Re),p.insertBefore(I,st[A]),I}function Yr(S,A){if(s==1||A>0){let I=s==1&&b[S.scale].time,F=S.value;S.value=I?Gg(F)?Zg(q,Jg(F,H)):F||Q:F||RM,S.label=S.label||(I?bM:_M)}if(Ce||A>0){S.width=S.width==null?1:S.width,S.paths=S.paths||GM||NS,S.fillTo=gt(S.fillTo||DM),S.pxAlign=+Mt(S.pxAlign,v),S.pxRound=r0(S.pxAlign),S.stroke=gt(S.stroke||null),S.fill=gt(S.fill||null),S._stroke=S._fill=S._paths=S._focus=null;let I=PM(ni(1,S.width),1),F=S.points=Sn({},{size:I,width:ni(1,I*.2),stroke:S.stroke,space:I*2,paths:WM,_stroke:null,_fill:null},S.points);F.show=gt(F.show),F.filter=gt(F.filter),F.fill=gt(F.fill),F.stroke=gt(F.stroke),F.paths=gt(F.paths),F.pxAlign=S.pxAlign}if(ee){let I=Ut(S,A);Xe.splice(A,0,I[0]),De.splice(A,0,I[1]),de.values.push(null)}if(me){ie.splice(A,0,null);let I=null;Ce?A==0&&(I=aa(S,A)):A>0&&(I=aa(S,A)),st.splice(A,0,I),Wt.splice(A,0,0),Zn.splice(A,0,0)}On("addSeries",A)}function Zh(S,A){A=A??y.length,S=s==1?Hd(S,A,jg,i0):Hd(S,A,{},n0),y.splice(A,0,S),Yr(y[A],A)}i.addSeries=Zh;function Al(S){if(y.splice(S,1),ee){de.values.splice(S,1),De.splice(S,1);let A=Xe.splice(S,1)[0];Cn(null,A.firstChild),A.remove()}me&&(ie.splice(S,1),st.splice(S,1)[0].remove(),Wt.splice(S,1),Zn.splice(S,1)),On("delSeries",S)}i.delSeries=Al;let Qi=[!1,!1,!1,!1];function ms(S,A){if(S._show=S.show,S.show){let I=S.side%2,F=b[S.scale];F==null&&(S.scale=I?y[1].scale:T,F=b[S.scale]);let X=F.time;S.size=gt(S.size),S.space=gt(S.space),S.rotate=gt(S.rotate),Js(S.incrs)&&S.incrs.forEach(ae=>{!Zs.has(ae)&&Zs.set(ae,v0(ae))}),S.incrs=gt(S.incrs||(F.distr==2?tM:X?m==1?iM:oM:wr)),S.splits=gt(S.splits||(X&&F.distr==1?le:F.distr==3?kd:F.distr==4?wM:MM)),S.stroke=gt(S.stroke),S.grid.stroke=gt(S.grid.stroke),S.ticks.stroke=gt(S.ticks.stroke),S.border.stroke=gt(S.border.stroke);let K=S.values;S.values=Js(K)&&!Js(K[0])?gt(K):X?Js(K)?Yg(q,qg(K,H)):Gg(K)?cM(q,K):K||Z:K||SM,S.filter=gt(S.filter||(F.distr>=3&&F.log==10?AM:F.distr==3&&F.log==2?CM:g0)),S.font=c0(S.font),S.labelFont=c0(S.labelFont),S._size=S.size(i,null,A,0),S._space=S._rotate=S._incrs=S._found=S._splits=S._values=null,S._size>0&&(Qi[A]=!0,S._el=Ci(hS,h))}}function gs(S,A,I,F){let[X,K,ae,fe]=I,be=A%2,Ne=0;return be==0&&(fe||K)&&(Ne=A==0&&!X||A==2&&!ae?Pn(Kg.size/3):0),be==1&&(X||ae)&&(Ne=A==1&&!K||A==3&&!fe?Pn(e0.size/2):0),Ne}let la=i.padding=(n.padding||[gs,gs,gs,gs]).map(S=>gt(Mt(S,gs))),ki=i._padding=la.map((S,A)=>S(i,A,Qi,0)),on,dn=null,fn=null,es=s==1?y[0].idxs:null,ui=null,zs=!1;function ca(S,A){if(e=S??[],i.data=i._data=e,s==2){on=0;for(let I=1;I<y.length;I++)on+=e[I][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),ui=e[0],on=ui.length;let I=e;if(B==2){I=e.slice();let F=I[0]=Array(on);for(let X=0;X<on;X++)F[X]=X}i._data=e=I}if(lt(!0),On("setData"),B==2&&(_e=!0),A!==!1){let I=L;I.auto(i,zs)?ua():Gs(T,I.min,I.max),te=te||he.left>=0,pe=!0,$n()}}i.setData=ca;function ua(){zs=!0;let S,A;s==1&&(on>0?(dn=es[0]=0,fn=es[1]=on-1,S=e[0][dn],A=e[0][fn],B==2?(S=dn,A=fn):S==A&&(B==3?[S,A]=nc(S,S,L.log,!1):B==4?[S,A]=$d(S,S,L.log,!1):L.time?A=S+Pn(86400/m):[S,A]=Ql(S,A,qd,!0))):(dn=es[0]=S=null,fn=es[1]=A=null)),Gs(T,S,A)}let Jr,Vs,Zr,C,V,j,Y,J,Te,Pe;function Ae(S,A,I,F,X,K){S??=Tg,I??=Jd,F??="butt",X??=Tg,K??="round",S!=Jr&&(f.strokeStyle=Jr=S),X!=Vs&&(f.fillStyle=Vs=X),A!=Zr&&(f.lineWidth=Zr=A),K!=V&&(f.lineJoin=V=K),F!=j&&(f.lineCap=j=F),I!=C&&f.setLineDash(C=I)}function Ie(S,A,I,F){A!=Vs&&(f.fillStyle=Vs=A),S!=Y&&(f.font=Y=S),I!=J&&(f.textAlign=J=I),F!=Te&&(f.textBaseline=Te=F)}function ze(S,A,I,F,X=0){if(F.length>0&&S.auto(i,zs)&&(A==null||A.min==null)){let K=Mt(dn,0),ae=Mt(fn,F.length-1),fe=I.min==null?AS(F,K,ae,X,S.distr==3):[I.min,I.max];S.min=Wi(S.min,I.min=fe[0]),S.max=ni(S.max,I.max=fe[1])}}let je={min:null,max:null};function ht(){for(let F in b){let X=b[F];W[F]==null&&(X.min==null||W[T]!=null&&X.auto(i,zs))&&(W[F]=je)}for(let F in b){let X=b[F];W[F]==null&&X.from!=null&&W[X.from]!=null&&(W[F]=je)}W[T]!=null&&lt(!0);let S={};for(let F in W){let X=W[F];if(X!=null){let K=S[F]=po(b[F],US);if(X.min!=null)Sn(K,X);else if(F!=T||s==2)if(on==0&&K.from==null){let ae=K.range(i,null,null,F);K.min=ae[0],K.max=ae[1]}else K.min=zt,K.max=-zt}}if(on>0){y.forEach((F,X)=>{if(s==1){let K=F.scale,ae=W[K];if(ae==null)return;let fe=S[K];if(X==0){let be=fe.range(i,fe.min,fe.max,K);fe.min=be[0],fe.max=be[1],dn=Gi(fe.min,e[0]),fn=Gi(fe.max,e[0]),fn-dn>1&&(e[0][dn]<fe.min&&dn++,e[0][fn]>fe.max&&fn--),F.min=ui[dn],F.max=ui[fn]}else F.show&&F.auto&&ze(fe,ae,F,e[X],F.sorted);F.idxs[0]=dn,F.idxs[1]=fn}else if(X>0&&F.show&&F.auto){let[K,ae]=F.facets,fe=K.scale,be=ae.scale,[Ne,Fe]=e[X],Oe=S[fe],nt=S[be];Oe!=null&&ze(Oe,W[fe],K,Ne,K.sorted),nt!=null&&ze(nt,W[be],ae,Fe,ae.sorted),F.min=ae.min,F.max=ae.max}});for(let F in S){let X=S[F],K=W[F];if(X.from==null&&(K==null||K.min==null)){let ae=X.range(i,X.min==zt?null:X.min,X.max==-zt?null:X.max,F);X.min=ae[0],X.max=ae[1]}}}for(let F in S){let X=S[F];if(X.from!=null){let K=S[X.from];if(K.min==null)X.min=X.max=null;else{let ae=X.range(i,K.min,K.max,F);X.min=ae[0],X.max=ae[1]}}}let A={},I=!1;for(let F in S){let X=S[F],K=b[F];if(K.min!=X.min||K.max!=X.max){K.min=X.min,K.max=X.max;let ae=K.distr;K._min=ae==3?Ss(K.min):ae==4?Rd(K.min,K.asinh):ae==100?K.fwd(K.min):K.min,K._max=ae==3?Ss(K.max):ae==4?Rd(K.max,K.asinh):ae==100?K.fwd(K.max):K.max,A[F]=I=!0}}if(I){y.forEach((F,X)=>{s==2?X>0&&A.y&&(F._paths=null):A[F.scale]&&(F._paths=null)});for(let F in A)_e=!0,On("setScale",F);me&&he.left>=0&&(te=pe=!0)}for(let F in W)W[F]=null}function Be(S){let A=Od(dn-1,0,on-1),I=Od(fn+1,0,on-1);for(;S[A]==null&&A>0;)A--;for(;S[I]==null&&I<on-1;)I++;return[A,I]}function dt(){if(on>0){let S=y.some(A=>A._focus)&&Pe!=ke.alpha;S&&(f.globalAlpha=Pe=ke.alpha),y.forEach((A,I)=>{if(I>0&&A.show&&(nn(I,!1),nn(I,!0),A._paths==null)){let F=Pe;Pe!=A.alpha&&(f.globalAlpha=Pe=A.alpha);let X=s==2?[0,e[I][0].length-1]:Be(e[I]);A._paths=A.paths(i,I,X[0],X[1]),Pe!=F&&(f.globalAlpha=Pe=F)}}),y.forEach((A,I)=>{if(I>0&&A.show){let F=Pe;Pe!=A.alpha&&(f.globalAlpha=Pe=A.alpha),A._paths!=null&&It(I,!1);{let X=A._paths!=null?A._paths.gaps:null,K=A.points.show(i,I,dn,fn,X),ae=A.points.filter(i,I,K,X);(K||ae)&&(A.points._paths=A.points.paths(i,I,dn,fn,ae),It(I,!0))}Pe!=F&&(f.globalAlpha=Pe=F),On("drawSeries",I)}}),S&&(f.globalAlpha=Pe=1)}}function nn(S,A){let I=A?y[S].points:y[S];I._stroke=I.stroke(i,S),I._fill=I.fill(i,S)}function It(S,A){let I=A?y[S].points:y[S],{stroke:F,fill:X,clip:K,flags:ae,_stroke:fe=I._stroke,_fill:be=I._fill,_width:Ne=I.width}=I._paths;Ne=Vt(Ne*Ct,3);let Fe=null,Oe=Ne%2/2;A&&be==null&&(be=Ne>0?"#fff":fe);let nt=I.pxAlign==1&&Oe>0;if(nt&&f.translate(Oe,Oe),!A){let Et=P-Ne/2,St=w-Ne/2,ft=$+Ne,Je=ue+Ne;Fe=new Path2D,Fe.rect(Et,St,ft,Je)}A?Ue(fe,Ne,I.dash,I.cap,be,F,X,ae,K):Lt(S,fe,Ne,I.dash,I.cap,be,F,X,ae,Fe,K),nt&&f.translate(-Oe,-Oe)}function Lt(S,A,I,F,X,K,ae,fe,be,Ne,Fe){let Oe=!1;be!=0&&R.forEach((nt,Et)=>{if(nt.series[0]==S){let St=y[nt.series[1]],ft=e[nt.series[1]],Je=(St._paths||Ta).band;Js(Je)&&(Je=nt.dir==1?Je[0]:Je[1]);let We,qt=null;St.show&&Je&&RS(ft,dn,fn)?(qt=nt.fill(i,Et)||K,We=St._paths.clip):Je=null,Ue(A,I,F,X,qt,ae,fe,be,Ne,Fe,We,Je),Oe=!0}}),Oe||Ue(A,I,F,X,K,ae,fe,be,Ne,Fe)}let Rn=mo|zd;function Ue(S,A,I,F,X,K,ae,fe,be,Ne,Fe,Oe){Ae(S,A,I,F,X),(be||Ne||Oe)&&(f.save(),be&&f.clip(be),Ne&&f.clip(Ne)),Oe?(fe&Rn)==Rn?(f.clip(Oe),Fe&&f.clip(Fe),mt(X,ae),xn(S,K,A)):fe&zd?(mt(X,ae),f.clip(Oe),xn(S,K,A)):fe&mo&&(f.save(),f.clip(Oe),Fe&&f.clip(Fe),mt(X,ae),f.restore(),xn(S,K,A)):(mt(X,ae),xn(S,K,A)),(be||Ne||Oe)&&f.restore()}function xn(S,A,I){I>0&&(A instanceof Map?A.forEach((F,X)=>{f.strokeStyle=Jr=X,f.stroke(F)}):A!=null&&S&&f.stroke(A))}function mt(S,A){A instanceof Map?A.forEach((I,F)=>{f.fillStyle=Vs=F,f.fill(I)}):A!=null&&S&&f.fill(A)}function xs(S,A,I,F){let X=M[S],K;if(F<=0)K=[0,0];else{let ae=X._space=X.space(i,S,A,I,F),fe=X._incrs=X.incrs(i,S,A,I,F,ae);K=ZM(A,I,fe,F,ae)}return X._found=K}function vn(S,A,I,F,X,K,ae,fe,be,Ne){let Fe=ae%2/2;v==1&&f.translate(Fe,Fe),Ae(fe,ae,be,Ne,fe),f.beginPath();let Oe,nt,Et,St,ft=X+(F==0||F==3?-K:K);I==0?(nt=X,St=ft):(Oe=X,Et=ft);for(let Je=0;Je<S.length;Je++)A[Je]!=null&&(I==0?Oe=Et=S[Je]:nt=St=S[Je],f.moveTo(Oe,nt),f.lineTo(Et,St));f.stroke(),v==1&&f.translate(-Fe,-Fe)}function Kr(S){let A=!0;return M.forEach((I,F)=>{if(!I.show)return;let X=b[I.scale];if(X.min==null){I._show&&(A=!1,I._show=!1,lt(!1));return}else I._show||(A=!1,I._show=!0,lt(!1));let K=I.side,ae=K%2,{min:fe,max:be}=X,[Ne,Fe]=xs(F,fe,be,ae==0?k:Re);if(Fe==0)return;let Oe=X.distr==2,nt=I._splits=I.splits(i,F,fe,be,Ne,Fe,Oe),Et=X.distr==2?nt.map(We=>ui[We]):nt,St=X.distr==2?ui[nt[1]]-ui[nt[0]]:Ne,ft=I._values=I.values(i,I.filter(i,Et,F,Fe,St),F,Fe,St);I._rotate=K==2?I.rotate(i,ft,F,Fe):0;let Je=I._size;I._size=Ri(I.size(i,ft,F,S)),Je!=null&&I._size!=Je&&(A=!1)}),A}function ts(S){let A=!0;return la.forEach((I,F)=>{let X=I(i,F,Qi,S);X!=ki[F]&&(A=!1),ki[F]=X}),A}function vs(){for(let S=0;S<M.length;S++){let A=M[S];if(!A.show||!A._show)continue;let I=A.side,F=I%2,X,K,ae=A.stroke(i,S),fe=I==0||I==3?-1:1,[be,Ne]=A._found;if(A.label!=null){let Qn=A.labelGap*fe,fi=Pn((A._lpos+Qn)*Ct);Ie(A.labelFont[0],ae,"center",I==2?"top":Eg),f.save(),F==1?(X=K=0,f.translate(fi,Pn(w+ue/2)),f.rotate((I==3?-Kl:Kl)/2)):(X=Pn(P+$/2),K=fi);let yr=p0(A.label)?A.label(i,S,be,Ne):A.label;f.fillText(yr,X,K),f.restore()}if(Ne==0)continue;let Fe=b[A.scale],Oe=F==0?$:ue,nt=F==0?P:w,Et=A._splits,St=Fe.distr==2?Et.map(Qn=>ui[Qn]):Et,ft=Fe.distr==2?ui[Et[1]]-ui[Et[0]]:be,Je=A.ticks,We=A.border,qt=Je.show?Je.size:0,ln=Pn(qt*Ct),kn=Pn((A.alignTo==2?A._size-qt-A.gap:A.gap)*Ct),Ot=A._rotate*-Kl/180,cn=g(A._pos*Ct),hi=(ln+kn)*fe,jn=cn+hi;K=F==0?jn:0,X=F==1?jn:0;let Ti=A.font[0],Bi=A.align==1?lo:A.align==2?Td:Ot>0?lo:Ot<0?Td:F==0?"center":I==3?Td:lo,ss=Ot||F==1?"middle":I==2?"top":Eg;Ie(Ti,ae,Bi,ss);let di=A.font[1]*A.lineGap,Ai=Et.map(Qn=>g(a(Qn,Fe,Oe,nt))),zi=A._values;for(let Qn=0;Qn<zi.length;Qn++){let fi=zi[Qn];if(fi!=null){F==0?X=Ai[Qn]:K=Ai[Qn],fi=""+fi;let yr=fi.indexOf(`
`)==-1?[fi]:fi.split(/\n/gm);for(let ei=0;ei<yr.length;ei++){let km=yr[ei];Ot?(f.save(),f.translate(X,K+ei*di),f.rotate(Ot),f.fillText(km,0,0),f.restore()):f.fillText(km,X,K+ei*di)}}}Je.show&&vn(Ai,Je.filter(i,St,S,Ne,ft),F,I,cn,ln,Vt(Je.width*Ct,3),Je.stroke(i,S),Je.dash,Je.cap);let rs=A.grid;rs.show&&vn(Ai,rs.filter(i,St,S,Ne,ft),F,F==0?2:1,F==0?w:P,F==0?ue:$,Vt(rs.width*Ct,3),rs.stroke(i,S),rs.dash,rs.cap),We.show&&vn([cn],[1],F==0?1:0,F==0?1:2,F==1?w:P,F==1?ue:$,Vt(We.width*Ct,3),We.stroke(i,S),We.dash,We.cap)}On("drawAxes")}function lt(S){y.forEach((A,I)=>{I>0&&(A._paths=null,S&&(s==1?(A.min=null,A.max=null):A.facets.forEach(F=>{F.min=null,F.max=null})))})}let an=!1,Kn=!1,Nt=[];function yn(){Kn=!1;for(let S=0;S<Nt.length;S++)On(...Nt[S]);Nt.length=0}function $n(){an||(GS(_m),an=!0)}function Cl(S,A=!1){an=!0,Kn=A,S(i),_m(),A&&Nt.length>0&&queueMicrotask(yn)}i.batch=Cl;function _m(){if(oe&&(ht(),oe=!1),_e&&(Ee(),_e=!1),ye){if(Yt(d,lo,qe),Yt(d,"top",it),Yt(d,Sa,k),Yt(d,Ma,Re),Yt(p,lo,qe),Yt(p,"top",it),Yt(p,Sa,k),Yt(p,Ma,Re),Yt(h,Sa,rn),Yt(h,Ma,gn),u.width=Pn(rn*Ct),u.height=Pn(gn*Ct),M.forEach(({_el:S,_show:A,_size:I,_pos:F,side:X})=>{if(S!=null)if(A){let K=X===3||X===0?I:0,ae=X%2==1;Yt(S,ae?"left":"top",F-K),Yt(S,ae?"width":"height",I),Yt(S,ae?"top":"left",ae?it:qe),Yt(S,ae?"height":"width",ae?Re:k),Fd(S,Er)}else mi(S,Er)}),Jr=Vs=Zr=V=j=Y=J=Te=C=null,Pe=1,fa(!0),qe!=we||it!=Bt||k!=He||Re!=$e){lt(!1);let S=k/He,A=Re/$e;if(me&&!te&&he.left>=0){he.left*=S,he.top*=A,jr&&as(jr,Pn(he.left),0,k,Re),Qr&&as(Qr,0,Pn(he.top),k,Re);for(let I=0;I<st.length;I++){let F=st[I];F!=null&&(Wt[I]*=S,Zn[I]*=A,as(F,Ri(Wt[I]),Ri(Zn[I]),k,Re))}}if($t.show&&!se&&$t.left>=0&&$t.width>0){$t.left*=S,$t.width*=S,$t.top*=A,$t.height*=A;for(let I in nd)Yt(no,I,$t[I])}we=qe,Bt=it,He=k,$e=Re}On("setSize"),ye=!1}rn>0&&gn>0&&(f.clearRect(0,0,u.width,u.height),On("drawClear"),E.forEach(S=>S()),On("draw")),$t.show&&se&&(Rl($t),se=!1),me&&te&&(vr(null,!0,!1),te=!1),de.show&&de.live&&pe&&(ed(),pe=!1),l||(l=!0,i.status=1,On("ready")),zs=!1,an=!1}i.redraw=(S,A)=>{_e=A||!1,S!==!1?Gs(T,L.min,L.max):$n()};function Kh(S,A){let I=b[S];if(I.from==null){if(on==0){let F=I.range(i,A.min,A.max,S);A.min=F[0],A.max=F[1]}if(A.min>A.max){let F=A.min;A.min=A.max,A.max=F}if(on>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;S==T&&I.distr==2&&on>0&&(A.min=Gi(A.min,e[0]),A.max=Gi(A.max,e[0]),A.min==A.max&&A.max++),W[S]=A,oe=!0,$n()}}i.setScale=Kh;let jh,Qh,jr,Qr,bm,Sm,eo,to,Mm,wm,Xt,Qt,Hs=!1,Gn=he.drag,Fn=Gn.x,Un=Gn.y;me&&(he.x&&(jh=Ci(fS,p)),he.y&&(Qh=Ci(pS,p)),L.ori==0?(jr=jh,Qr=Qh):(jr=Qh,Qr=jh),Xt=he.left,Qt=he.top);let $t=i.select=Sn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),no=$t.show?Ci(dS,$t.over?p:d):null;function Rl(S,A){if($t.show){for(let I in S)$t[I]=S[I],I in nd&&Yt(no,I,S[I]);A!==!1&&On("setSelect")}}i.setSelect=Rl;function rb(S){if(y[S].show)ee&&Fd(Xe[S],Er);else if(ee&&mi(Xe[S],Er),me){let I=Ce?st[0]:st[S];I!=null&&as(I,-10,-10,k,Re)}}function Gs(S,A,I){Kh(S,{min:A,max:I})}function ns(S,A,I,F){A.focus!=null&&ub(S),A.show!=null&&y.forEach((X,K)=>{K>0&&(S==K||S==null)&&(X.show=A.show,rb(K),s==2?(Gs(X.facets[0].scale,null,null),Gs(X.facets[1].scale,null,null)):Gs(X.scale,null,null),$n())}),I!==!1&&On("setSeries",S,A),F&&pa("setSeries",i,S,A)}i.setSeries=ns;function ob(S,A){Sn(R[S],A)}function ab(S,A){S.fill=gt(S.fill||null),S.dir=Mt(S.dir,-1),A=A??R.length,R.splice(A,0,S)}function lb(S){S==null?R.length=0:R.splice(S,1)}i.addBand=ab,i.setBand=ob,i.delBand=lb;function cb(S,A){y[S].alpha=A,me&&st[S]!=null&&(st[S].style.opacity=A),ee&&Xe[S]&&(Xe[S].style.opacity=A)}let ys,Ws,xr,io={focus:!0};function ub(S){if(S!=xr){let A=S==null,I=ke.alpha!=1;y.forEach((F,X)=>{if(s==1||X>0){let K=A||X==0||X==S;F._focus=A?null:K,I&&cb(X,K?1:ke.alpha)}}),xr=S,I&&$n()}}ee&&Ke&&_t(Rg,Me,S=>{he._lock||(Ze(S),xr!=null&&ns(null,io,!0,_n.setSeries))});function is(S,A,I){let F=b[A];I&&(S=S/Ct-(F.ori==1?it:qe));let X=k;F.ori==1&&(X=Re,S=X-S),F.dir==-1&&(S=X-S);let K=F._min,ae=F._max,fe=S/X,be=K+(ae-K)*fe,Ne=F.distr;return Ne==3?ho(10,be):Ne==4?IS(be,F.asinh):Ne==100?F.bwd(be):be}function hb(S,A){let I=is(S,T,A);return Gi(I,e[0],dn,fn)}i.valToIdx=S=>Gi(S,e[0]),i.posToIdx=hb,i.posToVal=is,i.valToPos=(S,A,I)=>b[A].ori==0?r(S,b[A],I?$:k,I?P:0):o(S,b[A],I?ue:Re,I?w:0),i.setCursor=(S,A,I)=>{Xt=S.left,Qt=S.top,vr(null,A,I)};function Em(S,A){Yt(no,lo,$t.left=S),Yt(no,Sa,$t.width=A)}function Tm(S,A){Yt(no,"top",$t.top=S),Yt(no,Ma,$t.height=A)}let ha=L.ori==0?Em:Tm,da=L.ori==1?Em:Tm;function db(){if(ee&&de.live)for(let S=s==2?1:0;S<y.length;S++){if(S==0&&at)continue;let A=de.values[S],I=0;for(let F in A)De[S][I++].firstChild.nodeValue=A[F]}}function ed(S,A){if(S!=null&&(S.idxs?S.idxs.forEach((I,F)=>{ie[F]=I}):FS(S.idx)||ie.fill(S.idx),de.idx=ie[0]),ee&&de.live){for(let I=0;I<y.length;I++)(I>0||s==1&&!at)&&fb(I,ie[I]);db()}pe=!1,A!==!1&&On("setLegend")}i.setLegend=ed;function fb(S,A){let I=y[S],F=S==0&&B==2?ui:e[S],X;at?X=I.values(i,S,A)??tt:(X=I.value(i,A==null?null:F[A],S,A),X=X==null?tt:{_:X}),de.values[S]=X}function vr(S,A,I){Mm=Xt,wm=Qt,[Xt,Qt]=he.move(i,Xt,Qt),he.left=Xt,he.top=Qt,me&&(jr&&as(jr,Pn(Xt),0,k,Re),Qr&&as(Qr,0,Pn(Qt),k,Re));let F,X=dn>fn;ys=zt,Ws=null;let K=L.ori==0?k:Re,ae=L.ori==1?k:Re;if(Xt<0||on==0||X){F=he.idx=null;for(let fe=0;fe<y.length;fe++){let be=st[fe];be!=null&&as(be,-10,-10,k,Re)}Ke&&ns(null,io,!0,S==null&&_n.setSeries),de.live&&(ie.fill(F),pe=!0)}else{let fe,be,Ne;s==1&&(fe=L.ori==0?Xt:Qt,be=is(fe,T),F=he.idx=Gi(be,e[0],dn,fn),Ne=z(e[0][F],L,K,0));let Fe=-10,Oe=-10,nt=0,Et=0,St=!0,ft="",Je="";for(let We=s==2?1:0;We<y.length;We++){let qt=y[We],ln=ie[We],kn=ln==null?null:s==1?e[We][ln]:e[We][1][ln],Ot=he.dataIdx(i,We,F,be),cn=Ot==null?null:s==1?e[We][Ot]:e[We][1][Ot];if(pe=pe||cn!=kn||Ot!=ln,ie[We]=Ot,We>0&&qt.show){let hi=Ot==null?-10:Ot==F?Ne:z(s==1?e[0][Ot]:e[We][0][Ot],L,K,0),jn=cn==null?-10:D(cn,s==1?b[qt.scale]:b[qt.facets[1].scale],ae,0);if(Ke&&cn!=null){let Ti=L.ori==1?Xt:Qt,Bi=In(ke.dist(i,We,Ot,jn,Ti));if(Bi<ys){let ss=ke.bias;if(ss!=0){let di=is(Ti,qt.scale),Ai=cn>=0?1:-1,zi=di>=0?1:-1;zi==Ai&&(zi==1?ss==1?cn>=di:cn<=di:ss==1?cn<=di:cn>=di)&&(ys=Bi,Ws=We)}else ys=Bi,Ws=We}}if(pe||Ce){let Ti,Bi;L.ori==0?(Ti=hi,Bi=jn):(Ti=jn,Bi=hi);let ss,di,Ai,zi,rs,Qn,fi=!0,yr=ce.bbox;if(yr!=null){fi=!1;let ei=yr(i,We);Ai=ei.left,zi=ei.top,ss=ei.width,di=ei.height}else Ai=Ti,zi=Bi,ss=di=ce.size(i,We);if(Qn=ce.fill(i,We),rs=ce.stroke(i,We),Ce)We==Ws&&ys<=ke.prox&&(Fe=Ai,Oe=zi,nt=ss,Et=di,St=fi,ft=Qn,Je=rs);else{let ei=st[We];ei!=null&&(Wt[We]=Ai,Zn[We]=zi,Ug(ei,ss,di,fi),Dg(ei,Qn,rs),as(ei,Ri(Ai),Ri(zi),k,Re))}}}}if(Ce){let We=ke.prox,qt=xr==null?ys<=We:ys>We||Ws!=xr;if(pe||qt){let ln=st[0];ln!=null&&(Wt[0]=Fe,Zn[0]=Oe,Ug(ln,nt,Et,St),Dg(ln,ft,Je),as(ln,Ri(Fe),Ri(Oe),k,Re))}}}if($t.show&&Hs)if(S!=null){let[fe,be]=_n.scales,[Ne,Fe]=_n.match,[Oe,nt]=S.cursor.sync.scales,Et=S.cursor.drag;if(Fn=Et._x,Un=Et._y,Fn||Un){let{left:St,top:ft,width:Je,height:We}=S.select,qt=S.scales[Oe].ori,ln=S.posToVal,kn,Ot,cn,hi,jn,Ti=fe!=null&&Ne(fe,Oe),Bi=be!=null&&Fe(be,nt);Ti&&Fn?(qt==0?(kn=St,Ot=Je):(kn=ft,Ot=We),cn=b[fe],hi=z(ln(kn,Oe),cn,K,0),jn=z(ln(kn+Ot,Oe),cn,K,0),ha(Wi(hi,jn),In(jn-hi))):ha(0,K),Bi&&Un?(qt==1?(kn=St,Ot=Je):(kn=ft,Ot=We),cn=b[be],hi=D(ln(kn,nt),cn,ae,0),jn=D(ln(kn+Ot,nt),cn,ae,0),da(Wi(hi,jn),In(jn-hi))):da(0,ae)}else id()}else{let fe=In(Mm-bm),be=In(wm-Sm);if(L.ori==1){let nt=fe;fe=be,be=nt}Fn=Gn.x&&fe>=Gn.dist,Un=Gn.y&&be>=Gn.dist;let Ne=Gn.uni;Ne!=null?Fn&&Un&&(Fn=fe>=Ne,Un=be>=Ne,!Fn&&!Un&&(be>fe?Un=!0:Fn=!0)):Gn.x&&Gn.y&&(Fn||Un)&&(Fn=Un=!0);let Fe,Oe;Fn&&(L.ori==0?(Fe=eo,Oe=Xt):(Fe=to,Oe=Qt),ha(Wi(Fe,Oe),In(Oe-Fe)),Un||da(0,ae)),Un&&(L.ori==1?(Fe=eo,Oe=Xt):(Fe=to,Oe=Qt),da(Wi(Fe,Oe),In(Oe-Fe)),Fn||ha(0,K)),!Fn&&!Un&&(ha(0,0),da(0,0))}if(Gn._x=Fn,Gn._y=Un,S==null){if(I){if(Om!=null){let[fe,be]=_n.scales;_n.values[0]=fe!=null?is(L.ori==0?Xt:Qt,fe):null,_n.values[1]=be!=null?is(L.ori==1?Xt:Qt,be):null}pa(Ad,i,Xt,Qt,k,Re,F)}if(Ke){let fe=I&&_n.setSeries,be=ke.prox;xr==null?ys<=be&&ns(Ws,io,!0,fe):ys>be?ns(null,io,!0,fe):Ws!=xr&&ns(Ws,io,!0,fe)}}pe&&(de.idx=F,ed()),A!==!1&&On("setCursor")}let Xs=null;Object.defineProperty(i,"rect",{get(){return Xs==null&&fa(!1),Xs}});function fa(S=!1){S?Xs=null:(Xs=p.getBoundingClientRect(),On("syncRect",Xs))}function Am(S,A,I,F,X,K,ae){he._lock||Hs&&S!=null&&S.movementX==0&&S.movementY==0||(td(S,A,I,F,X,K,ae,!1,S!=null),S!=null?vr(null,!0,!0):vr(A,!0,!1))}function td(S,A,I,F,X,K,ae,fe,be){if(Xs==null&&fa(!1),Ze(S),S!=null)I=S.clientX-Xs.left,F=S.clientY-Xs.top;else{if(I<0||F<0){Xt=-10,Qt=-10;return}let[Ne,Fe]=_n.scales,Oe=A.cursor.sync,[nt,Et]=Oe.values,[St,ft]=Oe.scales,[Je,We]=_n.match,qt=A.axes[0].side%2==1,ln=L.ori==0?k:Re,kn=L.ori==1?k:Re,Ot=qt?K:X,cn=qt?X:K,hi=qt?F:I,jn=qt?I:F;if(St!=null?I=Je(Ne,St)?a(nt,b[Ne],ln,0):-10:I=ln*(hi/Ot),ft!=null?F=We(Fe,ft)?a(Et,b[Fe],kn,0):-10:F=kn*(jn/cn),L.ori==1){let Ti=I;I=F,F=Ti}}be&&(A==null||A.cursor.event.type==Ad)&&((I<=1||I>=k-1)&&(I=Mr(I,k)),(F<=1||F>=Re-1)&&(F=Mr(F,Re))),fe?(bm=I,Sm=F,[eo,to]=he.move(i,I,F)):(Xt=I,Qt=F)}let nd={width:0,height:0,left:0,top:0};function id(){Rl(nd,!1)}let Cm,Rm,Pm,Im;function Lm(S,A,I,F,X,K,ae){Hs=!0,Fn=Un=Gn._x=Gn._y=!1,td(S,A,I,F,X,K,ae,!0,!1),S!=null&&(_t(Cd,Nd,Nm,!1),pa(Ag,i,eo,to,k,Re,null));let{left:fe,top:be,width:Ne,height:Fe}=$t;Cm=fe,Rm=be,Pm=Ne,Im=Fe}function Nm(S,A,I,F,X,K,ae){Hs=Gn._x=Gn._y=!1,td(S,A,I,F,X,K,ae,!1,!0);let{left:fe,top:be,width:Ne,height:Fe}=$t,Oe=Ne>0||Fe>0,nt=Cm!=fe||Rm!=be||Pm!=Ne||Im!=Fe;if(Oe&&nt&&Rl($t),Gn.setScale&&Oe&&nt){let Et=fe,St=Ne,ft=be,Je=Fe;if(L.ori==1&&(Et=be,St=Fe,ft=fe,Je=Ne),Fn&&Gs(T,is(Et,T),is(Et+St,T)),Un)for(let We in b){let qt=b[We];We!=T&&qt.from==null&&qt.min!=zt&&Gs(We,is(ft+Je,We),is(ft,We))}id()}else he.lock&&(he._lock=!he._lock,vr(A,!0,S!=null));S!=null&&(Cn(Cd,Nd),pa(Cd,i,Xt,Qt,k,Re,null))}function pb(S,A,I,F,X,K,ae){if(he._lock)return;Ze(S);let fe=Hs;if(Hs){let be=!0,Ne=!0,Fe=10,Oe,nt;L.ori==0?(Oe=Fn,nt=Un):(Oe=Un,nt=Fn),Oe&&nt&&(be=Xt<=Fe||Xt>=k-Fe,Ne=Qt<=Fe||Qt>=Re-Fe),Oe&&be&&(Xt=Xt<eo?0:k),nt&&Ne&&(Qt=Qt<to?0:Re),vr(null,!0,!0),Hs=!1}Xt=-10,Qt=-10,ie.fill(null),vr(null,!0,!0),fe&&(Hs=fe)}function Dm(S,A,I,F,X,K,ae){he._lock||(Ze(S),ua(),id(),S!=null&&pa(Pg,i,Xt,Qt,k,Re,null))}function Fm(){M.forEach(KM),O(i.width,i.height,!0)}Tr(jl,uo,Fm);let so={};so.mousedown=Lm,so.mousemove=Am,so.mouseup=Nm,so.dblclick=Dm,so.setSeries=(S,A,I,F)=>{let X=_n.match[2];I=X(i,A,I),I!=-1&&ns(I,F,!0,!1)},me&&(_t(Ag,p,Lm),_t(Ad,p,Am),_t(Cg,p,S=>{Ze(S),fa(!1)}),_t(Rg,p,pb),_t(Pg,p,Dm),Vd.add(i),i.syncRect=fa);let Pl=i.hooks=n.hooks||{};function On(S,A,I){Kn?Nt.push([S,A,I]):S in Pl&&Pl[S].forEach(F=>{F.call(null,i,A,I)})}(n.plugins||[]).forEach(S=>{for(let A in S.hooks)Pl[A]=(Pl[A]||[]).concat(S.hooks[A])});let Um=(S,A,I)=>I,_n=Sn({key:null,setSeries:!1,filters:{pub:Vg,sub:Vg},scales:[T,y[1]?y[1].scale:null],match:[Hg,Hg,Um],values:[null,null]},he.sync);_n.match.length==2&&_n.match.push(Um),he.sync=_n;let Om=_n.key,sd=k0(Om);function pa(S,A,I,F,X,K,ae){_n.filters.pub(S,A,I,F,X,K,ae)&&sd.pub(S,A,I,F,X,K,ae)}sd.sub(i);function mb(S,A,I,F,X,K,ae){_n.filters.sub(S,A,I,F,X,K,ae)&&so[S](null,A,I,F,X,K,ae)}i.pub=mb;function gb(){sd.unsub(i),Vd.delete(i),Dn.clear(),Ud(jl,uo,Fm),c.remove(),Me?.remove(),On("destroy")}i.destroy=gb;function rd(){On("init",n,e),ca(e||n.data,!1),W[T]?Kh(T,W[T]):ua(),se=$t.show&&($t.width>0||$t.height>0),te=pe=!0,O(n.width,n.height)}return y.forEach(Yr),M.forEach(ms),t?t instanceof HTMLElement?(t.appendChild(c),rd()):t(i,rd):rd(),i}Mn.assign=Sn;Mn.fmtNum=Yd;Mn.rangeNum=Ql;Mn.rangeLog=nc;Mn.rangeAsinh=$d;Mn.orient=Cr;Mn.pxRatio=Ct;Mn.join=HS;Mn.fmtDate=Zd,Mn.tzDate=QS;Mn.sync=k0;{Mn.addGap=FM,Mn.clipGaps=rc;let n=Mn.paths={points:W0};n.linear=$0,n.stepped=kM,n.bars=BM,n.spline=VM}var sf="calyx-theme",Z0="(prefers-color-scheme: dark)";function uc(){let n=localStorage.getItem(sf);return n==="light"||n==="dark"?n:"system"}function hc(n){n==="system"?localStorage.removeItem(sf):localStorage.setItem(sf,n),n==="system"?delete document.documentElement.dataset.theme:document.documentElement.dataset.theme=n,window.dispatchEvent(new Event("calyx-theme"))}function cc(){let n=document.documentElement.dataset.theme;return n==="light"||n==="dark"?n:matchMedia(Z0).matches?"dark":"light"}function dc(){let[n,e]=Tt(cc());return At(()=>{let t=()=>e(cc()),i=matchMedia(Z0);return i.addEventListener("change",t),window.addEventListener("calyx-theme",t),()=>{i.removeEventListener("change",t),window.removeEventListener("calyx-theme",t)}},[]),n}var K0=[["cycle","Mesh cycle"],["roll_angle","Roll angle in deg"],["time","Time in s"],["step","Position"]],j0=190,jM=[void 0,[7,4],[2,3],[12,3,2,3]],QM=2;function Q0({studio:n}){let[e,t]=Tt("cycle"),[i,s]=Tt(null),r=n.settings.selected,o=r.flatMap(u=>n.results[u]??[]).filter(u=>u.steps),a=tw(o);if(a.length===0)return null;let l=(i??a.slice(0,QM)).filter(u=>a.includes(u)),c=u=>s(l.includes(u)?l.filter(f=>f!==u):[...l,u]);return x("details",{class:"plots",open:!0,children:[x("summary",{children:["Plots",o.filter(u=>u.incomplete).map(u=>x("span",{class:"incomplete",children:[en(u.id),": ",os(u)]},u.id))]}),x("div",{class:"plot-settings",children:[x("div",{class:"chips",role:"group","aria-label":"Plotted outputs",children:a.map(u=>x("button",{type:"button",class:"chip","aria-pressed":l.includes(u),onClick:()=>c(u),children:tn(u)},u))}),o.some(u=>u.stride>1)&&x("span",{class:"muted small-text",children:["one of ",Math.max(...o.map(u=>u.stride))," positions"]}),x("label",{class:"inline",children:["over",x("select",{value:e,onChange:u=>t(u.currentTarget.value),children:K0.map(([u,f])=>x("option",{value:u,children:f},u))})]})]}),x("div",{class:"plot-grid",children:l.map(u=>x(sw,{title:tn(u),unit:nw(n,o,u),label:K0.find(([f])=>f===e)?.[1]??"",curves:o.flatMap(f=>iw(n,f,u,e,r.indexOf(f.id)))},u))})]})}var ew=new Set(["step","time","cycle","roll_angle","point"]);function tw(n){return[...new Set(n.flatMap(e=>Object.keys(e.steps??{})))].filter(e=>!ew.has(e))}function ex(n,e,t){let i=e.run?.outputs?.[t]?.display??e.run?.columns?.[t]?.display,s=n.model?.outputs.find(r=>r.name===t);return{unit:i?.unit??s?.unit??"SI",factor:i?.factor??s?.factor??1}}function nw(n,e,t){let i=e.find(s=>s.steps?.[t]);return i?ex(n,i,t).unit:""}function iw(n,e,t,i,s){let[r,o]=[e.steps?.[i],e.steps?.[t]];if(!r||!o)return[];let{factor:a}=ex(n,e,t),l=i==="roll_angle"?180/Math.PI:1,c=r.map((f,h)=>h).filter(f=>typeof r[f]=="number");c.sort((f,h)=>Number(r[f])-Number(r[h]));let u=f=>typeof f=="number"?f/a:null;return[{run:en(e.id),colour:ao(s),x:c.map(f=>l*Number(r[f])),y:c.map(f=>u(o[f]))}]}function sw({title:n,unit:e,label:t,curves:i}){let s=Gt(null),r=dc(),o=JSON.stringify([n,e,t,i,r]);return At(()=>{let a=s.current;if(!a)return;let l=new Mn(aw(a,n,e,t,i),ow(i),a),c=new ResizeObserver(()=>{a.clientWidth>0&&l.setSize({width:a.clientWidth,height:j0})});return c.observe(a),()=>{c.disconnect(),l.destroy()}},[o]),x("figure",{class:"plot",children:[x("figcaption",{children:[n," ",e&&x("span",{class:"unit",children:e})]}),x("div",{ref:s,class:"canvas",role:"img","aria-label":rw(n,e,i)})]})}function rw(n,e,t){let i=t.map(({run:s,y:r})=>{let o=r.filter(a=>a!==null);return`${s} from ${ti(Math.min(...o))} to ${ti(Math.max(...o))}`});return`Plot of ${n}${e&&` in ${e}`}: ${i.join(", ")}`}function ow(n){return n.length===0?[[]]:Mn.join(n.map(({x:e,y:t})=>[e,t]))}function aw(n,e,t,i,s){let r=getComputedStyle(n),[o,a]=[r.color,r.borderTopColor],l="12px system-ui, sans-serif",u={values:(f,h)=>h.map(d=>String(Number(d.toPrecision(6)))),stroke:o,font:l,labelFont:l,grid:{stroke:a,width:1},ticks:{stroke:a,width:1,size:4}};return{width:Math.max(n.clientWidth,100),height:j0,cursor:{sync:{key:"positions"},points:{size:6}},legend:{live:!0},scales:{x:{time:!1}},axes:[{...u,label:i,labelSize:18,size:34},{...u,size:58}],series:[{label:i},...s.map(({run:f,colour:h},d)=>({label:s.length>1?f:e,stroke:h,width:1.6,dash:jM[d%2+2*(Math.floor(d/Sg)%2)],spanGaps:!0,points:{show:(s[0]?.x.length??0)<60,size:4,fill:h},value:(p,v)=>v===null?"–":`${ti(v)} ${t}`}))]}}function rf(n){let e=n.run;return[["Directory",n.directory],["Started",ug(n.started)],["Model",e?.model],["Hash of the source",e?.source?.sha256?.slice(0,16)],["Calyx",e?.calyx],["Fidelity",e?.fidelity],["Positions",ya(n)],...Object.entries(n.params??{}).filter(([,i])=>i.at_default!==!0).map(([i,s])=>[`Param: ${tn(i)}`,Hl(s)]),...Object.entries(n.settings??{}).map(([i,s])=>[`Set: ${Gl(i)}`,Wl(s)]),...Object.entries(e?.certificate??{}).map(([i,s])=>[`Residual: ${tn(i)}`,ti(s)])].filter(i=>!!i[1])}function tx({studio:n}){let e=n.settings.selected.flatMap(t=>n.results[t]??[]);return e.length===0?null:x("section",{class:"panel","aria-labelledby":"provenance-heading",children:[x("h2",{id:"provenance-heading",children:"Provenance"}),e.map(t=>x("details",{open:e.length===1,children:[x("summary",{children:en(t.id)}),x("dl",{class:"provenance",children:rf(t).map(([i,s])=>x("div",{children:[x("dt",{children:i}),x("dd",{children:s})]},i))}),x(lw,{results:t}),t.printed&&x("pre",{class:"plain",tabIndex:0,"aria-label":"Text that the model prints",children:t.printed}),x("p",{class:"links",children:[t.has_report&&x("a",{href:pi(t.id,"/files/report.html"),target:"_blank",rel:"noreferrer",children:"Report"}),t.steps&&x("a",{href:pi(t.id,"/files/steps.csv"),download:`${t.id}-steps.csv`,children:"steps.csv"}),t.run&&x("a",{href:pi(t.id,"/files/run.json"),download:`${t.id}.json`,children:"run.json"}),!n.withoutModel&&t.params&&x("button",{type:"button",class:"quiet",onClick:()=>n.useForm(t),children:"Use these params and settings"})]})]},t.id))]})}function lw({results:n}){let e=Object.entries(n.run?.ignored_inputs??{}),t=Object.entries(n.run?.refused_outputs??{});return e.length+t.length===0?null:x("ul",{class:"messages",children:[e.map(([i,s])=>x("li",{class:"warning",children:[x("code",{children:i})," is not used as given: ",s]},i)),t.map(([i,s])=>x("li",{class:"warning",children:[x("code",{children:i})," has no value: ",s]},i))]})}function ix({studio:n}){if(n.withoutModel)return null;let{check:e,model:t}=n,i=n.runs.filter(s=>s.status==="running");return x("section",{class:"panel","aria-labelledby":"run-heading",children:[x("h2",{id:"run-heading",children:"Run"}),x("div",{class:"plan-summary",children:x(uw,{studio:n})}),x("div",{class:"run-row",children:[x("button",{type:"button",class:"primary",disabled:!n.canRun,onClick:()=>{n.run()},children:"Run"}),x("label",{class:"switch",children:[x("input",{type:"checkbox",checked:n.settings.automatic,onChange:s=>n.setAutomatic(s.currentTarget.checked)}),"Run after changes if the predicted time is below 1 s"]})]}),x(cw,{studio:n}),e?.refused&&x("p",{class:"field-error",role:"alert",children:[x(oi,{text:e.refused.message}),x("span",{class:"help",children:x(oi,{text:e.refused.help})})]}),e&&!t?.broken&&e.rendered&&x("details",{open:!e.runnable,children:[x("summary",{children:e.runnable?"Warnings of the model":"Errors of the model with these params"}),x(Xl,{text:e.rendered,isError:!e.runnable})]}),i.map(s=>x(hw,{studio:n,run:s},s.id)),n.settings.selected.slice(0,1).map(s=>x(fw,{studio:n,id:s},s))]})}function cw({studio:n}){let{errors:e={},setting_errors:t={}}=n.check??{},i=r=>n.analysisSettings.find(o=>o.name===r)?.label??r,s=[...Object.keys(t).map(r=>({id:`setting-${r}`,label:i(r)})),...Object.keys(e).map(r=>({id:`param-${r}`,label:tn(r)}))];return s.length===0?null:x("p",{class:"fields-with-errors",children:[s.length===1?"One field has an error:":`${s.length} fields have errors:`,s.map(({id:r,label:o})=>x("button",{type:"button",class:"quiet",onClick:()=>document.getElementById(r)?.focus(),children:o},r))]})}function uw({studio:n}){let{check:e}=n,t=e?.plan;if(!t){let i=e?.runnable?"The model analyses nothing.":n.isChecking?"Checking …":"No plan: the model or its params have errors.";return x("p",{class:"muted","aria-busy":n.isChecking,children:i})}return x("div",{"aria-busy":n.isChecking,children:[x("dl",{class:"facts",children:[x("div",{children:[x("dt",{children:"Predicted time"}),x("dd",{"data-testid":"predicted-time",children:va(t.time)})]}),x("div",{children:[x("dt",{children:"Memory"}),x("dd",{children:yd(t.memory)})]}),x("div",{title:"Predicted size of the files of the 3-D view, and of the meshes with stresses if they are requested",children:[x("dt",{children:"Disk"}),x("dd",{"data-testid":"predicted-disk",children:yd(t.disk)})]}),x("div",{children:[x("dt",{children:"Fidelity"}),x("dd",{"data-testid":"fidelity",children:t.fidelity})]}),x("div",{children:[x("dt",{children:"Positions"}),x("dd",{children:t.positions})]})]}),x("details",{children:[x("summary",{children:"Plan and gear data"}),x("pre",{class:"plain",tabIndex:0,"aria-label":"Plan",children:`${t.cost}
${t.text}
${e.gear_data}`.trim()})]})]})}function hw({studio:n,run:e}){let t=n.progress[e.id]??e.progress;return x("div",{class:"progress-card",children:[x("div",{class:"progress-head",children:[x("span",{children:en(e.id)}),x("button",{type:"button",class:"quiet",disabled:!n.isConnected,onClick:()=>{n.cancel(e.id)},"aria-label":`Cancel ${en(e.id)}`,children:"Cancel"})]}),x(dw,{name:en(e.id),progress:t})]})}function dw({name:n,progress:e}){let t=e?.total??null,i=e?.seconds_left;return x(ot,{children:[x("progress",{"aria-label":`Progress of ${n}`,max:t??void 0,value:t===null?void 0:e?.done}),x("p",{class:"muted small-text",children:[e?.stage??"starting",t!==null&&` ${e?.done} of ${t}`,i!=null&&i>0&&`, ${va(i)} left`]})]})}function fw({studio:n,id:e}){let t=n.results[e];if(!t||t.status==="running")return null;let s=(t.messages??[]).filter(c=>c.severity!=="note"),r=t.run?.warnings??[],o=new Set(s.map(c=>c.message)),a=r.filter(c=>![...o].some(u=>c.includes(u))),l=[...s,...a.map(c=>({severity:"warning",code:null,message:c,help:null}))];return t.status==="finished"&&l.length===0?null:t.status==="cancelled"?x("div",{class:"ended",children:[x(nx,{studio:n,results:t}),x(_d,{messages:l.filter(c=>c.severity==="warning")})]}):x("div",{class:"ended",children:[x(nx,{studio:n,results:t,reason:s.length===0?t.message:null}),x(_d,{messages:l})]})}function nx({studio:n,results:e,reason:t}){let{id:i,status:s,incomplete:r,resumable:o}=e,a=en(i);return x("div",{class:"ended-early",children:[x("p",{children:[a,": ",s,r&&` after ${os(e)}`,t&&`, ${t}`]}),o&&x("button",{type:"button",disabled:!n.isConnected,"aria-label":`Continue ${a}`,title:"Solves the remaining positions with the params and settings of this run",onClick:()=>{n.continue(i)},children:"Continue"}),!o&&r&&s!=="elsewhere"&&(e.positions??0)>0&&x("p",{class:"muted small-text",children:["This studio did not start the run and does not know its options. To continue it, repeat its command with"," ",x("code",{children:"--resume"})," ","in a terminal."]})]})}var of=4;function sx({studio:n}){let e=[...n.runs].reverse(),t=rx(n.runs);return x("section",{class:"panel","aria-labelledby":"runs-heading",children:[x("h2",{id:"runs-heading",children:"Runs"}),e.length===0&&x("p",{class:"muted",children:"No runs yet."}),x("ul",{class:"runs",children:e.map(i=>x(pw,{studio:n,run:i,differing:t},i.id))}),e.length>1&&n.settings.selected.length<2&&x("p",{class:"muted small-text",children:"Check two or more runs to compare them."})]})}function pw({studio:n,run:e,differing:t}){let i=n.settings.selected.indexOf(e.id),s=en(e.id);return x("li",{class:i>=0?"selected":"","data-run":e.id,children:[x("input",{type:"checkbox","aria-label":`Compare ${s}`,checked:i>=0,style:i>=0?{accentColor:ao(i)}:void 0,onChange:()=>n.toggle(e.id)}),x("button",{type:"button",class:"run-name","aria-pressed":i>=0,title:e.directory,onClick:()=>n.select([e.id]),children:[x("span",{class:"run-title",children:[s,x("span",{class:`status ${e.status}`,children:mw(n,e)}),x("span",{class:"when",children:hg(e.started)})]}),x("span",{class:"differences",children:gw(e,t)})]})]})}function mw(n,e){if(e.status==="elsewhere")return"written by another process";let t=n.progress[e.id]?.seconds_left;return e.status==="running"&&t?`running, ${va(t)} left`:e.incomplete&&e.status!=="running"?`${e.status}, ${os(e)}`:e.status}function rx(n){return["params","settings"].flatMap(t=>{let i=n.filter(o=>o[t]!==null);return[...new Set(i.flatMap(o=>Object.keys(o[t]??{})))].filter(o=>new Set(i.map(a=>af(a,{kind:t,name:o}))).size>1).map(o=>({kind:t,name:o}))})}function af(n,{kind:e,name:t}){if(e==="settings"){let s=n.settings?.[t];return s===void 0?t==="vtu"?"no":"as in the model":Wl(s)}let i=n.params?.[t];return i?Vl(i.text,i.unit):"default"}function ox(n,e){let t=e.kind==="params"?n.params?.[e.name]:void 0;return t?Hl(t):af(n,e)}function ax({kind:n,name:e}){return n==="settings"?Gl(e):tn(e)}function gw(n,e){let t=n.params??{},i=[...Object.keys(t).filter(a=>t[a]?.at_default!==!0).map(a=>({kind:"params",name:a})),...Object.keys(n.settings??{}).map(a=>({kind:"settings",name:a}))],s=a=>e.some(({kind:l,name:c})=>l===a.kind&&c===a.name);i.sort((a,l)=>Number(s(l))-Number(s(a)));let r=i.slice(0,of).map(a=>`${ax(a)} ${ox(n,a)}`),o=i.length>of?[`${i.length-of} more`]:[];return[...r,...o].join(", ")||(n.params?"defaults":"")}function lx({studio:n}){let e=n.settings.selected.flatMap(i=>n.runs.filter(s=>s.id===i));if(e.length<2)return null;let t=rx(e);return x("section",{class:"panel","aria-labelledby":"differences-heading",children:[x("h2",{id:"differences-heading",children:"Different params and settings"}),t.length===0&&x("p",{class:"muted",children:"These runs have the same params and settings."}),t.length>0&&x("div",{class:"scroll inputs",tabIndex:0,role:"region","aria-label":"Table of different params and settings",children:x("table",{children:[x("thead",{children:x("tr",{children:[x("th",{scope:"col",children:"Param"}),e.map(i=>x("th",{scope:"col",children:en(i.id)},i.id))]})}),x("tbody",{children:t.map(i=>x("tr",{children:[x("th",{scope:"row",children:ax(i)}),e.map(s=>x("td",{title:af(s,i),children:ox(s,i)},s.id))]},`${i.kind}.${i.name}`))})]})})]})}var Dx=0,Uf=1,Fx=2;var Ka=1,Ux=2,Go=3,Fi=0,Xn=1,zn=2,Or=0,Wo=1,Of=2,kf=3,Bf=4,Ox=5;var kr=100,kx=101,Bx=102,zx=103,Vx=104,Hx=200,Gx=201,Wx=202,Xx=203,zf=204,Vf=205,$x=206,qx=207,Yx=208,Jx=209,Zx=210,Kx=211,jx=212,Qx=213,ev=214,Oc=0,kc=1,Bc=2,No=3,zc=4,Vc=5,Do=6,Hc=7,Hf=0,tv=1,nv=2,hs=0,Gf=1,Wf=2,Xf=3,$f=4,qf=5,Yf=6,Jf=7;var Zf=300,Br=301,Xo=302,fu=303,pu=304,Gc=1e3,cs=1001,Wc=1002,En=1003,iv=1004;var ja=1005;var Wn=1006,mu=1007;var Ns=1008;var Mi=1009,Kf=1010,jf=1011,$o=1012,gu=1013,Zi=1014,Ki=1015,ji=1016,xu=1017,vu=1018,zr=1020,Qf=35902,ep=35899,tp=1021,np=1022,wi=1023,Ps=1026,Ds=1027,ip=1028,yu=1029,hr=1030,_u=1031;var bu=1033,Qa=33776,el=33777,tl=33778,nl=33779,Su=35840,Mu=35841,wu=35842,Eu=35843,Tu=36196,Au=37492,Cu=37496,Ru=37488,Pu=37489,il=37490,Iu=37491,Lu=37808,Nu=37809,Du=37810,Fu=37811,Uu=37812,Ou=37813,ku=37814,Bu=37815,zu=37816,Vu=37817,Hu=37818,Gu=37819,Wu=37820,Xu=37821,$u=36492,qu=36494,Yu=36495,Ju=36283,Zu=36284,sl=36285,Ku=36286;var Da=2300,Xc=2301,Fc=2302,Pf=2303,If=2400,Lf=2401,Nf=2402;var sv=3200;var sp=0,rv=1,Fs="",ii="srgb",Fa="srgb-linear",Ua="linear",Pt="srgb";var Uc=7680,rl=7681;var rp=34055,op=34056;var ap=517;var ju=519,ov=512,av=513,lv=514,lp=515,cv=516,uv=517,cp=518,up=519,hv=35044,dr=35048;var hp="300 es",Ii=2e3,Oa=2001;function xw(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function vw(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ka(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function dv(){let n=ka("canvas");return n.style.display="block",n}var cx={},Fo=null;function dp(...n){let e="THREE."+n.shift();Fo?Fo("log",e,...n):console.log(e,...n)}function fv(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ye(...n){n=fv(n);let e="THREE."+n.shift();if(Fo)Fo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function Qe(...n){n=fv(n);let e="THREE."+n.shift();if(Fo)Fo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Na(...n){let e=n.join(" ");e in cx||(cx[e]=!0,Ye(...n))}function pv(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var mv={[Oc]:Oc,[Bc]:Do,[zc]:zc,[No]:Vc,[kc]:kc,[Do]:Bc,[Hc]:Hc,[Vc]:No},us=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},qn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var lf=Math.PI/180,$c=180/Math.PI;function ol(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(qn[n&255]+qn[n>>8&255]+qn[n>>16&255]+qn[n>>24&255]+"-"+qn[e&255]+qn[e>>8&255]+"-"+qn[e>>16&15|64]+qn[e>>24&255]+"-"+qn[t&63|128]+qn[t>>8&255]+"-"+qn[t>>16&255]+qn[t>>24&255]+qn[i&255]+qn[i>>8&255]+qn[i>>16&255]+qn[i>>24&255]).toLowerCase()}function vt(n,e,t){return Math.max(e,Math.min(t,n))}function yw(n,e){return(n%e+e)%e}function cf(n,e,t){return(1-t)*n+t*e}function gv(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function fp(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function _w(n,e){if(e.constructor===Float32Array)return n;let t=fp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function bw(n,e){if(e.constructor===Float32Array)return n;let t=fp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var yt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=vt(this.x,e.x,t.x),this.y=vt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=vt(this.x,e,t),this.y=vt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(vt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(vt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Li=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],h=r[o+0],d=r[o+1],p=r[o+2],v=r[o+3];if(f!==v||l!==h||c!==d||u!==p){let g=l*h+c*d+u*p+f*v;g<0&&(h=-h,d=-d,p=-p,v=-v,g=-g);let m=1-a;if(g<.9995){let y=Math.acos(g),M=Math.sin(y);m=Math.sin(m*y)/M,a=Math.sin(a*y)/M,l=l*m+h*a,c=c*m+d*a,u=u*m+p*a,f=f*m+v*a}else{l=l*m+h*a,c=c*m+d*a,u=u*m+p*a,f=f*m+v*a;let y=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=y,c*=y,u*=y,f*=y}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],h=r[o+1],d=r[o+2],p=r[o+3];return e[t]=a*p+u*f+l*d-c*h,e[t+1]=l*p+u*h+c*f-a*d,e[t+2]=c*p+u*d+a*h-l*f,e[t+3]=u*p-a*f-l*h-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),h=l(i/2),d=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"YXZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"ZXY":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"ZYX":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"YZX":this._x=h*u*f+c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f-h*d*p;break;case"XZY":this._x=h*u*f-c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f+h*d*p;break;default:Ye("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],f=t[10],h=i+a+f;if(h>0){let d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>f){let d=2*Math.sqrt(1+i-a-f);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>f){let d=2*Math.sqrt(1+a-i-f);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+f-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(vt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(ux.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(ux.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),f=2*(r*i-o*t);return this.x=t+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=vt(this.x,e.x,t.x),this.y=vt(this.y,e.y,t.y),this.z=vt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=vt(this.x,e,t),this.y=vt(this.y,e,t),this.z=vt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(vt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return uf.copy(this).projectOnVector(e),this.sub(uf)}reflect(e){return this.sub(uf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(vt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},uf=new G,ux=new Li,et=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],h=i[2],d=i[5],p=i[8],v=s[0],g=s[3],m=s[6],y=s[1],M=s[4],b=s[7],R=s[2],T=s[5],_=s[8];return r[0]=o*v+a*y+l*R,r[3]=o*g+a*M+l*T,r[6]=o*m+a*b+l*_,r[1]=c*v+u*y+f*R,r[4]=c*g+u*M+f*T,r[7]=c*m+u*b+f*_,r[2]=h*v+d*y+p*R,r[5]=h*g+d*M+p*T,r[8]=h*m+d*b+p*_,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=u*o-a*c,h=a*l-u*r,d=c*r-o*l,p=t*f+i*h+s*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/p;return e[0]=f*v,e[1]=(s*c-u*i)*v,e[2]=(a*i-s*o)*v,e[3]=h*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=d*v,e[7]=(i*l-c*t)*v,e[8]=(o*t-i*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Na("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(hf.makeScale(e,t)),this}rotate(e){return Na("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(hf.makeRotation(-e)),this}translate(e,t){return Na("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(hf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},hf=new et,hx=new et().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),dx=new et().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Sw(){let n={enabled:!0,workingColorSpace:Fa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=Rs(s.r),s.g=Rs(s.g),s.b=Rs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=Lo(s.r),s.g=Lo(s.g),s.b=Lo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Fs?Ua:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Fa]:{primaries:e,whitePoint:i,transfer:Ua,toXYZ:hx,fromXYZ:dx,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:ii},outputColorSpaceConfig:{drawingBufferColorSpace:ii}},[ii]:{primaries:e,whitePoint:i,transfer:Pt,toXYZ:hx,fromXYZ:dx,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:ii}}}),n}var xt=Sw();function Rs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Lo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var yo,qc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{yo===void 0&&(yo=ka("canvas")),yo.width=e.width,yo.height=e.height;let s=yo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=yo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=ka("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Rs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Rs(t[i]/255)*255):t[i]=Rs(t[i]);return{data:t,width:e.width,height:e.height}}else return Ye("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Mw=0,Uo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Mw++}),this.uuid=ol(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(df(s[o].image)):r.push(df(s[o]))}else r=df(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function df(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?qc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ye("Texture: Unable to serialize Texture."),{})}var ww=0,ff=new G,li=class n extends us{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=cs,s=cs,r=Wn,o=Ns,a=wi,l=Mi,c=n.DEFAULT_ANISOTROPY,u=Fs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:ww++}),this.uuid=ol(),this.name="",this.source=new Uo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new yt(0,0),this.repeat=new yt(1,1),this.center=new yt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new et,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ff).x}get height(){return this.source.getSize(ff).y}get depth(){return this.source.getSize(ff).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ye(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Zf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Gc:e.x=e.x-Math.floor(e.x);break;case cs:e.x=e.x<0?0:1;break;case Wc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Gc:e.y=e.y-Math.floor(e.y);break;case cs:e.y=e.y<0?0:1;break;case Wc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};li.DEFAULT_IMAGE=null;li.DEFAULT_MAPPING=Zf;li.DEFAULT_ANISOTROPY=1;var Zt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],f=l[8],h=l[1],d=l[5],p=l[9],v=l[2],g=l[6],m=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-v)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+v)<.1&&Math.abs(p+g)<.1&&Math.abs(c+d+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,b=(d+1)/2,R=(m+1)/2,T=(u+h)/4,_=(f+v)/4,E=(p+g)/4;return M>b&&M>R?M<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(M),s=T/i,r=_/i):b>R?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=T/s,r=E/s):R<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),i=_/r,s=E/r),this.set(i,s,r,t),this}let y=Math.sqrt((g-p)*(g-p)+(f-v)*(f-v)+(h-u)*(h-u));return Math.abs(y)<.001&&(y=1),this.x=(g-p)/y,this.y=(f-v)/y,this.z=(h-u)/y,this.w=Math.acos((c+d+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=vt(this.x,e.x,t.x),this.y=vt(this.y,e.y,t.y),this.z=vt(this.z,e.z,t.z),this.w=vt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=vt(this.x,e,t),this.y=vt(this.y,e,t),this.z=vt(this.z,e,t),this.w=vt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(vt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Yc=class extends us{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Wn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Zt(0,0,e,t),this.scissorTest=!1,this.viewport=new Zt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new li({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Wn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Uo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},_i=class extends Yc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Ba=class extends li{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=En,this.minFilter=En,this.wrapR=cs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Jc=class extends li{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=En,this.minFilter=En,this.wrapR=cs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var bt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,f,h,d,p,v,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,v,g)}set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,v,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=f,m[14]=h,m[3]=d,m[7]=p,m[11]=v,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/_o.setFromMatrixColumn(e,0).length(),r=1/_o.setFromMatrixColumn(e,1).length(),o=1/_o.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let h=o*u,d=o*f,p=a*u,v=a*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=d+p*c,t[5]=h-v*c,t[9]=-a*l,t[2]=v-h*c,t[6]=p+d*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,d=l*f,p=c*u,v=c*f;t[0]=h+v*a,t[4]=p*a-d,t[8]=o*c,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=d*a-p,t[6]=v+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,d=l*f,p=c*u,v=c*f;t[0]=h-v*a,t[4]=-o*f,t[8]=p+d*a,t[1]=d+p*a,t[5]=o*u,t[9]=v-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,d=o*f,p=a*u,v=a*f;t[0]=l*u,t[4]=p*c-d,t[8]=h*c+v,t[1]=l*f,t[5]=v*c+h,t[9]=d*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,d=o*c,p=a*l,v=a*c;t[0]=l*u,t[4]=v-h*f,t[8]=p*f+d,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*f+p,t[10]=h-v*f}else if(e.order==="XZY"){let h=o*l,d=o*c,p=a*l,v=a*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=h*f+v,t[5]=o*u,t[9]=d*f-p,t[2]=p*f-d,t[6]=a*u,t[10]=v*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Ew,e,Tw)}lookAt(e,t,i){let s=this.elements;return vi.subVectors(e,t),vi.lengthSq()===0&&(vi.z=1),vi.normalize(),Ks.crossVectors(i,vi),Ks.lengthSq()===0&&(Math.abs(i.z)===1?vi.x+=1e-4:vi.z+=1e-4,vi.normalize(),Ks.crossVectors(i,vi)),Ks.normalize(),fc.crossVectors(vi,Ks),s[0]=Ks.x,s[4]=fc.x,s[8]=vi.x,s[1]=Ks.y,s[5]=fc.y,s[9]=vi.y,s[2]=Ks.z,s[6]=fc.z,s[10]=vi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],h=i[9],d=i[13],p=i[2],v=i[6],g=i[10],m=i[14],y=i[3],M=i[7],b=i[11],R=i[15],T=s[0],_=s[4],E=s[8],U=s[12],N=s[1],L=s[5],B=s[9],z=s[13],D=s[2],W=s[6],q=s[10],H=s[14],le=s[3],Z=s[7],Q=s[11],ie=s[15];return r[0]=o*T+a*N+l*D+c*le,r[4]=o*_+a*L+l*W+c*Z,r[8]=o*E+a*B+l*q+c*Q,r[12]=o*U+a*z+l*H+c*ie,r[1]=u*T+f*N+h*D+d*le,r[5]=u*_+f*L+h*W+d*Z,r[9]=u*E+f*B+h*q+d*Q,r[13]=u*U+f*z+h*H+d*ie,r[2]=p*T+v*N+g*D+m*le,r[6]=p*_+v*L+g*W+m*Z,r[10]=p*E+v*B+g*q+m*Q,r[14]=p*U+v*z+g*H+m*ie,r[3]=y*T+M*N+b*D+R*le,r[7]=y*_+M*L+b*W+R*Z,r[11]=y*E+M*B+b*q+R*Q,r[15]=y*U+M*z+b*H+R*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],f=e[6],h=e[10],d=e[14],p=e[3],v=e[7],g=e[11],m=e[15],y=l*d-c*h,M=a*d-c*f,b=a*h-l*f,R=o*d-c*u,T=o*h-l*u,_=o*f-a*u;return t*(v*y-g*M+m*b)-i*(p*y-g*R+m*T)+s*(p*M-v*R+m*_)-r*(p*b-v*T+g*_)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=e[9],h=e[10],d=e[11],p=e[12],v=e[13],g=e[14],m=e[15],y=t*a-i*o,M=t*l-s*o,b=t*c-r*o,R=i*l-s*a,T=i*c-r*a,_=s*c-r*l,E=u*v-f*p,U=u*g-h*p,N=u*m-d*p,L=f*g-h*v,B=f*m-d*v,z=h*m-d*g,D=y*z-M*B+b*L+R*N-T*U+_*E;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/D;return e[0]=(a*z-l*B+c*L)*W,e[1]=(s*B-i*z-r*L)*W,e[2]=(v*_-g*T+m*R)*W,e[3]=(h*T-f*_-d*R)*W,e[4]=(l*N-o*z-c*U)*W,e[5]=(t*z-s*N+r*U)*W,e[6]=(g*b-p*_-m*M)*W,e[7]=(u*_-h*b+d*M)*W,e[8]=(o*B-a*N+c*E)*W,e[9]=(i*N-t*B-r*E)*W,e[10]=(p*T-v*b+m*y)*W,e[11]=(f*b-u*T-d*y)*W,e[12]=(a*U-o*L-l*E)*W,e[13]=(t*L-i*U+s*E)*W,e[14]=(v*M-p*R-g*y)*W,e[15]=(u*R-f*M+h*y)*W,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,f=a+a,h=r*c,d=r*u,p=r*f,v=o*u,g=o*f,m=a*f,y=l*c,M=l*u,b=l*f,R=i.x,T=i.y,_=i.z;return s[0]=(1-(v+m))*R,s[1]=(d+b)*R,s[2]=(p-M)*R,s[3]=0,s[4]=(d-b)*T,s[5]=(1-(h+m))*T,s[6]=(g+y)*T,s[7]=0,s[8]=(p+M)*_,s[9]=(g-y)*_,s[10]=(1-(h+v))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=_o.set(s[0],s[1],s[2]).length(),a=_o.set(s[4],s[5],s[6]).length(),l=_o.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Xi.copy(this);let c=1/o,u=1/a,f=1/l;return Xi.elements[0]*=c,Xi.elements[1]*=c,Xi.elements[2]*=c,Xi.elements[4]*=u,Xi.elements[5]*=u,Xi.elements[6]*=u,Xi.elements[8]*=f,Xi.elements[9]*=f,Xi.elements[10]*=f,t.setFromRotationMatrix(Xi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Ii,l=!1){let c=this.elements,u=2*r/(t-e),f=2*r/(i-s),h=(t+e)/(t-e),d=(i+s)/(i-s),p,v;if(l)p=r/(o-r),v=o*r/(o-r);else if(a===Ii)p=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===Oa)p=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ii,l=!1){let c=this.elements,u=2/(t-e),f=2/(i-s),h=-(t+e)/(t-e),d=-(i+s)/(i-s),p,v;if(l)p=1/(o-r),v=o/(o-r);else if(a===Ii)p=-2/(o-r),v=-(o+r)/(o-r);else if(a===Oa)p=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},_o=new G,Xi=new bt,Ew=new G(0,0,0),Tw=new G(1,1,1),Ks=new G,fc=new G,vi=new G,fx=new bt,px=new Li,ir=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(vt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-vt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(vt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-vt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(vt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-vt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Ye("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return fx.makeRotationFromQuaternion(e),this.setFromRotationMatrix(fx,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return px.setFromEuler(this),this.setFromQuaternion(px,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ir.DEFAULT_ORDER="XYZ";var za=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Aw=0,mx=new G,bo=new Li,ws=new bt,pc=new G,Ca=new G,Cw=new G,Rw=new Li,gx=new G(1,0,0),xx=new G(0,1,0),vx=new G(0,0,1),yx={type:"added"},Pw={type:"removed"},So={type:"childadded",child:null},pf={type:"childremoved",child:null},bi=class n extends us{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Aw++}),this.uuid=ol(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new G,t=new ir,i=new Li,s=new G(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new bt},normalMatrix:{value:new et}}),this.matrix=new bt,this.matrixWorld=new bt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new za,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return bo.setFromAxisAngle(e,t),this.quaternion.multiply(bo),this}rotateOnWorldAxis(e,t){return bo.setFromAxisAngle(e,t),this.quaternion.premultiply(bo),this}rotateX(e){return this.rotateOnAxis(gx,e)}rotateY(e){return this.rotateOnAxis(xx,e)}rotateZ(e){return this.rotateOnAxis(vx,e)}translateOnAxis(e,t){return mx.copy(e).applyQuaternion(this.quaternion),this.position.add(mx.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(gx,e)}translateY(e){return this.translateOnAxis(xx,e)}translateZ(e){return this.translateOnAxis(vx,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ws.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?pc.copy(e):pc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Ca.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ws.lookAt(Ca,pc,this.up):ws.lookAt(pc,Ca,this.up),this.quaternion.setFromRotationMatrix(ws),s&&(ws.extractRotation(s.matrixWorld),bo.setFromRotationMatrix(ws),this.quaternion.premultiply(bo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Qe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(yx),So.child=e,this.dispatchEvent(So),So.child=null):Qe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Pw),pf.child=e,this.dispatchEvent(pf),pf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ws.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ws.multiply(e.parent.matrixWorld)),e.applyMatrix4(ws),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(yx),So.child=e,this.dispatchEvent(So),So.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ca,e,Cw),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ca,Rw,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),f=o(e.shapes),h=o(e.skeletons),d=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),d.length>0&&(i.animations=d),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};bi.DEFAULT_UP=new G(0,1,0);bi.DEFAULT_MATRIX_AUTO_UPDATE=!0;bi.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var sn=class extends bi{constructor(){super(),this.isGroup=!0,this.type="Group"}},Iw={type:"move"},Oo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new sn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new sn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new sn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let g=t.getJointPose(v,i),m=this._getHandJoint(c,v);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),d=.02,p=.005;c.inputState.pinching&&h>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Iw)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new sn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},xv={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},js={h:0,s:0,l:0},mc={h:0,s:0,l:0};function mf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var rt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=ii){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,xt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=xt.workingColorSpace){return this.r=e,this.g=t,this.b=i,xt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=xt.workingColorSpace){if(e=yw(e,1),t=vt(t,0,1),i=vt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=mf(o,r,e+1/3),this.g=mf(o,r,e),this.b=mf(o,r,e-1/3)}return xt.colorSpaceToWorking(this,s),this}setStyle(e,t=ii){function i(r){r!==void 0&&parseFloat(r)<1&&Ye("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ye("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ye("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=ii){let i=xv[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ye("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Rs(e.r),this.g=Rs(e.g),this.b=Rs(e.b),this}copyLinearToSRGB(e){return this.r=Lo(e.r),this.g=Lo(e.g),this.b=Lo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ii){return xt.workingToColorSpace(Yn.copy(this),e),Math.round(vt(Yn.r*255,0,255))*65536+Math.round(vt(Yn.g*255,0,255))*256+Math.round(vt(Yn.b*255,0,255))}getHexString(e=ii){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=xt.workingColorSpace){xt.workingToColorSpace(Yn.copy(this),t);let i=Yn.r,s=Yn.g,r=Yn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=xt.workingColorSpace){return xt.workingToColorSpace(Yn.copy(this),t),e.r=Yn.r,e.g=Yn.g,e.b=Yn.b,e}getStyle(e=ii){xt.workingToColorSpace(Yn.copy(this),e);let t=Yn.r,i=Yn.g,s=Yn.b;return e!==ii?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(js),this.setHSL(js.h+e,js.s+t,js.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(js),e.getHSL(mc);let i=cf(js.h,mc.h,t),s=cf(js.s,mc.s,t),r=cf(js.l,mc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Yn=new rt;rt.NAMES=xv;var Va=class extends bi{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ir,this.environmentIntensity=1,this.environmentRotation=new ir,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},$i=new G,Es=new G,gf=new G,Ts=new G,Mo=new G,wo=new G,_x=new G,xf=new G,vf=new G,yf=new G,_f=new Zt,bf=new Zt,Sf=new Zt,nr=class n{constructor(e=new G,t=new G,i=new G){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),$i.subVectors(e,t),s.cross($i);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){$i.subVectors(s,t),Es.subVectors(i,t),gf.subVectors(e,t);let o=$i.dot($i),a=$i.dot(Es),l=$i.dot(gf),c=Es.dot(Es),u=Es.dot(gf),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,d=(c*l-a*u)*h,p=(o*u-a*l)*h;return r.set(1-d-p,p,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Ts)===null?!1:Ts.x>=0&&Ts.y>=0&&Ts.x+Ts.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Ts)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ts.x),l.addScaledVector(o,Ts.y),l.addScaledVector(a,Ts.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return _f.setScalar(0),bf.setScalar(0),Sf.setScalar(0),_f.fromBufferAttribute(e,t),bf.fromBufferAttribute(e,i),Sf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(_f,r.x),o.addScaledVector(bf,r.y),o.addScaledVector(Sf,r.z),o}static isFrontFacing(e,t,i,s){return $i.subVectors(i,t),Es.subVectors(e,t),$i.cross(Es).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return $i.subVectors(this.c,this.b),Es.subVectors(this.a,this.b),$i.cross(Es).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Mo.subVectors(s,i),wo.subVectors(r,i),xf.subVectors(e,i);let l=Mo.dot(xf),c=wo.dot(xf);if(l<=0&&c<=0)return t.copy(i);vf.subVectors(e,s);let u=Mo.dot(vf),f=wo.dot(vf);if(u>=0&&f<=u)return t.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Mo,o);yf.subVectors(e,r);let d=Mo.dot(yf),p=wo.dot(yf);if(p>=0&&d<=p)return t.copy(r);let v=d*c-l*p;if(v<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(wo,a);let g=u*p-d*f;if(g<=0&&f-u>=0&&d-p>=0)return _x.subVectors(r,s),a=(f-u)/(f-u+(d-p)),t.copy(s).addScaledVector(_x,a);let m=1/(g+v+h);return o=v*m,a=h*m,t.copy(i).addScaledVector(Mo,o).addScaledVector(wo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ci=class{constructor(e=new G(1/0,1/0,1/0),t=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(qi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(qi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=qi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,qi):qi.fromBufferAttribute(r,o),qi.applyMatrix4(e.matrixWorld),this.expandByPoint(qi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),gc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),gc.copy(i.boundingBox)),gc.applyMatrix4(e.matrixWorld),this.union(gc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,qi),qi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ra),xc.subVectors(this.max,Ra),Eo.subVectors(e.a,Ra),To.subVectors(e.b,Ra),Ao.subVectors(e.c,Ra),Qs.subVectors(To,Eo),er.subVectors(Ao,To),Rr.subVectors(Eo,Ao);let t=[0,-Qs.z,Qs.y,0,-er.z,er.y,0,-Rr.z,Rr.y,Qs.z,0,-Qs.x,er.z,0,-er.x,Rr.z,0,-Rr.x,-Qs.y,Qs.x,0,-er.y,er.x,0,-Rr.y,Rr.x,0];return!Mf(t,Eo,To,Ao,xc)||(t=[1,0,0,0,1,0,0,0,1],!Mf(t,Eo,To,Ao,xc))?!1:(vc.crossVectors(Qs,er),t=[vc.x,vc.y,vc.z],Mf(t,Eo,To,Ao,xc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,qi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(qi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(As[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),As[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),As[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),As[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),As[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),As[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),As[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),As[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(As),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},As=[new G,new G,new G,new G,new G,new G,new G,new G],qi=new G,gc=new ci,Eo=new G,To=new G,Ao=new G,Qs=new G,er=new G,Rr=new G,Ra=new G,xc=new G,vc=new G,Pr=new G;function Mf(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Pr.fromArray(n,r);let a=s.x*Math.abs(Pr.x)+s.y*Math.abs(Pr.y)+s.z*Math.abs(Pr.z),l=e.dot(Pr),c=t.dot(Pr),u=i.dot(Pr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var wn=new G,yc=new yt,Lw=0,pt=class extends us{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Lw++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=hv,this.updateRanges=[],this.gpuType=Ki,this.version=0,this._normalizationScale=e!==void 0?fp(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)yc.fromBufferAttribute(this,t),yc.applyMatrix3(e),this.setXY(t,yc.x,yc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.applyMatrix3(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.applyMatrix4(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.applyNormalMatrix(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.transformDirection(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):_w(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):bw(e,this.array)}};var Ha=class extends pt{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Ga=class extends pt{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var un=class extends pt{constructor(e,t,i){super(new Float32Array(e),t,i)}},Nw=new ci,Pa=new G,wf=new G,ri=class{constructor(e=new G,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):Nw.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Pa.subVectors(e,this.center);let t=Pa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Pa,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(wf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Pa.copy(e.center).add(wf)),this.expandByPoint(Pa.copy(e.center).sub(wf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Dw=0,Pi=new bt,Ef=new bi,Co=new G,yi=new ci,Ia=new ci,Bn=new G,hn=class n extends us{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Dw++}),this.uuid=ol(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(xw(e)?Ga:Ha)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new et().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Pi.makeRotationFromQuaternion(e),this.applyMatrix4(Pi),this}rotateX(e){return Pi.makeRotationX(e),this.applyMatrix4(Pi),this}rotateY(e){return Pi.makeRotationY(e),this.applyMatrix4(Pi),this}rotateZ(e){return Pi.makeRotationZ(e),this.applyMatrix4(Pi),this}translate(e,t,i){return Pi.makeTranslation(e,t,i),this.applyMatrix4(Pi),this}scale(e,t,i){return Pi.makeScale(e,t,i),this.applyMatrix4(Pi),this}lookAt(e){return Ef.lookAt(e),Ef.updateMatrix(),this.applyMatrix4(Ef.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Co).negate(),this.translate(Co.x,Co.y,Co.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new un(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ye("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ci);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];yi.setFromBufferAttribute(r),this.morphTargetsRelative?(Bn.addVectors(this.boundingBox.min,yi.min),this.boundingBox.expandByPoint(Bn),Bn.addVectors(this.boundingBox.max,yi.max),this.boundingBox.expandByPoint(Bn)):(this.boundingBox.expandByPoint(yi.min),this.boundingBox.expandByPoint(yi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ri);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(e){let i=this.boundingSphere.center;if(yi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Ia.setFromBufferAttribute(a),this.morphTargetsRelative?(Bn.addVectors(yi.min,Ia.min),yi.expandByPoint(Bn),Bn.addVectors(yi.max,Ia.max),yi.expandByPoint(Bn)):(yi.expandByPoint(Ia.min),yi.expandByPoint(Ia.max))}yi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Bn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Bn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Bn.fromBufferAttribute(a,c),l&&(Co.fromBufferAttribute(e,c),Bn.add(Co)),s=Math.max(s,i.distanceToSquared(Bn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Qe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new pt(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new G,l[U]=new G;let u=new G,f=new G,h=new G,d=new yt,p=new yt,v=new yt,g=new G,m=new G;function y(U,N,L){c[U]=c[N]=c[L]=1,u.fromBufferAttribute(i,U),f.fromBufferAttribute(i,N),h.fromBufferAttribute(i,L),d.fromBufferAttribute(r,U),p.fromBufferAttribute(r,N),v.fromBufferAttribute(r,L),f.sub(u),h.sub(u),p.sub(d),v.sub(d);let B=1/(p.x*v.y-v.x*p.y);isFinite(B)&&(g.copy(f).multiplyScalar(v.y).addScaledVector(h,-p.y).multiplyScalar(B),m.copy(h).multiplyScalar(p.x).addScaledVector(f,-v.x).multiplyScalar(B),a[U].add(g),a[N].add(g),a[L].add(g),l[U].add(m),l[N].add(m),l[L].add(m))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let U=0,N=M.length;U<N;++U){let L=M[U],B=L.start,z=L.count;for(let D=B,W=B+z;D<W;D+=3)y(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let b=new G,R=new G,T=new G,_=new G;function E(U){T.fromBufferAttribute(s,U),_.copy(T);let N=a[U];b.copy(N),b.sub(T.multiplyScalar(T.dot(N))).normalize(),R.crossVectors(_,N);let B=R.dot(l[U])<0?-1:1;o.setXYZW(U,b.x,b.y,b.z,B)}for(let U=0,N=i.count;U<N;++U)c[U]&&E(U);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new pt(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,d=i.count;h<d;h++)i.setXYZ(h,0,0,0);let s=new G,r=new G,o=new G,a=new G,l=new G,c=new G,u=new G,f=new G;if(e)for(let h=0,d=e.count;h<d;h+=3){let p=e.getX(h+0),v=e.getX(h+1),g=e.getX(h+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,g),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let h=0,d=t.count;h<d;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Bn.fromBufferAttribute(e,t),Bn.normalize(),e.setXYZ(t,Bn.x,Bn.y,Bn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,f=a.normalized,h=new c.constructor(l.length*u),d=0,p=0;for(let v=0,g=l.length;v<g;v++){a.isInterleavedBufferAttribute?d=l[v]*a.data.stride+a.offset:d=l[v]*u;for(let m=0;m<u;m++)h[p++]=c[d++]}return new pt(h,u,f)}if(this.index===null)return Ye("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let h=c[u],d=e(h,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let d=c[f];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,d=f.length;h<d;h++)u.push(f[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Tf=new G,Fw=new G,Uw=new et,Yi=class{constructor(e=new G(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Tf.subVectors(i,t).cross(Fw.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Tf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||Uw.getNormalMatrix(e),s=this.coplanarPoint(Tf).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Ow=0,sr=class extends us{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Ow++}),this.uuid=ol(),this.name="",this.type="Material",this.blending=Wo,this.side=Fi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=zf,this.blendDst=Vf,this.blendEquation=kr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new rt(0,0,0),this.blendAlpha=0,this.depthFunc=No,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=ju,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Uc,this.stencilZFail=Uc,this.stencilZPass=Uc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ye(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new rt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Yi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new yt().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new yt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Cs=new G,Af=new G,_c=new G,bc=new G,Ni=class{constructor(e=new G,t=new G(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Cs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Cs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Cs.copy(this.origin).addScaledVector(this.direction,t),Cs.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Af.copy(e).add(t).multiplyScalar(.5),_c.copy(t).sub(e).normalize(),bc.copy(this.origin).sub(Af);let r=e.distanceTo(t)*.5,o=-this.direction.dot(_c),a=bc.dot(this.direction),l=-bc.dot(_c),c=bc.lengthSq(),u=Math.abs(1-o*o),f,h,d,p;if(u>0)if(f=o*l-a,h=o*a-l,p=r*u,f>=0)if(h>=-p)if(h<=p){let v=1/u;f*=v,h*=v,d=f*(f+o*h+2*a)+h*(o*f+h+2*l)+c}else h=r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h<=-p?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c):h<=p?(f=0,h=Math.min(Math.max(-r,-l),r),d=h*(h+2*l)+c):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Af).addScaledVector(_c,h),d}intersectSphere(e,t){if(e.radius<0)return null;Cs.subVectors(e.center,this.origin);let i=Cs.dot(this.direction),s=Cs.dot(Cs)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-h.z)*f,l=(e.max.z-h.z)*f):(a=(e.max.z-h.z)*f,l=(e.min.z-h.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Cs)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=e.x-o.x,h=e.y-o.y,d=e.z-o.z,p=t.x-o.x,v=t.y-o.y,g=t.z-o.z,m=i.x-o.x,y=i.y-o.y,M=i.z-o.z,b=Math.abs(l),R=Math.abs(c),T=Math.abs(u),_,E,U,N,L,B,z,D,W,q,H,le;if(b>=R&&b>=T?(U=l,B=f,W=p,le=m,l>=0?(_=c,E=u,N=h,L=d,z=v,D=g,q=y,H=M):(_=u,E=c,N=d,L=h,z=g,D=v,q=M,H=y)):R>=T?(U=c,B=h,W=v,le=y,c>=0?(_=u,E=l,N=d,L=f,z=g,D=p,q=M,H=m):(_=l,E=u,N=f,L=d,z=p,D=g,q=m,H=M)):(U=u,B=d,W=g,le=M,u>=0?(_=l,E=c,N=f,L=h,z=p,D=v,q=m,H=y):(_=c,E=l,N=h,L=f,z=v,D=p,q=y,H=m)),U===0)return null;let Z=_/U,Q=E/U,ie=1/U,de=N-Z*B,he=L-Q*B,ee=z-Z*W,me=D-Q*W,ge=q-Z*le,Me=H-Q*le,ve=ge*me-Me*ee,Ve=de*Me-he*ge,Xe=ee*he-me*de;if(s){if(ve<0||Ve<0||Xe<0)return null}else if((ve<0||Ve<0||Xe<0)&&(ve>0||Ve>0||Xe>0))return null;let De=ve+Ve+Xe;if(De===0)return null;let ut=ie*(ve*B+Ve*W+Xe*le);return(De>0?ut<0:ut>0)?null:this.at(ut/De,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},rr=class extends sr{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new rt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ir,this.combine=Hf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},bx=new bt,Ir=new Ni,Sc=new ri,Sx=new G,Mc=new G,wc=new G,Ec=new G,Cf=new G,Tc=new G,Mx=new G,Ac=new G,wt=class extends bi{constructor(e=new hn,t=new rr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Tc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(Cf.fromBufferAttribute(f,e),o?Tc.addScaledVector(Cf,u):Tc.addScaledVector(Cf.sub(t),u))}t.add(Tc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Sc.copy(i.boundingSphere),Sc.applyMatrix4(r),Ir.copy(e.ray).recast(e.near),!(Sc.containsPoint(Ir.origin)===!1&&(Ir.intersectSphere(Sc,Sx)===null||Ir.origin.distanceToSquared(Sx)>(e.far-e.near)**2))&&(bx.copy(r).invert(),Ir.copy(e.ray).applyMatrix4(bx),!(i.boundingBox!==null&&Ir.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Ir)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,v=h.length;p<v;p++){let g=h[p],m=o[g.materialIndex],y=Math.max(g.start,d.start),M=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let b=y,R=M;b<R;b+=3){let T=a.getX(b),_=a.getX(b+1),E=a.getX(b+2);s=Cc(this,m,e,i,c,u,f,T,_,E),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),v=Math.min(a.count,d.start+d.count);for(let g=p,m=v;g<m;g+=3){let y=a.getX(g),M=a.getX(g+1),b=a.getX(g+2);s=Cc(this,o,e,i,c,u,f,y,M,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,v=h.length;p<v;p++){let g=h[p],m=o[g.materialIndex],y=Math.max(g.start,d.start),M=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let b=y,R=M;b<R;b+=3){let T=b,_=b+1,E=b+2;s=Cc(this,m,e,i,c,u,f,T,_,E),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),v=Math.min(l.count,d.start+d.count);for(let g=p,m=v;g<m;g+=3){let y=g,M=g+1,b=g+2;s=Cc(this,o,e,i,c,u,f,y,M,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function kw(n,e,t,i,s,r,o,a){let l;if(e.side===Xn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Fi,a),l===null)return null;Ac.copy(a),Ac.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Ac);return c<t.near||c>t.far?null:{distance:c,point:Ac.clone(),object:n}}function Cc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Mc),n.getVertexPosition(l,wc),n.getVertexPosition(c,Ec);let u=kw(n,e,t,i,Mc,wc,Ec,Mx);if(u){let f=new G;nr.getBarycoord(Mx,Mc,wc,Ec,f),s&&(u.uv=nr.getInterpolatedAttribute(s,a,l,c,f,new yt)),r&&(u.uv1=nr.getInterpolatedAttribute(r,a,l,c,f,new yt)),o&&(u.normal=nr.getInterpolatedAttribute(o,a,l,c,f,new G),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new G,materialIndex:0};nr.getNormal(Mc,wc,Ec,h.normal),u.face=h,u.barycoord=f}return u}var ko=class extends li{constructor(e=null,t=1,i=1,s,r,o,a,l,c=En,u=En,f,h){super(null,o,a,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Nr=class extends pt{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var Lr=new ri,Bw=new yt(.5,.5),Rc=new G,Is=class{constructor(e=new Yi,t=new Yi,i=new Yi,s=new Yi,r=new Yi,o=new Yi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ii,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],d=r[7],p=r[8],v=r[9],g=r[10],m=r[11],y=r[12],M=r[13],b=r[14],R=r[15];if(s[0].setComponents(c-o,d-u,m-p,R-y).normalize(),s[1].setComponents(c+o,d+u,m+p,R+y).normalize(),s[2].setComponents(c+a,d+f,m+v,R+M).normalize(),s[3].setComponents(c-a,d-f,m-v,R-M).normalize(),i)s[4].setComponents(l,h,g,b).normalize(),s[5].setComponents(c-l,d-h,m-g,R-b).normalize();else if(s[4].setComponents(c-l,d-h,m-g,R-b).normalize(),t===Ii)s[5].setComponents(c+l,d+h,m+g,R+b).normalize();else if(t===Oa)s[5].setComponents(l,h,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Lr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Lr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Lr)}intersectsSprite(e){Lr.center.set(0,0,0);let t=Bw.distanceTo(e.center);return Lr.radius=.7071067811865476+t,Lr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Lr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Rc.x=s.normal.x>0?e.max.x:e.min.x,Rc.y=s.normal.y>0?e.max.y:e.min.y,Rc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Rc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},wx=new bt,Zc=class n{constructor(){this.coordinateSystem=Ii,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];wx.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Is),i[s].setFromProjectionMatrix(wx,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Is),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var or=class extends sr{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new rt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Kc=new G,jc=new G,Ex=new bt,La=new Ni,Pc=new ri,Rf=new G,Tx=new G,Wa=class extends bi{constructor(e=new hn,t=new or){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Kc.fromBufferAttribute(t,s-1),jc.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Kc.distanceTo(jc);e.setAttribute("lineDistance",new un(i,1))}else Ye("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Pc.copy(i.boundingSphere),Pc.applyMatrix4(s),Pc.radius+=r,e.ray.intersectsSphere(Pc)===!1)return;Ex.copy(s).invert(),La.copy(e.ray).applyMatrix4(Ex);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let v=d,g=p-1;v<g;v+=c){let m=u.getX(v),y=u.getX(v+1),M=Ic(this,e,La,l,m,y,v);M&&t.push(M)}if(this.isLineLoop){let v=u.getX(p-1),g=u.getX(d),m=Ic(this,e,La,l,v,g,p-1);m&&t.push(m)}}else{let d=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let v=d,g=p-1;v<g;v+=c){let m=Ic(this,e,La,l,v,v+1,v);m&&t.push(m)}if(this.isLineLoop){let v=Ic(this,e,La,l,p-1,d,p-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Ic(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Kc.fromBufferAttribute(a,s),jc.fromBufferAttribute(a,r),t.distanceSqToSegment(Kc,jc,Rf,Tx)>i)return;Rf.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Rf);if(!(c<e.near||c>e.far))return{distance:c,point:Tx.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Ax=new G,Cx=new G,Ji=class extends Wa{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)Ax.fromBufferAttribute(t,s),Cx.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Ax.distanceTo(Cx);e.setAttribute("lineDistance",new un(i,1))}else Ye("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},Dr=class extends Wa{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}};var Xa=class extends li{constructor(e=[],t=Br,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ls=class extends li{constructor(e,t,i=Zi,s,r,o,a=En,l=En,c,u=Ps,f=1){if(u!==Ps&&u!==Ds)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:f};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Uo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},$a=class extends Ls{constructor(e,t=Zi,i=Br,s,r,o=En,a=En,l,c=Ps){let u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},qa=class extends li{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Bo=class n extends hn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],h=0,d=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new un(c,3)),this.setAttribute("normal",new un(u,3)),this.setAttribute("uv",new un(f,2));function p(v,g,m,y,M,b,R,T,_,E,U){let N=b/_,L=R/E,B=b/2,z=R/2,D=T/2,W=_+1,q=E+1,H=0,le=0,Z=new G;for(let Q=0;Q<q;Q++){let ie=Q*L-z;for(let de=0;de<W;de++){let he=de*N-B;Z[v]=he*y,Z[g]=ie*M,Z[m]=D,c.push(Z.x,Z.y,Z.z),Z[v]=0,Z[g]=0,Z[m]=T>0?1:-1,u.push(Z.x,Z.y,Z.z),f.push(de/_),f.push(1-Q/E),H+=1}}for(let Q=0;Q<E;Q++)for(let ie=0;ie<_;ie++){let de=h+ie+W*Q,he=h+ie+W*(Q+1),ee=h+(ie+1)+W*(Q+1),me=h+(ie+1)+W*Q;l.push(de,he,me),l.push(he,ee,me),le+=6}a.addGroup(d,le,U),d+=le,h+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var zo=class n extends hn{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],f=[],h=[],d=[],p=0,v=[],g=i/2,m=0;y(),o===!1&&(e>0&&M(!0),t>0&&M(!1)),this.setIndex(u),this.setAttribute("position",new un(f,3)),this.setAttribute("normal",new un(h,3)),this.setAttribute("uv",new un(d,2));function y(){let b=new G,R=new G,T=0,_=(t-e)/i;for(let E=0;E<=r;E++){let U=[],N=E/r,L=N*(t-e)+e;for(let B=0;B<=s;B++){let z=B/s,D=z*l+a,W=Math.sin(D),q=Math.cos(D);R.x=L*W,R.y=-N*i+g,R.z=L*q,f.push(R.x,R.y,R.z),b.set(W,_,q).normalize(),h.push(b.x,b.y,b.z),d.push(z,1-N),U.push(p++)}v.push(U)}for(let E=0;E<s;E++)for(let U=0;U<r;U++){let N=v[U][E],L=v[U+1][E],B=v[U+1][E+1],z=v[U][E+1];(e>0||U!==0)&&(u.push(N,L,z),T+=3),(t>0||U!==r-1)&&(u.push(L,B,z),T+=3)}c.addGroup(m,T,0),m+=T}function M(b){let R=p,T=new yt,_=new G,E=0,U=b===!0?e:t,N=b===!0?1:-1;for(let B=1;B<=s;B++)f.push(0,g*N,0),h.push(0,N,0),d.push(.5,.5),p++;let L=p;for(let B=0;B<=s;B++){let D=B/s*l+a,W=Math.cos(D),q=Math.sin(D);_.x=U*q,_.y=g*N,_.z=U*W,f.push(_.x,_.y,_.z),h.push(0,N,0),T.x=W*.5+.5,T.y=q*.5*N+.5,d.push(T.x,T.y),p++}for(let B=0;B<s;B++){let z=R+B,D=L+B;b===!0?u.push(D,D+1,z):u.push(D+1,D,z),E+=3}c.addGroup(m,E,b===!0?1:2),m+=E}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Fr=class n extends zo{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Ur=class n extends hn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=e/a,h=t/l,d=[],p=[],v=[],g=[];for(let m=0;m<u;m++){let y=m*h-o;for(let M=0;M<c;M++){let b=M*f-r;p.push(b,-y,0),v.push(0,0,1),g.push(M/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let y=0;y<a;y++){let M=y+c*m,b=y+c*(m+1),R=y+1+c*(m+1),T=y+1+c*m;d.push(M,b,T),d.push(b,R,T)}this.setIndex(d),this.setAttribute("position",new un(p,3)),this.setAttribute("normal",new un(v,3)),this.setAttribute("uv",new un(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Ya=class n extends hn{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],f=new G,h=new G,d=[],p=[],v=[],g=[];for(let m=0;m<=i;m++){let y=[],M=m/i,b=o+M*a,R=e*Math.cos(b),T=Math.sqrt(e*e-R*R),_=0;m===0&&o===0?_=.5/t:m===i&&l===Math.PI&&(_=-.5/t);for(let E=0;E<=t;E++){let U=E/t,N=s+U*r;f.x=-T*Math.cos(N),f.y=R,f.z=T*Math.sin(N),p.push(f.x,f.y,f.z),h.copy(f).normalize(),v.push(h.x,h.y,h.z),g.push(U+_,1-M),y.push(c++)}u.push(y)}for(let m=0;m<i;m++)for(let y=0;y<t;y++){let M=u[m][y+1],b=u[m][y],R=u[m+1][y],T=u[m+1][y+1];(m!==0||o>0)&&d.push(M,b,T),(m!==i-1||l<Math.PI)&&d.push(b,R,T)}this.setIndex(d),this.setAttribute("position",new un(p,3)),this.setAttribute("normal",new un(v,3)),this.setAttribute("uv",new un(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Vr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(Rx(s))s.isRenderTargetTexture?(Ye("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(Rx(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Jn(n){let e={};for(let t=0;t<n.length;t++){let i=Vr(n[t]);for(let s in i)e[s]=i[s]}return e}function Rx(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function zw(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function pp(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:xt.workingColorSpace}var vv={clone:Vr,merge:Jn},Vw=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Hw=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Di=class extends sr{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Vw,this.fragmentShader=Hw,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Vr(e.uniforms),this.uniformsGroups=zw(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new rt().setHex(s.value);break;case"v2":this.uniforms[i].value=new yt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new G().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Zt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new et().fromArray(s.value);break;case"m4":this.uniforms[i].value=new bt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Qc=class extends Di{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var eu=class extends sr{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=sv,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},tu=class extends sr{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ro(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Lc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var ar=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},nu=class extends ar{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:If,endingEnd:If}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Lf:r=e,a=2*t-i;break;case Nf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Lf:o=e,l=2*i-t;break;case Nf:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,d=this._weightNext,p=(i-t)/(s-t),v=p*p,g=v*p,m=-h*g+2*h*v-h*p,y=(1+h)*g+(-1.5-2*h)*v+(-.5+h)*p+1,M=(-1-d)*g+(1.5+d)*v+.5*p,b=d*g-d*v;for(let R=0;R!==a;++R)r[R]=m*o[u+R]+y*o[c+R]+M*o[l+R]+b*o[f+R];return r}},iu=class extends ar{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),f=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*f+o[l+h]*u;return r}},su=class extends ar{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},ru=class extends ar{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let p=(i-t)/(s-t),v=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*v+o[l+g]*p;return r}let h=a*2,d=e-1;for(let p=0;p!==a;++p){let v=o[c+p],g=o[l+p],m=d*h+p*2,y=f[m],M=f[m+1],b=e*h+p*2,R=u[b],T=u[b+1],_=Ww(i,t,y,R,s);r[p]=yv(_,v,M,T,g)}return r}};function yv(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function Gw(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function Ww(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=yv(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=Gw(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Si=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ro(t,this.TimeBufferType),this.values=Ro(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Ro(e.times,Array),values:Ro(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Lc(e.settings)&&(i.settings={inTangents:Ro(e.settings.inTangents,Array),outTangents:Ro(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new su(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new iu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new nu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new ru(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Da:t=this.InterpolantFactoryMethodDiscrete;break;case Xc:t=this.InterpolantFactoryMethodLinear;break;case Fc:t=this.InterpolantFactoryMethodSmooth;break;case Pf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ye("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Da;case this.InterpolantFactoryMethodLinear:return Xc;case this.InterpolantFactoryMethodSmooth:return Fc;case this.InterpolantFactoryMethodBezier:return Pf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Lc(this.settings)&&(Px(this.settings.inTangents,e),Px(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Lc(this.settings)&&(Ix(this.settings.inTangents,e),Ix(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Qe("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Qe("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Qe("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Qe("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&vw(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Qe("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Fc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let f=a*i,h=f-i,d=f+i;for(let p=0;p!==i;++p){let v=t[f+p];if(v!==t[h+p]||v!==t[d+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*i,h=o*i;for(let d=0;d!==i;++d)t[h+d]=t[f+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Lc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Px(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function Ix(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Si.prototype.ValueTypeName="";Si.prototype.TimeBufferType=Float32Array;Si.prototype.ValueBufferType=Float32Array;Si.prototype.DefaultInterpolation=Xc;var lr=class extends Si{constructor(e,t,i){super(e,t,i)}};lr.prototype.ValueTypeName="bool";lr.prototype.ValueBufferType=Array;lr.prototype.DefaultInterpolation=Da;lr.prototype.InterpolantFactoryMethodLinear=void 0;lr.prototype.InterpolantFactoryMethodSmooth=void 0;var ou=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}};ou.prototype.ValueTypeName="color";var au=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}};au.prototype.ValueTypeName="number";var lu=class extends ar{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Li.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ja=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new lu(this.times,this.values,this.getValueSize(),e)}};Ja.prototype.ValueTypeName="quaternion";Ja.prototype.InterpolantFactoryMethodSmooth=void 0;var cr=class extends Si{constructor(e,t,i){super(e,t,i)}};cr.prototype.ValueTypeName="string";cr.prototype.ValueBufferType=Array;cr.prototype.DefaultInterpolation=Da;cr.prototype.InterpolantFactoryMethodLinear=void 0;cr.prototype.InterpolantFactoryMethodSmooth=void 0;var cu=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}};cu.prototype.ValueTypeName="vector";var uu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let d=c[f],p=c[f+1];if(d.global&&(d.lastIndex=0),d.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},_v=new uu,hu=class{constructor(e){this.manager=e!==void 0?e:_v,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};hu.DEFAULT_MATERIAL_NAME="__DEFAULT";var Nc=new G,Dc=new Li,ls=new G,Za=class extends bi{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new bt,this.projectionMatrix=new bt,this.projectionMatrixInverse=new bt,this.coordinateSystem=Ii,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Nc,Dc,ls),ls.x===1&&ls.y===1&&ls.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Nc,Dc,ls.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Nc,Dc,ls),ls.x===1&&ls.y===1&&ls.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Nc,Dc,ls.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},tr=new G,Lx=new yt,Nx=new yt,si=class extends Za{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=$c*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(lf*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return $c*2*Math.atan(Math.tan(lf*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){tr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(tr.x,tr.y).multiplyScalar(-e/tr.z),tr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(tr.x,tr.y).multiplyScalar(-e/tr.z)}getViewSize(e,t){return this.getViewBounds(e,Lx,Nx),t.subVectors(Nx,Lx)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(lf*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Vo=class extends Za{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var ur=class extends hn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Po=-90,Io=1,Ho=class extends bi{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new si(Po,Io,e,t);s.layers=this.layers,this.add(s);let r=new si(Po,Io,e,t);r.layers=this.layers,this.add(r);let o=new si(Po,Io,e,t);o.layers=this.layers,this.add(o);let a=new si(Po,Io,e,t);a.layers=this.layers,this.add(a);let l=new si(Po,Io,e,t);l.layers=this.layers,this.add(l);let c=new si(Po,Io,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ii)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Oa)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let v=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=v,e.setRenderTarget(i,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,h,d),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},du=class extends si{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var mp="\\[\\]\\.:\\/",Xw=new RegExp("["+mp+"]","g"),gp="[^"+mp+"]",$w="[^"+mp.replace("\\.","")+"]",qw=/((?:WC+[\/:])*)/.source.replace("WC",gp),Yw=/(WCOD+)?/.source.replace("WCOD",$w),Jw=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",gp),Zw=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",gp),Kw=new RegExp("^"+qw+Yw+Jw+Zw+"$"),jw=["material","materials","bones","map"],Df=class{constructor(e,t,i){let s=i||Jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Jt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Xw,"")}static parseTrackName(e){let t=Kw.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);jw.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ye("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Qe("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Qe("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Qe("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){Qe("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){Qe("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Qe("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Jt.Composite=Df;Jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Jt.prototype.GetterByBindingType=[Jt.prototype._getValue_direct,Jt.prototype._getValue_array,Jt.prototype._getValue_arrayElement,Jt.prototype._getValue_toArray];Jt.prototype.SetterByBindingTypeAndVersioning=[[Jt.prototype._setValue_direct,Jt.prototype._setValue_direct_setNeedsUpdate,Jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_array,Jt.prototype._setValue_array_setNeedsUpdate,Jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_arrayElement,Jt.prototype._setValue_arrayElement_setNeedsUpdate,Jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_fromArray,Jt.prototype._setValue_fromArray_setNeedsUpdate,Jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var z3=new Float32Array(1);var Ff=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};function xp(n,e,t,i){let s=Qw(i);switch(t){case tp:return n*e;case ip:return n*e/s.components*s.byteLength;case yu:return n*e/s.components*s.byteLength;case hr:return n*e*2/s.components*s.byteLength;case _u:return n*e*2/s.components*s.byteLength;case np:return n*e*3/s.components*s.byteLength;case wi:return n*e*4/s.components*s.byteLength;case bu:return n*e*4/s.components*s.byteLength;case Qa:case el:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case tl:case nl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Mu:case Eu:return Math.max(n,16)*Math.max(e,8)/4;case Su:case wu:return Math.max(n,8)*Math.max(e,8)/2;case Tu:case Au:case Ru:case Pu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Cu:case il:case Iu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Lu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Nu:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Du:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Fu:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Uu:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Ou:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case ku:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Bu:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case zu:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Vu:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Hu:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Gu:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Wu:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Xu:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case $u:case qu:case Yu:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Ju:case Zu:return Math.ceil(n/4)*Math.ceil(e/4)*8;case sl:case Ku:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Qw(n){switch(n){case Mi:case Kf:return{byteLength:1,components:1};case $o:case jf:case ji:return{byteLength:2,components:1};case xu:case vu:return{byteLength:2,components:4};case Zi:case gu:case Ki:return{byteLength:4,components:1};case Qf:case ep:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ye("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Hv(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function t1(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,f=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((d,p)=>d.start-p.start);let h=0;for(let d=1;d<f.length;d++){let p=f[h],v=f[d];v.start<=p.start+p.count+1?p.count=Math.max(p.count,v.start+v.count-p.start):(++h,f[h]=v)}f.length=h+1;for(let d=0,p=f.length;d<p;d++){let v=f[d];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var n1=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,i1=`#ifdef USE_ALPHAHASH
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
#endif`,s1=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,r1=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,o1=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,a1=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,l1=`#ifdef USE_AOMAP
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
#endif`,c1=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,u1=`#ifdef USE_BATCHING
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
#endif`,h1=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,d1=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,f1=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,p1=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,m1=`#ifdef USE_IRIDESCENCE
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
#endif`,g1=`#ifdef USE_BUMPMAP
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
#endif`,x1=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,v1=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,y1=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,_1=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,b1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,S1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,M1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,w1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,E1=`#define PI 3.141592653589793
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
} // validated`,T1=`vec3 transformedNormal = objectNormal;
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
#endif`,A1=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,C1=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,R1=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,P1=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,I1="gl_FragColor = linearToOutputTexel( gl_FragColor );",L1=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,N1=`#ifdef USE_ENVMAP
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
#endif`,D1=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,F1=`#ifdef USE_ENVMAP
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
#endif`,U1=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,O1=`#ifdef USE_ENVMAP
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
#endif`,k1=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,B1=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,z1=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,V1=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,H1=`#ifdef USE_GRADIENTMAP
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
}`,G1=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,W1=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,X1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,$1=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,q1=`#ifdef USE_ENVMAP
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
#endif`,Y1=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,J1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Z1=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,K1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,j1=`PhysicalMaterial material;
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
#endif`,Q1=`uniform sampler2D dfgLUT;
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
}`,eE=`
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
#endif`,tE=`#if defined( RE_IndirectDiffuse )
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
#endif`,nE=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,iE=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,sE=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,rE=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,oE=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,aE=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,lE=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,cE=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,uE=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,hE=`#if defined( USE_POINTS_UV )
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
#endif`,dE=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,fE=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,pE=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,mE=`#if defined( USE_MORPHCOLORS )
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
#endif`,gE=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,xE=`#ifdef USE_MORPHTARGETS
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
#endif`,vE=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,yE=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,_E=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,bE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,SE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ME=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,wE=`#ifdef USE_NORMALMAP
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
#endif`,EE=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,TE=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,AE=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,CE=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,RE=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,PE=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,IE=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,LE=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,NE=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,DE=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,FE=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,UE=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,OE=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,kE=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,BE=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,zE=`float getShadowMask() {
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
}`,VE=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,HE=`#ifdef USE_SKINNING
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
#endif`,GE=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,WE=`#ifdef USE_SKINNING
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
#endif`,XE=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,$E=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,qE=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,YE=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,JE=`#ifdef USE_TRANSMISSION
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
#endif`,ZE=`#ifdef USE_TRANSMISSION
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
#endif`,KE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,jE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,QE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,eT=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,tT=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,nT=`uniform sampler2D t2D;
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
}`,iT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,sT=`uniform float backgroundBlurriness;
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
}`,rT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,oT=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,aT=`#include <common>
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
}`,lT=`#if DEPTH_PACKING == 3200
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
}`,cT=`#define DISTANCE
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
}`,uT=`#define DISTANCE
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
}`,hT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,dT=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,fT=`uniform float scale;
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
}`,pT=`uniform vec3 diffuse;
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
}`,mT=`#include <common>
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
}`,gT=`uniform vec3 diffuse;
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
}`,xT=`#define LAMBERT
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
}`,vT=`#define LAMBERT
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
}`,yT=`#define MATCAP
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
}`,_T=`#define MATCAP
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
}`,bT=`#define NORMAL
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
}`,ST=`#define NORMAL
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
}`,MT=`#define PHONG
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
}`,wT=`#define PHONG
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
}`,ET=`#define STANDARD
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
}`,TT=`#define STANDARD
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
}`,AT=`#define TOON
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
}`,CT=`#define TOON
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
}`,RT=`uniform float size;
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
}`,PT=`uniform vec3 diffuse;
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
}`,IT=`#include <common>
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
}`,LT=`uniform vec3 color;
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
}`,NT=`uniform float rotation;
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
}`,DT=`uniform vec3 diffuse;
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
}`,ct={alphahash_fragment:n1,alphahash_pars_fragment:i1,alphamap_fragment:s1,alphamap_pars_fragment:r1,alphatest_fragment:o1,alphatest_pars_fragment:a1,aomap_fragment:l1,aomap_pars_fragment:c1,batching_pars_vertex:u1,batching_vertex:h1,begin_vertex:d1,beginnormal_vertex:f1,bsdfs:p1,iridescence_fragment:m1,bumpmap_pars_fragment:g1,clipping_planes_fragment:x1,clipping_planes_pars_fragment:v1,clipping_planes_pars_vertex:y1,clipping_planes_vertex:_1,color_fragment:b1,color_pars_fragment:S1,color_pars_vertex:M1,color_vertex:w1,common:E1,defaultnormal_vertex:T1,displacementmap_pars_vertex:A1,displacementmap_vertex:C1,emissivemap_fragment:R1,emissivemap_pars_fragment:P1,colorspace_fragment:I1,colorspace_pars_fragment:L1,envmap_fragment:N1,envmap_common_pars_fragment:D1,envmap_pars_fragment:F1,envmap_pars_vertex:U1,envmap_physical_pars_fragment:q1,envmap_vertex:O1,fog_vertex:k1,fog_pars_vertex:B1,fog_fragment:z1,fog_pars_fragment:V1,gradientmap_pars_fragment:H1,lightmap_pars_fragment:G1,lights_lambert_fragment:W1,lights_lambert_pars_fragment:X1,lights_pars_begin:$1,lights_toon_fragment:Y1,lights_toon_pars_fragment:J1,lights_phong_fragment:Z1,lights_phong_pars_fragment:K1,lights_physical_fragment:j1,lights_physical_pars_fragment:Q1,lights_fragment_begin:eE,lights_fragment_maps:tE,lights_fragment_end:nE,lightprobes_pars_fragment:iE,logdepthbuf_fragment:sE,logdepthbuf_pars_fragment:rE,logdepthbuf_pars_vertex:oE,logdepthbuf_vertex:aE,map_fragment:lE,map_pars_fragment:cE,map_particle_fragment:uE,map_particle_pars_fragment:hE,metalnessmap_fragment:dE,metalnessmap_pars_fragment:fE,morphinstance_vertex:pE,morphcolor_vertex:mE,morphnormal_vertex:gE,morphtarget_pars_vertex:xE,morphtarget_vertex:vE,normal_fragment_begin:yE,normal_fragment_maps:_E,normal_pars_fragment:bE,normal_pars_vertex:SE,normal_vertex:ME,normalmap_pars_fragment:wE,clearcoat_normal_fragment_begin:EE,clearcoat_normal_fragment_maps:TE,clearcoat_pars_fragment:AE,iridescence_pars_fragment:CE,opaque_fragment:RE,packing:PE,premultiplied_alpha_fragment:IE,project_vertex:LE,dithering_fragment:NE,dithering_pars_fragment:DE,roughnessmap_fragment:FE,roughnessmap_pars_fragment:UE,shadowmap_pars_fragment:OE,shadowmap_pars_vertex:kE,shadowmap_vertex:BE,shadowmask_pars_fragment:zE,skinbase_vertex:VE,skinning_pars_vertex:HE,skinning_vertex:GE,skinnormal_vertex:WE,specularmap_fragment:XE,specularmap_pars_fragment:$E,tonemapping_fragment:qE,tonemapping_pars_fragment:YE,transmission_fragment:JE,transmission_pars_fragment:ZE,uv_pars_fragment:KE,uv_pars_vertex:jE,uv_vertex:QE,worldpos_vertex:eT,background_vert:tT,background_frag:nT,backgroundCube_vert:iT,backgroundCube_frag:sT,cube_vert:rT,cube_frag:oT,depth_vert:aT,depth_frag:lT,distance_vert:cT,distance_frag:uT,equirect_vert:hT,equirect_frag:dT,linedashed_vert:fT,linedashed_frag:pT,meshbasic_vert:mT,meshbasic_frag:gT,meshlambert_vert:xT,meshlambert_frag:vT,meshmatcap_vert:yT,meshmatcap_frag:_T,meshnormal_vert:bT,meshnormal_frag:ST,meshphong_vert:MT,meshphong_frag:wT,meshphysical_vert:ET,meshphysical_frag:TT,meshtoon_vert:AT,meshtoon_frag:CT,points_vert:RT,points_frag:PT,shadow_vert:IT,shadow_frag:LT,sprite_vert:NT,sprite_frag:DT},Le={common:{diffuse:{value:new rt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new et}},envmap:{envMap:{value:null},envMapRotation:{value:new et},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new et}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new et}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new et},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new et},normalScale:{value:new yt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new et},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new et}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new et}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new et}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new rt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new rt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0},uvTransform:{value:new et}},sprite:{diffuse:{value:new rt(16777215)},opacity:{value:1},center:{value:new yt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}}},fs={basic:{uniforms:Jn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:ct.meshbasic_vert,fragmentShader:ct.meshbasic_frag},lambert:{uniforms:Jn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new rt(0)},envMapIntensity:{value:1}}]),vertexShader:ct.meshlambert_vert,fragmentShader:ct.meshlambert_frag},phong:{uniforms:Jn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new rt(0)},specular:{value:new rt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ct.meshphong_vert,fragmentShader:ct.meshphong_frag},standard:{uniforms:Jn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new rt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ct.meshphysical_vert,fragmentShader:ct.meshphysical_frag},toon:{uniforms:Jn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new rt(0)}}]),vertexShader:ct.meshtoon_vert,fragmentShader:ct.meshtoon_frag},matcap:{uniforms:Jn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:ct.meshmatcap_vert,fragmentShader:ct.meshmatcap_frag},points:{uniforms:Jn([Le.points,Le.fog]),vertexShader:ct.points_vert,fragmentShader:ct.points_frag},dashed:{uniforms:Jn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ct.linedashed_vert,fragmentShader:ct.linedashed_frag},depth:{uniforms:Jn([Le.common,Le.displacementmap]),vertexShader:ct.depth_vert,fragmentShader:ct.depth_frag},normal:{uniforms:Jn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:ct.meshnormal_vert,fragmentShader:ct.meshnormal_frag},sprite:{uniforms:Jn([Le.sprite,Le.fog]),vertexShader:ct.sprite_vert,fragmentShader:ct.sprite_frag},background:{uniforms:{uvTransform:{value:new et},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ct.background_vert,fragmentShader:ct.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new et}},vertexShader:ct.backgroundCube_vert,fragmentShader:ct.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ct.cube_vert,fragmentShader:ct.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ct.equirect_vert,fragmentShader:ct.equirect_frag},distance:{uniforms:Jn([Le.common,Le.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ct.distance_vert,fragmentShader:ct.distance_frag},shadow:{uniforms:Jn([Le.lights,Le.fog,{color:{value:new rt(0)},opacity:{value:1}}]),vertexShader:ct.shadow_vert,fragmentShader:ct.shadow_frag}};fs.physical={uniforms:Jn([fs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new et},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new et},clearcoatNormalScale:{value:new yt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new et},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new et},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new et},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new et},sheen:{value:0},sheenColor:{value:new rt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new et},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new et},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new et},transmissionSamplerSize:{value:new yt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new et},attenuationDistance:{value:0},attenuationColor:{value:new rt(0)},specularColor:{value:new rt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new et},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new et},anisotropyVector:{value:new yt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new et}}]),vertexShader:ct.meshphysical_vert,fragmentShader:ct.meshphysical_frag};var Qu={r:0,b:0,g:0},FT=new bt,Gv=new et;Gv.set(-1,0,0,0,1,0,0,0,1);function UT(n,e,t,i,s,r){let o=new rt(0),a=s===!0?0:1,l,c,u=null,f=0,h=null;function d(y){let M=y.isScene===!0?y.background:null;if(M&&M.isTexture){let b=y.backgroundBlurriness>0;M=e.get(M,b)}return M}function p(y){let M=!1,b=d(y);b===null?g(o,a):b&&b.isColor&&(g(b,1),M=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function v(y,M){let b=d(M);b&&b.isCubeTexture?(c===void 0&&(c=new wt(new Bo(1,1,1),new Di({name:"BackgroundCubeMaterial",uniforms:Vr(fs.backgroundCube.uniforms),vertexShader:fs.backgroundCube.vertexShader,fragmentShader:fs.backgroundCube.fragmentShader,side:Xn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,T,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(FT.makeRotationFromEuler(M.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Gv),c.material.toneMapped=xt.getTransfer(b.colorSpace)!==Pt,(u!==b||f!==b.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,f=b.version,h=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new wt(new Ur(2,2),new Di({name:"BackgroundMaterial",uniforms:Vr(fs.background.uniforms),vertexShader:fs.background.vertexShader,fragmentShader:fs.background.fragmentShader,side:Fi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=xt.getTransfer(b.colorSpace)!==Pt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||f!==b.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,f=b.version,h=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function g(y,M){y.getRGB(Qu,pp(n)),t.buffers.color.setClear(Qu.r,Qu.g,Qu.b,M,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,M=1){o.set(y),a=M,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,g(o,a)},render:p,addToRenderList:v,dispose:m}}function OT(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(L,B,z,D,W){let q=!1,H=f(L,D,z,B);r!==H&&(r=H,c(r.object)),q=d(L,D,z,W),q&&p(L,D,z,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,b(L,B,z,D),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function f(L,B,z,D){let W=D.wireframe===!0,q=i[B.id];q===void 0&&(q={},i[B.id]=q);let H=L.isInstancedMesh===!0?L.id:0,le=q[H];le===void 0&&(le={},q[H]=le);let Z=le[z.id];Z===void 0&&(Z={},le[z.id]=Z);let Q=Z[W];return Q===void 0&&(Q=h(l()),Z[W]=Q),Q}function h(L){let B=[],z=[],D=[];for(let W=0;W<t;W++)B[W]=0,z[W]=0,D[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:z,attributeDivisors:D,object:L,attributes:{},index:null}}function d(L,B,z,D){let W=r.attributes,q=B.attributes,H=0,le=z.getAttributes();for(let Z in le)if(le[Z].location>=0){let ie=W[Z],de=q[Z];if(de===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(de=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(de=L.instanceColor)),ie===void 0||ie.attribute!==de||de&&ie.data!==de.data)return!0;H++}return r.attributesNum!==H||r.index!==D}function p(L,B,z,D){let W={},q=B.attributes,H=0,le=z.getAttributes();for(let Z in le)if(le[Z].location>=0){let ie=q[Z];ie===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(ie=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(ie=L.instanceColor));let de={};de.attribute=ie,ie&&ie.data&&(de.data=ie.data),W[Z]=de,H++}r.attributes=W,r.attributesNum=H,r.index=D}function v(){let L=r.newAttributes;for(let B=0,z=L.length;B<z;B++)L[B]=0}function g(L){m(L,0)}function m(L,B){let z=r.newAttributes,D=r.enabledAttributes,W=r.attributeDivisors;z[L]=1,D[L]===0&&(n.enableVertexAttribArray(L),D[L]=1),W[L]!==B&&(n.vertexAttribDivisor(L,B),W[L]=B)}function y(){let L=r.newAttributes,B=r.enabledAttributes;for(let z=0,D=B.length;z<D;z++)B[z]!==L[z]&&(n.disableVertexAttribArray(z),B[z]=0)}function M(L,B,z,D,W,q,H){H===!0?n.vertexAttribIPointer(L,B,z,W,q):n.vertexAttribPointer(L,B,z,D,W,q)}function b(L,B,z,D){v();let W=D.attributes,q=z.getAttributes(),H=B.defaultAttributeValues;for(let le in q){let Z=q[le];if(Z.location>=0){let Q=W[le];if(Q===void 0&&(le==="instanceMatrix"&&L.instanceMatrix&&(Q=L.instanceMatrix),le==="instanceColor"&&L.instanceColor&&(Q=L.instanceColor)),Q!==void 0){let ie=Q.normalized,de=Q.itemSize,he=e.get(Q);if(he===void 0)continue;let ee=he.buffer,me=he.type,ge=he.bytesPerElement,Me=me===n.INT||me===n.UNSIGNED_INT||Q.gpuType===gu;if(Q.isInterleavedBufferAttribute){let ve=Q.data,Ve=ve.isInterleavedBuffer===!0?ve.stride:ve.itemSize,Xe=Q.offset;if(ve.isInstancedInterleavedBuffer||ve.isInstancedBufferAttribute){for(let De=0;De<Z.locationSize;De++)m(Z.location+De,ve.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=ve.meshPerAttribute*ve.count)}else for(let De=0;De<Z.locationSize;De++)g(Z.location+De);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let De=0;De<Z.locationSize;De++)M(Z.location+De,de/Z.locationSize,me,ie,Ve*ge,(Xe+de/Z.locationSize*De)*ge,Me)}else{if(Q.isInstancedBufferAttribute){for(let ve=0;ve<Z.locationSize;ve++)m(Z.location+ve,Q.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let ve=0;ve<Z.locationSize;ve++)g(Z.location+ve);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let ve=0;ve<Z.locationSize;ve++)M(Z.location+ve,de/Z.locationSize,me,ie,de*ge,de/Z.locationSize*ve*ge,Me)}}else if(H!==void 0){let ie=H[le];if(ie!==void 0)switch(ie.length){case 2:n.vertexAttrib2fv(Z.location,ie);break;case 3:n.vertexAttrib3fv(Z.location,ie);break;case 4:n.vertexAttrib4fv(Z.location,ie);break;default:n.vertexAttrib1fv(Z.location,ie)}}}}y()}function R(){U();for(let L in i){let B=i[L];for(let z in B){let D=B[z];for(let W in D){let q=D[W];for(let H in q)u(q[H].object),delete q[H];delete D[W]}}delete i[L]}}function T(L){if(i[L.id]===void 0)return;let B=i[L.id];for(let z in B){let D=B[z];for(let W in D){let q=D[W];for(let H in q)u(q[H].object),delete q[H];delete D[W]}}delete i[L.id]}function _(L){for(let B in i){let z=i[B];for(let D in z){let W=z[D];if(W[L.id]===void 0)continue;let q=W[L.id];for(let H in q)u(q[H].object),delete q[H];delete W[L.id]}}}function E(L){for(let B in i){let z=i[B],D=L.isInstancedMesh===!0?L.id:0,W=z[D];if(W!==void 0){for(let q in W){let H=W[q];for(let le in H)u(H[le].object),delete H[le];delete W[q]}delete z[D],Object.keys(z).length===0&&delete i[B]}}}function U(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:N,dispose:R,releaseStatesOfGeometry:T,releaseStatesOfObject:E,releaseStatesOfProgram:_,initAttributes:v,enableAttribute:g,disableUnusedAttributes:y}}function kT(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let d=0;d<u;d++)h+=c[d];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function BT(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==wi&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let E=_===ji&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==Mi&&_!==Ki&&!E&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ye("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Ye("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Ye("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),M=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:p,maxTextureSize:v,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:y,maxVaryings:M,maxFragmentUniforms:b,maxSamples:R,samples:T}}function zT(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Yi,a=new et,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let d=f.length!==0||h||i!==0||s;return s=h,i=f.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,d){let p=f.clippingPlanes,v=f.clipIntersection,g=f.clipShadows,m=n.get(f);if(!s||p===null||p.length===0||r&&!g)r?u(null):c();else{let y=r?0:i,M=y*4,b=m.clippingState||null;l.value=b,b=u(p,h,M,d);for(let R=0;R!==M;++R)b[R]=t[R];m.clippingState=b,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(f,h,d,p){let v=f!==null?f.length:0,g=null;if(v!==0){if(g=l.value,p!==!0||g===null){let m=d+v*4,y=h.matrixWorldInverse;a.getNormalMatrix(y),(g===null||g.length<m)&&(g=new Float32Array(m));for(let M=0,b=d;M!==v;++M,b+=4)o.copy(f[M]).applyMatrix4(y,a),o.normal.toArray(g,b),g[b+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,g}}var cl=class extends _i{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Xa(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Bo(5,5,5),r=new Di({name:"CubemapFromEquirect",uniforms:Vr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Xn,blending:Or});r.uniforms.tEquirect.value=t;let o=new wt(s,r),a=t.minFilter;return t.minFilter===Ns&&(t.minFilter=Wn),new Ho(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},bv=256,VT=3,HT=20,Wv=256,Xv=16,GT=3,WT=new G,XT=new rt,th=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ho(1,10,null),this._boxMesh=new wt(new Bo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=WT}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(XT));let g=new Ho(i,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=d,l.autoClearStencil=p,e.background=v,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=wv(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Mv(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(bv,gv(e))}_fromTexture(e,t){e.mapping===Br||e.mapping===Xo?this._setSize(e.image.length===0?bv:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Sv(e,!1,!1),i=Math.log2(e)-VT;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Sv(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Br||e.mapping===Xo?(this._cubemapMaterial===null&&(this._cubemapMaterial=wv()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Mv()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=$T(),this._integrationMaterial=qT());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Xv);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-GT)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Wv*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=YT());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function Sv(n,e,t){return new cl(n,{minFilter:Ns,generateMipmaps:e,type:ji,colorSpace:Fa,depthBuffer:t})}function ul(n,e,t){return new Di({name:n,uniforms:e,vertexShader:ct.cube_vert,fragmentShader:t,side:Xn,blending:Or,depthTest:!1,depthWrite:!1})}function $T(){return ul("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Wv}u

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
	`)}function qT(){return ul("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Xv}},`

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
	`)}function YT(){return ul("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${HT}
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
	`)}function Mv(){return ul("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function wv(){return ul("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function JT(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,d=!1){return h==null?null:d?o(h):r(h)}function r(h){if(h&&h.isTexture){let d=h.mapping;if(d===fu||d===pu)if(e.has(h)){let p=e.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let v=new cl(p.height);return v.fromEquirectangularTexture(n,h),e.set(h,v),h.addEventListener("dispose",c),a(v.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let d=h.mapping,p=d===fu||d===pu,v=d===Br||d===Xo;if(p||v){let g=t.get(h),m=g!==void 0?g.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return i===null&&(i=new th(n)),g=p?i.fromEquirectangular(h,g):i.fromCubemap(h,g),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),g.texture;if(g!==void 0)return g.texture;{let y=h.image;return p&&y&&y.height>0||v&&y&&l(y)?(i===null&&(i=new th(n)),g=p?i.fromEquirectangular(h):i.fromCubemap(h),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),h.addEventListener("dispose",u),g.texture):null}}}return h}function a(h,d){return d===fu?h.mapping=Br:d===pu&&(h.mapping=Xo),h}function l(h){let d=0,p=6;for(let v=0;v<p;v++)h[v]!==void 0&&d++;return d===p}function c(h){let d=h.target;d.removeEventListener("dispose",c);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function u(h){let d=h.target;d.removeEventListener("dispose",u);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function ZT(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Na("WebGLRenderer: "+i+" extension not supported."),s}}}function KT(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let g in p.attributes)e.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let v=r.get(p);v&&(e.remove(v),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function u(p){let v=p.attributes;for(let g in v)e.update(v[g],n.ARRAY_BUFFER)}function f(p){let v=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let y=v!==null?v.array.length:g.array.length/3-1,M=g.count>=65535?Ga:Ha,b=new M(Math.ceil(y/3)*6,1),R=b.array;if(v!==null){let _=v.array;m=v.version;for(let E=0,U=0;E<y;E+=3){let N=_[E+0],L=_[E+1],B=_[E+2];R[U++]=N,R[U++]=L,R[U++]=L,R[U++]=B,R[U++]=B,R[U++]=N}}else{m=g.version;for(let _=0,E=0;_<y;_+=3){let U=_+0,N=_+1,L=_+2;R[E++]=U,R[E++]=N,R[E++]=N,R[E++]=L,R[E++]=L,R[E++]=U}}b.version=m;let T=r.get(p);T&&e.remove(T),r.set(p,b)}function h(p){let v=r.get(p);if(v){let g=p.index;g!==null&&v.version<g.version&&f(p)}else f(p);return r.get(p)}function d(){for(let p in s){let v=s[p].deref();v!==void 0&&l(v)}}return{get:c,update:u,getWireframeAttribute:h,dispose:d}}function jT(n,e,t){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,h){n.drawElements(i,h,r,f*o),t.update(h,i,1)}function c(f,h,d){d!==0&&(n.drawElementsInstanced(i,h,r,f*o,d),t.update(h,i,d))}function u(f,h,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,d);let v=0;for(let g=0;g<d;g++)v+=h[g];t.update(v,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function QT(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:Qe("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function eA(n,e,t){let i=new WeakMap,s=new Zt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==f){let U=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",U)};h!==void 0&&h.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],M=0;d===!0&&(M=1),p===!0&&(M=2),v===!0&&(M=3);let b=a.attributes.position.count*M,R=1;b>e.maxTextureSize&&(R=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let T=new Float32Array(b*R*4*f),_=new Ba(T,b,R,f);_.type=Ki,_.needsUpdate=!0;let E=M*4;for(let N=0;N<f;N++){let L=g[N],B=m[N],z=y[N],D=b*R*4*N;for(let W=0;W<L.count;W++){let q=W*E;d===!0&&(s.fromBufferAttribute(L,W),T[D+q+0]=s.x,T[D+q+1]=s.y,T[D+q+2]=s.z,T[D+q+3]=0),p===!0&&(s.fromBufferAttribute(B,W),T[D+q+4]=s.x,T[D+q+5]=s.y,T[D+q+6]=s.z,T[D+q+7]=0),v===!0&&(s.fromBufferAttribute(z,W),T[D+q+8]=s.x,T[D+q+9]=s.y,T[D+q+10]=s.z,T[D+q+11]=z.itemSize===4?s.w:1)}}h={count:f,texture:_,size:new yt(b,R)},i.set(a,h),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let v=0;v<c.length;v++)d+=c[v];let p=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function tA(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,h=e.get(c,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var nA={[Gf]:"LINEAR_TONE_MAPPING",[Wf]:"REINHARD_TONE_MAPPING",[Xf]:"CINEON_TONE_MAPPING",[$f]:"ACES_FILMIC_TONE_MAPPING",[Yf]:"AGX_TONE_MAPPING",[Jf]:"NEUTRAL_TONE_MAPPING",[qf]:"CUSTOM_TONE_MAPPING"};function iA(n,e,t,i,s,r){let o=new _i(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new hn;u.setAttribute("position",new un([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new un([0,2,0,0,2,0],2));let f=new Qc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new wt(u,f),d=new Vo(-1,1,1,-1,0,1),p=null,v=null,g=!1,m,y=null,M=[],b=!1;this.setSize=function(R,T){o.setSize(R,T),a!==null&&a.setSize(R,T),l!==null&&l.setSize(R,T);for(let _=0;_<M.length;_++){let E=M[_];E.setSize&&E.setSize(R,T)}},this.setEffects=function(R){M=R,b=M.length>0&&M[0].isRenderPass===!0;let T=o.width,_=o.height;M.length>0&&a===null&&(a=new _i(T,_,{type:ji,depthBuffer:!1,stencilBuffer:!1}),l=new _i(T,_,{type:ji,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&M.some(U=>U.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new Ls(T,_),r===!0&&(c.format=Ds,c.type=zr)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let U=0;U<M.length;U++){let N=M[U];N.setSize&&N.setSize(T,_),E&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(R,T){if(g||R.toneMapping===hs&&M.length===0)return!1;if(y=T,T!==null){let _=T.width,E=T.height;(o.width!==_||o.height!==E)&&this.setSize(_,E)}return b===!1&&R.setRenderTarget(o),m=R.toneMapping,R.toneMapping=hs,!0},this.hasRenderPass=function(){return b},this.end=function(R,T){R.toneMapping=m,g=!0;let _=o,E=a;for(let U=0;U<M.length;U++){let N=M[U];N.enabled!==!1&&(N.render(R,E,_,T),N.needsSwap!==!1&&(_=E,E=E===a?l:a))}if(p!==R.outputColorSpace||v!==R.toneMapping){p=R.outputColorSpace,v=R.toneMapping,f.defines={},xt.getTransfer(p)===Pt&&(f.defines.SRGB_TRANSFER="");let U=nA[v];U&&(f.defines[U]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=_.texture,R.setRenderTarget(y),R.render(h,d),y=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var $v=new li,qv=new Ls(1,1),Yv=new $a(1),Jv=new Ba,Zv=new Jc,Kv=new Xa,Ev=[],Tv=[],Av=new Float32Array(16),Cv=new Float32Array(9),Rv=new Float32Array(4);function Yo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=Ev[s];if(r===void 0&&(r=new Float32Array(s),Ev[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Ln(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Nn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function ih(n,e){let t=Tv[e];t===void 0&&(t=new Int32Array(e),Tv[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function sA(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function rA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ln(t,e))return;n.uniform2fv(this.addr,e),Nn(t,e)}}function oA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Ln(t,e))return;n.uniform3fv(this.addr,e),Nn(t,e)}}function aA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ln(t,e))return;n.uniform4fv(this.addr,e),Nn(t,e)}}function lA(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ln(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Nn(t,e)}else{if(Ln(t,i))return;Rv.set(i),n.uniformMatrix2fv(this.addr,!1,Rv),Nn(t,i)}}function cA(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ln(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Nn(t,e)}else{if(Ln(t,i))return;Cv.set(i),n.uniformMatrix3fv(this.addr,!1,Cv),Nn(t,i)}}function uA(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ln(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Nn(t,e)}else{if(Ln(t,i))return;Av.set(i),n.uniformMatrix4fv(this.addr,!1,Av),Nn(t,i)}}function hA(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function dA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ln(t,e))return;n.uniform2iv(this.addr,e),Nn(t,e)}}function fA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ln(t,e))return;n.uniform3iv(this.addr,e),Nn(t,e)}}function pA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ln(t,e))return;n.uniform4iv(this.addr,e),Nn(t,e)}}function mA(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function gA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ln(t,e))return;n.uniform2uiv(this.addr,e),Nn(t,e)}}function xA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ln(t,e))return;n.uniform3uiv(this.addr,e),Nn(t,e)}}function vA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ln(t,e))return;n.uniform4uiv(this.addr,e),Nn(t,e)}}function sh(n){return n.version===0&&(n.compareFunction=up,n.needsUpdate=!0),n}function yA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=sh(qv):r=$v,t.setTexture2D(e||r,s)}function _A(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||Zv,s)}function bA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=sh(Yv):r=Kv,t.setTextureCube(e||r,s)}function SA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||Jv,s)}function MA(n){switch(n){case 5126:return sA;case 35664:return rA;case 35665:return oA;case 35666:return aA;case 35674:return lA;case 35675:return cA;case 35676:return uA;case 5124:case 35670:return hA;case 35667:case 35671:return dA;case 35668:case 35672:return fA;case 35669:case 35673:return pA;case 5125:return mA;case 36294:return gA;case 36295:return xA;case 36296:return vA;case 35678:case 36198:case 36298:case 36306:case 35682:return yA;case 35679:case 36299:case 36307:return _A;case 35680:case 36300:case 36308:case 36293:return bA;case 36289:case 36303:case 36311:case 36292:return SA}}function wA(n,e){n.uniform1fv(this.addr,e)}function EA(n,e){let t=Yo(e,this.size,2);n.uniform2fv(this.addr,t)}function TA(n,e){let t=Yo(e,this.size,3);n.uniform3fv(this.addr,t)}function AA(n,e){let t=Yo(e,this.size,4);n.uniform4fv(this.addr,t)}function CA(n,e){let t=Yo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function RA(n,e){let t=Yo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function PA(n,e){let t=Yo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function IA(n,e){n.uniform1iv(this.addr,e)}function LA(n,e){n.uniform2iv(this.addr,e)}function NA(n,e){n.uniform3iv(this.addr,e)}function DA(n,e){n.uniform4iv(this.addr,e)}function FA(n,e){n.uniform1uiv(this.addr,e)}function UA(n,e){n.uniform2uiv(this.addr,e)}function OA(n,e){n.uniform3uiv(this.addr,e)}function kA(n,e){n.uniform4uiv(this.addr,e)}function BA(n,e,t){let i=this.cache,s=e.length,r=ih(t,s);Ln(i,r)||(n.uniform1iv(this.addr,r),Nn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=sh(qv):o=$v;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function zA(n,e,t){let i=this.cache,s=e.length,r=ih(t,s);Ln(i,r)||(n.uniform1iv(this.addr,r),Nn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Zv,r[o])}function VA(n,e,t){let i=this.cache,s=e.length,r=ih(t,s);Ln(i,r)||(n.uniform1iv(this.addr,r),Nn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=sh(Yv):o=Kv;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function HA(n,e,t){let i=this.cache,s=e.length,r=ih(t,s);Ln(i,r)||(n.uniform1iv(this.addr,r),Nn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Jv,r[o])}function GA(n){switch(n){case 5126:return wA;case 35664:return EA;case 35665:return TA;case 35666:return AA;case 35674:return CA;case 35675:return RA;case 35676:return PA;case 5124:case 35670:return IA;case 35667:case 35671:return LA;case 35668:case 35672:return NA;case 35669:case 35673:return DA;case 5125:return FA;case 36294:return UA;case 36295:return OA;case 36296:return kA;case 35678:case 36198:case 36298:case 36306:case 35682:return BA;case 35679:case 36299:case 36307:return zA;case 35680:case 36300:case 36308:case 36293:return VA;case 36289:case 36303:case 36311:case 36292:return HA}}var _p=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=MA(t.type)}},bp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=GA(t.type)}},Sp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},vp=/(\w+)(\])?(\[|\.)?/g;function Pv(n,e){n.seq.push(e),n.map[e.id]=e}function WA(n,e,t){let i=n.name,s=i.length;for(vp.lastIndex=0;;){let r=vp.exec(i),o=vp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Pv(t,c===void 0?new _p(a,n,e):new bp(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new Sp(a),Pv(t,f)),t=f}}}var qo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);WA(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function Iv(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var XA=37297,$A=0;function qA(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Lv=new et;function YA(n){xt._getMatrix(Lv,xt.workingColorSpace,n);let e=`mat3( ${Lv.elements.map(t=>t.toFixed(4))} )`;switch(xt.getTransfer(n)){case Ua:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return Ye("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Nv(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+qA(n.getShaderSource(e),a)}else return r}function JA(n,e){let t=YA(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var ZA={[Gf]:"Linear",[Wf]:"Reinhard",[Xf]:"Cineon",[$f]:"ACESFilmic",[Yf]:"AgX",[Jf]:"Neutral",[qf]:"Custom"};function KA(n,e){let t=ZA[e];return t===void 0?(Ye("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var eh=new G;function jA(){xt.getLuminanceCoefficients(eh);let n=eh.x.toFixed(4),e=eh.y.toFixed(4),t=eh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function QA(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ll).join(`
`)}function eC(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function tC(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function ll(n){return n!==""}function Dv(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Fv(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var nC=/^[ \t]*#include +<([\w\d./]+)>/gm;function Mp(n){return n.replace(nC,iC)}function iC(n,e){let t=ct[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Mp(t)}var sC=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Uv(n){return n.replace(sC,rC)}function rC(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Ov(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var oC={[Ka]:"SHADOWMAP_TYPE_PCF",[Go]:"SHADOWMAP_TYPE_VSM"};function aC(n){return oC[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var lC={[Xo]:"ENVMAP_MODE_REFRACTION"};function cC(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":lC[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var uC={[Hf]:"ENVMAP_BLENDING_MULTIPLY",[tv]:"ENVMAP_BLENDING_MIX",[nv]:"ENVMAP_BLENDING_ADD"};function hC(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":uC[n.combine]||"ENVMAP_BLENDING_NONE"}function dC(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=aC(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=cC(t),f=hC(t),h=QA(t),d=eC(r),p=s.createProgram(),v,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(ll).join(`
`),v.length>0&&(v+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(ll).join(`
`),g.length>0&&(g+=`
`)):(v=[Ov(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ll).join(`
`),g=[Ov(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==hs?"#define TONE_MAPPING":"",t.toneMapping!==hs?ct.tonemapping_pars_fragment:"",t.toneMapping!==hs?KA("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ct.colorspace_pars_fragment,JA("linearToOutputTexel",t.outputColorSpace),jA(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ll).join(`
`)),o=Mp(o),o=Dv(o,t),o=Fv(o,t),a=Mp(a),a=Dv(a,t),a=Fv(a,t),o=Uv(o),a=Uv(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,v=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,g=["#define varying in",t.glslVersion===hp?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===hp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let y=m+v+o,M=m+g+a,b=Iv(s,s.VERTEX_SHADER,y),R=Iv(s,s.FRAGMENT_SHADER,M);s.attachShader(p,b),s.attachShader(p,R),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function T(N){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",B=s.getShaderInfoLog(b)||"",z=s.getShaderInfoLog(R)||"",D=L.trim(),W=B.trim(),q=z.trim(),H=!0,le=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,b,R);else{let Z=Nv(s,b,"vertex"),Q=Nv(s,R,"fragment");Qe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+D+`
`+Z+`
`+Q)}else D!==""?Ye("WebGLProgram: Program Info Log:",D):(W===""||q==="")&&(le=!1);le&&(N.diagnostics={runnable:H,programLog:D,vertexShader:{log:W,prefix:v},fragmentShader:{log:q,prefix:g}})}s.deleteShader(b),s.deleteShader(R),_=new qo(s,p),E=tC(s,p)}let _;this.getUniforms=function(){return _===void 0&&T(this),_};let E;this.getAttributes=function(){return E===void 0&&T(this),E};let U=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(p,XA)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=$A++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=R,this}var fC=0,wp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Ep(e),t.set(e,i)),i}},Ep=class{constructor(e){this.id=fC++,this.code=e,this.usedTimes=0}};function pC(n){return n===hr||n===il||n===sl}function mC(n,e,t,i,s,r){let o=new za,a=new wp,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(_){return l.add(_),_===0?"uv":`uv${_}`}function p(_,E,U,N,L,B){let z=N.fog,D=L.geometry,W=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?N.environment:null,q=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,H=e.get(_.envMap||W,q),le=h[_.type],Z=i.precision;_.precision!==null&&(Z=i.getMaxPrecision(_.precision),Z!==_.precision&&Ye("WebGLProgram.getParameters:",_.precision,"not supported, using",Z,"instead."));let Q=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,ie=Q!==void 0?Q.length:0,de=0;D.morphAttributes.position!==void 0&&(de=1),D.morphAttributes.normal!==void 0&&(de=2),D.morphAttributes.color!==void 0&&(de=3);let he,ee,me,ge;if(le){let Ce=fs[le];he=Ce.vertexShader,ee=Ce.fragmentShader}else{he=_.vertexShader,ee=_.fragmentShader;let Ce=a.getVertexShaderStage(_),st=a.getFragmentShaderStage(_);a.update(_,Ce,st),me=Ce.id,ge=st.id}let Me=n.getRenderTarget(),ve=n.state.buffers.depth.getReversed(),Ve=L.isInstancedMesh===!0,Xe=L.isBatchedMesh===!0,De=!!_.map,ut=!!_.matcap,at=!!H,tt=at&&H.isPMREMTexture===!0,jt=!!_.aoMap,Ht=!!_.lightMap,mn=!!_.bumpMap&&_.wireframe===!1,Ut=!!_.normalMap,Dn=!!_.displacementMap,_t=!!_.emissiveMap,Cn=!!_.metalnessMap,rn=!!_.roughnessMap,gn=_.anisotropy>0,k=_.clearcoat>0,Re=_.diffuseRoughness>0,qe=_.dispersion>0,it=_.retroreflectivity>0,we=_.iridescence>0,Bt=_.sheen>0,He=_.transmission>0,$e=gn&&!!_.anisotropyMap,P=k&&!!_.clearcoatMap,w=k&&!!_.clearcoatNormalMap,$=k&&!!_.clearcoatRoughnessMap,ue=Re&&!!_.diffuseRoughnessMap,oe=we&&!!_.iridescenceMap,ye=we&&!!_.iridescenceThicknessMap,_e=Bt&&!!_.sheenColorMap,te=Bt&&!!_.sheenRoughnessMap,se=!!_.specularMap,pe=!!_.specularColorMap,O=!!_.specularIntensityMap,re=He&&!!_.transmissionMap,ne=He&&!!_.thicknessMap,Ee=!!_.gradientMap,xe=!!_.alphaMap,Se=_.alphaTest>0,Ge=!!_.alphaHash,Ze=!!_.extensions,ce=hs;_.toneMapped&&(Me===null||Me.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ke=tt?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,Ke={shaderID:le,shaderType:_.type,shaderName:_.name,vertexShader:he,fragmentShader:ee,defines:_.defines,customVertexShaderID:me,customFragmentShaderID:ge,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:Z,batching:Xe,batchingColor:Xe&&L._colorsTexture!==null,instancing:Ve,instancingColor:Ve&&L.instanceColor!==null,instancingMorph:Ve&&L.morphTexture!==null,outputColorSpace:Me===null?n.outputColorSpace:Me.isXRRenderTarget===!0?Me.texture.colorSpace:xt.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:De,matcap:ut,envMap:at,envMapMode:at&&H.mapping,envMapPMREM:tt,envMapMaxLod:tt?ke.length-1:null,envMapSize:tt?ke[0].width:null,aoMap:jt,lightMap:Ht,bumpMap:mn,normalMap:Ut,displacementMap:Dn,emissiveMap:_t,normalMapObjectSpace:Ut&&_.normalMapType===rv,normalMapTangentSpace:Ut&&_.normalMapType===sp,packedNormalMap:Ut&&_.normalMapType===sp&&pC(_.normalMap.format),metalnessMap:Cn,roughnessMap:rn,anisotropy:gn,anisotropyMap:$e,clearcoat:k,clearcoatMap:P,clearcoatNormalMap:w,clearcoatRoughnessMap:$,diffuseRoughness:Re,diffuseRoughnessMap:ue,dispersion:qe,retroreflection:it,iridescence:we,iridescenceMap:oe,iridescenceThicknessMap:ye,sheen:Bt,sheenColorMap:_e,sheenRoughnessMap:te,specularMap:se,specularColorMap:pe,specularIntensityMap:O,transmission:He,transmissionMap:re,thicknessMap:ne,gradientMap:Ee,opaque:_.transparent===!1&&_.blending===Wo&&_.alphaToCoverage===!1,alphaMap:xe,alphaTest:Se,alphaHash:Ge,combine:_.combine,mapUv:De&&d(_.map.channel),aoMapUv:jt&&d(_.aoMap.channel),lightMapUv:Ht&&d(_.lightMap.channel),bumpMapUv:mn&&d(_.bumpMap.channel),normalMapUv:Ut&&d(_.normalMap.channel),displacementMapUv:Dn&&d(_.displacementMap.channel),emissiveMapUv:_t&&d(_.emissiveMap.channel),metalnessMapUv:Cn&&d(_.metalnessMap.channel),roughnessMapUv:rn&&d(_.roughnessMap.channel),anisotropyMapUv:$e&&d(_.anisotropyMap.channel),clearcoatMapUv:P&&d(_.clearcoatMap.channel),clearcoatNormalMapUv:w&&d(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&d(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&d(_.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&d(_.iridescenceMap.channel),iridescenceThicknessMapUv:ye&&d(_.iridescenceThicknessMap.channel),sheenColorMapUv:_e&&d(_.sheenColorMap.channel),sheenRoughnessMapUv:te&&d(_.sheenRoughnessMap.channel),specularMapUv:se&&d(_.specularMap.channel),specularColorMapUv:pe&&d(_.specularColorMap.channel),specularIntensityMapUv:O&&d(_.specularIntensityMap.channel),transmissionMapUv:re&&d(_.transmissionMap.channel),thicknessMapUv:ne&&d(_.thicknessMap.channel),alphaMapUv:xe&&d(_.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Ut||gn),vertexNormals:!!D.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!D.attributes.uv&&(De||xe),fog:!!z,useFog:_.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||D.attributes.normal===void 0&&Ut===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:ve,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:de,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:B.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:De&&_.map.isVideoTexture===!0&&xt.getTransfer(_.map.colorSpace)===Pt,decodeVideoTextureEmissive:_t&&_.emissiveMap.isVideoTexture===!0&&xt.getTransfer(_.emissiveMap.colorSpace)===Pt,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===zn,flipSided:_.side===Xn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Ze&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ze&&_.extensions.multiDraw===!0||Xe)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Ke.vertexUv1s=l.has(1),Ke.vertexUv2s=l.has(2),Ke.vertexUv3s=l.has(3),l.clear(),Ke}function v(_){let E=[];if(_.shaderID?E.push(_.shaderID):(E.push(_.customVertexShaderID),E.push(_.customFragmentShaderID)),_.defines!==void 0)for(let U in _.defines)E.push(U),E.push(_.defines[U]);return _.isRawShaderMaterial===!1&&(g(E,_),m(E,_),E.push(n.outputColorSpace)),E.push(_.customProgramCacheKey),E.join()}function g(_,E){_.push(E.precision),_.push(E.outputColorSpace),_.push(E.envMapMode),_.push(E.envMapPMREM),_.push(E.envMapMaxLod),_.push(E.envMapSize),_.push(E.mapUv),_.push(E.alphaMapUv),_.push(E.lightMapUv),_.push(E.aoMapUv),_.push(E.bumpMapUv),_.push(E.normalMapUv),_.push(E.displacementMapUv),_.push(E.emissiveMapUv),_.push(E.metalnessMapUv),_.push(E.roughnessMapUv),_.push(E.anisotropyMapUv),_.push(E.clearcoatMapUv),_.push(E.clearcoatNormalMapUv),_.push(E.clearcoatRoughnessMapUv),_.push(E.diffuseRoughnessMapUv),_.push(E.iridescenceMapUv),_.push(E.iridescenceThicknessMapUv),_.push(E.sheenColorMapUv),_.push(E.sheenRoughnessMapUv),_.push(E.specularMapUv),_.push(E.specularColorMapUv),_.push(E.specularIntensityMapUv),_.push(E.transmissionMapUv),_.push(E.thicknessMapUv),_.push(E.combine),_.push(E.fogExp2),_.push(E.sizeAttenuation),_.push(E.morphTargetsCount),_.push(E.numSunLights),_.push(E.numDirLights),_.push(E.numPointLights),_.push(E.numSpotLights),_.push(E.numSpotLightMaps),_.push(E.numHemiLights),_.push(E.numRectAreaLights),_.push(E.numSunLightShadows),_.push(E.numDirLightShadows),_.push(E.numPointLightShadows),_.push(E.numSpotLightShadows),_.push(E.numSpotLightShadowsWithMaps),_.push(E.numLightProbes),_.push(E.numLightProbeGrids),_.push(E.shadowMapType),_.push(E.toneMapping),_.push(E.numClippingPlanes),_.push(E.numClipIntersection),_.push(E.depthPacking)}function m(_,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function y(_){let E=h[_.type],U;if(E){let N=fs[E];U=vv.clone(N.uniforms)}else U=_.uniforms;return U}function M(_,E){let U=u.get(E);return U!==void 0?++U.usedTimes:(U=new dC(n,E,_,s),c.push(U),u.set(E,U)),U}function b(_){if(--_.usedTimes===0){let E=c.indexOf(_);c[E]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function R(_){a.remove(_)}function T(){a.dispose()}return{getParameters:p,getProgramCacheKey:v,getUniforms:y,acquireProgram:M,releaseProgram:b,releaseShaderCache:R,programs:c,dispose:T}}function gC(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function xC(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function kv(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Bv(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function a(h,d,p,v,g,m){let y=n[e];return y===void 0?(y={id:h.id,object:h,geometry:d,material:p,materialVariant:o(h),groupOrder:v,renderOrder:h.renderOrder,z:g,group:m},n[e]=y):(y.id=h.id,y.object=h,y.geometry=d,y.material=p,y.materialVariant=o(h),y.groupOrder=v,y.renderOrder=h.renderOrder,y.z=g,y.group=m),e++,y}function l(h,d,p,v,g,m,y){y.reversedDepth===!0&&(g=-g);let M=a(h,d,p,v,g,m);p.transmission>0?i.push(M):p.transparent===!0?s.push(M):t.push(M)}function c(h,d,p,v,g,m){let y=a(h,d,p,v,g,m);p.transmission>0?i.unshift(y):p.transparent===!0?s.unshift(y):t.unshift(y)}function u(h,d){t.length>1&&t.sort(h||xC),i.length>1&&i.sort(d||kv),s.length>1&&s.sort(d||kv)}function f(){for(let h=e,d=n.length;h<d;h++){let p=n[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function vC(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Bv,n.set(i,[o])):s>=r.length?(o=new Bv,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function yC(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new G,color:new rt};break;case"SpotLight":t={position:new G,direction:new G,color:new rt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new G,color:new rt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new G,skyColor:new rt,groundColor:new rt};break;case"RectAreaLight":t={color:new rt,position:new G,halfWidth:new G,halfHeight:new G};break}return n[e.id]=t,t}}}function _C(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new yt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new yt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new yt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var bC=0;function SC(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function MC(n){let e=new yC,t=_C(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new G);let s=new G,r=new bt,o=new bt;function a(c){let u=0,f=0,h=0;for(let B=0;B<9;B++)i.probe[B].set(0,0,0);let d=0,p=0,v=0,g=0,m=0,y=0,M=0,b=0,R=0,T=0,_=0,E=0,U=0,N=0;c.sort(SC);for(let B=0,z=c.length;B<z;B++){let D=c[B],W=D.color,q=D.intensity,H=D.distance,le=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===hr?le=D.shadow.map.texture:le=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)u+=W.r*q,f+=W.g*q,h+=W.b*q;else if(D.isLightProbe){for(let Z=0;Z<9;Z++)i.probe[Z].addScaledVector(D.sh.coefficients[Z],q);N++}else if(D.isSunLight){let Z=e.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,ie=t.get(D);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=ie,i.sunShadowMap[p]=le;let de=Q.getViewportCount();for(let he=0;he<de;he++)i.sunShadowMatrix[v+he]=Q.getMatrix(he),i.sunShadowCascade[v+he]=Q._cascadeData[he];v+=de,p++}i.sun[d]=Z,d++}else if(D.isDirectionalLight){let Z=e.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,ie=t.get(D);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.directionalShadow[g]=ie,i.directionalShadowMap[g]=le,i.directionalShadowMatrix[g]=D.shadow.matrix,R++}i.directional[g]=Z,g++}else if(D.isSpotLight){let Z=e.get(D);Z.position.setFromMatrixPosition(D.matrixWorld),Z.color.copy(W).multiplyScalar(q),Z.distance=H,Z.coneCos=Math.cos(D.angle),Z.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),Z.decay=D.decay,i.spot[y]=Z;let Q=D.shadow;if(D.map&&(i.spotLightMap[E]=D.map,E++,Q.updateMatrices(D),D.castShadow&&U++),i.spotLightMatrix[y]=Q.matrix,D.castShadow){let ie=t.get(D);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.spotShadow[y]=ie,i.spotShadowMap[y]=le,_++}y++}else if(D.isRectAreaLight){let Z=e.get(D);Z.color.copy(W).multiplyScalar(q),Z.halfWidth.set(D.width*.5,0,0),Z.halfHeight.set(0,D.height*.5,0),i.rectArea[M]=Z,M++}else if(D.isPointLight){let Z=e.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),Z.distance=D.distance,Z.decay=D.decay,D.castShadow){let Q=D.shadow,ie=t.get(D);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,i.pointShadow[m]=ie,i.pointShadowMap[m]=le,i.pointShadowMatrix[m]=D.shadow.matrix,T++}i.point[m]=Z,m++}else if(D.isHemisphereLight){let Z=e.get(D);Z.skyColor.copy(D.color).multiplyScalar(q),Z.groundColor.copy(D.groundColor).multiplyScalar(q),i.hemi[b]=Z,b++}}M>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;let L=i.hash;(L.sunLength!==d||L.directionalLength!==g||L.pointLength!==m||L.spotLength!==y||L.rectAreaLength!==M||L.hemiLength!==b||L.numSunShadows!==p||L.numDirectionalShadows!==R||L.numPointShadows!==T||L.numSpotShadows!==_||L.numSpotMaps!==E||L.numLightProbes!==N)&&(i.sun.length=d,i.directional.length=g,i.spot.length=y,i.rectArea.length=M,i.point.length=m,i.hemi.length=b,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=v,i.sunShadowCascade.length=v,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=T,i.pointShadowMap.length=T,i.pointShadowMatrix.length=T,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+E-U,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=N,L.sunLength=d,L.directionalLength=g,L.pointLength=m,L.spotLength=y,L.rectAreaLength=M,L.hemiLength=b,L.numSunShadows=p,L.numDirectionalShadows=R,L.numPointShadows=T,L.numSpotShadows=_,L.numSpotMaps=E,L.numLightProbes=N,i.version=bC++)}function l(c,u){let f=0,h=0,d=0,p=0,v=0,g=0,m=u.matrixWorldInverse;for(let y=0,M=c.length;y<M;y++){let b=c[y];if(b.isSunLight){let R=i.sun[f];R.direction.setFromMatrixPosition(b.matrixWorld),R.direction.transformDirection(m),f++}else if(b.isDirectionalLight){let R=i.directional[h];R.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),h++}else if(b.isSpotLight){let R=i.spot[p];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(m),R.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),p++}else if(b.isRectAreaLight){let R=i.rectArea[v];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),R.halfWidth.set(b.width*.5,0,0),R.halfHeight.set(0,b.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),v++}else if(b.isPointLight){let R=i.point[d];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(m),d++}else if(b.isHemisphereLight){let R=i.hemi[g];R.direction.setFromMatrixPosition(b.matrixWorld),R.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:i}}function zv(n){let e=new MC(n),t=[],i=[],s=[];function r(f){u.camera=f,t.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):t.push(f)}function a(f){i.push(f)}function l(){e.setup(t),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){e.setupView(t,f)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function wC(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new zv(n),e.set(s,[a])):r>=o.length?(a=new zv(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var EC=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,TC=`uniform sampler2D shadow_pass;
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
}`,AC=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],CC=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],Vv=new bt,al=new G,yp=new G;function RC(n,e,t){let i=new Is,s=new yt,r=new yt,o=new Zt,a=new eu,l=new tu,c={},u=t.maxTextureSize,f={[Fi]:Xn,[Xn]:Fi,[zn]:zn},h=new Di({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new yt},radius:{value:4}},vertexShader:EC,fragmentShader:TC}),d=h.clone();d.defines.HORIZONTAL_PASS=1;let p=new hn;p.setAttribute("position",new pt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new wt(p,h),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ka;let m=this.type;this.render=function(T,_,E){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||T.length===0)return;this.type===Ux&&(Ye("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ka);let U=n.getRenderTarget(),N=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),B=n.state;B.setBlending(Or),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let z=m!==this.type;z&&_.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(W=>W.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,W=T.length;D<W;D++){let q=T[D],H=q.shadow;if(H===void 0){Ye("WebGLShadowMap:",q,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let le=H.getFrameExtents();s.multiply(le),r.copy(H.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,H.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,H.mapSize.y=r.y));let Z=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=Z,H.map===null||z===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===Go){if(q.isPointLight){Ye("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new _i(s.x,s.y,{format:hr,type:ji,minFilter:Wn,magFilter:Wn,generateMipmaps:!1}),H.map.texture.name=q.name+".shadowMap",H.map.depthTexture=new Ls(s.x,s.y,Ki),H.map.depthTexture.name=q.name+".shadowMapDepth",H.map.depthTexture.format=Ps,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=En,H.map.depthTexture.magFilter=En}else q.isPointLight?(H.map=new cl(s.x),H.map.depthTexture=new $a(s.x,Zi)):(H.map=new _i(s.x,s.y),H.map.depthTexture=new Ls(s.x,s.y,Zi)),H.map.depthTexture.name=q.name+".shadowMap",H.map.depthTexture.format=Ps,this.type===Ka?(H.map.depthTexture.compareFunction=Z?cp:lp,H.map.depthTexture.minFilter=Wn,H.map.depthTexture.magFilter=Wn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=En,H.map.depthTexture.magFilter=En);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();q.isPointLight!==!0&&H.updateMatrices(q,E);let ie=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:E.layers;for(let de=0;de<Q;de++){let he=H.getCamera(de);if(q.isPointLight){let ee=H.camera,me=H.matrix,ge=q.distance||ee.far;ge!==ee.far&&(ee.far=ge,ee.updateProjectionMatrix()),al.setFromMatrixPosition(q.matrixWorld),ee.position.copy(al),yp.copy(ee.position),yp.add(AC[de]),ee.up.copy(CC[de]),ee.lookAt(yp),ee.updateMatrixWorld(),me.makeTranslation(-al.x,-al.y,-al.z),Vv.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Vv,ee.coordinateSystem,ee.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,de),n.clear();else{de===0&&(n.setRenderTarget(H.map),n.clear());let ee=H.getViewport(de);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),B.viewport(o)}i=H.getFrustum(de),b(_,E,he,q,ie,this.type)}H.isPointLightShadow!==!0&&this.type===Go&&y(H,E),H.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(U,N,L)};function y(T,_){let E=e.update(v);h.defines.VSM_SAMPLES!==T.blurSamples&&(h.defines.VSM_SAMPLES=T.blurSamples,d.defines.VSM_SAMPLES=T.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),T.mapPass===null?T.mapPass=new _i(s.x,s.y,{format:hr,type:ji}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),h.uniforms.shadow_pass.value=T.map.depthTexture,h.uniforms.resolution.value.set(T.map.width,T.map.height),h.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(_,null,E,h,v,null),d.uniforms.shadow_pass.value=T.mapPass.texture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(_,null,E,d,v,null)}function M(T,_,E,U){let N=null,L=E.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(L!==void 0)N=L;else if(N=E.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let B=N.uuid,z=_.uuid,D=c[B];D===void 0&&(D={},c[B]=D);let W=D[z];W===void 0&&(W=N.clone(),D[z]=W,_.addEventListener("dispose",R)),N=W}if(N.visible=_.visible,N.wireframe=_.wireframe,U===Go?N.side=_.shadowSide!==null?_.shadowSide:_.side:N.side=_.shadowSide!==null?_.shadowSide:f[_.side],N.alphaMap=_.alphaMap,N.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,N.map=_.map,N.clipShadows=_.clipShadows,N.clippingPlanes=_.clippingPlanes,N.clipIntersection=_.clipIntersection,N.displacementMap=_.displacementMap,N.displacementScale=_.displacementScale,N.displacementBias=_.displacementBias,N.wireframeLinewidth=_.wireframeLinewidth,N.linewidth=_.linewidth,E.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let B=n.properties.get(N);B.light=E}return N}function b(T,_,E,U,N,L){if(T.visible===!1)return;if(T.layers.test(N)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&L===Go)&&(!T.frustumCulled||T.intersectsFrustum(i))){T.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,T.matrixWorld);let D=e.update(T),W=T.material;if(Array.isArray(W)){let q=D.groups;for(let H=0,le=q.length;H<le;H++){let Z=q[H],Q=W[Z.materialIndex];if(Q&&Q.visible){let ie=M(T,Q,U,L);T.onBeforeShadow(n,T,_,E,D,ie,Z),n.renderBufferDirect(E,null,D,ie,T,Z),T.onAfterShadow(n,T,_,E,D,ie,Z)}}}else if(W.visible){let q=M(T,W,U,L);T.onBeforeShadow(n,T,_,E,D,q,null),n.renderBufferDirect(E,null,D,q,T,null),T.onAfterShadow(n,T,_,E,D,q,null)}}let z=T.children;for(let D=0,W=z.length;D<W;D++)b(z[D],_,E,U,N,L)}function R(T){T.target.removeEventListener("dispose",R);for(let E in c){let U=c[E],N=T.target.uuid;N in U&&(U[N].dispose(),delete U[N])}}}function PC(n,e){function t(){let O=!1,re=new Zt,ne=null,Ee=new Zt(0,0,0,0);return{setMask:function(xe){ne!==xe&&!O&&(n.colorMask(xe,xe,xe,xe),ne=xe)},setLocked:function(xe){O=xe},setClear:function(xe,Se,Ge,Ze,ce){ce===!0&&(xe*=Ze,Se*=Ze,Ge*=Ze),re.set(xe,Se,Ge,Ze),Ee.equals(re)===!1&&(n.clearColor(xe,Se,Ge,Ze),Ee.copy(re))},reset:function(){O=!1,ne=null,Ee.set(-1,0,0,0)}}}function i(){let O=!1,re=!1,ne=null,Ee=null,xe=null;return{setReversed:function(Se){if(re!==Se){let Ge=e.get("EXT_clip_control");Se?Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.ZERO_TO_ONE_EXT):Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.NEGATIVE_ONE_TO_ONE_EXT),re=Se;let Ze=xe;xe=null,this.setClear(Ze)}},getReversed:function(){return re},setTest:function(Se){Se?ve(n.DEPTH_TEST):Ve(n.DEPTH_TEST)},setMask:function(Se){ne!==Se&&!O&&(n.depthMask(Se),ne=Se)},setFunc:function(Se){if(re&&(Se=mv[Se]),Ee!==Se){switch(Se){case Oc:n.depthFunc(n.NEVER);break;case kc:n.depthFunc(n.ALWAYS);break;case Bc:n.depthFunc(n.LESS);break;case No:n.depthFunc(n.LEQUAL);break;case zc:n.depthFunc(n.EQUAL);break;case Vc:n.depthFunc(n.GEQUAL);break;case Do:n.depthFunc(n.GREATER);break;case Hc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ee=Se}},setLocked:function(Se){O=Se},setClear:function(Se){xe!==Se&&(xe=Se,re&&(Se=1-Se),n.clearDepth(Se))},reset:function(){O=!1,ne=null,Ee=null,xe=null,re=!1}}}function s(){let O=!1,re=null,ne=null,Ee=null,xe=null,Se=null,Ge=null,Ze=null,ce=null;return{setTest:function(ke){O||(ke?ve(n.STENCIL_TEST):Ve(n.STENCIL_TEST))},setMask:function(ke){re!==ke&&!O&&(n.stencilMask(ke),re=ke)},setFunc:function(ke,Ke,Ce){(ne!==ke||Ee!==Ke||xe!==Ce)&&(n.stencilFunc(ke,Ke,Ce),ne=ke,Ee=Ke,xe=Ce)},setOp:function(ke,Ke,Ce){(Se!==ke||Ge!==Ke||Ze!==Ce)&&(n.stencilOp(ke,Ke,Ce),Se=ke,Ge=Ke,Ze=Ce)},setLocked:function(ke){O=ke},setClear:function(ke){ce!==ke&&(n.clearStencil(ke),ce=ke)},reset:function(){O=!1,re=null,ne=null,Ee=null,xe=null,Se=null,Ge=null,Ze=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},f={},h={},d=new WeakMap,p=[],v=null,g=!1,m=null,y=null,M=null,b=null,R=null,T=null,_=null,E=new rt(0,0,0),U=0,N=!1,L=null,B=null,z=null,D=null,W=null,q=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,le=0,Z=n.getParameter(n.VERSION);Z.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(Z)[1]),H=le>=1):Z.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),H=le>=2);let Q=null,ie={},de=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),ee=new Zt().fromArray(de),me=new Zt().fromArray(he);function ge(O,re,ne,Ee){let xe=new Uint8Array(4),Se=n.createTexture();n.bindTexture(O,Se),n.texParameteri(O,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(O,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ge=0;Ge<ne;Ge++)O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,Ee,0,n.RGBA,n.UNSIGNED_BYTE,xe):n.texImage2D(re+Ge,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xe);return Se}let Me={};Me[n.TEXTURE_2D]=ge(n.TEXTURE_2D,n.TEXTURE_2D,1),Me[n.TEXTURE_CUBE_MAP]=ge(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Me[n.TEXTURE_2D_ARRAY]=ge(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Me[n.TEXTURE_3D]=ge(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ve(n.DEPTH_TEST),o.setFunc(No),mn(!1),Ut(Uf),ve(n.CULL_FACE),jt(Or);function ve(O){u[O]!==!0&&(n.enable(O),u[O]=!0)}function Ve(O){u[O]!==!1&&(n.disable(O),u[O]=!1)}function Xe(O,re){return h[O]!==re?(n.bindFramebuffer(O,re),h[O]=re,O===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=re),O===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=re),!0):!1}function De(O,re){let ne=p,Ee=!1;if(O){ne=d.get(re),ne===void 0&&(ne=[],d.set(re,ne));let xe=O.textures;if(ne.length!==xe.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,Ge=xe.length;Se<Ge;Se++)ne[Se]=n.COLOR_ATTACHMENT0+Se;ne.length=xe.length,Ee=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,Ee=!0);Ee&&n.drawBuffers(ne)}function ut(O){return v!==O?(n.useProgram(O),v=O,!0):!1}let at={[kr]:n.FUNC_ADD,[kx]:n.FUNC_SUBTRACT,[Bx]:n.FUNC_REVERSE_SUBTRACT};at[zx]=n.MIN,at[Vx]=n.MAX;let tt={[Hx]:n.ZERO,[Gx]:n.ONE,[Wx]:n.SRC_COLOR,[zf]:n.SRC_ALPHA,[Zx]:n.SRC_ALPHA_SATURATE,[Yx]:n.DST_COLOR,[$x]:n.DST_ALPHA,[Xx]:n.ONE_MINUS_SRC_COLOR,[Vf]:n.ONE_MINUS_SRC_ALPHA,[Jx]:n.ONE_MINUS_DST_COLOR,[qx]:n.ONE_MINUS_DST_ALPHA,[Kx]:n.CONSTANT_COLOR,[jx]:n.ONE_MINUS_CONSTANT_COLOR,[Qx]:n.CONSTANT_ALPHA,[ev]:n.ONE_MINUS_CONSTANT_ALPHA};function jt(O,re,ne,Ee,xe,Se,Ge,Ze,ce,ke){if(O===Or){g===!0&&(Ve(n.BLEND),g=!1);return}if(g===!1&&(ve(n.BLEND),g=!0),O!==Ox){if(O!==m||ke!==N){if((y!==kr||R!==kr)&&(n.blendEquation(n.FUNC_ADD),y=kr,R=kr),ke)switch(O){case Wo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Of:n.blendFunc(n.ONE,n.ONE);break;case kf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Bf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Qe("WebGLState: Invalid blending: ",O);break}else switch(O){case Wo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Of:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case kf:Qe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Bf:Qe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qe("WebGLState: Invalid blending: ",O);break}M=null,b=null,T=null,_=null,E.set(0,0,0),U=0,m=O,N=ke}return}xe=xe||re,Se=Se||ne,Ge=Ge||Ee,(re!==y||xe!==R)&&(n.blendEquationSeparate(at[re],at[xe]),y=re,R=xe),(ne!==M||Ee!==b||Se!==T||Ge!==_)&&(n.blendFuncSeparate(tt[ne],tt[Ee],tt[Se],tt[Ge]),M=ne,b=Ee,T=Se,_=Ge),(Ze.equals(E)===!1||ce!==U)&&(n.blendColor(Ze.r,Ze.g,Ze.b,ce),E.copy(Ze),U=ce),m=O,N=!1}function Ht(O,re){O.side===zn?Ve(n.CULL_FACE):ve(n.CULL_FACE);let ne=O.side===Xn;re&&(ne=!ne),mn(ne),O.blending===Wo&&O.transparent===!1?jt(Or):jt(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let Ee=O.stencilWrite;a.setTest(Ee),Ee&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),_t(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?ve(n.SAMPLE_ALPHA_TO_COVERAGE):Ve(n.SAMPLE_ALPHA_TO_COVERAGE)}function mn(O){L!==O&&(O?n.frontFace(n.CW):n.frontFace(n.CCW),L=O)}function Ut(O){O!==Dx?(ve(n.CULL_FACE),O!==B&&(O===Uf?n.cullFace(n.BACK):O===Fx?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ve(n.CULL_FACE),B=O}function Dn(O){O!==z&&(H&&n.lineWidth(O),z=O)}function _t(O,re,ne){O?(ve(n.POLYGON_OFFSET_FILL),(D!==re||W!==ne)&&(D=re,W=ne,o.getReversed()&&(re=-re,ne=-ne),n.polygonOffset(re,ne))):Ve(n.POLYGON_OFFSET_FILL)}function Cn(O){O?ve(n.SCISSOR_TEST):Ve(n.SCISSOR_TEST)}function rn(O){O===void 0&&(O=n.TEXTURE0+q-1),Q!==O&&(n.activeTexture(O),Q=O)}function gn(O,re,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+q-1:ne=Q);let Ee=ie[ne];Ee===void 0&&(Ee={type:void 0,texture:void 0},ie[ne]=Ee),(Ee.type!==O||Ee.texture!==re)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(O,re||Me[O]),Ee.type=O,Ee.texture=re)}function k(){let O=ie[Q];O!==void 0&&O.type!==void 0&&(n.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Re(){try{n.compressedTexImage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function qe(){try{n.compressedTexImage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function it(){try{n.texSubImage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function we(){try{n.texSubImage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function Bt(){try{n.compressedTexSubImage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function He(){try{n.compressedTexSubImage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function $e(){try{n.texStorage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function P(){try{n.texStorage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function w(){try{n.texImage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function $(){try{n.texImage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function ue(O){return f[O]!==void 0?f[O]:n.getParameter(O)}function oe(O,re){f[O]!==re&&(n.pixelStorei(O,re),f[O]=re)}function ye(O){ee.equals(O)===!1&&(n.scissor(O.x,O.y,O.z,O.w),ee.copy(O))}function _e(O){me.equals(O)===!1&&(n.viewport(O.x,O.y,O.z,O.w),me.copy(O))}function te(O,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let Ee=ne.get(O);Ee===void 0&&(Ee=n.getUniformBlockIndex(re,O.name),n.uniformBlockBinding(re,Ee,Ee),ne.set(O,Ee))}function se(O,re,ne){let xe=c.get(re).get(O);l[xe]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,xe,ne),l[xe]=ne)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},Q=null,ie={},h={},l={},d=new WeakMap,p=[],v=null,g=!1,m=null,y=null,M=null,b=null,R=null,T=null,_=null,E=new rt(0,0,0),U=0,N=!1,L=null,B=null,z=null,D=null,W=null,ee.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ve,disable:Ve,bindFramebuffer:Xe,drawBuffers:De,useProgram:ut,setBlending:jt,setMaterial:Ht,setFlipSided:mn,setCullFace:Ut,setLineWidth:Dn,setPolygonOffset:_t,setScissorTest:Cn,activeTexture:rn,bindTexture:gn,unbindTexture:k,compressedTexImage2D:Re,compressedTexImage3D:qe,texImage2D:w,texImage3D:$,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:$e,texStorage3D:P,texSubImage2D:it,texSubImage3D:we,compressedTexSubImage2D:Bt,compressedTexSubImage3D:He,scissor:ye,viewport:_e,reset:pe}}function IC(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new yt,u=new WeakMap,f=new Set,h,d=new WeakMap,p=new Set,v=new FinalizationRegistry(P=>p.delete(P)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(P,w){return g?new OffscreenCanvas(P,w):ka("canvas")}function y(P,w,$){let ue=1,oe=$e(P);if((oe.width>$||oe.height>$)&&(ue=$/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let ye=Math.floor(ue*oe.width),_e=Math.floor(ue*oe.height);h===void 0&&(h=m(ye,_e));let te=w?m(ye,_e):h;return te.width=ye,te.height=_e,te.getContext("2d").drawImage(P,0,0,ye,_e),Ye("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+ye+"x"+_e+")."),te}else return"data"in P&&Ye("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),P;return P}function M(P){return P.generateMipmaps}function b(P){n.generateMipmap(P)}function R(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(P,w,$,ue,oe,ye=!1){if(P!==null){if(n[P]!==void 0)return n[P];Ye("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let _e;ue&&(_e=e.get("EXT_texture_norm16"),_e||Ye("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=w;if(w===n.RED&&($===n.FLOAT&&(te=n.R32F),$===n.HALF_FLOAT&&(te=n.R16F),$===n.UNSIGNED_BYTE&&(te=n.R8),$===n.UNSIGNED_SHORT&&_e&&(te=_e.R16_EXT),$===n.SHORT&&_e&&(te=_e.R16_SNORM_EXT)),w===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(te=n.R8UI),$===n.UNSIGNED_SHORT&&(te=n.R16UI),$===n.UNSIGNED_INT&&(te=n.R32UI),$===n.BYTE&&(te=n.R8I),$===n.SHORT&&(te=n.R16I),$===n.INT&&(te=n.R32I)),w===n.RG&&($===n.FLOAT&&(te=n.RG32F),$===n.HALF_FLOAT&&(te=n.RG16F),$===n.UNSIGNED_BYTE&&(te=n.RG8),$===n.UNSIGNED_SHORT&&_e&&(te=_e.RG16_EXT),$===n.SHORT&&_e&&(te=_e.RG16_SNORM_EXT)),w===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(te=n.RG8UI),$===n.UNSIGNED_SHORT&&(te=n.RG16UI),$===n.UNSIGNED_INT&&(te=n.RG32UI),$===n.BYTE&&(te=n.RG8I),$===n.SHORT&&(te=n.RG16I),$===n.INT&&(te=n.RG32I)),w===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(te=n.RGB8UI),$===n.UNSIGNED_SHORT&&(te=n.RGB16UI),$===n.UNSIGNED_INT&&(te=n.RGB32UI),$===n.BYTE&&(te=n.RGB8I),$===n.SHORT&&(te=n.RGB16I),$===n.INT&&(te=n.RGB32I)),w===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),$===n.UNSIGNED_INT&&(te=n.RGBA32UI),$===n.BYTE&&(te=n.RGBA8I),$===n.SHORT&&(te=n.RGBA16I),$===n.INT&&(te=n.RGBA32I)),w===n.RGB&&($===n.UNSIGNED_SHORT&&_e&&(te=_e.RGB16_EXT),$===n.SHORT&&_e&&(te=_e.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),w===n.RGBA){let se=ye?Ua:xt.getTransfer(oe);$===n.FLOAT&&(te=n.RGBA32F),$===n.HALF_FLOAT&&(te=n.RGBA16F),$===n.UNSIGNED_BYTE&&(te=se===Pt?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&_e&&(te=_e.RGBA16_EXT),$===n.SHORT&&_e&&(te=_e.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function _(P,w){let $;return P?w===null||w===Zi||w===zr?$=n.DEPTH24_STENCIL8:w===Ki?$=n.DEPTH32F_STENCIL8:w===$o&&($=n.DEPTH24_STENCIL8,Ye("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Zi||w===zr?$=n.DEPTH_COMPONENT24:w===Ki?$=n.DEPTH_COMPONENT32F:w===$o&&($=n.DEPTH_COMPONENT16),$}function E(P,w){return M(P)===!0||P.isFramebufferTexture&&P.minFilter!==En&&P.minFilter!==Wn?Math.log2(Math.max(w.width,w.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?w.mipmaps.length:1}function U(P){let w=new WeakRef(P);i.get(P).__ref=w,p.add(w),v.register(P,w,w)}function N(P){let w=i.get(P).__ref;w!==void 0&&(p.delete(w),v.unregister(w))}function L(P){z(P.target)}function B(P){D(P.target)}function z(P){P.removeEventListener("dispose",L),N(P),q(P),P.isVideoTexture&&u.delete(P),P.isHTMLTexture&&f.delete(P)}function D(P){P.removeEventListener("dispose",B),N(P),le(P)}function W(){for(let P of p){let w=P.deref();w!==void 0&&(w.isRenderTarget===!0?D(w):z(w))}p.clear(),f.clear()}function q(P){let w=i.get(P);if(w.__webglInit===void 0)return;let $=P.source,ue=d.get($);if(ue){let oe=ue[w.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&H(P),Object.keys(ue).length===0&&d.delete($)}i.remove(P)}function H(P){let w=i.get(P);n.deleteTexture(w.__webglTexture);let $=P.source,ue=d.get($);delete ue[w.__cacheKey],o.memory.textures--}function le(P){let w=i.get(P);w.__depthDisposeCallback&&w.__depthDisposeCallback();let $=P.depthTexture;if($&&$.renderTarget===P&&z($),P.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(w.__webglFramebuffer[oe]))for(let ye=0;ye<w.__webglFramebuffer[oe].length;ye++)n.deleteFramebuffer(w.__webglFramebuffer[oe][ye]);else n.deleteFramebuffer(w.__webglFramebuffer[oe]);w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer[oe])}else{if(Array.isArray(w.__webglFramebuffer))for(let oe=0;oe<w.__webglFramebuffer.length;oe++)n.deleteFramebuffer(w.__webglFramebuffer[oe]);else n.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&n.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let oe=0;oe<w.__webglColorRenderbuffer.length;oe++)w.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(w.__webglColorRenderbuffer[oe]);w.__webglDepthRenderbuffer&&n.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let ue=P.textures;for(let oe=0,ye=ue.length;oe<ye;oe++){let _e=i.get(ue[oe]);_e.__webglTexture&&(n.deleteTexture(_e.__webglTexture),o.memory.textures--),i.remove(ue[oe])}i.remove(P)}let Z=0;function Q(){Z=0}function ie(){return Z}function de(P){Z=P}function he(){let P=Z;return P>=s.maxTextures&&Ye("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,P}function ee(P){let w=[];return w.push(P.wrapS),w.push(P.wrapT),w.push(P.wrapR||0),w.push(P.magFilter),w.push(P.minFilter),w.push(P.anisotropy),w.push(P.internalFormat),w.push(P.format),w.push(P.type),w.push(P.generateMipmaps),w.push(P.mipmapsAutoUpdate),w.push(P.premultiplyAlpha),w.push(P.flipY),w.push(P.unpackAlignment),w.push(P.colorSpace),w.join()}function me(P,w){let $=i.get(P);if(P.isVideoTexture&&Bt(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&$.__version!==P.version){let ue=P.image;if(ue===null)Ye("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Ye("WebGLRenderer: Texture marked for update but image is incomplete");else{Ht($,P,w);return}}else P.isExternalTexture&&($.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+w)}function ge(P,w){let $=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&$.__version!==P.version){Ht($,P,w);return}else P.isExternalTexture&&($.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+w)}function Me(P,w){let $=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&$.__version!==P.version){Ht($,P,w);return}t.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+w)}function ve(P,w){let $=i.get(P);if(P.version>0&&$.__version!==P.version){mn($,P,w);return}t.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+w)}let Ve={[Gc]:n.REPEAT,[cs]:n.CLAMP_TO_EDGE,[Wc]:n.MIRRORED_REPEAT},Xe={[En]:n.NEAREST,[iv]:n.NEAREST_MIPMAP_NEAREST,[ja]:n.NEAREST_MIPMAP_LINEAR,[Wn]:n.LINEAR,[mu]:n.LINEAR_MIPMAP_NEAREST,[Ns]:n.LINEAR_MIPMAP_LINEAR},De={[ov]:n.NEVER,[up]:n.ALWAYS,[av]:n.LESS,[lp]:n.LEQUAL,[lv]:n.EQUAL,[cp]:n.GEQUAL,[cv]:n.GREATER,[uv]:n.NOTEQUAL};function ut(P,w){if(w.type===Ki&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===Wn||w.magFilter===mu||w.magFilter===ja||w.magFilter===Ns||w.minFilter===Wn||w.minFilter===mu||w.minFilter===ja||w.minFilter===Ns)&&Ye("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,Ve[w.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,Ve[w.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,Ve[w.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,Xe[w.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,Xe[w.minFilter]),w.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,De[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===En||w.minFilter!==ja&&w.minFilter!==Ns||w.type===Ki&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||i.get(w).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");n.texParameterf(P,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),i.get(w).__currentAnisotropy=w.anisotropy}}}function at(P,w){let $=!1;P.__webglInit===void 0&&(P.__webglInit=!0,w.addEventListener("dispose",L),U(w));let ue=w.source,oe=d.get(ue);oe===void 0&&(oe={},d.set(ue,oe));let ye=ee(w);if(ye!==P.__cacheKey){oe[ye]===void 0&&(oe[ye]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,$=!0),oe[ye].usedTimes++;let _e=oe[P.__cacheKey];_e!==void 0&&(oe[P.__cacheKey].usedTimes--,_e.usedTimes===0&&H(w)),P.__cacheKey=ye,P.__webglTexture=oe[ye].texture}return $}function tt(P,w,$){return Math.floor(Math.floor(P/$)/w)}function jt(P,w,$,ue){let ye=P.updateRanges;if(ye.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,w.width,w.height,$,ue,w.data);else{ye.sort((O,re)=>O.start-re.start);let _e=0;for(let O=1;O<ye.length;O++){let re=ye[_e],ne=ye[O],Ee=re.start+re.count,xe=tt(ne.start,w.width,4),Se=tt(re.start,w.width,4);ne.start<=Ee+1&&xe===Se&&tt(ne.start+ne.count-1,w.width,4)===xe?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++_e,ye[_e]=ne)}ye.length=_e+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),se=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,w.width);for(let O=0,re=ye.length;O<re;O++){let ne=ye[O],Ee=Math.floor(ne.start/4),xe=Math.ceil(ne.count/4),Se=Ee%w.width,Ge=Math.floor(Ee/w.width),Ze=xe,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,Ge),t.texSubImage2D(n.TEXTURE_2D,0,Se,Ge,Ze,ce,$,ue,w.data)}P.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,se),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function Ht(P,w,$){let ue=n.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),w.isData3DTexture&&(ue=n.TEXTURE_3D);let oe=at(P,w),ye=w.source;t.bindTexture(ue,P.__webglTexture,n.TEXTURE0+$);let _e=i.get(ye);if(ye.version!==_e.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let ce=xt.getPrimaries(xt.workingColorSpace),ke=w.colorSpace===Fs?null:xt.getPrimaries(w.colorSpace),Ke=w.colorSpace===Fs||ce===ke?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ke)}t.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment);let se=y(w.image,!1,s.maxTextureSize);se=He(w,se);let pe=r.convert(w.format,w.colorSpace),O=r.convert(w.type),re=T(w.internalFormat,pe,O,w.normalized,w.colorSpace,w.isVideoTexture);ut(ue,w);let ne,Ee=w.mipmaps,xe=w.isVideoTexture!==!0,Se=_e.__version===void 0||oe===!0,Ge=ye.dataReady,Ze=E(w,se);if(w.isDepthTexture)re=_(w.format===Ds,w.type),Se&&(xe?t.texStorage2D(n.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,O,null));else if(w.isDataTexture)if(Ee.length>0){xe&&Se&&t.texStorage2D(n.TEXTURE_2D,Ze,re,Ee[0].width,Ee[0].height);for(let ce=0,ke=Ee.length;ce<ke;ce++)ne=Ee[ce],xe?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,O,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,O,ne.data);w.generateMipmaps=!1}else xe?(Se&&t.texStorage2D(n.TEXTURE_2D,Ze,re,se.width,se.height),Ge&&jt(w,se,pe,O)):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,O,se.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){xe&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ze,re,Ee[0].width,Ee[0].height,se.depth);for(let ce=0,ke=Ee.length;ce<ke;ce++)if(ne=Ee[ce],w.format!==wi)if(pe!==null)if(xe){if(Ge)if(w.layerUpdates.size>0){let Ke=xp(ne.width,ne.height,w.format,w.type);for(let Ce of w.layerUpdates){let st=ne.data.subarray(Ce*Ke/ne.data.BYTES_PER_ELEMENT,(Ce+1)*Ke/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Ce,ne.width,ne.height,1,pe,st)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,ne.data,0,0);else Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?Ge&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,O,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,pe,O,ne.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{xe&&Se&&t.texStorage2D(n.TEXTURE_2D,Ze,re,Ee[0].width,Ee[0].height);for(let ce=0,ke=Ee.length;ce<ke;ce++)ne=Ee[ce],w.format!==wi?pe!==null?xe?Ge&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,O,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,O,ne.data)}else if(w.isDataArrayTexture)if(xe){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ze,re,se.width,se.height,se.depth),Ge)if(w.layerUpdates.size>0){let ce=xp(se.width,se.height,w.format,w.type);for(let ke of w.layerUpdates){let Ke=se.data.subarray(ke*ce/se.data.BYTES_PER_ELEMENT,(ke+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ke,se.width,se.height,1,pe,O,Ke)}w.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,pe,O,se.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,pe,O,se.data);else if(w.isData3DTexture)xe?(Se&&t.texStorage3D(n.TEXTURE_3D,Ze,re,se.width,se.height,se.depth),Ge&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,pe,O,se.data)):t.texImage3D(n.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,pe,O,se.data);else if(w.isFramebufferTexture){if(Se)if(xe)t.texStorage2D(n.TEXTURE_2D,Ze,re,se.width,se.height);else{let ce=se.width,ke=se.height;for(let Ke=0;Ke<Ze;Ke++)t.texImage2D(n.TEXTURE_2D,Ke,re,ce,ke,0,pe,O,null),ce>>=1,ke>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),f.add(w),ce.onpaint=ke=>{let Ke=ke.changedElements;for(let Ce of f)Ke.includes(Ce.image)&&(Ce.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,se);else{let Ke=n.RGBA,Ce=n.RGBA,st=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Ke,Ce,st,se)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ee.length>0){if(xe&&Se){let ce=$e(Ee[0]);t.texStorage2D(n.TEXTURE_2D,Ze,re,ce.width,ce.height)}for(let ce=0,ke=Ee.length;ce<ke;ce++)ne=Ee[ce],xe?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,pe,O,ne):t.texImage2D(n.TEXTURE_2D,ce,re,pe,O,ne);w.generateMipmaps=!1}else if(xe){if(Se){let ce=$e(se);t.texStorage2D(n.TEXTURE_2D,Ze,re,ce.width,ce.height)}Ge&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,O,se)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,O,se);M(w)&&w.mipmapsAutoUpdate===!0&&b(ue),_e.__version=ye.version,w.onUpdate&&w.onUpdate(w)}P.__version=w.version}function mn(P,w,$){if(w.image.length!==6)return;let ue=at(P,w),oe=w.source;t.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+$);let ye=i.get(oe);if(oe.version!==ye.__version||ue===!0){t.activeTexture(n.TEXTURE0+$);let _e=xt.getPrimaries(xt.workingColorSpace),te=w.colorSpace===Fs?null:xt.getPrimaries(w.colorSpace),se=w.colorSpace===Fs||_e===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let pe=w.isCompressedTexture||w.image[0].isCompressedTexture,O=w.image[0]&&w.image[0].isDataTexture,re=[];for(let Ce=0;Ce<6;Ce++)!pe&&!O?re[Ce]=y(w.image[Ce],!0,s.maxCubemapSize):re[Ce]=O?w.image[Ce].image:w.image[Ce],re[Ce]=He(w,re[Ce]);let ne=re[0],Ee=r.convert(w.format,w.colorSpace),xe=r.convert(w.type),Se=T(w.internalFormat,Ee,xe,w.normalized,w.colorSpace),Ge=w.isVideoTexture!==!0,Ze=ye.__version===void 0||ue===!0,ce=oe.dataReady,ke=E(w,ne);ut(n.TEXTURE_CUBE_MAP,w);let Ke;if(w.isDepthTexture){if(Se=_(w.format===Ds,w.type),Ze)if(Ge)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,ne.width,ne.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,ne.width,ne.height,0,Ee,xe,null)}else if(pe){Ge&&Ze&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,Se,ne.width,ne.height);for(let Ce=0;Ce<6;Ce++){Ke=re[Ce].mipmaps;for(let st=0;st<Ke.length;st++){let Wt=Ke[st];w.format!==wi?Ee!==null?Ge?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,st,0,0,Wt.width,Wt.height,Ee,Wt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,st,Se,Wt.width,Wt.height,0,Wt.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,st,0,0,Wt.width,Wt.height,Ee,xe,Wt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,st,Se,Wt.width,Wt.height,0,Ee,xe,Wt.data)}}}else{if(Ke=w.mipmaps,Ge&&Ze){Ke.length>0&&ke++;let Ce=$e(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,Se,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(O){Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,re[Ce].width,re[Ce].height,Ee,xe,re[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,re[Ce].width,re[Ce].height,0,Ee,xe,re[Ce].data);for(let st=0;st<Ke.length;st++){let Zn=Ke[st].image[Ce].image;Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,st+1,0,0,Zn.width,Zn.height,Ee,xe,Zn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,st+1,Se,Zn.width,Zn.height,0,Ee,xe,Zn.data)}}else{Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Ee,xe,re[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,Ee,xe,re[Ce]);for(let st=0;st<Ke.length;st++){let Wt=Ke[st];Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,st+1,0,0,Ee,xe,Wt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,st+1,Se,Ee,xe,Wt.image[Ce])}}}M(w)&&w.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),ye.__version=oe.version,w.onUpdate&&w.onUpdate(w)}P.__version=w.version}function Ut(P,w,$,ue,oe,ye){let _e=r.convert($.format,$.colorSpace),te=r.convert($.type),se=T($.internalFormat,_e,te,$.normalized,$.colorSpace),pe=i.get(w),O=i.get($);if(O.__renderTarget=w,!pe.__hasExternalTextures){let re=Math.max(1,w.width>>ye),ne=Math.max(1,w.height>>ye);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,ye,se,re,ne,w.depth,0,_e,te,null):t.texImage2D(oe,ye,se,re,ne,0,_e,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,P),we(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,oe,O.__webglTexture,0,it(w)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,oe,O.__webglTexture,ye),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Dn(P,w,$){if(n.bindRenderbuffer(n.RENDERBUFFER,P),w.depthBuffer){let ue=w.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,ye=_(w.stencilBuffer,oe),_e=w.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,it(w),ye,w.width,w.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,it(w),ye,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,ye,w.width,w.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,_e,n.RENDERBUFFER,P)}else{let ue=w.textures;for(let oe=0;oe<ue.length;oe++){let ye=ue[oe],_e=r.convert(ye.format,ye.colorSpace),te=r.convert(ye.type),se=T(ye.internalFormat,_e,te,ye.normalized,ye.colorSpace);we(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,it(w),se,w.width,w.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,it(w),se,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,se,w.width,w.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function _t(P,w,$){let ue=w.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,P),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(w.depthTexture);oe.__renderTarget=w;let ye=ue?w.depthTexture.image[0]:w.depthTexture.image;(!oe.__webglTexture||ye.width!==w.width||ye.height!==w.height)&&(ye.width=w.width,ye.height=w.height,w.depthTexture.needsUpdate=!0),ue?ve(w.depthTexture,0):me(w.depthTexture,0);let _e=oe.__webglTexture,te=it(w),se=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,pe=w.depthTexture.format===Ds?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(w.depthTexture.format===Ps)we(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,_e,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,_e,0);else if(w.depthTexture.format===Ds)we(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,_e,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,_e,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Cn(P){let w=i.get(P),$=P.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==P.depthTexture){let ue=P.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),ue){let oe=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),w.__depthDisposeCallback=oe}w.__boundDepthTexture=ue}if(P.depthTexture&&!w.__autoAllocateDepthBuffer)if($)for(let ue=0;ue<6;ue++)_t(w.__webglFramebuffer[ue],P,ue);else P.texture.mipmaps.length>0?_t(w.__webglFramebuffer[0],P,0):_t(w.__webglFramebuffer,P,0);else if($){w.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[ue]),w.__webglDepthbuffer[ue]===void 0)w.__webglDepthbuffer[ue]=n.createRenderbuffer(),Dn(w.__webglDepthbuffer[ue],P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=w.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ye)}}else if(P.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=n.createRenderbuffer(),Dn(w.__webglDepthbuffer,P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=w.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ye)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function rn(P,w,$){let ue=i.get(P);w!==void 0&&Ut(ue.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&Cn(P)}function gn(P){let w=P.texture,$=i.get(P),ue=i.get(w);P.addEventListener("dispose",B),U(P);let oe=P.textures,ye=P.isWebGLCubeRenderTarget===!0,_e=oe.length>1;if(_e||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=w.version,o.memory.textures++),ye){$.__webglFramebuffer=[];for(let te=0;te<6;te++)if(w.mipmaps.length>0){$.__webglFramebuffer[te]=[];for(let se=0;se<w.mipmaps.length;se++)$.__webglFramebuffer[te][se]=n.createFramebuffer()}else $.__webglFramebuffer[te]=n.createFramebuffer()}else{if(w.mipmaps.length>0){$.__webglFramebuffer=[];for(let te=0;te<w.mipmaps.length;te++)$.__webglFramebuffer[te]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(_e)for(let te=0,se=oe.length;te<se;te++){let pe=i.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&we(P)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let se=oe[te];$.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[te]);let pe=r.convert(se.format,se.colorSpace),O=r.convert(se.type),re=T(se.internalFormat,pe,O,se.normalized,se.colorSpace,P.isXRRenderTarget===!0),ne=it(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,$.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),Dn($.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ye){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),ut(n.TEXTURE_CUBE_MAP,w);for(let te=0;te<6;te++)if(w.mipmaps.length>0)for(let se=0;se<w.mipmaps.length;se++)Ut($.__webglFramebuffer[te][se],P,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else Ut($.__webglFramebuffer[te],P,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);M(w)?b(n.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}else if(_e){for(let te=0,se=oe.length;te<se;te++){let pe=oe[te],O=i.get(pe),re=n.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(re=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,O.__webglTexture),ut(re,pe),Ut($.__webglFramebuffer,P,pe,n.COLOR_ATTACHMENT0+te,re,0),M(pe)&&b(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(te=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),ut(te,w),w.mipmaps.length>0)for(let se=0;se<w.mipmaps.length;se++)Ut($.__webglFramebuffer[se],P,w,n.COLOR_ATTACHMENT0,te,se);else Ut($.__webglFramebuffer,P,w,n.COLOR_ATTACHMENT0,te,0);M(w)?b(te):w.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}P.depthBuffer&&Cn(P)}function k(P){let w=P.textures;for(let $=0,ue=w.length;$<ue;$++){let oe=w[$];if(M(oe)&&oe.mipmapsAutoUpdate===!0){let ye=R(P),_e=i.get(oe).__webglTexture;t.bindTexture(ye,_e),b(ye),t.unbindTexture()}}}let Re=[];function qe(P){if(P.samples>0){if(we(P)===!1){let w=P.textures,$=P.width,ue=P.height,oe=n.COLOR_BUFFER_BIT,ye=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=i.get(P),te=w.length>1;if(te)for(let pe=0;pe<w.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,_e.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,_e.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,_e.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,_e.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,_e.__webglFramebuffer);for(let pe=0;pe<w.length;pe++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,_e.__webglColorRenderbuffer[pe]);let O=i.get(w[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,O,0)}n.blitFramebuffer(0,0,$,ue,0,0,$,ue,oe,n.NEAREST),l===!0&&(Re.length=0,Re.push(n.COLOR_ATTACHMENT0+pe),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Re.push(ye),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<w.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,_e.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,_e.__webglColorRenderbuffer[pe]);let O=i.get(w[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,_e.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,O,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,_e.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let w=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[w])}}}function it(P){return Math.min(s.maxSamples,P.samples)}function we(P){let w=i.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Bt(P){let w=o.render.frame;u.get(P)!==w&&(u.set(P,w),P.update())}function He(P,w){let $=P.colorSpace,ue=P.format,oe=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||$!==Fa&&$!==Fs&&(xt.getTransfer($)===Pt?(ue!==wi||oe!==Mi)&&Ye("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qe("WebGLTextures: Unsupported texture color space:",$)),w}function $e(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=de,this.setTexture2D=me,this.setTexture2DArray=ge,this.setTexture3D=Me,this.setTextureCube=ve,this.rebindTextures=rn,this.setupRenderTarget=gn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=qe,this.setupDepthRenderbuffer=Cn,this.setupFrameBufferTexture=Ut,this.useMultisampledRTT=we,this.dispose=W}function LC(n,e){function t(i,s=Fs){let r,o=xt.getTransfer(s);if(i===Mi)return n.UNSIGNED_BYTE;if(i===xu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===vu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Qf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===ep)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Kf)return n.BYTE;if(i===jf)return n.SHORT;if(i===$o)return n.UNSIGNED_SHORT;if(i===gu)return n.INT;if(i===Zi)return n.UNSIGNED_INT;if(i===Ki)return n.FLOAT;if(i===ji)return n.HALF_FLOAT;if(i===tp)return n.ALPHA;if(i===np)return n.RGB;if(i===wi)return n.RGBA;if(i===Ps)return n.DEPTH_COMPONENT;if(i===Ds)return n.DEPTH_STENCIL;if(i===ip)return n.RED;if(i===yu)return n.RED_INTEGER;if(i===hr)return n.RG;if(i===_u)return n.RG_INTEGER;if(i===bu)return n.RGBA_INTEGER;if(i===Qa||i===el||i===tl||i===nl)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Qa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===el)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===tl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===nl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Qa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===el)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===tl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===nl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Su||i===Mu||i===wu||i===Eu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Su)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Mu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===wu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Eu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Tu||i===Au||i===Cu||i===Ru||i===Pu||i===il||i===Iu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Tu||i===Au)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Cu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Ru)return r.COMPRESSED_R11_EAC;if(i===Pu)return r.COMPRESSED_SIGNED_R11_EAC;if(i===il)return r.COMPRESSED_RG11_EAC;if(i===Iu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Lu||i===Nu||i===Du||i===Fu||i===Uu||i===Ou||i===ku||i===Bu||i===zu||i===Vu||i===Hu||i===Gu||i===Wu||i===Xu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Lu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Nu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Du)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Fu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Uu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Ou)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===ku)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Bu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===zu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Vu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Hu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Gu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Wu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Xu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===$u||i===qu||i===Yu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===$u)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===qu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Yu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Ju||i===Zu||i===sl||i===Ku)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Ju)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Zu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===sl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Ku)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===zr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var NC=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,DC=`
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

}`,Tp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new qa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Di({vertexShader:NC,fragmentShader:DC,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new wt(new Ur(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Ap=class extends us{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,h=null,d=null,p=null,v=typeof XRWebGLBinding<"u",g=new Tp,m={},y=t.getContextAttributes(),M=null,b=null,R=[],T=[],_=new yt,E=null,U=null,N=new si;N.viewport=new Zt;let L=new si;L.viewport=new Zt;let B=[N,L],z=new du,D=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=R[ee];return me===void 0&&(me=new Oo,R[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=R[ee];return me===void 0&&(me=new Oo,R[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=R[ee];return me===void 0&&(me=new Oo,R[ee]=me),me.getHandSpace()};function q(ee){let me=T.indexOf(ee.inputSource);if(me===-1)return;let ge=R[me];ge!==void 0&&(ge.update(ee.inputSource,ee.frame,c||o),ge.dispatchEvent({type:ee.type,data:ee.inputSource}))}function H(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",le);for(let ee=0;ee<R.length;ee++){let me=T[ee];me!==null&&(T[ee]=null,R[ee].disconnect(me))}D=null,W=null,g.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(M),d=null,h=null,f=null,s=null,b=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(E),e.setSize(_.width,_.height,!1),U!==null){let ee=U.camera;ee.fov=U.fov,ee.zoom=U.zoom,ee.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Ye("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Ye("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return f===null&&v&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",H),s.addEventListener("inputsourceschange",le),y.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(_),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,Me=null,ve=null;y.depth&&(ve=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=y.stencil?Ds:Ps,Me=y.stencil?zr:Zi);let Ve={colorFormat:t.RGBA8,depthFormat:ve,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(Ve),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),b=new _i(h.textureWidth,h.textureHeight,{format:wi,type:Mi,depthTexture:new Ls(h.textureWidth,h.textureHeight,Me,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let ge={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),b=new _i(d.framebufferWidth,d.framebufferHeight,{format:wi,type:Mi,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function le(ee){for(let me=0;me<ee.removed.length;me++){let ge=ee.removed[me],Me=T.indexOf(ge);Me>=0&&(T[Me]=null,R[Me].disconnect(ge))}for(let me=0;me<ee.added.length;me++){let ge=ee.added[me],Me=T.indexOf(ge);if(Me===-1){for(let Ve=0;Ve<R.length;Ve++)if(Ve>=T.length){T.push(ge),Me=Ve;break}else if(T[Ve]===null){T[Ve]=ge,Me=Ve;break}if(Me===-1)break}let ve=R[Me];ve&&ve.connect(ge)}}function Z(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ge=ee.far;g.texture!==null&&(g.depthNear>0&&(me=g.depthNear),g.depthFar>0&&(ge=g.depthFar)),z.near=L.near=N.near=me,z.far=L.far=N.far=ge,(D!==z.near||W!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),D=z.near,W=z.far),z.layers.mask=ee.layers.mask|6,N.layers.mask=z.layers.mask&-5,L.layers.mask=z.layers.mask&-3;let Me=ee.parent,ve=z.cameras;Z(z,Me);for(let Ve=0;Ve<ve.length;Ve++)Z(ve[Ve],Me);z.projectionMatrix.copy(N.projectionMatrix),z.projectionMatrixInverse.copy(N.projectionMatrixInverse),U===null&&ee.isPerspectiveCamera&&(U={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,z,Me)};function Q(ee,me,ge){ge===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ge.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=$c*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(h===null&&d===null))return l},this.setFoveation=function(ee){l=ee,h!==null&&(h.fixedFoveation=ee),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=ee)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(z)},this.getCameraTexture=function(ee){return m[ee]};let ie=null;function de(ee,me){if(u=me.getViewerPose(c||o),p=me,u!==null){let ge=u.views;d!==null&&(e.setRenderTargetFramebuffer(b,d.framebuffer),e.setRenderTarget(b));let Me=!1;ge.length!==z.cameras.length&&(z.cameras.length=0,Me=!0);for(let De=0;De<ge.length;De++){let ut=ge[De],at=null;if(d!==null)at=d.getViewport(ut);else{let jt=f.getViewSubImage(h,ut);at=jt.viewport,De===0&&(e.setRenderTargetTextures(b,jt.colorTexture,jt.depthStencilTexture),e.setRenderTarget(b))}let tt=B[De];tt===void 0&&(tt=new si,tt.layers.enable(De),tt.viewport=new Zt,B[De]=tt),tt.matrix.fromArray(ut.transform.matrix),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.projectionMatrix.fromArray(ut.projectionMatrix),tt.projectionMatrixInverse.copy(tt.projectionMatrix).invert(),tt.viewport.set(at.x,at.y,at.width,at.height),De===0&&(z.matrix.copy(tt.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),Me===!0&&z.cameras.push(tt)}let ve=s.enabledFeatures;if(ve&&ve.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){f=i.getBinding();let De=f.getDepthInformation(ge[0]);De&&De.isValid&&De.texture&&g.init(De,s.renderState)}if(ve&&ve.includes("camera-access")&&v){e.state.unbindTexture(),f=i.getBinding();for(let De=0;De<ge.length;De++){let ut=ge[De].camera;if(ut){let at=m[ut];at||(at=new qa,m[ut]=at);let tt=f.getCameraImage(ut);at.sourceTexture=tt}}}}for(let ge=0;ge<R.length;ge++){let Me=T[ge],ve=R[ge];Me!==null&&ve!==void 0&&ve.update(Me,me,c||o)}ie&&ie(ee,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),p=null}let he=new Hv;he.setAnimationLoop(de),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},FC=new bt,jv=new et;jv.set(-1,0,0,0,1,0,0,0,1);function UC(n,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,pp(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,y,M,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),f(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),h(g,m),m.isMeshPhysicalMaterial&&d(g,m,b)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),v(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,y,M):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===Xn&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===Xn&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let y=e.get(m),M=y.envMap,b=y.envMapRotation;M&&(g.envMap.value=M,g.envMapRotation.value.setFromMatrix4(FC.makeRotationFromEuler(b)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(jv),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,y,M){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*y,g.scale.value=M*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function f(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function h(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function d(g,m,y){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Xn&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=y.texture,g.transmissionSamplerSize.value.set(y.width,y.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function v(g,m){let y=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(y.matrixWorld),g.nearDistance.value=y.shadow.camera.near,g.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function OC(n,e,t,i){let s={},r={};function o(y,M){let b=M.program;i.uniformBlockBinding(y,b,s[y.id])}function a(y,M){let b=s[y.id];b===void 0&&(p(y),b=l(y),s[y.id]=b,y.addEventListener("dispose",g));let R=M.program;i.updateUBOMapping(y,R);let T=e.render.frame;r[y.id]!==T&&(c(y),r[y.id]=T)}function l(y){let M=n.createBuffer(),b=y.__size,R=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,M),n.bufferData(n.UNIFORM_BUFFER,b,R),n.bindBuffer(n.UNIFORM_BUFFER,null),M}function c(y){let M=s[y.id],b=y.uniforms,R=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,M);for(let T=0,_=b.length;T<_;T++){let E=b[T];if(Array.isArray(E))for(let U=0,N=E.length;U<N;U++)u(E[U],T,U,R);else u(E,T,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(y,M,b,R){if(h(y,M,b,R)===!0){let T=y.__offset,_=y.value;if(Array.isArray(_)){let E=0;for(let U=0;U<_.length;U++){let N=_[U],L=v(N,!0);f(N,y.__data,E),E+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else f(_,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,T,y.__data)}}function f(y,M,b){typeof y=="number"||typeof y=="boolean"?M[b]=y:y.isMatrix3?(M[b]=y.elements[0],M[b+1]=y.elements[1],M[b+2]=y.elements[2],M[b+3]=0,M[b+4]=y.elements[3],M[b+5]=y.elements[4],M[b+6]=y.elements[5],M[b+7]=0,M[b+8]=y.elements[6],M[b+9]=y.elements[7],M[b+10]=y.elements[8],M[b+11]=0):ArrayBuffer.isView(y)?M.set(y.subarray(0,M.length-b),b):y.toArray(M,b)}function h(y,M,b,R){let T=y.value,_=M+"_"+b;if(Array.isArray(T)){R[_]===void 0&&(R[_]=[]);let E=R[_],U=!1;for(let N=0;N<T.length;N++)d(T[N],E,N)===!0&&(U=!0);return U}return d(T,R,_)}function d(y,M,b){if(M[b]===void 0)return typeof y=="number"||typeof y=="boolean"?M[b]=y:ArrayBuffer.isView(y)?M[b]=y.slice():M[b]=y.clone(),!0;{let R=M[b];if(typeof y=="number"||typeof y=="boolean"){if(R!==y)return M[b]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(R.equals(y)===!1)return R.copy(y),!0}}return!1}function p(y){let M=y.uniforms,b=0,R=16;for(let _=0,E=M.length;_<E;_++){let U=Array.isArray(M[_])?M[_]:[M[_]];for(let N=0,L=U.length;N<L;N++){let B=U[N],z=Array.isArray(B.value)?B.value:[B.value],D=Array.isArray(M[_])||Array.isArray(B.value),W=b;for(let H=0,le=z.length;H<le;H++){let Z=z[H],Q=v(Z,D),ie=b%R,de=ie%Q.boundary,he=ie+de;b+=de,he!==0&&R-he<Q.storage&&(b+=R-he),H===0&&(W=b),b+=Q.storage}let q=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new q((b-W)/Float32Array.BYTES_PER_ELEMENT),B.__offset=W}}let T=b%R;return T>0&&(b+=R-T),y.__size=b,y.__cache={},this}function v(y,M){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=16):y.isMatrix3?(b.boundary=16,b.storage=48):y.isMatrix4?(b.boundary=16,b.storage=64):y.isTexture?Ye("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(b.boundary=16,b.storage=y.byteLength):Ye("WebGLRenderer: Unsupported uniform value type.",y),M===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(y){let M=y.target;M.removeEventListener("dispose",g),n.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function m(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:m}}var kC=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ds=null;function BC(){return ds===null&&(ds=new ko(kC,16,16,hr,ji),ds.name="DFG_LUT",ds.minFilter=Wn,ds.magFilter=Wn,ds.wrapS=cs,ds.wrapT=cs,ds.generateMipmaps=!1,ds.needsUpdate=!0),ds}var nh=class{constructor(e={}){let{canvas:t=dv(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:d=Mi}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let v=d,g=new Set([bu,_u,yu]),m=new Set([Mi,Zi,$o,zr,xu,vu]),y=new Uint32Array(4),M=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},R=null,T=null,_=[],E=[],U=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=hs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,L=!1,B=null,z=null,D=null,W=null;this._outputColorSpace=ii;let q=0,H=0,le=null,Z=-1,Q=null,ie=new Zt,de=new Zt,he=null,ee=new rt(0),me=0,ge=t.width,Me=t.height,ve=1,Ve=null,Xe=null,De=new Zt(0,0,ge,Me),ut=new Zt(0,0,ge,Me),at=!1,tt=new Is,jt=new Zc,Ht=!1,mn=!1,Ut=new bt,Dn=new G,_t=new Zt,Cn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},rn=!1;function gn(){return le===null?ve:1}let k=i;function Re(C,V){return t.getContext(C,V)}let qe,it,we,Bt,He,$e,P,w,$,ue,oe,ye,_e,te,se,pe,O,re,ne,Ee,xe,Se,Ge;try{let C={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",Ke,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),k===null){let V="webgl2";if(k=Re(V,C),k===null)throw Re(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ze()}catch(C){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",Ke,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),Qe("WebGLRenderer: "+C.message),C}function Ze(){qe=new ZT(k),qe.init(),xe=new LC(k,qe),it=new BT(k,qe,e,xe),we=new PC(k,qe),it.reversedDepthBuffer&&h&&we.buffers.depth.setReversed(!0),z=k.createFramebuffer(),D=k.createFramebuffer(),W=k.createFramebuffer(),Bt=new QT(k),He=new gC,$e=new IC(k,qe,we,He,it,xe,Bt),P=new JT(N),w=new t1(k),Se=new OT(k,w),$=new KT(k,w,Bt,Se),ue=new tA(k,$,w,Se,Bt),re=new eA(k,it,$e),se=new zT(He),oe=new mC(N,P,qe,it,Se,se),ye=new UC(N,He),_e=new vC,te=new wC(qe),O=new UT(N,P,we,ue,p,l),pe=new RC(N,ue,it),Ge=new OC(k,Bt,it,we),ne=new kT(k,qe,Bt),Ee=new jT(k,qe,Bt),Bt.programs=oe.programs,N.capabilities=it,N.extensions=qe,N.properties=He,N.renderLists=_e,N.shadowMap=pe,N.state=we,N.info=Bt}v!==Mi&&(U=new iA(v,t.width,t.height,a,s,r));let ce=new Ap(N,k);this.xr=ce,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let C=qe.get("WEBGL_lose_context");C&&C.loseContext()},this.forceContextRestore=function(){let C=qe.get("WEBGL_lose_context");C&&C.restoreContext()},this.getPixelRatio=function(){return ve},this.setPixelRatio=function(C){C!==void 0&&(ve=C,this.setSize(ge,Me,!1))},this.getSize=function(C){return C.set(ge,Me)},this.setSize=function(C,V,j=!0){if(ce.isPresenting){Ye("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=C,Me=V,t.width=Math.floor(C*ve),t.height=Math.floor(V*ve),j===!0&&(t.style.width=C+"px",t.style.height=V+"px"),U!==null&&U.setSize(t.width,t.height),this.setViewport(0,0,C,V)},this.getDrawingBufferSize=function(C){return C.set(ge*ve,Me*ve).floor()},this.setDrawingBufferSize=function(C,V,j){ge=C,Me=V,ve=j,t.width=Math.floor(C*j),t.height=Math.floor(V*j),this.setViewport(0,0,C,V)},this.setEffects=function(C){if(v===Mi){Qe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(C){for(let V=0;V<C.length;V++)if(C[V].isOutputPass===!0){Ye("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(C||[])},this.getCurrentViewport=function(C){return C.copy(ie)},this.getViewport=function(C){return C.copy(De)},this.setViewport=function(C,V,j,Y){C.isVector4?De.set(C.x,C.y,C.z,C.w):De.set(C,V,j,Y),we.viewport(ie.copy(De).multiplyScalar(gn()).round())},this.getScissor=function(C){return C.copy(ut)},this.setScissor=function(C,V,j,Y){C.isVector4?ut.set(C.x,C.y,C.z,C.w):ut.set(C,V,j,Y),we.scissor(de.copy(ut).multiplyScalar(gn()).round())},this.getScissorTest=function(){return at},this.setScissorTest=function(C){we.setScissorTest(at=C)},this.setOpaqueSort=function(C){Ve=C},this.setTransparentSort=function(C){Xe=C},this.getClearColor=function(C){return C.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(C=!0,V=!0,j=!0){let Y=0;if(C){let J=!1;if(le!==null){let Te=le.texture.format;J=g.has(Te)}if(J){let Te=le.texture.type,Pe=m.has(Te),Ae=O.getClearColor(),Ie=O.getClearAlpha(),ze=Ae.r,je=Ae.g,ht=Ae.b;Pe?(y[0]=ze,y[1]=je,y[2]=ht,y[3]=Ie,k.clearBufferuiv(k.COLOR,0,y)):(M[0]=ze,M[1]=je,M[2]=ht,M[3]=Ie,k.clearBufferiv(k.COLOR,0,M))}else Y|=k.COLOR_BUFFER_BIT}V&&(Y|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&k.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(C){C.setRenderer(this),B=C},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",Ke,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),O.dispose(),_e.dispose(),te.dispose(),$e.dispose(),He.dispose(),P.dispose(),ue.dispose(),$.dispose(),Se.dispose(),Ge.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",Al),ce.removeEventListener("sessionend",Qi),ms.stop()};function ke(C){C.preventDefault(),dp("WebGLRenderer: Context Lost."),L=!0}function Ke(){dp("WebGLRenderer: Context Restored."),L=!1;let C=Bt.autoReset,V=pe.enabled,j=pe.autoUpdate,Y=pe.needsUpdate,J=pe.type;Ze(),Bt.autoReset=C,pe.enabled=V,pe.autoUpdate=j,pe.needsUpdate=Y,pe.type=J}function Ce(C){Qe("WebGLRenderer: A WebGL context could not be created. Reason: ",C.statusMessage)}function st(C){let V=C.target;V.removeEventListener("dispose",st),Wt(V)}function Wt(C){Zn(C),He.remove(C)}function Zn(C){let V=He.get(C).programs;V!==void 0&&(V.forEach(function(j){oe.releaseProgram(j)}),C.isShaderMaterial&&oe.releaseShaderCache(C))}this.renderBufferDirect=function(C,V,j,Y,J,Te){V===null&&(V=Cn);let Pe=J.isMesh&&J.matrixWorld.determinantAffine()<0,Ae=ua(C,V,j,Y,J);we.setMaterial(Y,Pe);let Ie=j.index,ze=1;if(Y.wireframe===!0){if(Ie=$.getWireframeAttribute(j),Ie===void 0)return;ze=2}let je=j.drawRange,ht=j.attributes.position,Be=je.start*ze,dt=(je.start+je.count)*ze;Te!==null&&(Be=Math.max(Be,Te.start*ze),dt=Math.min(dt,(Te.start+Te.count)*ze)),Ie!==null?(Be=Math.max(Be,0),dt=Math.min(dt,Ie.count)):ht!=null&&(Be=Math.max(Be,0),dt=Math.min(dt,ht.count));let nn=dt-Be;if(nn<0||nn===1/0)return;Se.setup(J,Y,Ae,j,Ie);let It,Lt=ne;if(Ie!==null&&(It=w.get(Ie),Lt=Ee,Lt.setIndex(It)),J.isMesh)Y.wireframe===!0?(we.setLineWidth(Y.wireframeLinewidth*gn()),Lt.setMode(k.LINES)):Lt.setMode(k.TRIANGLES);else if(J.isLine){let Rn=Y.linewidth;Rn===void 0&&(Rn=1),we.setLineWidth(Rn*gn()),J.isLineSegments?Lt.setMode(k.LINES):J.isLineLoop?Lt.setMode(k.LINE_LOOP):Lt.setMode(k.LINE_STRIP)}else J.isPoints?Lt.setMode(k.POINTS):J.isSprite&&Lt.setMode(k.TRIANGLES);if(J.isBatchedMesh)if(qe.get("WEBGL_multi_draw"))Lt.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let Rn=J._multiDrawStarts,Ue=J._multiDrawCounts,xn=J._multiDrawCount,mt=Ie?w.get(Ie).bytesPerElement:1,xs=He.get(Y).currentProgram.getUniforms();for(let vn=0;vn<xn;vn++)xs.setValue(k,"_gl_DrawID",vn),Lt.render(Rn[vn]/mt,Ue[vn])}else if(J.isInstancedMesh)Lt.renderInstances(Be,nn,J.count);else if(j.isInstancedBufferGeometry){let Rn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ue=Math.min(j.instanceCount,Rn);Lt.renderInstances(Be,nn,Ue)}else Lt.render(Be,nn)};function aa(C,V,j,Y){B!==null&&C.isNodeMaterial&&B.setObject(Y,C),Ht===!0&&se.setState(C,j,!1),C.transparent===!0&&C.side===zn&&C.forceSinglePass===!1?(C.side=Xn,C.needsUpdate=!0,es(C,V,Y),C.side=Fi,C.needsUpdate=!0,es(C,V,Y),C.side=zn):es(C,V,Y)}this.compile=function(C,V,j=null){j===null&&(j=C),B!==null&&B.renderStart(C,V,j),T=te.get(j),T.init(V),E.push(T),j.traverseVisible(function(J){J.isLight&&J.layers.test(V.layers)&&(T.pushLight(J),J.castShadow&&T.pushShadow(J))}),C!==j&&C.traverseVisible(function(J){J.isLight&&J.layers.test(V.layers)&&(T.pushLight(J),J.castShadow&&T.pushShadow(J))}),T.setupLights(),B!==null&&B.updateLights(T.state.lightsArray),mn=this.localClippingEnabled,Ht=se.init(this.clippingPlanes,mn),Ht===!0&&se.setGlobalState(this.clippingPlanes,V),B!==null&&pe.render(T.state.shadowsArray,j,V);let Y=new Set;return C.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Te=J.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let Ae=Te[Pe];aa(Ae,j,V,J),Y.add(Ae)}else aa(Te,j,V,J),Y.add(Te)}),T=E.pop(),B!==null&&B.renderEnd(),Y},this.compileAsync=function(C,V,j=null){let Y=this.compile(C,V,j);return new Promise(J=>{function Te(){if(Y.forEach(function(Pe){let Ie=He.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&Y.delete(Pe)}),Y.size===0){J(C);return}setTimeout(Te,10)}qe.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let Yr=null;function Zh(C){Yr&&Yr(C)}function Al(){ms.stop()}function Qi(){ms.start()}let ms=new Hv;ms.setAnimationLoop(Zh),typeof self<"u"&&ms.setContext(self),this.setAnimationLoop=function(C){Yr=C,ce.setAnimationLoop(C),C===null?ms.stop():ms.start()},ce.addEventListener("sessionstart",Al),ce.addEventListener("sessionend",Qi),this.render=function(C,V){if(V!==void 0&&V.isCamera!==!0){Qe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;B!==null&&B.renderStart(C,V);let j=ce.enabled===!0&&ce.isPresenting===!0,Y=U!==null&&(le===null||j)&&U.begin(N,le);if(C.matrixWorldAutoUpdate===!0&&C.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(V),V=ce.getCamera()),C.isScene===!0&&C.onBeforeRender(N,C,V,le),T=te.get(C,E.length),T.init(V),T.state.textureUnits=$e.getTextureUnits(),E.push(T),Ut.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?jt.setFromArrayCamera(V):tt.setFromProjectionMatrix(Ut,Ii,V.reversedDepth),mn=this.localClippingEnabled,Ht=se.init(this.clippingPlanes,mn),R=_e.get(C,_.length),R.init(),_.push(R),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Pe=N.xr.getDepthSensingMesh();Pe!==null&&gs(Pe,V,-1/0,N.sortObjects)}gs(C,V,0,N.sortObjects),R.finish(),B!==null&&B.updateLights(T.state.lightsArray),N.sortObjects===!0&&R.sort(Ve,Xe),rn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,rn&&O.addToRenderList(R,C),this.info.autoReset===!0&&this.info.reset(),Ht===!0&&se.beginShadows();let J=T.state.shadowsArray;if(pe.render(J,C,V),Ht===!0&&se.endShadows(),(Y&&U.hasRenderPass())===!1){let Pe=R.opaque,Ae=R.transmissive;if(T.setupLights(),V.isArrayCamera){let Ie=V.cameras;if(Ae.length>0)for(let ze=0,je=Ie.length;ze<je;ze++){let ht=Ie[ze];ki(Pe,Ae,C,ht)}rn&&O.render(C);for(let ze=0,je=Ie.length;ze<je;ze++){let ht=Ie[ze];la(R,C,ht,ht.viewport)}}else Ae.length>0&&ki(Pe,Ae,C,V),rn&&O.render(C),la(R,C,V)}le!==null&&H===0&&($e.updateMultisampleRenderTarget(le),$e.updateRenderTargetMipmap(le)),Y&&U.end(N),C.isScene===!0&&C.onAfterRender(N,C,V),Se.resetDefaultState(),Z=-1,Q=null,E.pop(),E.length>0?(T=E[E.length-1],$e.setTextureUnits(T.state.textureUnits),Ht===!0&&se.setGlobalState(N.clippingPlanes,T.state.camera)):T=null,_.pop(),_.length>0?R=_[_.length-1]:R=null,B!==null&&B.renderEnd()};function gs(C,V,j,Y){if(C.visible===!1)return;if(C.layers.test(V.layers)){if(C.isGroup)j=C.renderOrder;else if(C.isLOD)C.autoUpdate===!0&&C.update(V);else if(C.isLight)T.pushLight(C),C.castShadow&&T.pushShadow(C);else if(C.isSprite){let Pe=V.isArrayCamera?jt:tt;if(!C.frustumCulled||C.intersectsFrustum(Pe)){Y&&_t.setFromMatrixPosition(C.matrixWorld).applyMatrix4(Ut);let Ae=ue.update(C),Ie=C.material;Ie.visible&&R.push(C,Ae,Ie,j,_t.z,null,V)}}else if(C.isMesh||C.isLine||C.isPoints){let Pe=V.isArrayCamera?jt:tt;if(!C.frustumCulled||C.intersectsFrustum(Pe)){let Ae=ue.update(C),Ie=C.material;if(Y&&(C.boundingSphere!==void 0?(C.boundingSphere===null&&C.computeBoundingSphere(),_t.copy(C.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),_t.copy(Ae.boundingSphere.center)),_t.applyMatrix4(C.matrixWorld).applyMatrix4(Ut)),Array.isArray(Ie)){let ze=Ae.groups;for(let je=0,ht=ze.length;je<ht;je++){let Be=ze[je],dt=Ie[Be.materialIndex];dt&&dt.visible&&R.push(C,Ae,dt,j,_t.z,Be,V)}}else Ie.visible&&R.push(C,Ae,Ie,j,_t.z,null,V)}}}let Te=C.children;for(let Pe=0,Ae=Te.length;Pe<Ae;Pe++)gs(Te[Pe],V,j,Y)}function la(C,V,j,Y){let{opaque:J,transmissive:Te,transparent:Pe}=C;T.setupLightsView(j),Ht===!0&&se.setGlobalState(N.clippingPlanes,j),Y&&we.viewport(ie.copy(Y)),J.length>0&&on(J,V,j),Te.length>0&&on(Te,V,j),Pe.length>0&&on(Pe,V,j),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function ki(C,V,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[Y.id]===void 0){let Be=qe.has("EXT_color_buffer_half_float")||qe.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[Y.id]=new _i(1,1,{generateMipmaps:!0,type:Be?ji:Mi,minFilter:Ns,samples:Math.max(4,it.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:xt.workingColorSpace})}let Te=T.state.transmissionRenderTarget[Y.id],Pe=Y.viewport||ie;Te.setSize(Pe.z*N.transmissionResolutionScale,Pe.w*N.transmissionResolutionScale);let Ae=N.getRenderTarget(),Ie=N.getActiveCubeFace(),ze=N.getActiveMipmapLevel();N.setRenderTarget(Te),N.getClearColor(ee),me=N.getClearAlpha(),me<1&&N.setClearColor(16777215,.5),N.clear(),rn&&O.render(j);let je=N.toneMapping;N.toneMapping=hs;let ht=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),T.setupLightsView(Y),Ht===!0&&se.setGlobalState(N.clippingPlanes,Y),on(C,j,Y),$e.updateMultisampleRenderTarget(Te),$e.updateRenderTargetMipmap(Te),qe.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let dt=0,nn=V.length;dt<nn;dt++){let It=V[dt],{object:Lt,geometry:Rn,material:Ue,group:xn}=It;if(Ue.side===zn&&Lt.layers.test(Y.layers)){let mt=Ue.side;Ue.side=Xn,Ue.needsUpdate=!0,dn(Lt,j,Y,Rn,Ue,xn),Ue.side=mt,Ue.needsUpdate=!0,Be=!0}}Be===!0&&($e.updateMultisampleRenderTarget(Te),$e.updateRenderTargetMipmap(Te))}N.setRenderTarget(Ae,Ie,ze),N.setClearColor(ee,me),ht!==void 0&&(Y.viewport=ht),N.toneMapping=je}function on(C,V,j){let Y=V.isScene===!0?V.overrideMaterial:null;for(let J=0,Te=C.length;J<Te;J++){let Pe=C[J],{object:Ae,geometry:Ie,group:ze}=Pe,je=Pe.material;je.allowOverride===!0&&Y!==null&&(je=Y),Ae.layers.test(j.layers)&&dn(Ae,V,j,Ie,je,ze)}}function dn(C,V,j,Y,J,Te){B!==null&&J.isNodeMaterial&&B.setObject(C,J),C.onBeforeRender(N,V,j,Y,J,Te),C.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,C.matrixWorld),C.normalMatrix.getNormalMatrix(C.modelViewMatrix),J.onBeforeRender(N,V,j,Y,C,Te),J.transparent===!0&&J.side===zn&&J.forceSinglePass===!1?(J.side=Xn,J.needsUpdate=!0,N.renderBufferDirect(j,V,Y,J,C,Te),J.side=Fi,J.needsUpdate=!0,N.renderBufferDirect(j,V,Y,J,C,Te),J.side=zn):N.renderBufferDirect(j,V,Y,J,C,Te),C.onAfterRender(N,V,j,Y,J,Te)}function fn(C){let V=0;for(let j of C)j.texture!==null&&V++;return V}function es(C,V,j){V.isScene!==!0&&(V=Cn);let Y=He.get(C),J=T.state.lights,Te=T.state.shadowsArray,Pe=J.state.version,Ae=oe.getParameters(C,J.state,Te,V,j,T.state.lightProbeGridArray),Ie=oe.getProgramCacheKey(Ae),ze=Y.programs;Y.environment=C.isMeshStandardMaterial||C.isMeshLambertMaterial||C.isMeshPhongMaterial?V.environment:null,Y.fog=V.fog;let je=C.isMeshStandardMaterial||C.isMeshLambertMaterial&&!C.envMap||C.isMeshPhongMaterial&&!C.envMap;Y.envMap=P.get(C.envMap||Y.environment,je),Y.envMapRotation=Y.environment!==null&&C.envMap===null?V.environmentRotation:C.envMapRotation,ze===void 0&&(C.addEventListener("dispose",st),ze=new Map,Y.programs=ze,Y.programVariants=new Map);let ht=ze.get(Ie);if(ht!==void 0){if(Y.currentProgram===ht&&Y.lightsStateVersion===Pe)return ca(C,Ae),ht}else Ae.uniforms=oe.getUniforms(C),B!==null&&C.isNodeMaterial&&B.build(C,j,Ae),C.onBeforeCompile(Ae,N),ht=oe.acquireProgram(Ae,Ie),ze.set(Ie,ht),Y.uniforms=Ae.uniforms;let Be=Y.uniforms;return(!C.isShaderMaterial&&!C.isRawShaderMaterial||C.clipping===!0)&&(Be.clippingPlanes=se.uniform),ca(C,Ae),Y.needsLights=Vs(C),Y.lightsStateVersion=Pe,Y.needsLights&&(Be.ambientLightColor.value=J.state.ambient,Be.lightProbe.value=J.state.probe,Be.sunLights.value=J.state.sun,Be.sunLightShadows.value=J.state.sunShadow,Be.directionalLights.value=J.state.directional,Be.directionalLightShadows.value=J.state.directionalShadow,Be.spotLights.value=J.state.spot,Be.spotLightShadows.value=J.state.spotShadow,Be.rectAreaLights.value=J.state.rectArea,Be.ltc_1.value=J.state.rectAreaLTC1,Be.ltc_2.value=J.state.rectAreaLTC2,Be.pointLights.value=J.state.point,Be.pointLightShadows.value=J.state.pointShadow,Be.hemisphereLights.value=J.state.hemi,Be.sunShadowMatrix.value=J.state.sunShadowMatrix,Be.sunShadowCascade.value=J.state.sunShadowCascade,Be.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Be.spotLightMatrix.value=J.state.spotLightMatrix,Be.spotLightMap.value=J.state.spotLightMap,Be.pointShadowMatrix.value=J.state.pointShadowMatrix),Y.numLightProbeGrids=fn(T.state.lightProbeGridArray),Y.currentProgram=ht,Y.uniformsList=null,ht}function ui(C,V,j,Y,J){let Te=He.get(C),Pe=Te.currentProgram.id+","+Y+","+J,Ae=Te.programVariants.get(Pe);return Ae===void 0?(Ae=es(C,V,j),Te.programVariants.set(Pe,Ae)):(Te.currentProgram=Ae,Te.uniformsList=null,Te.outputColorSpace=Y,Te.toneMapping=J),Ae}function zs(C){if(C.uniformsList===null){let V=C.currentProgram.getUniforms();C.uniformsList=qo.seqWithValue(V.seq,C.uniforms)}return C.uniformsList}function ca(C,V){let j=He.get(C);j.outputColorSpace=V.outputColorSpace,j.batching=V.batching,j.batchingColor=V.batchingColor,j.instancing=V.instancing,j.instancingColor=V.instancingColor,j.instancingMorph=V.instancingMorph,j.skinning=V.skinning,j.morphTargets=V.morphTargets,j.morphNormals=V.morphNormals,j.morphColors=V.morphColors,j.morphTargetsCount=V.morphTargetsCount,j.numClippingPlanes=V.numClippingPlanes,j.numIntersection=V.numClipIntersection,j.vertexAlphas=V.vertexAlphas,j.vertexTangents=V.vertexTangents,j.toneMapping=V.toneMapping}function ua(C,V,j,Y,J){V.isScene!==!0&&(V=Cn),$e.resetTextureUnits();let Te=V.fog,Pe=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?V.environment:null,Ae=le===null?N.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:xt.workingColorSpace,Ie=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,ze=P.get(Y.envMap||Pe,Ie),je=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,ht=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Be=!!j.morphAttributes.position,dt=!!j.morphAttributes.normal,nn=!!j.morphAttributes.color,It=hs;Y.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(It=N.toneMapping);let Lt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,Rn=Lt!==void 0?Lt.length:0,Ue=He.get(Y),xn=T.state.lights;if(Ht===!0&&(mn===!0||C!==Q)){let Nt=C===Q&&Y.id===Z;se.setState(Y,C,Nt)}let mt=!1,xs=!1;Y.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==xn.state.version||J.isBatchedMesh&&Ue.batching===!1||!J.isBatchedMesh&&Ue.batching===!0||J.isBatchedMesh&&Ue.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&Ue.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&Ue.instancing===!1||!J.isInstancedMesh&&Ue.instancing===!0||J.isSkinnedMesh&&Ue.skinning===!1||!J.isSkinnedMesh&&Ue.skinning===!0||J.isInstancedMesh&&Ue.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Ue.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Ue.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Ue.instancingMorph===!1&&J.morphTexture!==null||Ue.envMap!==ze||Y.fog===!0&&Ue.fog!==Te||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==se.numPlanes||Ue.numIntersection!==se.numIntersection)||Ue.vertexAlphas!==je||Ue.vertexTangents!==ht||Ue.morphTargets!==Be||Ue.morphNormals!==dt||Ue.morphColors!==nn||Ue.morphTargetsCount!==Rn||Ue.numLightProbeGrids!==fn(T.state.lightProbeGridArray)?mt=!0:(Ue.outputColorSpace!==Ae||Ue.toneMapping!==It)&&(xs=!0):(mt=!0,Ue.__version=Y.version);let vn=Ue.currentProgram;(mt===!0||xs===!0)&&(vn=xs===!0?ui(Y,V,J,Ae,It):es(Y,V,J),B&&Y.isNodeMaterial&&B.onUpdateProgram(Y,vn,Ue));let Kr=!1,ts=!1,vs=!1,lt=vn.getUniforms(),an=Ue.uniforms;if(we.useProgram(vn.program)&&(Kr=!0,ts=!0,vs=!0),Y.id!==Z&&(Z=Y.id,ts=!0),Kr||Q!==C){we.buffers.depth.getReversed()&&C.reversedDepth!==!0&&(C._reversedDepth=!0,C.updateProjectionMatrix()),lt.setValue(k,"projectionMatrix",C.projectionMatrix),lt.setValue(k,"viewMatrix",C.matrixWorldInverse);let yn=lt.map.cameraPosition;yn!==void 0&&yn.setValue(k,Dn.setFromMatrixPosition(C.matrixWorld)),it.logarithmicDepthBuffer&&lt.setValue(k,"logDepthBufFC",2/(Math.log(C.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&lt.setValue(k,"isOrthographic",C.isOrthographicCamera===!0),Q!==C&&(Q=C,ts=!0,vs=!0)}if(Ue.needsLights&&(xn.state.sunShadowMap.length>0&&lt.setValue(k,"sunShadowMap",xn.state.sunShadowMap,$e),xn.state.directionalShadowMap.length>0&&lt.setValue(k,"directionalShadowMap",xn.state.directionalShadowMap,$e),xn.state.spotShadowMap.length>0&&lt.setValue(k,"spotShadowMap",xn.state.spotShadowMap,$e),xn.state.pointShadowMap.length>0&&lt.setValue(k,"pointShadowMap",xn.state.pointShadowMap,$e)),J.isSkinnedMesh){lt.setOptional(k,J,"bindMatrix"),lt.setOptional(k,J,"bindMatrixInverse");let Nt=J.skeleton;Nt&&(Nt.boneTexture===null&&Nt.computeBoneTexture(),lt.setValue(k,"boneTexture",Nt.boneTexture,$e))}J.isBatchedMesh&&(lt.setOptional(k,J,"batchingTexture"),lt.setValue(k,"batchingTexture",J._matricesTexture,$e),lt.setOptional(k,J,"batchingIdTexture"),lt.setValue(k,"batchingIdTexture",J._indirectTexture,$e),lt.setOptional(k,J,"batchingColorTexture"),J._colorsTexture!==null&&lt.setValue(k,"batchingColorTexture",J._colorsTexture,$e));let Kn=j.morphAttributes;if((Kn.position!==void 0||Kn.normal!==void 0||Kn.color!==void 0)&&re.update(J,j,vn),(ts||Ue.receiveShadow!==J.receiveShadow)&&(Ue.receiveShadow=J.receiveShadow,lt.setValue(k,"receiveShadow",J.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&V.environment!==null&&(an.envMapIntensity.value=V.environmentIntensity),an.dfgLUT!==void 0&&(an.dfgLUT.value=BC()),ts){if(lt.setValue(k,"toneMappingExposure",N.toneMappingExposure),Ue.needsLights&&Jr(an,vs),Te&&Y.fog===!0&&ye.refreshFogUniforms(an,Te),ye.refreshMaterialUniforms(an,Y,ve,Me,T.state.transmissionRenderTarget[C.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let Nt=b,yn=0;for(let $n of T.state.lightProbeGridArray)$n.texture!==null&&(Nt.textures[yn]=$n.texture,Nt.min[yn]=$n.boundingBox.min,Nt.max[yn]=$n.boundingBox.max,Nt.resolution[yn]=$n.resolution,yn++);for(let $n in Nt)Nt[$n].length=yn;an.probesSH.value=Nt.textures,an.probesMin.value=Nt.min,an.probesMax.value=Nt.max,an.probesResolution.value=Nt.resolution}qo.upload(k,zs(Ue),an,$e)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(qo.upload(k,zs(Ue),an,$e),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&lt.setValue(k,"center",J.center),lt.setValue(k,"modelViewMatrix",J.modelViewMatrix),lt.setValue(k,"normalMatrix",J.normalMatrix),lt.setValue(k,"modelMatrix",J.matrixWorld),Y.uniformsGroups!==void 0){let Nt=Y.uniformsGroups;for(let yn=0,$n=Nt.length;yn<$n;yn++){let Cl=Nt[yn];Ge.update(Cl,vn),Ge.bind(Cl,vn)}}return vn}function Jr(C,V){C.ambientLightColor.needsUpdate=V,C.lightProbe.needsUpdate=V,C.sunLights.needsUpdate=V,C.sunLightShadows.needsUpdate=V,C.directionalLights.needsUpdate=V,C.directionalLightShadows.needsUpdate=V,C.pointLights.needsUpdate=V,C.pointLightShadows.needsUpdate=V,C.spotLights.needsUpdate=V,C.spotLightShadows.needsUpdate=V,C.rectAreaLights.needsUpdate=V,C.hemisphereLights.needsUpdate=V}function Vs(C){return C.isMeshLambertMaterial||C.isMeshToonMaterial||C.isMeshPhongMaterial||C.isMeshStandardMaterial||C.isShadowMaterial||C.isShaderMaterial&&C.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(C,V,j){let Y=He.get(C);Y.__autoAllocateDepthBuffer=C.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),He.get(C.texture).__webglTexture=V,He.get(C.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(C,V){let j=He.get(C);j.__webglFramebuffer=V,j.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(C,V=0,j=0){le=C,q=V,H=j;let Y=null,J=!1,Te=!1;if(C){let Ae=He.get(C);if(Ae.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(k.FRAMEBUFFER,Ae.__webglFramebuffer),ie.copy(C.viewport),de.copy(C.scissor),he=C.scissorTest,we.viewport(ie),we.scissor(de),we.setScissorTest(he),Z=-1;return}else if(Ae.__webglFramebuffer===void 0)$e.setupRenderTarget(C);else if(Ae.__hasExternalTextures)$e.rebindTextures(C,He.get(C.texture).__webglTexture,He.get(C.depthTexture).__webglTexture);else if(C.depthBuffer){let je=C.depthTexture;if(Ae.__boundDepthTexture!==je){if(je!==null&&He.has(je)&&(C.width!==je.image.width||C.height!==je.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(C)}}let Ie=C.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Te=!0);let ze=He.get(C).__webglFramebuffer;C.isWebGLCubeRenderTarget?(Array.isArray(ze[V])?Y=ze[V][j]:Y=ze[V],J=!0):C.samples>0&&$e.useMultisampledRTT(C)===!1?Y=He.get(C).__webglMultisampledFramebuffer:Array.isArray(ze)?Y=ze[j]:Y=ze,ie.copy(C.viewport),de.copy(C.scissor),he=C.scissorTest}else ie.copy(De).multiplyScalar(ve).floor(),de.copy(ut).multiplyScalar(ve).floor(),he=at;if(j!==0&&(Y=z),we.bindFramebuffer(k.FRAMEBUFFER,Y)&&we.drawBuffers(C,Y),we.viewport(ie),we.scissor(de),we.setScissorTest(he),J){let Ae=He.get(C.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+V,Ae.__webglTexture,j)}else if(Te){let Ae=V;for(let Ie=0;Ie<C.textures.length;Ie++){let ze=He.get(C.textures[Ie]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Ie,ze.__webglTexture,j,Ae)}}else if(C!==null&&j!==0){let Ae=He.get(C.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Ae.__webglTexture,j)}Z=-1};function Zr(C){let V=He.get(C);return(V.__readFormat!==C.format||V.__readType!==C.type)&&(V.__readFormat=C.format,V.__readType=C.type,V.__formatReadable=it.textureFormatReadable(C.format),V.__typeReadable=it.textureTypeReadable(C.type)),V}this.readRenderTargetPixels=function(C,V,j,Y,J,Te,Pe,Ae=0){if(!(C&&C.isWebGLRenderTarget)){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=He.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){we.bindFramebuffer(k.FRAMEBUFFER,Ie);try{let ze=C.textures[Ae],je=ze.format,ht=ze.type;C.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Ae);let Be=Zr(ze);if(Be.__formatReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=C.width-Y&&j>=0&&j<=C.height-J&&k.readPixels(V,j,Y,J,xe.convert(je),xe.convert(ht),Te)}finally{let ze=le!==null?He.get(le).__webglFramebuffer:null;we.bindFramebuffer(k.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(C,V,j,Y,J,Te,Pe,Ae=0){if(!(C&&C.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=He.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(V>=0&&V<=C.width-Y&&j>=0&&j<=C.height-J){we.bindFramebuffer(k.FRAMEBUFFER,Ie);let ze=C.textures[Ae],je=ze.format,ht=ze.type;C.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Ae);let Be=Zr(ze);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let dt=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,dt),k.bufferData(k.PIXEL_PACK_BUFFER,Te.byteLength,k.STREAM_READ),k.readPixels(V,j,Y,J,xe.convert(je),xe.convert(ht),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let nn=le!==null?He.get(le).__webglFramebuffer:null;we.bindFramebuffer(k.FRAMEBUFFER,nn);let It=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await pv(k,It,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,dt),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Te),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(dt),k.deleteSync(It),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(C,V=null,j=0){let Y=Math.pow(2,-j),J=Math.floor(C.image.width*Y),Te=Math.floor(C.image.height*Y),Pe=V!==null?V.x:0,Ae=V!==null?V.y:0;$e.setTexture2D(C,0),k.copyTexSubImage2D(k.TEXTURE_2D,j,0,0,Pe,Ae,J,Te),we.unbindTexture()},this.copyTextureToTexture=function(C,V,j=null,Y=null,J=0,Te=0){let Pe,Ae,Ie,ze,je,ht,Be,dt,nn,It=C.isCompressedTexture?C.mipmaps[Te]:C.image;if(j!==null)Pe=j.max.x-j.min.x,Ae=j.max.y-j.min.y,Ie=j.isBox3?j.max.z-j.min.z:1,ze=j.min.x,je=j.min.y,ht=j.isBox3?j.min.z:0;else{let lt=Math.pow(2,-J);Pe=Math.floor(It.width*lt),Ae=Math.floor(It.height*lt),C.isDataArrayTexture?Ie=It.depth:C.isData3DTexture?Ie=Math.floor(It.depth*lt):Ie=1,ze=0,je=0,ht=0}Y!==null?(Be=Y.x,dt=Y.y,nn=Y.z):(Be=0,dt=0,nn=0);let Lt=xe.convert(V.format),Rn=xe.convert(V.type),Ue;V.isData3DTexture?($e.setTexture3D(V,0),Ue=k.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?($e.setTexture2DArray(V,0),Ue=k.TEXTURE_2D_ARRAY):($e.setTexture2D(V,0),Ue=k.TEXTURE_2D),we.activeTexture(k.TEXTURE0),we.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,V.flipY),we.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),we.pixelStorei(k.UNPACK_ALIGNMENT,V.unpackAlignment);let xn=we.getParameter(k.UNPACK_ROW_LENGTH),mt=we.getParameter(k.UNPACK_IMAGE_HEIGHT),xs=we.getParameter(k.UNPACK_SKIP_PIXELS),vn=we.getParameter(k.UNPACK_SKIP_ROWS),Kr=we.getParameter(k.UNPACK_SKIP_IMAGES);we.pixelStorei(k.UNPACK_ROW_LENGTH,It.width),we.pixelStorei(k.UNPACK_IMAGE_HEIGHT,It.height),we.pixelStorei(k.UNPACK_SKIP_PIXELS,ze),we.pixelStorei(k.UNPACK_SKIP_ROWS,je),we.pixelStorei(k.UNPACK_SKIP_IMAGES,ht);let ts=C.isDataArrayTexture||C.isData3DTexture,vs=V.isDataArrayTexture||V.isData3DTexture;if(C.isDepthTexture){let lt=He.get(C),an=He.get(V),Kn=He.get(lt.__renderTarget),Nt=He.get(an.__renderTarget);we.bindFramebuffer(k.READ_FRAMEBUFFER,Kn.__webglFramebuffer),we.bindFramebuffer(k.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer);for(let yn=0;yn<Ie;yn++)ts&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,He.get(C).__webglTexture,J,ht+yn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,He.get(V).__webglTexture,Te,nn+yn)),k.blitFramebuffer(ze,je,ze+Pe,je+Ae,Be,dt,Be+Pe,dt+Ae,k.DEPTH_BUFFER_BIT,k.NEAREST);we.bindFramebuffer(k.READ_FRAMEBUFFER,null),we.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(J!==0||C.isRenderTargetTexture||He.has(C)){let lt=He.get(C),an=He.get(V);we.bindFramebuffer(k.READ_FRAMEBUFFER,D),we.bindFramebuffer(k.DRAW_FRAMEBUFFER,W);for(let Kn=0;Kn<Ie;Kn++)ts?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,lt.__webglTexture,J,ht+Kn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,lt.__webglTexture,J),vs?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,an.__webglTexture,Te,nn+Kn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,an.__webglTexture,Te),J!==0?k.blitFramebuffer(ze,je,ze+Pe,je+Ae,Be,dt,Be+Pe,dt+Ae,k.COLOR_BUFFER_BIT,k.NEAREST):vs?k.copyTexSubImage3D(Ue,Te,Be,dt,nn+Kn,ze,je,Pe,Ae):k.copyTexSubImage2D(Ue,Te,Be,dt,ze,je,Pe,Ae);we.bindFramebuffer(k.READ_FRAMEBUFFER,null),we.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else vs?C.isDataTexture||C.isData3DTexture?k.texSubImage3D(Ue,Te,Be,dt,nn,Pe,Ae,Ie,Lt,Rn,It.data):V.isCompressedArrayTexture?k.compressedTexSubImage3D(Ue,Te,Be,dt,nn,Pe,Ae,Ie,Lt,It.data):k.texSubImage3D(Ue,Te,Be,dt,nn,Pe,Ae,Ie,Lt,Rn,It):C.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Te,Be,dt,Pe,Ae,Lt,Rn,It.data):C.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Te,Be,dt,It.width,It.height,Lt,It.data):k.texSubImage2D(k.TEXTURE_2D,Te,Be,dt,Pe,Ae,Lt,Rn,It);we.pixelStorei(k.UNPACK_ROW_LENGTH,xn),we.pixelStorei(k.UNPACK_IMAGE_HEIGHT,mt),we.pixelStorei(k.UNPACK_SKIP_PIXELS,xs),we.pixelStorei(k.UNPACK_SKIP_ROWS,vn),we.pixelStorei(k.UNPACK_SKIP_IMAGES,Kr),Te===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&k.generateMipmap(Ue),we.unbindTexture()},this.initRenderTarget=function(C){He.get(C).__webglFramebuffer===void 0&&$e.setupRenderTarget(C)},this.initTexture=function(C){C.isCubeTexture?$e.setTextureCube(C,0):C.isData3DTexture?$e.setTexture3D(C,0):C.isDataArrayTexture||C.isCompressedArrayTexture?$e.setTexture2DArray(C,0):$e.setTexture2D(C,0),we.unbindTexture()},this.resetState=function(){q=0,H=0,le=null,we.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ii}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=xt._getDrawingBufferColorSpace(e),t.unpackColorSpace=xt._getUnpackColorSpace()}};var hl=1e30,zC="1e20",rh=1e34,Qv="1e32",VC=`
#ifdef COPIES
// Rotations of the copy and of the next one.
attribute vec4 copyRotation;
// 1 for a point of the next copy.
attribute float seam;
#endif
#ifdef DEFORMED
attribute vec3 displacement;
uniform float deformation;
#endif
#ifdef FIELD
attribute float field;
centroid varying float vField;
#endif
#ifdef LIT
centroid varying vec3 vNormal;
centroid varying vec3 vEye;
#endif
#ifdef CUT
uniform vec4 cutPlane;
centroid varying float vCut;
#endif
uniform float bias;

void main() {
  vec3 p = position;
  #ifdef COPIES
  vec2 turn = seam > 0.5 ? copyRotation.zw : copyRotation.xy;
  p = vec3(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y, p.z);
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
`,HC=`
uniform vec3 colour;
uniform float opacity;
#ifdef FIELD
uniform bool useField;
uniform sampler2D scale;
uniform vec2 limits;
uniform vec3 noValue;
centroid varying float vField;
#endif
#ifdef LIT
centroid varying vec3 vNormal;
centroid varying vec3 vEye;
#endif
#ifdef CUT
centroid varying float vCut;
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
    if (vField < ${Qv}) base = vField > ${zC} ? noValue : texture2D(scale, vec2(clamp(fraction, 0.0, 1.0) * 0.99609375 + 0.001953125, 0.5)).rgb;
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
  if (useField && vField < ${Qv}) hatch = 1.0;
  #endif
  base *= hatch;
  #endif
  gl_FragColor = vec4(base, opacity);
  #include <colorspace_fragment>
}
`,Ui=class extends Di{cuttable;constructor(e,t,i={},s){super({vertexShader:VC,fragmentShader:HC,defines:Object.fromEntries(t.map(r=>[r,""])),...i}),this.uniforms={cutPlane:e.cutPlane,deformation:e.deformation,limits:e.limits,scale:e.scale,noValue:e.noValue,pixelRatio:e.pixelRatio,colour:s??{value:new rt},opacity:{value:1},useField:{value:!1},bias:{value:0}},this.cuttable=!t.includes("CAP")&&!t.includes("ON_PLANE")}get colour(){return this.uniforms.colour.value}set alpha(e){this.uniforms.opacity.value=e,this.transparent=e<1}set useField(e){this.uniforms.useField.value=e}set bias(e){this.uniforms.bias.value=e}set cut(e){!this.cuttable||e==="CUT"in this.defines||(e?this.defines.CUT="":delete this.defines.CUT,this.needsUpdate=!0)}};function ey(n){return{cutPlane:{value:new Zt(0,0,1,0)},deformation:{value:0},limits:{value:new yt(0,1)},scale:{value:n},noValue:{value:new rt("#9a9a9a")},lineColour:{value:new rt("#1c2733")},edgeColour:{value:new rt("#1c2733")},pixelRatio:{value:1},lineBias:{value:0}}}function Cp(n,e){let t=e?["COPIES","DEFORMED"]:["COPIES"],i=(r,o)=>new Ui(n,t,{side:r,colorWrite:!1,depthWrite:!1,depthTest:!1,stencilWrite:!0,stencilFunc:ju,stencilFail:o,stencilZFail:o,stencilZPass:o}),s=(r,o,a=t)=>{let l=new Ui(n,a,{depthWrite:!1},r);return l.alpha=o,l.uniforms.bias=n.lineBias,l};return{surface:new Ui(n,e?["COPIES","DEFORMED","FIELD","LIT"]:["COPIES","LIT"]),features:s(n.lineColour,.55),edges:s(n.edgeColour,.3),stencilBack:i(Xn,rp),stencilFront:i(Fi,op),section:new Ui(n,["FIELD","CAP"],{side:zn,polygonOffset:!0,polygonOffsetFactor:1}),sectionEdges:s(n.edgeColour,.34,["ON_PLANE"])}}function ty(n){return new Ui(n,["CAP"],{side:zn,stencilWrite:!0,stencilRef:0,stencilFunc:ap,stencilFail:rl,stencilZFail:rl,stencilZPass:rl})}var oh=class{group=new sn;materials;#e=new hn;#t;#n=null;#i;#s="";markLine=new Dr(new hn,new or({color:"#e07b1f",transparent:!0,depthTest:!1}));constructor(e){let t=new Ui(e,["FIELD"],{side:zn}),i=new Ui(e,["FIELD"],{side:zn,depthFunc:Do,depthWrite:!1});i.alpha=.5,t.useField=i.useField=!0,this.#i=i,this.materials=[t,i];let s=this.materials.map(r=>new wt(this.#e,r));for(let r of s)r.frustumCulled=!1,r.matrixAutoUpdate=!1,this.group.add(r);this.#t=s[1],this.#t.renderOrder=99999,s[0].renderOrder=5,this.markLine.geometry.setAttribute("position",new pt(new Float32Array(12),3)),this.markLine.frustumCulled=!1,this.markLine.matrixAutoUpdate=!1,this.markLine.renderOrder=25e4,this.markLine.visible=!1}mark(e,t){let i=e!==null&&t>=0&&t<e.count;if(!i&&!this.markLine.visible)return!1;if(this.markLine.visible=i,!i)return!0;let s=this.markLine.geometry.getAttribute("position");return s.array.set(e.corners.subarray(12*t,12*t+12)),s.needsUpdate=!0,!0}setBias(e){for(let t of this.materials)t.bias=e;this.#i.bias=0}setBehind(e){this.#t.visible=e}get contacts(){return this.#n}set(e,t,i){if(e===this.#n&&t===this.#s||(this.#n=e,this.#s=t,this.mark(null,-1),this.#e.dispose(),this.group.visible=e!==null,!e))return;let s=[];for(let l=0;l<e.count;l++)e.pressures[l]>0&&i(l)&&s.push(l);let r=new Float32Array(12*s.length),o=new Float32Array(4*s.length),a=new Uint32Array(6*s.length);s.forEach((l,c)=>{r.set(e.corners.subarray(12*l,12*l+12),12*c),o.fill(e.pressures[l],4*c,4*c+4);let u=4*c;a.set([u,u+1,u+2,u,u+2,u+3],6*c)}),this.#e.setAttribute("position",new pt(r,3)),this.#e.setAttribute("field",new pt(o,1)),this.#e.setIndex(new pt(a,1))}dispose(){this.#e.dispose(),this.markLine.geometry.dispose();for(let e of this.materials)e.dispose()}},ny={Flank:0,Edge:1};function fl(n,e,t){return t==="all"||n.zones[e]===(t==="edges"?ny.Edge:ny.Flank)}var GC=1.5;function dl(n,e){return n.pressures.reduce((t,i,s)=>fl(n,s,e)?Math.max(t,i):t,0)}function iy(n){let e=dl(n,"flanks");return e>0&&dl(n,"all")>GC*e}function sy(n){let e=new Map,t=n.corners;for(let i=0;i<n.count;i++){let s=12*i,r=t[s+6]-t[s],o=t[s+7]-t[s+1],a=t[s+8]-t[s+2],l=t[s+9]-t[s+3],c=t[s+10]-t[s+4],u=t[s+11]-t[s+5],f=.5*Math.hypot(o*u-a*c,a*l-r*u,r*c-o*l),h=`${n.parts[2*i]} ${n.parts[2*i+1]}`;e.set(h,(e.get(h)??0)+n.pressures[i]*f)}return e}var ah=class{constructor(e){this.core=e}core;playing=!1;#e=0;toggle(){this.playing?this.stop():this.start()}start(){let e=this.core.positions?.list.length??0;this.playing||e<2||(this.playing=!0,this.play(++this.#e),this.core.changed(!1))}stop(){this.playing&&(this.playing=!1,this.#e++,this.core.changed(!1))}step(e){this.stop();let t=this.next(e,!0);t!==null&&this.core.goTo(t)}next(e,t){let i=this.core.positions?.list.length??0;if(i===0)return null;let s=this.core.state.position+e;return s>=0&&s<i?s:t?(s+i)%i:null}async play(e){let{core:t}=this,i=t.positions?.list.length??0;for(!t.state.animation.loop&&t.state.position===i-1&&await t.goTo(0);e===this.#e;){let s=performance.now()+1e3/Math.max(.1,t.state.animation.speed),r=this.next(1,t.state.animation.loop);if(r===null)break;if(await t.positions?.load(r).catch(()=>null),await new Promise(o=>setTimeout(o,Math.max(0,s-performance.now()))),e!==this.#e)return;await t.goTo(r),await new Promise(requestAnimationFrame)}e===this.#e&&this.stop()}};var ry="CALYXARR";var kt=class extends Error{constructor(t,i){super(`${t}: ${i}`);this.file=t;this.reason=i;this.name="FileError"}file;reason},Jo=class n{constructor(e,t,i,s){this.name=e;this.header=t;this.buffer=i;this.start=s}name;header;buffer;start;static parse(e,t){if(t.byteLength<16)throw new kt(e,`the file is truncated: it has ${t.byteLength} bytes, the header needs 16`);let i=new DataView(t);if(new TextDecoder("latin1").decode(new Uint8Array(t,0,8))!==ry)throw new kt(e,`not an array file: it does not begin with ${ry}`);let r=i.getUint32(8,!0);if(r<5)throw new kt(e,"written by an older version of Calyx: run the model again");if(r>5)throw new kt(e,`version ${r} of the format is not supported; this viewer reads version 5`);let o=i.getUint32(12,!0),a=16+o;if(a>t.byteLength)throw new kt(e,`the file is truncated: it has ${t.byteLength} bytes, the header ends at ${a}`);let l;try{l=JSON.parse(new TextDecoder("utf-8",{fatal:!0}).decode(new Uint8Array(t,16,o)))}catch{throw new kt(e,"the header is not valid JSON")}if(typeof l!="object"||l===null||Array.isArray(l))throw new kt(e,"the header is not a JSON object");return new n(e,l,t,a)}f32(e,t,i){let{offset:s,length:r}=this.locate(e,"f32",t,i);return new Float32Array(this.buffer,s,r)}f64(e,t,i){let{offset:s,length:r}=this.locate(e,"f64",t,i);return s%8===0?new Float64Array(this.buffer,s,r):new Float64Array(this.buffer.slice(s,s+8*r))}u32(e,t,i){let{offset:s,length:r}=this.locate(e,"u32",t,i);return new Uint32Array(this.buffer,s,r)}locate(e,t,i,s){let r=p=>{throw new kt(this.name,`${s}: ${p}`)};if(typeof e!="object"||e===null)return r("the array is missing");let o=e;if(o.type!==t)return r(`the array has type ${String(o.type)}, expected ${t}`);if(o.components!==i)return r(`the array has ${String(o.components)} components, expected ${i}`);let{count:a,offset:l}=o,c=p=>Number.isSafeInteger(p)&&p>=0;if(!c(a)||!c(l))return r("the size or the offset of the array is not a whole number");let u=t==="f64"?8:4;if(l%u!==0)return r(`the offset ${l} is not aligned`);let f=a*i,h=this.start+l+f*u;if(h>this.buffer.byteLength)return r(`the file is truncated: it has ${this.buffer.byteLength} bytes, the array ends at ${h}`);let d=this.start+l;return d%u!==0?r("the header's length is not a multiple of 8"):{offset:d,length:f}}};var lh=256,Rp={viridis:{label:"Viridis",colours:["#440154","#482475","#414487","#355f8d","#2a788e","#21918c","#22a884","#44bf70","#7ad151","#bddf26","#fde725"]},cividis:{label:"Cividis",colours:["#00224e","#123570","#3b496c","#575d6d","#707173","#8a8678","#a59c74","#c3b369","#e1cc55","#fee838"]},turbo:{label:"Turbo",colours:["#30123b","#4145ab","#4675ed","#39a2fc","#1bcfd4","#24eca6","#61fc6c","#a4fc3b","#d1e834","#f3c63a","#fe9b2d","#f36315","#d93806","#b11901","#7a0402"]},grey:{label:"Grey",colours:["#1a1a1a","#f2f2f2"]}},ay=Object.entries(Rp).map(([n,{label:e}])=>({name:n,label:e}));function oy(n){let e=parseInt(n.slice(1),16);return[e>>16&255,e>>8&255,e&255]}function fr(n,e){let{colours:t}=Rp[n]??Rp.viridis,i=Math.min(Math.max(e,0),1)*(t.length-1),s=Math.min(Math.floor(i),t.length-2),r=oy(t[s]),o=oy(t[s+1]),a=i-s;return r.map((l,c)=>Math.round(l+a*(o[c]-l)))}function Hr(n,e){if(e<1)return n;let t=Math.min(Math.max(Math.floor(n*e),0),e-1);return e===1?.5:t/(e-1)}function Gr([n,e,t]){return`rgb(${n} ${e} ${t})`}function ly(n,e,t){let i=n.image.data;for(let r=0;r<lh;r++){let[o,a,l]=fr(e,Hr(r/(lh-1),t));i.set([o,a,l,255],4*r)}let s=t>0?En:Wn;n.minFilter=s,n.magFilter=s,n.needsUpdate=!0}function cy(){let n=new ko(new Uint8Array(4*lh),lh,1,wi);return n.colorSpace=ii,n}var uy=["#7f9db9","#c9a66b","#8fb09a","#b58a9b","#9a95bd","#b9b08a","#76a9ae","#c08f76"],WC={gear:uy,shaft:["#a9adb3","#b7b2aa","#9ea6ac"],bearing:["#8a8f98","#969089"],body:["#b4bcc4","#c0b9ae","#aab7b0"]};function hy(n,e){let t=WC[n]??uy;return t[e%t.length]}var dy={x:[1,0,0],y:[0,1,0],z:[0,0,1]},ch=class{group=new sn;capGeometry=new Ur(2,2);capMatrix=new bt;normal=new G(0,0,1);range=[-1,1];offset=0;#e;#t=new sn;#n=new G;#i=1;#s=new G;constructor(){let e=[-1,-1,0,1,-1,0,1,1,0,-1,1,0],t=new hn;t.setAttribute("position",new un(e,3)),this.#e=new Dr(t,new or({color:"#e07b1f",transparent:!0,opacity:.8}));let i=new rr({color:"#e07b1f",transparent:!0,depthTest:!1}),s=new Fr(.022,.05,20).rotateX(Math.PI/2),r=new wt(s.clone().translate(0,0,.062),i),o=new wt(s.clone().rotateY(Math.PI).translate(0,0,-.062),i),a=new wt(new Ya(.021,20,14),i);this.#t.add(r,o,a);for(let l of this.#t.children)l.renderOrder=3e5;this.group.add(this.#e,this.#t),this.group.visible=!1}setBounds(e,t){this.#n.copy(e),this.#i=t}apply(e,t){let i=typeof e.normal=="string"?dy[e.normal]??dy.z:e.normal;this.normal.set(i[0],i[1],i[2]),this.normal.lengthSq()>0||this.normal.set(0,0,1),this.normal.normalize();let s=this.normal.dot(this.#n);this.range=[s-this.#i,s+this.#i],this.offset=e.offset??s;let r=e.flipped?-1:1;t.set(r*this.normal.x,r*this.normal.y,r*this.normal.z,-r*this.offset),this.group.visible=e.on;let o=this.#n.clone().addScaledVector(this.normal,this.offset-s),a=new Li().setFromUnitVectors(new G(0,0,1),this.normal),l=1.02*this.#i;this.capMatrix.compose(o,a,new G(1.5*l,1.5*l,1)),this.#e.position.copy(o),this.#e.quaternion.copy(a),this.#e.scale.set(.86*l,.86*l,1),this.#t.quaternion.copy(a),this.#t.position.set(.86*l,.86*l,0).applyQuaternion(a).add(o),this.#t.scale.setScalar(l)}get handle(){return this.#t.position}setHighlight(e){for(let t of this.#t.children)t.material.color.set(e?"#ffa648":"#e07b1f")}drag(e,t,i,s,r){let o=.01*this.#i,a=this.#s.copy(this.handle).project(i),l=a.x,c=a.y,u=this.#s.copy(this.handle).addScaledVector(this.normal,o).project(i),f=(u.x-l)*s/2,h=-(u.y-c)*r/2,d=f*f+h*h;return d<.02?-t*o/2:(e*f+t*h)/d*o}};function XC(n,e,t,i,s,r){let o=Math.max(Math.abs(n),Math.abs(e),Math.abs(t),Math.abs(i),Math.abs(s),Math.abs(r));if(!Number.isFinite(o))return[NaN,NaN,NaN];if(o===0)return[0,0,0];let a=(n+e+t)/3,l=(n-e)/o,c=(e-t)/o,u=(t-n)/o,f=(l-u)/3,h=(c-l)/3,d=(u-c)/3,p=i/o,v=s/o,g=r/o,m=(l*l+c*c+u*u)/6+p*p+v*v+g*g;if(m===0)return[a,a,a];let y=f*(h*d-p*p)-g*(g*d-p*v)+v*(g*p-h*v),M=2*m/3,b=Math.SQRT2,R=f*f+g*g+v*v-M,T=h*h+g*g+p*p-M,_=d*d+p*p+v*v-M,E=b*(v*g-f*p),U=b*(p*g-h*v),N=b*(p*v-d*g),L=b*p,B=b*v,z=b*g,D=(f*T-h*R)**2+(f*_-d*R)**2+(h*_-d*T)**2+(f*E-L*R)**2+(f*U-B*R)**2+(f*N-z*R)**2+(h*E-L*T)**2+(h*U-B*T)**2+(h*N-z*T)**2+(d*E-L*_)**2+(d*U-B*_)**2+(d*N-z*_)**2+(L*U-B*E)**2+(L*N-z*E)**2+(B*N-z*U)**2,W=Math.atan2(Math.sqrt(3*D),Math.sqrt(27)*y)/3,q=2*Math.sqrt(m/3)*o,H=2*Math.PI/3;return[a+q*Math.cos(W),a+q*Math.cos(W-H),a+q*Math.cos(W+H)]}function $C(n,e,t,i,s,r){let o=n-e,a=e-t,l=t-n;return Math.sqrt(.5*(o*o+a*a+l*l)+3*(i*i+s*s+r*r))}function Hn(n){return n!=="plain"&&n!=="contact_pressure"}var Ei={plain:{label:"Plain",quantity:"none"},contact_pressure:{label:"Contact pressure",quantity:"stress"},max_principal:{label:"Maximum principal stress",quantity:"stress"},min_principal:{label:"Minimum principal stress",quantity:"stress"},von_mises:{label:"Von Mises stress",quantity:"stress"},stress_error:{label:"Stress error",quantity:"stress"},displacement:{label:"Displacement",quantity:"length"}},Zo={stress_error:"Estimated error of the stresses, as von Mises stress: the difference between the averaged stresses at a node and those of its elements (Zienkiewicz and Zhu). Where it is large, a finer mesh changes the stresses. It is largest at contacts, whose loads are concentrated at nodes: automatic limits leave out the largest values, so that the fillets and the body are visible."},uh="Contact pressure and plain colours show the undeformed shape, because contact cells and plain parts have no elastic displacements. Choose a stress or the displacement to see the deformation, or set a factor.";function Pp(n){return n==="stress_error"?.9:1}function py(n){return n==="min_principal"?"minimum":"maximum"}function qC(n,e,t){if(e==="displacement"){let h=n.displacements;return Math.hypot(h[3*t],h[3*t+1],h[3*t+2])}if(e==="stress_error")return n.stressErrors?.[t]??NaN;let i=n.stresses;if(!i)return NaN;let s=6*t,[r,o,a,l,c,u]=[i[s],i[s+1],i[s+2],i[s+3],i[s+4],i[s+5]];if(e==="von_mises")return $C(r,o,a,l,c,u);let f=XC(r,o,a,l,c,u);return e==="max_principal"?f[0]:f[2]}function my(n){let e={min:1/0,max:-1/0,minIndex:-1,maxIndex:-1};for(let t=0;t<n.length;t++){let i=n[t];i<e.min&&i!==-1/0&&(e.min=i,e.minIndex=t),i>e.max&&i!==1/0&&(e.max=i,e.maxIndex=t)}return e.minIndex<0||e.maxIndex<0?null:e}var fy=new WeakMap;function Ip(n){let e=fy.get(n);if(e)return e;e=new Uint8Array(n.points.length/3);for(let t=0;t<n.triangles.length;t++)e[n.triangles[t]]=1;return fy.set(n,e),e}function gy(n,e){let t=n.shape.points.length/3,i=new Float64Array(t);for(let s=0;s<t;s++)i[s]=qC(n,e,s);return i}function YC(n){return n.match(/[\s.:/]*[^\s.:/]+/g)??[n]}function xy(n){let e=0;for(;n.every(t=>e+1<t.length&&t[e]===n[0][e]);)e++;return e}function vy(n){let e=[...new Set(n)],t=new Map;if(e.length<2)return new Map(e.map(a=>[a,a]));let i=e.map(YC),s=xy(i),r=i.map(a=>a.slice(s).reverse()),o=xy(r);return e.forEach((a,l)=>t.set(a,r[l].slice(o).reverse().join("").replace(/^[\s.:/]+/,""))),t}var Lp=12;function yy(n){return n.length>Lp+4?[n.slice(0,-Lp),n.slice(-Lp)]:["",n]}var JC={Pa:[[1e6,"MPa",1e-6],[1e3,"kPa",.001],[0,"Pa",1]],m:[[1e-4,"mm",1e3],[1e-7,"µm",1e6],[0,"nm",1e9]],N:[[1e3,"kN",.001],[0,"N",1]],"N m":[[1e3,"kN m",.001],[0,"N m",1]],W:[[1e3,"kW",.001],[0,"W",1]],s:[[1,"s",1],[.001,"ms",1e3],[0,"µs",1e6]],rad:[[.1,"rad",1],[1e-4,"mrad",1e3],[0,"µrad",1e6]]},ZC={Pa:[[0,"psi",1/6894.757293168361]],m:[[0,"inch",1/.0254]],N:[[0,"lbf",1/4.4482216152605]],"N m":[[0,"lbf inch",1/.1129848290276167]]},_y=!1;function by(n){_y=/^(inch|ft|foot)_/.test(n)}function Tn(n,e){let t=n.replace("·"," "),i=(_y?ZC[t]:void 0)??JC[t];if(!i)return{symbol:n==="1"?"":n,factor:1};let s=Math.abs(e);if(!(s>0))return{symbol:i[0][1],factor:i[0][2]};let r=i.find(([o])=>s>=o)??i[i.length-1];return{symbol:r[1],factor:r[2]}}function Oi(){return Tn("Pa",0)}var KC="−";function Ft(n,e=4){if(Number.isNaN(n))return"no value";if(n===0)return"0";let t=Math.abs(n),i;if(t>=1e6||t<1e-4)i=n.toExponential(e-1).replace("e+","e");else{let s=Math.max(0,e-1-Math.floor(Math.log10(t)));i=n.toFixed(Math.min(s,12)),i.includes(".")&&(i=i.replace(/\.?0+$/,""))}return i.replaceAll("-",KC)}function Sy(n,e,t=4){if(!Number.isFinite(n))return"no value";let i=Tn(e,n);return`${Ft(n*i.factor,t)} ${i.symbol}`.trim()}function My(n){if(!(n>0)||!Number.isFinite(n))return n;let e=10**Math.floor(Math.log10(n)),t=n/e,i=t>=5?5:t>=2?2:1;return Number((i*e).toPrecision(3))}var wy={bearing:"#2f6fb5",mesh:"#c2502b"},jC=new G(0,1,0),hh=class{group=new sn;labels=[];#e=new zo(1,1,1,20).translate(0,.5,0);#t=new Fr(1,1,24).translate(0,.5,0);#n;#i=new wt(new hn,new rr({transparent:!0}));constructor(e){let t=i=>{let s=new Ui(e,["LIT"],{transparent:!0});return s.colour.set(i),s};this.#n={bearing:t(wy.bearing),mesh:t(wy.mesh)},this.#i.renderOrder=2e5,this.#i.frustumCulled=!1,this.#i.onBeforeRender=i=>i.clearDepth()}set(e,t){this.group.clear(),this.labels=[];let i=({kind:o,parts:a})=>o==="mesh"?t.names[a[0]??-1]:void 0,s=vy(e.flatMap(o=>[o.name,i(o)??""]).filter(o=>o!=="")),r=0;for(let{force:o}of e)r=Math.max(r,Math.hypot(...o));if(r>0){this.group.add(this.#i);for(let o of e){if(o.kind==="bearing"?!t.bearings:!t.meshes)continue;let a=Math.hypot(...o.force);if(!(a>0))continue;let l=t.scale*.5*t.radius*a/r,c=this.arrow(o,l,t.radius*.011);this.group.add(c);let u=new G(...o.force).multiplyScalar(l/a).add(new G(...o.point));if(t.labels){let f=s.get(o.name)??o.name,h=i(o),d=h&&s.get(h),p=`${f?`${f}: `:""}${Sy(a,"N",3)}${d?` on ${d}`:""}`;this.labels.push({text:p,point:u,kind:o.kind,weight:a})}}}}arrow(e,t,i){let s=this.#n[e.kind],r=new sn,o=Math.min(5.2*i,.45*t),a=new wt(this.#e,s);a.scale.set(.55*i,t-o,.55*i);let l=new wt(this.#t,s);l.scale.set(.33*o,o,.33*o),l.position.y=t-o,r.add(a,l),r.position.set(...e.point),r.quaternion.setFromUnitVectors(jC,new G(...e.force).normalize());for(let c of[a,l])c.renderOrder=200001;return r}dispose(){this.#e.dispose(),this.#t.dispose(),this.#i.geometry.dispose(),this.#i.material.dispose();for(let e of Object.values(this.#n))e.dispose()}};var QC=2;function eR(n,e,t){let i=d=>[e[3*d],e[3*d+1],e[3*d+2]],s=(d,p)=>Math.hypot(...i(d).map((v,g)=>v-i(p)[g])),r=new Map,o=(d,p)=>r.get(d)?.push(p)??r.set(d,[p]);for(let d=0;d<n.length;d+=2)o(n[d],n[d+1]),o(n[d+1],n[d]);let a=d=>{let[p,v,...g]=r.get(d);if(p===void 0||v===void 0||g.length>0)return!0;let[m,y,M]=[i(p),i(d),i(v)];return[0,1,2].reduce((R,T)=>R+(y[T]-m[T])*(M[T]-y[T]),0)<tR*s(p,d)*s(d,v)},l=new Set,c=(d,p)=>d<p?`${d} ${p}`:`${p} ${d}`,u=[],f=(d,p)=>{let[v,g,m]=[d,d,p];for(;;){if(l.has(c(g,m)))return;l.add(c(g,m));let y=m===d||a(m);if((y||s(v,m)>=t)&&(u.push(v,m),v=m),y)return;let M=r.get(m).find(b=>b!==g);if(M===void 0)return;[g,m]=[m,M]}},h=[...r.keys()];for(let d of[...h.filter(a),...h])for(let p of r.get(d))f(d,p);return Uint32Array.from(u)}var tR=Math.cos(40*Math.PI/180),nR=-30,Ko=class{constructor(e,t){this.lines=e;this.points=t}lines;points;#e=new Map;index(e){let t=Math.max(nR,Math.ceil(Math.log2(QC/e))),i=this.#e.get(t);return i||this.#e.set(t,i=new pt(eR(this.lines,this.points,2**t),1)),i}};var Ey=new WeakMap;function Wr(n,e){let t=Ey.get(n);if(t?.copies===e)return t.seam;let i=new Int32Array(n.length/3).fill(-1);return e>1&&iR(n,2*Math.PI/e,i),Ey.set(n,{copies:e,seam:i}),i}function iR(n,e,t){let i=0;for(let u=0;u<n.length;u++)i=Math.max(i,Math.abs(n[u]));if(!(i>0))return;let s=i*2e-5,r=u=>Math.round(u/s)+65536,o=(u,f,h)=>(r(u)*131072+r(f))*131072+r(h),a=new Map;for(let u=t.length-1;u>=0;u--)a.set(o(n[3*u],n[3*u+1],n[3*u+2]),u);let[l,c]=[Math.cos(e),Math.sin(e)];for(let u=0;u<t.length;u++){let f=l*n[3*u]+c*n[3*u+1],h=l*n[3*u+1]-c*n[3*u],d=n[3*u+2];for(let p=0;p<8;p++){let[v,g,m]=[p&1?-.25:.25,p&2?-.25:.25,p&4?-.25:.25],y=a.get(o(f+v*s,h+g*s,d+m*s));if(!(y===void 0||y===u)){t[u]=y;break}}}}function jo(n,e){let t=2*Math.PI*(n%e)/e;return[Math.cos(t),Math.sin(t)]}function pl(n,e){return[...jo(n,e),...jo(n+1,e)]}function dh(n,e){let t=n.slice();return e.forEach((i,s)=>{i>=0&&t.set(n.subarray(3*i,3*i+3),3*s)}),t}function Ty(n,e,t,i){let[s,r,o,a]=pl(t,i),l=new Float64Array(n.length);for(let c=0;c<e.length;c++){let u=e[c],f=3*(u<0?c:u),[h,d]=u<0?[s,r]:[o,a];l[3*c]=h*n[f]-d*n[f+1],l[3*c+1]=d*n[f]+h*n[f+1],l[3*c+2]=n[f+2]}return l}function Ay(n,e,t,i){t.forEach((s,r)=>{if(!(s<0))for(let o=0;o<3;o++){let a=i*n[3*r+o]+(1-i)*e[3*s+o];n[3*r+o]=e[3*s+o]=a}})}var sR=1e5,rR=["gear","shaft","bearing","body"];function ml(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)?n:null}function Dp(n){return Array.isArray(n)?n:[]}function Fp(n,e,t,i){for(let s=0;s<t.length;s++)if(t[s]>=i)throw new kt(n,`${e}: index ${t[s]} exceeds the ${i} points`)}function Py(n){let e=Jo.parse("parts.bin",n);if(!Array.isArray(e.header.parts))throw new kt(e.name,"the list of parts is missing");let t=e.header.parts.map((i,s)=>{let r=ml(i);if(!r)throw new kt(e.name,`part ${s} is not an object`);let o=typeof r.name=="string"?r.name:`part ${s}`,a=Number(r.copies??1);if(!Number.isInteger(a)||a<1||a>sR)throw new kt(e.name,`${o}: the number of copies is not valid`);let l=e.f32(r.points,3,`${o}, points`),c=e.u32(r.triangles,3,`${o}, triangles`),u=r.edges?e.u32(r.edges,2,`${o}, edges`):new Uint32Array;Fp(e.name,`${o}, triangles`,c,l.length/3),Fp(e.name,`${o}, edges`,u,l.length/3);let f=rR.includes(String(r.kind))?r.kind:"body",h=Number(r.without_mesh??0);if(!Number.isInteger(h)||h<0||3*h>c.length)throw new kt(e.name,`${o}: the number of triangles without a mesh is not valid`);let d=r.with_outer?e.f32(r.with_outer,1,`${o}, shares of the outer ring`):null;if(d&&3*d.length!==l.length)throw new kt(e.name,`${o}: the shares of the outer ring do not fit the points`);return{index:s,name:o,kind:f,copies:a,withoutMesh:h,withOuter:d,open:r.open===!0,points:l,triangles:c,edges:u}});return{model:String(e.header.model??""),units:String(e.header.units??""),parts:t}}function Np(n){if(!Array.isArray(n)||n.length!==3)return null;let e=n.map(t=>typeof t=="number"?t:NaN);return e.every(Number.isFinite)?e:null}function oR(n,e){let t=ml(n),i=Np(t?.point),s=Np(t?.force);return!t||!i||!s?null:{kind:t.kind==="mesh"?"mesh":"bearing",name:String(t.name??""),point:i,force:s,moment:Np(t.moment)??[0,0,0],parts:Dp(t.parts).filter(r=>typeof r=="number"&&r>=0&&r<e)}}function aR(n,e){let t=ml(e);if(!t)return null;let i=n.f32(t.corners,12,"contacts, corners"),s=n.f32(t.pressures,1,"contacts, pressures"),r=n.u32(t.parts,2,"contacts, parts"),o=n.u32(t.teeth,2,"contacts, teeth"),a=n.u32(t.zones,1,"contacts, zones"),l=n.u32(t.surfaces,2,"contacts, surfaces"),c=s.length,u=[r,o,l].every(({length:f})=>f===2*c);if(i.length!==12*c||a.length!==c||!u)throw new kt(n.name,"contacts: the arrays have different lengths");return c>0?{count:c,corners:i,pressures:s,zones:a,parts:r,teeth:o,surfaces:l}:null}var Cy=new WeakMap;function gl({shape:n,copy:e,copies:t}){let i=Cy.get(n);i||Cy.set(n,i=new Map);let s=i.get(e);return s||i.set(e,s=Ty(n.points,Wr(n.points,t),e,t)),s}function Us(n,e,t){let i=gl(n),s=n.displacements,r=3*e;return[i[r]+t*s[r],i[r+1]+t*s[r+1],i[r+2]+t*s[r+2]]}function Iy(n,e){let t=Jo.parse(n,e),{header:i}=t,s=t.f32(i.points,3,"points"),r=(a,l,c)=>{if(!c&&!i[a])return new Uint32Array;let u=t.u32(i[a],l,a);return Fp(n,a,u,s.length/3),u},o=i.extruded===!0;if(o&&s.length%6!==0)throw new kt(n,"points: an extruded mesh needs an even number of them");return{name:n,open:i.open===!0,extruded:o,points:s,triangles:r("triangles",3,!0),edges:r("edges",2,!1),tetrahedra:r("tetrahedra",4,!1),wedges:r("wedges",6,!1),hexahedra:r("hexahedra",8,!1)}}var lR=/^mesh-[0-9A-Za-z_-]+\.bin$/;async function cR(n,e,t,i,s){let r=ml(e),o=i[Number(r?.part)];if(!r||!o)throw new kt(n.name,`mesh ${t}: the part does not exist`);let a=`mesh of ${o.name}`,l=Number(r.copy??0);if(!Number.isInteger(l)||l<0||l>=o.copies)throw new kt(n.name,`${a}: the copy does not exist`);let c=String(r.mesh);if(!lR.test(c))throw new kt(n.name,`${a}: the name of the mesh is not valid`);let u=await s(c),f=(g,m,y)=>{let M=`${a}, ${g.replace("_"," ")}`;return u.extruded?hR(n.f32(r[g],y.length,M),m,y):n.f32(r[g],m,M)},h=f("displacements",3,[0,1]),d=r.stresses?f("stresses",6,[0,1,2,5]):null,p=r.stress_errors?f("stress_errors",1,[0]):null,v=u.points.length/3;if(h.length!==3*v||d&&d.length!==6*v||p&&p.length!==v)throw new kt(n.name,`${a}: the values do not fit the ${v} points of ${c}`);return{part:o.index,copy:l,copies:o.copies,shape:u,displacements:h,stresses:d,stressErrors:p}}function uR(n,e){let t=[...n];for(let{index:i,copies:s}of e){let r=n.find(({part:a})=>a===i);if(!r||s===1)continue;let o=new Map(n.filter(({part:a})=>a===i).map(a=>[a.copy,a]));for(let a=0;a<s;a++){if(o.has(a))continue;let l=new Float32Array(r.shape.points.length),c={part:i,copy:a,copies:s,shape:r.shape,displacements:l,stresses:null,stressErrors:null};o.set(a,c),t.push(c)}for(let[a,l]of o){let c=o.get((a+1)%s);if(c.shape!==l.shape)continue;let[u,f]=[l,c].map(h=>n.includes(h));Ay(l.displacements,c.displacements,Wr(l.shape.points,s),u===f?.5:u?1:0)}}return t}function hR(n,e,t){let i=n.length/t.length,s=new Float32Array(2*e*i);for(let r=0;r<i;r++)t.forEach((o,a)=>{s[e*r+o]=n[t.length*r+a]});return s.copyWithin(e*i,0,e*i),s}var Ry=new WeakMap;function dR(n){let e=Ry.get(n);if(!e){let t=new Uint32Array,{open:i,points:s,triangles:r,edges:o}=n;e={name:`part ${n.index}`,open:i,extruded:!1,points:s,triangles:r,edges:o,tetrahedra:t,wedges:t,hexahedra:t},Ry.set(n,e)}return e}function fR(n,e,t){let i=ml(e);if(!i)return[];let s=n.u32(i.parts,1,"motions, parts"),r=n.f32(i.at,3,"motions, reference points"),o=n.f32(i.motions,12,"motions");if(r.length!==3*s.length||o.length!==12*s.length)throw new kt(n.name,"motions: the arrays have different lengths");return Array.from(s,(a,l)=>{let c=t[a];if(!c||c.copies!==1)throw new kt(n.name,"motions: the part does not exist");let[u,f]=[o.subarray(12*l,12*l+6),o.subarray(12*l+6,12*l+12)],h=new Float32Array(c.points.length);for(let d=0;d<c.points.length/3;d++){let p=c.withOuter?.[d]??0,[v,g,m,y,M,b]=Array.from(u,(E,U)=>E+p*(f[U]-E)),[R,T,_]=[0,1,2].map(E=>c.points[3*d+E]-r[3*l+E]);h.set([v+M*_-b*T,g+b*R-y*_,m+y*T-M*R],3*d)}return{part:a,copy:0,copies:1,shape:dR(c),displacements:h,stresses:null,stressErrors:null}})}async function Ly(n,e,t,i){let s=Jo.parse(n,e),{header:r}=s,o=s.f64(r.poses,12,"poses");if(o.length!==12*t.length)throw new kt(n,`${o.length/12} poses for ${t.length} parts; the files are from different runs`);let a="",l=u=>i(u).catch(f=>{throw a=f instanceof Error?f.message:String(f),new fh(a)}),c=await Promise.all(Dp(r.meshes).map((u,f)=>cR(s,u,f,t,l).catch(h=>{if(h instanceof fh)return null;throw h})));return{position:Number(r.position??0),time:Number(r.time??0),poses:o,contacts:aR(s,r.contacts),forces:Dp(r.forces).map(u=>oR(u,t.length)).filter(u=>u!==null),meshes:[...uR(c.filter(u=>u!==null),t),...fR(s,r.motions,t)],bytes:e.byteLength,problem:a}}function ph({meshes:n}){return n.some(({stresses:e})=>e!==null)}var fh=class extends Error{};function Dy({tetrahedra:n,wedges:e,hexahedra:t}){return n.length+e.length+t.length>0}var pR=[[0,1,2],[3,4,5],[0,1,4,3],[1,2,5,4],[2,0,3,5]],mR=[[0,1,2,3],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]];function gR(n,e,t,i,s){let r=0;for(let l=1;l<n.length;l++)e[n[l]]<e[n[r]]&&(r=l);let o=t.map(l=>l.reduce((c,u)=>c|1<<u,0)),a=(...l)=>{let c=l.reduce((u,f)=>u|1<<f,0);return o.some(u=>(u&c)===c)};for(let l of t){if(l.includes(r))continue;let c=0;l.forEach((u,f)=>c=e[n[u]]<e[n[l[c]]]?f:c);for(let u=1;u+1<l.length;u++){let[f,h,d]=[l[c],l[(c+u)%l.length],l[(c+u+1)%l.length]];i.push(n[r],n[f],n[h],n[d]),s.push(1|(a(r,h,d)?2:0)|(a(r,f,d)?4:0)|(a(r,f,h)?8:0))}}}var Ny=new WeakMap;function Fy(n,e){let t=Ny.get(n);if(t)return t;let i=xR(n,e),s=[],r=[];for(let[c,u,f]of[[n.wedges,6,pR],[n.hexahedra,8,mR]])for(let h=0;h<c.length;h+=u)gR(c.subarray(h,h+u),i,f,s,r);let{tetrahedra:o}=n,a=new Uint32Array(o.length+s.length);a.set(o),a.set(s,o.length);let l=new Uint8Array(a.length/4).fill(15);return l.set(r,o.length/4),t={nodes:a,borders:l},Ny.set(n,t),t}function xR(n,e){return Float64Array.from(Wr(n.points,e),(t,i)=>t<0?i:t+.5)}var vR=1e-13,gh=class{points=new Float32Array(9*1024);values=new Float32Array(3*1024);sources=new Uint32Array(1024);count=0;edges=new Float32Array(6*2048);edgeCount=0;#e=new Float64Array;#t=[];#n=new Float64Array(12);#i=new Float64Array(4);compute(e,t,i,s,r,o){let{nodes:a,borders:l}=Fy(e.shape,e.copies),c=this.measure(e,i,s);this.count=0,this.edgeCount=0;for(let u=0;u<a.length;u+=4){let f=(c[a[u]]<0?1:0)|(c[a[u+1]]<0?2:0)|(c[a[u+2]]<0?4:0)|(c[a[u+3]]<0?8:0);if(f===0||f===15)continue;let h=r?l[u/4]:0,d=yR[f],p=d.length/3;for(let v=0;v<p;v++)this.cross(e,t,s,o,a[u+d[3*v]],a[u+d[3*v+1]],v);this.push(u/4,0,1,2),p===4&&this.push(u/4,0,2,3);for(let v=0;h&&v<p;v++)h&1<<d[3*v+2]&&this.pushEdge(v,(v+1)%p)}}measure(e,[t,i,s,r],o){let a=this.#t=gl(e),l=e.displacements,c=a.length/3;this.#e.length<c&&(this.#e=new Float64Array(c));let u=this.#e;for(let f=0,h=0;f<c;f++,h+=3)u[f]=t*(a[h]+o*l[h])+i*(a[h+1]+o*l[h+1])+s*(a[h+2]+o*l[h+2])+r;return u}cross(e,t,i,s,r,o,a){let l=this.#t,c=e.displacements,u=this.#e[r],f=u/(u-this.#e[o]),h=3*r,d=3*o;for(let v=0;v<3;v++){let g=l[h+v]+i*c[h+v];this.#n[3*a+v]=g+f*(l[d+v]+i*c[d+v]-g)}let p=t?t[r]+f*(t[o]-t[r]):NaN;this.#i[a]=Number.isFinite(p)?p:s}push(e,t,i,s){this.count===this.sources.length&&(this.points=mh(this.points,Float32Array),this.values=mh(this.values,Float32Array),this.sources=mh(this.sources,Uint32Array));let r=this.count++,o=this.#n;this.sources[r]=e;for(let a=0;a<3;a++){let l=a===0?t:a===1?i:s;this.values[3*r+a]=this.#i[l];for(let c=0;c<3;c++)this.points[9*r+3*a+c]=o[3*l+c]}}pushEdge(e,t){6*this.edgeCount===this.edges.length&&(this.edges=mh(this.edges,Float32Array));let i=6*this.edgeCount++;for(let s=0;s<3;s++)this.edges[i+s]=this.#n[3*e+s],this.edges[i+3+s]=this.#n[3*t+s]}find(e,t,i,s){let r=[Math.abs(s[0]),Math.abs(s[1]),Math.abs(s[2])],o=r[0]>=r[1]&&r[0]>=r[2]?0:r[1]>=r[2]?1:2,[a,l]=o===0?[1,2]:o===1?[2,0]:[0,1],c=[e,t,i],[u,f]=[c[a],c[l]];for(let h=0;h<this.count;h++){let d=9*h,{points:p}=this,[v,g]=[p[d+a]-u,p[d+l]-f],[m,y]=[p[d+3+a]-u,p[d+3+l]-f],[M,b]=[p[d+6+a]-u,p[d+6+l]-f],R=v*y-g*m,T=m*b-y*M,_=M*g-b*v;if(!(Math.abs(R+T+_)<=vR*(v*v+g*g+m*m+y*y+M*M+b*b))&&(R>=0&&T>=0&&_>=0||R<=0&&T<=0&&_<=0))return h}return-1}};function mh(n,e){let t=new e(2*n.length);return t.set(n),t}var yR=Array.from({length:16},(n,e)=>{let t=[0,1,2,3].filter(c=>e&1<<c),i=[0,1,2,3].filter(c=>!(e&1<<c));if(t.length===2&&i.length===2){let[c,u,f,h]=[t[0],t[1],i[0],i[1]];return[c,f,u,c,h,f,u,h,c,u,f,h]}let[s,r]=t.length===1?[t[0],i]:[i[0],t];if(r.length!==3)return[];let[o,a,l]=r;return[s,o,l,s,a,o,s,l,a]});function Uy(n,e,t,i){let s=Fy(n.shape,n.copies).nodes,r=[0,1,2,3].map(f=>s[4*e+f]),o=r.map(f=>Us(n,f,t)),a=(f,h)=>[h[0]-f[0],h[1]-f[1],h[2]-f[2]],l=(f,h,d,p)=>{let[v,g,m]=[a(f,h),a(f,d),a(f,p)];return v[0]*(g[1]*m[2]-g[2]*m[1])+v[1]*(g[2]*m[0]-g[0]*m[2])+v[2]*(g[0]*m[1]-g[1]*m[0])},c=l(o[0],o[1],o[2],o[3]),u=[0,1,2,3].map(f=>{let h=o.map((d,p)=>p===f?i:d);return l(h[0],h[1],h[2],h[3])/c});return{nodes:r,weights:u}}var xh=class{section=new gh;objects;plane=null;#e=[];#t=new hn;#n=new hn;constructor(e){this.objects=[new wt(this.#t,e.section),new Ji(this.#n,e.sectionEdges)],this.objects.forEach((t,i)=>{t.frustumCulled=!1,t.matrixAutoUpdate=!1,t.visible=!1,t.renderOrder=1e5+2*i})}hide(){this.plane=null;for(let e of this.objects)e.visible=!1}update(e,t,i,s,r){this.plane=i;let o=[e,t,...i,s,r],a=o.every((l,c)=>l===this.#e[c]);if(!a){this.#e=o,this.section.compute(e,t,i,s,r,e.stresses?hl:rh);let{points:l,values:c,count:u,edges:f,edgeCount:h}=this.section;Up(this.#t,"position",l,3,3*u),Up(this.#t,"field",c,1,3*u),Up(this.#n,"position",f,3,2*h),this.#t.setDrawRange(0,3*u),this.#n.setDrawRange(0,2*h)}return this.objects[0].visible=this.section.count>0,this.objects[1].visible=r&&this.section.edgeCount>0,!a}dispose(){this.#t.dispose(),this.#n.dispose()}};function Up(n,e,t,i,s){let r=n.getAttribute(e);r?.array!==t&&(n.dispose(),r=new pt(t,i).setUsage(dr),n.setAttribute(e,r)),r.clearUpdateRanges(),r.addUpdateRange(0,i*s),r.needsUpdate=!0}var Op=Math.cos(32*Math.PI/180),Qo=n=>n===2147483648?0:n;function _R(n){let e=n.length/3,t=new Uint32Array(n.buffer,n.byteOffset,n.length),i=1;for(;i<2*e;)i*=2;let s=new Uint32Array(i),r=new Uint32Array(e);for(let o=0;o<e;o++){let[a,l,c]=[Qo(t[3*o]),Qo(t[3*o+1]),Qo(t[3*o+2])],u=Math.imul(a,2654435761)^Math.imul(l,2246822507)^Math.imul(c,3266489909);for(u=(u^u>>>15)&i-1;;){let f=s[u];if(f===0){s[u]=o+1,r[o]=o;break}let h=3*(f-1);if(Qo(t[h])===a&&Qo(t[h+1])===l&&Qo(t[h+2])===c){r[o]=f-1;break}u=u+1&i-1}}return r}function bR(n,e){let t=new Uint32Array(e+1);for(let r=0;r<n.length;r++)t[n[r]+1]++;for(let r=0;r<e;r++)t[r+1]+=t[r];let i=t.slice(0,e),s=new Uint32Array(n.length);for(let r=0;r<n.length;r++)s[i[n[r]]++]=r;return{starts:t,corners:s}}function SR(n,e){let t=new Float32Array(e.length);for(let i=0;i<e.length;i+=3){let s=3*e[i],r=3*e[i+1],o=3*e[i+2],a=n[r]-n[s],l=n[r+1]-n[s+1],c=n[r+2]-n[s+2],u=n[o]-n[s],f=n[o+1]-n[s+1],h=n[o+2]-n[s+2];t[i]=l*h-c*f,t[i+1]=c*u-a*h,t[i+2]=a*f-l*u}return t}function MR(n,e,t,i,s){for(let r=e[i];r<e[i+1];r++){let o=t[r],a=o-o%3;if(n[a+(o+1)%3]===s)return a}return-1}function wR(n,e,t){let i=new Map,s=(r,o,a)=>i.set(r,[...i.get(r)??[],[o,a]]);return n.forEach((r,o)=>{r<0||e[o]!==o||!t[o]||(s(o,e[r],1),s(e[r],o,-1))}),i}function xl(n,e,t){let i=n.length/3,s=_R(n),r=e.map(v=>s[v]),{starts:o,corners:a}=bR(r,i),l=SR(n,e),c=new Uint8Array(i),u=[];for(let v=0;v<e.length;v++){let g=v-v%3,m=r[v],y=r[g+(v+1)%3];if(m===y)continue;let M=MR(r,o,a,y,m);M<0?(c[m]=c[y]=1,t===1&&u.push(v)):g<M&&Bp(l,g,l,M)<Op&&u.push(v)}let f=Wr(n,t),h=wR(f,s,c),d=ER(e,s,t,o,a,l,h),p=new Uint32Array(2*u.length);return u.forEach((v,g)=>{let m=v-v%3;p[2*g]=d.firstVertex[r[v]],p[2*g+1]=d.firstVertex[r[m+(v+1)%3]]}),{...d,features:p,seam:f}}var kp=(n,e,t)=>Math.sqrt(n*n+e*e+t*t);function Bp(n,e,t,i){let s=n[e]*t[i]+n[e+1]*t[i+1]+n[e+2]*t[i+2],r=kp(n[e],n[e+1],n[e+2])*kp(t[i],t[i+1],t[i+2]);return r>0?s/r:1}function ER(n,e,t,i,s,r,o){let a=e.length,l=[],c=[],u=new Uint32Array(a),f=new Uint32Array(n.length),h=2*Math.PI/t;for(let d=0;d<a;d++){let p=l.length;u[d]=p;let v=e[d],g=AR(v,o,i,s,r,h);for(let m=i[v];m<i[v+1];m++){let y=s[m];if(n[y]!==d)continue;let M=y-y%3,b=0,R=0,T=0;for(let U=i[v];U<i[v+1];U++){let N=s[U]-s[U]%3;N!==M&&Bp(r,M,r,N)<Op||(b+=r[N],R+=r[N+1],T+=r[N+2])}for(let U=0;U<g.length;U+=3)Bp(r,M,g,U)<Op||(b+=g[U],R+=g[U+1],T+=g[U+2]);let _=kp(b,R,T)||1;b/=_,R/=_,T/=_;let E=p;for(;E<l.length;){let U=3*E;if(c[U]*b+c[U+1]*R+c[U+2]*T>.99999)break;E++}E===l.length&&(l.push(d),c.push(b,R,T)),f[y]=E}l.length===p&&(l.push(d),c.push(0,0,1))}return{nodes:Uint32Array.from(l),firstVertex:u,normals:Float32Array.from(c),triangles:f}}var TR=[];function AR(n,e,t,i,s,r){let o=e.get(n);if(!o)return TR;let a=[];for(let[l,c]of o){let u=Math.cos(c*r),f=Math.sin(c*r);for(let h=t[l];h<t[l+1];h++){let d=i[h]-i[h]%3;a.push(u*s[d]-f*s[d+1],f*s[d]+u*s[d+1],s[d+2])}}return a}var zp=[48,32,16,8],CR=1.6;function Oy(n){let e=-1;return zp.forEach((t,i)=>{n<=CR*t&&(e=i)}),e}function RR(n,e,t){let[i,s,r]=[Math.abs(n),Math.abs(e),Math.abs(t)];return i>=s&&i>=r?n>0?0:1:s>=r?e>0?2:3:t>0?4:5}function PR({nodes:n,features:e,seam:t}){let i=new Uint32Array(t.length);for(let s of e)i[n[s]]++;return Uint8Array.from(i,s=>s===0?0:s===2?1:2)}function IR(n,e,t){let{seam:i}=e,s=PR(e),r=new Set(i),o=new Map,a=new Uint32Array(i.length),l=new Map,c=[],u=[],f=d=>{let p=o.get(d);return p===void 0&&(p=o.size,o.set(d,p),c.push(0,0,0,0),u.push(0)),p};for(let d=0;d<i.length;d++){let p=i[d],v=3*(p<0?d:p),[g,m,y]=[n[v],n[v+1],n[v+2]],M=`${Math.floor(g/t)},${Math.floor(m/t)},${Math.floor(y/t)}`,b=f(p>=0?`last ${M}`:r.has(d)?`first ${M}`:M);p>=0&&l.set(b,f(`first ${M}`)),a[d]=b,!(s[d]<u[b])&&(s[d]>u[b]&&c.fill(0,4*b,4*b+4),u[b]=s[d],[g,m,y,1].forEach((R,T)=>c[4*b+T]+=R))}let h=Float32Array.from({length:3*u.length},(d,p)=>{let v=l.get(Math.floor(p/3))??Math.floor(p/3);return c[4*v+p%3]/c[4*v+3]});return{cellOf:a,lastCells:l,places:h}}function ky(n,e,t,i){let{nodes:s,normals:r,triangles:o}=e,{cellOf:a,lastCells:l,places:c}=IR(n,e,i),u=new Map,f=[],h=[],d=new Uint32Array(s.length);for(let m=0;m<s.length;m++){let y=a[s[m]],[M,b,R]=[r[3*m],r[3*m+1],r[3*m+2]],T=6*y+RR(M,b,R),_=u.get(T);_===void 0&&(_=u.size,u.set(T,_),f.push(y),h.push(0,0,0)),h[3*_]+=M,h[3*_+1]+=b,h[3*_+2]+=R,d[m]=_}let p={points:Float32Array.from(f.flatMap(m=>[...c.subarray(3*m,3*m+3)])),normals:new Float32Array(h.length),seam:Float32Array.from(f,m=>l.has(m)?1:0)};for(let m=0;m<h.length;m+=3){let y=Math.hypot(h[m],h[m+1],h[m+2])||1;for(let M=0;M<3;M++)p.normals[m+M]=h[m+M]/y}let v=[];for(let m=0;m<o.length;m+=3){let[y,M,b]=[d[o[m]],d[o[m+1]],d[o[m+2]]],[R,T,_]=[f[y],f[M],f[b]];R!==T&&T!==_&&_!==R&&v.push(y,M,b)}let g=v.filter((m,y)=>LR(p,v,y-y%3,t));return{...p,closed:Uint32Array.from(v),triangles:Uint32Array.from(g)}}function LR({points:n,normals:e,seam:t},i,s,r){let[o,a]=jo(1,r),l=i.slice(s,s+3).map(y=>{let[M,b,R]=n.subarray(3*y,3*y+3);return t[y]?[o*M-a*b,a*M+o*b,R]:[M,b,R]}),c=y=>l[y].map((M,b)=>M-l[0][b]),[[u,f,h],[d,p,v]]=[c(1),c(2)],g=[f*v-h*p,h*d-u*v,u*p-f*d],m=0;for(let y=s;y<s+3;y++)for(let M=0;M<3;M++)m+=g[M]*e[3*i[y]+M];return m>=0}function Xr(n,e,t=new Float32Array(3*e.length)){for(let i=0;i<e.length;i++){let s=3*e[i];t[3*i]=n[s],t[3*i+1]=n[s+1],t[3*i+2]=n[s+2]}return t}function Vp({nodes:n,seam:e}){return Float32Array.from(n,t=>e[t]<0?0:1)}var vl=class{constructor(e,t,i){this.input=e;this.total=i;let{surface:s,points:r}=e;this.#r=i,this.triangleCount=s.triangles.length/3,this.box=new ci().setFromArray(Xr(r,s.nodes));let o=new pt(Xr(dh(r,s.seam),s.nodes),3),a=new pt(Vp(s),1);this.sphere=this.box.getBoundingSphere(new ri),this.#o=new Nr(new Float32Array(4*i),4),this.#o.setUsage(dr);let l=(d,p=!1)=>{let v=new ur;return v.setAttribute("position",o),v.setAttribute("seam",a),v.setAttribute("copyRotation",this.#o),p&&v.setAttribute("normal",new pt(s.normals,3)),v.setIndex(new pt(d,1)),v.instanceCount=i,v},c=Uint32Array.from(e.edges,d=>s.firstVertex[d]),u=l(s.triangles,!0);this.#s=new Ko(s.features,Xr(r,s.nodes));let f=l(s.features),h=l(c);this.#e=[u,f,h],this.#t={shown:u,closed:u},this.surface=new wt(u,t.surface),this.features=new Ji(f,t.features),this.edges=new Ji(h,t.edges),this.stencils=[new wt(u,t.stencilBack),new wt(u,t.stencilFront)];for(let d of[this.surface,this.features,this.edges,...this.stencils])d.frustumCulled=!1,d.matrixAutoUpdate=!1,this.group.add(d);this.group.matrixAutoUpdate=!1,this.setCopies(Array.from({length:i},(d,p)=>p),i)}input;total;group=new sn;surface;features;edges;stencils;triangleCount;sphere;box;#e;#t;#n=[];#i=-1;#s;#r;#o;setLevel(e){if(e===this.#i)return;this.#i=e;let t=e<0?this.#t:this.#n[e]??=this.coarse(e);t.shown.instanceCount=t.closed.instanceCount=this.#r,this.surface.geometry=t.shown;for(let i of this.stencils)i.geometry=t.closed}coarse(e){let t=2*this.sphere.radius/zp[e],i=ky(this.input.points,this.input.surface,this.total,t),s={position:new pt(i.points,3),normal:new pt(i.normals,3),seam:new pt(i.seam,1),copyRotation:this.#o},r=o=>{let a=new ur;for(let[l,c]of Object.entries(s))a.setAttribute(l,c);return a.setIndex(new pt(o,1)),this.#e.push(a),a};return{shown:r(i.triangles),closed:r(i.closed)}}setScale(e){this.features.geometry.setIndex(this.#s.index(e))}get drawnTriangles(){return this.surface.geometry.index.count/3}setCopies(e,t){let i=this.#o,s=i.array;for(let r=0;r<t;r++)s.set(pl(e[r],this.total),4*r);i.clearUpdateRanges(),i.addUpdateRange(0,4*t),i.needsUpdate=!0,this.#r=t;for(let r of this.#e)r.instanceCount=t;this.group.visible=t>0}dispose(){for(let e of this.#e)e.dispose()}};var By=new WeakMap;function NR(n,e){let t=By.get(n);return t||By.set(n,t=xl(n.points,n.triangles,e)),t}var Hp=class{constructor(e,t){this.shape=e;let i=NR(e,t);this.surface=i,this.position=new pt(Xr(dh(e.points,i.seam),i.nodes),3),this.seam=new pt(Vp(i),1),this.normal=new pt(i.normals,3),this.triangles=new pt(i.triangles,1),this.outline=new Ko(i.features,Xr(e.points,i.nodes)),this.edges=new pt(Uint32Array.from(e.edges,s=>i.firstVertex[s]),1)}shape;surface;position;seam;normal;triangles;outline;edges},Gp=class{constructor(e,t){this.buffers=e;let{surface:i,shape:s}=e,r=i.nodes.length;this.triangleCount=s.triangles.length/3,this.#t=new pt(new Float32Array(3*r),3).setUsage(dr),this.#n=new pt(new Float32Array(r).fill(hl),1).setUsage(dr);let o=u=>{let f=new ur;return f.setAttribute("position",e.position),f.setAttribute("seam",e.seam),f.setAttribute("normal",e.normal),f.setAttribute("displacement",this.#t),f.setAttribute("field",this.#n),f.setAttribute("copyRotation",this.#i),f.setIndex(u),f.instanceCount=1,f},a=o(e.triangles),l=o(e.outline.index(1/0)),c=o(e.edges);this.surface=new wt(a,t.surface),this.features=new Ji(l,t.features),this.edges=new Ji(c,t.edges),this.stencils=[new wt(a,t.stencilBack),new wt(a,t.stencilFront)],this.#e=[a,l,c],this.section=Dy(s)?new xh(t):null;for(let u of[this.surface,this.features,this.edges,...this.stencils])u.frustumCulled=!1,u.matrixAutoUpdate=!1,this.group.add(u);this.section&&this.group.add(...this.section.objects),this.group.matrixAutoUpdate=!1}buffers;group=new sn;surface;features;edges;stencils;section;triangleCount;mesh=null;values=null;#e;#t;#n;#i=new Nr(new Float32Array(4),4);setScale(e){this.features.geometry.setIndex(this.buffers.outline.index(e))}get open(){return this.buffers.shape.open}set(e){e!==this.mesh&&(this.mesh=e,this.values=null,this.#i.setXYZW(0,...pl(e.copy,e.copies)),this.#i.needsUpdate=!0,Xr(e.displacements,this.buffers.surface.nodes,this.#t.array),this.#t.needsUpdate=!0)}setField(e){if(e===this.values)return;this.values=e;let t=this.#n.array,i=this.mesh?.stresses?hl:rh,{nodes:s}=this.buffers.surface;for(let r=0;r<s.length;r++){let o=e[s[r]];t[r]=Number.isFinite(o)?o:i}this.#n.needsUpdate=!0}dispose(){for(let e of this.#e)e.dispose();this.section?.dispose()}},vh=class{#e=new Map;#t=new Map;display(e,t){let i=new Map([...this.#t].map(([o,a])=>[o,[...a]])),s=o=>`${o.part} ${o.shape.name}`,r=e.map(o=>{let a=i.get(s(o))??[],l=a.findIndex(c=>c.mesh?.copy===o.copy&&c.mesh.shape===o.shape);return l<0?null:a.splice(l,1)[0]});return e.map((o,a)=>{let l=i.get(s(o))??[],c=r[a]?-1:l.findIndex(f=>f.mesh?.shape===o.shape),u=r[a]??(c<0?this.create(o,t(o.part)):l.splice(c,1)[0]);return u.set(o),u})}create(e,t){let i=this.#e.get(e.shape);i||this.#e.set(e.shape,i=new Hp(e.shape,e.copies));let s=new Gp(i,t),r=`${e.part} ${e.shape.name}`;return this.#t.set(r,[...this.#t.get(r)??[],s]),s}dispose(){for(let e of this.#t.values())for(let t of e)t.dispose();this.#t.clear(),this.#e.clear()}};var DR=.28,Wp=7,FR=6e4,yh=class{constructor(e,t,i,s){this.part=e;this.#i=new rt(s),this.#s=new rt("#b4b9bf").lerp(this.#i,.4),this.#e=Cp(t,!1),this.#t=Cp(t,!0),this.#n=ty(t),this.surface=xl(e.points,e.triangles,e.copies),this.copies=new vl({...e,surface:this.surface},this.#e,e.copies),this.#r=Array.from({length:e.copies},(o,a)=>a),this.#a=new Uint32Array(e.copies);let r=0;for(let o=0;o<e.points.length;o+=3)r=Math.max(r,e.points[o]**2+e.points[o+1]**2+e.points[o+2]**2);this.radius=Math.sqrt(r),this.group.matrixAutoUpdate=!1,this.restTriangles=e.triangles.subarray(e.triangles.length-3*e.withoutMesh),this.rest=e.withoutMesh>0?this.createRest():null,this.group.add(this.copies.group),this.rest&&this.group.add(this.rest.group),this.cap=new wt(i,this.#n),this.cap.frustumCulled=!1,this.cap.matrixAutoUpdate=!1,this.cap.onAfterRender=o=>o.clearStencil(),this.#x=e.index,this.#t.section.polygonOffsetUnits=-UR*e.index,this.refresh()}part;group=new sn;cap;copies;surface;radius;restTriangles;meshes=[];visibility="visible";present=!0;#e;#t;#n;#i;#s;#r;#o=[];rest;#a;#c=-1;#h=NaN;#l=!1;#m=!1;#d=!1;#f=!1;#x;get materials(){return[...Object.values(this.#e),...Object.values(this.#t),this.#n]}setMeshes(e,t){for(let i of this.meshes)e.includes(i)||this.group.remove(i.group);for(let i of e)i.group.parent!==this.group&&this.group.add(i.group);this.meshes=e,this.#r=[];for(let i=0;i<this.part.copies;i++)t.has(i)||this.#r.push(i);this.#h=NaN,this.#o=[...t],this.rest?.setCopies(this.#o,this.#o.length),this.refresh()}createRest(){let{points:e,copies:t,edges:i}=this.part,s=this.restTriangles.reduce((o,a)=>Math.min(o,a),1/0),r=xl(e,this.restTriangles,t);return new vl({points:e,surface:r,edges:i.filter((o,a)=>i[a-a%2]>=s)},this.#e,t)}get replacedCopies(){return this.#o}get meshMaterials(){return this.#t}get presentCopies(){return this.#r}setVisibility(e){this.visibility=e,this.refresh()}setFieldMode(e){this.#l=e,this.refresh()}setEdges(e){this.#m=e,this.refresh()}setSections(e){e!==this.#f&&(this.#f=e,this.refresh())}get showsField(){return this.#l}get showsSections(){return this.#f&&this.#d&&this.group.visible}setCut(e){this.#d=e;for(let t of this.materials)t.cut=e;this.refresh()}setPresent(e){this.present=e,this.refresh()}refresh(){let e=this.visibility==="translucent",t=this.visibility!=="hidden"&&this.present;this.group.visible=t,this.cap.visible=t&&this.#d&&!this.part.open;let i=e?DR:1;for(let r of[this.#e,this.#t]){r.surface.alpha=i,r.surface.depthWrite=!e;let o=this.part.open||this.#d;r.surface.side=o&&!e?zn:Fi,r.surface.colour.copy(this.#l?this.#s:this.#i),r.features.alpha=e?.25:.5,r.edges.alpha=e?.12:.34,r.stencilBack.transparent=r.stencilFront.transparent=e}this.#t.surface.useField=this.#t.section.useField=this.#l,this.#t.section.colour.copy(this.#l?this.#s:this.#i).multiplyScalar(.86),this.#n.alpha=e?.5:1,this.#n.depthWrite=!e,this.#n.colour.copy(this.#l?this.#s:this.#i).multiplyScalar(.86);let s=10+3*this.#x;this.cap.renderOrder=s+2;for(let r of[this.copies,...this.rest?[this.rest]:[],...this.meshes])r.edges.visible=this.#m,r.surface.renderOrder=e?1e5:0,r.features.renderOrder=r.edges.renderOrder=100001;this.refreshStencils(this.copies.stencils,s,!0),this.rest&&this.refreshStencils(this.rest.stencils,s,!0);for(let r of this.meshes){let o=!r.open&&!(this.#f&&r.section);this.refreshStencils(r.stencils,s,o)}}refreshStencils(e,t,i){e.forEach((s,r)=>{s.visible=i&&this.#d&&!this.part.open,s.renderOrder=t+r})}prepare(e,t){if(!this.group.visible)return 0;let{sphere:i}=this.copies,s=0,r=0,o=0,a=this.group.matrixWorld;yl.radius=i.radius;for(let d of this.#r){let[p,v]=jo(d,this.part.copies),{x:g,y:m,z:y}=i.center;yl.center.set(p*g-v*m,v*g+p*m,y).applyMatrix4(a),e.intersectsSphere(yl)&&(this.#a[s++]=d,r=(r*31+d+1)%4294967291,o=Math.max(o,i.radius*2*t(yl.center)))}(s!==this.#c||r!==this.#h)&&(this.copies.setCopies(this.#a,s),this.#c=s,this.#h=r);let l=this.part.copies>1?2*Math.PI*this.radius/this.part.copies:2*i.radius,c=o*Math.min(l,2*i.radius)/(2*i.radius||1);this.copies.features.visible=c>Wp;let u=t(yl.center.setFromMatrixPosition(a)),f=this.part.copies===1||l*u>Wp;for(let d of[this.copies,...this.rest?[this.rest]:[],...this.meshes])d.setScale(u),d!==this.copies&&(d.features.visible=f);this.copies.edges.visible=this.#m&&c>2*Wp,this.copies.setLevel(s*this.copies.triangleCount>FR?Oy(o):-1);let h=s*this.copies.drawnTriangles+this.#o.length*this.part.withoutMesh;for(let d of this.meshes)h+=d.triangleCount;return h}dispose(){this.copies.dispose(),this.rest?.dispose();for(let e of this.materials)e.dispose()}},UR=8,yl=new ri;function _h(){return{version:1,camera:null,parts:{},colours:{field:"plain",scale:"viridis",bands:0,limits:"position",min:0,max:1,cells:"all"},deformation:{mode:"automatic",factor:1},mesh_edges:!1,hidden_contacts:!0,extremes:!0,forces:{bearings:!1,meshes:!1,labels:!0,scale:1},cut:{on:!1,normal:"z",offset:null,flipped:!1},frame:null,position:0,animation:{speed:10,loop:!0},theme:"system",panels:{parts:!0,settings:!1,plots:!1,pattern:!1},pattern:{gear:"",tooth:"all",flank:"automatic",envelope:!1},plotted:[]}}function bh(n,e=_h()){let t=structuredClone(e),i=n??{};for(let[s,r]of Object.entries(t)){let o=i[s];if(o===void 0||s==="version")continue;Xp(r)&&s!=="parts"&&s!=="camera"?Xp(o)&&(t[s]=OR(r,o)):s==="camera"?kR(o)&&(t[s]=o):s==="frame"?(o===null||typeof o=="string")&&(t[s]=o):typeof o==typeof r&&o!==null&&(t[s]=o)}return structuredClone(t)}function Xp(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)}function OR(n,e){let t={...n};for(let i of Object.keys(n)){let s=e[i];s!==void 0&&(i==="normal"||i==="offset"||typeof s==typeof n[i])&&(t[i]=s)}return t}function kR(n){return!Xp(n)||!Array.isArray(n.target)||n.target.length!==3?!1:[...n.target,n.azimuth,n.elevation,n.height].every(t=>typeof t=="number"&&Number.isFinite(t))&&(n.projection==="perspective"||n.projection==="orthographic")}function _l(n,e){return n.parts[e.name]??(e.kind==="body"?"translucent":"visible")}var BR=.05,zR=1.5,VR=30,HR=1e-4,Mh=class{constructor(e){this.scene=e;this.contacts=new oh(e.uniforms),this.forces=new hh(e.uniforms),e.root.add(this.contacts.group,this.contacts.markLine,this.forces.group),e.scene.add(this.cut.group)}scene;views=[];position=null;meshes=[];colours=[];factor=0;limits=null;clipped=null;triangles=0;cut=new ch;contacts;forces;centre=new G;radius=1;sectionTime=0;#e=new vh;#t=[];#n=new WeakMap;#i=new WeakMap;#s=!1;#r=!1;#o=null;#a=new bt;#c=!1;setParts(e,t){this.clear();let i=new Map;this.#o=t?.poses??null,this.colours=e.map(({kind:r})=>{let o=i.get(r)??0;return i.set(r,o+1),hy(r,o)}),this.views=e.map((r,o)=>{let a=new yh(r,this.scene.uniforms,this.cut.capGeometry,this.colours[o]);return this.scene.root.add(a.group),this.scene.scene.add(a.cap),a}),this.meshes=e.map(()=>[]);let s=new ci().setFromPoints(this.views.flatMap(r=>this.outline(r))).getBoundingSphere(new ri);this.centre.copy(s.center),this.radius=s.radius>0?s.radius:1,this.contacts.setBias(8e-4*this.radius),this.cut.setBounds(this.centre,this.radius),this.updateBounds()}updateBounds(){let e=this.views.filter(i=>i.visibility!=="hidden"),t=(e.length>0?e:this.views).flatMap(i=>this.outline(i));this.scene.camera.setBounds(this.centre,this.radius*1.1,t)}outline(e){let t=Os(this.#o,e.part.index,new bt),{min:i,max:s}=e.copies.box,r=[];if(e.part.points.length===0||!Sh(this.#o,e.part.index))return r;if(e.part.copies>1){let o=0,a=e.part.points;for(let l=0;l<a.length;l+=3)o=Math.max(o,Math.hypot(a[l],a[l+1]));for(let l=0;l<24;l++){let c=2*Math.PI*l/24;for(let u of[i.z,s.z])r.push(new G(o*Math.cos(c),o*Math.sin(c),u))}}else for(let o=0;o<8;o++)r.push(new G(o&1?s.x:i.x,o&2?s.y:i.y,o&4?s.z:i.z));return r.map(o=>o.applyMatrix4(t))}setPosition(e){this.position=e,this.meshes=this.views.map(()=>[]);let t=this.views.map(()=>[]),i=this.views.map(()=>new Set);this.#t=this.#e.display(e?.meshes??[],s=>this.views[s].meshMaterials),e?.meshes.forEach((s,r)=>{this.meshes[s.part].push(s),t[s.part].push(this.#t[r]),i[s.part].add(s.copy)}),this.views.forEach((s,r)=>{Os(e?.poses??null,r,s.group.matrix),s.setPresent(Sh(e?.poses??null,r)),s.setMeshes(t[r],i[r])})}values(e,t){let i=this.#n.get(e);i||this.#n.set(e,i=new Map);let s=i.get(t);return s||i.set(t,s=gy(e,t)),s}limitsOf(e,t){return this.automaticLimits(e,t,this.extremes(e,t))}automaticLimits(e,t,i){if(!i)return null;let s=Pp(t.colours.field);if(s===1)return[i.min.value,i.max.value];let r=this.surfaceValues(e,t).filter(o=>o>HR*i.max.value).sort();return[i.min.value,r[Math.floor(s*(r.length-1))]??i.max.value]}surfaceValues(e,t){let i=t.colours.field,s=e.meshes.filter(({part:a})=>this.shown(t,a)),r=new Float64Array(s.reduce((a,l)=>a+l.shape.points.length/3,0)),o=0;for(let a of s){let l=Ip(a.shape);this.values(a,i).forEach((c,u)=>{l[u]&&Number.isFinite(c)&&(r[o++]=c)})}return r.subarray(0,o)}clippedBy(e,t,i){let{field:s,limits:r}=t.colours;if(!e||!i||!this.position||r==="fixed"||Pp(s)===1)return null;let o=this.surfaceValues(this.position,t),a=o.reduce((l,c)=>l+(c>e[1]?1:0),0);return a>0?{share:a/o.length,largest:i.max.value}:null}shown(e,t){let i=this.views[t]?.part.name;return i!==void 0&&e.parts[i]!=="hidden"}cellShown(e,t,i){let s=t.contacts,{parts:r}=s;return fl(s,i,e.colours.cells)?this.shown(e,r[2*i])||this.shown(e,r[2*i+1]):!1}extremes(e,t){let{field:i}=t.colours,s=null,r=null;if(Hn(i))for(let o of e.meshes){if(!this.shown(t,o.part))continue;let a=this.values(o,i),l=Ip(o.shape);for(let c=0;c<a.length;c++){let u=a[c];!l[c]||!Number.isFinite(u)||((!s||u<s.value)&&(s={value:u,mesh:o,index:c}),(!r||u>r.value)&&(r={value:u,mesh:o,index:c}))}}else if(i==="contact_pressure"&&e.contacts){let o=Float64Array.from(e.contacts.pressures,(l,c)=>l>0&&this.cellShown(t,e,c)?l:NaN),a=my(o);a&&(s={value:0,mesh:null,index:a.minIndex},r={value:a.max,mesh:null,index:a.maxIndex})}return s&&r?{min:s,max:r}:null}extremePoint(e,t){let i=new G,{mesh:s,index:r}=e;if(s)return i.set(...Us(s,r,this.factor)).applyMatrix4(Os(t.poses,s.part,this.#a));let o=t.contacts.corners;for(let a=0;a<4;a++)i.x+=o[12*r+3*a]/4,i.y+=o[12*r+3*a+1]/4,i.z+=o[12*r+3*a+2]/4;return i}apply(e,t){let{uniforms:i}=this.scene,{colours:s}=e,r=this.position,o=Hn(s.field);for(let h of this.views)h.setVisibility(_l(e,h.part)),h.setFieldMode(o),h.setEdges(e.mesh_edges),h.setSections(this.sectionsShown(e));if(this.applyFrame(e),this.factor=this.deformationFactor(e),i.deformation.value=this.factor,o)for(let h of this.#t)h.setField(this.values(h.mesh,s.field));this.#s=e.mesh_edges;let a=r&&s.field==="contact_pressure"?r.contacts:null,l=JSON.stringify([s.cells,Object.entries(e.parts).filter(([,h])=>h==="hidden")]);this.contacts.set(a,l,h=>this.cellShown(e,r,h)),this.contacts.setBehind(e.hidden_contacts);let c=r?this.extremes(r,e):null;this.limits=this.chooseLimits(e,c,t),this.clipped=this.clippedBy(this.limits,e,c),this.limits&&i.limits.value.set(...this.limits),ly(this.scene.scaleTexture,s.scale,s.bands);let u=this.views.map(({part:h})=>h.name);this.forces.set(r?.forces??[],{...e.forces,radius:this.radius,names:u}),this.applyCut(e);let f=[...this.forces.labels];if(r&&c&&e.extremes){let h=Math.max(Math.abs(c.min.value),Math.abs(c.max.value)),d=Ei[s.field].quantity==="length"?Tn("m",h):Oi(),p=(v,g,m)=>{let y=Math.abs(v.value)<1e-9*h?0:v.value*d.factor,M=this.extremePoint(v,r);this.isCutAway(M)||f.push({kind:g,text:`${m} ${Ft(y)} ${d.symbol}`,point:M})};py(s.field)==="maximum"?p(c.max,"maximum","max"):p(c.min,"minimum","min")}return f}chooseLimits(e,t,i){let{colours:s}=e;return s.field==="plain"?null:s.limits==="fixed"?[Math.min(s.min,s.max),Math.max(s.min,s.max)]:s.limits==="all"&&i?i:this.position&&this.automaticLimits(this.position,e,t)}deformationFactor(e){let{mode:t,factor:i}=e.deformation;if(t==="factor")return Number.isFinite(i)?i:0;if(!Hn(e.colours.field))return 0;let s=this.position?this.largestDisplacement(this.position):0;return s>0?My(BR*2*this.radius/s):1}largestDisplacement(e){let t=this.#i.get(e);if(t===void 0){t=0;for(let{displacements:i}of e.meshes)for(let s=0;s<i.length;s+=3)t=Math.max(t,i[s]**2+i[s+1]**2+i[s+2]**2||0);this.#i.set(e,t)}return Math.sqrt(t)}applyFrame(e){let{root:t}=this.scene;t.matrix.identity();let i=this.views.findIndex(r=>r.part.name===e.frame),s=r=>r&&Sh(r,i);i>=0&&this.position&&s(this.#o)&&s(this.position.poses)&&(Os(this.#o,i,t.matrix),t.matrix.multiply(Os(this.position.poses,i,this.#a).invert())),t.updateMatrixWorld(!0)}applyCut(e){this.cut.apply(e.cut,this.scene.uniforms.cutPlane.value);for(let t of this.views)t.cap.matrix.copy(this.cut.capMatrix),t.cap.updateMatrixWorld(!0);if(this.#c!==e.cut.on){this.#c=e.cut.on;for(let t of this.views)t.setCut(this.#c);for(let t of this.contacts.materials)t.cut=this.#c}}isCutAway(e){let t=this.cutPlane,i=zy.copy(e).applyMatrix4(this.scene.root.matrix);return t!==null&&t.x*i.x+t.y*i.y+t.z*i.z+t.w>0}get cutPlane(){return this.#c?this.scene.uniforms.cutPlane.value:null}setDragging(e,t){if(e!==this.#r){this.#r=e;for(let i of this.views)i.setSections(this.sectionsShown(t));this.scene.invalidate()}}sectionsShown(e){return(Hn(e.colours.field)||e.mesh_edges)&&!(this.#r&&this.sectionTime>VR)}updateSections(){let e=performance.now(),t=!1;for(let i of this.views){let s=i.showsSections?this.planeOf(i):null;for(let r of i.meshes)if(r.section)if(s&&r.mesh){let o=i.showsField?r.values:null;t=r.section.update(r.mesh,o,s,this.factor,this.#s)||t}else r.section.hide()}t&&(this.sectionTime=performance.now()-e)}planeOf(e){let{x:t,y:i,z:s,w:r}=this.scene.uniforms.cutPlane.value,o=e.group.matrixWorld.elements;return[o[0]*t+o[1]*i+o[2]*s,o[4]*t+o[5]*i+o[6]*s,o[8]*t+o[9]*i+o[10]*s,o[12]*t+o[13]*i+o[14]*s+r]}prepareFrame(){this.updateSections();let e=this.scene.frustum(),{active:t,state:i,direction:s}=this.scene.camera,r=this.scene.height/i.height;this.scene.uniforms.lineBias.value=zR/r;let o=t.position.distanceTo(GR.fromArray(i.target)),a=i.projection==="orthographic",l=c=>{if(a)return r;let u=zy.copy(t.position).sub(c).dot(s);return u>0?r*o/u:r};this.triangles=0;for(let c of this.views)this.triangles+=c.prepare(e,l)}clear(){for(let e of this.views)e.group.removeFromParent(),e.cap.removeFromParent(),e.dispose();this.#e.dispose(),this.#t=[],this.views=[],this.position=null,this.#c=!1;for(let e of this.contacts.materials)e.cut=!1}dispose(){this.clear(),this.contacts.dispose(),this.forces.dispose()}},GR=new G,zy=new G;function Sh(n,e){return!n||n.subarray(12*e,12*e+12).every(Number.isFinite)}function Os(n,e,t){if(!n||!Sh(n,e))return t.identity();let[i,s,r,o,a,l,c,u,f,h,d,p]=n.subarray(12*e,12*e+12);return t.set(i,s,r,h,o,a,l,d,c,u,f,p,0,0,0,1)}var WR=(n,e)=>n.left<e.right&&e.left<n.right&&n.top<e.bottom&&e.top<n.bottom,[wh,$p]=[9,9];function Vy(n,e,t,i){let s=n==="right"?e+wh:n==="left"?e-wh-i:e-i/2,r=n==="above"?t-wh-2*$p:n==="below"?t+wh:t-$p;return{left:s,top:r,right:s+i,bottom:r+2*$p}}var Eh=class{element=document.createElement("div");#e=[];#t=[];#n=[];#i=new G;constructor(){this.element.className="cv-labels"}set(e){for(let t of e)t.hidden??=this.#e.find(({kind:i})=>i===t.kind)?.hidden;for(this.#e=e;this.#t.length>e.length;)this.#t.pop().remove();e.forEach((t,i)=>{let s=this.#t[i];s||(s=document.createElement("div"),s.append(document.createElement("i"),document.createElement("span")),this.#t.push(s),this.element.append(s)),s.className=`cv-label cv-label-${t.kind}${t.hidden?" cv-label-hidden":""} ${Hy(this.#n[i])}`,s.lastElementChild.textContent=t.text})}hide(e){this.#e.forEach((t,i)=>{t.kind!=="maximum"&&t.kind!=="minimum"||(t.hidden=e(t.point),this.#t[i].classList.toggle("cv-label-hidden",t.hidden))})}arrange(e,t,i){let{left:s,top:r}=this.element.getBoundingClientRect(),o=i?[{left:i.left-s,top:i.top-r,right:i.right-s,bottom:i.bottom-r}]:[],a=({kind:h})=>h==="maximum"||h==="minimum",l=h=>a(h)?1/0:h.weight??0,c=this.#e.map((h,d)=>d).sort((h,d)=>l(this.#e[d])-l(this.#e[h])||h-d),u=this.#t.map(h=>h.lastElementChild.offsetWidth),f=this.#t.map(h=>h.getBoundingClientRect());for(let h of c){if(this.#t[h].style.display==="none")continue;let[d,p]=[f[h].x-s,f[h].y-r],v=y=>y.left>=0&&y.right<=e&&y.top>=0&&y.bottom<=t&&!o.some(M=>WR(y,M)),m=["right","left","above","below"].filter(y=>v(Vy(y,d,p,u[h])))[0]??(a(this.#e[h])?"right":null);m&&o.push(Vy(m,d,p,u[h])),this.#t[h].classList.remove(...XR),this.#t[h].classList.add(Hy(m)),this.#n[h]=m}}update(e,t,i,s){this.#e.forEach((r,o)=>{let a=this.#i.copy(r.point).applyMatrix4(t).project(e),l=a.z>-1&&a.z<1&&Math.abs(a.x)<1.02&&Math.abs(a.y)<1.02,{style:c}=this.#t[o];c.display=l?"":"none",l&&(c.transform=`translate(${(.5+.5*a.x)*i}px, ${(.5-.5*a.y)*s}px)`)})}placed(e,t,i,s){return this.#e.map((r,o)=>{let a=r.point.clone().applyMatrix4(t).project(e);return{...r,x:(.5+.5*a.x)*i,y:(.5-.5*a.y)*s,depth:a.z,side:this.#n[o]===void 0?"right":this.#n[o]}}).filter(r=>r.side!==null&&r.depth>-1&&r.depth<1&&r.x>0&&r.x<i&&r.y>0&&r.y<s)}},XR=["right","left","above","below","unplaced"].map(n=>`cv-label-${n}`);function Hy(n){return`cv-label-${n===void 0?"right":n??"unplaced"}`}function Yp(n,e,t,i,s){let[r,o,a]=n.origin,[l,c,u]=n.direction,f=null,h=1/0;for(let d=0;d<t.length;d+=3){let p=3*t[d],v=3*t[d+1],g=3*t[d+2],m=e[p],y=e[p+1],M=e[p+2],b=e[v],R=e[v+1],T=e[v+2],_=e[g],E=e[g+1],U=e[g+2];if(i){let{displacements:Xe,factor:De}=i;m+=De*Xe[p],y+=De*Xe[p+1],M+=De*Xe[p+2],b+=De*Xe[v],R+=De*Xe[v+1],T+=De*Xe[v+2],_+=De*Xe[g],E+=De*Xe[g+1],U+=De*Xe[g+2]}let N=b-m,L=R-y,B=T-M,z=_-m,D=E-y,W=U-M,q=c*W-u*D,H=u*z-l*W,le=l*D-c*z,Z=N*q+L*H+B*le;if(Z===0)continue;let Q=1/Z,ie=r-m,de=o-y,he=a-M,ee=(ie*q+de*H+he*le)*Q;if(ee<-1e-9||ee>1+1e-9)continue;let me=de*B-he*L,ge=he*N-ie*B,Me=ie*L-de*N,ve=(l*me+c*ge+u*Me)*Q;if(ve<-1e-9||ee+ve>1+1e-9)continue;let Ve=(z*me+D*ge+W*Me)*Q;Ve<=s||Ve>=h||(h=Ve,f={distance:Ve,triangle:d,u:ee,v:ve,facing:Z>0})}return f}function Th(n,e,t){if(!t)return[0,1/0];let i=t.x*n.x+t.y*n.y+t.z*n.z+t.w,s=t.x*e.x+t.y*e.y+t.z*e.z;if(s===0)return i>0?[1/0,1/0]:[0,1/0];let r=-i/s;return s<0?[Math.max(0,r),1/0]:[0,r]}var qp=new bt,$r=new G,qr=new G,pr=new Ni,Gy=new ri;function Ah(n,e,t,i,s){let[r,o]=Th(n.origin,n.direction,s),a=null,l=(c,u,f,h,d,p)=>{if(!h)return;let v=s!==null&&r>0&&!h.facing&&!p,g=v?r:h.distance;if(g>o||a&&g>=a.distance)return;let m=h.triangle;a={view:c,copy:u,mesh:f,nodes:[d[m],d[m+1],d[m+2]],weights:[1-h.u-h.v,h.u,h.v],distance:g,point:n.at(g,new G),cap:v}};for(let c of e){if(c.visibility!=="visible"||!c.present)continue;qp.copy(c.group.matrixWorld).invert(),$r.copy(n.origin).applyMatrix4(qp),qr.copy(n.direction).transformDirection(qp);let u=c.copies.sphere,{triangles:f}=c.part,h=c.presentCopies.map(v=>[v,f]),d=c.rest?c.replacedCopies.map(v=>[v,c.restTriangles]):[];for(let[v,g]of[...h,...d]){let m=-2*Math.PI*v/c.part.copies,y=Math.cos(m),M=Math.sin(m);if(pr.origin.set(y*$r.x-M*$r.y,M*$r.x+y*$r.y,$r.z),pr.direction.set(y*qr.x-M*qr.y,M*qr.x+y*qr.y,qr.z),Gy.copy(u),!pr.intersectsSphere(Gy)||!pr.intersectsBox(c.copies.box))continue;let b=Yp(Jp(pr),c.part.points,g,null,r);l(c,v,-1,b,g,c.part.open)}pr.origin.copy($r),pr.direction.copy(qr),(t[c.part.index]??[]).forEach((v,g)=>{let{triangles:m}=v.shape,{displacements:y}=v,M=Yp(Jp(pr),gl(v),m,{displacements:y,factor:i},r);l(c,-1,g,M,m,v.shape.open)})}return a}function Jp(n){return{origin:[n.origin.x,n.origin.y,n.origin.z],direction:[n.direction.x,n.direction.y,n.direction.z]}}function Wy(n,e,t,i){let s=null,r=Jp(n);for(let o=0;o<e.count;o++){if(!(e.pressures[o]>0)||!t(o))continue;let a=e.corners.subarray(12*o,12*o+12),l=Yp(r,a,$R,null,i[0]);l&&l.distance<i[1]&&(!s||l.distance<s.distance)&&(s={cell:o,distance:l.distance})}return s}var $R=new Uint32Array([0,1,2,0,2,3]);var Ch=new Ni,Zp=new G,Rh=new G;function Xy(n,e,t){Zp.copy(t).applyMatrix4(n.root.matrixWorld),Rh.copy(Zp).project(n.camera.active),n.ray((.5+.5*Rh.x)*n.width,(.5-.5*Rh.y)*n.height,Ch);let i=Ah(Ch,e.views,e.meshes,e.factor,e.cutPlane);if(!i)return!1;let s=Rh.copy(Zp).sub(Ch.origin).dot(Ch.direction),r=.001*e.radius;return i.distance<s-r}var $y=2*Math.PI/180,qy=new WeakMap;function mr(n){let e=qy.get(n);return e===void 0&&qy.set(n,e=n.copies>1?qR(n):null),e}function qR({points:n,triangles:e}){let t=KR(n,e),i=e.length/3,s=YR(n,e),r=new Float64Array(i),o=new Float64Array(i);for(let d=0;d<i;d++){let[p,v,g]=[3*e[3*d],3*e[3*d+1],3*e[3*d+2]],[m,y,M]=[n[v]-n[p],n[v+1]-n[p+1],n[v+2]-n[p+2]],[b,R,T]=[n[g]-n[p],n[g+1]-n[p+1],n[g+2]-n[p+2]],[_,E,U]=[y*T-M*R,M*b-m*T,m*R-y*b],N=Math.hypot(_,E,U),[L,B]=[n[p]+n[v]+n[g],n[p+1]+n[v+1]+n[g+1]];N>0&&(o[d]=N/2,r[d]=(E*L-_*B)/(Math.hypot(L,B)||1))}let a=r.map((d,p)=>{let v=s[p];return v<0?d/(2*o[p]||1):(d+r[v])/(2*(o[p]+o[v])||1)}),l=a.reduce((d,p)=>Math.max(d,Math.abs(p)),0),c=d=>{let p=[];for(let g=0;g<i;g++)o[g]>0&&d*a[g]>.35*l&&p.push(g);let v=jR(n,e,t,o,p);return v&&{outline:QR(n,e,p),angle:v}},[u,f]=[c(1),c(-1)];if(!u||!f)return null;let h=JR(u.angle,f.angle);return{flanks:{left:u,right:f},direction:h,tip:ZR(u,f,h)}}function YR(n,e){let t=new Int32Array(e.length/3).fill(-1),i=new Map,s=(r,o)=>Math.hypot(n[3*r]-n[3*o],n[3*r+1]-n[3*o+1],n[3*r+2]-n[3*o+2]);for(let r=0;r<t.length;r++){let o=[...e.subarray(3*r,3*r+3)],a=o.map((h,d)=>[h,o[(d+1)%3]]),[l,c]=a.reduce((h,d)=>s(...d)>s(...h)?d:h),u=l<c?`${l} ${c}`:`${c} ${l}`,f=i.get(u);f===void 0?i.set(u,r):[t[r],t[f]]=[f,r]}return t}function JR(n,e){let t=n[1]-e[1],i=n[2]-e[2];if(!(Math.hypot(t,i)>0))return 0;let s=Math.atan2(i>=0?-t:t,Math.abs(i));return Math.abs(s)<$y?0:Math.abs(s)>Math.PI/2-$y?Math.PI/2:s}function ZR(n,e,t){let i=n.outline[0]??[],s=a=>i.reduce((l,c,u)=>u%2===a?l+2*c/i.length:l,0),r=bl(n.angle,s(0),s(1))-bl(e.angle,s(0),s(1));return(Math.cos(t)*(n.angle[2]-e.angle[2])-Math.sin(t)*(n.angle[1]-e.angle[1]))*r<=0?1:-1}function KR(n,e){let t=n.length/3,[i,s]=[0,0];for(let h=0;h<n.length;h+=3)i+=n[h],s+=n[h+1];let r=Math.atan2(s,i),o=(h,d)=>h-2*Math.PI*Math.round((h-d)/(2*Math.PI)),a=h=>Math.atan2(n[3*h+1],n[3*h]),l=new Uint32Array(t+1);for(let h of e)l[h+1]++;for(let h=0;h<t;h++)l[h+1]+=l[h];let c=l.slice(0,t),u=new Uint32Array(e.length);e.forEach((h,d)=>u[c[h]++]=d);let f=new Float64Array(t).fill(NaN);for(let h=0;h<t;h++){if(!Number.isNaN(f[h]))continue;f[h]=o(a(h),r);let d=[h];for(let p=d.pop();p!==void 0;p=d.pop())for(let v=l[p];v<l[p+1];v++){let g=u[v]-u[v]%3;for(let m=0;m<3;m++){let y=e[g+m];Number.isNaN(f[y])&&(f[y]=o(a(y),f[p]),d.push(y))}}}return f}function jR(n,e,t,i,s){let r=s.map(g=>{let[m,y,M]=[0,0,0];for(let b=0;b<3;b++){let R=e[3*g+b];m+=n[3*R+2]/3,y+=Math.hypot(n[3*R],n[3*R+1])/3,M+=t[R]/3}return[i[g],m,y,M]}),o=r.reduce((g,[m])=>g+m,0);if(!(o>0))return null;let a=[1,2,3].map(g=>r.reduce((m,y)=>m+y[0]*y[g],0)/o),[l,c,u,f,h]=[0,0,0,0,0];for(let[g,m,y,M]of r){let[b,R,T]=[m-a[0],y-a[1],M-a[2]];l+=g*b*b,c+=g*b*R,u+=g*R*R,f+=g*b*T,h+=g*R*T}let d=l*u-c*c,[p,v]=d>1e-12*(l+u)**2?[(f*u-h*c)/d,(h*l-f*c)/d]:[0,0];return[a[2]-p*a[0]-v*a[1],p,v]}function QR(n,e,t){let i=new Map,s=c=>{let u=`${n[3*c]} ${n[3*c+1]} ${n[3*c+2]}`,f=i.get(u);return f===void 0&&i.set(u,c),f??c},r=new Set;for(let c of t){let u=[0,1,2].map(f=>s(e[3*c+f]));for(let f=0;f<3;f++){let[h,d]=[u[f],u[(f+1)%3]];r.delete(`${d} ${h}`)||r.add(`${h} ${d}`)}}let o=new Map;for(let c of r){let[u,f]=c.split(" ").map(Number);o.set(u,[...o.get(u)??[],f])}let a=[];for(let c of o.keys()){let u=[];for(let f=c;f!==void 0&&!(u.length>0&&f===c);f=o.get(f)?.pop())u.push(n[3*f+2],Math.hypot(n[3*f],n[3*f+1]));u.length>4&&a.push(u)}let l=Math.max(...a.map(Yy),0);return a.filter(c=>Yy(c)>.02*l)}function Yy(n){let e=0;for(let t=0;t<n.length;t+=2){let[i,s,r,o]=[n[t],n[t+1],n[(t+2)%n.length],n[(t+3)%n.length]];e+=i*o-s*r}return Math.abs(e)/2}function bl([n,e,t],i,s){return n+e*i+t*s}function Kp(n,e,t){let{contacts:i,poses:s}=n;if(!i)return[];let r=s.subarray(12*e.index,12*e.index+12),o=mr(e),a=[];for(let u=0;u<i.count;u++){let f=i.pressures[u];if(!(!(f>0)||!fl(i,u,t)))for(let h=0;h<2;h++){if(i.parts[2*u+h]!==e.index)continue;let d=[],[p,v]=[0,0];for(let T=0;T<4;T++){let _=e2(r,i.corners.subarray(12*u+3*T,12*u+3*T+3));d.push(_[2],Math.hypot(_[0],_[1])),p+=_[0]/4,v+=_[1]/4}let[g,m]=t2(d),y=i.teeth[2*u+h],M=o?(bl(o.flanks.left.angle,g,m)+bl(o.flanks.right.angle,g,m))/2:0,b=Math.atan2(v,p)-2*Math.PI*y/e.copies-M,R=Math.atan2(Math.sin(b),Math.cos(b));a.push({cell:u,tooth:y,side:"left",pressure:f,corners:d,surface:i.surfaces[2*u+h],offset:R})}}let l=new Map,c=u=>`${u.tooth} ${u.surface}`;for(let u of a)l.set(c(u),(l.get(c(u))??0)+u.pressure*u.offset);return a.map(({surface:u,offset:f,...h})=>({...h,side:l.get(c({...h,surface:u}))>=0?"left":"right"})).sort((u,f)=>u.pressure-f.pressure)}function e2(n,e){let[t,i,s]=[e[0]-n[9],e[1]-n[10],e[2]-n[11]];return[n[0]*t+n[3]*i+n[6]*s,n[1]*t+n[4]*i+n[7]*s,n[2]*t+n[5]*i+n[8]*s]}function t2(n){return[(n[0]+n[2]+n[4]+n[6])/4,(n[1]+n[3]+n[5]+n[7])/4]}function Jy(n){let e=0;for(let{side:t,pressure:i,corners:s}of n){let r=Math.abs((s[4]-s[0])*(s[7]-s[3])-(s[5]-s[1])*(s[6]-s[2]))/2;e+=(t==="left"?1:-1)*i*r}return e>=0?"left":"right"}function jp(n,{tooth:e,side:t}){return n.side===t&&(e===null||n.tooth===e)}var Ph=class{constructor(e,t=1){this.direction=e;this.tip=t;this.cos=Math.cos(e),this.sin=Math.sin(e),this.#e=this.sin<0?-1:1,this.#t=e===0?1:t}direction;tip;cos;sin;#e;#t;along(e,t){return this.#e*(this.cos*e+this.sin*t)}across(e,t){return this.#t*(this.cos*t-this.sin*e)}inverse(e,t){let[i,s]=[this.#e*e,this.#t*t];return[this.cos*i-this.sin*s,this.sin*i+this.cos*s]}get ends(){return this.direction!==0?["toe","heel","root","tip"]:this.tip>0?["−z end","+z end","root","tip"]:["−z end","+z end","tip","root"]}};function Qp(n,e,t){let i={u0:1/0,u1:-1/0,v0:1/0,v1:-1/0},s=(o,a)=>{let[l,c]=[t.along(o,a),t.across(o,a)];i.u0=Math.min(i.u0,l),i.u1=Math.max(i.u1,l),i.v0=Math.min(i.v0,c),i.v1=Math.max(i.v1,c)},r=mr(n)?.flanks[e].outline??[];for(let o of r)for(let a=0;a<o.length;a+=2)s(o[a],o[a+1]);if(r.length===0){let o=n.points;for(let a=0;a<o.length;a+=3)s(o[a+2],Math.hypot(o[a],o[a+1]))}return!(i.u1>i.u0)||!(i.v1>i.v0)?{u0:-.001,u1:.001,v0:0,v1:.001}:i}function Zy(n,e,t){let i=Qp(n,e,t),s=.03*Math.max(i.u1-i.u0,i.v1-i.v0);return{u0:i.u0-s,u1:i.u1+s,v0:i.v0-s,v1:i.v1+s}}function Ky(n,e,t){let[i,s]=[!1,!1];for(let r=0;r<8;r+=2){let[o,a,l,c]=[n[r],n[r+1],n[(r+2)%8],n[(r+3)%8]],u=(l-o)*(t-a)-(c-a)*(e-o);u>0&&(i=!0),u<0&&(s=!0)}return!(i&&s)}function jy(n,e,t){for(let i=n.length-1;i>=0;i--)if(Ky(n[i].corners,e,t))return n[i];return null}var Ih=class{constructor(e,t,i=320){this.bounds=e;this.axes=t;this.columns=i,this.rows=Math.min(Math.max(Math.round(i*(e.v1-e.v0)/(e.u1-e.u0)),40),640),this.values=new Float32Array(this.columns*this.rows)}bounds;axes;columns;rows;values;included=new Set;largest=0;column(e){return(e-this.bounds.u0)/(this.bounds.u1-this.bounds.u0)*this.columns}row(e){return(e-this.bounds.v0)/(this.bounds.v1-this.bounds.v0)*this.rows}add(e){let{columns:t,rows:i,values:s}=this;for(let{corners:r,pressure:o}of e){this.largest=Math.max(this.largest,o);let a=[];for(let h=0;h<8;h+=2){let[d,p]=[r[h],r[h+1]];a.push(this.column(this.axes.along(d,p)),this.row(this.axes.across(d,p)))}let l=[a[0],a[2],a[4],a[6]],c=[a[1],a[3],a[5],a[7]],u=!1,f=(h,d)=>{if(u=!0,h<0||d<0||h>=t||d>=i)return;let p=d*t+h;o>s[p]&&(s[p]=o)};for(let h=Math.max(0,Math.floor(Math.min(...c)));h<=Math.min(i-1,Math.floor(Math.max(...c)));h++)for(let d=Math.max(0,Math.floor(Math.min(...l)));d<=Math.min(t-1,Math.floor(Math.max(...l)));d++)Ky(a,d+.5,h+.5)&&f(d,h);u||f(Math.floor(l.reduce((h,d)=>h+d)/4),Math.floor(c.reduce((h,d)=>h+d)/4))}}at(e,t){let[i,s]=[Math.floor(this.column(e)),Math.floor(this.row(t))];return i<0||s<0||i>=this.columns||s>=this.rows?0:this.values[s*this.columns+i]}};var n2=25,Lh=class{constructor(e){this.core=e}core;pointed=new Map;hovered=-1;#e=null;#t=null;#n="";#i=null;#s=0;#r=!1;gears(){let e=this.core.display?.position?.contacts,t=this.core.parts?.parts??[],i=new Set(e?.parts),s=this.core.state.pattern.gear;return t.filter(r=>r.kind==="gear"&&(i.has(r.index)||r.name===s))}teeth(e){return[...new Set(this.cellsOf(e).map(({tooth:t})=>t))].sort((t,i)=>t-i)}pattern(){let{core:e}=this,{display:t,state:i}=e,s=this.gears(),r=s.find(({name:v})=>v===i.pattern.gear)??s[0];if(!r||!t)return null;let o=new Ph(mr(r)?.direction??0,mr(r)?.tip),a=this.cellsOf(r),l=this.tooth(r),c=i.pattern.flank==="automatic"?Jy(a.filter(v=>l===null||v.tooth===l)):i.pattern.flank,u=Zy(r,c,o),f=i.pattern.envelope?this.envelope(r,o,u,{tooth:l,side:c}):null,h=f?[]:a.filter(v=>jp(v,{tooth:l,side:c})),d=f?.largest??h[h.length-1]?.pressure??0,p=i.colours.field==="contact_pressure"?t.limits:null;return{part:r,axes:o,bounds:u,tooth:l,side:c,cells:h,envelope:f,largest:d,limits:p??[0,d>0?d:1]}}tooth(e){let{tooth:t}=this.core.state.pattern;return t==="pointer"?this.pointed.get(e.index)??null:t!=="all"&&/^\d+$/.test(t)?Number(t):null}cellsOf(e){let t=this.core.display?.position;if(!t)return[];let i=this.core.state.colours.cells,s=this.#e;if(s?.position===t&&s.part===e&&s.choice===i)return s.cells;let r=Kp(t,e,i);return this.#e={position:t,part:e,choice:i,cells:r},r}envelope(e,t,i,s){let{positions:r,state:o}=this.core,a=JSON.stringify([e.name,s,o.colours.cells]);return!this.#t||a!==this.#n||r!==this.#i?(this.#t=new Ih(i,t),this.#n=a,this.#i=r,this.#s++,this.fill(this.#t,e,s,this.#s)):this.#t.included.size<(r?.list.length??0)&&!this.#r&&(this.#s++,this.fill(this.#t,e,s,this.#s)),this.#t}async fill(e,t,i,s){let{core:r}=this,{positions:o}=r,a=()=>s===this.#s&&o===r.positions&&r.state.panels.pattern&&r.state.pattern.envelope;this.#r=!0;let l=performance.now();for(let c=0;o&&c<o.list.length&&a();c++){if(e.included.has(c))continue;let u=await o.load(c).catch(()=>null);if(!a())break;e.included.add(c),u&&e.add(Kp(u,t,r.state.colours.cells).filter(f=>jp(f,i))),!(performance.now()-l<n2)&&(r.changed(!1),await new Promise(f=>setTimeout(f)),l=performance.now())}s===this.#s&&(this.#r=!1),r.changed(!1)}};var i2=6,gr=new Ni,em=new Ni,ea=new bt;function e_(n,e,t){let{scene:i,display:s,state:r}=n;if(!i||!s)return null;i.ray(e,t,gr);let o=s.cutPlane,a=o&&Hn(r.colours.field)?r2(n,e,t,o):null;if(a)return a;let l=Ah(gr,s.views,s.meshes,s.factor,o),c=l2(n,e,t,l?.distance??1/0);if(c)return c;if(!l)return null;let{part:u}=l.view,f=new G,h=s.meshes[u.index]?.[l.mesh],d=r.colours.field==="plain"?null:NaN,p=null,v=null;if(l.cap)return f.copy(l.point).applyMatrix4(ea.copy(l.view.group.matrixWorld).invert()),f.applyMatrix4(Os(s.position?.poses??null,u.index,ea)),v=u.copies>1?h?.copy??l.copy:null,{x:e,y:t,part:u.name,tooth:v,value:null,node:p,point:f};if(h){if(p=a2(n,h,l,e,t),p!==null?f.set(...Us(h,p,0)):l.nodes.forEach((g,m)=>f.addScaledVector(t_.set(...Us(h,g,0)),l.weights[m])),Hn(r.colours.field)){let g=s.values(h,r.colours.field);d=p!==null?g[p]:l.nodes.reduce((m,y,M)=>m+l.weights[M]*g[y],0)}v=u.copies>1?h.copy:null}else o2(u.points,l,f),f.applyAxisAngle(s2,2*Math.PI*l.copy/u.copies),v=u.copies>1?l.copy:null;return f.applyMatrix4(Os(s.position?.poses??null,u.index,ea)),{x:e,y:t,part:u.name,tooth:v,value:d,node:p,point:f}}var s2=new G(0,0,1),t_=new G;function r2(n,e,t,i){let{display:s,state:r}=n,{field:o}=r.colours;if(!s||!Hn(o))return null;let[a]=Th(gr.origin,gr.direction,i);if(!(a>0)||!Number.isFinite(a))return null;let l=gr.at(a,new G);for(let c of s.views){if(!c.showsSections)continue;let u=l.clone().applyMatrix4(ea.copy(c.group.matrixWorld).invert());for(let{mesh:f,section:h}of c.meshes){if(!f||!h?.plane)continue;let d=h.section.find(u.x,u.y,u.z,h.plane);if(d<0)continue;let{nodes:p,weights:v}=Uy(f,h.section.sources[d],s.factor,[u.x,u.y,u.z]),g=s.values(f,o),m=new G;p.forEach((M,b)=>m.addScaledVector(t_.set(...Us(f,M,0)),v[b])),m.applyMatrix4(Os(s.position?.poses??null,c.part.index,ea));let y=p.reduce((M,b,R)=>M+v[R]*g[b],0);return{x:e,y:t,part:c.part.name,tooth:c.part.copies>1?f.copy:null,value:y,node:null,point:m}}}return null}function o2(n,e,t){t.set(0,0,0),e.nodes.forEach((i,s)=>{let r=e.weights[s];t.x+=r*n[3*i],t.y+=r*n[3*i+1],t.z+=r*n[3*i+2]})}function a2(n,e,t,i,s){let r=n.scene,o=n.display.factor,a=null,l=i2,c=new G;for(let u of t.nodes){c.set(...Us(e,u,o)),c.applyMatrix4(t.view.group.matrixWorld).project(r.camera.active);let f=Math.hypot((.5+.5*c.x)*r.width-i,(.5-.5*c.y)*r.height-s);f<=l&&(l=f,a=u)}return a}function l2(n,e,t,i){let{display:s,state:r}=n,o=s?.position,a=r.colours.field==="contact_pressure"?o?.contacts:null;if(!a||!o||!s)return null;let l=ea.copy(n.scene.root.matrixWorld).invert();em.copy(gr).applyMatrix4(l);let c=Th(gr.origin,gr.direction,s.cutPlane);r.hidden_contacts||(c[1]=Math.min(c[1],i+.002*s.radius));let u=Wy(em,a,p=>s.cellShown(r,o,p),c);if(!u)return null;let f=em.at(u.distance,new G),h=r.parts[Qy(n,a.parts[2*u.cell])]==="hidden"?1:0,d=a.parts[2*u.cell+h];return{x:e,y:t,part:Qy(n,d),tooth:a.teeth[2*u.cell+h],cell:u.cell,value:a.pressures[u.cell],node:null,point:f}}function Qy(n,e){return n.parts?.parts[e]?.name??`part ${e}`}var ta=new Map;function n_(n,e,t){let i=ta.get(n);if(!i){let s=t(n).then(o=>Iy(n,o)),r={shape:s,users:new Set};ta.set(n,r),s.catch(()=>ta.get(n)===r&&ta.delete(n)),i=r}return i.users.add(e),i.shape}function tm(n){for(let[e,{users:t}]of ta)t.delete(n)&&t.size===0&&ta.delete(e)}function Sl(n){return`position-${String(n).padStart(4,"0")}.bin`}var c2=384e6,Nh=class{constructor(e,t){this.source=e;this.parts=t}source;parts;list=[];#e=new Map;#t=new Map;#n=0;#i=!1;async update(){this.list=await this.source.positions()}cached(e){return this.#e.get(e)}load(e){let t=this.#e.get(e);if(t)return this.#e.delete(e),this.#e.set(e,t),Promise.resolve(t);let i=this.#t.get(e);if(i)return i;let s=this.read(e).finally(()=>this.#t.delete(e));return this.#t.set(e,s),s}async read(e){let t=this.list[e],i=Sl(t?.position??e),s=await Ly(i,await this.source.position(e),this.parts,r=>n_(r,this,async o=>{if(!this.source.mesh)throw new Error(`${o}: this source contains no meshes`);return this.source.mesh(o)}));if(this.#i&&tm(this),this.#i||s.problem)return s;this.#e.set(e,s),this.#n+=s.bytes;for(let[r,o]of this.#e){if(this.#n<=c2||r===e)break;this.#e.delete(r),this.#n-=o.bytes}return s}dispose(){this.#i=!0,tm(this),this.#e.clear(),this.#n=0}};var nm=24,u2=260,h2={front:[-90,0],back:[90,0],left:[180,0],right:[0,0],top:[-90,90],bottom:[-90,-90],isometric:[-50,30]},Dh=class{perspective=new si(nm);orthographic=new Vo;onChange=null;#e={projection:"perspective",target:[0,0,0],azimuth:-50,elevation:30,height:1};#t=1;#n=new G;#i=1;#s=[];#r=!1;#o=!1;#a=0;#c=new G;#h=new G;#l=new G;get active(){return this.#e.projection==="perspective"?this.perspective:this.orthographic}get state(){let e={...this.#e,target:[...this.#e.target]};return this.#r?e.fitted=!0:delete e.fitted,e}setBounds(e,t,i){this.#n.copy(e),this.#i=t>0?t:1,this.#s=i,this.update()}setFitPoints(e){this.#s=e}setAspect(e){this.#t=e>0?e:1,this.#r&&Object.assign(this.#e,this.fitted(this.#e.azimuth,this.#e.elevation)),this.update()}set(e,t=!1){this.interrupt(),this.#e={...e,target:[...e.target]},e.fitted&&(Object.assign(this.#e,this.fitted(e.azimuth,e.elevation)),this.#r=!0),this.changed(t)}setProjection(e){this.#e.projection=e,this.changed(!0)}orbit(e,t){this.interrupt(),this.#e.azimuth=sm(this.#e.azimuth+e),this.#e.elevation=im(this.#e.elevation+t,-90,90),this.changed(!0)}pan(e,t){this.interrupt(),this.shift(e,t),this.changed(!0)}zoom(e,t=0,i=0){this.interrupt();let s=im(this.#e.height*e,this.#i*1e-4,this.#i*40),r=s/this.#e.height;this.shift(-t*(1-r),-i*(1-r)),this.#e.height=s,this.changed(!0)}view(e,t=!0){let[i,s]=h2[e],r={...this.#e,azimuth:i,elevation:s};this.#o=t,t&&Object.assign(r,this.fitted(i,s)),this.animateTo(r)}fit(e=!0){let t={...this.#e,...this.fitted(this.#e.azimuth,this.#e.elevation)};this.#o=!0,e?this.animateTo(t):this.set({...t,fitted:!0},!0)}interrupt(){cancelAnimationFrame(this.#a),this.#r=!1}fitted(e,t){if(this.#s.length===0){let d=2.1*this.#i/Math.min(1,this.#t);return{target:[this.#n.x,this.#n.y,this.#n.z],height:d}}let[i,s,r]=[new G,new G,new G];i_(e,t,i,s,r);let o=new ci,a=new G,l=this.#s.map(d=>new G(d.dot(i),d.dot(s),d.dot(r)));for(let d of l)o.expandByPoint(d);let c=o.getCenter(a),u=this.#e.projection==="perspective"?Math.tan(nm*Math.PI/360):0,f=.001*this.#i;for(let d of l){let p=(d.z-c.z)*u;f=Math.max(f,2*(Math.abs(d.y-c.y)+p),2*(Math.abs(d.x-c.x)/this.#t+p))}f*=1.1;let h=i.multiplyScalar(c.x).addScaledVector(s,c.y).addScaledVector(r,c.z);return{target:[h.x,h.y,h.z],height:f}}animateTo(e){if(cancelAnimationFrame(this.#a),matchMedia("(prefers-reduced-motion: reduce)").matches){this.set({...e,fitted:this.#o},!0);return}let t=this.state,i=sm(e.azimuth-t.azimuth),s=performance.now(),r=o=>{let a=im((o-s)/u2,0,1),l=a*a*(3-2*a);this.#e.azimuth=sm(t.azimuth+l*i),this.#e.elevation=t.elevation+l*(e.elevation-t.elevation),this.#e.height=t.height*(e.height/t.height)**l;for(let c=0;c<3;c++)this.#e.target[c]=t.target[c]+l*(e.target[c]-t.target[c]);a===1&&(this.#e={...e,target:[...e.target]},this.#r=this.#o),this.changed(!0),a<1&&(this.#a=requestAnimationFrame(r))};this.#a=requestAnimationFrame(r)}shift(e,t){let{height:i,target:s}=this.#e;for(let r=0;r<3;r++){let o=this.#c.getComponent(r),a=this.#h.getComponent(r);s[r]-=i*(e*o+t*a)}}changed(e){this.update(),this.onChange?.(e)}get direction(){return this.#l}update(){let{azimuth:e,elevation:t,height:i,target:s}=this.#e;i_(e,t,this.#c,this.#h,this.#l);let r=i/(2*Math.tan(nm*Math.PI/360)),o=s[0],a=s[1],l=s[2],c=r-(this.#n.x-o)*this.#l.x-(this.#n.y-a)*this.#l.y-(this.#n.z-l)*this.#l.z,u=1.3*this.#i+.02*i;for(let h of[this.perspective,this.orthographic])h.position.set(o+r*this.#l.x,a+r*this.#l.y,l+r*this.#l.z),h.matrix.makeBasis(this.#c,this.#h,this.#l),h.quaternion.setFromRotationMatrix(h.matrix),h.updateMatrixWorld();this.perspective.near=Math.max(c-u,r*.02),this.perspective.far=Math.max(c+u,this.perspective.near*1.1),this.perspective.aspect=this.#t,this.perspective.updateProjectionMatrix();let f=this.orthographic;f.near=c-u,f.far=c+u,f.top=i/2,f.bottom=-i/2,f.right=i/2*this.#t,f.left=-f.right,f.updateProjectionMatrix()}};function i_(n,e,t,i,s){let r=n*Math.PI/180,o=e*Math.PI/180;t.set(-Math.sin(r),Math.cos(r),0),s.set(Math.cos(o)*Math.cos(r),Math.cos(o)*Math.sin(r),Math.sin(o)),i.crossVectors(s,t)}function im(n,e,t){return Math.min(Math.max(n,e),t)}function sm(n){return((n+180)%360+360)%360-180}var na=class extends Error{constructor(){super("This browser cannot draw three-dimensional pictures: WebGL 2 is not available. Turn on hardware acceleration in the browser's settings, or use another browser."),this.name="NoWebGlError"}},Fh=class{constructor(e){this.container=e;this.uniforms=ey(this.scaleTexture);let t=this.canvas.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0,depth:!0,powerPreference:"high-performance"});if(!t)throw new na;this.#e=new nh({canvas:this.canvas,context:t,stencil:!0,alpha:!0}),this.#e.setClearColor(0,0),this.root.matrixAutoUpdate=!1,this.scene.add(this.root),e.append(this.canvas),this.#t=new ResizeObserver(()=>this.resize()),this.#t.observe(e),this.canvas.addEventListener("webglcontextrestored",()=>this.invalidate()),this.resize()}container;canvas=document.createElement("canvas");camera=new Dh;scene=new Va;root=new sn;uniforms;scaleTexture=cy();onPrepare=null;onFrame=null;frames=0;width=1;height=1;#e;#t;#n=0;#i=new Is;#s=new bt;resize(){this.width=Math.max(this.container.clientWidth,1),this.height=Math.max(this.container.clientHeight,1);let e=Math.min(window.devicePixelRatio||1,2);this.uniforms.pixelRatio.value=e,this.#e.setPixelRatio(e),this.#e.setSize(this.width,this.height),this.camera.setAspect(this.width/this.height),this.draw()}invalidate(){this.#n||(this.#n=requestAnimationFrame(()=>{this.#n=0,this.draw()}))}frustum(){let{active:e}=this.camera;return this.#s.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this.#i.setFromProjectionMatrix(this.#s)}draw(){this.scene.updateMatrixWorld(),this.onPrepare?.(),this.#e.render(this.scene,this.camera.active),this.frames++,this.onFrame?.()}snapshot(e){let t=this.#e.getPixelRatio(),i=document.createElement("canvas");try{this.uniforms.pixelRatio.value=e,this.#e.setPixelRatio(e),this.#e.setSize(this.width,this.height,!1),this.draw(),i.width=this.canvas.width,i.height=this.canvas.height,i.getContext("2d").drawImage(this.canvas,0,0)}finally{this.uniforms.pixelRatio.value=t,this.#e.setPixelRatio(t),this.#e.setSize(this.width,this.height),this.draw()}return i}ray(e,t,i){let{active:s}=this.camera,r=2*e/this.width-1,o=1-2*t/this.height;return i.origin.set(r,o,-1).unproject(s),i.direction.set(r,o,1).unproject(s).sub(i.origin).normalize(),i}dispose(){cancelAnimationFrame(this.#n),this.#t.disconnect(),this.scaleTexture.dispose(),this.#e.dispose(),this.#e.forceContextLoss(),this.canvas.remove()}};var Uh=class{constructor(e,t){this.element=e;this.changed=t;this.#t.addEventListener("change",this.#n)}element;changed;theme="light";#e="system";#t=matchMedia("(prefers-color-scheme: dark)");#n=()=>{this.set(this.#e),this.changed()};set(e){this.#e=e,this.theme=e==="system"?this.#t.matches?"dark":"light":e,this.element.dataset.theme=this.theme}dispose(){this.#t.removeEventListener("change",this.#n)}};var d2=640,f2=900,p2=100,kh=class{constructor(e,t,i){this.element=e;this.state=bh(i,_h()),this.#i=i.colours?.field!==void 0,this.#s=i.colours?.cells!==void 0,this.theme=new Uh(e,()=>this.changed()),this.theme.set(this.state.theme),this.#c.observe(e);try{this.scene=new Fh(t),this.display=new Mh(this.scene)}catch(o){this.fail(o instanceof na?o:new na);return}let{scene:s,display:r}=this;t.append(this.labels.element),s.onPrepare=()=>r.prepareFrame(),s.onFrame=()=>{this.labels.update(s.camera.active,s.root.matrix,s.width,s.height),this.#a||=window.setTimeout(()=>this.updateMarks(),p2)},s.camera.onChange=o=>{this.state.camera=s.camera.state,this.probe=null,s.invalidate(),this.changed(o)}}element;state;status="empty";failure="";notice="";source=null;parts=null;positions=null;probe=null;help=!1;narrow=!1;drawers=!1;drawer=null;progress=null;scene=null;display=null;labels=new Eh;animation=new ah(this);pattern=new Lh(this);theme;onChange=null;#e=new Set;#t=0;#n=0;#i;#s;#r=new Map;#o="";#a=0;#c=new ResizeObserver(()=>this.resize());resize(){let e=this.element.clientWidth,t=e>0&&e<d2,i=e>0&&e<f2;t===this.narrow&&i===this.drawers||(this.narrow=t,this.drawers=i,this.drawer=null,this.element.toggleAttribute("data-narrow",t),this.element.toggleAttribute("data-drawers",i),this.changed(!1))}isOpen(e){return this.drawers?this.drawer===e:this.state.panels[e]}toggle(e,t=!this.isOpen(e)){this.drawers?this.setDrawer(t?e:null):this.update({panels:{[e]:t}})}setDrawer(e){this.drawer=e,this.changed(!1)}subscribe(e){return this.#e.add(e),()=>this.#e.delete(e)}changed(e=!0){e&&(this.#h=!0),!this.#t&&(this.#t=requestAnimationFrame(()=>{this.#t=0;for(let t of this.#e)t();this.#h&&this.onChange?.(structuredClone(this.state)),this.#h=!1}))}#h=!1;fail(e){this.status="failed",this.failure=e instanceof Error?e.message:String(e),this.changed(!1)}async show(e){this.scene&&(this.source=e,this.status!=="ready"&&(this.status="loading"),this.notice="",this.changed(!1),await this.load(!0))}async reload(){this.source&&this.scene&&await this.load(!1)}async load(e){let{source:t,display:i,scene:s}=this;if(!t||!i||!s)return;let r=++this.#n,o=()=>r!==this.#n;e&&this.animation.stop();try{let a=Py(await t.parts()),l=new Nh(t,a.parts),c="";try{await l.update()}catch(f){c=`The list of positions cannot be read: ${Oh(f)}`}let u=l.list.length>0?await l.load(0).catch(f=>(c=Oh(f),null)):null;if(o()){l.dispose();return}u?.problem&&(c=s_(u)),this.positions?.dispose(),this.parts=a,by(a.units),this.positions=l,this.#r.clear(),this.notice=c,i.setParts(a.parts,u),i.setPosition(u),!this.#i&&u&&(ph(u)||u.contacts)&&(this.#i=!0,this.state.colours.field=ph(u)?"von_mises":"contact_pressure"),!this.#s&&u?.contacts&&(this.#s=!0,iy(u.contacts)&&(this.state.colours.cells="flanks")),this.state.position=Math.min(Math.max(0,Math.trunc(this.state.position)),Math.max(0,l.list.length-1)),this.status="ready",this.apply(),i.updateBounds(),this.state.camera?s.camera.set(this.state.camera):a.parts.length>0&&s.camera.fit(!1),this.state.position>0&&await this.goTo(this.state.position),this.changed()}catch(a){o()||this.fail(a)}}async updatePositions(){let{positions:e}=this;if(!e)return;let t=e.list.length===0;try{await e.update()}catch(i){this.notice=`The list of positions cannot be read: ${Oh(i)}`}this.#r.clear(),t&&e.list.length>0?await this.load(!0):this.update({})}update(e){let t=this.state;this.state=bh(e,t),e.colours?.field&&(this.#i=!0),e.colours?.cells&&(this.#s=!0),this.probe=null,this.theme.set(this.state.theme),e.camera&&this.scene&&this.scene.camera.set(this.state.camera),this.apply(),e.parts&&this.display?.updateBounds(),e.position!==void 0&&this.goTo(this.state.position),this.changed()}apply(){let{display:e,scene:t}=this;if(!e||!t||this.status!=="ready")return;let i=e.apply(this.state,this.#r.get(this.limitsKey())??null);this.labels.set(i),t.invalidate(),this.state.colours.limits==="all"&&this.findAllLimits()}setVisibility(e,t){let i={...this.state.parts};for(let s of e)i[s]=t;this.update({parts:i})}async goTo(e){let{positions:t,display:i}=this;if(!t||!i||t.list.length===0)return;let s=Math.min(Math.max(0,e),t.list.length-1);this.state.position=s,this.changed();try{let r=await t.load(s);if(t!==this.positions||this.state.position!==s)return;this.notice=s_(r),i.position!==r&&i.setPosition(r),this.probe=null,this.apply()}catch(r){if(t!==this.positions||this.state.position!==s)return;this.animation.stop(),this.notice=`${Oh(r)}. The picture shows another position.`}this.changed()}limitsKey(){let e=Object.entries(this.state.parts).filter(([,t])=>t==="hidden");return JSON.stringify([this.state.colours.field,this.state.colours.cells,e.map(([t])=>t).sort()])}async findAllLimits(){let{positions:e,display:t,state:i}=this,s=this.limitsKey();if(!e||!t||i.colours.field==="plain"||this.#r.has(s)||this.#o===s)return;this.#o=s;let r=()=>this.#o===s&&e===this.positions&&this.state.colours.limits==="all",o=null;for(let l=0;l<e.list.length&&r();l++){this.progress=l/e.list.length,this.changed(!1);let c=await e.load(l).catch(()=>null),u=c&&r()?t.limitsOf(c,this.state):null;u&&(o=o?[Math.min(o[0],u[0]),Math.max(o[1],u[1])]:u)}if(this.#o!==s)return;let a=r();this.#o="",this.progress=null,a&&(o?this.#r.set(s,o):this.#r.set(s,[0,1]),this.apply()),this.changed(!1)}probePointer(e,t){this.probe=this.status==="ready"?e_(this,e,t):null,this.state.panels.pattern&&this.followPointer(),this.changed(!1)}followPointer(){let{probe:e,pattern:t}=this,i=e?.cell??-1,s=this.display?.position?.contacts;for(let o=0;s&&i>=0&&o<2;o++)t.pointed.set(s.parts[2*i+o],s.teeth[2*i+o]);let r=this.parts?.parts.find(({name:o})=>o===e?.part);e&&i<0&&r&&e.tooth!==null&&t.pointed.set(r.index,e.tooth),this.hover(i)}hover(e){let{display:t,scene:i,pattern:s}=this;s.hovered=e,t?.contacts.mark(t.position?.contacts??null,e)&&i?.invalidate(),this.changed(!1)}updateMarks(){clearTimeout(this.#a),this.#a=0;let{scene:e,display:t}=this;!e||!t||this.status!=="ready"||(this.labels.hide(i=>Xy(e,t,i)),this.labels.arrange(e.width,e.height,this.element.querySelector(".cv-legend")?.getBoundingClientRect()??null))}clearProbe(){this.pattern.hovered>=0&&this.hover(-1),this.probe&&(this.probe=null,this.changed(!1))}get hasMeshes(){return(this.display?.position?.meshes.length??0)>0}get missingField(){let{field:e}=this.state.colours,t=this.display?.position;return e==="plain"||this.status!=="ready"?!1:e==="displacement"?!this.hasMeshes:Hn(e)?!t||!ph(t):!t?.contacts}project(e,t){let{scene:i,display:s}=this,r=s?.views.find(l=>l.part.name===e);if(!i||!r)return null;let o=new G(...t).applyMatrix4(r.group.matrixWorld).project(i.camera.active),a=i.canvas.getBoundingClientRect();return{x:a.left+(.5+.5*o.x)*i.width,y:a.top+(.5-.5*o.y)*i.height}}nodalValue(e,t){let{display:i,parts:s}=this,r=s?.parts.findIndex(l=>l.name===e)??-1,o=i?.meshes[r]?.[0],{field:a}=this.state.colours;return o&&i&&Hn(a)?i.values(o,a)[t]??NaN:NaN}dispose(){this.#n++,cancelAnimationFrame(this.#t),clearTimeout(this.#a),this.#c.disconnect(),this.animation.stop(),this.positions?.dispose(),this.display?.dispose(),this.scene?.dispose(),this.theme.dispose(),this.#e.clear()}};function s_({problem:n}){return n&&`${n}. The mesh is not displayed.`}function Oh(n){return n instanceof kt||n instanceof Error?n.message:String(n)}var r_=.35,m2=18;function o_(n,e){let t=n.scene,i=new Map,s=null,r=0,o=0,a=0,l=new G,c=d=>{let p=e.getBoundingClientRect();return{x:d.clientX-p.left,y:d.clientY-p.top}},u=(d,p)=>{if(!n.state.cut.on)return!1;let v=l.copy(n.display.cut.handle).project(t.camera.active);return Math.hypot((.5+.5*v.x)*t.width-d,(.5-.5*v.y)*t.height-p)<m2};e.addEventListener("pointerdown",d=>{e.setPointerCapture(d.pointerId),e.focus({preventScroll:!0}),n.drawer&&n.setDrawer(null);let{x:p,y:v}=c(d);i.set(d.pointerId,{x:p,y:v}),i.size>1?s="pan":d.button===0&&u(p,v)?s="cut":s=d.button===0&&!d.shiftKey?"orbit":"pan",n.clearProbe(),n.display?.setDragging(s==="cut",n.state),e.dataset.drag=s}),e.addEventListener("pointermove",d=>{let{x:p,y:v}=c(d),g=i.get(d.pointerId);if(!g||!s){let M=u(p,v);e.dataset.handle=String(M),n.display?.cut.setHighlight(M),o=p,a=v,r||=requestAnimationFrame(()=>{r=0,n.probePointer(o,a)});return}let m=p-g.x,y=v-g.y;if(i.size===2){let M=[...i].find(([T])=>T!==d.pointerId)[1],b=Math.hypot(g.x-M.x,g.y-M.y),R=Math.hypot(p-M.x,v-M.y);t.camera.pan(m/2/t.height,-y/2/t.height),b>0&&R>0&&t.camera.zoom(b/R,...h((p+M.x)/2,(v+M.y)/2))}else if(s==="orbit")t.camera.orbit(-m*r_,y*r_);else if(s==="pan")t.camera.pan(m/t.height,-y/t.height);else{let{cut:M}=n.display;a_(n,M.drag(m,y,t.camera.active,t.width,t.height))}g.x=p,g.y=v});let f=d=>{i.delete(d.pointerId),i.size===0&&(s=null,n.display?.setDragging(!1,n.state),delete e.dataset.drag)};e.addEventListener("pointerup",f),e.addEventListener("pointercancel",f),e.addEventListener("pointerleave",()=>{cancelAnimationFrame(r),r=0,n.clearProbe()}),e.addEventListener("contextmenu",d=>d.preventDefault()),e.addEventListener("dblclick",()=>t.camera.fit());let h=(d,p)=>[(d-t.width/2)/t.height,(t.height/2-p)/t.height];e.addEventListener("wheel",d=>{d.preventDefault();let{x:p,y:v}=c(d),g=d.deltaY*(d.deltaMode===1?16:1);t.camera.zoom(Math.exp(Math.min(Math.max(g,-240),240)*.0016),...h(p,v))},{passive:!1})}function a_(n,e){let{cut:t}=n.display,i=Math.min(Math.max(t.offset+e,t.range[0]),t.range[1]);n.update({cut:{offset:i}})}function ia(n,e){let t=e.normal??n.state.cut.normal,i=n.scene.camera.direction,s=typeof t=="string"?i[t]:i.x*t[0]+i.y*t[1]+i.z*t[2];n.update({cut:{...e,...e.normal?{offset:null}:{},...e.on===!1?{}:{flipped:s<0}}})}var l_=[["View",[{keys:"F",label:"Fit the parts into the picture"},{keys:"1 … 6",label:"Front, back, left, right, top, bottom"},{keys:"7",label:"Isometric"},{keys:"P",label:"Perspective or orthographic"},{keys:"Arrow keys",label:"Orbit (picture focused)"},{keys:"Shift + arrow keys",label:"Pan (picture focused)"},{keys:"+ −",label:"Zoom"}]],["Display",[{keys:"M",label:"Edges of the finite elements"},{keys:"V",label:"Force vectors"},{keys:"C",label:"Cutting plane"},{keys:"[ ]",label:"Move the cutting plane"},{keys:"D",label:"Undeformed, true or automatic deformation"}]],["Animation",[{keys:"K",label:"Play or pause"},{keys:", .",label:"Previous or next position"}]],["Panels",[{keys:"B",label:"Parts"},{keys:"S",label:"Settings"},{keys:"G",label:"Plots"},{keys:"U",label:"Contact pattern on the unrolled flank"},{keys:"?",label:"This help"},{keys:"Esc",label:"Close"}]],["Pointer",[{keys:"Drag",label:"Orbit"},{keys:"Right or Shift + drag",label:"Pan"},{keys:"Wheel",label:"Zoom at the pointer"},{keys:"Double click",label:"Fit"}]]],g2={1:"front",2:"back",3:"left",4:"right",5:"top",6:"bottom",7:"isometric"};function c_(n,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let t=e.target;if(t.closest("input:not([type=checkbox]):not([type=range]), select, textarea"))return!1;let{scene:i,state:s,animation:r}=n;if(e.key==="?")return n.help=!n.help,n.changed(!1),!0;if(e.key==="Escape"&&n.help)return n.help=!1,n.changed(!1),!0;if(e.key==="Escape"&&n.drawer)return n.setDrawer(null),!0;if(!i||n.status!=="ready")return!1;let{camera:o}=i;if(t===i.canvas&&e.key.startsWith("Arrow")){let u=e.key==="ArrowRight"?1:e.key==="ArrowLeft"?-1:0,f=e.key==="ArrowUp"?1:e.key==="ArrowDown"?-1:0;return e.shiftKey?o.pan(.05*u,.05*f):o.orbit(-6*u,-6*f),!0}let a=g2[e.key];if(a)return o.view(a),!0;let{panels:l,forces:c}=s;switch(e.key.toLowerCase()){case"f":o.fit();break;case"p":o.setProjection(s.camera?.projection==="orthographic"?"perspective":"orthographic");break;case"+":case"=":o.zoom(.85);break;case"-":case"_":o.zoom(1/.85);break;case"m":n.update({mesh_edges:!s.mesh_edges});break;case"v":{let u=!(c.bearings||c.meshes);n.update({forces:{bearings:u,meshes:u}});break}case"c":ia(n,{on:!s.cut.on});break;case"[":case"]":s.cut.on&&a_(n,(e.key==="["?-.04:.04)*n.display.radius);break;case"d":n.update({deformation:x2(n)});break;case"k":r.toggle();break;case",":r.step(-1);break;case".":r.step(1);break;case"b":n.toggle("parts");break;case"s":n.toggle("settings");break;case"g":n.update({panels:{plots:!l.plots}});break;case"u":n.update({panels:{pattern:!l.pattern}});break;default:return!1}return!0}function x2(n){let{mode:e,factor:t}=n.state.deformation;return e==="automatic"?{mode:"factor",factor:0}:t===0?{mode:"factor",factor:1}:{mode:"automatic",factor:1}}function Bh(n,e,t){let i=(e-n)/Math.max(t,1),s=10**Math.floor(Math.log10(i)),r=[1,2,5,10].map(a=>a*s).find(a=>a>=i)??10*s,o=[];for(let a=Math.ceil(n/r-1e-9);a*r<=e+1e-9*r;a++)o.push(a*r);return o}var v2=.09;function zh(n,e,t){let i=v2*(e-n);return[n,...Bh(n,e,t).filter(s=>s>n+i&&s<e-i),e]}function Ml(n){let{field:e}=n.state.colours;if(Ei[e].quantity==="stress")return Oi();if(Ei[e].quantity==="none")return{symbol:"",factor:1};let t=n.display?.limits;return Tn("m",t?Math.max(Math.abs(t[0]),Math.abs(t[1])):0)}function sa(n){return Ei[n.state.colours.field].label}function Vh(n){let e=Ml(n),t=n.display?.limits;if(!t)return{ticks:[],unit:e.symbol};let{bands:i}=n.state.colours,s=t[0]*e.factor,r=t[1]*e.factor;return s===r?{ticks:[{fraction:.5,text:Ft(s)}],unit:e.symbol}:{ticks:(i>0&&i<=12?Array.from({length:i+1},(l,c)=>s+c/i*(r-s)):zh(s,r,5)).map(l=>({fraction:(l-s)/(r-s),text:Ft(Math.abs(l)<1e-9*Math.abs(r-s)?0:l,4)})),unit:e.symbol}}var ks={left:58,right:92,top:20,bottom:36},rm=14,h_=.6,ra=class{constructor(e,t,{bounds:i},s=!0){this.width=e;this.height=t;this.bar=s;let r=Math.max(e-ks.left-(s?ks.right:12),40),o=Math.max(t-ks.top-ks.bottom,30);this.scale=Math.min(r/(i.u1-i.u0),o/(i.v1-i.v0)),this.left=ks.left+(r-this.scale*(i.u1-i.u0))/2,this.bottom=ks.top+(o+this.scale*(i.v1-i.v0))/2,this.right=this.left+this.scale*(i.u1-i.u0),this.top=this.bottom-this.scale*(i.v1-i.v0),this.#e=this.left-this.scale*i.u0,this.#t=this.bottom+this.scale*i.v0}width;height;bar;scale;#e;#t;right;top;left;bottom;x(e){return this.#e+this.scale*e}y(e){return this.#t-this.scale*e}inverse(e,t){return[(e-this.#e)/this.scale,(this.#t-t)/this.scale]}};function Hh(n,[e,t],i){let s=Math.min(Math.max((n-e)/(t-e||1),0),1);return Gr(fr(i.scale,Hr(s,i.bands)))}function Xh(n,e,t,i,s,r=-1){let{axes:o,side:a,part:l,limits:c}=t,u=d=>{let p=[];for(let v=0;v<d.length;v+=2){let[g,m]=[d[v],d[v+1]];p.push(e.x(o.along(g,m)),e.y(o.across(g,m)))}return p},f=(mr(l)?.flanks[a].outline??[]).map(u);n.fill(f,s.flank),t.envelope&&y2(n,e,t,i);for(let{corners:d,pressure:p}of t.cells)n.fill([u(d)],Hh(p,c,i),!0);for(let d of f)n.stroke(d,s.muted,1,!0);let h=t.cells.find(({cell:d})=>d===r);h&&n.stroke(u(h.corners),s.mark,2,!0),_2(n,e,t,s),e.bar&&b2(n,e,c,i,s)}function y2(n,e,{envelope:t,limits:i},s){let{bounds:r,columns:o,rows:a,values:l}=t,c=(r.u1-r.u0)/o,u=(r.v1-r.v0)/a;for(let f=0;f<a;f++){let h=e.y(r.v0+(f+1)*u),d=e.y(r.v0+f*u);for(let p=0;p<o;){let v=l[f*o+p],g=p++;if(!(v>0))continue;let m=Hh(v,i,s);for(;p<o&&l[f*o+p]>0&&Hh(l[f*o+p],i,s)===m;)p++;let[y,M]=[e.x(r.u0+g*c),e.x(r.u0+p*c)];n.fill([[y,h,M,h,M,d,y,d]],m,!0)}}}function om({part:n,side:e,axes:t}){if(t.direction===0)return[0,0];let{u0:i,v0:s}=Qp(n,e,t);return[i,s]}function _2(n,e,t,i){let{left:s,right:r,top:o,bottom:a}=e,{factor:l,symbol:c}=Tn("m",1),{bounds:u,axes:f}=t,[h,d]=om(t),p=f.direction===0;n.stroke([s,o,s,a,r,a],i.muted,1);for(let M of Bh((u.u0-h)*l,(u.u1-h)*l,Math.min((r-s)/60,10))){let b=e.x(M/l+h);n.stroke([b,a,b,a+4],i.muted,1),n.text(b,a+15,Ft(M),i.muted,"middle")}for(let M of Bh((u.v0-d)*l,(u.v1-d)*l,Math.min((a-o)/26,8))){let b=e.y(M/l+d);n.stroke([s-4,b,s,b],i.muted,1),n.text(s-7,b+4,Ft(M),i.muted,"end")}let[v,g,m,y]=f.ends;n.text(s,a+30,v,i.muted,"start"),n.text(r,a+30,g,i.muted,"end"),n.text(s-16,a+16,m,i.muted,"end"),n.text(s-16,o-8,y,i.muted,"end"),n.text((s+r)/2,a+30,`${p?"z":"along the face"} in ${c}`,i.text,"middle"),n.text(s-44,(o+a)/2,`${p?"radius":"across the face"} in ${c}`,i.text,"middle",!0)}function b2(n,e,t,i,s){let r=e.width-ks.right+22,[o,a]=[ks.top+16,e.height-ks.bottom],l=Oi(),c=i.bands>0?i.bands:48;for(let h=0;h<c;h++){let d=t[0]+(h+.5)/c*(t[1]-t[0]),[p,v]=[a-h*(a-o)/c,a-(h+1)*(a-o)/c];n.fill([[r,p,r+rm,p,r+rm,v,r,v]],Hh(d,t,i),!0)}n.text(r,o-7,l.symbol,s.text,"start");let[u,f]=[t[0]*l.factor,t[1]*l.factor];for(let h of zh(u,f,a-o<90?2:4)){let d=a-(h-u)/(f-u||1)*(a-o);n.text(r+rm+6,d+4,Ft(h),s.muted,"start")}}var Gh=class{constructor(e){this.context=e}context;fill(e,t,i=!1){let{context:s}=this;s.fillStyle=t,s.beginPath();for(let r of e)this.path(r,!0);s.fill("evenodd"),i&&(s.strokeStyle=t,s.lineWidth=h_,s.stroke())}stroke(e,t,i,s=!1){let{context:r}=this;r.strokeStyle=t,r.lineWidth=i,r.beginPath(),this.path(e,s),r.stroke()}path(e,t){let{context:i}=this;for(let s=0;s<e.length;s+=2)s===0?i.moveTo(e[0],e[1]):i.lineTo(e[s],e[s+1]);t&&i.closePath()}text(e,t,i,s,r,o=!1){let{context:a}=this;a.fillStyle=s,a.textAlign=r==="middle"?"center":r,a.save(),a.translate(e,t),o&&a.rotate(-Math.PI/2),a.fillText(i,0,0),a.restore()}},Wh=class{elements=[];fill(e,t,i=!1){e.length!==0&&this.elements.push(`<path d="${e.map(s=>u_(s,!0)).join("")}" fill="${t}"${i?` stroke="${t}" stroke-width="${h_}"`:' fill-rule="evenodd"'}/>`)}stroke(e,t,i,s=!1){this.elements.push(`<path d="${u_(e,s)}" fill="none" stroke="${t}" stroke-width="${i}"/>`)}text(e,t,i,s,r,o=!1){let a=o?` transform="rotate(-90 ${e.toFixed(1)} ${t.toFixed(1)})"`:"";this.elements.push(`<text x="${e.toFixed(1)}" y="${t.toFixed(1)}" fill="${s}" text-anchor="${r}"${a}>${$h(i)}</text>`)}};function u_(n,e){let t="";for(let i=0;i<n.length;i+=2)t+=`${i===0?"M":"L"}${n[i].toFixed(2)} ${n[i+1].toFixed(2)}`;return e?`${t}Z`:t}function $h(n){return n.replace(/[&<>"]/g,e=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[e])}function d_(n,e,t,i){let s=new TextEncoder,r=[],o=[],a=0,l=d=>{let p=typeof d=="string"?s.encode(d):d;r.push(p),a+=p.length},c=(d,p)=>{o.push(a),l(`${o.length} 0 obj
${d}
`),p!==void 0&&(l(`stream
`),l(p),l(`
endstream
`)),l(`endobj
`)},u=Math.round(842*t/e),f=`q 842 0 0 ${u} 0 0 cm /Picture Do Q`;l(`%PDF-1.4
`),c("<< /Type /Catalog /Pages 2 0 R >>"),c("<< /Type /Pages /Kids [3 0 R] /Count 1 >>"),c(`<< /Type /Page /Parent 2 0 R /MediaBox [0 0 842 ${u}] /Resources << /XObject << /Picture 4 0 R >> >> /Contents 5 0 R >>`),c(`<< /Type /XObject /Subtype /Image /Width ${e} /Height ${t} /ColorSpace /DeviceRGB /BitsPerComponent 8 /Filter /DCTDecode /Length ${n.length} >>`,n),c(`<< /Length ${f.length} >>`,f),c(`<< /Title <${S2(i)}> /Producer (Calyx) >>`);let h=a;l(`xref
0 ${o.length+1}
0000000000 65535 f 
`);for(let d of o)l(`${String(d).padStart(10,"0")} 00000 n 
`);return l(`trailer
<< /Size ${o.length+1} /Root 1 0 R /Info 6 0 R >>
startxref
${h}
%%EOF
`),new Blob(r,{type:"application/pdf"})}function S2(n){let e="FEFF";for(let t=0;t<n.length;t++)e+=n.charCodeAt(t).toString(16).padStart(4,"0").toUpperCase();return e}var M2={right:[9,4,"start"],left:[-9,4,"end"],above:[0,-14,"middle"],below:[0,22,"middle"]},am=2,w2="system-ui, -apple-system, 'Segoe UI', Roboto, Helvetica, Arial, sans-serif",Bs={width:16,height:200,right:92,top:56};function E2(n){let{width:e,height:t}=n.scene,i=getComputedStyle(n.element),s=r=>i.getPropertyValue(r).trim();return{width:e,height:t,text:s("--cv-text"),muted:s("--cv-muted"),background:s("--cv-stage"),halo:s("--cv-stage")}}function f_(n,e){let{scene:t,labels:i,state:s,display:r}=n,o=[],a=(h,d,p,v="")=>o.push(`<text x="${h.toFixed(1)}" y="${d.toFixed(1)}" fill="${e.text}" stroke="${e.halo}" stroke-width="3" stroke-linejoin="round" paint-order="stroke" ${v}>${$h(p)}</text>`);for(let h of i.placed(t.camera.active,t.root.matrix,e.width,e.height)){let d=h.hidden?'stroke-dasharray="3 2" opacity="0.6"':"";(h.kind==="maximum"||h.kind==="minimum")&&o.push(`<circle cx="${h.x.toFixed(1)}" cy="${h.y.toFixed(1)}" r="4" fill="none" stroke="${e.text}" stroke-width="1.6" ${d}/>`);let[p,v,g]=M2[h.side];a(h.x+p,h.y+v,h.text,`font-weight="600" text-anchor="${g}"${h.hidden?' opacity="0.7"':""}`)}let{limits:l}=r,{colours:c}=s;if(l&&c.field!=="plain"){let h=e.width-Bs.right,d=c.bands>0?c.bands:64;for(let g=0;g<d;g++){let m=Gr(fr(c.scale,c.bands>0?Hr((g+.5)/d,d):g/(d-1))),y=Bs.height/d,M=Bs.top+Bs.height-(g+1)*y;o.push(`<rect x="${h}" y="${M.toFixed(2)}" width="${Bs.width}" height="${(y+.4).toFixed(2)}" fill="${m}"/>`)}let{ticks:p,unit:v}=Vh(n);for(let g of p)a(h+Bs.width+7,Bs.top+Bs.height*(1-g.fraction)+4,g.text);a(e.width-16,Bs.top-18,`${sa(n)}${v?` in ${v}`:""}`,'text-anchor="end" font-weight="600"')}let u=n.positions?.list[s.position],f=[n.source?.title,u?`position ${u.position}`:""].filter(Boolean).join(", ");return f&&a(16,e.height-16,f),n.hasMeshes&&a(16,e.height-36,`deformation × ${r.factor}`),o.join(`
`)}function lm(n,e){return`<svg xmlns="http://www.w3.org/2000/svg" width="${n.width}" height="${n.height}" viewBox="0 0 ${n.width} ${n.height}" font-family="${w2}" font-size="12">
${e}
</svg>
`}function p_(n,e){let t=n.display.cut.group,i=t.visible;t.visible=!1;let s=n.scene.snapshot(am);t.visible=i,n.scene.invalidate();let r=document.createElement("canvas");r.width=s.width,r.height=s.height;let o=r.getContext("2d");return o.fillStyle=e.background,o.fillRect(0,0,r.width,r.height),o.drawImage(s,0,0),r}async function x_(n,e){let t=new Image,i=URL.createObjectURL(new Blob([e],{type:"image/svg+xml"}));try{t.src=i,await t.decode(),n.getContext("2d").drawImage(t,0,0,n.width,n.height)}finally{URL.revokeObjectURL(i)}return n}function m_(n,e,t){return new Promise((i,s)=>{n.toBlob(r=>r?i(r):s(new Error("the picture cannot be encoded")),e,t)})}async function cm(n,e){if(!n.scene||n.status!=="ready")throw new Error("there is no picture to export");n.updateMarks();let t=E2(n);if(e==="svg"){let s=p_(n,t).toDataURL("image/png"),r=`<image width="${t.width}" height="${t.height}" href="${s}"/>
${f_(n,t)}`;return new Blob([lm(t,r)],{type:"image/svg+xml"})}let i=await x_(p_(n,t),lm(t,f_(n,t)));return v_(i,e,n.source?.title??"")}async function v_(n,e,t){if(e==="png")return m_(n,"image/png");let i=await m_(n,"image/jpeg",.94);return d_(new Uint8Array(await i.arrayBuffer()),n.width,n.height,t)}function um(n){let e=getComputedStyle(n.element),t=i=>e.getPropertyValue(i).trim();return{text:t("--cv-text"),muted:t("--cv-muted"),line:t("--cv-line"),flank:t("--cv-flank"),mark:t("--cv-mark")}}function hm(n,{part:e,tooth:t,side:i,envelope:s}){let r=n.positions?.list[n.state.position],o=n.positions?.list.length??0,a=s?`maximum over ${s.included.size<o?`${s.included.size} of `:""}${o} positions`:`position ${r?.position??0}`,l={all:"",flanks:", without edges",edges:", edges only"}[n.state.colours.cells];return`Contact pattern of ${e.name}, ${t===null?"all teeth":`tooth ${t}`}, ${i} flank, ${a}${l}`}var g_={width:960,height:420,title:34};async function dm(n,e){let t=n.pattern.pattern();if(!t)throw new Error("there is no contact pattern to export");let{width:i,height:s,title:r}=g_,o=new Wh,a=um(n);Xh(o,new ra(i,s-r,t),t,n.state.colours,a);let l=getComputedStyle(n.element).getPropertyValue("--cv-bg").trim(),c=[n.source?.title,hm(n,t)].filter(Boolean).join(": "),u=lm(g_,`<rect width="${i}" height="${s}" fill="${l}"/>
<text x="16" y="22" fill="${a.text}" font-weight="600">${$h(c)}</text>
<g transform="translate(0 ${r})">
${o.elements.join(`
`)}
</g>`);if(e==="svg")return new Blob([u],{type:"image/svg+xml"});let f=document.createElement("canvas");return f.width=am*i,f.height=am*s,v_(await x_(f,u),e,c)}async function y_(n,e){b_(n,await cm(n,e),e)}async function __(n,e){b_(n,await dm(n,e),`pattern.${e}`)}function b_(n,e,t){let i=document.createElement("a"),s=(n.source?.title??"view").replace(/[^\p{L}\p{N}._-]+/gu,"_")||"view";i.href=URL.createObjectURL(e),i.download=`${s}.${t}`,i.click(),setTimeout(()=>URL.revokeObjectURL(i.href),1e4)}function S_(n){let[,e]=xd(t=>t+1,0);At(()=>(e(0),n.subscribe(()=>e(0))),[n])}var T2={parts:"M2.5 3.5h4M2.5 8h4M2.5 12.5h4M9 3.5h4.5M9 8h4.5M9 12.5h4.5",settings:"M2 4.5h7M12 4.5h2M2 11.5h2M7 11.5h7M10.5 3v3M5.5 10v3",fit:"M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10",cube:"M8 1.8l5.5 3v6.4L8 14.2l-5.5-3V4.8zM2.5 4.8L8 8l5.5-3.2M8 8v6.2",perspective:"M2 3.5l12 2v5l-12 2zM8 4.5v7",orthographic:"M2.5 3.5h11v9h-11zM8 3.5v9",mesh:"M2.5 2.5h11v11h-11zM2.5 6.2h11M2.5 9.8h11M6.2 2.5v11M9.8 2.5v11",force:"M3 13L12.5 3.5M7.5 3h5.5v5.5",cut:"M1.5 10.5l5-7h8l-5 7zM3 13.5h4M9.5 13.5h4",plot:"M2.5 2.5v11h11M4.5 10.5l3-4 2.5 2 3.5-5",pattern:"M1.8 3.5h12.4v9H1.8zM4 8c0-1.6 1.8-2.4 4-2.4S12 6.4 12 8s-1.8 2.4-4 2.4S4 9.6 4 8",more:"M2.6 8h1.2M7.4 8h1.2M12.2 8h1.2",download:"M8 2v8M4.8 7L8 10.2 11.2 7M2.5 13.5h11",help:"M5.5 6a2.5 2.5 0 1 1 3.6 2.2c-.8.4-1.1.9-1.1 1.8M8 12.6v.4",sun:"M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6M8 1.2v1.6M8 13.2v1.6M1.2 8h1.6M13.2 8h1.6M3.2 3.2l1.1 1.1M11.7 11.7l1.1 1.1M12.8 3.2l-1.1 1.1M4.3 11.7l-1.1 1.1",moon:"M13.2 9.6A5.8 5.8 0 0 1 6.4 2.8a5.6 5.6 0 1 0 6.8 6.8",play:"M5 3l8 5-8 5z",pause:"M5 3v10M11 3v10",next:"M4 3.5l6 4.5-6 4.5zM12.2 3.5v9",previous:"M12 3.5L6 8l6 4.5zM3.8 3.5v9",loop:"M11.5 2l2 2-2 2M13.5 4H5a3 3 0 0 0-3 3M4.5 14l-2-2 2-2M2.5 12H11a3 3 0 0 0 3-3",eye:"M1.5 8S4 3.8 8 3.8 14.5 8 14.5 8 12 12.2 8 12.2 1.5 8 1.5 8M8 6.2a1.8 1.8 0 1 0 0 3.6 1.8 1.8 0 0 0 0-3.6",half:"M8 2.5a5.5 5.5 0 1 0 0 11zM8 2.5a5.5 5.5 0 0 1 0 11M8 5h4.6M8 8h5.5M8 11h4.6",hidden:"M2 2l12 12M6.2 4.1A6 6 0 0 1 8 3.8c4 0 6.5 4.2 6.5 4.2a12 12 0 0 1-1.9 2.3M4 5.2A11 11 0 0 0 1.5 8S4 12.2 8 12.2a6 6 0 0 0 3-.8",pin:"M8 9.5V14M5 9.5h6l-1.3-2V3.3h.8M6.3 7.5L5 9.5M6.3 7.5V3.3h-.8M6.3 3.3h3.4",chevron:"M5.5 3.5L10 8l-4.5 4.5",close:"M3.5 3.5l9 9M12.5 3.5l-9 9"};function wl({name:n}){return x("svg",{class:"cv-icon",viewBox:"0 0 16 16","aria-hidden":"true",children:x("path",{d:T2[n]})})}function qh(n,e,t,i){let s=n>t-240&&n>t/2,r=e>i-120&&e>i/2;return{[s?"right":"left"]:`${(s?t-n:n)+14}px`,[r?"bottom":"top"]:`${(r?i-e:e)+12}px`,"max-width":`${Math.max(120,(s?n:t-n)-20)}px`}}function An({icon:n,label:e,shortcut:t,pressed:i,disabled:s,onClick:r}){return x("button",{type:"button",class:"cv-tool","aria-label":e,"aria-pressed":i,disabled:s,title:t?`${e} (${t})`:e,onClick:r,children:x(wl,{name:n})})}function Kt({label:n,value:e,options:t,onChange:i,quiet:s,title:r}){return x("label",{class:"cv-field",title:r,children:[x("span",{class:s?"cv-hidden":"",children:n}),x("select",{"aria-label":n,value:e,onChange:o=>i(o.currentTarget.value),children:t.map(o=>x("option",{value:o.value,disabled:o.disabled,selected:o.value===e,children:o.label},o.value))})]})}function ps({label:n,value:e,onChange:t}){return x("label",{class:"cv-check",children:[x("input",{type:"checkbox",checked:e,onChange:i=>t(i.currentTarget.checked)}),x("span",{children:n})]})}function El({label:n,value:e,unit:t,min:i,max:s,disabled:r,onChange:o}){let a=Number.isFinite(e)?String(Number(e.toPrecision(6))):"",[l,c]=Tt(null),u=()=>{if(l===null)return;let f=Number(l.trim().replace(",",".").replace("−","-"));c(null),!(l.trim()===""||!Number.isFinite(f))&&o(Math.min(Math.max(f,i??-1/0),s??1/0))};return x("label",{class:"cv-field",children:[x("span",{children:n}),x("span",{class:"cv-number",children:[x("input",{type:"text",inputMode:"decimal",value:l??a,disabled:r,onInput:f=>c(f.currentTarget.value),onBlur:u,onKeyDown:f=>{f.key==="Enter"&&u(),f.key==="Escape"&&c(null)}}),t?x("span",{class:"cv-unit",children:t}):null]})]})}function fm({label:n,value:e,min:t,max:i,step:s="any",text:r,onInput:o,onEnd:a}){return x("label",{class:"cv-field cv-slider",children:[x("span",{children:n}),x("input",{type:"range",min:t,max:i,step:s,value:e,"aria-valuetext":r,onInput:l=>o(Number(l.currentTarget.value)),onChange:a})]})}function oa({title:n,children:e}){return x("section",{class:"cv-section",children:[x("h3",{children:n}),e]})}function M_({core:n}){let e=Gt(null);ag(()=>{e.current.showModal()},[]);let t=()=>{n.help=!1,n.changed(!1)};return x("dialog",{class:"cv-help",ref:e,"aria-labelledby":"cv-help-title",onClose:t,onClick:i=>i.target===e.current&&t(),children:[x("div",{class:"cv-help-head",children:[x("h2",{id:"cv-help-title",children:"Shortcuts"}),x(An,{icon:"close",label:"Close",onClick:t})]}),x("div",{class:"cv-help-grid",children:l_.map(([i,s])=>x("section",{children:[x("h3",{children:i}),x("dl",{children:s.map(({keys:r,label:o})=>x("div",{children:[x("dt",{children:x("kbd",{children:r})}),x("dd",{children:o})]},r))})]},i))})]})}var w_={all:"of cells, edges included",flanks:"flanks only",edges:"edges only"},A2={stress_error:"estimated, as von Mises stress"};function C2(n){let{scale:e,bands:t}=n.state.colours,i=[];if(t>0)for(let s=0;s<t;s++){let r=Gr(fr(e,Hr((s+.5)/t,t)));i.push(`${r} ${100*s/t}% ${100*(s+1)/t}%`)}else for(let s=0;s<=20;s++)i.push(`${Gr(fr(e,s/20))} ${5*s}%`);return`linear-gradient(to top, ${i.join(", ")})`}function R2({share:n,largest:e},t){return`${Ft(100*n,2)} % of the nodes are above, up to ${Ft(e*Oi().factor,3)} ${t}`}function P2(n,e){let{field:t,cells:i}=n.state.colours,s=n.display?.position?.contacts;if(t!=="contact_pressure"||i!=="flanks"||!s)return null;let r=dl(s,"all");return r>dl(s,"flanks")?`edges, not shown: up to ${Ft(r*Oi().factor,4)} ${e}`:null}function I2(n){let e=n.display?.position;return e?n.state.colours.field!=="contact_pressure"?e.meshes.length===0?"No values: the run stored no meshes with stresses (--vtu), or its fidelity level has no finite elements.":"No values: the parts with meshes are hidden.":e.contacts?n.state.colours.cells==="all"?"No values: the gears in contact are hidden.":`No values: no visible loaded cells, ${w_[n.state.colours.cells]}.`:'No values: no contact is loaded in this position, or the fidelity level is "rigid".':"No values: the run has no positions."}function E_({core:n}){let{field:e}=n.state.colours;if(e==="plain")return null;let{ticks:t,unit:i}=Vh(n);if(n.missingField||t.length===0)return x("div",{class:"cv-legend cv-legend-empty",role:"note",children:[x("strong",{children:sa(n)}),x("span",{children:I2(n)})]});let s=n.narrow?Math.ceil(t.length/6):1,{limits:r}=n.state.colours,o=n.display?.clipped,a=P2(n,i),l=r==="all"?"all positions":r==="fixed"?"fixed limits":"this position";return x("button",{type:"button",class:"cv-legend","aria-label":`Legend: ${sa(n)} from ${t[0].text} to ${t[t.length-1].text} ${i}. Opens the settings.`,title:Zo[e]??"Settings of the colours",onClick:()=>n.toggle("settings"),children:[x("span",{class:"cv-legend-title",children:[x("strong",{children:sa(n)}),i?x("span",{class:"cv-legend-unit",children:i}):null]}),x("span",{class:"cv-scale",children:[x("span",{class:"cv-bar",style:{background:C2(n)}}),x("span",{class:"cv-ticks",children:t.filter((c,u)=>u%s===0).map((c,u)=>x("span",{style:{bottom:`${100*c.fraction}%`},children:c.text},u))})]}),Zo[e]?x("span",{class:"cv-range",children:A2[e]}):null,a?x("span",{class:"cv-range",children:a}):null,o?x("span",{class:"cv-range",children:R2(o,i)}):null,x("span",{class:"cv-range",children:[e==="contact_pressure"?`${w_[n.state.colours.cells]}; `:"",n.progress!==null?`reading … ${Math.round(100*n.progress)} %`:l]})]})}var L2=[{kind:"gear",label:"Gears"},{kind:"shaft",label:"Shafts"},{kind:"bearing",label:"Bearings"},{kind:"body",label:"Bodies"}],T_={mixed:"visible",visible:"translucent",translucent:"hidden",hidden:"visible"},N2={mixed:"half",visible:"eye",translucent:"half",hidden:"hidden"};function A_({core:n}){let e=n.parts?.parts??[];return x("aside",{class:"cv-panel cv-parts","aria-label":"Parts",children:[x("div",{class:"cv-scroll",children:L2.map(({kind:t,label:i})=>{let s=e.filter(r=>r.kind===t);return s.length>0?x(D2,{core:n,label:i,parts:s},t):null})}),x("div",{class:"cv-foot",children:x(Kt,{label:"Fixed frame",value:n.state.frame??"",options:[{value:"",label:"Ground"},...e.map(({name:t})=>({value:t,label:t}))],onChange:t=>n.update({frame:t||null})})}),n.source?.provenance?.length?x("details",{class:"cv-provenance",children:[x("summary",{children:"Provenance"}),x("dl",{children:n.source.provenance.map(([t,i])=>x("div",{children:[x("dt",{children:t}),x("dd",{title:i,children:i})]},t))})]}):null]})}function D2({core:n,label:e,parts:t}){let[i,s]=Tt(!0),r=t.map(({name:l})=>l),o=new Set(t.map(l=>_l(n.state,l))),a=o.size===1?[...o][0]:"mixed";return x("div",{class:"cv-group",role:"group","aria-label":e,children:[x("div",{class:"cv-row cv-row-group",children:[x("button",{type:"button",class:"cv-fold","aria-expanded":i,onClick:()=>s(!i),children:[x(wl,{name:"chevron"}),x("span",{children:e}),x("span",{class:"cv-count",children:t.length})]}),x(C_,{name:e,value:a,onChange:l=>n.setVisibility(r,l)})]}),i?t.map(l=>x(F2,{core:n,part:l},l.name)):null]})}function F2({core:n,part:e}){let t=_l(n.state,e);return x("div",{class:`cv-row cv-row-${t}`,children:[x("span",{class:"cv-swatch",style:{background:n.display?.colours[e.index]}}),x("span",{class:"cv-name",title:e.name,children:x(U2,{name:e.name})}),e.copies>1?x("span",{class:"cv-count",title:`${e.copies} teeth`,children:["z ",e.copies]}):null,n.state.frame===e.name?x("span",{class:"cv-pin",title:"Fixed frame",children:x(wl,{name:"pin"})}):null,x(C_,{name:e.name,value:t,onChange:i=>n.setVisibility([e.name],i)})]})}function U2({name:n}){let[e,t]=yy(n);return e?x(ot,{children:[x("span",{class:"cv-name-start",children:e}),x("span",{class:"cv-name-end",children:t})]}):x(ot,{children:t})}function C_({name:n,value:e,onChange:t}){return x("button",{type:"button",class:"cv-eye","aria-label":`${n}: ${e}`,title:`${e}; click for ${T_[e]}, Alt and click for hidden`,onClick:i=>t(i.altKey?e==="hidden"?"visible":"hidden":T_[e]),children:x(wl,{name:N2[e]})})}function P_({core:n}){let e=n.pattern.pattern();return x("section",{class:"cv-pattern","aria-label":"Contact pattern",children:e?x(ot,{children:[x(O2,{core:n,pattern:e}),x(B2,{core:n,pattern:e})]}):x("div",{class:"cv-muted",children:"No gear has contacts in this position."})})}function O2({core:n,pattern:e}){let{state:t}=n,{part:i}=e,[s,r]=Tt(""),o=t.pattern.tooth,a=n.pattern.teeth(i).map(String);/^\d+$/.test(o)&&!a.includes(o)&&a.push(o);let l=n.pattern.pointed.get(i.index);return x("div",{class:"cv-pattern-head",children:[x(Kt,{quiet:!0,label:"Gear",value:i.name,options:n.pattern.gears().map(({name:c})=>({value:c,label:c})),onChange:c=>n.update({pattern:{gear:c}})}),x(Kt,{quiet:!0,label:"Tooth",value:o,options:[{value:"all",label:"All teeth"},{value:"pointer",label:l===void 0?"At the pointer":`At the pointer: ${l}`},...a.map(c=>({value:c,label:`Tooth ${c}`}))],onChange:c=>n.update({pattern:{tooth:c}})}),x(Kt,{quiet:!0,label:"Flank",value:t.pattern.flank,options:[{value:"automatic",label:`Loaded: ${e.side}`},{value:"left",label:"Left flank"},{value:"right",label:"Right flank"}],onChange:c=>n.update({pattern:{flank:c}})}),x(Kt,{quiet:!0,label:"Positions of the pattern",value:t.pattern.envelope?"all":"current",options:[{value:"current",label:"This position"},{value:"all",label:"All positions"}],onChange:c=>n.update({pattern:{envelope:c==="all"}})}),x(Kt,{quiet:!0,label:s?`Export the pattern. ${s}`:"Export the pattern",value:"",options:[{value:"",label:"Export"},{value:"png",label:"PNG"},{value:"svg",label:"SVG"},{value:"pdf",label:"PDF"}],onChange:c=>{c&&__(n,c).catch(u=>r(String(u))),n.changed(!1)}}),x(k2,{core:n,pattern:e})]})}function k2({core:n,pattern:e}){let t=n.positions?.list.length??0,{envelope:i,limits:s,largest:r}=e,o=[];i&&i.included.size<t&&o.push(`read ${i.included.size} of ${t} positions …`),r===0&&!(i&&i.included.size<t)&&o.push("no loaded cells");let a=Oi();return r>s[1]*(1+1e-9)&&o.push(`up to ${Ft(r*a.factor)} ${a.symbol}, above the scale`),o.length>0?x("span",{class:"cv-muted",role:"note",children:o.join("; ")}):null}function R_(n,e,t,i){if(t<e.left||t>e.right||i<e.top||i>e.bottom)return null;let[s,r]=e.inverse(t,i),[o,a]=n.axes.inverse(s,r);if(n.envelope)return{value:n.envelope.at(s,r)||NaN,z:o,r:a,cell:null};let l=jy(n.cells,o,a);return{value:l?.pressure??NaN,z:o,r:a,cell:l}}function B2({core:n,pattern:e}){let t=Gt(null),i=Gt(null),[s,r]=Tt([0,0]),[o,a]=Tt(null),{hovered:l}=n.pattern,c=!(n.drawers&&n.state.colours.field==="contact_pressure"),u=new ra(s[0],s[1],e,c);At(()=>{let d=t.current,p=new ResizeObserver(()=>r([d.clientWidth,d.clientHeight]));return p.observe(d),()=>p.disconnect()},[]);let f=JSON.stringify([n.state.colours,e.limits,e.part.name,e.side,e.tooth,l,s,c,n.theme.theme,e.envelope?.included.size]);At(()=>{let d=i.current;if(s[0]<1||s[1]<1)return;let p=window.devicePixelRatio||1;d.width=Math.round(s[0]*p),d.height=Math.round(s[1]*p);let v=d.getContext("2d");v&&(v.scale(p,p),v.font="11px system-ui, sans-serif",Xh(new Gh(v),u,e,n.state.colours,um(n),l))},[f,n.display?.position]);let h=o?R_(e,u,...o):null;return x("div",{class:"cv-pattern-picture",ref:t,children:[x("canvas",{ref:i,role:"img","aria-label":hm(n,e),onPointerMove:d=>{let p=d.currentTarget.getBoundingClientRect(),v=[d.clientX-p.left,d.clientY-p.top];a(v),n.hover(R_(e,u,...v)?.cell?.cell??-1)},onPointerLeave:()=>{a(null),n.hover(-1)}}),h?x(z2,{pattern:e,reading:h,layout:u,pointer:o}):null]})}function z2({pattern:n,reading:e,layout:t,pointer:i}){let{value:s,z:r,r:o,cell:a}=e,l=Oi(),c=Tn("m",1),[u,f]=om(n),{axes:h}=n,d=p=>`${Ft(p*c.factor,5)} ${c.symbol}`;return x("div",{class:"cv-tooltip",role:"status","aria-label":"Value in the pattern","data-value":Number.isFinite(s)?String(s):"",style:qh(...i,t.width,t.height),children:[x("div",{class:"cv-tooltip-value",children:x("strong",{children:Number.isFinite(s)?`${Ft(s*l.factor,6)} ${l.symbol}`:"no contact"})}),a?x("div",{children:["tooth ",a.tooth]}):null,x("div",{class:"cv-muted",children:["z ",d(r),", radius ",d(o)]}),h.direction!==0?x("div",{class:"cv-muted",children:["from the toe ",d(h.along(r,o)-u),", from the root ",d(h.across(r,o)-f)]}):null]})}var V2=new Set(["step","time","cycle","roll_angle","position"]);function pm(n){return n.values.reduce((e,t)=>t!==null&&Number.isFinite(t)?Math.max(e,Math.abs(t)):e,0)}function I_({core:n}){let e=n.source?.outputs?.columns??[],t=e.filter(o=>!V2.has(o.name)&&o.values.some(a=>typeof a=="number"&&Number.isFinite(a))),i=t.find(o=>n.state.plotted.includes(o.name))?.name??t[0]?.name??"",s=t.find(o=>o.name===i),r=e.find(o=>o.name==="time");return x("section",{class:"cv-plots","aria-label":"Plots",children:s?x(ot,{children:[x("div",{class:"cv-plots-head",children:[x(Kt,{quiet:!0,label:"Output",value:i,options:t.map(o=>({value:o.name,label:o.name.replaceAll("_"," ")})),onChange:o=>n.update({plotted:[o]})}),x(H2,{core:n,column:s,time:r})]}),x(G2,{core:n,column:s,time:r})]}):x("div",{class:"cv-muted",children:"This run has no outputs over the positions."})})}function L_(n,e){let t=n.positions?.list[n.state.position];if(!t||!e)return n.state.position;let i=0;return e.values.forEach((s,r)=>{Math.abs((s??1/0)-t.time)<Math.abs((e.values[i]??1/0)-t.time)&&(i=r)}),i}function H2({core:n,column:e,time:t}){let i=e.values[L_(n,t)]??NaN,s=Tn(e.unit,pm(e));return x("output",{class:"cv-muted",children:Number.isFinite(i)?`${Ft(i*s.factor,5)} ${s.symbol}`:"no value"})}function G2({core:n,column:e,time:t}){let i=Gt(null),s=Gt(null),r=L_(n,t),{theme:o}=n.theme;return At(()=>{let a=i.current,l=getComputedStyle(n.element),c=m=>l.getPropertyValue(m).trim(),u=Tn(e.unit,pm(e)),f=Tn("s",t?pm(t):0),h=t?t.values.map(m=>(m??NaN)*f.factor):e.values.map((m,y)=>y),d=e.values.map(m=>m===null||!Number.isFinite(m)?null:m*u.factor),p=m=>({label:m,labelSize:18,size:44,font:"11px system-ui, sans-serif",labelFont:"11px system-ui, sans-serif",stroke:c("--cv-muted"),grid:{stroke:c("--cv-line"),width:1},ticks:{stroke:c("--cv-line"),width:1,size:4}}),v=new Mn({width:a.clientWidth,height:a.clientHeight,scales:{x:{time:!1}},legend:{show:!1},cursor:{y:!1,points:{size:7},drag:{x:!1,y:!1}},series:[{},{stroke:c("--cv-accent"),width:1.75,points:{show:h.length<60}}],axes:[{...p(t?`time in ${f.symbol}`:"position"),size:30},{...p(u.symbol),size:56}],hooks:{drawAxes:[m=>W2(m,c("--cv-mark"))]}},[h,d],a);s.current=v,v.over.addEventListener("click",()=>{let m=v.cursor.idx,y=n.positions?.list??[];if(m==null||y.length===0)return;let M=t?t.values[m]??0:m,b=0;y.forEach((R,T)=>{let _=E=>Math.abs((t?y[E].time:E)-M);_(T)<_(b)&&(b=T)}),n.animation.stop(),n.goTo(b)});let g=new ResizeObserver(()=>v.setSize({width:a.clientWidth,height:a.clientHeight}));return g.observe(a),()=>{g.disconnect(),v.destroy(),s.current=null}},[n,e,t,o]),At(()=>{N_.set(s.current,r),s.current?.redraw(!1)},[r,e,t,o]),x("div",{class:"cv-plot",ref:i,role:"img","aria-label":`${e.name.replaceAll("_"," ")} over ${t?"time":"positions"}`})}var N_=new WeakMap;function W2(n,e){let t=N_.get(n),i=t===void 0?void 0:n.data[0][t];if(i===void 0)return;let s=Math.round(n.valToPos(i,"x",!0))+.5,{ctx:r,bbox:o}=n;r.save(),r.strokeStyle=e,r.lineWidth=1.5*(window.devicePixelRatio||1),r.beginPath(),r.moveTo(s,o.top),r.lineTo(s,o.top+o.height),r.stroke(),r.restore()}var gm=[{value:"all",label:"All cells"},{value:"flanks",label:"Flanks only"},{value:"edges",label:"Edges only"}];function D_({core:n}){return x("aside",{class:"cv-panel cv-settings","aria-label":"Settings",children:x("div",{class:"cv-scroll",children:[n.state.colours.field!=="plain"?x(X2,{core:n}):null,n.hasMeshes?x($2,{core:n}):null,x(Y2,{core:n}),x(J2,{core:n}),x(oa,{title:"Display",children:[x(ps,{label:"Mesh edges",value:n.state.mesh_edges,onChange:e=>n.update({mesh_edges:e})}),x(Kt,{label:"Theme",value:n.state.theme,options:[{value:"system",label:"As the system"},{value:"light",label:"Light"},{value:"dark",label:"Dark"}],onChange:e=>n.update({theme:e})})]})]})})}function X2({core:n}){let{colours:e}=n.state,t=Ml(n),[i,s]=n.display?.limits??[0,1],r=1e-9*Math.max(Math.abs(i),Math.abs(s)),o=[Math.abs(i)<r?0:i,Math.abs(s)<r?0:s],a=(l,c)=>n.update({colours:{limits:"fixed",min:l,max:c}});return x(oa,{title:"Colours",children:[x(Kt,{label:"Limits",value:e.limits,options:[{value:"position",label:"This position"},{value:"all",label:"All positions"},{value:"fixed",label:"Fixed"}],onChange:l=>l==="fixed"?a(o[0],o[1]):n.update({colours:{limits:l}})}),x(El,{label:"Maximum",unit:t.symbol,value:o[1]*t.factor,onChange:l=>a(o[0],l/t.factor)}),x(El,{label:"Minimum",unit:t.symbol,value:o[0]*t.factor,onChange:l=>a(l/t.factor,o[1])}),x(Kt,{label:"Scale",value:e.scale,options:ay.map(({name:l,label:c})=>({value:l,label:c})),onChange:l=>n.update({colours:{scale:l}})}),x(Kt,{label:"Bands",value:String(e.bands),options:["0","6","8","10","12","16","24"].map(l=>({value:l,label:l==="0"?"Continuous":l})),onChange:l=>n.update({colours:{bands:Number(l)}})}),Hn(e.field)?null:x(Kt,{label:"Contact cells",value:e.cells,options:gm,onChange:l=>n.update({colours:{cells:l}})}),Zo[e.field]?x("p",{class:"cv-note",children:Zo[e.field]}):null,x(ps,{label:"Mark the extreme values",value:n.state.extremes,onChange:l=>n.update({extremes:l})}),Hn(e.field)?null:x(ps,{label:"Show contacts behind surfaces",value:n.state.hidden_contacts,onChange:l=>n.update({hidden_contacts:l})})]})}function $2({core:n}){let{mode:e}=n.state.deformation,t=({index:o})=>(n.display.meshes[o]?.length??0)>0,i=n.parts?.parts??[],[s,r]=[i.filter(t),i.filter(o=>!t(o))];return x(oa,{title:"Deformation",children:[x(ps,{label:"Automatic factor",value:e==="automatic",onChange:o=>n.update({deformation:{mode:o?"automatic":"factor",factor:n.display.factor}})}),x(El,{label:"Factor",unit:"×",value:n.display.factor,onChange:o=>n.update({deformation:{mode:"factor",factor:o}})}),e==="automatic"&&!Hn(n.state.colours.field)?x("p",{class:"cv-note",children:uh}):null,r.length>0&&n.display.factor>0?x("p",{class:"cv-note",title:r.map(({name:o})=>o).join(", "),children:["These parts move: ",q2(s),". The other parts stay in place."]}):null]})}var mm=5;function q2(n){let e=n.slice(0,mm).map(({name:t})=>t).join(", ");return n.length>mm?`${e} and ${n.length-mm} more`:e}function Y2({core:n}){let{cut:e}=n.state,t=n.display.cut,i=()=>{let o=n.scene.camera.direction;return[o.x,o.y,o.z]},s=Tn("m",1),r=typeof e.normal=="string"?e.normal:"view";return x(oa,{title:"Cutting plane",children:[x(ps,{label:"Cut",value:e.on,onChange:o=>ia(n,{on:o})}),e.on?x(ot,{children:[x(Kt,{label:"Normal",value:r,options:[{value:"x",label:"x"},{value:"y",label:"y"},{value:"z",label:"z"},{value:"view",label:"View direction"}],onChange:o=>ia(n,{normal:o==="view"?i():o})}),x(fm,{label:"Location",min:t.range[0],max:t.range[1],value:t.offset,text:`${Ft(t.offset*s.factor,4)} ${s.symbol}`,onInput:o=>{n.display.setDragging(!0,n.state),n.update({cut:{offset:o}})},onEnd:()=>n.display.setDragging(!1,n.state)}),x(El,{label:"Coordinate",unit:s.symbol,value:t.offset*s.factor,onChange:o=>n.update({cut:{offset:o/s.factor}})}),x(ps,{label:"Flip",value:e.flipped,onChange:o=>n.update({cut:{flipped:o}})})]}):null]})}function J2({core:n}){let{forces:e}=n.state,t=e.bearings||e.meshes;return x(oa,{title:"Forces",children:[x(ps,{label:"At bearings",value:e.bearings,onChange:i=>n.update({forces:{bearings:i}})}),x(ps,{label:"At meshes",value:e.meshes,onChange:i=>n.update({forces:{meshes:i}})}),t?x(ot,{children:[x(ps,{label:"Labels",value:e.labels,onChange:i=>n.update({forces:{labels:i}})}),x(fm,{label:"Length",min:.2,max:4,value:e.scale,onInput:i=>n.update({forces:{scale:i}})})]}):null]})}var xm="Positions count from 0, like the column step of steps.csv",Z2=[1,2,5,10,20,30,60];function F_({core:n}){let e=n.positions?.list??[],{state:t,animation:i}=n;if(e.length===0)return x("div",{class:"cv-timeline cv-muted",children:"No positions yet"});let s=e[Math.min(t.position,e.length-1)],r=e[e.length-1],o=Tn("s",Math.max(Math.abs(r.time),Math.abs(e[0].time))),a=`${Ft(s.time*o.factor)} ${o.symbol}`,l=e.length>1;return x("div",{class:"cv-timeline",role:"group","aria-label":"Animation",children:[x(An,{icon:"previous",label:"Previous position",shortcut:",",disabled:!l,onClick:()=>i.step(-1)}),x(An,{icon:i.playing?"pause":"play",label:i.playing?"Pause":"Play",shortcut:"K",disabled:!l,onClick:()=>i.toggle()}),x(An,{icon:"next",label:"Next position",shortcut:".",disabled:!l,onClick:()=>i.step(1)}),x("input",{class:"cv-time",type:"range",min:0,max:e.length-1,step:1,value:t.position,disabled:!l,"aria-label":"Position","aria-valuetext":`position ${s.position}, ${a}`,onInput:c=>{i.stop(),n.goTo(Number(c.currentTarget.value))}}),x("output",{class:"cv-clock",children:[x("span",{title:xm,children:[n.narrow?"":"Position ",s.position,l?x("span",{class:"cv-muted",children:[" (",e[0].position," to ",r.position,")"]}):null]}),x("span",{class:"cv-clock-time",children:a})]}),n.narrow?null:x(vm,{core:n})]})}function vm({core:n}){let{state:e}=n;return x(ot,{children:[x(Kt,{quiet:!0,label:"Speed, positions per second",value:String(e.animation.speed),options:[...new Set([...Z2,e.animation.speed])].sort((t,i)=>t-i).map(t=>({value:String(t),label:`${t} / s`})),onChange:t=>n.update({animation:{speed:Number(t)}})}),x(An,{icon:"loop",label:"Loop",pressed:e.animation.loop,onClick:()=>n.update({animation:{loop:!e.animation.loop}})})]})}var K2=[{value:"",label:"View"},{value:"isometric",label:"Isometric"},{value:"front",label:"Front"},{value:"back",label:"Back"},{value:"left",label:"Left"},{value:"right",label:"Right"},{value:"top",label:"Top"},{value:"bottom",label:"Bottom"}],j2=Object.keys(Ei);function O_({core:n,showTitle:e,showTheme:t}){let{scene:i,status:s,narrow:r}=n,o=s==="ready"&&i!==null;return x("div",{class:"cv-toolbar",role:"toolbar","aria-label":"View",children:[x(An,{icon:"parts",label:"Parts",shortcut:"B",pressed:n.isOpen("parts"),onClick:()=>n.toggle("parts")}),e&&!r?x("h1",{class:"cv-title",title:n.source?.title,children:n.source?.title??"Calyx"}):null,o&&!r?x(ot,{children:[x("span",{class:"cv-rule"}),x(B_,{core:n}),x("span",{class:"cv-rule"}),x(U_,{core:n}),x(z_,{core:n}),x("span",{class:"cv-rule"}),x(V_,{core:n})]}):null,o&&r?x("span",{class:"cv-grow",children:x(U_,{core:n})}):x("span",{class:"cv-space"}),x("span",{class:"cv-tool-group",children:[o&&!r?x(H_,{core:n}):null,o?x(An,{icon:"settings",label:"Settings",shortcut:"S",pressed:n.isOpen("settings"),onClick:()=>n.toggle("settings")}):null,r?x(An,{icon:"more",label:"More tools",pressed:n.drawer==="tools",onClick:()=>n.setDrawer(n.drawer==="tools"?null:"tools")}):x(G_,{core:n,showTheme:t})]})]})}function k_({core:n,showTheme:e}){let t=n.status==="ready"&&n.scene!==null;return x("div",{class:"cv-tools",role:"group","aria-label":"More tools",children:[t?x(ot,{children:[x(B_,{core:n}),x(V_,{core:n}),x(z_,{core:n}),x(H_,{core:n}),x(vm,{core:n})]}):null,x(G_,{core:n,showTheme:e})]})}function B_({core:n}){let{camera:e}=n.scene,t=n.state.camera?.projection==="orthographic";return x(ot,{children:[x(An,{icon:"fit",label:"Fit",shortcut:"F",onClick:()=>e.fit()}),x(Kt,{quiet:!0,label:"Standard view",value:"",options:K2,onChange:i=>{i&&e.view(i),n.changed(!1)}}),x(An,{icon:t?"orthographic":"perspective",label:"Orthographic projection",shortcut:"P",pressed:t,onClick:()=>e.setProjection(t?"perspective":"orthographic")})]})}function U_({core:n}){let{colours:e}=n.state;return x(Kt,{quiet:!0,label:"Colours",value:e.field,options:j2.map(t=>({value:t,label:Ei[t].label})),onChange:t=>n.update({colours:{field:t,limits:e.limits==="fixed"?"position":e.limits}})})}function z_({core:n}){let{colours:e}=n.state;return x(ot,{children:[e.field==="contact_pressure"?x(Kt,{quiet:!0,label:"Contact cells",value:e.cells,options:gm,onChange:t=>n.update({colours:{cells:t}})}):null,n.hasMeshes?x(Q2,{core:n}):null]})}function V_({core:n}){let{state:e}=n,t=e.forces.bearings||e.forces.meshes;return x(ot,{children:[x(An,{icon:"mesh",label:"Mesh edges",shortcut:"M",pressed:e.mesh_edges,onClick:()=>n.update({mesh_edges:!e.mesh_edges})}),x(An,{icon:"force",label:"Force vectors",shortcut:"V",pressed:t,onClick:()=>n.update({forces:{bearings:!t,meshes:!t}})}),x(An,{icon:"cut",label:"Cutting plane",shortcut:"C",pressed:e.cut.on,onClick:()=>{let i=!e.cut.on;ia(n,{on:i}),i&&!n.drawers&&n.toggle("settings",!0)}})]})}function H_({core:n}){let{panels:e}=n.state;return x(ot,{children:[x(An,{icon:"plot",label:"Plots",shortcut:"G",pressed:e.plots,onClick:()=>n.update({panels:{plots:!e.plots}})}),x(An,{icon:"pattern",label:"Contact pattern",shortcut:"U",pressed:e.pattern,onClick:()=>n.update({panels:{pattern:!e.pattern}})}),x(eP,{core:n})]})}function G_({core:n,showTheme:e}){let t=n.theme.theme==="dark";return x(ot,{children:[e?x(An,{icon:t?"sun":"moon",label:t?"Light theme":"Dark theme",onClick:()=>n.update({theme:t?"light":"dark"})}):null,x(An,{icon:"help",label:"Help",shortcut:"?",pressed:n.help,onClick:()=>{n.help=!n.help,n.changed(!1)}})]})}function Q2({core:n}){let{mode:e,factor:t}=n.state.deformation,i=e==="automatic"&&!Hn(n.state.colours.field),s=e==="automatic"?"automatic":t===0||t===1?String(t):"other";return x(ot,{children:[x(Kt,{quiet:!0,label:"Deformation",title:i?uh:void 0,value:s,options:[{value:"automatic",label:i?"No deformation here":"Deformation: automatic"},{value:"0",label:"Undeformed"},{value:"1",label:"True deformation"},{value:"other",label:"Other factor …"}],onChange:r=>{r==="automatic"?n.update({deformation:{mode:"automatic"}}):r==="other"?(n.update({deformation:{mode:"factor",factor:n.display.factor||10}}),n.toggle("settings",!0)):n.update({deformation:{mode:"factor",factor:Number(r)}})}}),i?null:x("output",{class:"cv-factor","aria-label":"Factor of the deformation",title:"Factor of the displayed deformation",children:["× ",Ft(n.display.factor,3)]})]})}function eP({core:n}){let[e,t]=Tt("");return x("span",{class:"cv-export",children:x(Kt,{quiet:!0,label:e?`Export. ${e}`:"Export the picture",value:"",options:[{value:"",label:"Export"},{value:"png",label:"PNG"},{value:"svg",label:"SVG"},{value:"pdf",label:"PDF"}],onChange:i=>{i&&y_(n,i).catch(s=>t(String(s))),n.changed(!1)}})})}function W_({core:n}){let{probe:e,scene:t}=n;if(!e||!t)return null;let i=Ml(n),s=Tn("m",1),{x:r,y:o,z:a}=e.point,l=e.value!==null&&Number.isFinite(e.value);return x("div",{class:"cv-tooltip",role:"status","aria-label":"Value at the pointer","data-value":e.value===null?"":String(e.value),style:qh(e.x,e.y,t.width,t.height),children:[e.value!==null?x("div",{class:"cv-tooltip-value",children:[x("span",{class:"cv-muted",children:Ei[n.state.colours.field].label}),x("strong",{children:l?`${Ft(e.value*i.factor,6)} ${i.symbol}`:"no value"})]}):null,x("div",{children:[e.part,e.tooth!==null?`, tooth ${e.tooth}`:"",e.node!==null?`, node ${e.node}`:""]}),x("div",{class:"cv-muted",children:[[r,o,a].map(c=>Ft(Math.round(c*s.factor*1e3)/1e3,6)).join("  ")," ",s.symbol]})]})}var X_=[{name:"x",azimuth:0,elevation:0,v:[1,0,0]},{name:"y",azimuth:90,elevation:0,v:[0,1,0]},{name:"z",azimuth:-90,elevation:90,v:[0,0,1]}];function $_({core:n}){let e=Gt(null);return At(()=>tP(n,e.current)),x("svg",{class:"cv-triad",viewBox:"-34 -34 68 68",ref:e,"aria-hidden":"true",children:X_.map(({name:t})=>x("g",{class:`cv-axis-${t}`,children:[x("line",{}),x("text",{"text-anchor":"middle","dominant-baseline":"central",children:t})]},t))})}function tP(n,e){let t=n.state.camera??n.scene?.camera.state;if(!t)return;let i=t.azimuth*Math.PI/180,s=t.elevation*Math.PI/180,r=[-Math.sin(i),Math.cos(i),0],o=[-Math.sin(s)*Math.cos(i),-Math.sin(s)*Math.sin(i),Math.cos(s)];X_.forEach(({v:a},l)=>{let c=a[0]*r[0]+a[1]*r[1]+a[2]*r[2],u=-(a[0]*o[0]+a[1]*o[1]+a[2]*o[2]),f=e.children[l],[h,d]=[f.children[0],f.children[1]];h.setAttribute("x2",String(20*c)),h.setAttribute("y2",String(20*u)),d.setAttribute("x",String(28*c)),d.setAttribute("y",String(28*u)),f.setAttribute("opacity",Math.hypot(c,u)<.12?"0.15":"1")})}function q_({core:n,stage:e,showTitle:t,showTheme:i}){S_(n);let{status:s,state:r}=n,o=s==="ready";return x(ot,{children:[x(O_,{core:n,showTitle:t,showTheme:i}),x("div",{class:"cv-body",children:[o&&n.isOpen("parts")?x(A_,{core:n}):null,x("div",{class:"cv-centre",children:[x("div",{class:"cv-view",children:[x(nP,{stage:e}),o?x($_,{core:n}):null,o?x(E_,{core:n}):null,o?x(W_,{core:n}):null,n.notice?x("div",{class:"cv-notice",role:"alert",children:n.notice}):null,s==="loading"?x("div",{class:"cv-message",role:"status",children:"Reading the shapes …"}):null,o&&n.parts?.parts.length===0?x("div",{class:"cv-message",children:"This run has no parts to display."}):null,s==="failed"?x("div",{class:"cv-message",role:"alert",children:[x("strong",{children:"The view cannot be displayed."}),x("span",{children:n.failure})]}):null]}),o&&r.panels.pattern?x(P_,{core:n}):null,o&&r.panels.plots?x(I_,{core:n}):null,o?x(F_,{core:n}):null]}),o&&n.isOpen("settings")?x(D_,{core:n}):null,n.narrow&&n.drawer==="tools"?x(k_,{core:n,showTheme:i}):null]}),n.help?x(M_,{core:n}):null]})}function nP({stage:n}){let e=Gt(null);return At(()=>{e.current.append(n)},[n]),x("div",{class:"cv-holder",ref:e})}var Tl=class{onChange=null;#e;#t;#n=new AbortController;#i=new Set;constructor(e,t={}){let i=document.createElement("div");i.className="calyx-viewer";let s=document.createElement("div");s.className="cv-stage",e.append(i),this.#t=i;let r=new kh(i,s,t.state??{});if(this.#e=r,r.onChange=a=>this.onChange?.(a),ga(x(q_,{core:r,stage:s,showTitle:t.showTitle??!0,showTheme:t.showTheme??!0}),i),r.scene){let{canvas:a,camera:l}=r.scene;a.tabIndex=0,a.setAttribute("role","img"),a.setAttribute("aria-label","Three-dimensional view. Arrow keys orbit, plus and minus zoom, question mark shows all shortcuts."),o_(r,a);let c=l.onChange;l.onChange=u=>{if(c?.(u),u)for(let f of this.#i)f.#e.scene?.camera.set(l.state)}}let o=a=>{c_(r,a)&&a.preventDefault()};i.addEventListener("keydown",o),t.pageKeys&&document.addEventListener("keydown",a=>a.target===document.body&&o(a),{signal:this.#n.signal})}fail(e){this.#e.fail(new Error(e))}show(e){return this.#e.show(e)}reload(){return this.#e.reload()}updatePositions(){return this.#e.updatePositions()}get state(){return structuredClone(this.#e.state)}restore(e){this.#e.update(e)}linkCamera(e){this.#i.add(e),e.#i.add(this);let{camera:t}=this.#e.state;return t&&e.#e.scene?.camera.set(t),()=>{this.#i.delete(e),e.#i.delete(this)}}image(e){return cm(this.#e,e)}patternImage(e){return dm(this.#e,e)}get frames(){return this.#e.scene?.frames??0}get triangles(){return this.#e.display?.triangles??0}draw(){this.#e.scene?.draw()}project(e,t){return this.#e.project(e,t)}nodalValue(e,t){return this.#e.nodalValue(e,t)}contactLoads(){let e=this.#e.display?.position?.contacts,t=this.#e.parts?.parts.map(({name:i})=>i)??[];return e?[...sy(e)].map(([i,s])=>{let[r,o]=i.split(" ").map(Number);return{parts:[t[r]??"",t[o]??""],load:s}}):[]}dispose(){for(let e of this.#i)e.#i.delete(this);this.#i.clear(),this.#n.abort(),ga(null,this.#t),this.#e.dispose(),this.#t.remove()}};var iP=1.4;function Y_(n,{width:e,height:t},i){let s={columns:Math.max(1,Math.floor(e/i.width)),rows:Math.max(1,Math.floor(t/i.height))},r=Math.max(1,Math.min(n,s.columns*s.rows)),o={columns:Math.min(s.columns,r),rows:1},a=0;for(let l=1;l<=Math.min(s.columns,r);l++){let c=Math.ceil(r/l);if(c>s.rows)continue;let u=Math.min(t/c,e/l/iP);u>a&&(a=u,o={columns:l,rows:c})}return o}function J_(n){let[e,t]=Tt({width:0,height:0});return At(()=>{if(!n.current)return;let i=new ResizeObserver(([s])=>{if(!s)return;let{width:r,height:o}=s.contentRect;t(a=>a.width===r&&a.height===o?a:{width:r,height:o})});return i.observe(n.current),()=>i.disconnect()},[]),e}function Z_({viewers:n,state:e,positions:t}){let[i,s]=Tt(e.colours?.field??"plain"),[r,o]=Tt(e.position??0),a=Math.max(t-1,0),l=Math.min(r,a),c=f=>n().forEach(h=>h.restore(f)),u=f=>{o(f),c({position:f})};return x("div",{class:"scene-bar",role:"group","aria-label":"All scenes",children:[x("select",{"aria-label":"Displayed field",value:i,onChange:f=>{let h=f.currentTarget.value;s(h),c({colours:{field:h}})},children:Object.entries(Ei).map(([f,{label:h}])=>x("option",{value:f,children:h},f))}),x("label",{class:"inline position",children:["Position",x("input",{type:"range",min:0,max:a,value:l,disabled:t<2,onInput:f=>u(Number(f.currentTarget.value))}),x("output",{title:xm,children:[l," (0 to ",a,")"]})]})]})}var K_=9,sP={width:200,height:150},rP=620,oP=480,aP=500;function j_({studio:n}){let e=Gt(null),t=J_(e),i=n.settings.selected.flatMap(u=>n.runs.filter(f=>f.id===u)),s=i.filter(u=>u.has_view),{modelScene:r}=n,o=r!==null&&(n.scene==="model"||s.length===0),a=Y_(Math.min(s.length,K_),t,sP),c=t.width>0||s.length===1?s.slice(0,Math.min(a.columns*a.rows,K_)):[];return x("div",{class:"scene-area",children:[x("div",{class:"scene-bar",children:[r&&s.length>0&&x("div",{class:"chips",role:"group","aria-label":"Displayed scene",children:[x("button",{type:"button",class:"chip","aria-pressed":o,onClick:()=>n.showScene("model"),children:"Model"}),x("button",{type:"button",class:"chip","aria-pressed":!o,onClick:()=>n.showScene("runs"),children:"Results"})]}),!o&&c.length>1&&x("label",{class:"switch",children:[x("input",{type:"checkbox",checked:n.settings.linked,onChange:u=>n.setLinked(u.currentTarget.checked)}),"Link cameras"]}),!o&&c.length===1&&c[0]?.incomplete&&x(Q_,{run:c[0]}),!o&&x(lP,{runs:i,drawn:c})]}),x("div",{class:"scene-space",ref:e,children:[o&&x(dP,{studio:n,scene:r}),!o&&c.length>0&&x(cP,{studio:n,runs:c,columns:a.columns,isCompact:c.length>1&&t.width/a.columns<oP}),!o&&s.length===0&&x(fP,{studio:n,runs:i})]})]})}function Q_({run:n}){return x("span",{class:"incomplete",children:["Incomplete: ",os(n)]})}function lP({runs:n,drawn:e}){if(e.length===0)return null;let t=n.filter(r=>!e.includes(r)),i=(r,o)=>o.length>0?[`${o.map(a=>en(a.id)).join(", ")} (${r})`]:[],s=[...i("no space",t.filter(r=>r.has_view)),...i("no view files",t.filter(r=>!r.has_view))];return s.length===0?null:x("span",{class:"not-drawn",role:"status",children:["Not drawn: ",s.join(", ")]})}function cP({studio:n,runs:e,columns:t,isCompact:i}){let s=Gt(new Map),[r,o]=Tt(0),{linked:a}=n.settings;return At(()=>{if(!a)return;let l=[...s.current.values()],c=l.slice(1).map(u=>l[0]?.linkCamera(u));return()=>c.forEach(u=>u?.())},[r,a,e.map(l=>l.id).join()]),x(ot,{children:[i&&x(Z_,{viewers:()=>[...s.current.values()],state:n.settings.scene??{},positions:Math.max(...e.map(l=>l.positions??0))}),x("div",{class:`scenes ${i?"compact":""}`,style:{gridTemplateColumns:`repeat(${t}, minmax(0, 1fr))`},children:e.map(l=>x(uP,{studio:n,run:l,hasTitle:e.length>1,onViewer:c=>{c?s.current.set(l.id,c):s.current.delete(l.id),o(u=>u+1)}},l.id))})]})}function uP({studio:n,run:e,hasTitle:t,onViewer:i}){let s=Gt(null),r=Gt(null);At(()=>{if(!s.current)return;let a=eb(s.current,n,!t);return r.current=a,i(a),a.show(hP(n,e.id)),()=>{r.current=null,i(null),a.dispose()}},[e.id,t]),tb(r);let o=Gt(!0);return At(()=>{o.current?o.current=!1:e.id==="preview"?r.current?.reload():r.current?.updatePositions()},[e.status,e.positions,e.id==="preview"?n.results[e.id]:null]),x("figure",{class:"scene",children:[t&&x("figcaption",{children:[en(e.id),e.incomplete&&x(Q_,{run:e})]}),x("div",{ref:s,class:"viewer"})]})}function eb(n,e,t){let i=e.settings.scene??{},s=t&&n.clientWidth>=rP,r=s?i.panels:{parts:!1,settings:!1,plots:!1},o=new Tl(n,{state:{...i,theme:cc(),...r&&{panels:r}},showTheme:!1,showTitle:!1}),a=0;return o.onChange=l=>{window.clearTimeout(a),a=window.setTimeout(()=>e.setScene(s?l:{...l,panels:i.panels}),aP)},o}function tb(n){let e=dc();At(()=>n.current?.restore({theme:e}),[e])}function hP(n,e){let t=[],i=n.results[e];return{title:en(e),provenance:i?rf(i):[],outputs:null,parts:()=>ql(pi(e,"/files/view/parts.bin")),positions:async()=>(t=(await Vi(pi(e,"/view"))).positions.map(({position:r,time:o})=>({position:r,time:o??r})),t),position:s=>{let r=t[s];return r?ql(pi(e,`/files/view/${Sl(r.position)}`)):Promise.reject(new Error(`position ${s} does not exist`))},mesh:s=>ql(pi(e,`/files/view/${s}`))}}function dP({studio:n,scene:e}){let t=Gt(null),i=Gt(null),s=Gt(e);s.current=e,tb(i),At(()=>{if(!t.current)return;let o=eb(t.current,n,!0);return i.current=o,o.show({title:"Model",parts:async()=>s.current.parts,positions:async()=>[{position:0,time:0}],position:async()=>s.current.position}),()=>{i.current=null,o.dispose()}},[]);let r=Gt(e);return At(()=>{r.current!==e&&i.current?.reload(),r.current=e},[e]),x("div",{ref:t,class:"viewer"})}function fP({studio:n,runs:e}){let t=e[0]?.status;return x("div",{class:"no-scene",children:[x("p",{children:pP(n,t)}),t==="finished"&&x("p",{class:"muted",children:"Runs without positions, and runs of older versions, have none."})]})}function pP(n,e){return e==="running"||e==="elsewhere"?"This run has not written view files yet.":e==="finished"?"This run has no view files.":e?"This run ended before its first position.":n.model?.broken?"The model has errors.":n.check&&!n.check.runnable?"The params in the form have errors.":"Run the model to see its parts."}function nb({studio:n}){let[,e]=Tt(0);return At(()=>n.subscribe(()=>e(t=>t+1)),[]),gP(n),x(ot,{children:[x(xP,{studio:n}),x(yP,{studio:n}),x("main",{class:"columns",children:n.isLoaded?x(mP,{studio:n}):x("p",{class:"empty",role:"status",children:"Loading …"})})]})}function mP({studio:n}){let{model:e}=n;return x(ot,{children:[x("aside",{class:"left","aria-label":"Params",children:[e?.broken&&x(Xl,{text:e.rendered,isError:!0}),(!e?.broken||e.params.length>0)&&x(_g,{studio:n})]}),x("div",{class:"centre",children:[x(bg,{studio:n}),x(j_,{studio:n}),x(Q0,{studio:n})]}),x("aside",{class:"right","aria-label":"Runs and results",children:[x(ix,{studio:n}),x(Mg,{studio:n}),x(lx,{studio:n}),x(sx,{studio:n}),x(tx,{studio:n})]})]})}function gP(n){At(()=>{let e=t=>{t.key==="Enter"&&(t.ctrlKey||t.metaKey)&&n.canRun&&n.run()};return window.addEventListener("keydown",e),()=>window.removeEventListener("keydown",e)},[])}function xP({studio:n}){let e=n.model?.model??"",t=Sr(e)||"Calyx studio";return At(()=>{document.title=e?`${t} – Calyx studio`:"Calyx studio"},[t]),x("header",{class:"top",children:[x("h1",{title:e,children:t}),x("p",{class:"about",children:oo(n.model?.doc??"").split(`
`)[0]}),x(vP,{})]})}function vP(){let[n,e]=Tt(uc());return x("label",{class:"inline theme",children:["Theme",x("select",{value:n,onChange:t=>{let i=t.currentTarget.value;e(i),hc(i)},children:[x("option",{value:"system",children:"System"}),x("option",{value:"light",children:"Light"}),x("option",{value:"dark",children:"Dark"})]})]})}function yP({studio:n}){return n.isConnected?n.model?.broken?x(_P,{studio:n}):n.notice?x("div",{class:"notice",role:"alert",children:[x("span",{children:[x(oi,{text:n.notice.message}),n.notice.help&&x("span",{class:"help",children:[" ",x(oi,{text:n.notice.help})]})]}),x("button",{type:"button",class:"quiet",onClick:()=>n.dismiss(),children:"Dismiss"})]}):null:x(bP,{studio:n})}function _P({studio:n}){let e=()=>document.querySelector("pre.rendered.error")?.scrollIntoView({block:"start"});return x("div",{class:"notice error",role:"status","data-testid":"model-broken",children:[x("span",{children:["The model has errors: it cannot run, and the form keeps its values. Correct ",Sr(n.model?.model??"the file")," in the editor."]}),x("button",{type:"button",class:"quiet",onClick:e,children:"Show the errors"})]})}function bP({studio:n}){let e=x("code",{children:n.command});return x("div",{class:"notice error",role:"alert",children:[n.connection==="ended"&&x("span",{children:["The studio has ended; this page keeps the form. To go on, start ",e," and open the address that it prints. This page then reconnects."]}),n.connection==="refused"&&x("span",{children:"A new studio runs at this address. Open the address that it printed, in this browser: this page then reconnects, with its form."}),n.connection==="other"&&x("span",{children:["The studio at this address is another one: of another model, or of another version of Calyx. This page reconnects to"," ",e," of its own version; ",x("a",{href:"/",children:"reload"})," it for the other studio."]})]})}var SP=1e3,Yh=class{constructor(e,t,i){this.about=e;this.listen=t;this.onChange=i;this.#i()}about;listen;onChange;state="connected";#e=null;#t=0;#n=!1;pause(){this.#n=!0,window.clearTimeout(this.#t),this.#e?.close()}resume(){this.#n&&(this.#n=!1,this.#r())}#i(){let e=new EventSource("/api/events");this.#e=e,this.listen(e),e.onopen=()=>this.#s("connected"),e.onerror=()=>{e.close(),this.#r()}}#s(e){this.state=e,this.onChange()}async#r(){window.clearTimeout(this.#t);let e=await this.#o();if(!this.#n){if(e==="connected"){this.#i();return}e!==this.state&&this.#s(e),this.#t=window.setTimeout(()=>{this.#r()},SP)}}async#o(){try{let{subject:e,calyx:t}=await Vi("/api/studio");return e===this.about.subject&&t===this.about.calyx?"connected":"other"}catch(e){return e instanceof ai&&e.status===401?"refused":"ended"}}};var MP=1,ib=180,wP=700,EP=300,Jh=class{model=null;withoutModel=!1;values={};analysis={};analysisSettings=[];check=null;isChecking=!1;runs=[];progress={};results={};settings={automatic:!0,linked:!0,analysisOpen:!0,selected:[],scene:null};modelScene=null;scene="runs";notice=null;isStarting=!1;#e=new Set;#t=0;#n=0;#i=!1;#s=!1;#r={params:{},settings:{}};#o=!1;#a=!1;#c=!1;#h=null;#l=null;#m=new Map;#d=null;#f=!1;#x="";#b=!1;#_=new Set;subscribe(e){return this.#e.add(e),()=>this.#e.delete(e)}#u(){for(let e of this.#e)e()}async load(){await this.#p(async()=>{let e=await Vi("/api/studio");this.#h=e,this.withoutModel=e.model===null,this.analysisSettings=e.settings,this.withoutModel||await this.#R(),e.opened&&(this.settings.selected=[e.opened]),this.#b=e.opened!==null}),this.#f=!0,this.#u(),window.addEventListener("pagehide",()=>this.#y(!0)),document.addEventListener("visibilitychange",()=>{document.visibilityState==="hidden"?(this.#y(!0),this.#l?.pause()):this.#l?.resume()}),this.#P()}async#R(){let e=await Vi("/api/session");this.#w(e),this.#c=!0;let t=e.view??{};typeof t.automatic=="boolean"&&(this.settings.automatic=t.automatic),typeof t.linked=="boolean"&&(this.settings.linked=t.linked),typeof t.analysisOpen=="boolean"&&(this.settings.analysisOpen=t.analysisOpen),Array.isArray(t.selected)&&(this.settings.selected=t.selected.filter(i=>typeof i=="string"&&i!=="preview")),this.settings.scene=t.scene??null}#w({params:e,settings:t={}}){this.#r={params:e,settings:t},this.values={...e};let i=new Set(this.analysisSettings.map(s=>s.name));this.analysis=Object.fromEntries(Object.entries(t).filter(([s])=>i.has(s)))}async#E(){this.#s||!this.#f||await this.#p(async()=>{let e=await Vi("/api/session"),{params:t,settings:i={}}=e;if(this.#o){this.#a=!0;return}ym({params:t,settings:i},this.#r)||!ym(this.#A(),this.#r)||(this.#w(e),this.#g(0))})}#P(){if(!this.#h)return;let e=!0;this.#l=new Yh(this.#h,t=>this.#I(t),()=>{this.isConnected&&!e&&(this.notice=null,this.#x=""),e=this.isConnected,this.#y(),this.#u()})}get isLoaded(){return this.#f}get connection(){return this.#l?.state??"connected"}get isConnected(){return this.connection==="connected"}#I(e){e.addEventListener("model",()=>{this.#T()}),e.addEventListener("runs",()=>{this.#L()}),e.addEventListener("session",()=>{this.#E()}),e.addEventListener("progress",t=>{let{id:i,...s}=JSON.parse(t.data);this.progress[i]=s,this.settings.selected.includes(i)&&this.#N(i),this.#u()})}async#T(){this.withoutModel||await this.#p(async()=>{let e=await Vi("/api/model");if(e.broken){let{params:s,outputs:r,doc:o}=this.model??e;this.model={...e,params:s,outputs:r,doc:o},this.#d?.abort(),this.check=null,this.isChecking=!1;return}this.model=e,this.#c&&(this.values=this.#C()),this.#c=!1;let t=new Set(e.params.map(s=>s.name)),i=Object.keys(this.values).filter(s=>!t.has(s));for(let s of i)delete this.values[s];if(i.length>0){let s=`the model has no param ${i.map(r=>`\`${r}\``).join(", ")} any more`;this.notice={message:s,help:"its value in the form was dropped"}}this.#g(0)})}async#L(){await this.#p(async()=>{let{runs:e}=await Vi("/api/runs"),t=new Map(this.runs.map(r=>[r.id,JSON.stringify(r)]));this.runs=e;let i=new Set(e.map(r=>r.id));for(let r of[...this.#_])i.has(r)?this.#_.delete(r):i.add(r);let s=this.settings.selected.filter(r=>!i.has(r)&&t.has(r)&&r!=="preview");s.length>0&&(this.notice={message:`${s.map(en).join(", ")}: the directory was deleted`,help:""}),this.settings.selected=this.settings.selected.filter(r=>i.has(r));for(let r of Object.keys(this.results))i.has(r)||delete this.results[r];for(let r of e){r.progress&&(this.progress[r.id]=r.progress);let o=t.get(r.id)!==JSON.stringify(r)||r.id==="preview";this.settings.selected.includes(r.id)&&(o||!this.results[r.id])&&this.#S(r.id)}if(this.settings.selected.length===0){let r=e.findLast(o=>o.status==="finished");r&&this.select([r.id])}})}#N(e){if(this.#m.has(e))return;let t=window.setTimeout(()=>{this.#m.delete(e),this.#S(e)},wP);this.#m.set(e,t)}async#S(e){try{this.results[e]=await Vi(pi(e))}catch(t){t instanceof ai&&t.status===404||this.#M(t),delete this.results[e]}this.#u()}param(e){return this.model?.params.find(t=>t.name===e)}value(e){return this.values[e.name]??e.default??""}setValue(e,t){let i=this.param(e);i?.independent&&i.default===t?delete this.values[e]:this.values[e]=t,this.#g(ib),this.#u()}reset(e){delete this.values[e],this.#g(0),this.#u()}get form(){return{params:{...this.values},settings:{...this.analysis}}}isChanged(e){let t=this.values[e],i=this.param(e);return t===void 0?!1:!i?.independent||i.default===null||!Ys(i.default,t)}get changes(){return Object.keys(this.values).filter(e=>this.isChanged(e)).length+Object.keys(this.analysis).length}setAnalysis(e,t){t===""?delete this.analysis[e]:this.analysis[e]=t,this.#g(ib),this.#u()}resetAll(){this.analysis={},this.setValues({})}setValues(e){this.values={};for(let[t,i]of Object.entries(e)){let s=this.param(t);(!s?.independent||s.default===null||!Ys(s.default,i))&&(this.values[t]=i)}this.#g(0),this.#u()}#g(e){this.modelScene&&(this.scene="model"),window.clearTimeout(this.#t),this.isChecking=!0,this.#t=window.setTimeout(()=>{this.#D()},e),this.#v()}async#D(){if(!this.model||this.model.broken){this.isChecking=!1;return}this.#d?.abort();let e=new AbortController;this.#d=e;let{form:t}=this;await this.#p(async()=>{let i=await bs("POST","/api/check",t,e.signal);e.signal.aborted||(this.check=i,this.isChecking=!1,i.version!==this.model?.version&&await this.#T(),await Promise.all([this.#U(t),this.#F(t,e.signal)]))}),this.#d===e&&(this.isChecking=!1),this.#u()}get canRun(){return this.isConnected&&!this.isStarting&&!!this.check?.runnable}get command(){let e=this.#h?.model||(this.runs.find(i=>i.id==="opened")?.directory??"");return`calyx studio ${/^[\w./@%+,:=-]*$/.test(e)?e:`'${e.replaceAll("'","'\\''")}'`}`.trim()+(location.port&&` --port ${location.port}`)}get isQuick(){return this.check?.plan!=null&&this.check.plan.time<MP}async#F(e,t){let{errors:i,setting_errors:s}=this.check??{};if(!(Object.keys({...i,...s}).length>0))try{this.modelScene=await gg(e,t)}catch(r){if(!(r instanceof ai))throw r;this.modelScene=null}}showScene(e){this.scene=e,this.#u()}async#U(e){let t=JSON.stringify([this.check?.version,e]);if(!this.settings.automatic||!this.check?.runnable||!this.isQuick||this.#x===t)return;if(this.#x=t,this.#b){this.#b=!1;return}await bs("POST","/api/preview",e),this.#_.add("preview"),this.settings.selected.length<=1&&this.select(["preview"])}setAutomatic(e){this.settings.automatic=e,this.#v(),this.#u(),e&&this.#g(0)}setAnalysisOpen(e){e!==this.settings.analysisOpen&&(this.settings.analysisOpen=e,this.#v())}setLinked(e){this.settings.linked=e,this.#v(),this.#u()}setScene(e){this.settings.scene=e,this.#v()}async run(){this.isStarting=!0,this.#u(),await this.#p(async()=>{let{id:e}=await bs("POST","/api/runs",this.form);this.#_.add(e),this.select([e])}),this.isStarting=!1,this.#u()}async cancel(e){await this.#p(()=>bs("POST",pi(e,"/cancel"),{}))}async continue(e){await this.#p(async()=>{await bs("POST",pi(e,"/continue"),{}),delete this.progress[e]})}select(e){this.settings.selected=e,this.scene="runs";for(let t of e)this.results[t]||this.#S(t);this.#v(),this.#u()}toggle(e){let{selected:t}=this.settings;this.select(t.includes(e)?t.filter(i=>i!==e):[...t,e])}useForm(e){let t={};for(let[i,s]of Object.entries(e.params??{}))this.param(i)&&s.at_default!==!0&&(t[i]=s.entered??s.text);this.analysis={...e.settings},this.setValues(t)}dismiss(){this.notice=null,this.#u()}fail(e){this.#M(e),this.#u()}#M(e){if(e instanceof DOMException&&e.name==="AbortError")return;let t=e instanceof ai?e.help:"";this.notice={message:e instanceof Error?e.message:String(e),help:t}}async#p(e){try{await e()}catch(t){this.#M(t)}this.#u()}#v(){!this.#f||this.withoutModel||this.#s||(this.#i=!0,window.clearTimeout(this.#n),this.#n=window.setTimeout(()=>this.#y(),EP))}#y(e=!1){if(window.clearTimeout(this.#n),!this.#i||!this.isConnected||this.#o&&!e)return;this.#i=!1,this.#o=!0;let t=this.#r,i=this.#A();this.#r=i,this.#p(async()=>{try{await xg({version:1,...i,view:{...this.settings},before:t})}catch(s){this.#r=t;let r=s instanceof ai&&s.status===409;if(r&&ym(i,t)){this.#i=!0,this.#a=!0;return}throw r?this.#s=!0:this.#i=!0,s}finally{this.#o=!1,this.#a&&(this.#a=!1,await this.#E())}this.#y()})}#A(){return{params:this.#C(),settings:{...this.analysis}}}#C(){let e=([t,i])=>i.trim()!==""||this.param(t)?.kind==="text";return Object.fromEntries(Object.entries(this.values).filter(e))}};function ym(n,e){let t=({params:i,settings:s})=>JSON.stringify([i,s].map(r=>Object.entries(r).sort(([o],[a])=>o<a?-1:1)));return t(n)===t(e)}var sb=document.getElementById("studio");if(sb){hc(uc());let n=new Jh;ga(x(nb,{studio:n}),sb),n.load()}})();
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
