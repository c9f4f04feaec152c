"use strict";(()=>{var Ft,Lm,ob,qs,ed,Tl,Nm,Sl,Dm,nd,td,ab,ha=Symbol.for("pv"),Al={},Rl=[],lb=/^m(i|n|o|s|text|space)$/,id=Array.isArray,Fm=Rl.slice,br=Object.assign;function yr(n){n&&n.parentNode&&n.remove()}function Ml(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:ha,__v:s||++Lm,__i:-1,__u:0};return!s&&Ft.vnode&&Ft.vnode(r),r}function lt(n){return n.children}function wl(n,e){this.props=n,this.context=e,this.__g=0}function Ys(n,e){if(e==null)return n.__&&Ys(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:Ys(n)}function cb(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=br({constructor:ha},t)).__v=t.__v+1,Ft.vnode&&Ft.vnode(e),sd(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||Ys(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,Vm(s,e,r),t.__=t.__e=null,e.__e!=i&&Um(e))}function Um(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),Um(n)}function Pm(n){(8&n.__g||(n.__g|=8,qs.push(n),Tl++))&&ed==Ft.debounceRendering||((ed=Ft.debounceRendering)||queueMicrotask)(Om)}function Om(){try{for(var n,e=1;qs.length;)qs.length>e&&qs.sort(Nm),n=qs.shift(),e=qs.length,8&n.__g&&cb(n)}finally{(Tl=qs.length)&&(ed||queueMicrotask)(Om)}}function km(n,e,t,i,s,r,o,a,l,c,u){var d,h,f,p,v,m,g=i.__k||Rl,_=e.length;for(l=ub(t,e,g,l,_),d=0;d<_;d++)(f=t.__k[d])!=null&&(h=~f.__i&&g[f.__i]||Al,f.__i=d,m=sd(n,f,h,s,r,o,a,l,c,u),p=f.__e,(h.ref!=f.ref||8&h.__u)&&(h.ref&&rd(h.ref,null,f,h),f.ref&&u.push(f.ref,f.__c||p,f)),v=v||p,4&f.__u?(l=Bm(f,l,n,!h.__v),h.__e&&(h.__e=null)):typeof f.type=="function"&&m!==void 0?l=m:p&&(l=p.nextSibling),f.__u&=-21);return t.__e=v,l}function ub(n,e,t,i,s){var r,o,a,l,c,u,d,h,f,p=t.length,v=p,m=0,g=0,_=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=_[r]=Ml(null,o):id(o)?o=_[r]=Ml(lt,{children:o}):o.constructor===ha&&o.__b?o=_[r]=Ml(o.type,o.props,o.key,o.ref,o.__v):_[r]=o,l=r+m,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=hb(o,t,l,v))&&(v--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?m--:c==l+1?m++:c!=l&&(c>l?m--:m++,g=1)):(~c||(s>p?m--:s<p&&m++),typeof o.type!="function"&&(o.__u|=4))):_[r]=null;if(g){for(u=[],d=[],r=0;r<s;r++)if((o=_[r])&&16&o.__u){for(m=0,h=u.length;m<h;)u[f=m+h>>1]<o.__i?m=f+1:h=f;u[m]=o.__i,d[r]=m+1}for(m=u.length;r--;)d[r]&&(d[r]==m?m--:_[r].__u|=4)}if(v)for(r=0;r<p;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=Ys(a)),od(a,a));return i}function Bm(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=Bm(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=Ys(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function hb(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function Im(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function bl(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Im(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Im(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=td[e]||(td[e]=db(e)),(n.__a||(n.__a={}))[e]=nd,r=e!=(e=e.replace(Dm,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function db(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[Sl]==null)e[Sl]=nd++;else if(e[Sl]<this.__a[n])return;return t(Ft.event?Ft.event(e):e)}}}function sd(n,e,t,i,s,r,o,a,l,c){var u,d,h,f,p,v,m,g,_,M,b,C,R,y,E,U,N,L,O=e.type;if(e.constructor!==ha)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,d=r=[],u.nodeType==8?a=El(u,r):r.push(u),a=r[0]||a),(u=Ft.__b)&&u(e);e:if(typeof O=="function"){h=o.length;try{if(g=e.props,_=(u=O.prototype)&&u.render,M=(u=O.contextType)&&i[u.__c],b=u?M?M.props.value:u.__:i,(f=t.__c)?(e.__c=f,2&f.__g&&(f.__g|=1)):(_?e.__c=f=new O(g,b):(e.__c=f=new wl(g,b),f.constructor=O,f.render=pb),M&&M.sub(f),f.state||(f.state={}),f.__n=i,f.__g|=8,f.__h=[],f.__k=[]),_&&(f.__s||(f.__s=f.state),O.getDerivedStateFromProps&&(f.__s==f.state&&(f.__s=br({},f.__s)),br(f.__s,O.getDerivedStateFromProps(g,f.__s)))),p=f.props,v=f.state,f.__v=e,t.__c){if(g!==p&&_&&!O.getDerivedStateFromProps&&f.componentWillReceiveProps&&f.componentWillReceiveProps(g,b),e.__v==t.__v&&!(8&f.__g)||!(4&f.__g)&&f.shouldComponentUpdate&&f.shouldComponentUpdate(g,f.__s,b)===!1){e.__v!=t.__v&&(f.props=g,f.state=f.__s,f.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(z){z&&(z.__=e)}),Rl.push.apply(f.__h,f.__k),f.__k=[],f.__h.length&&o.push(f),a=Ys(t);break e}f.componentWillUpdate&&f.componentWillUpdate(g,f.__s,b),_&&f.componentDidUpdate&&f.__h.push(function(){f.componentDidUpdate(p,v,m)})}else _&&!O.getDerivedStateFromProps&&f.componentWillMount&&f.componentWillMount(),_&&f.componentDidMount&&f.__h.push(f.componentDidMount);f.context=b,f.props=g,f.__P=n,f.__g&=-5,C=Ft.__r,R=_?25:0;do f.__g&=-9,C&&C(e),u=f.render(f.props,f.state=f.__s,f.context);while(8&f.__g&&++R<25);_&&(Rl.push.apply(f.__h,f.__k),f.__k=[]),f.state=f.__s,f.getChildContext&&(i=br({},i,f.getChildContext())),_&&t.__c&&f.getSnapshotBeforeUpdate&&(m=f.getSnapshotBeforeUpdate(p,v)),y=u&&u.type===lt&&u.key==null?u.props.children:u,g.__P&&(u=a,s=(n=g.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(z){z&&od(z,z)}),t.__k=null),a=t.__k?Ys(t,0):null),a=km(n,id(y)?y:[y],e,t,i,s,r,o,a,l,c),g.__P&&(e.__e=null,a=u),e.__u&=-161,d&&d.some(yr),f.__h.length&&o.push(f),1&f.__g&&(f.__g&=-4)}catch(z){if(o.length=h,e.__v=null,l||r)if(z&&z.then){if(e.__u|=128|l,r){for(~(N=r.indexOf(a||void 0))||(N=r.length);(L=r[N-1])&&L.nodeType==8;)N--;for(;N<r.length;N++)if(L=r[N])if(r[N]=null,E){if(L==U)break}else{if(L.nodeType!=8)break;L.data.startsWith("$s")&&(U=El(E=L))}}if(!E){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;E=a}(u=El(E=e.__c.__z||(e.__c.__z=E)))?(e.__e=E,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(yr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),z&&z.then||zm(e),Ft.__e(z,e,t)}}else a=e.__e=fb(t.__e,e,t,i,s,r,o,l,c,n);return(u=Ft.diffed)&&u(e),a}function El(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function zm(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(zm))}function Vm(n,e,t){for(var i=0;i<t.length;)rd(t[i++],t[i++],t[i++]);Ft.__c&&Ft.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Ft.__e(r,s.__v)}})}function fb(n,e,t,i,s,r,o,a,l,c){var u,d,h,f,p,v,m,g,_=t.props||Al,M=e.props,b=e.type;if(b=="svg"?s="http://www.w3.org/2000/svg":b=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((p=r[u])&&(b?p.localName==b:p.nodeType==3)){n=p,r[u]=null;break}}if(!n){if(g=c.ownerDocument||document,!b)return g.createTextNode(M);n=g.createElementNS(s,b,M.is?M:c),a&&(Ft.__m&&Ft.__m(e,r),a=!1),r=null}if(b){if(c=b=="template"&&n.content||n,r=b=="textarea"&&M.defaultValue!=null?null:r&&Fm.call(c.childNodes),!a&&r)for(_={},u=0;u<n.attributes.length;u++)_[(p=n.attributes[u]).name]=p.value;for(u in _)p=_[u],u=="dangerouslySetInnerHTML"?h=p:u=="children"||u in M||u=="value"&&"defaultValue"in M||u=="checked"&&"defaultChecked"in M||bl(n,u,null,p,s);for(u in M)p=M[u],u=="children"?f=p:u=="dangerouslySetInnerHTML"?d=p:u=="value"?v=p:u=="checked"?m=p:a&&typeof p!="function"||_[u]===p||bl(n,u,p,_[u],s);d?(a||h&&(d.__html==h.__html||d.__html==n.innerHTML)||(n.innerHTML=d.__html),e.__k=[]):(h&&(n.textContent=""),(b=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&lb.test(b))&&(s="http://www.w3.org/1999/xhtml"),km(c,id(f)?f:[f],e,t,i,s,r,o,r?r[0]:t.__k&&Ys(t,0),a,l),r&&r.some(yr)),a&&b!="textarea"||(u="value",b=="progress"&&v==null?n.removeAttribute(u):v==null||v===n[u]&&(b!="progress"||v)||bl(n,u,v,_[u],s),u="checked",m!=null&&m!=n[u]&&bl(n,u,m,_[u],s))}else _===M||a&&n.data==M||(n.data=M);return n}function rd(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Ft.__e(s,t)}}function od(n,e,t){var i,s,r,o;if(Ft.unmount&&Ft.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||rd(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Ft.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&od(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=El(i,r=[]))&&(i==n.__e&&r.some(yr),yr(s),yr(i)),t||yr(n.__e),n.__e=n.__c=n.__=null}function pb(n,e,t){return this.constructor(n,t)}function da(n,e){var t,i,s,r;Ft.__&&Ft.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=Ml(lt,{children:[n]}),s=[],r=[],sd(e,e.__k,i||Al,Al,e.namespaceURI,i?null:e.firstChild?Fm.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),Vm(s,e.__k,r),e.__k.props.children=null}Ft={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw Tl=0,n}},Lm=0,ob=function(n){return n!=null&&n.constructor===ha},wl.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=br({},this.state)),typeof n=="function"&&(n=n(br({},t),this.props)),n&&(br(t,n),this.__v&&(e&&this.__k.push(e),Pm(this)))},wl.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),Pm(this))},wl.prototype.render=lt,qs=[],Tl=0,Nm=function(n,e){return n.__v.__b-e.__v.__b},Sl=Symbol(),Dm=/(PointerCapture)$|Capture$/i,nd=0,td={},ab=0;var io,bn,ad,Hm,ld=Object.is,Cl=0,Km=[],cd=[],pn=Ft,Gm=pn.__b,Wm=pn.__r,Xm=pn.diffed,$m=pn.__c,qm=pn.unmount,Ym=pn.__;function Pl(n,e){pn.__h&&pn.__h(bn,n,Cl||e),Cl=0;var t=bn.__H||(bn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function Tt(n){return Cl=1,hd(Qm,n)}function hd(n,e,t){var i=Pl(io++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):Qm(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);ld(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=bn,!bn.__f)){bn.__f=!0;var s=bn.shouldComponentUpdate;bn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(h){h.__N&&(c=!0,ld(h.__[0],h.__N[0])||(u=!0))}),s){var d=s.call(this,r,o,a);return c?d||u:d}return!c||u}}return i.__}function At(n,e){var t=Pl(io++,3);!pn.__s&&dd(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,bn.__H.__h.push(t))}function jm(n,e){var t=Pl(io++,4);!pn.__s&&dd(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,bn.__h.push(t))}function Gt(n){return Cl=5,mb(function(){return{current:n}},[])}function mb(n,e){var t=Pl(io++,7);return dd(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function gb(){var n;do{for(;n=cd.shift();)try{fa(n)}catch(t){pn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=Km.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(fa),e.__h.some(ud),e.__h=[]}catch(t){e.__h=[],pn.__e(t,n.__v)}}}while(cd.length)}pn.__b=function(n){bn=null,Gm&&Gm(n)},pn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),Ym&&Ym(n,e)},pn.__r=function(n){Wm&&Wm(n),io=0;var e=(bn=n.__c).__H;e&&(ad==bn?bn.__h=[]:(e.__h.some(fa),e.__h.some(ud),io=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),ad=bn},pn.diffed=function(n){Xm&&Xm(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&Zm(Km.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),ad=bn=null},pn.__c=function(n,e){e.some(function(t){try{t.__h.some(fa),t.__h=t.__h.filter(function(i){return!i.__||ud(i)})}catch(i){t.__h=[function(){throw i}]}}),$m&&$m(n,e)},pn.unmount=function(n){qm&&qm(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,Zm(cd.push(s))}else fa(s)}catch(r){e=r}}),i.__H=void 0,e&&pn.__e(e,i.__v))};var Jm=typeof requestAnimationFrame=="function";function xb(n){var e,t=function(){clearTimeout(i),Jm&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Jm&&(e=requestAnimationFrame(t))}function Zm(n){n!=1&&Hm==pn.requestAnimationFrame||((Hm=pn.requestAnimationFrame)||xb)(gb)}function fa(n){var e=bn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),bn=e}function ud(n){var e=bn;n.__c=n.__(),bn=e}function dd(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!ld(t,n[i])})}function Qm(n,e){return typeof e=="function"?e(n):e}function ti(n){if(n==null||Number.isNaN(n))return"–";if(n===0)return"0";let e=Math.abs(n);return e>=1e6||e<1e-4?n.toExponential(3).replace("e+","e"):String(Number(n.toPrecision(5)))}function pa(n){return n<.095?`${Math.ceil(1e3*n)} ms`:n<9.5?`${n.toFixed(1)} s`:n<600?`${Math.round(n)} s`:n<7200?`${Math.round(n/60)} min`:`${(n/3600).toFixed(1)} h`}function fd(n){return n<1e6?"below 1 MB":n<1e9?`${Math.ceil(1e-6*n)} MB`:`${(1e-9*n).toFixed(1)} GB`}function eg(n){let e=100*n;return e>=1?`${e.toFixed(1)} %`:`${Number(e.toPrecision(1))} %`}function tg(n){if(n===null)return"";let e=new Date(1e3*n);return`${e.toLocaleDateString(void 0,{year:"numeric",month:"short",day:"numeric"})} ${e.toLocaleTimeString()}`}function ng(n){if(n===null)return"";let e=new Date(1e3*n),t=e.toDateString()===new Date().toDateString(),i=e.toLocaleTimeString(void 0,{hour:"2-digit",minute:"2-digit"});return t?i:`${e.toLocaleDateString()} ${i}`}function en(n){return n==="preview"?"Automatic run":n==="model"?"Run from the command line":n==="opened"?"Opened run":`Run ${Number(n.replace("run-",""))}`}function tn(n){return n.replaceAll("_"," ")}function so(n){return n.replace(/([^\n])\n(?!\n)/g,"$1 ")}function Sr(n){return n.split("/").pop()??n}function Il(n,e){return e?`${n} ${e}`:n}function Ll({entered:n,text:e,unit:t}){return n!==void 0?bs(n)?Il(n.trim(),t):n.trim():Il(bs(e)&&e.length>8?ti(Number(e)):e,t)}function bs(n){return/^\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*$/.test(n)}function ma(n){let e=n.positions??0;return n.incomplete?n.total!==null&&n.total>=e?`${e} of ${n.total}`:String(e):n.positions===null?"":String(e)}function os(n){let e=n.total===null?n.positions===1:n.total===1;return`${ma(n)} ${e?"position":"positions"}`}function Nl(n){return n==="vtu"?"meshes with stresses":tn(n)}function Dl(n){return n==="TRUE"?"yes":n==="FALSE"?"no":n}function Js(n,e){let[t,i]=[n.trim(),e.trim()];return t===i||bs(t)&&bs(i)&&Number(t)===Number(i)}var vb=Symbol.for("pv"),_b=0;function x(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:vb,__v:--_b,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),Ft.vnode&&Ft.vnode(c),c}function oi({text:n}){return x(lt,{children:n.split("`").map((e,t)=>t%2===1?x("code",{children:e},t):e)})}function Fl({text:n,isError:e}){return x("pre",{class:`rendered ${e?"error":"warning"}`,role:e?"alert":void 0,tabIndex:0,"aria-label":"Diagnostics of the model",children:n.trim()})}function pd({messages:n}){return n.length===0?null:x("ul",{class:"messages",children:n.map((e,t)=>x("li",{class:e.severity,children:[e.code&&x("code",{children:e.code})," ",x(oi,{text:e.message}),e.primary&&x("span",{class:"place",children:[" ",Sr(e.primary.file),":",e.primary.line]}),e.help&&x("span",{class:"help",children:x(oi,{text:e.help})})]},t))})}var yb=200,bb=1e3,ig=24;function sg({studio:n,param:e}){let t=n.value(e),i=n.isChanged(e.name),s=n.check?.errors[e.name],r=`param-${e.name}`,a=e.kind==="number"||e.kind==="integer"||e.kind==="array"?e.domain:"",l=tn(e.name.split(".").pop()??e.name),c=l.length+a.length<ig+12&&a.length<=ig,u=[a&&c&&`${r}-range`,`${r}-doc`,s&&`${r}-error`].filter(Boolean).join(" ");return x("div",{class:`field ${i?"changed":""} ${s?"invalid":""}`,"data-param":e.name,children:[x(md,{id:r,label:l,title:e.name,range:c&&a?a:void 0,reset:i?`Reset ${tn(e.name)} to ${e.default??"its default"}`:null,onReset:()=>n.reset(e.name),children:e.kind==="boolean"&&x("input",{id:r,type:"checkbox",checked:t.toUpperCase()==="TRUE","aria-describedby":u,onChange:d=>n.setValue(e.name,d.currentTarget.checked?"TRUE":"FALSE")})}),e.kind!=="boolean"&&x(Sb,{studio:n,param:e,id:r,text:t,describedBy:u,isInvalid:!!s}),x(Mb,{studio:n,param:e,text:t}),x("p",{class:"doc",id:`${r}-doc`,children:[so(e.doc),!e.independent&&x("span",{class:"note",children:" Default and range follow other params."}),a&&!c&&x("span",{class:"range",children:a})]}),s&&x(gd,{id:`${r}-error`,error:s})]})}function md({id:n,label:e,title:t,range:i,reset:s,onReset:r,children:o}){return x("div",{class:"field-head",children:[o,x("label",{for:n,title:t,children:e}),i&&x("span",{class:"range",id:`${n}-range`,children:i}),s!==null&&x("button",{type:"button",class:"quiet small","aria-label":s,title:s,onClick:r,children:"reset"})]})}function gd({id:n,error:e}){return x("p",{class:"field-error",id:n,role:"alert",children:[x(oi,{text:e.message}),e.help&&x("span",{class:"help",children:x(oi,{text:e.help})})]})}function Sb({studio:n,param:e,id:t,text:i,describedBy:s,isInvalid:r}){let o=l=>n.setValue(e.name,l);if(e.kind==="choice"){let l=e.choices.includes(i)?e.choices:[i,...e.choices];return x("div",{class:"control",children:x("select",{id:t,value:i,"aria-describedby":s,"aria-invalid":r,onChange:c=>o(c.currentTarget.value),children:l.map(c=>x("option",{value:c,children:c},c))})})}let a=e.unit!==""&&(bs(i)||i===""||/^\s*\[[^\]]*\]\s*$/.test(i));return x("div",{class:"control",children:[x("input",{id:t,type:"text",inputMode:e.kind==="integer"?"numeric":void 0,value:i,placeholder:e.default??"",autocomplete:"off",spellcheck:!1,"aria-describedby":s,"aria-invalid":r,onInput:l=>o(l.currentTarget.value)}),e.unit&&x("span",{class:`unit ${a?"":"off"}`,children:e.unit})]})}function Mb({studio:n,param:e,text:t}){let{low:i,high:s}=e;if(e.kind!=="number"&&e.kind!=="integer"||!e.independent||i===null||s===null||!(s>i)||!bs(t)||i>0&&s/i>yb||e.kind==="integer"&&s-i>bb)return null;let r=e.kind==="integer"?1:10**Math.floor(Math.log10((s-i)/100));return x("input",{type:"range",class:"slider",min:i,max:s,step:r,value:t,"aria-label":`${tn(e.name)}, slider`,onInput:o=>n.setValue(e.name,String(Number(o.currentTarget.value)))})}function og({studio:n}){let{analysisSettings:e,analysis:t}=n,i=e.filter(u=>u.detail),s=n.check?.setting_errors??{},r=Object.keys(t).length,o=n.settings.analysisOpen||Object.keys(s).length>0,[a,l]=Tt(!1),c=i.some(({name:u})=>u in t||u in s);return At(()=>{c&&l(!0)},[c]),e.length===0?null:x("details",{class:"analysis",open:o,onToggle:u=>{u.target===u.currentTarget&&n.setAnalysisOpen(u.currentTarget.open)},children:[x("summary",{children:["Analysis settings",r>0&&x("span",{class:"summary-value",children:[r," changed"]})]}),x("fieldset",{children:[x("legend",{class:"hidden-text",children:"Analysis settings"}),e.filter(u=>!u.detail).map(u=>x(rg,{studio:n,setting:u},u.name)),x("details",{open:a,onToggle:u=>l(u.currentTarget.open),children:[x("summary",{children:"Positions, mesh and contact grid"}),i.map(u=>x(rg,{studio:n,setting:u},u.name))]})]})]})}function rg({studio:n,setting:e}){let{name:t,label:i,doc:s,domain:r}=e,o=n.analysis[t]??"",a=n.check?.setting_errors[t],l=`setting-${t}`,c=Tb(n,t),u=[`${l}-doc`,a&&`${l}-error`,!a&&c&&`${l}-effect`].filter(Boolean).join(" "),d=t in n.analysis;return x("div",{class:`field ${d?"changed":""} ${a?"invalid":""}`,"data-setting":t,children:[x(md,{id:l,label:i,title:t,reset:d?`Reset ${i} to the model's own`:null,onReset:()=>n.setAnalysis(t,""),children:e.kind==="boolean"&&x("input",{id:l,type:"checkbox",checked:o==="TRUE","aria-describedby":u,onChange:h=>n.setAnalysis(t,h.currentTarget.checked?"TRUE":"")})}),e.kind!=="boolean"&&x("div",{class:"control",children:x(Ab,{studio:n,setting:e,id:l,text:o,describedBy:u,isInvalid:!!a})}),x("p",{class:"doc",id:`${l}-doc`,children:[s,r&&x("span",{class:"range",children:r})]}),a&&x(gd,{id:`${l}-error`,error:a}),!a&&c&&x("p",{class:"field-note",id:`${l}-effect`,role:"status",children:x(oi,{text:c})})]})}var wb=new Set(["vtu","refinement","element_order","face_elements","displacement_order"]),Eb=new Set(["face_elements","displacement_order","contact_slices"]);function Tb(n,e){let t=n.check?.plan;if(!t||!(e in n.analysis))return null;let i=t.ignored_inputs[e];return i?`This setting has no effect: ${i}.`:wb.has(e)&&(t.fidelity==="rigid"||t.fidelity==="analytic")?`This setting has no effect on gears: at the fidelity "${t.fidelity}" they have no finite-element meshes.`:Eb.has(e)&&t.fidelity==="plane"?"This setting has no effect: a two-dimensional model has no face-width direction.":null}function Ab({studio:n,setting:e,id:t,text:i,describedBy:s,isInvalid:r}){let{name:o,choices:a}=e;if(e.kind==="choice"){let l=o==="fidelity"&&i===""?n.check?.plan?.fidelity:void 0;return x("select",{id:t,value:i,"aria-describedby":s,"aria-invalid":r,onChange:c=>n.setAnalysis(o,c.currentTarget.value),children:[x("option",{value:"",children:["As in the model",l&&`: ${l}`]}),a.map(c=>x("option",{value:c.name,children:[c.name,": ",c.doc]},c.name))]})}return x("input",{id:t,type:"text",value:i,placeholder:"as in the model",autocomplete:"off",spellcheck:!1,"aria-describedby":s,"aria-invalid":r,onInput:l=>n.setAnalysis(o,l.currentTarget.value)})}var ai=class extends Error{constructor(t,i,s,r){super(t);this.status=i;this.help=s;this.body=r}status;help;body};async function Ul(n,e={}){let t;try{t=await fetch(n,e)}catch(o){throw o instanceof DOMException&&o.name==="AbortError"?o:new ai("the studio does not respond",0,"start `calyx studio` again",null)}if(t.ok)return t;let i=await t.json().catch(()=>null),{message:s,help:r}=i??{};throw new ai(s??t.statusText,t.status,r??"",i)}async function as(n,e){return(await Ul(n,{signal:e})).json()}async function Ol(n){return(await Ul(n)).arrayBuffer()}async function ag(n,e){let t=await Ss("POST","/api/scene",n,e),i=s=>Uint8Array.from(atob(s),r=>r.charCodeAt(0)).buffer;return{parts:i(t.parts),position:i(t.position)}}var Rb=6e4;async function lg(n){let e=JSON.stringify(n);await Ul("/api/session",{method:"PUT",keepalive:new Blob([e]).size<Rb,headers:{"Content-Type":"application/json"},body:e})}async function Ss(n,e,t,i){let r=await(await Ul(e,{method:n,signal:i,headers:{"Content-Type":"application/json"},body:JSON.stringify(t??{})})).text();return r?JSON.parse(r):null}function pi(n,e=""){return`/api/runs/${encodeURIComponent(n)}${e}`}async function cg(n){let e=await n.text();try{let{params:t}=await Ss("POST","/api/params",{name:n.name,text:e});return t}catch(t){throw!(t instanceof ai)||t.message.includes(n.name)?t:new ai(`${n.name}: ${t.message}`,t.status,t.help,t.body)}}function Cb(n){let e=(n.model?.params??[]).filter(t=>t.independent||t.name in n.values).map(t=>{let i=n.value(t).trim();if(t.kind==="boolean")return[t.name,i.toUpperCase()==="TRUE"];let s=(t.kind==="number"||t.kind==="integer")&&bs(i);return[t.name,s?Number(i):i]});return`${JSON.stringify(Object.fromEntries(e),null,2)}
`}function ug(n,e){let t=URL.createObjectURL(new Blob([Cb(n)],{type:"application/json"})),i=document.createElement("a");i.href=t,i.download=e,i.click(),URL.revokeObjectURL(t)}var Pb=20;function hg({studio:n}){let[e,t]=Tt(""),i=n.model;if(!i)return x("p",{class:"empty",children:n.withoutModel?"The model of this run is not known.":"Loading …"});let s=i.params.length>Pb,r=s?i.params.filter(o=>Ib(n,o,e)):i.params;return x("form",{class:"params","aria-label":"Params",onSubmit:o=>o.preventDefault(),children:[x(Nb,{studio:n}),x(og,{studio:n}),i.params.length===0&&x("p",{class:"empty",children:"The model has no params."}),s&&x("input",{type:"search",class:"search",placeholder:`Find one of ${i.params.length} params`,"aria-label":"Find a param",value:e,onInput:o=>t(o.currentTarget.value)}),i.params.length>0&&r.length===0&&x("p",{class:"empty",role:"status",children:"No param contains these words."}),Lb(r).map(([o,a])=>x("fieldset",{children:[x("legend",{class:o?"":"hidden-text",children:o||"Params"}),a.map(l=>x(sg,{studio:n,param:l},l.name))]},o))]})}function Ib(n,e,t){let i=`${e.name} ${tn(e.name)} ${e.group} ${e.doc}`.toLowerCase();return t.toLowerCase().split(/\s+/).every(r=>i.includes(r))||n.check?.errors[e.name]!==void 0}function Lb(n){let e=new Map;for(let t of n){let i=e.get(t.group);i?i.push(t):e.set(t.group,[t])}return[...e]}function Nb({studio:n}){let e=n.changes,t=Gt(null),i=async s=>{if(s)try{n.setValues(await cg(s))}catch(r){n.fail(r)}};return x("div",{class:"toolbar",children:[x("span",{class:"count",role:"status",children:e===0?"Defaults":`${e} changed`}),x("button",{type:"button",class:"quiet",disabled:e===0,onClick:()=>n.resetAll(),children:"Reset all"}),x("button",{type:"button",class:"quiet",onClick:()=>t.current?.click(),children:"Load …"}),x("button",{type:"button",class:"quiet",onClick:()=>ug(n,`${Sr(n.model?.model??"model")}.json`),children:"Save"}),x("input",{ref:t,type:"file",accept:".json,.toml",class:"hidden-text",tabIndex:-1,"aria-label":"Params file",onChange:s=>{let r=s.currentTarget;i(r.files?.[0]).finally(()=>r.value="")}})]})}var xd=4;function Db(n,e){let{model:t,check:i}=n;if(!t||t.broken||!e.params)return[];let s=t.params.filter(a=>Fb(n,a,e)).map(({name:a})=>tn(a)),r=n.analysisSettings.filter(({name:a})=>{let[l,c]=[n.analysis[a],e.settings?.[a]].map(u=>u==="FALSE"?"":u??"");return e.settings!==null&&!Js(l,c)});return[...i?.source!=null&&e.source!==null&&i.source!==e.source?["the text of the model"]:[],...r.map(({label:a})=>a.toLowerCase()),...s]}function Fb(n,e,t){let i=t.params?.[e.name],s=n.values[e.name];if(s===void 0)return!i||i.at_default===!0?!1:e.default===null||!Js(e.default,i.text);let r=n.check?.values[e.name]??s,o=i?.text??e.default;return o===null||!(Js(r,o)||Js(s,o))}function dg({studio:n}){let{selected:e,automatic:t}=n.settings,i=n.runs.find(({id:a})=>a===e[0]);if(!i||e.length!==1||n.isChecking||i.id==="preview"&&t&&n.isQuick&&n.check?.runnable)return null;let s=Db(n,i);if(s.length===0)return null;let r=s.slice(0,xd).join(", "),o=s.length>xd?` and ${s.length-xd} more`:"";return x("div",{class:"form-changed",role:"status","data-testid":"form-changed",children:[x("span",{children:[x("strong",{children:["Form changed since ",en(i.id),":"]})," ",r,o,". Results are those of the run."]}),x("span",{class:"form-changed-actions",children:[x("button",{type:"button",disabled:!n.canRun,onClick:()=>{n.run()},children:"Run with this form"}),x("button",{type:"button",class:"quiet",onClick:()=>n.useForm(i),children:"Back to the values of the run"})]})]})}var vd=["#2f6fb3","#c8641b","#2c8a57","#8c4fa8","#b3324b","#6b7280","#0f8b8d","#a8861b"],fg=vd.length;function ro(n){return vd[n%vd.length]??"#2f6fb3"}var Ub=[["max","Maximum"],["mean","Mean"],["min","Minimum"],["peak_to_peak","Peak to peak"]],Ob=6;function pg({studio:n}){let e=n.settings.selected,t=e.flatMap(i=>n.results[i]??[]);return x("section",{class:"panel","aria-labelledby":"outputs-heading",children:[x("h2",{id:"outputs-heading",children:"Outputs"}),e.length<=1&&x(kb,{studio:n,results:t[0]}),e.length>1&&x(Gb,{runs:t,places:e})]})}function kb({studio:n,results:e}){return e?.run?.outputs?x(Vb,{results:e}):e?.so_far&&(e.positions??0)>0?x(Bb,{results:e}):x(zb,{studio:n})}function Bb({results:n}){return x(lt,{children:[x("p",{class:"incomplete",children:["Incomplete: ",os(n)]}),x("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Table of outputs at the solved positions",children:x("table",{class:"outputs","data-testid":"so-far",children:[x("thead",{children:x("tr",{children:[x("th",{scope:"col",children:"Output"}),x("th",{scope:"col",children:"Min so far"}),x("th",{scope:"col",children:"Max so far"}),x("th",{scope:"col",children:"Last"})]})}),x("tbody",{children:Object.entries(n.so_far??{}).map(([e,t])=>x("tr",{children:[x("th",{scope:"row",title:t.doc,children:[tn(e)," ",x("span",{class:"unit",children:t.unit})]}),x("td",{children:ti(t.min)}),x("td",{children:ti(t.max)}),x("td",{children:ti(t.last)})]},e))})]})}),x("p",{class:"muted small-text",children:"The remaining positions may have smaller and larger values. Means and errors need all positions."})]})}function zb({studio:n}){let e=n.model?.outputs??[];return n.model?.broken?x("p",{class:"muted",children:"The model has errors."}):e.length===0?x("p",{class:"muted",children:"The model has no outputs."}):x("details",{open:e.length<=Ob,children:[x("summary",{children:[e.length===1?"1 output":`${e.length} outputs`," of a run"]}),x("dl",{class:"declared",children:e.map(t=>x("div",{children:[x("dt",{children:[tn(t.name)," ",t.unit&&x("span",{class:"unit",children:t.unit})]}),x("dd",{children:so(t.doc)})]},t.name))})]})}function Vb({results:n}){let e=Object.entries(n.run?.outputs??{}),t=e.some(([,i])=>i.error_estimate?.includes_level===!1);return x("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Table of outputs",children:[x("table",{class:"outputs","data-testid":"outputs",children:[x("thead",{children:x("tr",{children:[x("th",{scope:"col",children:"Output"}),x("th",{scope:"col",children:"Min"}),x("th",{scope:"col",children:"Mean"}),x("th",{scope:"col",children:"Max"}),x("th",{scope:"col",children:"Error"})]})}),x("tbody",{children:e.map(([i,s])=>x("tr",{children:[x("th",{scope:"row",title:s.doc,children:[tn(i)," ",x("span",{class:"unit",children:s.display.unit})]}),x("td",{children:ti(s.display.min)}),x("td",{children:ti(s.display.mean)}),x("td",{children:ti(s.display.max)}),x("td",{children:Hb(s)})]},i))})]}),x("p",{class:"muted small-text",children:["Error: estimated, relative to the largest magnitude.",t&&" The error of the fidelity level itself is not included."]})]})}function Hb(n){let e=n.error_estimate;return e?e.is_rounding?"rounding":e.relative==null?"–":eg(e.relative):"–"}function Gb({runs:n,places:e}){let[t,i]=Tt("max"),s=[...new Set(n.flatMap(Wb))],r=n[0],o=n.some(ga);return x(lt,{children:[x("label",{class:"inline",children:["Value",x("select",{value:t,onChange:a=>i(a.currentTarget.value),children:Ub.map(([a,l])=>x("option",{value:a,children:l},a))})]}),x("p",{class:"muted small-text",children:["Changes are relative to ",en(r?.id??""),".",o&&" Values of incomplete runs are those of their solved positions, without mean and change."]}),x("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Table of compared outputs",children:x("table",{class:"outputs","data-testid":"compared",children:[x("thead",{children:x("tr",{children:[x("th",{scope:"col",children:"Output"}),n.map(a=>x("th",{scope:"col",children:[x("span",{class:"swatch",style:{background:ro(e.indexOf(a.id))}}),en(a.id),ga(a)&&x("span",{class:"incomplete",children:[ma(a)," solved"]})]},a.id))]})}),x("tbody",{children:s.map(a=>x("tr",{children:[x("th",{scope:"row",children:[tn(a)," ",x("span",{class:"unit",children:Xb(n,a)})]}),n.map(l=>{let c=l!==r&&r&&!ga(l)&&!ga(r);return x("td",{class:ga(l)?"so-far":"",children:[ti(_d(l,a,t)),c&&x($b,{from:_d(r,a,t),to:_d(l,a,t)})]},l.id)})]},a))})]})})]})}function ga(n){return!n.run?.outputs}function Wb(n){return Object.keys(n.run?.outputs??n.so_far??{})}function Xb(n,e){return n.map(i=>i.run?.outputs?.[e]?.display.unit??i.so_far?.[e]?.unit).find(i=>i!==void 0)??""}function _d(n,e,t){let i=n.run?.outputs?.[e]?.display;if(i)return i[t];let s=n.so_far?.[e];return s&&(t==="min"||t==="max")?s[t]:null}function $b({from:n,to:e}){if(n===null||e===null||n===0)return null;let t=100*(e-n)/Math.abs(n),i=Math.abs(t)<.005?"±0":`${t>0?"+":"−"}${Math.abs(t).toFixed(Math.abs(t)<10?2:1)}`;return x("span",{class:"change",children:[i," %"]})}var qb="uplot",Yb="u-hz",Jb="u-vt",Zb="u-title",Kb="u-wrap",jb="u-under",Qb="u-over",eS="u-axis",Er="u-off",tS="u-select",nS="u-cursor-x",iS="u-cursor-y",sS="u-cursor-pt",rS="u-legend",oS="u-live",aS="u-inline",lS="u-series",cS="u-marker",mg="u-label",uS="u-value",va="width",_a="height";var gg="bottom",oo="left",yd="right",Od="#000",xg=Od+"0",bd="mousemove",vg="mousedown",Sd="mouseup",_g="mouseenter",yg="mouseleave",bg="dblclick",hS="resize",dS="scroll",Sg="change",Hl="dppxchange",kd="--",po=typeof window<"u",Ad=po?document:null,lo=po?window:null,fS=po?navigator:null,Rt,kl;function Rd(){let n=devicePixelRatio;Rt!=n&&(Rt=n,kl&&Pd(Sg,kl,Rd),kl=matchMedia(`(min-resolution: ${Rt-.001}dppx) and (max-resolution: ${Rt+.001}dppx)`),Tr(Sg,kl,Rd),lo.dispatchEvent(new CustomEvent(Hl)))}function mi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Cd(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Jt(n,e,t){n.style[e]=t+"px"}function Vi(n,e,t,i){let s=Ad.createElement(n);return e!=null&&mi(s,e),t?.insertBefore(s,i),s}function Ri(n,e){return Vi("div",n,e)}var Mg=new WeakMap;function ls(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Mg.get(n);r!=o&&(n.style.transform=r,Mg.set(n,r),e<0||t<0||e>i||t>s?mi(n,Er):Cd(n,Er))}var wg=new WeakMap;function Eg(n,e,t){let i=e+t,s=wg.get(n);i!=s&&(wg.set(n,i),n.style.background=e,n.style.borderColor=t)}var Tg=new WeakMap;function Ag(n,e,t,i){let s=e+""+t,r=Tg.get(n);s!=r&&(Tg.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Bd={passive:!0},pS={...Bd,capture:!0};function Tr(n,e,t,i){e.addEventListener(n,t,i?pS:Bd)}function Pd(n,e,t,i){e.removeEventListener(n,t,Bd)}po&&Rd();function Hi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:gi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function t0(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var n0=n=>n!=null,i0=n=>n!=null&&n>0,Xl=t0(n0),mS=t0(i0);function gS(n,e,t,i=0,s=!1){let r=s?mS:Xl,o=s?i0:n0;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Vt,l??-Vt]}function $l(n,e,t,i){let s=Pg(n),r=Pg(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Ms:s0,a=s==1?gi:Ci,l=r==1?Ci:gi,c=a(o(In(n))),u=l(o(In(e))),d=co(t,c),h=co(t,u);return t==10&&(c<0&&(d=Ht(d,-c)),u<0&&(h=Ht(h,-u))),i||t==2?(n=d*s,e=h*r):(n=l0(n,d),e=ql(e,h)),[n,e]}function zd(n,e,t,i){let s=$l(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Vd=.1,Rg={mode:3,pad:Vd},ba={pad:0,soft:null,mode:0},xS={min:ba,max:ba};function Gl(n,e,t,i){return Yl(t)?Cg(n,e,t):(ba.pad=t,ba.soft=i?0:null,ba.mode=i?3:0,Cg(n,e,xS))}function wt(n,e){return n??e}function vS(n,e,t){for(e=wt(e,0),t=wt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Cg(n,e,t){let i=t.min,s=t.max,r=wt(i.pad,0),o=wt(s.pad,0),a=wt(i.hard,-Vt),l=wt(s.hard,Vt),c=wt(i.soft,Vt),u=wt(s.soft,-Vt),d=wt(i.mode,0),h=wt(s.mode,0),f=e-n,p=Ms(f),v=ni(In(n),In(e)),m=Ms(v),g=In(m-p);(f<1e-24||g>10)&&(f=0,(n==0||e==0)&&(f=1e-24,d==2&&c!=Vt&&(r=0),h==2&&u!=-Vt&&(o=0)));let _=f||v||1e3,M=Ms(_),b=co(10,gi(M)),C=_*(f==0?n==0?.1:1:r),R=Ht(l0(n-C,b/10),24),y=n>=c&&(d==1||d==3&&R<=c||d==2&&R>=c)?c:Vt,E=ni(a,R<y&&n>=y?y:Gi(y,R)),U=_*(f==0?e==0?.1:1:o),N=Ht(ql(e+U,b/10),24),L=e<=u&&(h==1||h==3&&N>=u||h==2&&N<=u)?u:-Vt,O=Gi(l,N>L&&e<=L?L:ni(L,N));return E==O&&E==0&&(O=100),[E,O]}var _S=new Intl.NumberFormat(po?fS.language:"en-US"),Hd=n=>_S.format(n),xi=Math,Vl=xi.PI,In=xi.abs,gi=xi.floor,Pn=xi.round,Ci=xi.ceil,Gi=xi.min,ni=xi.max,co=xi.pow,Pg=xi.sign,Ms=xi.log10,s0=xi.log2,yS=(n,e=1)=>xi.sinh(n)*e,Md=(n,e=1)=>xi.asinh(n/e),Vt=1/0;function Ig(n){return(Ms((n^n>>31)-(n>>31))|0)+1}function Id(n,e,t){return Gi(ni(n,e),t)}function r0(n){return typeof n=="function"}function mt(n){return r0(n)?n:()=>n}var bS=()=>{},o0=n=>n,a0=(n,e)=>e,SS=n=>null,Lg=n=>!0,Ng=(n,e)=>n==e,MS=/\.\d*?(?=9{6,}|0{6,})/gm,Ar=n=>{if(u0(n)||Ks.has(n))return n;let e=`${n}`,t=e.match(MS);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Ar(s)}e${r}`}return Ht(n,i)};function Mr(n,e){return Ar(Ht(Ar(n/e))*e)}function ql(n,e){return Ar(Ci(Ar(n/e))*e)}function l0(n,e){return Ar(gi(Ar(n/e))*e)}function Ht(n,e=0){if(u0(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Pn(i)/t}var Ks=new Map;function c0(n){return((""+n).split(".")[1]||"").length}function Ma(n,e,t,i){let s=[],r=i.map(c0);for(let o=e;o<t;o++){let a=In(o),l=Ht(co(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Ht(u,d);s.push(h),Ks.set(h,d)}}return s}var Sa={},Gd=[],uo=[null,null],Zs=Array.isArray,u0=Number.isInteger,wS=n=>n===void 0;function Dg(n){return typeof n=="string"}function Yl(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function ES(n){return n!=null&&typeof n=="object"}var TS=Object.getPrototypeOf(Uint8Array),h0="__proto__";function ho(n,e=Yl){let t;if(Zs(n)){let i=n.find(s=>s!=null);if(Zs(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=ho(n[s],e)}else t=n.slice()}else if(n instanceof TS)t=n.slice();else if(e(n)){t={};for(let i in n)i!=h0&&(t[i]=ho(n[i],e))}else t=n;return t}function Sn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=h0&&(Yl(n[s])?Sn(n[s],ho(i[s])):n[s]=ho(i[s]))}return n}var AS=0,RS=1,CS=2;function PS(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function IS(n,e){if(DS(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return FS(o[0])||(o=NS(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],d=Array(s).fill(void 0),h=e?e[o][c]:RS,f=[];for(let p=0;p<u.length;p++){let v=u[p],m=r.get(l[p]);v===null?h!=AS&&(d[m]=v,h==CS&&f.push(m)):d[m]=v}PS(d,f,s),i.push(d)}}return i}var LS=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function NS(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function DS(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function FS(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=ni(1,gi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var d0=["January","February","March","April","May","June","July","August","September","October","November","December"],f0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function p0(n){return n.slice(0,3)}var US=f0.map(p0),OS=d0.map(p0),kS={MMMM:d0,MMM:OS,WWWW:f0,WWW:US};function xa(n){return(n<10?"0":"")+n}function BS(n){return(n<10?"00":n<100?"0":"")+n}var zS={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>xa(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>xa(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>xa(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>xa(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>xa(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>BS(n.getMilliseconds())};function Wd(n,e){e=e||kS;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?zS[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var VS=new Intl.DateTimeFormat().resolvedOptions().timeZone;function HS(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==VS?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var m0=n=>n%1==0,Wl=[1,2,2.5,5],GS=Ma(10,-32,0,Wl),g0=Ma(10,0,32,Wl),WS=g0.filter(m0),wr=GS.concat(g0),Xd=`
`,x0="{YYYY}",Fg=Xd+x0,v0="{M}/{D}",ya=Xd+v0,Bl=ya+"/{YY}",_0="{aa}",XS="{h}:{mm}",ao=XS+_0,Ug=Xd+ao,Og=":{ss}",Ct=null;function y0(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ma(10,0,3,Wl).filter(m0):Ma(10,-3,0,Wl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,x0,Ct,Ct,Ct,Ct,Ct,Ct,1],[s*28,"{MMM}",Fg,Ct,Ct,Ct,Ct,Ct,1],[s,v0,Fg,Ct,Ct,Ct,Ct,Ct,1],[i,"{h}"+_0,Bl,Ct,ya,Ct,Ct,Ct,1],[t,ao,Bl,Ct,ya,Ct,Ct,Ct,1],[e,Og,Bl+" "+ao,Ct,ya+" "+ao,Ct,Ug,Ct,1],[n,Og+".{fff}",Bl+" "+ao,Ct,ya+" "+ao,Ct,Ug,Ct,1]];function u(d){return(h,f,p,v,m,g)=>{let _=[],M=m>=o,b=m>=r&&m<o,C=d(p),R=Ht(C*n,3),y=wd(C.getFullYear(),M?0:C.getMonth(),b||M?1:C.getDate()),E=Ht(y*n,3);if(b||M){let U=b?m/r:0,N=M?m/o:0,L=R==E?R:Ht(wd(y.getFullYear()+N,y.getMonth()+U,1)*n,3),O=new Date(Pn(L/n)),z=O.getFullYear(),D=O.getMonth();for(let W=0;L<=v;W++){let q=wd(z+N*W,D+U*W,1),H=q-d(Ht(q*n,3));L=Ht((+q+H)*n,3),L<=v&&_.push(L)}}else{let U=m>=s?s:m,N=gi(p)-gi(R),L=E+N+ql(R-E,U);_.push(L);let O=d(L),z=O.getHours()+O.getMinutes()/t+O.getSeconds()/i,D=m/i,W=h.axes[f]._space,q=g/W;for(;L=Ht(L+m,n==1?0:3),!(L>v);)if(D>1){let H=gi(Ht(z+D,6))%24,Q=d(L).getHours()-H;Q>1&&(Q=-1),L-=Q*i,z=(z+D)%24;let ie=_[_.length-1];Ht((L-ie)/m,3)*q>=.7&&_.push(L)}else _.push(L)}return _}}return[l,c,u]}var[$S,qS,YS]=y0(1),[JS,ZS,KS]=y0(.001);Ma(2,-53,53,[1]);function kg(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Bg(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,d,h,f;return i.map(p=>{let v=n(p),m=v.getFullYear(),g=v.getMonth(),_=v.getDate(),M=v.getHours(),b=v.getMinutes(),C=v.getSeconds(),R=m!=l&&a[2]||g!=c&&a[3]||_!=u&&a[4]||M!=d&&a[5]||b!=h&&a[6]||C!=f&&a[7]||a[1];return l=m,c=g,u=_,d=M,h=b,f=C,R(v)})}}function jS(n,e){let t=Wd(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function wd(n,e,t){return new Date(n,e,t)}function zg(n,e){return e(n)}var QS="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Vg(n,e){return(t,i,s,r)=>r==null?kd:e(n(i))}function eM(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function tM(n,e){return n.series[e].fill(n,e)}var nM={show:!0,live:!0,isolate:!1,mount:bS,markers:{show:!0,width:2,stroke:eM,fill:tM,dash:"solid"},idx:null,idxs:null,values:[]};function iM(n,e){let t=n.cursor.points,i=Ri(),s=t.size(n,e);Jt(i,va,s),Jt(i,_a,s);let r=s/-2;Jt(i,"marginLeft",r),Jt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Jt(i,"borderWidth",o),i}function sM(n,e){let t=n.series[e].points;return t._fill||t._stroke}function rM(n,e){let t=n.series[e].points;return t._stroke||t._fill}function oM(n,e){return n.series[e].points.size}var Ed=[0,0];function aM(n,e,t){return Ed[0]=e,Ed[1]=t,Ed}function zl(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Td(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var lM={show:!0,x:!0,y:!0,lock:!1,move:aM,points:{one:!1,show:iM,size:oM,width:0,stroke:rM,fill:sM},bind:{mousedown:zl,mouseup:zl,click:zl,dblclick:zl,mousemove:Td,mouseleave:Td,mouseenter:Td},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},b0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},$d=Sn({},b0,{filter:a0}),S0=Sn({},$d,{size:10}),M0=Sn({},b0,{show:!1}),qd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',w0="bold "+qd,E0=1.5,Hg={show:!0,scale:"x",stroke:Od,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:w0,side:2,grid:$d,ticks:S0,border:M0,font:qd,lineGap:E0,rotate:0},cM="Value",uM="Time",Gg={show:!0,scale:"x",auto:!1,sorted:1,min:Vt,max:-Vt,idxs:[]};function hM(n,e,t,i,s){return e.map(r=>r==null?"":Hd(r))}function dM(n,e,t,i,s,r,o){let a=[],l=Ks.get(s)||0;t=o?t:Ht(ql(t,s),l);for(let c=t;c<=i;c=Ht(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Ld(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Ms:s0,u=gi(c(t));s=co(l,u),l==10&&(s=wr[Hi(s,wr)]);let d=t,h=s*l;l==10&&(h=wr[Hi(h,wr)]);do a.push(d),d=d+s,l==10&&!Ks.has(d)&&(d=Ht(d,Ks.get(s))),d>=h&&(s=d,h=s*l,l==10&&(h=wr[Hi(h,wr)]));while(d<=i);return a}function fM(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Ld(n,e,ni(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Ld(n,e,ni(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var T0=/./,pM=/[12357]/,mM=/[125]/,Wg=/1/,Nd=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function gM(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),d=l(9,o)-u>=c?T0:l(7,o)-u>=c?pM:l(5,o)-u>=c?mM:Wg;if(d==Wg){let h=In(l(1,o)-u);if(h<c)return Nd(e.slice().reverse(),a.distr,d,Ci(c/h)).reverse()}return Nd(e,a.distr,d,1)}function xM(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=In(l(1,o)-l(2,o));return c<a?Nd(e.slice().reverse(),3,T0,Ci(a/c)).reverse():e}function vM(n,e,t,i){return i==null?kd:e==null?"":Hd(e)}var Xg={show:!0,scale:"y",stroke:Od,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:w0,side:3,grid:$d,ticks:S0,border:M0,font:qd,lineGap:E0,rotate:0};function _M(n,e){let t=3+(n||1)*2;return Ht(t*e,3)}function yM(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=In(o-r),l=n.series[e],c=a/(l.points.space*Rt);return i[1]-i[0]<=c}var $g={scale:null,auto:!0,sorted:0,min:Vt,max:-Vt},A0=(n,e,t,i,s)=>s,qg={show:!0,auto:!0,sorted:0,gaps:A0,alpha:1,facets:[Sn({},$g,{scale:"x"}),Sn({},$g,{scale:"y"})]},Yg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:A0,alpha:1,points:{show:yM,filter:null},values:null,min:Vt,max:-Vt,idxs:[],path:null,clip:null};function bM(n,e,t,i,s){return t/10}var R0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},SM=Sn({},R0,{time:!1,ori:1}),Jg={};function C0(n,e){let t=Jg[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Jg[n]=t)),t}var fo=1,Dd=2;function Rr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,f=a.top,p=a.width,v=a.height,m=n.valToPosH,g=n.valToPosV;return u.ori==0?t(s,l,c,u,d,m,g,h,f,p,v,Zl,mo,jl,I0,N0):t(s,l,c,u,d,g,m,f,h,v,p,Kl,go,Zd,L0,D0)}function Yd(n,e){let t=0,i=0,s=wt(n.bands,Gd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function MM(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ws(n,e,t,i,s,r){return Rr(n,e,(o,a,l,c,u,d,h,f,p,v,m)=>{let g=o.pxRound,_=c.dir*(c.ori==0?1:-1),M=c.ori==0?mo:go,b,C;_==1?(b=t,C=i):(b=i,C=t);let R=g(d(a[b],c,v,f)),y=g(h(l[b],u,m,p)),E=g(d(a[C],c,v,f)),U=g(h(r==1?u.max:u.min,u,m,p)),N=new Path2D(s);return M(N,E,U),M(N,R,U),M(N,R,y),N})}function Jl(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?jl:Zd,l=t;for(let d=0;d<n.length;d++){let h=n[d];if(h[1]>h[0]){let f=h[0]-l;f>0&&a(o,l,i,f,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function wM(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Jd(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let d=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let f=r(n[d]),p=h==d?f:r(n[h]),v=d-s;f=o<=0&&v>=0&&v<l?r(n[v]):f;let g=h+s;p=o>=0&&g>=0&&g<l?r(n[g]):p,p>=f&&a.push([f,p])}return a}function Zg(n){return n==0?o0:n==1?Pn:e=>Mr(e,n)}function P0(n){let e=n==0?Zl:Kl,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Gi(c,a/2,l/2),u=Gi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Zl=(n,e,t)=>{n.moveTo(e,t)},Kl=(n,e,t)=>{n.moveTo(t,e)},mo=(n,e,t)=>{n.lineTo(e,t)},go=(n,e,t)=>{n.lineTo(t,e)},jl=P0(0),Zd=P0(1),I0=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},L0=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},N0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},D0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function F0(n){return(e,t,i,s,r)=>Rr(e,t,(o,a,l,c,u,d,h,f,p,v,m)=>{let{pxRound:g,points:_}=o,M,b;c.ori==0?(M=Zl,b=I0):(M=Kl,b=L0);let C=Ht(_.width*Rt,3),R=(_.size-_.width)/2*Rt,y=Ht(R*2,3),E=new Path2D,U=new Path2D,{left:N,top:L,width:O,height:z}=e.bbox;jl(U,N-y,L-y,O+y*2,z+y*2);let D=W=>{if(l[W]!=null){let q=g(d(a[W],c,v,f)),H=g(h(l[W],u,m,p));M(E,q+R,H),b(E,q,H,R,0,Vl*2)}};if(r)r.forEach(D);else for(let W=i;W<=s;W++)D(W);return{stroke:C>0?E:null,fill:E,clip:U,flags:fo|Dd}})}function U0(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var EM=U0(mo),TM=U0(go);function O0(n){let e=wt(n?.alignGaps,0);return(t,i,s,r)=>Rr(t,i,(o,a,l,c,u,d,h,f,p,v,m)=>{[s,r]=Xl(l,s,r);let g=o.pxRound,_=z=>g(d(z,c,v,f)),M=z=>g(h(z,u,m,p)),b,C;c.ori==0?(b=mo,C=EM):(b=go,C=TM);let R=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:fo},E=y.stroke,U=!1;if(r-s>=v*4){let z=he=>t.posToVal(he,c.key,!0),D=null,W=null,q,H,le,Z=_(a[R==1?s:r]),Q=_(a[s]),ie=_(a[r]),de=z(R==1?Q+1:ie-1);for(let he=R==1?s:r;he>=s&&he<=r;he+=R){let ee=a[he],ge=(R==1?ee<de:ee>de)?Z:_(ee),Me=l[he];ge==Z?Me!=null?(H=Me,D==null?(b(E,ge,M(H)),q=D=W=H):H<D?D=H:H>W&&(W=H)):Me===null&&(U=!0):(D!=null&&C(E,Z,M(D),M(W),M(q),M(H)),Me!=null?(H=Me,b(E,ge,M(H)),D=W=q=H):(D=W=null,Me===null&&(U=!0)),Z=ge,de=z(Z+R))}D!=null&&D!=W&&le!=Z&&C(E,Z,M(D),M(W),M(q),M(H))}else for(let z=R==1?s:r;z>=s&&z<=r;z+=R){let D=l[z];D===null?U=!0:D!=null&&b(E,_(a[z]),M(D))}let[L,O]=Yd(t,i);if(o.fill!=null||L!=0){let z=y.fill=new Path2D(E),D=o.fillTo(t,i,o.min,o.max,L),W=M(D),q=_(a[s]),H=_(a[r]);R==-1&&([H,q]=[q,H]),b(z,H,W),b(z,q,W)}if(!o.spanGaps){let z=[];U&&z.push(...Jd(a,l,s,r,R,_,e)),y.gaps=z=o.gaps(t,i,s,r,z),y.clip=Jl(z,c.ori,f,p,v,m)}return O!=0&&(y.band=O==2?[ws(t,i,s,r,E,-1),ws(t,i,s,r,E,1)]:ws(t,i,s,r,E,O)),y})}function AM(n){let e=wt(n.align,1),t=wt(n.ascDesc,!1),i=wt(n.alignGaps,0),s=wt(n.extend,!1);return(r,o,a,l)=>Rr(r,o,(c,u,d,h,f,p,v,m,g,_,M)=>{[a,l]=Xl(d,a,l);let b=c.pxRound,{left:C,width:R}=r.bbox,y=Q=>b(p(Q,h,_,m)),E=Q=>b(v(Q,f,M,g)),U=h.ori==0?mo:go,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:fo},L=N.stroke,O=h.dir*(h.ori==0?1:-1),z=E(d[O==1?a:l]),D=y(u[O==1?a:l]),W=D,q=D;s&&e==-1&&(q=C,U(L,q,z)),U(L,D,z);for(let Q=O==1?a:l;Q>=a&&Q<=l;Q+=O){let ie=d[Q];if(ie==null)continue;let de=y(u[Q]),he=E(ie);e==1?U(L,de,z):U(L,W,he),U(L,de,he),z=he,W=de}let H=W;s&&e==1&&(H=C+R,U(L,H,z));let[le,Z]=Yd(r,o);if(c.fill!=null||le!=0){let Q=N.fill=new Path2D(L),ie=c.fillTo(r,o,c.min,c.max,le),de=E(ie);U(Q,H,de),U(Q,q,de)}if(!c.spanGaps){let Q=[];Q.push(...Jd(u,d,a,l,O,y,i));let ie=c.width*Rt/2,de=t||e==1?ie:-ie,he=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=de,ee[1]+=he}),N.gaps=Q=c.gaps(r,o,a,l,Q),N.clip=Jl(Q,h.ori,m,g,_,M)}return Z!=0&&(N.band=Z==2?[ws(r,o,a,l,L,-1),ws(r,o,a,l,L,1)]:ws(r,o,a,l,L,Z)),N})}function Kg(n,e,t,i,s,r,o=Vt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=In(n[l]-n[a]);u<c&&(c=u,o=In(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function RM(n){n=n||Sa;let e=wt(n.size,[.6,Vt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=mt(s),o=1-e[0],a=wt(e[1],Vt),l=wt(e[2],1),c=wt(n.disp,Sa),u=wt(n.each,f=>{}),{fill:d,stroke:h}=c;return(f,p,v,m)=>Rr(f,p,(g,_,M,b,C,R,y,E,U,N,L)=>{let O=g.pxRound,z=t,D=i*Rt,W=a*Rt,q=l*Rt,H,le;b.ori==0?[H,le]=r(f,p):[le,H]=r(f,p);let Z=b.dir*(b.ori==0?1:-1),Q=b.ori==0?jl:Zd,ie=b.ori==0?u:(Ce,qe,rt,we,zt,He,Xe)=>{u(Ce,qe,rt,zt,we,Xe,He)},de=wt(f.bands,Gd).find(Ce=>Ce.series[0]==p),he=de!=null?de.dir:0,ee=g.fillTo(f,p,g.min,g.max,he),me=O(y(ee,C,L,U)),ge,Me,ve,Ve=N,$e=O(g.width*Rt),Fe=!1,Ze=null,Je=null,je=null,Bt=null;d!=null&&($e==0||h!=null)&&(Fe=!0,Ze=d.values(f,p,v,m),Je=new Map,new Set(Ze).forEach(Ce=>{Ce!=null&&Je.set(Ce,new Path2D)}),$e>0&&(je=h.values(f,p,v,m),Bt=new Map,new Set(je).forEach(Ce=>{Ce!=null&&Bt.set(Ce,new Path2D)})));let{x0:It,size:mn}=c;if(It!=null&&mn!=null){z=1,_=It.values(f,p,v,m),It.unit==2&&(_=_.map(rt=>f.posToVal(E+rt*N,b.key,!0)));let Ce=mn.values(f,p,v,m);mn.unit==2?Me=Ce[0]*N:Me=R(Ce[0],b,N,E)-R(0,b,N,E),Ve=Kg(_,M,R,b,N,E,Ve),ve=Ve-Me+D}else Ve=Kg(_,M,R,b,N,E,Ve),ve=Ve*o+D,Me=Ve-ve;ve<1&&(ve=0),$e>=Me/2&&($e=0),ve<5&&(O=o0);let Ot=ve>0,Dn=Ve-ve-(Ot?$e:0);Me=O(Id(Dn,q,W)),ge=(z==0?Me/2:z==Z?0:Me)-z*Z*((z==0?D/2:0)+(Ot?$e/2:0));let _t={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Rn=Fe?null:new Path2D,on=null;if(de!=null)on=f.data[de.series[1]];else{let{y0:Ce,y1:qe}=c;Ce!=null&&qe!=null&&(M=qe.values(f,p,v,m),on=Ce.values(f,p,v,m))}let gn=H*Me,B=le*Me;for(let Ce=Z==1?v:m;Ce>=v&&Ce<=m;Ce+=Z){let qe=M[Ce];if(qe==null)continue;if(on!=null){let $=on[Ce]??0;if(qe-$==0)continue;me=y($,C,L,U)}let rt=b.distr!=2||c!=null?_[Ce]:Ce,we=R(rt,b,N,E),zt=y(wt(qe,ee),C,L,U),He=O(we-ge),Xe=O(ni(zt,me)),P=O(Gi(zt,me)),w=Xe-P;if(qe!=null){let $=qe<0?B:gn,ue=qe<0?gn:B;Fe?($e>0&&je[Ce]!=null&&Q(Bt.get(je[Ce]),He,P+gi($e/2),Me,ni(0,w-$e),$,ue),Ze[Ce]!=null&&Q(Je.get(Ze[Ce]),He,P+gi($e/2),Me,ni(0,w-$e),$,ue)):Q(Rn,He,P+gi($e/2),Me,ni(0,w-$e),$,ue),ie(f,p,Ce,He-$e/2,P,Me+$e,w)}}return $e>0?_t.stroke=Fe?Bt:Rn:Fe||(_t._fill=g.width==0?g._fill:g._stroke??g._fill,_t.width=0),_t.fill=Fe?Je:Rn,_t})}function CM(n,e){let t=wt(e?.alignGaps,0);return(i,s,r,o)=>Rr(i,s,(a,l,c,u,d,h,f,p,v,m,g)=>{[r,o]=Xl(c,r,o);let _=a.pxRound,M=H=>_(h(H,u,m,p)),b=H=>_(f(H,d,g,v)),C,R,y;u.ori==0?(C=Zl,y=mo,R=N0):(C=Kl,y=go,R=D0);let E=u.dir*(u.ori==0?1:-1),U=M(l[E==1?r:o]),N=U,L=[],O=[];for(let H=E==1?r:o;H>=r&&H<=o;H+=E)if(c[H]!=null){let Z=l[H],Q=M(Z);L.push(N=Q),O.push(b(c[H]))}let z={stroke:n(L,O,C,y,R,_),fill:null,clip:null,band:null,gaps:null,flags:fo},D=z.stroke,[W,q]=Yd(i,s);if(a.fill!=null||W!=0){let H=z.fill=new Path2D(D),le=a.fillTo(i,s,a.min,a.max,W),Z=b(le);y(H,N,Z),y(H,U,Z)}if(!a.spanGaps){let H=[];H.push(...Jd(l,c,r,o,E,M,t)),z.gaps=H=a.gaps(i,s,r,o,H),z.clip=Jl(H,u.ori,p,v,m,g)}return q!=0&&(z.band=q==2?[ws(i,s,r,o,D,-1),ws(i,s,r,o,D,1)]:ws(i,s,r,o,D,q)),z})}function PM(n){return CM(IM,n)}function IM(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),d=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],d[h]=n[h+1]-n[h],c[h]=u[h]/d[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(d[h-1]+d[h])/((2*d[h]+d[h-1])/c[h-1]+(d[h]+2*d[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+d[h]/3,e[h]+l[h]*d[h]/3,n[h+1]-d[h]/3,e[h+1]-l[h+1]*d[h]/3,n[h+1],e[h+1])}return a}var Fd=new Set;function jg(){for(let n of Fd)n.syncRect(!0)}po&&(Tr(hS,lo,jg),Tr(dS,lo,jg,!0),Tr(Hl,lo,()=>{Mn.pxRatio=Rt}));var LM=O0(),NM=F0();function Qg(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Ud(r,o,e,t))}function DM(n,e){return n.map((t,i)=>i==0?{}:Sn({},e,t))}function Ud(n,e,t,i){return Sn({},e==0?t:i,n)}function k0(n,e,t){return e==null?uo:[e,t]}var FM=k0;function UM(n,e,t){return e==null?uo:Gl(e,t,Vd,!0)}function B0(n,e,t,i){return e==null?uo:$l(e,t,n.scales[i].log,!1)}var OM=B0;function z0(n,e,t,i){return e==null?uo:zd(e,t,n.scales[i].log,!1)}var kM=z0;function BM(n,e,t,i,s){let r=ni(Ig(n),Ig(e)),o=e-n,a=Hi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Ks.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function e0(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Pn((t=+s)*Rt))+"px"),[n,e,t]}function zM(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Ht(e[2]*Rt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Mn(n,e,t){let i={mode:wt(n.mode,1)},s=i.mode;function r(S,T,I,F){let X=T.valToPct(S);return F+I*(T.dir==-1?1-X:X)}function o(S,T,I,F){let X=T.valToPct(S);return F+I*(T.dir==-1?X:1-X)}function a(S,T,I,F){return T.ori==0?r(S,T,I,F):o(S,T,I,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ri(qb);if(n.id!=null&&(c.id=n.id),mi(c,n.class),n.title){let S=Ri(Zb,c);S.textContent=n.title}let u=Vi("canvas"),d=i.ctx=u.getContext("2d"),h=Ri(Kb,c);Tr("click",h,S=>{S.target===p&&($t!=jr||Qt!=Qr)&&Gn.click(i,S)},!0);let f=i.under=Ri(jb,h);h.appendChild(u);let p=i.over=Ri(Qb,h);n=ho(n);let v=+wt(n.pxAlign,1),m=Zg(v);(n.plugins||[]).forEach(S=>{S.opts&&(n=S.opts(i,n)||n)});let g=n.ms||.001,_=i.series=s==1?Qg(n.series||[],Gg,Yg,!1):DM(n.series||[null],qg),M=i.axes=Qg(n.axes||[],Hg,Xg,!0),b=i.scales={},C=i.bands=n.bands||[];C.forEach(S=>{S.fill=mt(S.fill||null),S.dir=wt(S.dir,-1)});let R=s==2?_[1].facets[0].scale:_[0].scale,y={axes:_s,series:dt},E=(n.drawOrder||["axes","series"]).map(S=>y[S]);function U(S){let T=S.distr==3?I=>Ms(I>0?I:S.clamp(i,I,S.min,S.max,S.key)):S.distr==4?I=>Md(I,S.asinh):S.distr==100?I=>S.fwd(I):I=>I;return I=>{let F=T(I),{_min:X,_max:K}=S,ae=K-X;return(F-X)/ae}}function N(S){let T=b[S];if(T==null){let I=(n.scales||Sa)[S]||Sa;if(I.from!=null){N(I.from);let F=Sn({},b[I.from],I,{key:S});F.valToPct=U(F),b[S]=F}else{T=b[S]=Sn({},S==R?R0:SM,I),T.key=S;let F=T.time,X=T.range,K=Zs(X);if((S!=R||s==2&&!F)&&(K&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Rg:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Rg:{mode:1,hard:X[1],soft:X[1]}},K=!1),!K&&Yl(X))){let ae=X;X=(fe,be,Ne)=>be==null?uo:Gl(be,Ne,ae)}T.range=mt(X||(F?FM:S==R?T.distr==3?OM:T.distr==4?kM:k0:T.distr==3?B0:T.distr==4?z0:UM)),T.auto=mt(K?!1:T.auto),T.clamp=mt(T.clamp||bM),T._min=T._max=null,T.valToPct=U(T)}}}N("x"),N("y"),s==1&&_.forEach(S=>{N(S.scale)}),M.forEach(S=>{N(S.scale)});for(let S in n.scales)N(S);let L=b[R],O=L.distr,z,D;L.ori==0?(mi(c,Yb),z=r,D=o):(mi(c,Jb),z=o,D=r);let W={};for(let S in b){let T=b[S];(T.min!=null||T.max!=null)&&(W[S]={min:T.min,max:T.max},T.min=T.max=null)}let q=n.tzDate||(S=>new Date(Pn(S/g))),H=n.fmtDate||Wd,le=g==1?YS(q):KS(q),Z=Bg(q,kg(g==1?qS:ZS,H)),Q=Vg(q,zg(QS,H)),ie=[],de=i.legend=Sn({},nM,n.legend),he=i.cursor=Sn({},lM,{drag:{y:s==2}},n.cursor),ee=de.show,me=he.show,ge=de.markers;de.idxs=ie,ge.width=mt(ge.width),ge.dash=mt(ge.dash),ge.stroke=mt(ge.stroke),ge.fill=mt(ge.fill);let Me,ve,Ve,$e=[],Fe=[],Ze,Je=!1,je={};if(de.live){let S=_[1]?_[1].values:null;Je=S!=null,Ze=Je?S(i,1,0):{_:0};for(let T in Ze)je[T]=kd}if(ee)if(Me=Vi("table",rS,c),Ve=Vi("tbody",null,Me),de.mount(i,Me),Je){ve=Vi("thead",null,Me,Ve);let S=Vi("tr",null,ve);Vi("th",null,S);for(var Bt in Ze)Vi("th",mg,S).textContent=Bt}else mi(Me,aS),de.live&&mi(Me,oS);let It={show:!0},mn={show:!1};function Ot(S,T){if(T==0&&(Je||!de.live||s==2))return uo;let I=[],F=Vi("tr",lS,Ve,Ve.childNodes[T]);mi(F,S.class),S.show||mi(F,Er);let X=Vi("th",null,F);if(ge.show){let fe=Ri(cS,X);if(T>0){let be=ge.width(i,T);be&&(fe.style.border=be+"px "+ge.dash(i,T)+" "+ge.stroke(i,T)),fe.style.background=ge.fill(i,T)}}let K=Ri(mg,X);S.label instanceof HTMLElement?K.appendChild(S.label):K.textContent=S.label,T>0&&(ge.show||(K.style.color=S.width>0?ge.stroke(i,T):ge.fill(i,T)),_t("click",X,fe=>{if(he._lock)return;Qe(fe);let be=_.indexOf(S);if((fe.ctrlKey||fe.metaKey)!=de.isolate){let Ne=_.some((De,Oe)=>Oe>0&&Oe!=be&&De.show);_.forEach((De,Oe)=>{Oe>0&&ns(Oe,Ne?Oe==be?It:mn:It,!0,yn.setSeries)})}else ns(be,{show:!S.show},!0,yn.setSeries)},!1),et&&_t(_g,X,fe=>{he._lock||(Qe(fe),ns(_.indexOf(S),to,!0,yn.setSeries))},!1));for(var ae in Ze){let fe=Vi("td",uS,F);fe.textContent="--",I.push(fe)}return[F,I]}let Dn=new Map;function _t(S,T,I,F=!0){let X=Dn.get(T)||{},K=he.bind[S](i,T,I,F);K&&(Tr(S,T,X[S]=K),Dn.set(T,X))}function Rn(S,T,I){let F=Dn.get(T)||{};for(let X in F)(S==null||X==S)&&(Pd(X,T,F[X]),delete F[X]);S==null&&Dn.delete(T)}let on=0,gn=0,B=0,Ce=0,qe=0,rt=0,we=qe,zt=rt,He=B,Xe=Ce,P=0,w=0,$=0,ue=0;i.bbox={};let oe=!1,_e=!1,ye=!1,te=!1,se=!1,pe=!1;function k(S,T,I){(I||S!=i.width||T!=i.height)&&re(S,T),ct(!1),ye=!0,_e=!0,$n()}function re(S,T){i.width=on=B=S,i.height=gn=Ce=T,qe=rt=0,Se(),Ge();let I=i.bbox;P=I.left=Mr(qe*Rt,.5),w=I.top=Mr(rt*Rt,.5),$=I.width=Mr(B*Rt,.5),ue=I.height=Mr(Ce*Rt,.5)}let ne=3;function Ee(){let S=!1,T=0;for(;!S;){T++;let I=Jr(T),F=ts(T);S=T==ne||I&&F,S||(re(i.width,i.height),_e=!0)}}function xe({width:S,height:T}){k(S,T)}i.setSize=xe;function Se(){let S=!1,T=!1,I=!1,F=!1;M.forEach((X,K)=>{if(X.show&&X._show){let{side:ae,_size:fe}=X,be=ae%2,Ne=X.label!=null?X.labelSize:0,De=fe+Ne;De>0&&(be?(B-=De,ae==3?(qe+=De,F=!0):I=!0):(Ce-=De,ae==0?(rt+=De,S=!0):T=!0))}}),Qi[0]=S,Qi[1]=I,Qi[2]=T,Qi[3]=F,B-=ki[1]+ki[3],qe+=ki[3],Ce-=ki[2]+ki[0],rt+=ki[0]}function Ge(){let S=qe+B,T=rt+Ce,I=qe,F=rt;function X(K,ae){switch(K){case 1:return S+=ae,S-ae;case 2:return T+=ae,T-ae;case 3:return I-=ae,I+ae;case 0:return F-=ae,F+ae}}M.forEach((K,ae)=>{if(K.show&&K._show){let fe=K.side;K._pos=X(fe,K._size),K.label!=null&&(K._lpos=X(fe,K.labelSize))}})}if(he.dataIdx==null){let S=he.hover,T=S.skip=new Set(S.skip??[]);T.add(void 0);let I=S.prox=mt(S.prox),F=S.bias??=0;he.dataIdx=(X,K,ae,fe)=>{if(K==0)return ae;let be=ae,Ne=I(X,K,ae,fe)??Vt,De=Ne>=0&&Ne<Vt,Oe=L.ori==0?B:Ce,st=he.left,Et=e[0],Mt=e[K];if(T.has(Mt[ae])){be=null;let ft=null,Ke=null,We;if(F==0||F==-1)for(We=ae;ft==null&&We-- >0;)T.has(Mt[We])||(ft=We);if(F==0||F==1)for(We=ae;Ke==null&&We++<Mt.length;)T.has(Mt[We])||(Ke=We);if(ft!=null||Ke!=null)if(De){let Yt=ft==null?-1/0:z(Et[ft],L,Oe,0),cn=Ke==null?1/0:z(Et[Ke],L,Oe,0),kn=st-Yt,kt=cn-st;kn<=kt?kn<=Ne&&(be=ft):kt<=Ne&&(be=Ke)}else be=Ke==null?ft:ft==null?Ke:ae-ft<=Ke-ae?ft:Ke}else De&&In(st-z(Et[ae],L,Oe,0))>Ne&&(be=null);return be}}let Qe=S=>{he.event=S};he.idxs=ie,he._lock=!1;let ce=he.points;ce.show=mt(ce.show),ce.size=mt(ce.size),ce.stroke=mt(ce.stroke),ce.width=mt(ce.width),ce.fill=mt(ce.fill);let ke=i.focus=Sn({},n.focus||{alpha:.3},he.focus),et=ke.prox>=0,Re=et&&ce.one,ot=[],Xt=[],Zn=[];function ia(S,T){let I=ce.show(i,T);if(I instanceof HTMLElement)return mi(I,sS),mi(I,S.class),ls(I,-10,-10,B,Ce),p.insertBefore(I,ot[T]),I}function $r(S,T){if(s==1||T>0){let I=s==1&&b[S.scale].time,F=S.value;S.value=I?Dg(F)?Vg(q,zg(F,H)):F||Q:F||vM,S.label=S.label||(I?uM:cM)}if(Re||T>0){S.width=S.width==null?1:S.width,S.paths=S.paths||LM||SS,S.fillTo=mt(S.fillTo||MM),S.pxAlign=+wt(S.pxAlign,v),S.pxRound=Zg(S.pxAlign),S.stroke=mt(S.stroke||null),S.fill=mt(S.fill||null),S._stroke=S._fill=S._paths=S._focus=null;let I=_M(ni(1,S.width),1),F=S.points=Sn({},{size:I,width:ni(1,I*.2),stroke:S.stroke,space:I*2,paths:NM,_stroke:null,_fill:null},S.points);F.show=mt(F.show),F.filter=mt(F.filter),F.fill=mt(F.fill),F.stroke=mt(F.stroke),F.paths=mt(F.paths),F.pxAlign=S.pxAlign}if(ee){let I=Ot(S,T);$e.splice(T,0,I[0]),Fe.splice(T,0,I[1]),de.values.push(null)}if(me){ie.splice(T,0,null);let I=null;Re?T==0&&(I=ia(S,T)):T>0&&(I=ia(S,T)),ot.splice(T,0,I),Xt.splice(T,0,0),Zn.splice(T,0,0)}On("addSeries",T)}function Wh(S,T){T=T??_.length,S=s==1?Ud(S,T,Gg,Yg):Ud(S,T,{},qg),_.splice(T,0,S),$r(_[T],T)}i.addSeries=Wh;function xl(S){if(_.splice(S,1),ee){de.values.splice(S,1),Fe.splice(S,1);let T=$e.splice(S,1)[0];Rn(null,T.firstChild),T.remove()}me&&(ie.splice(S,1),ot.splice(S,1)[0].remove(),Xt.splice(S,1),Zn.splice(S,1)),On("delSeries",S)}i.delSeries=xl;let Qi=[!1,!1,!1,!1];function gs(S,T){if(S._show=S.show,S.show){let I=S.side%2,F=b[S.scale];F==null&&(S.scale=I?_[1].scale:R,F=b[S.scale]);let X=F.time;S.size=mt(S.size),S.space=mt(S.space),S.rotate=mt(S.rotate),Zs(S.incrs)&&S.incrs.forEach(ae=>{!Ks.has(ae)&&Ks.set(ae,c0(ae))}),S.incrs=mt(S.incrs||(F.distr==2?WS:X?g==1?$S:JS:wr)),S.splits=mt(S.splits||(X&&F.distr==1?le:F.distr==3?Ld:F.distr==4?fM:dM)),S.stroke=mt(S.stroke),S.grid.stroke=mt(S.grid.stroke),S.ticks.stroke=mt(S.ticks.stroke),S.border.stroke=mt(S.border.stroke);let K=S.values;S.values=Zs(K)&&!Zs(K[0])?mt(K):X?Zs(K)?Bg(q,kg(K,H)):Dg(K)?jS(q,K):K||Z:K||hM,S.filter=mt(S.filter||(F.distr>=3&&F.log==10?gM:F.distr==3&&F.log==2?xM:a0)),S.font=e0(S.font),S.labelFont=e0(S.labelFont),S._size=S.size(i,null,T,0),S._space=S._rotate=S._incrs=S._found=S._splits=S._values=null,S._size>0&&(Qi[T]=!0,S._el=Ri(eS,h))}}function xs(S,T,I,F){let[X,K,ae,fe]=I,be=T%2,Ne=0;return be==0&&(fe||K)&&(Ne=T==0&&!X||T==2&&!ae?Pn(Hg.size/3):0),be==1&&(X||ae)&&(Ne=T==1&&!K||T==3&&!fe?Pn(Xg.size/2):0),Ne}let sa=i.padding=(n.padding||[xs,xs,xs,xs]).map(S=>mt(wt(S,xs))),ki=i._padding=sa.map((S,T)=>S(i,T,Qi,0)),an,dn=null,fn=null,es=s==1?_[0].idxs:null,ui=null,Vs=!1;function ra(S,T){if(e=S??[],i.data=i._data=e,s==2){an=0;for(let I=1;I<_.length;I++)an+=e[I][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),ui=e[0],an=ui.length;let I=e;if(O==2){I=e.slice();let F=I[0]=Array(an);for(let X=0;X<an;X++)F[X]=X}i._data=e=I}if(ct(!0),On("setData"),O==2&&(ye=!0),T!==!1){let I=L;I.auto(i,Vs)?oa():Ws(R,I.min,I.max),te=te||he.left>=0,pe=!0,$n()}}i.setData=ra;function oa(){Vs=!0;let S,T;s==1&&(an>0?(dn=es[0]=0,fn=es[1]=an-1,S=e[0][dn],T=e[0][fn],O==2?(S=dn,T=fn):S==T&&(O==3?[S,T]=$l(S,S,L.log,!1):O==4?[S,T]=zd(S,S,L.log,!1):L.time?T=S+Pn(86400/g):[S,T]=Gl(S,T,Vd,!0))):(dn=es[0]=S=null,fn=es[1]=T=null)),Ws(R,S,T)}let qr,Hs,Yr,A,V,j,Y,J,Te,Pe;function Ae(S,T,I,F,X,K){S??=xg,I??=Gd,F??="butt",X??=xg,K??="round",S!=qr&&(d.strokeStyle=qr=S),X!=Hs&&(d.fillStyle=Hs=X),T!=Yr&&(d.lineWidth=Yr=T),K!=V&&(d.lineJoin=V=K),F!=j&&(d.lineCap=j=F),I!=A&&d.setLineDash(A=I)}function Ie(S,T,I,F){T!=Hs&&(d.fillStyle=Hs=T),S!=Y&&(d.font=Y=S),I!=J&&(d.textAlign=J=I),F!=Te&&(d.textBaseline=Te=F)}function ze(S,T,I,F,X=0){if(F.length>0&&S.auto(i,Vs)&&(T==null||T.min==null)){let K=wt(dn,0),ae=wt(fn,F.length-1),fe=I.min==null?gS(F,K,ae,X,S.distr==3):[I.min,I.max];S.min=Gi(S.min,I.min=fe[0]),S.max=ni(S.max,I.max=fe[1])}}let tt={min:null,max:null};function ht(){for(let F in b){let X=b[F];W[F]==null&&(X.min==null||W[R]!=null&&X.auto(i,Vs))&&(W[F]=tt)}for(let F in b){let X=b[F];W[F]==null&&X.from!=null&&W[X.from]!=null&&(W[F]=tt)}W[R]!=null&&ct(!0);let S={};for(let F in W){let X=W[F];if(X!=null){let K=S[F]=ho(b[F],ES);if(X.min!=null)Sn(K,X);else if(F!=R||s==2)if(an==0&&K.from==null){let ae=K.range(i,null,null,F);K.min=ae[0],K.max=ae[1]}else K.min=Vt,K.max=-Vt}}if(an>0){_.forEach((F,X)=>{if(s==1){let K=F.scale,ae=W[K];if(ae==null)return;let fe=S[K];if(X==0){let be=fe.range(i,fe.min,fe.max,K);fe.min=be[0],fe.max=be[1],dn=Hi(fe.min,e[0]),fn=Hi(fe.max,e[0]),fn-dn>1&&(e[0][dn]<fe.min&&dn++,e[0][fn]>fe.max&&fn--),F.min=ui[dn],F.max=ui[fn]}else F.show&&F.auto&&ze(fe,ae,F,e[X],F.sorted);F.idxs[0]=dn,F.idxs[1]=fn}else if(X>0&&F.show&&F.auto){let[K,ae]=F.facets,fe=K.scale,be=ae.scale,[Ne,De]=e[X],Oe=S[fe],st=S[be];Oe!=null&&ze(Oe,W[fe],K,Ne,K.sorted),st!=null&&ze(st,W[be],ae,De,ae.sorted),F.min=ae.min,F.max=ae.max}});for(let F in S){let X=S[F],K=W[F];if(X.from==null&&(K==null||K.min==null)){let ae=X.range(i,X.min==Vt?null:X.min,X.max==-Vt?null:X.max,F);X.min=ae[0],X.max=ae[1]}}}for(let F in S){let X=S[F];if(X.from!=null){let K=S[X.from];if(K.min==null)X.min=X.max=null;else{let ae=X.range(i,K.min,K.max,F);X.min=ae[0],X.max=ae[1]}}}let T={},I=!1;for(let F in S){let X=S[F],K=b[F];if(K.min!=X.min||K.max!=X.max){K.min=X.min,K.max=X.max;let ae=K.distr;K._min=ae==3?Ms(K.min):ae==4?Md(K.min,K.asinh):ae==100?K.fwd(K.min):K.min,K._max=ae==3?Ms(K.max):ae==4?Md(K.max,K.asinh):ae==100?K.fwd(K.max):K.max,T[F]=I=!0}}if(I){_.forEach((F,X)=>{s==2?X>0&&T.y&&(F._paths=null):T[F.scale]&&(F._paths=null)});for(let F in T)ye=!0,On("setScale",F);me&&he.left>=0&&(te=pe=!0)}for(let F in W)W[F]=null}function Be(S){let T=Id(dn-1,0,an-1),I=Id(fn+1,0,an-1);for(;S[T]==null&&T>0;)T--;for(;S[I]==null&&I<an-1;)I++;return[T,I]}function dt(){if(an>0){let S=_.some(T=>T._focus)&&Pe!=ke.alpha;S&&(d.globalAlpha=Pe=ke.alpha),_.forEach((T,I)=>{if(I>0&&T.show&&(sn(I,!1),sn(I,!0),T._paths==null)){let F=Pe;Pe!=T.alpha&&(d.globalAlpha=Pe=T.alpha);let X=s==2?[0,e[I][0].length-1]:Be(e[I]);T._paths=T.paths(i,I,X[0],X[1]),Pe!=F&&(d.globalAlpha=Pe=F)}}),_.forEach((T,I)=>{if(I>0&&T.show){let F=Pe;Pe!=T.alpha&&(d.globalAlpha=Pe=T.alpha),T._paths!=null&&Lt(I,!1);{let X=T._paths!=null?T._paths.gaps:null,K=T.points.show(i,I,dn,fn,X),ae=T.points.filter(i,I,K,X);(K||ae)&&(T.points._paths=T.points.paths(i,I,dn,fn,ae),Lt(I,!0))}Pe!=F&&(d.globalAlpha=Pe=F),On("drawSeries",I)}}),S&&(d.globalAlpha=Pe=1)}}function sn(S,T){let I=T?_[S].points:_[S];I._stroke=I.stroke(i,S),I._fill=I.fill(i,S)}function Lt(S,T){let I=T?_[S].points:_[S],{stroke:F,fill:X,clip:K,flags:ae,_stroke:fe=I._stroke,_fill:be=I._fill,_width:Ne=I.width}=I._paths;Ne=Ht(Ne*Rt,3);let De=null,Oe=Ne%2/2;T&&be==null&&(be=Ne>0?"#fff":fe);let st=I.pxAlign==1&&Oe>0;if(st&&d.translate(Oe,Oe),!T){let Et=P-Ne/2,Mt=w-Ne/2,ft=$+Ne,Ke=ue+Ne;De=new Path2D,De.rect(Et,Mt,ft,Ke)}T?Ue(fe,Ne,I.dash,I.cap,be,F,X,ae,K):Nt(S,fe,Ne,I.dash,I.cap,be,F,X,ae,De,K),st&&d.translate(-Oe,-Oe)}function Nt(S,T,I,F,X,K,ae,fe,be,Ne,De){let Oe=!1;be!=0&&C.forEach((st,Et)=>{if(st.series[0]==S){let Mt=_[st.series[1]],ft=e[st.series[1]],Ke=(Mt._paths||Sa).band;Zs(Ke)&&(Ke=st.dir==1?Ke[0]:Ke[1]);let We,Yt=null;Mt.show&&Ke&&vS(ft,dn,fn)?(Yt=st.fill(i,Et)||K,We=Mt._paths.clip):Ke=null,Ue(T,I,F,X,Yt,ae,fe,be,Ne,De,We,Ke),Oe=!0}}),Oe||Ue(T,I,F,X,K,ae,fe,be,Ne,De)}let Cn=fo|Dd;function Ue(S,T,I,F,X,K,ae,fe,be,Ne,De,Oe){Ae(S,T,I,F,X),(be||Ne||Oe)&&(d.save(),be&&d.clip(be),Ne&&d.clip(Ne)),Oe?(fe&Cn)==Cn?(d.clip(Oe),De&&d.clip(De),pt(X,ae),xn(S,K,T)):fe&Dd?(pt(X,ae),d.clip(Oe),xn(S,K,T)):fe&fo&&(d.save(),d.clip(Oe),De&&d.clip(De),pt(X,ae),d.restore(),xn(S,K,T)):(pt(X,ae),xn(S,K,T)),(be||Ne||Oe)&&d.restore()}function xn(S,T,I){I>0&&(T instanceof Map?T.forEach((F,X)=>{d.strokeStyle=qr=X,d.stroke(F)}):T!=null&&S&&d.stroke(T))}function pt(S,T){T instanceof Map?T.forEach((I,F)=>{d.fillStyle=Hs=F,d.fill(I)}):T!=null&&S&&d.fill(T)}function vs(S,T,I,F){let X=M[S],K;if(F<=0)K=[0,0];else{let ae=X._space=X.space(i,S,T,I,F),fe=X._incrs=X.incrs(i,S,T,I,F,ae);K=BM(T,I,fe,F,ae)}return X._found=K}function vn(S,T,I,F,X,K,ae,fe,be,Ne){let De=ae%2/2;v==1&&d.translate(De,De),Ae(fe,ae,be,Ne,fe),d.beginPath();let Oe,st,Et,Mt,ft=X+(F==0||F==3?-K:K);I==0?(st=X,Mt=ft):(Oe=X,Et=ft);for(let Ke=0;Ke<S.length;Ke++)T[Ke]!=null&&(I==0?Oe=Et=S[Ke]:st=Mt=S[Ke],d.moveTo(Oe,st),d.lineTo(Et,Mt));d.stroke(),v==1&&d.translate(-De,-De)}function Jr(S){let T=!0;return M.forEach((I,F)=>{if(!I.show)return;let X=b[I.scale];if(X.min==null){I._show&&(T=!1,I._show=!1,ct(!1));return}else I._show||(T=!1,I._show=!0,ct(!1));let K=I.side,ae=K%2,{min:fe,max:be}=X,[Ne,De]=vs(F,fe,be,ae==0?B:Ce);if(De==0)return;let Oe=X.distr==2,st=I._splits=I.splits(i,F,fe,be,Ne,De,Oe),Et=X.distr==2?st.map(We=>ui[We]):st,Mt=X.distr==2?ui[st[1]]-ui[st[0]]:Ne,ft=I._values=I.values(i,I.filter(i,Et,F,De,Mt),F,De,Mt);I._rotate=K==2?I.rotate(i,ft,F,De):0;let Ke=I._size;I._size=Ci(I.size(i,ft,F,S)),Ke!=null&&I._size!=Ke&&(T=!1)}),T}function ts(S){let T=!0;return sa.forEach((I,F)=>{let X=I(i,F,Qi,S);X!=ki[F]&&(T=!1),ki[F]=X}),T}function _s(){for(let S=0;S<M.length;S++){let T=M[S];if(!T.show||!T._show)continue;let I=T.side,F=I%2,X,K,ae=T.stroke(i,S),fe=I==0||I==3?-1:1,[be,Ne]=T._found;if(T.label!=null){let Qn=T.labelGap*fe,fi=Pn((T._lpos+Qn)*Rt);Ie(T.labelFont[0],ae,"center",I==2?"top":gg),d.save(),F==1?(X=K=0,d.translate(fi,Pn(w+ue/2)),d.rotate((I==3?-Vl:Vl)/2)):(X=Pn(P+$/2),K=fi);let _r=r0(T.label)?T.label(i,S,be,Ne):T.label;d.fillText(_r,X,K),d.restore()}if(Ne==0)continue;let De=b[T.scale],Oe=F==0?$:ue,st=F==0?P:w,Et=T._splits,Mt=De.distr==2?Et.map(Qn=>ui[Qn]):Et,ft=De.distr==2?ui[Et[1]]-ui[Et[0]]:be,Ke=T.ticks,We=T.border,Yt=Ke.show?Ke.size:0,cn=Pn(Yt*Rt),kn=Pn((T.alignTo==2?T._size-Yt-T.gap:T.gap)*Rt),kt=T._rotate*-Vl/180,un=m(T._pos*Rt),hi=(cn+kn)*fe,jn=un+hi;K=F==0?jn:0,X=F==1?jn:0;let Ti=T.font[0],Bi=T.align==1?oo:T.align==2?yd:kt>0?oo:kt<0?yd:F==0?"center":I==3?yd:oo,ss=kt||F==1?"middle":I==2?"top":gg;Ie(Ti,ae,Bi,ss);let di=T.font[1]*T.lineGap,Ai=Et.map(Qn=>m(a(Qn,De,Oe,st))),zi=T._values;for(let Qn=0;Qn<zi.length;Qn++){let fi=zi[Qn];if(fi!=null){F==0?X=Ai[Qn]:K=Ai[Qn],fi=""+fi;let _r=fi.indexOf(`
`)==-1?[fi]:fi.split(/\n/gm);for(let ei=0;ei<_r.length;ei++){let Cm=_r[ei];kt?(d.save(),d.translate(X,K+ei*di),d.rotate(kt),d.fillText(Cm,0,0),d.restore()):d.fillText(Cm,X,K+ei*di)}}}Ke.show&&vn(Ai,Ke.filter(i,Mt,S,Ne,ft),F,I,un,cn,Ht(Ke.width*Rt,3),Ke.stroke(i,S),Ke.dash,Ke.cap);let rs=T.grid;rs.show&&vn(Ai,rs.filter(i,Mt,S,Ne,ft),F,F==0?2:1,F==0?w:P,F==0?ue:$,Ht(rs.width*Rt,3),rs.stroke(i,S),rs.dash,rs.cap),We.show&&vn([un],[1],F==0?1:0,F==0?1:2,F==1?w:P,F==1?ue:$,Ht(We.width*Rt,3),We.stroke(i,S),We.dash,We.cap)}On("drawAxes")}function ct(S){_.forEach((T,I)=>{I>0&&(T._paths=null,S&&(s==1?(T.min=null,T.max=null):T.facets.forEach(F=>{F.min=null,F.max=null})))})}let ln=!1,Kn=!1,Dt=[];function _n(){Kn=!1;for(let S=0;S<Dt.length;S++)On(...Dt[S]);Dt.length=0}function $n(){ln||(LS(hm),ln=!0)}function vl(S,T=!1){ln=!0,Kn=T,S(i),hm(),T&&Dt.length>0&&queueMicrotask(_n)}i.batch=vl;function hm(){if(oe&&(ht(),oe=!1),ye&&(Ee(),ye=!1),_e){if(Jt(f,oo,qe),Jt(f,"top",rt),Jt(f,va,B),Jt(f,_a,Ce),Jt(p,oo,qe),Jt(p,"top",rt),Jt(p,va,B),Jt(p,_a,Ce),Jt(h,va,on),Jt(h,_a,gn),u.width=Pn(on*Rt),u.height=Pn(gn*Rt),M.forEach(({_el:S,_show:T,_size:I,_pos:F,side:X})=>{if(S!=null)if(T){let K=X===3||X===0?I:0,ae=X%2==1;Jt(S,ae?"left":"top",F-K),Jt(S,ae?"width":"height",I),Jt(S,ae?"top":"left",ae?rt:qe),Jt(S,ae?"height":"width",ae?Ce:B),Cd(S,Er)}else mi(S,Er)}),qr=Hs=Yr=V=j=Y=J=Te=A=null,Pe=1,ca(!0),qe!=we||rt!=zt||B!=He||Ce!=Xe){ct(!1);let S=B/He,T=Ce/Xe;if(me&&!te&&he.left>=0){he.left*=S,he.top*=T,Zr&&ls(Zr,Pn(he.left),0,B,Ce),Kr&&ls(Kr,0,Pn(he.top),B,Ce);for(let I=0;I<ot.length;I++){let F=ot[I];F!=null&&(Xt[I]*=S,Zn[I]*=T,ls(F,Ci(Xt[I]),Ci(Zn[I]),B,Ce))}}if(qt.show&&!se&&qt.left>=0&&qt.width>0){qt.left*=S,qt.width*=S,qt.top*=T,qt.height*=T;for(let I in Zh)Jt(eo,I,qt[I])}we=qe,zt=rt,He=B,Xe=Ce}On("setSize"),_e=!1}on>0&&gn>0&&(d.clearRect(0,0,u.width,u.height),On("drawClear"),E.forEach(S=>S()),On("draw")),qt.show&&se&&(_l(qt),se=!1),me&&te&&(vr(null,!0,!1),te=!1),de.show&&de.live&&pe&&(Yh(),pe=!1),l||(l=!0,i.status=1,On("ready")),Vs=!1,ln=!1}i.redraw=(S,T)=>{ye=T||!1,S!==!1?Ws(R,L.min,L.max):$n()};function Xh(S,T){let I=b[S];if(I.from==null){if(an==0){let F=I.range(i,T.min,T.max,S);T.min=F[0],T.max=F[1]}if(T.min>T.max){let F=T.min;T.min=T.max,T.max=F}if(an>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;S==R&&I.distr==2&&an>0&&(T.min=Hi(T.min,e[0]),T.max=Hi(T.max,e[0]),T.min==T.max&&T.max++),W[S]=T,oe=!0,$n()}}i.setScale=Xh;let $h,qh,Zr,Kr,dm,fm,jr,Qr,pm,mm,$t,Qt,Gs=!1,Gn=he.drag,Fn=Gn.x,Un=Gn.y;me&&(he.x&&($h=Ri(nS,p)),he.y&&(qh=Ri(iS,p)),L.ori==0?(Zr=$h,Kr=qh):(Zr=qh,Kr=$h),$t=he.left,Qt=he.top);let qt=i.select=Sn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),eo=qt.show?Ri(tS,qt.over?p:f):null;function _l(S,T){if(qt.show){for(let I in S)qt[I]=S[I],I in Zh&&Jt(eo,I,S[I]);T!==!1&&On("setSelect")}}i.setSelect=_l;function Yy(S){if(_[S].show)ee&&Cd($e[S],Er);else if(ee&&mi($e[S],Er),me){let I=Re?ot[0]:ot[S];I!=null&&ls(I,-10,-10,B,Ce)}}function Ws(S,T,I){Xh(S,{min:T,max:I})}function ns(S,T,I,F){T.focus!=null&&Qy(S),T.show!=null&&_.forEach((X,K)=>{K>0&&(S==K||S==null)&&(X.show=T.show,Yy(K),s==2?(Ws(X.facets[0].scale,null,null),Ws(X.facets[1].scale,null,null)):Ws(X.scale,null,null),$n())}),I!==!1&&On("setSeries",S,T),F&&ua("setSeries",i,S,T)}i.setSeries=ns;function Jy(S,T){Sn(C[S],T)}function Zy(S,T){S.fill=mt(S.fill||null),S.dir=wt(S.dir,-1),T=T??C.length,C.splice(T,0,S)}function Ky(S){S==null?C.length=0:C.splice(S,1)}i.addBand=Zy,i.setBand=Jy,i.delBand=Ky;function jy(S,T){_[S].alpha=T,me&&ot[S]!=null&&(ot[S].style.opacity=T),ee&&$e[S]&&($e[S].style.opacity=T)}let ys,Xs,xr,to={focus:!0};function Qy(S){if(S!=xr){let T=S==null,I=ke.alpha!=1;_.forEach((F,X)=>{if(s==1||X>0){let K=T||X==0||X==S;F._focus=T?null:K,I&&jy(X,K?1:ke.alpha)}}),xr=S,I&&$n()}}ee&&et&&_t(yg,Me,S=>{he._lock||(Qe(S),xr!=null&&ns(null,to,!0,yn.setSeries))});function is(S,T,I){let F=b[T];I&&(S=S/Rt-(F.ori==1?rt:qe));let X=B;F.ori==1&&(X=Ce,S=X-S),F.dir==-1&&(S=X-S);let K=F._min,ae=F._max,fe=S/X,be=K+(ae-K)*fe,Ne=F.distr;return Ne==3?co(10,be):Ne==4?yS(be,F.asinh):Ne==100?F.bwd(be):be}function eb(S,T){let I=is(S,R,T);return Hi(I,e[0],dn,fn)}i.valToIdx=S=>Hi(S,e[0]),i.posToIdx=eb,i.posToVal=is,i.valToPos=(S,T,I)=>b[T].ori==0?r(S,b[T],I?$:B,I?P:0):o(S,b[T],I?ue:Ce,I?w:0),i.setCursor=(S,T,I)=>{$t=S.left,Qt=S.top,vr(null,T,I)};function gm(S,T){Jt(eo,oo,qt.left=S),Jt(eo,va,qt.width=T)}function xm(S,T){Jt(eo,"top",qt.top=S),Jt(eo,_a,qt.height=T)}let aa=L.ori==0?gm:xm,la=L.ori==1?gm:xm;function tb(){if(ee&&de.live)for(let S=s==2?1:0;S<_.length;S++){if(S==0&&Je)continue;let T=de.values[S],I=0;for(let F in T)Fe[S][I++].firstChild.nodeValue=T[F]}}function Yh(S,T){if(S!=null&&(S.idxs?S.idxs.forEach((I,F)=>{ie[F]=I}):wS(S.idx)||ie.fill(S.idx),de.idx=ie[0]),ee&&de.live){for(let I=0;I<_.length;I++)(I>0||s==1&&!Je)&&nb(I,ie[I]);tb()}pe=!1,T!==!1&&On("setLegend")}i.setLegend=Yh;function nb(S,T){let I=_[S],F=S==0&&O==2?ui:e[S],X;Je?X=I.values(i,S,T)??je:(X=I.value(i,T==null?null:F[T],S,T),X=X==null?je:{_:X}),de.values[S]=X}function vr(S,T,I){pm=$t,mm=Qt,[$t,Qt]=he.move(i,$t,Qt),he.left=$t,he.top=Qt,me&&(Zr&&ls(Zr,Pn($t),0,B,Ce),Kr&&ls(Kr,0,Pn(Qt),B,Ce));let F,X=dn>fn;ys=Vt,Xs=null;let K=L.ori==0?B:Ce,ae=L.ori==1?B:Ce;if($t<0||an==0||X){F=he.idx=null;for(let fe=0;fe<_.length;fe++){let be=ot[fe];be!=null&&ls(be,-10,-10,B,Ce)}et&&ns(null,to,!0,S==null&&yn.setSeries),de.live&&(ie.fill(F),pe=!0)}else{let fe,be,Ne;s==1&&(fe=L.ori==0?$t:Qt,be=is(fe,R),F=he.idx=Hi(be,e[0],dn,fn),Ne=z(e[0][F],L,K,0));let De=-10,Oe=-10,st=0,Et=0,Mt=!0,ft="",Ke="";for(let We=s==2?1:0;We<_.length;We++){let Yt=_[We],cn=ie[We],kn=cn==null?null:s==1?e[We][cn]:e[We][1][cn],kt=he.dataIdx(i,We,F,be),un=kt==null?null:s==1?e[We][kt]:e[We][1][kt];if(pe=pe||un!=kn||kt!=cn,ie[We]=kt,We>0&&Yt.show){let hi=kt==null?-10:kt==F?Ne:z(s==1?e[0][kt]:e[We][0][kt],L,K,0),jn=un==null?-10:D(un,s==1?b[Yt.scale]:b[Yt.facets[1].scale],ae,0);if(et&&un!=null){let Ti=L.ori==1?$t:Qt,Bi=In(ke.dist(i,We,kt,jn,Ti));if(Bi<ys){let ss=ke.bias;if(ss!=0){let di=is(Ti,Yt.scale),Ai=un>=0?1:-1,zi=di>=0?1:-1;zi==Ai&&(zi==1?ss==1?un>=di:un<=di:ss==1?un<=di:un>=di)&&(ys=Bi,Xs=We)}else ys=Bi,Xs=We}}if(pe||Re){let Ti,Bi;L.ori==0?(Ti=hi,Bi=jn):(Ti=jn,Bi=hi);let ss,di,Ai,zi,rs,Qn,fi=!0,_r=ce.bbox;if(_r!=null){fi=!1;let ei=_r(i,We);Ai=ei.left,zi=ei.top,ss=ei.width,di=ei.height}else Ai=Ti,zi=Bi,ss=di=ce.size(i,We);if(Qn=ce.fill(i,We),rs=ce.stroke(i,We),Re)We==Xs&&ys<=ke.prox&&(De=Ai,Oe=zi,st=ss,Et=di,Mt=fi,ft=Qn,Ke=rs);else{let ei=ot[We];ei!=null&&(Xt[We]=Ai,Zn[We]=zi,Ag(ei,ss,di,fi),Eg(ei,Qn,rs),ls(ei,Ci(Ai),Ci(zi),B,Ce))}}}}if(Re){let We=ke.prox,Yt=xr==null?ys<=We:ys>We||Xs!=xr;if(pe||Yt){let cn=ot[0];cn!=null&&(Xt[0]=De,Zn[0]=Oe,Ag(cn,st,Et,Mt),Eg(cn,ft,Ke),ls(cn,Ci(De),Ci(Oe),B,Ce))}}}if(qt.show&&Gs)if(S!=null){let[fe,be]=yn.scales,[Ne,De]=yn.match,[Oe,st]=S.cursor.sync.scales,Et=S.cursor.drag;if(Fn=Et._x,Un=Et._y,Fn||Un){let{left:Mt,top:ft,width:Ke,height:We}=S.select,Yt=S.scales[Oe].ori,cn=S.posToVal,kn,kt,un,hi,jn,Ti=fe!=null&&Ne(fe,Oe),Bi=be!=null&&De(be,st);Ti&&Fn?(Yt==0?(kn=Mt,kt=Ke):(kn=ft,kt=We),un=b[fe],hi=z(cn(kn,Oe),un,K,0),jn=z(cn(kn+kt,Oe),un,K,0),aa(Gi(hi,jn),In(jn-hi))):aa(0,K),Bi&&Un?(Yt==1?(kn=Mt,kt=Ke):(kn=ft,kt=We),un=b[be],hi=D(cn(kn,st),un,ae,0),jn=D(cn(kn+kt,st),un,ae,0),la(Gi(hi,jn),In(jn-hi))):la(0,ae)}else Kh()}else{let fe=In(pm-dm),be=In(mm-fm);if(L.ori==1){let st=fe;fe=be,be=st}Fn=Gn.x&&fe>=Gn.dist,Un=Gn.y&&be>=Gn.dist;let Ne=Gn.uni;Ne!=null?Fn&&Un&&(Fn=fe>=Ne,Un=be>=Ne,!Fn&&!Un&&(be>fe?Un=!0:Fn=!0)):Gn.x&&Gn.y&&(Fn||Un)&&(Fn=Un=!0);let De,Oe;Fn&&(L.ori==0?(De=jr,Oe=$t):(De=Qr,Oe=Qt),aa(Gi(De,Oe),In(Oe-De)),Un||la(0,ae)),Un&&(L.ori==1?(De=jr,Oe=$t):(De=Qr,Oe=Qt),la(Gi(De,Oe),In(Oe-De)),Fn||aa(0,K)),!Fn&&!Un&&(aa(0,0),la(0,0))}if(Gn._x=Fn,Gn._y=Un,S==null){if(I){if(Rm!=null){let[fe,be]=yn.scales;yn.values[0]=fe!=null?is(L.ori==0?$t:Qt,fe):null,yn.values[1]=be!=null?is(L.ori==1?$t:Qt,be):null}ua(bd,i,$t,Qt,B,Ce,F)}if(et){let fe=I&&yn.setSeries,be=ke.prox;xr==null?ys<=be&&ns(Xs,to,!0,fe):ys>be?ns(null,to,!0,fe):Xs!=xr&&ns(Xs,to,!0,fe)}}pe&&(de.idx=F,Yh()),T!==!1&&On("setCursor")}let $s=null;Object.defineProperty(i,"rect",{get(){return $s==null&&ca(!1),$s}});function ca(S=!1){S?$s=null:($s=p.getBoundingClientRect(),On("syncRect",$s))}function vm(S,T,I,F,X,K,ae){he._lock||Gs&&S!=null&&S.movementX==0&&S.movementY==0||(Jh(S,T,I,F,X,K,ae,!1,S!=null),S!=null?vr(null,!0,!0):vr(T,!0,!1))}function Jh(S,T,I,F,X,K,ae,fe,be){if($s==null&&ca(!1),Qe(S),S!=null)I=S.clientX-$s.left,F=S.clientY-$s.top;else{if(I<0||F<0){$t=-10,Qt=-10;return}let[Ne,De]=yn.scales,Oe=T.cursor.sync,[st,Et]=Oe.values,[Mt,ft]=Oe.scales,[Ke,We]=yn.match,Yt=T.axes[0].side%2==1,cn=L.ori==0?B:Ce,kn=L.ori==1?B:Ce,kt=Yt?K:X,un=Yt?X:K,hi=Yt?F:I,jn=Yt?I:F;if(Mt!=null?I=Ke(Ne,Mt)?a(st,b[Ne],cn,0):-10:I=cn*(hi/kt),ft!=null?F=We(De,ft)?a(Et,b[De],kn,0):-10:F=kn*(jn/un),L.ori==1){let Ti=I;I=F,F=Ti}}be&&(T==null||T.cursor.event.type==bd)&&((I<=1||I>=B-1)&&(I=Mr(I,B)),(F<=1||F>=Ce-1)&&(F=Mr(F,Ce))),fe?(dm=I,fm=F,[jr,Qr]=he.move(i,I,F)):($t=I,Qt=F)}let Zh={width:0,height:0,left:0,top:0};function Kh(){_l(Zh,!1)}let _m,ym,bm,Sm;function Mm(S,T,I,F,X,K,ae){Gs=!0,Fn=Un=Gn._x=Gn._y=!1,Jh(S,T,I,F,X,K,ae,!0,!1),S!=null&&(_t(Sd,Ad,wm,!1),ua(vg,i,jr,Qr,B,Ce,null));let{left:fe,top:be,width:Ne,height:De}=qt;_m=fe,ym=be,bm=Ne,Sm=De}function wm(S,T,I,F,X,K,ae){Gs=Gn._x=Gn._y=!1,Jh(S,T,I,F,X,K,ae,!1,!0);let{left:fe,top:be,width:Ne,height:De}=qt,Oe=Ne>0||De>0,st=_m!=fe||ym!=be||bm!=Ne||Sm!=De;if(Oe&&st&&_l(qt),Gn.setScale&&Oe&&st){let Et=fe,Mt=Ne,ft=be,Ke=De;if(L.ori==1&&(Et=be,Mt=De,ft=fe,Ke=Ne),Fn&&Ws(R,is(Et,R),is(Et+Mt,R)),Un)for(let We in b){let Yt=b[We];We!=R&&Yt.from==null&&Yt.min!=Vt&&Ws(We,is(ft+Ke,We),is(ft,We))}Kh()}else he.lock&&(he._lock=!he._lock,vr(T,!0,S!=null));S!=null&&(Rn(Sd,Ad),ua(Sd,i,$t,Qt,B,Ce,null))}function ib(S,T,I,F,X,K,ae){if(he._lock)return;Qe(S);let fe=Gs;if(Gs){let be=!0,Ne=!0,De=10,Oe,st;L.ori==0?(Oe=Fn,st=Un):(Oe=Un,st=Fn),Oe&&st&&(be=$t<=De||$t>=B-De,Ne=Qt<=De||Qt>=Ce-De),Oe&&be&&($t=$t<jr?0:B),st&&Ne&&(Qt=Qt<Qr?0:Ce),vr(null,!0,!0),Gs=!1}$t=-10,Qt=-10,ie.fill(null),vr(null,!0,!0),fe&&(Gs=fe)}function Em(S,T,I,F,X,K,ae){he._lock||(Qe(S),oa(),Kh(),S!=null&&ua(bg,i,$t,Qt,B,Ce,null))}function Tm(){M.forEach(zM),k(i.width,i.height,!0)}Tr(Hl,lo,Tm);let no={};no.mousedown=Mm,no.mousemove=vm,no.mouseup=wm,no.dblclick=Em,no.setSeries=(S,T,I,F)=>{let X=yn.match[2];I=X(i,T,I),I!=-1&&ns(I,F,!0,!1)},me&&(_t(vg,p,Mm),_t(bd,p,vm),_t(_g,p,S=>{Qe(S),ca(!1)}),_t(yg,p,ib),_t(bg,p,Em),Fd.add(i),i.syncRect=ca);let yl=i.hooks=n.hooks||{};function On(S,T,I){Kn?Dt.push([S,T,I]):S in yl&&yl[S].forEach(F=>{F.call(null,i,T,I)})}(n.plugins||[]).forEach(S=>{for(let T in S.hooks)yl[T]=(yl[T]||[]).concat(S.hooks[T])});let Am=(S,T,I)=>I,yn=Sn({key:null,setSeries:!1,filters:{pub:Lg,sub:Lg},scales:[R,_[1]?_[1].scale:null],match:[Ng,Ng,Am],values:[null,null]},he.sync);yn.match.length==2&&yn.match.push(Am),he.sync=yn;let Rm=yn.key,jh=C0(Rm);function ua(S,T,I,F,X,K,ae){yn.filters.pub(S,T,I,F,X,K,ae)&&jh.pub(S,T,I,F,X,K,ae)}jh.sub(i);function sb(S,T,I,F,X,K,ae){yn.filters.sub(S,T,I,F,X,K,ae)&&no[S](null,T,I,F,X,K,ae)}i.pub=sb;function rb(){jh.unsub(i),Fd.delete(i),Dn.clear(),Pd(Hl,lo,Tm),c.remove(),Me?.remove(),On("destroy")}i.destroy=rb;function Qh(){On("init",n,e),ra(e||n.data,!1),W[R]?Xh(R,W[R]):oa(),se=qt.show&&(qt.width>0||qt.height>0),te=pe=!0,k(n.width,n.height)}return _.forEach($r),M.forEach(gs),t?t instanceof HTMLElement?(t.appendChild(c),Qh()):t(i,Qh):Qh(),i}Mn.assign=Sn;Mn.fmtNum=Hd;Mn.rangeNum=Gl;Mn.rangeLog=$l;Mn.rangeAsinh=zd;Mn.orient=Rr;Mn.pxRatio=Rt;Mn.join=IS;Mn.fmtDate=Wd,Mn.tzDate=HS;Mn.sync=C0;{Mn.addGap=wM,Mn.clipGaps=Jl;let n=Mn.paths={points:F0};n.linear=O0,n.stepped=AM,n.bars=RM,n.spline=PM}var Kd="calyx-theme",V0="(prefers-color-scheme: dark)";function ec(){let n=localStorage.getItem(Kd);return n==="light"||n==="dark"?n:"system"}function tc(n){n==="system"?localStorage.removeItem(Kd):localStorage.setItem(Kd,n),n==="system"?delete document.documentElement.dataset.theme:document.documentElement.dataset.theme=n,window.dispatchEvent(new Event("calyx-theme"))}function Ql(){let n=document.documentElement.dataset.theme;return n==="light"||n==="dark"?n:matchMedia(V0).matches?"dark":"light"}function nc(){let[n,e]=Tt(Ql());return At(()=>{let t=()=>e(Ql()),i=matchMedia(V0);return i.addEventListener("change",t),window.addEventListener("calyx-theme",t),()=>{i.removeEventListener("change",t),window.removeEventListener("calyx-theme",t)}},[]),n}var H0=[["cycle","Mesh cycle"],["roll_angle","Roll angle in deg"],["time","Time in s"],["step","Position"]],G0=190,VM=[void 0,[7,4],[2,3],[12,3,2,3]],HM=2;function W0({studio:n}){let[e,t]=Tt("cycle"),[i,s]=Tt(null),r=n.settings.selected,o=r.flatMap(u=>n.results[u]??[]).filter(u=>u.steps),a=WM(o);if(a.length===0)return null;let l=(i??a.slice(0,HM)).filter(u=>a.includes(u)),c=u=>s(l.includes(u)?l.filter(d=>d!==u):[...l,u]);return x("details",{class:"plots",open:!0,children:[x("summary",{children:["Plots",o.filter(u=>u.incomplete).map(u=>x("span",{class:"incomplete",children:[en(u.id),": ",os(u)]},u.id))]}),x("div",{class:"plot-settings",children:[x("div",{class:"chips",role:"group","aria-label":"Plotted outputs",children:a.map(u=>x("button",{type:"button",class:"chip","aria-pressed":l.includes(u),onClick:()=>c(u),children:tn(u)},u))}),o.some(u=>u.stride>1)&&x("span",{class:"muted small-text",children:["one of ",Math.max(...o.map(u=>u.stride))," positions"]}),x("label",{class:"inline",children:["over",x("select",{value:e,onChange:u=>t(u.currentTarget.value),children:H0.map(([u,d])=>x("option",{value:u,children:d},u))})]})]}),x("div",{class:"plot-grid",children:l.map(u=>x(qM,{title:tn(u),unit:XM(n,o,u),label:H0.find(([d])=>d===e)?.[1]??"",curves:o.flatMap(d=>$M(n,d,u,e,r.indexOf(d.id)))},u))})]})}var GM=new Set(["step","time","cycle","roll_angle","point"]);function WM(n){return[...new Set(n.flatMap(e=>Object.keys(e.steps??{})))].filter(e=>!GM.has(e))}function X0(n,e,t){let i=e.run?.outputs?.[t]?.display??e.run?.columns?.[t]?.display,s=n.model?.outputs.find(r=>r.name===t);return{unit:i?.unit??s?.unit??"SI",factor:i?.factor??s?.factor??1}}function XM(n,e,t){let i=e.find(s=>s.steps?.[t]);return i?X0(n,i,t).unit:""}function $M(n,e,t,i,s){let[r,o]=[e.steps?.[i],e.steps?.[t]];if(!r||!o)return[];let{factor:a}=X0(n,e,t),l=i==="roll_angle"?180/Math.PI:1,c=r.map((d,h)=>h).filter(d=>typeof r[d]=="number");c.sort((d,h)=>Number(r[d])-Number(r[h]));let u=d=>typeof d=="number"?d/a:null;return[{run:en(e.id),colour:ro(s),x:c.map(d=>l*Number(r[d])),y:c.map(d=>u(o[d]))}]}function qM({title:n,unit:e,label:t,curves:i}){let s=Gt(null),r=nc(),o=JSON.stringify([n,e,t,i,r]);return At(()=>{let a=s.current;if(!a)return;let l=new Mn(ZM(a,n,e,t,i),JM(i),a),c=new ResizeObserver(()=>{a.clientWidth>0&&l.setSize({width:a.clientWidth,height:G0})});return c.observe(a),()=>{c.disconnect(),l.destroy()}},[o]),x("figure",{class:"plot",children:[x("figcaption",{children:[n," ",e&&x("span",{class:"unit",children:e})]}),x("div",{ref:s,class:"canvas",role:"img","aria-label":YM(n,e,i)})]})}function YM(n,e,t){let i=t.map(({run:s,y:r})=>{let o=r.filter(a=>a!==null);return`${s} from ${ti(Math.min(...o))} to ${ti(Math.max(...o))}`});return`Plot of ${n}${e&&` in ${e}`}: ${i.join(", ")}`}function JM(n){return n.length===0?[[]]:Mn.join(n.map(({x:e,y:t})=>[e,t]))}function ZM(n,e,t,i,s){let r=getComputedStyle(n),[o,a]=[r.color,r.borderTopColor],l="12px system-ui, sans-serif",u={values:(d,h)=>h.map(f=>String(Number(f.toPrecision(6)))),stroke:o,font:l,labelFont:l,grid:{stroke:a,width:1},ticks:{stroke:a,width:1,size:4}};return{width:Math.max(n.clientWidth,100),height:G0,cursor:{sync:{key:"positions"},points:{size:6}},legend:{live:!0},scales:{x:{time:!1}},axes:[{...u,label:i,labelSize:18,size:34},{...u,size:58}],series:[{label:i},...s.map(({run:d,colour:h},f)=>({label:s.length>1?d:e,stroke:h,width:1.6,dash:VM[f%2+2*(Math.floor(f/fg)%2)],spanGaps:!0,points:{show:(s[0]?.x.length??0)<60,size:4,fill:h},value:(p,v)=>v===null?"–":`${ti(v)} ${t}`}))]}}function jd(n){let e=n.run;return[["Directory",n.directory],["Started",tg(n.started)],["Model",e?.model],["Hash of the source",e?.source?.sha256?.slice(0,16)],["Calyx",e?.calyx],["Fidelity",e?.fidelity],["Positions",ma(n)],...Object.entries(n.params??{}).filter(([,i])=>i.at_default!==!0).map(([i,s])=>[`Param: ${tn(i)}`,Ll(s)]),...Object.entries(n.settings??{}).map(([i,s])=>[`Set: ${Nl(i)}`,Dl(s)]),...Object.entries(e?.certificate??{}).map(([i,s])=>[`Residual: ${tn(i)}`,ti(s)])].filter(i=>!!i[1])}function $0({studio:n}){let e=n.settings.selected.flatMap(t=>n.results[t]??[]);return e.length===0?null:x("section",{class:"panel","aria-labelledby":"provenance-heading",children:[x("h2",{id:"provenance-heading",children:"Provenance"}),e.map(t=>x("details",{open:e.length===1,children:[x("summary",{children:en(t.id)}),x("dl",{class:"provenance",children:jd(t).map(([i,s])=>x("div",{children:[x("dt",{children:i}),x("dd",{children:s})]},i))}),x(KM,{results:t}),t.printed&&x("pre",{class:"plain",tabIndex:0,"aria-label":"Text that the model prints",children:t.printed}),x("p",{class:"links",children:[t.has_report&&x("a",{href:pi(t.id,"/files/report.html"),target:"_blank",rel:"noreferrer",children:"Report"}),t.steps&&x("a",{href:pi(t.id,"/files/steps.csv"),download:`${t.id}-steps.csv`,children:"steps.csv"}),t.run&&x("a",{href:pi(t.id,"/files/run.json"),download:`${t.id}.json`,children:"run.json"}),!n.withoutModel&&t.params&&x("button",{type:"button",class:"quiet",onClick:()=>n.useForm(t),children:"Use these params and settings"})]})]},t.id))]})}function KM({results:n}){let e=Object.entries(n.run?.ignored_inputs??{}),t=Object.entries(n.run?.refused_outputs??{});return e.length+t.length===0?null:x("ul",{class:"messages",children:[e.map(([i,s])=>x("li",{class:"warning",children:[x("code",{children:i})," is not used as given: ",s]},i)),t.map(([i,s])=>x("li",{class:"warning",children:[x("code",{children:i})," has no value: ",s]},i))]})}function Y0({studio:n}){if(n.withoutModel)return null;let{check:e,model:t}=n,i=n.runs.filter(s=>s.status==="running");return x("section",{class:"panel","aria-labelledby":"run-heading",children:[x("h2",{id:"run-heading",children:"Run"}),x(QM,{studio:n}),x("div",{class:"run-row",children:[x("button",{type:"button",class:"primary",disabled:!n.canRun,onClick:()=>{n.run()},children:"Run"}),x("label",{class:"switch",children:[x("input",{type:"checkbox",checked:n.settings.automatic,onChange:s=>n.setAutomatic(s.currentTarget.checked)}),"Run after changes if the predicted time is below 1 s"]})]}),x(jM,{studio:n}),e?.refused&&x("p",{class:"field-error",role:"alert",children:[x(oi,{text:e.refused.message}),x("span",{class:"help",children:x(oi,{text:e.refused.help})})]}),e&&!t?.broken&&e.rendered&&x("details",{open:!e.runnable,children:[x("summary",{children:e.runnable?"Warnings of the model":"Errors of the model with these params"}),x(Fl,{text:e.rendered,isError:!e.runnable})]}),i.map(s=>x(ew,{studio:n,run:s},s.id)),n.settings.selected.slice(0,1).map(s=>x(nw,{studio:n,id:s},s))]})}function jM({studio:n}){let{errors:e={},setting_errors:t={}}=n.check??{},i=r=>n.analysisSettings.find(o=>o.name===r)?.label??r,s=[...Object.keys(t).map(r=>({id:`setting-${r}`,label:i(r)})),...Object.keys(e).map(r=>({id:`param-${r}`,label:tn(r)}))];return s.length===0?null:x("p",{class:"fields-with-errors",children:[s.length===1?"One field has an error:":`${s.length} fields have errors:`,s.map(({id:r,label:o})=>x("button",{type:"button",class:"quiet",onClick:()=>document.getElementById(r)?.focus(),children:o},r))]})}function QM({studio:n}){let{check:e}=n,t=e?.plan;if(!t){let i=e?.runnable?"The model analyses nothing.":n.isChecking?"Checking …":"No plan: the model or its params have errors.";return x("p",{class:"muted","aria-busy":n.isChecking,children:i})}return x("div",{"aria-busy":n.isChecking,children:[x("dl",{class:"facts",children:[x("div",{children:[x("dt",{children:"Predicted time"}),x("dd",{"data-testid":"predicted-time",children:pa(t.time)})]}),x("div",{children:[x("dt",{children:"Memory"}),x("dd",{children:fd(t.memory)})]}),x("div",{title:"Predicted size of the files of the 3-D view, and of the meshes with stresses if they are requested",children:[x("dt",{children:"Disk"}),x("dd",{"data-testid":"predicted-disk",children:fd(t.disk)})]}),x("div",{children:[x("dt",{children:"Fidelity"}),x("dd",{"data-testid":"fidelity",children:t.fidelity})]}),x("div",{children:[x("dt",{children:"Positions"}),x("dd",{children:t.positions})]})]}),x("details",{children:[x("summary",{children:"Plan and gear data"}),x("pre",{class:"plain",tabIndex:0,"aria-label":"Plan",children:`${t.cost}
${t.text}
${e.gear_data}`.trim()})]})]})}function ew({studio:n,run:e}){let t=n.progress[e.id]??e.progress;return x("div",{class:"progress-card",children:[x("div",{class:"progress-head",children:[x("span",{children:en(e.id)}),x("button",{type:"button",class:"quiet",disabled:!n.isConnected,onClick:()=>{n.cancel(e.id)},"aria-label":`Cancel ${en(e.id)}`,children:"Cancel"})]}),x(tw,{name:en(e.id),progress:t})]})}function tw({name:n,progress:e}){let t=e?.total??null,i=e?.seconds_left;return x(lt,{children:[x("progress",{"aria-label":`Progress of ${n}`,max:t??void 0,value:t===null?void 0:e?.done}),x("p",{class:"muted small-text",children:[e?.stage??"starting",t!==null&&` ${e?.done} of ${t}`,i!=null&&i>0&&`, ${pa(i)} left`]})]})}function nw({studio:n,id:e}){let t=n.results[e];if(!t||t.status==="running")return null;let s=(t.messages??[]).filter(c=>c.severity!=="note"),r=t.run?.warnings??[],o=new Set(s.map(c=>c.message)),a=r.filter(c=>![...o].some(u=>c.includes(u))),l=[...s,...a.map(c=>({severity:"warning",code:null,message:c,help:null}))];return t.status==="finished"&&l.length===0?null:t.status==="cancelled"?x("div",{class:"ended",children:[x(q0,{studio:n,results:t}),x(pd,{messages:l.filter(c=>c.severity==="warning")})]}):x("div",{class:"ended",children:[x(q0,{studio:n,results:t,reason:s.length===0?t.message:null}),x(pd,{messages:l})]})}function q0({studio:n,results:e,reason:t}){let{id:i,status:s,incomplete:r,resumable:o}=e,a=en(i);return x("div",{class:"ended-early",children:[x("p",{children:[a,": ",s,r&&` after ${os(e)}`,t&&`, ${t}`]}),o&&x("button",{type:"button",disabled:!n.isConnected,"aria-label":`Continue ${a}`,title:"Solves the remaining positions with the params and settings of this run",onClick:()=>{n.continue(i)},children:"Continue"}),!o&&r&&s!=="elsewhere"&&(e.positions??0)>0&&x("p",{class:"muted small-text",children:["This studio did not start the run and does not know its options. To continue it, repeat its command with"," ",x("code",{children:"--resume"})," ","in a terminal."]})]})}var Qd=4;function J0({studio:n}){let e=[...n.runs].reverse(),t=Z0(n.runs);return x("section",{class:"panel","aria-labelledby":"runs-heading",children:[x("h2",{id:"runs-heading",children:"Runs"}),e.length===0&&x("p",{class:"muted",children:"No runs yet."}),x("ul",{class:"runs",children:e.map(i=>x(iw,{studio:n,run:i,differing:t},i.id))}),e.length>1&&n.settings.selected.length<2&&x("p",{class:"muted small-text",children:"Check two or more runs to compare them."})]})}function iw({studio:n,run:e,differing:t}){let i=n.settings.selected.indexOf(e.id),s=en(e.id);return x("li",{class:i>=0?"selected":"","data-run":e.id,children:[x("input",{type:"checkbox","aria-label":`Compare ${s}`,checked:i>=0,style:i>=0?{accentColor:ro(i)}:void 0,onChange:()=>n.toggle(e.id)}),x("button",{type:"button",class:"run-name","aria-pressed":i>=0,title:e.directory,onClick:()=>n.select([e.id]),children:[x("span",{class:"run-title",children:[s,x("span",{class:`status ${e.status}`,children:sw(n,e)}),x("span",{class:"when",children:ng(e.started)})]}),x("span",{class:"differences",children:rw(e,t)})]})]})}function sw(n,e){if(e.status==="elsewhere")return"written by another process";let t=n.progress[e.id]?.seconds_left;return e.status==="running"&&t?`running, ${pa(t)} left`:e.incomplete&&e.status!=="running"?`${e.status}, ${os(e)}`:e.status}function Z0(n){return["params","settings"].flatMap(t=>{let i=n.filter(o=>o[t]!==null);return[...new Set(i.flatMap(o=>Object.keys(o[t]??{})))].filter(o=>new Set(i.map(a=>ef(a,{kind:t,name:o}))).size>1).map(o=>({kind:t,name:o}))})}function ef(n,{kind:e,name:t}){if(e==="settings"){let s=n.settings?.[t];return s===void 0?t==="vtu"?"no":"as in the model":Dl(s)}let i=n.params?.[t];return i?Il(i.text,i.unit):"default"}function K0(n,e){let t=e.kind==="params"?n.params?.[e.name]:void 0;return t?Ll(t):ef(n,e)}function j0({kind:n,name:e}){return n==="settings"?Nl(e):tn(e)}function rw(n,e){let t=n.params??{},i=[...Object.keys(t).filter(a=>t[a]?.at_default!==!0).map(a=>({kind:"params",name:a})),...Object.keys(n.settings??{}).map(a=>({kind:"settings",name:a}))],s=a=>e.some(({kind:l,name:c})=>l===a.kind&&c===a.name);i.sort((a,l)=>Number(s(l))-Number(s(a)));let r=i.slice(0,Qd).map(a=>`${j0(a)} ${K0(n,a)}`),o=i.length>Qd?[`${i.length-Qd} more`]:[];return[...r,...o].join(", ")||(n.params?"defaults":"")}function Q0({studio:n}){let e=n.settings.selected.flatMap(i=>n.runs.filter(s=>s.id===i));if(e.length<2)return null;let t=Z0(e);return x("section",{class:"panel","aria-labelledby":"differences-heading",children:[x("h2",{id:"differences-heading",children:"Different params and settings"}),t.length===0&&x("p",{class:"muted",children:"These runs have the same params and settings."}),t.length>0&&x("div",{class:"scroll inputs",tabIndex:0,role:"region","aria-label":"Table of different params and settings",children:x("table",{children:[x("thead",{children:x("tr",{children:[x("th",{scope:"col",children:"Param"}),e.map(i=>x("th",{scope:"col",children:en(i.id)},i.id))]})}),x("tbody",{children:t.map(i=>x("tr",{children:[x("th",{scope:"row",children:j0(i)}),e.map(s=>x("td",{title:ef(s,i),children:K0(s,i)},s.id))]},`${i.kind}.${i.name}`))})]})})]})}var Ex=0,Pf=1,Tx=2;var qa=1,Ax=2,Vo=3,Fi=0,Xn=1,zn=2,Ur=0,Ho=1,If=2,Lf=3,Nf=4,Rx=5;var Or=100,Cx=101,Px=102,Ix=103,Lx=104,Nx=200,Dx=201,Fx=202,Ux=203,Df=204,Ff=205,Ox=206,kx=207,Bx=208,zx=209,Vx=210,Hx=211,Gx=212,Wx=213,Xx=214,Ac=0,Rc=1,Cc=2,Io=3,Pc=4,Ic=5,Lo=6,Lc=7,Uf=0,$x=1,qx=2,ds=0,Of=1,kf=2,Bf=3,zf=4,Vf=5,Hf=6,Gf=7;var Wf=300,kr=301,Go=302,iu=303,su=304,Nc=1e3,us=1001,Dc=1002,En=1003,Yx=1004;var Ya=1005;var Wn=1006,ru=1007;var Fs=1008;var Mi=1009,Xf=1010,$f=1011,Wo=1012,ou=1013,Zi=1014,Ki=1015,ji=1016,au=1017,lu=1018,Br=1020,qf=35902,Yf=35899,Jf=1021,Zf=1022,wi=1023,Is=1026,Us=1027,Kf=1028,cu=1029,hr=1030,uu=1031;var hu=1033,Ja=33776,Za=33777,Ka=33778,ja=33779,du=35840,fu=35841,pu=35842,mu=35843,gu=36196,xu=37492,vu=37496,_u=37488,yu=37489,Qa=37490,bu=37491,Su=37808,Mu=37809,wu=37810,Eu=37811,Tu=37812,Au=37813,Ru=37814,Cu=37815,Pu=37816,Iu=37817,Lu=37818,Nu=37819,Du=37820,Fu=37821,Uu=36492,Ou=36494,ku=36495,Bu=36283,zu=36284,el=36285,Vu=36286;var Pa=2300,Fc=2301,Ec=2302,wf=2303,Ef=2400,Tf=2401,Af=2402;var Jx=3200;var jf=0,Zx=1,Os="",ii="srgb",Ia="srgb-linear",La="linear",Pt="srgb";var Tc=7680,tl=7681;var Qf=34055,ep=34056;var tp=517;var Hu=519,Kx=512,jx=513,Qx=514,np=515,ev=516,tv=517,ip=518,sp=519,nv=35044,dr=35048;var rp="300 es",Ii=2e3,Na=2001;function ow(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function aw(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Da(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function iv(){let n=Da("canvas");return n.style.display="block",n}var ex={},No=null;function op(...n){let e="THREE."+n.shift();No?No("log",e,...n):console.log(e,...n)}function sv(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ye(...n){n=sv(n);let e="THREE."+n.shift();if(No)No("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function nt(...n){n=sv(n);let e="THREE."+n.shift();if(No)No("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Ca(...n){let e=n.join(" ");e in ex||(ex[e]=!0,Ye(...n))}function rv(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var ov={[Ac]:Ac,[Cc]:Lo,[Pc]:Pc,[Io]:Ic,[Rc]:Rc,[Lo]:Cc,[Lc]:Lc,[Ic]:Io},hs=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},qn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var tf=Math.PI/180,Uc=180/Math.PI;function nl(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(qn[n&255]+qn[n>>8&255]+qn[n>>16&255]+qn[n>>24&255]+"-"+qn[e&255]+qn[e>>8&255]+"-"+qn[e>>16&15|64]+qn[e>>24&255]+"-"+qn[t&63|128]+qn[t>>8&255]+"-"+qn[t>>16&255]+qn[t>>24&255]+qn[i&255]+qn[i>>8&255]+qn[i>>16&255]+qn[i>>24&255]).toLowerCase()}function xt(n,e,t){return Math.max(e,Math.min(t,n))}function lw(n,e){return(n%e+e)%e}function nf(n,e,t){return(1-t)*n+t*e}function av(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function ap(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function cw(n,e){if(e.constructor===Float32Array)return n;let t=ap(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function uw(n,e){if(e.constructor===Float32Array)return n;let t=ap(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var vt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(xt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Li=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],d=i[s+3],h=r[o+0],f=r[o+1],p=r[o+2],v=r[o+3];if(d!==v||l!==h||c!==f||u!==p){let m=l*h+c*f+u*p+d*v;m<0&&(h=-h,f=-f,p=-p,v=-v,m=-m);let g=1-a;if(m<.9995){let _=Math.acos(m),M=Math.sin(_);g=Math.sin(g*_)/M,a=Math.sin(a*_)/M,l=l*g+h*a,c=c*g+f*a,u=u*g+p*a,d=d*g+v*a}else{l=l*g+h*a,c=c*g+f*a,u=u*g+p*a,d=d*g+v*a;let _=1/Math.sqrt(l*l+c*c+u*u+d*d);l*=_,c*=_,u*=_,d*=_}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=d}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],d=r[o],h=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+u*d+l*f-c*h,e[t+1]=l*p+u*h+c*d-a*f,e[t+2]=c*p+u*f+a*h-l*d,e[t+3]=u*p-a*d-l*h-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),d=a(r/2),h=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*u*d+c*f*p,this._y=c*f*d-h*u*p,this._z=c*u*p+h*f*d,this._w=c*u*d-h*f*p;break;case"YXZ":this._x=h*u*d+c*f*p,this._y=c*f*d-h*u*p,this._z=c*u*p-h*f*d,this._w=c*u*d+h*f*p;break;case"ZXY":this._x=h*u*d-c*f*p,this._y=c*f*d+h*u*p,this._z=c*u*p+h*f*d,this._w=c*u*d-h*f*p;break;case"ZYX":this._x=h*u*d-c*f*p,this._y=c*f*d+h*u*p,this._z=c*u*p-h*f*d,this._w=c*u*d+h*f*p;break;case"YZX":this._x=h*u*d+c*f*p,this._y=c*f*d+h*u*p,this._z=c*u*p-h*f*d,this._w=c*u*d-h*f*p;break;case"XZY":this._x=h*u*d-c*f*p,this._y=c*f*d-h*u*p,this._z=c*u*p+h*f*d,this._w=c*u*d+h*f*p;break;default:Ye("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],d=t[10],h=i+a+d;if(h>0){let f=.5/Math.sqrt(h+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>d){let f=2*Math.sqrt(1+i-a-d);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-i-d);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+d-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(xt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(tx.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(tx.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),d=2*(r*i-o*t);return this.x=t+l*c+o*d-a*u,this.y=i+l*u+a*c-r*d,this.z=s+l*d+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return sf.copy(this).projectOnVector(e),this.sub(sf)}reflect(e){return this.sub(sf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(xt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},sf=new G,tx=new Li,it=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],d=i[7],h=i[2],f=i[5],p=i[8],v=s[0],m=s[3],g=s[6],_=s[1],M=s[4],b=s[7],C=s[2],R=s[5],y=s[8];return r[0]=o*v+a*_+l*C,r[3]=o*m+a*M+l*R,r[6]=o*g+a*b+l*y,r[1]=c*v+u*_+d*C,r[4]=c*m+u*M+d*R,r[7]=c*g+u*b+d*y,r[2]=h*v+f*_+p*C,r[5]=h*m+f*M+p*R,r[8]=h*g+f*b+p*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],d=u*o-a*c,h=a*l-u*r,f=c*r-o*l,p=t*d+i*h+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/p;return e[0]=d*v,e[1]=(s*c-u*i)*v,e[2]=(a*i-s*o)*v,e[3]=h*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=f*v,e[7]=(i*l-c*t)*v,e[8]=(o*t-i*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Ca("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(rf.makeScale(e,t)),this}rotate(e){return Ca("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(rf.makeRotation(-e)),this}translate(e,t){return Ca("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(rf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},rf=new it,nx=new it().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),ix=new it().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function hw(){let n={enabled:!0,workingColorSpace:Ia,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=Ps(s.r),s.g=Ps(s.g),s.b=Ps(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=Po(s.r),s.g=Po(s.g),s.b=Po(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Os?La:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ia]:{primaries:e,whitePoint:i,transfer:La,toXYZ:nx,fromXYZ:ix,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:ii},outputColorSpaceConfig:{drawingBufferColorSpace:ii}},[ii]:{primaries:e,whitePoint:i,transfer:Pt,toXYZ:nx,fromXYZ:ix,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:ii}}}),n}var gt=hw();function Ps(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Po(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var xo,Oc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{xo===void 0&&(xo=Da("canvas")),xo.width=e.width,xo.height=e.height;let s=xo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=xo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Da("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ps(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Ps(t[i]/255)*255):t[i]=Ps(t[i]);return{data:t,width:e.width,height:e.height}}else return Ye("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},dw=0,Do=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:dw++}),this.uuid=nl(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(of(s[o].image)):r.push(of(s[o]))}else r=of(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function of(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Oc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ye("Texture: Unable to serialize Texture."),{})}var fw=0,af=new G,li=class n extends hs{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=us,s=us,r=Wn,o=Fs,a=wi,l=Mi,c=n.DEFAULT_ANISOTROPY,u=Os){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:fw++}),this.uuid=nl(),this.name="",this.source=new Do(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new vt(0,0),this.repeat=new vt(1,1),this.center=new vt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new it,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(af).x}get height(){return this.source.getSize(af).y}get depth(){return this.source.getSize(af).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ye(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Wf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Nc:e.x=e.x-Math.floor(e.x);break;case us:e.x=e.x<0?0:1;break;case Dc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Nc:e.y=e.y-Math.floor(e.y);break;case us:e.y=e.y<0?0:1;break;case Dc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};li.DEFAULT_IMAGE=null;li.DEFAULT_MAPPING=Wf;li.DEFAULT_ANISOTROPY=1;var Kt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],d=l[8],h=l[1],f=l[5],p=l[9],v=l[2],m=l[6],g=l[10];if(Math.abs(u-h)<.01&&Math.abs(d-v)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+h)<.1&&Math.abs(d+v)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,b=(f+1)/2,C=(g+1)/2,R=(u+h)/4,y=(d+v)/4,E=(p+m)/4;return M>b&&M>C?M<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(M),s=R/i,r=y/i):b>C?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=R/s,r=E/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=y/r,s=E/r),this.set(i,s,r,t),this}let _=Math.sqrt((m-p)*(m-p)+(d-v)*(d-v)+(h-u)*(h-u));return Math.abs(_)<.001&&(_=1),this.x=(m-p)/_,this.y=(d-v)/_,this.z=(h-u)/_,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this.w=xt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this.w=xt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},kc=class extends hs{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Wn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Kt(0,0,e,t),this.scissorTest=!1,this.viewport=new Kt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new li({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Wn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Do(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},yi=class extends kc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Fa=class extends li{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=En,this.minFilter=En,this.wrapR=us,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Bc=class extends li{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=En,this.minFilter=En,this.wrapR=us,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var yt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,d,h,f,p,v,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,d,h,f,p,v,m)}set(e,t,i,s,r,o,a,l,c,u,d,h,f,p,v,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=d,g[14]=h,g[3]=f,g[7]=p,g[11]=v,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/vo.setFromMatrixColumn(e,0).length(),r=1/vo.setFromMatrixColumn(e,1).length(),o=1/vo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let h=o*u,f=o*d,p=a*u,v=a*d;t[0]=l*u,t[4]=-l*d,t[8]=c,t[1]=f+p*c,t[5]=h-v*c,t[9]=-a*l,t[2]=v-h*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,f=l*d,p=c*u,v=c*d;t[0]=h+v*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*d,t[5]=o*u,t[9]=-a,t[2]=f*a-p,t[6]=v+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,f=l*d,p=c*u,v=c*d;t[0]=h-v*a,t[4]=-o*d,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*u,t[9]=v-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,f=o*d,p=a*u,v=a*d;t[0]=l*u,t[4]=p*c-f,t[8]=h*c+v,t[1]=l*d,t[5]=v*c+h,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,f=o*c,p=a*l,v=a*c;t[0]=l*u,t[4]=v-h*d,t[8]=p*d+f,t[1]=d,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*d+p,t[10]=h-v*d}else if(e.order==="XZY"){let h=o*l,f=o*c,p=a*l,v=a*c;t[0]=l*u,t[4]=-d,t[8]=c*u,t[1]=h*d+v,t[5]=o*u,t[9]=f*d-p,t[2]=p*d-f,t[6]=a*u,t[10]=v*d+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(pw,e,mw)}lookAt(e,t,i){let s=this.elements;return vi.subVectors(e,t),vi.lengthSq()===0&&(vi.z=1),vi.normalize(),js.crossVectors(i,vi),js.lengthSq()===0&&(Math.abs(i.z)===1?vi.x+=1e-4:vi.z+=1e-4,vi.normalize(),js.crossVectors(i,vi)),js.normalize(),ic.crossVectors(vi,js),s[0]=js.x,s[4]=ic.x,s[8]=vi.x,s[1]=js.y,s[5]=ic.y,s[9]=vi.y,s[2]=js.z,s[6]=ic.z,s[10]=vi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],d=i[5],h=i[9],f=i[13],p=i[2],v=i[6],m=i[10],g=i[14],_=i[3],M=i[7],b=i[11],C=i[15],R=s[0],y=s[4],E=s[8],U=s[12],N=s[1],L=s[5],O=s[9],z=s[13],D=s[2],W=s[6],q=s[10],H=s[14],le=s[3],Z=s[7],Q=s[11],ie=s[15];return r[0]=o*R+a*N+l*D+c*le,r[4]=o*y+a*L+l*W+c*Z,r[8]=o*E+a*O+l*q+c*Q,r[12]=o*U+a*z+l*H+c*ie,r[1]=u*R+d*N+h*D+f*le,r[5]=u*y+d*L+h*W+f*Z,r[9]=u*E+d*O+h*q+f*Q,r[13]=u*U+d*z+h*H+f*ie,r[2]=p*R+v*N+m*D+g*le,r[6]=p*y+v*L+m*W+g*Z,r[10]=p*E+v*O+m*q+g*Q,r[14]=p*U+v*z+m*H+g*ie,r[3]=_*R+M*N+b*D+C*le,r[7]=_*y+M*L+b*W+C*Z,r[11]=_*E+M*O+b*q+C*Q,r[15]=_*U+M*z+b*H+C*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],d=e[6],h=e[10],f=e[14],p=e[3],v=e[7],m=e[11],g=e[15],_=l*f-c*h,M=a*f-c*d,b=a*h-l*d,C=o*f-c*u,R=o*h-l*u,y=o*d-a*u;return t*(v*_-m*M+g*b)-i*(p*_-m*C+g*R)+s*(p*M-v*C+g*y)-r*(p*b-v*R+m*y)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],d=e[9],h=e[10],f=e[11],p=e[12],v=e[13],m=e[14],g=e[15],_=t*a-i*o,M=t*l-s*o,b=t*c-r*o,C=i*l-s*a,R=i*c-r*a,y=s*c-r*l,E=u*v-d*p,U=u*m-h*p,N=u*g-f*p,L=d*m-h*v,O=d*g-f*v,z=h*g-f*m,D=_*z-M*O+b*L+C*N-R*U+y*E;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/D;return e[0]=(a*z-l*O+c*L)*W,e[1]=(s*O-i*z-r*L)*W,e[2]=(v*y-m*R+g*C)*W,e[3]=(h*R-d*y-f*C)*W,e[4]=(l*N-o*z-c*U)*W,e[5]=(t*z-s*N+r*U)*W,e[6]=(m*b-p*y-g*M)*W,e[7]=(u*y-h*b+f*M)*W,e[8]=(o*O-a*N+c*E)*W,e[9]=(i*N-t*O-r*E)*W,e[10]=(p*R-v*b+g*_)*W,e[11]=(d*b-u*R-f*_)*W,e[12]=(a*U-o*L-l*E)*W,e[13]=(t*L-i*U+s*E)*W,e[14]=(v*M-p*C-m*_)*W,e[15]=(u*C-d*M+h*_)*W,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,d=a+a,h=r*c,f=r*u,p=r*d,v=o*u,m=o*d,g=a*d,_=l*c,M=l*u,b=l*d,C=i.x,R=i.y,y=i.z;return s[0]=(1-(v+g))*C,s[1]=(f+b)*C,s[2]=(p-M)*C,s[3]=0,s[4]=(f-b)*R,s[5]=(1-(h+g))*R,s[6]=(m+_)*R,s[7]=0,s[8]=(p+M)*y,s[9]=(m-_)*y,s[10]=(1-(h+v))*y,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=vo.set(s[0],s[1],s[2]).length(),a=vo.set(s[4],s[5],s[6]).length(),l=vo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Wi.copy(this);let c=1/o,u=1/a,d=1/l;return Wi.elements[0]*=c,Wi.elements[1]*=c,Wi.elements[2]*=c,Wi.elements[4]*=u,Wi.elements[5]*=u,Wi.elements[6]*=u,Wi.elements[8]*=d,Wi.elements[9]*=d,Wi.elements[10]*=d,t.setFromRotationMatrix(Wi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Ii,l=!1){let c=this.elements,u=2*r/(t-e),d=2*r/(i-s),h=(t+e)/(t-e),f=(i+s)/(i-s),p,v;if(l)p=r/(o-r),v=o*r/(o-r);else if(a===Ii)p=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===Na)p=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ii,l=!1){let c=this.elements,u=2/(t-e),d=2/(i-s),h=-(t+e)/(t-e),f=-(i+s)/(i-s),p,v;if(l)p=1/(o-r),v=o/(o-r);else if(a===Ii)p=-2/(o-r),v=-(o+r)/(o-r);else if(a===Na)p=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},vo=new G,Wi=new yt,pw=new G(0,0,0),mw=new G(1,1,1),js=new G,ic=new G,vi=new G,sx=new yt,rx=new Li,sr=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],d=s[2],h=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(xt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(xt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-xt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(h,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-xt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Ye("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return sx.makeRotationFromQuaternion(e),this.setFromRotationMatrix(sx,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return rx.setFromEuler(this),this.setFromQuaternion(rx,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};sr.DEFAULT_ORDER="XYZ";var Ua=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},gw=0,ox=new G,_o=new Li,Es=new yt,sc=new G,wa=new G,xw=new G,vw=new Li,ax=new G(1,0,0),lx=new G(0,1,0),cx=new G(0,0,1),ux={type:"added"},_w={type:"removed"},yo={type:"childadded",child:null},lf={type:"childremoved",child:null},bi=class n extends hs{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:gw++}),this.uuid=nl(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new G,t=new sr,i=new Li,s=new G(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new yt},normalMatrix:{value:new it}}),this.matrix=new yt,this.matrixWorld=new yt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ua,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return _o.setFromAxisAngle(e,t),this.quaternion.multiply(_o),this}rotateOnWorldAxis(e,t){return _o.setFromAxisAngle(e,t),this.quaternion.premultiply(_o),this}rotateX(e){return this.rotateOnAxis(ax,e)}rotateY(e){return this.rotateOnAxis(lx,e)}rotateZ(e){return this.rotateOnAxis(cx,e)}translateOnAxis(e,t){return ox.copy(e).applyQuaternion(this.quaternion),this.position.add(ox.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(ax,e)}translateY(e){return this.translateOnAxis(lx,e)}translateZ(e){return this.translateOnAxis(cx,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Es.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?sc.copy(e):sc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),wa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Es.lookAt(wa,sc,this.up):Es.lookAt(sc,wa,this.up),this.quaternion.setFromRotationMatrix(Es),s&&(Es.extractRotation(s.matrixWorld),_o.setFromRotationMatrix(Es),this.quaternion.premultiply(_o.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(nt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(ux),yo.child=e,this.dispatchEvent(yo),yo.child=null):nt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(_w),lf.child=e,this.dispatchEvent(lf),lf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Es.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Es.multiply(e.parent.matrixWorld)),e.applyMatrix4(Es),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(ux),yo.child=e,this.dispatchEvent(yo),yo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(wa,e,xw),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(wa,vw,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),d=o(e.shapes),h=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),d.length>0&&(i.shapes=d),h.length>0&&(i.skeletons=h),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};bi.DEFAULT_UP=new G(0,1,0);bi.DEFAULT_MATRIX_AUTO_UPDATE=!0;bi.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var rn=class extends bi{constructor(){super(),this.isGroup=!0,this.type="Group"}},yw={type:"move"},Fo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new rn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new rn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new rn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let m=t.getJointPose(v,i),g=this._getHandJoint(c,v);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let u=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],h=u.position.distanceTo(d.position),f=.02,p=.005;c.inputState.pinching&&h>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(yw)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new rn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},lv={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Qs={h:0,s:0,l:0},rc={h:0,s:0,l:0};function cf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var at=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=ii){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,gt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=gt.workingColorSpace){return this.r=e,this.g=t,this.b=i,gt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=gt.workingColorSpace){if(e=lw(e,1),t=xt(t,0,1),i=xt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=cf(o,r,e+1/3),this.g=cf(o,r,e),this.b=cf(o,r,e-1/3)}return gt.colorSpaceToWorking(this,s),this}setStyle(e,t=ii){function i(r){r!==void 0&&parseFloat(r)<1&&Ye("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ye("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ye("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=ii){let i=lv[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ye("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ps(e.r),this.g=Ps(e.g),this.b=Ps(e.b),this}copyLinearToSRGB(e){return this.r=Po(e.r),this.g=Po(e.g),this.b=Po(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ii){return gt.workingToColorSpace(Yn.copy(this),e),Math.round(xt(Yn.r*255,0,255))*65536+Math.round(xt(Yn.g*255,0,255))*256+Math.round(xt(Yn.b*255,0,255))}getHexString(e=ii){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=gt.workingColorSpace){gt.workingToColorSpace(Yn.copy(this),t);let i=Yn.r,s=Yn.g,r=Yn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=u<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=gt.workingColorSpace){return gt.workingToColorSpace(Yn.copy(this),t),e.r=Yn.r,e.g=Yn.g,e.b=Yn.b,e}getStyle(e=ii){gt.workingToColorSpace(Yn.copy(this),e);let t=Yn.r,i=Yn.g,s=Yn.b;return e!==ii?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Qs),this.setHSL(Qs.h+e,Qs.s+t,Qs.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Qs),e.getHSL(rc);let i=nf(Qs.h,rc.h,t),s=nf(Qs.s,rc.s,t),r=nf(Qs.l,rc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Yn=new at;at.NAMES=lv;var Oa=class extends bi{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new sr,this.environmentIntensity=1,this.environmentRotation=new sr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Xi=new G,Ts=new G,uf=new G,As=new G,bo=new G,So=new G,hx=new G,hf=new G,df=new G,ff=new G,pf=new Kt,mf=new Kt,gf=new Kt,ir=class n{constructor(e=new G,t=new G,i=new G){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Xi.subVectors(e,t),s.cross(Xi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Xi.subVectors(s,t),Ts.subVectors(i,t),uf.subVectors(e,t);let o=Xi.dot(Xi),a=Xi.dot(Ts),l=Xi.dot(uf),c=Ts.dot(Ts),u=Ts.dot(uf),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let h=1/d,f=(c*l-a*u)*h,p=(o*u-a*l)*h;return r.set(1-f-p,p,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,As)===null?!1:As.x>=0&&As.y>=0&&As.x+As.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,As)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,As.x),l.addScaledVector(o,As.y),l.addScaledVector(a,As.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return pf.setScalar(0),mf.setScalar(0),gf.setScalar(0),pf.fromBufferAttribute(e,t),mf.fromBufferAttribute(e,i),gf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(pf,r.x),o.addScaledVector(mf,r.y),o.addScaledVector(gf,r.z),o}static isFrontFacing(e,t,i,s){return Xi.subVectors(i,t),Ts.subVectors(e,t),Xi.cross(Ts).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Xi.subVectors(this.c,this.b),Ts.subVectors(this.a,this.b),Xi.cross(Ts).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;bo.subVectors(s,i),So.subVectors(r,i),hf.subVectors(e,i);let l=bo.dot(hf),c=So.dot(hf);if(l<=0&&c<=0)return t.copy(i);df.subVectors(e,s);let u=bo.dot(df),d=So.dot(df);if(u>=0&&d<=u)return t.copy(s);let h=l*d-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(bo,o);ff.subVectors(e,r);let f=bo.dot(ff),p=So.dot(ff);if(p>=0&&f<=p)return t.copy(r);let v=f*c-l*p;if(v<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(So,a);let m=u*p-f*d;if(m<=0&&d-u>=0&&f-p>=0)return hx.subVectors(r,s),a=(d-u)/(d-u+(f-p)),t.copy(s).addScaledVector(hx,a);let g=1/(m+v+h);return o=v*g,a=h*g,t.copy(i).addScaledVector(bo,o).addScaledVector(So,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ci=class{constructor(e=new G(1/0,1/0,1/0),t=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint($i.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint($i.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=$i.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,$i):$i.fromBufferAttribute(r,o),$i.applyMatrix4(e.matrixWorld),this.expandByPoint($i);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),oc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),oc.copy(i.boundingBox)),oc.applyMatrix4(e.matrixWorld),this.union(oc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,$i),$i.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ea),ac.subVectors(this.max,Ea),Mo.subVectors(e.a,Ea),wo.subVectors(e.b,Ea),Eo.subVectors(e.c,Ea),er.subVectors(wo,Mo),tr.subVectors(Eo,wo),Cr.subVectors(Mo,Eo);let t=[0,-er.z,er.y,0,-tr.z,tr.y,0,-Cr.z,Cr.y,er.z,0,-er.x,tr.z,0,-tr.x,Cr.z,0,-Cr.x,-er.y,er.x,0,-tr.y,tr.x,0,-Cr.y,Cr.x,0];return!xf(t,Mo,wo,Eo,ac)||(t=[1,0,0,0,1,0,0,0,1],!xf(t,Mo,wo,Eo,ac))?!1:(lc.crossVectors(er,tr),t=[lc.x,lc.y,lc.z],xf(t,Mo,wo,Eo,ac))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,$i).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize($i).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Rs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Rs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Rs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Rs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Rs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Rs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Rs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Rs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Rs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Rs=[new G,new G,new G,new G,new G,new G,new G,new G],$i=new G,oc=new ci,Mo=new G,wo=new G,Eo=new G,er=new G,tr=new G,Cr=new G,Ea=new G,ac=new G,lc=new G,Pr=new G;function xf(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Pr.fromArray(n,r);let a=s.x*Math.abs(Pr.x)+s.y*Math.abs(Pr.y)+s.z*Math.abs(Pr.z),l=e.dot(Pr),c=t.dot(Pr),u=i.dot(Pr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var wn=new G,cc=new vt,bw=0,St=class extends hs{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:bw++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=nv,this.updateRanges=[],this.gpuType=Ki,this.version=0,this._normalizationScale=e!==void 0?ap(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)cc.fromBufferAttribute(this,t),cc.applyMatrix3(e),this.setXY(t,cc.x,cc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.applyMatrix3(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.applyMatrix4(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.applyNormalMatrix(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.transformDirection(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):cw(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):uw(e,this.array)}};var ka=class extends St{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Ba=class extends St{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Wt=class extends St{constructor(e,t,i){super(new Float32Array(e),t,i)}},Sw=new ci,Ta=new G,vf=new G,ri=class{constructor(e=new G,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):Sw.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ta.subVectors(e,this.center);let t=Ta.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Ta,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(vf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ta.copy(e.center).add(vf)),this.expandByPoint(Ta.copy(e.center).sub(vf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Mw=0,Pi=new yt,_f=new bi,To=new G,_i=new ci,Aa=new ci,Bn=new G,hn=class n extends hs{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Mw++}),this.uuid=nl(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(ow(e)?Ba:ka)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new it().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Pi.makeRotationFromQuaternion(e),this.applyMatrix4(Pi),this}rotateX(e){return Pi.makeRotationX(e),this.applyMatrix4(Pi),this}rotateY(e){return Pi.makeRotationY(e),this.applyMatrix4(Pi),this}rotateZ(e){return Pi.makeRotationZ(e),this.applyMatrix4(Pi),this}translate(e,t,i){return Pi.makeTranslation(e,t,i),this.applyMatrix4(Pi),this}scale(e,t,i){return Pi.makeScale(e,t,i),this.applyMatrix4(Pi),this}lookAt(e){return _f.lookAt(e),_f.updateMatrix(),this.applyMatrix4(_f.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(To).negate(),this.translate(To.x,To.y,To.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Wt(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ye("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ci);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];_i.setFromBufferAttribute(r),this.morphTargetsRelative?(Bn.addVectors(this.boundingBox.min,_i.min),this.boundingBox.expandByPoint(Bn),Bn.addVectors(this.boundingBox.max,_i.max),this.boundingBox.expandByPoint(Bn)):(this.boundingBox.expandByPoint(_i.min),this.boundingBox.expandByPoint(_i.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&nt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ri);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(e){let i=this.boundingSphere.center;if(_i.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Aa.setFromBufferAttribute(a),this.morphTargetsRelative?(Bn.addVectors(_i.min,Aa.min),_i.expandByPoint(Bn),Bn.addVectors(_i.max,Aa.max),_i.expandByPoint(Bn)):(_i.expandByPoint(Aa.min),_i.expandByPoint(Aa.max))}_i.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Bn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Bn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Bn.fromBufferAttribute(a,c),l&&(To.fromBufferAttribute(e,c),Bn.add(To)),s=Math.max(s,i.distanceToSquared(Bn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&nt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){nt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new St(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new G,l[U]=new G;let u=new G,d=new G,h=new G,f=new vt,p=new vt,v=new vt,m=new G,g=new G;function _(U,N,L){c[U]=c[N]=c[L]=1,u.fromBufferAttribute(i,U),d.fromBufferAttribute(i,N),h.fromBufferAttribute(i,L),f.fromBufferAttribute(r,U),p.fromBufferAttribute(r,N),v.fromBufferAttribute(r,L),d.sub(u),h.sub(u),p.sub(f),v.sub(f);let O=1/(p.x*v.y-v.x*p.y);isFinite(O)&&(m.copy(d).multiplyScalar(v.y).addScaledVector(h,-p.y).multiplyScalar(O),g.copy(h).multiplyScalar(p.x).addScaledVector(d,-v.x).multiplyScalar(O),a[U].add(m),a[N].add(m),a[L].add(m),l[U].add(g),l[N].add(g),l[L].add(g))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let U=0,N=M.length;U<N;++U){let L=M[U],O=L.start,z=L.count;for(let D=O,W=O+z;D<W;D+=3)_(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let b=new G,C=new G,R=new G,y=new G;function E(U){R.fromBufferAttribute(s,U),y.copy(R);let N=a[U];b.copy(N),b.sub(R.multiplyScalar(R.dot(N))).normalize(),C.crossVectors(y,N);let O=C.dot(l[U])<0?-1:1;o.setXYZW(U,b.x,b.y,b.z,O)}for(let U=0,N=i.count;U<N;++U)c[U]&&E(U);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new St(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,f=i.count;h<f;h++)i.setXYZ(h,0,0,0);let s=new G,r=new G,o=new G,a=new G,l=new G,c=new G,u=new G,d=new G;if(e)for(let h=0,f=e.count;h<f;h+=3){let p=e.getX(h+0),v=e.getX(h+1),m=e.getX(h+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,m),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let h=0,f=t.count;h<f;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Bn.fromBufferAttribute(e,t),Bn.normalize(),e.setXYZ(t,Bn.x,Bn.y,Bn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,d=a.normalized,h=new c.constructor(l.length*u),f=0,p=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?f=l[v]*a.data.stride+a.offset:f=l[v]*u;for(let g=0;g<u;g++)h[p++]=c[f++]}return new St(h,u,d)}if(this.index===null)return Ye("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,d=c.length;u<d;u++){let h=c[u],f=e(h,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let d=0,h=c.length;d<h;d++){let f=c[d];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],d=r[c];for(let h=0,f=d.length;h<f;h++)u.push(d[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var yf=new G,ww=new G,Ew=new it,qi=class{constructor(e=new G(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=yf.subVectors(i,t).cross(ww.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(yf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||Ew.getNormalMatrix(e),s=this.coplanarPoint(yf).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Tw=0,rr=class extends hs{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Tw++}),this.uuid=nl(),this.name="",this.type="Material",this.blending=Ho,this.side=Fi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Df,this.blendDst=Ff,this.blendEquation=Or,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new at(0,0,0),this.blendAlpha=0,this.depthFunc=Io,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Hu,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Tc,this.stencilZFail=Tc,this.stencilZPass=Tc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ye(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new at().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new qi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new vt().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new vt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Cs=new G,bf=new G,uc=new G,hc=new G,Ni=class{constructor(e=new G,t=new G(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Cs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Cs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Cs.copy(this.origin).addScaledVector(this.direction,t),Cs.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){bf.copy(e).add(t).multiplyScalar(.5),uc.copy(t).sub(e).normalize(),hc.copy(this.origin).sub(bf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(uc),a=hc.dot(this.direction),l=-hc.dot(uc),c=hc.lengthSq(),u=Math.abs(1-o*o),d,h,f,p;if(u>0)if(d=o*l-a,h=o*a-l,p=r*u,d>=0)if(h>=-p)if(h<=p){let v=1/u;d*=v,h*=v,f=d*(d+o*h+2*a)+h*(o*d+h+2*l)+c}else h=r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;else h=-r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;else h<=-p?(d=Math.max(0,-(-o*r+a)),h=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+h*(h+2*l)+c):h<=p?(d=0,h=Math.min(Math.max(-r,-l),r),f=h*(h+2*l)+c):(d=Math.max(0,-(o*r+a)),h=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+h*(h+2*l)+c);else h=o>0?-r:r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(bf).addScaledVector(uc,h),f}intersectSphere(e,t){if(e.radius<0)return null;Cs.subVectors(e.center,this.origin);let i=Cs.dot(this.direction),s=Cs.dot(Cs)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,d=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(e.min.z-h.z)*d,l=(e.max.z-h.z)*d):(a=(e.max.z-h.z)*d,l=(e.min.z-h.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Cs)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,d=e.x-o.x,h=e.y-o.y,f=e.z-o.z,p=t.x-o.x,v=t.y-o.y,m=t.z-o.z,g=i.x-o.x,_=i.y-o.y,M=i.z-o.z,b=Math.abs(l),C=Math.abs(c),R=Math.abs(u),y,E,U,N,L,O,z,D,W,q,H,le;if(b>=C&&b>=R?(U=l,O=d,W=p,le=g,l>=0?(y=c,E=u,N=h,L=f,z=v,D=m,q=_,H=M):(y=u,E=c,N=f,L=h,z=m,D=v,q=M,H=_)):C>=R?(U=c,O=h,W=v,le=_,c>=0?(y=u,E=l,N=f,L=d,z=m,D=p,q=M,H=g):(y=l,E=u,N=d,L=f,z=p,D=m,q=g,H=M)):(U=u,O=f,W=m,le=M,u>=0?(y=l,E=c,N=d,L=h,z=p,D=v,q=g,H=_):(y=c,E=l,N=h,L=d,z=v,D=p,q=_,H=g)),U===0)return null;let Z=y/U,Q=E/U,ie=1/U,de=N-Z*O,he=L-Q*O,ee=z-Z*W,me=D-Q*W,ge=q-Z*le,Me=H-Q*le,ve=ge*me-Me*ee,Ve=de*Me-he*ge,$e=ee*he-me*de;if(s){if(ve<0||Ve<0||$e<0)return null}else if((ve<0||Ve<0||$e<0)&&(ve>0||Ve>0||$e>0))return null;let Fe=ve+Ve+$e;if(Fe===0)return null;let Ze=ie*(ve*O+Ve*W+$e*le);return(Fe>0?Ze<0:Ze>0)?null:this.at(Ze/Fe,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},or=class extends rr{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new at(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new sr,this.combine=Uf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},dx=new yt,Ir=new Ni,dc=new ri,fx=new G,fc=new G,pc=new G,mc=new G,Sf=new G,gc=new G,px=new G,xc=new G,bt=class extends bi{constructor(e=new hn,t=new or){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){gc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],d=r[l];u!==0&&(Sf.fromBufferAttribute(d,e),o?gc.addScaledVector(Sf,u):gc.addScaledVector(Sf.sub(t),u))}t.add(gc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),dc.copy(i.boundingSphere),dc.applyMatrix4(r),Ir.copy(e.ray).recast(e.near),!(dc.containsPoint(Ir.origin)===!1&&(Ir.intersectSphere(dc,fx)===null||Ir.origin.distanceToSquared(fx)>(e.far-e.near)**2))&&(dx.copy(r).invert(),Ir.copy(e.ray).applyMatrix4(dx),!(i.boundingBox!==null&&Ir.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Ir)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,d=r.attributes.normal,h=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,v=h.length;p<v;p++){let m=h[p],g=o[m.materialIndex],_=Math.max(m.start,f.start),M=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let b=_,C=M;b<C;b+=3){let R=a.getX(b),y=a.getX(b+1),E=a.getX(b+2);s=vc(this,g,e,i,c,u,d,R,y,E),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let m=p,g=v;m<g;m+=3){let _=a.getX(m),M=a.getX(m+1),b=a.getX(m+2);s=vc(this,o,e,i,c,u,d,_,M,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,v=h.length;p<v;p++){let m=h[p],g=o[m.materialIndex],_=Math.max(m.start,f.start),M=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=_,C=M;b<C;b+=3){let R=b,y=b+1,E=b+2;s=vc(this,g,e,i,c,u,d,R,y,E),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let m=p,g=v;m<g;m+=3){let _=m,M=m+1,b=m+2;s=vc(this,o,e,i,c,u,d,_,M,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function Aw(n,e,t,i,s,r,o,a){let l;if(e.side===Xn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Fi,a),l===null)return null;xc.copy(a),xc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(xc);return c<t.near||c>t.far?null:{distance:c,point:xc.clone(),object:n}}function vc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,fc),n.getVertexPosition(l,pc),n.getVertexPosition(c,mc);let u=Aw(n,e,t,i,fc,pc,mc,px);if(u){let d=new G;ir.getBarycoord(px,fc,pc,mc,d),s&&(u.uv=ir.getInterpolatedAttribute(s,a,l,c,d,new vt)),r&&(u.uv1=ir.getInterpolatedAttribute(r,a,l,c,d,new vt)),o&&(u.normal=ir.getInterpolatedAttribute(o,a,l,c,d,new G),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new G,materialIndex:0};ir.getNormal(fc,pc,mc,h.normal),u.face=h,u.barycoord=d}return u}var Uo=class extends li{constructor(e=null,t=1,i=1,s,r,o,a,l,c=En,u=En,d,h){super(null,o,a,l,c,u,s,r,d,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ls=class extends St{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var Lr=new ri,Rw=new vt(.5,.5),_c=new G,Ns=class{constructor(e=new qi,t=new qi,i=new qi,s=new qi,r=new qi,o=new qi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ii,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],d=r[5],h=r[6],f=r[7],p=r[8],v=r[9],m=r[10],g=r[11],_=r[12],M=r[13],b=r[14],C=r[15];if(s[0].setComponents(c-o,f-u,g-p,C-_).normalize(),s[1].setComponents(c+o,f+u,g+p,C+_).normalize(),s[2].setComponents(c+a,f+d,g+v,C+M).normalize(),s[3].setComponents(c-a,f-d,g-v,C-M).normalize(),i)s[4].setComponents(l,h,m,b).normalize(),s[5].setComponents(c-l,f-h,g-m,C-b).normalize();else if(s[4].setComponents(c-l,f-h,g-m,C-b).normalize(),t===Ii)s[5].setComponents(c+l,f+h,g+m,C+b).normalize();else if(t===Na)s[5].setComponents(l,h,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Lr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Lr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Lr)}intersectsSprite(e){Lr.center.set(0,0,0);let t=Rw.distanceTo(e.center);return Lr.radius=.7071067811865476+t,Lr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Lr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(_c.x=s.normal.x>0?e.max.x:e.min.x,_c.y=s.normal.y>0?e.max.y:e.min.y,_c.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(_c)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},mx=new yt,zc=class n{constructor(){this.coordinateSystem=Ii,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];mx.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Ns),i[s].setFromProjectionMatrix(mx,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Ns),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var ar=class extends rr{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new at(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Vc=new G,Hc=new G,gx=new yt,Ra=new Ni,yc=new ri,Mf=new G,xx=new G,za=class extends bi{constructor(e=new hn,t=new ar){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Vc.fromBufferAttribute(t,s-1),Hc.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Vc.distanceTo(Hc);e.setAttribute("lineDistance",new Wt(i,1))}else Ye("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),yc.copy(i.boundingSphere),yc.applyMatrix4(s),yc.radius+=r,e.ray.intersectsSphere(yc)===!1)return;gx.copy(s).invert(),Ra.copy(e.ray).applyMatrix4(gx);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let v=f,m=p-1;v<m;v+=c){let g=u.getX(v),_=u.getX(v+1),M=bc(this,e,Ra,l,g,_,v);M&&t.push(M)}if(this.isLineLoop){let v=u.getX(p-1),m=u.getX(f),g=bc(this,e,Ra,l,v,m,p-1);g&&t.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let v=f,m=p-1;v<m;v+=c){let g=bc(this,e,Ra,l,v,v+1,v);g&&t.push(g)}if(this.isLineLoop){let v=bc(this,e,Ra,l,p-1,f,p-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function bc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Vc.fromBufferAttribute(a,s),Hc.fromBufferAttribute(a,r),t.distanceSqToSegment(Vc,Hc,Mf,xx)>i)return;Mf.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Mf);if(!(c<e.near||c>e.far))return{distance:c,point:xx.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var vx=new G,_x=new G,Yi=class extends za{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)vx.fromBufferAttribute(t,s),_x.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+vx.distanceTo(_x);e.setAttribute("lineDistance",new Wt(i,1))}else Ye("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},Nr=class extends za{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}};var Va=class extends li{constructor(e=[],t=kr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ds=class extends li{constructor(e,t,i=Zi,s,r,o,a=En,l=En,c,u=Is,d=1){if(u!==Is&&u!==Us)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:d};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Do(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ha=class extends Ds{constructor(e,t=Zi,i=kr,s,r,o=En,a=En,l,c=Is){let u={width:e,height:e,depth:1},d=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ga=class extends li{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Oo=class n extends hn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],d=[],h=0,f=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Wt(c,3)),this.setAttribute("normal",new Wt(u,3)),this.setAttribute("uv",new Wt(d,2));function p(v,m,g,_,M,b,C,R,y,E,U){let N=b/y,L=C/E,O=b/2,z=C/2,D=R/2,W=y+1,q=E+1,H=0,le=0,Z=new G;for(let Q=0;Q<q;Q++){let ie=Q*L-z;for(let de=0;de<W;de++){let he=de*N-O;Z[v]=he*_,Z[m]=ie*M,Z[g]=D,c.push(Z.x,Z.y,Z.z),Z[v]=0,Z[m]=0,Z[g]=R>0?1:-1,u.push(Z.x,Z.y,Z.z),d.push(de/y),d.push(1-Q/E),H+=1}}for(let Q=0;Q<E;Q++)for(let ie=0;ie<y;ie++){let de=h+ie+W*Q,he=h+ie+W*(Q+1),ee=h+(ie+1)+W*(Q+1),me=h+(ie+1)+W*Q;l.push(de,he,me),l.push(he,ee,me),le+=6}a.addGroup(f,le,U),f+=le,h+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var ko=class n extends hn{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],d=[],h=[],f=[],p=0,v=[],m=i/2,g=0;_(),o===!1&&(e>0&&M(!0),t>0&&M(!1)),this.setIndex(u),this.setAttribute("position",new Wt(d,3)),this.setAttribute("normal",new Wt(h,3)),this.setAttribute("uv",new Wt(f,2));function _(){let b=new G,C=new G,R=0,y=(t-e)/i;for(let E=0;E<=r;E++){let U=[],N=E/r,L=N*(t-e)+e;for(let O=0;O<=s;O++){let z=O/s,D=z*l+a,W=Math.sin(D),q=Math.cos(D);C.x=L*W,C.y=-N*i+m,C.z=L*q,d.push(C.x,C.y,C.z),b.set(W,y,q).normalize(),h.push(b.x,b.y,b.z),f.push(z,1-N),U.push(p++)}v.push(U)}for(let E=0;E<s;E++)for(let U=0;U<r;U++){let N=v[U][E],L=v[U+1][E],O=v[U+1][E+1],z=v[U][E+1];(e>0||U!==0)&&(u.push(N,L,z),R+=3),(t>0||U!==r-1)&&(u.push(L,O,z),R+=3)}c.addGroup(g,R,0),g+=R}function M(b){let C=p,R=new vt,y=new G,E=0,U=b===!0?e:t,N=b===!0?1:-1;for(let O=1;O<=s;O++)d.push(0,m*N,0),h.push(0,N,0),f.push(.5,.5),p++;let L=p;for(let O=0;O<=s;O++){let D=O/s*l+a,W=Math.cos(D),q=Math.sin(D);y.x=U*q,y.y=m*N,y.z=U*W,d.push(y.x,y.y,y.z),h.push(0,N,0),R.x=W*.5+.5,R.y=q*.5*N+.5,f.push(R.x,R.y),p++}for(let O=0;O<s;O++){let z=C+O,D=L+O;b===!0?u.push(D,D+1,z):u.push(D+1,D,z),E+=3}c.addGroup(g,E,b===!0?1:2),g+=E}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Dr=class n extends ko{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Fr=class n extends hn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,d=e/a,h=t/l,f=[],p=[],v=[],m=[];for(let g=0;g<u;g++){let _=g*h-o;for(let M=0;M<c;M++){let b=M*d-r;p.push(b,-_,0),v.push(0,0,1),m.push(M/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let _=0;_<a;_++){let M=_+c*g,b=_+c*(g+1),C=_+1+c*(g+1),R=_+1+c*g;f.push(M,b,R),f.push(b,C,R)}this.setIndex(f),this.setAttribute("position",new Wt(p,3)),this.setAttribute("normal",new Wt(v,3)),this.setAttribute("uv",new Wt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Wa=class n extends hn{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],d=new G,h=new G,f=[],p=[],v=[],m=[];for(let g=0;g<=i;g++){let _=[],M=g/i,b=o+M*a,C=e*Math.cos(b),R=Math.sqrt(e*e-C*C),y=0;g===0&&o===0?y=.5/t:g===i&&l===Math.PI&&(y=-.5/t);for(let E=0;E<=t;E++){let U=E/t,N=s+U*r;d.x=-R*Math.cos(N),d.y=C,d.z=R*Math.sin(N),p.push(d.x,d.y,d.z),h.copy(d).normalize(),v.push(h.x,h.y,h.z),m.push(U+y,1-M),_.push(c++)}u.push(_)}for(let g=0;g<i;g++)for(let _=0;_<t;_++){let M=u[g][_+1],b=u[g][_],C=u[g+1][_],R=u[g+1][_+1];(g!==0||o>0)&&f.push(M,b,R),(g!==i-1||l<Math.PI)&&f.push(b,C,R)}this.setIndex(f),this.setAttribute("position",new Wt(p,3)),this.setAttribute("normal",new Wt(v,3)),this.setAttribute("uv",new Wt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function zr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(yx(s))s.isRenderTargetTexture?(Ye("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(yx(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Jn(n){let e={};for(let t=0;t<n.length;t++){let i=zr(n[t]);for(let s in i)e[s]=i[s]}return e}function yx(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Cw(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function lp(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:gt.workingColorSpace}var cv={clone:zr,merge:Jn},Pw=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Iw=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Di=class extends rr{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Pw,this.fragmentShader=Iw,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=zr(e.uniforms),this.uniformsGroups=Cw(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new at().setHex(s.value);break;case"v2":this.uniforms[i].value=new vt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new G().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Kt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new it().fromArray(s.value);break;case"m4":this.uniforms[i].value=new yt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Gc=class extends Di{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Wc=class extends rr{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Jx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Xc=class extends rr{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ao(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Sc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var lr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},$c=class extends lr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ef,endingEnd:Ef}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Tf:r=e,a=2*t-i;break;case Af:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Tf:o=e,l=2*i-t;break;case Af:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,d=this._offsetNext,h=this._weightPrev,f=this._weightNext,p=(i-t)/(s-t),v=p*p,m=v*p,g=-h*m+2*h*v-h*p,_=(1+h)*m+(-1.5-2*h)*v+(-.5+h)*p+1,M=(-1-f)*m+(1.5+f)*v+.5*p,b=f*m-f*v;for(let C=0;C!==a;++C)r[C]=g*o[u+C]+_*o[c+C]+M*o[l+C]+b*o[d+C];return r}},qc=class extends lr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),d=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*d+o[l+h]*u;return r}},Yc=class extends lr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Jc=class extends lr{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,d=this.outTangents;if(!u||!d){let p=(i-t)/(s-t),v=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*v+o[l+m]*p;return r}let h=a*2,f=e-1;for(let p=0;p!==a;++p){let v=o[c+p],m=o[l+p],g=f*h+p*2,_=d[g],M=d[g+1],b=e*h+p*2,C=u[b],R=u[b+1],y=Nw(i,t,_,C,s);r[p]=uv(y,v,M,R,m)}return r}};function uv(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function Lw(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function Nw(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=uv(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=Lw(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Si=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ao(t,this.TimeBufferType),this.values=Ao(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Ao(e.times,Array),values:Ao(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Sc(e.settings)&&(i.settings={inTangents:Ao(e.settings.inTangents,Array),outTangents:Ao(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Yc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new qc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new $c(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Jc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Pa:t=this.InterpolantFactoryMethodDiscrete;break;case Fc:t=this.InterpolantFactoryMethodLinear;break;case Ec:t=this.InterpolantFactoryMethodSmooth;break;case wf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ye("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Pa;case this.InterpolantFactoryMethodLinear:return Fc;case this.InterpolantFactoryMethodSmooth:return Ec;case this.InterpolantFactoryMethodBezier:return wf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Sc(this.settings)&&(bx(this.settings.inTangents,e),bx(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Sc(this.settings)&&(Sx(this.settings.inTangents,e),Sx(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(nt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(nt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){nt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){nt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&aw(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){nt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Ec,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let d=a*i,h=d-i,f=d+i;for(let p=0;p!==i;++p){let v=t[d+p];if(v!==t[h+p]||v!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let d=a*i,h=o*i;for(let f=0;f!==i;++f)t[h+f]=t[d+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Sc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function bx(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function Sx(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Si.prototype.ValueTypeName="";Si.prototype.TimeBufferType=Float32Array;Si.prototype.ValueBufferType=Float32Array;Si.prototype.DefaultInterpolation=Fc;var cr=class extends Si{constructor(e,t,i){super(e,t,i)}};cr.prototype.ValueTypeName="bool";cr.prototype.ValueBufferType=Array;cr.prototype.DefaultInterpolation=Pa;cr.prototype.InterpolantFactoryMethodLinear=void 0;cr.prototype.InterpolantFactoryMethodSmooth=void 0;var Zc=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}};Zc.prototype.ValueTypeName="color";var Kc=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}};Kc.prototype.ValueTypeName="number";var jc=class extends lr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Li.slerpFlat(r,0,o,c-a,o,c,l);return r}},Xa=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new jc(this.times,this.values,this.getValueSize(),e)}};Xa.prototype.ValueTypeName="quaternion";Xa.prototype.InterpolantFactoryMethodSmooth=void 0;var ur=class extends Si{constructor(e,t,i){super(e,t,i)}};ur.prototype.ValueTypeName="string";ur.prototype.ValueBufferType=Array;ur.prototype.DefaultInterpolation=Pa;ur.prototype.InterpolantFactoryMethodLinear=void 0;ur.prototype.InterpolantFactoryMethodSmooth=void 0;var Qc=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}};Qc.prototype.ValueTypeName="vector";var eu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,d){return c.push(u,d),this},this.removeHandler=function(u){let d=c.indexOf(u);return d!==-1&&c.splice(d,2),this},this.getHandler=function(u){for(let d=0,h=c.length;d<h;d+=2){let f=c[d],p=c[d+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},hv=new eu,tu=class{constructor(e){this.manager=e!==void 0?e:hv,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};tu.DEFAULT_MATERIAL_NAME="__DEFAULT";var Mc=new G,wc=new Li,cs=new G,$a=class extends bi{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new yt,this.projectionMatrix=new yt,this.projectionMatrixInverse=new yt,this.coordinateSystem=Ii,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Mc,wc,cs),cs.x===1&&cs.y===1&&cs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Mc,wc,cs.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Mc,wc,cs),cs.x===1&&cs.y===1&&cs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Mc,wc,cs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},nr=new G,Mx=new vt,wx=new vt,si=class extends $a{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Uc*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(tf*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Uc*2*Math.atan(Math.tan(tf*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){nr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(nr.x,nr.y).multiplyScalar(-e/nr.z),nr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(nr.x,nr.y).multiplyScalar(-e/nr.z)}getViewSize(e,t){return this.getViewBounds(e,Mx,wx),t.subVectors(wx,Mx)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(tf*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Bo=class extends $a{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Ji=class extends hn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Ro=-90,Co=1,zo=class extends bi{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new si(Ro,Co,e,t);s.layers=this.layers,this.add(s);let r=new si(Ro,Co,e,t);r.layers=this.layers,this.add(r);let o=new si(Ro,Co,e,t);o.layers=this.layers,this.add(o);let a=new si(Ro,Co,e,t);a.layers=this.layers,this.add(a);let l=new si(Ro,Co,e,t);l.layers=this.layers,this.add(l);let c=new si(Ro,Co,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ii)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Na)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,d=e.getRenderTarget(),h=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let v=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=v,e.setRenderTarget(i,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(d,h,f),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},nu=class extends si{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var cp="\\[\\]\\.:\\/",Dw=new RegExp("["+cp+"]","g"),up="[^"+cp+"]",Fw="[^"+cp.replace("\\.","")+"]",Uw=/((?:WC+[\/:])*)/.source.replace("WC",up),Ow=/(WCOD+)?/.source.replace("WCOD",Fw),kw=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",up),Bw=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",up),zw=new RegExp("^"+Uw+Ow+kw+Bw+"$"),Vw=["material","materials","bones","map"],Rf=class{constructor(e,t,i){let s=i||Zt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Zt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Dw,"")}static parseTrackName(e){let t=zw.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Vw.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ye("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){nt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){nt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){nt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){nt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){nt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;nt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Zt.Composite=Rf;Zt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Zt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Zt.prototype.GetterByBindingType=[Zt.prototype._getValue_direct,Zt.prototype._getValue_array,Zt.prototype._getValue_arrayElement,Zt.prototype._getValue_toArray];Zt.prototype.SetterByBindingTypeAndVersioning=[[Zt.prototype._setValue_direct,Zt.prototype._setValue_direct_setNeedsUpdate,Zt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_array,Zt.prototype._setValue_array_setNeedsUpdate,Zt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_arrayElement,Zt.prototype._setValue_arrayElement_setNeedsUpdate,Zt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_fromArray,Zt.prototype._setValue_fromArray_setNeedsUpdate,Zt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var y3=new Float32Array(1);var Cf=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};function hp(n,e,t,i){let s=Hw(i);switch(t){case Jf:return n*e;case Kf:return n*e/s.components*s.byteLength;case cu:return n*e/s.components*s.byteLength;case hr:return n*e*2/s.components*s.byteLength;case uu:return n*e*2/s.components*s.byteLength;case Zf:return n*e*3/s.components*s.byteLength;case wi:return n*e*4/s.components*s.byteLength;case hu:return n*e*4/s.components*s.byteLength;case Ja:case Za:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Ka:case ja:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case fu:case mu:return Math.max(n,16)*Math.max(e,8)/4;case du:case pu:return Math.max(n,8)*Math.max(e,8)/2;case gu:case xu:case _u:case yu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case vu:case Qa:case bu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Su:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Mu:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case wu:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Eu:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Tu:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Au:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Ru:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Cu:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Pu:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Iu:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Lu:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Nu:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Du:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Fu:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Uu:case Ou:case ku:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Bu:case zu:return Math.ceil(n/4)*Math.ceil(e/4)*8;case el:case Vu:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Hw(n){switch(n){case Mi:case Xf:return{byteLength:1,components:1};case Wo:case $f:case ji:return{byteLength:2,components:1};case au:case lu:return{byteLength:2,components:4};case Zi:case ou:case Ki:return{byteLength:4,components:1};case qf:case Yf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ye("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Nv(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function Ww(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,d=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let u=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,u);else{d.sort((f,p)=>f.start-p.start);let h=0;for(let f=1;f<d.length;f++){let p=d[h],v=d[f];v.start<=p.start+p.count+1?p.count=Math.max(p.count,v.start+v.count-p.start):(++h,d[h]=v)}d.length=h+1;for(let f=0,p=d.length;f<p;f++){let v=d[f];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Xw=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,$w=`#ifdef USE_ALPHAHASH
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
#endif`,qw=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Yw=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Jw=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Zw=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Kw=`#ifdef USE_AOMAP
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
#endif`,jw=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Qw=`#ifdef USE_BATCHING
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
#endif`,e1=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,t1=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,n1=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,i1=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,s1=`#ifdef USE_IRIDESCENCE
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
#endif`,r1=`#ifdef USE_BUMPMAP
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
#endif`,o1=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,a1=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,l1=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,c1=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,u1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,h1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,d1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,f1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,p1=`#define PI 3.141592653589793
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
} // validated`,m1=`vec3 transformedNormal = objectNormal;
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
#endif`,g1=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,x1=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,v1=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,_1=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,y1="gl_FragColor = linearToOutputTexel( gl_FragColor );",b1=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,S1=`#ifdef USE_ENVMAP
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
#endif`,M1=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,w1=`#ifdef USE_ENVMAP
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
#endif`,E1=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,T1=`#ifdef USE_ENVMAP
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
#endif`,A1=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,R1=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,C1=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,P1=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,I1=`#ifdef USE_GRADIENTMAP
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
}`,L1=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,N1=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,D1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,F1=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,U1=`#ifdef USE_ENVMAP
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
#endif`,O1=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,k1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,B1=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,z1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,V1=`PhysicalMaterial material;
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
#endif`,H1=`uniform sampler2D dfgLUT;
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
}`,G1=`
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
#endif`,W1=`#if defined( RE_IndirectDiffuse )
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
#endif`,X1=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,$1=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,q1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Y1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,J1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Z1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,K1=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,j1=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Q1=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,eE=`#if defined( USE_POINTS_UV )
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
#endif`,tE=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,nE=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,iE=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,sE=`#if defined( USE_MORPHCOLORS )
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
#endif`,rE=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,oE=`#ifdef USE_MORPHTARGETS
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
#endif`,aE=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,lE=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,cE=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,uE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,hE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,dE=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,fE=`#ifdef USE_NORMALMAP
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
#endif`,pE=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,mE=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,gE=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,xE=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,vE=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,_E=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,yE=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,bE=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,SE=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,ME=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,wE=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,EE=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,TE=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,AE=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,RE=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,CE=`float getShadowMask() {
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
}`,PE=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,IE=`#ifdef USE_SKINNING
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
#endif`,LE=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,NE=`#ifdef USE_SKINNING
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
#endif`,DE=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,FE=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,UE=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,OE=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,kE=`#ifdef USE_TRANSMISSION
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
#endif`,BE=`#ifdef USE_TRANSMISSION
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
#endif`,zE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,VE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,HE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,GE=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,WE=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,XE=`uniform sampler2D t2D;
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
}`,$E=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,qE=`uniform float backgroundBlurriness;
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
}`,YE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,JE=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ZE=`#include <common>
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
}`,KE=`#if DEPTH_PACKING == 3200
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
}`,jE=`#define DISTANCE
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
}`,QE=`#define DISTANCE
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
}`,eT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,tT=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,nT=`uniform float scale;
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
}`,iT=`uniform vec3 diffuse;
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
}`,sT=`#include <common>
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
}`,rT=`uniform vec3 diffuse;
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
}`,oT=`#define LAMBERT
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
}`,aT=`#define LAMBERT
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
}`,lT=`#define MATCAP
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
}`,cT=`#define MATCAP
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
}`,uT=`#define NORMAL
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
}`,hT=`#define NORMAL
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
}`,dT=`#define PHONG
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
}`,fT=`#define PHONG
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
}`,pT=`#define STANDARD
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
}`,mT=`#define STANDARD
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
}`,gT=`#define TOON
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
}`,xT=`#define TOON
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
}`,vT=`uniform float size;
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
}`,_T=`uniform vec3 diffuse;
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
}`,yT=`#include <common>
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
}`,bT=`uniform vec3 color;
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
}`,ST=`uniform float rotation;
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
}`,MT=`uniform vec3 diffuse;
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
}`,ut={alphahash_fragment:Xw,alphahash_pars_fragment:$w,alphamap_fragment:qw,alphamap_pars_fragment:Yw,alphatest_fragment:Jw,alphatest_pars_fragment:Zw,aomap_fragment:Kw,aomap_pars_fragment:jw,batching_pars_vertex:Qw,batching_vertex:e1,begin_vertex:t1,beginnormal_vertex:n1,bsdfs:i1,iridescence_fragment:s1,bumpmap_pars_fragment:r1,clipping_planes_fragment:o1,clipping_planes_pars_fragment:a1,clipping_planes_pars_vertex:l1,clipping_planes_vertex:c1,color_fragment:u1,color_pars_fragment:h1,color_pars_vertex:d1,color_vertex:f1,common:p1,defaultnormal_vertex:m1,displacementmap_pars_vertex:g1,displacementmap_vertex:x1,emissivemap_fragment:v1,emissivemap_pars_fragment:_1,colorspace_fragment:y1,colorspace_pars_fragment:b1,envmap_fragment:S1,envmap_common_pars_fragment:M1,envmap_pars_fragment:w1,envmap_pars_vertex:E1,envmap_physical_pars_fragment:U1,envmap_vertex:T1,fog_vertex:A1,fog_pars_vertex:R1,fog_fragment:C1,fog_pars_fragment:P1,gradientmap_pars_fragment:I1,lightmap_pars_fragment:L1,lights_lambert_fragment:N1,lights_lambert_pars_fragment:D1,lights_pars_begin:F1,lights_toon_fragment:O1,lights_toon_pars_fragment:k1,lights_phong_fragment:B1,lights_phong_pars_fragment:z1,lights_physical_fragment:V1,lights_physical_pars_fragment:H1,lights_fragment_begin:G1,lights_fragment_maps:W1,lights_fragment_end:X1,lightprobes_pars_fragment:$1,logdepthbuf_fragment:q1,logdepthbuf_pars_fragment:Y1,logdepthbuf_pars_vertex:J1,logdepthbuf_vertex:Z1,map_fragment:K1,map_pars_fragment:j1,map_particle_fragment:Q1,map_particle_pars_fragment:eE,metalnessmap_fragment:tE,metalnessmap_pars_fragment:nE,morphinstance_vertex:iE,morphcolor_vertex:sE,morphnormal_vertex:rE,morphtarget_pars_vertex:oE,morphtarget_vertex:aE,normal_fragment_begin:lE,normal_fragment_maps:cE,normal_pars_fragment:uE,normal_pars_vertex:hE,normal_vertex:dE,normalmap_pars_fragment:fE,clearcoat_normal_fragment_begin:pE,clearcoat_normal_fragment_maps:mE,clearcoat_pars_fragment:gE,iridescence_pars_fragment:xE,opaque_fragment:vE,packing:_E,premultiplied_alpha_fragment:yE,project_vertex:bE,dithering_fragment:SE,dithering_pars_fragment:ME,roughnessmap_fragment:wE,roughnessmap_pars_fragment:EE,shadowmap_pars_fragment:TE,shadowmap_pars_vertex:AE,shadowmap_vertex:RE,shadowmask_pars_fragment:CE,skinbase_vertex:PE,skinning_pars_vertex:IE,skinning_vertex:LE,skinnormal_vertex:NE,specularmap_fragment:DE,specularmap_pars_fragment:FE,tonemapping_fragment:UE,tonemapping_pars_fragment:OE,transmission_fragment:kE,transmission_pars_fragment:BE,uv_pars_fragment:zE,uv_pars_vertex:VE,uv_vertex:HE,worldpos_vertex:GE,background_vert:WE,background_frag:XE,backgroundCube_vert:$E,backgroundCube_frag:qE,cube_vert:YE,cube_frag:JE,depth_vert:ZE,depth_frag:KE,distance_vert:jE,distance_frag:QE,equirect_vert:eT,equirect_frag:tT,linedashed_vert:nT,linedashed_frag:iT,meshbasic_vert:sT,meshbasic_frag:rT,meshlambert_vert:oT,meshlambert_frag:aT,meshmatcap_vert:lT,meshmatcap_frag:cT,meshnormal_vert:uT,meshnormal_frag:hT,meshphong_vert:dT,meshphong_frag:fT,meshphysical_vert:pT,meshphysical_frag:mT,meshtoon_vert:gT,meshtoon_frag:xT,points_vert:vT,points_frag:_T,shadow_vert:yT,shadow_frag:bT,sprite_vert:ST,sprite_frag:MT},Le={common:{diffuse:{value:new at(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new it}},envmap:{envMap:{value:null},envMapRotation:{value:new it},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new it}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new it}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new it},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new it},normalScale:{value:new vt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new it},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new it}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new it}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new it}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new at(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new at(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0},uvTransform:{value:new it}},sprite:{diffuse:{value:new at(16777215)},opacity:{value:1},center:{value:new vt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}}},ps={basic:{uniforms:Jn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:ut.meshbasic_vert,fragmentShader:ut.meshbasic_frag},lambert:{uniforms:Jn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new at(0)},envMapIntensity:{value:1}}]),vertexShader:ut.meshlambert_vert,fragmentShader:ut.meshlambert_frag},phong:{uniforms:Jn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new at(0)},specular:{value:new at(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ut.meshphong_vert,fragmentShader:ut.meshphong_frag},standard:{uniforms:Jn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new at(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ut.meshphysical_vert,fragmentShader:ut.meshphysical_frag},toon:{uniforms:Jn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new at(0)}}]),vertexShader:ut.meshtoon_vert,fragmentShader:ut.meshtoon_frag},matcap:{uniforms:Jn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:ut.meshmatcap_vert,fragmentShader:ut.meshmatcap_frag},points:{uniforms:Jn([Le.points,Le.fog]),vertexShader:ut.points_vert,fragmentShader:ut.points_frag},dashed:{uniforms:Jn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ut.linedashed_vert,fragmentShader:ut.linedashed_frag},depth:{uniforms:Jn([Le.common,Le.displacementmap]),vertexShader:ut.depth_vert,fragmentShader:ut.depth_frag},normal:{uniforms:Jn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:ut.meshnormal_vert,fragmentShader:ut.meshnormal_frag},sprite:{uniforms:Jn([Le.sprite,Le.fog]),vertexShader:ut.sprite_vert,fragmentShader:ut.sprite_frag},background:{uniforms:{uvTransform:{value:new it},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ut.background_vert,fragmentShader:ut.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new it}},vertexShader:ut.backgroundCube_vert,fragmentShader:ut.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ut.cube_vert,fragmentShader:ut.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ut.equirect_vert,fragmentShader:ut.equirect_frag},distance:{uniforms:Jn([Le.common,Le.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ut.distance_vert,fragmentShader:ut.distance_frag},shadow:{uniforms:Jn([Le.lights,Le.fog,{color:{value:new at(0)},opacity:{value:1}}]),vertexShader:ut.shadow_vert,fragmentShader:ut.shadow_frag}};ps.physical={uniforms:Jn([ps.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new it},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new it},clearcoatNormalScale:{value:new vt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new it},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new it},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new it},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new it},sheen:{value:0},sheenColor:{value:new at(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new it},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new it},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new it},transmissionSamplerSize:{value:new vt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new it},attenuationDistance:{value:0},attenuationColor:{value:new at(0)},specularColor:{value:new at(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new it},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new it},anisotropyVector:{value:new vt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new it}}]),vertexShader:ut.meshphysical_vert,fragmentShader:ut.meshphysical_frag};var Gu={r:0,b:0,g:0},wT=new yt,Dv=new it;Dv.set(-1,0,0,0,1,0,0,0,1);function ET(n,e,t,i,s,r){let o=new at(0),a=s===!0?0:1,l,c,u=null,d=0,h=null;function f(_){let M=_.isScene===!0?_.background:null;if(M&&M.isTexture){let b=_.backgroundBlurriness>0;M=e.get(M,b)}return M}function p(_){let M=!1,b=f(_);b===null?m(o,a):b&&b.isColor&&(m(b,1),M=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function v(_,M){let b=f(M);b&&b.isCubeTexture?(c===void 0&&(c=new bt(new Oo(1,1,1),new Di({name:"BackgroundCubeMaterial",uniforms:zr(ps.backgroundCube.uniforms),vertexShader:ps.backgroundCube.vertexShader,fragmentShader:ps.backgroundCube.fragmentShader,side:Xn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,R,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(wT.makeRotationFromEuler(M.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Dv),c.material.toneMapped=gt.getTransfer(b.colorSpace)!==Pt,(u!==b||d!==b.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,d=b.version,h=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new bt(new Fr(2,2),new Di({name:"BackgroundMaterial",uniforms:zr(ps.background.uniforms),vertexShader:ps.background.vertexShader,fragmentShader:ps.background.fragmentShader,side:Fi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=gt.getTransfer(b.colorSpace)!==Pt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||d!==b.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,d=b.version,h=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function m(_,M){_.getRGB(Gu,lp(n)),t.buffers.color.setClear(Gu.r,Gu.g,Gu.b,M,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,M=1){o.set(_),a=M,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,m(o,a)},render:p,addToRenderList:v,dispose:g}}function TT(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(L,O,z,D,W){let q=!1,H=d(L,D,z,O);r!==H&&(r=H,c(r.object)),q=f(L,D,z,W),q&&p(L,D,z,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,b(L,O,z,D),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function d(L,O,z,D){let W=D.wireframe===!0,q=i[O.id];q===void 0&&(q={},i[O.id]=q);let H=L.isInstancedMesh===!0?L.id:0,le=q[H];le===void 0&&(le={},q[H]=le);let Z=le[z.id];Z===void 0&&(Z={},le[z.id]=Z);let Q=Z[W];return Q===void 0&&(Q=h(l()),Z[W]=Q),Q}function h(L){let O=[],z=[],D=[];for(let W=0;W<t;W++)O[W]=0,z[W]=0,D[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:z,attributeDivisors:D,object:L,attributes:{},index:null}}function f(L,O,z,D){let W=r.attributes,q=O.attributes,H=0,le=z.getAttributes();for(let Z in le)if(le[Z].location>=0){let ie=W[Z],de=q[Z];if(de===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(de=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(de=L.instanceColor)),ie===void 0||ie.attribute!==de||de&&ie.data!==de.data)return!0;H++}return r.attributesNum!==H||r.index!==D}function p(L,O,z,D){let W={},q=O.attributes,H=0,le=z.getAttributes();for(let Z in le)if(le[Z].location>=0){let ie=q[Z];ie===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(ie=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(ie=L.instanceColor));let de={};de.attribute=ie,ie&&ie.data&&(de.data=ie.data),W[Z]=de,H++}r.attributes=W,r.attributesNum=H,r.index=D}function v(){let L=r.newAttributes;for(let O=0,z=L.length;O<z;O++)L[O]=0}function m(L){g(L,0)}function g(L,O){let z=r.newAttributes,D=r.enabledAttributes,W=r.attributeDivisors;z[L]=1,D[L]===0&&(n.enableVertexAttribArray(L),D[L]=1),W[L]!==O&&(n.vertexAttribDivisor(L,O),W[L]=O)}function _(){let L=r.newAttributes,O=r.enabledAttributes;for(let z=0,D=O.length;z<D;z++)O[z]!==L[z]&&(n.disableVertexAttribArray(z),O[z]=0)}function M(L,O,z,D,W,q,H){H===!0?n.vertexAttribIPointer(L,O,z,W,q):n.vertexAttribPointer(L,O,z,D,W,q)}function b(L,O,z,D){v();let W=D.attributes,q=z.getAttributes(),H=O.defaultAttributeValues;for(let le in q){let Z=q[le];if(Z.location>=0){let Q=W[le];if(Q===void 0&&(le==="instanceMatrix"&&L.instanceMatrix&&(Q=L.instanceMatrix),le==="instanceColor"&&L.instanceColor&&(Q=L.instanceColor)),Q!==void 0){let ie=Q.normalized,de=Q.itemSize,he=e.get(Q);if(he===void 0)continue;let ee=he.buffer,me=he.type,ge=he.bytesPerElement,Me=me===n.INT||me===n.UNSIGNED_INT||Q.gpuType===ou;if(Q.isInterleavedBufferAttribute){let ve=Q.data,Ve=ve.isInterleavedBuffer===!0?ve.stride:ve.itemSize,$e=Q.offset;if(ve.isInstancedInterleavedBuffer||ve.isInstancedBufferAttribute){for(let Fe=0;Fe<Z.locationSize;Fe++)g(Z.location+Fe,ve.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=ve.meshPerAttribute*ve.count)}else for(let Fe=0;Fe<Z.locationSize;Fe++)m(Z.location+Fe);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Fe=0;Fe<Z.locationSize;Fe++)M(Z.location+Fe,de/Z.locationSize,me,ie,Ve*ge,($e+de/Z.locationSize*Fe)*ge,Me)}else{if(Q.isInstancedBufferAttribute){for(let ve=0;ve<Z.locationSize;ve++)g(Z.location+ve,Q.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let ve=0;ve<Z.locationSize;ve++)m(Z.location+ve);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let ve=0;ve<Z.locationSize;ve++)M(Z.location+ve,de/Z.locationSize,me,ie,de*ge,de/Z.locationSize*ve*ge,Me)}}else if(H!==void 0){let ie=H[le];if(ie!==void 0)switch(ie.length){case 2:n.vertexAttrib2fv(Z.location,ie);break;case 3:n.vertexAttrib3fv(Z.location,ie);break;case 4:n.vertexAttrib4fv(Z.location,ie);break;default:n.vertexAttrib1fv(Z.location,ie)}}}}_()}function C(){U();for(let L in i){let O=i[L];for(let z in O){let D=O[z];for(let W in D){let q=D[W];for(let H in q)u(q[H].object),delete q[H];delete D[W]}}delete i[L]}}function R(L){if(i[L.id]===void 0)return;let O=i[L.id];for(let z in O){let D=O[z];for(let W in D){let q=D[W];for(let H in q)u(q[H].object),delete q[H];delete D[W]}}delete i[L.id]}function y(L){for(let O in i){let z=i[O];for(let D in z){let W=z[D];if(W[L.id]===void 0)continue;let q=W[L.id];for(let H in q)u(q[H].object),delete q[H];delete W[L.id]}}}function E(L){for(let O in i){let z=i[O],D=L.isInstancedMesh===!0?L.id:0,W=z[D];if(W!==void 0){for(let q in W){let H=W[q];for(let le in H)u(H[le].object),delete H[le];delete W[q]}delete z[D],Object.keys(z).length===0&&delete i[O]}}}function U(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:N,dispose:C,releaseStatesOfGeometry:R,releaseStatesOfObject:E,releaseStatesOfProgram:y,initAttributes:v,enableAttribute:m,disableUnusedAttributes:_}}function AT(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let f=0;f<u;f++)h+=c[f];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function RT(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==wi&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let E=y===ji&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==Mi&&y!==Ki&&!E&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ye("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&Ye("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&Ye("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),M=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),R=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:p,maxTextureSize:v,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:_,maxVaryings:M,maxFragmentUniforms:b,maxSamples:C,samples:R}}function CT(n){let e=this,t=null,i=0,s=!1,r=!1,o=new qi,a=new it,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,h){let f=d.length!==0||h||i!==0||s;return s=h,i=d.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,h){t=u(d,h,0)},this.setState=function(d,h,f){let p=d.clippingPlanes,v=d.clipIntersection,m=d.clipShadows,g=n.get(d);if(!s||p===null||p.length===0||r&&!m)r?u(null):c();else{let _=r?0:i,M=_*4,b=g.clippingState||null;l.value=b,b=u(p,h,M,f);for(let C=0;C!==M;++C)b[C]=t[C];g.clippingState=b,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(d,h,f,p){let v=d!==null?d.length:0,m=null;if(v!==0){if(m=l.value,p!==!0||m===null){let g=f+v*4,_=h.matrixWorldInverse;a.getNormalMatrix(_),(m===null||m.length<g)&&(m=new Float32Array(g));for(let M=0,b=f;M!==v;++M,b+=4)o.copy(d[M]).applyMatrix4(_,a),o.normal.toArray(m,b),m[b+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,m}}var rl=class extends yi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Va(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Oo(5,5,5),r=new Di({name:"CubemapFromEquirect",uniforms:zr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Xn,blending:Ur});r.uniforms.tEquirect.value=t;let o=new bt(s,r),a=t.minFilter;return t.minFilter===Fs&&(t.minFilter=Wn),new zo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},dv=256,PT=3,IT=20,Fv=256,Uv=16,LT=3,NT=new G,DT=new at,Xu=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new zo(1,10,null),this._boxMesh=new bt(new Oo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=NT}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,h=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(DT));let m=new zo(i,s,u);return m.position.copy(a),m.update(l,e),l.autoClear=d,l.autoClearColor=h,l.autoClearDepth=f,l.autoClearStencil=p,e.background=v,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=mv(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=pv(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(dv,av(e))}_fromTexture(e,t){e.mapping===kr||e.mapping===Go?this._setSize(e.image.length===0?dv:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=fv(e,!1,!1),i=Math.log2(e)-PT;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=fv(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===kr||e.mapping===Go?(this._cubemapMaterial===null&&(this._cubemapMaterial=mv()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=pv()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=FT(),this._integrationMaterial=UT());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Uv);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-LT)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Fv*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=OT());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function fv(n,e,t){return new rl(n,{minFilter:Fs,generateMipmaps:e,type:ji,colorSpace:Ia,depthBuffer:t})}function ol(n,e,t){return new Di({name:n,uniforms:e,vertexShader:ut.cube_vert,fragmentShader:t,side:Xn,blending:Ur,depthTest:!1,depthWrite:!1})}function FT(){return ol("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Fv}u

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
	`)}function UT(){return ol("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Uv}},`

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
	`)}function OT(){return ol("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${IT}
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
	`)}function pv(){return ol("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function mv(){return ol("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function kT(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,f=!1){return h==null?null:f?o(h):r(h)}function r(h){if(h&&h.isTexture){let f=h.mapping;if(f===iu||f===su)if(e.has(h)){let p=e.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let v=new rl(p.height);return v.fromEquirectangularTexture(n,h),e.set(h,v),h.addEventListener("dispose",c),a(v.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let f=h.mapping,p=f===iu||f===su,v=f===kr||f===Go;if(p||v){let m=t.get(h),g=m!==void 0?m.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==g)return i===null&&(i=new Xu(n)),m=p?i.fromEquirectangular(h,m):i.fromCubemap(h,m),m.texture.pmremVersion=h.pmremVersion,t.set(h,m),m.texture;if(m!==void 0)return m.texture;{let _=h.image;return p&&_&&_.height>0||v&&_&&l(_)?(i===null&&(i=new Xu(n)),m=p?i.fromEquirectangular(h):i.fromCubemap(h),m.texture.pmremVersion=h.pmremVersion,t.set(h,m),h.addEventListener("dispose",u),m.texture):null}}}return h}function a(h,f){return f===iu?h.mapping=kr:f===su&&(h.mapping=Go),h}function l(h){let f=0,p=6;for(let v=0;v<p;v++)h[v]!==void 0&&f++;return f===p}function c(h){let f=h.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(h){let f=h.target;f.removeEventListener("dispose",u);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function d(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function BT(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Ca("WebGLRenderer: "+i+" extension not supported."),s}}}function zT(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let v=r.get(p);v&&(e.remove(v),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function u(p){let v=p.attributes;for(let m in v)e.update(v[m],n.ARRAY_BUFFER)}function d(p){let v=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let _=v!==null?v.array.length:m.array.length/3-1,M=m.count>=65535?Ba:ka,b=new M(Math.ceil(_/3)*6,1),C=b.array;if(v!==null){let y=v.array;g=v.version;for(let E=0,U=0;E<_;E+=3){let N=y[E+0],L=y[E+1],O=y[E+2];C[U++]=N,C[U++]=L,C[U++]=L,C[U++]=O,C[U++]=O,C[U++]=N}}else{g=m.version;for(let y=0,E=0;y<_;y+=3){let U=y+0,N=y+1,L=y+2;C[E++]=U,C[E++]=N,C[E++]=N,C[E++]=L,C[E++]=L,C[E++]=U}}b.version=g;let R=r.get(p);R&&e.remove(R),r.set(p,b)}function h(p){let v=r.get(p);if(v){let m=p.index;m!==null&&v.version<m.version&&d(p)}else d(p);return r.get(p)}function f(){for(let p in s){let v=s[p].deref();v!==void 0&&l(v)}}return{get:c,update:u,getWireframeAttribute:h,dispose:f}}function VT(n,e,t){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,h){n.drawElements(i,h,r,d*o),t.update(h,i,1)}function c(d,h,f){f!==0&&(n.drawElementsInstanced(i,h,r,d*o,f),t.update(h,i,f))}function u(d,h,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,d,0,f);let v=0;for(let m=0;m<f;m++)v+=h[m];t.update(v,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function HT(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:nt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function GT(n,e,t){let i=new WeakMap,s=new Kt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==d){let U=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",U)};h!==void 0&&h.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],M=0;f===!0&&(M=1),p===!0&&(M=2),v===!0&&(M=3);let b=a.attributes.position.count*M,C=1;b>e.maxTextureSize&&(C=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let R=new Float32Array(b*C*4*d),y=new Fa(R,b,C,d);y.type=Ki,y.needsUpdate=!0;let E=M*4;for(let N=0;N<d;N++){let L=m[N],O=g[N],z=_[N],D=b*C*4*N;for(let W=0;W<L.count;W++){let q=W*E;f===!0&&(s.fromBufferAttribute(L,W),R[D+q+0]=s.x,R[D+q+1]=s.y,R[D+q+2]=s.z,R[D+q+3]=0),p===!0&&(s.fromBufferAttribute(O,W),R[D+q+4]=s.x,R[D+q+5]=s.y,R[D+q+6]=s.z,R[D+q+7]=0),v===!0&&(s.fromBufferAttribute(z,W),R[D+q+8]=s.x,R[D+q+9]=s.y,R[D+q+10]=s.z,R[D+q+11]=z.itemSize===4?s.w:1)}}h={count:d,texture:y,size:new vt(b,C)},i.set(a,h),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function WT(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,d=c.geometry,h=e.get(c,d);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var XT={[Of]:"LINEAR_TONE_MAPPING",[kf]:"REINHARD_TONE_MAPPING",[Bf]:"CINEON_TONE_MAPPING",[zf]:"ACES_FILMIC_TONE_MAPPING",[Hf]:"AGX_TONE_MAPPING",[Gf]:"NEUTRAL_TONE_MAPPING",[Vf]:"CUSTOM_TONE_MAPPING"};function $T(n,e,t,i,s,r){let o=new yi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new hn;u.setAttribute("position",new Wt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Wt([0,2,0,0,2,0],2));let d=new Gc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new bt(u,d),f=new Bo(-1,1,1,-1,0,1),p=null,v=null,m=!1,g,_=null,M=[],b=!1;this.setSize=function(C,R){o.setSize(C,R),a!==null&&a.setSize(C,R),l!==null&&l.setSize(C,R);for(let y=0;y<M.length;y++){let E=M[y];E.setSize&&E.setSize(C,R)}},this.setEffects=function(C){M=C,b=M.length>0&&M[0].isRenderPass===!0;let R=o.width,y=o.height;M.length>0&&a===null&&(a=new yi(R,y,{type:ji,depthBuffer:!1,stencilBuffer:!1}),l=new yi(R,y,{type:ji,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&M.some(U=>U.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new Ds(R,y),r===!0&&(c.format=Us,c.type=Br)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let U=0;U<M.length;U++){let N=M[U];N.setSize&&N.setSize(R,y),E&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(C,R){if(m||C.toneMapping===ds&&M.length===0)return!1;if(_=R,R!==null){let y=R.width,E=R.height;(o.width!==y||o.height!==E)&&this.setSize(y,E)}return b===!1&&C.setRenderTarget(o),g=C.toneMapping,C.toneMapping=ds,!0},this.hasRenderPass=function(){return b},this.end=function(C,R){C.toneMapping=g,m=!0;let y=o,E=a;for(let U=0;U<M.length;U++){let N=M[U];N.enabled!==!1&&(N.render(C,E,y,R),N.needsSwap!==!1&&(y=E,E=E===a?l:a))}if(p!==C.outputColorSpace||v!==C.toneMapping){p=C.outputColorSpace,v=C.toneMapping,d.defines={},gt.getTransfer(p)===Pt&&(d.defines.SRGB_TRANSFER="");let U=XT[v];U&&(d.defines[U]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=y.texture,C.setRenderTarget(_),C.render(h,f),_=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),d.dispose()}}var Ov=new li,kv=new Ds(1,1),Bv=new Ha(1),zv=new Fa,Vv=new Bc,Hv=new Va,gv=[],xv=[],vv=new Float32Array(16),_v=new Float32Array(9),yv=new Float32Array(4);function $o(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=gv[s];if(r===void 0&&(r=new Float32Array(s),gv[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Ln(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Nn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function qu(n,e){let t=xv[e];t===void 0&&(t=new Int32Array(e),xv[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function qT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function YT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ln(t,e))return;n.uniform2fv(this.addr,e),Nn(t,e)}}function JT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Ln(t,e))return;n.uniform3fv(this.addr,e),Nn(t,e)}}function ZT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ln(t,e))return;n.uniform4fv(this.addr,e),Nn(t,e)}}function KT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ln(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Nn(t,e)}else{if(Ln(t,i))return;yv.set(i),n.uniformMatrix2fv(this.addr,!1,yv),Nn(t,i)}}function jT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ln(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Nn(t,e)}else{if(Ln(t,i))return;_v.set(i),n.uniformMatrix3fv(this.addr,!1,_v),Nn(t,i)}}function QT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ln(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Nn(t,e)}else{if(Ln(t,i))return;vv.set(i),n.uniformMatrix4fv(this.addr,!1,vv),Nn(t,i)}}function eA(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function tA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ln(t,e))return;n.uniform2iv(this.addr,e),Nn(t,e)}}function nA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ln(t,e))return;n.uniform3iv(this.addr,e),Nn(t,e)}}function iA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ln(t,e))return;n.uniform4iv(this.addr,e),Nn(t,e)}}function sA(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function rA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ln(t,e))return;n.uniform2uiv(this.addr,e),Nn(t,e)}}function oA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ln(t,e))return;n.uniform3uiv(this.addr,e),Nn(t,e)}}function aA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ln(t,e))return;n.uniform4uiv(this.addr,e),Nn(t,e)}}function Yu(n){return n.version===0&&(n.compareFunction=sp,n.needsUpdate=!0),n}function lA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Yu(kv):r=Ov,t.setTexture2D(e||r,s)}function cA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||Vv,s)}function uA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Yu(Bv):r=Hv,t.setTextureCube(e||r,s)}function hA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||zv,s)}function dA(n){switch(n){case 5126:return qT;case 35664:return YT;case 35665:return JT;case 35666:return ZT;case 35674:return KT;case 35675:return jT;case 35676:return QT;case 5124:case 35670:return eA;case 35667:case 35671:return tA;case 35668:case 35672:return nA;case 35669:case 35673:return iA;case 5125:return sA;case 36294:return rA;case 36295:return oA;case 36296:return aA;case 35678:case 36198:case 36298:case 36306:case 35682:return lA;case 35679:case 36299:case 36307:return cA;case 35680:case 36300:case 36308:case 36293:return uA;case 36289:case 36303:case 36311:case 36292:return hA}}function fA(n,e){n.uniform1fv(this.addr,e)}function pA(n,e){let t=$o(e,this.size,2);n.uniform2fv(this.addr,t)}function mA(n,e){let t=$o(e,this.size,3);n.uniform3fv(this.addr,t)}function gA(n,e){let t=$o(e,this.size,4);n.uniform4fv(this.addr,t)}function xA(n,e){let t=$o(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function vA(n,e){let t=$o(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function _A(n,e){let t=$o(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function yA(n,e){n.uniform1iv(this.addr,e)}function bA(n,e){n.uniform2iv(this.addr,e)}function SA(n,e){n.uniform3iv(this.addr,e)}function MA(n,e){n.uniform4iv(this.addr,e)}function wA(n,e){n.uniform1uiv(this.addr,e)}function EA(n,e){n.uniform2uiv(this.addr,e)}function TA(n,e){n.uniform3uiv(this.addr,e)}function AA(n,e){n.uniform4uiv(this.addr,e)}function RA(n,e,t){let i=this.cache,s=e.length,r=qu(t,s);Ln(i,r)||(n.uniform1iv(this.addr,r),Nn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Yu(kv):o=Ov;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function CA(n,e,t){let i=this.cache,s=e.length,r=qu(t,s);Ln(i,r)||(n.uniform1iv(this.addr,r),Nn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Vv,r[o])}function PA(n,e,t){let i=this.cache,s=e.length,r=qu(t,s);Ln(i,r)||(n.uniform1iv(this.addr,r),Nn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Yu(Bv):o=Hv;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function IA(n,e,t){let i=this.cache,s=e.length,r=qu(t,s);Ln(i,r)||(n.uniform1iv(this.addr,r),Nn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||zv,r[o])}function LA(n){switch(n){case 5126:return fA;case 35664:return pA;case 35665:return mA;case 35666:return gA;case 35674:return xA;case 35675:return vA;case 35676:return _A;case 5124:case 35670:return yA;case 35667:case 35671:return bA;case 35668:case 35672:return SA;case 35669:case 35673:return MA;case 5125:return wA;case 36294:return EA;case 36295:return TA;case 36296:return AA;case 35678:case 36198:case 36298:case 36306:case 35682:return RA;case 35679:case 36299:case 36307:return CA;case 35680:case 36300:case 36308:case 36293:return PA;case 36289:case 36303:case 36311:case 36292:return IA}}var pp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=dA(t.type)}},mp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=LA(t.type)}},gp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},dp=/(\w+)(\])?(\[|\.)?/g;function bv(n,e){n.seq.push(e),n.map[e.id]=e}function NA(n,e,t){let i=n.name,s=i.length;for(dp.lastIndex=0;;){let r=dp.exec(i),o=dp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){bv(t,c===void 0?new pp(a,n,e):new mp(a,n,e));break}else{let d=t.map[a];d===void 0&&(d=new gp(a),bv(t,d)),t=d}}}var Xo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);NA(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function Sv(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var DA=37297,FA=0;function UA(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Mv=new it;function OA(n){gt._getMatrix(Mv,gt.workingColorSpace,n);let e=`mat3( ${Mv.elements.map(t=>t.toFixed(4))} )`;switch(gt.getTransfer(n)){case La:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return Ye("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function wv(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+UA(n.getShaderSource(e),a)}else return r}function kA(n,e){let t=OA(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var BA={[Of]:"Linear",[kf]:"Reinhard",[Bf]:"Cineon",[zf]:"ACESFilmic",[Hf]:"AgX",[Gf]:"Neutral",[Vf]:"Custom"};function zA(n,e){let t=BA[e];return t===void 0?(Ye("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Wu=new G;function VA(){gt.getLuminanceCoefficients(Wu);let n=Wu.x.toFixed(4),e=Wu.y.toFixed(4),t=Wu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function HA(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(sl).join(`
`)}function GA(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function WA(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function sl(n){return n!==""}function Ev(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Tv(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var XA=/^[ \t]*#include +<([\w\d./]+)>/gm;function xp(n){return n.replace(XA,$A)}function $A(n,e){let t=ut[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return xp(t)}var qA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Av(n){return n.replace(qA,YA)}function YA(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Rv(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var JA={[qa]:"SHADOWMAP_TYPE_PCF",[Vo]:"SHADOWMAP_TYPE_VSM"};function ZA(n){return JA[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var KA={[Go]:"ENVMAP_MODE_REFRACTION"};function jA(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":KA[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var QA={[Uf]:"ENVMAP_BLENDING_MULTIPLY",[$x]:"ENVMAP_BLENDING_MIX",[qx]:"ENVMAP_BLENDING_ADD"};function eR(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":QA[n.combine]||"ENVMAP_BLENDING_NONE"}function tR(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=ZA(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=jA(t),d=eR(t),h=HA(t),f=GA(r),p=s.createProgram(),v,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(sl).join(`
`),v.length>0&&(v+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(sl).join(`
`),m.length>0&&(m+=`
`)):(v=[Rv(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(sl).join(`
`),m=[Rv(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ds?"#define TONE_MAPPING":"",t.toneMapping!==ds?ut.tonemapping_pars_fragment:"",t.toneMapping!==ds?zA("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ut.colorspace_pars_fragment,kA("linearToOutputTexel",t.outputColorSpace),VA(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(sl).join(`
`)),o=xp(o),o=Ev(o,t),o=Tv(o,t),a=xp(a),a=Ev(a,t),a=Tv(a,t),o=Av(o),a=Av(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,v=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,m=["#define varying in",t.glslVersion===rp?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===rp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let _=g+v+o,M=g+m+a,b=Sv(s,s.VERTEX_SHADER,_),C=Sv(s,s.FRAGMENT_SHADER,M);s.attachShader(p,b),s.attachShader(p,C),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function R(N){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",O=s.getShaderInfoLog(b)||"",z=s.getShaderInfoLog(C)||"",D=L.trim(),W=O.trim(),q=z.trim(),H=!0,le=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,b,C);else{let Z=wv(s,b,"vertex"),Q=wv(s,C,"fragment");nt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+D+`
`+Z+`
`+Q)}else D!==""?Ye("WebGLProgram: Program Info Log:",D):(W===""||q==="")&&(le=!1);le&&(N.diagnostics={runnable:H,programLog:D,vertexShader:{log:W,prefix:v},fragmentShader:{log:q,prefix:m}})}s.deleteShader(b),s.deleteShader(C),y=new Xo(s,p),E=WA(s,p)}let y;this.getUniforms=function(){return y===void 0&&R(this),y};let E;this.getAttributes=function(){return E===void 0&&R(this),E};let U=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(p,DA)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=FA++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=C,this}var nR=0,vp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new _p(e),t.set(e,i)),i}},_p=class{constructor(e){this.id=nR++,this.code=e,this.usedTimes=0}};function iR(n){return n===hr||n===Qa||n===el}function sR(n,e,t,i,s,r){let o=new Ua,a=new vp,l=new Set,c=[],u=new Map,d=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,E,U,N,L,O){let z=N.fog,D=L.geometry,W=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?N.environment:null,q=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,H=e.get(y.envMap||W,q),le=h[y.type],Z=i.precision;y.precision!==null&&(Z=i.getMaxPrecision(y.precision),Z!==y.precision&&Ye("WebGLProgram.getParameters:",y.precision,"not supported, using",Z,"instead."));let Q=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,ie=Q!==void 0?Q.length:0,de=0;D.morphAttributes.position!==void 0&&(de=1),D.morphAttributes.normal!==void 0&&(de=2),D.morphAttributes.color!==void 0&&(de=3);let he,ee,me,ge;if(le){let Re=ps[le];he=Re.vertexShader,ee=Re.fragmentShader}else{he=y.vertexShader,ee=y.fragmentShader;let Re=a.getVertexShaderStage(y),ot=a.getFragmentShaderStage(y);a.update(y,Re,ot),me=Re.id,ge=ot.id}let Me=n.getRenderTarget(),ve=n.state.buffers.depth.getReversed(),Ve=L.isInstancedMesh===!0,$e=L.isBatchedMesh===!0,Fe=!!y.map,Ze=!!y.matcap,Je=!!H,je=Je&&H.isPMREMTexture===!0,Bt=!!y.aoMap,It=!!y.lightMap,mn=!!y.bumpMap&&y.wireframe===!1,Ot=!!y.normalMap,Dn=!!y.displacementMap,_t=!!y.emissiveMap,Rn=!!y.metalnessMap,on=!!y.roughnessMap,gn=y.anisotropy>0,B=y.clearcoat>0,Ce=y.diffuseRoughness>0,qe=y.dispersion>0,rt=y.retroreflectivity>0,we=y.iridescence>0,zt=y.sheen>0,He=y.transmission>0,Xe=gn&&!!y.anisotropyMap,P=B&&!!y.clearcoatMap,w=B&&!!y.clearcoatNormalMap,$=B&&!!y.clearcoatRoughnessMap,ue=Ce&&!!y.diffuseRoughnessMap,oe=we&&!!y.iridescenceMap,_e=we&&!!y.iridescenceThicknessMap,ye=zt&&!!y.sheenColorMap,te=zt&&!!y.sheenRoughnessMap,se=!!y.specularMap,pe=!!y.specularColorMap,k=!!y.specularIntensityMap,re=He&&!!y.transmissionMap,ne=He&&!!y.thicknessMap,Ee=!!y.gradientMap,xe=!!y.alphaMap,Se=y.alphaTest>0,Ge=!!y.alphaHash,Qe=!!y.extensions,ce=ds;y.toneMapped&&(Me===null||Me.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ke=je?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,et={shaderID:le,shaderType:y.type,shaderName:y.name,vertexShader:he,fragmentShader:ee,defines:y.defines,customVertexShaderID:me,customFragmentShaderID:ge,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:Z,batching:$e,batchingColor:$e&&L._colorsTexture!==null,instancing:Ve,instancingColor:Ve&&L.instanceColor!==null,instancingMorph:Ve&&L.morphTexture!==null,outputColorSpace:Me===null?n.outputColorSpace:Me.isXRRenderTarget===!0?Me.texture.colorSpace:gt.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Fe,matcap:Ze,envMap:Je,envMapMode:Je&&H.mapping,envMapPMREM:je,envMapMaxLod:je?ke.length-1:null,envMapSize:je?ke[0].width:null,aoMap:Bt,lightMap:It,bumpMap:mn,normalMap:Ot,displacementMap:Dn,emissiveMap:_t,normalMapObjectSpace:Ot&&y.normalMapType===Zx,normalMapTangentSpace:Ot&&y.normalMapType===jf,packedNormalMap:Ot&&y.normalMapType===jf&&iR(y.normalMap.format),metalnessMap:Rn,roughnessMap:on,anisotropy:gn,anisotropyMap:Xe,clearcoat:B,clearcoatMap:P,clearcoatNormalMap:w,clearcoatRoughnessMap:$,diffuseRoughness:Ce,diffuseRoughnessMap:ue,dispersion:qe,retroreflection:rt,iridescence:we,iridescenceMap:oe,iridescenceThicknessMap:_e,sheen:zt,sheenColorMap:ye,sheenRoughnessMap:te,specularMap:se,specularColorMap:pe,specularIntensityMap:k,transmission:He,transmissionMap:re,thicknessMap:ne,gradientMap:Ee,opaque:y.transparent===!1&&y.blending===Ho&&y.alphaToCoverage===!1,alphaMap:xe,alphaTest:Se,alphaHash:Ge,combine:y.combine,mapUv:Fe&&f(y.map.channel),aoMapUv:Bt&&f(y.aoMap.channel),lightMapUv:It&&f(y.lightMap.channel),bumpMapUv:mn&&f(y.bumpMap.channel),normalMapUv:Ot&&f(y.normalMap.channel),displacementMapUv:Dn&&f(y.displacementMap.channel),emissiveMapUv:_t&&f(y.emissiveMap.channel),metalnessMapUv:Rn&&f(y.metalnessMap.channel),roughnessMapUv:on&&f(y.roughnessMap.channel),anisotropyMapUv:Xe&&f(y.anisotropyMap.channel),clearcoatMapUv:P&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:w&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(y.sheenRoughnessMap.channel),specularMapUv:se&&f(y.specularMap.channel),specularColorMapUv:pe&&f(y.specularColorMap.channel),specularIntensityMapUv:k&&f(y.specularIntensityMap.channel),transmissionMapUv:re&&f(y.transmissionMap.channel),thicknessMapUv:ne&&f(y.thicknessMap.channel),alphaMapUv:xe&&f(y.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Ot||gn),vertexNormals:!!D.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!D.attributes.uv&&(Fe||xe),fog:!!z,useFog:y.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||D.attributes.normal===void 0&&Ot===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:ve,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:de,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:O.filter(Re=>Re.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:Fe&&y.map.isVideoTexture===!0&&gt.getTransfer(y.map.colorSpace)===Pt,decodeVideoTextureEmissive:_t&&y.emissiveMap.isVideoTexture===!0&&gt.getTransfer(y.emissiveMap.colorSpace)===Pt,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===zn,flipSided:y.side===Xn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Qe&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qe&&y.extensions.multiDraw===!0||$e)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return et.vertexUv1s=l.has(1),et.vertexUv2s=l.has(2),et.vertexUv3s=l.has(3),l.clear(),et}function v(y){let E=[];if(y.shaderID?E.push(y.shaderID):(E.push(y.customVertexShaderID),E.push(y.customFragmentShaderID)),y.defines!==void 0)for(let U in y.defines)E.push(U),E.push(y.defines[U]);return y.isRawShaderMaterial===!1&&(m(E,y),g(E,y),E.push(n.outputColorSpace)),E.push(y.customProgramCacheKey),E.join()}function m(y,E){y.push(E.precision),y.push(E.outputColorSpace),y.push(E.envMapMode),y.push(E.envMapPMREM),y.push(E.envMapMaxLod),y.push(E.envMapSize),y.push(E.mapUv),y.push(E.alphaMapUv),y.push(E.lightMapUv),y.push(E.aoMapUv),y.push(E.bumpMapUv),y.push(E.normalMapUv),y.push(E.displacementMapUv),y.push(E.emissiveMapUv),y.push(E.metalnessMapUv),y.push(E.roughnessMapUv),y.push(E.anisotropyMapUv),y.push(E.clearcoatMapUv),y.push(E.clearcoatNormalMapUv),y.push(E.clearcoatRoughnessMapUv),y.push(E.diffuseRoughnessMapUv),y.push(E.iridescenceMapUv),y.push(E.iridescenceThicknessMapUv),y.push(E.sheenColorMapUv),y.push(E.sheenRoughnessMapUv),y.push(E.specularMapUv),y.push(E.specularColorMapUv),y.push(E.specularIntensityMapUv),y.push(E.transmissionMapUv),y.push(E.thicknessMapUv),y.push(E.combine),y.push(E.fogExp2),y.push(E.sizeAttenuation),y.push(E.morphTargetsCount),y.push(E.numSunLights),y.push(E.numDirLights),y.push(E.numPointLights),y.push(E.numSpotLights),y.push(E.numSpotLightMaps),y.push(E.numHemiLights),y.push(E.numRectAreaLights),y.push(E.numSunLightShadows),y.push(E.numDirLightShadows),y.push(E.numPointLightShadows),y.push(E.numSpotLightShadows),y.push(E.numSpotLightShadowsWithMaps),y.push(E.numLightProbes),y.push(E.numLightProbeGrids),y.push(E.shadowMapType),y.push(E.toneMapping),y.push(E.numClippingPlanes),y.push(E.numClipIntersection),y.push(E.depthPacking)}function g(y,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function _(y){let E=h[y.type],U;if(E){let N=ps[E];U=cv.clone(N.uniforms)}else U=y.uniforms;return U}function M(y,E){let U=u.get(E);return U!==void 0?++U.usedTimes:(U=new tR(n,E,y,s),c.push(U),u.set(E,U)),U}function b(y){if(--y.usedTimes===0){let E=c.indexOf(y);c[E]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function C(y){a.remove(y)}function R(){a.dispose()}return{getParameters:p,getProgramCacheKey:v,getUniforms:_,acquireProgram:M,releaseProgram:b,releaseShaderCache:C,programs:c,dispose:R}}function rR(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function oR(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Cv(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Pv(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let f=0;return h.isInstancedMesh&&(f+=2),h.isSkinnedMesh&&(f+=1),f}function a(h,f,p,v,m,g){let _=n[e];return _===void 0?(_={id:h.id,object:h,geometry:f,material:p,materialVariant:o(h),groupOrder:v,renderOrder:h.renderOrder,z:m,group:g},n[e]=_):(_.id=h.id,_.object=h,_.geometry=f,_.material=p,_.materialVariant=o(h),_.groupOrder=v,_.renderOrder=h.renderOrder,_.z=m,_.group=g),e++,_}function l(h,f,p,v,m,g,_){_.reversedDepth===!0&&(m=-m);let M=a(h,f,p,v,m,g);p.transmission>0?i.push(M):p.transparent===!0?s.push(M):t.push(M)}function c(h,f,p,v,m,g){let _=a(h,f,p,v,m,g);p.transmission>0?i.unshift(_):p.transparent===!0?s.unshift(_):t.unshift(_)}function u(h,f){t.length>1&&t.sort(h||oR),i.length>1&&i.sort(f||Cv),s.length>1&&s.sort(f||Cv)}function d(){for(let h=e,f=n.length;h<f;h++){let p=n[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:u}}function aR(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Pv,n.set(i,[o])):s>=r.length?(o=new Pv,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function lR(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new G,color:new at};break;case"SpotLight":t={position:new G,direction:new G,color:new at,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new G,color:new at,distance:0,decay:0};break;case"HemisphereLight":t={direction:new G,skyColor:new at,groundColor:new at};break;case"RectAreaLight":t={color:new at,position:new G,halfWidth:new G,halfHeight:new G};break}return n[e.id]=t,t}}}function cR(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new vt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new vt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new vt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var uR=0;function hR(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function dR(n){let e=new lR,t=cR(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new G);let s=new G,r=new yt,o=new yt;function a(c){let u=0,d=0,h=0;for(let O=0;O<9;O++)i.probe[O].set(0,0,0);let f=0,p=0,v=0,m=0,g=0,_=0,M=0,b=0,C=0,R=0,y=0,E=0,U=0,N=0;c.sort(hR);for(let O=0,z=c.length;O<z;O++){let D=c[O],W=D.color,q=D.intensity,H=D.distance,le=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===hr?le=D.shadow.map.texture:le=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)u+=W.r*q,d+=W.g*q,h+=W.b*q;else if(D.isLightProbe){for(let Z=0;Z<9;Z++)i.probe[Z].addScaledVector(D.sh.coefficients[Z],q);N++}else if(D.isSunLight){let Z=e.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,ie=t.get(D);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=ie,i.sunShadowMap[p]=le;let de=Q.getViewportCount();for(let he=0;he<de;he++)i.sunShadowMatrix[v+he]=Q.getMatrix(he),i.sunShadowCascade[v+he]=Q._cascadeData[he];v+=de,p++}i.sun[f]=Z,f++}else if(D.isDirectionalLight){let Z=e.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,ie=t.get(D);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.directionalShadow[m]=ie,i.directionalShadowMap[m]=le,i.directionalShadowMatrix[m]=D.shadow.matrix,C++}i.directional[m]=Z,m++}else if(D.isSpotLight){let Z=e.get(D);Z.position.setFromMatrixPosition(D.matrixWorld),Z.color.copy(W).multiplyScalar(q),Z.distance=H,Z.coneCos=Math.cos(D.angle),Z.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),Z.decay=D.decay,i.spot[_]=Z;let Q=D.shadow;if(D.map&&(i.spotLightMap[E]=D.map,E++,Q.updateMatrices(D),D.castShadow&&U++),i.spotLightMatrix[_]=Q.matrix,D.castShadow){let ie=t.get(D);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.spotShadow[_]=ie,i.spotShadowMap[_]=le,y++}_++}else if(D.isRectAreaLight){let Z=e.get(D);Z.color.copy(W).multiplyScalar(q),Z.halfWidth.set(D.width*.5,0,0),Z.halfHeight.set(0,D.height*.5,0),i.rectArea[M]=Z,M++}else if(D.isPointLight){let Z=e.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),Z.distance=D.distance,Z.decay=D.decay,D.castShadow){let Q=D.shadow,ie=t.get(D);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,i.pointShadow[g]=ie,i.pointShadowMap[g]=le,i.pointShadowMatrix[g]=D.shadow.matrix,R++}i.point[g]=Z,g++}else if(D.isHemisphereLight){let Z=e.get(D);Z.skyColor.copy(D.color).multiplyScalar(q),Z.groundColor.copy(D.groundColor).multiplyScalar(q),i.hemi[b]=Z,b++}}M>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=d,i.ambient[2]=h;let L=i.hash;(L.sunLength!==f||L.directionalLength!==m||L.pointLength!==g||L.spotLength!==_||L.rectAreaLength!==M||L.hemiLength!==b||L.numSunShadows!==p||L.numDirectionalShadows!==C||L.numPointShadows!==R||L.numSpotShadows!==y||L.numSpotMaps!==E||L.numLightProbes!==N)&&(i.sun.length=f,i.directional.length=m,i.spot.length=_,i.rectArea.length=M,i.point.length=g,i.hemi.length=b,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=v,i.sunShadowCascade.length=v,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=R,i.pointShadowMap.length=R,i.pointShadowMatrix.length=R,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+E-U,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=N,L.sunLength=f,L.directionalLength=m,L.pointLength=g,L.spotLength=_,L.rectAreaLength=M,L.hemiLength=b,L.numSunShadows=p,L.numDirectionalShadows=C,L.numPointShadows=R,L.numSpotShadows=y,L.numSpotMaps=E,L.numLightProbes=N,i.version=uR++)}function l(c,u){let d=0,h=0,f=0,p=0,v=0,m=0,g=u.matrixWorldInverse;for(let _=0,M=c.length;_<M;_++){let b=c[_];if(b.isSunLight){let C=i.sun[d];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(g),d++}else if(b.isDirectionalLight){let C=i.directional[h];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),h++}else if(b.isSpotLight){let C=i.spot[p];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),p++}else if(b.isRectAreaLight){let C=i.rectArea[v];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),o.identity(),r.copy(b.matrixWorld),r.premultiply(g),o.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),v++}else if(b.isPointLight){let C=i.point[f];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let C=i.hemi[m];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function Iv(n){let e=new dR(n),t=[],i=[],s=[];function r(d){u.camera=d,t.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):t.push(d)}function a(d){i.push(d)}function l(){e.setup(t),s.sort((d,h)=>d.priority-h.priority||d.id-h.id)}function c(d){e.setupView(t,d)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function fR(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Iv(n),e.set(s,[a])):r>=o.length?(a=new Iv(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var pR=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,mR=`uniform sampler2D shadow_pass;
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
}`,gR=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],xR=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],Lv=new yt,il=new G,fp=new G;function vR(n,e,t){let i=new Ns,s=new vt,r=new vt,o=new Kt,a=new Wc,l=new Xc,c={},u=t.maxTextureSize,d={[Fi]:Xn,[Xn]:Fi,[zn]:zn},h=new Di({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new vt},radius:{value:4}},vertexShader:pR,fragmentShader:mR}),f=h.clone();f.defines.HORIZONTAL_PASS=1;let p=new hn;p.setAttribute("position",new St(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new bt(p,h),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=qa;let g=this.type;this.render=function(R,y,E){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||R.length===0)return;this.type===Ax&&(Ye("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=qa);let U=n.getRenderTarget(),N=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),O=n.state;O.setBlending(Ur),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let z=g!==this.type;z&&y.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(W=>W.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,W=R.length;D<W;D++){let q=R[D],H=q.shadow;if(H===void 0){Ye("WebGLShadowMap:",q,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let le=H.getFrameExtents();s.multiply(le),r.copy(H.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,H.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,H.mapSize.y=r.y));let Z=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=Z,H.map===null||z===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===Vo){if(q.isPointLight){Ye("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new yi(s.x,s.y,{format:hr,type:ji,minFilter:Wn,magFilter:Wn,generateMipmaps:!1}),H.map.texture.name=q.name+".shadowMap",H.map.depthTexture=new Ds(s.x,s.y,Ki),H.map.depthTexture.name=q.name+".shadowMapDepth",H.map.depthTexture.format=Is,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=En,H.map.depthTexture.magFilter=En}else q.isPointLight?(H.map=new rl(s.x),H.map.depthTexture=new Ha(s.x,Zi)):(H.map=new yi(s.x,s.y),H.map.depthTexture=new Ds(s.x,s.y,Zi)),H.map.depthTexture.name=q.name+".shadowMap",H.map.depthTexture.format=Is,this.type===qa?(H.map.depthTexture.compareFunction=Z?ip:np,H.map.depthTexture.minFilter=Wn,H.map.depthTexture.magFilter=Wn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=En,H.map.depthTexture.magFilter=En);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();q.isPointLight!==!0&&H.updateMatrices(q,E);let ie=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:E.layers;for(let de=0;de<Q;de++){let he=H.getCamera(de);if(q.isPointLight){let ee=H.camera,me=H.matrix,ge=q.distance||ee.far;ge!==ee.far&&(ee.far=ge,ee.updateProjectionMatrix()),il.setFromMatrixPosition(q.matrixWorld),ee.position.copy(il),fp.copy(ee.position),fp.add(gR[de]),ee.up.copy(xR[de]),ee.lookAt(fp),ee.updateMatrixWorld(),me.makeTranslation(-il.x,-il.y,-il.z),Lv.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Lv,ee.coordinateSystem,ee.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,de),n.clear();else{de===0&&(n.setRenderTarget(H.map),n.clear());let ee=H.getViewport(de);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),O.viewport(o)}i=H.getFrustum(de),b(y,E,he,q,ie,this.type)}H.isPointLightShadow!==!0&&this.type===Vo&&_(H,E),H.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(U,N,L)};function _(R,y){let E=e.update(v);h.defines.VSM_SAMPLES!==R.blurSamples&&(h.defines.VSM_SAMPLES=R.blurSamples,f.defines.VSM_SAMPLES=R.blurSamples,h.needsUpdate=!0,f.needsUpdate=!0),R.mapPass===null?R.mapPass=new yi(s.x,s.y,{format:hr,type:ji}):(R.mapPass.width!==R.map.width||R.mapPass.height!==R.map.height)&&R.mapPass.setSize(R.map.width,R.map.height),h.uniforms.shadow_pass.value=R.map.depthTexture,h.uniforms.resolution.value.set(R.map.width,R.map.height),h.uniforms.radius.value=R.radius,n.setRenderTarget(R.mapPass),n.clear(),n.renderBufferDirect(y,null,E,h,v,null),f.uniforms.shadow_pass.value=R.mapPass.texture,f.uniforms.resolution.value.set(R.map.width,R.map.height),f.uniforms.radius.value=R.radius,n.setRenderTarget(R.map),n.clear(),n.renderBufferDirect(y,null,E,f,v,null)}function M(R,y,E,U){let N=null,L=E.isPointLight===!0?R.customDistanceMaterial:R.customDepthMaterial;if(L!==void 0)N=L;else if(N=E.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let O=N.uuid,z=y.uuid,D=c[O];D===void 0&&(D={},c[O]=D);let W=D[z];W===void 0&&(W=N.clone(),D[z]=W,y.addEventListener("dispose",C)),N=W}if(N.visible=y.visible,N.wireframe=y.wireframe,U===Vo?N.side=y.shadowSide!==null?y.shadowSide:y.side:N.side=y.shadowSide!==null?y.shadowSide:d[y.side],N.alphaMap=y.alphaMap,N.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,N.map=y.map,N.clipShadows=y.clipShadows,N.clippingPlanes=y.clippingPlanes,N.clipIntersection=y.clipIntersection,N.displacementMap=y.displacementMap,N.displacementScale=y.displacementScale,N.displacementBias=y.displacementBias,N.wireframeLinewidth=y.wireframeLinewidth,N.linewidth=y.linewidth,E.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let O=n.properties.get(N);O.light=E}return N}function b(R,y,E,U,N,L){if(R.visible===!1)return;if(R.layers.test(N)&&(R.isMesh||R.isLine||R.isPoints)&&(R.castShadow||R.receiveShadow&&L===Vo)&&(!R.frustumCulled||R.intersectsFrustum(i))){R.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,R.matrixWorld);let D=e.update(R),W=R.material;if(Array.isArray(W)){let q=D.groups;for(let H=0,le=q.length;H<le;H++){let Z=q[H],Q=W[Z.materialIndex];if(Q&&Q.visible){let ie=M(R,Q,U,L);R.onBeforeShadow(n,R,y,E,D,ie,Z),n.renderBufferDirect(E,null,D,ie,R,Z),R.onAfterShadow(n,R,y,E,D,ie,Z)}}}else if(W.visible){let q=M(R,W,U,L);R.onBeforeShadow(n,R,y,E,D,q,null),n.renderBufferDirect(E,null,D,q,R,null),R.onAfterShadow(n,R,y,E,D,q,null)}}let z=R.children;for(let D=0,W=z.length;D<W;D++)b(z[D],y,E,U,N,L)}function C(R){R.target.removeEventListener("dispose",C);for(let E in c){let U=c[E],N=R.target.uuid;N in U&&(U[N].dispose(),delete U[N])}}}function _R(n,e){function t(){let k=!1,re=new Kt,ne=null,Ee=new Kt(0,0,0,0);return{setMask:function(xe){ne!==xe&&!k&&(n.colorMask(xe,xe,xe,xe),ne=xe)},setLocked:function(xe){k=xe},setClear:function(xe,Se,Ge,Qe,ce){ce===!0&&(xe*=Qe,Se*=Qe,Ge*=Qe),re.set(xe,Se,Ge,Qe),Ee.equals(re)===!1&&(n.clearColor(xe,Se,Ge,Qe),Ee.copy(re))},reset:function(){k=!1,ne=null,Ee.set(-1,0,0,0)}}}function i(){let k=!1,re=!1,ne=null,Ee=null,xe=null;return{setReversed:function(Se){if(re!==Se){let Ge=e.get("EXT_clip_control");Se?Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.ZERO_TO_ONE_EXT):Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.NEGATIVE_ONE_TO_ONE_EXT),re=Se;let Qe=xe;xe=null,this.setClear(Qe)}},getReversed:function(){return re},setTest:function(Se){Se?ve(n.DEPTH_TEST):Ve(n.DEPTH_TEST)},setMask:function(Se){ne!==Se&&!k&&(n.depthMask(Se),ne=Se)},setFunc:function(Se){if(re&&(Se=ov[Se]),Ee!==Se){switch(Se){case Ac:n.depthFunc(n.NEVER);break;case Rc:n.depthFunc(n.ALWAYS);break;case Cc:n.depthFunc(n.LESS);break;case Io:n.depthFunc(n.LEQUAL);break;case Pc:n.depthFunc(n.EQUAL);break;case Ic:n.depthFunc(n.GEQUAL);break;case Lo:n.depthFunc(n.GREATER);break;case Lc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ee=Se}},setLocked:function(Se){k=Se},setClear:function(Se){xe!==Se&&(xe=Se,re&&(Se=1-Se),n.clearDepth(Se))},reset:function(){k=!1,ne=null,Ee=null,xe=null,re=!1}}}function s(){let k=!1,re=null,ne=null,Ee=null,xe=null,Se=null,Ge=null,Qe=null,ce=null;return{setTest:function(ke){k||(ke?ve(n.STENCIL_TEST):Ve(n.STENCIL_TEST))},setMask:function(ke){re!==ke&&!k&&(n.stencilMask(ke),re=ke)},setFunc:function(ke,et,Re){(ne!==ke||Ee!==et||xe!==Re)&&(n.stencilFunc(ke,et,Re),ne=ke,Ee=et,xe=Re)},setOp:function(ke,et,Re){(Se!==ke||Ge!==et||Qe!==Re)&&(n.stencilOp(ke,et,Re),Se=ke,Ge=et,Qe=Re)},setLocked:function(ke){k=ke},setClear:function(ke){ce!==ke&&(n.clearStencil(ke),ce=ke)},reset:function(){k=!1,re=null,ne=null,Ee=null,xe=null,Se=null,Ge=null,Qe=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},d={},h={},f=new WeakMap,p=[],v=null,m=!1,g=null,_=null,M=null,b=null,C=null,R=null,y=null,E=new at(0,0,0),U=0,N=!1,L=null,O=null,z=null,D=null,W=null,q=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,le=0,Z=n.getParameter(n.VERSION);Z.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(Z)[1]),H=le>=1):Z.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),H=le>=2);let Q=null,ie={},de=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),ee=new Kt().fromArray(de),me=new Kt().fromArray(he);function ge(k,re,ne,Ee){let xe=new Uint8Array(4),Se=n.createTexture();n.bindTexture(k,Se),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ge=0;Ge<ne;Ge++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,Ee,0,n.RGBA,n.UNSIGNED_BYTE,xe):n.texImage2D(re+Ge,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xe);return Se}let Me={};Me[n.TEXTURE_2D]=ge(n.TEXTURE_2D,n.TEXTURE_2D,1),Me[n.TEXTURE_CUBE_MAP]=ge(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Me[n.TEXTURE_2D_ARRAY]=ge(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Me[n.TEXTURE_3D]=ge(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ve(n.DEPTH_TEST),o.setFunc(Io),mn(!1),Ot(Pf),ve(n.CULL_FACE),Bt(Ur);function ve(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function Ve(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function $e(k,re){return h[k]!==re?(n.bindFramebuffer(k,re),h[k]=re,k===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=re),k===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Fe(k,re){let ne=p,Ee=!1;if(k){ne=f.get(re),ne===void 0&&(ne=[],f.set(re,ne));let xe=k.textures;if(ne.length!==xe.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,Ge=xe.length;Se<Ge;Se++)ne[Se]=n.COLOR_ATTACHMENT0+Se;ne.length=xe.length,Ee=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,Ee=!0);Ee&&n.drawBuffers(ne)}function Ze(k){return v!==k?(n.useProgram(k),v=k,!0):!1}let Je={[Or]:n.FUNC_ADD,[Cx]:n.FUNC_SUBTRACT,[Px]:n.FUNC_REVERSE_SUBTRACT};Je[Ix]=n.MIN,Je[Lx]=n.MAX;let je={[Nx]:n.ZERO,[Dx]:n.ONE,[Fx]:n.SRC_COLOR,[Df]:n.SRC_ALPHA,[Vx]:n.SRC_ALPHA_SATURATE,[Bx]:n.DST_COLOR,[Ox]:n.DST_ALPHA,[Ux]:n.ONE_MINUS_SRC_COLOR,[Ff]:n.ONE_MINUS_SRC_ALPHA,[zx]:n.ONE_MINUS_DST_COLOR,[kx]:n.ONE_MINUS_DST_ALPHA,[Hx]:n.CONSTANT_COLOR,[Gx]:n.ONE_MINUS_CONSTANT_COLOR,[Wx]:n.CONSTANT_ALPHA,[Xx]:n.ONE_MINUS_CONSTANT_ALPHA};function Bt(k,re,ne,Ee,xe,Se,Ge,Qe,ce,ke){if(k===Ur){m===!0&&(Ve(n.BLEND),m=!1);return}if(m===!1&&(ve(n.BLEND),m=!0),k!==Rx){if(k!==g||ke!==N){if((_!==Or||C!==Or)&&(n.blendEquation(n.FUNC_ADD),_=Or,C=Or),ke)switch(k){case Ho:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case If:n.blendFunc(n.ONE,n.ONE);break;case Lf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Nf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:nt("WebGLState: Invalid blending: ",k);break}else switch(k){case Ho:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case If:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Lf:nt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Nf:nt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:nt("WebGLState: Invalid blending: ",k);break}M=null,b=null,R=null,y=null,E.set(0,0,0),U=0,g=k,N=ke}return}xe=xe||re,Se=Se||ne,Ge=Ge||Ee,(re!==_||xe!==C)&&(n.blendEquationSeparate(Je[re],Je[xe]),_=re,C=xe),(ne!==M||Ee!==b||Se!==R||Ge!==y)&&(n.blendFuncSeparate(je[ne],je[Ee],je[Se],je[Ge]),M=ne,b=Ee,R=Se,y=Ge),(Qe.equals(E)===!1||ce!==U)&&(n.blendColor(Qe.r,Qe.g,Qe.b,ce),E.copy(Qe),U=ce),g=k,N=!1}function It(k,re){k.side===zn?Ve(n.CULL_FACE):ve(n.CULL_FACE);let ne=k.side===Xn;re&&(ne=!ne),mn(ne),k.blending===Ho&&k.transparent===!1?Bt(Ur):Bt(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Ee=k.stencilWrite;a.setTest(Ee),Ee&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),_t(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?ve(n.SAMPLE_ALPHA_TO_COVERAGE):Ve(n.SAMPLE_ALPHA_TO_COVERAGE)}function mn(k){L!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),L=k)}function Ot(k){k!==Ex?(ve(n.CULL_FACE),k!==O&&(k===Pf?n.cullFace(n.BACK):k===Tx?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ve(n.CULL_FACE),O=k}function Dn(k){k!==z&&(H&&n.lineWidth(k),z=k)}function _t(k,re,ne){k?(ve(n.POLYGON_OFFSET_FILL),(D!==re||W!==ne)&&(D=re,W=ne,o.getReversed()&&(re=-re,ne=-ne),n.polygonOffset(re,ne))):Ve(n.POLYGON_OFFSET_FILL)}function Rn(k){k?ve(n.SCISSOR_TEST):Ve(n.SCISSOR_TEST)}function on(k){k===void 0&&(k=n.TEXTURE0+q-1),Q!==k&&(n.activeTexture(k),Q=k)}function gn(k,re,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+q-1:ne=Q);let Ee=ie[ne];Ee===void 0&&(Ee={type:void 0,texture:void 0},ie[ne]=Ee),(Ee.type!==k||Ee.texture!==re)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(k,re||Me[k]),Ee.type=k,Ee.texture=re)}function B(){let k=ie[Q];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Ce(){try{n.compressedTexImage2D(...arguments)}catch(k){nt("WebGLState:",k)}}function qe(){try{n.compressedTexImage3D(...arguments)}catch(k){nt("WebGLState:",k)}}function rt(){try{n.texSubImage2D(...arguments)}catch(k){nt("WebGLState:",k)}}function we(){try{n.texSubImage3D(...arguments)}catch(k){nt("WebGLState:",k)}}function zt(){try{n.compressedTexSubImage2D(...arguments)}catch(k){nt("WebGLState:",k)}}function He(){try{n.compressedTexSubImage3D(...arguments)}catch(k){nt("WebGLState:",k)}}function Xe(){try{n.texStorage2D(...arguments)}catch(k){nt("WebGLState:",k)}}function P(){try{n.texStorage3D(...arguments)}catch(k){nt("WebGLState:",k)}}function w(){try{n.texImage2D(...arguments)}catch(k){nt("WebGLState:",k)}}function $(){try{n.texImage3D(...arguments)}catch(k){nt("WebGLState:",k)}}function ue(k){return d[k]!==void 0?d[k]:n.getParameter(k)}function oe(k,re){d[k]!==re&&(n.pixelStorei(k,re),d[k]=re)}function _e(k){ee.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),ee.copy(k))}function ye(k){me.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),me.copy(k))}function te(k,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let Ee=ne.get(k);Ee===void 0&&(Ee=n.getUniformBlockIndex(re,k.name),n.uniformBlockBinding(re,Ee,Ee),ne.set(k,Ee))}function se(k,re,ne){let xe=c.get(re).get(k);l[xe]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,xe,ne),l[xe]=ne)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},d={},Q=null,ie={},h={},l={},f=new WeakMap,p=[],v=null,m=!1,g=null,_=null,M=null,b=null,C=null,R=null,y=null,E=new at(0,0,0),U=0,N=!1,L=null,O=null,z=null,D=null,W=null,ee.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ve,disable:Ve,bindFramebuffer:$e,drawBuffers:Fe,useProgram:Ze,setBlending:Bt,setMaterial:It,setFlipSided:mn,setCullFace:Ot,setLineWidth:Dn,setPolygonOffset:_t,setScissorTest:Rn,activeTexture:on,bindTexture:gn,unbindTexture:B,compressedTexImage2D:Ce,compressedTexImage3D:qe,texImage2D:w,texImage3D:$,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:Xe,texStorage3D:P,texSubImage2D:rt,texSubImage3D:we,compressedTexSubImage2D:zt,compressedTexSubImage3D:He,scissor:_e,viewport:ye,reset:pe}}function yR(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new vt,u=new WeakMap,d=new Set,h,f=new WeakMap,p=new Set,v=new FinalizationRegistry(P=>p.delete(P)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(P,w){return m?new OffscreenCanvas(P,w):Da("canvas")}function _(P,w,$){let ue=1,oe=Xe(P);if((oe.width>$||oe.height>$)&&(ue=$/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let _e=Math.floor(ue*oe.width),ye=Math.floor(ue*oe.height);h===void 0&&(h=g(_e,ye));let te=w?g(_e,ye):h;return te.width=_e,te.height=ye,te.getContext("2d").drawImage(P,0,0,_e,ye),Ye("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+_e+"x"+ye+")."),te}else return"data"in P&&Ye("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),P;return P}function M(P){return P.generateMipmaps}function b(P){n.generateMipmap(P)}function C(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function R(P,w,$,ue,oe,_e=!1){if(P!==null){if(n[P]!==void 0)return n[P];Ye("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||Ye("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=w;if(w===n.RED&&($===n.FLOAT&&(te=n.R32F),$===n.HALF_FLOAT&&(te=n.R16F),$===n.UNSIGNED_BYTE&&(te=n.R8),$===n.UNSIGNED_SHORT&&ye&&(te=ye.R16_EXT),$===n.SHORT&&ye&&(te=ye.R16_SNORM_EXT)),w===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(te=n.R8UI),$===n.UNSIGNED_SHORT&&(te=n.R16UI),$===n.UNSIGNED_INT&&(te=n.R32UI),$===n.BYTE&&(te=n.R8I),$===n.SHORT&&(te=n.R16I),$===n.INT&&(te=n.R32I)),w===n.RG&&($===n.FLOAT&&(te=n.RG32F),$===n.HALF_FLOAT&&(te=n.RG16F),$===n.UNSIGNED_BYTE&&(te=n.RG8),$===n.UNSIGNED_SHORT&&ye&&(te=ye.RG16_EXT),$===n.SHORT&&ye&&(te=ye.RG16_SNORM_EXT)),w===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(te=n.RG8UI),$===n.UNSIGNED_SHORT&&(te=n.RG16UI),$===n.UNSIGNED_INT&&(te=n.RG32UI),$===n.BYTE&&(te=n.RG8I),$===n.SHORT&&(te=n.RG16I),$===n.INT&&(te=n.RG32I)),w===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(te=n.RGB8UI),$===n.UNSIGNED_SHORT&&(te=n.RGB16UI),$===n.UNSIGNED_INT&&(te=n.RGB32UI),$===n.BYTE&&(te=n.RGB8I),$===n.SHORT&&(te=n.RGB16I),$===n.INT&&(te=n.RGB32I)),w===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),$===n.UNSIGNED_INT&&(te=n.RGBA32UI),$===n.BYTE&&(te=n.RGBA8I),$===n.SHORT&&(te=n.RGBA16I),$===n.INT&&(te=n.RGBA32I)),w===n.RGB&&($===n.UNSIGNED_SHORT&&ye&&(te=ye.RGB16_EXT),$===n.SHORT&&ye&&(te=ye.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),w===n.RGBA){let se=_e?La:gt.getTransfer(oe);$===n.FLOAT&&(te=n.RGBA32F),$===n.HALF_FLOAT&&(te=n.RGBA16F),$===n.UNSIGNED_BYTE&&(te=se===Pt?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&ye&&(te=ye.RGBA16_EXT),$===n.SHORT&&ye&&(te=ye.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function y(P,w){let $;return P?w===null||w===Zi||w===Br?$=n.DEPTH24_STENCIL8:w===Ki?$=n.DEPTH32F_STENCIL8:w===Wo&&($=n.DEPTH24_STENCIL8,Ye("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Zi||w===Br?$=n.DEPTH_COMPONENT24:w===Ki?$=n.DEPTH_COMPONENT32F:w===Wo&&($=n.DEPTH_COMPONENT16),$}function E(P,w){return M(P)===!0||P.isFramebufferTexture&&P.minFilter!==En&&P.minFilter!==Wn?Math.log2(Math.max(w.width,w.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?w.mipmaps.length:1}function U(P){let w=new WeakRef(P);i.get(P).__ref=w,p.add(w),v.register(P,w,w)}function N(P){let w=i.get(P).__ref;w!==void 0&&(p.delete(w),v.unregister(w))}function L(P){z(P.target)}function O(P){D(P.target)}function z(P){P.removeEventListener("dispose",L),N(P),q(P),P.isVideoTexture&&u.delete(P),P.isHTMLTexture&&d.delete(P)}function D(P){P.removeEventListener("dispose",O),N(P),le(P)}function W(){for(let P of p){let w=P.deref();w!==void 0&&(w.isRenderTarget===!0?D(w):z(w))}p.clear(),d.clear()}function q(P){let w=i.get(P);if(w.__webglInit===void 0)return;let $=P.source,ue=f.get($);if(ue){let oe=ue[w.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&H(P),Object.keys(ue).length===0&&f.delete($)}i.remove(P)}function H(P){let w=i.get(P);n.deleteTexture(w.__webglTexture);let $=P.source,ue=f.get($);delete ue[w.__cacheKey],o.memory.textures--}function le(P){let w=i.get(P);w.__depthDisposeCallback&&w.__depthDisposeCallback();let $=P.depthTexture;if($&&$.renderTarget===P&&z($),P.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(w.__webglFramebuffer[oe]))for(let _e=0;_e<w.__webglFramebuffer[oe].length;_e++)n.deleteFramebuffer(w.__webglFramebuffer[oe][_e]);else n.deleteFramebuffer(w.__webglFramebuffer[oe]);w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer[oe])}else{if(Array.isArray(w.__webglFramebuffer))for(let oe=0;oe<w.__webglFramebuffer.length;oe++)n.deleteFramebuffer(w.__webglFramebuffer[oe]);else n.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&n.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let oe=0;oe<w.__webglColorRenderbuffer.length;oe++)w.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(w.__webglColorRenderbuffer[oe]);w.__webglDepthRenderbuffer&&n.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let ue=P.textures;for(let oe=0,_e=ue.length;oe<_e;oe++){let ye=i.get(ue[oe]);ye.__webglTexture&&(n.deleteTexture(ye.__webglTexture),o.memory.textures--),i.remove(ue[oe])}i.remove(P)}let Z=0;function Q(){Z=0}function ie(){return Z}function de(P){Z=P}function he(){let P=Z;return P>=s.maxTextures&&Ye("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,P}function ee(P){let w=[];return w.push(P.wrapS),w.push(P.wrapT),w.push(P.wrapR||0),w.push(P.magFilter),w.push(P.minFilter),w.push(P.anisotropy),w.push(P.internalFormat),w.push(P.format),w.push(P.type),w.push(P.generateMipmaps),w.push(P.mipmapsAutoUpdate),w.push(P.premultiplyAlpha),w.push(P.flipY),w.push(P.unpackAlignment),w.push(P.colorSpace),w.join()}function me(P,w){let $=i.get(P);if(P.isVideoTexture&&zt(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&$.__version!==P.version){let ue=P.image;if(ue===null)Ye("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Ye("WebGLRenderer: Texture marked for update but image is incomplete");else{It($,P,w);return}}else P.isExternalTexture&&($.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+w)}function ge(P,w){let $=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&$.__version!==P.version){It($,P,w);return}else P.isExternalTexture&&($.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+w)}function Me(P,w){let $=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&$.__version!==P.version){It($,P,w);return}t.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+w)}function ve(P,w){let $=i.get(P);if(P.version>0&&$.__version!==P.version){mn($,P,w);return}t.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+w)}let Ve={[Nc]:n.REPEAT,[us]:n.CLAMP_TO_EDGE,[Dc]:n.MIRRORED_REPEAT},$e={[En]:n.NEAREST,[Yx]:n.NEAREST_MIPMAP_NEAREST,[Ya]:n.NEAREST_MIPMAP_LINEAR,[Wn]:n.LINEAR,[ru]:n.LINEAR_MIPMAP_NEAREST,[Fs]:n.LINEAR_MIPMAP_LINEAR},Fe={[Kx]:n.NEVER,[sp]:n.ALWAYS,[jx]:n.LESS,[np]:n.LEQUAL,[Qx]:n.EQUAL,[ip]:n.GEQUAL,[ev]:n.GREATER,[tv]:n.NOTEQUAL};function Ze(P,w){if(w.type===Ki&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===Wn||w.magFilter===ru||w.magFilter===Ya||w.magFilter===Fs||w.minFilter===Wn||w.minFilter===ru||w.minFilter===Ya||w.minFilter===Fs)&&Ye("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,Ve[w.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,Ve[w.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,Ve[w.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,$e[w.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,$e[w.minFilter]),w.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,Fe[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===En||w.minFilter!==Ya&&w.minFilter!==Fs||w.type===Ki&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||i.get(w).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");n.texParameterf(P,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),i.get(w).__currentAnisotropy=w.anisotropy}}}function Je(P,w){let $=!1;P.__webglInit===void 0&&(P.__webglInit=!0,w.addEventListener("dispose",L),U(w));let ue=w.source,oe=f.get(ue);oe===void 0&&(oe={},f.set(ue,oe));let _e=ee(w);if(_e!==P.__cacheKey){oe[_e]===void 0&&(oe[_e]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,$=!0),oe[_e].usedTimes++;let ye=oe[P.__cacheKey];ye!==void 0&&(oe[P.__cacheKey].usedTimes--,ye.usedTimes===0&&H(w)),P.__cacheKey=_e,P.__webglTexture=oe[_e].texture}return $}function je(P,w,$){return Math.floor(Math.floor(P/$)/w)}function Bt(P,w,$,ue){let _e=P.updateRanges;if(_e.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,w.width,w.height,$,ue,w.data);else{_e.sort((k,re)=>k.start-re.start);let ye=0;for(let k=1;k<_e.length;k++){let re=_e[ye],ne=_e[k],Ee=re.start+re.count,xe=je(ne.start,w.width,4),Se=je(re.start,w.width,4);ne.start<=Ee+1&&xe===Se&&je(ne.start+ne.count-1,w.width,4)===xe?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++ye,_e[ye]=ne)}_e.length=ye+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),se=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,w.width);for(let k=0,re=_e.length;k<re;k++){let ne=_e[k],Ee=Math.floor(ne.start/4),xe=Math.ceil(ne.count/4),Se=Ee%w.width,Ge=Math.floor(Ee/w.width),Qe=xe,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,Ge),t.texSubImage2D(n.TEXTURE_2D,0,Se,Ge,Qe,ce,$,ue,w.data)}P.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,se),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function It(P,w,$){let ue=n.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),w.isData3DTexture&&(ue=n.TEXTURE_3D);let oe=Je(P,w),_e=w.source;t.bindTexture(ue,P.__webglTexture,n.TEXTURE0+$);let ye=i.get(_e);if(_e.version!==ye.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let ce=gt.getPrimaries(gt.workingColorSpace),ke=w.colorSpace===Os?null:gt.getPrimaries(w.colorSpace),et=w.colorSpace===Os||ce===ke?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,et)}t.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment);let se=_(w.image,!1,s.maxTextureSize);se=He(w,se);let pe=r.convert(w.format,w.colorSpace),k=r.convert(w.type),re=R(w.internalFormat,pe,k,w.normalized,w.colorSpace,w.isVideoTexture);Ze(ue,w);let ne,Ee=w.mipmaps,xe=w.isVideoTexture!==!0,Se=ye.__version===void 0||oe===!0,Ge=_e.dataReady,Qe=E(w,se);if(w.isDepthTexture)re=y(w.format===Us,w.type),Se&&(xe?t.texStorage2D(n.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,k,null));else if(w.isDataTexture)if(Ee.length>0){xe&&Se&&t.texStorage2D(n.TEXTURE_2D,Qe,re,Ee[0].width,Ee[0].height);for(let ce=0,ke=Ee.length;ce<ke;ce++)ne=Ee[ce],xe?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,k,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,k,ne.data);w.generateMipmaps=!1}else xe?(Se&&t.texStorage2D(n.TEXTURE_2D,Qe,re,se.width,se.height),Ge&&Bt(w,se,pe,k)):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,k,se.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){xe&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Qe,re,Ee[0].width,Ee[0].height,se.depth);for(let ce=0,ke=Ee.length;ce<ke;ce++)if(ne=Ee[ce],w.format!==wi)if(pe!==null)if(xe){if(Ge)if(w.layerUpdates.size>0){let et=hp(ne.width,ne.height,w.format,w.type);for(let Re of w.layerUpdates){let ot=ne.data.subarray(Re*et/ne.data.BYTES_PER_ELEMENT,(Re+1)*et/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Re,ne.width,ne.height,1,pe,ot)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,ne.data,0,0);else Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?Ge&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,k,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,pe,k,ne.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{xe&&Se&&t.texStorage2D(n.TEXTURE_2D,Qe,re,Ee[0].width,Ee[0].height);for(let ce=0,ke=Ee.length;ce<ke;ce++)ne=Ee[ce],w.format!==wi?pe!==null?xe?Ge&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,k,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,k,ne.data)}else if(w.isDataArrayTexture)if(xe){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Qe,re,se.width,se.height,se.depth),Ge)if(w.layerUpdates.size>0){let ce=hp(se.width,se.height,w.format,w.type);for(let ke of w.layerUpdates){let et=se.data.subarray(ke*ce/se.data.BYTES_PER_ELEMENT,(ke+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ke,se.width,se.height,1,pe,k,et)}w.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,pe,k,se.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,pe,k,se.data);else if(w.isData3DTexture)xe?(Se&&t.texStorage3D(n.TEXTURE_3D,Qe,re,se.width,se.height,se.depth),Ge&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,pe,k,se.data)):t.texImage3D(n.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,pe,k,se.data);else if(w.isFramebufferTexture){if(Se)if(xe)t.texStorage2D(n.TEXTURE_2D,Qe,re,se.width,se.height);else{let ce=se.width,ke=se.height;for(let et=0;et<Qe;et++)t.texImage2D(n.TEXTURE_2D,et,re,ce,ke,0,pe,k,null),ce>>=1,ke>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),d.add(w),ce.onpaint=ke=>{let et=ke.changedElements;for(let Re of d)et.includes(Re.image)&&(Re.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,se);else{let et=n.RGBA,Re=n.RGBA,ot=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,et,Re,ot,se)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ee.length>0){if(xe&&Se){let ce=Xe(Ee[0]);t.texStorage2D(n.TEXTURE_2D,Qe,re,ce.width,ce.height)}for(let ce=0,ke=Ee.length;ce<ke;ce++)ne=Ee[ce],xe?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,pe,k,ne):t.texImage2D(n.TEXTURE_2D,ce,re,pe,k,ne);w.generateMipmaps=!1}else if(xe){if(Se){let ce=Xe(se);t.texStorage2D(n.TEXTURE_2D,Qe,re,ce.width,ce.height)}Ge&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,k,se)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,k,se);M(w)&&w.mipmapsAutoUpdate===!0&&b(ue),ye.__version=_e.version,w.onUpdate&&w.onUpdate(w)}P.__version=w.version}function mn(P,w,$){if(w.image.length!==6)return;let ue=Je(P,w),oe=w.source;t.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+$);let _e=i.get(oe);if(oe.version!==_e.__version||ue===!0){t.activeTexture(n.TEXTURE0+$);let ye=gt.getPrimaries(gt.workingColorSpace),te=w.colorSpace===Os?null:gt.getPrimaries(w.colorSpace),se=w.colorSpace===Os||ye===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let pe=w.isCompressedTexture||w.image[0].isCompressedTexture,k=w.image[0]&&w.image[0].isDataTexture,re=[];for(let Re=0;Re<6;Re++)!pe&&!k?re[Re]=_(w.image[Re],!0,s.maxCubemapSize):re[Re]=k?w.image[Re].image:w.image[Re],re[Re]=He(w,re[Re]);let ne=re[0],Ee=r.convert(w.format,w.colorSpace),xe=r.convert(w.type),Se=R(w.internalFormat,Ee,xe,w.normalized,w.colorSpace),Ge=w.isVideoTexture!==!0,Qe=_e.__version===void 0||ue===!0,ce=oe.dataReady,ke=E(w,ne);Ze(n.TEXTURE_CUBE_MAP,w);let et;if(w.isDepthTexture){if(Se=y(w.format===Us,w.type),Qe)if(Ge)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,ne.width,ne.height);else for(let Re=0;Re<6;Re++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,ne.width,ne.height,0,Ee,xe,null)}else if(pe){Ge&&Qe&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,Se,ne.width,ne.height);for(let Re=0;Re<6;Re++){et=re[Re].mipmaps;for(let ot=0;ot<et.length;ot++){let Xt=et[ot];w.format!==wi?Ee!==null?Ge?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ot,0,0,Xt.width,Xt.height,Ee,Xt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ot,Se,Xt.width,Xt.height,0,Xt.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ot,0,0,Xt.width,Xt.height,Ee,xe,Xt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ot,Se,Xt.width,Xt.height,0,Ee,xe,Xt.data)}}}else{if(et=w.mipmaps,Ge&&Qe){et.length>0&&ke++;let Re=Xe(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,Se,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(k){Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,re[Re].width,re[Re].height,Ee,xe,re[Re].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,re[Re].width,re[Re].height,0,Ee,xe,re[Re].data);for(let ot=0;ot<et.length;ot++){let Zn=et[ot].image[Re].image;Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ot+1,0,0,Zn.width,Zn.height,Ee,xe,Zn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ot+1,Se,Zn.width,Zn.height,0,Ee,xe,Zn.data)}}else{Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,Ee,xe,re[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,Ee,xe,re[Re]);for(let ot=0;ot<et.length;ot++){let Xt=et[ot];Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ot+1,0,0,Ee,xe,Xt.image[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ot+1,Se,Ee,xe,Xt.image[Re])}}}M(w)&&w.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),_e.__version=oe.version,w.onUpdate&&w.onUpdate(w)}P.__version=w.version}function Ot(P,w,$,ue,oe,_e){let ye=r.convert($.format,$.colorSpace),te=r.convert($.type),se=R($.internalFormat,ye,te,$.normalized,$.colorSpace),pe=i.get(w),k=i.get($);if(k.__renderTarget=w,!pe.__hasExternalTextures){let re=Math.max(1,w.width>>_e),ne=Math.max(1,w.height>>_e);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,_e,se,re,ne,w.depth,0,ye,te,null):t.texImage2D(oe,_e,se,re,ne,0,ye,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,P),we(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,oe,k.__webglTexture,0,rt(w)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,oe,k.__webglTexture,_e),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Dn(P,w,$){if(n.bindRenderbuffer(n.RENDERBUFFER,P),w.depthBuffer){let ue=w.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,_e=y(w.stencilBuffer,oe),ye=w.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,rt(w),_e,w.width,w.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,rt(w),_e,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,_e,w.width,w.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ye,n.RENDERBUFFER,P)}else{let ue=w.textures;for(let oe=0;oe<ue.length;oe++){let _e=ue[oe],ye=r.convert(_e.format,_e.colorSpace),te=r.convert(_e.type),se=R(_e.internalFormat,ye,te,_e.normalized,_e.colorSpace);we(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,rt(w),se,w.width,w.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,rt(w),se,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,se,w.width,w.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function _t(P,w,$){let ue=w.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,P),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(w.depthTexture);oe.__renderTarget=w;let _e=ue?w.depthTexture.image[0]:w.depthTexture.image;(!oe.__webglTexture||_e.width!==w.width||_e.height!==w.height)&&(_e.width=w.width,_e.height=w.height,w.depthTexture.needsUpdate=!0),ue?ve(w.depthTexture,0):me(w.depthTexture,0);let ye=oe.__webglTexture,te=rt(w),se=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,pe=w.depthTexture.format===Us?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(w.depthTexture.format===Is)we(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,ye,0);else if(w.depthTexture.format===Us)we(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Rn(P){let w=i.get(P),$=P.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==P.depthTexture){let ue=P.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),ue){let oe=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),w.__depthDisposeCallback=oe}w.__boundDepthTexture=ue}if(P.depthTexture&&!w.__autoAllocateDepthBuffer)if($)for(let ue=0;ue<6;ue++)_t(w.__webglFramebuffer[ue],P,ue);else P.texture.mipmaps.length>0?_t(w.__webglFramebuffer[0],P,0):_t(w.__webglFramebuffer,P,0);else if($){w.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[ue]),w.__webglDepthbuffer[ue]===void 0)w.__webglDepthbuffer[ue]=n.createRenderbuffer(),Dn(w.__webglDepthbuffer[ue],P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=w.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,_e)}}else if(P.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=n.createRenderbuffer(),Dn(w.__webglDepthbuffer,P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=w.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,_e)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function on(P,w,$){let ue=i.get(P);w!==void 0&&Ot(ue.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&Rn(P)}function gn(P){let w=P.texture,$=i.get(P),ue=i.get(w);P.addEventListener("dispose",O),U(P);let oe=P.textures,_e=P.isWebGLCubeRenderTarget===!0,ye=oe.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=w.version,o.memory.textures++),_e){$.__webglFramebuffer=[];for(let te=0;te<6;te++)if(w.mipmaps.length>0){$.__webglFramebuffer[te]=[];for(let se=0;se<w.mipmaps.length;se++)$.__webglFramebuffer[te][se]=n.createFramebuffer()}else $.__webglFramebuffer[te]=n.createFramebuffer()}else{if(w.mipmaps.length>0){$.__webglFramebuffer=[];for(let te=0;te<w.mipmaps.length;te++)$.__webglFramebuffer[te]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(ye)for(let te=0,se=oe.length;te<se;te++){let pe=i.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&we(P)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let se=oe[te];$.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[te]);let pe=r.convert(se.format,se.colorSpace),k=r.convert(se.type),re=R(se.internalFormat,pe,k,se.normalized,se.colorSpace,P.isXRRenderTarget===!0),ne=rt(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,$.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),Dn($.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_e){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),Ze(n.TEXTURE_CUBE_MAP,w);for(let te=0;te<6;te++)if(w.mipmaps.length>0)for(let se=0;se<w.mipmaps.length;se++)Ot($.__webglFramebuffer[te][se],P,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else Ot($.__webglFramebuffer[te],P,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);M(w)?b(n.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let te=0,se=oe.length;te<se;te++){let pe=oe[te],k=i.get(pe),re=n.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(re=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,k.__webglTexture),Ze(re,pe),Ot($.__webglFramebuffer,P,pe,n.COLOR_ATTACHMENT0+te,re,0),M(pe)&&b(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(te=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),Ze(te,w),w.mipmaps.length>0)for(let se=0;se<w.mipmaps.length;se++)Ot($.__webglFramebuffer[se],P,w,n.COLOR_ATTACHMENT0,te,se);else Ot($.__webglFramebuffer,P,w,n.COLOR_ATTACHMENT0,te,0);M(w)?b(te):w.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}P.depthBuffer&&Rn(P)}function B(P){let w=P.textures;for(let $=0,ue=w.length;$<ue;$++){let oe=w[$];if(M(oe)&&oe.mipmapsAutoUpdate===!0){let _e=C(P),ye=i.get(oe).__webglTexture;t.bindTexture(_e,ye),b(_e),t.unbindTexture()}}}let Ce=[];function qe(P){if(P.samples>0){if(we(P)===!1){let w=P.textures,$=P.width,ue=P.height,oe=n.COLOR_BUFFER_BIT,_e=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=i.get(P),te=w.length>1;if(te)for(let pe=0;pe<w.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let pe=0;pe<w.length;pe++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let k=i.get(w[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,k,0)}n.blitFramebuffer(0,0,$,ue,0,0,$,ue,oe,n.NEAREST),l===!0&&(Ce.length=0,Ce.push(n.COLOR_ATTACHMENT0+pe),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Ce.push(_e),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ce))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<w.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let k=i.get(w[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,k,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let w=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[w])}}}function rt(P){return Math.min(s.maxSamples,P.samples)}function we(P){let w=i.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function zt(P){let w=o.render.frame;u.get(P)!==w&&(u.set(P,w),P.update())}function He(P,w){let $=P.colorSpace,ue=P.format,oe=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||$!==Ia&&$!==Os&&(gt.getTransfer($)===Pt?(ue!==wi||oe!==Mi)&&Ye("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):nt("WebGLTextures: Unsupported texture color space:",$)),w}function Xe(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=de,this.setTexture2D=me,this.setTexture2DArray=ge,this.setTexture3D=Me,this.setTextureCube=ve,this.rebindTextures=on,this.setupRenderTarget=gn,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=qe,this.setupDepthRenderbuffer=Rn,this.setupFrameBufferTexture=Ot,this.useMultisampledRTT=we,this.dispose=W}function bR(n,e){function t(i,s=Os){let r,o=gt.getTransfer(s);if(i===Mi)return n.UNSIGNED_BYTE;if(i===au)return n.UNSIGNED_SHORT_4_4_4_4;if(i===lu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===qf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Yf)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Xf)return n.BYTE;if(i===$f)return n.SHORT;if(i===Wo)return n.UNSIGNED_SHORT;if(i===ou)return n.INT;if(i===Zi)return n.UNSIGNED_INT;if(i===Ki)return n.FLOAT;if(i===ji)return n.HALF_FLOAT;if(i===Jf)return n.ALPHA;if(i===Zf)return n.RGB;if(i===wi)return n.RGBA;if(i===Is)return n.DEPTH_COMPONENT;if(i===Us)return n.DEPTH_STENCIL;if(i===Kf)return n.RED;if(i===cu)return n.RED_INTEGER;if(i===hr)return n.RG;if(i===uu)return n.RG_INTEGER;if(i===hu)return n.RGBA_INTEGER;if(i===Ja||i===Za||i===Ka||i===ja)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ja)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Za)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ka)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===ja)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ja)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Za)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ka)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===ja)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===du||i===fu||i===pu||i===mu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===du)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===fu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===pu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===mu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===gu||i===xu||i===vu||i===_u||i===yu||i===Qa||i===bu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===gu||i===xu)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===vu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===_u)return r.COMPRESSED_R11_EAC;if(i===yu)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Qa)return r.COMPRESSED_RG11_EAC;if(i===bu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Su||i===Mu||i===wu||i===Eu||i===Tu||i===Au||i===Ru||i===Cu||i===Pu||i===Iu||i===Lu||i===Nu||i===Du||i===Fu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Su)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Mu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===wu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Eu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Tu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Au)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Ru)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Cu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Pu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Iu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Lu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Nu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Du)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Fu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Uu||i===Ou||i===ku)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Uu)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Ou)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===ku)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Bu||i===zu||i===el||i===Vu)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Bu)return r.COMPRESSED_RED_RGTC1_EXT;if(i===zu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===el)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Vu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Br?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var SR=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,MR=`
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

}`,yp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Ga(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Di({vertexShader:SR,fragmentShader:MR,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new bt(new Fr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},bp=class extends hs{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,d=null,h=null,f=null,p=null,v=typeof XRWebGLBinding<"u",m=new yp,g={},_=t.getContextAttributes(),M=null,b=null,C=[],R=[],y=new vt,E=null,U=null,N=new si;N.viewport=new Kt;let L=new si;L.viewport=new Kt;let O=[N,L],z=new nu,D=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=C[ee];return me===void 0&&(me=new Fo,C[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=C[ee];return me===void 0&&(me=new Fo,C[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=C[ee];return me===void 0&&(me=new Fo,C[ee]=me),me.getHandSpace()};function q(ee){let me=R.indexOf(ee.inputSource);if(me===-1)return;let ge=C[me];ge!==void 0&&(ge.update(ee.inputSource,ee.frame,c||o),ge.dispatchEvent({type:ee.type,data:ee.inputSource}))}function H(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",le);for(let ee=0;ee<C.length;ee++){let me=R[ee];me!==null&&(R[ee]=null,C[ee].disconnect(me))}D=null,W=null,m.reset();for(let ee in g)delete g[ee];if(e.setRenderTarget(M),f=null,h=null,d=null,s=null,b=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(E),e.setSize(y.width,y.height,!1),U!==null){let ee=U.camera;ee.fov=U.fov,ee.zoom=U.zoom,ee.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Ye("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Ye("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return h!==null?h:f},this.getBinding=function(){return d===null&&v&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",H),s.addEventListener("inputsourceschange",le),_.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(y),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,Me=null,ve=null;_.depth&&(ve=_.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=_.stencil?Us:Is,Me=_.stencil?Br:Zi);let Ve={colorFormat:t.RGBA8,depthFormat:ve,scaleFactor:r};d=this.getBinding(),h=d.createProjectionLayer(Ve),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),b=new yi(h.textureWidth,h.textureHeight,{format:wi,type:Mi,depthTexture:new Ds(h.textureWidth,h.textureHeight,Me,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:_.stencil,colorSpace:e.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let ge={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new yi(f.framebufferWidth,f.framebufferHeight,{format:wi,type:Mi,colorSpace:e.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function le(ee){for(let me=0;me<ee.removed.length;me++){let ge=ee.removed[me],Me=R.indexOf(ge);Me>=0&&(R[Me]=null,C[Me].disconnect(ge))}for(let me=0;me<ee.added.length;me++){let ge=ee.added[me],Me=R.indexOf(ge);if(Me===-1){for(let Ve=0;Ve<C.length;Ve++)if(Ve>=R.length){R.push(ge),Me=Ve;break}else if(R[Ve]===null){R[Ve]=ge,Me=Ve;break}if(Me===-1)break}let ve=C[Me];ve&&ve.connect(ge)}}function Z(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ge=ee.far;m.texture!==null&&(m.depthNear>0&&(me=m.depthNear),m.depthFar>0&&(ge=m.depthFar)),z.near=L.near=N.near=me,z.far=L.far=N.far=ge,(D!==z.near||W!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),D=z.near,W=z.far),z.layers.mask=ee.layers.mask|6,N.layers.mask=z.layers.mask&-5,L.layers.mask=z.layers.mask&-3;let Me=ee.parent,ve=z.cameras;Z(z,Me);for(let Ve=0;Ve<ve.length;Ve++)Z(ve[Ve],Me);z.projectionMatrix.copy(N.projectionMatrix),z.projectionMatrixInverse.copy(N.projectionMatrixInverse),U===null&&ee.isPerspectiveCamera&&(U={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,z,Me)};function Q(ee,me,ge){ge===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ge.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Uc*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(h===null&&f===null))return l},this.setFoveation=function(ee){l=ee,h!==null&&(h.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(z)},this.getCameraTexture=function(ee){return g[ee]};let ie=null;function de(ee,me){if(u=me.getViewerPose(c||o),p=me,u!==null){let ge=u.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Me=!1;ge.length!==z.cameras.length&&(z.cameras.length=0,Me=!0);for(let Fe=0;Fe<ge.length;Fe++){let Ze=ge[Fe],Je=null;if(f!==null)Je=f.getViewport(Ze);else{let Bt=d.getViewSubImage(h,Ze);Je=Bt.viewport,Fe===0&&(e.setRenderTargetTextures(b,Bt.colorTexture,Bt.depthStencilTexture),e.setRenderTarget(b))}let je=O[Fe];je===void 0&&(je=new si,je.layers.enable(Fe),je.viewport=new Kt,O[Fe]=je),je.matrix.fromArray(Ze.transform.matrix),je.matrix.decompose(je.position,je.quaternion,je.scale),je.projectionMatrix.fromArray(Ze.projectionMatrix),je.projectionMatrixInverse.copy(je.projectionMatrix).invert(),je.viewport.set(Je.x,Je.y,Je.width,Je.height),Fe===0&&(z.matrix.copy(je.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),Me===!0&&z.cameras.push(je)}let ve=s.enabledFeatures;if(ve&&ve.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){d=i.getBinding();let Fe=d.getDepthInformation(ge[0]);Fe&&Fe.isValid&&Fe.texture&&m.init(Fe,s.renderState)}if(ve&&ve.includes("camera-access")&&v){e.state.unbindTexture(),d=i.getBinding();for(let Fe=0;Fe<ge.length;Fe++){let Ze=ge[Fe].camera;if(Ze){let Je=g[Ze];Je||(Je=new Ga,g[Ze]=Je);let je=d.getCameraImage(Ze);Je.sourceTexture=je}}}}for(let ge=0;ge<C.length;ge++){let Me=R[ge],ve=C[ge];Me!==null&&ve!==void 0&&ve.update(Me,me,c||o)}ie&&ie(ee,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),p=null}let he=new Nv;he.setAnimationLoop(de),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},wR=new yt,Gv=new it;Gv.set(-1,0,0,0,1,0,0,0,1);function ER(n,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,lp(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,_,M,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),d(m,g)):g.isMeshPhongMaterial?(r(m,g),u(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),h(m,g),g.isMeshPhysicalMaterial&&f(m,g,b)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),v(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,_,M):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===Xn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===Xn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let _=e.get(g),M=_.envMap,b=_.envMapRotation;M&&(m.envMap.value=M,m.envMapRotation.value.setFromMatrix4(wR.makeRotationFromEuler(b)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Gv),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,_,M){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*_,m.scale.value=M*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function u(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function d(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function h(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,_){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Xn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=_.texture,m.transmissionSamplerSize.value.set(_.width,_.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function v(m,g){let _=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(_.matrixWorld),m.nearDistance.value=_.shadow.camera.near,m.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function TR(n,e,t,i){let s={},r={};function o(_,M){let b=M.program;i.uniformBlockBinding(_,b,s[_.id])}function a(_,M){let b=s[_.id];b===void 0&&(p(_),b=l(_),s[_.id]=b,_.addEventListener("dispose",m));let C=M.program;i.updateUBOMapping(_,C);let R=e.render.frame;r[_.id]!==R&&(c(_),r[_.id]=R)}function l(_){let M=n.createBuffer(),b=_.__size,C=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,M),n.bufferData(n.UNIFORM_BUFFER,b,C),n.bindBuffer(n.UNIFORM_BUFFER,null),M}function c(_){let M=s[_.id],b=_.uniforms,C=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,M);for(let R=0,y=b.length;R<y;R++){let E=b[R];if(Array.isArray(E))for(let U=0,N=E.length;U<N;U++)u(E[U],R,U,C);else u(E,R,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(_,M,b,C){if(h(_,M,b,C)===!0){let R=_.__offset,y=_.value;if(Array.isArray(y)){let E=0;for(let U=0;U<y.length;U++){let N=y[U],L=v(N,!0);d(N,_.__data,E),E+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else d(y,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,R,_.__data)}}function d(_,M,b){typeof _=="number"||typeof _=="boolean"?M[b]=_:_.isMatrix3?(M[b]=_.elements[0],M[b+1]=_.elements[1],M[b+2]=_.elements[2],M[b+3]=0,M[b+4]=_.elements[3],M[b+5]=_.elements[4],M[b+6]=_.elements[5],M[b+7]=0,M[b+8]=_.elements[6],M[b+9]=_.elements[7],M[b+10]=_.elements[8],M[b+11]=0):ArrayBuffer.isView(_)?M.set(_.subarray(0,M.length-b),b):_.toArray(M,b)}function h(_,M,b,C){let R=_.value,y=M+"_"+b;if(Array.isArray(R)){C[y]===void 0&&(C[y]=[]);let E=C[y],U=!1;for(let N=0;N<R.length;N++)f(R[N],E,N)===!0&&(U=!0);return U}return f(R,C,y)}function f(_,M,b){if(M[b]===void 0)return typeof _=="number"||typeof _=="boolean"?M[b]=_:ArrayBuffer.isView(_)?M[b]=_.slice():M[b]=_.clone(),!0;{let C=M[b];if(typeof _=="number"||typeof _=="boolean"){if(C!==_)return M[b]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(C.equals(_)===!1)return C.copy(_),!0}}return!1}function p(_){let M=_.uniforms,b=0,C=16;for(let y=0,E=M.length;y<E;y++){let U=Array.isArray(M[y])?M[y]:[M[y]];for(let N=0,L=U.length;N<L;N++){let O=U[N],z=Array.isArray(O.value)?O.value:[O.value],D=Array.isArray(M[y])||Array.isArray(O.value),W=b;for(let H=0,le=z.length;H<le;H++){let Z=z[H],Q=v(Z,D),ie=b%C,de=ie%Q.boundary,he=ie+de;b+=de,he!==0&&C-he<Q.storage&&(b+=C-he),H===0&&(W=b),b+=Q.storage}let q=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new q((b-W)/Float32Array.BYTES_PER_ELEMENT),O.__offset=W}}let R=b%C;return R>0&&(b+=C-R),_.__size=b,_.__cache={},this}function v(_,M){let b={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(b.boundary=4,b.storage=4):_.isVector2?(b.boundary=8,b.storage=8):_.isVector3||_.isColor?(b.boundary=16,b.storage=12):_.isVector4?(b.boundary=16,b.storage=16):_.isMatrix3?(b.boundary=16,b.storage=48):_.isMatrix4?(b.boundary=16,b.storage=64):_.isTexture?Ye("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(b.boundary=16,b.storage=_.byteLength):Ye("WebGLRenderer: Unsupported uniform value type.",_),M===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(_){let M=_.target;M.removeEventListener("dispose",m),n.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function g(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:g}}var AR=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),fs=null;function RR(){return fs===null&&(fs=new Uo(AR,16,16,hr,ji),fs.name="DFG_LUT",fs.minFilter=Wn,fs.magFilter=Wn,fs.wrapS=us,fs.wrapT=us,fs.generateMipmaps=!1,fs.needsUpdate=!0),fs}var $u=class{constructor(e={}){let{canvas:t=iv(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:h=!1,outputBufferType:f=Mi}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let v=f,m=new Set([hu,uu,cu]),g=new Set([Mi,Zi,Wo,Br,au,lu]),_=new Uint32Array(4),M=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,R=null,y=[],E=[],U=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ds,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,L=!1,O=null,z=null,D=null,W=null;this._outputColorSpace=ii;let q=0,H=0,le=null,Z=-1,Q=null,ie=new Kt,de=new Kt,he=null,ee=new at(0),me=0,ge=t.width,Me=t.height,ve=1,Ve=null,$e=null,Fe=new Kt(0,0,ge,Me),Ze=new Kt(0,0,ge,Me),Je=!1,je=new Ns,Bt=new zc,It=!1,mn=!1,Ot=new yt,Dn=new G,_t=new Kt,Rn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},on=!1;function gn(){return le===null?ve:1}let B=i;function Ce(A,V){return t.getContext(A,V)}let qe,rt,we,zt,He,Xe,P,w,$,ue,oe,_e,ye,te,se,pe,k,re,ne,Ee,xe,Se,Ge;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",et,!1),t.addEventListener("webglcontextcreationerror",Re,!1),B===null){let V="webgl2";if(B=Ce(V,A),B===null)throw Ce(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Qe()}catch(A){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),nt("WebGLRenderer: "+A.message),A}function Qe(){qe=new BT(B),qe.init(),xe=new bR(B,qe),rt=new RT(B,qe,e,xe),we=new _R(B,qe),rt.reversedDepthBuffer&&h&&we.buffers.depth.setReversed(!0),z=B.createFramebuffer(),D=B.createFramebuffer(),W=B.createFramebuffer(),zt=new HT(B),He=new rR,Xe=new yR(B,qe,we,He,rt,xe,zt),P=new kT(N),w=new Ww(B),Se=new TT(B,w),$=new zT(B,w,zt,Se),ue=new WT(B,$,w,Se,zt),re=new GT(B,rt,Xe),se=new CT(He),oe=new sR(N,P,qe,rt,Se,se),_e=new ER(N,He),ye=new aR,te=new fR(qe),k=new ET(N,P,we,ue,p,l),pe=new vR(N,ue,rt),Ge=new TR(B,zt,rt,we),ne=new AT(B,qe,zt),Ee=new VT(B,qe,zt),zt.programs=oe.programs,N.capabilities=rt,N.extensions=qe,N.properties=He,N.renderLists=ye,N.shadowMap=pe,N.state=we,N.info=zt}v!==Mi&&(U=new $T(v,t.width,t.height,a,s,r));let ce=new bp(N,B);this.xr=ce,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let A=qe.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=qe.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return ve},this.setPixelRatio=function(A){A!==void 0&&(ve=A,this.setSize(ge,Me,!1))},this.getSize=function(A){return A.set(ge,Me)},this.setSize=function(A,V,j=!0){if(ce.isPresenting){Ye("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=A,Me=V,t.width=Math.floor(A*ve),t.height=Math.floor(V*ve),j===!0&&(t.style.width=A+"px",t.style.height=V+"px"),U!==null&&U.setSize(t.width,t.height),this.setViewport(0,0,A,V)},this.getDrawingBufferSize=function(A){return A.set(ge*ve,Me*ve).floor()},this.setDrawingBufferSize=function(A,V,j){ge=A,Me=V,ve=j,t.width=Math.floor(A*j),t.height=Math.floor(V*j),this.setViewport(0,0,A,V)},this.setEffects=function(A){if(v===Mi){nt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let V=0;V<A.length;V++)if(A[V].isOutputPass===!0){Ye("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(ie)},this.getViewport=function(A){return A.copy(Fe)},this.setViewport=function(A,V,j,Y){A.isVector4?Fe.set(A.x,A.y,A.z,A.w):Fe.set(A,V,j,Y),we.viewport(ie.copy(Fe).multiplyScalar(gn()).round())},this.getScissor=function(A){return A.copy(Ze)},this.setScissor=function(A,V,j,Y){A.isVector4?Ze.set(A.x,A.y,A.z,A.w):Ze.set(A,V,j,Y),we.scissor(de.copy(Ze).multiplyScalar(gn()).round())},this.getScissorTest=function(){return Je},this.setScissorTest=function(A){we.setScissorTest(Je=A)},this.setOpaqueSort=function(A){Ve=A},this.setTransparentSort=function(A){$e=A},this.getClearColor=function(A){return A.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(A=!0,V=!0,j=!0){let Y=0;if(A){let J=!1;if(le!==null){let Te=le.texture.format;J=m.has(Te)}if(J){let Te=le.texture.type,Pe=g.has(Te),Ae=k.getClearColor(),Ie=k.getClearAlpha(),ze=Ae.r,tt=Ae.g,ht=Ae.b;Pe?(_[0]=ze,_[1]=tt,_[2]=ht,_[3]=Ie,B.clearBufferuiv(B.COLOR,0,_)):(M[0]=ze,M[1]=tt,M[2]=ht,M[3]=Ie,B.clearBufferiv(B.COLOR,0,M))}else Y|=B.COLOR_BUFFER_BIT}V&&(Y|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&B.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),O=A},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),k.dispose(),ye.dispose(),te.dispose(),Xe.dispose(),He.dispose(),P.dispose(),ue.dispose(),$.dispose(),Se.dispose(),Ge.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",xl),ce.removeEventListener("sessionend",Qi),gs.stop()};function ke(A){A.preventDefault(),op("WebGLRenderer: Context Lost."),L=!0}function et(){op("WebGLRenderer: Context Restored."),L=!1;let A=zt.autoReset,V=pe.enabled,j=pe.autoUpdate,Y=pe.needsUpdate,J=pe.type;Qe(),zt.autoReset=A,pe.enabled=V,pe.autoUpdate=j,pe.needsUpdate=Y,pe.type=J}function Re(A){nt("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function ot(A){let V=A.target;V.removeEventListener("dispose",ot),Xt(V)}function Xt(A){Zn(A),He.remove(A)}function Zn(A){let V=He.get(A).programs;V!==void 0&&(V.forEach(function(j){oe.releaseProgram(j)}),A.isShaderMaterial&&oe.releaseShaderCache(A))}this.renderBufferDirect=function(A,V,j,Y,J,Te){V===null&&(V=Rn);let Pe=J.isMesh&&J.matrixWorld.determinantAffine()<0,Ae=oa(A,V,j,Y,J);we.setMaterial(Y,Pe);let Ie=j.index,ze=1;if(Y.wireframe===!0){if(Ie=$.getWireframeAttribute(j),Ie===void 0)return;ze=2}let tt=j.drawRange,ht=j.attributes.position,Be=tt.start*ze,dt=(tt.start+tt.count)*ze;Te!==null&&(Be=Math.max(Be,Te.start*ze),dt=Math.min(dt,(Te.start+Te.count)*ze)),Ie!==null?(Be=Math.max(Be,0),dt=Math.min(dt,Ie.count)):ht!=null&&(Be=Math.max(Be,0),dt=Math.min(dt,ht.count));let sn=dt-Be;if(sn<0||sn===1/0)return;Se.setup(J,Y,Ae,j,Ie);let Lt,Nt=ne;if(Ie!==null&&(Lt=w.get(Ie),Nt=Ee,Nt.setIndex(Lt)),J.isMesh)Y.wireframe===!0?(we.setLineWidth(Y.wireframeLinewidth*gn()),Nt.setMode(B.LINES)):Nt.setMode(B.TRIANGLES);else if(J.isLine){let Cn=Y.linewidth;Cn===void 0&&(Cn=1),we.setLineWidth(Cn*gn()),J.isLineSegments?Nt.setMode(B.LINES):J.isLineLoop?Nt.setMode(B.LINE_LOOP):Nt.setMode(B.LINE_STRIP)}else J.isPoints?Nt.setMode(B.POINTS):J.isSprite&&Nt.setMode(B.TRIANGLES);if(J.isBatchedMesh)if(qe.get("WEBGL_multi_draw"))Nt.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let Cn=J._multiDrawStarts,Ue=J._multiDrawCounts,xn=J._multiDrawCount,pt=Ie?w.get(Ie).bytesPerElement:1,vs=He.get(Y).currentProgram.getUniforms();for(let vn=0;vn<xn;vn++)vs.setValue(B,"_gl_DrawID",vn),Nt.render(Cn[vn]/pt,Ue[vn])}else if(J.isInstancedMesh)Nt.renderInstances(Be,sn,J.count);else if(j.isInstancedBufferGeometry){let Cn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ue=Math.min(j.instanceCount,Cn);Nt.renderInstances(Be,sn,Ue)}else Nt.render(Be,sn)};function ia(A,V,j,Y){O!==null&&A.isNodeMaterial&&O.setObject(Y,A),It===!0&&se.setState(A,j,!1),A.transparent===!0&&A.side===zn&&A.forceSinglePass===!1?(A.side=Xn,A.needsUpdate=!0,es(A,V,Y),A.side=Fi,A.needsUpdate=!0,es(A,V,Y),A.side=zn):es(A,V,Y)}this.compile=function(A,V,j=null){j===null&&(j=A),O!==null&&O.renderStart(A,V,j),R=te.get(j),R.init(V),E.push(R),j.traverseVisible(function(J){J.isLight&&J.layers.test(V.layers)&&(R.pushLight(J),J.castShadow&&R.pushShadow(J))}),A!==j&&A.traverseVisible(function(J){J.isLight&&J.layers.test(V.layers)&&(R.pushLight(J),J.castShadow&&R.pushShadow(J))}),R.setupLights(),O!==null&&O.updateLights(R.state.lightsArray),mn=this.localClippingEnabled,It=se.init(this.clippingPlanes,mn),It===!0&&se.setGlobalState(this.clippingPlanes,V),O!==null&&pe.render(R.state.shadowsArray,j,V);let Y=new Set;return A.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Te=J.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let Ae=Te[Pe];ia(Ae,j,V,J),Y.add(Ae)}else ia(Te,j,V,J),Y.add(Te)}),R=E.pop(),O!==null&&O.renderEnd(),Y},this.compileAsync=function(A,V,j=null){let Y=this.compile(A,V,j);return new Promise(J=>{function Te(){if(Y.forEach(function(Pe){let Ie=He.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&Y.delete(Pe)}),Y.size===0){J(A);return}setTimeout(Te,10)}qe.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let $r=null;function Wh(A){$r&&$r(A)}function xl(){gs.stop()}function Qi(){gs.start()}let gs=new Nv;gs.setAnimationLoop(Wh),typeof self<"u"&&gs.setContext(self),this.setAnimationLoop=function(A){$r=A,ce.setAnimationLoop(A),A===null?gs.stop():gs.start()},ce.addEventListener("sessionstart",xl),ce.addEventListener("sessionend",Qi),this.render=function(A,V){if(V!==void 0&&V.isCamera!==!0){nt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;O!==null&&O.renderStart(A,V);let j=ce.enabled===!0&&ce.isPresenting===!0,Y=U!==null&&(le===null||j)&&U.begin(N,le);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(V),V=ce.getCamera()),A.isScene===!0&&A.onBeforeRender(N,A,V,le),R=te.get(A,E.length),R.init(V),R.state.textureUnits=Xe.getTextureUnits(),E.push(R),Ot.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?Bt.setFromArrayCamera(V):je.setFromProjectionMatrix(Ot,Ii,V.reversedDepth),mn=this.localClippingEnabled,It=se.init(this.clippingPlanes,mn),C=ye.get(A,y.length),C.init(),y.push(C),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Pe=N.xr.getDepthSensingMesh();Pe!==null&&xs(Pe,V,-1/0,N.sortObjects)}xs(A,V,0,N.sortObjects),C.finish(),O!==null&&O.updateLights(R.state.lightsArray),N.sortObjects===!0&&C.sort(Ve,$e),on=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,on&&k.addToRenderList(C,A),this.info.autoReset===!0&&this.info.reset(),It===!0&&se.beginShadows();let J=R.state.shadowsArray;if(pe.render(J,A,V),It===!0&&se.endShadows(),(Y&&U.hasRenderPass())===!1){let Pe=C.opaque,Ae=C.transmissive;if(R.setupLights(),V.isArrayCamera){let Ie=V.cameras;if(Ae.length>0)for(let ze=0,tt=Ie.length;ze<tt;ze++){let ht=Ie[ze];ki(Pe,Ae,A,ht)}on&&k.render(A);for(let ze=0,tt=Ie.length;ze<tt;ze++){let ht=Ie[ze];sa(C,A,ht,ht.viewport)}}else Ae.length>0&&ki(Pe,Ae,A,V),on&&k.render(A),sa(C,A,V)}le!==null&&H===0&&(Xe.updateMultisampleRenderTarget(le),Xe.updateRenderTargetMipmap(le)),Y&&U.end(N),A.isScene===!0&&A.onAfterRender(N,A,V),Se.resetDefaultState(),Z=-1,Q=null,E.pop(),E.length>0?(R=E[E.length-1],Xe.setTextureUnits(R.state.textureUnits),It===!0&&se.setGlobalState(N.clippingPlanes,R.state.camera)):R=null,y.pop(),y.length>0?C=y[y.length-1]:C=null,O!==null&&O.renderEnd()};function xs(A,V,j,Y){if(A.visible===!1)return;if(A.layers.test(V.layers)){if(A.isGroup)j=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(V);else if(A.isLight)R.pushLight(A),A.castShadow&&R.pushShadow(A);else if(A.isSprite){let Pe=V.isArrayCamera?Bt:je;if(!A.frustumCulled||A.intersectsFrustum(Pe)){Y&&_t.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Ot);let Ae=ue.update(A),Ie=A.material;Ie.visible&&C.push(A,Ae,Ie,j,_t.z,null,V)}}else if(A.isMesh||A.isLine||A.isPoints){let Pe=V.isArrayCamera?Bt:je;if(!A.frustumCulled||A.intersectsFrustum(Pe)){let Ae=ue.update(A),Ie=A.material;if(Y&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),_t.copy(A.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),_t.copy(Ae.boundingSphere.center)),_t.applyMatrix4(A.matrixWorld).applyMatrix4(Ot)),Array.isArray(Ie)){let ze=Ae.groups;for(let tt=0,ht=ze.length;tt<ht;tt++){let Be=ze[tt],dt=Ie[Be.materialIndex];dt&&dt.visible&&C.push(A,Ae,dt,j,_t.z,Be,V)}}else Ie.visible&&C.push(A,Ae,Ie,j,_t.z,null,V)}}}let Te=A.children;for(let Pe=0,Ae=Te.length;Pe<Ae;Pe++)xs(Te[Pe],V,j,Y)}function sa(A,V,j,Y){let{opaque:J,transmissive:Te,transparent:Pe}=A;R.setupLightsView(j),It===!0&&se.setGlobalState(N.clippingPlanes,j),Y&&we.viewport(ie.copy(Y)),J.length>0&&an(J,V,j),Te.length>0&&an(Te,V,j),Pe.length>0&&an(Pe,V,j),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function ki(A,V,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(R.state.transmissionRenderTarget[Y.id]===void 0){let Be=qe.has("EXT_color_buffer_half_float")||qe.has("EXT_color_buffer_float");R.state.transmissionRenderTarget[Y.id]=new yi(1,1,{generateMipmaps:!0,type:Be?ji:Mi,minFilter:Fs,samples:Math.max(4,rt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:gt.workingColorSpace})}let Te=R.state.transmissionRenderTarget[Y.id],Pe=Y.viewport||ie;Te.setSize(Pe.z*N.transmissionResolutionScale,Pe.w*N.transmissionResolutionScale);let Ae=N.getRenderTarget(),Ie=N.getActiveCubeFace(),ze=N.getActiveMipmapLevel();N.setRenderTarget(Te),N.getClearColor(ee),me=N.getClearAlpha(),me<1&&N.setClearColor(16777215,.5),N.clear(),on&&k.render(j);let tt=N.toneMapping;N.toneMapping=ds;let ht=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),R.setupLightsView(Y),It===!0&&se.setGlobalState(N.clippingPlanes,Y),an(A,j,Y),Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te),qe.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let dt=0,sn=V.length;dt<sn;dt++){let Lt=V[dt],{object:Nt,geometry:Cn,material:Ue,group:xn}=Lt;if(Ue.side===zn&&Nt.layers.test(Y.layers)){let pt=Ue.side;Ue.side=Xn,Ue.needsUpdate=!0,dn(Nt,j,Y,Cn,Ue,xn),Ue.side=pt,Ue.needsUpdate=!0,Be=!0}}Be===!0&&(Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te))}N.setRenderTarget(Ae,Ie,ze),N.setClearColor(ee,me),ht!==void 0&&(Y.viewport=ht),N.toneMapping=tt}function an(A,V,j){let Y=V.isScene===!0?V.overrideMaterial:null;for(let J=0,Te=A.length;J<Te;J++){let Pe=A[J],{object:Ae,geometry:Ie,group:ze}=Pe,tt=Pe.material;tt.allowOverride===!0&&Y!==null&&(tt=Y),Ae.layers.test(j.layers)&&dn(Ae,V,j,Ie,tt,ze)}}function dn(A,V,j,Y,J,Te){O!==null&&J.isNodeMaterial&&O.setObject(A,J),A.onBeforeRender(N,V,j,Y,J,Te),A.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),J.onBeforeRender(N,V,j,Y,A,Te),J.transparent===!0&&J.side===zn&&J.forceSinglePass===!1?(J.side=Xn,J.needsUpdate=!0,N.renderBufferDirect(j,V,Y,J,A,Te),J.side=Fi,J.needsUpdate=!0,N.renderBufferDirect(j,V,Y,J,A,Te),J.side=zn):N.renderBufferDirect(j,V,Y,J,A,Te),A.onAfterRender(N,V,j,Y,J,Te)}function fn(A){let V=0;for(let j of A)j.texture!==null&&V++;return V}function es(A,V,j){V.isScene!==!0&&(V=Rn);let Y=He.get(A),J=R.state.lights,Te=R.state.shadowsArray,Pe=J.state.version,Ae=oe.getParameters(A,J.state,Te,V,j,R.state.lightProbeGridArray),Ie=oe.getProgramCacheKey(Ae),ze=Y.programs;Y.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?V.environment:null,Y.fog=V.fog;let tt=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;Y.envMap=P.get(A.envMap||Y.environment,tt),Y.envMapRotation=Y.environment!==null&&A.envMap===null?V.environmentRotation:A.envMapRotation,ze===void 0&&(A.addEventListener("dispose",ot),ze=new Map,Y.programs=ze,Y.programVariants=new Map);let ht=ze.get(Ie);if(ht!==void 0){if(Y.currentProgram===ht&&Y.lightsStateVersion===Pe)return ra(A,Ae),ht}else Ae.uniforms=oe.getUniforms(A),O!==null&&A.isNodeMaterial&&O.build(A,j,Ae),A.onBeforeCompile(Ae,N),ht=oe.acquireProgram(Ae,Ie),ze.set(Ie,ht),Y.uniforms=Ae.uniforms;let Be=Y.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Be.clippingPlanes=se.uniform),ra(A,Ae),Y.needsLights=Hs(A),Y.lightsStateVersion=Pe,Y.needsLights&&(Be.ambientLightColor.value=J.state.ambient,Be.lightProbe.value=J.state.probe,Be.sunLights.value=J.state.sun,Be.sunLightShadows.value=J.state.sunShadow,Be.directionalLights.value=J.state.directional,Be.directionalLightShadows.value=J.state.directionalShadow,Be.spotLights.value=J.state.spot,Be.spotLightShadows.value=J.state.spotShadow,Be.rectAreaLights.value=J.state.rectArea,Be.ltc_1.value=J.state.rectAreaLTC1,Be.ltc_2.value=J.state.rectAreaLTC2,Be.pointLights.value=J.state.point,Be.pointLightShadows.value=J.state.pointShadow,Be.hemisphereLights.value=J.state.hemi,Be.sunShadowMatrix.value=J.state.sunShadowMatrix,Be.sunShadowCascade.value=J.state.sunShadowCascade,Be.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Be.spotLightMatrix.value=J.state.spotLightMatrix,Be.spotLightMap.value=J.state.spotLightMap,Be.pointShadowMatrix.value=J.state.pointShadowMatrix),Y.numLightProbeGrids=fn(R.state.lightProbeGridArray),Y.currentProgram=ht,Y.uniformsList=null,ht}function ui(A,V,j,Y,J){let Te=He.get(A),Pe=Te.currentProgram.id+","+Y+","+J,Ae=Te.programVariants.get(Pe);return Ae===void 0?(Ae=es(A,V,j),Te.programVariants.set(Pe,Ae)):(Te.currentProgram=Ae,Te.uniformsList=null,Te.outputColorSpace=Y,Te.toneMapping=J),Ae}function Vs(A){if(A.uniformsList===null){let V=A.currentProgram.getUniforms();A.uniformsList=Xo.seqWithValue(V.seq,A.uniforms)}return A.uniformsList}function ra(A,V){let j=He.get(A);j.outputColorSpace=V.outputColorSpace,j.batching=V.batching,j.batchingColor=V.batchingColor,j.instancing=V.instancing,j.instancingColor=V.instancingColor,j.instancingMorph=V.instancingMorph,j.skinning=V.skinning,j.morphTargets=V.morphTargets,j.morphNormals=V.morphNormals,j.morphColors=V.morphColors,j.morphTargetsCount=V.morphTargetsCount,j.numClippingPlanes=V.numClippingPlanes,j.numIntersection=V.numClipIntersection,j.vertexAlphas=V.vertexAlphas,j.vertexTangents=V.vertexTangents,j.toneMapping=V.toneMapping}function oa(A,V,j,Y,J){V.isScene!==!0&&(V=Rn),Xe.resetTextureUnits();let Te=V.fog,Pe=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?V.environment:null,Ae=le===null?N.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:gt.workingColorSpace,Ie=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,ze=P.get(Y.envMap||Pe,Ie),tt=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,ht=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Be=!!j.morphAttributes.position,dt=!!j.morphAttributes.normal,sn=!!j.morphAttributes.color,Lt=ds;Y.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Lt=N.toneMapping);let Nt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,Cn=Nt!==void 0?Nt.length:0,Ue=He.get(Y),xn=R.state.lights;if(It===!0&&(mn===!0||A!==Q)){let Dt=A===Q&&Y.id===Z;se.setState(Y,A,Dt)}let pt=!1,vs=!1;Y.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==xn.state.version||J.isBatchedMesh&&Ue.batching===!1||!J.isBatchedMesh&&Ue.batching===!0||J.isBatchedMesh&&Ue.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&Ue.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&Ue.instancing===!1||!J.isInstancedMesh&&Ue.instancing===!0||J.isSkinnedMesh&&Ue.skinning===!1||!J.isSkinnedMesh&&Ue.skinning===!0||J.isInstancedMesh&&Ue.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Ue.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Ue.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Ue.instancingMorph===!1&&J.morphTexture!==null||Ue.envMap!==ze||Y.fog===!0&&Ue.fog!==Te||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==se.numPlanes||Ue.numIntersection!==se.numIntersection)||Ue.vertexAlphas!==tt||Ue.vertexTangents!==ht||Ue.morphTargets!==Be||Ue.morphNormals!==dt||Ue.morphColors!==sn||Ue.morphTargetsCount!==Cn||Ue.numLightProbeGrids!==fn(R.state.lightProbeGridArray)?pt=!0:(Ue.outputColorSpace!==Ae||Ue.toneMapping!==Lt)&&(vs=!0):(pt=!0,Ue.__version=Y.version);let vn=Ue.currentProgram;(pt===!0||vs===!0)&&(vn=vs===!0?ui(Y,V,J,Ae,Lt):es(Y,V,J),O&&Y.isNodeMaterial&&O.onUpdateProgram(Y,vn,Ue));let Jr=!1,ts=!1,_s=!1,ct=vn.getUniforms(),ln=Ue.uniforms;if(we.useProgram(vn.program)&&(Jr=!0,ts=!0,_s=!0),Y.id!==Z&&(Z=Y.id,ts=!0),Jr||Q!==A){we.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),ct.setValue(B,"projectionMatrix",A.projectionMatrix),ct.setValue(B,"viewMatrix",A.matrixWorldInverse);let _n=ct.map.cameraPosition;_n!==void 0&&_n.setValue(B,Dn.setFromMatrixPosition(A.matrixWorld)),rt.logarithmicDepthBuffer&&ct.setValue(B,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&ct.setValue(B,"isOrthographic",A.isOrthographicCamera===!0),Q!==A&&(Q=A,ts=!0,_s=!0)}if(Ue.needsLights&&(xn.state.sunShadowMap.length>0&&ct.setValue(B,"sunShadowMap",xn.state.sunShadowMap,Xe),xn.state.directionalShadowMap.length>0&&ct.setValue(B,"directionalShadowMap",xn.state.directionalShadowMap,Xe),xn.state.spotShadowMap.length>0&&ct.setValue(B,"spotShadowMap",xn.state.spotShadowMap,Xe),xn.state.pointShadowMap.length>0&&ct.setValue(B,"pointShadowMap",xn.state.pointShadowMap,Xe)),J.isSkinnedMesh){ct.setOptional(B,J,"bindMatrix"),ct.setOptional(B,J,"bindMatrixInverse");let Dt=J.skeleton;Dt&&(Dt.boneTexture===null&&Dt.computeBoneTexture(),ct.setValue(B,"boneTexture",Dt.boneTexture,Xe))}J.isBatchedMesh&&(ct.setOptional(B,J,"batchingTexture"),ct.setValue(B,"batchingTexture",J._matricesTexture,Xe),ct.setOptional(B,J,"batchingIdTexture"),ct.setValue(B,"batchingIdTexture",J._indirectTexture,Xe),ct.setOptional(B,J,"batchingColorTexture"),J._colorsTexture!==null&&ct.setValue(B,"batchingColorTexture",J._colorsTexture,Xe));let Kn=j.morphAttributes;if((Kn.position!==void 0||Kn.normal!==void 0||Kn.color!==void 0)&&re.update(J,j,vn),(ts||Ue.receiveShadow!==J.receiveShadow)&&(Ue.receiveShadow=J.receiveShadow,ct.setValue(B,"receiveShadow",J.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&V.environment!==null&&(ln.envMapIntensity.value=V.environmentIntensity),ln.dfgLUT!==void 0&&(ln.dfgLUT.value=RR()),ts){if(ct.setValue(B,"toneMappingExposure",N.toneMappingExposure),Ue.needsLights&&qr(ln,_s),Te&&Y.fog===!0&&_e.refreshFogUniforms(ln,Te),_e.refreshMaterialUniforms(ln,Y,ve,Me,R.state.transmissionRenderTarget[A.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let Dt=b,_n=0;for(let $n of R.state.lightProbeGridArray)$n.texture!==null&&(Dt.textures[_n]=$n.texture,Dt.min[_n]=$n.boundingBox.min,Dt.max[_n]=$n.boundingBox.max,Dt.resolution[_n]=$n.resolution,_n++);for(let $n in Dt)Dt[$n].length=_n;ln.probesSH.value=Dt.textures,ln.probesMin.value=Dt.min,ln.probesMax.value=Dt.max,ln.probesResolution.value=Dt.resolution}Xo.upload(B,Vs(Ue),ln,Xe)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(Xo.upload(B,Vs(Ue),ln,Xe),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&ct.setValue(B,"center",J.center),ct.setValue(B,"modelViewMatrix",J.modelViewMatrix),ct.setValue(B,"normalMatrix",J.normalMatrix),ct.setValue(B,"modelMatrix",J.matrixWorld),Y.uniformsGroups!==void 0){let Dt=Y.uniformsGroups;for(let _n=0,$n=Dt.length;_n<$n;_n++){let vl=Dt[_n];Ge.update(vl,vn),Ge.bind(vl,vn)}}return vn}function qr(A,V){A.ambientLightColor.needsUpdate=V,A.lightProbe.needsUpdate=V,A.sunLights.needsUpdate=V,A.sunLightShadows.needsUpdate=V,A.directionalLights.needsUpdate=V,A.directionalLightShadows.needsUpdate=V,A.pointLights.needsUpdate=V,A.pointLightShadows.needsUpdate=V,A.spotLights.needsUpdate=V,A.spotLightShadows.needsUpdate=V,A.rectAreaLights.needsUpdate=V,A.hemisphereLights.needsUpdate=V}function Hs(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(A,V,j){let Y=He.get(A);Y.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),He.get(A.texture).__webglTexture=V,He.get(A.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,V){let j=He.get(A);j.__webglFramebuffer=V,j.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(A,V=0,j=0){le=A,q=V,H=j;let Y=null,J=!1,Te=!1;if(A){let Ae=He.get(A);if(Ae.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(B.FRAMEBUFFER,Ae.__webglFramebuffer),ie.copy(A.viewport),de.copy(A.scissor),he=A.scissorTest,we.viewport(ie),we.scissor(de),we.setScissorTest(he),Z=-1;return}else if(Ae.__webglFramebuffer===void 0)Xe.setupRenderTarget(A);else if(Ae.__hasExternalTextures)Xe.rebindTextures(A,He.get(A.texture).__webglTexture,He.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let tt=A.depthTexture;if(Ae.__boundDepthTexture!==tt){if(tt!==null&&He.has(tt)&&(A.width!==tt.image.width||A.height!==tt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xe.setupDepthRenderbuffer(A)}}let Ie=A.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Te=!0);let ze=He.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(ze[V])?Y=ze[V][j]:Y=ze[V],J=!0):A.samples>0&&Xe.useMultisampledRTT(A)===!1?Y=He.get(A).__webglMultisampledFramebuffer:Array.isArray(ze)?Y=ze[j]:Y=ze,ie.copy(A.viewport),de.copy(A.scissor),he=A.scissorTest}else ie.copy(Fe).multiplyScalar(ve).floor(),de.copy(Ze).multiplyScalar(ve).floor(),he=Je;if(j!==0&&(Y=z),we.bindFramebuffer(B.FRAMEBUFFER,Y)&&we.drawBuffers(A,Y),we.viewport(ie),we.scissor(de),we.setScissorTest(he),J){let Ae=He.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+V,Ae.__webglTexture,j)}else if(Te){let Ae=V;for(let Ie=0;Ie<A.textures.length;Ie++){let ze=He.get(A.textures[Ie]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ie,ze.__webglTexture,j,Ae)}}else if(A!==null&&j!==0){let Ae=He.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ae.__webglTexture,j)}Z=-1};function Yr(A){let V=He.get(A);return(V.__readFormat!==A.format||V.__readType!==A.type)&&(V.__readFormat=A.format,V.__readType=A.type,V.__formatReadable=rt.textureFormatReadable(A.format),V.__typeReadable=rt.textureTypeReadable(A.type)),V}this.readRenderTargetPixels=function(A,V,j,Y,J,Te,Pe,Ae=0){if(!(A&&A.isWebGLRenderTarget)){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=He.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){we.bindFramebuffer(B.FRAMEBUFFER,Ie);try{let ze=A.textures[Ae],tt=ze.format,ht=ze.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ae);let Be=Yr(ze);if(Be.__formatReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=A.width-Y&&j>=0&&j<=A.height-J&&B.readPixels(V,j,Y,J,xe.convert(tt),xe.convert(ht),Te)}finally{let ze=le!==null?He.get(le).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(A,V,j,Y,J,Te,Pe,Ae=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=He.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(V>=0&&V<=A.width-Y&&j>=0&&j<=A.height-J){we.bindFramebuffer(B.FRAMEBUFFER,Ie);let ze=A.textures[Ae],tt=ze.format,ht=ze.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ae);let Be=Yr(ze);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let dt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,dt),B.bufferData(B.PIXEL_PACK_BUFFER,Te.byteLength,B.STREAM_READ),B.readPixels(V,j,Y,J,xe.convert(tt),xe.convert(ht),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let sn=le!==null?He.get(le).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,sn);let Lt=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await rv(B,Lt,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,dt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Te),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(dt),B.deleteSync(Lt),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,V=null,j=0){let Y=Math.pow(2,-j),J=Math.floor(A.image.width*Y),Te=Math.floor(A.image.height*Y),Pe=V!==null?V.x:0,Ae=V!==null?V.y:0;Xe.setTexture2D(A,0),B.copyTexSubImage2D(B.TEXTURE_2D,j,0,0,Pe,Ae,J,Te),we.unbindTexture()},this.copyTextureToTexture=function(A,V,j=null,Y=null,J=0,Te=0){let Pe,Ae,Ie,ze,tt,ht,Be,dt,sn,Lt=A.isCompressedTexture?A.mipmaps[Te]:A.image;if(j!==null)Pe=j.max.x-j.min.x,Ae=j.max.y-j.min.y,Ie=j.isBox3?j.max.z-j.min.z:1,ze=j.min.x,tt=j.min.y,ht=j.isBox3?j.min.z:0;else{let ct=Math.pow(2,-J);Pe=Math.floor(Lt.width*ct),Ae=Math.floor(Lt.height*ct),A.isDataArrayTexture?Ie=Lt.depth:A.isData3DTexture?Ie=Math.floor(Lt.depth*ct):Ie=1,ze=0,tt=0,ht=0}Y!==null?(Be=Y.x,dt=Y.y,sn=Y.z):(Be=0,dt=0,sn=0);let Nt=xe.convert(V.format),Cn=xe.convert(V.type),Ue;V.isData3DTexture?(Xe.setTexture3D(V,0),Ue=B.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(Xe.setTexture2DArray(V,0),Ue=B.TEXTURE_2D_ARRAY):(Xe.setTexture2D(V,0),Ue=B.TEXTURE_2D),we.activeTexture(B.TEXTURE0),we.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,V.flipY),we.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),we.pixelStorei(B.UNPACK_ALIGNMENT,V.unpackAlignment);let xn=we.getParameter(B.UNPACK_ROW_LENGTH),pt=we.getParameter(B.UNPACK_IMAGE_HEIGHT),vs=we.getParameter(B.UNPACK_SKIP_PIXELS),vn=we.getParameter(B.UNPACK_SKIP_ROWS),Jr=we.getParameter(B.UNPACK_SKIP_IMAGES);we.pixelStorei(B.UNPACK_ROW_LENGTH,Lt.width),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Lt.height),we.pixelStorei(B.UNPACK_SKIP_PIXELS,ze),we.pixelStorei(B.UNPACK_SKIP_ROWS,tt),we.pixelStorei(B.UNPACK_SKIP_IMAGES,ht);let ts=A.isDataArrayTexture||A.isData3DTexture,_s=V.isDataArrayTexture||V.isData3DTexture;if(A.isDepthTexture){let ct=He.get(A),ln=He.get(V),Kn=He.get(ct.__renderTarget),Dt=He.get(ln.__renderTarget);we.bindFramebuffer(B.READ_FRAMEBUFFER,Kn.__webglFramebuffer),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,Dt.__webglFramebuffer);for(let _n=0;_n<Ie;_n++)ts&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,He.get(A).__webglTexture,J,ht+_n),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,He.get(V).__webglTexture,Te,sn+_n)),B.blitFramebuffer(ze,tt,ze+Pe,tt+Ae,Be,dt,Be+Pe,dt+Ae,B.DEPTH_BUFFER_BIT,B.NEAREST);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(J!==0||A.isRenderTargetTexture||He.has(A)){let ct=He.get(A),ln=He.get(V);we.bindFramebuffer(B.READ_FRAMEBUFFER,D),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,W);for(let Kn=0;Kn<Ie;Kn++)ts?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ct.__webglTexture,J,ht+Kn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ct.__webglTexture,J),_s?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ln.__webglTexture,Te,sn+Kn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ln.__webglTexture,Te),J!==0?B.blitFramebuffer(ze,tt,ze+Pe,tt+Ae,Be,dt,Be+Pe,dt+Ae,B.COLOR_BUFFER_BIT,B.NEAREST):_s?B.copyTexSubImage3D(Ue,Te,Be,dt,sn+Kn,ze,tt,Pe,Ae):B.copyTexSubImage2D(Ue,Te,Be,dt,ze,tt,Pe,Ae);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else _s?A.isDataTexture||A.isData3DTexture?B.texSubImage3D(Ue,Te,Be,dt,sn,Pe,Ae,Ie,Nt,Cn,Lt.data):V.isCompressedArrayTexture?B.compressedTexSubImage3D(Ue,Te,Be,dt,sn,Pe,Ae,Ie,Nt,Lt.data):B.texSubImage3D(Ue,Te,Be,dt,sn,Pe,Ae,Ie,Nt,Cn,Lt):A.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Te,Be,dt,Pe,Ae,Nt,Cn,Lt.data):A.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Te,Be,dt,Lt.width,Lt.height,Nt,Lt.data):B.texSubImage2D(B.TEXTURE_2D,Te,Be,dt,Pe,Ae,Nt,Cn,Lt);we.pixelStorei(B.UNPACK_ROW_LENGTH,xn),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,pt),we.pixelStorei(B.UNPACK_SKIP_PIXELS,vs),we.pixelStorei(B.UNPACK_SKIP_ROWS,vn),we.pixelStorei(B.UNPACK_SKIP_IMAGES,Jr),Te===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&B.generateMipmap(Ue),we.unbindTexture()},this.initRenderTarget=function(A){He.get(A).__webglFramebuffer===void 0&&Xe.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Xe.setTextureCube(A,0):A.isData3DTexture?Xe.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Xe.setTexture2DArray(A,0):Xe.setTexture2D(A,0),we.unbindTexture()},this.resetState=function(){q=0,H=0,le=null,we.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ii}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=gt._getDrawingBufferColorSpace(e),t.unpackColorSpace=gt._getUnpackColorSpace()}};var al=1e30,CR="1e20",PR=`
#ifdef COPIES
attribute vec2 copyRotation;
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
varying vec3 vNormal;
varying vec3 vEye;
#endif
#ifdef CUT
uniform vec4 cutPlane;
centroid varying float vCut;
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
`,IR=`
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
varying vec3 vNormal;
varying vec3 vEye;
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
    base = vField > ${CR} ? noValue : texture2D(scale, vec2(clamp(fraction, 0.0, 1.0) * 0.99609375 + 0.001953125, 0.5)).rgb;
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
`,Ui=class extends Di{cuttable;constructor(e,t,i={},s){super({vertexShader:PR,fragmentShader:IR,defines:Object.fromEntries(t.map(r=>[r,""])),...i}),this.uniforms={cutPlane:e.cutPlane,deformation:e.deformation,limits:e.limits,scale:e.scale,noValue:e.noValue,pixelRatio:e.pixelRatio,colour:s??{value:new at},opacity:{value:1},useField:{value:!1},bias:{value:0}},this.cuttable=!t.includes("CAP")&&!t.includes("ON_PLANE")}get colour(){return this.uniforms.colour.value}set alpha(e){this.uniforms.opacity.value=e,this.transparent=e<1}set useField(e){this.uniforms.useField.value=e}set bias(e){this.uniforms.bias.value=e}set cut(e){!this.cuttable||e==="CUT"in this.defines||(e?this.defines.CUT="":delete this.defines.CUT,this.needsUpdate=!0)}};function Wv(n){return{cutPlane:{value:new Kt(0,0,1,0)},deformation:{value:0},limits:{value:new vt(0,1)},scale:{value:n},noValue:{value:new at("#9a9a9a")},lineColour:{value:new at("#1c2733")},edgeColour:{value:new at("#1c2733")},pixelRatio:{value:1}}}function Sp(n,e){let t=e?["COPIES","DEFORMED"]:["COPIES"],i=(r,o)=>new Ui(n,t,{side:r,colorWrite:!1,depthWrite:!1,depthTest:!1,stencilWrite:!0,stencilFunc:Hu,stencilFail:o,stencilZFail:o,stencilZPass:o}),s=(r,o,a=t)=>{let l=new Ui(n,a,{depthWrite:!1},r);return l.alpha=o,l};return{surface:new Ui(n,e?["COPIES","DEFORMED","FIELD","LIT"]:["COPIES","LIT"],{polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),features:s(n.lineColour,.55),edges:s(n.edgeColour,.3),stencilBack:i(Xn,Qf),stencilFront:i(Fi,ep),section:new Ui(n,["FIELD","CAP"],{side:zn,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),sectionEdges:s(n.edgeColour,.34,["ON_PLANE"])}}function Xv(n){return new Ui(n,["CAP"],{side:zn,stencilWrite:!0,stencilRef:0,stencilFunc:tp,stencilFail:tl,stencilZFail:tl,stencilZPass:tl})}var Ju=class{group=new rn;materials;#e=new hn;#t;#n=null;#i;#s="";markLine=new Nr(new hn,new ar({color:"#e07b1f",transparent:!0,depthTest:!1}));constructor(e){let t=new Ui(e,["FIELD"],{side:zn}),i=new Ui(e,["FIELD"],{side:zn,depthFunc:Lo,depthWrite:!1});i.alpha=.5,t.useField=i.useField=!0,this.#i=i,this.materials=[t,i];let s=this.materials.map(r=>new bt(this.#e,r));for(let r of s)r.frustumCulled=!1,r.matrixAutoUpdate=!1,this.group.add(r);this.#t=s[1],this.#t.renderOrder=99999,s[0].renderOrder=5,this.markLine.geometry.setAttribute("position",new St(new Float32Array(12),3)),this.markLine.frustumCulled=!1,this.markLine.matrixAutoUpdate=!1,this.markLine.renderOrder=25e4,this.markLine.visible=!1}mark(e,t){let i=e!==null&&t>=0&&t<e.count;if(!i&&!this.markLine.visible)return!1;if(this.markLine.visible=i,!i)return!0;let s=this.markLine.geometry.getAttribute("position");return s.array.set(e.corners.subarray(12*t,12*t+12)),s.needsUpdate=!0,!0}setBias(e){for(let t of this.materials)t.bias=e;this.#i.bias=0}setBehind(e){this.#t.visible=e}get contacts(){return this.#n}set(e,t,i){if(e===this.#n&&t===this.#s||(this.#n=e,this.#s=t,this.mark(null,-1),this.#e.dispose(),this.group.visible=e!==null,!e))return;let s=[];for(let l=0;l<e.count;l++)e.pressures[l]>0&&i(l)&&s.push(l);let r=new Float32Array(12*s.length),o=new Float32Array(4*s.length),a=new Uint32Array(6*s.length);s.forEach((l,c)=>{r.set(e.corners.subarray(12*l,12*l+12),12*c),o.fill(e.pressures[l],4*c,4*c+4);let u=4*c;a.set([u,u+1,u+2,u,u+2,u+3],6*c)}),this.#e.setAttribute("position",new St(r,3)),this.#e.setAttribute("field",new St(o,1)),this.#e.setIndex(new St(a,1))}dispose(){this.#e.dispose(),this.markLine.geometry.dispose();for(let e of this.materials)e.dispose()}},$v={Flank:0,Edge:1};function cl(n,e,t){return t==="all"||n.zones[e]===(t==="edges"?$v.Edge:$v.Flank)}var LR=1.5;function ll(n,e){return n.pressures.reduce((t,i,s)=>cl(n,s,e)?Math.max(t,i):t,0)}function qv(n){let e=ll(n,"flanks");return e>0&&ll(n,"all")>LR*e}function Yv(n){let e=new Map,t=n.corners;for(let i=0;i<n.count;i++){let s=12*i,r=t[s+6]-t[s],o=t[s+7]-t[s+1],a=t[s+8]-t[s+2],l=t[s+9]-t[s+3],c=t[s+10]-t[s+4],u=t[s+11]-t[s+5],d=.5*Math.hypot(o*u-a*c,a*l-r*u,r*c-o*l),h=`${n.parts[2*i]} ${n.parts[2*i+1]}`;e.set(h,(e.get(h)??0)+n.pressures[i]*d)}return e}var Zu=class{constructor(e){this.core=e}core;playing=!1;#e=0;toggle(){this.playing?this.stop():this.start()}start(){let e=this.core.positions?.list.length??0;this.playing||e<2||(this.playing=!0,this.play(++this.#e),this.core.changed(!1))}stop(){this.playing&&(this.playing=!1,this.#e++,this.core.changed(!1))}step(e){this.stop();let t=this.next(e,!0);t!==null&&this.core.goTo(t)}next(e,t){let i=this.core.positions?.list.length??0;if(i===0)return null;let s=this.core.state.position+e;return s>=0&&s<i?s:t?(s+i)%i:null}async play(e){let{core:t}=this,i=t.positions?.list.length??0;for(!t.state.animation.loop&&t.state.position===i-1&&await t.goTo(0);e===this.#e;){let s=performance.now()+1e3/Math.max(.1,t.state.animation.speed),r=this.next(1,t.state.animation.loop);if(r===null)break;if(await t.positions?.load(r).catch(()=>null),await new Promise(o=>setTimeout(o,Math.max(0,s-performance.now()))),e!==this.#e)return;await t.goTo(r),await new Promise(requestAnimationFrame)}e===this.#e&&this.stop()}};var Jv="CALYXARR";var nn=class extends Error{constructor(t,i){super(`${t}: ${i}`);this.file=t;this.reason=i;this.name="FileError"}file;reason},qo=class n{constructor(e,t,i,s){this.name=e;this.header=t;this.buffer=i;this.start=s}name;header;buffer;start;static parse(e,t){if(t.byteLength<16)throw new nn(e,`the file is truncated: it has ${t.byteLength} bytes, the header needs 16`);let i=new DataView(t);if(new TextDecoder("latin1").decode(new Uint8Array(t,0,8))!==Jv)throw new nn(e,`not an array file: it does not begin with ${Jv}`);let r=i.getUint32(8,!0);if(r<4)throw new nn(e,"written by an older version of Calyx: run the model again");if(r>4)throw new nn(e,`version ${r} of the format is not supported; this viewer reads version 4`);let o=i.getUint32(12,!0),a=16+o;if(a>t.byteLength)throw new nn(e,`the file is truncated: it has ${t.byteLength} bytes, the header ends at ${a}`);let l;try{l=JSON.parse(new TextDecoder("utf-8",{fatal:!0}).decode(new Uint8Array(t,16,o)))}catch{throw new nn(e,"the header is not valid JSON")}if(typeof l!="object"||l===null||Array.isArray(l))throw new nn(e,"the header is not a JSON object");return new n(e,l,t,a)}f32(e,t,i){let{offset:s,length:r}=this.locate(e,"f32",t,i);return new Float32Array(this.buffer,s,r)}f64(e,t,i){let{offset:s,length:r}=this.locate(e,"f64",t,i);return s%8===0?new Float64Array(this.buffer,s,r):new Float64Array(this.buffer.slice(s,s+8*r))}u32(e,t,i){let{offset:s,length:r}=this.locate(e,"u32",t,i);return new Uint32Array(this.buffer,s,r)}locate(e,t,i,s){let r=p=>{throw new nn(this.name,`${s}: ${p}`)};if(typeof e!="object"||e===null)return r("the array is missing");let o=e;if(o.type!==t)return r(`the array has type ${String(o.type)}, expected ${t}`);if(o.components!==i)return r(`the array has ${String(o.components)} components, expected ${i}`);let{count:a,offset:l}=o,c=p=>Number.isSafeInteger(p)&&p>=0;if(!c(a)||!c(l))return r("the size or the offset of the array is not a whole number");let u=t==="f64"?8:4;if(l%u!==0)return r(`the offset ${l} is not aligned`);let d=a*i,h=this.start+l+d*u;if(h>this.buffer.byteLength)return r(`the file is truncated: it has ${this.buffer.byteLength} bytes, the array ends at ${h}`);let f=this.start+l;return f%u!==0?r("the header's length is not a multiple of 8"):{offset:f,length:d}}};var Ku=256,Mp={viridis:{label:"Viridis",colours:["#440154","#482475","#414487","#355f8d","#2a788e","#21918c","#22a884","#44bf70","#7ad151","#bddf26","#fde725"]},cividis:{label:"Cividis",colours:["#00224e","#123570","#3b496c","#575d6d","#707173","#8a8678","#a59c74","#c3b369","#e1cc55","#fee838"]},turbo:{label:"Turbo",colours:["#30123b","#4145ab","#4675ed","#39a2fc","#1bcfd4","#24eca6","#61fc6c","#a4fc3b","#d1e834","#f3c63a","#fe9b2d","#f36315","#d93806","#b11901","#7a0402"]},grey:{label:"Grey",colours:["#1a1a1a","#f2f2f2"]}},Kv=Object.entries(Mp).map(([n,{label:e}])=>({name:n,label:e}));function Zv(n){let e=parseInt(n.slice(1),16);return[e>>16&255,e>>8&255,e&255]}function fr(n,e){let{colours:t}=Mp[n]??Mp.viridis,i=Math.min(Math.max(e,0),1)*(t.length-1),s=Math.min(Math.floor(i),t.length-2),r=Zv(t[s]),o=Zv(t[s+1]),a=i-s;return r.map((l,c)=>Math.round(l+a*(o[c]-l)))}function Vr(n,e){if(e<1)return n;let t=Math.min(Math.max(Math.floor(n*e),0),e-1);return e===1?.5:t/(e-1)}function Hr([n,e,t]){return`rgb(${n} ${e} ${t})`}function jv(n,e,t){let i=n.image.data;for(let r=0;r<Ku;r++){let[o,a,l]=fr(e,Vr(r/(Ku-1),t));i.set([o,a,l,255],4*r)}let s=t>0?En:Wn;n.minFilter=s,n.magFilter=s,n.needsUpdate=!0}function Qv(){let n=new Uo(new Uint8Array(4*Ku),Ku,1,wi);return n.colorSpace=ii,n}var e_=["#7f9db9","#c9a66b","#8fb09a","#b58a9b","#9a95bd","#b9b08a","#76a9ae","#c08f76"],NR={gear:e_,shaft:["#a9adb3","#b7b2aa","#9ea6ac"],bearing:["#8a8f98","#969089"],body:["#b4bcc4","#c0b9ae","#aab7b0"]};function t_(n,e){let t=NR[n]??e_;return t[e%t.length]}var n_={x:[1,0,0],y:[0,1,0],z:[0,0,1]},ju=class{group=new rn;capGeometry=new Fr(2,2);capMatrix=new yt;normal=new G(0,0,1);range=[-1,1];offset=0;#e;#t=new rn;#n=new G;#i=1;#s=new G;constructor(){let e=[-1,-1,0,1,-1,0,1,1,0,-1,1,0],t=new hn;t.setAttribute("position",new Wt(e,3)),this.#e=new Nr(t,new ar({color:"#e07b1f",transparent:!0,opacity:.8}));let i=new or({color:"#e07b1f",transparent:!0,depthTest:!1}),s=new Dr(.022,.05,20).rotateX(Math.PI/2),r=new bt(s.clone().translate(0,0,.062),i),o=new bt(s.clone().rotateY(Math.PI).translate(0,0,-.062),i),a=new bt(new Wa(.021,20,14),i);this.#t.add(r,o,a);for(let l of this.#t.children)l.renderOrder=3e5;this.group.add(this.#e,this.#t),this.group.visible=!1}setBounds(e,t){this.#n.copy(e),this.#i=t}apply(e,t){let i=typeof e.normal=="string"?n_[e.normal]??n_.z:e.normal;this.normal.set(i[0],i[1],i[2]),this.normal.lengthSq()>0||this.normal.set(0,0,1),this.normal.normalize();let s=this.normal.dot(this.#n);this.range=[s-this.#i,s+this.#i],this.offset=e.offset??s;let r=e.flipped?-1:1;t.set(r*this.normal.x,r*this.normal.y,r*this.normal.z,-r*this.offset),this.group.visible=e.on;let o=this.#n.clone().addScaledVector(this.normal,this.offset-s),a=new Li().setFromUnitVectors(new G(0,0,1),this.normal),l=1.02*this.#i;this.capMatrix.compose(o,a,new G(1.5*l,1.5*l,1)),this.#e.position.copy(o),this.#e.quaternion.copy(a),this.#e.scale.set(.86*l,.86*l,1),this.#t.quaternion.copy(a),this.#t.position.set(.86*l,.86*l,0).applyQuaternion(a).add(o),this.#t.scale.setScalar(l)}get handle(){return this.#t.position}setHighlight(e){for(let t of this.#t.children)t.material.color.set(e?"#ffa648":"#e07b1f")}drag(e,t,i,s,r){let o=.01*this.#i,a=this.#s.copy(this.handle).project(i),l=a.x,c=a.y,u=this.#s.copy(this.handle).addScaledVector(this.normal,o).project(i),d=(u.x-l)*s/2,h=-(u.y-c)*r/2,f=d*d+h*h;return f<.02?-t*o/2:(e*d+t*h)/f*o}};function DR(n,e,t,i,s,r){let o=Math.max(Math.abs(n),Math.abs(e),Math.abs(t),Math.abs(i),Math.abs(s),Math.abs(r));if(!Number.isFinite(o))return[NaN,NaN,NaN];if(o===0)return[0,0,0];let a=(n+e+t)/3,l=(n-e)/o,c=(e-t)/o,u=(t-n)/o,d=(l-u)/3,h=(c-l)/3,f=(u-c)/3,p=i/o,v=s/o,m=r/o,g=(l*l+c*c+u*u)/6+p*p+v*v+m*m;if(g===0)return[a,a,a];let _=d*(h*f-p*p)-m*(m*f-p*v)+v*(m*p-h*v),M=2*g/3,b=Math.SQRT2,C=d*d+m*m+v*v-M,R=h*h+m*m+p*p-M,y=f*f+p*p+v*v-M,E=b*(v*m-d*p),U=b*(p*m-h*v),N=b*(p*v-f*m),L=b*p,O=b*v,z=b*m,D=(d*R-h*C)**2+(d*y-f*C)**2+(h*y-f*R)**2+(d*E-L*C)**2+(d*U-O*C)**2+(d*N-z*C)**2+(h*E-L*R)**2+(h*U-O*R)**2+(h*N-z*R)**2+(f*E-L*y)**2+(f*U-O*y)**2+(f*N-z*y)**2+(L*U-O*E)**2+(L*N-z*E)**2+(O*N-z*U)**2,W=Math.atan2(Math.sqrt(3*D),Math.sqrt(27)*_)/3,q=2*Math.sqrt(g/3)*o,H=2*Math.PI/3;return[a+q*Math.cos(W),a+q*Math.cos(W-H),a+q*Math.cos(W+H)]}function FR(n,e,t,i,s,r){let o=n-e,a=e-t,l=t-n;return Math.sqrt(.5*(o*o+a*a+l*l)+3*(i*i+s*s+r*r))}function Hn(n){return n!=="plain"&&n!=="contact_pressure"}var Ei={plain:{label:"Plain",quantity:"none"},contact_pressure:{label:"Contact pressure",quantity:"stress"},max_principal:{label:"Maximum principal stress",quantity:"stress"},min_principal:{label:"Minimum principal stress",quantity:"stress"},von_mises:{label:"Von Mises stress",quantity:"stress"},stress_error:{label:"Stress error",quantity:"stress"},displacement:{label:"Displacement",quantity:"length"}},Yo={stress_error:"Estimated error of the stresses, as von Mises stress: the difference between the averaged stresses at a node and those of its elements (Zienkiewicz and Zhu). Where it is large, a finer mesh changes the stresses. It is largest at contacts, whose loads are concentrated at nodes: automatic limits leave out the largest values, so that the fillets and the body are visible."},Qu="Contact pressure and plain colours show the undeformed shape, because contact cells and plain parts have no elastic displacements. Choose a stress or the displacement to see the deformation, or set a factor.";function wp(n){return n==="stress_error"?.9:1}function s_(n){return n==="min_principal"?"minimum":"maximum"}function UR(n,e,t){if(e==="displacement"){let h=n.displacements;return Math.hypot(h[3*t],h[3*t+1],h[3*t+2])}if(e==="stress_error")return n.stressErrors?.[t]??NaN;let i=n.stresses,s=6*t,[r,o,a,l,c,u]=[i[s],i[s+1],i[s+2],i[s+3],i[s+4],i[s+5]];if(e==="von_mises")return FR(r,o,a,l,c,u);let d=DR(r,o,a,l,c,u);return e==="max_principal"?d[0]:d[2]}function r_(n){let e={min:1/0,max:-1/0,minIndex:-1,maxIndex:-1};for(let t=0;t<n.length;t++){let i=n[t];i<e.min&&i!==-1/0&&(e.min=i,e.minIndex=t),i>e.max&&i!==1/0&&(e.max=i,e.maxIndex=t)}return e.minIndex<0||e.maxIndex<0?null:e}var i_=new WeakMap;function Ep(n){let e=i_.get(n);if(e)return e;e=new Uint8Array(n.points.length/3);for(let t=0;t<n.triangles.length;t++)e[n.triangles[t]]=1;return i_.set(n,e),e}function o_(n,e){let t=n.shape.points.length/3,i=new Float64Array(t);for(let s=0;s<t;s++)i[s]=UR(n,e,s);return i}function OR(n){return n.match(/[\s.:/]*[^\s.:/]+/g)??[n]}function a_(n){let e=0;for(;n.every(t=>e+1<t.length&&t[e]===n[0][e]);)e++;return e}function l_(n){let e=[...new Set(n)],t=new Map;if(e.length<2)return new Map(e.map(a=>[a,a]));let i=e.map(OR),s=a_(i),r=i.map(a=>a.slice(s).reverse()),o=a_(r);return e.forEach((a,l)=>t.set(a,r[l].slice(o).reverse().join("").replace(/^[\s.:/]+/,""))),t}var Tp=12;function c_(n){return n.length>Tp+4?[n.slice(0,-Tp),n.slice(-Tp)]:["",n]}var kR={Pa:[[1e6,"MPa",1e-6],[1e3,"kPa",.001],[0,"Pa",1]],m:[[1e-4,"mm",1e3],[1e-7,"µm",1e6],[0,"nm",1e9]],N:[[1e3,"kN",.001],[0,"N",1]],"N m":[[1e3,"kN m",.001],[0,"N m",1]],W:[[1e3,"kW",.001],[0,"W",1]],s:[[1,"s",1],[.001,"ms",1e3],[0,"µs",1e6]],rad:[[.1,"rad",1],[1e-4,"mrad",1e3],[0,"µrad",1e6]]},BR={Pa:[[0,"psi",1/6894.757293168361]],m:[[0,"inch",1/.0254]],N:[[0,"lbf",1/4.4482216152605]],"N m":[[0,"lbf inch",1/.1129848290276167]]},u_=!1;function h_(n){u_=/^(inch|ft|foot)_/.test(n)}function Tn(n,e){let t=n.replace("·"," "),i=(u_?BR[t]:void 0)??kR[t];if(!i)return{symbol:n==="1"?"":n,factor:1};let s=Math.abs(e);if(!(s>0))return{symbol:i[0][1],factor:i[0][2]};let r=i.find(([o])=>s>=o)??i[i.length-1];return{symbol:r[1],factor:r[2]}}function Oi(){return Tn("Pa",0)}var zR="−";function Ut(n,e=4){if(Number.isNaN(n))return"no value";if(n===0)return"0";let t=Math.abs(n),i;if(t>=1e6||t<1e-4)i=n.toExponential(e-1).replace("e+","e");else{let s=Math.max(0,e-1-Math.floor(Math.log10(t)));i=n.toFixed(Math.min(s,12)),i.includes(".")&&(i=i.replace(/\.?0+$/,""))}return i.replaceAll("-",zR)}function d_(n,e,t=4){if(!Number.isFinite(n))return"no value";let i=Tn(e,n);return`${Ut(n*i.factor,t)} ${i.symbol}`.trim()}function f_(n){if(!(n>0)||!Number.isFinite(n))return n;let e=10**Math.floor(Math.log10(n)),t=n/e,i=t>=5?5:t>=2?2:1;return Number((i*e).toPrecision(3))}var p_={bearing:"#2f6fb5",mesh:"#c2502b"},VR=new G(0,1,0),eh=class{group=new rn;labels=[];#e=new ko(1,1,1,20).translate(0,.5,0);#t=new Dr(1,1,24).translate(0,.5,0);#n;#i=new bt(new hn,new or({transparent:!0}));constructor(e){let t=i=>{let s=new Ui(e,["LIT"],{transparent:!0});return s.colour.set(i),s};this.#n={bearing:t(p_.bearing),mesh:t(p_.mesh)},this.#i.renderOrder=2e5,this.#i.frustumCulled=!1,this.#i.onBeforeRender=i=>i.clearDepth()}set(e,t){this.group.clear(),this.labels=[];let i=({kind:o,parts:a})=>o==="mesh"?t.names[a[0]??-1]:void 0,s=l_(e.flatMap(o=>[o.name,i(o)??""]).filter(o=>o!=="")),r=0;for(let{force:o}of e)r=Math.max(r,Math.hypot(...o));if(r>0){this.group.add(this.#i);for(let o of e){if(o.kind==="bearing"?!t.bearings:!t.meshes)continue;let a=Math.hypot(...o.force);if(!(a>0))continue;let l=t.scale*.5*t.radius*a/r,c=this.arrow(o,l,t.radius*.011);this.group.add(c);let u=new G(...o.force).multiplyScalar(l/a).add(new G(...o.point));if(t.labels){let d=s.get(o.name)??o.name,h=i(o),f=h&&s.get(h),p=`${d?`${d}: `:""}${d_(a,"N",3)}${f?` on ${f}`:""}`;this.labels.push({text:p,point:u,kind:o.kind,weight:a})}}}}arrow(e,t,i){let s=this.#n[e.kind],r=new rn,o=Math.min(5.2*i,.45*t),a=new bt(this.#e,s);a.scale.set(.55*i,t-o,.55*i);let l=new bt(this.#t,s);l.scale.set(.33*o,o,.33*o),l.position.y=t-o,r.add(a,l),r.position.set(...e.point),r.quaternion.setFromUnitVectors(VR,new G(...e.force).normalize());for(let c of[a,l])c.renderOrder=200001;return r}dispose(){this.#e.dispose(),this.#t.dispose(),this.#i.geometry.dispose(),this.#i.material.dispose();for(let e of Object.values(this.#n))e.dispose()}};function m_(n,e){let t=[],i=g_(n,e);for(let s=0;s<n.length;s+=2){for(let r of[n[s+1],n[s]])t.push(e[3*r],e[3*r+1],e[3*r+2]);t.push(...i)}return t}function g_(n,e){return[0,1,2].map(t=>n.reduce((i,s)=>i+e[3*s+t],0)/Math.max(n.length,1))}function HR(n){let e=new Map,t=s=>{let r=s;for(let o=e.get(r);o!==void 0&&o!==r;o=e.get(r))r=o;return e.set(s,r),r};for(let s=0;s<n.length;s+=2)e.set(t(n[s]),t(n[s+1]));let i=new Map;for(let s=0;s<n.length;s+=2){let r=t(n[s]),o=i.get(r)??[];o.push(n[s],n[s+1]),i.set(r,o)}return[...i.values()]}function x_(n,e){return[e.stencilBack,e.stencilFront].map(t=>{let i=new bt(n,t);return i.frustumCulled=!1,i.matrixAutoUpdate=!1,i})}var th=class{geometry=new Ji;meshes;#e;#t;constructor(e,t,i,s){this.#e=HR(e.openEdges);let r=this.#e.flatMap(o=>m_(o,t));this.#t=new Wt(new Float32Array(r.length),3),this.geometry.setAttribute("position",new Wt(r,3)),this.geometry.setAttribute("displacement",this.#t),this.geometry.setAttribute("copyRotation",i),this.geometry.instanceCount=r.length>0?1:0,this.meshes=x_(this.geometry,s)}setDisplacements(e){let t=this.#t.array,i=0;for(let s of this.#e){let r=g_(s,e);for(let o=0;o<s.length;o+=2){for(let a of[s[o+1],s[o]])for(let l=0;l<3;l++)t[i++]=e[3*a+l];for(let a=0;a<3;a++)t[i++]=r[a]}}this.#t.needsUpdate=!0}};function GR(n,e,t){let i=[];for(let l=0;l<n.length;l+=2){let[c,u]=[3*n[l],3*n[l+1]];i.push([e[c]+e[u],e[c+1]+e[u+1],e[c+2]+e[u+2]])}let[s,r]=[Math.cos(2*Math.PI/t),Math.sin(2*Math.PI/t)],o=([l,c,u],d)=>{let[h,f]=[s*l+d*r*c,s*c-d*r*l],p=1/0;for(let[v,m,g]of i)p=Math.min(p,(v-h)**2+(m-f)**2+(g-u)**2);return p},a={1:[],[-1]:[]};return i.forEach((l,c)=>{let u=o(l,1)<=o(l,-1)?1:-1;a[u].push(n[2*c],n[2*c+1])}),a}var nh=class{constructor(e,t,i,s){this.copies=i;let r=GR(e.openEdges,t,i);this.#e=[1,-1].map(o=>{let a=r[o],l=new Ji;l.setAttribute("position",new Wt(m_(a,t),3));let c=new Ls(new Float32Array(2*i),2);return l.setAttribute("copyRotation",c),l.instanceCount=0,{geometry:l,rotation:c,next:o}}),this.meshes=this.#e.flatMap(({geometry:o})=>x_(o,s))}copies;meshes;#e;set(e){for(let{geometry:t,rotation:i,next:s}of this.#e){let r=0;if(e.size>0){for(let o=0;o<this.copies;o++){if(e.has(o)||!e.has((o+s+this.copies)%this.copies))continue;let a=2*Math.PI*o/this.copies;i.setXY(r++,Math.cos(a),Math.sin(a))}i.needsUpdate=!0}t.instanceCount=r}}dispose(){for(let{geometry:e}of this.#e)e.dispose()}};function __({tetrahedra:n,wedges:e,hexahedra:t}){return n.length+e.length+t.length>0}var WR=[[0,1,2],[3,4,5],[0,1,4,3],[1,2,5,4],[2,0,3,5]],XR=[[0,1,2,3],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]];function $R(n,e,t,i){let s=0;for(let a=1;a<n.length;a++)n[a]<n[s]&&(s=a);let r=e.map(a=>a.reduce((l,c)=>l|1<<c,0)),o=(...a)=>{let l=a.reduce((c,u)=>c|1<<u,0);return r.some(c=>(c&l)===l)};for(let a of e){if(a.includes(s))continue;let l=0;a.forEach((c,u)=>l=n[c]<n[a[l]]?u:l);for(let c=1;c+1<a.length;c++){let[u,d,h]=[a[l],a[(l+c)%a.length],a[(l+c+1)%a.length]];t.push(n[s],n[u],n[d],n[h]),i.push(1|(o(s,d,h)?2:0)|(o(s,u,h)?4:0)|(o(s,u,d)?8:0))}}}var v_=new WeakMap;function y_(n){let e=v_.get(n);if(e)return e;let t=[],i=[];for(let[a,l,c]of[[n.wedges,6,WR],[n.hexahedra,8,XR]])for(let u=0;u<a.length;u+=l)$R(a.subarray(u,u+l),c,t,i);let{tetrahedra:s}=n,r=new Uint32Array(s.length+t.length);r.set(s),r.set(t,s.length);let o=new Uint8Array(r.length/4).fill(15);return o.set(i,s.length/4),e={nodes:r,borders:o},v_.set(n,e),e}var qR=1e-13,sh=class{points=new Float32Array(9*1024);values=new Float32Array(3*1024);sources=new Uint32Array(1024);count=0;edges=new Float32Array(6*2048);edgeCount=0;#e=new Float64Array;#t=new Float64Array(12);#n=new Float64Array(4);compute(e,t,i,s,r,o){let{nodes:a,borders:l}=y_(e.shape),c=this.measure(e,i,s);this.count=0,this.edgeCount=0;for(let u=0;u<a.length;u+=4){let d=(c[a[u]]<0?1:0)|(c[a[u+1]]<0?2:0)|(c[a[u+2]]<0?4:0)|(c[a[u+3]]<0?8:0);if(d===0||d===15)continue;let h=r?l[u/4]:0,f=YR[d],p=f.length/3;for(let v=0;v<p;v++)this.cross(e,t,s,o,a[u+f[3*v]],a[u+f[3*v+1]],v);this.push(u/4,0,1,2),p===4&&this.push(u/4,0,2,3);for(let v=0;h&&v<p;v++)h&1<<f[3*v+2]&&this.pushEdge(v,(v+1)%p)}}measure(e,[t,i,s,r],o){let{points:a}=e.shape,{cos:l,sin:c,displacements:u}=e,d=a.length/3;this.#e.length<d&&(this.#e=new Float64Array(d));let h=this.#e,f=l*t+c*i,p=l*i-c*t;for(let v=0,m=0;v<d;v++,m+=3)h[v]=f*a[m]+p*a[m+1]+s*a[m+2]+r+o*(t*u[m]+i*u[m+1]+s*u[m+2]);return h}cross(e,t,i,s,r,o,a){let{points:l}=e.shape,{cos:c,sin:u,displacements:d}=e,h=this.#e[r],f=h/(h-this.#e[o]),p=3*r,v=3*o,m=l[p]+f*(l[v]-l[p]),g=l[p+1]+f*(l[v+1]-l[p+1]),_=this.#t;_[3*a]=c*m-u*g+i*(d[p]+f*(d[v]-d[p])),_[3*a+1]=u*m+c*g+i*(d[p+1]+f*(d[v+1]-d[p+1])),_[3*a+2]=l[p+2]+f*(l[v+2]-l[p+2])+i*(d[p+2]+f*(d[v+2]-d[p+2]));let M=t?t[r]+f*(t[o]-t[r]):NaN;this.#n[a]=Number.isFinite(M)?M:s}push(e,t,i,s){this.count===this.sources.length&&(this.points=ih(this.points,Float32Array),this.values=ih(this.values,Float32Array),this.sources=ih(this.sources,Uint32Array));let r=this.count++,o=this.#t;this.sources[r]=e;for(let a=0;a<3;a++){let l=a===0?t:a===1?i:s;this.values[3*r+a]=this.#n[l];for(let c=0;c<3;c++)this.points[9*r+3*a+c]=o[3*l+c]}}pushEdge(e,t){6*this.edgeCount===this.edges.length&&(this.edges=ih(this.edges,Float32Array));let i=6*this.edgeCount++;for(let s=0;s<3;s++)this.edges[i+s]=this.#t[3*e+s],this.edges[i+3+s]=this.#t[3*t+s]}find(e,t,i,s){let r=[Math.abs(s[0]),Math.abs(s[1]),Math.abs(s[2])],o=r[0]>=r[1]&&r[0]>=r[2]?0:r[1]>=r[2]?1:2,[a,l]=o===0?[1,2]:o===1?[2,0]:[0,1],c=[e,t,i],[u,d]=[c[a],c[l]];for(let h=0;h<this.count;h++){let f=9*h,{points:p}=this,[v,m]=[p[f+a]-u,p[f+l]-d],[g,_]=[p[f+3+a]-u,p[f+3+l]-d],[M,b]=[p[f+6+a]-u,p[f+6+l]-d],C=v*_-m*g,R=g*b-_*M,y=M*m-b*v;if(!(Math.abs(C+R+y)<=qR*(v*v+m*m+g*g+_*_+M*M+b*b))&&(C>=0&&R>=0&&y>=0||C<=0&&R<=0&&y<=0))return h}return-1}};function ih(n,e){let t=new e(2*n.length);return t.set(n),t}var YR=Array.from({length:16},(n,e)=>{let t=[0,1,2,3].filter(c=>e&1<<c),i=[0,1,2,3].filter(c=>!(e&1<<c));if(t.length===2&&i.length===2){let[c,u,d,h]=[t[0],t[1],i[0],i[1]];return[c,d,u,c,h,d,u,h,c,u,d,h]}let[s,r]=t.length===1?[t[0],i]:[i[0],t];if(r.length!==3)return[];let[o,a,l]=r;return[s,o,l,s,a,o,s,l,a]});function b_(n,e,t,i){let s=y_(n.shape).nodes,r=[0,1,2,3].map(v=>s[4*e+v]),{cos:o,sin:a,displacements:l}=n,{points:c}=n.shape,u=r.map(v=>{let m=3*v,[g,_]=[c[m],c[m+1]];return[o*g-a*_+t*l[m],a*g+o*_+t*l[m+1],c[m+2]+t*l[m+2]]}),d=(v,m)=>[m[0]-v[0],m[1]-v[1],m[2]-v[2]],h=(v,m,g,_)=>{let[M,b,C]=[d(v,m),d(v,g),d(v,_)];return M[0]*(b[1]*C[2]-b[2]*C[1])+M[1]*(b[2]*C[0]-b[0]*C[2])+M[2]*(b[0]*C[1]-b[1]*C[0])},f=h(u[0],u[1],u[2],u[3]),p=[0,1,2,3].map(v=>{let m=u.map((g,_)=>_===v?i:g);return h(m[0],m[1],m[2],m[3])/f});return{nodes:r,weights:p}}var rh=class{section=new sh;objects;plane=null;#e=[];#t=new hn;#n=new hn;constructor(e){this.objects=[new bt(this.#t,e.section),new Yi(this.#n,e.sectionEdges)],this.objects.forEach((t,i)=>{t.frustumCulled=!1,t.matrixAutoUpdate=!1,t.visible=!1,t.renderOrder=1e5+2*i})}hide(){this.plane=null;for(let e of this.objects)e.visible=!1}update(e,t,i,s,r){this.plane=i;let o=[e,t,...i,s,r],a=o.every((l,c)=>l===this.#e[c]);if(!a){this.#e=o,this.section.compute(e,t,i,s,r,al);let{points:l,values:c,count:u,edges:d,edgeCount:h}=this.section;Ap(this.#t,"position",l,3,3*u),Ap(this.#t,"field",c,1,3*u),Ap(this.#n,"position",d,3,2*h),this.#t.setDrawRange(0,3*u),this.#n.setDrawRange(0,2*h)}return this.objects[0].visible=this.section.count>0,this.objects[1].visible=r&&this.section.edgeCount>0,!a}dispose(){this.#t.dispose(),this.#n.dispose()}};function Ap(n,e,t,i,s){let r=n.getAttribute(e);r?.array!==t&&(n.dispose(),r=new St(t,i).setUsage(dr),n.setAttribute(e,r)),r.clearUpdateRanges(),r.addUpdateRange(0,i*s),r.needsUpdate=!0}var Rp=Math.cos(32*Math.PI/180),Jo=n=>n===2147483648?0:n;function JR(n){let e=n.length/3,t=new Uint32Array(n.buffer,n.byteOffset,n.length),i=1;for(;i<2*e;)i*=2;let s=new Uint32Array(i),r=new Uint32Array(e);for(let o=0;o<e;o++){let[a,l,c]=[Jo(t[3*o]),Jo(t[3*o+1]),Jo(t[3*o+2])],u=Math.imul(a,2654435761)^Math.imul(l,2246822507)^Math.imul(c,3266489909);for(u=(u^u>>>15)&i-1;;){let d=s[u];if(d===0){s[u]=o+1,r[o]=o;break}let h=3*(d-1);if(Jo(t[h])===a&&Jo(t[h+1])===l&&Jo(t[h+2])===c){r[o]=d-1;break}u=u+1&i-1}}return r}function ZR(n,e){let t=new Uint32Array(e+1);for(let r=0;r<n.length;r++)t[n[r]+1]++;for(let r=0;r<e;r++)t[r+1]+=t[r];let i=t.slice(0,e),s=new Uint32Array(n.length);for(let r=0;r<n.length;r++)s[i[n[r]]++]=r;return{starts:t,corners:s}}function KR(n,e){let t=new Float32Array(e.length);for(let i=0;i<e.length;i+=3){let s=3*e[i],r=3*e[i+1],o=3*e[i+2],a=n[r]-n[s],l=n[r+1]-n[s+1],c=n[r+2]-n[s+2],u=n[o]-n[s],d=n[o+1]-n[s+1],h=n[o+2]-n[s+2];t[i]=l*h-c*d,t[i+1]=c*u-a*h,t[i+2]=a*d-l*u}return t}function jR(n,e,t,i,s){for(let r=e[i];r<e[i+1];r++){let o=t[r],a=o-o%3;if(n[a+(o+1)%3]===s)return a}return-1}function QR(n,e,t){let i=new Map,s=[],r=0;for(let c=0;c<e.length;c++)e[c]&&(s.push(c),r=Math.max(r,Math.abs(n[3*c]),Math.abs(n[3*c+1]),Math.abs(n[3*c+2])));if(s.length===0||!(r>0))return i;let o=r*2e-5,a=(c,u,d)=>`${Math.round(c/o)},${Math.round(u/o)},${Math.round(d/o)}`,l=new Map;for(let c of s)l.set(a(n[3*c],n[3*c+1],n[3*c+2]),c);for(let c of[1,-1]){let u=c*2*Math.PI/t,d=Math.cos(u),h=Math.sin(u);for(let f of s){let p=d*n[3*f]-h*n[3*f+1],v=h*n[3*f]+d*n[3*f+1],m=n[3*f+2],g;for(let _=0;_<27&&g===void 0;_++){let M=(_%3-1)*o*.5,b=(Math.floor(_/3)%3-1)*o*.5,C=(Math.floor(_/9)-1)*o*.5;g=l.get(a(p+M,v+b,m+C))}g!==void 0&&i.set(f,[...i.get(f)??[],[g,-c]])}}return i}function oh(n,e,t){let i=n.length/3,s=JR(n),r=e.map(v=>s[v]),{starts:o,corners:a}=ZR(r,i),l=KR(n,e),c=new Uint8Array(i),u=[],d=[];for(let v=0;v<e.length;v++){let m=v-v%3,g=r[v],_=r[m+(v+1)%3];if(g===_)continue;let M=jR(r,o,a,_,g);M<0?(c[g]=c[_]=1,d.push(g,_),t===1&&u.push(v)):m<M&&Pp(l,m,l,M)<Rp&&u.push(v)}let h=t>1?QR(n,c,t):new Map,f=eC(e,s,t,o,a,l,h),p=new Uint32Array(2*u.length);u.forEach((v,m)=>{let g=v-v%3;p[2*m]=f.triangles[v],p[2*m+1]=f.triangles[g+(v+1)%3]});for(let v=0;v<i;v++)c[v]=c[s[v]];return{...f,features:p,open:c,openEdges:Uint32Array.from(d)}}var Cp=(n,e,t)=>Math.sqrt(n*n+e*e+t*t);function Pp(n,e,t,i){let s=n[e]*t[i]+n[e+1]*t[i+1]+n[e+2]*t[i+2],r=Cp(n[e],n[e+1],n[e+2])*Cp(t[i],t[i+1],t[i+2]);return r>0?s/r:1}function eC(n,e,t,i,s,r,o){let a=e.length,l=[],c=[],u=new Uint32Array(a),d=new Uint32Array(n.length),h=2*Math.PI/t;for(let f=0;f<a;f++){let p=l.length;u[f]=p;let v=e[f],m=nC(v,o,i,s,r,h);for(let g=i[v];g<i[v+1];g++){let _=s[g];if(n[_]!==f)continue;let M=_-_%3,b=0,C=0,R=0;for(let U=i[v];U<i[v+1];U++){let N=s[U]-s[U]%3;N!==M&&Pp(r,M,r,N)<Rp||(b+=r[N],C+=r[N+1],R+=r[N+2])}for(let U=0;U<m.length;U+=3)Pp(r,M,m,U)<Rp||(b+=m[U],C+=m[U+1],R+=m[U+2]);let y=Cp(b,C,R)||1;b/=y,C/=y,R/=y;let E=p;for(;E<l.length;){let U=3*E;if(c[U]*b+c[U+1]*C+c[U+2]*R>.99999)break;E++}E===l.length&&(l.push(f),c.push(b,C,R)),d[_]=E}l.length===p&&(l.push(f),c.push(0,0,1))}return{nodes:Uint32Array.from(l),firstVertex:u,normals:Float32Array.from(c),triangles:d}}var tC=[];function nC(n,e,t,i,s,r){let o=e.get(n);if(!o)return tC;let a=[];for(let[l,c]of o){let u=Math.cos(c*r),d=Math.sin(c*r);for(let h=t[l];h<t[l+1];h++){let f=i[h]-i[h]%3;a.push(u*s[f]-d*s[f+1],d*s[f]+u*s[f+1],s[f+2])}}return a}var Ip=[48,32,16,8],iC=1.6;function S_(n){let e=-1;return Ip.forEach((t,i)=>{n<=iC*t&&(e=i)}),e}function sC(n,e,t){let[i,s,r]=[Math.abs(n),Math.abs(e),Math.abs(t)];return i>=s&&i>=r?n>0?0:1:s>=r?e>0?2:3:t>0?4:5}function M_(n,e,t){let{nodes:i,normals:s,triangles:r,open:o}=e,a=rC(n),l=new Map,c=[],u=new Map,d=[],h=[],f=new Uint32Array(i.length);for(let g=0;g<i.length;g++){let _=3*i[g],[M,b,C]=[n[_],n[_+1],n[_+2]],R=o[i[g]]?`${oC(M,b,a)} ${Math.floor(Math.hypot(M,b)/t+1e-6)} ${Math.floor(C/t+1e-6)}`:`${Math.floor(M/t)},${Math.floor(b/t)},${Math.floor(C/t)}`,y=l.get(R);y===void 0&&(y=l.size,l.set(R,y),c.push(0,0,0,0)),c[4*y]+=M,c[4*y+1]+=b,c[4*y+2]+=C,c[4*y+3]+=1;let[E,U,N]=[s[3*g],s[3*g+1],s[3*g+2]],L=6*y+sC(E,U,N),O=u.get(L);O===void 0&&(O=u.size,u.set(L,O),d.push(y),h.push(0,0,0)),h[3*O]+=E,h[3*O+1]+=U,h[3*O+2]+=N,f[g]=O}let p=new Float32Array(3*d.length),v=new Float32Array(3*d.length);d.forEach((g,_)=>{let M=Math.hypot(h[3*_],h[3*_+1],h[3*_+2])||1;for(let b=0;b<3;b++)p[3*_+b]=c[4*g+b]/c[4*g+3],v[3*_+b]=h[3*_+b]/M});let m=[];for(let g=0;g<r.length;g+=3){let[_,M,b]=[f[r[g]],f[r[g+1]],f[r[g+2]]];d[_]===d[M]||d[M]===d[b]||d[b]===d[_]||m.push(_,M,b)}return{points:p,normals:v,triangles:Uint32Array.from(m)}}function rC(n){let e=0,t=0;for(let i=0;i<n.length;i+=3)e+=n[i],t+=n[i+1];return Math.atan2(t,e)}function oC(n,e,t){return Math.sin(Math.atan2(e,n)-t)>0?"l":"r"}function lh(n,e,t=new Float32Array(3*e.length)){for(let i=0;i<e.length;i++){let s=3*e[i];t[3*i]=n[s],t[3*i+1]=n[s+1],t[3*i+2]=n[s+2]}return t}var ah=class{constructor(e,t,i){this.input=e;this.total=i;let{surface:s,points:r}=e;this.#s=i,this.triangleCount=s.triangles.length/3;let o=new St(lh(r,s.nodes),3);this.box=new ci().setFromBufferAttribute(o),this.sphere=this.box.getBoundingSphere(new ri),this.#r=new Ls(new Float32Array(2*i),2),this.#r.setUsage(dr);let a=(h,f=!1)=>{let p=new Ji;return p.setAttribute("position",o),p.setAttribute("copyRotation",this.#r),f&&p.setAttribute("normal",new St(s.normals,3)),p.setIndex(new St(h,1)),p.instanceCount=i,p},l=Uint32Array.from(e.edges,h=>s.firstVertex[h]),c=a(s.triangles,!0),u=a(s.features),d=a(l);this.#e=[c,u,d],this.#t=c,this.surface=new bt(c,t.surface),this.features=new Yi(u,t.features),this.edges=new Yi(d,t.edges),this.stencils=[new bt(c,t.stencilBack),new bt(c,t.stencilFront)];for(let h of[this.surface,this.features,this.edges,...this.stencils])h.frustumCulled=!1,h.matrixAutoUpdate=!1,this.group.add(h);this.group.matrixAutoUpdate=!1,this.setCopies(Array.from({length:i},(h,f)=>f),i)}input;total;group=new rn;surface;features;edges;stencils;triangleCount;sphere;box;#e;#t;#n=[];#i=-1;#s;#r;setLevel(e){if(e===this.#i)return;this.#i=e;let t=e<0?this.#t:this.#n[e];if(!t){let i=2*this.sphere.radius/Ip[e],s=M_(this.input.points,this.input.surface,i);t=new Ji,t.setAttribute("position",new St(s.points,3)),t.setAttribute("normal",new St(s.normals,3)),t.setAttribute("copyRotation",this.#r),t.setIndex(new St(s.triangles,1)),this.#n[e]=t,this.#e.push(t)}t.instanceCount=this.#s;for(let i of[this.surface,...this.stencils])i.geometry=t}get drawnTriangles(){return this.surface.geometry.index.count/3}setCopies(e,t){let i=this.#r,s=i.array;for(let r=0;r<t;r++){let o=2*Math.PI*e[r]/this.total;s[2*r]=Math.cos(o),s[2*r+1]=Math.sin(o)}i.clearUpdateRanges(),i.addUpdateRange(0,2*t),i.needsUpdate=!0,this.#s=t;for(let r of this.#e)r.instanceCount=t;this.group.visible=t>0}dispose(){for(let e of this.#e)e.dispose()}};var w_=new WeakMap;function aC(n){let e=w_.get(n);return e||w_.set(n,e=oh(n.points,n.triangles,1)),e}var Lp=class{constructor(e){this.shape=e;let t=aC(e);this.surface=t,this.position=new St(lh(e.points,t.nodes),3),this.normal=new St(t.normals,3),this.triangles=new St(t.triangles,1),this.features=new St(t.features,1),this.edges=new St(Uint32Array.from(e.edges,i=>t.firstVertex[i]),1)}shape;surface;position;normal;triangles;features;edges},Np=class{constructor(e,t){this.buffers=e;let{surface:i,shape:s}=e,r=i.nodes.length;this.triangleCount=s.triangles.length/3,this.#t=new St(new Float32Array(3*r),3).setUsage(dr),this.#n=new St(new Float32Array(r).fill(al),1).setUsage(dr);let o=u=>{let d=new Ji;return d.setAttribute("position",e.position),d.setAttribute("normal",e.normal),d.setAttribute("displacement",this.#t),d.setAttribute("field",this.#n),d.setAttribute("copyRotation",this.#i),d.setIndex(u),d.instanceCount=1,d},a=o(e.triangles),l=o(e.features),c=o(e.edges);this.surface=new bt(a,t.surface),this.features=new Yi(l,t.features),this.edges=new Yi(c,t.edges),this.stencils=[new bt(a,t.stencilBack),new bt(a,t.stencilFront)],this.#s=new th(i,s.points,this.#i,t),this.closures=this.#s.meshes,this.#e=[a,l,c,this.#s.geometry],this.section=__(s)?new rh(t):null;for(let u of[this.surface,this.features,this.edges,...this.stencils,...this.closures])u.frustumCulled=!1,u.matrixAutoUpdate=!1,this.group.add(u);this.section&&this.group.add(...this.section.objects),this.group.matrixAutoUpdate=!1}buffers;group=new rn;surface;features;edges;stencils;closures;section;triangleCount;mesh=null;values=null;#e;#t;#n;#i=new Ls(new Float32Array(2),2);#s;get open(){return this.buffers.shape.open}set(e){e!==this.mesh&&(this.mesh=e,this.values=null,this.#i.setXY(0,e.cos,e.sin),this.#i.needsUpdate=!0,lh(e.displacements,this.buffers.surface.nodes,this.#t.array),this.#t.needsUpdate=!0,this.#s.setDisplacements(e.displacements))}setField(e){if(e===this.values)return;this.values=e;let t=this.#n.array,{nodes:i}=this.buffers.surface;for(let s=0;s<i.length;s++){let r=e[i[s]];t[s]=Number.isFinite(r)?r:al}this.#n.needsUpdate=!0}dispose(){for(let e of this.#e)e.dispose();this.section?.dispose()}},ch=class{#e=new Map;#t=new Map;display(e,t){let i=new Map([...this.#t].map(([o,a])=>[o,[...a]])),s=o=>`${o.part} ${o.shape.name}`,r=e.map(o=>{let a=i.get(s(o))??[],l=a.findIndex(c=>c.mesh?.copy===o.copy&&c.mesh.shape===o.shape);return l<0?null:a.splice(l,1)[0]});return e.map((o,a)=>{let l=i.get(s(o))??[],c=r[a]?-1:l.findIndex(d=>d.mesh?.shape===o.shape),u=r[a]??(c<0?this.create(o,t(o.part)):l.splice(c,1)[0]);return u.set(o),u})}create(e,t){let i=this.#e.get(e.shape);i||this.#e.set(e.shape,i=new Lp(e.shape));let s=new Np(i,t),r=`${e.part} ${e.shape.name}`;return this.#t.set(r,[...this.#t.get(r)??[],s]),s}dispose(){for(let e of this.#t.values())for(let t of e)t.dispose();this.#t.clear(),this.#e.clear()}};var lC=.28,E_=7,cC=6e4,hh=class{constructor(e,t,i,s){this.part=e;this.#i=new at(s),this.#s=new at("#b4b9bf").lerp(this.#i,.4),this.#e=Sp(t,!1),this.#t=Sp(t,!0),this.#n=Xv(t),this.surface=oh(e.points,e.triangles,e.copies),this.copies=new ah({...e,surface:this.surface},this.#e,e.copies),this.#r=Array.from({length:e.copies},(o,a)=>a),this.#a=new Uint32Array(e.copies);let r=0;for(let o=0;o<e.points.length;o+=3)r=Math.max(r,e.points[o]**2+e.points[o+1]**2+e.points[o+2]**2);this.radius=Math.sqrt(r),this.group.matrixAutoUpdate=!1,this.#o=new nh(this.surface,e.points,e.copies,this.#e),this.group.add(this.copies.group,...this.#o.meshes),this.cap=new bt(i,this.#n),this.cap.frustumCulled=!1,this.cap.matrixAutoUpdate=!1,this.cap.onAfterRender=o=>o.clearStencil(),this.#l=e.index,this.#t.section.polygonOffsetUnits-=uC*e.index,this.refresh()}part;group=new rn;cap;copies;surface;radius;meshes=[];visibility="visible";present=!0;#e;#t;#n;#i;#s;#r;#o;#a;#c=-1;#h=NaN;#u=!1;#m=!1;#d=!1;#f=!1;#l;get materials(){return[...Object.values(this.#e),...Object.values(this.#t),this.#n]}setMeshes(e,t){for(let i of this.meshes)e.includes(i)||this.group.remove(i.group);for(let i of e)i.group.parent!==this.group&&this.group.add(i.group);this.meshes=e,this.#r=[];for(let i=0;i<this.part.copies;i++)t.has(i)||this.#r.push(i);this.#h=NaN,this.#o.set(t),this.refresh()}get meshMaterials(){return this.#t}get presentCopies(){return this.#r}setVisibility(e){this.visibility=e,this.refresh()}setFieldMode(e){this.#u=e,this.refresh()}setEdges(e){this.#m=e,this.refresh()}setSections(e){e!==this.#f&&(this.#f=e,this.refresh())}get showsField(){return this.#u}get showsSections(){return this.#f&&this.#d&&this.group.visible}setCut(e){this.#d=e;for(let t of this.materials)t.cut=e;this.refresh()}setPresent(e){this.present=e,this.refresh()}refresh(){let e=this.visibility==="translucent",t=this.visibility!=="hidden"&&this.present;this.group.visible=t,this.cap.visible=t&&this.#d&&!this.part.open;let i=e?lC:1;for(let r of[this.#e,this.#t]){r.surface.alpha=i,r.surface.depthWrite=!e;let o=this.part.open||this.#d||this.meshes.length>0;r.surface.side=o&&!e?zn:Fi,r.surface.colour.copy(this.#u?this.#s:this.#i),r.features.alpha=e?.25:.5,r.edges.alpha=e?.12:.34,r.stencilBack.transparent=r.stencilFront.transparent=e}this.#t.surface.useField=this.#t.section.useField=this.#u,this.#t.section.colour.copy(this.#u?this.#s:this.#i).multiplyScalar(.86),this.#n.alpha=e?.5:1,this.#n.depthWrite=!e,this.#n.colour.copy(this.#u?this.#s:this.#i).multiplyScalar(.86);let s=10+3*this.#l;this.cap.renderOrder=s+2;for(let r of[this.copies,...this.meshes])r.edges.visible=this.#m,r.surface.renderOrder=e?1e5:0,r.features.renderOrder=r.edges.renderOrder=100001;this.refreshStencils(this.copies.stencils,s,!0);for(let r of this.meshes){let o=!r.open&&!(this.#f&&r.section);this.refreshStencils(r.stencils,s,o),this.refreshStencils(r.closures,s,o)}this.#o.meshes.forEach((r,o)=>{r.visible=this.#d&&this.meshes.length>0&&!this.part.open,r.renderOrder=s+o%2})}refreshStencils(e,t,i){e.forEach((s,r)=>{s.visible=i&&this.#d&&!this.part.open,s.renderOrder=t+r})}prepare(e,t){if(!this.group.visible)return 0;let{sphere:i}=this.copies,s=0,r=0,o=0,a=this.group.matrixWorld;uh.radius=i.radius;for(let d of this.#r){let h=2*Math.PI*d/this.part.copies,f=Math.cos(h),p=Math.sin(h),{x:v,y:m,z:g}=i.center;uh.center.set(f*v-p*m,p*v+f*m,g).applyMatrix4(a),e.intersectsSphere(uh)&&(this.#a[s++]=d,r=(r*31+d+1)%4294967291,o=Math.max(o,i.radius*2*t(uh.center)))}(s!==this.#c||r!==this.#h)&&(this.copies.setCopies(this.#a,s),this.#c=s,this.#h=r);let l=this.part.copies>1?2*Math.PI*this.radius/this.part.copies:2*i.radius,c=o*Math.min(l,2*i.radius)/(2*i.radius||1);this.copies.features.visible=c>E_,this.copies.edges.visible=this.#m&&c>2*E_,this.copies.setLevel(s*this.copies.triangleCount>cC?S_(o):-1);let u=s*this.copies.drawnTriangles;for(let d of this.meshes)u+=d.triangleCount;return u}dispose(){this.copies.dispose(),this.#o.dispose();for(let e of this.materials)e.dispose()}},uC=8,uh=new ri;var hC=1e5,dC=["gear","shaft","bearing","body"];function fh(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)?n:null}function Fp(n){return Array.isArray(n)?n:[]}function Up(n,e,t,i){for(let s=0;s<t.length;s++)if(t[s]>=i)throw new nn(n,`${e}: index ${t[s]} exceeds the ${i} points`)}function T_(n){let e=qo.parse("parts.bin",n);if(!Array.isArray(e.header.parts))throw new nn(e.name,"the list of parts is missing");let t=e.header.parts.map((i,s)=>{let r=fh(i);if(!r)throw new nn(e.name,`part ${s} is not an object`);let o=typeof r.name=="string"?r.name:`part ${s}`,a=Number(r.copies??1);if(!Number.isInteger(a)||a<1||a>hC)throw new nn(e.name,`${o}: the number of copies is not valid`);let l=e.f32(r.points,3,`${o}, points`),c=e.u32(r.triangles,3,`${o}, triangles`),u=r.edges?e.u32(r.edges,2,`${o}, edges`):new Uint32Array;Up(e.name,`${o}, triangles`,c,l.length/3),Up(e.name,`${o}, edges`,u,l.length/3);let d=dC.includes(String(r.kind))?r.kind:"body";return{index:s,name:o,kind:d,copies:a,open:r.open===!0,points:l,triangles:c,edges:u}});return{model:String(e.header.model??""),units:String(e.header.units??""),parts:t}}function Dp(n){if(!Array.isArray(n)||n.length!==3)return null;let e=n.map(t=>typeof t=="number"?t:NaN);return e.every(Number.isFinite)?e:null}function fC(n,e){let t=fh(n),i=Dp(t?.point),s=Dp(t?.force);return!t||!i||!s?null:{kind:t.kind==="mesh"?"mesh":"bearing",name:String(t.name??""),point:i,force:s,moment:Dp(t.moment)??[0,0,0],parts:Fp(t.parts).filter(r=>typeof r=="number"&&r>=0&&r<e)}}function pC(n,e){let t=fh(e);if(!t)return null;let i=n.f32(t.corners,12,"contacts, corners"),s=n.f32(t.pressures,1,"contacts, pressures"),r=n.u32(t.parts,2,"contacts, parts"),o=n.u32(t.teeth,2,"contacts, teeth"),a=n.u32(t.zones,1,"contacts, zones"),l=n.u32(t.surfaces,2,"contacts, surfaces"),c=s.length,u=[r,o,l].every(({length:d})=>d===2*c);if(i.length!==12*c||a.length!==c||!u)throw new nn(n.name,"contacts: the arrays have different lengths");return c>0?{count:c,corners:i,pressures:s,zones:a,parts:r,teeth:o,surfaces:l}:null}function Gr(n,e,t){let{cos:i,sin:s,displacements:r}=n,{points:o}=n.shape,a=3*e,[l,c,u]=[o[a],o[a+1],o[a+2]];return[i*l-s*c+t*r[a],s*l+i*c+t*r[a+1],u+t*r[a+2]]}function A_(n,e){let t=qo.parse(n,e),{header:i}=t,s=t.f32(i.points,3,"points"),r=(a,l,c)=>{if(!c&&!i[a])return new Uint32Array;let u=t.u32(i[a],l,a);return Up(n,a,u,s.length/3),u},o=i.extruded===!0;if(o&&s.length%6!==0)throw new nn(n,"points: an extruded mesh needs an even number of them");return{name:n,open:i.open===!0,extruded:o,points:s,triangles:r("triangles",3,!0),edges:r("edges",2,!1),tetrahedra:r("tetrahedra",4,!1),wedges:r("wedges",6,!1),hexahedra:r("hexahedra",8,!1)}}var mC=/^mesh-[0-9A-Za-z_-]+\.bin$/;async function gC(n,e,t,i,s){let r=fh(e),o=i[Number(r?.part)];if(!r||!o)throw new nn(n.name,`mesh ${t}: the part does not exist`);let a=`mesh of ${o.name}`,l=Number(r.copy??0);if(!Number.isInteger(l)||l<0||l>=o.copies)throw new nn(n.name,`${a}: the copy does not exist`);let c=String(r.mesh);if(!mC.test(c))throw new nn(n.name,`${a}: the name of the mesh is not valid`);let u=await s(c),d=(g,_,M)=>{let b=`${a}, ${g.replace("_"," ")}`;return u.extruded?xC(n.f32(r[g],M.length,b),_,M):n.f32(r[g],_,b)},h=d("displacements",3,[0,1]),f=d("stresses",6,[0,1,2,5]),p=r.stress_errors?d("stress_errors",1,[0]):null,v=u.points.length/3;if(h.length!==3*v||f.length!==6*v||p&&p.length!==v)throw new nn(n.name,`${a}: the values do not fit the ${v} points of ${c}`);let m=2*Math.PI*l/o.copies;return{part:o.index,copy:l,cos:Math.cos(m),sin:Math.sin(m),shape:u,displacements:h,stresses:f,stressErrors:p}}function xC(n,e,t){let i=n.length/t.length,s=new Float32Array(2*e*i);for(let r=0;r<i;r++)t.forEach((o,a)=>{s[e*r+o]=n[t.length*r+a]});return s.copyWithin(e*i,0,e*i),s}async function R_(n,e,t,i){let s=qo.parse(n,e),{header:r}=s,o=s.f64(r.poses,12,"poses");if(o.length!==12*t.length)throw new nn(n,`${o.length/12} poses for ${t.length} parts; the files are from different runs`);let a="",l=u=>i(u).catch(d=>{throw a=d instanceof Error?d.message:String(d),new dh(a)}),c=await Promise.all(Fp(r.meshes).map((u,d)=>gC(s,u,d,t,l).catch(h=>{if(h instanceof dh)return null;throw h})));return{position:Number(r.position??0),time:Number(r.time??0),poses:o,contacts:pC(s,r.contacts),forces:Fp(r.forces).map(u=>fC(u,t.length)).filter(u=>u!==null),meshes:c.filter(u=>u!==null),bytes:e.byteLength,problem:a}}var dh=class extends Error{};function ph(){return{version:1,camera:null,parts:{},colours:{field:"plain",scale:"viridis",bands:0,limits:"position",min:0,max:1,cells:"all"},deformation:{mode:"automatic",factor:1},mesh_edges:!1,hidden_contacts:!0,extremes:!0,forces:{bearings:!1,meshes:!1,labels:!0,scale:1},cut:{on:!1,normal:"z",offset:null,flipped:!1},frame:null,position:0,animation:{speed:10,loop:!0},theme:"system",panels:{parts:!0,settings:!1,plots:!1,pattern:!1},pattern:{gear:"",tooth:"all",flank:"automatic",envelope:!1},plotted:[]}}function mh(n,e=ph()){let t=structuredClone(e),i=n??{};for(let[s,r]of Object.entries(t)){let o=i[s];if(o===void 0||s==="version")continue;Op(r)&&s!=="parts"&&s!=="camera"?Op(o)&&(t[s]=vC(r,o)):s==="camera"?_C(o)&&(t[s]=o):s==="frame"?(o===null||typeof o=="string")&&(t[s]=o):typeof o==typeof r&&o!==null&&(t[s]=o)}return structuredClone(t)}function Op(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)}function vC(n,e){let t={...n};for(let i of Object.keys(n)){let s=e[i];s!==void 0&&(i==="normal"||i==="offset"||typeof s==typeof n[i])&&(t[i]=s)}return t}function _C(n){return!Op(n)||!Array.isArray(n.target)||n.target.length!==3?!1:[...n.target,n.azimuth,n.elevation,n.height].every(t=>typeof t=="number"&&Number.isFinite(t))&&(n.projection==="perspective"||n.projection==="orthographic")}function ul(n,e){return n.parts[e.name]??(e.kind==="body"?"translucent":"visible")}var yC=.05,bC=30,SC=1e-4,xh=class{constructor(e){this.scene=e;this.contacts=new Ju(e.uniforms),this.forces=new eh(e.uniforms),e.root.add(this.contacts.group,this.contacts.markLine,this.forces.group),e.scene.add(this.cut.group)}scene;views=[];position=null;meshes=[];colours=[];factor=0;limits=null;clipped=null;triangles=0;cut=new ju;contacts;forces;centre=new G;radius=1;sectionTime=0;#e=new ch;#t=[];#n=new WeakMap;#i=new WeakMap;#s=!1;#r=!1;#o=null;#a=new yt;#c=!1;setParts(e,t){this.clear();let i=new Map;this.#o=t?.poses??null,this.colours=e.map(({kind:r})=>{let o=i.get(r)??0;return i.set(r,o+1),t_(r,o)}),this.views=e.map((r,o)=>{let a=new hh(r,this.scene.uniforms,this.cut.capGeometry,this.colours[o]);return this.scene.root.add(a.group),this.scene.scene.add(a.cap),a}),this.meshes=e.map(()=>[]);let s=new ci().setFromPoints(this.views.flatMap(r=>this.outline(r))).getBoundingSphere(new ri);this.centre.copy(s.center),this.radius=s.radius>0?s.radius:1,this.contacts.setBias(8e-4*this.radius),this.cut.setBounds(this.centre,this.radius),this.updateBounds()}updateBounds(){let e=this.views.filter(i=>i.visibility!=="hidden"),t=(e.length>0?e:this.views).flatMap(i=>this.outline(i));this.scene.camera.setBounds(this.centre,this.radius*1.1,t)}outline(e){let t=ks(this.#o,e.part.index,new yt),{min:i,max:s}=e.copies.box,r=[];if(e.part.points.length===0||!gh(this.#o,e.part.index))return r;if(e.part.copies>1){let o=0,a=e.part.points;for(let l=0;l<a.length;l+=3)o=Math.max(o,Math.hypot(a[l],a[l+1]));for(let l=0;l<24;l++){let c=2*Math.PI*l/24;for(let u of[i.z,s.z])r.push(new G(o*Math.cos(c),o*Math.sin(c),u))}}else for(let o=0;o<8;o++)r.push(new G(o&1?s.x:i.x,o&2?s.y:i.y,o&4?s.z:i.z));return r.map(o=>o.applyMatrix4(t))}setPosition(e){this.position=e,this.meshes=this.views.map(()=>[]);let t=this.views.map(()=>[]),i=this.views.map(()=>new Set);this.#t=this.#e.display(e?.meshes??[],s=>this.views[s].meshMaterials),e?.meshes.forEach((s,r)=>{this.meshes[s.part].push(s),t[s.part].push(this.#t[r]),i[s.part].add(s.copy)}),this.views.forEach((s,r)=>{ks(e?.poses??null,r,s.group.matrix),s.setPresent(gh(e?.poses??null,r)),s.setMeshes(t[r],i[r])})}values(e,t){let i=this.#n.get(e);i||this.#n.set(e,i=new Map);let s=i.get(t);return s||i.set(t,s=o_(e,t)),s}limitsOf(e,t){return this.automaticLimits(e,t,this.extremes(e,t))}automaticLimits(e,t,i){if(!i)return null;let s=wp(t.colours.field);if(s===1)return[i.min.value,i.max.value];let r=this.surfaceValues(e,t).filter(o=>o>SC*i.max.value).sort();return[i.min.value,r[Math.floor(s*(r.length-1))]??i.max.value]}surfaceValues(e,t){let i=t.colours.field,s=e.meshes.filter(({part:a})=>this.shown(t,a)),r=new Float64Array(s.reduce((a,l)=>a+l.shape.points.length/3,0)),o=0;for(let a of s){let l=Ep(a.shape);this.values(a,i).forEach((c,u)=>{l[u]&&Number.isFinite(c)&&(r[o++]=c)})}return r.subarray(0,o)}clippedBy(e,t,i){let{field:s,limits:r}=t.colours;if(!e||!i||!this.position||r==="fixed"||wp(s)===1)return null;let o=this.surfaceValues(this.position,t),a=o.reduce((l,c)=>l+(c>e[1]?1:0),0);return a>0?{share:a/o.length,largest:i.max.value}:null}shown(e,t){let i=this.views[t]?.part.name;return i!==void 0&&e.parts[i]!=="hidden"}cellShown(e,t,i){let s=t.contacts,{parts:r}=s;return cl(s,i,e.colours.cells)?this.shown(e,r[2*i])||this.shown(e,r[2*i+1]):!1}extremes(e,t){let{field:i}=t.colours,s=null,r=null;if(Hn(i))for(let o of e.meshes){if(!this.shown(t,o.part))continue;let a=this.values(o,i),l=Ep(o.shape);for(let c=0;c<a.length;c++){let u=a[c];!l[c]||!Number.isFinite(u)||((!s||u<s.value)&&(s={value:u,mesh:o,index:c}),(!r||u>r.value)&&(r={value:u,mesh:o,index:c}))}}else if(i==="contact_pressure"&&e.contacts){let o=Float64Array.from(e.contacts.pressures,(l,c)=>l>0&&this.cellShown(t,e,c)?l:NaN),a=r_(o);a&&(s={value:0,mesh:null,index:a.minIndex},r={value:a.max,mesh:null,index:a.maxIndex})}return s&&r?{min:s,max:r}:null}extremePoint(e,t){let i=new G,{mesh:s,index:r}=e;if(s)return i.set(...Gr(s,r,this.factor)).applyMatrix4(ks(t.poses,s.part,this.#a));let o=t.contacts.corners;for(let a=0;a<4;a++)i.x+=o[12*r+3*a]/4,i.y+=o[12*r+3*a+1]/4,i.z+=o[12*r+3*a+2]/4;return i}apply(e,t){let{uniforms:i}=this.scene,{colours:s}=e,r=this.position,o=Hn(s.field);for(let h of this.views)h.setVisibility(ul(e,h.part)),h.setFieldMode(o),h.setEdges(e.mesh_edges),h.setSections(this.sectionsShown(e));if(this.applyFrame(e),this.factor=this.deformationFactor(e),i.deformation.value=this.factor,o)for(let h of this.#t)h.setField(this.values(h.mesh,s.field));this.#s=e.mesh_edges;let a=r&&s.field==="contact_pressure"?r.contacts:null,l=JSON.stringify([s.cells,Object.entries(e.parts).filter(([,h])=>h==="hidden")]);this.contacts.set(a,l,h=>this.cellShown(e,r,h)),this.contacts.setBehind(e.hidden_contacts);let c=r?this.extremes(r,e):null;this.limits=this.chooseLimits(e,c,t),this.clipped=this.clippedBy(this.limits,e,c),this.limits&&i.limits.value.set(...this.limits),jv(this.scene.scaleTexture,s.scale,s.bands);let u=this.views.map(({part:h})=>h.name);this.forces.set(r?.forces??[],{...e.forces,radius:this.radius,names:u}),this.applyCut(e);let d=[...this.forces.labels];if(r&&c&&e.extremes){let h=Math.max(Math.abs(c.min.value),Math.abs(c.max.value)),f=Ei[s.field].quantity==="length"?Tn("m",h):Oi(),p=(v,m,g)=>{let _=Math.abs(v.value)<1e-9*h?0:v.value*f.factor,M=this.extremePoint(v,r);this.isCutAway(M)||d.push({kind:m,text:`${g} ${Ut(_)} ${f.symbol}`,point:M})};s_(s.field)==="maximum"?p(c.max,"maximum","max"):p(c.min,"minimum","min")}return d}chooseLimits(e,t,i){let{colours:s}=e;return s.field==="plain"?null:s.limits==="fixed"?[Math.min(s.min,s.max),Math.max(s.min,s.max)]:s.limits==="all"&&i?i:this.position&&this.automaticLimits(this.position,e,t)}deformationFactor(e){let{mode:t,factor:i}=e.deformation;if(t==="factor")return Number.isFinite(i)?i:0;if(!Hn(e.colours.field))return 0;let s=this.position?this.largestDisplacement(this.position):0;return s>0?f_(yC*2*this.radius/s):1}largestDisplacement(e){let t=this.#i.get(e);if(t===void 0){t=0;for(let{displacements:i}of e.meshes)for(let s=0;s<i.length;s+=3)t=Math.max(t,i[s]**2+i[s+1]**2+i[s+2]**2||0);this.#i.set(e,t)}return Math.sqrt(t)}applyFrame(e){let{root:t}=this.scene;t.matrix.identity();let i=this.views.findIndex(r=>r.part.name===e.frame),s=r=>r&&gh(r,i);i>=0&&this.position&&s(this.#o)&&s(this.position.poses)&&(ks(this.#o,i,t.matrix),t.matrix.multiply(ks(this.position.poses,i,this.#a).invert())),t.updateMatrixWorld(!0)}applyCut(e){this.cut.apply(e.cut,this.scene.uniforms.cutPlane.value);for(let t of this.views)t.cap.matrix.copy(this.cut.capMatrix),t.cap.updateMatrixWorld(!0);if(this.#c!==e.cut.on){this.#c=e.cut.on;for(let t of this.views)t.setCut(this.#c);for(let t of this.contacts.materials)t.cut=this.#c}}isCutAway(e){let t=this.cutPlane,i=C_.copy(e).applyMatrix4(this.scene.root.matrix);return t!==null&&t.x*i.x+t.y*i.y+t.z*i.z+t.w>0}get cutPlane(){return this.#c?this.scene.uniforms.cutPlane.value:null}setDragging(e,t){if(e!==this.#r){this.#r=e;for(let i of this.views)i.setSections(this.sectionsShown(t));this.scene.invalidate()}}sectionsShown(e){return(Hn(e.colours.field)||e.mesh_edges)&&!(this.#r&&this.sectionTime>bC)}updateSections(){let e=performance.now(),t=!1;for(let i of this.views){let s=i.showsSections?this.planeOf(i):null;for(let r of i.meshes)if(r.section)if(s&&r.mesh){let o=i.showsField?r.values:null;t=r.section.update(r.mesh,o,s,this.factor,this.#s)||t}else r.section.hide()}t&&(this.sectionTime=performance.now()-e)}planeOf(e){let{x:t,y:i,z:s,w:r}=this.scene.uniforms.cutPlane.value,o=e.group.matrixWorld.elements;return[o[0]*t+o[1]*i+o[2]*s,o[4]*t+o[5]*i+o[6]*s,o[8]*t+o[9]*i+o[10]*s,o[12]*t+o[13]*i+o[14]*s+r]}prepareFrame(){this.updateSections();let e=this.scene.frustum(),{active:t,state:i,direction:s}=this.scene.camera,r=this.scene.height/i.height,o=t.position.distanceTo(MC.fromArray(i.target)),a=i.projection==="orthographic",l=c=>{if(a)return r;let u=C_.copy(t.position).sub(c).dot(s);return u>0?r*o/u:r};this.triangles=0;for(let c of this.views)this.triangles+=c.prepare(e,l)}clear(){for(let e of this.views)e.group.removeFromParent(),e.cap.removeFromParent(),e.dispose();this.#e.dispose(),this.#t=[],this.views=[],this.position=null,this.#c=!1;for(let e of this.contacts.materials)e.cut=!1}dispose(){this.clear(),this.contacts.dispose(),this.forces.dispose()}},MC=new G,C_=new G;function gh(n,e){return!n||n.subarray(12*e,12*e+12).every(Number.isFinite)}function ks(n,e,t){if(!n||!gh(n,e))return t.identity();let[i,s,r,o,a,l,c,u,d,h,f,p]=n.subarray(12*e,12*e+12);return t.set(i,s,r,h,o,a,l,f,c,u,d,p,0,0,0,1)}var wC=(n,e)=>n.left<e.right&&e.left<n.right&&n.top<e.bottom&&e.top<n.bottom,[vh,kp]=[9,9];function P_(n,e,t,i){let s=n==="right"?e+vh:n==="left"?e-vh-i:e-i/2,r=n==="above"?t-vh-2*kp:n==="below"?t+vh:t-kp;return{left:s,top:r,right:s+i,bottom:r+2*kp}}var _h=class{element=document.createElement("div");#e=[];#t=[];#n=[];#i=new G;constructor(){this.element.className="cv-labels"}set(e){for(let t of e)t.hidden??=this.#e.find(({kind:i})=>i===t.kind)?.hidden;for(this.#e=e;this.#t.length>e.length;)this.#t.pop().remove();e.forEach((t,i)=>{let s=this.#t[i];s||(s=document.createElement("div"),s.append(document.createElement("i"),document.createElement("span")),this.#t.push(s),this.element.append(s)),s.className=`cv-label cv-label-${t.kind}${t.hidden?" cv-label-hidden":""} ${I_(this.#n[i])}`,s.lastElementChild.textContent=t.text})}hide(e){this.#e.forEach((t,i)=>{t.kind!=="maximum"&&t.kind!=="minimum"||(t.hidden=e(t.point),this.#t[i].classList.toggle("cv-label-hidden",t.hidden))})}arrange(e,t,i){let{left:s,top:r}=this.element.getBoundingClientRect(),o=i?[{left:i.left-s,top:i.top-r,right:i.right-s,bottom:i.bottom-r}]:[],a=({kind:h})=>h==="maximum"||h==="minimum",l=h=>a(h)?1/0:h.weight??0,c=this.#e.map((h,f)=>f).sort((h,f)=>l(this.#e[f])-l(this.#e[h])||h-f),u=this.#t.map(h=>h.lastElementChild.offsetWidth),d=this.#t.map(h=>h.getBoundingClientRect());for(let h of c){if(this.#t[h].style.display==="none")continue;let[f,p]=[d[h].x-s,d[h].y-r],v=_=>_.left>=0&&_.right<=e&&_.top>=0&&_.bottom<=t&&!o.some(M=>wC(_,M)),g=["right","left","above","below"].filter(_=>v(P_(_,f,p,u[h])))[0]??(a(this.#e[h])?"right":null);g&&o.push(P_(g,f,p,u[h])),this.#t[h].classList.remove(...EC),this.#t[h].classList.add(I_(g)),this.#n[h]=g}}update(e,t,i,s){this.#e.forEach((r,o)=>{let a=this.#i.copy(r.point).applyMatrix4(t).project(e),l=a.z>-1&&a.z<1&&Math.abs(a.x)<1.02&&Math.abs(a.y)<1.02,{style:c}=this.#t[o];c.display=l?"":"none",l&&(c.transform=`translate(${(.5+.5*a.x)*i}px, ${(.5-.5*a.y)*s}px)`)})}placed(e,t,i,s){return this.#e.map((r,o)=>{let a=r.point.clone().applyMatrix4(t).project(e);return{...r,x:(.5+.5*a.x)*i,y:(.5-.5*a.y)*s,depth:a.z,side:this.#n[o]===void 0?"right":this.#n[o]}}).filter(r=>r.side!==null&&r.depth>-1&&r.depth<1&&r.x>0&&r.x<i&&r.y>0&&r.y<s)}},EC=["right","left","above","below","unplaced"].map(n=>`cv-label-${n}`);function I_(n){return`cv-label-${n===void 0?"right":n??"unplaced"}`}function zp(n,e,t,i,s){let[r,o,a]=n.origin,[l,c,u]=n.direction,d=null,h=1/0;for(let f=0;f<t.length;f+=3){let p=3*t[f],v=3*t[f+1],m=3*t[f+2],g=e[p],_=e[p+1],M=e[p+2],b=e[v],C=e[v+1],R=e[v+2],y=e[m],E=e[m+1],U=e[m+2];if(i){let{cos:$e,sin:Fe,displacements:Ze,factor:Je}=i,[je,Bt,It]=[g,b,y];g=$e*je-Fe*_+Je*Ze[p],_=Fe*je+$e*_+Je*Ze[p+1],M+=Je*Ze[p+2],b=$e*Bt-Fe*C+Je*Ze[v],C=Fe*Bt+$e*C+Je*Ze[v+1],R+=Je*Ze[v+2],y=$e*It-Fe*E+Je*Ze[m],E=Fe*It+$e*E+Je*Ze[m+1],U+=Je*Ze[m+2]}let N=b-g,L=C-_,O=R-M,z=y-g,D=E-_,W=U-M,q=c*W-u*D,H=u*z-l*W,le=l*D-c*z,Z=N*q+L*H+O*le;if(Z===0)continue;let Q=1/Z,ie=r-g,de=o-_,he=a-M,ee=(ie*q+de*H+he*le)*Q;if(ee<-1e-9||ee>1+1e-9)continue;let me=de*O-he*L,ge=he*N-ie*O,Me=ie*L-de*N,ve=(l*me+c*ge+u*Me)*Q;if(ve<-1e-9||ee+ve>1+1e-9)continue;let Ve=(z*me+D*ge+W*Me)*Q;Ve<=s||Ve>=h||(h=Ve,d={distance:Ve,triangle:f,u:ee,v:ve,facing:Z>0})}return d}function yh(n,e,t){if(!t)return[0,1/0];let i=t.x*n.x+t.y*n.y+t.z*n.z+t.w,s=t.x*e.x+t.y*e.y+t.z*e.z;if(s===0)return i>0?[1/0,1/0]:[0,1/0];let r=-i/s;return s<0?[Math.max(0,r),1/0]:[0,r]}var Bp=new yt,Wr=new G,Xr=new G,pr=new Ni,L_=new ri;function bh(n,e,t,i,s){let[r,o]=yh(n.origin,n.direction,s),a=null,l=(c,u,d,h,f,p)=>{if(!h)return;let v=s!==null&&r>0&&!h.facing&&!p,m=v?r:h.distance;if(m>o||a&&m>=a.distance)return;let g=h.triangle;a={view:c,copy:u,mesh:d,nodes:[f[g],f[g+1],f[g+2]],weights:[1-h.u-h.v,h.u,h.v],distance:m,point:n.at(m,new G),cap:v}};for(let c of e){if(c.visibility!=="visible"||!c.present)continue;Bp.copy(c.group.matrixWorld).invert(),Wr.copy(n.origin).applyMatrix4(Bp),Xr.copy(n.direction).transformDirection(Bp);let u=c.copies.sphere;for(let h of c.presentCopies){let f=-2*Math.PI*h/c.part.copies,p=Math.cos(f),v=Math.sin(f);if(pr.origin.set(p*Wr.x-v*Wr.y,v*Wr.x+p*Wr.y,Wr.z),pr.direction.set(p*Xr.x-v*Xr.y,v*Xr.x+p*Xr.y,Xr.z),L_.copy(u),!pr.intersectsSphere(L_)||!pr.intersectsBox(c.copies.box))continue;let m=zp(Vp(pr),c.part.points,c.part.triangles,null,r);l(c,h,-1,m,c.part.triangles,c.part.open)}pr.origin.copy(Wr),pr.direction.copy(Xr),(t[c.part.index]??[]).forEach((h,f)=>{let{points:p,triangles:v}=h.shape,{cos:m,sin:g,displacements:_}=h,M=zp(Vp(pr),p,v,{cos:m,sin:g,displacements:_,factor:i},r);l(c,-1,f,M,v,h.shape.open)})}return a}function Vp(n){return{origin:[n.origin.x,n.origin.y,n.origin.z],direction:[n.direction.x,n.direction.y,n.direction.z]}}function N_(n,e,t,i){let s=null,r=Vp(n);for(let o=0;o<e.count;o++){if(!(e.pressures[o]>0)||!t(o))continue;let a=e.corners.subarray(12*o,12*o+12),l=zp(r,a,TC,null,i[0]);l&&l.distance<i[1]&&(!s||l.distance<s.distance)&&(s={cell:o,distance:l.distance})}return s}var TC=new Uint32Array([0,1,2,0,2,3]);var Sh=new Ni,Hp=new G,Mh=new G;function D_(n,e,t){Hp.copy(t).applyMatrix4(n.root.matrixWorld),Mh.copy(Hp).project(n.camera.active),n.ray((.5+.5*Mh.x)*n.width,(.5-.5*Mh.y)*n.height,Sh);let i=bh(Sh,e.views,e.meshes,e.factor,e.cutPlane);if(!i)return!1;let s=Mh.copy(Hp).sub(Sh.origin).dot(Sh.direction),r=.001*e.radius;return i.distance<s-r}var F_=2*Math.PI/180,U_=new WeakMap;function mr(n){let e=U_.get(n);return e===void 0&&U_.set(n,e=n.copies>1?AC(n):null),e}function AC({points:n,triangles:e}){let t=IC(n,e),i=e.length/3,s=RC(n,e),r=new Float64Array(i),o=new Float64Array(i);for(let f=0;f<i;f++){let[p,v,m]=[3*e[3*f],3*e[3*f+1],3*e[3*f+2]],[g,_,M]=[n[v]-n[p],n[v+1]-n[p+1],n[v+2]-n[p+2]],[b,C,R]=[n[m]-n[p],n[m+1]-n[p+1],n[m+2]-n[p+2]],[y,E,U]=[_*R-M*C,M*b-g*R,g*C-_*b],N=Math.hypot(y,E,U),[L,O]=[n[p]+n[v]+n[m],n[p+1]+n[v+1]+n[m+1]];N>0&&(o[f]=N/2,r[f]=(E*L-y*O)/(Math.hypot(L,O)||1))}let a=r.map((f,p)=>{let v=s[p];return v<0?f/(2*o[p]||1):(f+r[v])/(2*(o[p]+o[v])||1)}),l=a.reduce((f,p)=>Math.max(f,Math.abs(p)),0),c=f=>{let p=[];for(let m=0;m<i;m++)o[m]>0&&f*a[m]>.35*l&&p.push(m);let v=LC(n,e,t,o,p);return v&&{outline:NC(n,e,p),angle:v}},[u,d]=[c(1),c(-1)];if(!u||!d)return null;let h=CC(u.angle,d.angle);return{flanks:{left:u,right:d},direction:h,tip:PC(u,d,h)}}function RC(n,e){let t=new Int32Array(e.length/3).fill(-1),i=new Map,s=(r,o)=>Math.hypot(n[3*r]-n[3*o],n[3*r+1]-n[3*o+1],n[3*r+2]-n[3*o+2]);for(let r=0;r<t.length;r++){let o=[...e.subarray(3*r,3*r+3)],a=o.map((h,f)=>[h,o[(f+1)%3]]),[l,c]=a.reduce((h,f)=>s(...f)>s(...h)?f:h),u=l<c?`${l} ${c}`:`${c} ${l}`,d=i.get(u);d===void 0?i.set(u,r):[t[r],t[d]]=[d,r]}return t}function CC(n,e){let t=n[1]-e[1],i=n[2]-e[2];if(!(Math.hypot(t,i)>0))return 0;let s=Math.atan2(i>=0?-t:t,Math.abs(i));return Math.abs(s)<F_?0:Math.abs(s)>Math.PI/2-F_?Math.PI/2:s}function PC(n,e,t){let i=n.outline[0]??[],s=a=>i.reduce((l,c,u)=>u%2===a?l+2*c/i.length:l,0),r=hl(n.angle,s(0),s(1))-hl(e.angle,s(0),s(1));return(Math.cos(t)*(n.angle[2]-e.angle[2])-Math.sin(t)*(n.angle[1]-e.angle[1]))*r<=0?1:-1}function IC(n,e){let t=n.length/3,[i,s]=[0,0];for(let h=0;h<n.length;h+=3)i+=n[h],s+=n[h+1];let r=Math.atan2(s,i),o=(h,f)=>h-2*Math.PI*Math.round((h-f)/(2*Math.PI)),a=h=>Math.atan2(n[3*h+1],n[3*h]),l=new Uint32Array(t+1);for(let h of e)l[h+1]++;for(let h=0;h<t;h++)l[h+1]+=l[h];let c=l.slice(0,t),u=new Uint32Array(e.length);e.forEach((h,f)=>u[c[h]++]=f);let d=new Float64Array(t).fill(NaN);for(let h=0;h<t;h++){if(!Number.isNaN(d[h]))continue;d[h]=o(a(h),r);let f=[h];for(let p=f.pop();p!==void 0;p=f.pop())for(let v=l[p];v<l[p+1];v++){let m=u[v]-u[v]%3;for(let g=0;g<3;g++){let _=e[m+g];Number.isNaN(d[_])&&(d[_]=o(a(_),d[p]),f.push(_))}}}return d}function LC(n,e,t,i,s){let r=s.map(m=>{let[g,_,M]=[0,0,0];for(let b=0;b<3;b++){let C=e[3*m+b];g+=n[3*C+2]/3,_+=Math.hypot(n[3*C],n[3*C+1])/3,M+=t[C]/3}return[i[m],g,_,M]}),o=r.reduce((m,[g])=>m+g,0);if(!(o>0))return null;let a=[1,2,3].map(m=>r.reduce((g,_)=>g+_[0]*_[m],0)/o),[l,c,u,d,h]=[0,0,0,0,0];for(let[m,g,_,M]of r){let[b,C,R]=[g-a[0],_-a[1],M-a[2]];l+=m*b*b,c+=m*b*C,u+=m*C*C,d+=m*b*R,h+=m*C*R}let f=l*u-c*c,[p,v]=f>1e-12*(l+u)**2?[(d*u-h*c)/f,(h*l-d*c)/f]:[0,0];return[a[2]-p*a[0]-v*a[1],p,v]}function NC(n,e,t){let i=new Map,s=c=>{let u=`${n[3*c]} ${n[3*c+1]} ${n[3*c+2]}`,d=i.get(u);return d===void 0&&i.set(u,c),d??c},r=new Set;for(let c of t){let u=[0,1,2].map(d=>s(e[3*c+d]));for(let d=0;d<3;d++){let[h,f]=[u[d],u[(d+1)%3]];r.delete(`${f} ${h}`)||r.add(`${h} ${f}`)}}let o=new Map;for(let c of r){let[u,d]=c.split(" ").map(Number);o.set(u,[...o.get(u)??[],d])}let a=[];for(let c of o.keys()){let u=[];for(let d=c;d!==void 0&&!(u.length>0&&d===c);d=o.get(d)?.pop())u.push(n[3*d+2],Math.hypot(n[3*d],n[3*d+1]));u.length>4&&a.push(u)}let l=Math.max(...a.map(O_),0);return a.filter(c=>O_(c)>.02*l)}function O_(n){let e=0;for(let t=0;t<n.length;t+=2){let[i,s,r,o]=[n[t],n[t+1],n[(t+2)%n.length],n[(t+3)%n.length]];e+=i*o-s*r}return Math.abs(e)/2}function hl([n,e,t],i,s){return n+e*i+t*s}function Gp(n,e,t){let{contacts:i,poses:s}=n;if(!i)return[];let r=s.subarray(12*e.index,12*e.index+12),o=mr(e),a=[];for(let u=0;u<i.count;u++){let d=i.pressures[u];if(!(!(d>0)||!cl(i,u,t)))for(let h=0;h<2;h++){if(i.parts[2*u+h]!==e.index)continue;let f=[],[p,v]=[0,0];for(let R=0;R<4;R++){let y=DC(r,i.corners.subarray(12*u+3*R,12*u+3*R+3));f.push(y[2],Math.hypot(y[0],y[1])),p+=y[0]/4,v+=y[1]/4}let[m,g]=FC(f),_=i.teeth[2*u+h],M=o?(hl(o.flanks.left.angle,m,g)+hl(o.flanks.right.angle,m,g))/2:0,b=Math.atan2(v,p)-2*Math.PI*_/e.copies-M,C=Math.atan2(Math.sin(b),Math.cos(b));a.push({cell:u,tooth:_,side:"left",pressure:d,corners:f,surface:i.surfaces[2*u+h],offset:C})}}let l=new Map,c=u=>`${u.tooth} ${u.surface}`;for(let u of a)l.set(c(u),(l.get(c(u))??0)+u.pressure*u.offset);return a.map(({surface:u,offset:d,...h})=>({...h,side:l.get(c({...h,surface:u}))>=0?"left":"right"})).sort((u,d)=>u.pressure-d.pressure)}function DC(n,e){let[t,i,s]=[e[0]-n[9],e[1]-n[10],e[2]-n[11]];return[n[0]*t+n[3]*i+n[6]*s,n[1]*t+n[4]*i+n[7]*s,n[2]*t+n[5]*i+n[8]*s]}function FC(n){return[(n[0]+n[2]+n[4]+n[6])/4,(n[1]+n[3]+n[5]+n[7])/4]}function k_(n){let e=0;for(let{side:t,pressure:i,corners:s}of n){let r=Math.abs((s[4]-s[0])*(s[7]-s[3])-(s[5]-s[1])*(s[6]-s[2]))/2;e+=(t==="left"?1:-1)*i*r}return e>=0?"left":"right"}function Wp(n,{tooth:e,side:t}){return n.side===t&&(e===null||n.tooth===e)}var wh=class{constructor(e,t=1){this.direction=e;this.tip=t;this.cos=Math.cos(e),this.sin=Math.sin(e),this.#e=this.sin<0?-1:1,this.#t=e===0?1:t}direction;tip;cos;sin;#e;#t;along(e,t){return this.#e*(this.cos*e+this.sin*t)}across(e,t){return this.#t*(this.cos*t-this.sin*e)}inverse(e,t){let[i,s]=[this.#e*e,this.#t*t];return[this.cos*i-this.sin*s,this.sin*i+this.cos*s]}get ends(){return this.direction!==0?["toe","heel","root","tip"]:this.tip>0?["−z end","+z end","root","tip"]:["−z end","+z end","tip","root"]}};function Xp(n,e,t){let i={u0:1/0,u1:-1/0,v0:1/0,v1:-1/0},s=(o,a)=>{let[l,c]=[t.along(o,a),t.across(o,a)];i.u0=Math.min(i.u0,l),i.u1=Math.max(i.u1,l),i.v0=Math.min(i.v0,c),i.v1=Math.max(i.v1,c)},r=mr(n)?.flanks[e].outline??[];for(let o of r)for(let a=0;a<o.length;a+=2)s(o[a],o[a+1]);if(r.length===0){let o=n.points;for(let a=0;a<o.length;a+=3)s(o[a+2],Math.hypot(o[a],o[a+1]))}return!(i.u1>i.u0)||!(i.v1>i.v0)?{u0:-.001,u1:.001,v0:0,v1:.001}:i}function B_(n,e,t){let i=Xp(n,e,t),s=.03*Math.max(i.u1-i.u0,i.v1-i.v0);return{u0:i.u0-s,u1:i.u1+s,v0:i.v0-s,v1:i.v1+s}}function z_(n,e,t){let[i,s]=[!1,!1];for(let r=0;r<8;r+=2){let[o,a,l,c]=[n[r],n[r+1],n[(r+2)%8],n[(r+3)%8]],u=(l-o)*(t-a)-(c-a)*(e-o);u>0&&(i=!0),u<0&&(s=!0)}return!(i&&s)}function V_(n,e,t){for(let i=n.length-1;i>=0;i--)if(z_(n[i].corners,e,t))return n[i];return null}var Eh=class{constructor(e,t,i=320){this.bounds=e;this.axes=t;this.columns=i,this.rows=Math.min(Math.max(Math.round(i*(e.v1-e.v0)/(e.u1-e.u0)),40),640),this.values=new Float32Array(this.columns*this.rows)}bounds;axes;columns;rows;values;included=new Set;largest=0;column(e){return(e-this.bounds.u0)/(this.bounds.u1-this.bounds.u0)*this.columns}row(e){return(e-this.bounds.v0)/(this.bounds.v1-this.bounds.v0)*this.rows}add(e){let{columns:t,rows:i,values:s}=this;for(let{corners:r,pressure:o}of e){this.largest=Math.max(this.largest,o);let a=[];for(let h=0;h<8;h+=2){let[f,p]=[r[h],r[h+1]];a.push(this.column(this.axes.along(f,p)),this.row(this.axes.across(f,p)))}let l=[a[0],a[2],a[4],a[6]],c=[a[1],a[3],a[5],a[7]],u=!1,d=(h,f)=>{if(u=!0,h<0||f<0||h>=t||f>=i)return;let p=f*t+h;o>s[p]&&(s[p]=o)};for(let h=Math.max(0,Math.floor(Math.min(...c)));h<=Math.min(i-1,Math.floor(Math.max(...c)));h++)for(let f=Math.max(0,Math.floor(Math.min(...l)));f<=Math.min(t-1,Math.floor(Math.max(...l)));f++)z_(a,f+.5,h+.5)&&d(f,h);u||d(Math.floor(l.reduce((h,f)=>h+f)/4),Math.floor(c.reduce((h,f)=>h+f)/4))}}at(e,t){let[i,s]=[Math.floor(this.column(e)),Math.floor(this.row(t))];return i<0||s<0||i>=this.columns||s>=this.rows?0:this.values[s*this.columns+i]}};var UC=25,Th=class{constructor(e){this.core=e}core;pointed=new Map;hovered=-1;#e=null;#t=null;#n="";#i=null;#s=0;#r=!1;gears(){let e=this.core.display?.position?.contacts,t=this.core.parts?.parts??[],i=new Set(e?.parts),s=this.core.state.pattern.gear;return t.filter(r=>r.kind==="gear"&&(i.has(r.index)||r.name===s))}teeth(e){return[...new Set(this.cellsOf(e).map(({tooth:t})=>t))].sort((t,i)=>t-i)}pattern(){let{core:e}=this,{display:t,state:i}=e,s=this.gears(),r=s.find(({name:v})=>v===i.pattern.gear)??s[0];if(!r||!t)return null;let o=new wh(mr(r)?.direction??0,mr(r)?.tip),a=this.cellsOf(r),l=this.tooth(r),c=i.pattern.flank==="automatic"?k_(a.filter(v=>l===null||v.tooth===l)):i.pattern.flank,u=B_(r,c,o),d=i.pattern.envelope?this.envelope(r,o,u,{tooth:l,side:c}):null,h=d?[]:a.filter(v=>Wp(v,{tooth:l,side:c})),f=d?.largest??h[h.length-1]?.pressure??0,p=i.colours.field==="contact_pressure"?t.limits:null;return{part:r,axes:o,bounds:u,tooth:l,side:c,cells:h,envelope:d,largest:f,limits:p??[0,f>0?f:1]}}tooth(e){let{tooth:t}=this.core.state.pattern;return t==="pointer"?this.pointed.get(e.index)??null:t!=="all"&&/^\d+$/.test(t)?Number(t):null}cellsOf(e){let t=this.core.display?.position;if(!t)return[];let i=this.core.state.colours.cells,s=this.#e;if(s?.position===t&&s.part===e&&s.choice===i)return s.cells;let r=Gp(t,e,i);return this.#e={position:t,part:e,choice:i,cells:r},r}envelope(e,t,i,s){let{positions:r,state:o}=this.core,a=JSON.stringify([e.name,s,o.colours.cells]);return!this.#t||a!==this.#n||r!==this.#i?(this.#t=new Eh(i,t),this.#n=a,this.#i=r,this.#s++,this.fill(this.#t,e,s,this.#s)):this.#t.included.size<(r?.list.length??0)&&!this.#r&&(this.#s++,this.fill(this.#t,e,s,this.#s)),this.#t}async fill(e,t,i,s){let{core:r}=this,{positions:o}=r,a=()=>s===this.#s&&o===r.positions&&r.state.panels.pattern&&r.state.pattern.envelope;this.#r=!0;let l=performance.now();for(let c=0;o&&c<o.list.length&&a();c++){if(e.included.has(c))continue;let u=await o.load(c).catch(()=>null);if(!a())break;e.included.add(c),u&&e.add(Gp(u,t,r.state.colours.cells).filter(d=>Wp(d,i))),!(performance.now()-l<UC)&&(r.changed(!1),await new Promise(d=>setTimeout(d)),l=performance.now())}s===this.#s&&(this.#r=!1),r.changed(!1)}};var OC=6,gr=new Ni,$p=new Ni,Zo=new yt;function G_(n,e,t){let{scene:i,display:s,state:r}=n;if(!i||!s)return null;i.ray(e,t,gr);let o=s.cutPlane,a=o&&Hn(r.colours.field)?BC(n,e,t,o):null;if(a)return a;let l=bh(gr,s.views,s.meshes,s.factor,o),c=HC(n,e,t,l?.distance??1/0);if(c)return c;if(!l)return null;let{part:u}=l.view,d=new G,h=s.meshes[u.index]?.[l.mesh],f=r.colours.field==="plain"?null:NaN,p=null,v=null;if(l.cap)return d.copy(l.point).applyMatrix4(Zo.copy(l.view.group.matrixWorld).invert()),d.applyMatrix4(ks(s.position?.poses??null,u.index,Zo)),v=u.copies>1?h?.copy??l.copy:null,{x:e,y:t,part:u.name,tooth:v,value:null,node:p,point:d};if(h){if(p=VC(n,h,l,e,t),p!==null?d.set(...Gr(h,p,0)):l.nodes.forEach((m,g)=>d.addScaledVector(W_.set(...Gr(h,m,0)),l.weights[g])),Hn(r.colours.field)){let m=s.values(h,r.colours.field);f=p!==null?m[p]:l.nodes.reduce((g,_,M)=>g+l.weights[M]*m[_],0)}v=u.copies>1?h.copy:null}else zC(u.points,l,d),d.applyAxisAngle(kC,2*Math.PI*l.copy/u.copies),v=u.copies>1?l.copy:null;return d.applyMatrix4(ks(s.position?.poses??null,u.index,Zo)),{x:e,y:t,part:u.name,tooth:v,value:f,node:p,point:d}}var kC=new G(0,0,1),W_=new G;function BC(n,e,t,i){let{display:s,state:r}=n,{field:o}=r.colours;if(!s||!Hn(o))return null;let[a]=yh(gr.origin,gr.direction,i);if(!(a>0)||!Number.isFinite(a))return null;let l=gr.at(a,new G);for(let c of s.views){if(!c.showsSections)continue;let u=l.clone().applyMatrix4(Zo.copy(c.group.matrixWorld).invert());for(let{mesh:d,section:h}of c.meshes){if(!d||!h?.plane)continue;let f=h.section.find(u.x,u.y,u.z,h.plane);if(f<0)continue;let{nodes:p,weights:v}=b_(d,h.section.sources[f],s.factor,[u.x,u.y,u.z]),m=s.values(d,o),g=new G;p.forEach((M,b)=>g.addScaledVector(W_.set(...Gr(d,M,0)),v[b])),g.applyMatrix4(ks(s.position?.poses??null,c.part.index,Zo));let _=p.reduce((M,b,C)=>M+v[C]*m[b],0);return{x:e,y:t,part:c.part.name,tooth:c.part.copies>1?d.copy:null,value:_,node:null,point:g}}}return null}function zC(n,e,t){t.set(0,0,0),e.nodes.forEach((i,s)=>{let r=e.weights[s];t.x+=r*n[3*i],t.y+=r*n[3*i+1],t.z+=r*n[3*i+2]})}function VC(n,e,t,i,s){let r=n.scene,o=n.display.factor,a=null,l=OC,c=new G;for(let u of t.nodes){c.set(...Gr(e,u,o)),c.applyMatrix4(t.view.group.matrixWorld).project(r.camera.active);let d=Math.hypot((.5+.5*c.x)*r.width-i,(.5-.5*c.y)*r.height-s);d<=l&&(l=d,a=u)}return a}function HC(n,e,t,i){let{display:s,state:r}=n,o=s?.position,a=r.colours.field==="contact_pressure"?o?.contacts:null;if(!a||!o||!s)return null;let l=Zo.copy(n.scene.root.matrixWorld).invert();$p.copy(gr).applyMatrix4(l);let c=yh(gr.origin,gr.direction,s.cutPlane);r.hidden_contacts||(c[1]=Math.min(c[1],i+.002*s.radius));let u=N_($p,a,p=>s.cellShown(r,o,p),c);if(!u)return null;let d=$p.at(u.distance,new G),h=r.parts[H_(n,a.parts[2*u.cell])]==="hidden"?1:0,f=a.parts[2*u.cell+h];return{x:e,y:t,part:H_(n,f),tooth:a.teeth[2*u.cell+h],cell:u.cell,value:a.pressures[u.cell],node:null,point:d}}function H_(n,e){return n.parts?.parts[e]?.name??`part ${e}`}var Ko=new Map;function X_(n,e,t){let i=Ko.get(n);if(!i){let s=t(n).then(o=>A_(n,o)),r={shape:s,users:new Set};Ko.set(n,r),s.catch(()=>Ko.get(n)===r&&Ko.delete(n)),i=r}return i.users.add(e),i.shape}function qp(n){for(let[e,{users:t}]of Ko)t.delete(n)&&t.size===0&&Ko.delete(e)}function dl(n){return`position-${String(n).padStart(4,"0")}.bin`}var GC=384e6,Ah=class{constructor(e,t){this.source=e;this.parts=t}source;parts;list=[];#e=new Map;#t=new Map;#n=0;#i=!1;async update(){this.list=await this.source.positions()}cached(e){return this.#e.get(e)}load(e){let t=this.#e.get(e);if(t)return this.#e.delete(e),this.#e.set(e,t),Promise.resolve(t);let i=this.#t.get(e);if(i)return i;let s=this.read(e).finally(()=>this.#t.delete(e));return this.#t.set(e,s),s}async read(e){let t=this.list[e],i=dl(t?.position??e),s=await R_(i,await this.source.position(e),this.parts,r=>X_(r,this,async o=>{if(!this.source.mesh)throw new Error(`${o}: this source contains no meshes`);return this.source.mesh(o)}));if(this.#i&&qp(this),this.#i||s.problem)return s;this.#e.set(e,s),this.#n+=s.bytes;for(let[r,o]of this.#e){if(this.#n<=GC||r===e)break;this.#e.delete(r),this.#n-=o.bytes}return s}dispose(){this.#i=!0,qp(this),this.#e.clear(),this.#n=0}};var Yp=24,WC=260,XC={front:[-90,0],back:[90,0],left:[180,0],right:[0,0],top:[-90,90],bottom:[-90,-90],isometric:[-50,30]},Rh=class{perspective=new si(Yp);orthographic=new Bo;onChange=null;#e={projection:"perspective",target:[0,0,0],azimuth:-50,elevation:30,height:1};#t=1;#n=new G;#i=1;#s=[];#r=!1;#o=!1;#a=0;#c=new G;#h=new G;#u=new G;get active(){return this.#e.projection==="perspective"?this.perspective:this.orthographic}get state(){let e={...this.#e,target:[...this.#e.target]};return this.#r?e.fitted=!0:delete e.fitted,e}setBounds(e,t,i){this.#n.copy(e),this.#i=t>0?t:1,this.#s=i,this.update()}setFitPoints(e){this.#s=e}setAspect(e){this.#t=e>0?e:1,this.#r&&Object.assign(this.#e,this.fitted(this.#e.azimuth,this.#e.elevation)),this.update()}set(e,t=!1){this.interrupt(),this.#e={...e,target:[...e.target]},e.fitted&&(Object.assign(this.#e,this.fitted(e.azimuth,e.elevation)),this.#r=!0),this.changed(t)}setProjection(e){this.#e.projection=e,this.changed(!0)}orbit(e,t){this.interrupt(),this.#e.azimuth=Zp(this.#e.azimuth+e),this.#e.elevation=Jp(this.#e.elevation+t,-90,90),this.changed(!0)}pan(e,t){this.interrupt(),this.shift(e,t),this.changed(!0)}zoom(e,t=0,i=0){this.interrupt();let s=Jp(this.#e.height*e,this.#i*1e-4,this.#i*40),r=s/this.#e.height;this.shift(-t*(1-r),-i*(1-r)),this.#e.height=s,this.changed(!0)}view(e,t=!0){let[i,s]=XC[e],r={...this.#e,azimuth:i,elevation:s};this.#o=t,t&&Object.assign(r,this.fitted(i,s)),this.animateTo(r)}fit(e=!0){let t={...this.#e,...this.fitted(this.#e.azimuth,this.#e.elevation)};this.#o=!0,e?this.animateTo(t):this.set({...t,fitted:!0},!0)}interrupt(){cancelAnimationFrame(this.#a),this.#r=!1}fitted(e,t){if(this.#s.length===0){let f=2.1*this.#i/Math.min(1,this.#t);return{target:[this.#n.x,this.#n.y,this.#n.z],height:f}}let[i,s,r]=[new G,new G,new G];$_(e,t,i,s,r);let o=new ci,a=new G,l=this.#s.map(f=>new G(f.dot(i),f.dot(s),f.dot(r)));for(let f of l)o.expandByPoint(f);let c=o.getCenter(a),u=this.#e.projection==="perspective"?Math.tan(Yp*Math.PI/360):0,d=.001*this.#i;for(let f of l){let p=(f.z-c.z)*u;d=Math.max(d,2*(Math.abs(f.y-c.y)+p),2*(Math.abs(f.x-c.x)/this.#t+p))}d*=1.1;let h=i.multiplyScalar(c.x).addScaledVector(s,c.y).addScaledVector(r,c.z);return{target:[h.x,h.y,h.z],height:d}}animateTo(e){if(cancelAnimationFrame(this.#a),matchMedia("(prefers-reduced-motion: reduce)").matches){this.set({...e,fitted:this.#o},!0);return}let t=this.state,i=Zp(e.azimuth-t.azimuth),s=performance.now(),r=o=>{let a=Jp((o-s)/WC,0,1),l=a*a*(3-2*a);this.#e.azimuth=Zp(t.azimuth+l*i),this.#e.elevation=t.elevation+l*(e.elevation-t.elevation),this.#e.height=t.height*(e.height/t.height)**l;for(let c=0;c<3;c++)this.#e.target[c]=t.target[c]+l*(e.target[c]-t.target[c]);a===1&&(this.#e={...e,target:[...e.target]},this.#r=this.#o),this.changed(!0),a<1&&(this.#a=requestAnimationFrame(r))};this.#a=requestAnimationFrame(r)}shift(e,t){let{height:i,target:s}=this.#e;for(let r=0;r<3;r++){let o=this.#c.getComponent(r),a=this.#h.getComponent(r);s[r]-=i*(e*o+t*a)}}changed(e){this.update(),this.onChange?.(e)}get direction(){return this.#u}update(){let{azimuth:e,elevation:t,height:i,target:s}=this.#e;$_(e,t,this.#c,this.#h,this.#u);let r=i/(2*Math.tan(Yp*Math.PI/360)),o=s[0],a=s[1],l=s[2],c=r-(this.#n.x-o)*this.#u.x-(this.#n.y-a)*this.#u.y-(this.#n.z-l)*this.#u.z,u=1.3*this.#i+.02*i;for(let h of[this.perspective,this.orthographic])h.position.set(o+r*this.#u.x,a+r*this.#u.y,l+r*this.#u.z),h.matrix.makeBasis(this.#c,this.#h,this.#u),h.quaternion.setFromRotationMatrix(h.matrix),h.updateMatrixWorld();this.perspective.near=Math.max(c-u,r*.02),this.perspective.far=Math.max(c+u,this.perspective.near*1.1),this.perspective.aspect=this.#t,this.perspective.updateProjectionMatrix();let d=this.orthographic;d.near=c-u,d.far=c+u,d.top=i/2,d.bottom=-i/2,d.right=i/2*this.#t,d.left=-d.right,d.updateProjectionMatrix()}};function $_(n,e,t,i,s){let r=n*Math.PI/180,o=e*Math.PI/180;t.set(-Math.sin(r),Math.cos(r),0),s.set(Math.cos(o)*Math.cos(r),Math.cos(o)*Math.sin(r),Math.sin(o)),i.crossVectors(s,t)}function Jp(n,e,t){return Math.min(Math.max(n,e),t)}function Zp(n){return((n+180)%360+360)%360-180}var jo=class extends Error{constructor(){super("This browser cannot draw three-dimensional pictures: WebGL 2 is not available. Turn on hardware acceleration in the browser's settings, or use another browser."),this.name="NoWebGlError"}},Ch=class{constructor(e){this.container=e;this.uniforms=Wv(this.scaleTexture);let t=this.canvas.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0,depth:!0,powerPreference:"high-performance"});if(!t)throw new jo;this.#e=new $u({canvas:this.canvas,context:t,stencil:!0,alpha:!0}),this.#e.setClearColor(0,0),this.root.matrixAutoUpdate=!1,this.scene.add(this.root),e.append(this.canvas),this.#t=new ResizeObserver(()=>this.resize()),this.#t.observe(e),this.canvas.addEventListener("webglcontextrestored",()=>this.invalidate()),this.resize()}container;canvas=document.createElement("canvas");camera=new Rh;scene=new Oa;root=new rn;uniforms;scaleTexture=Qv();onPrepare=null;onFrame=null;frames=0;width=1;height=1;#e;#t;#n=0;#i=new Ns;#s=new yt;resize(){this.width=Math.max(this.container.clientWidth,1),this.height=Math.max(this.container.clientHeight,1);let e=Math.min(window.devicePixelRatio||1,2);this.uniforms.pixelRatio.value=e,this.#e.setPixelRatio(e),this.#e.setSize(this.width,this.height),this.camera.setAspect(this.width/this.height),this.draw()}invalidate(){this.#n||(this.#n=requestAnimationFrame(()=>{this.#n=0,this.draw()}))}frustum(){let{active:e}=this.camera;return this.#s.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this.#i.setFromProjectionMatrix(this.#s)}draw(){this.scene.updateMatrixWorld(),this.onPrepare?.(),this.#e.render(this.scene,this.camera.active),this.frames++,this.onFrame?.()}snapshot(e){let t=this.#e.getPixelRatio(),i=document.createElement("canvas");try{this.uniforms.pixelRatio.value=e,this.#e.setPixelRatio(e),this.#e.setSize(this.width,this.height,!1),this.draw(),i.width=this.canvas.width,i.height=this.canvas.height,i.getContext("2d").drawImage(this.canvas,0,0)}finally{this.uniforms.pixelRatio.value=t,this.#e.setPixelRatio(t),this.#e.setSize(this.width,this.height),this.draw()}return i}ray(e,t,i){let{active:s}=this.camera,r=2*e/this.width-1,o=1-2*t/this.height;return i.origin.set(r,o,-1).unproject(s),i.direction.set(r,o,1).unproject(s).sub(i.origin).normalize(),i}dispose(){cancelAnimationFrame(this.#n),this.#t.disconnect(),this.scaleTexture.dispose(),this.#e.dispose(),this.#e.forceContextLoss(),this.canvas.remove()}};var Ph=class{constructor(e,t){this.element=e;this.changed=t;this.#t.addEventListener("change",this.#n)}element;changed;theme="light";#e="system";#t=matchMedia("(prefers-color-scheme: dark)");#n=()=>{this.set(this.#e),this.changed()};set(e){this.#e=e,this.theme=e==="system"?this.#t.matches?"dark":"light":e,this.element.dataset.theme=this.theme}dispose(){this.#t.removeEventListener("change",this.#n)}};var $C=640,qC=900,YC=100,Lh=class{constructor(e,t,i){this.element=e;this.state=mh(i,ph()),this.#i=i.colours?.field!==void 0,this.#s=i.colours?.cells!==void 0,this.theme=new Ph(e,()=>this.changed()),this.theme.set(this.state.theme),this.#c.observe(e);try{this.scene=new Ch(t),this.display=new xh(this.scene)}catch(o){this.fail(o instanceof jo?o:new jo);return}let{scene:s,display:r}=this;t.append(this.labels.element),s.onPrepare=()=>r.prepareFrame(),s.onFrame=()=>{this.labels.update(s.camera.active,s.root.matrix,s.width,s.height),this.#a||=window.setTimeout(()=>this.updateMarks(),YC)},s.camera.onChange=o=>{this.state.camera=s.camera.state,this.probe=null,s.invalidate(),this.changed(o)}}element;state;status="empty";failure="";notice="";source=null;parts=null;positions=null;probe=null;help=!1;narrow=!1;drawers=!1;drawer=null;progress=null;scene=null;display=null;labels=new _h;animation=new Zu(this);pattern=new Th(this);theme;onChange=null;#e=new Set;#t=0;#n=0;#i;#s;#r=new Map;#o="";#a=0;#c=new ResizeObserver(()=>this.resize());resize(){let e=this.element.clientWidth,t=e>0&&e<$C,i=e>0&&e<qC;t===this.narrow&&i===this.drawers||(this.narrow=t,this.drawers=i,this.drawer=null,this.element.toggleAttribute("data-narrow",t),this.element.toggleAttribute("data-drawers",i),this.changed(!1))}isOpen(e){return this.drawers?this.drawer===e:this.state.panels[e]}toggle(e,t=!this.isOpen(e)){this.drawers?this.setDrawer(t?e:null):this.update({panels:{[e]:t}})}setDrawer(e){this.drawer=e,this.changed(!1)}subscribe(e){return this.#e.add(e),()=>this.#e.delete(e)}changed(e=!0){e&&(this.#h=!0),!this.#t&&(this.#t=requestAnimationFrame(()=>{this.#t=0;for(let t of this.#e)t();this.#h&&this.onChange?.(structuredClone(this.state)),this.#h=!1}))}#h=!1;fail(e){this.status="failed",this.failure=e instanceof Error?e.message:String(e),this.changed(!1)}async show(e){this.scene&&(this.source=e,this.status!=="ready"&&(this.status="loading"),this.notice="",this.changed(!1),await this.load(!0))}async reload(){this.source&&this.scene&&await this.load(!1)}async load(e){let{source:t,display:i,scene:s}=this;if(!t||!i||!s)return;let r=++this.#n,o=()=>r!==this.#n;e&&this.animation.stop();try{let a=T_(await t.parts()),l=new Ah(t,a.parts),c="";try{await l.update()}catch(d){c=`The list of positions cannot be read: ${Ih(d)}`}let u=l.list.length>0?await l.load(0).catch(d=>(c=Ih(d),null)):null;if(o()){l.dispose();return}u?.problem&&(c=q_(u)),this.positions?.dispose(),this.parts=a,h_(a.units),this.positions=l,this.#r.clear(),this.notice=c,i.setParts(a.parts,u),i.setPosition(u),!this.#i&&(u?.meshes.length||u?.contacts)&&(this.#i=!0,this.state.colours.field=u.meshes.length?"von_mises":"contact_pressure"),!this.#s&&u?.contacts&&(this.#s=!0,qv(u.contacts)&&(this.state.colours.cells="flanks")),this.state.position=Math.min(Math.max(0,Math.trunc(this.state.position)),Math.max(0,l.list.length-1)),this.status="ready",this.apply(),i.updateBounds(),this.state.camera?s.camera.set(this.state.camera):a.parts.length>0&&s.camera.fit(!1),this.state.position>0&&await this.goTo(this.state.position),this.changed()}catch(a){o()||this.fail(a)}}async updatePositions(){let{positions:e}=this;if(!e)return;let t=e.list.length===0;try{await e.update()}catch(i){this.notice=`The list of positions cannot be read: ${Ih(i)}`}this.#r.clear(),t&&e.list.length>0?await this.load(!0):this.update({})}update(e){let t=this.state;this.state=mh(e,t),e.colours?.field&&(this.#i=!0),e.colours?.cells&&(this.#s=!0),this.probe=null,this.theme.set(this.state.theme),e.camera&&this.scene&&this.scene.camera.set(this.state.camera),this.apply(),e.parts&&this.display?.updateBounds(),e.position!==void 0&&this.goTo(this.state.position),this.changed()}apply(){let{display:e,scene:t}=this;if(!e||!t||this.status!=="ready")return;let i=e.apply(this.state,this.#r.get(this.limitsKey())??null);this.labels.set(i),t.invalidate(),this.state.colours.limits==="all"&&this.findAllLimits()}setVisibility(e,t){let i={...this.state.parts};for(let s of e)i[s]=t;this.update({parts:i})}async goTo(e){let{positions:t,display:i}=this;if(!t||!i||t.list.length===0)return;let s=Math.min(Math.max(0,e),t.list.length-1);this.state.position=s,this.changed();try{let r=await t.load(s);if(t!==this.positions||this.state.position!==s)return;this.notice=q_(r),i.position!==r&&i.setPosition(r),this.probe=null,this.apply()}catch(r){if(t!==this.positions||this.state.position!==s)return;this.animation.stop(),this.notice=`${Ih(r)}. The picture shows another position.`}this.changed()}limitsKey(){let e=Object.entries(this.state.parts).filter(([,t])=>t==="hidden");return JSON.stringify([this.state.colours.field,this.state.colours.cells,e.map(([t])=>t).sort()])}async findAllLimits(){let{positions:e,display:t,state:i}=this,s=this.limitsKey();if(!e||!t||i.colours.field==="plain"||this.#r.has(s)||this.#o===s)return;this.#o=s;let r=()=>this.#o===s&&e===this.positions&&this.state.colours.limits==="all",o=null;for(let l=0;l<e.list.length&&r();l++){this.progress=l/e.list.length,this.changed(!1);let c=await e.load(l).catch(()=>null),u=c&&r()?t.limitsOf(c,this.state):null;u&&(o=o?[Math.min(o[0],u[0]),Math.max(o[1],u[1])]:u)}if(this.#o!==s)return;let a=r();this.#o="",this.progress=null,a&&(o?this.#r.set(s,o):this.#r.set(s,[0,1]),this.apply()),this.changed(!1)}probePointer(e,t){this.probe=this.status==="ready"?G_(this,e,t):null,this.state.panels.pattern&&this.followPointer(),this.changed(!1)}followPointer(){let{probe:e,pattern:t}=this,i=e?.cell??-1,s=this.display?.position?.contacts;for(let o=0;s&&i>=0&&o<2;o++)t.pointed.set(s.parts[2*i+o],s.teeth[2*i+o]);let r=this.parts?.parts.find(({name:o})=>o===e?.part);e&&i<0&&r&&e.tooth!==null&&t.pointed.set(r.index,e.tooth),this.hover(i)}hover(e){let{display:t,scene:i,pattern:s}=this;s.hovered=e,t?.contacts.mark(t.position?.contacts??null,e)&&i?.invalidate(),this.changed(!1)}updateMarks(){clearTimeout(this.#a),this.#a=0;let{scene:e,display:t}=this;!e||!t||this.status!=="ready"||(this.labels.hide(i=>D_(e,t,i)),this.labels.arrange(e.width,e.height,this.element.querySelector(".cv-legend")?.getBoundingClientRect()??null))}clearProbe(){this.pattern.hovered>=0&&this.hover(-1),this.probe&&(this.probe=null,this.changed(!1))}get hasMeshes(){return(this.display?.position?.meshes.length??0)>0}get missingField(){let{field:e}=this.state.colours,t=this.display?.position;return e==="plain"||this.status!=="ready"?!1:Hn(e)?!t?.meshes.length:!t?.contacts}project(e,t){let{scene:i,display:s}=this,r=s?.views.find(l=>l.part.name===e);if(!i||!r)return null;let o=new G(...t).applyMatrix4(r.group.matrixWorld).project(i.camera.active),a=i.canvas.getBoundingClientRect();return{x:a.left+(.5+.5*o.x)*i.width,y:a.top+(.5-.5*o.y)*i.height}}nodalValue(e,t){let{display:i,parts:s}=this,r=s?.parts.findIndex(l=>l.name===e)??-1,o=i?.meshes[r]?.[0],{field:a}=this.state.colours;return o&&i&&Hn(a)?i.values(o,a)[t]??NaN:NaN}dispose(){this.#n++,cancelAnimationFrame(this.#t),clearTimeout(this.#a),this.#c.disconnect(),this.animation.stop(),this.positions?.dispose(),this.display?.dispose(),this.scene?.dispose(),this.theme.dispose(),this.#e.clear()}};function q_({problem:n}){return n&&`${n}. The mesh is not displayed.`}function Ih(n){return n instanceof nn||n instanceof Error?n.message:String(n)}var Y_=.35,JC=18;function J_(n,e){let t=n.scene,i=new Map,s=null,r=0,o=0,a=0,l=new G,c=f=>{let p=e.getBoundingClientRect();return{x:f.clientX-p.left,y:f.clientY-p.top}},u=(f,p)=>{if(!n.state.cut.on)return!1;let v=l.copy(n.display.cut.handle).project(t.camera.active);return Math.hypot((.5+.5*v.x)*t.width-f,(.5-.5*v.y)*t.height-p)<JC};e.addEventListener("pointerdown",f=>{e.setPointerCapture(f.pointerId),e.focus({preventScroll:!0}),n.drawer&&n.setDrawer(null);let{x:p,y:v}=c(f);i.set(f.pointerId,{x:p,y:v}),i.size>1?s="pan":f.button===0&&u(p,v)?s="cut":s=f.button===0&&!f.shiftKey?"orbit":"pan",n.clearProbe(),n.display?.setDragging(s==="cut",n.state),e.dataset.drag=s}),e.addEventListener("pointermove",f=>{let{x:p,y:v}=c(f),m=i.get(f.pointerId);if(!m||!s){let M=u(p,v);e.dataset.handle=String(M),n.display?.cut.setHighlight(M),o=p,a=v,r||=requestAnimationFrame(()=>{r=0,n.probePointer(o,a)});return}let g=p-m.x,_=v-m.y;if(i.size===2){let M=[...i].find(([R])=>R!==f.pointerId)[1],b=Math.hypot(m.x-M.x,m.y-M.y),C=Math.hypot(p-M.x,v-M.y);t.camera.pan(g/2/t.height,-_/2/t.height),b>0&&C>0&&t.camera.zoom(b/C,...h((p+M.x)/2,(v+M.y)/2))}else if(s==="orbit")t.camera.orbit(-g*Y_,_*Y_);else if(s==="pan")t.camera.pan(g/t.height,-_/t.height);else{let{cut:M}=n.display;Z_(n,M.drag(g,_,t.camera.active,t.width,t.height))}m.x=p,m.y=v});let d=f=>{i.delete(f.pointerId),i.size===0&&(s=null,n.display?.setDragging(!1,n.state),delete e.dataset.drag)};e.addEventListener("pointerup",d),e.addEventListener("pointercancel",d),e.addEventListener("pointerleave",()=>{cancelAnimationFrame(r),r=0,n.clearProbe()}),e.addEventListener("contextmenu",f=>f.preventDefault()),e.addEventListener("dblclick",()=>t.camera.fit());let h=(f,p)=>[(f-t.width/2)/t.height,(t.height/2-p)/t.height];e.addEventListener("wheel",f=>{f.preventDefault();let{x:p,y:v}=c(f),m=f.deltaY*(f.deltaMode===1?16:1);t.camera.zoom(Math.exp(Math.min(Math.max(m,-240),240)*.0016),...h(p,v))},{passive:!1})}function Z_(n,e){let{cut:t}=n.display,i=Math.min(Math.max(t.offset+e,t.range[0]),t.range[1]);n.update({cut:{offset:i}})}function Qo(n,e){let t=e.normal??n.state.cut.normal,i=n.scene.camera.direction,s=typeof t=="string"?i[t]:i.x*t[0]+i.y*t[1]+i.z*t[2];n.update({cut:{...e,...e.normal?{offset:null}:{},...e.on===!1?{}:{flipped:s<0}}})}var K_=[["View",[{keys:"F",label:"Fit the parts into the picture"},{keys:"1 … 6",label:"Front, back, left, right, top, bottom"},{keys:"7",label:"Isometric"},{keys:"P",label:"Perspective or orthographic"},{keys:"Arrow keys",label:"Orbit (picture focused)"},{keys:"Shift + arrow keys",label:"Pan (picture focused)"},{keys:"+ −",label:"Zoom"}]],["Display",[{keys:"M",label:"Edges of the finite elements"},{keys:"V",label:"Force vectors"},{keys:"C",label:"Cutting plane"},{keys:"[ ]",label:"Move the cutting plane"},{keys:"D",label:"Undeformed, true or automatic deformation"}]],["Animation",[{keys:"K",label:"Play or pause"},{keys:", .",label:"Previous or next position"}]],["Panels",[{keys:"B",label:"Parts"},{keys:"S",label:"Settings"},{keys:"G",label:"Plots"},{keys:"U",label:"Contact pattern on the unrolled flank"},{keys:"?",label:"This help"},{keys:"Esc",label:"Close"}]],["Pointer",[{keys:"Drag",label:"Orbit"},{keys:"Right or Shift + drag",label:"Pan"},{keys:"Wheel",label:"Zoom at the pointer"},{keys:"Double click",label:"Fit"}]]],ZC={1:"front",2:"back",3:"left",4:"right",5:"top",6:"bottom",7:"isometric"};function j_(n,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let t=e.target;if(t.closest("input:not([type=checkbox]):not([type=range]), select, textarea"))return!1;let{scene:i,state:s,animation:r}=n;if(e.key==="?")return n.help=!n.help,n.changed(!1),!0;if(e.key==="Escape"&&n.help)return n.help=!1,n.changed(!1),!0;if(e.key==="Escape"&&n.drawer)return n.setDrawer(null),!0;if(!i||n.status!=="ready")return!1;let{camera:o}=i;if(t===i.canvas&&e.key.startsWith("Arrow")){let u=e.key==="ArrowRight"?1:e.key==="ArrowLeft"?-1:0,d=e.key==="ArrowUp"?1:e.key==="ArrowDown"?-1:0;return e.shiftKey?o.pan(.05*u,.05*d):o.orbit(-6*u,-6*d),!0}let a=ZC[e.key];if(a)return o.view(a),!0;let{panels:l,forces:c}=s;switch(e.key.toLowerCase()){case"f":o.fit();break;case"p":o.setProjection(s.camera?.projection==="orthographic"?"perspective":"orthographic");break;case"+":case"=":o.zoom(.85);break;case"-":case"_":o.zoom(1/.85);break;case"m":n.update({mesh_edges:!s.mesh_edges});break;case"v":{let u=!(c.bearings||c.meshes);n.update({forces:{bearings:u,meshes:u}});break}case"c":Qo(n,{on:!s.cut.on});break;case"[":case"]":s.cut.on&&Z_(n,(e.key==="["?-.04:.04)*n.display.radius);break;case"d":n.update({deformation:KC(n)});break;case"k":r.toggle();break;case",":r.step(-1);break;case".":r.step(1);break;case"b":n.toggle("parts");break;case"s":n.toggle("settings");break;case"g":n.update({panels:{plots:!l.plots}});break;case"u":n.update({panels:{pattern:!l.pattern}});break;default:return!1}return!0}function KC(n){let{mode:e,factor:t}=n.state.deformation;return e==="automatic"?{mode:"factor",factor:0}:t===0?{mode:"factor",factor:1}:{mode:"automatic",factor:1}}function Nh(n,e,t){let i=(e-n)/Math.max(t,1),s=10**Math.floor(Math.log10(i)),r=[1,2,5,10].map(a=>a*s).find(a=>a>=i)??10*s,o=[];for(let a=Math.ceil(n/r-1e-9);a*r<=e+1e-9*r;a++)o.push(a*r);return o}var jC=.09;function Dh(n,e,t){let i=jC*(e-n);return[n,...Nh(n,e,t).filter(s=>s>n+i&&s<e-i),e]}function fl(n){let{field:e}=n.state.colours;if(Ei[e].quantity==="stress")return Oi();if(Ei[e].quantity==="none")return{symbol:"",factor:1};let t=n.display?.limits;return Tn("m",t?Math.max(Math.abs(t[0]),Math.abs(t[1])):0)}function ea(n){return Ei[n.state.colours.field].label}function Fh(n){let e=fl(n),t=n.display?.limits;if(!t)return{ticks:[],unit:e.symbol};let{bands:i}=n.state.colours,s=t[0]*e.factor,r=t[1]*e.factor;return s===r?{ticks:[{fraction:.5,text:Ut(s)}],unit:e.symbol}:{ticks:(i>0&&i<=12?Array.from({length:i+1},(l,c)=>s+c/i*(r-s)):Dh(s,r,5)).map(l=>({fraction:(l-s)/(r-s),text:Ut(Math.abs(l)<1e-9*Math.abs(r-s)?0:l,4)})),unit:e.symbol}}var Bs={left:58,right:92,top:20,bottom:36},Kp=14,ey=.6,ta=class{constructor(e,t,{bounds:i},s=!0){this.width=e;this.height=t;this.bar=s;let r=Math.max(e-Bs.left-(s?Bs.right:12),40),o=Math.max(t-Bs.top-Bs.bottom,30);this.scale=Math.min(r/(i.u1-i.u0),o/(i.v1-i.v0)),this.left=Bs.left+(r-this.scale*(i.u1-i.u0))/2,this.bottom=Bs.top+(o+this.scale*(i.v1-i.v0))/2,this.right=this.left+this.scale*(i.u1-i.u0),this.top=this.bottom-this.scale*(i.v1-i.v0),this.#e=this.left-this.scale*i.u0,this.#t=this.bottom+this.scale*i.v0}width;height;bar;scale;#e;#t;right;top;left;bottom;x(e){return this.#e+this.scale*e}y(e){return this.#t-this.scale*e}inverse(e,t){return[(e-this.#e)/this.scale,(this.#t-t)/this.scale]}};function Uh(n,[e,t],i){let s=Math.min(Math.max((n-e)/(t-e||1),0),1);return Hr(fr(i.scale,Vr(s,i.bands)))}function Bh(n,e,t,i,s,r=-1){let{axes:o,side:a,part:l,limits:c}=t,u=f=>{let p=[];for(let v=0;v<f.length;v+=2){let[m,g]=[f[v],f[v+1]];p.push(e.x(o.along(m,g)),e.y(o.across(m,g)))}return p},d=(mr(l)?.flanks[a].outline??[]).map(u);n.fill(d,s.flank),t.envelope&&QC(n,e,t,i);for(let{corners:f,pressure:p}of t.cells)n.fill([u(f)],Uh(p,c,i),!0);for(let f of d)n.stroke(f,s.muted,1,!0);let h=t.cells.find(({cell:f})=>f===r);h&&n.stroke(u(h.corners),s.mark,2,!0),e2(n,e,t,s),e.bar&&t2(n,e,c,i,s)}function QC(n,e,{envelope:t,limits:i},s){let{bounds:r,columns:o,rows:a,values:l}=t,c=(r.u1-r.u0)/o,u=(r.v1-r.v0)/a;for(let d=0;d<a;d++){let h=e.y(r.v0+(d+1)*u),f=e.y(r.v0+d*u);for(let p=0;p<o;){let v=l[d*o+p],m=p++;if(!(v>0))continue;let g=Uh(v,i,s);for(;p<o&&l[d*o+p]>0&&Uh(l[d*o+p],i,s)===g;)p++;let[_,M]=[e.x(r.u0+m*c),e.x(r.u0+p*c)];n.fill([[_,h,M,h,M,f,_,f]],g,!0)}}}function jp({part:n,side:e,axes:t}){if(t.direction===0)return[0,0];let{u0:i,v0:s}=Xp(n,e,t);return[i,s]}function e2(n,e,t,i){let{left:s,right:r,top:o,bottom:a}=e,{factor:l,symbol:c}=Tn("m",1),{bounds:u,axes:d}=t,[h,f]=jp(t),p=d.direction===0;n.stroke([s,o,s,a,r,a],i.muted,1);for(let M of Nh((u.u0-h)*l,(u.u1-h)*l,Math.min((r-s)/60,10))){let b=e.x(M/l+h);n.stroke([b,a,b,a+4],i.muted,1),n.text(b,a+15,Ut(M),i.muted,"middle")}for(let M of Nh((u.v0-f)*l,(u.v1-f)*l,Math.min((a-o)/26,8))){let b=e.y(M/l+f);n.stroke([s-4,b,s,b],i.muted,1),n.text(s-7,b+4,Ut(M),i.muted,"end")}let[v,m,g,_]=d.ends;n.text(s,a+30,v,i.muted,"start"),n.text(r,a+30,m,i.muted,"end"),n.text(s-16,a+16,g,i.muted,"end"),n.text(s-16,o-8,_,i.muted,"end"),n.text((s+r)/2,a+30,`${p?"z":"along the face"} in ${c}`,i.text,"middle"),n.text(s-44,(o+a)/2,`${p?"radius":"across the face"} in ${c}`,i.text,"middle",!0)}function t2(n,e,t,i,s){let r=e.width-Bs.right+22,[o,a]=[Bs.top+16,e.height-Bs.bottom],l=Oi(),c=i.bands>0?i.bands:48;for(let h=0;h<c;h++){let f=t[0]+(h+.5)/c*(t[1]-t[0]),[p,v]=[a-h*(a-o)/c,a-(h+1)*(a-o)/c];n.fill([[r,p,r+Kp,p,r+Kp,v,r,v]],Uh(f,t,i),!0)}n.text(r,o-7,l.symbol,s.text,"start");let[u,d]=[t[0]*l.factor,t[1]*l.factor];for(let h of Dh(u,d,a-o<90?2:4)){let f=a-(h-u)/(d-u||1)*(a-o);n.text(r+Kp+6,f+4,Ut(h),s.muted,"start")}}var Oh=class{constructor(e){this.context=e}context;fill(e,t,i=!1){let{context:s}=this;s.fillStyle=t,s.beginPath();for(let r of e)this.path(r,!0);s.fill("evenodd"),i&&(s.strokeStyle=t,s.lineWidth=ey,s.stroke())}stroke(e,t,i,s=!1){let{context:r}=this;r.strokeStyle=t,r.lineWidth=i,r.beginPath(),this.path(e,s),r.stroke()}path(e,t){let{context:i}=this;for(let s=0;s<e.length;s+=2)s===0?i.moveTo(e[0],e[1]):i.lineTo(e[s],e[s+1]);t&&i.closePath()}text(e,t,i,s,r,o=!1){let{context:a}=this;a.fillStyle=s,a.textAlign=r==="middle"?"center":r,a.save(),a.translate(e,t),o&&a.rotate(-Math.PI/2),a.fillText(i,0,0),a.restore()}},kh=class{elements=[];fill(e,t,i=!1){e.length!==0&&this.elements.push(`<path d="${e.map(s=>Q_(s,!0)).join("")}" fill="${t}"${i?` stroke="${t}" stroke-width="${ey}"`:' fill-rule="evenodd"'}/>`)}stroke(e,t,i,s=!1){this.elements.push(`<path d="${Q_(e,s)}" fill="none" stroke="${t}" stroke-width="${i}"/>`)}text(e,t,i,s,r,o=!1){let a=o?` transform="rotate(-90 ${e.toFixed(1)} ${t.toFixed(1)})"`:"";this.elements.push(`<text x="${e.toFixed(1)}" y="${t.toFixed(1)}" fill="${s}" text-anchor="${r}"${a}>${zh(i)}</text>`)}};function Q_(n,e){let t="";for(let i=0;i<n.length;i+=2)t+=`${i===0?"M":"L"}${n[i].toFixed(2)} ${n[i+1].toFixed(2)}`;return e?`${t}Z`:t}function zh(n){return n.replace(/[&<>"]/g,e=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[e])}function ty(n,e,t,i){let s=new TextEncoder,r=[],o=[],a=0,l=f=>{let p=typeof f=="string"?s.encode(f):f;r.push(p),a+=p.length},c=(f,p)=>{o.push(a),l(`${o.length} 0 obj
${f}
`),p!==void 0&&(l(`stream
`),l(p),l(`
endstream
`)),l(`endobj
`)},u=Math.round(842*t/e),d=`q 842 0 0 ${u} 0 0 cm /Picture Do Q`;l(`%PDF-1.4
`),c("<< /Type /Catalog /Pages 2 0 R >>"),c("<< /Type /Pages /Kids [3 0 R] /Count 1 >>"),c(`<< /Type /Page /Parent 2 0 R /MediaBox [0 0 842 ${u}] /Resources << /XObject << /Picture 4 0 R >> >> /Contents 5 0 R >>`),c(`<< /Type /XObject /Subtype /Image /Width ${e} /Height ${t} /ColorSpace /DeviceRGB /BitsPerComponent 8 /Filter /DCTDecode /Length ${n.length} >>`,n),c(`<< /Length ${d.length} >>`,d),c(`<< /Title <${n2(i)}> /Producer (Calyx) >>`);let h=a;l(`xref
0 ${o.length+1}
0000000000 65535 f 
`);for(let f of o)l(`${String(f).padStart(10,"0")} 00000 n 
`);return l(`trailer
<< /Size ${o.length+1} /Root 1 0 R /Info 6 0 R >>
startxref
${h}
%%EOF
`),new Blob(r,{type:"application/pdf"})}function n2(n){let e="FEFF";for(let t=0;t<n.length;t++)e+=n.charCodeAt(t).toString(16).padStart(4,"0").toUpperCase();return e}var i2={right:[9,4,"start"],left:[-9,4,"end"],above:[0,-14,"middle"],below:[0,22,"middle"]},Qp=2,s2="system-ui, -apple-system, 'Segoe UI', Roboto, Helvetica, Arial, sans-serif",zs={width:16,height:200,right:92,top:56};function r2(n){let{width:e,height:t}=n.scene,i=getComputedStyle(n.element),s=r=>i.getPropertyValue(r).trim();return{width:e,height:t,text:s("--cv-text"),muted:s("--cv-muted"),background:s("--cv-stage"),halo:s("--cv-stage")}}function ny(n,e){let{scene:t,labels:i,state:s,display:r}=n,o=[],a=(h,f,p,v="")=>o.push(`<text x="${h.toFixed(1)}" y="${f.toFixed(1)}" fill="${e.text}" stroke="${e.halo}" stroke-width="3" stroke-linejoin="round" paint-order="stroke" ${v}>${zh(p)}</text>`);for(let h of i.placed(t.camera.active,t.root.matrix,e.width,e.height)){let f=h.hidden?'stroke-dasharray="3 2" opacity="0.6"':"";(h.kind==="maximum"||h.kind==="minimum")&&o.push(`<circle cx="${h.x.toFixed(1)}" cy="${h.y.toFixed(1)}" r="4" fill="none" stroke="${e.text}" stroke-width="1.6" ${f}/>`);let[p,v,m]=i2[h.side];a(h.x+p,h.y+v,h.text,`font-weight="600" text-anchor="${m}"${h.hidden?' opacity="0.7"':""}`)}let{limits:l}=r,{colours:c}=s;if(l&&c.field!=="plain"){let h=e.width-zs.right,f=c.bands>0?c.bands:64;for(let m=0;m<f;m++){let g=Hr(fr(c.scale,c.bands>0?Vr((m+.5)/f,f):m/(f-1))),_=zs.height/f,M=zs.top+zs.height-(m+1)*_;o.push(`<rect x="${h}" y="${M.toFixed(2)}" width="${zs.width}" height="${(_+.4).toFixed(2)}" fill="${g}"/>`)}let{ticks:p,unit:v}=Fh(n);for(let m of p)a(h+zs.width+7,zs.top+zs.height*(1-m.fraction)+4,m.text);a(e.width-16,zs.top-18,`${ea(n)}${v?` in ${v}`:""}`,'text-anchor="end" font-weight="600"')}let u=n.positions?.list[s.position],d=[n.source?.title,u?`position ${u.position}`:""].filter(Boolean).join(", ");return d&&a(16,e.height-16,d),n.hasMeshes&&a(16,e.height-36,`deformation × ${r.factor}`),o.join(`
`)}function em(n,e){return`<svg xmlns="http://www.w3.org/2000/svg" width="${n.width}" height="${n.height}" viewBox="0 0 ${n.width} ${n.height}" font-family="${s2}" font-size="12">
${e}
</svg>
`}function iy(n,e){let t=n.display.cut.group,i=t.visible;t.visible=!1;let s=n.scene.snapshot(Qp);t.visible=i,n.scene.invalidate();let r=document.createElement("canvas");r.width=s.width,r.height=s.height;let o=r.getContext("2d");return o.fillStyle=e.background,o.fillRect(0,0,r.width,r.height),o.drawImage(s,0,0),r}async function oy(n,e){let t=new Image,i=URL.createObjectURL(new Blob([e],{type:"image/svg+xml"}));try{t.src=i,await t.decode(),n.getContext("2d").drawImage(t,0,0,n.width,n.height)}finally{URL.revokeObjectURL(i)}return n}function sy(n,e,t){return new Promise((i,s)=>{n.toBlob(r=>r?i(r):s(new Error("the picture cannot be encoded")),e,t)})}async function tm(n,e){if(!n.scene||n.status!=="ready")throw new Error("there is no picture to export");n.updateMarks();let t=r2(n);if(e==="svg"){let s=iy(n,t).toDataURL("image/png"),r=`<image width="${t.width}" height="${t.height}" href="${s}"/>
${ny(n,t)}`;return new Blob([em(t,r)],{type:"image/svg+xml"})}let i=await oy(iy(n,t),em(t,ny(n,t)));return ay(i,e,n.source?.title??"")}async function ay(n,e,t){if(e==="png")return sy(n,"image/png");let i=await sy(n,"image/jpeg",.94);return ty(new Uint8Array(await i.arrayBuffer()),n.width,n.height,t)}function nm(n){let e=getComputedStyle(n.element),t=i=>e.getPropertyValue(i).trim();return{text:t("--cv-text"),muted:t("--cv-muted"),line:t("--cv-line"),flank:t("--cv-flank"),mark:t("--cv-mark")}}function im(n,{part:e,tooth:t,side:i,envelope:s}){let r=n.positions?.list[n.state.position],o=n.positions?.list.length??0,a=s?`maximum over ${s.included.size<o?`${s.included.size} of `:""}${o} positions`:`position ${r?.position??0}`,l={all:"",flanks:", without edges",edges:", edges only"}[n.state.colours.cells];return`Contact pattern of ${e.name}, ${t===null?"all teeth":`tooth ${t}`}, ${i} flank, ${a}${l}`}var ry={width:960,height:420,title:34};async function sm(n,e){let t=n.pattern.pattern();if(!t)throw new Error("there is no contact pattern to export");let{width:i,height:s,title:r}=ry,o=new kh,a=nm(n);Bh(o,new ta(i,s-r,t),t,n.state.colours,a);let l=getComputedStyle(n.element).getPropertyValue("--cv-bg").trim(),c=[n.source?.title,im(n,t)].filter(Boolean).join(": "),u=em(ry,`<rect width="${i}" height="${s}" fill="${l}"/>
<text x="16" y="22" fill="${a.text}" font-weight="600">${zh(c)}</text>
<g transform="translate(0 ${r})">
${o.elements.join(`
`)}
</g>`);if(e==="svg")return new Blob([u],{type:"image/svg+xml"});let d=document.createElement("canvas");return d.width=Qp*i,d.height=Qp*s,ay(await oy(d,u),e,c)}async function ly(n,e){uy(n,await tm(n,e),e)}async function cy(n,e){uy(n,await sm(n,e),`pattern.${e}`)}function uy(n,e,t){let i=document.createElement("a"),s=(n.source?.title??"view").replace(/[^\p{L}\p{N}._-]+/gu,"_")||"view";i.href=URL.createObjectURL(e),i.download=`${s}.${t}`,i.click(),setTimeout(()=>URL.revokeObjectURL(i.href),1e4)}function hy(n){let[,e]=hd(t=>t+1,0);At(()=>(e(0),n.subscribe(()=>e(0))),[n])}var o2={parts:"M2.5 3.5h4M2.5 8h4M2.5 12.5h4M9 3.5h4.5M9 8h4.5M9 12.5h4.5",settings:"M2 4.5h7M12 4.5h2M2 11.5h2M7 11.5h7M10.5 3v3M5.5 10v3",fit:"M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10",cube:"M8 1.8l5.5 3v6.4L8 14.2l-5.5-3V4.8zM2.5 4.8L8 8l5.5-3.2M8 8v6.2",perspective:"M2 3.5l12 2v5l-12 2zM8 4.5v7",orthographic:"M2.5 3.5h11v9h-11zM8 3.5v9",mesh:"M2.5 2.5h11v11h-11zM2.5 6.2h11M2.5 9.8h11M6.2 2.5v11M9.8 2.5v11",force:"M3 13L12.5 3.5M7.5 3h5.5v5.5",cut:"M1.5 10.5l5-7h8l-5 7zM3 13.5h4M9.5 13.5h4",plot:"M2.5 2.5v11h11M4.5 10.5l3-4 2.5 2 3.5-5",pattern:"M1.8 3.5h12.4v9H1.8zM4 8c0-1.6 1.8-2.4 4-2.4S12 6.4 12 8s-1.8 2.4-4 2.4S4 9.6 4 8",more:"M2.6 8h1.2M7.4 8h1.2M12.2 8h1.2",download:"M8 2v8M4.8 7L8 10.2 11.2 7M2.5 13.5h11",help:"M5.5 6a2.5 2.5 0 1 1 3.6 2.2c-.8.4-1.1.9-1.1 1.8M8 12.6v.4",sun:"M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6M8 1.2v1.6M8 13.2v1.6M1.2 8h1.6M13.2 8h1.6M3.2 3.2l1.1 1.1M11.7 11.7l1.1 1.1M12.8 3.2l-1.1 1.1M4.3 11.7l-1.1 1.1",moon:"M13.2 9.6A5.8 5.8 0 0 1 6.4 2.8a5.6 5.6 0 1 0 6.8 6.8",play:"M5 3l8 5-8 5z",pause:"M5 3v10M11 3v10",next:"M4 3.5l6 4.5-6 4.5zM12.2 3.5v9",previous:"M12 3.5L6 8l6 4.5zM3.8 3.5v9",loop:"M11.5 2l2 2-2 2M13.5 4H5a3 3 0 0 0-3 3M4.5 14l-2-2 2-2M2.5 12H11a3 3 0 0 0 3-3",eye:"M1.5 8S4 3.8 8 3.8 14.5 8 14.5 8 12 12.2 8 12.2 1.5 8 1.5 8M8 6.2a1.8 1.8 0 1 0 0 3.6 1.8 1.8 0 0 0 0-3.6",half:"M8 2.5a5.5 5.5 0 1 0 0 11zM8 2.5a5.5 5.5 0 0 1 0 11M8 5h4.6M8 8h5.5M8 11h4.6",hidden:"M2 2l12 12M6.2 4.1A6 6 0 0 1 8 3.8c4 0 6.5 4.2 6.5 4.2a12 12 0 0 1-1.9 2.3M4 5.2A11 11 0 0 0 1.5 8S4 12.2 8 12.2a6 6 0 0 0 3-.8",pin:"M8 9.5V14M5 9.5h6l-1.3-2V3.3h.8M6.3 7.5L5 9.5M6.3 7.5V3.3h-.8M6.3 3.3h3.4",chevron:"M5.5 3.5L10 8l-4.5 4.5",close:"M3.5 3.5l9 9M12.5 3.5l-9 9"};function pl({name:n}){return x("svg",{class:"cv-icon",viewBox:"0 0 16 16","aria-hidden":"true",children:x("path",{d:o2[n]})})}function Vh(n,e,t,i){let s=n>t-240&&n>t/2,r=e>i-120&&e>i/2;return{[s?"right":"left"]:`${(s?t-n:n)+14}px`,[r?"bottom":"top"]:`${(r?i-e:e)+12}px`,"max-width":`${Math.max(120,(s?n:t-n)-20)}px`}}function An({icon:n,label:e,shortcut:t,pressed:i,disabled:s,onClick:r}){return x("button",{type:"button",class:"cv-tool","aria-label":e,"aria-pressed":i,disabled:s,title:t?`${e} (${t})`:e,onClick:r,children:x(pl,{name:n})})}function jt({label:n,value:e,options:t,onChange:i,quiet:s,title:r}){return x("label",{class:"cv-field",title:r,children:[x("span",{class:s?"cv-hidden":"",children:n}),x("select",{"aria-label":n,value:e,onChange:o=>i(o.currentTarget.value),children:t.map(o=>x("option",{value:o.value,disabled:o.disabled,selected:o.value===e,children:o.label},o.value))})]})}function ms({label:n,value:e,onChange:t}){return x("label",{class:"cv-check",children:[x("input",{type:"checkbox",checked:e,onChange:i=>t(i.currentTarget.checked)}),x("span",{children:n})]})}function ml({label:n,value:e,unit:t,min:i,max:s,disabled:r,onChange:o}){let a=Number.isFinite(e)?String(Number(e.toPrecision(6))):"",[l,c]=Tt(null),u=()=>{if(l===null)return;let d=Number(l.trim().replace(",",".").replace("−","-"));c(null),!(l.trim()===""||!Number.isFinite(d))&&o(Math.min(Math.max(d,i??-1/0),s??1/0))};return x("label",{class:"cv-field",children:[x("span",{children:n}),x("span",{class:"cv-number",children:[x("input",{type:"text",inputMode:"decimal",value:l??a,disabled:r,onInput:d=>c(d.currentTarget.value),onBlur:u,onKeyDown:d=>{d.key==="Enter"&&u(),d.key==="Escape"&&c(null)}}),t?x("span",{class:"cv-unit",children:t}):null]})]})}function rm({label:n,value:e,min:t,max:i,step:s="any",text:r,onInput:o,onEnd:a}){return x("label",{class:"cv-field cv-slider",children:[x("span",{children:n}),x("input",{type:"range",min:t,max:i,step:s,value:e,"aria-valuetext":r,onInput:l=>o(Number(l.currentTarget.value)),onChange:a})]})}function na({title:n,children:e}){return x("section",{class:"cv-section",children:[x("h3",{children:n}),e]})}function dy({core:n}){let e=Gt(null);jm(()=>{e.current.showModal()},[]);let t=()=>{n.help=!1,n.changed(!1)};return x("dialog",{class:"cv-help",ref:e,"aria-labelledby":"cv-help-title",onClose:t,onClick:i=>i.target===e.current&&t(),children:[x("div",{class:"cv-help-head",children:[x("h2",{id:"cv-help-title",children:"Shortcuts"}),x(An,{icon:"close",label:"Close",onClick:t})]}),x("div",{class:"cv-help-grid",children:K_.map(([i,s])=>x("section",{children:[x("h3",{children:i}),x("dl",{children:s.map(({keys:r,label:o})=>x("div",{children:[x("dt",{children:x("kbd",{children:r})}),x("dd",{children:o})]},r))})]},i))})]})}var fy={all:"of cells, edges included",flanks:"flanks only",edges:"edges only"},a2={stress_error:"estimated, as von Mises stress"};function l2(n){let{scale:e,bands:t}=n.state.colours,i=[];if(t>0)for(let s=0;s<t;s++){let r=Hr(fr(e,Vr((s+.5)/t,t)));i.push(`${r} ${100*s/t}% ${100*(s+1)/t}%`)}else for(let s=0;s<=20;s++)i.push(`${Hr(fr(e,s/20))} ${5*s}%`);return`linear-gradient(to top, ${i.join(", ")})`}function c2({share:n,largest:e},t){return`${Ut(100*n,2)} % of the nodes are above, up to ${Ut(e*Oi().factor,3)} ${t}`}function u2(n,e){let{field:t,cells:i}=n.state.colours,s=n.display?.position?.contacts;if(t!=="contact_pressure"||i!=="flanks"||!s)return null;let r=ll(s,"all");return r>ll(s,"flanks")?`edges, not shown: up to ${Ut(r*Oi().factor,4)} ${e}`:null}function h2(n){let e=n.display?.position;return e?n.state.colours.field!=="contact_pressure"?e.meshes.length===0?"No values: the run stored no meshes with stresses (--vtu), or its fidelity level has no finite elements.":"No values: the parts with meshes are hidden.":e.contacts?n.state.colours.cells==="all"?"No values: the gears in contact are hidden.":`No values: no visible loaded cells, ${fy[n.state.colours.cells]}.`:'No values: no contact is loaded in this position, or the fidelity level is "rigid".':"No values: the run has no positions."}function py({core:n}){let{field:e}=n.state.colours;if(e==="plain")return null;let{ticks:t,unit:i}=Fh(n);if(n.missingField||t.length===0)return x("div",{class:"cv-legend cv-legend-empty",role:"note",children:[x("strong",{children:ea(n)}),x("span",{children:h2(n)})]});let s=n.narrow?Math.ceil(t.length/6):1,{limits:r}=n.state.colours,o=n.display?.clipped,a=u2(n,i),l=r==="all"?"all positions":r==="fixed"?"fixed limits":"this position";return x("button",{type:"button",class:"cv-legend","aria-label":`Legend: ${ea(n)} from ${t[0].text} to ${t[t.length-1].text} ${i}. Opens the settings.`,title:Yo[e]??"Settings of the colours",onClick:()=>n.toggle("settings"),children:[x("span",{class:"cv-legend-title",children:[x("strong",{children:ea(n)}),i?x("span",{class:"cv-legend-unit",children:i}):null]}),x("span",{class:"cv-scale",children:[x("span",{class:"cv-bar",style:{background:l2(n)}}),x("span",{class:"cv-ticks",children:t.filter((c,u)=>u%s===0).map((c,u)=>x("span",{style:{bottom:`${100*c.fraction}%`},children:c.text},u))})]}),Yo[e]?x("span",{class:"cv-range",children:a2[e]}):null,a?x("span",{class:"cv-range",children:a}):null,o?x("span",{class:"cv-range",children:c2(o,i)}):null,x("span",{class:"cv-range",children:[e==="contact_pressure"?`${fy[n.state.colours.cells]}; `:"",n.progress!==null?`reading … ${Math.round(100*n.progress)} %`:l]})]})}var d2=[{kind:"gear",label:"Gears"},{kind:"shaft",label:"Shafts"},{kind:"bearing",label:"Bearings"},{kind:"body",label:"Bodies"}],my={mixed:"visible",visible:"translucent",translucent:"hidden",hidden:"visible"},f2={mixed:"half",visible:"eye",translucent:"half",hidden:"hidden"};function gy({core:n}){let e=n.parts?.parts??[];return x("aside",{class:"cv-panel cv-parts","aria-label":"Parts",children:[x("div",{class:"cv-scroll",children:d2.map(({kind:t,label:i})=>{let s=e.filter(r=>r.kind===t);return s.length>0?x(p2,{core:n,label:i,parts:s},t):null})}),x("div",{class:"cv-foot",children:x(jt,{label:"Fixed frame",value:n.state.frame??"",options:[{value:"",label:"Ground"},...e.map(({name:t})=>({value:t,label:t}))],onChange:t=>n.update({frame:t||null})})}),n.source?.provenance?.length?x("details",{class:"cv-provenance",children:[x("summary",{children:"Provenance"}),x("dl",{children:n.source.provenance.map(([t,i])=>x("div",{children:[x("dt",{children:t}),x("dd",{title:i,children:i})]},t))})]}):null]})}function p2({core:n,label:e,parts:t}){let[i,s]=Tt(!0),r=t.map(({name:l})=>l),o=new Set(t.map(l=>ul(n.state,l))),a=o.size===1?[...o][0]:"mixed";return x("div",{class:"cv-group",role:"group","aria-label":e,children:[x("div",{class:"cv-row cv-row-group",children:[x("button",{type:"button",class:"cv-fold","aria-expanded":i,onClick:()=>s(!i),children:[x(pl,{name:"chevron"}),x("span",{children:e}),x("span",{class:"cv-count",children:t.length})]}),x(xy,{name:e,value:a,onChange:l=>n.setVisibility(r,l)})]}),i?t.map(l=>x(m2,{core:n,part:l},l.name)):null]})}function m2({core:n,part:e}){let t=ul(n.state,e);return x("div",{class:`cv-row cv-row-${t}`,children:[x("span",{class:"cv-swatch",style:{background:n.display?.colours[e.index]}}),x("span",{class:"cv-name",title:e.name,children:x(g2,{name:e.name})}),e.copies>1?x("span",{class:"cv-count",title:`${e.copies} teeth`,children:["z ",e.copies]}):null,n.state.frame===e.name?x("span",{class:"cv-pin",title:"Fixed frame",children:x(pl,{name:"pin"})}):null,x(xy,{name:e.name,value:t,onChange:i=>n.setVisibility([e.name],i)})]})}function g2({name:n}){let[e,t]=c_(n);return e?x(lt,{children:[x("span",{class:"cv-name-start",children:e}),x("span",{class:"cv-name-end",children:t})]}):x(lt,{children:t})}function xy({name:n,value:e,onChange:t}){return x("button",{type:"button",class:"cv-eye","aria-label":`${n}: ${e}`,title:`${e}; click for ${my[e]}, Alt and click for hidden`,onClick:i=>t(i.altKey?e==="hidden"?"visible":"hidden":my[e]),children:x(pl,{name:f2[e]})})}function _y({core:n}){let e=n.pattern.pattern();return x("section",{class:"cv-pattern","aria-label":"Contact pattern",children:e?x(lt,{children:[x(x2,{core:n,pattern:e}),x(_2,{core:n,pattern:e})]}):x("div",{class:"cv-muted",children:"No gear has contacts in this position."})})}function x2({core:n,pattern:e}){let{state:t}=n,{part:i}=e,[s,r]=Tt(""),o=t.pattern.tooth,a=n.pattern.teeth(i).map(String);/^\d+$/.test(o)&&!a.includes(o)&&a.push(o);let l=n.pattern.pointed.get(i.index);return x("div",{class:"cv-pattern-head",children:[x(jt,{quiet:!0,label:"Gear",value:i.name,options:n.pattern.gears().map(({name:c})=>({value:c,label:c})),onChange:c=>n.update({pattern:{gear:c}})}),x(jt,{quiet:!0,label:"Tooth",value:o,options:[{value:"all",label:"All teeth"},{value:"pointer",label:l===void 0?"At the pointer":`At the pointer: ${l}`},...a.map(c=>({value:c,label:`Tooth ${c}`}))],onChange:c=>n.update({pattern:{tooth:c}})}),x(jt,{quiet:!0,label:"Flank",value:t.pattern.flank,options:[{value:"automatic",label:`Loaded: ${e.side}`},{value:"left",label:"Left flank"},{value:"right",label:"Right flank"}],onChange:c=>n.update({pattern:{flank:c}})}),x(jt,{quiet:!0,label:"Positions of the pattern",value:t.pattern.envelope?"all":"current",options:[{value:"current",label:"This position"},{value:"all",label:"All positions"}],onChange:c=>n.update({pattern:{envelope:c==="all"}})}),x(jt,{quiet:!0,label:s?`Export the pattern. ${s}`:"Export the pattern",value:"",options:[{value:"",label:"Export"},{value:"png",label:"PNG"},{value:"svg",label:"SVG"},{value:"pdf",label:"PDF"}],onChange:c=>{c&&cy(n,c).catch(u=>r(String(u))),n.changed(!1)}}),x(v2,{core:n,pattern:e})]})}function v2({core:n,pattern:e}){let t=n.positions?.list.length??0,{envelope:i,limits:s,largest:r}=e,o=[];i&&i.included.size<t&&o.push(`read ${i.included.size} of ${t} positions …`),r===0&&!(i&&i.included.size<t)&&o.push("no loaded cells");let a=Oi();return r>s[1]*(1+1e-9)&&o.push(`up to ${Ut(r*a.factor)} ${a.symbol}, above the scale`),o.length>0?x("span",{class:"cv-muted",role:"note",children:o.join("; ")}):null}function vy(n,e,t,i){if(t<e.left||t>e.right||i<e.top||i>e.bottom)return null;let[s,r]=e.inverse(t,i),[o,a]=n.axes.inverse(s,r);if(n.envelope)return{value:n.envelope.at(s,r)||NaN,z:o,r:a,cell:null};let l=V_(n.cells,o,a);return{value:l?.pressure??NaN,z:o,r:a,cell:l}}function _2({core:n,pattern:e}){let t=Gt(null),i=Gt(null),[s,r]=Tt([0,0]),[o,a]=Tt(null),{hovered:l}=n.pattern,c=!(n.drawers&&n.state.colours.field==="contact_pressure"),u=new ta(s[0],s[1],e,c);At(()=>{let f=t.current,p=new ResizeObserver(()=>r([f.clientWidth,f.clientHeight]));return p.observe(f),()=>p.disconnect()},[]);let d=JSON.stringify([n.state.colours,e.limits,e.part.name,e.side,e.tooth,l,s,c,n.theme.theme,e.envelope?.included.size]);At(()=>{let f=i.current;if(s[0]<1||s[1]<1)return;let p=window.devicePixelRatio||1;f.width=Math.round(s[0]*p),f.height=Math.round(s[1]*p);let v=f.getContext("2d");v&&(v.scale(p,p),v.font="11px system-ui, sans-serif",Bh(new Oh(v),u,e,n.state.colours,nm(n),l))},[d,n.display?.position]);let h=o?vy(e,u,...o):null;return x("div",{class:"cv-pattern-picture",ref:t,children:[x("canvas",{ref:i,role:"img","aria-label":im(n,e),onPointerMove:f=>{let p=f.currentTarget.getBoundingClientRect(),v=[f.clientX-p.left,f.clientY-p.top];a(v),n.hover(vy(e,u,...v)?.cell?.cell??-1)},onPointerLeave:()=>{a(null),n.hover(-1)}}),h?x(y2,{pattern:e,reading:h,layout:u,pointer:o}):null]})}function y2({pattern:n,reading:e,layout:t,pointer:i}){let{value:s,z:r,r:o,cell:a}=e,l=Oi(),c=Tn("m",1),[u,d]=jp(n),{axes:h}=n,f=p=>`${Ut(p*c.factor,5)} ${c.symbol}`;return x("div",{class:"cv-tooltip",role:"status","aria-label":"Value in the pattern","data-value":Number.isFinite(s)?String(s):"",style:Vh(...i,t.width,t.height),children:[x("div",{class:"cv-tooltip-value",children:x("strong",{children:Number.isFinite(s)?`${Ut(s*l.factor,6)} ${l.symbol}`:"no contact"})}),a?x("div",{children:["tooth ",a.tooth]}):null,x("div",{class:"cv-muted",children:["z ",f(r),", radius ",f(o)]}),h.direction!==0?x("div",{class:"cv-muted",children:["from the toe ",f(h.along(r,o)-u),", from the root ",f(h.across(r,o)-d)]}):null]})}var b2=new Set(["step","time","cycle","roll_angle","position"]);function om(n){return n.values.reduce((e,t)=>t!==null&&Number.isFinite(t)?Math.max(e,Math.abs(t)):e,0)}function yy({core:n}){let e=n.source?.outputs?.columns??[],t=e.filter(o=>!b2.has(o.name)&&o.values.some(a=>typeof a=="number"&&Number.isFinite(a))),i=t.find(o=>n.state.plotted.includes(o.name))?.name??t[0]?.name??"",s=t.find(o=>o.name===i),r=e.find(o=>o.name==="time");return x("section",{class:"cv-plots","aria-label":"Plots",children:s?x(lt,{children:[x("div",{class:"cv-plots-head",children:[x(jt,{quiet:!0,label:"Output",value:i,options:t.map(o=>({value:o.name,label:o.name.replaceAll("_"," ")})),onChange:o=>n.update({plotted:[o]})}),x(S2,{core:n,column:s,time:r})]}),x(M2,{core:n,column:s,time:r})]}):x("div",{class:"cv-muted",children:"This run has no outputs over the positions."})})}function by(n,e){let t=n.positions?.list[n.state.position];if(!t||!e)return n.state.position;let i=0;return e.values.forEach((s,r)=>{Math.abs((s??1/0)-t.time)<Math.abs((e.values[i]??1/0)-t.time)&&(i=r)}),i}function S2({core:n,column:e,time:t}){let i=e.values[by(n,t)]??NaN,s=Tn(e.unit,om(e));return x("output",{class:"cv-muted",children:Number.isFinite(i)?`${Ut(i*s.factor,5)} ${s.symbol}`:"no value"})}function M2({core:n,column:e,time:t}){let i=Gt(null),s=Gt(null),r=by(n,t),{theme:o}=n.theme;return At(()=>{let a=i.current,l=getComputedStyle(n.element),c=g=>l.getPropertyValue(g).trim(),u=Tn(e.unit,om(e)),d=Tn("s",t?om(t):0),h=t?t.values.map(g=>(g??NaN)*d.factor):e.values.map((g,_)=>_),f=e.values.map(g=>g===null||!Number.isFinite(g)?null:g*u.factor),p=g=>({label:g,labelSize:18,size:44,font:"11px system-ui, sans-serif",labelFont:"11px system-ui, sans-serif",stroke:c("--cv-muted"),grid:{stroke:c("--cv-line"),width:1},ticks:{stroke:c("--cv-line"),width:1,size:4}}),v=new Mn({width:a.clientWidth,height:a.clientHeight,scales:{x:{time:!1}},legend:{show:!1},cursor:{y:!1,points:{size:7},drag:{x:!1,y:!1}},series:[{},{stroke:c("--cv-accent"),width:1.75,points:{show:h.length<60}}],axes:[{...p(t?`time in ${d.symbol}`:"position"),size:30},{...p(u.symbol),size:56}],hooks:{drawAxes:[g=>w2(g,c("--cv-mark"))]}},[h,f],a);s.current=v,v.over.addEventListener("click",()=>{let g=v.cursor.idx,_=n.positions?.list??[];if(g==null||_.length===0)return;let M=t?t.values[g]??0:g,b=0;_.forEach((C,R)=>{let y=E=>Math.abs((t?_[E].time:E)-M);y(R)<y(b)&&(b=R)}),n.animation.stop(),n.goTo(b)});let m=new ResizeObserver(()=>v.setSize({width:a.clientWidth,height:a.clientHeight}));return m.observe(a),()=>{m.disconnect(),v.destroy(),s.current=null}},[n,e,t,o]),At(()=>{Sy.set(s.current,r),s.current?.redraw(!1)},[r,e,t,o]),x("div",{class:"cv-plot",ref:i,role:"img","aria-label":`${e.name.replaceAll("_"," ")} over ${t?"time":"positions"}`})}var Sy=new WeakMap;function w2(n,e){let t=Sy.get(n),i=t===void 0?void 0:n.data[0][t];if(i===void 0)return;let s=Math.round(n.valToPos(i,"x",!0))+.5,{ctx:r,bbox:o}=n;r.save(),r.strokeStyle=e,r.lineWidth=1.5*(window.devicePixelRatio||1),r.beginPath(),r.moveTo(s,o.top),r.lineTo(s,o.top+o.height),r.stroke(),r.restore()}var lm=[{value:"all",label:"All cells"},{value:"flanks",label:"Flanks only"},{value:"edges",label:"Edges only"}];function My({core:n}){return x("aside",{class:"cv-panel cv-settings","aria-label":"Settings",children:x("div",{class:"cv-scroll",children:[n.state.colours.field!=="plain"?x(E2,{core:n}):null,n.hasMeshes?x(T2,{core:n}):null,x(R2,{core:n}),x(C2,{core:n}),x(na,{title:"Display",children:[x(ms,{label:"Mesh edges",value:n.state.mesh_edges,onChange:e=>n.update({mesh_edges:e})}),x(jt,{label:"Theme",value:n.state.theme,options:[{value:"system",label:"As the system"},{value:"light",label:"Light"},{value:"dark",label:"Dark"}],onChange:e=>n.update({theme:e})})]})]})})}function E2({core:n}){let{colours:e}=n.state,t=fl(n),[i,s]=n.display?.limits??[0,1],r=1e-9*Math.max(Math.abs(i),Math.abs(s)),o=[Math.abs(i)<r?0:i,Math.abs(s)<r?0:s],a=(l,c)=>n.update({colours:{limits:"fixed",min:l,max:c}});return x(na,{title:"Colours",children:[x(jt,{label:"Limits",value:e.limits,options:[{value:"position",label:"This position"},{value:"all",label:"All positions"},{value:"fixed",label:"Fixed"}],onChange:l=>l==="fixed"?a(o[0],o[1]):n.update({colours:{limits:l}})}),x(ml,{label:"Maximum",unit:t.symbol,value:o[1]*t.factor,onChange:l=>a(o[0],l/t.factor)}),x(ml,{label:"Minimum",unit:t.symbol,value:o[0]*t.factor,onChange:l=>a(l/t.factor,o[1])}),x(jt,{label:"Scale",value:e.scale,options:Kv.map(({name:l,label:c})=>({value:l,label:c})),onChange:l=>n.update({colours:{scale:l}})}),x(jt,{label:"Bands",value:String(e.bands),options:["0","6","8","10","12","16","24"].map(l=>({value:l,label:l==="0"?"Continuous":l})),onChange:l=>n.update({colours:{bands:Number(l)}})}),Hn(e.field)?null:x(jt,{label:"Contact cells",value:e.cells,options:lm,onChange:l=>n.update({colours:{cells:l}})}),Yo[e.field]?x("p",{class:"cv-note",children:Yo[e.field]}):null,x(ms,{label:"Mark the extreme values",value:n.state.extremes,onChange:l=>n.update({extremes:l})}),Hn(e.field)?null:x(ms,{label:"Show contacts behind surfaces",value:n.state.hidden_contacts,onChange:l=>n.update({hidden_contacts:l})})]})}function T2({core:n}){let{mode:e}=n.state.deformation,t=({index:o})=>(n.display.meshes[o]?.length??0)>0,i=n.parts?.parts??[],[s,r]=[i.filter(t),i.filter(o=>!t(o))];return x(na,{title:"Deformation",children:[x(ms,{label:"Automatic factor",value:e==="automatic",onChange:o=>n.update({deformation:{mode:o?"automatic":"factor",factor:n.display.factor}})}),x(ml,{label:"Factor",unit:"×",value:n.display.factor,onChange:o=>n.update({deformation:{mode:"factor",factor:o}})}),e==="automatic"&&!Hn(n.state.colours.field)?x("p",{class:"cv-note",children:Qu}):null,r.length>0&&n.display.factor>0?x("p",{class:"cv-note",title:r.map(({name:o})=>o).join(", "),children:["Parts with meshes move: ",A2(s),". The other parts stay in place."]}):null]})}var am=5;function A2(n){let e=n.slice(0,am).map(({name:t})=>t).join(", ");return n.length>am?`${e} and ${n.length-am} more`:e}function R2({core:n}){let{cut:e}=n.state,t=n.display.cut,i=()=>{let o=n.scene.camera.direction;return[o.x,o.y,o.z]},s=Tn("m",1),r=typeof e.normal=="string"?e.normal:"view";return x(na,{title:"Cutting plane",children:[x(ms,{label:"Cut",value:e.on,onChange:o=>Qo(n,{on:o})}),e.on?x(lt,{children:[x(jt,{label:"Normal",value:r,options:[{value:"x",label:"x"},{value:"y",label:"y"},{value:"z",label:"z"},{value:"view",label:"View direction"}],onChange:o=>Qo(n,{normal:o==="view"?i():o})}),x(rm,{label:"Location",min:t.range[0],max:t.range[1],value:t.offset,text:`${Ut(t.offset*s.factor,4)} ${s.symbol}`,onInput:o=>{n.display.setDragging(!0,n.state),n.update({cut:{offset:o}})},onEnd:()=>n.display.setDragging(!1,n.state)}),x(ml,{label:"Coordinate",unit:s.symbol,value:t.offset*s.factor,onChange:o=>n.update({cut:{offset:o/s.factor}})}),x(ms,{label:"Flip",value:e.flipped,onChange:o=>n.update({cut:{flipped:o}})})]}):null]})}function C2({core:n}){let{forces:e}=n.state,t=e.bearings||e.meshes;return x(na,{title:"Forces",children:[x(ms,{label:"At bearings",value:e.bearings,onChange:i=>n.update({forces:{bearings:i}})}),x(ms,{label:"At meshes",value:e.meshes,onChange:i=>n.update({forces:{meshes:i}})}),t?x(lt,{children:[x(ms,{label:"Labels",value:e.labels,onChange:i=>n.update({forces:{labels:i}})}),x(rm,{label:"Length",min:.2,max:4,value:e.scale,onInput:i=>n.update({forces:{scale:i}})})]}):null]})}var cm="Positions count from 0, like the column step of steps.csv",P2=[1,2,5,10,20,30,60];function wy({core:n}){let e=n.positions?.list??[],{state:t,animation:i}=n;if(e.length===0)return x("div",{class:"cv-timeline cv-muted",children:"No positions yet"});let s=e[Math.min(t.position,e.length-1)],r=e[e.length-1],o=Tn("s",Math.max(Math.abs(r.time),Math.abs(e[0].time))),a=`${Ut(s.time*o.factor)} ${o.symbol}`,l=e.length>1;return x("div",{class:"cv-timeline",role:"group","aria-label":"Animation",children:[x(An,{icon:"previous",label:"Previous position",shortcut:",",disabled:!l,onClick:()=>i.step(-1)}),x(An,{icon:i.playing?"pause":"play",label:i.playing?"Pause":"Play",shortcut:"K",disabled:!l,onClick:()=>i.toggle()}),x(An,{icon:"next",label:"Next position",shortcut:".",disabled:!l,onClick:()=>i.step(1)}),x("input",{class:"cv-time",type:"range",min:0,max:e.length-1,step:1,value:t.position,disabled:!l,"aria-label":"Position","aria-valuetext":`position ${s.position}, ${a}`,onInput:c=>{i.stop(),n.goTo(Number(c.currentTarget.value))}}),x("output",{class:"cv-clock",children:[x("span",{title:cm,children:[n.narrow?"":"Position ",s.position,l?x("span",{class:"cv-muted",children:[" (",e[0].position," to ",r.position,")"]}):null]}),x("span",{class:"cv-clock-time",children:a})]}),n.narrow?null:x(um,{core:n})]})}function um({core:n}){let{state:e}=n;return x(lt,{children:[x(jt,{quiet:!0,label:"Speed, positions per second",value:String(e.animation.speed),options:[...new Set([...P2,e.animation.speed])].sort((t,i)=>t-i).map(t=>({value:String(t),label:`${t} / s`})),onChange:t=>n.update({animation:{speed:Number(t)}})}),x(An,{icon:"loop",label:"Loop",pressed:e.animation.loop,onClick:()=>n.update({animation:{loop:!e.animation.loop}})})]})}var I2=[{value:"",label:"View"},{value:"isometric",label:"Isometric"},{value:"front",label:"Front"},{value:"back",label:"Back"},{value:"left",label:"Left"},{value:"right",label:"Right"},{value:"top",label:"Top"},{value:"bottom",label:"Bottom"}],L2=Object.keys(Ei);function Ty({core:n,showTitle:e,showTheme:t}){let{scene:i,status:s,narrow:r}=n,o=s==="ready"&&i!==null;return x("div",{class:"cv-toolbar",role:"toolbar","aria-label":"View",children:[x(An,{icon:"parts",label:"Parts",shortcut:"B",pressed:n.isOpen("parts"),onClick:()=>n.toggle("parts")}),e&&!r?x("h1",{class:"cv-title",title:n.source?.title,children:n.source?.title??"Calyx"}):null,o&&!r?x(lt,{children:[x("span",{class:"cv-rule"}),x(Ry,{core:n}),x("span",{class:"cv-rule"}),x(Ey,{core:n}),x(Cy,{core:n}),x("span",{class:"cv-rule"}),x(Py,{core:n})]}):null,o&&r?x("span",{class:"cv-grow",children:x(Ey,{core:n})}):x("span",{class:"cv-space"}),x("span",{class:"cv-tool-group",children:[o&&!r?x(Iy,{core:n}):null,o?x(An,{icon:"settings",label:"Settings",shortcut:"S",pressed:n.isOpen("settings"),onClick:()=>n.toggle("settings")}):null,r?x(An,{icon:"more",label:"More tools",pressed:n.drawer==="tools",onClick:()=>n.setDrawer(n.drawer==="tools"?null:"tools")}):x(Ly,{core:n,showTheme:t})]})]})}function Ay({core:n,showTheme:e}){let t=n.status==="ready"&&n.scene!==null;return x("div",{class:"cv-tools",role:"group","aria-label":"More tools",children:[t?x(lt,{children:[x(Ry,{core:n}),x(Py,{core:n}),x(Cy,{core:n}),x(Iy,{core:n}),x(um,{core:n})]}):null,x(Ly,{core:n,showTheme:e})]})}function Ry({core:n}){let{camera:e}=n.scene,t=n.state.camera?.projection==="orthographic";return x(lt,{children:[x(An,{icon:"fit",label:"Fit",shortcut:"F",onClick:()=>e.fit()}),x(jt,{quiet:!0,label:"Standard view",value:"",options:I2,onChange:i=>{i&&e.view(i),n.changed(!1)}}),x(An,{icon:t?"orthographic":"perspective",label:"Orthographic projection",shortcut:"P",pressed:t,onClick:()=>e.setProjection(t?"perspective":"orthographic")})]})}function Ey({core:n}){let{colours:e}=n.state;return x(jt,{quiet:!0,label:"Colours",value:e.field,options:L2.map(t=>({value:t,label:Ei[t].label})),onChange:t=>n.update({colours:{field:t,limits:e.limits==="fixed"?"position":e.limits}})})}function Cy({core:n}){let{colours:e}=n.state;return x(lt,{children:[e.field==="contact_pressure"?x(jt,{quiet:!0,label:"Contact cells",value:e.cells,options:lm,onChange:t=>n.update({colours:{cells:t}})}):null,n.hasMeshes?x(N2,{core:n}):null]})}function Py({core:n}){let{state:e}=n,t=e.forces.bearings||e.forces.meshes;return x(lt,{children:[x(An,{icon:"mesh",label:"Mesh edges",shortcut:"M",pressed:e.mesh_edges,onClick:()=>n.update({mesh_edges:!e.mesh_edges})}),x(An,{icon:"force",label:"Force vectors",shortcut:"V",pressed:t,onClick:()=>n.update({forces:{bearings:!t,meshes:!t}})}),x(An,{icon:"cut",label:"Cutting plane",shortcut:"C",pressed:e.cut.on,onClick:()=>{let i=!e.cut.on;Qo(n,{on:i}),i&&!n.drawers&&n.toggle("settings",!0)}})]})}function Iy({core:n}){let{panels:e}=n.state;return x(lt,{children:[x(An,{icon:"plot",label:"Plots",shortcut:"G",pressed:e.plots,onClick:()=>n.update({panels:{plots:!e.plots}})}),x(An,{icon:"pattern",label:"Contact pattern",shortcut:"U",pressed:e.pattern,onClick:()=>n.update({panels:{pattern:!e.pattern}})}),x(D2,{core:n})]})}function Ly({core:n,showTheme:e}){let t=n.theme.theme==="dark";return x(lt,{children:[e?x(An,{icon:t?"sun":"moon",label:t?"Light theme":"Dark theme",onClick:()=>n.update({theme:t?"light":"dark"})}):null,x(An,{icon:"help",label:"Help",shortcut:"?",pressed:n.help,onClick:()=>{n.help=!n.help,n.changed(!1)}})]})}function N2({core:n}){let{mode:e,factor:t}=n.state.deformation,i=e==="automatic"&&!Hn(n.state.colours.field),s=e==="automatic"?"automatic":t===0||t===1?String(t):"other";return x(lt,{children:[x(jt,{quiet:!0,label:"Deformation",title:i?Qu:void 0,value:s,options:[{value:"automatic",label:i?"No deformation here":"Deformation: automatic"},{value:"0",label:"Undeformed"},{value:"1",label:"True deformation"},{value:"other",label:"Other factor …"}],onChange:r=>{r==="automatic"?n.update({deformation:{mode:"automatic"}}):r==="other"?(n.update({deformation:{mode:"factor",factor:n.display.factor||10}}),n.toggle("settings",!0)):n.update({deformation:{mode:"factor",factor:Number(r)}})}}),i?null:x("output",{class:"cv-factor","aria-label":"Factor of the deformation",title:"Factor of the displayed deformation",children:["× ",Ut(n.display.factor,3)]})]})}function D2({core:n}){let[e,t]=Tt("");return x("span",{class:"cv-export",children:x(jt,{quiet:!0,label:e?`Export. ${e}`:"Export the picture",value:"",options:[{value:"",label:"Export"},{value:"png",label:"PNG"},{value:"svg",label:"SVG"},{value:"pdf",label:"PDF"}],onChange:i=>{i&&ly(n,i).catch(s=>t(String(s))),n.changed(!1)}})})}function Ny({core:n}){let{probe:e,scene:t}=n;if(!e||!t)return null;let i=fl(n),s=Tn("m",1),{x:r,y:o,z:a}=e.point,l=e.value!==null&&Number.isFinite(e.value);return x("div",{class:"cv-tooltip",role:"status","aria-label":"Value at the pointer","data-value":e.value===null?"":String(e.value),style:Vh(e.x,e.y,t.width,t.height),children:[e.value!==null?x("div",{class:"cv-tooltip-value",children:[x("span",{class:"cv-muted",children:Ei[n.state.colours.field].label}),x("strong",{children:l?`${Ut(e.value*i.factor,6)} ${i.symbol}`:"no value"})]}):null,x("div",{children:[e.part,e.tooth!==null?`, tooth ${e.tooth}`:"",e.node!==null?`, node ${e.node}`:""]}),x("div",{class:"cv-muted",children:[[r,o,a].map(c=>Ut(Math.round(c*s.factor*1e3)/1e3,6)).join("  ")," ",s.symbol]})]})}var Dy=[{name:"x",azimuth:0,elevation:0,v:[1,0,0]},{name:"y",azimuth:90,elevation:0,v:[0,1,0]},{name:"z",azimuth:-90,elevation:90,v:[0,0,1]}];function Fy({core:n}){let e=Gt(null);return At(()=>F2(n,e.current)),x("svg",{class:"cv-triad",viewBox:"-34 -34 68 68",ref:e,"aria-hidden":"true",children:Dy.map(({name:t})=>x("g",{class:`cv-axis-${t}`,children:[x("line",{}),x("text",{"text-anchor":"middle","dominant-baseline":"central",children:t})]},t))})}function F2(n,e){let t=n.state.camera??n.scene?.camera.state;if(!t)return;let i=t.azimuth*Math.PI/180,s=t.elevation*Math.PI/180,r=[-Math.sin(i),Math.cos(i),0],o=[-Math.sin(s)*Math.cos(i),-Math.sin(s)*Math.sin(i),Math.cos(s)];Dy.forEach(({v:a},l)=>{let c=a[0]*r[0]+a[1]*r[1]+a[2]*r[2],u=-(a[0]*o[0]+a[1]*o[1]+a[2]*o[2]),d=e.children[l],[h,f]=[d.children[0],d.children[1]];h.setAttribute("x2",String(20*c)),h.setAttribute("y2",String(20*u)),f.setAttribute("x",String(28*c)),f.setAttribute("y",String(28*u)),d.setAttribute("opacity",Math.hypot(c,u)<.12?"0.15":"1")})}function Uy({core:n,stage:e,showTitle:t,showTheme:i}){hy(n);let{status:s,state:r}=n,o=s==="ready";return x(lt,{children:[x(Ty,{core:n,showTitle:t,showTheme:i}),x("div",{class:"cv-body",children:[o&&n.isOpen("parts")?x(gy,{core:n}):null,x("div",{class:"cv-centre",children:[x("div",{class:"cv-view",children:[x(U2,{stage:e}),o?x(Fy,{core:n}):null,o?x(py,{core:n}):null,o?x(Ny,{core:n}):null,n.notice?x("div",{class:"cv-notice",role:"alert",children:n.notice}):null,s==="loading"?x("div",{class:"cv-message",role:"status",children:"Reading the shapes …"}):null,o&&n.parts?.parts.length===0?x("div",{class:"cv-message",children:"This run has no parts to display."}):null,s==="failed"?x("div",{class:"cv-message",role:"alert",children:[x("strong",{children:"The view cannot be displayed."}),x("span",{children:n.failure})]}):null]}),o&&r.panels.pattern?x(_y,{core:n}):null,o&&r.panels.plots?x(yy,{core:n}):null,o?x(wy,{core:n}):null]}),o&&n.isOpen("settings")?x(My,{core:n}):null,n.narrow&&n.drawer==="tools"?x(Ay,{core:n,showTheme:i}):null]}),n.help?x(dy,{core:n}):null]})}function U2({stage:n}){let e=Gt(null);return At(()=>{e.current.append(n)},[n]),x("div",{class:"cv-holder",ref:e})}var gl=class{onChange=null;#e;#t;#n=new AbortController;#i=new Set;constructor(e,t={}){let i=document.createElement("div");i.className="calyx-viewer";let s=document.createElement("div");s.className="cv-stage",e.append(i),this.#t=i;let r=new Lh(i,s,t.state??{});if(this.#e=r,r.onChange=a=>this.onChange?.(a),da(x(Uy,{core:r,stage:s,showTitle:t.showTitle??!0,showTheme:t.showTheme??!0}),i),r.scene){let{canvas:a,camera:l}=r.scene;a.tabIndex=0,a.setAttribute("role","img"),a.setAttribute("aria-label","Three-dimensional view. Arrow keys orbit, plus and minus zoom, question mark shows all shortcuts."),J_(r,a);let c=l.onChange;l.onChange=u=>{if(c?.(u),u)for(let d of this.#i)d.#e.scene?.camera.set(l.state)}}let o=a=>{j_(r,a)&&a.preventDefault()};i.addEventListener("keydown",o),t.pageKeys&&document.addEventListener("keydown",a=>a.target===document.body&&o(a),{signal:this.#n.signal})}fail(e){this.#e.fail(new Error(e))}show(e){return this.#e.show(e)}reload(){return this.#e.reload()}updatePositions(){return this.#e.updatePositions()}get state(){return structuredClone(this.#e.state)}restore(e){this.#e.update(e)}linkCamera(e){this.#i.add(e),e.#i.add(this);let{camera:t}=this.#e.state;return t&&e.#e.scene?.camera.set(t),()=>{this.#i.delete(e),e.#i.delete(this)}}image(e){return tm(this.#e,e)}patternImage(e){return sm(this.#e,e)}get frames(){return this.#e.scene?.frames??0}get triangles(){return this.#e.display?.triangles??0}draw(){this.#e.scene?.draw()}project(e,t){return this.#e.project(e,t)}nodalValue(e,t){return this.#e.nodalValue(e,t)}contactLoads(){let e=this.#e.display?.position?.contacts,t=this.#e.parts?.parts.map(({name:i})=>i)??[];return e?[...Yv(e)].map(([i,s])=>{let[r,o]=i.split(" ").map(Number);return{parts:[t[r]??"",t[o]??""],load:s}}):[]}dispose(){for(let e of this.#i)e.#i.delete(this);this.#i.clear(),this.#n.abort(),da(null,this.#t),this.#e.dispose(),this.#t.remove()}};var O2=1.4;function Oy(n,{width:e,height:t},i){let s={columns:Math.max(1,Math.floor(e/i.width)),rows:Math.max(1,Math.floor(t/i.height))},r=Math.max(1,Math.min(n,s.columns*s.rows)),o={columns:Math.min(s.columns,r),rows:1},a=0;for(let l=1;l<=Math.min(s.columns,r);l++){let c=Math.ceil(r/l);if(c>s.rows)continue;let u=Math.min(t/c,e/l/O2);u>a&&(a=u,o={columns:l,rows:c})}return o}function ky(n){let[e,t]=Tt({width:0,height:0});return At(()=>{if(!n.current)return;let i=new ResizeObserver(([s])=>{if(!s)return;let{width:r,height:o}=s.contentRect;t(a=>a.width===r&&a.height===o?a:{width:r,height:o})});return i.observe(n.current),()=>i.disconnect()},[]),e}function By({viewers:n,state:e,positions:t}){let[i,s]=Tt(e.colours?.field??"plain"),[r,o]=Tt(e.position??0),a=Math.max(t-1,0),l=Math.min(r,a),c=d=>n().forEach(h=>h.restore(d)),u=d=>{o(d),c({position:d})};return x("div",{class:"scene-bar",role:"group","aria-label":"All scenes",children:[x("select",{"aria-label":"Displayed field",value:i,onChange:d=>{let h=d.currentTarget.value;s(h),c({colours:{field:h}})},children:Object.entries(Ei).map(([d,{label:h}])=>x("option",{value:d,children:h},d))}),x("label",{class:"inline position",children:["Position",x("input",{type:"range",min:0,max:a,value:l,disabled:t<2,onInput:d=>u(Number(d.currentTarget.value))}),x("output",{title:cm,children:[l," (0 to ",a,")"]})]})]})}var zy=9,k2={width:200,height:150},B2=620,z2=480,V2=500;function Vy({studio:n}){let e=Gt(null),t=ky(e),i=n.settings.selected.flatMap(u=>n.runs.filter(d=>d.id===u)),s=i.filter(u=>u.has_view),{modelScene:r}=n,o=r!==null&&(n.scene==="model"||s.length===0),a=Oy(Math.min(s.length,zy),t,k2),c=t.width>0||s.length===1?s.slice(0,Math.min(a.columns*a.rows,zy)):[];return x("div",{class:"scene-area",children:[x("div",{class:"scene-bar",children:[r&&s.length>0&&x("div",{class:"chips",role:"group","aria-label":"Displayed scene",children:[x("button",{type:"button",class:"chip","aria-pressed":o,onClick:()=>n.showScene("model"),children:"Model"}),x("button",{type:"button",class:"chip","aria-pressed":!o,onClick:()=>n.showScene("runs"),children:"Results"})]}),!o&&c.length>1&&x("label",{class:"switch",children:[x("input",{type:"checkbox",checked:n.settings.linked,onChange:u=>n.setLinked(u.currentTarget.checked)}),"Link cameras"]}),!o&&c.length===1&&c[0]?.incomplete&&x(Hy,{run:c[0]}),!o&&x(H2,{runs:i,drawn:c})]}),x("div",{class:"scene-space",ref:e,children:[o&&x($2,{studio:n,scene:r}),!o&&c.length>0&&x(G2,{studio:n,runs:c,columns:a.columns,isCompact:c.length>1&&t.width/a.columns<z2}),!o&&s.length===0&&x(q2,{studio:n,runs:i})]})]})}function Hy({run:n}){return x("span",{class:"incomplete",children:["Incomplete: ",os(n)]})}function H2({runs:n,drawn:e}){if(e.length===0)return null;let t=n.filter(r=>!e.includes(r)),i=(r,o)=>o.length>0?[`${o.map(a=>en(a.id)).join(", ")} (${r})`]:[],s=[...i("no space",t.filter(r=>r.has_view)),...i("no view files",t.filter(r=>!r.has_view))];return s.length===0?null:x("span",{class:"not-drawn",role:"status",children:["Not drawn: ",s.join(", ")]})}function G2({studio:n,runs:e,columns:t,isCompact:i}){let s=Gt(new Map),[r,o]=Tt(0),{linked:a}=n.settings;return At(()=>{if(!a)return;let l=[...s.current.values()],c=l.slice(1).map(u=>l[0]?.linkCamera(u));return()=>c.forEach(u=>u?.())},[r,a,e.map(l=>l.id).join()]),x(lt,{children:[i&&x(By,{viewers:()=>[...s.current.values()],state:n.settings.scene??{},positions:Math.max(...e.map(l=>l.positions??0))}),x("div",{class:`scenes ${i?"compact":""}`,style:{gridTemplateColumns:`repeat(${t}, minmax(0, 1fr))`},children:e.map(l=>x(W2,{studio:n,run:l,hasTitle:e.length>1,onViewer:c=>{c?s.current.set(l.id,c):s.current.delete(l.id),o(u=>u+1)}},l.id))})]})}function W2({studio:n,run:e,hasTitle:t,onViewer:i}){let s=Gt(null),r=Gt(null);At(()=>{if(!s.current)return;let a=Gy(s.current,n,!t);return r.current=a,i(a),a.show(X2(n,e.id)),()=>{r.current=null,i(null),a.dispose()}},[e.id,t]),Wy(r);let o=Gt(!0);return At(()=>{o.current?o.current=!1:e.id==="preview"?r.current?.reload():r.current?.updatePositions()},[e.status,e.positions,e.id==="preview"?n.results[e.id]:null]),x("figure",{class:"scene",children:[t&&x("figcaption",{children:[en(e.id),e.incomplete&&x(Hy,{run:e})]}),x("div",{ref:s,class:"viewer"})]})}function Gy(n,e,t){let i=e.settings.scene??{},s=t&&n.clientWidth>=B2,r=s?i.panels:{parts:!1,settings:!1,plots:!1},o=new gl(n,{state:{...i,theme:Ql(),...r&&{panels:r}},showTheme:!1,showTitle:!1}),a=0;return o.onChange=l=>{window.clearTimeout(a),a=window.setTimeout(()=>e.setScene(s?l:{...l,panels:i.panels}),V2)},o}function Wy(n){let e=nc();At(()=>n.current?.restore({theme:e}),[e])}function X2(n,e){let t=[],i=n.results[e];return{title:en(e),provenance:i?jd(i):[],outputs:null,parts:()=>Ol(pi(e,"/files/view/parts.bin")),positions:async()=>(t=(await as(pi(e,"/view"))).positions.map(({position:r,time:o})=>({position:r,time:o??r})),t),position:s=>{let r=t[s];return r?Ol(pi(e,`/files/view/${dl(r.position)}`)):Promise.reject(new Error(`position ${s} does not exist`))},mesh:s=>Ol(pi(e,`/files/view/${s}`))}}function $2({studio:n,scene:e}){let t=Gt(null),i=Gt(null),s=Gt(e);s.current=e,Wy(i),At(()=>{if(!t.current)return;let o=Gy(t.current,n,!0);return i.current=o,o.show({title:"Model",parts:async()=>s.current.parts,positions:async()=>[{position:0,time:0}],position:async()=>s.current.position}),()=>{i.current=null,o.dispose()}},[]);let r=Gt(e);return At(()=>{r.current!==e&&i.current?.reload(),r.current=e},[e]),x("div",{ref:t,class:"viewer"})}function q2({studio:n,runs:e}){let t=e[0]?.status;return x("div",{class:"no-scene",children:[x("p",{children:Y2(n,t)}),t==="finished"&&x("p",{class:"muted",children:"Runs without positions, and runs of older versions, have none."})]})}function Y2(n,e){return e==="running"||e==="elsewhere"?"This run has not written view files yet.":e==="finished"?"This run has no view files.":e?"This run ended before its first position.":n.model?.broken?"The model has errors.":n.check&&!n.check.runnable?"The params in the form have errors.":"Run the model to see its parts."}function Xy({studio:n}){let[,e]=Tt(0);return At(()=>n.subscribe(()=>e(t=>t+1)),[]),Z2(n),x(lt,{children:[x(K2,{studio:n}),x(Q2,{studio:n}),x("main",{class:"columns",children:n.isLoaded?x(J2,{studio:n}):x("p",{class:"empty",role:"status",children:"Loading …"})})]})}function J2({studio:n}){let{model:e}=n;return x(lt,{children:[x("aside",{class:"left","aria-label":"Params",children:[e?.broken&&x(Fl,{text:e.rendered,isError:!0}),(!e?.broken||e.params.length>0)&&x(hg,{studio:n})]}),x("div",{class:"centre",children:[x(dg,{studio:n}),x(Vy,{studio:n}),x(W0,{studio:n})]}),x("aside",{class:"right","aria-label":"Runs and results",children:[x(Y0,{studio:n}),x(pg,{studio:n}),x(Q0,{studio:n}),x(J0,{studio:n}),x($0,{studio:n})]})]})}function Z2(n){At(()=>{let e=t=>{t.key==="Enter"&&(t.ctrlKey||t.metaKey)&&n.canRun&&n.run()};return window.addEventListener("keydown",e),()=>window.removeEventListener("keydown",e)},[])}function K2({studio:n}){let e=n.model?.model??"",t=Sr(e)||"Calyx studio";return At(()=>{document.title=e?`${t} – Calyx studio`:"Calyx studio"},[t]),x("header",{class:"top",children:[x("h1",{title:e,children:t}),x("p",{class:"about",children:so(n.model?.doc??"").split(`
`)[0]}),x(j2,{})]})}function j2(){let[n,e]=Tt(ec());return x("label",{class:"inline theme",children:["Theme",x("select",{value:n,onChange:t=>{let i=t.currentTarget.value;e(i),tc(i)},children:[x("option",{value:"system",children:"System"}),x("option",{value:"light",children:"Light"}),x("option",{value:"dark",children:"Dark"})]})]})}function Q2({studio:n}){return n.isConnected?n.model?.broken?x(eP,{studio:n}):n.notice?x("div",{class:"notice",role:"alert",children:[x("span",{children:[x(oi,{text:n.notice.message}),n.notice.help&&x("span",{class:"help",children:[" ",x(oi,{text:n.notice.help})]})]}),x("button",{type:"button",class:"quiet",onClick:()=>n.dismiss(),children:"Dismiss"})]}):null:x(tP,{studio:n})}function eP({studio:n}){let e=()=>document.querySelector("pre.rendered.error")?.scrollIntoView({block:"start"});return x("div",{class:"notice error",role:"status","data-testid":"model-broken",children:[x("span",{children:["The model has errors: it cannot run, and the form keeps its values. Correct ",Sr(n.model?.model??"the file")," in the editor."]}),x("button",{type:"button",class:"quiet",onClick:e,children:"Show the errors"})]})}function tP({studio:n}){let e=x("code",{children:n.command});return x("div",{class:"notice error",role:"alert",children:[n.connection==="ended"&&x("span",{children:["The studio has ended; this page keeps the form. To go on, start ",e," and open the address that it prints. This page then reconnects."]}),n.connection==="refused"&&x("span",{children:"A new studio runs at this address. Open the address that it printed, in this browser: this page then reconnects, with its form."}),n.connection==="other"&&x("span",{children:["The studio at this address is another one: of another model, or of another version of Calyx. This page reconnects to"," ",e," of its own version; ",x("a",{href:"/",children:"reload"})," it for the other studio."]})]})}var nP=1e3,Hh=class{constructor(e,t,i){this.about=e;this.listen=t;this.onChange=i;this.#i()}about;listen;onChange;state="connected";#e=null;#t=0;#n=!1;pause(){this.#n=!0,window.clearTimeout(this.#t),this.#e?.close()}resume(){this.#n&&(this.#n=!1,this.#r())}#i(){let e=new EventSource("/api/events");this.#e=e,this.listen(e),e.onopen=()=>this.#s("connected"),e.onerror=()=>{e.close(),this.#r()}}#s(e){this.state=e,this.onChange()}async#r(){window.clearTimeout(this.#t);let e=await this.#o();if(!this.#n){if(e==="connected"){this.#i();return}e!==this.state&&this.#s(e),this.#t=window.setTimeout(()=>{this.#r()},nP)}}async#o(){try{let{subject:e,calyx:t}=await as("/api/studio");return e===this.about.subject&&t===this.about.calyx?"connected":"other"}catch(e){return e instanceof ai&&e.status===401?"refused":"ended"}}};var iP=1,$y=180,sP=700,rP=300,Gh=class{model=null;withoutModel=!1;values={};analysis={};analysisSettings=[];check=null;isChecking=!1;runs=[];progress={};results={};settings={automatic:!0,linked:!0,analysisOpen:!0,selected:[],scene:null};modelScene=null;scene="runs";notice=null;isStarting=!1;#e=new Set;#t=0;#n=0;#i=!1;#s=!1;#r=!1;#o=null;#a=null;#c=new Map;#h=null;#u=!1;#m="";#d=!1;#f=new Set;subscribe(e){return this.#e.add(e),()=>this.#e.delete(e)}#l(){for(let e of this.#e)e()}async load(){await this.#p(async()=>{let e=await as("/api/studio");this.#o=e,this.withoutModel=e.model===null,this.analysisSettings=e.settings,this.withoutModel||await this.#M(),e.opened&&(this.settings.selected=[e.opened]),this.#d=e.opened!==null}),this.#u=!0,this.#l(),window.addEventListener("pagehide",()=>this.#v()),document.addEventListener("visibilitychange",()=>{document.visibilityState==="hidden"?(this.#v(),this.#a?.pause()):this.#a?.resume()}),this.#w()}async#M(){let e=await as("/api/session");this.values={...e.params};let t=new Set(this.analysisSettings.map(s=>s.name));this.analysis=Object.fromEntries(Object.entries(e.settings??{}).filter(([s])=>t.has(s))),this.#r=!0;let i=e.view??{};typeof i.automatic=="boolean"&&(this.settings.automatic=i.automatic),typeof i.linked=="boolean"&&(this.settings.linked=i.linked),typeof i.analysisOpen=="boolean"&&(this.settings.analysisOpen=i.analysisOpen),Array.isArray(i.selected)&&(this.settings.selected=i.selected.filter(s=>typeof s=="string"&&s!=="preview")),this.settings.scene=i.scene??null}#w(){if(!this.#o)return;let e=!0;this.#a=new Hh(this.#o,t=>this.#E(t),()=>{this.isConnected&&!e&&(this.notice=null,this.#m=""),e=this.isConnected,this.#v(),this.#l()})}get isLoaded(){return this.#u}get connection(){return this.#a?.state??"connected"}get isConnected(){return this.connection==="connected"}#E(e){e.addEventListener("model",()=>{this.#b()}),e.addEventListener("runs",()=>{this.#T()}),e.addEventListener("progress",t=>{let{id:i,...s}=JSON.parse(t.data);this.progress[i]=s,this.settings.selected.includes(i)&&this.#A(i),this.#l()})}async#b(){this.withoutModel||await this.#p(async()=>{let e=await as("/api/model");if(e.broken){let{params:s,outputs:r,doc:o}=this.model??e;this.model={...e,params:s,outputs:r,doc:o},this.#h?.abort(),this.check=null,this.isChecking=!1;return}this.model=e,this.#r&&(this.values=this.#S()),this.#r=!1;let t=new Set(e.params.map(s=>s.name)),i=Object.keys(this.values).filter(s=>!t.has(s));for(let s of i)delete this.values[s];if(i.length>0){let s=`the model has no param ${i.map(r=>`\`${r}\``).join(", ")} any more`;this.notice={message:s,help:"its value in the form was dropped"}}this.#g(0)})}async#T(){await this.#p(async()=>{let{runs:e}=await as("/api/runs"),t=new Map(this.runs.map(r=>[r.id,JSON.stringify(r)]));this.runs=e;let i=new Set(e.map(r=>r.id));for(let r of[...this.#f])i.has(r)?this.#f.delete(r):i.add(r);let s=this.settings.selected.filter(r=>!i.has(r)&&t.has(r)&&r!=="preview");s.length>0&&(this.notice={message:`${s.map(en).join(", ")}: the directory was deleted`,help:""}),this.settings.selected=this.settings.selected.filter(r=>i.has(r));for(let r of Object.keys(this.results))i.has(r)||delete this.results[r];for(let r of e){r.progress&&(this.progress[r.id]=r.progress);let o=t.get(r.id)!==JSON.stringify(r)||r.id==="preview";this.settings.selected.includes(r.id)&&(o||!this.results[r.id])&&this.#_(r.id)}if(this.settings.selected.length===0){let r=e.findLast(o=>o.status==="finished");r&&this.select([r.id])}})}#A(e){if(this.#c.has(e))return;let t=window.setTimeout(()=>{this.#c.delete(e),this.#_(e)},sP);this.#c.set(e,t)}async#_(e){try{this.results[e]=await as(pi(e))}catch(t){t instanceof ai&&t.status===404||this.#y(t),delete this.results[e]}this.#l()}param(e){return this.model?.params.find(t=>t.name===e)}value(e){return this.values[e.name]??e.default??""}setValue(e,t){let i=this.param(e);i?.independent&&i.default===t?delete this.values[e]:this.values[e]=t,this.#g($y),this.#l()}reset(e){delete this.values[e],this.#g(0),this.#l()}get form(){return{params:{...this.values},settings:{...this.analysis}}}isChanged(e){let t=this.values[e],i=this.param(e);return t===void 0?!1:!i?.independent||i.default===null||!Js(i.default,t)}get changes(){return Object.keys(this.values).filter(e=>this.isChanged(e)).length+Object.keys(this.analysis).length}setAnalysis(e,t){t===""?delete this.analysis[e]:this.analysis[e]=t,this.#g($y),this.#l()}resetAll(){this.analysis={},this.setValues({})}setValues(e){this.values={};for(let[t,i]of Object.entries(e)){let s=this.param(t);(!s?.independent||s.default===null||!Js(s.default,i))&&(this.values[t]=i)}this.#g(0),this.#l()}#g(e){this.modelScene&&(this.scene="model"),window.clearTimeout(this.#t),this.isChecking=!0,this.#t=window.setTimeout(()=>{this.#R()},e),this.#x()}async#R(){if(!this.model||this.model.broken){this.isChecking=!1;return}this.#h?.abort();let e=new AbortController;this.#h=e;let{form:t}=this;await this.#p(async()=>{let i=await Ss("POST","/api/check",t,e.signal);e.signal.aborted||(this.check=i,this.isChecking=!1,i.version!==this.model?.version&&await this.#b(),await Promise.all([this.#P(t),this.#C(t,e.signal)]))}),this.#h===e&&(this.isChecking=!1),this.#l()}get canRun(){return this.isConnected&&!this.isStarting&&!!this.check?.runnable}get command(){let e=this.#o?.model||(this.runs.find(i=>i.id==="opened")?.directory??"");return`calyx studio ${/^[\w./@%+,:=-]*$/.test(e)?e:`'${e.replaceAll("'","'\\''")}'`}`.trim()+(location.port&&` --port ${location.port}`)}get isQuick(){return this.check?.plan!=null&&this.check.plan.time<iP}async#C(e,t){let{errors:i,setting_errors:s}=this.check??{};if(!(Object.keys({...i,...s}).length>0))try{this.modelScene=await ag(e,t)}catch(r){if(!(r instanceof ai))throw r;this.modelScene=null}}showScene(e){this.scene=e,this.#l()}async#P(e){let t=JSON.stringify([this.check?.version,e]);if(!this.settings.automatic||!this.check?.runnable||!this.isQuick||this.#m===t)return;if(this.#m=t,this.#d){this.#d=!1;return}await Ss("POST","/api/preview",e),this.#f.add("preview"),this.settings.selected.length<=1&&this.select(["preview"])}setAutomatic(e){this.settings.automatic=e,this.#x(),this.#l(),e&&this.#g(0)}setAnalysisOpen(e){e!==this.settings.analysisOpen&&(this.settings.analysisOpen=e,this.#x())}setLinked(e){this.settings.linked=e,this.#x(),this.#l()}setScene(e){this.settings.scene=e,this.#x()}async run(){this.isStarting=!0,this.#l(),await this.#p(async()=>{let{id:e}=await Ss("POST","/api/runs",this.form);this.#f.add(e),this.select([e])}),this.isStarting=!1,this.#l()}async cancel(e){await this.#p(()=>Ss("POST",pi(e,"/cancel"),{}))}async continue(e){await this.#p(async()=>{await Ss("POST",pi(e,"/continue"),{}),delete this.progress[e]})}select(e){this.settings.selected=e,this.scene="runs";for(let t of e)this.results[t]||this.#_(t);this.#x(),this.#l()}toggle(e){let{selected:t}=this.settings;this.select(t.includes(e)?t.filter(i=>i!==e):[...t,e])}useForm(e){let t={};for(let[i,s]of Object.entries(e.params??{}))this.param(i)&&s.at_default!==!0&&(t[i]=s.entered??s.text);this.analysis={...e.settings},this.setValues(t)}dismiss(){this.notice=null,this.#l()}fail(e){this.#y(e),this.#l()}#y(e){if(e instanceof DOMException&&e.name==="AbortError")return;let t=e instanceof ai?e.help:"";this.notice={message:e instanceof Error?e.message:String(e),help:t}}async#p(e){try{await e()}catch(t){this.#y(t)}this.#l()}#x(){!this.#u||this.withoutModel||this.#s||(this.#i=!0,window.clearTimeout(this.#n),this.#n=window.setTimeout(()=>this.#v(),rP))}#v(){if(window.clearTimeout(this.#n),!this.#i||!this.isConnected)return;this.#i=!1;let e={version:1,params:this.#S(),settings:this.analysis,view:{...this.settings}};this.#p(async()=>{try{await lg(e)}catch(t){throw t instanceof ai&&t.status===409?this.#s=!0:this.#i=!0,t}})}#S(){let e=([t,i])=>i.trim()!==""||this.param(t)?.kind==="text";return Object.fromEntries(Object.entries(this.values).filter(e))}};var qy=document.getElementById("studio");if(qy){tc(ec());let n=new Gh;da(x(Xy,{studio:n}),qy),n.load()}})();
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
