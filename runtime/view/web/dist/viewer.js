"use strict";(()=>{var It,Jp,Vv,Us,Th,pl,Kp,ul,jp,Ch,Ah,Hv,Qo=Symbol.for("pv"),ml={},gl=[],Gv=/^m(i|n|o|s|text|space)$/,Rh=Array.isArray,Qp=gl.slice,ur=Object.assign;function cr(n){n&&n.parentNode&&n.remove()}function hl(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Qo,__v:s||++Jp,__i:-1,__u:0};return!s&&It.vnode&&It.vnode(r),r}function Lt(n){return n.children}function fl(n,e){this.props=n,this.context=e,this.__g=0}function Os(n,e){if(e==null)return n.__&&Os(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:Os(n)}function Wv(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=ur({constructor:Qo},t)).__v=t.__v+1,It.vnode&&It.vnode(e),Ph(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||Os(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,rm(s,e,r),t.__=t.__e=null,e.__e!=i&&em(e))}function em(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),em(n)}function Yp(n){(8&n.__g||(n.__g|=8,Us.push(n),pl++))&&Th==It.debounceRendering||((Th=It.debounceRendering)||queueMicrotask)(tm)}function tm(){try{for(var n,e=1;Us.length;)Us.length>e&&Us.sort(Kp),n=Us.shift(),e=Us.length,8&n.__g&&Wv(n)}finally{(pl=Us.length)&&(Th||queueMicrotask)(tm)}}function nm(n,e,t,i,s,r,o,a,l,c,u){var f,h,d,p,_,g,m=i.__k||gl,x=e.length;for(l=Xv(t,e,m,l,x),f=0;f<x;f++)(d=t.__k[f])!=null&&(h=~d.__i&&m[d.__i]||ml,d.__i=f,g=Ph(n,d,h,s,r,o,a,l,c,u),p=d.__e,(h.ref!=d.ref||8&h.__u)&&(h.ref&&Ih(h.ref,null,d,h),d.ref&&u.push(d.ref,d.__c||p,d)),_=_||p,4&d.__u?(l=im(d,l,n,!h.__v),h.__e&&(h.__e=null)):typeof d.type=="function"&&g!==void 0?l=g:p&&(l=p.nextSibling),d.__u&=-21);return t.__e=_,l}function Xv(n,e,t,i,s){var r,o,a,l,c,u,f,h,d,p=t.length,_=p,g=0,m=0,x=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=x[r]=hl(null,o):Rh(o)?o=x[r]=hl(Lt,{children:o}):o.constructor===Qo&&o.__b?o=x[r]=hl(o.type,o.props,o.key,o.ref,o.__v):x[r]=o,l=r+g,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=qv(o,t,l,_))&&(_--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?g--:c==l+1?g++:c!=l&&(c>l?g--:g++,m=1)):(~c||(s>p?g--:s<p&&g++),typeof o.type!="function"&&(o.__u|=4))):x[r]=null;if(m){for(u=[],f=[],r=0;r<s;r++)if((o=x[r])&&16&o.__u){for(g=0,h=u.length;g<h;)u[d=g+h>>1]<o.__i?g=d+1:h=d;u[g]=o.__i,f[r]=g+1}for(g=u.length;r--;)f[r]&&(f[r]==g?g--:x[r].__u|=4)}if(_)for(r=0;r<p;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=Os(a)),Lh(a,a));return i}function im(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=im(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=Os(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function qv(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function Zp(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function cl(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Zp(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Zp(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=Ah[e]||(Ah[e]=$v(e)),(n.__a||(n.__a={}))[e]=Ch,r=e!=(e=e.replace(jp,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function $v(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[ul]==null)e[ul]=Ch++;else if(e[ul]<this.__a[n])return;return t(It.event?It.event(e):e)}}}function Ph(n,e,t,i,s,r,o,a,l,c){var u,f,h,d,p,_,g,m,x,M,b,C,A,v,E,U,L,I,k=e.type;if(e.constructor!==Qo)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,f=r=[],u.nodeType==8?a=dl(u,r):r.push(u),a=r[0]||a),(u=It.__b)&&u(e);e:if(typeof k=="function"){h=o.length;try{if(m=e.props,x=(u=k.prototype)&&u.render,M=(u=k.contextType)&&i[u.__c],b=u?M?M.props.value:u.__:i,(d=t.__c)?(e.__c=d,2&d.__g&&(d.__g|=1)):(x?e.__c=d=new k(m,b):(e.__c=d=new fl(m,b),d.constructor=k,d.render=Zv),M&&M.sub(d),d.state||(d.state={}),d.__n=i,d.__g|=8,d.__h=[],d.__k=[]),x&&(d.__s||(d.__s=d.state),k.getDerivedStateFromProps&&(d.__s==d.state&&(d.__s=ur({},d.__s)),ur(d.__s,k.getDerivedStateFromProps(m,d.__s)))),p=d.props,_=d.state,d.__v=e,t.__c){if(m!==p&&x&&!k.getDerivedStateFromProps&&d.componentWillReceiveProps&&d.componentWillReceiveProps(m,b),e.__v==t.__v&&!(8&d.__g)||!(4&d.__g)&&d.shouldComponentUpdate&&d.shouldComponentUpdate(m,d.__s,b)===!1){e.__v!=t.__v&&(d.props=m,d.state=d.__s,d.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(z){z&&(z.__=e)}),gl.push.apply(d.__h,d.__k),d.__k=[],d.__h.length&&o.push(d),a=Os(t);break e}d.componentWillUpdate&&d.componentWillUpdate(m,d.__s,b),x&&d.componentDidUpdate&&d.__h.push(function(){d.componentDidUpdate(p,_,g)})}else x&&!k.getDerivedStateFromProps&&d.componentWillMount&&d.componentWillMount(),x&&d.componentDidMount&&d.__h.push(d.componentDidMount);d.context=b,d.props=m,d.__P=n,d.__g&=-5,C=It.__r,A=x?25:0;do d.__g&=-9,C&&C(e),u=d.render(d.props,d.state=d.__s,d.context);while(8&d.__g&&++A<25);x&&(gl.push.apply(d.__h,d.__k),d.__k=[]),d.state=d.__s,d.getChildContext&&(i=ur({},i,d.getChildContext())),x&&t.__c&&d.getSnapshotBeforeUpdate&&(g=d.getSnapshotBeforeUpdate(p,_)),v=u&&u.type===Lt&&u.key==null?u.props.children:u,m.__P&&(u=a,s=(n=m.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(z){z&&Lh(z,z)}),t.__k=null),a=t.__k?Os(t,0):null),a=nm(n,Rh(v)?v:[v],e,t,i,s,r,o,a,l,c),m.__P&&(e.__e=null,a=u),e.__u&=-161,f&&f.some(cr),d.__h.length&&o.push(d),1&d.__g&&(d.__g&=-4)}catch(z){if(o.length=h,e.__v=null,l||r)if(z&&z.then){if(e.__u|=128|l,r){for(~(L=r.indexOf(a||void 0))||(L=r.length);(I=r[L-1])&&I.nodeType==8;)L--;for(;L<r.length;L++)if(I=r[L])if(r[L]=null,E){if(I==U)break}else{if(I.nodeType!=8)break;I.data.startsWith("$s")&&(U=dl(E=I))}}if(!E){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;E=a}(u=dl(E=e.__c.__z||(e.__c.__z=E)))?(e.__e=E,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(cr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),z&&z.then||sm(e),It.__e(z,e,t)}}else a=e.__e=Yv(t.__e,e,t,i,s,r,o,l,c,n);return(u=It.diffed)&&u(e),a}function dl(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function sm(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(sm))}function rm(n,e,t){for(var i=0;i<t.length;)Ih(t[i++],t[i++],t[i++]);It.__c&&It.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){It.__e(r,s.__v)}})}function Yv(n,e,t,i,s,r,o,a,l,c){var u,f,h,d,p,_,g,m,x=t.props||ml,M=e.props,b=e.type;if(b=="svg"?s="http://www.w3.org/2000/svg":b=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((p=r[u])&&(b?p.localName==b:p.nodeType==3)){n=p,r[u]=null;break}}if(!n){if(m=c.ownerDocument||document,!b)return m.createTextNode(M);n=m.createElementNS(s,b,M.is?M:c),a&&(It.__m&&It.__m(e,r),a=!1),r=null}if(b){if(c=b=="template"&&n.content||n,r=b=="textarea"&&M.defaultValue!=null?null:r&&Qp.call(c.childNodes),!a&&r)for(x={},u=0;u<n.attributes.length;u++)x[(p=n.attributes[u]).name]=p.value;for(u in x)p=x[u],u=="dangerouslySetInnerHTML"?h=p:u=="children"||u in M||u=="value"&&"defaultValue"in M||u=="checked"&&"defaultChecked"in M||cl(n,u,null,p,s);for(u in M)p=M[u],u=="children"?d=p:u=="dangerouslySetInnerHTML"?f=p:u=="value"?_=p:u=="checked"?g=p:a&&typeof p!="function"||x[u]===p||cl(n,u,p,x[u],s);f?(a||h&&(f.__html==h.__html||f.__html==n.innerHTML)||(n.innerHTML=f.__html),e.__k=[]):(h&&(n.textContent=""),(b=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Gv.test(b))&&(s="http://www.w3.org/1999/xhtml"),nm(c,Rh(d)?d:[d],e,t,i,s,r,o,r?r[0]:t.__k&&Os(t,0),a,l),r&&r.some(cr)),a&&b!="textarea"||(u="value",b=="progress"&&_==null?n.removeAttribute(u):_==null||_===n[u]&&(b!="progress"||_)||cl(n,u,_,x[u],s),u="checked",g!=null&&g!=n[u]&&cl(n,u,g,x[u],s))}else x===M||a&&n.data==M||(n.data=M);return n}function Ih(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){It.__e(s,t)}}function Lh(n,e,t){var i,s,r,o;if(It.unmount&&It.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||Ih(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){It.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&Lh(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=dl(i,r=[]))&&(i==n.__e&&r.some(cr),cr(s),cr(i)),t||cr(n.__e),n.__e=n.__c=n.__=null}function Zv(n,e,t){return this.constructor(n,t)}function Dh(n,e){var t,i,s,r;It.__&&It.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=hl(Lt,{children:[n]}),s=[],r=[],Ph(e,e.__k,i||ml,ml,e.namespaceURI,i?null:e.firstChild?Qp.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),rm(s,e.__k,r),e.__k.props.children=null}It={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw pl=0,n}},Jp=0,Vv=function(n){return n!=null&&n.constructor===Qo},fl.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=ur({},this.state)),typeof n=="function"&&(n=n(ur({},t),this.props)),n&&(ur(t,n),this.__v&&(e&&this.__k.push(e),Yp(this)))},fl.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),Yp(this))},fl.prototype.render=Lt,Us=[],pl=0,Kp=function(n,e){return n.__v.__b-e.__v.__b},ul=Symbol(),jp=/(PointerCapture)$|Capture$/i,Ch=0,Ah={},Hv=0;var Im=0,cf=1,Lm=2;var Sa=1,Dm=2,_o=3,Si=0,Bn=1,Nn=2,vr=0,xo=1,uf=2,hf=3,ff=4,Nm=5;var yr=100,Fm=101,Um=102,Om=103,Bm=104,km=200,zm=201,Vm=202,Hm=203,df=204,pf=205,Gm=206,Wm=207,Xm=208,qm=209,$m=210,Ym=211,Zm=212,Jm=213,Km=214,Vl=0,Hl=1,Gl=2,oo=3,Wl=4,Xl=5,ao=6,ql=7,mf=0,jm=1,Qm=2,ts=0,gf=1,_f=2,xf=3,vf=4,yf=5,bf=6,Mf=7;var Sf=300,br=301,vo=302,_c=303,xc=304,$l=1e3,Qi=1001,Yl=1002,_n=1003,eg=1004;var wa=1005;var On=1006,vc=1007;var bs=1008;var hi=1009,wf=1010,Ef=1011,yo=1012,yc=1013,Bi=1014,ki=1015,zi=1016,bc=1017,Mc=1018,Mr=1020,Tf=35902,Af=35899,Cf=1021,Rf=1022,fi=1023,xs=1026,Ms=1027,Pf=1028,Sc=1029,js=1030,wc=1031;var Ec=1033,Ea=33776,Ta=33777,Aa=33778,Ca=33779,Tc=35840,Ac=35841,Cc=35842,Rc=35843,Pc=36196,Ic=37492,Lc=37496,Dc=37488,Nc=37489,Ra=37490,Fc=37491,Uc=37808,Oc=37809,Bc=37810,kc=37811,zc=37812,Vc=37813,Hc=37814,Gc=37815,Wc=37816,Xc=37817,qc=37818,$c=37819,Yc=37820,Zc=37821,Jc=36492,Kc=36494,jc=36495,Qc=36283,eu=36284,Pa=36285,tu=36286;var oa=2300,Zl=2301,kl=2302,nf=2303,sf=2400,rf=2401,of=2402;var tg=3200;var If=0,ng=1,Ss="",Jn="srgb",aa="srgb-linear",la="linear",Tt="srgb";var zl=7680,Ia=7681;var Lf=34055,Df=34056;var Nf=517;var nu=519,ig=512,sg=513,rg=514,Ff=515,og=516,ag=517,Uf=518,Of=519,lg=35044,Qs=35048;var Bf="300 es",vi=2e3,ca=2001;function Jv(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function Kv(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ua(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function cg(){let n=ua("canvas");return n.style.display="block",n}var om={},lo=null;function kf(...n){let e="THREE."+n.shift();lo?lo("log",e,...n):console.log(e,...n)}function ug(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ye(...n){n=ug(n);let e="THREE."+n.shift();if(lo)lo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function Qe(...n){n=ug(n);let e="THREE."+n.shift();if(lo)lo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function ra(...n){let e=n.join(" ");e in om||(om[e]=!0,Ye(...n))}function hg(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var fg={[Vl]:Vl,[Gl]:ao,[Wl]:Wl,[oo]:Xl,[Hl]:Hl,[ao]:Gl,[ql]:ql,[Xl]:oo},es=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Hn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Nh=Math.PI/180,Jl=180/Math.PI;function La(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Hn[n&255]+Hn[n>>8&255]+Hn[n>>16&255]+Hn[n>>24&255]+"-"+Hn[e&255]+Hn[e>>8&255]+"-"+Hn[e>>16&15|64]+Hn[e>>24&255]+"-"+Hn[t&63|128]+Hn[t>>8&255]+"-"+Hn[t>>16&255]+Hn[t>>24&255]+Hn[i&255]+Hn[i>>8&255]+Hn[i>>16&255]+Hn[i>>24&255]).toLowerCase()}function _t(n,e,t){return Math.max(e,Math.min(t,n))}function jv(n,e){return(n%e+e)%e}function Fh(n,e,t){return(1-t)*n+t*e}function dg(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function zf(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Qv(n,e){if(e.constructor===Float32Array)return n;let t=zf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function ey(n,e){if(e.constructor===Float32Array)return n;let t=zf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var xt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(_t(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(_t(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},yi=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],h=r[o+0],d=r[o+1],p=r[o+2],_=r[o+3];if(f!==_||l!==h||c!==d||u!==p){let g=l*h+c*d+u*p+f*_;g<0&&(h=-h,d=-d,p=-p,_=-_,g=-g);let m=1-a;if(g<.9995){let x=Math.acos(g),M=Math.sin(x);m=Math.sin(m*x)/M,a=Math.sin(a*x)/M,l=l*m+h*a,c=c*m+d*a,u=u*m+p*a,f=f*m+_*a}else{l=l*m+h*a,c=c*m+d*a,u=u*m+p*a,f=f*m+_*a;let x=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=x,c*=x,u*=x,f*=x}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],h=r[o+1],d=r[o+2],p=r[o+3];return e[t]=a*p+u*f+l*d-c*h,e[t+1]=l*p+u*h+c*f-a*d,e[t+2]=c*p+u*d+a*h-l*f,e[t+3]=u*p-a*f-l*h-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),h=l(i/2),d=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"YXZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"ZXY":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"ZYX":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"YZX":this._x=h*u*f+c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f-h*d*p;break;case"XZY":this._x=h*u*f-c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f+h*d*p;break;default:Ye("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],f=t[10],h=i+a+f;if(h>0){let d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>f){let d=2*Math.sqrt(1+i-a-f);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>f){let d=2*Math.sqrt(1+a-i-f);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+f-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(_t(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(am.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(am.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),f=2*(r*i-o*t);return this.x=t+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(_t(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Uh.copy(this).projectOnVector(e),this.sub(Uh)}reflect(e){return this.sub(Uh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(_t(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Uh=new G,am=new yi,et=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],h=i[2],d=i[5],p=i[8],_=s[0],g=s[3],m=s[6],x=s[1],M=s[4],b=s[7],C=s[2],A=s[5],v=s[8];return r[0]=o*_+a*x+l*C,r[3]=o*g+a*M+l*A,r[6]=o*m+a*b+l*v,r[1]=c*_+u*x+f*C,r[4]=c*g+u*M+f*A,r[7]=c*m+u*b+f*v,r[2]=h*_+d*x+p*C,r[5]=h*g+d*M+p*A,r[8]=h*m+d*b+p*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=u*o-a*c,h=a*l-u*r,d=c*r-o*l,p=t*f+i*h+s*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/p;return e[0]=f*_,e[1]=(s*c-u*i)*_,e[2]=(a*i-s*o)*_,e[3]=h*_,e[4]=(u*t-s*l)*_,e[5]=(s*r-a*t)*_,e[6]=d*_,e[7]=(i*l-c*t)*_,e[8]=(o*t-i*r)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return ra("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Oh.makeScale(e,t)),this}rotate(e){return ra("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Oh.makeRotation(-e)),this}translate(e,t){return ra("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Oh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Oh=new et,lm=new et().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),cm=new et().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function ty(){let n={enabled:!0,workingColorSpace:aa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Tt&&(s.r=_s(s.r),s.g=_s(s.g),s.b=_s(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Tt&&(s.r=ro(s.r),s.g=ro(s.g),s.b=ro(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ss?la:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[aa]:{primaries:e,whitePoint:i,transfer:la,toXYZ:lm,fromXYZ:cm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Jn},outputColorSpaceConfig:{drawingBufferColorSpace:Jn}},[Jn]:{primaries:e,whitePoint:i,transfer:Tt,toXYZ:lm,fromXYZ:cm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Jn}}}),n}var pt=ty();function _s(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ro(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var qr,Kl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{qr===void 0&&(qr=ua("canvas")),qr.width=e.width,qr.height=e.height;let s=qr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=qr}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=ua("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=_s(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(_s(t[i]/255)*255):t[i]=_s(t[i]);return{data:t,width:e.width,height:e.height}}else return Ye("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},ny=0,co=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:ny++}),this.uuid=La(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Bh(s[o].image)):r.push(Bh(s[o]))}else r=Bh(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Bh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Kl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ye("Texture: Unable to serialize Texture."),{})}var iy=0,kh=new G,ei=class n extends es{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=Qi,s=Qi,r=On,o=bs,a=fi,l=hi,c=n.DEFAULT_ANISOTROPY,u=Ss){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:iy++}),this.uuid=La(),this.name="",this.source=new co(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new xt(0,0),this.repeat=new xt(1,1),this.center=new xt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new et,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(kh).x}get height(){return this.source.getSize(kh).y}get depth(){return this.source.getSize(kh).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ye(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Sf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case $l:e.x=e.x-Math.floor(e.x);break;case Qi:e.x=e.x<0?0:1;break;case Yl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case $l:e.y=e.y-Math.floor(e.y);break;case Qi:e.y=e.y<0?0:1;break;case Yl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ei.DEFAULT_IMAGE=null;ei.DEFAULT_MAPPING=Sf;ei.DEFAULT_ANISOTROPY=1;var Xt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],f=l[8],h=l[1],d=l[5],p=l[9],_=l[2],g=l[6],m=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-_)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+_)<.1&&Math.abs(p+g)<.1&&Math.abs(c+d+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,b=(d+1)/2,C=(m+1)/2,A=(u+h)/4,v=(f+_)/4,E=(p+g)/4;return M>b&&M>C?M<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(M),s=A/i,r=v/i):b>C?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=A/s,r=E/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=v/r,s=E/r),this.set(i,s,r,t),this}let x=Math.sqrt((g-p)*(g-p)+(f-_)*(f-_)+(h-u)*(h-u));return Math.abs(x)<.001&&(x=1),this.x=(g-p)/x,this.y=(f-_)/x,this.z=(h-u)/x,this.w=Math.acos((c+d+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this.w=_t(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this.w=_t(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(_t(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},jl=class extends es{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:On,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Xt(0,0,e,t),this.scissorTest=!1,this.viewport=new Xt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ei({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:On,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new co(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},li=class extends jl{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},ha=class extends ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=_n,this.minFilter=_n,this.wrapR=Qi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Ql=class extends ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=_n,this.minFilter=_n,this.wrapR=Qi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var yt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,f,h,d,p,_,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,_,g)}set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,_,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=f,m[14]=h,m[3]=d,m[7]=p,m[11]=_,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/$r.setFromMatrixColumn(e,0).length(),r=1/$r.setFromMatrixColumn(e,1).length(),o=1/$r.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let h=o*u,d=o*f,p=a*u,_=a*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=d+p*c,t[5]=h-_*c,t[9]=-a*l,t[2]=_-h*c,t[6]=p+d*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,d=l*f,p=c*u,_=c*f;t[0]=h+_*a,t[4]=p*a-d,t[8]=o*c,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=d*a-p,t[6]=_+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,d=l*f,p=c*u,_=c*f;t[0]=h-_*a,t[4]=-o*f,t[8]=p+d*a,t[1]=d+p*a,t[5]=o*u,t[9]=_-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,d=o*f,p=a*u,_=a*f;t[0]=l*u,t[4]=p*c-d,t[8]=h*c+_,t[1]=l*f,t[5]=_*c+h,t[9]=d*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,d=o*c,p=a*l,_=a*c;t[0]=l*u,t[4]=_-h*f,t[8]=p*f+d,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*f+p,t[10]=h-_*f}else if(e.order==="XZY"){let h=o*l,d=o*c,p=a*l,_=a*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=h*f+_,t[5]=o*u,t[9]=d*f-p,t[2]=p*f-d,t[6]=a*u,t[10]=_*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(sy,e,ry)}lookAt(e,t,i){let s=this.elements;return oi.subVectors(e,t),oi.lengthSq()===0&&(oi.z=1),oi.normalize(),Bs.crossVectors(i,oi),Bs.lengthSq()===0&&(Math.abs(i.z)===1?oi.x+=1e-4:oi.z+=1e-4,oi.normalize(),Bs.crossVectors(i,oi)),Bs.normalize(),_l.crossVectors(oi,Bs),s[0]=Bs.x,s[4]=_l.x,s[8]=oi.x,s[1]=Bs.y,s[5]=_l.y,s[9]=oi.y,s[2]=Bs.z,s[6]=_l.z,s[10]=oi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],h=i[9],d=i[13],p=i[2],_=i[6],g=i[10],m=i[14],x=i[3],M=i[7],b=i[11],C=i[15],A=s[0],v=s[4],E=s[8],U=s[12],L=s[1],I=s[5],k=s[9],z=s[13],N=s[2],W=s[6],$=s[10],H=s[14],le=s[3],J=s[7],Q=s[11],ie=s[15];return r[0]=o*A+a*L+l*N+c*le,r[4]=o*v+a*I+l*W+c*J,r[8]=o*E+a*k+l*$+c*Q,r[12]=o*U+a*z+l*H+c*ie,r[1]=u*A+f*L+h*N+d*le,r[5]=u*v+f*I+h*W+d*J,r[9]=u*E+f*k+h*$+d*Q,r[13]=u*U+f*z+h*H+d*ie,r[2]=p*A+_*L+g*N+m*le,r[6]=p*v+_*I+g*W+m*J,r[10]=p*E+_*k+g*$+m*Q,r[14]=p*U+_*z+g*H+m*ie,r[3]=x*A+M*L+b*N+C*le,r[7]=x*v+M*I+b*W+C*J,r[11]=x*E+M*k+b*$+C*Q,r[15]=x*U+M*z+b*H+C*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],f=e[6],h=e[10],d=e[14],p=e[3],_=e[7],g=e[11],m=e[15],x=l*d-c*h,M=a*d-c*f,b=a*h-l*f,C=o*d-c*u,A=o*h-l*u,v=o*f-a*u;return t*(_*x-g*M+m*b)-i*(p*x-g*C+m*A)+s*(p*M-_*C+m*v)-r*(p*b-_*A+g*v)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=e[9],h=e[10],d=e[11],p=e[12],_=e[13],g=e[14],m=e[15],x=t*a-i*o,M=t*l-s*o,b=t*c-r*o,C=i*l-s*a,A=i*c-r*a,v=s*c-r*l,E=u*_-f*p,U=u*g-h*p,L=u*m-d*p,I=f*g-h*_,k=f*m-d*_,z=h*m-d*g,N=x*z-M*k+b*I+C*L-A*U+v*E;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/N;return e[0]=(a*z-l*k+c*I)*W,e[1]=(s*k-i*z-r*I)*W,e[2]=(_*v-g*A+m*C)*W,e[3]=(h*A-f*v-d*C)*W,e[4]=(l*L-o*z-c*U)*W,e[5]=(t*z-s*L+r*U)*W,e[6]=(g*b-p*v-m*M)*W,e[7]=(u*v-h*b+d*M)*W,e[8]=(o*k-a*L+c*E)*W,e[9]=(i*L-t*k-r*E)*W,e[10]=(p*A-_*b+m*x)*W,e[11]=(f*b-u*A-d*x)*W,e[12]=(a*U-o*I-l*E)*W,e[13]=(t*I-i*U+s*E)*W,e[14]=(_*M-p*C-g*x)*W,e[15]=(u*C-f*M+h*x)*W,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,f=a+a,h=r*c,d=r*u,p=r*f,_=o*u,g=o*f,m=a*f,x=l*c,M=l*u,b=l*f,C=i.x,A=i.y,v=i.z;return s[0]=(1-(_+m))*C,s[1]=(d+b)*C,s[2]=(p-M)*C,s[3]=0,s[4]=(d-b)*A,s[5]=(1-(h+m))*A,s[6]=(g+x)*A,s[7]=0,s[8]=(p+M)*v,s[9]=(g-x)*v,s[10]=(1-(h+_))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=$r.set(s[0],s[1],s[2]).length(),a=$r.set(s[4],s[5],s[6]).length(),l=$r.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Di.copy(this);let c=1/o,u=1/a,f=1/l;return Di.elements[0]*=c,Di.elements[1]*=c,Di.elements[2]*=c,Di.elements[4]*=u,Di.elements[5]*=u,Di.elements[6]*=u,Di.elements[8]*=f,Di.elements[9]*=f,Di.elements[10]*=f,t.setFromRotationMatrix(Di),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=vi,l=!1){let c=this.elements,u=2*r/(t-e),f=2*r/(i-s),h=(t+e)/(t-e),d=(i+s)/(i-s),p,_;if(l)p=r/(o-r),_=o*r/(o-r);else if(a===vi)p=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===ca)p=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=vi,l=!1){let c=this.elements,u=2/(t-e),f=2/(i-s),h=-(t+e)/(t-e),d=-(i+s)/(i-s),p,_;if(l)p=1/(o-r),_=o/(o-r);else if(a===vi)p=-2/(o-r),_=-(o+r)/(o-r);else if(a===ca)p=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},$r=new G,Di=new yt,sy=new G(0,0,0),ry=new G(1,1,1),Bs=new G,_l=new G,oi=new G,um=new yt,hm=new yi,Ws=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(_t(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-_t(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(_t(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-_t(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(_t(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-_t(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Ye("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return um.makeRotationFromQuaternion(e),this.setFromRotationMatrix(um,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return hm.setFromEuler(this),this.setFromQuaternion(hm,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ws.DEFAULT_ORDER="XYZ";var fa=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},oy=0,fm=new G,Yr=new yi,fs=new yt,xl=new G,ea=new G,ay=new G,ly=new yi,dm=new G(1,0,0),pm=new G(0,1,0),mm=new G(0,0,1),gm={type:"added"},cy={type:"removed"},Zr={type:"childadded",child:null},zh={type:"childremoved",child:null},ci=class n extends es{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:oy++}),this.uuid=La(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new G,t=new Ws,i=new yi,s=new G(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new yt},normalMatrix:{value:new et}}),this.matrix=new yt,this.matrixWorld=new yt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new fa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Yr.setFromAxisAngle(e,t),this.quaternion.multiply(Yr),this}rotateOnWorldAxis(e,t){return Yr.setFromAxisAngle(e,t),this.quaternion.premultiply(Yr),this}rotateX(e){return this.rotateOnAxis(dm,e)}rotateY(e){return this.rotateOnAxis(pm,e)}rotateZ(e){return this.rotateOnAxis(mm,e)}translateOnAxis(e,t){return fm.copy(e).applyQuaternion(this.quaternion),this.position.add(fm.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(dm,e)}translateY(e){return this.translateOnAxis(pm,e)}translateZ(e){return this.translateOnAxis(mm,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(fs.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?xl.copy(e):xl.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ea.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?fs.lookAt(ea,xl,this.up):fs.lookAt(xl,ea,this.up),this.quaternion.setFromRotationMatrix(fs),s&&(fs.extractRotation(s.matrixWorld),Yr.setFromRotationMatrix(fs),this.quaternion.premultiply(Yr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Qe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(gm),Zr.child=e,this.dispatchEvent(Zr),Zr.child=null):Qe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(cy),zh.child=e,this.dispatchEvent(zh),zh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),fs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),fs.multiply(e.parent.matrixWorld)),e.applyMatrix4(fs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(gm),Zr.child=e,this.dispatchEvent(Zr),Zr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ea,e,ay),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ea,ly,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),f=o(e.shapes),h=o(e.skeletons),d=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),d.length>0&&(i.animations=d),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};ci.DEFAULT_UP=new G(0,1,0);ci.DEFAULT_MATRIX_AUTO_UPDATE=!0;ci.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var jt=class extends ci{constructor(){super(),this.isGroup=!0,this.type="Group"}},uy={type:"move"},uo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new jt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new jt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new jt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let _ of e.hand.values()){let g=t.getJointPose(_,i),m=this._getHandJoint(c,_);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),d=.02,p=.005;c.inputState.pinching&&h>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(uy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new jt;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},pg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ks={h:0,s:0,l:0},vl={h:0,s:0,l:0};function Vh(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var rt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Jn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,pt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=pt.workingColorSpace){return this.r=e,this.g=t,this.b=i,pt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=pt.workingColorSpace){if(e=jv(e,1),t=_t(t,0,1),i=_t(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Vh(o,r,e+1/3),this.g=Vh(o,r,e),this.b=Vh(o,r,e-1/3)}return pt.colorSpaceToWorking(this,s),this}setStyle(e,t=Jn){function i(r){r!==void 0&&parseFloat(r)<1&&Ye("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ye("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ye("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Jn){let i=pg[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ye("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=_s(e.r),this.g=_s(e.g),this.b=_s(e.b),this}copyLinearToSRGB(e){return this.r=ro(e.r),this.g=ro(e.g),this.b=ro(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Jn){return pt.workingToColorSpace(Gn.copy(this),e),Math.round(_t(Gn.r*255,0,255))*65536+Math.round(_t(Gn.g*255,0,255))*256+Math.round(_t(Gn.b*255,0,255))}getHexString(e=Jn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=pt.workingColorSpace){pt.workingToColorSpace(Gn.copy(this),t);let i=Gn.r,s=Gn.g,r=Gn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=pt.workingColorSpace){return pt.workingToColorSpace(Gn.copy(this),t),e.r=Gn.r,e.g=Gn.g,e.b=Gn.b,e}getStyle(e=Jn){pt.workingToColorSpace(Gn.copy(this),e);let t=Gn.r,i=Gn.g,s=Gn.b;return e!==Jn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(ks),this.setHSL(ks.h+e,ks.s+t,ks.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(ks),e.getHSL(vl);let i=Fh(ks.h,vl.h,t),s=Fh(ks.s,vl.s,t),r=Fh(ks.l,vl.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Gn=new rt;rt.NAMES=pg;var da=class extends ci{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ws,this.environmentIntensity=1,this.environmentRotation=new Ws,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ni=new G,ds=new G,Hh=new G,ps=new G,Jr=new G,Kr=new G,_m=new G,Gh=new G,Wh=new G,Xh=new G,qh=new Xt,$h=new Xt,Yh=new Xt,Gs=class n{constructor(e=new G,t=new G,i=new G){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Ni.subVectors(e,t),s.cross(Ni);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Ni.subVectors(s,t),ds.subVectors(i,t),Hh.subVectors(e,t);let o=Ni.dot(Ni),a=Ni.dot(ds),l=Ni.dot(Hh),c=ds.dot(ds),u=ds.dot(Hh),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,d=(c*l-a*u)*h,p=(o*u-a*l)*h;return r.set(1-d-p,p,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,ps)===null?!1:ps.x>=0&&ps.y>=0&&ps.x+ps.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,ps)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ps.x),l.addScaledVector(o,ps.y),l.addScaledVector(a,ps.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return qh.setScalar(0),$h.setScalar(0),Yh.setScalar(0),qh.fromBufferAttribute(e,t),$h.fromBufferAttribute(e,i),Yh.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(qh,r.x),o.addScaledVector($h,r.y),o.addScaledVector(Yh,r.z),o}static isFrontFacing(e,t,i,s){return Ni.subVectors(i,t),ds.subVectors(e,t),Ni.cross(ds).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ni.subVectors(this.c,this.b),ds.subVectors(this.a,this.b),Ni.cross(ds).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Jr.subVectors(s,i),Kr.subVectors(r,i),Gh.subVectors(e,i);let l=Jr.dot(Gh),c=Kr.dot(Gh);if(l<=0&&c<=0)return t.copy(i);Wh.subVectors(e,s);let u=Jr.dot(Wh),f=Kr.dot(Wh);if(u>=0&&f<=u)return t.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Jr,o);Xh.subVectors(e,r);let d=Jr.dot(Xh),p=Kr.dot(Xh);if(p>=0&&d<=p)return t.copy(r);let _=d*c-l*p;if(_<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(Kr,a);let g=u*p-d*f;if(g<=0&&f-u>=0&&d-p>=0)return _m.subVectors(r,s),a=(f-u)/(f-u+(d-p)),t.copy(s).addScaledVector(_m,a);let m=1/(g+_+h);return o=_*m,a=h*m,t.copy(i).addScaledVector(Jr,o).addScaledVector(Kr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ti=class{constructor(e=new G(1/0,1/0,1/0),t=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Fi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Fi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Fi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Fi):Fi.fromBufferAttribute(r,o),Fi.applyMatrix4(e.matrixWorld),this.expandByPoint(Fi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),yl.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),yl.copy(i.boundingBox)),yl.applyMatrix4(e.matrixWorld),this.union(yl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Fi),Fi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ta),bl.subVectors(this.max,ta),jr.subVectors(e.a,ta),Qr.subVectors(e.b,ta),eo.subVectors(e.c,ta),zs.subVectors(Qr,jr),Vs.subVectors(eo,Qr),hr.subVectors(jr,eo);let t=[0,-zs.z,zs.y,0,-Vs.z,Vs.y,0,-hr.z,hr.y,zs.z,0,-zs.x,Vs.z,0,-Vs.x,hr.z,0,-hr.x,-zs.y,zs.x,0,-Vs.y,Vs.x,0,-hr.y,hr.x,0];return!Zh(t,jr,Qr,eo,bl)||(t=[1,0,0,0,1,0,0,0,1],!Zh(t,jr,Qr,eo,bl))?!1:(Ml.crossVectors(zs,Vs),t=[Ml.x,Ml.y,Ml.z],Zh(t,jr,Qr,eo,bl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Fi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Fi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ms[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ms[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ms[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ms[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ms[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ms[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ms[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ms[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ms),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ms=[new G,new G,new G,new G,new G,new G,new G,new G],Fi=new G,yl=new ti,jr=new G,Qr=new G,eo=new G,zs=new G,Vs=new G,hr=new G,ta=new G,bl=new G,Ml=new G,fr=new G;function Zh(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){fr.fromArray(n,r);let a=s.x*Math.abs(fr.x)+s.y*Math.abs(fr.y)+s.z*Math.abs(fr.z),l=e.dot(fr),c=t.dot(fr),u=i.dot(fr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var gn=new G,Sl=new xt,hy=0,mt=class extends es{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:hy++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=lg,this.updateRanges=[],this.gpuType=ki,this.version=0,this._normalizationScale=e!==void 0?zf(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Sl.fromBufferAttribute(this,t),Sl.applyMatrix3(e),this.setXY(t,Sl.x,Sl.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix3(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix4(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.applyNormalMatrix(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.transformDirection(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Qv(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):ey(e,this.array)}};var pa=class extends mt{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var ma=class extends mt{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var rn=class extends mt{constructor(e,t,i){super(new Float32Array(e),t,i)}},fy=new ti,na=new G,Jh=new G,jn=class{constructor(e=new G,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):fy.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;na.subVectors(e,this.center);let t=na.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(na,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Jh.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(na.copy(e.center).add(Jh)),this.expandByPoint(na.copy(e.center).sub(Jh))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},dy=0,xi=new yt,Kh=new ci,to=new G,ai=new ti,ia=new ti,Dn=new G,on=class n extends es{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:dy++}),this.uuid=La(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Jv(e)?ma:pa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new et().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return xi.makeRotationFromQuaternion(e),this.applyMatrix4(xi),this}rotateX(e){return xi.makeRotationX(e),this.applyMatrix4(xi),this}rotateY(e){return xi.makeRotationY(e),this.applyMatrix4(xi),this}rotateZ(e){return xi.makeRotationZ(e),this.applyMatrix4(xi),this}translate(e,t,i){return xi.makeTranslation(e,t,i),this.applyMatrix4(xi),this}scale(e,t,i){return xi.makeScale(e,t,i),this.applyMatrix4(xi),this}lookAt(e){return Kh.lookAt(e),Kh.updateMatrix(),this.applyMatrix4(Kh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(to).negate(),this.translate(to.x,to.y,to.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new rn(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ye("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ti);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];ai.setFromBufferAttribute(r),this.morphTargetsRelative?(Dn.addVectors(this.boundingBox.min,ai.min),this.boundingBox.expandByPoint(Dn),Dn.addVectors(this.boundingBox.max,ai.max),this.boundingBox.expandByPoint(Dn)):(this.boundingBox.expandByPoint(ai.min),this.boundingBox.expandByPoint(ai.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new jn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(e){let i=this.boundingSphere.center;if(ai.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ia.setFromBufferAttribute(a),this.morphTargetsRelative?(Dn.addVectors(ai.min,ia.min),ai.expandByPoint(Dn),Dn.addVectors(ai.max,ia.max),ai.expandByPoint(Dn)):(ai.expandByPoint(ia.min),ai.expandByPoint(ia.max))}ai.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Dn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Dn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Dn.fromBufferAttribute(a,c),l&&(to.fromBufferAttribute(e,c),Dn.add(to)),s=Math.max(s,i.distanceToSquared(Dn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Qe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new mt(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new G,l[U]=new G;let u=new G,f=new G,h=new G,d=new xt,p=new xt,_=new xt,g=new G,m=new G;function x(U,L,I){c[U]=c[L]=c[I]=1,u.fromBufferAttribute(i,U),f.fromBufferAttribute(i,L),h.fromBufferAttribute(i,I),d.fromBufferAttribute(r,U),p.fromBufferAttribute(r,L),_.fromBufferAttribute(r,I),f.sub(u),h.sub(u),p.sub(d),_.sub(d);let k=1/(p.x*_.y-_.x*p.y);isFinite(k)&&(g.copy(f).multiplyScalar(_.y).addScaledVector(h,-p.y).multiplyScalar(k),m.copy(h).multiplyScalar(p.x).addScaledVector(f,-_.x).multiplyScalar(k),a[U].add(g),a[L].add(g),a[I].add(g),l[U].add(m),l[L].add(m),l[I].add(m))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let U=0,L=M.length;U<L;++U){let I=M[U],k=I.start,z=I.count;for(let N=k,W=k+z;N<W;N+=3)x(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let b=new G,C=new G,A=new G,v=new G;function E(U){A.fromBufferAttribute(s,U),v.copy(A);let L=a[U];b.copy(L),b.sub(A.multiplyScalar(A.dot(L))).normalize(),C.crossVectors(v,L);let k=C.dot(l[U])<0?-1:1;o.setXYZW(U,b.x,b.y,b.z,k)}for(let U=0,L=i.count;U<L;++U)c[U]&&E(U);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new mt(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,d=i.count;h<d;h++)i.setXYZ(h,0,0,0);let s=new G,r=new G,o=new G,a=new G,l=new G,c=new G,u=new G,f=new G;if(e)for(let h=0,d=e.count;h<d;h+=3){let p=e.getX(h+0),_=e.getX(h+1),g=e.getX(h+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,_),o.fromBufferAttribute(t,g),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let h=0,d=t.count;h<d;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Dn.fromBufferAttribute(e,t),Dn.normalize(),e.setXYZ(t,Dn.x,Dn.y,Dn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,f=a.normalized,h=new c.constructor(l.length*u),d=0,p=0;for(let _=0,g=l.length;_<g;_++){a.isInterleavedBufferAttribute?d=l[_]*a.data.stride+a.offset:d=l[_]*u;for(let m=0;m<u;m++)h[p++]=c[d++]}return new mt(h,u,f)}if(this.index===null)return Ye("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let h=c[u],d=e(h,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let d=c[f];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,d=f.length;h<d;h++)u.push(f[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var jh=new G,py=new G,my=new et,Ui=class{constructor(e=new G(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=jh.subVectors(i,t).cross(py.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(jh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||my.getNormalMatrix(e),s=this.coplanarPoint(jh).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},gy=0,Xs=class extends es{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:gy++}),this.uuid=La(),this.name="",this.type="Material",this.blending=xo,this.side=Si,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=df,this.blendDst=pf,this.blendEquation=yr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new rt(0,0,0),this.blendAlpha=0,this.depthFunc=oo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=nu,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=zl,this.stencilZFail=zl,this.stencilZPass=zl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ye(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new rt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Ui().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new xt().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new xt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var gs=new G,Qh=new G,wl=new G,El=new G,bi=class{constructor(e=new G,t=new G(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,gs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=gs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(gs.copy(this.origin).addScaledVector(this.direction,t),gs.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Qh.copy(e).add(t).multiplyScalar(.5),wl.copy(t).sub(e).normalize(),El.copy(this.origin).sub(Qh);let r=e.distanceTo(t)*.5,o=-this.direction.dot(wl),a=El.dot(this.direction),l=-El.dot(wl),c=El.lengthSq(),u=Math.abs(1-o*o),f,h,d,p;if(u>0)if(f=o*l-a,h=o*a-l,p=r*u,f>=0)if(h>=-p)if(h<=p){let _=1/u;f*=_,h*=_,d=f*(f+o*h+2*a)+h*(o*f+h+2*l)+c}else h=r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h<=-p?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c):h<=p?(f=0,h=Math.min(Math.max(-r,-l),r),d=h*(h+2*l)+c):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Qh).addScaledVector(wl,h),d}intersectSphere(e,t){if(e.radius<0)return null;gs.subVectors(e.center,this.origin);let i=gs.dot(this.direction),s=gs.dot(gs)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-h.z)*f,l=(e.max.z-h.z)*f):(a=(e.max.z-h.z)*f,l=(e.min.z-h.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,gs)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=e.x-o.x,h=e.y-o.y,d=e.z-o.z,p=t.x-o.x,_=t.y-o.y,g=t.z-o.z,m=i.x-o.x,x=i.y-o.y,M=i.z-o.z,b=Math.abs(l),C=Math.abs(c),A=Math.abs(u),v,E,U,L,I,k,z,N,W,$,H,le;if(b>=C&&b>=A?(U=l,k=f,W=p,le=m,l>=0?(v=c,E=u,L=h,I=d,z=_,N=g,$=x,H=M):(v=u,E=c,L=d,I=h,z=g,N=_,$=M,H=x)):C>=A?(U=c,k=h,W=_,le=x,c>=0?(v=u,E=l,L=d,I=f,z=g,N=p,$=M,H=m):(v=l,E=u,L=f,I=d,z=p,N=g,$=m,H=M)):(U=u,k=d,W=g,le=M,u>=0?(v=l,E=c,L=f,I=h,z=p,N=_,$=m,H=x):(v=c,E=l,L=h,I=f,z=_,N=p,$=x,H=m)),U===0)return null;let J=v/U,Q=E/U,ie=1/U,fe=L-J*k,he=I-Q*k,ee=z-J*W,me=N-Q*W,ge=$-J*le,Se=H-Q*le,xe=ge*me-Se*ee,Ve=fe*Se-he*ge,Xe=ee*he-me*fe;if(s){if(xe<0||Ve<0||Xe<0)return null}else if((xe<0||Ve<0||Xe<0)&&(xe>0||Ve>0||Xe>0))return null;let Ne=xe+Ve+Xe;if(Ne===0)return null;let ct=ie*(xe*k+Ve*W+Xe*le);return(Ne>0?ct<0:ct>0)?null:this.at(ct/Ne,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},qs=class extends Xs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new rt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ws,this.combine=mf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},xm=new yt,dr=new bi,Tl=new jn,vm=new G,Al=new G,Cl=new G,Rl=new G,ef=new G,Pl=new G,ym=new G,Il=new G,Mt=class extends ci{constructor(e=new on,t=new qs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Pl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(ef.fromBufferAttribute(f,e),o?Pl.addScaledVector(ef,u):Pl.addScaledVector(ef.sub(t),u))}t.add(Pl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Tl.copy(i.boundingSphere),Tl.applyMatrix4(r),dr.copy(e.ray).recast(e.near),!(Tl.containsPoint(dr.origin)===!1&&(dr.intersectSphere(Tl,vm)===null||dr.origin.distanceToSquared(vm)>(e.far-e.near)**2))&&(xm.copy(r).invert(),dr.copy(e.ray).applyMatrix4(xm),!(i.boundingBox!==null&&dr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,dr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,_=h.length;p<_;p++){let g=h[p],m=o[g.materialIndex],x=Math.max(g.start,d.start),M=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let b=x,C=M;b<C;b+=3){let A=a.getX(b),v=a.getX(b+1),E=a.getX(b+2);s=Ll(this,m,e,i,c,u,f,A,v,E),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),_=Math.min(a.count,d.start+d.count);for(let g=p,m=_;g<m;g+=3){let x=a.getX(g),M=a.getX(g+1),b=a.getX(g+2);s=Ll(this,o,e,i,c,u,f,x,M,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,_=h.length;p<_;p++){let g=h[p],m=o[g.materialIndex],x=Math.max(g.start,d.start),M=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let b=x,C=M;b<C;b+=3){let A=b,v=b+1,E=b+2;s=Ll(this,m,e,i,c,u,f,A,v,E),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),_=Math.min(l.count,d.start+d.count);for(let g=p,m=_;g<m;g+=3){let x=g,M=g+1,b=g+2;s=Ll(this,o,e,i,c,u,f,x,M,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function _y(n,e,t,i,s,r,o,a){let l;if(e.side===Bn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Si,a),l===null)return null;Il.copy(a),Il.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Il);return c<t.near||c>t.far?null:{distance:c,point:Il.clone(),object:n}}function Ll(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Al),n.getVertexPosition(l,Cl),n.getVertexPosition(c,Rl);let u=_y(n,e,t,i,Al,Cl,Rl,ym);if(u){let f=new G;Gs.getBarycoord(ym,Al,Cl,Rl,f),s&&(u.uv=Gs.getInterpolatedAttribute(s,a,l,c,f,new xt)),r&&(u.uv1=Gs.getInterpolatedAttribute(r,a,l,c,f,new xt)),o&&(u.normal=Gs.getInterpolatedAttribute(o,a,l,c,f,new G),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new G,materialIndex:0};Gs.getNormal(Al,Cl,Rl,h.normal),u.face=h,u.barycoord=f}return u}var ho=class extends ei{constructor(e=null,t=1,i=1,s,r,o,a,l,c=_n,u=_n,f,h){super(null,o,a,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var mr=class extends mt{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var pr=new jn,xy=new xt(.5,.5),Dl=new G,vs=class{constructor(e=new Ui,t=new Ui,i=new Ui,s=new Ui,r=new Ui,o=new Ui){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=vi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],d=r[7],p=r[8],_=r[9],g=r[10],m=r[11],x=r[12],M=r[13],b=r[14],C=r[15];if(s[0].setComponents(c-o,d-u,m-p,C-x).normalize(),s[1].setComponents(c+o,d+u,m+p,C+x).normalize(),s[2].setComponents(c+a,d+f,m+_,C+M).normalize(),s[3].setComponents(c-a,d-f,m-_,C-M).normalize(),i)s[4].setComponents(l,h,g,b).normalize(),s[5].setComponents(c-l,d-h,m-g,C-b).normalize();else if(s[4].setComponents(c-l,d-h,m-g,C-b).normalize(),t===vi)s[5].setComponents(c+l,d+h,m+g,C+b).normalize();else if(t===ca)s[5].setComponents(l,h,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),pr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),pr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(pr)}intersectsSprite(e){pr.center.set(0,0,0);let t=xy.distanceTo(e.center);return pr.radius=.7071067811865476+t,pr.applyMatrix4(e.matrixWorld),this.intersectsSphere(pr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Dl.x=s.normal.x>0?e.max.x:e.min.x,Dl.y=s.normal.y>0?e.max.y:e.min.y,Dl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Dl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},bm=new yt,ec=class n{constructor(){this.coordinateSystem=vi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];bm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new vs),i[s].setFromProjectionMatrix(bm,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new vs),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var $s=class extends Xs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new rt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},tc=new G,nc=new G,Mm=new yt,sa=new bi,Nl=new jn,tf=new G,Sm=new G,ga=class extends ci{constructor(e=new on,t=new $s){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)tc.fromBufferAttribute(t,s-1),nc.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=tc.distanceTo(nc);e.setAttribute("lineDistance",new rn(i,1))}else Ye("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Nl.copy(i.boundingSphere),Nl.applyMatrix4(s),Nl.radius+=r,e.ray.intersectsSphere(Nl)===!1)return;Mm.copy(s).invert(),sa.copy(e.ray).applyMatrix4(Mm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let _=d,g=p-1;_<g;_+=c){let m=u.getX(_),x=u.getX(_+1),M=Fl(this,e,sa,l,m,x,_);M&&t.push(M)}if(this.isLineLoop){let _=u.getX(p-1),g=u.getX(d),m=Fl(this,e,sa,l,_,g,p-1);m&&t.push(m)}}else{let d=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let _=d,g=p-1;_<g;_+=c){let m=Fl(this,e,sa,l,_,_+1,_);m&&t.push(m)}if(this.isLineLoop){let _=Fl(this,e,sa,l,p-1,d,p-1);_&&t.push(_)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Fl(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(tc.fromBufferAttribute(a,s),nc.fromBufferAttribute(a,r),t.distanceSqToSegment(tc,nc,tf,Sm)>i)return;tf.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(tf);if(!(c<e.near||c>e.far))return{distance:c,point:Sm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var wm=new G,Em=new G,Oi=class extends ga{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)wm.fromBufferAttribute(t,s),Em.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+wm.distanceTo(Em);e.setAttribute("lineDistance",new rn(i,1))}else Ye("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},gr=class extends ga{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}};var _a=class extends ei{constructor(e=[],t=br,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var ys=class extends ei{constructor(e,t,i=Bi,s,r,o,a=_n,l=_n,c,u=xs,f=1){if(u!==xs&&u!==Ms)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:f};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new co(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},xa=class extends ys{constructor(e,t=Bi,i=br,s,r,o=_n,a=_n,l,c=xs){let u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},va=class extends ei{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},fo=class n extends on{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],h=0,d=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new rn(c,3)),this.setAttribute("normal",new rn(u,3)),this.setAttribute("uv",new rn(f,2));function p(_,g,m,x,M,b,C,A,v,E,U){let L=b/v,I=C/E,k=b/2,z=C/2,N=A/2,W=v+1,$=E+1,H=0,le=0,J=new G;for(let Q=0;Q<$;Q++){let ie=Q*I-z;for(let fe=0;fe<W;fe++){let he=fe*L-k;J[_]=he*x,J[g]=ie*M,J[m]=N,c.push(J.x,J.y,J.z),J[_]=0,J[g]=0,J[m]=A>0?1:-1,u.push(J.x,J.y,J.z),f.push(fe/v),f.push(1-Q/E),H+=1}}for(let Q=0;Q<E;Q++)for(let ie=0;ie<v;ie++){let fe=h+ie+W*Q,he=h+ie+W*(Q+1),ee=h+(ie+1)+W*(Q+1),me=h+(ie+1)+W*Q;l.push(fe,he,me),l.push(he,ee,me),le+=6}a.addGroup(d,le,U),d+=le,h+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var po=class n extends on{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],f=[],h=[],d=[],p=0,_=[],g=i/2,m=0;x(),o===!1&&(e>0&&M(!0),t>0&&M(!1)),this.setIndex(u),this.setAttribute("position",new rn(f,3)),this.setAttribute("normal",new rn(h,3)),this.setAttribute("uv",new rn(d,2));function x(){let b=new G,C=new G,A=0,v=(t-e)/i;for(let E=0;E<=r;E++){let U=[],L=E/r,I=L*(t-e)+e;for(let k=0;k<=s;k++){let z=k/s,N=z*l+a,W=Math.sin(N),$=Math.cos(N);C.x=I*W,C.y=-L*i+g,C.z=I*$,f.push(C.x,C.y,C.z),b.set(W,v,$).normalize(),h.push(b.x,b.y,b.z),d.push(z,1-L),U.push(p++)}_.push(U)}for(let E=0;E<s;E++)for(let U=0;U<r;U++){let L=_[U][E],I=_[U+1][E],k=_[U+1][E+1],z=_[U][E+1];(e>0||U!==0)&&(u.push(L,I,z),A+=3),(t>0||U!==r-1)&&(u.push(I,k,z),A+=3)}c.addGroup(m,A,0),m+=A}function M(b){let C=p,A=new xt,v=new G,E=0,U=b===!0?e:t,L=b===!0?1:-1;for(let k=1;k<=s;k++)f.push(0,g*L,0),h.push(0,L,0),d.push(.5,.5),p++;let I=p;for(let k=0;k<=s;k++){let N=k/s*l+a,W=Math.cos(N),$=Math.sin(N);v.x=U*$,v.y=g*L,v.z=U*W,f.push(v.x,v.y,v.z),h.push(0,L,0),A.x=W*.5+.5,A.y=$*.5*L+.5,d.push(A.x,A.y),p++}for(let k=0;k<s;k++){let z=C+k,N=I+k;b===!0?u.push(N,N+1,z):u.push(N+1,N,z),E+=3}c.addGroup(m,E,b===!0?1:2),m+=E}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},_r=class n extends po{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var xr=class n extends on{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=e/a,h=t/l,d=[],p=[],_=[],g=[];for(let m=0;m<u;m++){let x=m*h-o;for(let M=0;M<c;M++){let b=M*f-r;p.push(b,-x,0),_.push(0,0,1),g.push(M/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let x=0;x<a;x++){let M=x+c*m,b=x+c*(m+1),C=x+1+c*(m+1),A=x+1+c*m;d.push(M,b,A),d.push(b,C,A)}this.setIndex(d),this.setAttribute("position",new rn(p,3)),this.setAttribute("normal",new rn(_,3)),this.setAttribute("uv",new rn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var ya=class n extends on{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],f=new G,h=new G,d=[],p=[],_=[],g=[];for(let m=0;m<=i;m++){let x=[],M=m/i,b=o+M*a,C=e*Math.cos(b),A=Math.sqrt(e*e-C*C),v=0;m===0&&o===0?v=.5/t:m===i&&l===Math.PI&&(v=-.5/t);for(let E=0;E<=t;E++){let U=E/t,L=s+U*r;f.x=-A*Math.cos(L),f.y=C,f.z=A*Math.sin(L),p.push(f.x,f.y,f.z),h.copy(f).normalize(),_.push(h.x,h.y,h.z),g.push(U+v,1-M),x.push(c++)}u.push(x)}for(let m=0;m<i;m++)for(let x=0;x<t;x++){let M=u[m][x+1],b=u[m][x],C=u[m+1][x],A=u[m+1][x+1];(m!==0||o>0)&&d.push(M,b,A),(m!==i-1||l<Math.PI)&&d.push(b,C,A)}this.setIndex(d),this.setAttribute("position",new rn(p,3)),this.setAttribute("normal",new rn(_,3)),this.setAttribute("uv",new rn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Sr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(Tm(s))s.isRenderTargetTexture?(Ye("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(Tm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Wn(n){let e={};for(let t=0;t<n.length;t++){let i=Sr(n[t]);for(let s in i)e[s]=i[s]}return e}function Tm(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function vy(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Vf(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:pt.workingColorSpace}var mg={clone:Sr,merge:Wn},yy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,by=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Mi=class extends Xs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=yy,this.fragmentShader=by,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Sr(e.uniforms),this.uniformsGroups=vy(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new rt().setHex(s.value);break;case"v2":this.uniforms[i].value=new xt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new G().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Xt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new et().fromArray(s.value);break;case"m4":this.uniforms[i].value=new yt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},ic=class extends Mi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var sc=class extends Xs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=tg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},rc=class extends Xs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function no(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Ul(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Ys=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},oc=class extends Ys{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:sf,endingEnd:sf}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case rf:r=e,a=2*t-i;break;case of:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case rf:o=e,l=2*i-t;break;case of:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,d=this._weightNext,p=(i-t)/(s-t),_=p*p,g=_*p,m=-h*g+2*h*_-h*p,x=(1+h)*g+(-1.5-2*h)*_+(-.5+h)*p+1,M=(-1-d)*g+(1.5+d)*_+.5*p,b=d*g-d*_;for(let C=0;C!==a;++C)r[C]=m*o[u+C]+x*o[c+C]+M*o[l+C]+b*o[f+C];return r}},ac=class extends Ys{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),f=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*f+o[l+h]*u;return r}},lc=class extends Ys{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},cc=class extends Ys{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let p=(i-t)/(s-t),_=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*_+o[l+g]*p;return r}let h=a*2,d=e-1;for(let p=0;p!==a;++p){let _=o[c+p],g=o[l+p],m=d*h+p*2,x=f[m],M=f[m+1],b=e*h+p*2,C=u[b],A=u[b+1],v=Sy(i,t,x,C,s);r[p]=gg(v,_,M,A,g)}return r}};function gg(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function My(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function Sy(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=gg(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=My(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ui=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=no(t,this.TimeBufferType),this.values=no(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:no(e.times,Array),values:no(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Ul(e.settings)&&(i.settings={inTangents:no(e.settings.inTangents,Array),outTangents:no(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new lc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new ac(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new oc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new cc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case oa:t=this.InterpolantFactoryMethodDiscrete;break;case Zl:t=this.InterpolantFactoryMethodLinear;break;case kl:t=this.InterpolantFactoryMethodSmooth;break;case nf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ye("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return oa;case this.InterpolantFactoryMethodLinear:return Zl;case this.InterpolantFactoryMethodSmooth:return kl;case this.InterpolantFactoryMethodBezier:return nf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Ul(this.settings)&&(Am(this.settings.inTangents,e),Am(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Ul(this.settings)&&(Cm(this.settings.inTangents,e),Cm(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Qe("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Qe("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Qe("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Qe("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Kv(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Qe("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===kl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let f=a*i,h=f-i,d=f+i;for(let p=0;p!==i;++p){let _=t[f+p];if(_!==t[h+p]||_!==t[d+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*i,h=o*i;for(let d=0;d!==i;++d)t[h+d]=t[f+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Ul(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Am(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function Cm(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}ui.prototype.ValueTypeName="";ui.prototype.TimeBufferType=Float32Array;ui.prototype.ValueBufferType=Float32Array;ui.prototype.DefaultInterpolation=Zl;var Zs=class extends ui{constructor(e,t,i){super(e,t,i)}};Zs.prototype.ValueTypeName="bool";Zs.prototype.ValueBufferType=Array;Zs.prototype.DefaultInterpolation=oa;Zs.prototype.InterpolantFactoryMethodLinear=void 0;Zs.prototype.InterpolantFactoryMethodSmooth=void 0;var uc=class extends ui{constructor(e,t,i,s){super(e,t,i,s)}};uc.prototype.ValueTypeName="color";var hc=class extends ui{constructor(e,t,i,s){super(e,t,i,s)}};hc.prototype.ValueTypeName="number";var fc=class extends Ys{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)yi.slerpFlat(r,0,o,c-a,o,c,l);return r}},ba=class extends ui{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new fc(this.times,this.values,this.getValueSize(),e)}};ba.prototype.ValueTypeName="quaternion";ba.prototype.InterpolantFactoryMethodSmooth=void 0;var Js=class extends ui{constructor(e,t,i){super(e,t,i)}};Js.prototype.ValueTypeName="string";Js.prototype.ValueBufferType=Array;Js.prototype.DefaultInterpolation=oa;Js.prototype.InterpolantFactoryMethodLinear=void 0;Js.prototype.InterpolantFactoryMethodSmooth=void 0;var dc=class extends ui{constructor(e,t,i,s){super(e,t,i,s)}};dc.prototype.ValueTypeName="vector";var pc=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let d=c[f],p=c[f+1];if(d.global&&(d.lastIndex=0),d.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},_g=new pc,mc=class{constructor(e){this.manager=e!==void 0?e:_g,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};mc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ol=new G,Bl=new yi,ji=new G,Ma=class extends ci{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new yt,this.projectionMatrix=new yt,this.projectionMatrixInverse=new yt,this.coordinateSystem=vi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Ol,Bl,ji),ji.x===1&&ji.y===1&&ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ol,Bl,ji.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Ol,Bl,ji),ji.x===1&&ji.y===1&&ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ol,Bl,ji.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Hs=new G,Rm=new xt,Pm=new xt,Kn=class extends Ma{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Jl*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Nh*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Jl*2*Math.atan(Math.tan(Nh*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Hs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Hs.x,Hs.y).multiplyScalar(-e/Hs.z),Hs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Hs.x,Hs.y).multiplyScalar(-e/Hs.z)}getViewSize(e,t){return this.getViewBounds(e,Rm,Pm),t.subVectors(Pm,Rm)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Nh*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var mo=class extends Ma{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Ks=class extends on{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var io=-90,so=1,go=class extends ci{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Kn(io,so,e,t);s.layers=this.layers,this.add(s);let r=new Kn(io,so,e,t);r.layers=this.layers,this.add(r);let o=new Kn(io,so,e,t);o.layers=this.layers,this.add(o);let a=new Kn(io,so,e,t);a.layers=this.layers,this.add(a);let l=new Kn(io,so,e,t);l.layers=this.layers,this.add(l);let c=new Kn(io,so,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===vi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===ca)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=_,e.setRenderTarget(i,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,h,d),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},gc=class extends Kn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Hf="\\[\\]\\.:\\/",wy=new RegExp("["+Hf+"]","g"),Gf="[^"+Hf+"]",Ey="[^"+Hf.replace("\\.","")+"]",Ty=/((?:WC+[\/:])*)/.source.replace("WC",Gf),Ay=/(WCOD+)?/.source.replace("WCOD",Ey),Cy=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Gf),Ry=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Gf),Py=new RegExp("^"+Ty+Ay+Cy+Ry+"$"),Iy=["material","materials","bones","map"],af=class{constructor(e,t,i){let s=i||Wt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Wt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(wy,"")}static parseTrackName(e){let t=Py.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Iy.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ye("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Qe("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Qe("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Qe("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){Qe("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){Qe("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Qe("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Wt.Composite=af;Wt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Wt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Wt.prototype.GetterByBindingType=[Wt.prototype._getValue_direct,Wt.prototype._getValue_array,Wt.prototype._getValue_arrayElement,Wt.prototype._getValue_toArray];Wt.prototype.SetterByBindingTypeAndVersioning=[[Wt.prototype._setValue_direct,Wt.prototype._setValue_direct_setNeedsUpdate,Wt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Wt.prototype._setValue_array,Wt.prototype._setValue_array_setNeedsUpdate,Wt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Wt.prototype._setValue_arrayElement,Wt.prototype._setValue_arrayElement_setNeedsUpdate,Wt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Wt.prototype._setValue_fromArray,Wt.prototype._setValue_fromArray_setNeedsUpdate,Wt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var PC=new Float32Array(1);var lf=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};function Wf(n,e,t,i){let s=Ly(i);switch(t){case Cf:return n*e;case Pf:return n*e/s.components*s.byteLength;case Sc:return n*e/s.components*s.byteLength;case js:return n*e*2/s.components*s.byteLength;case wc:return n*e*2/s.components*s.byteLength;case Rf:return n*e*3/s.components*s.byteLength;case fi:return n*e*4/s.components*s.byteLength;case Ec:return n*e*4/s.components*s.byteLength;case Ea:case Ta:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Aa:case Ca:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ac:case Rc:return Math.max(n,16)*Math.max(e,8)/4;case Tc:case Cc:return Math.max(n,8)*Math.max(e,8)/2;case Pc:case Ic:case Dc:case Nc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Lc:case Ra:case Fc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Uc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Oc:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Bc:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case kc:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case zc:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Vc:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Hc:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Gc:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Wc:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Xc:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case qc:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case $c:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Yc:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Zc:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Jc:case Kc:case jc:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Qc:case eu:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Pa:case tu:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Ly(n){switch(n){case hi:case wf:return{byteLength:1,components:1};case yo:case Ef:case zi:return{byteLength:2,components:1};case bc:case Mc:return{byteLength:2,components:4};case Bi:case yc:case ki:return{byteLength:4,components:1};case Tf:case Af:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ye("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function kg(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function Ny(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,f=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((d,p)=>d.start-p.start);let h=0;for(let d=1;d<f.length;d++){let p=f[h],_=f[d];_.start<=p.start+p.count+1?p.count=Math.max(p.count,_.start+_.count-p.start):(++h,f[h]=_)}f.length=h+1;for(let d=0,p=f.length;d<p;d++){let _=f[d];n.bufferSubData(c,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Fy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Uy=`#ifdef USE_ALPHAHASH
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
#endif`,Oy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,By=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ky=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,zy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Vy=`#ifdef USE_AOMAP
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
#endif`,Hy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Gy=`#ifdef USE_BATCHING
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
#endif`,Wy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Xy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,qy=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,$y=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Yy=`#ifdef USE_IRIDESCENCE
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
#endif`,Zy=`#ifdef USE_BUMPMAP
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
#endif`,Jy=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Ky=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,jy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Qy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,eb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,tb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,nb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,ib=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,sb=`#define PI 3.141592653589793
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
} // validated`,rb=`vec3 transformedNormal = objectNormal;
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
#endif`,ob=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,ab=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,lb=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,cb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,ub="gl_FragColor = linearToOutputTexel( gl_FragColor );",hb=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,fb=`#ifdef USE_ENVMAP
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
#endif`,db=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,pb=`#ifdef USE_ENVMAP
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
#endif`,mb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,gb=`#ifdef USE_ENVMAP
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
#endif`,_b=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,xb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,vb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,yb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,bb=`#ifdef USE_GRADIENTMAP
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
}`,Mb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Sb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,wb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Eb=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Tb=`#ifdef USE_ENVMAP
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
#endif`,Ab=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Cb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Rb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Pb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Ib=`PhysicalMaterial material;
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
#endif`,Lb=`uniform sampler2D dfgLUT;
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
}`,Db=`
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
#endif`,Nb=`#if defined( RE_IndirectDiffuse )
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
#endif`,Fb=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Ub=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Ob=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Bb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,kb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,zb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Vb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Hb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Gb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Wb=`#if defined( USE_POINTS_UV )
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
#endif`,Xb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,qb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,$b=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Yb=`#if defined( USE_MORPHCOLORS )
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
#endif`,Zb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Jb=`#ifdef USE_MORPHTARGETS
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
#endif`,Kb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,jb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Qb=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,eM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,tM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,nM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,iM=`#ifdef USE_NORMALMAP
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
#endif`,sM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,rM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,oM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,aM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,lM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,cM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,uM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,hM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,fM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,dM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,pM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,mM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,gM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,_M=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,xM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,vM=`float getShadowMask() {
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
}`,yM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,bM=`#ifdef USE_SKINNING
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
#endif`,MM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,SM=`#ifdef USE_SKINNING
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
#endif`,wM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,EM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,TM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,AM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,CM=`#ifdef USE_TRANSMISSION
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
#endif`,RM=`#ifdef USE_TRANSMISSION
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
#endif`,PM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,IM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,LM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,DM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,NM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,FM=`uniform sampler2D t2D;
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
}`,UM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,OM=`uniform float backgroundBlurriness;
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
}`,BM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,kM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,zM=`#include <common>
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
}`,VM=`#if DEPTH_PACKING == 3200
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
}`,HM=`#define DISTANCE
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
}`,GM=`#define DISTANCE
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
}`,WM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,XM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,qM=`uniform float scale;
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
}`,$M=`uniform vec3 diffuse;
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
}`,YM=`#include <common>
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
}`,ZM=`uniform vec3 diffuse;
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
}`,JM=`#define LAMBERT
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
}`,KM=`#define LAMBERT
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
}`,jM=`#define MATCAP
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
}`,QM=`#define MATCAP
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
}`,eS=`#define NORMAL
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
}`,tS=`#define NORMAL
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
}`,nS=`#define PHONG
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
}`,iS=`#define PHONG
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
}`,sS=`#define STANDARD
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
}`,rS=`#define STANDARD
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
}`,oS=`#define TOON
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
}`,aS=`#define TOON
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
}`,lS=`uniform float size;
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
}`,cS=`uniform vec3 diffuse;
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
}`,uS=`#include <common>
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
}`,hS=`uniform vec3 color;
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
}`,fS=`uniform float rotation;
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
}`,dS=`uniform vec3 diffuse;
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
}`,lt={alphahash_fragment:Fy,alphahash_pars_fragment:Uy,alphamap_fragment:Oy,alphamap_pars_fragment:By,alphatest_fragment:ky,alphatest_pars_fragment:zy,aomap_fragment:Vy,aomap_pars_fragment:Hy,batching_pars_vertex:Gy,batching_vertex:Wy,begin_vertex:Xy,beginnormal_vertex:qy,bsdfs:$y,iridescence_fragment:Yy,bumpmap_pars_fragment:Zy,clipping_planes_fragment:Jy,clipping_planes_pars_fragment:Ky,clipping_planes_pars_vertex:jy,clipping_planes_vertex:Qy,color_fragment:eb,color_pars_fragment:tb,color_pars_vertex:nb,color_vertex:ib,common:sb,defaultnormal_vertex:rb,displacementmap_pars_vertex:ob,displacementmap_vertex:ab,emissivemap_fragment:lb,emissivemap_pars_fragment:cb,colorspace_fragment:ub,colorspace_pars_fragment:hb,envmap_fragment:fb,envmap_common_pars_fragment:db,envmap_pars_fragment:pb,envmap_pars_vertex:mb,envmap_physical_pars_fragment:Tb,envmap_vertex:gb,fog_vertex:_b,fog_pars_vertex:xb,fog_fragment:vb,fog_pars_fragment:yb,gradientmap_pars_fragment:bb,lightmap_pars_fragment:Mb,lights_lambert_fragment:Sb,lights_lambert_pars_fragment:wb,lights_pars_begin:Eb,lights_toon_fragment:Ab,lights_toon_pars_fragment:Cb,lights_phong_fragment:Rb,lights_phong_pars_fragment:Pb,lights_physical_fragment:Ib,lights_physical_pars_fragment:Lb,lights_fragment_begin:Db,lights_fragment_maps:Nb,lights_fragment_end:Fb,lightprobes_pars_fragment:Ub,logdepthbuf_fragment:Ob,logdepthbuf_pars_fragment:Bb,logdepthbuf_pars_vertex:kb,logdepthbuf_vertex:zb,map_fragment:Vb,map_pars_fragment:Hb,map_particle_fragment:Gb,map_particle_pars_fragment:Wb,metalnessmap_fragment:Xb,metalnessmap_pars_fragment:qb,morphinstance_vertex:$b,morphcolor_vertex:Yb,morphnormal_vertex:Zb,morphtarget_pars_vertex:Jb,morphtarget_vertex:Kb,normal_fragment_begin:jb,normal_fragment_maps:Qb,normal_pars_fragment:eM,normal_pars_vertex:tM,normal_vertex:nM,normalmap_pars_fragment:iM,clearcoat_normal_fragment_begin:sM,clearcoat_normal_fragment_maps:rM,clearcoat_pars_fragment:oM,iridescence_pars_fragment:aM,opaque_fragment:lM,packing:cM,premultiplied_alpha_fragment:uM,project_vertex:hM,dithering_fragment:fM,dithering_pars_fragment:dM,roughnessmap_fragment:pM,roughnessmap_pars_fragment:mM,shadowmap_pars_fragment:gM,shadowmap_pars_vertex:_M,shadowmap_vertex:xM,shadowmask_pars_fragment:vM,skinbase_vertex:yM,skinning_pars_vertex:bM,skinning_vertex:MM,skinnormal_vertex:SM,specularmap_fragment:wM,specularmap_pars_fragment:EM,tonemapping_fragment:TM,tonemapping_pars_fragment:AM,transmission_fragment:CM,transmission_pars_fragment:RM,uv_pars_fragment:PM,uv_pars_vertex:IM,uv_vertex:LM,worldpos_vertex:DM,background_vert:NM,background_frag:FM,backgroundCube_vert:UM,backgroundCube_frag:OM,cube_vert:BM,cube_frag:kM,depth_vert:zM,depth_frag:VM,distance_vert:HM,distance_frag:GM,equirect_vert:WM,equirect_frag:XM,linedashed_vert:qM,linedashed_frag:$M,meshbasic_vert:YM,meshbasic_frag:ZM,meshlambert_vert:JM,meshlambert_frag:KM,meshmatcap_vert:jM,meshmatcap_frag:QM,meshnormal_vert:eS,meshnormal_frag:tS,meshphong_vert:nS,meshphong_frag:iS,meshphysical_vert:sS,meshphysical_frag:rS,meshtoon_vert:oS,meshtoon_frag:aS,points_vert:lS,points_frag:cS,shadow_vert:uS,shadow_frag:hS,sprite_vert:fS,sprite_frag:dS},Le={common:{diffuse:{value:new rt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new et}},envmap:{envMap:{value:null},envMapRotation:{value:new et},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new et}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new et}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new et},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new et},normalScale:{value:new xt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new et},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new et}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new et}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new et}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new rt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new rt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0},uvTransform:{value:new et}},sprite:{diffuse:{value:new rt(16777215)},opacity:{value:1},center:{value:new xt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}}},is={basic:{uniforms:Wn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:lt.meshbasic_vert,fragmentShader:lt.meshbasic_frag},lambert:{uniforms:Wn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new rt(0)},envMapIntensity:{value:1}}]),vertexShader:lt.meshlambert_vert,fragmentShader:lt.meshlambert_frag},phong:{uniforms:Wn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new rt(0)},specular:{value:new rt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:lt.meshphong_vert,fragmentShader:lt.meshphong_frag},standard:{uniforms:Wn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new rt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:lt.meshphysical_vert,fragmentShader:lt.meshphysical_frag},toon:{uniforms:Wn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new rt(0)}}]),vertexShader:lt.meshtoon_vert,fragmentShader:lt.meshtoon_frag},matcap:{uniforms:Wn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:lt.meshmatcap_vert,fragmentShader:lt.meshmatcap_frag},points:{uniforms:Wn([Le.points,Le.fog]),vertexShader:lt.points_vert,fragmentShader:lt.points_frag},dashed:{uniforms:Wn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:lt.linedashed_vert,fragmentShader:lt.linedashed_frag},depth:{uniforms:Wn([Le.common,Le.displacementmap]),vertexShader:lt.depth_vert,fragmentShader:lt.depth_frag},normal:{uniforms:Wn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:lt.meshnormal_vert,fragmentShader:lt.meshnormal_frag},sprite:{uniforms:Wn([Le.sprite,Le.fog]),vertexShader:lt.sprite_vert,fragmentShader:lt.sprite_frag},background:{uniforms:{uvTransform:{value:new et},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:lt.background_vert,fragmentShader:lt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new et}},vertexShader:lt.backgroundCube_vert,fragmentShader:lt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:lt.cube_vert,fragmentShader:lt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:lt.equirect_vert,fragmentShader:lt.equirect_frag},distance:{uniforms:Wn([Le.common,Le.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:lt.distance_vert,fragmentShader:lt.distance_frag},shadow:{uniforms:Wn([Le.lights,Le.fog,{color:{value:new rt(0)},opacity:{value:1}}]),vertexShader:lt.shadow_vert,fragmentShader:lt.shadow_frag}};is.physical={uniforms:Wn([is.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new et},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new et},clearcoatNormalScale:{value:new xt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new et},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new et},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new et},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new et},sheen:{value:0},sheenColor:{value:new rt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new et},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new et},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new et},transmissionSamplerSize:{value:new xt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new et},attenuationDistance:{value:0},attenuationColor:{value:new rt(0)},specularColor:{value:new rt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new et},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new et},anisotropyVector:{value:new xt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new et}}]),vertexShader:lt.meshphysical_vert,fragmentShader:lt.meshphysical_frag};var iu={r:0,b:0,g:0},pS=new yt,zg=new et;zg.set(-1,0,0,0,1,0,0,0,1);function mS(n,e,t,i,s,r){let o=new rt(0),a=s===!0?0:1,l,c,u=null,f=0,h=null;function d(x){let M=x.isScene===!0?x.background:null;if(M&&M.isTexture){let b=x.backgroundBlurriness>0;M=e.get(M,b)}return M}function p(x){let M=!1,b=d(x);b===null?g(o,a):b&&b.isColor&&(g(b,1),M=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(x,M){let b=d(M);b&&b.isCubeTexture?(c===void 0&&(c=new Mt(new fo(1,1,1),new Mi({name:"BackgroundCubeMaterial",uniforms:Sr(is.backgroundCube.uniforms),vertexShader:is.backgroundCube.vertexShader,fragmentShader:is.backgroundCube.fragmentShader,side:Bn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,A,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(pS.makeRotationFromEuler(M.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(zg),c.material.toneMapped=pt.getTransfer(b.colorSpace)!==Tt,(u!==b||f!==b.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,f=b.version,h=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Mt(new xr(2,2),new Mi({name:"BackgroundMaterial",uniforms:Sr(is.background.uniforms),vertexShader:is.background.vertexShader,fragmentShader:is.background.fragmentShader,side:Si,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=pt.getTransfer(b.colorSpace)!==Tt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||f!==b.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,f=b.version,h=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function g(x,M){x.getRGB(iu,Vf(n)),t.buffers.color.setClear(iu.r,iu.g,iu.b,M,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,M=1){o.set(x),a=M,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,g(o,a)},render:p,addToRenderList:_,dispose:m}}function gS(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(I,k,z,N,W){let $=!1,H=f(I,N,z,k);r!==H&&(r=H,c(r.object)),$=d(I,N,z,W),$&&p(I,N,z,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,b(I,k,z,N),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function f(I,k,z,N){let W=N.wireframe===!0,$=i[k.id];$===void 0&&($={},i[k.id]=$);let H=I.isInstancedMesh===!0?I.id:0,le=$[H];le===void 0&&(le={},$[H]=le);let J=le[z.id];J===void 0&&(J={},le[z.id]=J);let Q=J[W];return Q===void 0&&(Q=h(l()),J[W]=Q),Q}function h(I){let k=[],z=[],N=[];for(let W=0;W<t;W++)k[W]=0,z[W]=0,N[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:z,attributeDivisors:N,object:I,attributes:{},index:null}}function d(I,k,z,N){let W=r.attributes,$=k.attributes,H=0,le=z.getAttributes();for(let J in le)if(le[J].location>=0){let ie=W[J],fe=$[J];if(fe===void 0&&(J==="instanceMatrix"&&I.instanceMatrix&&(fe=I.instanceMatrix),J==="instanceColor"&&I.instanceColor&&(fe=I.instanceColor)),ie===void 0||ie.attribute!==fe||fe&&ie.data!==fe.data)return!0;H++}return r.attributesNum!==H||r.index!==N}function p(I,k,z,N){let W={},$=k.attributes,H=0,le=z.getAttributes();for(let J in le)if(le[J].location>=0){let ie=$[J];ie===void 0&&(J==="instanceMatrix"&&I.instanceMatrix&&(ie=I.instanceMatrix),J==="instanceColor"&&I.instanceColor&&(ie=I.instanceColor));let fe={};fe.attribute=ie,ie&&ie.data&&(fe.data=ie.data),W[J]=fe,H++}r.attributes=W,r.attributesNum=H,r.index=N}function _(){let I=r.newAttributes;for(let k=0,z=I.length;k<z;k++)I[k]=0}function g(I){m(I,0)}function m(I,k){let z=r.newAttributes,N=r.enabledAttributes,W=r.attributeDivisors;z[I]=1,N[I]===0&&(n.enableVertexAttribArray(I),N[I]=1),W[I]!==k&&(n.vertexAttribDivisor(I,k),W[I]=k)}function x(){let I=r.newAttributes,k=r.enabledAttributes;for(let z=0,N=k.length;z<N;z++)k[z]!==I[z]&&(n.disableVertexAttribArray(z),k[z]=0)}function M(I,k,z,N,W,$,H){H===!0?n.vertexAttribIPointer(I,k,z,W,$):n.vertexAttribPointer(I,k,z,N,W,$)}function b(I,k,z,N){_();let W=N.attributes,$=z.getAttributes(),H=k.defaultAttributeValues;for(let le in $){let J=$[le];if(J.location>=0){let Q=W[le];if(Q===void 0&&(le==="instanceMatrix"&&I.instanceMatrix&&(Q=I.instanceMatrix),le==="instanceColor"&&I.instanceColor&&(Q=I.instanceColor)),Q!==void 0){let ie=Q.normalized,fe=Q.itemSize,he=e.get(Q);if(he===void 0)continue;let ee=he.buffer,me=he.type,ge=he.bytesPerElement,Se=me===n.INT||me===n.UNSIGNED_INT||Q.gpuType===yc;if(Q.isInterleavedBufferAttribute){let xe=Q.data,Ve=xe.isInterleavedBuffer===!0?xe.stride:xe.itemSize,Xe=Q.offset;if(xe.isInstancedInterleavedBuffer||xe.isInstancedBufferAttribute){for(let Ne=0;Ne<J.locationSize;Ne++)m(J.location+Ne,xe.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=xe.meshPerAttribute*xe.count)}else for(let Ne=0;Ne<J.locationSize;Ne++)g(J.location+Ne);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Ne=0;Ne<J.locationSize;Ne++)M(J.location+Ne,fe/J.locationSize,me,ie,Ve*ge,(Xe+fe/J.locationSize*Ne)*ge,Se)}else{if(Q.isInstancedBufferAttribute){for(let xe=0;xe<J.locationSize;xe++)m(J.location+xe,Q.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let xe=0;xe<J.locationSize;xe++)g(J.location+xe);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let xe=0;xe<J.locationSize;xe++)M(J.location+xe,fe/J.locationSize,me,ie,fe*ge,fe/J.locationSize*xe*ge,Se)}}else if(H!==void 0){let ie=H[le];if(ie!==void 0)switch(ie.length){case 2:n.vertexAttrib2fv(J.location,ie);break;case 3:n.vertexAttrib3fv(J.location,ie);break;case 4:n.vertexAttrib4fv(J.location,ie);break;default:n.vertexAttrib1fv(J.location,ie)}}}}x()}function C(){U();for(let I in i){let k=i[I];for(let z in k){let N=k[z];for(let W in N){let $=N[W];for(let H in $)u($[H].object),delete $[H];delete N[W]}}delete i[I]}}function A(I){if(i[I.id]===void 0)return;let k=i[I.id];for(let z in k){let N=k[z];for(let W in N){let $=N[W];for(let H in $)u($[H].object),delete $[H];delete N[W]}}delete i[I.id]}function v(I){for(let k in i){let z=i[k];for(let N in z){let W=z[N];if(W[I.id]===void 0)continue;let $=W[I.id];for(let H in $)u($[H].object),delete $[H];delete W[I.id]}}}function E(I){for(let k in i){let z=i[k],N=I.isInstancedMesh===!0?I.id:0,W=z[N];if(W!==void 0){for(let $ in W){let H=W[$];for(let le in H)u(H[le].object),delete H[le];delete W[$]}delete z[N],Object.keys(z).length===0&&delete i[k]}}}function U(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:L,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfObject:E,releaseStatesOfProgram:v,initAttributes:_,enableAttribute:g,disableUnusedAttributes:x}}function _S(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let d=0;d<u;d++)h+=c[d];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function xS(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==fi&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let E=v===zi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==hi&&v!==ki&&!E&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ye("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Ye("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Ye("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),M=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:p,maxTextureSize:_,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:x,maxVaryings:M,maxFragmentUniforms:b,maxSamples:C,samples:A}}function vS(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Ui,a=new et,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let d=f.length!==0||h||i!==0||s;return s=h,i=f.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,d){let p=f.clippingPlanes,_=f.clipIntersection,g=f.clipShadows,m=n.get(f);if(!s||p===null||p.length===0||r&&!g)r?u(null):c();else{let x=r?0:i,M=x*4,b=m.clippingState||null;l.value=b,b=u(p,h,M,d);for(let C=0;C!==M;++C)b[C]=t[C];m.clippingState=b,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(f,h,d,p){let _=f!==null?f.length:0,g=null;if(_!==0){if(g=l.value,p!==!0||g===null){let m=d+_*4,x=h.matrixWorldInverse;a.getNormalMatrix(x),(g===null||g.length<m)&&(g=new Float32Array(m));for(let M=0,b=d;M!==_;++M,b+=4)o.copy(f[M]).applyMatrix4(x,a),o.normal.toArray(g,b),g[b+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,g}}var Fa=class extends li{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new _a(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new fo(5,5,5),r=new Mi({name:"CubemapFromEquirect",uniforms:Sr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Bn,blending:vr});r.uniforms.tEquirect.value=t;let o=new Mt(s,r),a=t.minFilter;return t.minFilter===bs&&(t.minFilter=On),new go(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},xg=256,yS=3,bS=20,Vg=256,Hg=16,MS=3,SS=new G,wS=new rt,ru=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new go(1,10,null),this._boxMesh=new Mt(new fo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=SS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,_=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(e.background=l.getClearColor(wS));let g=new go(i,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=d,l.autoClearStencil=p,e.background=_,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=bg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=yg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(xg,dg(e))}_fromTexture(e,t){e.mapping===br||e.mapping===vo?this._setSize(e.image.length===0?xg:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=vg(e,!1,!1),i=Math.log2(e)-yS;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=vg(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===br||e.mapping===vo?(this._cubemapMaterial===null&&(this._cubemapMaterial=bg()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=yg()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=ES(),this._integrationMaterial=TS());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Hg);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-MS)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Vg*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=AS());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function vg(n,e,t){return new Fa(n,{minFilter:bs,generateMipmaps:e,type:zi,colorSpace:aa,depthBuffer:t})}function Ua(n,e,t){return new Mi({name:n,uniforms:e,vertexShader:lt.cube_vert,fragmentShader:t,side:Bn,blending:vr,depthTest:!1,depthWrite:!1})}function ES(){return Ua("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Vg}u

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
	`)}function TS(){return Ua("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Hg}},`

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
	`)}function AS(){return Ua("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${bS}
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
	`)}function yg(){return Ua("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function bg(){return Ua("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function CS(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,d=!1){return h==null?null:d?o(h):r(h)}function r(h){if(h&&h.isTexture){let d=h.mapping;if(d===_c||d===xc)if(e.has(h)){let p=e.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let _=new Fa(p.height);return _.fromEquirectangularTexture(n,h),e.set(h,_),h.addEventListener("dispose",c),a(_.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let d=h.mapping,p=d===_c||d===xc,_=d===br||d===vo;if(p||_){let g=t.get(h),m=g!==void 0?g.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return i===null&&(i=new ru(n)),g=p?i.fromEquirectangular(h,g):i.fromCubemap(h,g),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),g.texture;if(g!==void 0)return g.texture;{let x=h.image;return p&&x&&x.height>0||_&&x&&l(x)?(i===null&&(i=new ru(n)),g=p?i.fromEquirectangular(h):i.fromCubemap(h),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),h.addEventListener("dispose",u),g.texture):null}}}return h}function a(h,d){return d===_c?h.mapping=br:d===xc&&(h.mapping=vo),h}function l(h){let d=0,p=6;for(let _=0;_<p;_++)h[_]!==void 0&&d++;return d===p}function c(h){let d=h.target;d.removeEventListener("dispose",c);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function u(h){let d=h.target;d.removeEventListener("dispose",u);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function RS(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&ra("WebGLRenderer: "+i+" extension not supported."),s}}}function PS(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let g in p.attributes)e.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let _=r.get(p);_&&(e.remove(_),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),t.memory.geometries++),_}function u(p){let _=p.attributes;for(let g in _)e.update(_[g],n.ARRAY_BUFFER)}function f(p){let _=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let x=_!==null?_.array.length:g.array.length/3-1,M=g.count>=65535?ma:pa,b=new M(Math.ceil(x/3)*6,1),C=b.array;if(_!==null){let v=_.array;m=_.version;for(let E=0,U=0;E<x;E+=3){let L=v[E+0],I=v[E+1],k=v[E+2];C[U++]=L,C[U++]=I,C[U++]=I,C[U++]=k,C[U++]=k,C[U++]=L}}else{m=g.version;for(let v=0,E=0;v<x;v+=3){let U=v+0,L=v+1,I=v+2;C[E++]=U,C[E++]=L,C[E++]=L,C[E++]=I,C[E++]=I,C[E++]=U}}b.version=m;let A=r.get(p);A&&e.remove(A),r.set(p,b)}function h(p){let _=r.get(p);if(_){let g=p.index;g!==null&&_.version<g.version&&f(p)}else f(p);return r.get(p)}function d(){for(let p in s){let _=s[p].deref();_!==void 0&&l(_)}}return{get:c,update:u,getWireframeAttribute:h,dispose:d}}function IS(n,e,t){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,h){n.drawElements(i,h,r,f*o),t.update(h,i,1)}function c(f,h,d){d!==0&&(n.drawElementsInstanced(i,h,r,f*o,d),t.update(h,i,d))}function u(f,h,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,d);let _=0;for(let g=0;g<d;g++)_+=h[g];t.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function LS(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:Qe("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function DS(n,e,t){let i=new WeakMap,s=new Xt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==f){let U=function(){v.dispose(),i.delete(a),a.removeEventListener("dispose",U)};h!==void 0&&h.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],M=0;d===!0&&(M=1),p===!0&&(M=2),_===!0&&(M=3);let b=a.attributes.position.count*M,C=1;b>e.maxTextureSize&&(C=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let A=new Float32Array(b*C*4*f),v=new ha(A,b,C,f);v.type=ki,v.needsUpdate=!0;let E=M*4;for(let L=0;L<f;L++){let I=g[L],k=m[L],z=x[L],N=b*C*4*L;for(let W=0;W<I.count;W++){let $=W*E;d===!0&&(s.fromBufferAttribute(I,W),A[N+$+0]=s.x,A[N+$+1]=s.y,A[N+$+2]=s.z,A[N+$+3]=0),p===!0&&(s.fromBufferAttribute(k,W),A[N+$+4]=s.x,A[N+$+5]=s.y,A[N+$+6]=s.z,A[N+$+7]=0),_===!0&&(s.fromBufferAttribute(z,W),A[N+$+8]=s.x,A[N+$+9]=s.y,A[N+$+10]=s.z,A[N+$+11]=z.itemSize===4?s.w:1)}}h={count:f,texture:v,size:new xt(b,C)},i.set(a,h),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let _=0;_<c.length;_++)d+=c[_];let p=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function NS(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,h=e.get(c,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var FS={[gf]:"LINEAR_TONE_MAPPING",[_f]:"REINHARD_TONE_MAPPING",[xf]:"CINEON_TONE_MAPPING",[vf]:"ACES_FILMIC_TONE_MAPPING",[bf]:"AGX_TONE_MAPPING",[Mf]:"NEUTRAL_TONE_MAPPING",[yf]:"CUSTOM_TONE_MAPPING"};function US(n,e,t,i,s,r){let o=new li(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new on;u.setAttribute("position",new rn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new rn([0,2,0,0,2,0],2));let f=new ic({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new Mt(u,f),d=new mo(-1,1,1,-1,0,1),p=null,_=null,g=!1,m,x=null,M=[],b=!1;this.setSize=function(C,A){o.setSize(C,A),a!==null&&a.setSize(C,A),l!==null&&l.setSize(C,A);for(let v=0;v<M.length;v++){let E=M[v];E.setSize&&E.setSize(C,A)}},this.setEffects=function(C){M=C,b=M.length>0&&M[0].isRenderPass===!0;let A=o.width,v=o.height;M.length>0&&a===null&&(a=new li(A,v,{type:zi,depthBuffer:!1,stencilBuffer:!1}),l=new li(A,v,{type:zi,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&M.some(U=>U.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new ys(A,v),r===!0&&(c.format=Ms,c.type=Mr)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let U=0;U<M.length;U++){let L=M[U];L.setSize&&L.setSize(A,v),E&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(C,A){if(g||C.toneMapping===ts&&M.length===0)return!1;if(x=A,A!==null){let v=A.width,E=A.height;(o.width!==v||o.height!==E)&&this.setSize(v,E)}return b===!1&&C.setRenderTarget(o),m=C.toneMapping,C.toneMapping=ts,!0},this.hasRenderPass=function(){return b},this.end=function(C,A){C.toneMapping=m,g=!0;let v=o,E=a;for(let U=0;U<M.length;U++){let L=M[U];L.enabled!==!1&&(L.render(C,E,v,A),L.needsSwap!==!1&&(v=E,E=E===a?l:a))}if(p!==C.outputColorSpace||_!==C.toneMapping){p=C.outputColorSpace,_=C.toneMapping,f.defines={},pt.getTransfer(p)===Tt&&(f.defines.SRGB_TRANSFER="");let U=FS[_];U&&(f.defines[U]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=v.texture,C.setRenderTarget(x),C.render(h,d),x=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var Gg=new ei,Wg=new ys(1,1),Xg=new xa(1),qg=new ha,$g=new Ql,Yg=new _a,Mg=[],Sg=[],wg=new Float32Array(16),Eg=new Float32Array(9),Tg=new Float32Array(4);function Mo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=Mg[s];if(r===void 0&&(r=new Float32Array(s),Mg[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function wn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function En(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function au(n,e){let t=Sg[e];t===void 0&&(t=new Int32Array(e),Sg[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function OS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function BS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wn(t,e))return;n.uniform2fv(this.addr,e),En(t,e)}}function kS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(wn(t,e))return;n.uniform3fv(this.addr,e),En(t,e)}}function zS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wn(t,e))return;n.uniform4fv(this.addr,e),En(t,e)}}function VS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),En(t,e)}else{if(wn(t,i))return;Tg.set(i),n.uniformMatrix2fv(this.addr,!1,Tg),En(t,i)}}function HS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),En(t,e)}else{if(wn(t,i))return;Eg.set(i),n.uniformMatrix3fv(this.addr,!1,Eg),En(t,i)}}function GS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),En(t,e)}else{if(wn(t,i))return;wg.set(i),n.uniformMatrix4fv(this.addr,!1,wg),En(t,i)}}function WS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function XS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wn(t,e))return;n.uniform2iv(this.addr,e),En(t,e)}}function qS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(wn(t,e))return;n.uniform3iv(this.addr,e),En(t,e)}}function $S(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wn(t,e))return;n.uniform4iv(this.addr,e),En(t,e)}}function YS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function ZS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wn(t,e))return;n.uniform2uiv(this.addr,e),En(t,e)}}function JS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(wn(t,e))return;n.uniform3uiv(this.addr,e),En(t,e)}}function KS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wn(t,e))return;n.uniform4uiv(this.addr,e),En(t,e)}}function lu(n){return n.version===0&&(n.compareFunction=Of,n.needsUpdate=!0),n}function jS(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=lu(Wg):r=Gg,t.setTexture2D(e||r,s)}function QS(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||$g,s)}function ew(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=lu(Xg):r=Yg,t.setTextureCube(e||r,s)}function tw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||qg,s)}function nw(n){switch(n){case 5126:return OS;case 35664:return BS;case 35665:return kS;case 35666:return zS;case 35674:return VS;case 35675:return HS;case 35676:return GS;case 5124:case 35670:return WS;case 35667:case 35671:return XS;case 35668:case 35672:return qS;case 35669:case 35673:return $S;case 5125:return YS;case 36294:return ZS;case 36295:return JS;case 36296:return KS;case 35678:case 36198:case 36298:case 36306:case 35682:return jS;case 35679:case 36299:case 36307:return QS;case 35680:case 36300:case 36308:case 36293:return ew;case 36289:case 36303:case 36311:case 36292:return tw}}function iw(n,e){n.uniform1fv(this.addr,e)}function sw(n,e){let t=Mo(e,this.size,2);n.uniform2fv(this.addr,t)}function rw(n,e){let t=Mo(e,this.size,3);n.uniform3fv(this.addr,t)}function ow(n,e){let t=Mo(e,this.size,4);n.uniform4fv(this.addr,t)}function aw(n,e){let t=Mo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function lw(n,e){let t=Mo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function cw(n,e){let t=Mo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function uw(n,e){n.uniform1iv(this.addr,e)}function hw(n,e){n.uniform2iv(this.addr,e)}function fw(n,e){n.uniform3iv(this.addr,e)}function dw(n,e){n.uniform4iv(this.addr,e)}function pw(n,e){n.uniform1uiv(this.addr,e)}function mw(n,e){n.uniform2uiv(this.addr,e)}function gw(n,e){n.uniform3uiv(this.addr,e)}function _w(n,e){n.uniform4uiv(this.addr,e)}function xw(n,e,t){let i=this.cache,s=e.length,r=au(t,s);wn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=lu(Wg):o=Gg;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function vw(n,e,t){let i=this.cache,s=e.length,r=au(t,s);wn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||$g,r[o])}function yw(n,e,t){let i=this.cache,s=e.length,r=au(t,s);wn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=lu(Xg):o=Yg;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function bw(n,e,t){let i=this.cache,s=e.length,r=au(t,s);wn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||qg,r[o])}function Mw(n){switch(n){case 5126:return iw;case 35664:return sw;case 35665:return rw;case 35666:return ow;case 35674:return aw;case 35675:return lw;case 35676:return cw;case 5124:case 35670:return uw;case 35667:case 35671:return hw;case 35668:case 35672:return fw;case 35669:case 35673:return dw;case 5125:return pw;case 36294:return mw;case 36295:return gw;case 36296:return _w;case 35678:case 36198:case 36298:case 36306:case 35682:return xw;case 35679:case 36299:case 36307:return vw;case 35680:case 36300:case 36308:case 36293:return yw;case 36289:case 36303:case 36311:case 36292:return bw}}var $f=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=nw(t.type)}},Yf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Mw(t.type)}},Zf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Xf=/(\w+)(\])?(\[|\.)?/g;function Ag(n,e){n.seq.push(e),n.map[e.id]=e}function Sw(n,e,t){let i=n.name,s=i.length;for(Xf.lastIndex=0;;){let r=Xf.exec(i),o=Xf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Ag(t,c===void 0?new $f(a,n,e):new Yf(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new Zf(a),Ag(t,f)),t=f}}}var bo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);Sw(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function Cg(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var ww=37297,Ew=0;function Tw(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Rg=new et;function Aw(n){pt._getMatrix(Rg,pt.workingColorSpace,n);let e=`mat3( ${Rg.elements.map(t=>t.toFixed(4))} )`;switch(pt.getTransfer(n)){case la:return[e,"LinearTransferOETF"];case Tt:return[e,"sRGBTransferOETF"];default:return Ye("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Pg(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+Tw(n.getShaderSource(e),a)}else return r}function Cw(n,e){let t=Aw(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Rw={[gf]:"Linear",[_f]:"Reinhard",[xf]:"Cineon",[vf]:"ACESFilmic",[bf]:"AgX",[Mf]:"Neutral",[yf]:"Custom"};function Pw(n,e){let t=Rw[e];return t===void 0?(Ye("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var su=new G;function Iw(){pt.getLuminanceCoefficients(su);let n=su.x.toFixed(4),e=su.y.toFixed(4),t=su.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Lw(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Na).join(`
`)}function Dw(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function Nw(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Na(n){return n!==""}function Ig(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Lg(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var Fw=/^[ \t]*#include +<([\w\d./]+)>/gm;function Jf(n){return n.replace(Fw,Uw)}function Uw(n,e){let t=lt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Jf(t)}var Ow=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Dg(n){return n.replace(Ow,Bw)}function Bw(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Ng(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var kw={[Sa]:"SHADOWMAP_TYPE_PCF",[_o]:"SHADOWMAP_TYPE_VSM"};function zw(n){return kw[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Vw={[vo]:"ENVMAP_MODE_REFRACTION"};function Hw(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":Vw[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Gw={[mf]:"ENVMAP_BLENDING_MULTIPLY",[jm]:"ENVMAP_BLENDING_MIX",[Qm]:"ENVMAP_BLENDING_ADD"};function Ww(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":Gw[n.combine]||"ENVMAP_BLENDING_NONE"}function Xw(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=zw(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=Hw(t),f=Ww(t),h=Lw(t),d=Dw(r),p=s.createProgram(),_,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Na).join(`
`),_.length>0&&(_+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Na).join(`
`),g.length>0&&(g+=`
`)):(_=[Ng(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Na).join(`
`),g=[Ng(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ts?"#define TONE_MAPPING":"",t.toneMapping!==ts?lt.tonemapping_pars_fragment:"",t.toneMapping!==ts?Pw("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",lt.colorspace_pars_fragment,Cw("linearToOutputTexel",t.outputColorSpace),Iw(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Na).join(`
`)),o=Jf(o),o=Ig(o,t),o=Lg(o,t),a=Jf(a),a=Ig(a,t),a=Lg(a,t),o=Dg(o),a=Dg(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,_=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,g=["#define varying in",t.glslVersion===Bf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Bf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let x=m+_+o,M=m+g+a,b=Cg(s,s.VERTEX_SHADER,x),C=Cg(s,s.FRAGMENT_SHADER,M);s.attachShader(p,b),s.attachShader(p,C),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function A(L){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(p)||"",k=s.getShaderInfoLog(b)||"",z=s.getShaderInfoLog(C)||"",N=I.trim(),W=k.trim(),$=z.trim(),H=!0,le=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,b,C);else{let J=Pg(s,b,"vertex"),Q=Pg(s,C,"fragment");Qe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+N+`
`+J+`
`+Q)}else N!==""?Ye("WebGLProgram: Program Info Log:",N):(W===""||$==="")&&(le=!1);le&&(L.diagnostics={runnable:H,programLog:N,vertexShader:{log:W,prefix:_},fragmentShader:{log:$,prefix:g}})}s.deleteShader(b),s.deleteShader(C),v=new bo(s,p),E=Nw(s,p)}let v;this.getUniforms=function(){return v===void 0&&A(this),v};let E;this.getAttributes=function(){return E===void 0&&A(this),E};let U=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(p,ww)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Ew++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=C,this}var qw=0,Kf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new jf(e),t.set(e,i)),i}},jf=class{constructor(e){this.id=qw++,this.code=e,this.usedTimes=0}};function $w(n){return n===js||n===Ra||n===Pa}function Yw(n,e,t,i,s,r){let o=new fa,a=new Kf,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(v){return l.add(v),v===0?"uv":`uv${v}`}function p(v,E,U,L,I,k){let z=L.fog,N=I.geometry,W=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?L.environment:null,$=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,H=e.get(v.envMap||W,$),le=h[v.type],J=i.precision;v.precision!==null&&(J=i.getMaxPrecision(v.precision),J!==v.precision&&Ye("WebGLProgram.getParameters:",v.precision,"not supported, using",J,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ie=Q!==void 0?Q.length:0,fe=0;N.morphAttributes.position!==void 0&&(fe=1),N.morphAttributes.normal!==void 0&&(fe=2),N.morphAttributes.color!==void 0&&(fe=3);let he,ee,me,ge;if(le){let Ce=is[le];he=Ce.vertexShader,ee=Ce.fragmentShader}else{he=v.vertexShader,ee=v.fragmentShader;let Ce=a.getVertexShaderStage(v),st=a.getFragmentShaderStage(v);a.update(v,Ce,st),me=Ce.id,ge=st.id}let Se=n.getRenderTarget(),xe=n.state.buffers.depth.getReversed(),Ve=I.isInstancedMesh===!0,Xe=I.isBatchedMesh===!0,Ne=!!v.map,ct=!!v.matcap,ot=!!H,tt=ot&&H.isPMREMTexture===!0,Zt=!!v.aoMap,kt=!!v.lightMap,un=!!v.bumpMap&&v.wireframe===!1,Nt=!!v.normalMap,Cn=!!v.displacementMap,vt=!!v.emissiveMap,Mn=!!v.metalnessMap,Qt=!!v.roughnessMap,hn=v.anisotropy>0,B=v.clearcoat>0,Re=v.diffuseRoughness>0,$e=v.dispersion>0,it=v.retroreflectivity>0,we=v.iridescence>0,Ut=v.sheen>0,He=v.transmission>0,qe=hn&&!!v.anisotropyMap,R=B&&!!v.clearcoatMap,S=B&&!!v.clearcoatNormalMap,q=B&&!!v.clearcoatRoughnessMap,ue=Re&&!!v.diffuseRoughnessMap,oe=we&&!!v.iridescenceMap,ve=we&&!!v.iridescenceThicknessMap,ye=Ut&&!!v.sheenColorMap,te=Ut&&!!v.sheenRoughnessMap,se=!!v.specularMap,pe=!!v.specularColorMap,O=!!v.specularIntensityMap,re=He&&!!v.transmissionMap,ne=He&&!!v.thicknessMap,Ee=!!v.gradientMap,_e=!!v.alphaMap,Me=v.alphaTest>0,Ge=!!v.alphaHash,Je=!!v.extensions,ce=ts;v.toneMapped&&(Se===null||Se.isXRRenderTarget===!0)&&(ce=n.toneMapping);let Be=tt?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,Ke={shaderID:le,shaderType:v.type,shaderName:v.name,vertexShader:he,fragmentShader:ee,defines:v.defines,customVertexShaderID:me,customFragmentShaderID:ge,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:J,batching:Xe,batchingColor:Xe&&I._colorsTexture!==null,instancing:Ve,instancingColor:Ve&&I.instanceColor!==null,instancingMorph:Ve&&I.morphTexture!==null,outputColorSpace:Se===null?n.outputColorSpace:Se.isXRRenderTarget===!0?Se.texture.colorSpace:pt.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Ne,matcap:ct,envMap:ot,envMapMode:ot&&H.mapping,envMapPMREM:tt,envMapMaxLod:tt?Be.length-1:null,envMapSize:tt?Be[0].width:null,aoMap:Zt,lightMap:kt,bumpMap:un,normalMap:Nt,displacementMap:Cn,emissiveMap:vt,normalMapObjectSpace:Nt&&v.normalMapType===ng,normalMapTangentSpace:Nt&&v.normalMapType===If,packedNormalMap:Nt&&v.normalMapType===If&&$w(v.normalMap.format),metalnessMap:Mn,roughnessMap:Qt,anisotropy:hn,anisotropyMap:qe,clearcoat:B,clearcoatMap:R,clearcoatNormalMap:S,clearcoatRoughnessMap:q,diffuseRoughness:Re,diffuseRoughnessMap:ue,dispersion:$e,retroreflection:it,iridescence:we,iridescenceMap:oe,iridescenceThicknessMap:ve,sheen:Ut,sheenColorMap:ye,sheenRoughnessMap:te,specularMap:se,specularColorMap:pe,specularIntensityMap:O,transmission:He,transmissionMap:re,thicknessMap:ne,gradientMap:Ee,opaque:v.transparent===!1&&v.blending===xo&&v.alphaToCoverage===!1,alphaMap:_e,alphaTest:Me,alphaHash:Ge,combine:v.combine,mapUv:Ne&&d(v.map.channel),aoMapUv:Zt&&d(v.aoMap.channel),lightMapUv:kt&&d(v.lightMap.channel),bumpMapUv:un&&d(v.bumpMap.channel),normalMapUv:Nt&&d(v.normalMap.channel),displacementMapUv:Cn&&d(v.displacementMap.channel),emissiveMapUv:vt&&d(v.emissiveMap.channel),metalnessMapUv:Mn&&d(v.metalnessMap.channel),roughnessMapUv:Qt&&d(v.roughnessMap.channel),anisotropyMapUv:qe&&d(v.anisotropyMap.channel),clearcoatMapUv:R&&d(v.clearcoatMap.channel),clearcoatNormalMapUv:S&&d(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&d(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&d(v.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&d(v.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&d(v.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&d(v.sheenColorMap.channel),sheenRoughnessMapUv:te&&d(v.sheenRoughnessMap.channel),specularMapUv:se&&d(v.specularMap.channel),specularColorMapUv:pe&&d(v.specularColorMap.channel),specularIntensityMapUv:O&&d(v.specularIntensityMap.channel),transmissionMapUv:re&&d(v.transmissionMap.channel),thicknessMapUv:ne&&d(v.thicknessMap.channel),alphaMapUv:_e&&d(v.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Nt||hn),vertexNormals:!!N.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!N.attributes.uv&&(Ne||_e),fog:!!z,useFog:v.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||N.attributes.normal===void 0&&Nt===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:xe,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:fe,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:k.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:Ne&&v.map.isVideoTexture===!0&&pt.getTransfer(v.map.colorSpace)===Tt,decodeVideoTextureEmissive:vt&&v.emissiveMap.isVideoTexture===!0&&pt.getTransfer(v.emissiveMap.colorSpace)===Tt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Nn,flipSided:v.side===Bn,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Je&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Je&&v.extensions.multiDraw===!0||Xe)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return Ke.vertexUv1s=l.has(1),Ke.vertexUv2s=l.has(2),Ke.vertexUv3s=l.has(3),l.clear(),Ke}function _(v){let E=[];if(v.shaderID?E.push(v.shaderID):(E.push(v.customVertexShaderID),E.push(v.customFragmentShaderID)),v.defines!==void 0)for(let U in v.defines)E.push(U),E.push(v.defines[U]);return v.isRawShaderMaterial===!1&&(g(E,v),m(E,v),E.push(n.outputColorSpace)),E.push(v.customProgramCacheKey),E.join()}function g(v,E){v.push(E.precision),v.push(E.outputColorSpace),v.push(E.envMapMode),v.push(E.envMapPMREM),v.push(E.envMapMaxLod),v.push(E.envMapSize),v.push(E.mapUv),v.push(E.alphaMapUv),v.push(E.lightMapUv),v.push(E.aoMapUv),v.push(E.bumpMapUv),v.push(E.normalMapUv),v.push(E.displacementMapUv),v.push(E.emissiveMapUv),v.push(E.metalnessMapUv),v.push(E.roughnessMapUv),v.push(E.anisotropyMapUv),v.push(E.clearcoatMapUv),v.push(E.clearcoatNormalMapUv),v.push(E.clearcoatRoughnessMapUv),v.push(E.diffuseRoughnessMapUv),v.push(E.iridescenceMapUv),v.push(E.iridescenceThicknessMapUv),v.push(E.sheenColorMapUv),v.push(E.sheenRoughnessMapUv),v.push(E.specularMapUv),v.push(E.specularColorMapUv),v.push(E.specularIntensityMapUv),v.push(E.transmissionMapUv),v.push(E.thicknessMapUv),v.push(E.combine),v.push(E.fogExp2),v.push(E.sizeAttenuation),v.push(E.morphTargetsCount),v.push(E.numSunLights),v.push(E.numDirLights),v.push(E.numPointLights),v.push(E.numSpotLights),v.push(E.numSpotLightMaps),v.push(E.numHemiLights),v.push(E.numRectAreaLights),v.push(E.numSunLightShadows),v.push(E.numDirLightShadows),v.push(E.numPointLightShadows),v.push(E.numSpotLightShadows),v.push(E.numSpotLightShadowsWithMaps),v.push(E.numLightProbes),v.push(E.numLightProbeGrids),v.push(E.shadowMapType),v.push(E.toneMapping),v.push(E.numClippingPlanes),v.push(E.numClipIntersection),v.push(E.depthPacking)}function m(v,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function x(v){let E=h[v.type],U;if(E){let L=is[E];U=mg.clone(L.uniforms)}else U=v.uniforms;return U}function M(v,E){let U=u.get(E);return U!==void 0?++U.usedTimes:(U=new Xw(n,E,v,s),c.push(U),u.set(E,U)),U}function b(v){if(--v.usedTimes===0){let E=c.indexOf(v);c[E]=c[c.length-1],c.pop(),u.delete(v.cacheKey),v.destroy()}}function C(v){a.remove(v)}function A(){a.dispose()}return{getParameters:p,getProgramCacheKey:_,getUniforms:x,acquireProgram:M,releaseProgram:b,releaseShaderCache:C,programs:c,dispose:A}}function Zw(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function Jw(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Fg(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Ug(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function a(h,d,p,_,g,m){let x=n[e];return x===void 0?(x={id:h.id,object:h,geometry:d,material:p,materialVariant:o(h),groupOrder:_,renderOrder:h.renderOrder,z:g,group:m},n[e]=x):(x.id=h.id,x.object=h,x.geometry=d,x.material=p,x.materialVariant=o(h),x.groupOrder=_,x.renderOrder=h.renderOrder,x.z=g,x.group=m),e++,x}function l(h,d,p,_,g,m,x){x.reversedDepth===!0&&(g=-g);let M=a(h,d,p,_,g,m);p.transmission>0?i.push(M):p.transparent===!0?s.push(M):t.push(M)}function c(h,d,p,_,g,m){let x=a(h,d,p,_,g,m);p.transmission>0?i.unshift(x):p.transparent===!0?s.unshift(x):t.unshift(x)}function u(h,d){t.length>1&&t.sort(h||Jw),i.length>1&&i.sort(d||Fg),s.length>1&&s.sort(d||Fg)}function f(){for(let h=e,d=n.length;h<d;h++){let p=n[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function Kw(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Ug,n.set(i,[o])):s>=r.length?(o=new Ug,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function jw(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new G,color:new rt};break;case"SpotLight":t={position:new G,direction:new G,color:new rt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new G,color:new rt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new G,skyColor:new rt,groundColor:new rt};break;case"RectAreaLight":t={color:new rt,position:new G,halfWidth:new G,halfHeight:new G};break}return n[e.id]=t,t}}}function Qw(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var e1=0;function t1(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function n1(n){let e=new jw,t=Qw(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new G);let s=new G,r=new yt,o=new yt;function a(c){let u=0,f=0,h=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let d=0,p=0,_=0,g=0,m=0,x=0,M=0,b=0,C=0,A=0,v=0,E=0,U=0,L=0;c.sort(t1);for(let k=0,z=c.length;k<z;k++){let N=c[k],W=N.color,$=N.intensity,H=N.distance,le=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===js?le=N.shadow.map.texture:le=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=W.r*$,f+=W.g*$,h+=W.b*$;else if(N.isLightProbe){for(let J=0;J<9;J++)i.probe[J].addScaledVector(N.sh.coefficients[J],$);L++}else if(N.isSunLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=ie,i.sunShadowMap[p]=le;let fe=Q.getViewportCount();for(let he=0;he<fe;he++)i.sunShadowMatrix[_+he]=Q.getMatrix(he),i.sunShadowCascade[_+he]=Q._cascadeData[he];_+=fe,p++}i.sun[d]=J,d++}else if(N.isDirectionalLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.directionalShadow[g]=ie,i.directionalShadowMap[g]=le,i.directionalShadowMatrix[g]=N.shadow.matrix,C++}i.directional[g]=J,g++}else if(N.isSpotLight){let J=e.get(N);J.position.setFromMatrixPosition(N.matrixWorld),J.color.copy(W).multiplyScalar($),J.distance=H,J.coneCos=Math.cos(N.angle),J.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),J.decay=N.decay,i.spot[x]=J;let Q=N.shadow;if(N.map&&(i.spotLightMap[E]=N.map,E++,Q.updateMatrices(N),N.castShadow&&U++),i.spotLightMatrix[x]=Q.matrix,N.castShadow){let ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.spotShadow[x]=ie,i.spotShadowMap[x]=le,v++}x++}else if(N.isRectAreaLight){let J=e.get(N);J.color.copy(W).multiplyScalar($),J.halfWidth.set(N.width*.5,0,0),J.halfHeight.set(0,N.height*.5,0),i.rectArea[M]=J,M++}else if(N.isPointLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),J.distance=N.distance,J.decay=N.decay,N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,i.pointShadow[m]=ie,i.pointShadowMap[m]=le,i.pointShadowMatrix[m]=N.shadow.matrix,A++}i.point[m]=J,m++}else if(N.isHemisphereLight){let J=e.get(N);J.skyColor.copy(N.color).multiplyScalar($),J.groundColor.copy(N.groundColor).multiplyScalar($),i.hemi[b]=J,b++}}M>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;let I=i.hash;(I.sunLength!==d||I.directionalLength!==g||I.pointLength!==m||I.spotLength!==x||I.rectAreaLength!==M||I.hemiLength!==b||I.numSunShadows!==p||I.numDirectionalShadows!==C||I.numPointShadows!==A||I.numSpotShadows!==v||I.numSpotMaps!==E||I.numLightProbes!==L)&&(i.sun.length=d,i.directional.length=g,i.spot.length=x,i.rectArea.length=M,i.point.length=m,i.hemi.length=b,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+E-U,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=L,I.sunLength=d,I.directionalLength=g,I.pointLength=m,I.spotLength=x,I.rectAreaLength=M,I.hemiLength=b,I.numSunShadows=p,I.numDirectionalShadows=C,I.numPointShadows=A,I.numSpotShadows=v,I.numSpotMaps=E,I.numLightProbes=L,i.version=e1++)}function l(c,u){let f=0,h=0,d=0,p=0,_=0,g=0,m=u.matrixWorldInverse;for(let x=0,M=c.length;x<M;x++){let b=c[x];if(b.isSunLight){let C=i.sun[f];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(m),f++}else if(b.isDirectionalLight){let C=i.directional[h];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),h++}else if(b.isSpotLight){let C=i.spot[p];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(m),C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),p++}else if(b.isRectAreaLight){let C=i.rectArea[_];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),_++}else if(b.isPointLight){let C=i.point[d];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(m),d++}else if(b.isHemisphereLight){let C=i.hemi[g];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:i}}function Og(n){let e=new n1(n),t=[],i=[],s=[];function r(f){u.camera=f,t.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):t.push(f)}function a(f){i.push(f)}function l(){e.setup(t),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){e.setupView(t,f)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function i1(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Og(n),e.set(s,[a])):r>=o.length?(a=new Og(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var s1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,r1=`uniform sampler2D shadow_pass;
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
}`,o1=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],a1=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],Bg=new yt,Da=new G,qf=new G;function l1(n,e,t){let i=new vs,s=new xt,r=new xt,o=new Xt,a=new sc,l=new rc,c={},u=t.maxTextureSize,f={[Si]:Bn,[Bn]:Si,[Nn]:Nn},h=new Mi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new xt},radius:{value:4}},vertexShader:s1,fragmentShader:r1}),d=h.clone();d.defines.HORIZONTAL_PASS=1;let p=new on;p.setAttribute("position",new mt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Mt(p,h),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Sa;let m=this.type;this.render=function(A,v,E){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||A.length===0)return;this.type===Dm&&(Ye("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Sa);let U=n.getRenderTarget(),L=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),k=n.state;k.setBlending(vr),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let z=m!==this.type;z&&v.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(W=>W.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,W=A.length;N<W;N++){let $=A[N],H=$.shadow;if(H===void 0){Ye("WebGLShadowMap:",$,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let le=H.getFrameExtents();s.multiply(le),r.copy(H.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,H.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,H.mapSize.y=r.y));let J=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=J,H.map===null||z===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===_o){if($.isPointLight){Ye("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new li(s.x,s.y,{format:js,type:zi,minFilter:On,magFilter:On,generateMipmaps:!1}),H.map.texture.name=$.name+".shadowMap",H.map.depthTexture=new ys(s.x,s.y,ki),H.map.depthTexture.name=$.name+".shadowMapDepth",H.map.depthTexture.format=xs,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=_n,H.map.depthTexture.magFilter=_n}else $.isPointLight?(H.map=new Fa(s.x),H.map.depthTexture=new xa(s.x,Bi)):(H.map=new li(s.x,s.y),H.map.depthTexture=new ys(s.x,s.y,Bi)),H.map.depthTexture.name=$.name+".shadowMap",H.map.depthTexture.format=xs,this.type===Sa?(H.map.depthTexture.compareFunction=J?Uf:Ff,H.map.depthTexture.minFilter=On,H.map.depthTexture.magFilter=On):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=_n,H.map.depthTexture.magFilter=_n);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();$.isPointLight!==!0&&H.updateMatrices($,E);let ie=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:E.layers;for(let fe=0;fe<Q;fe++){let he=H.getCamera(fe);if($.isPointLight){let ee=H.camera,me=H.matrix,ge=$.distance||ee.far;ge!==ee.far&&(ee.far=ge,ee.updateProjectionMatrix()),Da.setFromMatrixPosition($.matrixWorld),ee.position.copy(Da),qf.copy(ee.position),qf.add(o1[fe]),ee.up.copy(a1[fe]),ee.lookAt(qf),ee.updateMatrixWorld(),me.makeTranslation(-Da.x,-Da.y,-Da.z),Bg.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Bg,ee.coordinateSystem,ee.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,fe),n.clear();else{fe===0&&(n.setRenderTarget(H.map),n.clear());let ee=H.getViewport(fe);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),k.viewport(o)}i=H.getFrustum(fe),b(v,E,he,$,ie,this.type)}H.isPointLightShadow!==!0&&this.type===_o&&x(H,E),H.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(U,L,I)};function x(A,v){let E=e.update(_);h.defines.VSM_SAMPLES!==A.blurSamples&&(h.defines.VSM_SAMPLES=A.blurSamples,d.defines.VSM_SAMPLES=A.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),A.mapPass===null?A.mapPass=new li(s.x,s.y,{format:js,type:zi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),h.uniforms.shadow_pass.value=A.map.depthTexture,h.uniforms.resolution.value.set(A.map.width,A.map.height),h.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(v,null,E,h,_,null),d.uniforms.shadow_pass.value=A.mapPass.texture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(v,null,E,d,_,null)}function M(A,v,E,U){let L=null,I=E.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(I!==void 0)L=I;else if(L=E.isPointLight===!0?l:a,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let k=L.uuid,z=v.uuid,N=c[k];N===void 0&&(N={},c[k]=N);let W=N[z];W===void 0&&(W=L.clone(),N[z]=W,v.addEventListener("dispose",C)),L=W}if(L.visible=v.visible,L.wireframe=v.wireframe,U===_o?L.side=v.shadowSide!==null?v.shadowSide:v.side:L.side=v.shadowSide!==null?v.shadowSide:f[v.side],L.alphaMap=v.alphaMap,L.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,L.map=v.map,L.clipShadows=v.clipShadows,L.clippingPlanes=v.clippingPlanes,L.clipIntersection=v.clipIntersection,L.displacementMap=v.displacementMap,L.displacementScale=v.displacementScale,L.displacementBias=v.displacementBias,L.wireframeLinewidth=v.wireframeLinewidth,L.linewidth=v.linewidth,E.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let k=n.properties.get(L);k.light=E}return L}function b(A,v,E,U,L,I){if(A.visible===!1)return;if(A.layers.test(L)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&I===_o)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,A.matrixWorld);let N=e.update(A),W=A.material;if(Array.isArray(W)){let $=N.groups;for(let H=0,le=$.length;H<le;H++){let J=$[H],Q=W[J.materialIndex];if(Q&&Q.visible){let ie=M(A,Q,U,I);A.onBeforeShadow(n,A,v,E,N,ie,J),n.renderBufferDirect(E,null,N,ie,A,J),A.onAfterShadow(n,A,v,E,N,ie,J)}}}else if(W.visible){let $=M(A,W,U,I);A.onBeforeShadow(n,A,v,E,N,$,null),n.renderBufferDirect(E,null,N,$,A,null),A.onAfterShadow(n,A,v,E,N,$,null)}}let z=A.children;for(let N=0,W=z.length;N<W;N++)b(z[N],v,E,U,L,I)}function C(A){A.target.removeEventListener("dispose",C);for(let E in c){let U=c[E],L=A.target.uuid;L in U&&(U[L].dispose(),delete U[L])}}}function c1(n,e){function t(){let O=!1,re=new Xt,ne=null,Ee=new Xt(0,0,0,0);return{setMask:function(_e){ne!==_e&&!O&&(n.colorMask(_e,_e,_e,_e),ne=_e)},setLocked:function(_e){O=_e},setClear:function(_e,Me,Ge,Je,ce){ce===!0&&(_e*=Je,Me*=Je,Ge*=Je),re.set(_e,Me,Ge,Je),Ee.equals(re)===!1&&(n.clearColor(_e,Me,Ge,Je),Ee.copy(re))},reset:function(){O=!1,ne=null,Ee.set(-1,0,0,0)}}}function i(){let O=!1,re=!1,ne=null,Ee=null,_e=null;return{setReversed:function(Me){if(re!==Me){let Ge=e.get("EXT_clip_control");Me?Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.ZERO_TO_ONE_EXT):Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.NEGATIVE_ONE_TO_ONE_EXT),re=Me;let Je=_e;_e=null,this.setClear(Je)}},getReversed:function(){return re},setTest:function(Me){Me?xe(n.DEPTH_TEST):Ve(n.DEPTH_TEST)},setMask:function(Me){ne!==Me&&!O&&(n.depthMask(Me),ne=Me)},setFunc:function(Me){if(re&&(Me=fg[Me]),Ee!==Me){switch(Me){case Vl:n.depthFunc(n.NEVER);break;case Hl:n.depthFunc(n.ALWAYS);break;case Gl:n.depthFunc(n.LESS);break;case oo:n.depthFunc(n.LEQUAL);break;case Wl:n.depthFunc(n.EQUAL);break;case Xl:n.depthFunc(n.GEQUAL);break;case ao:n.depthFunc(n.GREATER);break;case ql:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ee=Me}},setLocked:function(Me){O=Me},setClear:function(Me){_e!==Me&&(_e=Me,re&&(Me=1-Me),n.clearDepth(Me))},reset:function(){O=!1,ne=null,Ee=null,_e=null,re=!1}}}function s(){let O=!1,re=null,ne=null,Ee=null,_e=null,Me=null,Ge=null,Je=null,ce=null;return{setTest:function(Be){O||(Be?xe(n.STENCIL_TEST):Ve(n.STENCIL_TEST))},setMask:function(Be){re!==Be&&!O&&(n.stencilMask(Be),re=Be)},setFunc:function(Be,Ke,Ce){(ne!==Be||Ee!==Ke||_e!==Ce)&&(n.stencilFunc(Be,Ke,Ce),ne=Be,Ee=Ke,_e=Ce)},setOp:function(Be,Ke,Ce){(Me!==Be||Ge!==Ke||Je!==Ce)&&(n.stencilOp(Be,Ke,Ce),Me=Be,Ge=Ke,Je=Ce)},setLocked:function(Be){O=Be},setClear:function(Be){ce!==Be&&(n.clearStencil(Be),ce=Be)},reset:function(){O=!1,re=null,ne=null,Ee=null,_e=null,Me=null,Ge=null,Je=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},f={},h={},d=new WeakMap,p=[],_=null,g=!1,m=null,x=null,M=null,b=null,C=null,A=null,v=null,E=new rt(0,0,0),U=0,L=!1,I=null,k=null,z=null,N=null,W=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,le=0,J=n.getParameter(n.VERSION);J.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(J)[1]),H=le>=1):J.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),H=le>=2);let Q=null,ie={},fe=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),ee=new Xt().fromArray(fe),me=new Xt().fromArray(he);function ge(O,re,ne,Ee){let _e=new Uint8Array(4),Me=n.createTexture();n.bindTexture(O,Me),n.texParameteri(O,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(O,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ge=0;Ge<ne;Ge++)O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,Ee,0,n.RGBA,n.UNSIGNED_BYTE,_e):n.texImage2D(re+Ge,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_e);return Me}let Se={};Se[n.TEXTURE_2D]=ge(n.TEXTURE_2D,n.TEXTURE_2D,1),Se[n.TEXTURE_CUBE_MAP]=ge(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Se[n.TEXTURE_2D_ARRAY]=ge(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Se[n.TEXTURE_3D]=ge(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),xe(n.DEPTH_TEST),o.setFunc(oo),un(!1),Nt(cf),xe(n.CULL_FACE),Zt(vr);function xe(O){u[O]!==!0&&(n.enable(O),u[O]=!0)}function Ve(O){u[O]!==!1&&(n.disable(O),u[O]=!1)}function Xe(O,re){return h[O]!==re?(n.bindFramebuffer(O,re),h[O]=re,O===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=re),O===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Ne(O,re){let ne=p,Ee=!1;if(O){ne=d.get(re),ne===void 0&&(ne=[],d.set(re,ne));let _e=O.textures;if(ne.length!==_e.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let Me=0,Ge=_e.length;Me<Ge;Me++)ne[Me]=n.COLOR_ATTACHMENT0+Me;ne.length=_e.length,Ee=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,Ee=!0);Ee&&n.drawBuffers(ne)}function ct(O){return _!==O?(n.useProgram(O),_=O,!0):!1}let ot={[yr]:n.FUNC_ADD,[Fm]:n.FUNC_SUBTRACT,[Um]:n.FUNC_REVERSE_SUBTRACT};ot[Om]=n.MIN,ot[Bm]=n.MAX;let tt={[km]:n.ZERO,[zm]:n.ONE,[Vm]:n.SRC_COLOR,[df]:n.SRC_ALPHA,[$m]:n.SRC_ALPHA_SATURATE,[Xm]:n.DST_COLOR,[Gm]:n.DST_ALPHA,[Hm]:n.ONE_MINUS_SRC_COLOR,[pf]:n.ONE_MINUS_SRC_ALPHA,[qm]:n.ONE_MINUS_DST_COLOR,[Wm]:n.ONE_MINUS_DST_ALPHA,[Ym]:n.CONSTANT_COLOR,[Zm]:n.ONE_MINUS_CONSTANT_COLOR,[Jm]:n.CONSTANT_ALPHA,[Km]:n.ONE_MINUS_CONSTANT_ALPHA};function Zt(O,re,ne,Ee,_e,Me,Ge,Je,ce,Be){if(O===vr){g===!0&&(Ve(n.BLEND),g=!1);return}if(g===!1&&(xe(n.BLEND),g=!0),O!==Nm){if(O!==m||Be!==L){if((x!==yr||C!==yr)&&(n.blendEquation(n.FUNC_ADD),x=yr,C=yr),Be)switch(O){case xo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case uf:n.blendFunc(n.ONE,n.ONE);break;case hf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case ff:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Qe("WebGLState: Invalid blending: ",O);break}else switch(O){case xo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case uf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case hf:Qe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ff:Qe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qe("WebGLState: Invalid blending: ",O);break}M=null,b=null,A=null,v=null,E.set(0,0,0),U=0,m=O,L=Be}return}_e=_e||re,Me=Me||ne,Ge=Ge||Ee,(re!==x||_e!==C)&&(n.blendEquationSeparate(ot[re],ot[_e]),x=re,C=_e),(ne!==M||Ee!==b||Me!==A||Ge!==v)&&(n.blendFuncSeparate(tt[ne],tt[Ee],tt[Me],tt[Ge]),M=ne,b=Ee,A=Me,v=Ge),(Je.equals(E)===!1||ce!==U)&&(n.blendColor(Je.r,Je.g,Je.b,ce),E.copy(Je),U=ce),m=O,L=!1}function kt(O,re){O.side===Nn?Ve(n.CULL_FACE):xe(n.CULL_FACE);let ne=O.side===Bn;re&&(ne=!ne),un(ne),O.blending===xo&&O.transparent===!1?Zt(vr):Zt(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let Ee=O.stencilWrite;a.setTest(Ee),Ee&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),vt(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?xe(n.SAMPLE_ALPHA_TO_COVERAGE):Ve(n.SAMPLE_ALPHA_TO_COVERAGE)}function un(O){I!==O&&(O?n.frontFace(n.CW):n.frontFace(n.CCW),I=O)}function Nt(O){O!==Im?(xe(n.CULL_FACE),O!==k&&(O===cf?n.cullFace(n.BACK):O===Lm?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ve(n.CULL_FACE),k=O}function Cn(O){O!==z&&(H&&n.lineWidth(O),z=O)}function vt(O,re,ne){O?(xe(n.POLYGON_OFFSET_FILL),(N!==re||W!==ne)&&(N=re,W=ne,o.getReversed()&&(re=-re,ne=-ne),n.polygonOffset(re,ne))):Ve(n.POLYGON_OFFSET_FILL)}function Mn(O){O?xe(n.SCISSOR_TEST):Ve(n.SCISSOR_TEST)}function Qt(O){O===void 0&&(O=n.TEXTURE0+$-1),Q!==O&&(n.activeTexture(O),Q=O)}function hn(O,re,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+$-1:ne=Q);let Ee=ie[ne];Ee===void 0&&(Ee={type:void 0,texture:void 0},ie[ne]=Ee),(Ee.type!==O||Ee.texture!==re)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(O,re||Se[O]),Ee.type=O,Ee.texture=re)}function B(){let O=ie[Q];O!==void 0&&O.type!==void 0&&(n.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Re(){try{n.compressedTexImage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function $e(){try{n.compressedTexImage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function it(){try{n.texSubImage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function we(){try{n.texSubImage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function Ut(){try{n.compressedTexSubImage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function He(){try{n.compressedTexSubImage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function qe(){try{n.texStorage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function R(){try{n.texStorage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function S(){try{n.texImage2D(...arguments)}catch(O){Qe("WebGLState:",O)}}function q(){try{n.texImage3D(...arguments)}catch(O){Qe("WebGLState:",O)}}function ue(O){return f[O]!==void 0?f[O]:n.getParameter(O)}function oe(O,re){f[O]!==re&&(n.pixelStorei(O,re),f[O]=re)}function ve(O){ee.equals(O)===!1&&(n.scissor(O.x,O.y,O.z,O.w),ee.copy(O))}function ye(O){me.equals(O)===!1&&(n.viewport(O.x,O.y,O.z,O.w),me.copy(O))}function te(O,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let Ee=ne.get(O);Ee===void 0&&(Ee=n.getUniformBlockIndex(re,O.name),n.uniformBlockBinding(re,Ee,Ee),ne.set(O,Ee))}function se(O,re,ne){let _e=c.get(re).get(O);l[_e]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,_e,ne),l[_e]=ne)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},Q=null,ie={},h={},l={},d=new WeakMap,p=[],_=null,g=!1,m=null,x=null,M=null,b=null,C=null,A=null,v=null,E=new rt(0,0,0),U=0,L=!1,I=null,k=null,z=null,N=null,W=null,ee.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:xe,disable:Ve,bindFramebuffer:Xe,drawBuffers:Ne,useProgram:ct,setBlending:Zt,setMaterial:kt,setFlipSided:un,setCullFace:Nt,setLineWidth:Cn,setPolygonOffset:vt,setScissorTest:Mn,activeTexture:Qt,bindTexture:hn,unbindTexture:B,compressedTexImage2D:Re,compressedTexImage3D:$e,texImage2D:S,texImage3D:q,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:qe,texStorage3D:R,texSubImage2D:it,texSubImage3D:we,compressedTexSubImage2D:Ut,compressedTexSubImage3D:He,scissor:ve,viewport:ye,reset:pe}}function u1(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new xt,u=new WeakMap,f=new Set,h,d=new WeakMap,p=new Set,_=new FinalizationRegistry(R=>p.delete(R)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(R,S){return g?new OffscreenCanvas(R,S):ua("canvas")}function x(R,S,q){let ue=1,oe=qe(R);if((oe.width>q||oe.height>q)&&(ue=q/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let ve=Math.floor(ue*oe.width),ye=Math.floor(ue*oe.height);h===void 0&&(h=m(ve,ye));let te=S?m(ve,ye):h;return te.width=ve,te.height=ye,te.getContext("2d").drawImage(R,0,0,ve,ye),Ye("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+ve+"x"+ye+")."),te}else return"data"in R&&Ye("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),R;return R}function M(R){return R.generateMipmaps}function b(R){n.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(R,S,q,ue,oe,ve=!1){if(R!==null){if(n[R]!==void 0)return n[R];Ye("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||Ye("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=S;if(S===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.R16_EXT),q===n.SHORT&&ye&&(te=ye.R16_SNORM_EXT)),S===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),S===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RG16_EXT),q===n.SHORT&&ye&&(te=ye.RG16_SNORM_EXT)),S===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),S===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),S===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),S===n.RGB&&(q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGB16_EXT),q===n.SHORT&&ye&&(te=ye.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),S===n.RGBA){let se=ve?la:pt.getTransfer(oe);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=se===Tt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGBA16_EXT),q===n.SHORT&&ye&&(te=ye.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function v(R,S){let q;return R?S===null||S===Bi||S===Mr?q=n.DEPTH24_STENCIL8:S===ki?q=n.DEPTH32F_STENCIL8:S===yo&&(q=n.DEPTH24_STENCIL8,Ye("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Bi||S===Mr?q=n.DEPTH_COMPONENT24:S===ki?q=n.DEPTH_COMPONENT32F:S===yo&&(q=n.DEPTH_COMPONENT16),q}function E(R,S){return M(R)===!0||R.isFramebufferTexture&&R.minFilter!==_n&&R.minFilter!==On?Math.log2(Math.max(S.width,S.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?S.mipmaps.length:1}function U(R){let S=new WeakRef(R);i.get(R).__ref=S,p.add(S),_.register(R,S,S)}function L(R){let S=i.get(R).__ref;S!==void 0&&(p.delete(S),_.unregister(S))}function I(R){z(R.target)}function k(R){N(R.target)}function z(R){R.removeEventListener("dispose",I),L(R),$(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&f.delete(R)}function N(R){R.removeEventListener("dispose",k),L(R),le(R)}function W(){for(let R of p){let S=R.deref();S!==void 0&&(S.isRenderTarget===!0?N(S):z(S))}p.clear(),f.clear()}function $(R){let S=i.get(R);if(S.__webglInit===void 0)return;let q=R.source,ue=d.get(q);if(ue){let oe=ue[S.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&H(R),Object.keys(ue).length===0&&d.delete(q)}i.remove(R)}function H(R){let S=i.get(R);n.deleteTexture(S.__webglTexture);let q=R.source,ue=d.get(q);delete ue[S.__cacheKey],o.memory.textures--}function le(R){let S=i.get(R);S.__depthDisposeCallback&&S.__depthDisposeCallback();let q=R.depthTexture;if(q&&q.renderTarget===R&&z(q),R.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(S.__webglFramebuffer[oe]))for(let ve=0;ve<S.__webglFramebuffer[oe].length;ve++)n.deleteFramebuffer(S.__webglFramebuffer[oe][ve]);else n.deleteFramebuffer(S.__webglFramebuffer[oe]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[oe])}else{if(Array.isArray(S.__webglFramebuffer))for(let oe=0;oe<S.__webglFramebuffer.length;oe++)n.deleteFramebuffer(S.__webglFramebuffer[oe]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let oe=0;oe<S.__webglColorRenderbuffer.length;oe++)S.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[oe]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ue=R.textures;for(let oe=0,ve=ue.length;oe<ve;oe++){let ye=i.get(ue[oe]);ye.__webglTexture&&(n.deleteTexture(ye.__webglTexture),o.memory.textures--),i.remove(ue[oe])}i.remove(R)}let J=0;function Q(){J=0}function ie(){return J}function fe(R){J=R}function he(){let R=J;return R>=s.maxTextures&&Ye("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,R}function ee(R){let S=[];return S.push(R.wrapS),S.push(R.wrapT),S.push(R.wrapR||0),S.push(R.magFilter),S.push(R.minFilter),S.push(R.anisotropy),S.push(R.internalFormat),S.push(R.format),S.push(R.type),S.push(R.generateMipmaps),S.push(R.mipmapsAutoUpdate),S.push(R.premultiplyAlpha),S.push(R.flipY),S.push(R.unpackAlignment),S.push(R.colorSpace),S.join()}function me(R,S){let q=i.get(R);if(R.isVideoTexture&&Ut(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let ue=R.image;if(ue===null)Ye("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Ye("WebGLRenderer: Texture marked for update but image is incomplete");else{kt(q,R,S);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+S)}function ge(R,S){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){kt(q,R,S);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+S)}function Se(R,S){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){kt(q,R,S);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+S)}function xe(R,S){let q=i.get(R);if(R.version>0&&q.__version!==R.version){un(q,R,S);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+S)}let Ve={[$l]:n.REPEAT,[Qi]:n.CLAMP_TO_EDGE,[Yl]:n.MIRRORED_REPEAT},Xe={[_n]:n.NEAREST,[eg]:n.NEAREST_MIPMAP_NEAREST,[wa]:n.NEAREST_MIPMAP_LINEAR,[On]:n.LINEAR,[vc]:n.LINEAR_MIPMAP_NEAREST,[bs]:n.LINEAR_MIPMAP_LINEAR},Ne={[ig]:n.NEVER,[Of]:n.ALWAYS,[sg]:n.LESS,[Ff]:n.LEQUAL,[rg]:n.EQUAL,[Uf]:n.GEQUAL,[og]:n.GREATER,[ag]:n.NOTEQUAL};function ct(R,S){if(S.type===ki&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===On||S.magFilter===vc||S.magFilter===wa||S.magFilter===bs||S.minFilter===On||S.minFilter===vc||S.minFilter===wa||S.minFilter===bs)&&Ye("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,Ve[S.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,Ve[S.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,Ve[S.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,Xe[S.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,Xe[S.minFilter]),S.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,Ne[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===_n||S.minFilter!==wa&&S.minFilter!==bs||S.type===ki&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function ot(R,S){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,S.addEventListener("dispose",I),U(S));let ue=S.source,oe=d.get(ue);oe===void 0&&(oe={},d.set(ue,oe));let ve=ee(S);if(ve!==R.__cacheKey){oe[ve]===void 0&&(oe[ve]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[ve].usedTimes++;let ye=oe[R.__cacheKey];ye!==void 0&&(oe[R.__cacheKey].usedTimes--,ye.usedTimes===0&&H(S)),R.__cacheKey=ve,R.__webglTexture=oe[ve].texture}return q}function tt(R,S,q){return Math.floor(Math.floor(R/q)/S)}function Zt(R,S,q,ue){let ve=R.updateRanges;if(ve.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,q,ue,S.data);else{ve.sort((O,re)=>O.start-re.start);let ye=0;for(let O=1;O<ve.length;O++){let re=ve[ye],ne=ve[O],Ee=re.start+re.count,_e=tt(ne.start,S.width,4),Me=tt(re.start,S.width,4);ne.start<=Ee+1&&_e===Me&&tt(ne.start+ne.count-1,S.width,4)===_e?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++ye,ve[ye]=ne)}ve.length=ye+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),se=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let O=0,re=ve.length;O<re;O++){let ne=ve[O],Ee=Math.floor(ne.start/4),_e=Math.ceil(ne.count/4),Me=Ee%S.width,Ge=Math.floor(Ee/S.width),Je=_e,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Me),t.pixelStorei(n.UNPACK_SKIP_ROWS,Ge),t.texSubImage2D(n.TEXTURE_2D,0,Me,Ge,Je,ce,q,ue,S.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,se),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function kt(R,S,q){let ue=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ue=n.TEXTURE_3D);let oe=ot(R,S),ve=S.source;t.bindTexture(ue,R.__webglTexture,n.TEXTURE0+q);let ye=i.get(ve);if(ve.version!==ye.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let ce=pt.getPrimaries(pt.workingColorSpace),Be=S.colorSpace===Ss?null:pt.getPrimaries(S.colorSpace),Ke=S.colorSpace===Ss||ce===Be?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ke)}t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let se=x(S.image,!1,s.maxTextureSize);se=He(S,se);let pe=r.convert(S.format,S.colorSpace),O=r.convert(S.type),re=A(S.internalFormat,pe,O,S.normalized,S.colorSpace,S.isVideoTexture);ct(ue,S);let ne,Ee=S.mipmaps,_e=S.isVideoTexture!==!0,Me=ye.__version===void 0||oe===!0,Ge=ve.dataReady,Je=E(S,se);if(S.isDepthTexture)re=v(S.format===Ms,S.type),Me&&(_e?t.texStorage2D(n.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,O,null));else if(S.isDataTexture)if(Ee.length>0){_e&&Me&&t.texStorage2D(n.TEXTURE_2D,Je,re,Ee[0].width,Ee[0].height);for(let ce=0,Be=Ee.length;ce<Be;ce++)ne=Ee[ce],_e?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,O,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,O,ne.data);S.generateMipmaps=!1}else _e?(Me&&t.texStorage2D(n.TEXTURE_2D,Je,re,se.width,se.height),Ge&&Zt(S,se,pe,O)):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,O,se.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){_e&&Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,re,Ee[0].width,Ee[0].height,se.depth);for(let ce=0,Be=Ee.length;ce<Be;ce++)if(ne=Ee[ce],S.format!==fi)if(pe!==null)if(_e){if(Ge)if(S.layerUpdates.size>0){let Ke=Wf(ne.width,ne.height,S.format,S.type);for(let Ce of S.layerUpdates){let st=ne.data.subarray(Ce*Ke/ne.data.BYTES_PER_ELEMENT,(Ce+1)*Ke/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Ce,ne.width,ne.height,1,pe,st)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,ne.data,0,0);else Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?Ge&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,O,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,pe,O,ne.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{_e&&Me&&t.texStorage2D(n.TEXTURE_2D,Je,re,Ee[0].width,Ee[0].height);for(let ce=0,Be=Ee.length;ce<Be;ce++)ne=Ee[ce],S.format!==fi?pe!==null?_e?Ge&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,O,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,O,ne.data)}else if(S.isDataArrayTexture)if(_e){if(Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,re,se.width,se.height,se.depth),Ge)if(S.layerUpdates.size>0){let ce=Wf(se.width,se.height,S.format,S.type);for(let Be of S.layerUpdates){let Ke=se.data.subarray(Be*ce/se.data.BYTES_PER_ELEMENT,(Be+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Be,se.width,se.height,1,pe,O,Ke)}S.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,pe,O,se.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,pe,O,se.data);else if(S.isData3DTexture)_e?(Me&&t.texStorage3D(n.TEXTURE_3D,Je,re,se.width,se.height,se.depth),Ge&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,pe,O,se.data)):t.texImage3D(n.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,pe,O,se.data);else if(S.isFramebufferTexture){if(Me)if(_e)t.texStorage2D(n.TEXTURE_2D,Je,re,se.width,se.height);else{let ce=se.width,Be=se.height;for(let Ke=0;Ke<Je;Ke++)t.texImage2D(n.TEXTURE_2D,Ke,re,ce,Be,0,pe,O,null),ce>>=1,Be>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),f.add(S),ce.onpaint=Be=>{let Ke=Be.changedElements;for(let Ce of f)Ke.includes(Ce.image)&&(Ce.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,se);else{let Ke=n.RGBA,Ce=n.RGBA,st=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Ke,Ce,st,se)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ee.length>0){if(_e&&Me){let ce=qe(Ee[0]);t.texStorage2D(n.TEXTURE_2D,Je,re,ce.width,ce.height)}for(let ce=0,Be=Ee.length;ce<Be;ce++)ne=Ee[ce],_e?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,pe,O,ne):t.texImage2D(n.TEXTURE_2D,ce,re,pe,O,ne);S.generateMipmaps=!1}else if(_e){if(Me){let ce=qe(se);t.texStorage2D(n.TEXTURE_2D,Je,re,ce.width,ce.height)}Ge&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,O,se)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,O,se);M(S)&&S.mipmapsAutoUpdate===!0&&b(ue),ye.__version=ve.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function un(R,S,q){if(S.image.length!==6)return;let ue=ot(R,S),oe=S.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+q);let ve=i.get(oe);if(oe.version!==ve.__version||ue===!0){t.activeTexture(n.TEXTURE0+q);let ye=pt.getPrimaries(pt.workingColorSpace),te=S.colorSpace===Ss?null:pt.getPrimaries(S.colorSpace),se=S.colorSpace===Ss||ye===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let pe=S.isCompressedTexture||S.image[0].isCompressedTexture,O=S.image[0]&&S.image[0].isDataTexture,re=[];for(let Ce=0;Ce<6;Ce++)!pe&&!O?re[Ce]=x(S.image[Ce],!0,s.maxCubemapSize):re[Ce]=O?S.image[Ce].image:S.image[Ce],re[Ce]=He(S,re[Ce]);let ne=re[0],Ee=r.convert(S.format,S.colorSpace),_e=r.convert(S.type),Me=A(S.internalFormat,Ee,_e,S.normalized,S.colorSpace),Ge=S.isVideoTexture!==!0,Je=ve.__version===void 0||ue===!0,ce=oe.dataReady,Be=E(S,ne);ct(n.TEXTURE_CUBE_MAP,S);let Ke;if(S.isDepthTexture){if(Me=v(S.format===Ms,S.type),Je)if(Ge)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Me,ne.width,ne.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,ne.width,ne.height,0,Ee,_e,null)}else if(pe){Ge&&Je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Me,ne.width,ne.height);for(let Ce=0;Ce<6;Ce++){Ke=re[Ce].mipmaps;for(let st=0;st<Ke.length;st++){let zt=Ke[st];S.format!==fi?Ee!==null?Ge?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,st,0,0,zt.width,zt.height,Ee,zt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,st,Me,zt.width,zt.height,0,zt.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,st,0,0,zt.width,zt.height,Ee,_e,zt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,st,Me,zt.width,zt.height,0,Ee,_e,zt.data)}}}else{if(Ke=S.mipmaps,Ge&&Je){Ke.length>0&&Be++;let Ce=qe(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Me,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(O){Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,re[Ce].width,re[Ce].height,Ee,_e,re[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,re[Ce].width,re[Ce].height,0,Ee,_e,re[Ce].data);for(let st=0;st<Ke.length;st++){let Xn=Ke[st].image[Ce].image;Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,st+1,0,0,Xn.width,Xn.height,Ee,_e,Xn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,st+1,Me,Xn.width,Xn.height,0,Ee,_e,Xn.data)}}else{Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Ee,_e,re[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,Ee,_e,re[Ce]);for(let st=0;st<Ke.length;st++){let zt=Ke[st];Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,st+1,0,0,Ee,_e,zt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,st+1,Me,Ee,_e,zt.image[Ce])}}}M(S)&&S.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),ve.__version=oe.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function Nt(R,S,q,ue,oe,ve){let ye=r.convert(q.format,q.colorSpace),te=r.convert(q.type),se=A(q.internalFormat,ye,te,q.normalized,q.colorSpace),pe=i.get(S),O=i.get(q);if(O.__renderTarget=S,!pe.__hasExternalTextures){let re=Math.max(1,S.width>>ve),ne=Math.max(1,S.height>>ve);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,ve,se,re,ne,S.depth,0,ye,te,null):t.texImage2D(oe,ve,se,re,ne,0,ye,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,oe,O.__webglTexture,0,it(S)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,oe,O.__webglTexture,ve),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Cn(R,S,q){if(n.bindRenderbuffer(n.RENDERBUFFER,R),S.depthBuffer){let ue=S.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,ve=v(S.stencilBuffer,oe),ye=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,it(S),ve,S.width,S.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,it(S),ve,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,ve,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ye,n.RENDERBUFFER,R)}else{let ue=S.textures;for(let oe=0;oe<ue.length;oe++){let ve=ue[oe],ye=r.convert(ve.format,ve.colorSpace),te=r.convert(ve.type),se=A(ve.internalFormat,ye,te,ve.normalized,ve.colorSpace);we(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,it(S),se,S.width,S.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,it(S),se,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,se,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function vt(R,S,q){let ue=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(S.depthTexture);oe.__renderTarget=S;let ve=ue?S.depthTexture.image[0]:S.depthTexture.image;(!oe.__webglTexture||ve.width!==S.width||ve.height!==S.height)&&(ve.width=S.width,ve.height=S.height,S.depthTexture.needsUpdate=!0),ue?xe(S.depthTexture,0):me(S.depthTexture,0);let ye=oe.__webglTexture,te=it(S),se=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,pe=S.depthTexture.format===Ms?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===xs)we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,ye,0);else if(S.depthTexture.format===Ms)we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Mn(R){let S=i.get(R),q=R.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==R.depthTexture){let ue=R.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ue){let oe=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),S.__depthDisposeCallback=oe}S.__boundDepthTexture=ue}if(R.depthTexture&&!S.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)vt(S.__webglFramebuffer[ue],R,ue);else R.texture.mipmaps.length>0?vt(S.__webglFramebuffer[0],R,0):vt(S.__webglFramebuffer,R,0);else if(q){S.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[ue]),S.__webglDepthbuffer[ue]===void 0)S.__webglDepthbuffer[ue]=n.createRenderbuffer(),Cn(S.__webglDepthbuffer[ue],R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=S.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ve)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),Cn(S.__webglDepthbuffer,R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ve)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Qt(R,S,q){let ue=i.get(R);S!==void 0&&Nt(ue.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&Mn(R)}function hn(R){let S=R.texture,q=i.get(R),ue=i.get(S);R.addEventListener("dispose",k),U(R);let oe=R.textures,ve=R.isWebGLCubeRenderTarget===!0,ye=oe.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=S.version,o.memory.textures++),ve){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(S.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let se=0;se<S.mipmaps.length;se++)q.__webglFramebuffer[te][se]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(S.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<S.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ye)for(let te=0,se=oe.length;te<se;te++){let pe=i.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&we(R)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let se=oe[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let pe=r.convert(se.format,se.colorSpace),O=r.convert(se.type),re=A(se.internalFormat,pe,O,se.normalized,se.colorSpace,R.isXRRenderTarget===!0),ne=it(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),Cn(q.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ve){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),ct(n.TEXTURE_CUBE_MAP,S);for(let te=0;te<6;te++)if(S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)Nt(q.__webglFramebuffer[te][se],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else Nt(q.__webglFramebuffer[te],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);M(S)?b(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let te=0,se=oe.length;te<se;te++){let pe=oe[te],O=i.get(pe),re=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(re=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,O.__webglTexture),ct(re,pe),Nt(q.__webglFramebuffer,R,pe,n.COLOR_ATTACHMENT0+te,re,0),M(pe)&&b(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),ct(te,S),S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)Nt(q.__webglFramebuffer[se],R,S,n.COLOR_ATTACHMENT0,te,se);else Nt(q.__webglFramebuffer,R,S,n.COLOR_ATTACHMENT0,te,0);M(S)?b(te):S.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Mn(R)}function B(R){let S=R.textures;for(let q=0,ue=S.length;q<ue;q++){let oe=S[q];if(M(oe)&&oe.mipmapsAutoUpdate===!0){let ve=C(R),ye=i.get(oe).__webglTexture;t.bindTexture(ve,ye),b(ve),t.unbindTexture()}}}let Re=[];function $e(R){if(R.samples>0){if(we(R)===!1){let S=R.textures,q=R.width,ue=R.height,oe=n.COLOR_BUFFER_BIT,ve=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=i.get(R),te=S.length>1;if(te)for(let pe=0;pe<S.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let pe=0;pe<S.length;pe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let O=i.get(S[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,O,0)}n.blitFramebuffer(0,0,q,ue,0,0,q,ue,oe,n.NEAREST),l===!0&&(Re.length=0,Re.push(n.COLOR_ATTACHMENT0+pe),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Re.push(ve),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<S.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let O=i.get(S[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,O,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let S=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function it(R){return Math.min(s.maxSamples,R.samples)}function we(R){let S=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Ut(R){let S=o.render.frame;u.get(R)!==S&&(u.set(R,S),R.update())}function He(R,S){let q=R.colorSpace,ue=R.format,oe=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==aa&&q!==Ss&&(pt.getTransfer(q)===Tt?(ue!==fi||oe!==hi)&&Ye("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qe("WebGLTextures: Unsupported texture color space:",q)),S}function qe(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=fe,this.setTexture2D=me,this.setTexture2DArray=ge,this.setTexture3D=Se,this.setTextureCube=xe,this.rebindTextures=Qt,this.setupRenderTarget=hn,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=$e,this.setupDepthRenderbuffer=Mn,this.setupFrameBufferTexture=Nt,this.useMultisampledRTT=we,this.dispose=W}function h1(n,e){function t(i,s=Ss){let r,o=pt.getTransfer(s);if(i===hi)return n.UNSIGNED_BYTE;if(i===bc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Mc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Tf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Af)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===wf)return n.BYTE;if(i===Ef)return n.SHORT;if(i===yo)return n.UNSIGNED_SHORT;if(i===yc)return n.INT;if(i===Bi)return n.UNSIGNED_INT;if(i===ki)return n.FLOAT;if(i===zi)return n.HALF_FLOAT;if(i===Cf)return n.ALPHA;if(i===Rf)return n.RGB;if(i===fi)return n.RGBA;if(i===xs)return n.DEPTH_COMPONENT;if(i===Ms)return n.DEPTH_STENCIL;if(i===Pf)return n.RED;if(i===Sc)return n.RED_INTEGER;if(i===js)return n.RG;if(i===wc)return n.RG_INTEGER;if(i===Ec)return n.RGBA_INTEGER;if(i===Ea||i===Ta||i===Aa||i===Ca)if(o===Tt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ea)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ta)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Aa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ca)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ea)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ta)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Aa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ca)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Tc||i===Ac||i===Cc||i===Rc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Tc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Ac)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Cc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Rc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Pc||i===Ic||i===Lc||i===Dc||i===Nc||i===Ra||i===Fc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Pc||i===Ic)return o===Tt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Lc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Dc)return r.COMPRESSED_R11_EAC;if(i===Nc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Ra)return r.COMPRESSED_RG11_EAC;if(i===Fc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Uc||i===Oc||i===Bc||i===kc||i===zc||i===Vc||i===Hc||i===Gc||i===Wc||i===Xc||i===qc||i===$c||i===Yc||i===Zc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Uc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Oc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Bc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===kc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===zc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Vc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Hc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Gc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Wc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Xc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===qc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===$c)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Yc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Zc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Jc||i===Kc||i===jc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Jc)return o===Tt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Kc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===jc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Qc||i===eu||i===Pa||i===tu)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Qc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===eu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Pa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===tu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Mr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var f1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,d1=`
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

}`,Qf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new va(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Mi({vertexShader:f1,fragmentShader:d1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Mt(new xr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},ed=class extends es{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,h=null,d=null,p=null,_=typeof XRWebGLBinding<"u",g=new Qf,m={},x=t.getContextAttributes(),M=null,b=null,C=[],A=[],v=new xt,E=null,U=null,L=new Kn;L.viewport=new Xt;let I=new Kn;I.viewport=new Xt;let k=[L,I],z=new gc,N=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=C[ee];return me===void 0&&(me=new uo,C[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=C[ee];return me===void 0&&(me=new uo,C[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=C[ee];return me===void 0&&(me=new uo,C[ee]=me),me.getHandSpace()};function $(ee){let me=A.indexOf(ee.inputSource);if(me===-1)return;let ge=C[me];ge!==void 0&&(ge.update(ee.inputSource,ee.frame,c||o),ge.dispatchEvent({type:ee.type,data:ee.inputSource}))}function H(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",le);for(let ee=0;ee<C.length;ee++){let me=A[ee];me!==null&&(A[ee]=null,C[ee].disconnect(me))}N=null,W=null,g.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(M),d=null,h=null,f=null,s=null,b=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(E),e.setSize(v.width,v.height,!1),U!==null){let ee=U.camera;ee.fov=U.fov,ee.zoom=U.zoom,ee.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Ye("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Ye("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return f===null&&_&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",H),s.addEventListener("inputsourceschange",le),x.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(v),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,Se=null,xe=null;x.depth&&(xe=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=x.stencil?Ms:xs,Se=x.stencil?Mr:Bi);let Ve={colorFormat:t.RGBA8,depthFormat:xe,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(Ve),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),b=new li(h.textureWidth,h.textureHeight,{format:fi,type:hi,depthTexture:new ys(h.textureWidth,h.textureHeight,Se,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let ge={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),b=new li(d.framebufferWidth,d.framebufferHeight,{format:fi,type:hi,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function le(ee){for(let me=0;me<ee.removed.length;me++){let ge=ee.removed[me],Se=A.indexOf(ge);Se>=0&&(A[Se]=null,C[Se].disconnect(ge))}for(let me=0;me<ee.added.length;me++){let ge=ee.added[me],Se=A.indexOf(ge);if(Se===-1){for(let Ve=0;Ve<C.length;Ve++)if(Ve>=A.length){A.push(ge),Se=Ve;break}else if(A[Ve]===null){A[Ve]=ge,Se=Ve;break}if(Se===-1)break}let xe=C[Se];xe&&xe.connect(ge)}}function J(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ge=ee.far;g.texture!==null&&(g.depthNear>0&&(me=g.depthNear),g.depthFar>0&&(ge=g.depthFar)),z.near=I.near=L.near=me,z.far=I.far=L.far=ge,(N!==z.near||W!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),N=z.near,W=z.far),z.layers.mask=ee.layers.mask|6,L.layers.mask=z.layers.mask&-5,I.layers.mask=z.layers.mask&-3;let Se=ee.parent,xe=z.cameras;J(z,Se);for(let Ve=0;Ve<xe.length;Ve++)J(xe[Ve],Se);z.projectionMatrix.copy(L.projectionMatrix),z.projectionMatrixInverse.copy(L.projectionMatrixInverse),U===null&&ee.isPerspectiveCamera&&(U={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,z,Se)};function Q(ee,me,ge){ge===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ge.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Jl*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(h===null&&d===null))return l},this.setFoveation=function(ee){l=ee,h!==null&&(h.fixedFoveation=ee),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=ee)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(z)},this.getCameraTexture=function(ee){return m[ee]};let ie=null;function fe(ee,me){if(u=me.getViewerPose(c||o),p=me,u!==null){let ge=u.views;d!==null&&(e.setRenderTargetFramebuffer(b,d.framebuffer),e.setRenderTarget(b));let Se=!1;ge.length!==z.cameras.length&&(z.cameras.length=0,Se=!0);for(let Ne=0;Ne<ge.length;Ne++){let ct=ge[Ne],ot=null;if(d!==null)ot=d.getViewport(ct);else{let Zt=f.getViewSubImage(h,ct);ot=Zt.viewport,Ne===0&&(e.setRenderTargetTextures(b,Zt.colorTexture,Zt.depthStencilTexture),e.setRenderTarget(b))}let tt=k[Ne];tt===void 0&&(tt=new Kn,tt.layers.enable(Ne),tt.viewport=new Xt,k[Ne]=tt),tt.matrix.fromArray(ct.transform.matrix),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.projectionMatrix.fromArray(ct.projectionMatrix),tt.projectionMatrixInverse.copy(tt.projectionMatrix).invert(),tt.viewport.set(ot.x,ot.y,ot.width,ot.height),Ne===0&&(z.matrix.copy(tt.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),Se===!0&&z.cameras.push(tt)}let xe=s.enabledFeatures;if(xe&&xe.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){f=i.getBinding();let Ne=f.getDepthInformation(ge[0]);Ne&&Ne.isValid&&Ne.texture&&g.init(Ne,s.renderState)}if(xe&&xe.includes("camera-access")&&_){e.state.unbindTexture(),f=i.getBinding();for(let Ne=0;Ne<ge.length;Ne++){let ct=ge[Ne].camera;if(ct){let ot=m[ct];ot||(ot=new va,m[ct]=ot);let tt=f.getCameraImage(ct);ot.sourceTexture=tt}}}}for(let ge=0;ge<C.length;ge++){let Se=A[ge],xe=C[ge];Se!==null&&xe!==void 0&&xe.update(Se,me,c||o)}ie&&ie(ee,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),p=null}let he=new kg;he.setAnimationLoop(fe),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},p1=new yt,Zg=new et;Zg.set(-1,0,0,0,1,0,0,0,1);function m1(n,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,Vf(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,x,M,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),f(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),h(g,m),m.isMeshPhysicalMaterial&&d(g,m,b)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),_(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,x,M):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===Bn&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===Bn&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let x=e.get(m),M=x.envMap,b=x.envMapRotation;M&&(g.envMap.value=M,g.envMapRotation.value.setFromMatrix4(p1.makeRotationFromEuler(b)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Zg),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,x,M){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*x,g.scale.value=M*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function f(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function h(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function d(g,m,x){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Bn&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=x.texture,g.transmissionSamplerSize.value.set(x.width,x.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function _(g,m){let x=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(x.matrixWorld),g.nearDistance.value=x.shadow.camera.near,g.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function g1(n,e,t,i){let s={},r={};function o(x,M){let b=M.program;i.uniformBlockBinding(x,b,s[x.id])}function a(x,M){let b=s[x.id];b===void 0&&(p(x),b=l(x),s[x.id]=b,x.addEventListener("dispose",g));let C=M.program;i.updateUBOMapping(x,C);let A=e.render.frame;r[x.id]!==A&&(c(x),r[x.id]=A)}function l(x){let M=n.createBuffer(),b=x.__size,C=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,M),n.bufferData(n.UNIFORM_BUFFER,b,C),n.bindBuffer(n.UNIFORM_BUFFER,null),M}function c(x){let M=s[x.id],b=x.uniforms,C=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,M);for(let A=0,v=b.length;A<v;A++){let E=b[A];if(Array.isArray(E))for(let U=0,L=E.length;U<L;U++)u(E[U],A,U,C);else u(E,A,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,M,b,C){if(h(x,M,b,C)===!0){let A=x.__offset,v=x.value;if(Array.isArray(v)){let E=0;for(let U=0;U<v.length;U++){let L=v[U],I=_(L,!0);f(L,x.__data,E),E+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else f(v,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,x.__data)}}function f(x,M,b){typeof x=="number"||typeof x=="boolean"?M[b]=x:x.isMatrix3?(M[b]=x.elements[0],M[b+1]=x.elements[1],M[b+2]=x.elements[2],M[b+3]=0,M[b+4]=x.elements[3],M[b+5]=x.elements[4],M[b+6]=x.elements[5],M[b+7]=0,M[b+8]=x.elements[6],M[b+9]=x.elements[7],M[b+10]=x.elements[8],M[b+11]=0):ArrayBuffer.isView(x)?M.set(x.subarray(0,M.length-b),b):x.toArray(M,b)}function h(x,M,b,C){let A=x.value,v=M+"_"+b;if(Array.isArray(A)){C[v]===void 0&&(C[v]=[]);let E=C[v],U=!1;for(let L=0;L<A.length;L++)d(A[L],E,L)===!0&&(U=!0);return U}return d(A,C,v)}function d(x,M,b){if(M[b]===void 0)return typeof x=="number"||typeof x=="boolean"?M[b]=x:ArrayBuffer.isView(x)?M[b]=x.slice():M[b]=x.clone(),!0;{let C=M[b];if(typeof x=="number"||typeof x=="boolean"){if(C!==x)return M[b]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(C.equals(x)===!1)return C.copy(x),!0}}return!1}function p(x){let M=x.uniforms,b=0,C=16;for(let v=0,E=M.length;v<E;v++){let U=Array.isArray(M[v])?M[v]:[M[v]];for(let L=0,I=U.length;L<I;L++){let k=U[L],z=Array.isArray(k.value)?k.value:[k.value],N=Array.isArray(M[v])||Array.isArray(k.value),W=b;for(let H=0,le=z.length;H<le;H++){let J=z[H],Q=_(J,N),ie=b%C,fe=ie%Q.boundary,he=ie+fe;b+=fe,he!==0&&C-he<Q.storage&&(b+=C-he),H===0&&(W=b),b+=Q.storage}let $=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new $((b-W)/Float32Array.BYTES_PER_ELEMENT),k.__offset=W}}let A=b%C;return A>0&&(b+=C-A),x.__size=b,x.__cache={},this}function _(x,M){let b={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(b.boundary=4,b.storage=4):x.isVector2?(b.boundary=8,b.storage=8):x.isVector3||x.isColor?(b.boundary=16,b.storage=12):x.isVector4?(b.boundary=16,b.storage=16):x.isMatrix3?(b.boundary=16,b.storage=48):x.isMatrix4?(b.boundary=16,b.storage=64):x.isTexture?Ye("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(b.boundary=16,b.storage=x.byteLength):Ye("WebGLRenderer: Unsupported uniform value type.",x),M===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(x){let M=x.target;M.removeEventListener("dispose",g),n.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function m(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:m}}var _1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ns=null;function x1(){return ns===null&&(ns=new ho(_1,16,16,js,zi),ns.name="DFG_LUT",ns.minFilter=On,ns.magFilter=On,ns.wrapS=Qi,ns.wrapT=Qi,ns.generateMipmaps=!1,ns.needsUpdate=!0),ns}var ou=class{constructor(e={}){let{canvas:t=cg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:d=hi}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let _=d,g=new Set([Ec,wc,Sc]),m=new Set([hi,Bi,yo,Mr,bc,Mc]),x=new Uint32Array(4),M=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,A=null,v=[],E=[],U=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ts,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,I=!1,k=null,z=null,N=null,W=null;this._outputColorSpace=Jn;let $=0,H=0,le=null,J=-1,Q=null,ie=new Xt,fe=new Xt,he=null,ee=new rt(0),me=0,ge=t.width,Se=t.height,xe=1,Ve=null,Xe=null,Ne=new Xt(0,0,ge,Se),ct=new Xt(0,0,ge,Se),ot=!1,tt=new vs,Zt=new ec,kt=!1,un=!1,Nt=new yt,Cn=new G,vt=new Xt,Mn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Qt=!1;function hn(){return le===null?xe:1}let B=i;function Re(T,V){return t.getContext(T,V)}let $e,it,we,Ut,He,qe,R,S,q,ue,oe,ve,ye,te,se,pe,O,re,ne,Ee,_e,Me,Ge;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",Ke,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),B===null){let V="webgl2";if(B=Re(V,T),B===null)throw Re(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Je()}catch(T){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",Ke,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),Qe("WebGLRenderer: "+T.message),T}function Je(){$e=new RS(B),$e.init(),_e=new h1(B,$e),it=new xS(B,$e,e,_e),we=new c1(B,$e),it.reversedDepthBuffer&&h&&we.buffers.depth.setReversed(!0),z=B.createFramebuffer(),N=B.createFramebuffer(),W=B.createFramebuffer(),Ut=new LS(B),He=new Zw,qe=new u1(B,$e,we,He,it,_e,Ut),R=new CS(L),S=new Ny(B),Me=new gS(B,S),q=new PS(B,S,Ut,Me),ue=new NS(B,q,S,Me,Ut),re=new DS(B,it,qe),se=new vS(He),oe=new Yw(L,R,$e,it,Me,se),ve=new m1(L,He),ye=new Kw,te=new i1($e),O=new mS(L,R,we,ue,p,l),pe=new l1(L,ue,it),Ge=new g1(B,Ut,it,we),ne=new _S(B,$e,Ut),Ee=new IS(B,$e,Ut),Ut.programs=oe.programs,L.capabilities=it,L.extensions=$e,L.properties=He,L.renderLists=ye,L.shadowMap=pe,L.state=we,L.info=Ut}_!==hi&&(U=new US(_,t.width,t.height,a,s,r));let ce=new ed(L,B);this.xr=ce,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let T=$e.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=$e.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return xe},this.setPixelRatio=function(T){T!==void 0&&(xe=T,this.setSize(ge,Se,!1))},this.getSize=function(T){return T.set(ge,Se)},this.setSize=function(T,V,j=!0){if(ce.isPresenting){Ye("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=T,Se=V,t.width=Math.floor(T*xe),t.height=Math.floor(V*xe),j===!0&&(t.style.width=T+"px",t.style.height=V+"px"),U!==null&&U.setSize(t.width,t.height),this.setViewport(0,0,T,V)},this.getDrawingBufferSize=function(T){return T.set(ge*xe,Se*xe).floor()},this.setDrawingBufferSize=function(T,V,j){ge=T,Se=V,xe=j,t.width=Math.floor(T*j),t.height=Math.floor(V*j),this.setViewport(0,0,T,V)},this.setEffects=function(T){if(_===hi){Qe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let V=0;V<T.length;V++)if(T[V].isOutputPass===!0){Ye("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(ie)},this.getViewport=function(T){return T.copy(Ne)},this.setViewport=function(T,V,j,Y){T.isVector4?Ne.set(T.x,T.y,T.z,T.w):Ne.set(T,V,j,Y),we.viewport(ie.copy(Ne).multiplyScalar(hn()).round())},this.getScissor=function(T){return T.copy(ct)},this.setScissor=function(T,V,j,Y){T.isVector4?ct.set(T.x,T.y,T.z,T.w):ct.set(T,V,j,Y),we.scissor(fe.copy(ct).multiplyScalar(hn()).round())},this.getScissorTest=function(){return ot},this.setScissorTest=function(T){we.setScissorTest(ot=T)},this.setOpaqueSort=function(T){Ve=T},this.setTransparentSort=function(T){Xe=T},this.getClearColor=function(T){return T.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(T=!0,V=!0,j=!0){let Y=0;if(T){let Z=!1;if(le!==null){let Te=le.texture.format;Z=g.has(Te)}if(Z){let Te=le.texture.type,Pe=m.has(Te),Ae=O.getClearColor(),Ie=O.getClearAlpha(),ze=Ae.r,je=Ae.g,ut=Ae.b;Pe?(x[0]=ze,x[1]=je,x[2]=ut,x[3]=Ie,B.clearBufferuiv(B.COLOR,0,x)):(M[0]=ze,M[1]=je,M[2]=ut,M[3]=Ie,B.clearBufferiv(B.COLOR,0,M))}else Y|=B.COLOR_BUFFER_BIT}V&&(Y|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&B.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),k=T},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",Ke,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),O.dispose(),ye.dispose(),te.dispose(),qe.dispose(),He.dispose(),R.dispose(),ue.dispose(),q.dispose(),Me.dispose(),Ge.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",rl),ce.removeEventListener("sessionend",Xi),as.stop()};function Be(T){T.preventDefault(),kf("WebGLRenderer: Context Lost."),I=!0}function Ke(){kf("WebGLRenderer: Context Restored."),I=!1;let T=Ut.autoReset,V=pe.enabled,j=pe.autoUpdate,Y=pe.needsUpdate,Z=pe.type;Je(),Ut.autoReset=T,pe.enabled=V,pe.autoUpdate=j,pe.needsUpdate=Y,pe.type=Z}function Ce(T){Qe("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function st(T){let V=T.target;V.removeEventListener("dispose",st),zt(V)}function zt(T){Xn(T),He.remove(T)}function Xn(T){let V=He.get(T).programs;V!==void 0&&(V.forEach(function(j){oe.releaseProgram(j)}),T.isShaderMaterial&&oe.releaseShaderCache(T))}this.renderBufferDirect=function(T,V,j,Y,Z,Te){V===null&&(V=Mn);let Pe=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ae=Yo(T,V,j,Y,Z);we.setMaterial(Y,Pe);let Ie=j.index,ze=1;if(Y.wireframe===!0){if(Ie=q.getWireframeAttribute(j),Ie===void 0)return;ze=2}let je=j.drawRange,ut=j.attributes.position,ke=je.start*ze,ht=(je.start+je.count)*ze;Te!==null&&(ke=Math.max(ke,Te.start*ze),ht=Math.min(ht,(Te.start+Te.count)*ze)),Ie!==null?(ke=Math.max(ke,0),ht=Math.min(ht,Ie.count)):ut!=null&&(ke=Math.max(ke,0),ht=Math.min(ht,ut.count));let Kt=ht-ke;if(Kt<0||Kt===1/0)return;Me.setup(Z,Y,Ae,j,Ie);let Ct,Rt=ne;if(Ie!==null&&(Ct=S.get(Ie),Rt=Ee,Rt.setIndex(Ct)),Z.isMesh)Y.wireframe===!0?(we.setLineWidth(Y.wireframeLinewidth*hn()),Rt.setMode(B.LINES)):Rt.setMode(B.TRIANGLES);else if(Z.isLine){let Sn=Y.linewidth;Sn===void 0&&(Sn=1),we.setLineWidth(Sn*hn()),Z.isLineSegments?Rt.setMode(B.LINES):Z.isLineLoop?Rt.setMode(B.LINE_LOOP):Rt.setMode(B.LINE_STRIP)}else Z.isPoints?Rt.setMode(B.POINTS):Z.isSprite&&Rt.setMode(B.TRIANGLES);if(Z.isBatchedMesh)if($e.get("WEBGL_multi_draw"))Rt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let Sn=Z._multiDrawStarts,Ue=Z._multiDrawCounts,fn=Z._multiDrawCount,dt=Ie?S.get(Ie).bytesPerElement:1,cs=He.get(Y).currentProgram.getUniforms();for(let dn=0;dn<fn;dn++)cs.setValue(B,"_gl_DrawID",dn),Rt.render(Sn[dn]/dt,Ue[dn])}else if(Z.isInstancedMesh)Rt.renderInstances(ke,Kt,Z.count);else if(j.isInstancedBufferGeometry){let Sn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ue=Math.min(j.instanceCount,Sn);Rt.renderInstances(ke,Kt,Ue)}else Rt.render(ke,Kt)};function Xo(T,V,j,Y){k!==null&&T.isNodeMaterial&&k.setObject(Y,T),kt===!0&&se.setState(T,j,!1),T.transparent===!0&&T.side===Nn&&T.forceSinglePass===!1?(T.side=Bn,T.needsUpdate=!0,qi(T,V,Y),T.side=Si,T.needsUpdate=!0,qi(T,V,Y),T.side=Nn):qi(T,V,Y)}this.compile=function(T,V,j=null){j===null&&(j=T),k!==null&&k.renderStart(T,V,j),A=te.get(j),A.init(V),E.push(A),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(V.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),T!==j&&T.traverseVisible(function(Z){Z.isLight&&Z.layers.test(V.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),A.setupLights(),k!==null&&k.updateLights(A.state.lightsArray),un=this.localClippingEnabled,kt=se.init(this.clippingPlanes,un),kt===!0&&se.setGlobalState(this.clippingPlanes,V),k!==null&&pe.render(A.state.shadowsArray,j,V);let Y=new Set;return T.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Te=Z.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let Ae=Te[Pe];Xo(Ae,j,V,Z),Y.add(Ae)}else Xo(Te,j,V,Z),Y.add(Te)}),A=E.pop(),k!==null&&k.renderEnd(),Y},this.compileAsync=function(T,V,j=null){let Y=this.compile(T,V,j);return new Promise(Z=>{function Te(){if(Y.forEach(function(Pe){let Ie=He.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&Y.delete(Pe)}),Y.size===0){Z(T);return}setTimeout(Te,10)}$e.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let Fr=null;function gh(T){Fr&&Fr(T)}function rl(){as.stop()}function Xi(){as.start()}let as=new kg;as.setAnimationLoop(gh),typeof self<"u"&&as.setContext(self),this.setAnimationLoop=function(T){Fr=T,ce.setAnimationLoop(T),T===null?as.stop():as.start()},ce.addEventListener("sessionstart",rl),ce.addEventListener("sessionend",Xi),this.render=function(T,V){if(V!==void 0&&V.isCamera!==!0){Qe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;k!==null&&k.renderStart(T,V);let j=ce.enabled===!0&&ce.isPresenting===!0,Y=U!==null&&(le===null||j)&&U.begin(L,le);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(V),V=ce.getCamera()),T.isScene===!0&&T.onBeforeRender(L,T,V,le),A=te.get(T,E.length),A.init(V),A.state.textureUnits=qe.getTextureUnits(),E.push(A),Nt.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?Zt.setFromArrayCamera(V):tt.setFromProjectionMatrix(Nt,vi,V.reversedDepth),un=this.localClippingEnabled,kt=se.init(this.clippingPlanes,un),C=ye.get(T,v.length),C.init(),v.push(C),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Pe=L.xr.getDepthSensingMesh();Pe!==null&&ls(Pe,V,-1/0,L.sortObjects)}ls(T,V,0,L.sortObjects),C.finish(),k!==null&&k.updateLights(A.state.lightsArray),L.sortObjects===!0&&C.sort(Ve,Xe),Qt=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,Qt&&O.addToRenderList(C,T),this.info.autoReset===!0&&this.info.reset(),kt===!0&&se.beginShadows();let Z=A.state.shadowsArray;if(pe.render(Z,T,V),kt===!0&&se.endShadows(),(Y&&U.hasRenderPass())===!1){let Pe=C.opaque,Ae=C.transmissive;if(A.setupLights(),V.isArrayCamera){let Ie=V.cameras;if(Ae.length>0)for(let ze=0,je=Ie.length;ze<je;ze++){let ut=Ie[ze];Pi(Pe,Ae,T,ut)}Qt&&O.render(T);for(let ze=0,je=Ie.length;ze<je;ze++){let ut=Ie[ze];qo(C,T,ut,ut.viewport)}}else Ae.length>0&&Pi(Pe,Ae,T,V),Qt&&O.render(T),qo(C,T,V)}le!==null&&H===0&&(qe.updateMultisampleRenderTarget(le),qe.updateRenderTargetMipmap(le)),Y&&U.end(L),T.isScene===!0&&T.onAfterRender(L,T,V),Me.resetDefaultState(),J=-1,Q=null,E.pop(),E.length>0?(A=E[E.length-1],qe.setTextureUnits(A.state.textureUnits),kt===!0&&se.setGlobalState(L.clippingPlanes,A.state.camera)):A=null,v.pop(),v.length>0?C=v[v.length-1]:C=null,k!==null&&k.renderEnd()};function ls(T,V,j,Y){if(T.visible===!1)return;if(T.layers.test(V.layers)){if(T.isGroup)j=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(V);else if(T.isLight)A.pushLight(T),T.castShadow&&A.pushShadow(T);else if(T.isSprite){let Pe=V.isArrayCamera?Zt:tt;if(!T.frustumCulled||T.intersectsFrustum(Pe)){Y&&vt.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Nt);let Ae=ue.update(T),Ie=T.material;Ie.visible&&C.push(T,Ae,Ie,j,vt.z,null,V)}}else if(T.isMesh||T.isLine||T.isPoints){let Pe=V.isArrayCamera?Zt:tt;if(!T.frustumCulled||T.intersectsFrustum(Pe)){let Ae=ue.update(T),Ie=T.material;if(Y&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),vt.copy(T.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),vt.copy(Ae.boundingSphere.center)),vt.applyMatrix4(T.matrixWorld).applyMatrix4(Nt)),Array.isArray(Ie)){let ze=Ae.groups;for(let je=0,ut=ze.length;je<ut;je++){let ke=ze[je],ht=Ie[ke.materialIndex];ht&&ht.visible&&C.push(T,Ae,ht,j,vt.z,ke,V)}}else Ie.visible&&C.push(T,Ae,Ie,j,vt.z,null,V)}}}let Te=T.children;for(let Pe=0,Ae=Te.length;Pe<Ae;Pe++)ls(Te[Pe],V,j,Y)}function qo(T,V,j,Y){let{opaque:Z,transmissive:Te,transparent:Pe}=T;A.setupLightsView(j),kt===!0&&se.setGlobalState(L.clippingPlanes,j),Y&&we.viewport(ie.copy(Y)),Z.length>0&&en(Z,V,j),Te.length>0&&en(Te,V,j),Pe.length>0&&en(Pe,V,j),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Pi(T,V,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[Y.id]===void 0){let ke=$e.has("EXT_color_buffer_half_float")||$e.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[Y.id]=new li(1,1,{generateMipmaps:!0,type:ke?zi:hi,minFilter:bs,samples:Math.max(4,it.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:pt.workingColorSpace})}let Te=A.state.transmissionRenderTarget[Y.id],Pe=Y.viewport||ie;Te.setSize(Pe.z*L.transmissionResolutionScale,Pe.w*L.transmissionResolutionScale);let Ae=L.getRenderTarget(),Ie=L.getActiveCubeFace(),ze=L.getActiveMipmapLevel();L.setRenderTarget(Te),L.getClearColor(ee),me=L.getClearAlpha(),me<1&&L.setClearColor(16777215,.5),L.clear(),Qt&&O.render(j);let je=L.toneMapping;L.toneMapping=ts;let ut=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),A.setupLightsView(Y),kt===!0&&se.setGlobalState(L.clippingPlanes,Y),en(T,j,Y),qe.updateMultisampleRenderTarget(Te),qe.updateRenderTargetMipmap(Te),$e.has("WEBGL_multisampled_render_to_texture")===!1){let ke=!1;for(let ht=0,Kt=V.length;ht<Kt;ht++){let Ct=V[ht],{object:Rt,geometry:Sn,material:Ue,group:fn}=Ct;if(Ue.side===Nn&&Rt.layers.test(Y.layers)){let dt=Ue.side;Ue.side=Bn,Ue.needsUpdate=!0,an(Rt,j,Y,Sn,Ue,fn),Ue.side=dt,Ue.needsUpdate=!0,ke=!0}}ke===!0&&(qe.updateMultisampleRenderTarget(Te),qe.updateRenderTargetMipmap(Te))}L.setRenderTarget(Ae,Ie,ze),L.setClearColor(ee,me),ut!==void 0&&(Y.viewport=ut),L.toneMapping=je}function en(T,V,j){let Y=V.isScene===!0?V.overrideMaterial:null;for(let Z=0,Te=T.length;Z<Te;Z++){let Pe=T[Z],{object:Ae,geometry:Ie,group:ze}=Pe,je=Pe.material;je.allowOverride===!0&&Y!==null&&(je=Y),Ae.layers.test(j.layers)&&an(Ae,V,j,Ie,je,ze)}}function an(T,V,j,Y,Z,Te){k!==null&&Z.isNodeMaterial&&k.setObject(T,Z),T.onBeforeRender(L,V,j,Y,Z,Te),T.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),Z.onBeforeRender(L,V,j,Y,T,Te),Z.transparent===!0&&Z.side===Nn&&Z.forceSinglePass===!1?(Z.side=Bn,Z.needsUpdate=!0,L.renderBufferDirect(j,V,Y,Z,T,Te),Z.side=Si,Z.needsUpdate=!0,L.renderBufferDirect(j,V,Y,Z,T,Te),Z.side=Nn):L.renderBufferDirect(j,V,Y,Z,T,Te),T.onAfterRender(L,V,j,Y,Z,Te)}function ln(T){let V=0;for(let j of T)j.texture!==null&&V++;return V}function qi(T,V,j){V.isScene!==!0&&(V=Mn);let Y=He.get(T),Z=A.state.lights,Te=A.state.shadowsArray,Pe=Z.state.version,Ae=oe.getParameters(T,Z.state,Te,V,j,A.state.lightProbeGridArray),Ie=oe.getProgramCacheKey(Ae),ze=Y.programs;Y.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?V.environment:null,Y.fog=V.fog;let je=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;Y.envMap=R.get(T.envMap||Y.environment,je),Y.envMapRotation=Y.environment!==null&&T.envMap===null?V.environmentRotation:T.envMapRotation,ze===void 0&&(T.addEventListener("dispose",st),ze=new Map,Y.programs=ze,Y.programVariants=new Map);let ut=ze.get(Ie);if(ut!==void 0){if(Y.currentProgram===ut&&Y.lightsStateVersion===Pe)return $o(T,Ae),ut}else Ae.uniforms=oe.getUniforms(T),k!==null&&T.isNodeMaterial&&k.build(T,j,Ae),T.onBeforeCompile(Ae,L),ut=oe.acquireProgram(Ae,Ie),ze.set(Ie,ut),Y.uniforms=Ae.uniforms;let ke=Y.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(ke.clippingPlanes=se.uniform),$o(T,Ae),Y.needsLights=Is(T),Y.lightsStateVersion=Pe,Y.needsLights&&(ke.ambientLightColor.value=Z.state.ambient,ke.lightProbe.value=Z.state.probe,ke.sunLights.value=Z.state.sun,ke.sunLightShadows.value=Z.state.sunShadow,ke.directionalLights.value=Z.state.directional,ke.directionalLightShadows.value=Z.state.directionalShadow,ke.spotLights.value=Z.state.spot,ke.spotLightShadows.value=Z.state.spotShadow,ke.rectAreaLights.value=Z.state.rectArea,ke.ltc_1.value=Z.state.rectAreaLTC1,ke.ltc_2.value=Z.state.rectAreaLTC2,ke.pointLights.value=Z.state.point,ke.pointLightShadows.value=Z.state.pointShadow,ke.hemisphereLights.value=Z.state.hemi,ke.sunShadowMatrix.value=Z.state.sunShadowMatrix,ke.sunShadowCascade.value=Z.state.sunShadowCascade,ke.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,ke.spotLightMatrix.value=Z.state.spotLightMatrix,ke.spotLightMap.value=Z.state.spotLightMap,ke.pointShadowMatrix.value=Z.state.pointShadowMatrix),Y.numLightProbeGrids=ln(A.state.lightProbeGridArray),Y.currentProgram=ut,Y.uniformsList=null,ut}function ni(T,V,j,Y,Z){let Te=He.get(T),Pe=Te.currentProgram.id+","+Y+","+Z,Ae=Te.programVariants.get(Pe);return Ae===void 0?(Ae=qi(T,V,j),Te.programVariants.set(Pe,Ae)):(Te.currentProgram=Ae,Te.uniformsList=null,Te.outputColorSpace=Y,Te.toneMapping=Z),Ae}function Ps(T){if(T.uniformsList===null){let V=T.currentProgram.getUniforms();T.uniformsList=bo.seqWithValue(V.seq,T.uniforms)}return T.uniformsList}function $o(T,V){let j=He.get(T);j.outputColorSpace=V.outputColorSpace,j.batching=V.batching,j.batchingColor=V.batchingColor,j.instancing=V.instancing,j.instancingColor=V.instancingColor,j.instancingMorph=V.instancingMorph,j.skinning=V.skinning,j.morphTargets=V.morphTargets,j.morphNormals=V.morphNormals,j.morphColors=V.morphColors,j.morphTargetsCount=V.morphTargetsCount,j.numClippingPlanes=V.numClippingPlanes,j.numIntersection=V.numClipIntersection,j.vertexAlphas=V.vertexAlphas,j.vertexTangents=V.vertexTangents,j.toneMapping=V.toneMapping}function Yo(T,V,j,Y,Z){V.isScene!==!0&&(V=Mn),qe.resetTextureUnits();let Te=V.fog,Pe=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?V.environment:null,Ae=le===null?L.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:pt.workingColorSpace,Ie=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,ze=R.get(Y.envMap||Pe,Ie),je=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,ut=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),ke=!!j.morphAttributes.position,ht=!!j.morphAttributes.normal,Kt=!!j.morphAttributes.color,Ct=ts;Y.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Ct=L.toneMapping);let Rt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,Sn=Rt!==void 0?Rt.length:0,Ue=He.get(Y),fn=A.state.lights;if(kt===!0&&(un===!0||T!==Q)){let Pt=T===Q&&Y.id===J;se.setState(Y,T,Pt)}let dt=!1,cs=!1;Y.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==fn.state.version||Z.isBatchedMesh&&Ue.batching===!1||!Z.isBatchedMesh&&Ue.batching===!0||Z.isBatchedMesh&&Ue.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ue.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ue.instancing===!1||!Z.isInstancedMesh&&Ue.instancing===!0||Z.isSkinnedMesh&&Ue.skinning===!1||!Z.isSkinnedMesh&&Ue.skinning===!0||Z.isInstancedMesh&&Ue.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ue.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ue.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ue.instancingMorph===!1&&Z.morphTexture!==null||Ue.envMap!==ze||Y.fog===!0&&Ue.fog!==Te||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==se.numPlanes||Ue.numIntersection!==se.numIntersection)||Ue.vertexAlphas!==je||Ue.vertexTangents!==ut||Ue.morphTargets!==ke||Ue.morphNormals!==ht||Ue.morphColors!==Kt||Ue.morphTargetsCount!==Sn||Ue.numLightProbeGrids!==ln(A.state.lightProbeGridArray)?dt=!0:(Ue.outputColorSpace!==Ae||Ue.toneMapping!==Ct)&&(cs=!0):(dt=!0,Ue.__version=Y.version);let dn=Ue.currentProgram;(dt===!0||cs===!0)&&(dn=cs===!0?ni(Y,V,Z,Ae,Ct):qi(Y,V,Z),k&&Y.isNodeMaterial&&k.onUpdateProgram(Y,dn,Ue));let Br=!1,$i=!1,us=!1,at=dn.getUniforms(),tn=Ue.uniforms;if(we.useProgram(dn.program)&&(Br=!0,$i=!0,us=!0),Y.id!==J&&(J=Y.id,$i=!0),Br||Q!==T){we.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),at.setValue(B,"projectionMatrix",T.projectionMatrix),at.setValue(B,"viewMatrix",T.matrixWorldInverse);let pn=at.map.cameraPosition;pn!==void 0&&pn.setValue(B,Cn.setFromMatrixPosition(T.matrixWorld)),it.logarithmicDepthBuffer&&at.setValue(B,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&at.setValue(B,"isOrthographic",T.isOrthographicCamera===!0),Q!==T&&(Q=T,$i=!0,us=!0)}if(Ue.needsLights&&(fn.state.sunShadowMap.length>0&&at.setValue(B,"sunShadowMap",fn.state.sunShadowMap,qe),fn.state.directionalShadowMap.length>0&&at.setValue(B,"directionalShadowMap",fn.state.directionalShadowMap,qe),fn.state.spotShadowMap.length>0&&at.setValue(B,"spotShadowMap",fn.state.spotShadowMap,qe),fn.state.pointShadowMap.length>0&&at.setValue(B,"pointShadowMap",fn.state.pointShadowMap,qe)),Z.isSkinnedMesh){at.setOptional(B,Z,"bindMatrix"),at.setOptional(B,Z,"bindMatrixInverse");let Pt=Z.skeleton;Pt&&(Pt.boneTexture===null&&Pt.computeBoneTexture(),at.setValue(B,"boneTexture",Pt.boneTexture,qe))}Z.isBatchedMesh&&(at.setOptional(B,Z,"batchingTexture"),at.setValue(B,"batchingTexture",Z._matricesTexture,qe),at.setOptional(B,Z,"batchingIdTexture"),at.setValue(B,"batchingIdTexture",Z._indirectTexture,qe),at.setOptional(B,Z,"batchingColorTexture"),Z._colorsTexture!==null&&at.setValue(B,"batchingColorTexture",Z._colorsTexture,qe));let qn=j.morphAttributes;if((qn.position!==void 0||qn.normal!==void 0||qn.color!==void 0)&&re.update(Z,j,dn),($i||Ue.receiveShadow!==Z.receiveShadow)&&(Ue.receiveShadow=Z.receiveShadow,at.setValue(B,"receiveShadow",Z.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&V.environment!==null&&(tn.envMapIntensity.value=V.environmentIntensity),tn.dfgLUT!==void 0&&(tn.dfgLUT.value=x1()),$i){if(at.setValue(B,"toneMappingExposure",L.toneMappingExposure),Ue.needsLights&&Ur(tn,us),Te&&Y.fog===!0&&ve.refreshFogUniforms(tn,Te),ve.refreshMaterialUniforms(tn,Y,xe,Se,A.state.transmissionRenderTarget[T.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let Pt=b,pn=0;for(let Vn of A.state.lightProbeGridArray)Vn.texture!==null&&(Pt.textures[pn]=Vn.texture,Pt.min[pn]=Vn.boundingBox.min,Pt.max[pn]=Vn.boundingBox.max,Pt.resolution[pn]=Vn.resolution,pn++);for(let Vn in Pt)Pt[Vn].length=pn;tn.probesSH.value=Pt.textures,tn.probesMin.value=Pt.min,tn.probesMax.value=Pt.max,tn.probesResolution.value=Pt.resolution}bo.upload(B,Ps(Ue),tn,qe)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(bo.upload(B,Ps(Ue),tn,qe),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&at.setValue(B,"center",Z.center),at.setValue(B,"modelViewMatrix",Z.modelViewMatrix),at.setValue(B,"normalMatrix",Z.normalMatrix),at.setValue(B,"modelMatrix",Z.matrixWorld),Y.uniformsGroups!==void 0){let Pt=Y.uniformsGroups;for(let pn=0,Vn=Pt.length;pn<Vn;pn++){let ol=Pt[pn];Ge.update(ol,dn),Ge.bind(ol,dn)}}return dn}function Ur(T,V){T.ambientLightColor.needsUpdate=V,T.lightProbe.needsUpdate=V,T.sunLights.needsUpdate=V,T.sunLightShadows.needsUpdate=V,T.directionalLights.needsUpdate=V,T.directionalLightShadows.needsUpdate=V,T.pointLights.needsUpdate=V,T.pointLightShadows.needsUpdate=V,T.spotLights.needsUpdate=V,T.spotLightShadows.needsUpdate=V,T.rectAreaLights.needsUpdate=V,T.hemisphereLights.needsUpdate=V}function Is(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(T,V,j){let Y=He.get(T);Y.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),He.get(T.texture).__webglTexture=V,He.get(T.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,V){let j=He.get(T);j.__webglFramebuffer=V,j.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(T,V=0,j=0){le=T,$=V,H=j;let Y=null,Z=!1,Te=!1;if(T){let Ae=He.get(T);if(Ae.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(B.FRAMEBUFFER,Ae.__webglFramebuffer),ie.copy(T.viewport),fe.copy(T.scissor),he=T.scissorTest,we.viewport(ie),we.scissor(fe),we.setScissorTest(he),J=-1;return}else if(Ae.__webglFramebuffer===void 0)qe.setupRenderTarget(T);else if(Ae.__hasExternalTextures)qe.rebindTextures(T,He.get(T.texture).__webglTexture,He.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let je=T.depthTexture;if(Ae.__boundDepthTexture!==je){if(je!==null&&He.has(je)&&(T.width!==je.image.width||T.height!==je.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qe.setupDepthRenderbuffer(T)}}let Ie=T.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Te=!0);let ze=He.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(ze[V])?Y=ze[V][j]:Y=ze[V],Z=!0):T.samples>0&&qe.useMultisampledRTT(T)===!1?Y=He.get(T).__webglMultisampledFramebuffer:Array.isArray(ze)?Y=ze[j]:Y=ze,ie.copy(T.viewport),fe.copy(T.scissor),he=T.scissorTest}else ie.copy(Ne).multiplyScalar(xe).floor(),fe.copy(ct).multiplyScalar(xe).floor(),he=ot;if(j!==0&&(Y=z),we.bindFramebuffer(B.FRAMEBUFFER,Y)&&we.drawBuffers(T,Y),we.viewport(ie),we.scissor(fe),we.setScissorTest(he),Z){let Ae=He.get(T.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+V,Ae.__webglTexture,j)}else if(Te){let Ae=V;for(let Ie=0;Ie<T.textures.length;Ie++){let ze=He.get(T.textures[Ie]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ie,ze.__webglTexture,j,Ae)}}else if(T!==null&&j!==0){let Ae=He.get(T.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ae.__webglTexture,j)}J=-1};function Or(T){let V=He.get(T);return(V.__readFormat!==T.format||V.__readType!==T.type)&&(V.__readFormat=T.format,V.__readType=T.type,V.__formatReadable=it.textureFormatReadable(T.format),V.__typeReadable=it.textureTypeReadable(T.type)),V}this.readRenderTargetPixels=function(T,V,j,Y,Z,Te,Pe,Ae=0){if(!(T&&T.isWebGLRenderTarget)){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=He.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){we.bindFramebuffer(B.FRAMEBUFFER,Ie);try{let ze=T.textures[Ae],je=ze.format,ut=ze.type;T.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ae);let ke=Or(ze);if(ke.__formatReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ke.__typeReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=T.width-Y&&j>=0&&j<=T.height-Z&&B.readPixels(V,j,Y,Z,_e.convert(je),_e.convert(ut),Te)}finally{let ze=le!==null?He.get(le).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(T,V,j,Y,Z,Te,Pe,Ae=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=He.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(V>=0&&V<=T.width-Y&&j>=0&&j<=T.height-Z){we.bindFramebuffer(B.FRAMEBUFFER,Ie);let ze=T.textures[Ae],je=ze.format,ut=ze.type;T.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ae);let ke=Or(ze);if(ke.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ke.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ht=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,ht),B.bufferData(B.PIXEL_PACK_BUFFER,Te.byteLength,B.STREAM_READ),B.readPixels(V,j,Y,Z,_e.convert(je),_e.convert(ut),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let Kt=le!==null?He.get(le).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,Kt);let Ct=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await hg(B,Ct,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,ht),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Te),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(ht),B.deleteSync(Ct),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,V=null,j=0){let Y=Math.pow(2,-j),Z=Math.floor(T.image.width*Y),Te=Math.floor(T.image.height*Y),Pe=V!==null?V.x:0,Ae=V!==null?V.y:0;qe.setTexture2D(T,0),B.copyTexSubImage2D(B.TEXTURE_2D,j,0,0,Pe,Ae,Z,Te),we.unbindTexture()},this.copyTextureToTexture=function(T,V,j=null,Y=null,Z=0,Te=0){let Pe,Ae,Ie,ze,je,ut,ke,ht,Kt,Ct=T.isCompressedTexture?T.mipmaps[Te]:T.image;if(j!==null)Pe=j.max.x-j.min.x,Ae=j.max.y-j.min.y,Ie=j.isBox3?j.max.z-j.min.z:1,ze=j.min.x,je=j.min.y,ut=j.isBox3?j.min.z:0;else{let at=Math.pow(2,-Z);Pe=Math.floor(Ct.width*at),Ae=Math.floor(Ct.height*at),T.isDataArrayTexture?Ie=Ct.depth:T.isData3DTexture?Ie=Math.floor(Ct.depth*at):Ie=1,ze=0,je=0,ut=0}Y!==null?(ke=Y.x,ht=Y.y,Kt=Y.z):(ke=0,ht=0,Kt=0);let Rt=_e.convert(V.format),Sn=_e.convert(V.type),Ue;V.isData3DTexture?(qe.setTexture3D(V,0),Ue=B.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(qe.setTexture2DArray(V,0),Ue=B.TEXTURE_2D_ARRAY):(qe.setTexture2D(V,0),Ue=B.TEXTURE_2D),we.activeTexture(B.TEXTURE0),we.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,V.flipY),we.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),we.pixelStorei(B.UNPACK_ALIGNMENT,V.unpackAlignment);let fn=we.getParameter(B.UNPACK_ROW_LENGTH),dt=we.getParameter(B.UNPACK_IMAGE_HEIGHT),cs=we.getParameter(B.UNPACK_SKIP_PIXELS),dn=we.getParameter(B.UNPACK_SKIP_ROWS),Br=we.getParameter(B.UNPACK_SKIP_IMAGES);we.pixelStorei(B.UNPACK_ROW_LENGTH,Ct.width),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Ct.height),we.pixelStorei(B.UNPACK_SKIP_PIXELS,ze),we.pixelStorei(B.UNPACK_SKIP_ROWS,je),we.pixelStorei(B.UNPACK_SKIP_IMAGES,ut);let $i=T.isDataArrayTexture||T.isData3DTexture,us=V.isDataArrayTexture||V.isData3DTexture;if(T.isDepthTexture){let at=He.get(T),tn=He.get(V),qn=He.get(at.__renderTarget),Pt=He.get(tn.__renderTarget);we.bindFramebuffer(B.READ_FRAMEBUFFER,qn.__webglFramebuffer),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,Pt.__webglFramebuffer);for(let pn=0;pn<Ie;pn++)$i&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,He.get(T).__webglTexture,Z,ut+pn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,He.get(V).__webglTexture,Te,Kt+pn)),B.blitFramebuffer(ze,je,ze+Pe,je+Ae,ke,ht,ke+Pe,ht+Ae,B.DEPTH_BUFFER_BIT,B.NEAREST);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(Z!==0||T.isRenderTargetTexture||He.has(T)){let at=He.get(T),tn=He.get(V);we.bindFramebuffer(B.READ_FRAMEBUFFER,N),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,W);for(let qn=0;qn<Ie;qn++)$i?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,at.__webglTexture,Z,ut+qn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,at.__webglTexture,Z),us?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,tn.__webglTexture,Te,Kt+qn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,tn.__webglTexture,Te),Z!==0?B.blitFramebuffer(ze,je,ze+Pe,je+Ae,ke,ht,ke+Pe,ht+Ae,B.COLOR_BUFFER_BIT,B.NEAREST):us?B.copyTexSubImage3D(Ue,Te,ke,ht,Kt+qn,ze,je,Pe,Ae):B.copyTexSubImage2D(Ue,Te,ke,ht,ze,je,Pe,Ae);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else us?T.isDataTexture||T.isData3DTexture?B.texSubImage3D(Ue,Te,ke,ht,Kt,Pe,Ae,Ie,Rt,Sn,Ct.data):V.isCompressedArrayTexture?B.compressedTexSubImage3D(Ue,Te,ke,ht,Kt,Pe,Ae,Ie,Rt,Ct.data):B.texSubImage3D(Ue,Te,ke,ht,Kt,Pe,Ae,Ie,Rt,Sn,Ct):T.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Te,ke,ht,Pe,Ae,Rt,Sn,Ct.data):T.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Te,ke,ht,Ct.width,Ct.height,Rt,Ct.data):B.texSubImage2D(B.TEXTURE_2D,Te,ke,ht,Pe,Ae,Rt,Sn,Ct);we.pixelStorei(B.UNPACK_ROW_LENGTH,fn),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,dt),we.pixelStorei(B.UNPACK_SKIP_PIXELS,cs),we.pixelStorei(B.UNPACK_SKIP_ROWS,dn),we.pixelStorei(B.UNPACK_SKIP_IMAGES,Br),Te===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&B.generateMipmap(Ue),we.unbindTexture()},this.initRenderTarget=function(T){He.get(T).__webglFramebuffer===void 0&&qe.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?qe.setTextureCube(T,0):T.isData3DTexture?qe.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?qe.setTexture2DArray(T,0):qe.setTexture2D(T,0),we.unbindTexture()},this.resetState=function(){$=0,H=0,le=null,we.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return vi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=pt._getDrawingBufferColorSpace(e),t.unpackColorSpace=pt._getUnpackColorSpace()}};var Oa=1e30,v1="1e20",y1=`
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
`,b1=`
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
    base = vField > ${v1} ? noValue : texture2D(scale, vec2(clamp(fraction, 0.0, 1.0) * 0.99609375 + 0.001953125, 0.5)).rgb;
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
`,wi=class extends Mi{cuttable;constructor(e,t,i={},s){super({vertexShader:y1,fragmentShader:b1,defines:Object.fromEntries(t.map(r=>[r,""])),...i}),this.uniforms={cutPlane:e.cutPlane,deformation:e.deformation,limits:e.limits,scale:e.scale,noValue:e.noValue,pixelRatio:e.pixelRatio,colour:s??{value:new rt},opacity:{value:1},useField:{value:!1},bias:{value:0}},this.cuttable=!t.includes("CAP")&&!t.includes("ON_PLANE")}get colour(){return this.uniforms.colour.value}set alpha(e){this.uniforms.opacity.value=e,this.transparent=e<1}set useField(e){this.uniforms.useField.value=e}set bias(e){this.uniforms.bias.value=e}set cut(e){!this.cuttable||e==="CUT"in this.defines||(e?this.defines.CUT="":delete this.defines.CUT,this.needsUpdate=!0)}};function Jg(n){return{cutPlane:{value:new Xt(0,0,1,0)},deformation:{value:0},limits:{value:new xt(0,1)},scale:{value:n},noValue:{value:new rt("#9a9a9a")},lineColour:{value:new rt("#1c2733")},edgeColour:{value:new rt("#1c2733")},pixelRatio:{value:1}}}function td(n,e){let t=e?["COPIES","DEFORMED"]:["COPIES"],i=(r,o)=>new wi(n,t,{side:r,colorWrite:!1,depthWrite:!1,depthTest:!1,stencilWrite:!0,stencilFunc:nu,stencilFail:o,stencilZFail:o,stencilZPass:o}),s=(r,o,a=t)=>{let l=new wi(n,a,{depthWrite:!1},r);return l.alpha=o,l};return{surface:new wi(n,e?["COPIES","DEFORMED","FIELD","LIT"]:["COPIES","LIT"],{polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),features:s(n.lineColour,.55),edges:s(n.edgeColour,.3),stencilBack:i(Bn,Lf),stencilFront:i(Si,Df),section:new wi(n,["FIELD","CAP"],{side:Nn,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),sectionEdges:s(n.edgeColour,.34,["ON_PLANE"])}}function Kg(n){return new wi(n,["CAP"],{side:Nn,stencilWrite:!0,stencilRef:0,stencilFunc:Nf,stencilFail:Ia,stencilZFail:Ia,stencilZPass:Ia})}var cu=class{group=new jt;materials;#e=new on;#t;#n=null;#i;#s="";markLine=new gr(new on,new $s({color:"#e07b1f",transparent:!0,depthTest:!1}));constructor(e){let t=new wi(e,["FIELD"],{side:Nn}),i=new wi(e,["FIELD"],{side:Nn,depthFunc:ao,depthWrite:!1});i.alpha=.5,t.useField=i.useField=!0,this.#i=i,this.materials=[t,i];let s=this.materials.map(r=>new Mt(this.#e,r));for(let r of s)r.frustumCulled=!1,r.matrixAutoUpdate=!1,this.group.add(r);this.#t=s[1],this.#t.renderOrder=99999,s[0].renderOrder=5,this.markLine.geometry.setAttribute("position",new mt(new Float32Array(12),3)),this.markLine.frustumCulled=!1,this.markLine.matrixAutoUpdate=!1,this.markLine.renderOrder=25e4,this.markLine.visible=!1}mark(e,t){let i=e!==null&&t>=0&&t<e.count;if(!i&&!this.markLine.visible)return!1;if(this.markLine.visible=i,!i)return!0;let s=this.markLine.geometry.getAttribute("position");return s.array.set(e.corners.subarray(12*t,12*t+12)),s.needsUpdate=!0,!0}setBias(e){for(let t of this.materials)t.bias=e;this.#i.bias=0}setBehind(e){this.#t.visible=e}get contacts(){return this.#n}set(e,t,i){if(e===this.#n&&t===this.#s||(this.#n=e,this.#s=t,this.mark(null,-1),this.#e.dispose(),this.group.visible=e!==null,!e))return;let s=[];for(let l=0;l<e.count;l++)e.pressures[l]>0&&i(l)&&s.push(l);let r=new Float32Array(12*s.length),o=new Float32Array(4*s.length),a=new Uint32Array(6*s.length);s.forEach((l,c)=>{r.set(e.corners.subarray(12*l,12*l+12),12*c),o.fill(e.pressures[l],4*c,4*c+4);let u=4*c;a.set([u,u+1,u+2,u,u+2,u+3],6*c)}),this.#e.setAttribute("position",new mt(r,3)),this.#e.setAttribute("field",new mt(o,1)),this.#e.setIndex(new mt(a,1))}dispose(){this.#e.dispose(),this.markLine.geometry.dispose();for(let e of this.materials)e.dispose()}},jg={Flank:0,Edge:1};function ka(n,e,t){return t==="all"||n.zones[e]===(t==="edges"?jg.Edge:jg.Flank)}var M1=1.5;function Ba(n,e){return n.pressures.reduce((t,i,s)=>ka(n,s,e)?Math.max(t,i):t,0)}function Qg(n){let e=Ba(n,"flanks");return e>0&&Ba(n,"all")>M1*e}function e0(n){let e=new Map,t=n.corners;for(let i=0;i<n.count;i++){let s=12*i,r=t[s+6]-t[s],o=t[s+7]-t[s+1],a=t[s+8]-t[s+2],l=t[s+9]-t[s+3],c=t[s+10]-t[s+4],u=t[s+11]-t[s+5],f=.5*Math.hypot(o*u-a*c,a*l-r*u,r*c-o*l),h=`${n.parts[2*i]} ${n.parts[2*i+1]}`;e.set(h,(e.get(h)??0)+n.pressures[i]*f)}return e}var uu=class{constructor(e){this.core=e}core;playing=!1;#e=0;toggle(){this.playing?this.stop():this.start()}start(){let e=this.core.positions?.list.length??0;this.playing||e<2||(this.playing=!0,this.play(++this.#e),this.core.changed(!1))}stop(){this.playing&&(this.playing=!1,this.#e++,this.core.changed(!1))}step(e){this.stop();let t=this.next(e,!0);t!==null&&this.core.goTo(t)}next(e,t){let i=this.core.positions?.list.length??0;if(i===0)return null;let s=this.core.state.position+e;return s>=0&&s<i?s:t?(s+i)%i:null}async play(e){let{core:t}=this,i=t.positions?.list.length??0;for(!t.state.animation.loop&&t.state.position===i-1&&await t.goTo(0);e===this.#e;){let s=performance.now()+1e3/Math.max(.1,t.state.animation.speed),r=this.next(1,t.state.animation.loop);if(r===null)break;if(await t.positions?.load(r).catch(()=>null),await new Promise(o=>setTimeout(o,Math.max(0,s-performance.now()))),e!==this.#e)return;await t.goTo(r),await new Promise(requestAnimationFrame)}e===this.#e&&this.stop()}};var t0="CALYXARR";var qt=class extends Error{constructor(t,i){super(`${t}: ${i}`);this.file=t;this.reason=i;this.name="FileError"}file;reason},So=class n{constructor(e,t,i,s){this.name=e;this.header=t;this.buffer=i;this.start=s}name;header;buffer;start;static parse(e,t){if(t.byteLength<16)throw new qt(e,`the file is truncated: it has ${t.byteLength} bytes, the header needs 16`);let i=new DataView(t);if(new TextDecoder("latin1").decode(new Uint8Array(t,0,8))!==t0)throw new qt(e,`not an array file: it does not begin with ${t0}`);let r=i.getUint32(8,!0);if(r<5)throw new qt(e,"written by an older version of Calyx: run the model again");if(r>5)throw new qt(e,`version ${r} of the format is not supported; this viewer reads version 5`);let o=i.getUint32(12,!0),a=16+o;if(a>t.byteLength)throw new qt(e,`the file is truncated: it has ${t.byteLength} bytes, the header ends at ${a}`);let l;try{l=JSON.parse(new TextDecoder("utf-8",{fatal:!0}).decode(new Uint8Array(t,16,o)))}catch{throw new qt(e,"the header is not valid JSON")}if(typeof l!="object"||l===null||Array.isArray(l))throw new qt(e,"the header is not a JSON object");return new n(e,l,t,a)}f32(e,t,i){let{offset:s,length:r}=this.locate(e,"f32",t,i);return new Float32Array(this.buffer,s,r)}f64(e,t,i){let{offset:s,length:r}=this.locate(e,"f64",t,i);return s%8===0?new Float64Array(this.buffer,s,r):new Float64Array(this.buffer.slice(s,s+8*r))}u32(e,t,i){let{offset:s,length:r}=this.locate(e,"u32",t,i);return new Uint32Array(this.buffer,s,r)}locate(e,t,i,s){let r=p=>{throw new qt(this.name,`${s}: ${p}`)};if(typeof e!="object"||e===null)return r("the array is missing");let o=e;if(o.type!==t)return r(`the array has type ${String(o.type)}, expected ${t}`);if(o.components!==i)return r(`the array has ${String(o.components)} components, expected ${i}`);let{count:a,offset:l}=o,c=p=>Number.isSafeInteger(p)&&p>=0;if(!c(a)||!c(l))return r("the size or the offset of the array is not a whole number");let u=t==="f64"?8:4;if(l%u!==0)return r(`the offset ${l} is not aligned`);let f=a*i,h=this.start+l+f*u;if(h>this.buffer.byteLength)return r(`the file is truncated: it has ${this.buffer.byteLength} bytes, the array ends at ${h}`);let d=this.start+l;return d%u!==0?r("the header's length is not a multiple of 8"):{offset:d,length:f}}};var hu=256,nd={viridis:{label:"Viridis",colours:["#440154","#482475","#414487","#355f8d","#2a788e","#21918c","#22a884","#44bf70","#7ad151","#bddf26","#fde725"]},cividis:{label:"Cividis",colours:["#00224e","#123570","#3b496c","#575d6d","#707173","#8a8678","#a59c74","#c3b369","#e1cc55","#fee838"]},turbo:{label:"Turbo",colours:["#30123b","#4145ab","#4675ed","#39a2fc","#1bcfd4","#24eca6","#61fc6c","#a4fc3b","#d1e834","#f3c63a","#fe9b2d","#f36315","#d93806","#b11901","#7a0402"]},grey:{label:"Grey",colours:["#1a1a1a","#f2f2f2"]}},i0=Object.entries(nd).map(([n,{label:e}])=>({name:n,label:e}));function n0(n){let e=parseInt(n.slice(1),16);return[e>>16&255,e>>8&255,e&255]}function er(n,e){let{colours:t}=nd[n]??nd.viridis,i=Math.min(Math.max(e,0),1)*(t.length-1),s=Math.min(Math.floor(i),t.length-2),r=n0(t[s]),o=n0(t[s+1]),a=i-s;return r.map((l,c)=>Math.round(l+a*(o[c]-l)))}function wr(n,e){if(e<1)return n;let t=Math.min(Math.max(Math.floor(n*e),0),e-1);return e===1?.5:t/(e-1)}function Er([n,e,t]){return`rgb(${n} ${e} ${t})`}function s0(n,e,t){let i=n.image.data;for(let r=0;r<hu;r++){let[o,a,l]=er(e,wr(r/(hu-1),t));i.set([o,a,l,255],4*r)}let s=t>0?_n:On;n.minFilter=s,n.magFilter=s,n.needsUpdate=!0}function r0(){let n=new ho(new Uint8Array(4*hu),hu,1,fi);return n.colorSpace=Jn,n}var o0=["#7f9db9","#c9a66b","#8fb09a","#b58a9b","#9a95bd","#b9b08a","#76a9ae","#c08f76"],S1={gear:o0,shaft:["#a9adb3","#b7b2aa","#9ea6ac"],bearing:["#8a8f98","#969089"],body:["#b4bcc4","#c0b9ae","#aab7b0"]};function a0(n,e){let t=S1[n]??o0;return t[e%t.length]}var l0={x:[1,0,0],y:[0,1,0],z:[0,0,1]},fu=class{group=new jt;capGeometry=new xr(2,2);capMatrix=new yt;normal=new G(0,0,1);range=[-1,1];offset=0;#e;#t=new jt;#n=new G;#i=1;#s=new G;constructor(){let e=[-1,-1,0,1,-1,0,1,1,0,-1,1,0],t=new on;t.setAttribute("position",new rn(e,3)),this.#e=new gr(t,new $s({color:"#e07b1f",transparent:!0,opacity:.8}));let i=new qs({color:"#e07b1f",transparent:!0,depthTest:!1}),s=new _r(.022,.05,20).rotateX(Math.PI/2),r=new Mt(s.clone().translate(0,0,.062),i),o=new Mt(s.clone().rotateY(Math.PI).translate(0,0,-.062),i),a=new Mt(new ya(.021,20,14),i);this.#t.add(r,o,a);for(let l of this.#t.children)l.renderOrder=3e5;this.group.add(this.#e,this.#t),this.group.visible=!1}setBounds(e,t){this.#n.copy(e),this.#i=t}apply(e,t){let i=typeof e.normal=="string"?l0[e.normal]??l0.z:e.normal;this.normal.set(i[0],i[1],i[2]),this.normal.lengthSq()>0||this.normal.set(0,0,1),this.normal.normalize();let s=this.normal.dot(this.#n);this.range=[s-this.#i,s+this.#i],this.offset=e.offset??s;let r=e.flipped?-1:1;t.set(r*this.normal.x,r*this.normal.y,r*this.normal.z,-r*this.offset),this.group.visible=e.on;let o=this.#n.clone().addScaledVector(this.normal,this.offset-s),a=new yi().setFromUnitVectors(new G(0,0,1),this.normal),l=1.02*this.#i;this.capMatrix.compose(o,a,new G(1.5*l,1.5*l,1)),this.#e.position.copy(o),this.#e.quaternion.copy(a),this.#e.scale.set(.86*l,.86*l,1),this.#t.quaternion.copy(a),this.#t.position.set(.86*l,.86*l,0).applyQuaternion(a).add(o),this.#t.scale.setScalar(l)}get handle(){return this.#t.position}setHighlight(e){for(let t of this.#t.children)t.material.color.set(e?"#ffa648":"#e07b1f")}drag(e,t,i,s,r){let o=.01*this.#i,a=this.#s.copy(this.handle).project(i),l=a.x,c=a.y,u=this.#s.copy(this.handle).addScaledVector(this.normal,o).project(i),f=(u.x-l)*s/2,h=-(u.y-c)*r/2,d=f*f+h*h;return d<.02?-t*o/2:(e*f+t*h)/d*o}};function w1(n,e,t,i,s,r){let o=Math.max(Math.abs(n),Math.abs(e),Math.abs(t),Math.abs(i),Math.abs(s),Math.abs(r));if(!Number.isFinite(o))return[NaN,NaN,NaN];if(o===0)return[0,0,0];let a=(n+e+t)/3,l=(n-e)/o,c=(e-t)/o,u=(t-n)/o,f=(l-u)/3,h=(c-l)/3,d=(u-c)/3,p=i/o,_=s/o,g=r/o,m=(l*l+c*c+u*u)/6+p*p+_*_+g*g;if(m===0)return[a,a,a];let x=f*(h*d-p*p)-g*(g*d-p*_)+_*(g*p-h*_),M=2*m/3,b=Math.SQRT2,C=f*f+g*g+_*_-M,A=h*h+g*g+p*p-M,v=d*d+p*p+_*_-M,E=b*(_*g-f*p),U=b*(p*g-h*_),L=b*(p*_-d*g),I=b*p,k=b*_,z=b*g,N=(f*A-h*C)**2+(f*v-d*C)**2+(h*v-d*A)**2+(f*E-I*C)**2+(f*U-k*C)**2+(f*L-z*C)**2+(h*E-I*A)**2+(h*U-k*A)**2+(h*L-z*A)**2+(d*E-I*v)**2+(d*U-k*v)**2+(d*L-z*v)**2+(I*U-k*E)**2+(I*L-z*E)**2+(k*L-z*U)**2,W=Math.atan2(Math.sqrt(3*N),Math.sqrt(27)*x)/3,$=2*Math.sqrt(m/3)*o,H=2*Math.PI/3;return[a+$*Math.cos(W),a+$*Math.cos(W-H),a+$*Math.cos(W+H)]}function E1(n,e,t,i,s,r){let o=n-e,a=e-t,l=t-n;return Math.sqrt(.5*(o*o+a*a+l*l)+3*(i*i+s*s+r*r))}function Fn(n){return n!=="plain"&&n!=="contact_pressure"}var Vi={plain:{label:"Plain",quantity:"none"},contact_pressure:{label:"Contact pressure",quantity:"stress"},max_principal:{label:"Maximum principal stress",quantity:"stress"},min_principal:{label:"Minimum principal stress",quantity:"stress"},von_mises:{label:"Von Mises stress",quantity:"stress"},stress_error:{label:"Stress error",quantity:"stress"},displacement:{label:"Displacement",quantity:"length"}},wo={stress_error:"Estimated error of the stresses, as von Mises stress: the difference between the averaged stresses at a node and those of its elements (Zienkiewicz and Zhu). Where it is large, a finer mesh changes the stresses. It is largest at contacts, whose loads are concentrated at nodes: automatic limits leave out the largest values, so that the fillets and the body are visible."},du="Contact pressure and plain colours show the undeformed shape, because contact cells and plain parts have no elastic displacements. Choose a stress or the displacement to see the deformation, or set a factor.";function id(n){return n==="stress_error"?.9:1}function u0(n){return n==="min_principal"?"minimum":"maximum"}function T1(n,e,t){if(e==="displacement"){let h=n.displacements;return Math.hypot(h[3*t],h[3*t+1],h[3*t+2])}if(e==="stress_error")return n.stressErrors?.[t]??NaN;let i=n.stresses;if(!i)return NaN;let s=6*t,[r,o,a,l,c,u]=[i[s],i[s+1],i[s+2],i[s+3],i[s+4],i[s+5]];if(e==="von_mises")return E1(r,o,a,l,c,u);let f=w1(r,o,a,l,c,u);return e==="max_principal"?f[0]:f[2]}function h0(n){let e={min:1/0,max:-1/0,minIndex:-1,maxIndex:-1};for(let t=0;t<n.length;t++){let i=n[t];i<e.min&&i!==-1/0&&(e.min=i,e.minIndex=t),i>e.max&&i!==1/0&&(e.max=i,e.maxIndex=t)}return e.minIndex<0||e.maxIndex<0?null:e}var c0=new WeakMap;function sd(n){let e=c0.get(n);if(e)return e;e=new Uint8Array(n.points.length/3);for(let t=0;t<n.triangles.length;t++)e[n.triangles[t]]=1;return c0.set(n,e),e}function f0(n,e){let t=n.shape.points.length/3,i=new Float64Array(t);for(let s=0;s<t;s++)i[s]=T1(n,e,s);return i}function A1(n){return n.match(/[\s.:/]*[^\s.:/]+/g)??[n]}function d0(n){let e=0;for(;n.every(t=>e+1<t.length&&t[e]===n[0][e]);)e++;return e}function p0(n){let e=[...new Set(n)],t=new Map;if(e.length<2)return new Map(e.map(a=>[a,a]));let i=e.map(A1),s=d0(i),r=i.map(a=>a.slice(s).reverse()),o=d0(r);return e.forEach((a,l)=>t.set(a,r[l].slice(o).reverse().join("").replace(/^[\s.:/]+/,""))),t}var rd=12;function m0(n){return n.length>rd+4?[n.slice(0,-rd),n.slice(-rd)]:["",n]}var C1={Pa:[[1e6,"MPa",1e-6],[1e3,"kPa",.001],[0,"Pa",1]],m:[[1e-4,"mm",1e3],[1e-7,"µm",1e6],[0,"nm",1e9]],N:[[1e3,"kN",.001],[0,"N",1]],"N m":[[1e3,"kN m",.001],[0,"N m",1]],W:[[1e3,"kW",.001],[0,"W",1]],s:[[1,"s",1],[.001,"ms",1e3],[0,"µs",1e6]],rad:[[.1,"rad",1],[1e-4,"mrad",1e3],[0,"µrad",1e6]]},R1={Pa:[[0,"psi",1/6894.757293168361]],m:[[0,"inch",1/.0254]],N:[[0,"lbf",1/4.4482216152605]],"N m":[[0,"lbf inch",1/.1129848290276167]]},g0=!1;function _0(n){g0=/^(inch|ft|foot)_/.test(n)}function xn(n,e){let t=n.replace("·"," "),i=(g0?R1[t]:void 0)??C1[t];if(!i)return{symbol:n==="1"?"":n,factor:1};let s=Math.abs(e);if(!(s>0))return{symbol:i[0][1],factor:i[0][2]};let r=i.find(([o])=>s>=o)??i[i.length-1];return{symbol:r[1],factor:r[2]}}function Ei(){return xn("Pa",0)}var P1="−";function Dt(n,e=4){if(Number.isNaN(n))return"no value";if(n===0)return"0";let t=Math.abs(n),i;if(t>=1e6||t<1e-4)i=n.toExponential(e-1).replace("e+","e");else{let s=Math.max(0,e-1-Math.floor(Math.log10(t)));i=n.toFixed(Math.min(s,12)),i.includes(".")&&(i=i.replace(/\.?0+$/,""))}return i.replaceAll("-",P1)}function x0(n,e,t=4){if(!Number.isFinite(n))return"no value";let i=xn(e,n);return`${Dt(n*i.factor,t)} ${i.symbol}`.trim()}function v0(n){if(!(n>0)||!Number.isFinite(n))return n;let e=10**Math.floor(Math.log10(n)),t=n/e,i=t>=5?5:t>=2?2:1;return Number((i*e).toPrecision(3))}var y0={bearing:"#2f6fb5",mesh:"#c2502b"},I1=new G(0,1,0),pu=class{group=new jt;labels=[];#e=new po(1,1,1,20).translate(0,.5,0);#t=new _r(1,1,24).translate(0,.5,0);#n;#i=new Mt(new on,new qs({transparent:!0}));constructor(e){let t=i=>{let s=new wi(e,["LIT"],{transparent:!0});return s.colour.set(i),s};this.#n={bearing:t(y0.bearing),mesh:t(y0.mesh)},this.#i.renderOrder=2e5,this.#i.frustumCulled=!1,this.#i.onBeforeRender=i=>i.clearDepth()}set(e,t){this.group.clear(),this.labels=[];let i=({kind:o,parts:a})=>o==="mesh"?t.names[a[0]??-1]:void 0,s=p0(e.flatMap(o=>[o.name,i(o)??""]).filter(o=>o!=="")),r=0;for(let{force:o}of e)r=Math.max(r,Math.hypot(...o));if(r>0){this.group.add(this.#i);for(let o of e){if(o.kind==="bearing"?!t.bearings:!t.meshes)continue;let a=Math.hypot(...o.force);if(!(a>0))continue;let l=t.scale*.5*t.radius*a/r,c=this.arrow(o,l,t.radius*.011);this.group.add(c);let u=new G(...o.force).multiplyScalar(l/a).add(new G(...o.point));if(t.labels){let f=s.get(o.name)??o.name,h=i(o),d=h&&s.get(h),p=`${f?`${f}: `:""}${x0(a,"N",3)}${d?` on ${d}`:""}`;this.labels.push({text:p,point:u,kind:o.kind,weight:a})}}}}arrow(e,t,i){let s=this.#n[e.kind],r=new jt,o=Math.min(5.2*i,.45*t),a=new Mt(this.#e,s);a.scale.set(.55*i,t-o,.55*i);let l=new Mt(this.#t,s);l.scale.set(.33*o,o,.33*o),l.position.y=t-o,r.add(a,l),r.position.set(...e.point),r.quaternion.setFromUnitVectors(I1,new G(...e.force).normalize());for(let c of[a,l])c.renderOrder=200001;return r}dispose(){this.#e.dispose(),this.#t.dispose(),this.#i.geometry.dispose(),this.#i.material.dispose();for(let e of Object.values(this.#n))e.dispose()}};var b0=new WeakMap;function Tr(n,e){let t=b0.get(n);if(t?.copies===e)return t.seam;let i=new Int32Array(n.length/3).fill(-1);return e>1&&L1(n,2*Math.PI/e,i),b0.set(n,{copies:e,seam:i}),i}function L1(n,e,t){let i=0;for(let u=0;u<n.length;u++)i=Math.max(i,Math.abs(n[u]));if(!(i>0))return;let s=i*2e-5,r=u=>Math.round(u/s)+65536,o=(u,f,h)=>(r(u)*131072+r(f))*131072+r(h),a=new Map;for(let u=t.length-1;u>=0;u--)a.set(o(n[3*u],n[3*u+1],n[3*u+2]),u);let[l,c]=[Math.cos(e),Math.sin(e)];for(let u=0;u<t.length;u++){let f=l*n[3*u]+c*n[3*u+1],h=l*n[3*u+1]-c*n[3*u],d=n[3*u+2];for(let p=0;p<8;p++){let[_,g,m]=[p&1?-.25:.25,p&2?-.25:.25,p&4?-.25:.25],x=a.get(o(f+_*s,h+g*s,d+m*s));if(!(x===void 0||x===u)){t[u]=x;break}}}}function Eo(n,e){let t=2*Math.PI*(n%e)/e;return[Math.cos(t),Math.sin(t)]}function za(n,e){return[...Eo(n,e),...Eo(n+1,e)]}function mu(n,e){let t=n.slice();return e.forEach((i,s)=>{i>=0&&t.set(n.subarray(3*i,3*i+3),3*s)}),t}function M0(n,e,t,i){let[s,r,o,a]=za(t,i),l=new Float64Array(n.length);for(let c=0;c<e.length;c++){let u=e[c],f=3*(u<0?c:u),[h,d]=u<0?[s,r]:[o,a];l[3*c]=h*n[f]-d*n[f+1],l[3*c+1]=d*n[f]+h*n[f+1],l[3*c+2]=n[f+2]}return l}function S0(n,e,t){t.forEach((i,s)=>{if(!(i<0))for(let r=0;r<3;r++){let o=.5*(n[3*s+r]+e[3*i+r]);n[3*s+r]=e[3*i+r]=o}})}var D1=1e5,N1=["gear","shaft","bearing","body"];function _u(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)?n:null}function ad(n){return Array.isArray(n)?n:[]}function ld(n,e,t,i){for(let s=0;s<t.length;s++)if(t[s]>=i)throw new qt(n,`${e}: index ${t[s]} exceeds the ${i} points`)}function E0(n){let e=So.parse("parts.bin",n);if(!Array.isArray(e.header.parts))throw new qt(e.name,"the list of parts is missing");let t=e.header.parts.map((i,s)=>{let r=_u(i);if(!r)throw new qt(e.name,`part ${s} is not an object`);let o=typeof r.name=="string"?r.name:`part ${s}`,a=Number(r.copies??1);if(!Number.isInteger(a)||a<1||a>D1)throw new qt(e.name,`${o}: the number of copies is not valid`);let l=e.f32(r.points,3,`${o}, points`),c=e.u32(r.triangles,3,`${o}, triangles`),u=r.edges?e.u32(r.edges,2,`${o}, edges`):new Uint32Array;ld(e.name,`${o}, triangles`,c,l.length/3),ld(e.name,`${o}, edges`,u,l.length/3);let f=N1.includes(String(r.kind))?r.kind:"body",h=Number(r.without_mesh??0);if(!Number.isInteger(h)||h<0||3*h>c.length)throw new qt(e.name,`${o}: the number of triangles without a mesh is not valid`);return{index:s,name:o,kind:f,copies:a,withoutMesh:h,open:r.open===!0,points:l,triangles:c,edges:u}});return{model:String(e.header.model??""),units:String(e.header.units??""),parts:t}}function od(n){if(!Array.isArray(n)||n.length!==3)return null;let e=n.map(t=>typeof t=="number"?t:NaN);return e.every(Number.isFinite)?e:null}function F1(n,e){let t=_u(n),i=od(t?.point),s=od(t?.force);return!t||!i||!s?null:{kind:t.kind==="mesh"?"mesh":"bearing",name:String(t.name??""),point:i,force:s,moment:od(t.moment)??[0,0,0],parts:ad(t.parts).filter(r=>typeof r=="number"&&r>=0&&r<e)}}function U1(n,e){let t=_u(e);if(!t)return null;let i=n.f32(t.corners,12,"contacts, corners"),s=n.f32(t.pressures,1,"contacts, pressures"),r=n.u32(t.parts,2,"contacts, parts"),o=n.u32(t.teeth,2,"contacts, teeth"),a=n.u32(t.zones,1,"contacts, zones"),l=n.u32(t.surfaces,2,"contacts, surfaces"),c=s.length,u=[r,o,l].every(({length:f})=>f===2*c);if(i.length!==12*c||a.length!==c||!u)throw new qt(n.name,"contacts: the arrays have different lengths");return c>0?{count:c,corners:i,pressures:s,zones:a,parts:r,teeth:o,surfaces:l}:null}var w0=new WeakMap;function Va({shape:n,copy:e,copies:t}){let i=w0.get(n);i||w0.set(n,i=new Map);let s=i.get(e);return s||i.set(e,s=M0(n.points,Tr(n.points,t),e,t)),s}function ws(n,e,t){let i=Va(n),s=n.displacements,r=3*e;return[i[r]+t*s[r],i[r+1]+t*s[r+1],i[r+2]+t*s[r+2]]}function T0(n,e){let t=So.parse(n,e),{header:i}=t,s=t.f32(i.points,3,"points"),r=(a,l,c)=>{if(!c&&!i[a])return new Uint32Array;let u=t.u32(i[a],l,a);return ld(n,a,u,s.length/3),u},o=i.extruded===!0;if(o&&s.length%6!==0)throw new qt(n,"points: an extruded mesh needs an even number of them");return{name:n,open:i.open===!0,extruded:o,points:s,triangles:r("triangles",3,!0),edges:r("edges",2,!1),tetrahedra:r("tetrahedra",4,!1),wedges:r("wedges",6,!1),hexahedra:r("hexahedra",8,!1)}}var O1=/^mesh-[0-9A-Za-z_-]+\.bin$/;async function B1(n,e,t,i,s){let r=_u(e),o=i[Number(r?.part)];if(!r||!o)throw new qt(n.name,`mesh ${t}: the part does not exist`);let a=`mesh of ${o.name}`,l=Number(r.copy??0);if(!Number.isInteger(l)||l<0||l>=o.copies)throw new qt(n.name,`${a}: the copy does not exist`);let c=String(r.mesh);if(!O1.test(c))throw new qt(n.name,`${a}: the name of the mesh is not valid`);let u=await s(c),f=(g,m,x)=>{let M=`${a}, ${g.replace("_"," ")}`;return u.extruded?z1(n.f32(r[g],x.length,M),m,x):n.f32(r[g],m,M)},h=f("displacements",3,[0,1]),d=r.stresses?f("stresses",6,[0,1,2,5]):null,p=r.stress_errors?f("stress_errors",1,[0]):null,_=u.points.length/3;if(h.length!==3*_||d&&d.length!==6*_||p&&p.length!==_)throw new qt(n.name,`${a}: the values do not fit the ${_} points of ${c}`);return{part:o.index,copy:l,copies:o.copies,shape:u,displacements:h,stresses:d,stressErrors:p}}function k1(n,e){let t=[...n];for(let{index:i,copies:s}of e){let r=n.find(({part:a})=>a===i);if(!r||s===1)continue;let o=new Map(n.filter(({part:a})=>a===i).map(a=>[a.copy,a]));for(let a=0;a<s;a++){if(o.has(a))continue;let l=new Float32Array(r.shape.points.length),c={part:i,copy:a,copies:s,shape:r.shape,displacements:l,stresses:null,stressErrors:null};o.set(a,c),t.push(c)}for(let[a,l]of o){let c=o.get((a+1)%s);c.shape===l.shape&&S0(l.displacements,c.displacements,Tr(l.shape.points,s))}}return t}function z1(n,e,t){let i=n.length/t.length,s=new Float32Array(2*e*i);for(let r=0;r<i;r++)t.forEach((o,a)=>{s[e*r+o]=n[t.length*r+a]});return s.copyWithin(e*i,0,e*i),s}async function A0(n,e,t,i){let s=So.parse(n,e),{header:r}=s,o=s.f64(r.poses,12,"poses");if(o.length!==12*t.length)throw new qt(n,`${o.length/12} poses for ${t.length} parts; the files are from different runs`);let a="",l=u=>i(u).catch(f=>{throw a=f instanceof Error?f.message:String(f),new gu(a)}),c=await Promise.all(ad(r.meshes).map((u,f)=>B1(s,u,f,t,l).catch(h=>{if(h instanceof gu)return null;throw h})));return{position:Number(r.position??0),time:Number(r.time??0),poses:o,contacts:U1(s,r.contacts),forces:ad(r.forces).map(u=>F1(u,t.length)).filter(u=>u!==null),meshes:k1(c.filter(u=>u!==null),t),bytes:e.byteLength,problem:a}}var gu=class extends Error{};function R0({tetrahedra:n,wedges:e,hexahedra:t}){return n.length+e.length+t.length>0}var V1=[[0,1,2],[3,4,5],[0,1,4,3],[1,2,5,4],[2,0,3,5]],H1=[[0,1,2,3],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]];function G1(n,e,t,i,s){let r=0;for(let l=1;l<n.length;l++)e[n[l]]<e[n[r]]&&(r=l);let o=t.map(l=>l.reduce((c,u)=>c|1<<u,0)),a=(...l)=>{let c=l.reduce((u,f)=>u|1<<f,0);return o.some(u=>(u&c)===c)};for(let l of t){if(l.includes(r))continue;let c=0;l.forEach((u,f)=>c=e[n[u]]<e[n[l[c]]]?f:c);for(let u=1;u+1<l.length;u++){let[f,h,d]=[l[c],l[(c+u)%l.length],l[(c+u+1)%l.length]];i.push(n[r],n[f],n[h],n[d]),s.push(1|(a(r,h,d)?2:0)|(a(r,f,d)?4:0)|(a(r,f,h)?8:0))}}}var C0=new WeakMap;function P0(n,e){let t=C0.get(n);if(t)return t;let i=W1(n,e),s=[],r=[];for(let[c,u,f]of[[n.wedges,6,V1],[n.hexahedra,8,H1]])for(let h=0;h<c.length;h+=u)G1(c.subarray(h,h+u),i,f,s,r);let{tetrahedra:o}=n,a=new Uint32Array(o.length+s.length);a.set(o),a.set(s,o.length);let l=new Uint8Array(a.length/4).fill(15);return l.set(r,o.length/4),t={nodes:a,borders:l},C0.set(n,t),t}function W1(n,e){return Float64Array.from(Tr(n.points,e),(t,i)=>t<0?i:t+.5)}var X1=1e-13,vu=class{points=new Float32Array(9*1024);values=new Float32Array(3*1024);sources=new Uint32Array(1024);count=0;edges=new Float32Array(6*2048);edgeCount=0;#e=new Float64Array;#t=[];#n=new Float64Array(12);#i=new Float64Array(4);compute(e,t,i,s,r,o){let{nodes:a,borders:l}=P0(e.shape,e.copies),c=this.measure(e,i,s);this.count=0,this.edgeCount=0;for(let u=0;u<a.length;u+=4){let f=(c[a[u]]<0?1:0)|(c[a[u+1]]<0?2:0)|(c[a[u+2]]<0?4:0)|(c[a[u+3]]<0?8:0);if(f===0||f===15)continue;let h=r?l[u/4]:0,d=q1[f],p=d.length/3;for(let _=0;_<p;_++)this.cross(e,t,s,o,a[u+d[3*_]],a[u+d[3*_+1]],_);this.push(u/4,0,1,2),p===4&&this.push(u/4,0,2,3);for(let _=0;h&&_<p;_++)h&1<<d[3*_+2]&&this.pushEdge(_,(_+1)%p)}}measure(e,[t,i,s,r],o){let a=this.#t=Va(e),l=e.displacements,c=a.length/3;this.#e.length<c&&(this.#e=new Float64Array(c));let u=this.#e;for(let f=0,h=0;f<c;f++,h+=3)u[f]=t*(a[h]+o*l[h])+i*(a[h+1]+o*l[h+1])+s*(a[h+2]+o*l[h+2])+r;return u}cross(e,t,i,s,r,o,a){let l=this.#t,c=e.displacements,u=this.#e[r],f=u/(u-this.#e[o]),h=3*r,d=3*o;for(let _=0;_<3;_++){let g=l[h+_]+i*c[h+_];this.#n[3*a+_]=g+f*(l[d+_]+i*c[d+_]-g)}let p=t?t[r]+f*(t[o]-t[r]):NaN;this.#i[a]=Number.isFinite(p)?p:s}push(e,t,i,s){this.count===this.sources.length&&(this.points=xu(this.points,Float32Array),this.values=xu(this.values,Float32Array),this.sources=xu(this.sources,Uint32Array));let r=this.count++,o=this.#n;this.sources[r]=e;for(let a=0;a<3;a++){let l=a===0?t:a===1?i:s;this.values[3*r+a]=this.#i[l];for(let c=0;c<3;c++)this.points[9*r+3*a+c]=o[3*l+c]}}pushEdge(e,t){6*this.edgeCount===this.edges.length&&(this.edges=xu(this.edges,Float32Array));let i=6*this.edgeCount++;for(let s=0;s<3;s++)this.edges[i+s]=this.#n[3*e+s],this.edges[i+3+s]=this.#n[3*t+s]}find(e,t,i,s){let r=[Math.abs(s[0]),Math.abs(s[1]),Math.abs(s[2])],o=r[0]>=r[1]&&r[0]>=r[2]?0:r[1]>=r[2]?1:2,[a,l]=o===0?[1,2]:o===1?[2,0]:[0,1],c=[e,t,i],[u,f]=[c[a],c[l]];for(let h=0;h<this.count;h++){let d=9*h,{points:p}=this,[_,g]=[p[d+a]-u,p[d+l]-f],[m,x]=[p[d+3+a]-u,p[d+3+l]-f],[M,b]=[p[d+6+a]-u,p[d+6+l]-f],C=_*x-g*m,A=m*b-x*M,v=M*g-b*_;if(!(Math.abs(C+A+v)<=X1*(_*_+g*g+m*m+x*x+M*M+b*b))&&(C>=0&&A>=0&&v>=0||C<=0&&A<=0&&v<=0))return h}return-1}};function xu(n,e){let t=new e(2*n.length);return t.set(n),t}var q1=Array.from({length:16},(n,e)=>{let t=[0,1,2,3].filter(c=>e&1<<c),i=[0,1,2,3].filter(c=>!(e&1<<c));if(t.length===2&&i.length===2){let[c,u,f,h]=[t[0],t[1],i[0],i[1]];return[c,f,u,c,h,f,u,h,c,u,f,h]}let[s,r]=t.length===1?[t[0],i]:[i[0],t];if(r.length!==3)return[];let[o,a,l]=r;return[s,o,l,s,a,o,s,l,a]});function I0(n,e,t,i){let s=P0(n.shape,n.copies).nodes,r=[0,1,2,3].map(f=>s[4*e+f]),o=r.map(f=>ws(n,f,t)),a=(f,h)=>[h[0]-f[0],h[1]-f[1],h[2]-f[2]],l=(f,h,d,p)=>{let[_,g,m]=[a(f,h),a(f,d),a(f,p)];return _[0]*(g[1]*m[2]-g[2]*m[1])+_[1]*(g[2]*m[0]-g[0]*m[2])+_[2]*(g[0]*m[1]-g[1]*m[0])},c=l(o[0],o[1],o[2],o[3]),u=[0,1,2,3].map(f=>{let h=o.map((d,p)=>p===f?i:d);return l(h[0],h[1],h[2],h[3])/c});return{nodes:r,weights:u}}var yu=class{section=new vu;objects;plane=null;#e=[];#t=new on;#n=new on;constructor(e){this.objects=[new Mt(this.#t,e.section),new Oi(this.#n,e.sectionEdges)],this.objects.forEach((t,i)=>{t.frustumCulled=!1,t.matrixAutoUpdate=!1,t.visible=!1,t.renderOrder=1e5+2*i})}hide(){this.plane=null;for(let e of this.objects)e.visible=!1}update(e,t,i,s,r){this.plane=i;let o=[e,t,...i,s,r],a=o.every((l,c)=>l===this.#e[c]);if(!a){this.#e=o,this.section.compute(e,t,i,s,r,Oa);let{points:l,values:c,count:u,edges:f,edgeCount:h}=this.section;cd(this.#t,"position",l,3,3*u),cd(this.#t,"field",c,1,3*u),cd(this.#n,"position",f,3,2*h),this.#t.setDrawRange(0,3*u),this.#n.setDrawRange(0,2*h)}return this.objects[0].visible=this.section.count>0,this.objects[1].visible=r&&this.section.edgeCount>0,!a}dispose(){this.#t.dispose(),this.#n.dispose()}};function cd(n,e,t,i,s){let r=n.getAttribute(e);r?.array!==t&&(n.dispose(),r=new mt(t,i).setUsage(Qs),n.setAttribute(e,r)),r.clearUpdateRanges(),r.addUpdateRange(0,i*s),r.needsUpdate=!0}var ud=Math.cos(32*Math.PI/180),To=n=>n===2147483648?0:n;function $1(n){let e=n.length/3,t=new Uint32Array(n.buffer,n.byteOffset,n.length),i=1;for(;i<2*e;)i*=2;let s=new Uint32Array(i),r=new Uint32Array(e);for(let o=0;o<e;o++){let[a,l,c]=[To(t[3*o]),To(t[3*o+1]),To(t[3*o+2])],u=Math.imul(a,2654435761)^Math.imul(l,2246822507)^Math.imul(c,3266489909);for(u=(u^u>>>15)&i-1;;){let f=s[u];if(f===0){s[u]=o+1,r[o]=o;break}let h=3*(f-1);if(To(t[h])===a&&To(t[h+1])===l&&To(t[h+2])===c){r[o]=f-1;break}u=u+1&i-1}}return r}function Y1(n,e){let t=new Uint32Array(e+1);for(let r=0;r<n.length;r++)t[n[r]+1]++;for(let r=0;r<e;r++)t[r+1]+=t[r];let i=t.slice(0,e),s=new Uint32Array(n.length);for(let r=0;r<n.length;r++)s[i[n[r]]++]=r;return{starts:t,corners:s}}function Z1(n,e){let t=new Float32Array(e.length);for(let i=0;i<e.length;i+=3){let s=3*e[i],r=3*e[i+1],o=3*e[i+2],a=n[r]-n[s],l=n[r+1]-n[s+1],c=n[r+2]-n[s+2],u=n[o]-n[s],f=n[o+1]-n[s+1],h=n[o+2]-n[s+2];t[i]=l*h-c*f,t[i+1]=c*u-a*h,t[i+2]=a*f-l*u}return t}function J1(n,e,t,i,s){for(let r=e[i];r<e[i+1];r++){let o=t[r],a=o-o%3;if(n[a+(o+1)%3]===s)return a}return-1}function K1(n,e,t){let i=new Map,s=(r,o,a)=>i.set(r,[...i.get(r)??[],[o,a]]);return n.forEach((r,o)=>{r<0||e[o]!==o||!t[o]||(s(o,e[r],1),s(e[r],o,-1))}),i}function Ha(n,e,t){let i=n.length/3,s=$1(n),r=e.map(_=>s[_]),{starts:o,corners:a}=Y1(r,i),l=Z1(n,e),c=new Uint8Array(i),u=[];for(let _=0;_<e.length;_++){let g=_-_%3,m=r[_],x=r[g+(_+1)%3];if(m===x)continue;let M=J1(r,o,a,x,m);M<0?(c[m]=c[x]=1,t===1&&u.push(_)):g<M&&fd(l,g,l,M)<ud&&u.push(_)}let f=Tr(n,t),h=K1(f,s,c),d=j1(e,s,t,o,a,l,h),p=new Uint32Array(2*u.length);return u.forEach((_,g)=>{let m=_-_%3;p[2*g]=d.triangles[_],p[2*g+1]=d.triangles[m+(_+1)%3]}),{...d,features:p,seam:f}}var hd=(n,e,t)=>Math.sqrt(n*n+e*e+t*t);function fd(n,e,t,i){let s=n[e]*t[i]+n[e+1]*t[i+1]+n[e+2]*t[i+2],r=hd(n[e],n[e+1],n[e+2])*hd(t[i],t[i+1],t[i+2]);return r>0?s/r:1}function j1(n,e,t,i,s,r,o){let a=e.length,l=[],c=[],u=new Uint32Array(a),f=new Uint32Array(n.length),h=2*Math.PI/t;for(let d=0;d<a;d++){let p=l.length;u[d]=p;let _=e[d],g=eE(_,o,i,s,r,h);for(let m=i[_];m<i[_+1];m++){let x=s[m];if(n[x]!==d)continue;let M=x-x%3,b=0,C=0,A=0;for(let U=i[_];U<i[_+1];U++){let L=s[U]-s[U]%3;L!==M&&fd(r,M,r,L)<ud||(b+=r[L],C+=r[L+1],A+=r[L+2])}for(let U=0;U<g.length;U+=3)fd(r,M,g,U)<ud||(b+=g[U],C+=g[U+1],A+=g[U+2]);let v=hd(b,C,A)||1;b/=v,C/=v,A/=v;let E=p;for(;E<l.length;){let U=3*E;if(c[U]*b+c[U+1]*C+c[U+2]*A>.99999)break;E++}E===l.length&&(l.push(d),c.push(b,C,A)),f[x]=E}l.length===p&&(l.push(d),c.push(0,0,1))}return{nodes:Uint32Array.from(l),firstVertex:u,normals:Float32Array.from(c),triangles:f}}var Q1=[];function eE(n,e,t,i,s,r){let o=e.get(n);if(!o)return Q1;let a=[];for(let[l,c]of o){let u=Math.cos(c*r),f=Math.sin(c*r);for(let h=t[l];h<t[l+1];h++){let d=i[h]-i[h]%3;a.push(u*s[d]-f*s[d+1],f*s[d]+u*s[d+1],s[d+2])}}return a}var dd=[48,32,16,8],tE=1.6;function L0(n){let e=-1;return dd.forEach((t,i)=>{n<=tE*t&&(e=i)}),e}function nE(n,e,t){let[i,s,r]=[Math.abs(n),Math.abs(e),Math.abs(t)];return i>=s&&i>=r?n>0?0:1:s>=r?e>0?2:3:t>0?4:5}function iE({nodes:n,features:e,seam:t}){let i=new Uint32Array(t.length);for(let s of e)i[n[s]]++;return Uint8Array.from(i,s=>s===0?0:s===2?1:2)}function sE(n,e,t){let{seam:i}=e,s=iE(e),r=new Set(i),o=new Map,a=new Uint32Array(i.length),l=new Map,c=[],u=[],f=d=>{let p=o.get(d);return p===void 0&&(p=o.size,o.set(d,p),c.push(0,0,0,0),u.push(0)),p};for(let d=0;d<i.length;d++){let p=i[d],_=3*(p<0?d:p),[g,m,x]=[n[_],n[_+1],n[_+2]],M=`${Math.floor(g/t)},${Math.floor(m/t)},${Math.floor(x/t)}`,b=f(p>=0?`last ${M}`:r.has(d)?`first ${M}`:M);p>=0&&l.set(b,f(`first ${M}`)),a[d]=b,!(s[d]<u[b])&&(s[d]>u[b]&&c.fill(0,4*b,4*b+4),u[b]=s[d],[g,m,x,1].forEach((C,A)=>c[4*b+A]+=C))}let h=Float32Array.from({length:3*u.length},(d,p)=>{let _=l.get(Math.floor(p/3))??Math.floor(p/3);return c[4*_+p%3]/c[4*_+3]});return{cellOf:a,lastCells:l,places:h}}function D0(n,e,t,i){let{nodes:s,normals:r,triangles:o}=e,{cellOf:a,lastCells:l,places:c}=sE(n,e,i),u=new Map,f=[],h=[],d=new Uint32Array(s.length);for(let m=0;m<s.length;m++){let x=a[s[m]],[M,b,C]=[r[3*m],r[3*m+1],r[3*m+2]],A=6*x+nE(M,b,C),v=u.get(A);v===void 0&&(v=u.size,u.set(A,v),f.push(x),h.push(0,0,0)),h[3*v]+=M,h[3*v+1]+=b,h[3*v+2]+=C,d[m]=v}let p={points:Float32Array.from(f.flatMap(m=>[...c.subarray(3*m,3*m+3)])),normals:new Float32Array(h.length),seam:Float32Array.from(f,m=>l.has(m)?1:0)};for(let m=0;m<h.length;m+=3){let x=Math.hypot(h[m],h[m+1],h[m+2])||1;for(let M=0;M<3;M++)p.normals[m+M]=h[m+M]/x}let _=[];for(let m=0;m<o.length;m+=3){let[x,M,b]=[d[o[m]],d[o[m+1]],d[o[m+2]]],[C,A,v]=[f[x],f[M],f[b]];C!==A&&A!==v&&v!==C&&_.push(x,M,b)}let g=_.filter((m,x)=>rE(p,_,x-x%3,t));return{...p,closed:Uint32Array.from(_),triangles:Uint32Array.from(g)}}function rE({points:n,normals:e,seam:t},i,s,r){let[o,a]=Eo(1,r),l=i.slice(s,s+3).map(x=>{let[M,b,C]=n.subarray(3*x,3*x+3);return t[x]?[o*M-a*b,a*M+o*b,C]:[M,b,C]}),c=x=>l[x].map((M,b)=>M-l[0][b]),[[u,f,h],[d,p,_]]=[c(1),c(2)],g=[f*_-h*p,h*d-u*_,u*p-f*d],m=0;for(let x=s;x<s+3;x++)for(let M=0;M<3;M++)m+=g[M]*e[3*i[x]+M];return m>=0}function Ga(n,e,t=new Float32Array(3*e.length)){for(let i=0;i<e.length;i++){let s=3*e[i];t[3*i]=n[s],t[3*i+1]=n[s+1],t[3*i+2]=n[s+2]}return t}function pd({nodes:n,seam:e}){return Float32Array.from(n,t=>e[t]<0?0:1)}var Wa=class{constructor(e,t,i){this.input=e;this.total=i;let{surface:s,points:r}=e;this.#s=i,this.triangleCount=s.triangles.length/3,this.box=new ti().setFromArray(Ga(r,s.nodes));let o=new mt(Ga(mu(r,s.seam),s.nodes),3),a=new mt(pd(s),1);this.sphere=this.box.getBoundingSphere(new jn),this.#r=new mr(new Float32Array(4*i),4),this.#r.setUsage(Qs);let l=(d,p=!1)=>{let _=new Ks;return _.setAttribute("position",o),_.setAttribute("seam",a),_.setAttribute("copyRotation",this.#r),p&&_.setAttribute("normal",new mt(s.normals,3)),_.setIndex(new mt(d,1)),_.instanceCount=i,_},c=Uint32Array.from(e.edges,d=>s.firstVertex[d]),u=l(s.triangles,!0),f=l(s.features),h=l(c);this.#e=[u,f,h],this.#t={shown:u,closed:u},this.surface=new Mt(u,t.surface),this.features=new Oi(f,t.features),this.edges=new Oi(h,t.edges),this.stencils=[new Mt(u,t.stencilBack),new Mt(u,t.stencilFront)];for(let d of[this.surface,this.features,this.edges,...this.stencils])d.frustumCulled=!1,d.matrixAutoUpdate=!1,this.group.add(d);this.group.matrixAutoUpdate=!1,this.setCopies(Array.from({length:i},(d,p)=>p),i)}input;total;group=new jt;surface;features;edges;stencils;triangleCount;sphere;box;#e;#t;#n=[];#i=-1;#s;#r;setLevel(e){if(e===this.#i)return;this.#i=e;let t=e<0?this.#t:this.#n[e]??=this.coarse(e);t.shown.instanceCount=t.closed.instanceCount=this.#s,this.surface.geometry=t.shown;for(let i of this.stencils)i.geometry=t.closed}coarse(e){let t=2*this.sphere.radius/dd[e],i=D0(this.input.points,this.input.surface,this.total,t),s={position:new mt(i.points,3),normal:new mt(i.normals,3),seam:new mt(i.seam,1),copyRotation:this.#r},r=o=>{let a=new Ks;for(let[l,c]of Object.entries(s))a.setAttribute(l,c);return a.setIndex(new mt(o,1)),this.#e.push(a),a};return{shown:r(i.triangles),closed:r(i.closed)}}get drawnTriangles(){return this.surface.geometry.index.count/3}setCopies(e,t){let i=this.#r,s=i.array;for(let r=0;r<t;r++)s.set(za(e[r],this.total),4*r);i.clearUpdateRanges(),i.addUpdateRange(0,4*t),i.needsUpdate=!0,this.#s=t;for(let r of this.#e)r.instanceCount=t;this.group.visible=t>0}dispose(){for(let e of this.#e)e.dispose()}};var N0=new WeakMap;function oE(n,e){let t=N0.get(n);return t||N0.set(n,t=Ha(n.points,n.triangles,e)),t}var md=class{constructor(e,t){this.shape=e;let i=oE(e,t);this.surface=i,this.position=new mt(Ga(mu(e.points,i.seam),i.nodes),3),this.seam=new mt(pd(i),1),this.normal=new mt(i.normals,3),this.triangles=new mt(i.triangles,1),this.features=new mt(i.features,1),this.edges=new mt(Uint32Array.from(e.edges,s=>i.firstVertex[s]),1)}shape;surface;position;seam;normal;triangles;features;edges},gd=class{constructor(e,t){this.buffers=e;let{surface:i,shape:s}=e,r=i.nodes.length;this.triangleCount=s.triangles.length/3,this.#t=new mt(new Float32Array(3*r),3).setUsage(Qs),this.#n=new mt(new Float32Array(r).fill(Oa),1).setUsage(Qs);let o=u=>{let f=new Ks;return f.setAttribute("position",e.position),f.setAttribute("seam",e.seam),f.setAttribute("normal",e.normal),f.setAttribute("displacement",this.#t),f.setAttribute("field",this.#n),f.setAttribute("copyRotation",this.#i),f.setIndex(u),f.instanceCount=1,f},a=o(e.triangles),l=o(e.features),c=o(e.edges);this.surface=new Mt(a,t.surface),this.features=new Oi(l,t.features),this.edges=new Oi(c,t.edges),this.stencils=[new Mt(a,t.stencilBack),new Mt(a,t.stencilFront)],this.#e=[a,l,c],this.section=R0(s)?new yu(t):null;for(let u of[this.surface,this.features,this.edges,...this.stencils])u.frustumCulled=!1,u.matrixAutoUpdate=!1,this.group.add(u);this.section&&this.group.add(...this.section.objects),this.group.matrixAutoUpdate=!1}buffers;group=new jt;surface;features;edges;stencils;section;triangleCount;mesh=null;values=null;#e;#t;#n;#i=new mr(new Float32Array(4),4);get open(){return this.buffers.shape.open}set(e){e!==this.mesh&&(this.mesh=e,this.values=null,this.#i.setXYZW(0,...za(e.copy,e.copies)),this.#i.needsUpdate=!0,Ga(e.displacements,this.buffers.surface.nodes,this.#t.array),this.#t.needsUpdate=!0)}setField(e){if(e===this.values)return;this.values=e;let t=this.#n.array,{nodes:i}=this.buffers.surface;for(let s=0;s<i.length;s++){let r=e[i[s]];t[s]=Number.isFinite(r)?r:Oa}this.#n.needsUpdate=!0}dispose(){for(let e of this.#e)e.dispose();this.section?.dispose()}},bu=class{#e=new Map;#t=new Map;display(e,t){let i=new Map([...this.#t].map(([o,a])=>[o,[...a]])),s=o=>`${o.part} ${o.shape.name}`,r=e.map(o=>{let a=i.get(s(o))??[],l=a.findIndex(c=>c.mesh?.copy===o.copy&&c.mesh.shape===o.shape);return l<0?null:a.splice(l,1)[0]});return e.map((o,a)=>{let l=i.get(s(o))??[],c=r[a]?-1:l.findIndex(f=>f.mesh?.shape===o.shape),u=r[a]??(c<0?this.create(o,t(o.part)):l.splice(c,1)[0]);return u.set(o),u})}create(e,t){let i=this.#e.get(e.shape);i||this.#e.set(e.shape,i=new md(e.shape,e.copies));let s=new gd(i,t),r=`${e.part} ${e.shape.name}`;return this.#t.set(r,[...this.#t.get(r)??[],s]),s}dispose(){for(let e of this.#t.values())for(let t of e)t.dispose();this.#t.clear(),this.#e.clear()}};var aE=.28,F0=7,lE=6e4,Su=class{constructor(e,t,i,s){this.part=e;this.#i=new rt(s),this.#s=new rt("#b4b9bf").lerp(this.#i,.4),this.#e=td(t,!1),this.#t=td(t,!0),this.#n=Kg(t),this.surface=Ha(e.points,e.triangles,e.copies),this.copies=new Wa({...e,surface:this.surface},this.#e,e.copies),this.#r=Array.from({length:e.copies},(o,a)=>a),this.#a=new Uint32Array(e.copies);let r=0;for(let o=0;o<e.points.length;o+=3)r=Math.max(r,e.points[o]**2+e.points[o+1]**2+e.points[o+2]**2);this.radius=Math.sqrt(r),this.group.matrixAutoUpdate=!1,this.restTriangles=e.triangles.subarray(e.triangles.length-3*e.withoutMesh),this.rest=e.withoutMesh>0?this.createRest():null,this.group.add(this.copies.group),this.rest&&this.group.add(this.rest.group),this.cap=new Mt(i,this.#n),this.cap.frustumCulled=!1,this.cap.matrixAutoUpdate=!1,this.cap.onAfterRender=o=>o.clearStencil(),this.#p=e.index,this.#t.section.polygonOffsetUnits-=cE*e.index,this.refresh()}part;group=new jt;cap;copies;surface;radius;restTriangles;meshes=[];visibility="visible";present=!0;#e;#t;#n;#i;#s;#r;#o=[];rest;#a;#l=-1;#u=NaN;#c=!1;#d=!1;#h=!1;#f=!1;#p;get materials(){return[...Object.values(this.#e),...Object.values(this.#t),this.#n]}setMeshes(e,t){for(let i of this.meshes)e.includes(i)||this.group.remove(i.group);for(let i of e)i.group.parent!==this.group&&this.group.add(i.group);this.meshes=e,this.#r=[];for(let i=0;i<this.part.copies;i++)t.has(i)||this.#r.push(i);this.#u=NaN,this.#o=[...t],this.rest?.setCopies(this.#o,this.#o.length),this.refresh()}createRest(){let{points:e,copies:t,edges:i}=this.part,s=this.restTriangles.reduce((o,a)=>Math.min(o,a),1/0),r=Ha(e,this.restTriangles,t);return new Wa({points:e,surface:r,edges:i.filter((o,a)=>i[a-a%2]>=s)},this.#e,t)}get replacedCopies(){return this.#o}get meshMaterials(){return this.#t}get presentCopies(){return this.#r}setVisibility(e){this.visibility=e,this.refresh()}setFieldMode(e){this.#c=e,this.refresh()}setEdges(e){this.#d=e,this.refresh()}setSections(e){e!==this.#f&&(this.#f=e,this.refresh())}get showsField(){return this.#c}get showsSections(){return this.#f&&this.#h&&this.group.visible}setCut(e){this.#h=e;for(let t of this.materials)t.cut=e;this.refresh()}setPresent(e){this.present=e,this.refresh()}refresh(){let e=this.visibility==="translucent",t=this.visibility!=="hidden"&&this.present;this.group.visible=t,this.cap.visible=t&&this.#h&&!this.part.open;let i=e?aE:1;for(let r of[this.#e,this.#t]){r.surface.alpha=i,r.surface.depthWrite=!e;let o=this.part.open||this.#h;r.surface.side=o&&!e?Nn:Si,r.surface.colour.copy(this.#c?this.#s:this.#i),r.features.alpha=e?.25:.5,r.edges.alpha=e?.12:.34,r.stencilBack.transparent=r.stencilFront.transparent=e}this.#t.surface.useField=this.#t.section.useField=this.#c,this.#t.section.colour.copy(this.#c?this.#s:this.#i).multiplyScalar(.86),this.#n.alpha=e?.5:1,this.#n.depthWrite=!e,this.#n.colour.copy(this.#c?this.#s:this.#i).multiplyScalar(.86);let s=10+3*this.#p;this.cap.renderOrder=s+2;for(let r of[this.copies,...this.rest?[this.rest]:[],...this.meshes])r.edges.visible=this.#d,r.surface.renderOrder=e?1e5:0,r.features.renderOrder=r.edges.renderOrder=100001;this.refreshStencils(this.copies.stencils,s,!0),this.rest&&this.refreshStencils(this.rest.stencils,s,!0);for(let r of this.meshes){let o=!r.open&&!(this.#f&&r.section);this.refreshStencils(r.stencils,s,o)}}refreshStencils(e,t,i){e.forEach((s,r)=>{s.visible=i&&this.#h&&!this.part.open,s.renderOrder=t+r})}prepare(e,t){if(!this.group.visible)return 0;let{sphere:i}=this.copies,s=0,r=0,o=0,a=this.group.matrixWorld;Mu.radius=i.radius;for(let f of this.#r){let[h,d]=Eo(f,this.part.copies),{x:p,y:_,z:g}=i.center;Mu.center.set(h*p-d*_,d*p+h*_,g).applyMatrix4(a),e.intersectsSphere(Mu)&&(this.#a[s++]=f,r=(r*31+f+1)%4294967291,o=Math.max(o,i.radius*2*t(Mu.center)))}(s!==this.#l||r!==this.#u)&&(this.copies.setCopies(this.#a,s),this.#l=s,this.#u=r);let l=this.part.copies>1?2*Math.PI*this.radius/this.part.copies:2*i.radius,c=o*Math.min(l,2*i.radius)/(2*i.radius||1);this.copies.features.visible=c>F0,this.copies.edges.visible=this.#d&&c>2*F0,this.copies.setLevel(s*this.copies.triangleCount>lE?L0(o):-1);let u=s*this.copies.drawnTriangles+this.#o.length*this.part.withoutMesh;for(let f of this.meshes)u+=f.triangleCount;return u}dispose(){this.copies.dispose(),this.rest?.dispose();for(let e of this.materials)e.dispose()}},cE=8,Mu=new jn;function wu(){return{version:1,camera:null,parts:{},colours:{field:"plain",scale:"viridis",bands:0,limits:"position",min:0,max:1,cells:"all"},deformation:{mode:"automatic",factor:1},mesh_edges:!1,hidden_contacts:!0,extremes:!0,forces:{bearings:!1,meshes:!1,labels:!0,scale:1},cut:{on:!1,normal:"z",offset:null,flipped:!1},frame:null,position:0,animation:{speed:10,loop:!0},theme:"system",panels:{parts:!0,settings:!1,plots:!1,pattern:!1},pattern:{gear:"",tooth:"all",flank:"automatic",envelope:!1},plotted:[]}}function Eu(n,e=wu()){let t=structuredClone(e),i=n??{};for(let[s,r]of Object.entries(t)){let o=i[s];if(o===void 0||s==="version")continue;_d(r)&&s!=="parts"&&s!=="camera"?_d(o)&&(t[s]=uE(r,o)):s==="camera"?hE(o)&&(t[s]=o):s==="frame"?(o===null||typeof o=="string")&&(t[s]=o):typeof o==typeof r&&o!==null&&(t[s]=o)}return structuredClone(t)}function _d(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)}function uE(n,e){let t={...n};for(let i of Object.keys(n)){let s=e[i];s!==void 0&&(i==="normal"||i==="offset"||typeof s==typeof n[i])&&(t[i]=s)}return t}function hE(n){return!_d(n)||!Array.isArray(n.target)||n.target.length!==3?!1:[...n.target,n.azimuth,n.elevation,n.height].every(t=>typeof t=="number"&&Number.isFinite(t))&&(n.projection==="perspective"||n.projection==="orthographic")}function Xa(n,e){return n.parts[e.name]??(e.kind==="body"?"translucent":"visible")}var fE=.05,dE=30,pE=1e-4,Au=class{constructor(e){this.scene=e;this.contacts=new cu(e.uniforms),this.forces=new pu(e.uniforms),e.root.add(this.contacts.group,this.contacts.markLine,this.forces.group),e.scene.add(this.cut.group)}scene;views=[];position=null;meshes=[];colours=[];factor=0;limits=null;clipped=null;triangles=0;cut=new fu;contacts;forces;centre=new G;radius=1;sectionTime=0;#e=new bu;#t=[];#n=new WeakMap;#i=new WeakMap;#s=!1;#r=!1;#o=null;#a=new yt;#l=!1;setParts(e,t){this.clear();let i=new Map;this.#o=t?.poses??null,this.colours=e.map(({kind:r})=>{let o=i.get(r)??0;return i.set(r,o+1),a0(r,o)}),this.views=e.map((r,o)=>{let a=new Su(r,this.scene.uniforms,this.cut.capGeometry,this.colours[o]);return this.scene.root.add(a.group),this.scene.scene.add(a.cap),a}),this.meshes=e.map(()=>[]);let s=new ti().setFromPoints(this.views.flatMap(r=>this.outline(r))).getBoundingSphere(new jn);this.centre.copy(s.center),this.radius=s.radius>0?s.radius:1,this.contacts.setBias(8e-4*this.radius),this.cut.setBounds(this.centre,this.radius),this.updateBounds()}updateBounds(){let e=this.views.filter(i=>i.visibility!=="hidden"),t=(e.length>0?e:this.views).flatMap(i=>this.outline(i));this.scene.camera.setBounds(this.centre,this.radius*1.1,t)}outline(e){let t=Es(this.#o,e.part.index,new yt),{min:i,max:s}=e.copies.box,r=[];if(e.part.points.length===0||!Tu(this.#o,e.part.index))return r;if(e.part.copies>1){let o=0,a=e.part.points;for(let l=0;l<a.length;l+=3)o=Math.max(o,Math.hypot(a[l],a[l+1]));for(let l=0;l<24;l++){let c=2*Math.PI*l/24;for(let u of[i.z,s.z])r.push(new G(o*Math.cos(c),o*Math.sin(c),u))}}else for(let o=0;o<8;o++)r.push(new G(o&1?s.x:i.x,o&2?s.y:i.y,o&4?s.z:i.z));return r.map(o=>o.applyMatrix4(t))}setPosition(e){this.position=e,this.meshes=this.views.map(()=>[]);let t=this.views.map(()=>[]),i=this.views.map(()=>new Set);this.#t=this.#e.display(e?.meshes??[],s=>this.views[s].meshMaterials),e?.meshes.forEach((s,r)=>{this.meshes[s.part].push(s),t[s.part].push(this.#t[r]),i[s.part].add(s.copy)}),this.views.forEach((s,r)=>{Es(e?.poses??null,r,s.group.matrix),s.setPresent(Tu(e?.poses??null,r)),s.setMeshes(t[r],i[r])})}values(e,t){let i=this.#n.get(e);i||this.#n.set(e,i=new Map);let s=i.get(t);return s||i.set(t,s=f0(e,t)),s}limitsOf(e,t){return this.automaticLimits(e,t,this.extremes(e,t))}automaticLimits(e,t,i){if(!i)return null;let s=id(t.colours.field);if(s===1)return[i.min.value,i.max.value];let r=this.surfaceValues(e,t).filter(o=>o>pE*i.max.value).sort();return[i.min.value,r[Math.floor(s*(r.length-1))]??i.max.value]}surfaceValues(e,t){let i=t.colours.field,s=e.meshes.filter(({part:a})=>this.shown(t,a)),r=new Float64Array(s.reduce((a,l)=>a+l.shape.points.length/3,0)),o=0;for(let a of s){let l=sd(a.shape);this.values(a,i).forEach((c,u)=>{l[u]&&Number.isFinite(c)&&(r[o++]=c)})}return r.subarray(0,o)}clippedBy(e,t,i){let{field:s,limits:r}=t.colours;if(!e||!i||!this.position||r==="fixed"||id(s)===1)return null;let o=this.surfaceValues(this.position,t),a=o.reduce((l,c)=>l+(c>e[1]?1:0),0);return a>0?{share:a/o.length,largest:i.max.value}:null}shown(e,t){let i=this.views[t]?.part.name;return i!==void 0&&e.parts[i]!=="hidden"}cellShown(e,t,i){let s=t.contacts,{parts:r}=s;return ka(s,i,e.colours.cells)?this.shown(e,r[2*i])||this.shown(e,r[2*i+1]):!1}extremes(e,t){let{field:i}=t.colours,s=null,r=null;if(Fn(i))for(let o of e.meshes){if(!this.shown(t,o.part))continue;let a=this.values(o,i),l=sd(o.shape);for(let c=0;c<a.length;c++){let u=a[c];!l[c]||!Number.isFinite(u)||((!s||u<s.value)&&(s={value:u,mesh:o,index:c}),(!r||u>r.value)&&(r={value:u,mesh:o,index:c}))}}else if(i==="contact_pressure"&&e.contacts){let o=Float64Array.from(e.contacts.pressures,(l,c)=>l>0&&this.cellShown(t,e,c)?l:NaN),a=h0(o);a&&(s={value:0,mesh:null,index:a.minIndex},r={value:a.max,mesh:null,index:a.maxIndex})}return s&&r?{min:s,max:r}:null}extremePoint(e,t){let i=new G,{mesh:s,index:r}=e;if(s)return i.set(...ws(s,r,this.factor)).applyMatrix4(Es(t.poses,s.part,this.#a));let o=t.contacts.corners;for(let a=0;a<4;a++)i.x+=o[12*r+3*a]/4,i.y+=o[12*r+3*a+1]/4,i.z+=o[12*r+3*a+2]/4;return i}apply(e,t){let{uniforms:i}=this.scene,{colours:s}=e,r=this.position,o=Fn(s.field);for(let h of this.views)h.setVisibility(Xa(e,h.part)),h.setFieldMode(o),h.setEdges(e.mesh_edges),h.setSections(this.sectionsShown(e));if(this.applyFrame(e),this.factor=this.deformationFactor(e),i.deformation.value=this.factor,o)for(let h of this.#t)h.setField(this.values(h.mesh,s.field));this.#s=e.mesh_edges;let a=r&&s.field==="contact_pressure"?r.contacts:null,l=JSON.stringify([s.cells,Object.entries(e.parts).filter(([,h])=>h==="hidden")]);this.contacts.set(a,l,h=>this.cellShown(e,r,h)),this.contacts.setBehind(e.hidden_contacts);let c=r?this.extremes(r,e):null;this.limits=this.chooseLimits(e,c,t),this.clipped=this.clippedBy(this.limits,e,c),this.limits&&i.limits.value.set(...this.limits),s0(this.scene.scaleTexture,s.scale,s.bands);let u=this.views.map(({part:h})=>h.name);this.forces.set(r?.forces??[],{...e.forces,radius:this.radius,names:u}),this.applyCut(e);let f=[...this.forces.labels];if(r&&c&&e.extremes){let h=Math.max(Math.abs(c.min.value),Math.abs(c.max.value)),d=Vi[s.field].quantity==="length"?xn("m",h):Ei(),p=(_,g,m)=>{let x=Math.abs(_.value)<1e-9*h?0:_.value*d.factor,M=this.extremePoint(_,r);this.isCutAway(M)||f.push({kind:g,text:`${m} ${Dt(x)} ${d.symbol}`,point:M})};u0(s.field)==="maximum"?p(c.max,"maximum","max"):p(c.min,"minimum","min")}return f}chooseLimits(e,t,i){let{colours:s}=e;return s.field==="plain"?null:s.limits==="fixed"?[Math.min(s.min,s.max),Math.max(s.min,s.max)]:s.limits==="all"&&i?i:this.position&&this.automaticLimits(this.position,e,t)}deformationFactor(e){let{mode:t,factor:i}=e.deformation;if(t==="factor")return Number.isFinite(i)?i:0;if(!Fn(e.colours.field))return 0;let s=this.position?this.largestDisplacement(this.position):0;return s>0?v0(fE*2*this.radius/s):1}largestDisplacement(e){let t=this.#i.get(e);if(t===void 0){t=0;for(let{displacements:i}of e.meshes)for(let s=0;s<i.length;s+=3)t=Math.max(t,i[s]**2+i[s+1]**2+i[s+2]**2||0);this.#i.set(e,t)}return Math.sqrt(t)}applyFrame(e){let{root:t}=this.scene;t.matrix.identity();let i=this.views.findIndex(r=>r.part.name===e.frame),s=r=>r&&Tu(r,i);i>=0&&this.position&&s(this.#o)&&s(this.position.poses)&&(Es(this.#o,i,t.matrix),t.matrix.multiply(Es(this.position.poses,i,this.#a).invert())),t.updateMatrixWorld(!0)}applyCut(e){this.cut.apply(e.cut,this.scene.uniforms.cutPlane.value);for(let t of this.views)t.cap.matrix.copy(this.cut.capMatrix),t.cap.updateMatrixWorld(!0);if(this.#l!==e.cut.on){this.#l=e.cut.on;for(let t of this.views)t.setCut(this.#l);for(let t of this.contacts.materials)t.cut=this.#l}}isCutAway(e){let t=this.cutPlane,i=U0.copy(e).applyMatrix4(this.scene.root.matrix);return t!==null&&t.x*i.x+t.y*i.y+t.z*i.z+t.w>0}get cutPlane(){return this.#l?this.scene.uniforms.cutPlane.value:null}setDragging(e,t){if(e!==this.#r){this.#r=e;for(let i of this.views)i.setSections(this.sectionsShown(t));this.scene.invalidate()}}sectionsShown(e){return(Fn(e.colours.field)||e.mesh_edges)&&!(this.#r&&this.sectionTime>dE)}updateSections(){let e=performance.now(),t=!1;for(let i of this.views){let s=i.showsSections?this.planeOf(i):null;for(let r of i.meshes)if(r.section)if(s&&r.mesh){let o=i.showsField?r.values:null;t=r.section.update(r.mesh,o,s,this.factor,this.#s)||t}else r.section.hide()}t&&(this.sectionTime=performance.now()-e)}planeOf(e){let{x:t,y:i,z:s,w:r}=this.scene.uniforms.cutPlane.value,o=e.group.matrixWorld.elements;return[o[0]*t+o[1]*i+o[2]*s,o[4]*t+o[5]*i+o[6]*s,o[8]*t+o[9]*i+o[10]*s,o[12]*t+o[13]*i+o[14]*s+r]}prepareFrame(){this.updateSections();let e=this.scene.frustum(),{active:t,state:i,direction:s}=this.scene.camera,r=this.scene.height/i.height,o=t.position.distanceTo(mE.fromArray(i.target)),a=i.projection==="orthographic",l=c=>{if(a)return r;let u=U0.copy(t.position).sub(c).dot(s);return u>0?r*o/u:r};this.triangles=0;for(let c of this.views)this.triangles+=c.prepare(e,l)}clear(){for(let e of this.views)e.group.removeFromParent(),e.cap.removeFromParent(),e.dispose();this.#e.dispose(),this.#t=[],this.views=[],this.position=null,this.#l=!1;for(let e of this.contacts.materials)e.cut=!1}dispose(){this.clear(),this.contacts.dispose(),this.forces.dispose()}},mE=new G,U0=new G;function Tu(n,e){return!n||n.subarray(12*e,12*e+12).every(Number.isFinite)}function Es(n,e,t){if(!n||!Tu(n,e))return t.identity();let[i,s,r,o,a,l,c,u,f,h,d,p]=n.subarray(12*e,12*e+12);return t.set(i,s,r,h,o,a,l,d,c,u,f,p,0,0,0,1)}var gE=(n,e)=>n.left<e.right&&e.left<n.right&&n.top<e.bottom&&e.top<n.bottom,[Cu,xd]=[9,9];function O0(n,e,t,i){let s=n==="right"?e+Cu:n==="left"?e-Cu-i:e-i/2,r=n==="above"?t-Cu-2*xd:n==="below"?t+Cu:t-xd;return{left:s,top:r,right:s+i,bottom:r+2*xd}}var Ru=class{element=document.createElement("div");#e=[];#t=[];#n=[];#i=new G;constructor(){this.element.className="cv-labels"}set(e){for(let t of e)t.hidden??=this.#e.find(({kind:i})=>i===t.kind)?.hidden;for(this.#e=e;this.#t.length>e.length;)this.#t.pop().remove();e.forEach((t,i)=>{let s=this.#t[i];s||(s=document.createElement("div"),s.append(document.createElement("i"),document.createElement("span")),this.#t.push(s),this.element.append(s)),s.className=`cv-label cv-label-${t.kind}${t.hidden?" cv-label-hidden":""} ${B0(this.#n[i])}`,s.lastElementChild.textContent=t.text})}hide(e){this.#e.forEach((t,i)=>{t.kind!=="maximum"&&t.kind!=="minimum"||(t.hidden=e(t.point),this.#t[i].classList.toggle("cv-label-hidden",t.hidden))})}arrange(e,t,i){let{left:s,top:r}=this.element.getBoundingClientRect(),o=i?[{left:i.left-s,top:i.top-r,right:i.right-s,bottom:i.bottom-r}]:[],a=({kind:h})=>h==="maximum"||h==="minimum",l=h=>a(h)?1/0:h.weight??0,c=this.#e.map((h,d)=>d).sort((h,d)=>l(this.#e[d])-l(this.#e[h])||h-d),u=this.#t.map(h=>h.lastElementChild.offsetWidth),f=this.#t.map(h=>h.getBoundingClientRect());for(let h of c){if(this.#t[h].style.display==="none")continue;let[d,p]=[f[h].x-s,f[h].y-r],_=x=>x.left>=0&&x.right<=e&&x.top>=0&&x.bottom<=t&&!o.some(M=>gE(x,M)),m=["right","left","above","below"].filter(x=>_(O0(x,d,p,u[h])))[0]??(a(this.#e[h])?"right":null);m&&o.push(O0(m,d,p,u[h])),this.#t[h].classList.remove(..._E),this.#t[h].classList.add(B0(m)),this.#n[h]=m}}update(e,t,i,s){this.#e.forEach((r,o)=>{let a=this.#i.copy(r.point).applyMatrix4(t).project(e),l=a.z>-1&&a.z<1&&Math.abs(a.x)<1.02&&Math.abs(a.y)<1.02,{style:c}=this.#t[o];c.display=l?"":"none",l&&(c.transform=`translate(${(.5+.5*a.x)*i}px, ${(.5-.5*a.y)*s}px)`)})}placed(e,t,i,s){return this.#e.map((r,o)=>{let a=r.point.clone().applyMatrix4(t).project(e);return{...r,x:(.5+.5*a.x)*i,y:(.5-.5*a.y)*s,depth:a.z,side:this.#n[o]===void 0?"right":this.#n[o]}}).filter(r=>r.side!==null&&r.depth>-1&&r.depth<1&&r.x>0&&r.x<i&&r.y>0&&r.y<s)}},_E=["right","left","above","below","unplaced"].map(n=>`cv-label-${n}`);function B0(n){return`cv-label-${n===void 0?"right":n??"unplaced"}`}function yd(n,e,t,i,s){let[r,o,a]=n.origin,[l,c,u]=n.direction,f=null,h=1/0;for(let d=0;d<t.length;d+=3){let p=3*t[d],_=3*t[d+1],g=3*t[d+2],m=e[p],x=e[p+1],M=e[p+2],b=e[_],C=e[_+1],A=e[_+2],v=e[g],E=e[g+1],U=e[g+2];if(i){let{displacements:Xe,factor:Ne}=i;m+=Ne*Xe[p],x+=Ne*Xe[p+1],M+=Ne*Xe[p+2],b+=Ne*Xe[_],C+=Ne*Xe[_+1],A+=Ne*Xe[_+2],v+=Ne*Xe[g],E+=Ne*Xe[g+1],U+=Ne*Xe[g+2]}let L=b-m,I=C-x,k=A-M,z=v-m,N=E-x,W=U-M,$=c*W-u*N,H=u*z-l*W,le=l*N-c*z,J=L*$+I*H+k*le;if(J===0)continue;let Q=1/J,ie=r-m,fe=o-x,he=a-M,ee=(ie*$+fe*H+he*le)*Q;if(ee<-1e-9||ee>1+1e-9)continue;let me=fe*k-he*I,ge=he*L-ie*k,Se=ie*I-fe*L,xe=(l*me+c*ge+u*Se)*Q;if(xe<-1e-9||ee+xe>1+1e-9)continue;let Ve=(z*me+N*ge+W*Se)*Q;Ve<=s||Ve>=h||(h=Ve,f={distance:Ve,triangle:d,u:ee,v:xe,facing:J>0})}return f}function Pu(n,e,t){if(!t)return[0,1/0];let i=t.x*n.x+t.y*n.y+t.z*n.z+t.w,s=t.x*e.x+t.y*e.y+t.z*e.z;if(s===0)return i>0?[1/0,1/0]:[0,1/0];let r=-i/s;return s<0?[Math.max(0,r),1/0]:[0,r]}var vd=new yt,Ar=new G,Cr=new G,tr=new bi,k0=new jn;function Iu(n,e,t,i,s){let[r,o]=Pu(n.origin,n.direction,s),a=null,l=(c,u,f,h,d,p)=>{if(!h)return;let _=s!==null&&r>0&&!h.facing&&!p,g=_?r:h.distance;if(g>o||a&&g>=a.distance)return;let m=h.triangle;a={view:c,copy:u,mesh:f,nodes:[d[m],d[m+1],d[m+2]],weights:[1-h.u-h.v,h.u,h.v],distance:g,point:n.at(g,new G),cap:_}};for(let c of e){if(c.visibility!=="visible"||!c.present)continue;vd.copy(c.group.matrixWorld).invert(),Ar.copy(n.origin).applyMatrix4(vd),Cr.copy(n.direction).transformDirection(vd);let u=c.copies.sphere,{triangles:f}=c.part,h=c.presentCopies.map(_=>[_,f]),d=c.rest?c.replacedCopies.map(_=>[_,c.restTriangles]):[];for(let[_,g]of[...h,...d]){let m=-2*Math.PI*_/c.part.copies,x=Math.cos(m),M=Math.sin(m);if(tr.origin.set(x*Ar.x-M*Ar.y,M*Ar.x+x*Ar.y,Ar.z),tr.direction.set(x*Cr.x-M*Cr.y,M*Cr.x+x*Cr.y,Cr.z),k0.copy(u),!tr.intersectsSphere(k0)||!tr.intersectsBox(c.copies.box))continue;let b=yd(bd(tr),c.part.points,g,null,r);l(c,_,-1,b,g,c.part.open)}tr.origin.copy(Ar),tr.direction.copy(Cr),(t[c.part.index]??[]).forEach((_,g)=>{let{triangles:m}=_.shape,{displacements:x}=_,M=yd(bd(tr),Va(_),m,{displacements:x,factor:i},r);l(c,-1,g,M,m,_.shape.open)})}return a}function bd(n){return{origin:[n.origin.x,n.origin.y,n.origin.z],direction:[n.direction.x,n.direction.y,n.direction.z]}}function z0(n,e,t,i){let s=null,r=bd(n);for(let o=0;o<e.count;o++){if(!(e.pressures[o]>0)||!t(o))continue;let a=e.corners.subarray(12*o,12*o+12),l=yd(r,a,xE,null,i[0]);l&&l.distance<i[1]&&(!s||l.distance<s.distance)&&(s={cell:o,distance:l.distance})}return s}var xE=new Uint32Array([0,1,2,0,2,3]);var Lu=new bi,Md=new G,Du=new G;function V0(n,e,t){Md.copy(t).applyMatrix4(n.root.matrixWorld),Du.copy(Md).project(n.camera.active),n.ray((.5+.5*Du.x)*n.width,(.5-.5*Du.y)*n.height,Lu);let i=Iu(Lu,e.views,e.meshes,e.factor,e.cutPlane);if(!i)return!1;let s=Du.copy(Md).sub(Lu.origin).dot(Lu.direction),r=.001*e.radius;return i.distance<s-r}var H0=2*Math.PI/180,G0=new WeakMap;function nr(n){let e=G0.get(n);return e===void 0&&G0.set(n,e=n.copies>1?vE(n):null),e}function vE({points:n,triangles:e}){let t=SE(n,e),i=e.length/3,s=yE(n,e),r=new Float64Array(i),o=new Float64Array(i);for(let d=0;d<i;d++){let[p,_,g]=[3*e[3*d],3*e[3*d+1],3*e[3*d+2]],[m,x,M]=[n[_]-n[p],n[_+1]-n[p+1],n[_+2]-n[p+2]],[b,C,A]=[n[g]-n[p],n[g+1]-n[p+1],n[g+2]-n[p+2]],[v,E,U]=[x*A-M*C,M*b-m*A,m*C-x*b],L=Math.hypot(v,E,U),[I,k]=[n[p]+n[_]+n[g],n[p+1]+n[_+1]+n[g+1]];L>0&&(o[d]=L/2,r[d]=(E*I-v*k)/(Math.hypot(I,k)||1))}let a=r.map((d,p)=>{let _=s[p];return _<0?d/(2*o[p]||1):(d+r[_])/(2*(o[p]+o[_])||1)}),l=a.reduce((d,p)=>Math.max(d,Math.abs(p)),0),c=d=>{let p=[];for(let g=0;g<i;g++)o[g]>0&&d*a[g]>.35*l&&p.push(g);let _=wE(n,e,t,o,p);return _&&{outline:EE(n,e,p),angle:_}},[u,f]=[c(1),c(-1)];if(!u||!f)return null;let h=bE(u.angle,f.angle);return{flanks:{left:u,right:f},direction:h,tip:ME(u,f,h)}}function yE(n,e){let t=new Int32Array(e.length/3).fill(-1),i=new Map,s=(r,o)=>Math.hypot(n[3*r]-n[3*o],n[3*r+1]-n[3*o+1],n[3*r+2]-n[3*o+2]);for(let r=0;r<t.length;r++){let o=[...e.subarray(3*r,3*r+3)],a=o.map((h,d)=>[h,o[(d+1)%3]]),[l,c]=a.reduce((h,d)=>s(...d)>s(...h)?d:h),u=l<c?`${l} ${c}`:`${c} ${l}`,f=i.get(u);f===void 0?i.set(u,r):[t[r],t[f]]=[f,r]}return t}function bE(n,e){let t=n[1]-e[1],i=n[2]-e[2];if(!(Math.hypot(t,i)>0))return 0;let s=Math.atan2(i>=0?-t:t,Math.abs(i));return Math.abs(s)<H0?0:Math.abs(s)>Math.PI/2-H0?Math.PI/2:s}function ME(n,e,t){let i=n.outline[0]??[],s=a=>i.reduce((l,c,u)=>u%2===a?l+2*c/i.length:l,0),r=qa(n.angle,s(0),s(1))-qa(e.angle,s(0),s(1));return(Math.cos(t)*(n.angle[2]-e.angle[2])-Math.sin(t)*(n.angle[1]-e.angle[1]))*r<=0?1:-1}function SE(n,e){let t=n.length/3,[i,s]=[0,0];for(let h=0;h<n.length;h+=3)i+=n[h],s+=n[h+1];let r=Math.atan2(s,i),o=(h,d)=>h-2*Math.PI*Math.round((h-d)/(2*Math.PI)),a=h=>Math.atan2(n[3*h+1],n[3*h]),l=new Uint32Array(t+1);for(let h of e)l[h+1]++;for(let h=0;h<t;h++)l[h+1]+=l[h];let c=l.slice(0,t),u=new Uint32Array(e.length);e.forEach((h,d)=>u[c[h]++]=d);let f=new Float64Array(t).fill(NaN);for(let h=0;h<t;h++){if(!Number.isNaN(f[h]))continue;f[h]=o(a(h),r);let d=[h];for(let p=d.pop();p!==void 0;p=d.pop())for(let _=l[p];_<l[p+1];_++){let g=u[_]-u[_]%3;for(let m=0;m<3;m++){let x=e[g+m];Number.isNaN(f[x])&&(f[x]=o(a(x),f[p]),d.push(x))}}}return f}function wE(n,e,t,i,s){let r=s.map(g=>{let[m,x,M]=[0,0,0];for(let b=0;b<3;b++){let C=e[3*g+b];m+=n[3*C+2]/3,x+=Math.hypot(n[3*C],n[3*C+1])/3,M+=t[C]/3}return[i[g],m,x,M]}),o=r.reduce((g,[m])=>g+m,0);if(!(o>0))return null;let a=[1,2,3].map(g=>r.reduce((m,x)=>m+x[0]*x[g],0)/o),[l,c,u,f,h]=[0,0,0,0,0];for(let[g,m,x,M]of r){let[b,C,A]=[m-a[0],x-a[1],M-a[2]];l+=g*b*b,c+=g*b*C,u+=g*C*C,f+=g*b*A,h+=g*C*A}let d=l*u-c*c,[p,_]=d>1e-12*(l+u)**2?[(f*u-h*c)/d,(h*l-f*c)/d]:[0,0];return[a[2]-p*a[0]-_*a[1],p,_]}function EE(n,e,t){let i=new Map,s=c=>{let u=`${n[3*c]} ${n[3*c+1]} ${n[3*c+2]}`,f=i.get(u);return f===void 0&&i.set(u,c),f??c},r=new Set;for(let c of t){let u=[0,1,2].map(f=>s(e[3*c+f]));for(let f=0;f<3;f++){let[h,d]=[u[f],u[(f+1)%3]];r.delete(`${d} ${h}`)||r.add(`${h} ${d}`)}}let o=new Map;for(let c of r){let[u,f]=c.split(" ").map(Number);o.set(u,[...o.get(u)??[],f])}let a=[];for(let c of o.keys()){let u=[];for(let f=c;f!==void 0&&!(u.length>0&&f===c);f=o.get(f)?.pop())u.push(n[3*f+2],Math.hypot(n[3*f],n[3*f+1]));u.length>4&&a.push(u)}let l=Math.max(...a.map(W0),0);return a.filter(c=>W0(c)>.02*l)}function W0(n){let e=0;for(let t=0;t<n.length;t+=2){let[i,s,r,o]=[n[t],n[t+1],n[(t+2)%n.length],n[(t+3)%n.length]];e+=i*o-s*r}return Math.abs(e)/2}function qa([n,e,t],i,s){return n+e*i+t*s}function Sd(n,e,t){let{contacts:i,poses:s}=n;if(!i)return[];let r=s.subarray(12*e.index,12*e.index+12),o=nr(e),a=[];for(let u=0;u<i.count;u++){let f=i.pressures[u];if(!(!(f>0)||!ka(i,u,t)))for(let h=0;h<2;h++){if(i.parts[2*u+h]!==e.index)continue;let d=[],[p,_]=[0,0];for(let A=0;A<4;A++){let v=TE(r,i.corners.subarray(12*u+3*A,12*u+3*A+3));d.push(v[2],Math.hypot(v[0],v[1])),p+=v[0]/4,_+=v[1]/4}let[g,m]=AE(d),x=i.teeth[2*u+h],M=o?(qa(o.flanks.left.angle,g,m)+qa(o.flanks.right.angle,g,m))/2:0,b=Math.atan2(_,p)-2*Math.PI*x/e.copies-M,C=Math.atan2(Math.sin(b),Math.cos(b));a.push({cell:u,tooth:x,side:"left",pressure:f,corners:d,surface:i.surfaces[2*u+h],offset:C})}}let l=new Map,c=u=>`${u.tooth} ${u.surface}`;for(let u of a)l.set(c(u),(l.get(c(u))??0)+u.pressure*u.offset);return a.map(({surface:u,offset:f,...h})=>({...h,side:l.get(c({...h,surface:u}))>=0?"left":"right"})).sort((u,f)=>u.pressure-f.pressure)}function TE(n,e){let[t,i,s]=[e[0]-n[9],e[1]-n[10],e[2]-n[11]];return[n[0]*t+n[3]*i+n[6]*s,n[1]*t+n[4]*i+n[7]*s,n[2]*t+n[5]*i+n[8]*s]}function AE(n){return[(n[0]+n[2]+n[4]+n[6])/4,(n[1]+n[3]+n[5]+n[7])/4]}function X0(n){let e=0;for(let{side:t,pressure:i,corners:s}of n){let r=Math.abs((s[4]-s[0])*(s[7]-s[3])-(s[5]-s[1])*(s[6]-s[2]))/2;e+=(t==="left"?1:-1)*i*r}return e>=0?"left":"right"}function wd(n,{tooth:e,side:t}){return n.side===t&&(e===null||n.tooth===e)}var Nu=class{constructor(e,t=1){this.direction=e;this.tip=t;this.cos=Math.cos(e),this.sin=Math.sin(e),this.#e=this.sin<0?-1:1,this.#t=e===0?1:t}direction;tip;cos;sin;#e;#t;along(e,t){return this.#e*(this.cos*e+this.sin*t)}across(e,t){return this.#t*(this.cos*t-this.sin*e)}inverse(e,t){let[i,s]=[this.#e*e,this.#t*t];return[this.cos*i-this.sin*s,this.sin*i+this.cos*s]}get ends(){return this.direction!==0?["toe","heel","root","tip"]:this.tip>0?["−z end","+z end","root","tip"]:["−z end","+z end","tip","root"]}};function Ed(n,e,t){let i={u0:1/0,u1:-1/0,v0:1/0,v1:-1/0},s=(o,a)=>{let[l,c]=[t.along(o,a),t.across(o,a)];i.u0=Math.min(i.u0,l),i.u1=Math.max(i.u1,l),i.v0=Math.min(i.v0,c),i.v1=Math.max(i.v1,c)},r=nr(n)?.flanks[e].outline??[];for(let o of r)for(let a=0;a<o.length;a+=2)s(o[a],o[a+1]);if(r.length===0){let o=n.points;for(let a=0;a<o.length;a+=3)s(o[a+2],Math.hypot(o[a],o[a+1]))}return!(i.u1>i.u0)||!(i.v1>i.v0)?{u0:-.001,u1:.001,v0:0,v1:.001}:i}function q0(n,e,t){let i=Ed(n,e,t),s=.03*Math.max(i.u1-i.u0,i.v1-i.v0);return{u0:i.u0-s,u1:i.u1+s,v0:i.v0-s,v1:i.v1+s}}function $0(n,e,t){let[i,s]=[!1,!1];for(let r=0;r<8;r+=2){let[o,a,l,c]=[n[r],n[r+1],n[(r+2)%8],n[(r+3)%8]],u=(l-o)*(t-a)-(c-a)*(e-o);u>0&&(i=!0),u<0&&(s=!0)}return!(i&&s)}function Y0(n,e,t){for(let i=n.length-1;i>=0;i--)if($0(n[i].corners,e,t))return n[i];return null}var Fu=class{constructor(e,t,i=320){this.bounds=e;this.axes=t;this.columns=i,this.rows=Math.min(Math.max(Math.round(i*(e.v1-e.v0)/(e.u1-e.u0)),40),640),this.values=new Float32Array(this.columns*this.rows)}bounds;axes;columns;rows;values;included=new Set;largest=0;column(e){return(e-this.bounds.u0)/(this.bounds.u1-this.bounds.u0)*this.columns}row(e){return(e-this.bounds.v0)/(this.bounds.v1-this.bounds.v0)*this.rows}add(e){let{columns:t,rows:i,values:s}=this;for(let{corners:r,pressure:o}of e){this.largest=Math.max(this.largest,o);let a=[];for(let h=0;h<8;h+=2){let[d,p]=[r[h],r[h+1]];a.push(this.column(this.axes.along(d,p)),this.row(this.axes.across(d,p)))}let l=[a[0],a[2],a[4],a[6]],c=[a[1],a[3],a[5],a[7]],u=!1,f=(h,d)=>{if(u=!0,h<0||d<0||h>=t||d>=i)return;let p=d*t+h;o>s[p]&&(s[p]=o)};for(let h=Math.max(0,Math.floor(Math.min(...c)));h<=Math.min(i-1,Math.floor(Math.max(...c)));h++)for(let d=Math.max(0,Math.floor(Math.min(...l)));d<=Math.min(t-1,Math.floor(Math.max(...l)));d++)$0(a,d+.5,h+.5)&&f(d,h);u||f(Math.floor(l.reduce((h,d)=>h+d)/4),Math.floor(c.reduce((h,d)=>h+d)/4))}}at(e,t){let[i,s]=[Math.floor(this.column(e)),Math.floor(this.row(t))];return i<0||s<0||i>=this.columns||s>=this.rows?0:this.values[s*this.columns+i]}};var CE=25,Uu=class{constructor(e){this.core=e}core;pointed=new Map;hovered=-1;#e=null;#t=null;#n="";#i=null;#s=0;#r=!1;gears(){let e=this.core.display?.position?.contacts,t=this.core.parts?.parts??[],i=new Set(e?.parts),s=this.core.state.pattern.gear;return t.filter(r=>r.kind==="gear"&&(i.has(r.index)||r.name===s))}teeth(e){return[...new Set(this.cellsOf(e).map(({tooth:t})=>t))].sort((t,i)=>t-i)}pattern(){let{core:e}=this,{display:t,state:i}=e,s=this.gears(),r=s.find(({name:_})=>_===i.pattern.gear)??s[0];if(!r||!t)return null;let o=new Nu(nr(r)?.direction??0,nr(r)?.tip),a=this.cellsOf(r),l=this.tooth(r),c=i.pattern.flank==="automatic"?X0(a.filter(_=>l===null||_.tooth===l)):i.pattern.flank,u=q0(r,c,o),f=i.pattern.envelope?this.envelope(r,o,u,{tooth:l,side:c}):null,h=f?[]:a.filter(_=>wd(_,{tooth:l,side:c})),d=f?.largest??h[h.length-1]?.pressure??0,p=i.colours.field==="contact_pressure"?t.limits:null;return{part:r,axes:o,bounds:u,tooth:l,side:c,cells:h,envelope:f,largest:d,limits:p??[0,d>0?d:1]}}tooth(e){let{tooth:t}=this.core.state.pattern;return t==="pointer"?this.pointed.get(e.index)??null:t!=="all"&&/^\d+$/.test(t)?Number(t):null}cellsOf(e){let t=this.core.display?.position;if(!t)return[];let i=this.core.state.colours.cells,s=this.#e;if(s?.position===t&&s.part===e&&s.choice===i)return s.cells;let r=Sd(t,e,i);return this.#e={position:t,part:e,choice:i,cells:r},r}envelope(e,t,i,s){let{positions:r,state:o}=this.core,a=JSON.stringify([e.name,s,o.colours.cells]);return!this.#t||a!==this.#n||r!==this.#i?(this.#t=new Fu(i,t),this.#n=a,this.#i=r,this.#s++,this.fill(this.#t,e,s,this.#s)):this.#t.included.size<(r?.list.length??0)&&!this.#r&&(this.#s++,this.fill(this.#t,e,s,this.#s)),this.#t}async fill(e,t,i,s){let{core:r}=this,{positions:o}=r,a=()=>s===this.#s&&o===r.positions&&r.state.panels.pattern&&r.state.pattern.envelope;this.#r=!0;let l=performance.now();for(let c=0;o&&c<o.list.length&&a();c++){if(e.included.has(c))continue;let u=await o.load(c).catch(()=>null);if(!a())break;e.included.add(c),u&&e.add(Sd(u,t,r.state.colours.cells).filter(f=>wd(f,i))),!(performance.now()-l<CE)&&(r.changed(!1),await new Promise(f=>setTimeout(f)),l=performance.now())}s===this.#s&&(this.#r=!1),r.changed(!1)}};var RE=6,ir=new bi,Td=new bi,Ao=new yt;function J0(n,e,t){let{scene:i,display:s,state:r}=n;if(!i||!s)return null;i.ray(e,t,ir);let o=s.cutPlane,a=o&&Fn(r.colours.field)?IE(n,e,t,o):null;if(a)return a;let l=Iu(ir,s.views,s.meshes,s.factor,o),c=NE(n,e,t,l?.distance??1/0);if(c)return c;if(!l)return null;let{part:u}=l.view,f=new G,h=s.meshes[u.index]?.[l.mesh],d=r.colours.field==="plain"?null:NaN,p=null,_=null;if(l.cap)return f.copy(l.point).applyMatrix4(Ao.copy(l.view.group.matrixWorld).invert()),f.applyMatrix4(Es(s.position?.poses??null,u.index,Ao)),_=u.copies>1?h?.copy??l.copy:null,{x:e,y:t,part:u.name,tooth:_,value:null,node:p,point:f};if(h){if(p=DE(n,h,l,e,t),p!==null?f.set(...ws(h,p,0)):l.nodes.forEach((g,m)=>f.addScaledVector(K0.set(...ws(h,g,0)),l.weights[m])),Fn(r.colours.field)){let g=s.values(h,r.colours.field);d=p!==null?g[p]:l.nodes.reduce((m,x,M)=>m+l.weights[M]*g[x],0)}_=u.copies>1?h.copy:null}else LE(u.points,l,f),f.applyAxisAngle(PE,2*Math.PI*l.copy/u.copies),_=u.copies>1?l.copy:null;return f.applyMatrix4(Es(s.position?.poses??null,u.index,Ao)),{x:e,y:t,part:u.name,tooth:_,value:d,node:p,point:f}}var PE=new G(0,0,1),K0=new G;function IE(n,e,t,i){let{display:s,state:r}=n,{field:o}=r.colours;if(!s||!Fn(o))return null;let[a]=Pu(ir.origin,ir.direction,i);if(!(a>0)||!Number.isFinite(a))return null;let l=ir.at(a,new G);for(let c of s.views){if(!c.showsSections)continue;let u=l.clone().applyMatrix4(Ao.copy(c.group.matrixWorld).invert());for(let{mesh:f,section:h}of c.meshes){if(!f||!h?.plane)continue;let d=h.section.find(u.x,u.y,u.z,h.plane);if(d<0)continue;let{nodes:p,weights:_}=I0(f,h.section.sources[d],s.factor,[u.x,u.y,u.z]),g=s.values(f,o),m=new G;p.forEach((M,b)=>m.addScaledVector(K0.set(...ws(f,M,0)),_[b])),m.applyMatrix4(Es(s.position?.poses??null,c.part.index,Ao));let x=p.reduce((M,b,C)=>M+_[C]*g[b],0);return{x:e,y:t,part:c.part.name,tooth:c.part.copies>1?f.copy:null,value:x,node:null,point:m}}}return null}function LE(n,e,t){t.set(0,0,0),e.nodes.forEach((i,s)=>{let r=e.weights[s];t.x+=r*n[3*i],t.y+=r*n[3*i+1],t.z+=r*n[3*i+2]})}function DE(n,e,t,i,s){let r=n.scene,o=n.display.factor,a=null,l=RE,c=new G;for(let u of t.nodes){c.set(...ws(e,u,o)),c.applyMatrix4(t.view.group.matrixWorld).project(r.camera.active);let f=Math.hypot((.5+.5*c.x)*r.width-i,(.5-.5*c.y)*r.height-s);f<=l&&(l=f,a=u)}return a}function NE(n,e,t,i){let{display:s,state:r}=n,o=s?.position,a=r.colours.field==="contact_pressure"?o?.contacts:null;if(!a||!o||!s)return null;let l=Ao.copy(n.scene.root.matrixWorld).invert();Td.copy(ir).applyMatrix4(l);let c=Pu(ir.origin,ir.direction,s.cutPlane);r.hidden_contacts||(c[1]=Math.min(c[1],i+.002*s.radius));let u=z0(Td,a,p=>s.cellShown(r,o,p),c);if(!u)return null;let f=Td.at(u.distance,new G),h=r.parts[Z0(n,a.parts[2*u.cell])]==="hidden"?1:0,d=a.parts[2*u.cell+h];return{x:e,y:t,part:Z0(n,d),tooth:a.teeth[2*u.cell+h],cell:u.cell,value:a.pressures[u.cell],node:null,point:f}}function Z0(n,e){return n.parts?.parts[e]?.name??`part ${e}`}var Co=new Map;function j0(n,e,t){let i=Co.get(n);if(!i){let s=t(n).then(o=>T0(n,o)),r={shape:s,users:new Set};Co.set(n,r),s.catch(()=>Co.get(n)===r&&Co.delete(n)),i=r}return i.users.add(e),i.shape}function Ad(n){for(let[e,{users:t}]of Co)t.delete(n)&&t.size===0&&Co.delete(e)}async function Cd(n,e){try{let t=atob(n),i=new Uint8Array(t.length);for(let r=0;r<t.length;r++)i[r]=t.charCodeAt(r);let s=new Blob([i]).stream().pipeThrough(new DecompressionStream("gzip"));return await new Response(s).arrayBuffer()}catch(t){let i=t instanceof Error?t.message:String(t);throw new Error(`${e}: the compressed data are damaged (${i})`)}}function Rd(n){let e=n.positions??[];return{title:n.title,provenance:n.provenance,outputs:n.outputs,parts:()=>Cd(n.parts,"parts.bin"),positions:async()=>e.map(({position:t,time:i})=>({position:t,time:i})),position:t=>{let i=e[t];return i?Cd(i.data,Ou(i.position)):Promise.reject(new Error(`position ${t} does not exist`))},mesh:t=>{let i=n.meshes?.[t];return i===void 0?Promise.reject(new Error(`${t}: the page does not contain this file`)):Cd(i,t)}}}function Ou(n){return`position-${String(n).padStart(4,"0")}.bin`}var FE=384e6,Bu=class{constructor(e,t){this.source=e;this.parts=t}source;parts;list=[];#e=new Map;#t=new Map;#n=0;#i=!1;async update(){this.list=await this.source.positions()}cached(e){return this.#e.get(e)}load(e){let t=this.#e.get(e);if(t)return this.#e.delete(e),this.#e.set(e,t),Promise.resolve(t);let i=this.#t.get(e);if(i)return i;let s=this.read(e).finally(()=>this.#t.delete(e));return this.#t.set(e,s),s}async read(e){let t=this.list[e],i=Ou(t?.position??e),s=await A0(i,await this.source.position(e),this.parts,r=>j0(r,this,async o=>{if(!this.source.mesh)throw new Error(`${o}: this source contains no meshes`);return this.source.mesh(o)}));if(this.#i&&Ad(this),this.#i||s.problem)return s;this.#e.set(e,s),this.#n+=s.bytes;for(let[r,o]of this.#e){if(this.#n<=FE||r===e)break;this.#e.delete(r),this.#n-=o.bytes}return s}dispose(){this.#i=!0,Ad(this),this.#e.clear(),this.#n=0}};var Pd=24,UE=260,OE={front:[-90,0],back:[90,0],left:[180,0],right:[0,0],top:[-90,90],bottom:[-90,-90],isometric:[-50,30]},ku=class{perspective=new Kn(Pd);orthographic=new mo;onChange=null;#e={projection:"perspective",target:[0,0,0],azimuth:-50,elevation:30,height:1};#t=1;#n=new G;#i=1;#s=[];#r=!1;#o=!1;#a=0;#l=new G;#u=new G;#c=new G;get active(){return this.#e.projection==="perspective"?this.perspective:this.orthographic}get state(){let e={...this.#e,target:[...this.#e.target]};return this.#r?e.fitted=!0:delete e.fitted,e}setBounds(e,t,i){this.#n.copy(e),this.#i=t>0?t:1,this.#s=i,this.update()}setFitPoints(e){this.#s=e}setAspect(e){this.#t=e>0?e:1,this.#r&&Object.assign(this.#e,this.fitted(this.#e.azimuth,this.#e.elevation)),this.update()}set(e,t=!1){this.interrupt(),this.#e={...e,target:[...e.target]},e.fitted&&(Object.assign(this.#e,this.fitted(e.azimuth,e.elevation)),this.#r=!0),this.changed(t)}setProjection(e){this.#e.projection=e,this.changed(!0)}orbit(e,t){this.interrupt(),this.#e.azimuth=Ld(this.#e.azimuth+e),this.#e.elevation=Id(this.#e.elevation+t,-90,90),this.changed(!0)}pan(e,t){this.interrupt(),this.shift(e,t),this.changed(!0)}zoom(e,t=0,i=0){this.interrupt();let s=Id(this.#e.height*e,this.#i*1e-4,this.#i*40),r=s/this.#e.height;this.shift(-t*(1-r),-i*(1-r)),this.#e.height=s,this.changed(!0)}view(e,t=!0){let[i,s]=OE[e],r={...this.#e,azimuth:i,elevation:s};this.#o=t,t&&Object.assign(r,this.fitted(i,s)),this.animateTo(r)}fit(e=!0){let t={...this.#e,...this.fitted(this.#e.azimuth,this.#e.elevation)};this.#o=!0,e?this.animateTo(t):this.set({...t,fitted:!0},!0)}interrupt(){cancelAnimationFrame(this.#a),this.#r=!1}fitted(e,t){if(this.#s.length===0){let d=2.1*this.#i/Math.min(1,this.#t);return{target:[this.#n.x,this.#n.y,this.#n.z],height:d}}let[i,s,r]=[new G,new G,new G];Q0(e,t,i,s,r);let o=new ti,a=new G,l=this.#s.map(d=>new G(d.dot(i),d.dot(s),d.dot(r)));for(let d of l)o.expandByPoint(d);let c=o.getCenter(a),u=this.#e.projection==="perspective"?Math.tan(Pd*Math.PI/360):0,f=.001*this.#i;for(let d of l){let p=(d.z-c.z)*u;f=Math.max(f,2*(Math.abs(d.y-c.y)+p),2*(Math.abs(d.x-c.x)/this.#t+p))}f*=1.1;let h=i.multiplyScalar(c.x).addScaledVector(s,c.y).addScaledVector(r,c.z);return{target:[h.x,h.y,h.z],height:f}}animateTo(e){if(cancelAnimationFrame(this.#a),matchMedia("(prefers-reduced-motion: reduce)").matches){this.set({...e,fitted:this.#o},!0);return}let t=this.state,i=Ld(e.azimuth-t.azimuth),s=performance.now(),r=o=>{let a=Id((o-s)/UE,0,1),l=a*a*(3-2*a);this.#e.azimuth=Ld(t.azimuth+l*i),this.#e.elevation=t.elevation+l*(e.elevation-t.elevation),this.#e.height=t.height*(e.height/t.height)**l;for(let c=0;c<3;c++)this.#e.target[c]=t.target[c]+l*(e.target[c]-t.target[c]);a===1&&(this.#e={...e,target:[...e.target]},this.#r=this.#o),this.changed(!0),a<1&&(this.#a=requestAnimationFrame(r))};this.#a=requestAnimationFrame(r)}shift(e,t){let{height:i,target:s}=this.#e;for(let r=0;r<3;r++){let o=this.#l.getComponent(r),a=this.#u.getComponent(r);s[r]-=i*(e*o+t*a)}}changed(e){this.update(),this.onChange?.(e)}get direction(){return this.#c}update(){let{azimuth:e,elevation:t,height:i,target:s}=this.#e;Q0(e,t,this.#l,this.#u,this.#c);let r=i/(2*Math.tan(Pd*Math.PI/360)),o=s[0],a=s[1],l=s[2],c=r-(this.#n.x-o)*this.#c.x-(this.#n.y-a)*this.#c.y-(this.#n.z-l)*this.#c.z,u=1.3*this.#i+.02*i;for(let h of[this.perspective,this.orthographic])h.position.set(o+r*this.#c.x,a+r*this.#c.y,l+r*this.#c.z),h.matrix.makeBasis(this.#l,this.#u,this.#c),h.quaternion.setFromRotationMatrix(h.matrix),h.updateMatrixWorld();this.perspective.near=Math.max(c-u,r*.02),this.perspective.far=Math.max(c+u,this.perspective.near*1.1),this.perspective.aspect=this.#t,this.perspective.updateProjectionMatrix();let f=this.orthographic;f.near=c-u,f.far=c+u,f.top=i/2,f.bottom=-i/2,f.right=i/2*this.#t,f.left=-f.right,f.updateProjectionMatrix()}};function Q0(n,e,t,i,s){let r=n*Math.PI/180,o=e*Math.PI/180;t.set(-Math.sin(r),Math.cos(r),0),s.set(Math.cos(o)*Math.cos(r),Math.cos(o)*Math.sin(r),Math.sin(o)),i.crossVectors(s,t)}function Id(n,e,t){return Math.min(Math.max(n,e),t)}function Ld(n){return((n+180)%360+360)%360-180}var Ro=class extends Error{constructor(){super("This browser cannot draw three-dimensional pictures: WebGL 2 is not available. Turn on hardware acceleration in the browser's settings, or use another browser."),this.name="NoWebGlError"}},zu=class{constructor(e){this.container=e;this.uniforms=Jg(this.scaleTexture);let t=this.canvas.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0,depth:!0,powerPreference:"high-performance"});if(!t)throw new Ro;this.#e=new ou({canvas:this.canvas,context:t,stencil:!0,alpha:!0}),this.#e.setClearColor(0,0),this.root.matrixAutoUpdate=!1,this.scene.add(this.root),e.append(this.canvas),this.#t=new ResizeObserver(()=>this.resize()),this.#t.observe(e),this.canvas.addEventListener("webglcontextrestored",()=>this.invalidate()),this.resize()}container;canvas=document.createElement("canvas");camera=new ku;scene=new da;root=new jt;uniforms;scaleTexture=r0();onPrepare=null;onFrame=null;frames=0;width=1;height=1;#e;#t;#n=0;#i=new vs;#s=new yt;resize(){this.width=Math.max(this.container.clientWidth,1),this.height=Math.max(this.container.clientHeight,1);let e=Math.min(window.devicePixelRatio||1,2);this.uniforms.pixelRatio.value=e,this.#e.setPixelRatio(e),this.#e.setSize(this.width,this.height),this.camera.setAspect(this.width/this.height),this.draw()}invalidate(){this.#n||(this.#n=requestAnimationFrame(()=>{this.#n=0,this.draw()}))}frustum(){let{active:e}=this.camera;return this.#s.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this.#i.setFromProjectionMatrix(this.#s)}draw(){this.scene.updateMatrixWorld(),this.onPrepare?.(),this.#e.render(this.scene,this.camera.active),this.frames++,this.onFrame?.()}snapshot(e){let t=this.#e.getPixelRatio(),i=document.createElement("canvas");try{this.uniforms.pixelRatio.value=e,this.#e.setPixelRatio(e),this.#e.setSize(this.width,this.height,!1),this.draw(),i.width=this.canvas.width,i.height=this.canvas.height,i.getContext("2d").drawImage(this.canvas,0,0)}finally{this.uniforms.pixelRatio.value=t,this.#e.setPixelRatio(t),this.#e.setSize(this.width,this.height),this.draw()}return i}ray(e,t,i){let{active:s}=this.camera,r=2*e/this.width-1,o=1-2*t/this.height;return i.origin.set(r,o,-1).unproject(s),i.direction.set(r,o,1).unproject(s).sub(i.origin).normalize(),i}dispose(){cancelAnimationFrame(this.#n),this.#t.disconnect(),this.scaleTexture.dispose(),this.#e.dispose(),this.#e.forceContextLoss(),this.canvas.remove()}};var Vu=class{constructor(e,t){this.element=e;this.changed=t;this.#t.addEventListener("change",this.#n)}element;changed;theme="light";#e="system";#t=matchMedia("(prefers-color-scheme: dark)");#n=()=>{this.set(this.#e),this.changed()};set(e){this.#e=e,this.theme=e==="system"?this.#t.matches?"dark":"light":e,this.element.dataset.theme=this.theme}dispose(){this.#t.removeEventListener("change",this.#n)}};var BE=640,kE=900,zE=100,Gu=class{constructor(e,t,i){this.element=e;this.state=Eu(i,wu()),this.#i=i.colours?.field!==void 0,this.#s=i.colours?.cells!==void 0,this.theme=new Vu(e,()=>this.changed()),this.theme.set(this.state.theme),this.#l.observe(e);try{this.scene=new zu(t),this.display=new Au(this.scene)}catch(o){this.fail(o instanceof Ro?o:new Ro);return}let{scene:s,display:r}=this;t.append(this.labels.element),s.onPrepare=()=>r.prepareFrame(),s.onFrame=()=>{this.labels.update(s.camera.active,s.root.matrix,s.width,s.height),this.#a||=window.setTimeout(()=>this.updateMarks(),zE)},s.camera.onChange=o=>{this.state.camera=s.camera.state,this.probe=null,s.invalidate(),this.changed(o)}}element;state;status="empty";failure="";notice="";source=null;parts=null;positions=null;probe=null;help=!1;narrow=!1;drawers=!1;drawer=null;progress=null;scene=null;display=null;labels=new Ru;animation=new uu(this);pattern=new Uu(this);theme;onChange=null;#e=new Set;#t=0;#n=0;#i;#s;#r=new Map;#o="";#a=0;#l=new ResizeObserver(()=>this.resize());resize(){let e=this.element.clientWidth,t=e>0&&e<BE,i=e>0&&e<kE;t===this.narrow&&i===this.drawers||(this.narrow=t,this.drawers=i,this.drawer=null,this.element.toggleAttribute("data-narrow",t),this.element.toggleAttribute("data-drawers",i),this.changed(!1))}isOpen(e){return this.drawers?this.drawer===e:this.state.panels[e]}toggle(e,t=!this.isOpen(e)){this.drawers?this.setDrawer(t?e:null):this.update({panels:{[e]:t}})}setDrawer(e){this.drawer=e,this.changed(!1)}subscribe(e){return this.#e.add(e),()=>this.#e.delete(e)}changed(e=!0){e&&(this.#u=!0),!this.#t&&(this.#t=requestAnimationFrame(()=>{this.#t=0;for(let t of this.#e)t();this.#u&&this.onChange?.(structuredClone(this.state)),this.#u=!1}))}#u=!1;fail(e){this.status="failed",this.failure=e instanceof Error?e.message:String(e),this.changed(!1)}async show(e){this.scene&&(this.source=e,this.status!=="ready"&&(this.status="loading"),this.notice="",this.changed(!1),await this.load(!0))}async reload(){this.source&&this.scene&&await this.load(!1)}async load(e){let{source:t,display:i,scene:s}=this;if(!t||!i||!s)return;let r=++this.#n,o=()=>r!==this.#n;e&&this.animation.stop();try{let a=E0(await t.parts()),l=new Bu(t,a.parts),c="";try{await l.update()}catch(f){c=`The list of positions cannot be read: ${Hu(f)}`}let u=l.list.length>0?await l.load(0).catch(f=>(c=Hu(f),null)):null;if(o()){l.dispose();return}u?.problem&&(c=e_(u)),this.positions?.dispose(),this.parts=a,_0(a.units),this.positions=l,this.#r.clear(),this.notice=c,i.setParts(a.parts,u),i.setPosition(u),!this.#i&&(u?.meshes.length||u?.contacts)&&(this.#i=!0,this.state.colours.field=u.meshes.length?"von_mises":"contact_pressure"),!this.#s&&u?.contacts&&(this.#s=!0,Qg(u.contacts)&&(this.state.colours.cells="flanks")),this.state.position=Math.min(Math.max(0,Math.trunc(this.state.position)),Math.max(0,l.list.length-1)),this.status="ready",this.apply(),i.updateBounds(),this.state.camera?s.camera.set(this.state.camera):a.parts.length>0&&s.camera.fit(!1),this.state.position>0&&await this.goTo(this.state.position),this.changed()}catch(a){o()||this.fail(a)}}async updatePositions(){let{positions:e}=this;if(!e)return;let t=e.list.length===0;try{await e.update()}catch(i){this.notice=`The list of positions cannot be read: ${Hu(i)}`}this.#r.clear(),t&&e.list.length>0?await this.load(!0):this.update({})}update(e){let t=this.state;this.state=Eu(e,t),e.colours?.field&&(this.#i=!0),e.colours?.cells&&(this.#s=!0),this.probe=null,this.theme.set(this.state.theme),e.camera&&this.scene&&this.scene.camera.set(this.state.camera),this.apply(),e.parts&&this.display?.updateBounds(),e.position!==void 0&&this.goTo(this.state.position),this.changed()}apply(){let{display:e,scene:t}=this;if(!e||!t||this.status!=="ready")return;let i=e.apply(this.state,this.#r.get(this.limitsKey())??null);this.labels.set(i),t.invalidate(),this.state.colours.limits==="all"&&this.findAllLimits()}setVisibility(e,t){let i={...this.state.parts};for(let s of e)i[s]=t;this.update({parts:i})}async goTo(e){let{positions:t,display:i}=this;if(!t||!i||t.list.length===0)return;let s=Math.min(Math.max(0,e),t.list.length-1);this.state.position=s,this.changed();try{let r=await t.load(s);if(t!==this.positions||this.state.position!==s)return;this.notice=e_(r),i.position!==r&&i.setPosition(r),this.probe=null,this.apply()}catch(r){if(t!==this.positions||this.state.position!==s)return;this.animation.stop(),this.notice=`${Hu(r)}. The picture shows another position.`}this.changed()}limitsKey(){let e=Object.entries(this.state.parts).filter(([,t])=>t==="hidden");return JSON.stringify([this.state.colours.field,this.state.colours.cells,e.map(([t])=>t).sort()])}async findAllLimits(){let{positions:e,display:t,state:i}=this,s=this.limitsKey();if(!e||!t||i.colours.field==="plain"||this.#r.has(s)||this.#o===s)return;this.#o=s;let r=()=>this.#o===s&&e===this.positions&&this.state.colours.limits==="all",o=null;for(let l=0;l<e.list.length&&r();l++){this.progress=l/e.list.length,this.changed(!1);let c=await e.load(l).catch(()=>null),u=c&&r()?t.limitsOf(c,this.state):null;u&&(o=o?[Math.min(o[0],u[0]),Math.max(o[1],u[1])]:u)}if(this.#o!==s)return;let a=r();this.#o="",this.progress=null,a&&(o?this.#r.set(s,o):this.#r.set(s,[0,1]),this.apply()),this.changed(!1)}probePointer(e,t){this.probe=this.status==="ready"?J0(this,e,t):null,this.state.panels.pattern&&this.followPointer(),this.changed(!1)}followPointer(){let{probe:e,pattern:t}=this,i=e?.cell??-1,s=this.display?.position?.contacts;for(let o=0;s&&i>=0&&o<2;o++)t.pointed.set(s.parts[2*i+o],s.teeth[2*i+o]);let r=this.parts?.parts.find(({name:o})=>o===e?.part);e&&i<0&&r&&e.tooth!==null&&t.pointed.set(r.index,e.tooth),this.hover(i)}hover(e){let{display:t,scene:i,pattern:s}=this;s.hovered=e,t?.contacts.mark(t.position?.contacts??null,e)&&i?.invalidate(),this.changed(!1)}updateMarks(){clearTimeout(this.#a),this.#a=0;let{scene:e,display:t}=this;!e||!t||this.status!=="ready"||(this.labels.hide(i=>V0(e,t,i)),this.labels.arrange(e.width,e.height,this.element.querySelector(".cv-legend")?.getBoundingClientRect()??null))}clearProbe(){this.pattern.hovered>=0&&this.hover(-1),this.probe&&(this.probe=null,this.changed(!1))}get hasMeshes(){return(this.display?.position?.meshes.length??0)>0}get missingField(){let{field:e}=this.state.colours,t=this.display?.position;return e==="plain"||this.status!=="ready"?!1:Fn(e)?!t?.meshes.length:!t?.contacts}project(e,t){let{scene:i,display:s}=this,r=s?.views.find(l=>l.part.name===e);if(!i||!r)return null;let o=new G(...t).applyMatrix4(r.group.matrixWorld).project(i.camera.active),a=i.canvas.getBoundingClientRect();return{x:a.left+(.5+.5*o.x)*i.width,y:a.top+(.5-.5*o.y)*i.height}}nodalValue(e,t){let{display:i,parts:s}=this,r=s?.parts.findIndex(l=>l.name===e)??-1,o=i?.meshes[r]?.[0],{field:a}=this.state.colours;return o&&i&&Fn(a)?i.values(o,a)[t]??NaN:NaN}dispose(){this.#n++,cancelAnimationFrame(this.#t),clearTimeout(this.#a),this.#l.disconnect(),this.animation.stop(),this.positions?.dispose(),this.display?.dispose(),this.scene?.dispose(),this.theme.dispose(),this.#e.clear()}};function e_({problem:n}){return n&&`${n}. The mesh is not displayed.`}function Hu(n){return n instanceof qt||n instanceof Error?n.message:String(n)}var t_=.35,VE=18;function n_(n,e){let t=n.scene,i=new Map,s=null,r=0,o=0,a=0,l=new G,c=d=>{let p=e.getBoundingClientRect();return{x:d.clientX-p.left,y:d.clientY-p.top}},u=(d,p)=>{if(!n.state.cut.on)return!1;let _=l.copy(n.display.cut.handle).project(t.camera.active);return Math.hypot((.5+.5*_.x)*t.width-d,(.5-.5*_.y)*t.height-p)<VE};e.addEventListener("pointerdown",d=>{e.setPointerCapture(d.pointerId),e.focus({preventScroll:!0}),n.drawer&&n.setDrawer(null);let{x:p,y:_}=c(d);i.set(d.pointerId,{x:p,y:_}),i.size>1?s="pan":d.button===0&&u(p,_)?s="cut":s=d.button===0&&!d.shiftKey?"orbit":"pan",n.clearProbe(),n.display?.setDragging(s==="cut",n.state),e.dataset.drag=s}),e.addEventListener("pointermove",d=>{let{x:p,y:_}=c(d),g=i.get(d.pointerId);if(!g||!s){let M=u(p,_);e.dataset.handle=String(M),n.display?.cut.setHighlight(M),o=p,a=_,r||=requestAnimationFrame(()=>{r=0,n.probePointer(o,a)});return}let m=p-g.x,x=_-g.y;if(i.size===2){let M=[...i].find(([A])=>A!==d.pointerId)[1],b=Math.hypot(g.x-M.x,g.y-M.y),C=Math.hypot(p-M.x,_-M.y);t.camera.pan(m/2/t.height,-x/2/t.height),b>0&&C>0&&t.camera.zoom(b/C,...h((p+M.x)/2,(_+M.y)/2))}else if(s==="orbit")t.camera.orbit(-m*t_,x*t_);else if(s==="pan")t.camera.pan(m/t.height,-x/t.height);else{let{cut:M}=n.display;i_(n,M.drag(m,x,t.camera.active,t.width,t.height))}g.x=p,g.y=_});let f=d=>{i.delete(d.pointerId),i.size===0&&(s=null,n.display?.setDragging(!1,n.state),delete e.dataset.drag)};e.addEventListener("pointerup",f),e.addEventListener("pointercancel",f),e.addEventListener("pointerleave",()=>{cancelAnimationFrame(r),r=0,n.clearProbe()}),e.addEventListener("contextmenu",d=>d.preventDefault()),e.addEventListener("dblclick",()=>t.camera.fit());let h=(d,p)=>[(d-t.width/2)/t.height,(t.height/2-p)/t.height];e.addEventListener("wheel",d=>{d.preventDefault();let{x:p,y:_}=c(d),g=d.deltaY*(d.deltaMode===1?16:1);t.camera.zoom(Math.exp(Math.min(Math.max(g,-240),240)*.0016),...h(p,_))},{passive:!1})}function i_(n,e){let{cut:t}=n.display,i=Math.min(Math.max(t.offset+e,t.range[0]),t.range[1]);n.update({cut:{offset:i}})}function Po(n,e){let t=e.normal??n.state.cut.normal,i=n.scene.camera.direction,s=typeof t=="string"?i[t]:i.x*t[0]+i.y*t[1]+i.z*t[2];n.update({cut:{...e,...e.normal?{offset:null}:{},...e.on===!1?{}:{flipped:s<0}}})}var s_=[["View",[{keys:"F",label:"Fit the parts into the picture"},{keys:"1 … 6",label:"Front, back, left, right, top, bottom"},{keys:"7",label:"Isometric"},{keys:"P",label:"Perspective or orthographic"},{keys:"Arrow keys",label:"Orbit (picture focused)"},{keys:"Shift + arrow keys",label:"Pan (picture focused)"},{keys:"+ −",label:"Zoom"}]],["Display",[{keys:"M",label:"Edges of the finite elements"},{keys:"V",label:"Force vectors"},{keys:"C",label:"Cutting plane"},{keys:"[ ]",label:"Move the cutting plane"},{keys:"D",label:"Undeformed, true or automatic deformation"}]],["Animation",[{keys:"K",label:"Play or pause"},{keys:", .",label:"Previous or next position"}]],["Panels",[{keys:"B",label:"Parts"},{keys:"S",label:"Settings"},{keys:"G",label:"Plots"},{keys:"U",label:"Contact pattern on the unrolled flank"},{keys:"?",label:"This help"},{keys:"Esc",label:"Close"}]],["Pointer",[{keys:"Drag",label:"Orbit"},{keys:"Right or Shift + drag",label:"Pan"},{keys:"Wheel",label:"Zoom at the pointer"},{keys:"Double click",label:"Fit"}]]],HE={1:"front",2:"back",3:"left",4:"right",5:"top",6:"bottom",7:"isometric"};function r_(n,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let t=e.target;if(t.closest("input:not([type=checkbox]):not([type=range]), select, textarea"))return!1;let{scene:i,state:s,animation:r}=n;if(e.key==="?")return n.help=!n.help,n.changed(!1),!0;if(e.key==="Escape"&&n.help)return n.help=!1,n.changed(!1),!0;if(e.key==="Escape"&&n.drawer)return n.setDrawer(null),!0;if(!i||n.status!=="ready")return!1;let{camera:o}=i;if(t===i.canvas&&e.key.startsWith("Arrow")){let u=e.key==="ArrowRight"?1:e.key==="ArrowLeft"?-1:0,f=e.key==="ArrowUp"?1:e.key==="ArrowDown"?-1:0;return e.shiftKey?o.pan(.05*u,.05*f):o.orbit(-6*u,-6*f),!0}let a=HE[e.key];if(a)return o.view(a),!0;let{panels:l,forces:c}=s;switch(e.key.toLowerCase()){case"f":o.fit();break;case"p":o.setProjection(s.camera?.projection==="orthographic"?"perspective":"orthographic");break;case"+":case"=":o.zoom(.85);break;case"-":case"_":o.zoom(1/.85);break;case"m":n.update({mesh_edges:!s.mesh_edges});break;case"v":{let u=!(c.bearings||c.meshes);n.update({forces:{bearings:u,meshes:u}});break}case"c":Po(n,{on:!s.cut.on});break;case"[":case"]":s.cut.on&&i_(n,(e.key==="["?-.04:.04)*n.display.radius);break;case"d":n.update({deformation:GE(n)});break;case"k":r.toggle();break;case",":r.step(-1);break;case".":r.step(1);break;case"b":n.toggle("parts");break;case"s":n.toggle("settings");break;case"g":n.update({panels:{plots:!l.plots}});break;case"u":n.update({panels:{pattern:!l.pattern}});break;default:return!1}return!0}function GE(n){let{mode:e,factor:t}=n.state.deformation;return e==="automatic"?{mode:"factor",factor:0}:t===0?{mode:"factor",factor:1}:{mode:"automatic",factor:1}}function Wu(n,e,t){let i=(e-n)/Math.max(t,1),s=10**Math.floor(Math.log10(i)),r=[1,2,5,10].map(a=>a*s).find(a=>a>=i)??10*s,o=[];for(let a=Math.ceil(n/r-1e-9);a*r<=e+1e-9*r;a++)o.push(a*r);return o}var WE=.09;function Xu(n,e,t){let i=WE*(e-n);return[n,...Wu(n,e,t).filter(s=>s>n+i&&s<e-i),e]}function $a(n){let{field:e}=n.state.colours;if(Vi[e].quantity==="stress")return Ei();if(Vi[e].quantity==="none")return{symbol:"",factor:1};let t=n.display?.limits;return xn("m",t?Math.max(Math.abs(t[0]),Math.abs(t[1])):0)}function Io(n){return Vi[n.state.colours.field].label}function qu(n){let e=$a(n),t=n.display?.limits;if(!t)return{ticks:[],unit:e.symbol};let{bands:i}=n.state.colours,s=t[0]*e.factor,r=t[1]*e.factor;return s===r?{ticks:[{fraction:.5,text:Dt(s)}],unit:e.symbol}:{ticks:(i>0&&i<=12?Array.from({length:i+1},(l,c)=>s+c/i*(r-s)):Xu(s,r,5)).map(l=>({fraction:(l-s)/(r-s),text:Dt(Math.abs(l)<1e-9*Math.abs(r-s)?0:l,4)})),unit:e.symbol}}var Ts={left:58,right:92,top:20,bottom:36},Dd=14,a_=.6,Lo=class{constructor(e,t,{bounds:i},s=!0){this.width=e;this.height=t;this.bar=s;let r=Math.max(e-Ts.left-(s?Ts.right:12),40),o=Math.max(t-Ts.top-Ts.bottom,30);this.scale=Math.min(r/(i.u1-i.u0),o/(i.v1-i.v0)),this.left=Ts.left+(r-this.scale*(i.u1-i.u0))/2,this.bottom=Ts.top+(o+this.scale*(i.v1-i.v0))/2,this.right=this.left+this.scale*(i.u1-i.u0),this.top=this.bottom-this.scale*(i.v1-i.v0),this.#e=this.left-this.scale*i.u0,this.#t=this.bottom+this.scale*i.v0}width;height;bar;scale;#e;#t;right;top;left;bottom;x(e){return this.#e+this.scale*e}y(e){return this.#t-this.scale*e}inverse(e,t){return[(e-this.#e)/this.scale,(this.#t-t)/this.scale]}};function $u(n,[e,t],i){let s=Math.min(Math.max((n-e)/(t-e||1),0),1);return Er(er(i.scale,wr(s,i.bands)))}function Ju(n,e,t,i,s,r=-1){let{axes:o,side:a,part:l,limits:c}=t,u=d=>{let p=[];for(let _=0;_<d.length;_+=2){let[g,m]=[d[_],d[_+1]];p.push(e.x(o.along(g,m)),e.y(o.across(g,m)))}return p},f=(nr(l)?.flanks[a].outline??[]).map(u);n.fill(f,s.flank),t.envelope&&XE(n,e,t,i);for(let{corners:d,pressure:p}of t.cells)n.fill([u(d)],$u(p,c,i),!0);for(let d of f)n.stroke(d,s.muted,1,!0);let h=t.cells.find(({cell:d})=>d===r);h&&n.stroke(u(h.corners),s.mark,2,!0),qE(n,e,t,s),e.bar&&$E(n,e,c,i,s)}function XE(n,e,{envelope:t,limits:i},s){let{bounds:r,columns:o,rows:a,values:l}=t,c=(r.u1-r.u0)/o,u=(r.v1-r.v0)/a;for(let f=0;f<a;f++){let h=e.y(r.v0+(f+1)*u),d=e.y(r.v0+f*u);for(let p=0;p<o;){let _=l[f*o+p],g=p++;if(!(_>0))continue;let m=$u(_,i,s);for(;p<o&&l[f*o+p]>0&&$u(l[f*o+p],i,s)===m;)p++;let[x,M]=[e.x(r.u0+g*c),e.x(r.u0+p*c)];n.fill([[x,h,M,h,M,d,x,d]],m,!0)}}}function Nd({part:n,side:e,axes:t}){if(t.direction===0)return[0,0];let{u0:i,v0:s}=Ed(n,e,t);return[i,s]}function qE(n,e,t,i){let{left:s,right:r,top:o,bottom:a}=e,{factor:l,symbol:c}=xn("m",1),{bounds:u,axes:f}=t,[h,d]=Nd(t),p=f.direction===0;n.stroke([s,o,s,a,r,a],i.muted,1);for(let M of Wu((u.u0-h)*l,(u.u1-h)*l,Math.min((r-s)/60,10))){let b=e.x(M/l+h);n.stroke([b,a,b,a+4],i.muted,1),n.text(b,a+15,Dt(M),i.muted,"middle")}for(let M of Wu((u.v0-d)*l,(u.v1-d)*l,Math.min((a-o)/26,8))){let b=e.y(M/l+d);n.stroke([s-4,b,s,b],i.muted,1),n.text(s-7,b+4,Dt(M),i.muted,"end")}let[_,g,m,x]=f.ends;n.text(s,a+30,_,i.muted,"start"),n.text(r,a+30,g,i.muted,"end"),n.text(s-16,a+16,m,i.muted,"end"),n.text(s-16,o-8,x,i.muted,"end"),n.text((s+r)/2,a+30,`${p?"z":"along the face"} in ${c}`,i.text,"middle"),n.text(s-44,(o+a)/2,`${p?"radius":"across the face"} in ${c}`,i.text,"middle",!0)}function $E(n,e,t,i,s){let r=e.width-Ts.right+22,[o,a]=[Ts.top+16,e.height-Ts.bottom],l=Ei(),c=i.bands>0?i.bands:48;for(let h=0;h<c;h++){let d=t[0]+(h+.5)/c*(t[1]-t[0]),[p,_]=[a-h*(a-o)/c,a-(h+1)*(a-o)/c];n.fill([[r,p,r+Dd,p,r+Dd,_,r,_]],$u(d,t,i),!0)}n.text(r,o-7,l.symbol,s.text,"start");let[u,f]=[t[0]*l.factor,t[1]*l.factor];for(let h of Xu(u,f,a-o<90?2:4)){let d=a-(h-u)/(f-u||1)*(a-o);n.text(r+Dd+6,d+4,Dt(h),s.muted,"start")}}var Yu=class{constructor(e){this.context=e}context;fill(e,t,i=!1){let{context:s}=this;s.fillStyle=t,s.beginPath();for(let r of e)this.path(r,!0);s.fill("evenodd"),i&&(s.strokeStyle=t,s.lineWidth=a_,s.stroke())}stroke(e,t,i,s=!1){let{context:r}=this;r.strokeStyle=t,r.lineWidth=i,r.beginPath(),this.path(e,s),r.stroke()}path(e,t){let{context:i}=this;for(let s=0;s<e.length;s+=2)s===0?i.moveTo(e[0],e[1]):i.lineTo(e[s],e[s+1]);t&&i.closePath()}text(e,t,i,s,r,o=!1){let{context:a}=this;a.fillStyle=s,a.textAlign=r==="middle"?"center":r,a.save(),a.translate(e,t),o&&a.rotate(-Math.PI/2),a.fillText(i,0,0),a.restore()}},Zu=class{elements=[];fill(e,t,i=!1){e.length!==0&&this.elements.push(`<path d="${e.map(s=>o_(s,!0)).join("")}" fill="${t}"${i?` stroke="${t}" stroke-width="${a_}"`:' fill-rule="evenodd"'}/>`)}stroke(e,t,i,s=!1){this.elements.push(`<path d="${o_(e,s)}" fill="none" stroke="${t}" stroke-width="${i}"/>`)}text(e,t,i,s,r,o=!1){let a=o?` transform="rotate(-90 ${e.toFixed(1)} ${t.toFixed(1)})"`:"";this.elements.push(`<text x="${e.toFixed(1)}" y="${t.toFixed(1)}" fill="${s}" text-anchor="${r}"${a}>${Ku(i)}</text>`)}};function o_(n,e){let t="";for(let i=0;i<n.length;i+=2)t+=`${i===0?"M":"L"}${n[i].toFixed(2)} ${n[i+1].toFixed(2)}`;return e?`${t}Z`:t}function Ku(n){return n.replace(/[&<>"]/g,e=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[e])}function l_(n,e,t,i){let s=new TextEncoder,r=[],o=[],a=0,l=d=>{let p=typeof d=="string"?s.encode(d):d;r.push(p),a+=p.length},c=(d,p)=>{o.push(a),l(`${o.length} 0 obj
${d}
`),p!==void 0&&(l(`stream
`),l(p),l(`
endstream
`)),l(`endobj
`)},u=Math.round(842*t/e),f=`q 842 0 0 ${u} 0 0 cm /Picture Do Q`;l(`%PDF-1.4
`),c("<< /Type /Catalog /Pages 2 0 R >>"),c("<< /Type /Pages /Kids [3 0 R] /Count 1 >>"),c(`<< /Type /Page /Parent 2 0 R /MediaBox [0 0 842 ${u}] /Resources << /XObject << /Picture 4 0 R >> >> /Contents 5 0 R >>`),c(`<< /Type /XObject /Subtype /Image /Width ${e} /Height ${t} /ColorSpace /DeviceRGB /BitsPerComponent 8 /Filter /DCTDecode /Length ${n.length} >>`,n),c(`<< /Length ${f.length} >>`,f),c(`<< /Title <${YE(i)}> /Producer (Calyx) >>`);let h=a;l(`xref
0 ${o.length+1}
0000000000 65535 f 
`);for(let d of o)l(`${String(d).padStart(10,"0")} 00000 n 
`);return l(`trailer
<< /Size ${o.length+1} /Root 1 0 R /Info 6 0 R >>
startxref
${h}
%%EOF
`),new Blob(r,{type:"application/pdf"})}function YE(n){let e="FEFF";for(let t=0;t<n.length;t++)e+=n.charCodeAt(t).toString(16).padStart(4,"0").toUpperCase();return e}var ZE={right:[9,4,"start"],left:[-9,4,"end"],above:[0,-14,"middle"],below:[0,22,"middle"]},Fd=2,JE="system-ui, -apple-system, 'Segoe UI', Roboto, Helvetica, Arial, sans-serif",As={width:16,height:200,right:92,top:56};function KE(n){let{width:e,height:t}=n.scene,i=getComputedStyle(n.element),s=r=>i.getPropertyValue(r).trim();return{width:e,height:t,text:s("--cv-text"),muted:s("--cv-muted"),background:s("--cv-stage"),halo:s("--cv-stage")}}function c_(n,e){let{scene:t,labels:i,state:s,display:r}=n,o=[],a=(h,d,p,_="")=>o.push(`<text x="${h.toFixed(1)}" y="${d.toFixed(1)}" fill="${e.text}" stroke="${e.halo}" stroke-width="3" stroke-linejoin="round" paint-order="stroke" ${_}>${Ku(p)}</text>`);for(let h of i.placed(t.camera.active,t.root.matrix,e.width,e.height)){let d=h.hidden?'stroke-dasharray="3 2" opacity="0.6"':"";(h.kind==="maximum"||h.kind==="minimum")&&o.push(`<circle cx="${h.x.toFixed(1)}" cy="${h.y.toFixed(1)}" r="4" fill="none" stroke="${e.text}" stroke-width="1.6" ${d}/>`);let[p,_,g]=ZE[h.side];a(h.x+p,h.y+_,h.text,`font-weight="600" text-anchor="${g}"${h.hidden?' opacity="0.7"':""}`)}let{limits:l}=r,{colours:c}=s;if(l&&c.field!=="plain"){let h=e.width-As.right,d=c.bands>0?c.bands:64;for(let g=0;g<d;g++){let m=Er(er(c.scale,c.bands>0?wr((g+.5)/d,d):g/(d-1))),x=As.height/d,M=As.top+As.height-(g+1)*x;o.push(`<rect x="${h}" y="${M.toFixed(2)}" width="${As.width}" height="${(x+.4).toFixed(2)}" fill="${m}"/>`)}let{ticks:p,unit:_}=qu(n);for(let g of p)a(h+As.width+7,As.top+As.height*(1-g.fraction)+4,g.text);a(e.width-16,As.top-18,`${Io(n)}${_?` in ${_}`:""}`,'text-anchor="end" font-weight="600"')}let u=n.positions?.list[s.position],f=[n.source?.title,u?`position ${u.position}`:""].filter(Boolean).join(", ");return f&&a(16,e.height-16,f),n.hasMeshes&&a(16,e.height-36,`deformation × ${r.factor}`),o.join(`
`)}function Ud(n,e){return`<svg xmlns="http://www.w3.org/2000/svg" width="${n.width}" height="${n.height}" viewBox="0 0 ${n.width} ${n.height}" font-family="${JE}" font-size="12">
${e}
</svg>
`}function u_(n,e){let t=n.display.cut.group,i=t.visible;t.visible=!1;let s=n.scene.snapshot(Fd);t.visible=i,n.scene.invalidate();let r=document.createElement("canvas");r.width=s.width,r.height=s.height;let o=r.getContext("2d");return o.fillStyle=e.background,o.fillRect(0,0,r.width,r.height),o.drawImage(s,0,0),r}async function d_(n,e){let t=new Image,i=URL.createObjectURL(new Blob([e],{type:"image/svg+xml"}));try{t.src=i,await t.decode(),n.getContext("2d").drawImage(t,0,0,n.width,n.height)}finally{URL.revokeObjectURL(i)}return n}function h_(n,e,t){return new Promise((i,s)=>{n.toBlob(r=>r?i(r):s(new Error("the picture cannot be encoded")),e,t)})}async function Od(n,e){if(!n.scene||n.status!=="ready")throw new Error("there is no picture to export");n.updateMarks();let t=KE(n);if(e==="svg"){let s=u_(n,t).toDataURL("image/png"),r=`<image width="${t.width}" height="${t.height}" href="${s}"/>
${c_(n,t)}`;return new Blob([Ud(t,r)],{type:"image/svg+xml"})}let i=await d_(u_(n,t),Ud(t,c_(n,t)));return p_(i,e,n.source?.title??"")}async function p_(n,e,t){if(e==="png")return h_(n,"image/png");let i=await h_(n,"image/jpeg",.94);return l_(new Uint8Array(await i.arrayBuffer()),n.width,n.height,t)}function Bd(n){let e=getComputedStyle(n.element),t=i=>e.getPropertyValue(i).trim();return{text:t("--cv-text"),muted:t("--cv-muted"),line:t("--cv-line"),flank:t("--cv-flank"),mark:t("--cv-mark")}}function kd(n,{part:e,tooth:t,side:i,envelope:s}){let r=n.positions?.list[n.state.position],o=n.positions?.list.length??0,a=s?`maximum over ${s.included.size<o?`${s.included.size} of `:""}${o} positions`:`position ${r?.position??0}`,l={all:"",flanks:", without edges",edges:", edges only"}[n.state.colours.cells];return`Contact pattern of ${e.name}, ${t===null?"all teeth":`tooth ${t}`}, ${i} flank, ${a}${l}`}var f_={width:960,height:420,title:34};async function zd(n,e){let t=n.pattern.pattern();if(!t)throw new Error("there is no contact pattern to export");let{width:i,height:s,title:r}=f_,o=new Zu,a=Bd(n);Ju(o,new Lo(i,s-r,t),t,n.state.colours,a);let l=getComputedStyle(n.element).getPropertyValue("--cv-bg").trim(),c=[n.source?.title,kd(n,t)].filter(Boolean).join(": "),u=Ud(f_,`<rect width="${i}" height="${s}" fill="${l}"/>
<text x="16" y="22" fill="${a.text}" font-weight="600">${Ku(c)}</text>
<g transform="translate(0 ${r})">
${o.elements.join(`
`)}
</g>`);if(e==="svg")return new Blob([u],{type:"image/svg+xml"});let f=document.createElement("canvas");return f.width=Fd*i,f.height=Fd*s,p_(await d_(f,u),e,c)}async function m_(n,e){__(n,await Od(n,e),e)}async function g_(n,e){__(n,await zd(n,e),`pattern.${e}`)}function __(n,e,t){let i=document.createElement("a"),s=(n.source?.title??"view").replace(/[^\p{L}\p{N}._-]+/gu,"_")||"view";i.href=URL.createObjectURL(e),i.download=`${s}.${t}`,i.click(),setTimeout(()=>URL.revokeObjectURL(i.href),1e4)}var Do,vn,Vd,x_,Hd=Object.is,ju=0,A_=[],Gd=[],cn=It,v_=cn.__b,y_=cn.__r,b_=cn.diffed,M_=cn.__c,S_=cn.unmount,w_=cn.__;function Qu(n,e){cn.__h&&cn.__h(vn,n,ju||e),ju=0;var t=vn.__H||(vn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function ss(n){return ju=1,Xd(R_,n)}function Xd(n,e,t){var i=Qu(Do++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):R_(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);Hd(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=vn,!vn.__f)){vn.__f=!0;var s=vn.shouldComponentUpdate;vn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(h){h.__N&&(c=!0,Hd(h.__[0],h.__N[0])||(u=!0))}),s){var f=s.call(this,r,o,a);return c?f||u:f}return!c||u}}return i.__}function Ti(n,e){var t=Qu(Do++,3);!cn.__s&&qd(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,vn.__H.__h.push(t))}function C_(n,e){var t=Qu(Do++,4);!cn.__s&&qd(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,vn.__h.push(t))}function Ai(n){return ju=5,jE(function(){return{current:n}},[])}function jE(n,e){var t=Qu(Do++,7);return qd(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function QE(){var n;do{for(;n=Gd.shift();)try{Ya(n)}catch(t){cn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=A_.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(Ya),e.__h.some(Wd),e.__h=[]}catch(t){e.__h=[],cn.__e(t,n.__v)}}}while(Gd.length)}cn.__b=function(n){vn=null,v_&&v_(n)},cn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),w_&&w_(n,e)},cn.__r=function(n){y_&&y_(n),Do=0;var e=(vn=n.__c).__H;e&&(Vd==vn?vn.__h=[]:(e.__h.some(Ya),e.__h.some(Wd),Do=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),Vd=vn},cn.diffed=function(n){b_&&b_(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&T_(A_.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),Vd=vn=null},cn.__c=function(n,e){e.some(function(t){try{t.__h.some(Ya),t.__h=t.__h.filter(function(i){return!i.__||Wd(i)})}catch(i){t.__h=[function(){throw i}]}}),M_&&M_(n,e)},cn.unmount=function(n){S_&&S_(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,T_(Gd.push(s))}else Ya(s)}catch(r){e=r}}),i.__H=void 0,e&&cn.__e(e,i.__v))};var E_=typeof requestAnimationFrame=="function";function eT(n){var e,t=function(){clearTimeout(i),E_&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);E_&&(e=requestAnimationFrame(t))}function T_(n){n!=1&&x_==cn.requestAnimationFrame||((x_=cn.requestAnimationFrame)||eT)(QE)}function Ya(n){var e=vn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),vn=e}function Wd(n){var e=vn;n.__c=n.__(),vn=e}function qd(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!Hd(t,n[i])})}function R_(n,e){return typeof e=="function"?e(n):e}var tT=Symbol.for("pv"),nT=0;function D(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:tT,__v:--nT,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),It.vnode&&It.vnode(c),c}function P_(n){let[,e]=Xd(t=>t+1,0);Ti(()=>(e(0),n.subscribe(()=>e(0))),[n])}var iT={parts:"M2.5 3.5h4M2.5 8h4M2.5 12.5h4M9 3.5h4.5M9 8h4.5M9 12.5h4.5",settings:"M2 4.5h7M12 4.5h2M2 11.5h2M7 11.5h7M10.5 3v3M5.5 10v3",fit:"M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10",cube:"M8 1.8l5.5 3v6.4L8 14.2l-5.5-3V4.8zM2.5 4.8L8 8l5.5-3.2M8 8v6.2",perspective:"M2 3.5l12 2v5l-12 2zM8 4.5v7",orthographic:"M2.5 3.5h11v9h-11zM8 3.5v9",mesh:"M2.5 2.5h11v11h-11zM2.5 6.2h11M2.5 9.8h11M6.2 2.5v11M9.8 2.5v11",force:"M3 13L12.5 3.5M7.5 3h5.5v5.5",cut:"M1.5 10.5l5-7h8l-5 7zM3 13.5h4M9.5 13.5h4",plot:"M2.5 2.5v11h11M4.5 10.5l3-4 2.5 2 3.5-5",pattern:"M1.8 3.5h12.4v9H1.8zM4 8c0-1.6 1.8-2.4 4-2.4S12 6.4 12 8s-1.8 2.4-4 2.4S4 9.6 4 8",more:"M2.6 8h1.2M7.4 8h1.2M12.2 8h1.2",download:"M8 2v8M4.8 7L8 10.2 11.2 7M2.5 13.5h11",help:"M5.5 6a2.5 2.5 0 1 1 3.6 2.2c-.8.4-1.1.9-1.1 1.8M8 12.6v.4",sun:"M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6M8 1.2v1.6M8 13.2v1.6M1.2 8h1.6M13.2 8h1.6M3.2 3.2l1.1 1.1M11.7 11.7l1.1 1.1M12.8 3.2l-1.1 1.1M4.3 11.7l-1.1 1.1",moon:"M13.2 9.6A5.8 5.8 0 0 1 6.4 2.8a5.6 5.6 0 1 0 6.8 6.8",play:"M5 3l8 5-8 5z",pause:"M5 3v10M11 3v10",next:"M4 3.5l6 4.5-6 4.5zM12.2 3.5v9",previous:"M12 3.5L6 8l6 4.5zM3.8 3.5v9",loop:"M11.5 2l2 2-2 2M13.5 4H5a3 3 0 0 0-3 3M4.5 14l-2-2 2-2M2.5 12H11a3 3 0 0 0 3-3",eye:"M1.5 8S4 3.8 8 3.8 14.5 8 14.5 8 12 12.2 8 12.2 1.5 8 1.5 8M8 6.2a1.8 1.8 0 1 0 0 3.6 1.8 1.8 0 0 0 0-3.6",half:"M8 2.5a5.5 5.5 0 1 0 0 11zM8 2.5a5.5 5.5 0 0 1 0 11M8 5h4.6M8 8h5.5M8 11h4.6",hidden:"M2 2l12 12M6.2 4.1A6 6 0 0 1 8 3.8c4 0 6.5 4.2 6.5 4.2a12 12 0 0 1-1.9 2.3M4 5.2A11 11 0 0 0 1.5 8S4 12.2 8 12.2a6 6 0 0 0 3-.8",pin:"M8 9.5V14M5 9.5h6l-1.3-2V3.3h.8M6.3 7.5L5 9.5M6.3 7.5V3.3h-.8M6.3 3.3h3.4",chevron:"M5.5 3.5L10 8l-4.5 4.5",close:"M3.5 3.5l9 9M12.5 3.5l-9 9"};function Za({name:n}){return D("svg",{class:"cv-icon",viewBox:"0 0 16 16","aria-hidden":"true",children:D("path",{d:iT[n]})})}function eh(n,e,t,i){let s=n>t-240&&n>t/2,r=e>i-120&&e>i/2;return{[s?"right":"left"]:`${(s?t-n:n)+14}px`,[r?"bottom":"top"]:`${(r?i-e:e)+12}px`,"max-width":`${Math.max(120,(s?n:t-n)-20)}px`}}function yn({icon:n,label:e,shortcut:t,pressed:i,disabled:s,onClick:r}){return D("button",{type:"button",class:"cv-tool","aria-label":e,"aria-pressed":i,disabled:s,title:t?`${e} (${t})`:e,onClick:r,children:D(Za,{name:n})})}function $t({label:n,value:e,options:t,onChange:i,quiet:s,title:r}){return D("label",{class:"cv-field",title:r,children:[D("span",{class:s?"cv-hidden":"",children:n}),D("select",{"aria-label":n,value:e,onChange:o=>i(o.currentTarget.value),children:t.map(o=>D("option",{value:o.value,disabled:o.disabled,selected:o.value===e,children:o.label},o.value))})]})}function rs({label:n,value:e,onChange:t}){return D("label",{class:"cv-check",children:[D("input",{type:"checkbox",checked:e,onChange:i=>t(i.currentTarget.checked)}),D("span",{children:n})]})}function Ja({label:n,value:e,unit:t,min:i,max:s,disabled:r,onChange:o}){let a=Number.isFinite(e)?String(Number(e.toPrecision(6))):"",[l,c]=ss(null),u=()=>{if(l===null)return;let f=Number(l.trim().replace(",",".").replace("−","-"));c(null),!(l.trim()===""||!Number.isFinite(f))&&o(Math.min(Math.max(f,i??-1/0),s??1/0))};return D("label",{class:"cv-field",children:[D("span",{children:n}),D("span",{class:"cv-number",children:[D("input",{type:"text",inputMode:"decimal",value:l??a,disabled:r,onInput:f=>c(f.currentTarget.value),onBlur:u,onKeyDown:f=>{f.key==="Enter"&&u(),f.key==="Escape"&&c(null)}}),t?D("span",{class:"cv-unit",children:t}):null]})]})}function $d({label:n,value:e,min:t,max:i,step:s="any",text:r,onInput:o,onEnd:a}){return D("label",{class:"cv-field cv-slider",children:[D("span",{children:n}),D("input",{type:"range",min:t,max:i,step:s,value:e,"aria-valuetext":r,onInput:l=>o(Number(l.currentTarget.value)),onChange:a})]})}function No({title:n,children:e}){return D("section",{class:"cv-section",children:[D("h3",{children:n}),e]})}function I_({core:n}){let e=Ai(null);C_(()=>{e.current.showModal()},[]);let t=()=>{n.help=!1,n.changed(!1)};return D("dialog",{class:"cv-help",ref:e,"aria-labelledby":"cv-help-title",onClose:t,onClick:i=>i.target===e.current&&t(),children:[D("div",{class:"cv-help-head",children:[D("h2",{id:"cv-help-title",children:"Shortcuts"}),D(yn,{icon:"close",label:"Close",onClick:t})]}),D("div",{class:"cv-help-grid",children:s_.map(([i,s])=>D("section",{children:[D("h3",{children:i}),D("dl",{children:s.map(({keys:r,label:o})=>D("div",{children:[D("dt",{children:D("kbd",{children:r})}),D("dd",{children:o})]},r))})]},i))})]})}var L_={all:"of cells, edges included",flanks:"flanks only",edges:"edges only"},sT={stress_error:"estimated, as von Mises stress"};function rT(n){let{scale:e,bands:t}=n.state.colours,i=[];if(t>0)for(let s=0;s<t;s++){let r=Er(er(e,wr((s+.5)/t,t)));i.push(`${r} ${100*s/t}% ${100*(s+1)/t}%`)}else for(let s=0;s<=20;s++)i.push(`${Er(er(e,s/20))} ${5*s}%`);return`linear-gradient(to top, ${i.join(", ")})`}function oT({share:n,largest:e},t){return`${Dt(100*n,2)} % of the nodes are above, up to ${Dt(e*Ei().factor,3)} ${t}`}function aT(n,e){let{field:t,cells:i}=n.state.colours,s=n.display?.position?.contacts;if(t!=="contact_pressure"||i!=="flanks"||!s)return null;let r=Ba(s,"all");return r>Ba(s,"flanks")?`edges, not shown: up to ${Dt(r*Ei().factor,4)} ${e}`:null}function lT(n){let e=n.display?.position;return e?n.state.colours.field!=="contact_pressure"?e.meshes.length===0?"No values: the run stored no meshes with stresses (--vtu), or its fidelity level has no finite elements.":"No values: the parts with meshes are hidden.":e.contacts?n.state.colours.cells==="all"?"No values: the gears in contact are hidden.":`No values: no visible loaded cells, ${L_[n.state.colours.cells]}.`:'No values: no contact is loaded in this position, or the fidelity level is "rigid".':"No values: the run has no positions."}function D_({core:n}){let{field:e}=n.state.colours;if(e==="plain")return null;let{ticks:t,unit:i}=qu(n);if(n.missingField||t.length===0)return D("div",{class:"cv-legend cv-legend-empty",role:"note",children:[D("strong",{children:Io(n)}),D("span",{children:lT(n)})]});let s=n.narrow?Math.ceil(t.length/6):1,{limits:r}=n.state.colours,o=n.display?.clipped,a=aT(n,i),l=r==="all"?"all positions":r==="fixed"?"fixed limits":"this position";return D("button",{type:"button",class:"cv-legend","aria-label":`Legend: ${Io(n)} from ${t[0].text} to ${t[t.length-1].text} ${i}. Opens the settings.`,title:wo[e]??"Settings of the colours",onClick:()=>n.toggle("settings"),children:[D("span",{class:"cv-legend-title",children:[D("strong",{children:Io(n)}),i?D("span",{class:"cv-legend-unit",children:i}):null]}),D("span",{class:"cv-scale",children:[D("span",{class:"cv-bar",style:{background:rT(n)}}),D("span",{class:"cv-ticks",children:t.filter((c,u)=>u%s===0).map((c,u)=>D("span",{style:{bottom:`${100*c.fraction}%`},children:c.text},u))})]}),wo[e]?D("span",{class:"cv-range",children:sT[e]}):null,a?D("span",{class:"cv-range",children:a}):null,o?D("span",{class:"cv-range",children:oT(o,i)}):null,D("span",{class:"cv-range",children:[e==="contact_pressure"?`${L_[n.state.colours.cells]}; `:"",n.progress!==null?`reading … ${Math.round(100*n.progress)} %`:l]})]})}var cT=[{kind:"gear",label:"Gears"},{kind:"shaft",label:"Shafts"},{kind:"bearing",label:"Bearings"},{kind:"body",label:"Bodies"}],N_={mixed:"visible",visible:"translucent",translucent:"hidden",hidden:"visible"},uT={mixed:"half",visible:"eye",translucent:"half",hidden:"hidden"};function F_({core:n}){let e=n.parts?.parts??[];return D("aside",{class:"cv-panel cv-parts","aria-label":"Parts",children:[D("div",{class:"cv-scroll",children:cT.map(({kind:t,label:i})=>{let s=e.filter(r=>r.kind===t);return s.length>0?D(hT,{core:n,label:i,parts:s},t):null})}),D("div",{class:"cv-foot",children:D($t,{label:"Fixed frame",value:n.state.frame??"",options:[{value:"",label:"Ground"},...e.map(({name:t})=>({value:t,label:t}))],onChange:t=>n.update({frame:t||null})})}),n.source?.provenance?.length?D("details",{class:"cv-provenance",children:[D("summary",{children:"Provenance"}),D("dl",{children:n.source.provenance.map(([t,i])=>D("div",{children:[D("dt",{children:t}),D("dd",{title:i,children:i})]},t))})]}):null]})}function hT({core:n,label:e,parts:t}){let[i,s]=ss(!0),r=t.map(({name:l})=>l),o=new Set(t.map(l=>Xa(n.state,l))),a=o.size===1?[...o][0]:"mixed";return D("div",{class:"cv-group",role:"group","aria-label":e,children:[D("div",{class:"cv-row cv-row-group",children:[D("button",{type:"button",class:"cv-fold","aria-expanded":i,onClick:()=>s(!i),children:[D(Za,{name:"chevron"}),D("span",{children:e}),D("span",{class:"cv-count",children:t.length})]}),D(U_,{name:e,value:a,onChange:l=>n.setVisibility(r,l)})]}),i?t.map(l=>D(fT,{core:n,part:l},l.name)):null]})}function fT({core:n,part:e}){let t=Xa(n.state,e);return D("div",{class:`cv-row cv-row-${t}`,children:[D("span",{class:"cv-swatch",style:{background:n.display?.colours[e.index]}}),D("span",{class:"cv-name",title:e.name,children:D(dT,{name:e.name})}),e.copies>1?D("span",{class:"cv-count",title:`${e.copies} teeth`,children:["z ",e.copies]}):null,n.state.frame===e.name?D("span",{class:"cv-pin",title:"Fixed frame",children:D(Za,{name:"pin"})}):null,D(U_,{name:e.name,value:t,onChange:i=>n.setVisibility([e.name],i)})]})}function dT({name:n}){let[e,t]=m0(n);return e?D(Lt,{children:[D("span",{class:"cv-name-start",children:e}),D("span",{class:"cv-name-end",children:t})]}):D(Lt,{children:t})}function U_({name:n,value:e,onChange:t}){return D("button",{type:"button",class:"cv-eye","aria-label":`${n}: ${e}`,title:`${e}; click for ${N_[e]}, Alt and click for hidden`,onClick:i=>t(i.altKey?e==="hidden"?"visible":"hidden":N_[e]),children:D(Za,{name:uT[e]})})}function B_({core:n}){let e=n.pattern.pattern();return D("section",{class:"cv-pattern","aria-label":"Contact pattern",children:e?D(Lt,{children:[D(pT,{core:n,pattern:e}),D(gT,{core:n,pattern:e})]}):D("div",{class:"cv-muted",children:"No gear has contacts in this position."})})}function pT({core:n,pattern:e}){let{state:t}=n,{part:i}=e,[s,r]=ss(""),o=t.pattern.tooth,a=n.pattern.teeth(i).map(String);/^\d+$/.test(o)&&!a.includes(o)&&a.push(o);let l=n.pattern.pointed.get(i.index);return D("div",{class:"cv-pattern-head",children:[D($t,{quiet:!0,label:"Gear",value:i.name,options:n.pattern.gears().map(({name:c})=>({value:c,label:c})),onChange:c=>n.update({pattern:{gear:c}})}),D($t,{quiet:!0,label:"Tooth",value:o,options:[{value:"all",label:"All teeth"},{value:"pointer",label:l===void 0?"At the pointer":`At the pointer: ${l}`},...a.map(c=>({value:c,label:`Tooth ${c}`}))],onChange:c=>n.update({pattern:{tooth:c}})}),D($t,{quiet:!0,label:"Flank",value:t.pattern.flank,options:[{value:"automatic",label:`Loaded: ${e.side}`},{value:"left",label:"Left flank"},{value:"right",label:"Right flank"}],onChange:c=>n.update({pattern:{flank:c}})}),D($t,{quiet:!0,label:"Positions of the pattern",value:t.pattern.envelope?"all":"current",options:[{value:"current",label:"This position"},{value:"all",label:"All positions"}],onChange:c=>n.update({pattern:{envelope:c==="all"}})}),D($t,{quiet:!0,label:s?`Export the pattern. ${s}`:"Export the pattern",value:"",options:[{value:"",label:"Export"},{value:"png",label:"PNG"},{value:"svg",label:"SVG"},{value:"pdf",label:"PDF"}],onChange:c=>{c&&g_(n,c).catch(u=>r(String(u))),n.changed(!1)}}),D(mT,{core:n,pattern:e})]})}function mT({core:n,pattern:e}){let t=n.positions?.list.length??0,{envelope:i,limits:s,largest:r}=e,o=[];i&&i.included.size<t&&o.push(`read ${i.included.size} of ${t} positions …`),r===0&&!(i&&i.included.size<t)&&o.push("no loaded cells");let a=Ei();return r>s[1]*(1+1e-9)&&o.push(`up to ${Dt(r*a.factor)} ${a.symbol}, above the scale`),o.length>0?D("span",{class:"cv-muted",role:"note",children:o.join("; ")}):null}function O_(n,e,t,i){if(t<e.left||t>e.right||i<e.top||i>e.bottom)return null;let[s,r]=e.inverse(t,i),[o,a]=n.axes.inverse(s,r);if(n.envelope)return{value:n.envelope.at(s,r)||NaN,z:o,r:a,cell:null};let l=Y0(n.cells,o,a);return{value:l?.pressure??NaN,z:o,r:a,cell:l}}function gT({core:n,pattern:e}){let t=Ai(null),i=Ai(null),[s,r]=ss([0,0]),[o,a]=ss(null),{hovered:l}=n.pattern,c=!(n.drawers&&n.state.colours.field==="contact_pressure"),u=new Lo(s[0],s[1],e,c);Ti(()=>{let d=t.current,p=new ResizeObserver(()=>r([d.clientWidth,d.clientHeight]));return p.observe(d),()=>p.disconnect()},[]);let f=JSON.stringify([n.state.colours,e.limits,e.part.name,e.side,e.tooth,l,s,c,n.theme.theme,e.envelope?.included.size]);Ti(()=>{let d=i.current;if(s[0]<1||s[1]<1)return;let p=window.devicePixelRatio||1;d.width=Math.round(s[0]*p),d.height=Math.round(s[1]*p);let _=d.getContext("2d");_&&(_.scale(p,p),_.font="11px system-ui, sans-serif",Ju(new Yu(_),u,e,n.state.colours,Bd(n),l))},[f,n.display?.position]);let h=o?O_(e,u,...o):null;return D("div",{class:"cv-pattern-picture",ref:t,children:[D("canvas",{ref:i,role:"img","aria-label":kd(n,e),onPointerMove:d=>{let p=d.currentTarget.getBoundingClientRect(),_=[d.clientX-p.left,d.clientY-p.top];a(_),n.hover(O_(e,u,..._)?.cell?.cell??-1)},onPointerLeave:()=>{a(null),n.hover(-1)}}),h?D(_T,{pattern:e,reading:h,layout:u,pointer:o}):null]})}function _T({pattern:n,reading:e,layout:t,pointer:i}){let{value:s,z:r,r:o,cell:a}=e,l=Ei(),c=xn("m",1),[u,f]=Nd(n),{axes:h}=n,d=p=>`${Dt(p*c.factor,5)} ${c.symbol}`;return D("div",{class:"cv-tooltip",role:"status","aria-label":"Value in the pattern","data-value":Number.isFinite(s)?String(s):"",style:eh(...i,t.width,t.height),children:[D("div",{class:"cv-tooltip-value",children:D("strong",{children:Number.isFinite(s)?`${Dt(s*l.factor,6)} ${l.symbol}`:"no contact"})}),a?D("div",{children:["tooth ",a.tooth]}):null,D("div",{class:"cv-muted",children:["z ",d(r),", radius ",d(o)]}),h.direction!==0?D("div",{class:"cv-muted",children:["from the toe ",d(h.along(r,o)-u),", from the root ",d(h.across(r,o)-f)]}):null]})}var xT="uplot",vT="u-hz",yT="u-vt",bT="u-title",MT="u-wrap",ST="u-under",wT="u-over",ET="u-axis",Ir="u-off",TT="u-select",AT="u-cursor-x",CT="u-cursor-y",RT="u-cursor-pt",PT="u-legend",IT="u-live",LT="u-inline",DT="u-series",NT="u-marker",k_="u-label",FT="u-value",ja="width",Qa="height";var z_="bottom",Fo="left",Yd="right",hp="#000",V_=hp+"0",Zd="mousemove",H_="mousedown",Jd="mouseup",G_="mouseenter",W_="mouseleave",X_="dblclick",UT="resize",OT="scroll",q_="change",rh="dppxchange",fp="--",Ho=typeof window<"u",tp=Ho?document:null,Oo=Ho?window:null,BT=Ho?navigator:null,Et,th;function np(){let n=devicePixelRatio;Et!=n&&(Et=n,th&&sp(q_,th,np),th=matchMedia(`(min-resolution: ${Et-.001}dppx) and (max-resolution: ${Et+.001}dppx)`),Lr(q_,th,np),Oo.dispatchEvent(new CustomEvent(rh)))}function di(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function ip(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Yt(n,e,t){n.style[e]=t+"px"}function Hi(n,e,t,i){let s=tp.createElement(n);return e!=null&&di(s,e),t?.insertBefore(s,i),s}function Ci(n,e){return Hi("div",n,e)}var $_=new WeakMap;function os(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=$_.get(n);r!=o&&(n.style.transform=r,$_.set(n,r),e<0||t<0||e>i||t>s?di(n,Ir):ip(n,Ir))}var Y_=new WeakMap;function Z_(n,e,t){let i=e+t,s=Y_.get(n);i!=s&&(Y_.set(n,i),n.style.background=e,n.style.borderColor=t)}var J_=new WeakMap;function K_(n,e,t,i){let s=e+""+t,r=J_.get(n);s!=r&&(J_.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var dp={passive:!0},kT={...dp,capture:!0};function Lr(n,e,t,i){e.addEventListener(n,t,i?kT:dp)}function sp(n,e,t,i){e.removeEventListener(n,t,dp)}Ho&&np();function Gi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:pi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function Ex(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var Tx=n=>n!=null,Ax=n=>n!=null&&n>0,lh=Ex(Tx),zT=Ex(Ax);function VT(n,e,t,i=0,s=!1){let r=s?zT:lh,o=s?Ax:Tx;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ot,l??-Ot]}function ch(n,e,t,i){let s=ex(n),r=ex(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Cs:Cx,a=s==1?pi:Ri,l=r==1?Ri:pi,c=a(o(An(n))),u=l(o(An(e))),f=Bo(t,c),h=Bo(t,u);return t==10&&(c<0&&(f=Bt(f,-c)),u<0&&(h=Bt(h,-u))),i||t==2?(n=f*s,e=h*r):(n=Lx(n,f),e=uh(e,h)),[n,e]}function pp(n,e,t,i){let s=ch(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var mp=.1,j_={mode:3,pad:mp},tl={pad:0,soft:null,mode:0},HT={min:tl,max:tl};function oh(n,e,t,i){return hh(t)?Q_(n,e,t):(tl.pad=t,tl.soft=i?0:null,tl.mode=i?3:0,Q_(n,e,HT))}function St(n,e){return n??e}function GT(n,e,t){for(e=St(e,0),t=St(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Q_(n,e,t){let i=t.min,s=t.max,r=St(i.pad,0),o=St(s.pad,0),a=St(i.hard,-Ot),l=St(s.hard,Ot),c=St(i.soft,Ot),u=St(s.soft,-Ot),f=St(i.mode,0),h=St(s.mode,0),d=e-n,p=Cs(d),_=Qn(An(n),An(e)),g=Cs(_),m=An(g-p);(d<1e-24||m>10)&&(d=0,(n==0||e==0)&&(d=1e-24,f==2&&c!=Ot&&(r=0),h==2&&u!=-Ot&&(o=0)));let x=d||_||1e3,M=Cs(x),b=Bo(10,pi(M)),C=x*(d==0?n==0?.1:1:r),A=Bt(Lx(n-C,b/10),24),v=n>=c&&(f==1||f==3&&A<=c||f==2&&A>=c)?c:Ot,E=Qn(a,A<v&&n>=v?v:Wi(v,A)),U=x*(d==0?e==0?.1:1:o),L=Bt(uh(e+U,b/10),24),I=e<=u&&(h==1||h==3&&L>=u||h==2&&L<=u)?u:-Ot,k=Wi(l,L>I&&e<=I?I:Qn(I,L));return E==k&&E==0&&(k=100),[E,k]}var WT=new Intl.NumberFormat(Ho?BT.language:"en-US"),gp=n=>WT.format(n),mi=Math,sh=mi.PI,An=mi.abs,pi=mi.floor,Tn=mi.round,Ri=mi.ceil,Wi=mi.min,Qn=mi.max,Bo=mi.pow,ex=mi.sign,Cs=mi.log10,Cx=mi.log2,XT=(n,e=1)=>mi.sinh(n)*e,Kd=(n,e=1)=>mi.asinh(n/e),Ot=1/0;function tx(n){return(Cs((n^n>>31)-(n>>31))|0)+1}function rp(n,e,t){return Wi(Qn(n,e),t)}function Rx(n){return typeof n=="function"}function gt(n){return Rx(n)?n:()=>n}var qT=()=>{},Px=n=>n,Ix=(n,e)=>e,$T=n=>null,nx=n=>!0,ix=(n,e)=>n==e,YT=/\.\d*?(?=9{6,}|0{6,})/gm,Dr=n=>{if(Nx(n)||rr.has(n))return n;let e=`${n}`,t=e.match(YT);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Dr(s)}e${r}`}return Bt(n,i)};function Rr(n,e){return Dr(Bt(Dr(n/e))*e)}function uh(n,e){return Dr(Ri(Dr(n/e))*e)}function Lx(n,e){return Dr(pi(Dr(n/e))*e)}function Bt(n,e=0){if(Nx(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Tn(i)/t}var rr=new Map;function Dx(n){return((""+n).split(".")[1]||"").length}function il(n,e,t,i){let s=[],r=i.map(Dx);for(let o=e;o<t;o++){let a=An(o),l=Bt(Bo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Bt(u,f);s.push(h),rr.set(h,f)}}return s}var nl={},_p=[],ko=[null,null],sr=Array.isArray,Nx=Number.isInteger,ZT=n=>n===void 0;function sx(n){return typeof n=="string"}function hh(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function JT(n){return n!=null&&typeof n=="object"}var KT=Object.getPrototypeOf(Uint8Array),Fx="__proto__";function zo(n,e=hh){let t;if(sr(n)){let i=n.find(s=>s!=null);if(sr(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=zo(n[s],e)}else t=n.slice()}else if(n instanceof KT)t=n.slice();else if(e(n)){t={};for(let i in n)i!=Fx&&(t[i]=zo(n[i],e))}else t=n;return t}function bn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=Fx&&(hh(n[s])?bn(n[s],zo(i[s])):n[s]=zo(i[s]))}return n}var jT=0,QT=1,eA=2;function tA(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function nA(n,e){if(rA(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return oA(o[0])||(o=sA(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),h=e?e[o][c]:QT,d=[];for(let p=0;p<u.length;p++){let _=u[p],g=r.get(l[p]);_===null?h!=jT&&(f[g]=_,h==eA&&d.push(g)):f[g]=_}tA(f,d,s),i.push(f)}}return i}var iA=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function sA(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function rA(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function oA(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Qn(1,pi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Ux=["January","February","March","April","May","June","July","August","September","October","November","December"],Ox=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Bx(n){return n.slice(0,3)}var aA=Ox.map(Bx),lA=Ux.map(Bx),cA={MMMM:Ux,MMM:lA,WWWW:Ox,WWW:aA};function Ka(n){return(n<10?"0":"")+n}function uA(n){return(n<10?"00":n<100?"0":"")+n}var hA={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Ka(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ka(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Ka(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ka(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ka(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>uA(n.getMilliseconds())};function xp(n,e){e=e||cA;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?hA[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var fA=new Intl.DateTimeFormat().resolvedOptions().timeZone;function dA(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==fA?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var kx=n=>n%1==0,ah=[1,2,2.5,5],pA=il(10,-32,0,ah),zx=il(10,0,32,ah),mA=zx.filter(kx),Pr=pA.concat(zx),vp=`
`,Vx="{YYYY}",rx=vp+Vx,Hx="{M}/{D}",el=vp+Hx,nh=el+"/{YY}",Gx="{aa}",gA="{h}:{mm}",Uo=gA+Gx,ox=vp+Uo,ax=":{ss}",At=null;function Wx(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?il(10,0,3,ah).filter(kx):il(10,-3,0,ah)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Vx,At,At,At,At,At,At,1],[s*28,"{MMM}",rx,At,At,At,At,At,1],[s,Hx,rx,At,At,At,At,At,1],[i,"{h}"+Gx,nh,At,el,At,At,At,1],[t,Uo,nh,At,el,At,At,At,1],[e,ax,nh+" "+Uo,At,el+" "+Uo,At,ox,At,1],[n,ax+".{fff}",nh+" "+Uo,At,el+" "+Uo,At,ox,At,1]];function u(f){return(h,d,p,_,g,m)=>{let x=[],M=g>=o,b=g>=r&&g<o,C=f(p),A=Bt(C*n,3),v=jd(C.getFullYear(),M?0:C.getMonth(),b||M?1:C.getDate()),E=Bt(v*n,3);if(b||M){let U=b?g/r:0,L=M?g/o:0,I=A==E?A:Bt(jd(v.getFullYear()+L,v.getMonth()+U,1)*n,3),k=new Date(Tn(I/n)),z=k.getFullYear(),N=k.getMonth();for(let W=0;I<=_;W++){let $=jd(z+L*W,N+U*W,1),H=$-f(Bt($*n,3));I=Bt((+$+H)*n,3),I<=_&&x.push(I)}}else{let U=g>=s?s:g,L=pi(p)-pi(A),I=E+L+uh(A-E,U);x.push(I);let k=f(I),z=k.getHours()+k.getMinutes()/t+k.getSeconds()/i,N=g/i,W=h.axes[d]._space,$=m/W;for(;I=Bt(I+g,n==1?0:3),!(I>_);)if(N>1){let H=pi(Bt(z+N,6))%24,Q=f(I).getHours()-H;Q>1&&(Q=-1),I-=Q*i,z=(z+N)%24;let ie=x[x.length-1];Bt((I-ie)/g,3)*$>=.7&&x.push(I)}else x.push(I)}return x}}return[l,c,u]}var[_A,xA,vA]=Wx(1),[yA,bA,MA]=Wx(.001);il(2,-53,53,[1]);function lx(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function cx(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,f,h,d;return i.map(p=>{let _=n(p),g=_.getFullYear(),m=_.getMonth(),x=_.getDate(),M=_.getHours(),b=_.getMinutes(),C=_.getSeconds(),A=g!=l&&a[2]||m!=c&&a[3]||x!=u&&a[4]||M!=f&&a[5]||b!=h&&a[6]||C!=d&&a[7]||a[1];return l=g,c=m,u=x,f=M,h=b,d=C,A(_)})}}function SA(n,e){let t=xp(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function jd(n,e,t){return new Date(n,e,t)}function ux(n,e){return e(n)}var wA="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function hx(n,e){return(t,i,s,r)=>r==null?fp:e(n(i))}function EA(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function TA(n,e){return n.series[e].fill(n,e)}var AA={show:!0,live:!0,isolate:!1,mount:qT,markers:{show:!0,width:2,stroke:EA,fill:TA,dash:"solid"},idx:null,idxs:null,values:[]};function CA(n,e){let t=n.cursor.points,i=Ci(),s=t.size(n,e);Yt(i,ja,s),Yt(i,Qa,s);let r=s/-2;Yt(i,"marginLeft",r),Yt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Yt(i,"borderWidth",o),i}function RA(n,e){let t=n.series[e].points;return t._fill||t._stroke}function PA(n,e){let t=n.series[e].points;return t._stroke||t._fill}function IA(n,e){return n.series[e].points.size}var Qd=[0,0];function LA(n,e,t){return Qd[0]=e,Qd[1]=t,Qd}function ih(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function ep(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var DA={show:!0,x:!0,y:!0,lock:!1,move:LA,points:{one:!1,show:CA,size:IA,width:0,stroke:PA,fill:RA},bind:{mousedown:ih,mouseup:ih,click:ih,dblclick:ih,mousemove:ep,mouseleave:ep,mouseenter:ep},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Xx={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},yp=bn({},Xx,{filter:Ix}),qx=bn({},yp,{size:10}),$x=bn({},Xx,{show:!1}),bp='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Yx="bold "+bp,Zx=1.5,fx={show:!0,scale:"x",stroke:hp,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Yx,side:2,grid:yp,ticks:qx,border:$x,font:bp,lineGap:Zx,rotate:0},NA="Value",FA="Time",dx={show:!0,scale:"x",auto:!1,sorted:1,min:Ot,max:-Ot,idxs:[]};function UA(n,e,t,i,s){return e.map(r=>r==null?"":gp(r))}function OA(n,e,t,i,s,r,o){let a=[],l=rr.get(s)||0;t=o?t:Bt(uh(t,s),l);for(let c=t;c<=i;c=Bt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function op(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Cs:Cx,u=pi(c(t));s=Bo(l,u),l==10&&(s=Pr[Gi(s,Pr)]);let f=t,h=s*l;l==10&&(h=Pr[Gi(h,Pr)]);do a.push(f),f=f+s,l==10&&!rr.has(f)&&(f=Bt(f,rr.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=Pr[Gi(h,Pr)]));while(f<=i);return a}function BA(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?op(n,e,Qn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?op(n,e,Qn(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var Jx=/./,kA=/[12357]/,zA=/[125]/,px=/1/,ap=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function VA(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?Jx:l(7,o)-u>=c?kA:l(5,o)-u>=c?zA:px;if(f==px){let h=An(l(1,o)-u);if(h<c)return ap(e.slice().reverse(),a.distr,f,Ri(c/h)).reverse()}return ap(e,a.distr,f,1)}function HA(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=An(l(1,o)-l(2,o));return c<a?ap(e.slice().reverse(),3,Jx,Ri(a/c)).reverse():e}function GA(n,e,t,i){return i==null?fp:e==null?"":gp(e)}var mx={show:!0,scale:"y",stroke:hp,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Yx,side:3,grid:yp,ticks:qx,border:$x,font:bp,lineGap:Zx,rotate:0};function WA(n,e){let t=3+(n||1)*2;return Bt(t*e,3)}function XA(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=An(o-r),l=n.series[e],c=a/(l.points.space*Et);return i[1]-i[0]<=c}var gx={scale:null,auto:!0,sorted:0,min:Ot,max:-Ot},Kx=(n,e,t,i,s)=>s,_x={show:!0,auto:!0,sorted:0,gaps:Kx,alpha:1,facets:[bn({},gx,{scale:"x"}),bn({},gx,{scale:"y"})]},xx={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Kx,alpha:1,points:{show:XA,filter:null},values:null,min:Ot,max:-Ot,idxs:[],path:null,clip:null};function qA(n,e,t,i,s){return t/10}var jx={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},$A=bn({},jx,{time:!1,ori:1}),vx={};function Qx(n,e){let t=vx[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(vx[n]=t)),t}var Vo=1,lp=2;function Nr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,d=a.top,p=a.width,_=a.height,g=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,f,g,m,h,d,p,_,dh,Go,mh,tv,iv):t(s,l,c,u,f,m,g,d,h,_,p,ph,Wo,wp,nv,sv)}function Mp(n,e){let t=0,i=0,s=St(n.bands,_p);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function YA(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Rs(n,e,t,i,s,r){return Nr(n,e,(o,a,l,c,u,f,h,d,p,_,g)=>{let m=o.pxRound,x=c.dir*(c.ori==0?1:-1),M=c.ori==0?Go:Wo,b,C;x==1?(b=t,C=i):(b=i,C=t);let A=m(f(a[b],c,_,d)),v=m(h(l[b],u,g,p)),E=m(f(a[C],c,_,d)),U=m(h(r==1?u.max:u.min,u,g,p)),L=new Path2D(s);return M(L,E,U),M(L,A,U),M(L,A,v),L})}function fh(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?mh:wp,l=t;for(let f=0;f<n.length;f++){let h=n[f];if(h[1]>h[0]){let d=h[0]-l;d>0&&a(o,l,i,d,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function ZA(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Sp(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let f=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let d=r(n[f]),p=h==f?d:r(n[h]),_=f-s;d=o<=0&&_>=0&&_<l?r(n[_]):d;let m=h+s;p=o>=0&&m>=0&&m<l?r(n[m]):p,p>=d&&a.push([d,p])}return a}function yx(n){return n==0?Px:n==1?Tn:e=>Rr(e,n)}function ev(n){let e=n==0?dh:ph,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Wi(c,a/2,l/2),u=Wi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var dh=(n,e,t)=>{n.moveTo(e,t)},ph=(n,e,t)=>{n.moveTo(t,e)},Go=(n,e,t)=>{n.lineTo(e,t)},Wo=(n,e,t)=>{n.lineTo(t,e)},mh=ev(0),wp=ev(1),tv=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},nv=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},iv=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},sv=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function rv(n){return(e,t,i,s,r)=>Nr(e,t,(o,a,l,c,u,f,h,d,p,_,g)=>{let{pxRound:m,points:x}=o,M,b;c.ori==0?(M=dh,b=tv):(M=ph,b=nv);let C=Bt(x.width*Et,3),A=(x.size-x.width)/2*Et,v=Bt(A*2,3),E=new Path2D,U=new Path2D,{left:L,top:I,width:k,height:z}=e.bbox;mh(U,L-v,I-v,k+v*2,z+v*2);let N=W=>{if(l[W]!=null){let $=m(f(a[W],c,_,d)),H=m(h(l[W],u,g,p));M(E,$+A,H),b(E,$,H,A,0,sh*2)}};if(r)r.forEach(N);else for(let W=i;W<=s;W++)N(W);return{stroke:C>0?E:null,fill:E,clip:U,flags:Vo|lp}})}function ov(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var JA=ov(Go),KA=ov(Wo);function av(n){let e=St(n?.alignGaps,0);return(t,i,s,r)=>Nr(t,i,(o,a,l,c,u,f,h,d,p,_,g)=>{[s,r]=lh(l,s,r);let m=o.pxRound,x=z=>m(f(z,c,_,d)),M=z=>m(h(z,u,g,p)),b,C;c.ori==0?(b=Go,C=JA):(b=Wo,C=KA);let A=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Vo},E=v.stroke,U=!1;if(r-s>=_*4){let z=he=>t.posToVal(he,c.key,!0),N=null,W=null,$,H,le,J=x(a[A==1?s:r]),Q=x(a[s]),ie=x(a[r]),fe=z(A==1?Q+1:ie-1);for(let he=A==1?s:r;he>=s&&he<=r;he+=A){let ee=a[he],ge=(A==1?ee<fe:ee>fe)?J:x(ee),Se=l[he];ge==J?Se!=null?(H=Se,N==null?(b(E,ge,M(H)),$=N=W=H):H<N?N=H:H>W&&(W=H)):Se===null&&(U=!0):(N!=null&&C(E,J,M(N),M(W),M($),M(H)),Se!=null?(H=Se,b(E,ge,M(H)),N=W=$=H):(N=W=null,Se===null&&(U=!0)),J=ge,fe=z(J+A))}N!=null&&N!=W&&le!=J&&C(E,J,M(N),M(W),M($),M(H))}else for(let z=A==1?s:r;z>=s&&z<=r;z+=A){let N=l[z];N===null?U=!0:N!=null&&b(E,x(a[z]),M(N))}let[I,k]=Mp(t,i);if(o.fill!=null||I!=0){let z=v.fill=new Path2D(E),N=o.fillTo(t,i,o.min,o.max,I),W=M(N),$=x(a[s]),H=x(a[r]);A==-1&&([H,$]=[$,H]),b(z,H,W),b(z,$,W)}if(!o.spanGaps){let z=[];U&&z.push(...Sp(a,l,s,r,A,x,e)),v.gaps=z=o.gaps(t,i,s,r,z),v.clip=fh(z,c.ori,d,p,_,g)}return k!=0&&(v.band=k==2?[Rs(t,i,s,r,E,-1),Rs(t,i,s,r,E,1)]:Rs(t,i,s,r,E,k)),v})}function jA(n){let e=St(n.align,1),t=St(n.ascDesc,!1),i=St(n.alignGaps,0),s=St(n.extend,!1);return(r,o,a,l)=>Nr(r,o,(c,u,f,h,d,p,_,g,m,x,M)=>{[a,l]=lh(f,a,l);let b=c.pxRound,{left:C,width:A}=r.bbox,v=Q=>b(p(Q,h,x,g)),E=Q=>b(_(Q,d,M,m)),U=h.ori==0?Go:Wo,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Vo},I=L.stroke,k=h.dir*(h.ori==0?1:-1),z=E(f[k==1?a:l]),N=v(u[k==1?a:l]),W=N,$=N;s&&e==-1&&($=C,U(I,$,z)),U(I,N,z);for(let Q=k==1?a:l;Q>=a&&Q<=l;Q+=k){let ie=f[Q];if(ie==null)continue;let fe=v(u[Q]),he=E(ie);e==1?U(I,fe,z):U(I,W,he),U(I,fe,he),z=he,W=fe}let H=W;s&&e==1&&(H=C+A,U(I,H,z));let[le,J]=Mp(r,o);if(c.fill!=null||le!=0){let Q=L.fill=new Path2D(I),ie=c.fillTo(r,o,c.min,c.max,le),fe=E(ie);U(Q,H,fe),U(Q,$,fe)}if(!c.spanGaps){let Q=[];Q.push(...Sp(u,f,a,l,k,v,i));let ie=c.width*Et/2,fe=t||e==1?ie:-ie,he=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=fe,ee[1]+=he}),L.gaps=Q=c.gaps(r,o,a,l,Q),L.clip=fh(Q,h.ori,g,m,x,M)}return J!=0&&(L.band=J==2?[Rs(r,o,a,l,I,-1),Rs(r,o,a,l,I,1)]:Rs(r,o,a,l,I,J)),L})}function bx(n,e,t,i,s,r,o=Ot){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=An(n[l]-n[a]);u<c&&(c=u,o=An(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function QA(n){n=n||nl;let e=St(n.size,[.6,Ot,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=gt(s),o=1-e[0],a=St(e[1],Ot),l=St(e[2],1),c=St(n.disp,nl),u=St(n.each,d=>{}),{fill:f,stroke:h}=c;return(d,p,_,g)=>Nr(d,p,(m,x,M,b,C,A,v,E,U,L,I)=>{let k=m.pxRound,z=t,N=i*Et,W=a*Et,$=l*Et,H,le;b.ori==0?[H,le]=r(d,p):[le,H]=r(d,p);let J=b.dir*(b.ori==0?1:-1),Q=b.ori==0?mh:wp,ie=b.ori==0?u:(Re,$e,it,we,Ut,He,qe)=>{u(Re,$e,it,Ut,we,qe,He)},fe=St(d.bands,_p).find(Re=>Re.series[0]==p),he=fe!=null?fe.dir:0,ee=m.fillTo(d,p,m.min,m.max,he),me=k(v(ee,C,I,U)),ge,Se,xe,Ve=L,Xe=k(m.width*Et),Ne=!1,ct=null,ot=null,tt=null,Zt=null;f!=null&&(Xe==0||h!=null)&&(Ne=!0,ct=f.values(d,p,_,g),ot=new Map,new Set(ct).forEach(Re=>{Re!=null&&ot.set(Re,new Path2D)}),Xe>0&&(tt=h.values(d,p,_,g),Zt=new Map,new Set(tt).forEach(Re=>{Re!=null&&Zt.set(Re,new Path2D)})));let{x0:kt,size:un}=c;if(kt!=null&&un!=null){z=1,x=kt.values(d,p,_,g),kt.unit==2&&(x=x.map(it=>d.posToVal(E+it*L,b.key,!0)));let Re=un.values(d,p,_,g);un.unit==2?Se=Re[0]*L:Se=A(Re[0],b,L,E)-A(0,b,L,E),Ve=bx(x,M,A,b,L,E,Ve),xe=Ve-Se+N}else Ve=bx(x,M,A,b,L,E,Ve),xe=Ve*o+N,Se=Ve-xe;xe<1&&(xe=0),Xe>=Se/2&&(Xe=0),xe<5&&(k=Px);let Nt=xe>0,Cn=Ve-xe-(Nt?Xe:0);Se=k(rp(Cn,$,W)),ge=(z==0?Se/2:z==J?0:Se)-z*J*((z==0?N/2:0)+(Nt?Xe/2:0));let vt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Mn=Ne?null:new Path2D,Qt=null;if(fe!=null)Qt=d.data[fe.series[1]];else{let{y0:Re,y1:$e}=c;Re!=null&&$e!=null&&(M=$e.values(d,p,_,g),Qt=Re.values(d,p,_,g))}let hn=H*Se,B=le*Se;for(let Re=J==1?_:g;Re>=_&&Re<=g;Re+=J){let $e=M[Re];if($e==null)continue;if(Qt!=null){let q=Qt[Re]??0;if($e-q==0)continue;me=v(q,C,I,U)}let it=b.distr!=2||c!=null?x[Re]:Re,we=A(it,b,L,E),Ut=v(St($e,ee),C,I,U),He=k(we-ge),qe=k(Qn(Ut,me)),R=k(Wi(Ut,me)),S=qe-R;if($e!=null){let q=$e<0?B:hn,ue=$e<0?hn:B;Ne?(Xe>0&&tt[Re]!=null&&Q(Zt.get(tt[Re]),He,R+pi(Xe/2),Se,Qn(0,S-Xe),q,ue),ct[Re]!=null&&Q(ot.get(ct[Re]),He,R+pi(Xe/2),Se,Qn(0,S-Xe),q,ue)):Q(Mn,He,R+pi(Xe/2),Se,Qn(0,S-Xe),q,ue),ie(d,p,Re,He-Xe/2,R,Se+Xe,S)}}return Xe>0?vt.stroke=Ne?Zt:Mn:Ne||(vt._fill=m.width==0?m._fill:m._stroke??m._fill,vt.width=0),vt.fill=Ne?ot:Mn,vt})}function eC(n,e){let t=St(e?.alignGaps,0);return(i,s,r,o)=>Nr(i,s,(a,l,c,u,f,h,d,p,_,g,m)=>{[r,o]=lh(c,r,o);let x=a.pxRound,M=H=>x(h(H,u,g,p)),b=H=>x(d(H,f,m,_)),C,A,v;u.ori==0?(C=dh,v=Go,A=iv):(C=ph,v=Wo,A=sv);let E=u.dir*(u.ori==0?1:-1),U=M(l[E==1?r:o]),L=U,I=[],k=[];for(let H=E==1?r:o;H>=r&&H<=o;H+=E)if(c[H]!=null){let J=l[H],Q=M(J);I.push(L=Q),k.push(b(c[H]))}let z={stroke:n(I,k,C,v,A,x),fill:null,clip:null,band:null,gaps:null,flags:Vo},N=z.stroke,[W,$]=Mp(i,s);if(a.fill!=null||W!=0){let H=z.fill=new Path2D(N),le=a.fillTo(i,s,a.min,a.max,W),J=b(le);v(H,L,J),v(H,U,J)}if(!a.spanGaps){let H=[];H.push(...Sp(l,c,r,o,E,M,t)),z.gaps=H=a.gaps(i,s,r,o,H),z.clip=fh(H,u.ori,p,_,g,m)}return $!=0&&(z.band=$==2?[Rs(i,s,r,o,N,-1),Rs(i,s,r,o,N,1)]:Rs(i,s,r,o,N,$)),z})}function tC(n){return eC(nC,n)}function nC(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],f[h]=n[h+1]-n[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+f[h]/3,e[h]+l[h]*f[h]/3,n[h+1]-f[h]/3,e[h+1]-l[h+1]*f[h]/3,n[h+1],e[h+1])}return a}var cp=new Set;function Mx(){for(let n of cp)n.syncRect(!0)}Ho&&(Lr(UT,Oo,Mx),Lr(OT,Oo,Mx,!0),Lr(rh,Oo,()=>{zn.pxRatio=Et}));var iC=av(),sC=rv();function Sx(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>up(r,o,e,t))}function rC(n,e){return n.map((t,i)=>i==0?{}:bn({},e,t))}function up(n,e,t,i){return bn({},e==0?t:i,n)}function lv(n,e,t){return e==null?ko:[e,t]}var oC=lv;function aC(n,e,t){return e==null?ko:oh(e,t,mp,!0)}function cv(n,e,t,i){return e==null?ko:ch(e,t,n.scales[i].log,!1)}var lC=cv;function uv(n,e,t,i){return e==null?ko:pp(e,t,n.scales[i].log,!1)}var cC=uv;function uC(n,e,t,i,s){let r=Qn(tx(n),tx(e)),o=e-n,a=Gi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?rr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function wx(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Tn((t=+s)*Et))+"px"),[n,e,t]}function hC(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Bt(e[2]*Et,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function zn(n,e,t){let i={mode:St(n.mode,1)},s=i.mode;function r(y,w,P,F){let X=w.valToPct(y);return F+P*(w.dir==-1?1-X:X)}function o(y,w,P,F){let X=w.valToPct(y);return F+P*(w.dir==-1?X:1-X)}function a(y,w,P,F){return w.ori==0?r(y,w,P,F):o(y,w,P,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ci(xT);if(n.id!=null&&(c.id=n.id),di(c,n.class),n.title){let y=Ci(bT,c);y.textContent=n.title}let u=Hi("canvas"),f=i.ctx=u.getContext("2d"),h=Ci(MT,c);Lr("click",h,y=>{y.target===p&&(Vt!=Vr||Jt!=Hr)&&Un.click(i,y)},!0);let d=i.under=Ci(ST,h);h.appendChild(u);let p=i.over=Ci(wT,h);n=zo(n);let _=+St(n.pxAlign,1),g=yx(_);(n.plugins||[]).forEach(y=>{y.opts&&(n=y.opts(i,n)||n)});let m=n.ms||.001,x=i.series=s==1?Sx(n.series||[],dx,xx,!1):rC(n.series||[null],_x),M=i.axes=Sx(n.axes||[],fx,mx,!0),b=i.scales={},C=i.bands=n.bands||[];C.forEach(y=>{y.fill=gt(y.fill||null),y.dir=St(y.dir,-1)});let A=s==2?x[1].facets[0].scale:x[0].scale,v={axes:us,series:ht},E=(n.drawOrder||["axes","series"]).map(y=>v[y]);function U(y){let w=y.distr==3?P=>Cs(P>0?P:y.clamp(i,P,y.min,y.max,y.key)):y.distr==4?P=>Kd(P,y.asinh):y.distr==100?P=>y.fwd(P):P=>P;return P=>{let F=w(P),{_min:X,_max:K}=y,ae=K-X;return(F-X)/ae}}function L(y){let w=b[y];if(w==null){let P=(n.scales||nl)[y]||nl;if(P.from!=null){L(P.from);let F=bn({},b[P.from],P,{key:y});F.valToPct=U(F),b[y]=F}else{w=b[y]=bn({},y==A?jx:$A,P),w.key=y;let F=w.time,X=w.range,K=sr(X);if((y!=A||s==2&&!F)&&(K&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?j_:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?j_:{mode:1,hard:X[1],soft:X[1]}},K=!1),!K&&hh(X))){let ae=X;X=(de,be,De)=>be==null?ko:oh(be,De,ae)}w.range=gt(X||(F?oC:y==A?w.distr==3?lC:w.distr==4?cC:lv:w.distr==3?cv:w.distr==4?uv:aC)),w.auto=gt(K?!1:w.auto),w.clamp=gt(w.clamp||qA),w._min=w._max=null,w.valToPct=U(w)}}}L("x"),L("y"),s==1&&x.forEach(y=>{L(y.scale)}),M.forEach(y=>{L(y.scale)});for(let y in n.scales)L(y);let I=b[A],k=I.distr,z,N;I.ori==0?(di(c,vT),z=r,N=o):(di(c,yT),z=o,N=r);let W={};for(let y in b){let w=b[y];(w.min!=null||w.max!=null)&&(W[y]={min:w.min,max:w.max},w.min=w.max=null)}let $=n.tzDate||(y=>new Date(Tn(y/m))),H=n.fmtDate||xp,le=m==1?vA($):MA($),J=cx($,lx(m==1?xA:bA,H)),Q=hx($,ux(wA,H)),ie=[],fe=i.legend=bn({},AA,n.legend),he=i.cursor=bn({},DA,{drag:{y:s==2}},n.cursor),ee=fe.show,me=he.show,ge=fe.markers;fe.idxs=ie,ge.width=gt(ge.width),ge.dash=gt(ge.dash),ge.stroke=gt(ge.stroke),ge.fill=gt(ge.fill);let Se,xe,Ve,Xe=[],Ne=[],ct,ot=!1,tt={};if(fe.live){let y=x[1]?x[1].values:null;ot=y!=null,ct=ot?y(i,1,0):{_:0};for(let w in ct)tt[w]=fp}if(ee)if(Se=Hi("table",PT,c),Ve=Hi("tbody",null,Se),fe.mount(i,Se),ot){xe=Hi("thead",null,Se,Ve);let y=Hi("tr",null,xe);Hi("th",null,y);for(var Zt in ct)Hi("th",k_,y).textContent=Zt}else di(Se,LT),fe.live&&di(Se,IT);let kt={show:!0},un={show:!1};function Nt(y,w){if(w==0&&(ot||!fe.live||s==2))return ko;let P=[],F=Hi("tr",DT,Ve,Ve.childNodes[w]);di(F,y.class),y.show||di(F,Ir);let X=Hi("th",null,F);if(ge.show){let de=Ci(NT,X);if(w>0){let be=ge.width(i,w);be&&(de.style.border=be+"px "+ge.dash(i,w)+" "+ge.stroke(i,w)),de.style.background=ge.fill(i,w)}}let K=Ci(k_,X);y.label instanceof HTMLElement?K.appendChild(y.label):K.textContent=y.label,w>0&&(ge.show||(K.style.color=y.width>0?ge.stroke(i,w):ge.fill(i,w)),vt("click",X,de=>{if(he._lock)return;Je(de);let be=x.indexOf(y);if((de.ctrlKey||de.metaKey)!=fe.isolate){let De=x.some((Fe,Oe)=>Oe>0&&Oe!=be&&Fe.show);x.forEach((Fe,Oe)=>{Oe>0&&Yi(Oe,De?Oe==be?kt:un:kt,!0,mn.setSeries)})}else Yi(be,{show:!y.show},!0,mn.setSeries)},!1),Ke&&vt(G_,X,de=>{he._lock||(Je(de),Yi(x.indexOf(y),Wr,!0,mn.setSeries))},!1));for(var ae in ct){let de=Hi("td",FT,F);de.textContent="--",P.push(de)}return[F,P]}let Cn=new Map;function vt(y,w,P,F=!0){let X=Cn.get(w)||{},K=he.bind[y](i,w,P,F);K&&(Lr(y,w,X[y]=K),Cn.set(w,X))}function Mn(y,w,P){let F=Cn.get(w)||{};for(let X in F)(y==null||X==y)&&(sp(X,w,F[X]),delete F[X]);y==null&&Cn.delete(w)}let Qt=0,hn=0,B=0,Re=0,$e=0,it=0,we=$e,Ut=it,He=B,qe=Re,R=0,S=0,q=0,ue=0;i.bbox={};let oe=!1,ve=!1,ye=!1,te=!1,se=!1,pe=!1;function O(y,w,P){(P||y!=i.width||w!=i.height)&&re(y,w),at(!1),ye=!0,ve=!0,Vn()}function re(y,w){i.width=Qt=B=y,i.height=hn=Re=w,$e=it=0,Me(),Ge();let P=i.bbox;R=P.left=Rr($e*Et,.5),S=P.top=Rr(it*Et,.5),q=P.width=Rr(B*Et,.5),ue=P.height=Rr(Re*Et,.5)}let ne=3;function Ee(){let y=!1,w=0;for(;!y;){w++;let P=Br(w),F=$i(w);y=w==ne||P&&F,y||(re(i.width,i.height),ve=!0)}}function _e({width:y,height:w}){O(y,w)}i.setSize=_e;function Me(){let y=!1,w=!1,P=!1,F=!1;M.forEach((X,K)=>{if(X.show&&X._show){let{side:ae,_size:de}=X,be=ae%2,De=X.label!=null?X.labelSize:0,Fe=de+De;Fe>0&&(be?(B-=Fe,ae==3?($e+=Fe,F=!0):P=!0):(Re-=Fe,ae==0?(it+=Fe,y=!0):w=!0))}}),Xi[0]=y,Xi[1]=P,Xi[2]=w,Xi[3]=F,B-=Pi[1]+Pi[3],$e+=Pi[3],Re-=Pi[2]+Pi[0],it+=Pi[0]}function Ge(){let y=$e+B,w=it+Re,P=$e,F=it;function X(K,ae){switch(K){case 1:return y+=ae,y-ae;case 2:return w+=ae,w-ae;case 3:return P-=ae,P+ae;case 0:return F-=ae,F+ae}}M.forEach((K,ae)=>{if(K.show&&K._show){let de=K.side;K._pos=X(de,K._size),K.label!=null&&(K._lpos=X(de,K.labelSize))}})}if(he.dataIdx==null){let y=he.hover,w=y.skip=new Set(y.skip??[]);w.add(void 0);let P=y.prox=gt(y.prox),F=y.bias??=0;he.dataIdx=(X,K,ae,de)=>{if(K==0)return ae;let be=ae,De=P(X,K,ae,de)??Ot,Fe=De>=0&&De<Ot,Oe=I.ori==0?B:Re,nt=he.left,wt=e[0],bt=e[K];if(w.has(bt[ae])){be=null;let ft=null,Ze=null,We;if(F==0||F==-1)for(We=ae;ft==null&&We-- >0;)w.has(bt[We])||(ft=We);if(F==0||F==1)for(We=ae;Ze==null&&We++<bt.length;)w.has(bt[We])||(Ze=We);if(ft!=null||Ze!=null)if(Fe){let Gt=ft==null?-1/0:z(wt[ft],I,Oe,0),nn=Ze==null?1/0:z(wt[Ze],I,Oe,0),Ln=nt-Gt,Ft=nn-nt;Ln<=Ft?Ln<=De&&(be=ft):Ft<=De&&(be=Ze)}else be=Ze==null?ft:ft==null?Ze:ae-ft<=Ze-ae?ft:Ze}else Fe&&An(nt-z(wt[ae],I,Oe,0))>De&&(be=null);return be}}let Je=y=>{he.event=y};he.idxs=ie,he._lock=!1;let ce=he.points;ce.show=gt(ce.show),ce.size=gt(ce.size),ce.stroke=gt(ce.stroke),ce.width=gt(ce.width),ce.fill=gt(ce.fill);let Be=i.focus=bn({},n.focus||{alpha:.3},he.focus),Ke=Be.prox>=0,Ce=Ke&&ce.one,st=[],zt=[],Xn=[];function Xo(y,w){let P=ce.show(i,w);if(P instanceof HTMLElement)return di(P,RT),di(P,y.class),os(P,-10,-10,B,Re),p.insertBefore(P,st[w]),P}function Fr(y,w){if(s==1||w>0){let P=s==1&&b[y.scale].time,F=y.value;y.value=P?sx(F)?hx($,ux(F,H)):F||Q:F||GA,y.label=y.label||(P?FA:NA)}if(Ce||w>0){y.width=y.width==null?1:y.width,y.paths=y.paths||iC||$T,y.fillTo=gt(y.fillTo||YA),y.pxAlign=+St(y.pxAlign,_),y.pxRound=yx(y.pxAlign),y.stroke=gt(y.stroke||null),y.fill=gt(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let P=WA(Qn(1,y.width),1),F=y.points=bn({},{size:P,width:Qn(1,P*.2),stroke:y.stroke,space:P*2,paths:sC,_stroke:null,_fill:null},y.points);F.show=gt(F.show),F.filter=gt(F.filter),F.fill=gt(F.fill),F.stroke=gt(F.stroke),F.paths=gt(F.paths),F.pxAlign=y.pxAlign}if(ee){let P=Nt(y,w);Xe.splice(w,0,P[0]),Ne.splice(w,0,P[1]),fe.values.push(null)}if(me){ie.splice(w,0,null);let P=null;Ce?w==0&&(P=Xo(y,w)):w>0&&(P=Xo(y,w)),st.splice(w,0,P),zt.splice(w,0,0),Xn.splice(w,0,0)}In("addSeries",w)}function gh(y,w){w=w??x.length,y=s==1?up(y,w,dx,xx):up(y,w,{},_x),x.splice(w,0,y),Fr(x[w],w)}i.addSeries=gh;function rl(y){if(x.splice(y,1),ee){fe.values.splice(y,1),Ne.splice(y,1);let w=Xe.splice(y,1)[0];Mn(null,w.firstChild),w.remove()}me&&(ie.splice(y,1),st.splice(y,1)[0].remove(),zt.splice(y,1),Xn.splice(y,1)),In("delSeries",y)}i.delSeries=rl;let Xi=[!1,!1,!1,!1];function as(y,w){if(y._show=y.show,y.show){let P=y.side%2,F=b[y.scale];F==null&&(y.scale=P?x[1].scale:A,F=b[y.scale]);let X=F.time;y.size=gt(y.size),y.space=gt(y.space),y.rotate=gt(y.rotate),sr(y.incrs)&&y.incrs.forEach(ae=>{!rr.has(ae)&&rr.set(ae,Dx(ae))}),y.incrs=gt(y.incrs||(F.distr==2?mA:X?m==1?_A:yA:Pr)),y.splits=gt(y.splits||(X&&F.distr==1?le:F.distr==3?op:F.distr==4?BA:OA)),y.stroke=gt(y.stroke),y.grid.stroke=gt(y.grid.stroke),y.ticks.stroke=gt(y.ticks.stroke),y.border.stroke=gt(y.border.stroke);let K=y.values;y.values=sr(K)&&!sr(K[0])?gt(K):X?sr(K)?cx($,lx(K,H)):sx(K)?SA($,K):K||J:K||UA,y.filter=gt(y.filter||(F.distr>=3&&F.log==10?VA:F.distr==3&&F.log==2?HA:Ix)),y.font=wx(y.font),y.labelFont=wx(y.labelFont),y._size=y.size(i,null,w,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(Xi[w]=!0,y._el=Ci(ET,h))}}function ls(y,w,P,F){let[X,K,ae,de]=P,be=w%2,De=0;return be==0&&(de||K)&&(De=w==0&&!X||w==2&&!ae?Tn(fx.size/3):0),be==1&&(X||ae)&&(De=w==1&&!K||w==3&&!de?Tn(mx.size/2):0),De}let qo=i.padding=(n.padding||[ls,ls,ls,ls]).map(y=>gt(St(y,ls))),Pi=i._padding=qo.map((y,w)=>y(i,w,Xi,0)),en,an=null,ln=null,qi=s==1?x[0].idxs:null,ni=null,Ps=!1;function $o(y,w){if(e=y??[],i.data=i._data=e,s==2){en=0;for(let P=1;P<x.length;P++)en+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),ni=e[0],en=ni.length;let P=e;if(k==2){P=e.slice();let F=P[0]=Array(en);for(let X=0;X<en;X++)F[X]=X}i._data=e=P}if(at(!0),In("setData"),k==2&&(ye=!0),w!==!1){let P=I;P.auto(i,Ps)?Yo():Ds(A,P.min,P.max),te=te||he.left>=0,pe=!0,Vn()}}i.setData=$o;function Yo(){Ps=!0;let y,w;s==1&&(en>0?(an=qi[0]=0,ln=qi[1]=en-1,y=e[0][an],w=e[0][ln],k==2?(y=an,w=ln):y==w&&(k==3?[y,w]=ch(y,y,I.log,!1):k==4?[y,w]=pp(y,y,I.log,!1):I.time?w=y+Tn(86400/m):[y,w]=oh(y,w,mp,!0))):(an=qi[0]=y=null,ln=qi[1]=w=null)),Ds(A,y,w)}let Ur,Is,Or,T,V,j,Y,Z,Te,Pe;function Ae(y,w,P,F,X,K){y??=V_,P??=_p,F??="butt",X??=V_,K??="round",y!=Ur&&(f.strokeStyle=Ur=y),X!=Is&&(f.fillStyle=Is=X),w!=Or&&(f.lineWidth=Or=w),K!=V&&(f.lineJoin=V=K),F!=j&&(f.lineCap=j=F),P!=T&&f.setLineDash(T=P)}function Ie(y,w,P,F){w!=Is&&(f.fillStyle=Is=w),y!=Y&&(f.font=Y=y),P!=Z&&(f.textAlign=Z=P),F!=Te&&(f.textBaseline=Te=F)}function ze(y,w,P,F,X=0){if(F.length>0&&y.auto(i,Ps)&&(w==null||w.min==null)){let K=St(an,0),ae=St(ln,F.length-1),de=P.min==null?VT(F,K,ae,X,y.distr==3):[P.min,P.max];y.min=Wi(y.min,P.min=de[0]),y.max=Qn(y.max,P.max=de[1])}}let je={min:null,max:null};function ut(){for(let F in b){let X=b[F];W[F]==null&&(X.min==null||W[A]!=null&&X.auto(i,Ps))&&(W[F]=je)}for(let F in b){let X=b[F];W[F]==null&&X.from!=null&&W[X.from]!=null&&(W[F]=je)}W[A]!=null&&at(!0);let y={};for(let F in W){let X=W[F];if(X!=null){let K=y[F]=zo(b[F],JT);if(X.min!=null)bn(K,X);else if(F!=A||s==2)if(en==0&&K.from==null){let ae=K.range(i,null,null,F);K.min=ae[0],K.max=ae[1]}else K.min=Ot,K.max=-Ot}}if(en>0){x.forEach((F,X)=>{if(s==1){let K=F.scale,ae=W[K];if(ae==null)return;let de=y[K];if(X==0){let be=de.range(i,de.min,de.max,K);de.min=be[0],de.max=be[1],an=Gi(de.min,e[0]),ln=Gi(de.max,e[0]),ln-an>1&&(e[0][an]<de.min&&an++,e[0][ln]>de.max&&ln--),F.min=ni[an],F.max=ni[ln]}else F.show&&F.auto&&ze(de,ae,F,e[X],F.sorted);F.idxs[0]=an,F.idxs[1]=ln}else if(X>0&&F.show&&F.auto){let[K,ae]=F.facets,de=K.scale,be=ae.scale,[De,Fe]=e[X],Oe=y[de],nt=y[be];Oe!=null&&ze(Oe,W[de],K,De,K.sorted),nt!=null&&ze(nt,W[be],ae,Fe,ae.sorted),F.min=ae.min,F.max=ae.max}});for(let F in y){let X=y[F],K=W[F];if(X.from==null&&(K==null||K.min==null)){let ae=X.range(i,X.min==Ot?null:X.min,X.max==-Ot?null:X.max,F);X.min=ae[0],X.max=ae[1]}}}for(let F in y){let X=y[F];if(X.from!=null){let K=y[X.from];if(K.min==null)X.min=X.max=null;else{let ae=X.range(i,K.min,K.max,F);X.min=ae[0],X.max=ae[1]}}}let w={},P=!1;for(let F in y){let X=y[F],K=b[F];if(K.min!=X.min||K.max!=X.max){K.min=X.min,K.max=X.max;let ae=K.distr;K._min=ae==3?Cs(K.min):ae==4?Kd(K.min,K.asinh):ae==100?K.fwd(K.min):K.min,K._max=ae==3?Cs(K.max):ae==4?Kd(K.max,K.asinh):ae==100?K.fwd(K.max):K.max,w[F]=P=!0}}if(P){x.forEach((F,X)=>{s==2?X>0&&w.y&&(F._paths=null):w[F.scale]&&(F._paths=null)});for(let F in w)ye=!0,In("setScale",F);me&&he.left>=0&&(te=pe=!0)}for(let F in W)W[F]=null}function ke(y){let w=rp(an-1,0,en-1),P=rp(ln+1,0,en-1);for(;y[w]==null&&w>0;)w--;for(;y[P]==null&&P<en-1;)P++;return[w,P]}function ht(){if(en>0){let y=x.some(w=>w._focus)&&Pe!=Be.alpha;y&&(f.globalAlpha=Pe=Be.alpha),x.forEach((w,P)=>{if(P>0&&w.show&&(Kt(P,!1),Kt(P,!0),w._paths==null)){let F=Pe;Pe!=w.alpha&&(f.globalAlpha=Pe=w.alpha);let X=s==2?[0,e[P][0].length-1]:ke(e[P]);w._paths=w.paths(i,P,X[0],X[1]),Pe!=F&&(f.globalAlpha=Pe=F)}}),x.forEach((w,P)=>{if(P>0&&w.show){let F=Pe;Pe!=w.alpha&&(f.globalAlpha=Pe=w.alpha),w._paths!=null&&Ct(P,!1);{let X=w._paths!=null?w._paths.gaps:null,K=w.points.show(i,P,an,ln,X),ae=w.points.filter(i,P,K,X);(K||ae)&&(w.points._paths=w.points.paths(i,P,an,ln,ae),Ct(P,!0))}Pe!=F&&(f.globalAlpha=Pe=F),In("drawSeries",P)}}),y&&(f.globalAlpha=Pe=1)}}function Kt(y,w){let P=w?x[y].points:x[y];P._stroke=P.stroke(i,y),P._fill=P.fill(i,y)}function Ct(y,w){let P=w?x[y].points:x[y],{stroke:F,fill:X,clip:K,flags:ae,_stroke:de=P._stroke,_fill:be=P._fill,_width:De=P.width}=P._paths;De=Bt(De*Et,3);let Fe=null,Oe=De%2/2;w&&be==null&&(be=De>0?"#fff":de);let nt=P.pxAlign==1&&Oe>0;if(nt&&f.translate(Oe,Oe),!w){let wt=R-De/2,bt=S-De/2,ft=q+De,Ze=ue+De;Fe=new Path2D,Fe.rect(wt,bt,ft,Ze)}w?Ue(de,De,P.dash,P.cap,be,F,X,ae,K):Rt(y,de,De,P.dash,P.cap,be,F,X,ae,Fe,K),nt&&f.translate(-Oe,-Oe)}function Rt(y,w,P,F,X,K,ae,de,be,De,Fe){let Oe=!1;be!=0&&C.forEach((nt,wt)=>{if(nt.series[0]==y){let bt=x[nt.series[1]],ft=e[nt.series[1]],Ze=(bt._paths||nl).band;sr(Ze)&&(Ze=nt.dir==1?Ze[0]:Ze[1]);let We,Gt=null;bt.show&&Ze&&GT(ft,an,ln)?(Gt=nt.fill(i,wt)||K,We=bt._paths.clip):Ze=null,Ue(w,P,F,X,Gt,ae,de,be,De,Fe,We,Ze),Oe=!0}}),Oe||Ue(w,P,F,X,K,ae,de,be,De,Fe)}let Sn=Vo|lp;function Ue(y,w,P,F,X,K,ae,de,be,De,Fe,Oe){Ae(y,w,P,F,X),(be||De||Oe)&&(f.save(),be&&f.clip(be),De&&f.clip(De)),Oe?(de&Sn)==Sn?(f.clip(Oe),Fe&&f.clip(Fe),dt(X,ae),fn(y,K,w)):de&lp?(dt(X,ae),f.clip(Oe),fn(y,K,w)):de&Vo&&(f.save(),f.clip(Oe),Fe&&f.clip(Fe),dt(X,ae),f.restore(),fn(y,K,w)):(dt(X,ae),fn(y,K,w)),(be||De||Oe)&&f.restore()}function fn(y,w,P){P>0&&(w instanceof Map?w.forEach((F,X)=>{f.strokeStyle=Ur=X,f.stroke(F)}):w!=null&&y&&f.stroke(w))}function dt(y,w){w instanceof Map?w.forEach((P,F)=>{f.fillStyle=Is=F,f.fill(P)}):w!=null&&y&&f.fill(w)}function cs(y,w,P,F){let X=M[y],K;if(F<=0)K=[0,0];else{let ae=X._space=X.space(i,y,w,P,F),de=X._incrs=X.incrs(i,y,w,P,F,ae);K=uC(w,P,de,F,ae)}return X._found=K}function dn(y,w,P,F,X,K,ae,de,be,De){let Fe=ae%2/2;_==1&&f.translate(Fe,Fe),Ae(de,ae,be,De,de),f.beginPath();let Oe,nt,wt,bt,ft=X+(F==0||F==3?-K:K);P==0?(nt=X,bt=ft):(Oe=X,wt=ft);for(let Ze=0;Ze<y.length;Ze++)w[Ze]!=null&&(P==0?Oe=wt=y[Ze]:nt=bt=y[Ze],f.moveTo(Oe,nt),f.lineTo(wt,bt));f.stroke(),_==1&&f.translate(-Fe,-Fe)}function Br(y){let w=!0;return M.forEach((P,F)=>{if(!P.show)return;let X=b[P.scale];if(X.min==null){P._show&&(w=!1,P._show=!1,at(!1));return}else P._show||(w=!1,P._show=!0,at(!1));let K=P.side,ae=K%2,{min:de,max:be}=X,[De,Fe]=cs(F,de,be,ae==0?B:Re);if(Fe==0)return;let Oe=X.distr==2,nt=P._splits=P.splits(i,F,de,be,De,Fe,Oe),wt=X.distr==2?nt.map(We=>ni[We]):nt,bt=X.distr==2?ni[nt[1]]-ni[nt[0]]:De,ft=P._values=P.values(i,P.filter(i,wt,F,Fe,bt),F,Fe,bt);P._rotate=K==2?P.rotate(i,ft,F,Fe):0;let Ze=P._size;P._size=Ri(P.size(i,ft,F,y)),Ze!=null&&P._size!=Ze&&(w=!1)}),w}function $i(y){let w=!0;return qo.forEach((P,F)=>{let X=P(i,F,Xi,y);X!=Pi[F]&&(w=!1),Pi[F]=X}),w}function us(){for(let y=0;y<M.length;y++){let w=M[y];if(!w.show||!w._show)continue;let P=w.side,F=P%2,X,K,ae=w.stroke(i,y),de=P==0||P==3?-1:1,[be,De]=w._found;if(w.label!=null){let Yn=w.labelGap*de,ri=Tn((w._lpos+Yn)*Et);Ie(w.labelFont[0],ae,"center",P==2?"top":z_),f.save(),F==1?(X=K=0,f.translate(ri,Tn(S+ue/2)),f.rotate((P==3?-sh:sh)/2)):(X=Tn(R+q/2),K=ri);let lr=Rx(w.label)?w.label(i,y,be,De):w.label;f.fillText(lr,X,K),f.restore()}if(De==0)continue;let Fe=b[w.scale],Oe=F==0?q:ue,nt=F==0?R:S,wt=w._splits,bt=Fe.distr==2?wt.map(Yn=>ni[Yn]):wt,ft=Fe.distr==2?ni[wt[1]]-ni[wt[0]]:be,Ze=w.ticks,We=w.border,Gt=Ze.show?Ze.size:0,nn=Tn(Gt*Et),Ln=Tn((w.alignTo==2?w._size-Gt-w.gap:w.gap)*Et),Ft=w._rotate*-sh/180,sn=g(w._pos*Et),ii=(nn+Ln)*de,$n=sn+ii;K=F==0?$n:0,X=F==1?$n:0;let gi=w.font[0],Ii=w.align==1?Fo:w.align==2?Yd:Ft>0?Fo:Ft<0?Yd:F==0?"center":P==3?Yd:Fo,Ji=Ft||F==1?"middle":P==2?"top":z_;Ie(gi,ae,Ii,Ji);let si=w.font[1]*w.lineGap,_i=wt.map(Yn=>g(a(Yn,Fe,Oe,nt))),Li=w._values;for(let Yn=0;Yn<Li.length;Yn++){let ri=Li[Yn];if(ri!=null){F==0?X=_i[Yn]:K=_i[Yn],ri=""+ri;let lr=ri.indexOf(`
`)==-1?[ri]:ri.split(/\n/gm);for(let Zn=0;Zn<lr.length;Zn++){let $p=lr[Zn];Ft?(f.save(),f.translate(X,K+Zn*si),f.rotate(Ft),f.fillText($p,0,0),f.restore()):f.fillText($p,X,K+Zn*si)}}}Ze.show&&dn(_i,Ze.filter(i,bt,y,De,ft),F,P,sn,nn,Bt(Ze.width*Et,3),Ze.stroke(i,y),Ze.dash,Ze.cap);let Ki=w.grid;Ki.show&&dn(_i,Ki.filter(i,bt,y,De,ft),F,F==0?2:1,F==0?S:R,F==0?ue:q,Bt(Ki.width*Et,3),Ki.stroke(i,y),Ki.dash,Ki.cap),We.show&&dn([sn],[1],F==0?1:0,F==0?1:2,F==1?S:R,F==1?ue:q,Bt(We.width*Et,3),We.stroke(i,y),We.dash,We.cap)}In("drawAxes")}function at(y){x.forEach((w,P)=>{P>0&&(w._paths=null,y&&(s==1?(w.min=null,w.max=null):w.facets.forEach(F=>{F.min=null,F.max=null})))})}let tn=!1,qn=!1,Pt=[];function pn(){qn=!1;for(let y=0;y<Pt.length;y++)In(...Pt[y]);Pt.length=0}function Vn(){tn||(iA(Rp),tn=!0)}function ol(y,w=!1){tn=!0,qn=w,y(i),Rp(),w&&Pt.length>0&&queueMicrotask(pn)}i.batch=ol;function Rp(){if(oe&&(ut(),oe=!1),ye&&(Ee(),ye=!1),ve){if(Yt(d,Fo,$e),Yt(d,"top",it),Yt(d,ja,B),Yt(d,Qa,Re),Yt(p,Fo,$e),Yt(p,"top",it),Yt(p,ja,B),Yt(p,Qa,Re),Yt(h,ja,Qt),Yt(h,Qa,hn),u.width=Tn(Qt*Et),u.height=Tn(hn*Et),M.forEach(({_el:y,_show:w,_size:P,_pos:F,side:X})=>{if(y!=null)if(w){let K=X===3||X===0?P:0,ae=X%2==1;Yt(y,ae?"left":"top",F-K),Yt(y,ae?"width":"height",P),Yt(y,ae?"top":"left",ae?it:$e),Yt(y,ae?"height":"width",ae?Re:B),ip(y,Ir)}else di(y,Ir)}),Ur=Is=Or=V=j=Y=Z=Te=T=null,Pe=1,Ko(!0),$e!=we||it!=Ut||B!=He||Re!=qe){at(!1);let y=B/He,w=Re/qe;if(me&&!te&&he.left>=0){he.left*=y,he.top*=w,kr&&os(kr,Tn(he.left),0,B,Re),zr&&os(zr,0,Tn(he.top),B,Re);for(let P=0;P<st.length;P++){let F=st[P];F!=null&&(zt[P]*=y,Xn[P]*=w,os(F,Ri(zt[P]),Ri(Xn[P]),B,Re))}}if(Ht.show&&!se&&Ht.left>=0&&Ht.width>0){Ht.left*=y,Ht.width*=y,Ht.top*=w,Ht.height*=w;for(let P in Mh)Yt(Gr,P,Ht[P])}we=$e,Ut=it,He=B,qe=Re}In("setSize"),ve=!1}Qt>0&&hn>0&&(f.clearRect(0,0,u.width,u.height),In("drawClear"),E.forEach(y=>y()),In("draw")),Ht.show&&se&&(al(Ht),se=!1),me&&te&&(ar(null,!0,!1),te=!1),fe.show&&fe.live&&pe&&(yh(),pe=!1),l||(l=!0,i.status=1,In("ready")),Ps=!1,tn=!1}i.redraw=(y,w)=>{ye=w||!1,y!==!1?Ds(A,I.min,I.max):Vn()};function _h(y,w){let P=b[y];if(P.from==null){if(en==0){let F=P.range(i,w.min,w.max,y);w.min=F[0],w.max=F[1]}if(w.min>w.max){let F=w.min;w.min=w.max,w.max=F}if(en>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;y==A&&P.distr==2&&en>0&&(w.min=Gi(w.min,e[0]),w.max=Gi(w.max,e[0]),w.min==w.max&&w.max++),W[y]=w,oe=!0,Vn()}}i.setScale=_h;let xh,vh,kr,zr,Pp,Ip,Vr,Hr,Lp,Dp,Vt,Jt,Ls=!1,Un=he.drag,Rn=Un.x,Pn=Un.y;me&&(he.x&&(xh=Ci(AT,p)),he.y&&(vh=Ci(CT,p)),I.ori==0?(kr=xh,zr=vh):(kr=vh,zr=xh),Vt=he.left,Jt=he.top);let Ht=i.select=bn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Gr=Ht.show?Ci(TT,Ht.over?p:d):null;function al(y,w){if(Ht.show){for(let P in y)Ht[P]=y[P],P in Mh&&Yt(Gr,P,y[P]);w!==!1&&In("setSelect")}}i.setSelect=al;function Rv(y){if(x[y].show)ee&&ip(Xe[y],Ir);else if(ee&&di(Xe[y],Ir),me){let P=Ce?st[0]:st[y];P!=null&&os(P,-10,-10,B,Re)}}function Ds(y,w,P){_h(y,{min:w,max:P})}function Yi(y,w,P,F){w.focus!=null&&Nv(y),w.show!=null&&x.forEach((X,K)=>{K>0&&(y==K||y==null)&&(X.show=w.show,Rv(K),s==2?(Ds(X.facets[0].scale,null,null),Ds(X.facets[1].scale,null,null)):Ds(X.scale,null,null),Vn())}),P!==!1&&In("setSeries",y,w),F&&jo("setSeries",i,y,w)}i.setSeries=Yi;function Pv(y,w){bn(C[y],w)}function Iv(y,w){y.fill=gt(y.fill||null),y.dir=St(y.dir,-1),w=w??C.length,C.splice(w,0,y)}function Lv(y){y==null?C.length=0:C.splice(y,1)}i.addBand=Iv,i.setBand=Pv,i.delBand=Lv;function Dv(y,w){x[y].alpha=w,me&&st[y]!=null&&(st[y].style.opacity=w),ee&&Xe[y]&&(Xe[y].style.opacity=w)}let hs,Ns,or,Wr={focus:!0};function Nv(y){if(y!=or){let w=y==null,P=Be.alpha!=1;x.forEach((F,X)=>{if(s==1||X>0){let K=w||X==0||X==y;F._focus=w?null:K,P&&Dv(X,K?1:Be.alpha)}}),or=y,P&&Vn()}}ee&&Ke&&vt(W_,Se,y=>{he._lock||(Je(y),or!=null&&Yi(null,Wr,!0,mn.setSeries))});function Zi(y,w,P){let F=b[w];P&&(y=y/Et-(F.ori==1?it:$e));let X=B;F.ori==1&&(X=Re,y=X-y),F.dir==-1&&(y=X-y);let K=F._min,ae=F._max,de=y/X,be=K+(ae-K)*de,De=F.distr;return De==3?Bo(10,be):De==4?XT(be,F.asinh):De==100?F.bwd(be):be}function Fv(y,w){let P=Zi(y,A,w);return Gi(P,e[0],an,ln)}i.valToIdx=y=>Gi(y,e[0]),i.posToIdx=Fv,i.posToVal=Zi,i.valToPos=(y,w,P)=>b[w].ori==0?r(y,b[w],P?q:B,P?R:0):o(y,b[w],P?ue:Re,P?S:0),i.setCursor=(y,w,P)=>{Vt=y.left,Jt=y.top,ar(null,w,P)};function Np(y,w){Yt(Gr,Fo,Ht.left=y),Yt(Gr,ja,Ht.width=w)}function Fp(y,w){Yt(Gr,"top",Ht.top=y),Yt(Gr,Qa,Ht.height=w)}let Zo=I.ori==0?Np:Fp,Jo=I.ori==1?Np:Fp;function Uv(){if(ee&&fe.live)for(let y=s==2?1:0;y<x.length;y++){if(y==0&&ot)continue;let w=fe.values[y],P=0;for(let F in w)Ne[y][P++].firstChild.nodeValue=w[F]}}function yh(y,w){if(y!=null&&(y.idxs?y.idxs.forEach((P,F)=>{ie[F]=P}):ZT(y.idx)||ie.fill(y.idx),fe.idx=ie[0]),ee&&fe.live){for(let P=0;P<x.length;P++)(P>0||s==1&&!ot)&&Ov(P,ie[P]);Uv()}pe=!1,w!==!1&&In("setLegend")}i.setLegend=yh;function Ov(y,w){let P=x[y],F=y==0&&k==2?ni:e[y],X;ot?X=P.values(i,y,w)??tt:(X=P.value(i,w==null?null:F[w],y,w),X=X==null?tt:{_:X}),fe.values[y]=X}function ar(y,w,P){Lp=Vt,Dp=Jt,[Vt,Jt]=he.move(i,Vt,Jt),he.left=Vt,he.top=Jt,me&&(kr&&os(kr,Tn(Vt),0,B,Re),zr&&os(zr,0,Tn(Jt),B,Re));let F,X=an>ln;hs=Ot,Ns=null;let K=I.ori==0?B:Re,ae=I.ori==1?B:Re;if(Vt<0||en==0||X){F=he.idx=null;for(let de=0;de<x.length;de++){let be=st[de];be!=null&&os(be,-10,-10,B,Re)}Ke&&Yi(null,Wr,!0,y==null&&mn.setSeries),fe.live&&(ie.fill(F),pe=!0)}else{let de,be,De;s==1&&(de=I.ori==0?Vt:Jt,be=Zi(de,A),F=he.idx=Gi(be,e[0],an,ln),De=z(e[0][F],I,K,0));let Fe=-10,Oe=-10,nt=0,wt=0,bt=!0,ft="",Ze="";for(let We=s==2?1:0;We<x.length;We++){let Gt=x[We],nn=ie[We],Ln=nn==null?null:s==1?e[We][nn]:e[We][1][nn],Ft=he.dataIdx(i,We,F,be),sn=Ft==null?null:s==1?e[We][Ft]:e[We][1][Ft];if(pe=pe||sn!=Ln||Ft!=nn,ie[We]=Ft,We>0&&Gt.show){let ii=Ft==null?-10:Ft==F?De:z(s==1?e[0][Ft]:e[We][0][Ft],I,K,0),$n=sn==null?-10:N(sn,s==1?b[Gt.scale]:b[Gt.facets[1].scale],ae,0);if(Ke&&sn!=null){let gi=I.ori==1?Vt:Jt,Ii=An(Be.dist(i,We,Ft,$n,gi));if(Ii<hs){let Ji=Be.bias;if(Ji!=0){let si=Zi(gi,Gt.scale),_i=sn>=0?1:-1,Li=si>=0?1:-1;Li==_i&&(Li==1?Ji==1?sn>=si:sn<=si:Ji==1?sn<=si:sn>=si)&&(hs=Ii,Ns=We)}else hs=Ii,Ns=We}}if(pe||Ce){let gi,Ii;I.ori==0?(gi=ii,Ii=$n):(gi=$n,Ii=ii);let Ji,si,_i,Li,Ki,Yn,ri=!0,lr=ce.bbox;if(lr!=null){ri=!1;let Zn=lr(i,We);_i=Zn.left,Li=Zn.top,Ji=Zn.width,si=Zn.height}else _i=gi,Li=Ii,Ji=si=ce.size(i,We);if(Yn=ce.fill(i,We),Ki=ce.stroke(i,We),Ce)We==Ns&&hs<=Be.prox&&(Fe=_i,Oe=Li,nt=Ji,wt=si,bt=ri,ft=Yn,Ze=Ki);else{let Zn=st[We];Zn!=null&&(zt[We]=_i,Xn[We]=Li,K_(Zn,Ji,si,ri),Z_(Zn,Yn,Ki),os(Zn,Ri(_i),Ri(Li),B,Re))}}}}if(Ce){let We=Be.prox,Gt=or==null?hs<=We:hs>We||Ns!=or;if(pe||Gt){let nn=st[0];nn!=null&&(zt[0]=Fe,Xn[0]=Oe,K_(nn,nt,wt,bt),Z_(nn,ft,Ze),os(nn,Ri(Fe),Ri(Oe),B,Re))}}}if(Ht.show&&Ls)if(y!=null){let[de,be]=mn.scales,[De,Fe]=mn.match,[Oe,nt]=y.cursor.sync.scales,wt=y.cursor.drag;if(Rn=wt._x,Pn=wt._y,Rn||Pn){let{left:bt,top:ft,width:Ze,height:We}=y.select,Gt=y.scales[Oe].ori,nn=y.posToVal,Ln,Ft,sn,ii,$n,gi=de!=null&&De(de,Oe),Ii=be!=null&&Fe(be,nt);gi&&Rn?(Gt==0?(Ln=bt,Ft=Ze):(Ln=ft,Ft=We),sn=b[de],ii=z(nn(Ln,Oe),sn,K,0),$n=z(nn(Ln+Ft,Oe),sn,K,0),Zo(Wi(ii,$n),An($n-ii))):Zo(0,K),Ii&&Pn?(Gt==1?(Ln=bt,Ft=Ze):(Ln=ft,Ft=We),sn=b[be],ii=N(nn(Ln,nt),sn,ae,0),$n=N(nn(Ln+Ft,nt),sn,ae,0),Jo(Wi(ii,$n),An($n-ii))):Jo(0,ae)}else Sh()}else{let de=An(Lp-Pp),be=An(Dp-Ip);if(I.ori==1){let nt=de;de=be,be=nt}Rn=Un.x&&de>=Un.dist,Pn=Un.y&&be>=Un.dist;let De=Un.uni;De!=null?Rn&&Pn&&(Rn=de>=De,Pn=be>=De,!Rn&&!Pn&&(be>de?Pn=!0:Rn=!0)):Un.x&&Un.y&&(Rn||Pn)&&(Rn=Pn=!0);let Fe,Oe;Rn&&(I.ori==0?(Fe=Vr,Oe=Vt):(Fe=Hr,Oe=Jt),Zo(Wi(Fe,Oe),An(Oe-Fe)),Pn||Jo(0,ae)),Pn&&(I.ori==1?(Fe=Vr,Oe=Vt):(Fe=Hr,Oe=Jt),Jo(Wi(Fe,Oe),An(Oe-Fe)),Rn||Zo(0,K)),!Rn&&!Pn&&(Zo(0,0),Jo(0,0))}if(Un._x=Rn,Un._y=Pn,y==null){if(P){if(qp!=null){let[de,be]=mn.scales;mn.values[0]=de!=null?Zi(I.ori==0?Vt:Jt,de):null,mn.values[1]=be!=null?Zi(I.ori==1?Vt:Jt,be):null}jo(Zd,i,Vt,Jt,B,Re,F)}if(Ke){let de=P&&mn.setSeries,be=Be.prox;or==null?hs<=be&&Yi(Ns,Wr,!0,de):hs>be?Yi(null,Wr,!0,de):Ns!=or&&Yi(Ns,Wr,!0,de)}}pe&&(fe.idx=F,yh()),w!==!1&&In("setCursor")}let Fs=null;Object.defineProperty(i,"rect",{get(){return Fs==null&&Ko(!1),Fs}});function Ko(y=!1){y?Fs=null:(Fs=p.getBoundingClientRect(),In("syncRect",Fs))}function Up(y,w,P,F,X,K,ae){he._lock||Ls&&y!=null&&y.movementX==0&&y.movementY==0||(bh(y,w,P,F,X,K,ae,!1,y!=null),y!=null?ar(null,!0,!0):ar(w,!0,!1))}function bh(y,w,P,F,X,K,ae,de,be){if(Fs==null&&Ko(!1),Je(y),y!=null)P=y.clientX-Fs.left,F=y.clientY-Fs.top;else{if(P<0||F<0){Vt=-10,Jt=-10;return}let[De,Fe]=mn.scales,Oe=w.cursor.sync,[nt,wt]=Oe.values,[bt,ft]=Oe.scales,[Ze,We]=mn.match,Gt=w.axes[0].side%2==1,nn=I.ori==0?B:Re,Ln=I.ori==1?B:Re,Ft=Gt?K:X,sn=Gt?X:K,ii=Gt?F:P,$n=Gt?P:F;if(bt!=null?P=Ze(De,bt)?a(nt,b[De],nn,0):-10:P=nn*(ii/Ft),ft!=null?F=We(Fe,ft)?a(wt,b[Fe],Ln,0):-10:F=Ln*($n/sn),I.ori==1){let gi=P;P=F,F=gi}}be&&(w==null||w.cursor.event.type==Zd)&&((P<=1||P>=B-1)&&(P=Rr(P,B)),(F<=1||F>=Re-1)&&(F=Rr(F,Re))),de?(Pp=P,Ip=F,[Vr,Hr]=he.move(i,P,F)):(Vt=P,Jt=F)}let Mh={width:0,height:0,left:0,top:0};function Sh(){al(Mh,!1)}let Op,Bp,kp,zp;function Vp(y,w,P,F,X,K,ae){Ls=!0,Rn=Pn=Un._x=Un._y=!1,bh(y,w,P,F,X,K,ae,!0,!1),y!=null&&(vt(Jd,tp,Hp,!1),jo(H_,i,Vr,Hr,B,Re,null));let{left:de,top:be,width:De,height:Fe}=Ht;Op=de,Bp=be,kp=De,zp=Fe}function Hp(y,w,P,F,X,K,ae){Ls=Un._x=Un._y=!1,bh(y,w,P,F,X,K,ae,!1,!0);let{left:de,top:be,width:De,height:Fe}=Ht,Oe=De>0||Fe>0,nt=Op!=de||Bp!=be||kp!=De||zp!=Fe;if(Oe&&nt&&al(Ht),Un.setScale&&Oe&&nt){let wt=de,bt=De,ft=be,Ze=Fe;if(I.ori==1&&(wt=be,bt=Fe,ft=de,Ze=De),Rn&&Ds(A,Zi(wt,A),Zi(wt+bt,A)),Pn)for(let We in b){let Gt=b[We];We!=A&&Gt.from==null&&Gt.min!=Ot&&Ds(We,Zi(ft+Ze,We),Zi(ft,We))}Sh()}else he.lock&&(he._lock=!he._lock,ar(w,!0,y!=null));y!=null&&(Mn(Jd,tp),jo(Jd,i,Vt,Jt,B,Re,null))}function Bv(y,w,P,F,X,K,ae){if(he._lock)return;Je(y);let de=Ls;if(Ls){let be=!0,De=!0,Fe=10,Oe,nt;I.ori==0?(Oe=Rn,nt=Pn):(Oe=Pn,nt=Rn),Oe&&nt&&(be=Vt<=Fe||Vt>=B-Fe,De=Jt<=Fe||Jt>=Re-Fe),Oe&&be&&(Vt=Vt<Vr?0:B),nt&&De&&(Jt=Jt<Hr?0:Re),ar(null,!0,!0),Ls=!1}Vt=-10,Jt=-10,ie.fill(null),ar(null,!0,!0),de&&(Ls=de)}function Gp(y,w,P,F,X,K,ae){he._lock||(Je(y),Yo(),Sh(),y!=null&&jo(X_,i,Vt,Jt,B,Re,null))}function Wp(){M.forEach(hC),O(i.width,i.height,!0)}Lr(rh,Oo,Wp);let Xr={};Xr.mousedown=Vp,Xr.mousemove=Up,Xr.mouseup=Hp,Xr.dblclick=Gp,Xr.setSeries=(y,w,P,F)=>{let X=mn.match[2];P=X(i,w,P),P!=-1&&Yi(P,F,!0,!1)},me&&(vt(H_,p,Vp),vt(Zd,p,Up),vt(G_,p,y=>{Je(y),Ko(!1)}),vt(W_,p,Bv),vt(X_,p,Gp),cp.add(i),i.syncRect=Ko);let ll=i.hooks=n.hooks||{};function In(y,w,P){qn?Pt.push([y,w,P]):y in ll&&ll[y].forEach(F=>{F.call(null,i,w,P)})}(n.plugins||[]).forEach(y=>{for(let w in y.hooks)ll[w]=(ll[w]||[]).concat(y.hooks[w])});let Xp=(y,w,P)=>P,mn=bn({key:null,setSeries:!1,filters:{pub:nx,sub:nx},scales:[A,x[1]?x[1].scale:null],match:[ix,ix,Xp],values:[null,null]},he.sync);mn.match.length==2&&mn.match.push(Xp),he.sync=mn;let qp=mn.key,wh=Qx(qp);function jo(y,w,P,F,X,K,ae){mn.filters.pub(y,w,P,F,X,K,ae)&&wh.pub(y,w,P,F,X,K,ae)}wh.sub(i);function kv(y,w,P,F,X,K,ae){mn.filters.sub(y,w,P,F,X,K,ae)&&Xr[y](null,w,P,F,X,K,ae)}i.pub=kv;function zv(){wh.unsub(i),cp.delete(i),Cn.clear(),sp(rh,Oo,Wp),c.remove(),Se?.remove(),In("destroy")}i.destroy=zv;function Eh(){In("init",n,e),$o(e||n.data,!1),W[A]?_h(A,W[A]):Yo(),se=Ht.show&&(Ht.width>0||Ht.height>0),te=pe=!0,O(n.width,n.height)}return x.forEach(Fr),M.forEach(as),t?t instanceof HTMLElement?(t.appendChild(c),Eh()):t(i,Eh):Eh(),i}zn.assign=bn;zn.fmtNum=gp;zn.rangeNum=oh;zn.rangeLog=ch;zn.rangeAsinh=pp;zn.orient=Nr;zn.pxRatio=Et;zn.join=nA;zn.fmtDate=xp,zn.tzDate=dA;zn.sync=Qx;{zn.addGap=ZA,zn.clipGaps=fh;let n=zn.paths={points:rv};n.linear=av,n.stepped=jA,n.bars=QA,n.spline=tC}var fC=new Set(["step","time","cycle","roll_angle","position"]);function Ep(n){return n.values.reduce((e,t)=>t!==null&&Number.isFinite(t)?Math.max(e,Math.abs(t)):e,0)}function hv({core:n}){let e=n.source?.outputs?.columns??[],t=e.filter(o=>!fC.has(o.name)&&o.values.some(a=>typeof a=="number"&&Number.isFinite(a))),i=t.find(o=>n.state.plotted.includes(o.name))?.name??t[0]?.name??"",s=t.find(o=>o.name===i),r=e.find(o=>o.name==="time");return D("section",{class:"cv-plots","aria-label":"Plots",children:s?D(Lt,{children:[D("div",{class:"cv-plots-head",children:[D($t,{quiet:!0,label:"Output",value:i,options:t.map(o=>({value:o.name,label:o.name.replaceAll("_"," ")})),onChange:o=>n.update({plotted:[o]})}),D(dC,{core:n,column:s,time:r})]}),D(pC,{core:n,column:s,time:r})]}):D("div",{class:"cv-muted",children:"This run has no outputs over the positions."})})}function fv(n,e){let t=n.positions?.list[n.state.position];if(!t||!e)return n.state.position;let i=0;return e.values.forEach((s,r)=>{Math.abs((s??1/0)-t.time)<Math.abs((e.values[i]??1/0)-t.time)&&(i=r)}),i}function dC({core:n,column:e,time:t}){let i=e.values[fv(n,t)]??NaN,s=xn(e.unit,Ep(e));return D("output",{class:"cv-muted",children:Number.isFinite(i)?`${Dt(i*s.factor,5)} ${s.symbol}`:"no value"})}function pC({core:n,column:e,time:t}){let i=Ai(null),s=Ai(null),r=fv(n,t),{theme:o}=n.theme;return Ti(()=>{let a=i.current,l=getComputedStyle(n.element),c=m=>l.getPropertyValue(m).trim(),u=xn(e.unit,Ep(e)),f=xn("s",t?Ep(t):0),h=t?t.values.map(m=>(m??NaN)*f.factor):e.values.map((m,x)=>x),d=e.values.map(m=>m===null||!Number.isFinite(m)?null:m*u.factor),p=m=>({label:m,labelSize:18,size:44,font:"11px system-ui, sans-serif",labelFont:"11px system-ui, sans-serif",stroke:c("--cv-muted"),grid:{stroke:c("--cv-line"),width:1},ticks:{stroke:c("--cv-line"),width:1,size:4}}),_=new zn({width:a.clientWidth,height:a.clientHeight,scales:{x:{time:!1}},legend:{show:!1},cursor:{y:!1,points:{size:7},drag:{x:!1,y:!1}},series:[{},{stroke:c("--cv-accent"),width:1.75,points:{show:h.length<60}}],axes:[{...p(t?`time in ${f.symbol}`:"position"),size:30},{...p(u.symbol),size:56}],hooks:{drawAxes:[m=>mC(m,c("--cv-mark"))]}},[h,d],a);s.current=_,_.over.addEventListener("click",()=>{let m=_.cursor.idx,x=n.positions?.list??[];if(m==null||x.length===0)return;let M=t?t.values[m]??0:m,b=0;x.forEach((C,A)=>{let v=E=>Math.abs((t?x[E].time:E)-M);v(A)<v(b)&&(b=A)}),n.animation.stop(),n.goTo(b)});let g=new ResizeObserver(()=>_.setSize({width:a.clientWidth,height:a.clientHeight}));return g.observe(a),()=>{g.disconnect(),_.destroy(),s.current=null}},[n,e,t,o]),Ti(()=>{dv.set(s.current,r),s.current?.redraw(!1)},[r,e,t,o]),D("div",{class:"cv-plot",ref:i,role:"img","aria-label":`${e.name.replaceAll("_"," ")} over ${t?"time":"positions"}`})}var dv=new WeakMap;function mC(n,e){let t=dv.get(n),i=t===void 0?void 0:n.data[0][t];if(i===void 0)return;let s=Math.round(n.valToPos(i,"x",!0))+.5,{ctx:r,bbox:o}=n;r.save(),r.strokeStyle=e,r.lineWidth=1.5*(window.devicePixelRatio||1),r.beginPath(),r.moveTo(s,o.top),r.lineTo(s,o.top+o.height),r.stroke(),r.restore()}var Ap=[{value:"all",label:"All cells"},{value:"flanks",label:"Flanks only"},{value:"edges",label:"Edges only"}];function pv({core:n}){return D("aside",{class:"cv-panel cv-settings","aria-label":"Settings",children:D("div",{class:"cv-scroll",children:[n.state.colours.field!=="plain"?D(gC,{core:n}):null,n.hasMeshes?D(_C,{core:n}):null,D(vC,{core:n}),D(yC,{core:n}),D(No,{title:"Display",children:[D(rs,{label:"Mesh edges",value:n.state.mesh_edges,onChange:e=>n.update({mesh_edges:e})}),D($t,{label:"Theme",value:n.state.theme,options:[{value:"system",label:"As the system"},{value:"light",label:"Light"},{value:"dark",label:"Dark"}],onChange:e=>n.update({theme:e})})]})]})})}function gC({core:n}){let{colours:e}=n.state,t=$a(n),[i,s]=n.display?.limits??[0,1],r=1e-9*Math.max(Math.abs(i),Math.abs(s)),o=[Math.abs(i)<r?0:i,Math.abs(s)<r?0:s],a=(l,c)=>n.update({colours:{limits:"fixed",min:l,max:c}});return D(No,{title:"Colours",children:[D($t,{label:"Limits",value:e.limits,options:[{value:"position",label:"This position"},{value:"all",label:"All positions"},{value:"fixed",label:"Fixed"}],onChange:l=>l==="fixed"?a(o[0],o[1]):n.update({colours:{limits:l}})}),D(Ja,{label:"Maximum",unit:t.symbol,value:o[1]*t.factor,onChange:l=>a(o[0],l/t.factor)}),D(Ja,{label:"Minimum",unit:t.symbol,value:o[0]*t.factor,onChange:l=>a(l/t.factor,o[1])}),D($t,{label:"Scale",value:e.scale,options:i0.map(({name:l,label:c})=>({value:l,label:c})),onChange:l=>n.update({colours:{scale:l}})}),D($t,{label:"Bands",value:String(e.bands),options:["0","6","8","10","12","16","24"].map(l=>({value:l,label:l==="0"?"Continuous":l})),onChange:l=>n.update({colours:{bands:Number(l)}})}),Fn(e.field)?null:D($t,{label:"Contact cells",value:e.cells,options:Ap,onChange:l=>n.update({colours:{cells:l}})}),wo[e.field]?D("p",{class:"cv-note",children:wo[e.field]}):null,D(rs,{label:"Mark the extreme values",value:n.state.extremes,onChange:l=>n.update({extremes:l})}),Fn(e.field)?null:D(rs,{label:"Show contacts behind surfaces",value:n.state.hidden_contacts,onChange:l=>n.update({hidden_contacts:l})})]})}function _C({core:n}){let{mode:e}=n.state.deformation,t=({index:o})=>(n.display.meshes[o]?.length??0)>0,i=n.parts?.parts??[],[s,r]=[i.filter(t),i.filter(o=>!t(o))];return D(No,{title:"Deformation",children:[D(rs,{label:"Automatic factor",value:e==="automatic",onChange:o=>n.update({deformation:{mode:o?"automatic":"factor",factor:n.display.factor}})}),D(Ja,{label:"Factor",unit:"×",value:n.display.factor,onChange:o=>n.update({deformation:{mode:"factor",factor:o}})}),e==="automatic"&&!Fn(n.state.colours.field)?D("p",{class:"cv-note",children:du}):null,r.length>0&&n.display.factor>0?D("p",{class:"cv-note",title:r.map(({name:o})=>o).join(", "),children:["Parts with meshes move: ",xC(s),". The other parts stay in place."]}):null]})}var Tp=5;function xC(n){let e=n.slice(0,Tp).map(({name:t})=>t).join(", ");return n.length>Tp?`${e} and ${n.length-Tp} more`:e}function vC({core:n}){let{cut:e}=n.state,t=n.display.cut,i=()=>{let o=n.scene.camera.direction;return[o.x,o.y,o.z]},s=xn("m",1),r=typeof e.normal=="string"?e.normal:"view";return D(No,{title:"Cutting plane",children:[D(rs,{label:"Cut",value:e.on,onChange:o=>Po(n,{on:o})}),e.on?D(Lt,{children:[D($t,{label:"Normal",value:r,options:[{value:"x",label:"x"},{value:"y",label:"y"},{value:"z",label:"z"},{value:"view",label:"View direction"}],onChange:o=>Po(n,{normal:o==="view"?i():o})}),D($d,{label:"Location",min:t.range[0],max:t.range[1],value:t.offset,text:`${Dt(t.offset*s.factor,4)} ${s.symbol}`,onInput:o=>{n.display.setDragging(!0,n.state),n.update({cut:{offset:o}})},onEnd:()=>n.display.setDragging(!1,n.state)}),D(Ja,{label:"Coordinate",unit:s.symbol,value:t.offset*s.factor,onChange:o=>n.update({cut:{offset:o/s.factor}})}),D(rs,{label:"Flip",value:e.flipped,onChange:o=>n.update({cut:{flipped:o}})})]}):null]})}function yC({core:n}){let{forces:e}=n.state,t=e.bearings||e.meshes;return D(No,{title:"Forces",children:[D(rs,{label:"At bearings",value:e.bearings,onChange:i=>n.update({forces:{bearings:i}})}),D(rs,{label:"At meshes",value:e.meshes,onChange:i=>n.update({forces:{meshes:i}})}),t?D(Lt,{children:[D(rs,{label:"Labels",value:e.labels,onChange:i=>n.update({forces:{labels:i}})}),D($d,{label:"Length",min:.2,max:4,value:e.scale,onInput:i=>n.update({forces:{scale:i}})})]}):null]})}var bC="Positions count from 0, like the column step of steps.csv",MC=[1,2,5,10,20,30,60];function mv({core:n}){let e=n.positions?.list??[],{state:t,animation:i}=n;if(e.length===0)return D("div",{class:"cv-timeline cv-muted",children:"No positions yet"});let s=e[Math.min(t.position,e.length-1)],r=e[e.length-1],o=xn("s",Math.max(Math.abs(r.time),Math.abs(e[0].time))),a=`${Dt(s.time*o.factor)} ${o.symbol}`,l=e.length>1;return D("div",{class:"cv-timeline",role:"group","aria-label":"Animation",children:[D(yn,{icon:"previous",label:"Previous position",shortcut:",",disabled:!l,onClick:()=>i.step(-1)}),D(yn,{icon:i.playing?"pause":"play",label:i.playing?"Pause":"Play",shortcut:"K",disabled:!l,onClick:()=>i.toggle()}),D(yn,{icon:"next",label:"Next position",shortcut:".",disabled:!l,onClick:()=>i.step(1)}),D("input",{class:"cv-time",type:"range",min:0,max:e.length-1,step:1,value:t.position,disabled:!l,"aria-label":"Position","aria-valuetext":`position ${s.position}, ${a}`,onInput:c=>{i.stop(),n.goTo(Number(c.currentTarget.value))}}),D("output",{class:"cv-clock",children:[D("span",{title:bC,children:[n.narrow?"":"Position ",s.position,l?D("span",{class:"cv-muted",children:[" (",e[0].position," to ",r.position,")"]}):null]}),D("span",{class:"cv-clock-time",children:a})]}),n.narrow?null:D(Cp,{core:n})]})}function Cp({core:n}){let{state:e}=n;return D(Lt,{children:[D($t,{quiet:!0,label:"Speed, positions per second",value:String(e.animation.speed),options:[...new Set([...MC,e.animation.speed])].sort((t,i)=>t-i).map(t=>({value:String(t),label:`${t} / s`})),onChange:t=>n.update({animation:{speed:Number(t)}})}),D(yn,{icon:"loop",label:"Loop",pressed:e.animation.loop,onClick:()=>n.update({animation:{loop:!e.animation.loop}})})]})}var SC=[{value:"",label:"View"},{value:"isometric",label:"Isometric"},{value:"front",label:"Front"},{value:"back",label:"Back"},{value:"left",label:"Left"},{value:"right",label:"Right"},{value:"top",label:"Top"},{value:"bottom",label:"Bottom"}],wC=Object.keys(Vi);function _v({core:n,showTitle:e,showTheme:t}){let{scene:i,status:s,narrow:r}=n,o=s==="ready"&&i!==null;return D("div",{class:"cv-toolbar",role:"toolbar","aria-label":"View",children:[D(yn,{icon:"parts",label:"Parts",shortcut:"B",pressed:n.isOpen("parts"),onClick:()=>n.toggle("parts")}),e&&!r?D("h1",{class:"cv-title",title:n.source?.title,children:n.source?.title??"Calyx"}):null,o&&!r?D(Lt,{children:[D("span",{class:"cv-rule"}),D(vv,{core:n}),D("span",{class:"cv-rule"}),D(gv,{core:n}),D(yv,{core:n}),D("span",{class:"cv-rule"}),D(bv,{core:n})]}):null,o&&r?D("span",{class:"cv-grow",children:D(gv,{core:n})}):D("span",{class:"cv-space"}),D("span",{class:"cv-tool-group",children:[o&&!r?D(Mv,{core:n}):null,o?D(yn,{icon:"settings",label:"Settings",shortcut:"S",pressed:n.isOpen("settings"),onClick:()=>n.toggle("settings")}):null,r?D(yn,{icon:"more",label:"More tools",pressed:n.drawer==="tools",onClick:()=>n.setDrawer(n.drawer==="tools"?null:"tools")}):D(Sv,{core:n,showTheme:t})]})]})}function xv({core:n,showTheme:e}){let t=n.status==="ready"&&n.scene!==null;return D("div",{class:"cv-tools",role:"group","aria-label":"More tools",children:[t?D(Lt,{children:[D(vv,{core:n}),D(bv,{core:n}),D(yv,{core:n}),D(Mv,{core:n}),D(Cp,{core:n})]}):null,D(Sv,{core:n,showTheme:e})]})}function vv({core:n}){let{camera:e}=n.scene,t=n.state.camera?.projection==="orthographic";return D(Lt,{children:[D(yn,{icon:"fit",label:"Fit",shortcut:"F",onClick:()=>e.fit()}),D($t,{quiet:!0,label:"Standard view",value:"",options:SC,onChange:i=>{i&&e.view(i),n.changed(!1)}}),D(yn,{icon:t?"orthographic":"perspective",label:"Orthographic projection",shortcut:"P",pressed:t,onClick:()=>e.setProjection(t?"perspective":"orthographic")})]})}function gv({core:n}){let{colours:e}=n.state;return D($t,{quiet:!0,label:"Colours",value:e.field,options:wC.map(t=>({value:t,label:Vi[t].label})),onChange:t=>n.update({colours:{field:t,limits:e.limits==="fixed"?"position":e.limits}})})}function yv({core:n}){let{colours:e}=n.state;return D(Lt,{children:[e.field==="contact_pressure"?D($t,{quiet:!0,label:"Contact cells",value:e.cells,options:Ap,onChange:t=>n.update({colours:{cells:t}})}):null,n.hasMeshes?D(EC,{core:n}):null]})}function bv({core:n}){let{state:e}=n,t=e.forces.bearings||e.forces.meshes;return D(Lt,{children:[D(yn,{icon:"mesh",label:"Mesh edges",shortcut:"M",pressed:e.mesh_edges,onClick:()=>n.update({mesh_edges:!e.mesh_edges})}),D(yn,{icon:"force",label:"Force vectors",shortcut:"V",pressed:t,onClick:()=>n.update({forces:{bearings:!t,meshes:!t}})}),D(yn,{icon:"cut",label:"Cutting plane",shortcut:"C",pressed:e.cut.on,onClick:()=>{let i=!e.cut.on;Po(n,{on:i}),i&&!n.drawers&&n.toggle("settings",!0)}})]})}function Mv({core:n}){let{panels:e}=n.state;return D(Lt,{children:[D(yn,{icon:"plot",label:"Plots",shortcut:"G",pressed:e.plots,onClick:()=>n.update({panels:{plots:!e.plots}})}),D(yn,{icon:"pattern",label:"Contact pattern",shortcut:"U",pressed:e.pattern,onClick:()=>n.update({panels:{pattern:!e.pattern}})}),D(TC,{core:n})]})}function Sv({core:n,showTheme:e}){let t=n.theme.theme==="dark";return D(Lt,{children:[e?D(yn,{icon:t?"sun":"moon",label:t?"Light theme":"Dark theme",onClick:()=>n.update({theme:t?"light":"dark"})}):null,D(yn,{icon:"help",label:"Help",shortcut:"?",pressed:n.help,onClick:()=>{n.help=!n.help,n.changed(!1)}})]})}function EC({core:n}){let{mode:e,factor:t}=n.state.deformation,i=e==="automatic"&&!Fn(n.state.colours.field),s=e==="automatic"?"automatic":t===0||t===1?String(t):"other";return D(Lt,{children:[D($t,{quiet:!0,label:"Deformation",title:i?du:void 0,value:s,options:[{value:"automatic",label:i?"No deformation here":"Deformation: automatic"},{value:"0",label:"Undeformed"},{value:"1",label:"True deformation"},{value:"other",label:"Other factor …"}],onChange:r=>{r==="automatic"?n.update({deformation:{mode:"automatic"}}):r==="other"?(n.update({deformation:{mode:"factor",factor:n.display.factor||10}}),n.toggle("settings",!0)):n.update({deformation:{mode:"factor",factor:Number(r)}})}}),i?null:D("output",{class:"cv-factor","aria-label":"Factor of the deformation",title:"Factor of the displayed deformation",children:["× ",Dt(n.display.factor,3)]})]})}function TC({core:n}){let[e,t]=ss("");return D("span",{class:"cv-export",children:D($t,{quiet:!0,label:e?`Export. ${e}`:"Export the picture",value:"",options:[{value:"",label:"Export"},{value:"png",label:"PNG"},{value:"svg",label:"SVG"},{value:"pdf",label:"PDF"}],onChange:i=>{i&&m_(n,i).catch(s=>t(String(s))),n.changed(!1)}})})}function wv({core:n}){let{probe:e,scene:t}=n;if(!e||!t)return null;let i=$a(n),s=xn("m",1),{x:r,y:o,z:a}=e.point,l=e.value!==null&&Number.isFinite(e.value);return D("div",{class:"cv-tooltip",role:"status","aria-label":"Value at the pointer","data-value":e.value===null?"":String(e.value),style:eh(e.x,e.y,t.width,t.height),children:[e.value!==null?D("div",{class:"cv-tooltip-value",children:[D("span",{class:"cv-muted",children:Vi[n.state.colours.field].label}),D("strong",{children:l?`${Dt(e.value*i.factor,6)} ${i.symbol}`:"no value"})]}):null,D("div",{children:[e.part,e.tooth!==null?`, tooth ${e.tooth}`:"",e.node!==null?`, node ${e.node}`:""]}),D("div",{class:"cv-muted",children:[[r,o,a].map(c=>Dt(Math.round(c*s.factor*1e3)/1e3,6)).join("  ")," ",s.symbol]})]})}var Ev=[{name:"x",azimuth:0,elevation:0,v:[1,0,0]},{name:"y",azimuth:90,elevation:0,v:[0,1,0]},{name:"z",azimuth:-90,elevation:90,v:[0,0,1]}];function Tv({core:n}){let e=Ai(null);return Ti(()=>AC(n,e.current)),D("svg",{class:"cv-triad",viewBox:"-34 -34 68 68",ref:e,"aria-hidden":"true",children:Ev.map(({name:t})=>D("g",{class:`cv-axis-${t}`,children:[D("line",{}),D("text",{"text-anchor":"middle","dominant-baseline":"central",children:t})]},t))})}function AC(n,e){let t=n.state.camera??n.scene?.camera.state;if(!t)return;let i=t.azimuth*Math.PI/180,s=t.elevation*Math.PI/180,r=[-Math.sin(i),Math.cos(i),0],o=[-Math.sin(s)*Math.cos(i),-Math.sin(s)*Math.sin(i),Math.cos(s)];Ev.forEach(({v:a},l)=>{let c=a[0]*r[0]+a[1]*r[1]+a[2]*r[2],u=-(a[0]*o[0]+a[1]*o[1]+a[2]*o[2]),f=e.children[l],[h,d]=[f.children[0],f.children[1]];h.setAttribute("x2",String(20*c)),h.setAttribute("y2",String(20*u)),d.setAttribute("x",String(28*c)),d.setAttribute("y",String(28*u)),f.setAttribute("opacity",Math.hypot(c,u)<.12?"0.15":"1")})}function Av({core:n,stage:e,showTitle:t,showTheme:i}){P_(n);let{status:s,state:r}=n,o=s==="ready";return D(Lt,{children:[D(_v,{core:n,showTitle:t,showTheme:i}),D("div",{class:"cv-body",children:[o&&n.isOpen("parts")?D(F_,{core:n}):null,D("div",{class:"cv-centre",children:[D("div",{class:"cv-view",children:[D(CC,{stage:e}),o?D(Tv,{core:n}):null,o?D(D_,{core:n}):null,o?D(wv,{core:n}):null,n.notice?D("div",{class:"cv-notice",role:"alert",children:n.notice}):null,s==="loading"?D("div",{class:"cv-message",role:"status",children:"Reading the shapes …"}):null,o&&n.parts?.parts.length===0?D("div",{class:"cv-message",children:"This run has no parts to display."}):null,s==="failed"?D("div",{class:"cv-message",role:"alert",children:[D("strong",{children:"The view cannot be displayed."}),D("span",{children:n.failure})]}):null]}),o&&r.panels.pattern?D(B_,{core:n}):null,o&&r.panels.plots?D(hv,{core:n}):null,o?D(mv,{core:n}):null]}),o&&n.isOpen("settings")?D(pv,{core:n}):null,n.narrow&&n.drawer==="tools"?D(xv,{core:n,showTheme:i}):null]}),n.help?D(I_,{core:n}):null]})}function CC({stage:n}){let e=Ai(null);return Ti(()=>{e.current.append(n)},[n]),D("div",{class:"cv-holder",ref:e})}var sl=class{onChange=null;#e;#t;#n=new AbortController;#i=new Set;constructor(e,t={}){let i=document.createElement("div");i.className="calyx-viewer";let s=document.createElement("div");s.className="cv-stage",e.append(i),this.#t=i;let r=new Gu(i,s,t.state??{});if(this.#e=r,r.onChange=a=>this.onChange?.(a),Dh(D(Av,{core:r,stage:s,showTitle:t.showTitle??!0,showTheme:t.showTheme??!0}),i),r.scene){let{canvas:a,camera:l}=r.scene;a.tabIndex=0,a.setAttribute("role","img"),a.setAttribute("aria-label","Three-dimensional view. Arrow keys orbit, plus and minus zoom, question mark shows all shortcuts."),n_(r,a);let c=l.onChange;l.onChange=u=>{if(c?.(u),u)for(let f of this.#i)f.#e.scene?.camera.set(l.state)}}let o=a=>{r_(r,a)&&a.preventDefault()};i.addEventListener("keydown",o),t.pageKeys&&document.addEventListener("keydown",a=>a.target===document.body&&o(a),{signal:this.#n.signal})}fail(e){this.#e.fail(new Error(e))}show(e){return this.#e.show(e)}reload(){return this.#e.reload()}updatePositions(){return this.#e.updatePositions()}get state(){return structuredClone(this.#e.state)}restore(e){this.#e.update(e)}linkCamera(e){this.#i.add(e),e.#i.add(this);let{camera:t}=this.#e.state;return t&&e.#e.scene?.camera.set(t),()=>{this.#i.delete(e),e.#i.delete(this)}}image(e){return Od(this.#e,e)}patternImage(e){return zd(this.#e,e)}get frames(){return this.#e.scene?.frames??0}get triangles(){return this.#e.display?.triangles??0}draw(){this.#e.scene?.draw()}project(e,t){return this.#e.project(e,t)}nodalValue(e,t){return this.#e.nodalValue(e,t)}contactLoads(){let e=this.#e.display?.position?.contacts,t=this.#e.parts?.parts.map(({name:i})=>i)??[];return e?[...e0(e)].map(([i,s])=>{let[r,o]=i.split(" ").map(Number);return{parts:[t[r]??"",t[o]??""],load:s}}):[]}dispose(){for(let e of this.#i)e.#i.delete(this);this.#i.clear(),this.#n.abort(),Dh(null,this.#t),this.#e.dispose(),this.#t.remove()}};function Cv(){let n=document.getElementById("calyx-viewer")??document.body,e=new sl(n,{pageKeys:!0});window.calyxViewer=e;let t=document.getElementById("calyx-view"),i;try{i=JSON.parse(t?.textContent??"")}catch{e.fail("The data embedded in this page are missing or damaged.");return}i.title&&(document.title=i.title),e.show(Rd(i))}document.readyState==="loading"?document.addEventListener("DOMContentLoaded",Cv):Cv();})();
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
