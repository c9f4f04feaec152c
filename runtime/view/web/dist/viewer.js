"use strict";(()=>{var Ct,kd,H_,Ps,ku,Ya,zd,Ga,Vd,Vu,zu,G_,Uo=Symbol.for("pv"),$a={},Za=[],W_=/^m(i|n|o|s|text|space)$/,Hu=Array.isArray,Hd=Za.slice,js=Object.assign;function Ks(i){i&&i.parentNode&&i.remove()}function Wa(i,e,t,n,s){var r={type:i,props:e,key:t,ref:n,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Uo,__v:s||++kd,__i:-1,__u:0};return!s&&Ct.vnode&&Ct.vnode(r),r}function In(i){return i.children}function Xa(i,e){this.props=i,this.context=e,this.__g=0}function Is(i,e){if(e==null)return i.__&&Is(i.__,i.__i+1);for(var t;e<i.__k.length;e++)if((t=i.__k[e])&&t.__e)return t.__e;return typeof i.type!="function"||i.props.__P?null:Is(i)}function X_(i){var e,t=i.__v,n=t.__e,s=[],r=[],o=i.__P;o&&((e=js({constructor:Uo},t)).__v=t.__v+1,Ct.vnode&&Ct.vnode(e),Gu(o,e,t,i.__n,o.namespaceURI,32&t.__u?[n]:null,s,n||Is(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,$d(s,e,r),t.__=t.__e=null,e.__e!=n&&Gd(e))}function Gd(i){if((i=i.__)&&i.__c&&!i.props.__P)return i.__e=null,i.__k.some(function(e){return e&&(i.__e=e.__e)}),Gd(i)}function Od(i){(8&i.__g||(i.__g|=8,Ps.push(i),Ya++))&&ku==Ct.debounceRendering||((ku=Ct.debounceRendering)||queueMicrotask)(Wd)}function Wd(){try{for(var i,e=1;Ps.length;)Ps.length>e&&Ps.sort(zd),i=Ps.shift(),e=Ps.length,8&i.__g&&X_(i)}finally{(Ya=Ps.length)&&(ku||queueMicrotask)(Wd)}}function Xd(i,e,t,n,s,r,o,a,c,l,u){var d,f,h,m,y,g,p=n.__k||Za,v=e.length;for(c=q_(t,e,p,c,v),d=0;d<v;d++)(h=t.__k[d])!=null&&(f=~h.__i&&p[h.__i]||$a,h.__i=d,g=Gu(i,h,f,s,r,o,a,c,l,u),m=h.__e,(f.ref!=h.ref||8&f.__u)&&(f.ref&&Wu(f.ref,null,h,f),h.ref&&u.push(h.ref,h.__c||m,h)),y=y||m,4&h.__u?(c=qd(h,c,i,!f.__v),f.__e&&(f.__e=null)):typeof h.type=="function"&&g!==void 0?c=g:m&&(c=m.nextSibling),h.__u&=-21);return t.__e=y,c}function q_(i,e,t,n,s){var r,o,a,c,l,u,d,f,h,m=t.length,y=m,g=0,p=0,v=i.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=v[r]=Wa(null,o):Hu(o)?o=v[r]=Wa(In,{children:o}):o.constructor===Uo&&o.__b?o=v[r]=Wa(o.type,o.props,o.key,o.ref,o.__v):v[r]=o,c=r+g,o.__=i,o.__b=i.__b+1,a=null,~(l=o.__i=Y_(o,t,c,y))&&(y--,(a=t[l])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,l==c-1?g--:l==c+1?g++:l!=c&&(l>c?g--:g++,p=1)):(~l||(s>m?g--:s<m&&g++),typeof o.type!="function"&&(o.__u|=4))):v[r]=null;if(p){for(u=[],d=[],r=0;r<s;r++)if((o=v[r])&&16&o.__u){for(g=0,f=u.length;g<f;)u[h=g+f>>1]<o.__i?g=h+1:f=h;u[g]=o.__i,d[r]=g+1}for(g=u.length;r--;)d[r]&&(d[r]==g?g--:v[r].__u|=4)}if(y)for(r=0;r<m;r++)!(a=t[r])||2&a.__u||(a.__e==n&&(n=Is(a)),Xu(a,a));return n}function qd(i,e,t,n){var s,r,o,a;if(typeof i.type=="function"){if(i.props.__P)return e;if(s=i.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=i,e=qd(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=Is(i))&&!e.parentNode&&(e=null),o=i.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!n&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Y_(i,e,t,n){var s,r=i.key,o=i.type,a=e[t],c=a&&!(2&a.__u);if(a===null&&r==null||c&&r==a.key&&o==a.type)return t;if(n>(c?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function Bd(i,e,t){t==null&&(t=""),e[0]=="-"?i.setProperty(e,t):i[e]=t}function Ha(i,e,t,n,s){var r,o;if(e=="style")if(typeof t=="string")i.style.cssText=t;else{if(typeof n=="string"&&(i.style.cssText=n=""),n)for(e in n)t&&e in t||Bd(i.style,e);if(t)for(e in t)n&&t[e]==n[e]||Bd(i.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof n!="function"&&(n=null),(i.__e||(i.__e={}))[e]=t,t&&n||(o=zu[e]||(zu[e]=$_(e)),(i.__a||(i.__a={}))[e]=Vu,r=e!=(e=e.replace(Vd,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?i.addEventListener(e,o,r):i.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in i)try{return void(i[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?i.removeAttribute(e):i.setAttribute(e,e=="popover"&&t==1?"":t)}}function $_(i){return function(e){var t=this.__e;if(t){if(t=t[i],e[Ga]==null)e[Ga]=Vu++;else if(e[Ga]<this.__a[i])return;return t(Ct.event?Ct.event(e):e)}}}function Gu(i,e,t,n,s,r,o,a,c,l){var u,d,f,h,m,y,g,p,v,A,b,R,T,_,w,F,L,I,O=e.type;if(e.constructor!==Uo)return null;128&t.__u&&(c=32&t.__u,u=t.__c.__z)&&(e.__u|=c,d=r=[],u.nodeType==8?a=qa(u,r):r.push(u),a=r[0]||a),(u=Ct.__b)&&u(e);e:if(typeof O=="function"){f=o.length;try{if(p=e.props,v=(u=O.prototype)&&u.render,A=(u=O.contextType)&&n[u.__c],b=u?A?A.props.value:u.__:n,(h=t.__c)?(e.__c=h,2&h.__g&&(h.__g|=1)):(v?e.__c=h=new O(p,b):(e.__c=h=new Xa(p,b),h.constructor=O,h.render=J_),A&&A.sub(h),h.state||(h.state={}),h.__n=n,h.__g|=8,h.__h=[],h.__k=[]),v&&(h.__s||(h.__s=h.state),O.getDerivedStateFromProps&&(h.__s==h.state&&(h.__s=js({},h.__s)),js(h.__s,O.getDerivedStateFromProps(p,h.__s)))),m=h.props,y=h.state,h.__v=e,t.__c){if(p!==m&&v&&!O.getDerivedStateFromProps&&h.componentWillReceiveProps&&h.componentWillReceiveProps(p,b),e.__v==t.__v&&!(8&h.__g)||!(4&h.__g)&&h.shouldComponentUpdate&&h.shouldComponentUpdate(p,h.__s,b)===!1){e.__v!=t.__v&&(h.props=p,h.state=h.__s,h.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(k){k&&(k.__=e)}),Za.push.apply(h.__h,h.__k),h.__k=[],h.__h.length&&o.push(h),a=Is(t);break e}h.componentWillUpdate&&h.componentWillUpdate(p,h.__s,b),v&&h.componentDidUpdate&&h.__h.push(function(){h.componentDidUpdate(m,y,g)})}else v&&!O.getDerivedStateFromProps&&h.componentWillMount&&h.componentWillMount(),v&&h.componentDidMount&&h.__h.push(h.componentDidMount);h.context=b,h.props=p,h.__P=i,h.__g&=-5,R=Ct.__r,T=v?25:0;do h.__g&=-9,R&&R(e),u=h.render(h.props,h.state=h.__s,h.context);while(8&h.__g&&++T<25);v&&(Za.push.apply(h.__h,h.__k),h.__k=[]),h.state=h.__s,h.getChildContext&&(n=js({},n,h.getChildContext())),v&&t.__c&&h.getSnapshotBeforeUpdate&&(g=h.getSnapshotBeforeUpdate(m,y)),_=u&&u.type===In&&u.key==null?u.props.children:u,p.__P&&(u=a,s=(i=p.__P).namespaceURI,c=r=null,t.props&&t.props.__P!=i&&(t.__k.some(function(k){k&&Xu(k,k)}),t.__k=null),a=t.__k?Is(t,0):null),a=Xd(i,Hu(_)?_:[_],e,t,n,s,r,o,a,c,l),p.__P&&(e.__e=null,a=u),e.__u&=-161,d&&d.some(Ks),h.__h.length&&o.push(h),1&h.__g&&(h.__g&=-4)}catch(k){if(o.length=f,e.__v=null,c||r)if(k&&k.then){if(e.__u|=128|c,r){for(~(L=r.indexOf(a||void 0))||(L=r.length);(I=r[L-1])&&I.nodeType==8;)L--;for(;L<r.length;L++)if(I=r[L])if(r[L]=null,w){if(I==F)break}else{if(I.nodeType!=8)break;I.data.startsWith("$s")&&(F=qa(w=I))}}if(!w){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;w=a}(u=qa(w=e.__c.__z||(e.__c.__z=w)))?(e.__e=w,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(Ks);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),k&&k.then||Yd(e),Ct.__e(k,e,t)}}else a=e.__e=Z_(t.__e,e,t,n,s,r,o,c,l,i);return(u=Ct.diffed)&&u(e),a}function qa(i,e){if(i&&i.nodeType==8&&i.data.startsWith("$s"))for(var t=1;i=i.nextSibling;){if(i.nodeType==8){if(i.data.startsWith("$s"))t++;else if(i.data.startsWith("/$s")&&!--t)return i}e&&e.push(i)}}function Yd(i){i&&(i.__c&&(i.__c.__g|=4),i.__k&&i.__k.some(Yd))}function $d(i,e,t){for(var n=0;n<t.length;)Wu(t[n++],t[n++],t[n++]);Ct.__c&&Ct.__c(e,i),i.some(function(s){try{i=s.__h,s.__h=[],i.some(function(r){r.call(s)})}catch(r){Ct.__e(r,s.__v)}})}function Z_(i,e,t,n,s,r,o,a,c,l){var u,d,f,h,m,y,g,p,v=t.props||$a,A=e.props,b=e.type;if(b=="svg"?s="http://www.w3.org/2000/svg":b=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((m=r[u])&&(b?m.localName==b:m.nodeType==3)){i=m,r[u]=null;break}}if(!i){if(p=l.ownerDocument||document,!b)return p.createTextNode(A);i=p.createElementNS(s,b,A.is?A:l),a&&(Ct.__m&&Ct.__m(e,r),a=!1),r=null}if(b){if(l=b=="template"&&i.content||i,r=b=="textarea"&&A.defaultValue!=null?null:r&&Hd.call(l.childNodes),!a&&r)for(v={},u=0;u<i.attributes.length;u++)v[(m=i.attributes[u]).name]=m.value;for(u in v)m=v[u],u=="dangerouslySetInnerHTML"?f=m:u=="children"||u in A||u=="value"&&"defaultValue"in A||u=="checked"&&"defaultChecked"in A||Ha(i,u,null,m,s);for(u in A)m=A[u],u=="children"?h=m:u=="dangerouslySetInnerHTML"?d=m:u=="value"?y=m:u=="checked"?g=m:a&&typeof m!="function"||v[u]===m||Ha(i,u,m,v[u],s);d?(a||f&&(d.__html==f.__html||d.__html==i.innerHTML)||(i.innerHTML=d.__html),e.__k=[]):(f&&(i.textContent=""),(b=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&W_.test(b))&&(s="http://www.w3.org/1999/xhtml"),Xd(l,Hu(h)?h:[h],e,t,n,s,r,o,r?r[0]:t.__k&&Is(t,0),a,c),r&&r.some(Ks)),a&&b!="textarea"||(u="value",b=="progress"&&y==null?i.removeAttribute(u):y==null||y===i[u]&&(b!="progress"||y)||Ha(i,u,y,v[u],s),u="checked",g!=null&&g!=i[u]&&Ha(i,u,g,v[u],s))}else v===A||a&&i.data==A||(i.data=A);return i}function Wu(i,e,t,n){try{typeof i=="function"?e?e.__x=i(e)||1:n&&(n=n.__c||n.__e)&&(e=n.__x)&&(n.__x=null,typeof e=="function"?e():i(null)):i.current=e}catch(s){Ct.__e(s,t)}}function Xu(i,e,t){var n,s,r,o;if(Ct.unmount&&Ct.unmount(i),!(n=i.ref)||n.current&&n.current!=i.__e||Wu(n,null,e,i),n=i.__c){if(n.componentWillUnmount)try{n.componentWillUnmount()}catch(a){Ct.__e(a,e)}n.__P=n.__n=null}if(n=i.__k)for(o=0;o<n.length;o++)n[o]&&Xu(n[o],e,typeof i.type!="function"||t&&!i.props.__P);!t&&(n=i.__c)&&(n=n.__z)&&(s=qa(n,r=[]))&&(n==i.__e&&r.some(Ks),Ks(s),Ks(n)),t||Ks(i.__e),i.__e=i.__c=i.__=null}function J_(i,e,t){return this.constructor(i,t)}function qu(i,e){var t,n,s,r;Ct.__&&Ct.__(i,e),e.nodeType==9&&(e=e.documentElement),n=(t=i&&32&i.__u)?null:e.__k,e.__k=Wa(In,{children:[i]}),s=[],r=[],Gu(e,e.__k,n||$a,$a,e.namespaceURI,n?null:e.firstChild?Hd.call(e.childNodes):null,s,n?n.__e:e.firstChild,t,r),$d(s,e.__k,r),e.__k.props.children=null}Ct={__e:function(i,e,t,n){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(i)),s.componentDidCatch&&(s.componentDidCatch(i,n||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){i=a}}throw Ya=0,i}},kd=0,H_=function(i){return i!=null&&i.constructor===Uo},Xa.prototype.setState=function(i,e){var t=this.__s;t&&t!=this.state||(t=this.__s=js({},this.state)),typeof i=="function"&&(i=i(js({},t),this.props)),i&&(js(t,i),this.__v&&(e&&this.__k.push(e),Od(this)))},Xa.prototype.forceUpdate=function(i){this.__v&&(this.__g|=4,i&&this.__h.push(i),Od(this))},Xa.prototype.render=In,Ps=[],Ya=0,zd=function(i,e){return i.__v.__b-e.__v.__b},Ga=Symbol(),Vd=/(PointerCapture)$|Capture$/i,Vu=0,zu={},G_=0;var yp=0,bh=1,bp=2;var la=1,Sp=2,io=3,yi=0,Dn=1,Nn=2,rr=0,so=1,Sh=2,Mh=3,wh=4,Mp=5;var or=100,wp=101,Ep=102,Tp=103,Ap=104,Rp=200,Cp=201,Pp=202,Ip=203,Eh=204,Th=205,Lp=206,Dp=207,Np=208,Fp=209,Up=210,Op=211,Bp=212,kp=213,zp=214,yl=0,bl=1,Sl=2,Wr=3,Ml=4,wl=5,Xr=6,El=7,Ah=0,Vp=1,Hp=2,Ki=0,Rh=1,Ch=2,Ph=3,Ih=4,Lh=5,Dh=6,Nh=7;var Fh=300,ar=301,ro=302,Jl=303,Kl=304,Tl=1e3,$i=1001,Al=1002,fn=1003,Gp=1004;var ca=1005;var Ln=1006,jl=1007;var gs=1008;var ci=1009,Uh=1010,Oh=1011,oo=1012,Ql=1013,Pi=1014,Ii=1015,Li=1016,ec=1017,tc=1018,lr=1020,Bh=35902,kh=35899,zh=1021,Vh=1022,ui=1023,ds=1026,_s=1027,Hh=1028,nc=1029,Ws=1030,ic=1031;var sc=1033,ua=33776,ha=33777,fa=33778,da=33779,rc=35840,oc=35841,ac=35842,lc=35843,cc=36196,uc=37492,hc=37496,fc=37488,dc=37489,pa=37490,pc=37491,mc=37808,gc=37809,_c=37810,xc=37811,vc=37812,yc=37813,bc=37814,Sc=37815,Mc=37816,wc=37817,Ec=37818,Tc=37819,Ac=37820,Rc=37821,Cc=36492,Pc=36494,Ic=36495,Lc=36283,Dc=36284,ma=36285,Nc=36286;var Go=2300,Rl=2301,xl=2302,mh=2303,gh=2400,_h=2401,xh=2402;var Wp=3200;var Gh=0,Xp=1,xs="",Yn="srgb",Wo="srgb-linear",Xo="linear",wt="srgb";var vl=7680,ga=7681;var Wh=34055,Xh=34056;var qh=517;var Fc=519,qp=512,Yp=513,$p=514,Yh=515,Zp=516,Jp=517,$h=518,Zh=519,Kp=35044,Jh=35048;var Kh="300 es",_i=2e3,qo=2001;function K_(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function j_(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Yo(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function jp(){let i=Yo("canvas");return i.style.display="block",i}var Zd={},qr=null;function jh(...i){let e="THREE."+i.shift();qr?qr("log",e,...i):console.log(e,...i)}function Qp(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ye(...i){i=Qp(i);let e="THREE."+i.shift();if(qr)qr("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function Qe(...i){i=Qp(i);let e="THREE."+i.shift();if(qr)qr("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Ho(...i){let e=i.join(" ");e in Zd||(Zd[e]=!0,Ye(...i))}function em(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var tm={[yl]:yl,[Sl]:Xr,[Ml]:Ml,[Wr]:wl,[bl]:bl,[Xr]:Sl,[El]:El,[wl]:Wr},Zi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},kn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Yu=Math.PI/180,Cl=180/Math.PI;function _a(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(kn[i&255]+kn[i>>8&255]+kn[i>>16&255]+kn[i>>24&255]+"-"+kn[e&255]+kn[e>>8&255]+"-"+kn[e>>16&15|64]+kn[e>>24&255]+"-"+kn[t&63|128]+kn[t>>8&255]+"-"+kn[t>>16&255]+kn[t>>24&255]+kn[n&255]+kn[n>>8&255]+kn[n>>16&255]+kn[n>>24&255]).toLowerCase()}function gt(i,e,t){return Math.max(e,Math.min(t,i))}function Q_(i,e){return(i%e+e)%e}function $u(i,e,t){return(1-t)*i+t*e}function nm(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Qh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function ex(i,e){if(e.constructor===Float32Array)return i;let t=Qh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function tx(i,e){if(e.constructor===Float32Array)return i;let t=Qh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var _t=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(gt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(gt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},xi=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let c=n[s+0],l=n[s+1],u=n[s+2],d=n[s+3],f=r[o+0],h=r[o+1],m=r[o+2],y=r[o+3];if(d!==y||c!==f||l!==h||u!==m){let g=c*f+l*h+u*m+d*y;g<0&&(f=-f,h=-h,m=-m,y=-y,g=-g);let p=1-a;if(g<.9995){let v=Math.acos(g),A=Math.sin(v);p=Math.sin(p*v)/A,a=Math.sin(a*v)/A,c=c*p+f*a,l=l*p+h*a,u=u*p+m*a,d=d*p+y*a}else{c=c*p+f*a,l=l*p+h*a,u=u*p+m*a,d=d*p+y*a;let v=1/Math.sqrt(c*c+l*l+u*u+d*d);c*=v,l*=v,u*=v,d*=v}}e[t]=c,e[t+1]=l,e[t+2]=u,e[t+3]=d}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],c=n[s+1],l=n[s+2],u=n[s+3],d=r[o],f=r[o+1],h=r[o+2],m=r[o+3];return e[t]=a*m+u*d+c*h-l*f,e[t+1]=c*m+u*f+l*d-a*h,e[t+2]=l*m+u*h+a*f-c*d,e[t+3]=u*m-a*d-c*f-l*h,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,c=Math.sin,l=a(n/2),u=a(s/2),d=a(r/2),f=c(n/2),h=c(s/2),m=c(r/2);switch(o){case"XYZ":this._x=f*u*d+l*h*m,this._y=l*h*d-f*u*m,this._z=l*u*m+f*h*d,this._w=l*u*d-f*h*m;break;case"YXZ":this._x=f*u*d+l*h*m,this._y=l*h*d-f*u*m,this._z=l*u*m-f*h*d,this._w=l*u*d+f*h*m;break;case"ZXY":this._x=f*u*d-l*h*m,this._y=l*h*d+f*u*m,this._z=l*u*m+f*h*d,this._w=l*u*d-f*h*m;break;case"ZYX":this._x=f*u*d-l*h*m,this._y=l*h*d+f*u*m,this._z=l*u*m-f*h*d,this._w=l*u*d+f*h*m;break;case"YZX":this._x=f*u*d+l*h*m,this._y=l*h*d+f*u*m,this._z=l*u*m-f*h*d,this._w=l*u*d-f*h*m;break;case"XZY":this._x=f*u*d-l*h*m,this._y=l*h*d-f*u*m,this._z=l*u*m+f*h*d,this._w=l*u*d+f*h*m;break;default:Ye("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],c=t[9],l=t[2],u=t[6],d=t[10],f=n+a+d;if(f>0){let h=.5/Math.sqrt(f+1);this._w=.25/h,this._x=(u-c)*h,this._y=(r-l)*h,this._z=(o-s)*h}else if(n>a&&n>d){let h=2*Math.sqrt(1+n-a-d);this._w=(u-c)/h,this._x=.25*h,this._y=(s+o)/h,this._z=(r+l)/h}else if(a>d){let h=2*Math.sqrt(1+a-n-d);this._w=(r-l)/h,this._x=(s+o)/h,this._y=.25*h,this._z=(c+u)/h}else{let h=2*Math.sqrt(1+d-n-a);this._w=(o-s)/h,this._x=(r+l)/h,this._y=(c+u)/h,this._z=.25*h}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(gt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,c=t._y,l=t._z,u=t._w;return this._x=n*u+o*a+s*l-r*c,this._y=s*u+o*c+r*a-n*l,this._z=r*u+o*l+n*c-s*a,this._w=o*u-n*a-s*c-r*l,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let c=1-t;if(a<.9995){let l=Math.acos(a),u=Math.sin(l);c=Math.sin(c*l)/u,t=Math.sin(t*l)/u,this._x=this._x*c+n*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+o*t,this._onChangeCallback()}else this._x=this._x*c+n*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},X=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Jd.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Jd.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,c=e.w,l=2*(o*s-a*n),u=2*(a*t-r*s),d=2*(r*n-o*t);return this.x=t+c*l+o*d-a*u,this.y=n+c*u+a*l-r*d,this.z=s+c*d+r*u-o*l,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this.z=gt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this.z=gt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(gt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,c=t.z;return this.x=s*c-r*a,this.y=r*o-n*c,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Zu.copy(this).projectOnVector(e),this.sub(Zu)}reflect(e){return this.sub(Zu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(gt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Zu=new X,Jd=new xi,et=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,c,l)}set(e,t,n,s,r,o,a,c,l){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=c,u[6]=n,u[7]=o,u[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],c=n[6],l=n[1],u=n[4],d=n[7],f=n[2],h=n[5],m=n[8],y=s[0],g=s[3],p=s[6],v=s[1],A=s[4],b=s[7],R=s[2],T=s[5],_=s[8];return r[0]=o*y+a*v+c*R,r[3]=o*g+a*A+c*T,r[6]=o*p+a*b+c*_,r[1]=l*y+u*v+d*R,r[4]=l*g+u*A+d*T,r[7]=l*p+u*b+d*_,r[2]=f*y+h*v+m*R,r[5]=f*g+h*A+m*T,r[8]=f*p+h*b+m*_,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],u=e[8];return t*o*u-t*a*l-n*r*u+n*a*c+s*r*l-s*o*c}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],u=e[8],d=u*o-a*l,f=a*c-u*r,h=l*r-o*c,m=t*d+n*f+s*h;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/m;return e[0]=d*y,e[1]=(s*l-u*n)*y,e[2]=(a*n-s*o)*y,e[3]=f*y,e[4]=(u*t-s*c)*y,e[5]=(s*r-a*t)*y,e[6]=h*y,e[7]=(n*c-l*t)*y,e[8]=(o*t-n*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*o+l*a)+o+e,-s*l,s*c,-s*(-l*o+c*a)+a+t,0,0,1),this}scale(e,t){return Ho("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ju.makeScale(e,t)),this}rotate(e){return Ho("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ju.makeRotation(-e)),this}translate(e,t){return Ho("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ju.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Ju=new et,Kd=new et().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),jd=new et().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function nx(){let i={enabled:!0,workingColorSpace:Wo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===wt&&(s.r=fs(s.r),s.g=fs(s.g),s.b=fs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===wt&&(s.r=Gr(s.r),s.g=Gr(s.g),s.b=Gr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===xs?Xo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Wo]:{primaries:e,whitePoint:n,transfer:Xo,toXYZ:Kd,fromXYZ:jd,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Yn},outputColorSpaceConfig:{drawingBufferColorSpace:Yn}},[Yn]:{primaries:e,whitePoint:n,transfer:wt,toXYZ:Kd,fromXYZ:jd,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Yn}}}),i}var pt=nx();function fs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Gr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Pr,Pl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Pr===void 0&&(Pr=Yo("canvas")),Pr.width=e.width,Pr.height=e.height;let s=Pr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Pr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Yo("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=fs(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(fs(t[n]/255)*255):t[n]=fs(t[n]);return{data:t,width:e.width,height:e.height}}else return Ye("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},ix=0,Yr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:ix++}),this.uuid=_a(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Ku(s[o].image)):r.push(Ku(s[o]))}else r=Ku(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Ku(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Pl.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ye("Texture: Unable to serialize Texture."),{})}var sx=0,ju=new X,Kn=class i extends Zi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=$i,s=$i,r=Ln,o=gs,a=ui,c=ci,l=i.DEFAULT_ANISOTROPY,u=xs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:sx++}),this.uuid=_a(),this.name="",this.source=new Yr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new _t(0,0),this.repeat=new _t(1,1),this.center=new _t(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new et,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ju).x}get height(){return this.source.getSize(ju).y}get depth(){return this.source.getSize(ju).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ye(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Fh)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Tl:e.x=e.x-Math.floor(e.x);break;case $i:e.x=e.x<0?0:1;break;case Al:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Tl:e.y=e.y-Math.floor(e.y);break;case $i:e.y=e.y<0?0:1;break;case Al:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Kn.DEFAULT_IMAGE=null;Kn.DEFAULT_MAPPING=Fh;Kn.DEFAULT_ANISOTROPY=1;var Ht=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,c=e.elements,l=c[0],u=c[4],d=c[8],f=c[1],h=c[5],m=c[9],y=c[2],g=c[6],p=c[10];if(Math.abs(u-f)<.01&&Math.abs(d-y)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+f)<.1&&Math.abs(d+y)<.1&&Math.abs(m+g)<.1&&Math.abs(l+h+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(l+1)/2,b=(h+1)/2,R=(p+1)/2,T=(u+f)/4,_=(d+y)/4,w=(m+g)/4;return A>b&&A>R?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=T/n,r=_/n):b>R?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=T/s,r=w/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=_/r,s=w/r),this.set(n,s,r,t),this}let v=Math.sqrt((g-m)*(g-m)+(d-y)*(d-y)+(f-u)*(f-u));return Math.abs(v)<.001&&(v=1),this.x=(g-m)/v,this.y=(d-y)/v,this.z=(f-u)/v,this.w=Math.acos((l+h+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this.z=gt(this.z,e.z,t.z),this.w=gt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this.z=gt(this.z,e,t),this.w=gt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(gt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Il=class extends Zi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ln,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Ht(0,0,e,t),this.scissorTest=!1,this.viewport=new Ht(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Kn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Ln,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Yr(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},oi=class extends Il{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},$o=class extends Kn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=fn,this.minFilter=fn,this.wrapR=$i,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Ll=class extends Kn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=fn,this.minFilter=fn,this.wrapR=$i,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var vt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,c,l,u,d,f,h,m,y,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,c,l,u,d,f,h,m,y,g)}set(e,t,n,s,r,o,a,c,l,u,d,f,h,m,y,g){let p=this.elements;return p[0]=e,p[4]=t,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=c,p[2]=l,p[6]=u,p[10]=d,p[14]=f,p[3]=h,p[7]=m,p[11]=y,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/Ir.setFromMatrixColumn(e,0).length(),r=1/Ir.setFromMatrixColumn(e,1).length(),o=1/Ir.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),c=Math.cos(s),l=Math.sin(s),u=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let f=o*u,h=o*d,m=a*u,y=a*d;t[0]=c*u,t[4]=-c*d,t[8]=l,t[1]=h+m*l,t[5]=f-y*l,t[9]=-a*c,t[2]=y-f*l,t[6]=m+h*l,t[10]=o*c}else if(e.order==="YXZ"){let f=c*u,h=c*d,m=l*u,y=l*d;t[0]=f+y*a,t[4]=m*a-h,t[8]=o*l,t[1]=o*d,t[5]=o*u,t[9]=-a,t[2]=h*a-m,t[6]=y+f*a,t[10]=o*c}else if(e.order==="ZXY"){let f=c*u,h=c*d,m=l*u,y=l*d;t[0]=f-y*a,t[4]=-o*d,t[8]=m+h*a,t[1]=h+m*a,t[5]=o*u,t[9]=y-f*a,t[2]=-o*l,t[6]=a,t[10]=o*c}else if(e.order==="ZYX"){let f=o*u,h=o*d,m=a*u,y=a*d;t[0]=c*u,t[4]=m*l-h,t[8]=f*l+y,t[1]=c*d,t[5]=y*l+f,t[9]=h*l-m,t[2]=-l,t[6]=a*c,t[10]=o*c}else if(e.order==="YZX"){let f=o*c,h=o*l,m=a*c,y=a*l;t[0]=c*u,t[4]=y-f*d,t[8]=m*d+h,t[1]=d,t[5]=o*u,t[9]=-a*u,t[2]=-l*u,t[6]=h*d+m,t[10]=f-y*d}else if(e.order==="XZY"){let f=o*c,h=o*l,m=a*c,y=a*l;t[0]=c*u,t[4]=-d,t[8]=l*u,t[1]=f*d+y,t[5]=o*u,t[9]=h*d-m,t[2]=m*d-h,t[6]=a*u,t[10]=y*d+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(rx,e,ox)}lookAt(e,t,n){let s=this.elements;return si.subVectors(e,t),si.lengthSq()===0&&(si.z=1),si.normalize(),Ls.crossVectors(n,si),Ls.lengthSq()===0&&(Math.abs(n.z)===1?si.x+=1e-4:si.z+=1e-4,si.normalize(),Ls.crossVectors(n,si)),Ls.normalize(),Ja.crossVectors(si,Ls),s[0]=Ls.x,s[4]=Ja.x,s[8]=si.x,s[1]=Ls.y,s[5]=Ja.y,s[9]=si.y,s[2]=Ls.z,s[6]=Ja.z,s[10]=si.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],c=n[8],l=n[12],u=n[1],d=n[5],f=n[9],h=n[13],m=n[2],y=n[6],g=n[10],p=n[14],v=n[3],A=n[7],b=n[11],R=n[15],T=s[0],_=s[4],w=s[8],F=s[12],L=s[1],I=s[5],O=s[9],k=s[13],D=s[2],G=s[6],Y=s[10],H=s[14],le=s[3],J=s[7],Q=s[11],ie=s[15];return r[0]=o*T+a*L+c*D+l*le,r[4]=o*_+a*I+c*G+l*J,r[8]=o*w+a*O+c*Y+l*Q,r[12]=o*F+a*k+c*H+l*ie,r[1]=u*T+d*L+f*D+h*le,r[5]=u*_+d*I+f*G+h*J,r[9]=u*w+d*O+f*Y+h*Q,r[13]=u*F+d*k+f*H+h*ie,r[2]=m*T+y*L+g*D+p*le,r[6]=m*_+y*I+g*G+p*J,r[10]=m*w+y*O+g*Y+p*Q,r[14]=m*F+y*k+g*H+p*ie,r[3]=v*T+A*L+b*D+R*le,r[7]=v*_+A*I+b*G+R*J,r[11]=v*w+A*O+b*Y+R*Q,r[15]=v*F+A*k+b*H+R*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],c=e[9],l=e[13],u=e[2],d=e[6],f=e[10],h=e[14],m=e[3],y=e[7],g=e[11],p=e[15],v=c*h-l*f,A=a*h-l*d,b=a*f-c*d,R=o*h-l*u,T=o*f-c*u,_=o*d-a*u;return t*(y*v-g*A+p*b)-n*(m*v-g*R+p*T)+s*(m*A-y*R+p*_)-r*(m*b-y*T+g*_)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],c=e[2],l=e[6],u=e[10];return t*(o*u-a*l)-n*(r*u-a*c)+s*(r*l-o*c)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],u=e[8],d=e[9],f=e[10],h=e[11],m=e[12],y=e[13],g=e[14],p=e[15],v=t*a-n*o,A=t*c-s*o,b=t*l-r*o,R=n*c-s*a,T=n*l-r*a,_=s*l-r*c,w=u*y-d*m,F=u*g-f*m,L=u*p-h*m,I=d*g-f*y,O=d*p-h*y,k=f*p-h*g,D=v*k-A*O+b*I+R*L-T*F+_*w;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/D;return e[0]=(a*k-c*O+l*I)*G,e[1]=(s*O-n*k-r*I)*G,e[2]=(y*_-g*T+p*R)*G,e[3]=(f*T-d*_-h*R)*G,e[4]=(c*L-o*k-l*F)*G,e[5]=(t*k-s*L+r*F)*G,e[6]=(g*b-m*_-p*A)*G,e[7]=(u*_-f*b+h*A)*G,e[8]=(o*O-a*L+l*w)*G,e[9]=(n*L-t*O-r*w)*G,e[10]=(m*T-y*b+p*v)*G,e[11]=(d*b-u*T-h*v)*G,e[12]=(a*F-o*I-c*w)*G,e[13]=(t*I-n*F+s*w)*G,e[14]=(y*A-m*R-g*v)*G,e[15]=(u*R-d*A+f*v)*G,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,c=e.z,l=r*o,u=r*a;return this.set(l*o+n,l*a-s*c,l*c+s*a,0,l*a+s*c,u*a+n,u*c-s*o,0,l*c-s*a,u*c+s*o,r*c*c+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,c=t._w,l=r+r,u=o+o,d=a+a,f=r*l,h=r*u,m=r*d,y=o*u,g=o*d,p=a*d,v=c*l,A=c*u,b=c*d,R=n.x,T=n.y,_=n.z;return s[0]=(1-(y+p))*R,s[1]=(h+b)*R,s[2]=(m-A)*R,s[3]=0,s[4]=(h-b)*T,s[5]=(1-(f+p))*T,s[6]=(g+v)*T,s[7]=0,s[8]=(m+A)*_,s[9]=(g-v)*_,s[10]=(1-(f+y))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=Ir.set(s[0],s[1],s[2]).length(),a=Ir.set(s[4],s[5],s[6]).length(),c=Ir.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ti.copy(this);let l=1/o,u=1/a,d=1/c;return Ti.elements[0]*=l,Ti.elements[1]*=l,Ti.elements[2]*=l,Ti.elements[4]*=u,Ti.elements[5]*=u,Ti.elements[6]*=u,Ti.elements[8]*=d,Ti.elements[9]*=d,Ti.elements[10]*=d,t.setFromRotationMatrix(Ti),n.x=o,n.y=a,n.z=c,this}makePerspective(e,t,n,s,r,o,a=_i,c=!1){let l=this.elements,u=2*r/(t-e),d=2*r/(n-s),f=(t+e)/(t-e),h=(n+s)/(n-s),m,y;if(c)m=r/(o-r),y=o*r/(o-r);else if(a===_i)m=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===qo)m=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=f,l[12]=0,l[1]=0,l[5]=d,l[9]=h,l[13]=0,l[2]=0,l[6]=0,l[10]=m,l[14]=y,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=_i,c=!1){let l=this.elements,u=2/(t-e),d=2/(n-s),f=-(t+e)/(t-e),h=-(n+s)/(n-s),m,y;if(c)m=1/(o-r),y=o/(o-r);else if(a===_i)m=-2/(o-r),y=-(o+r)/(o-r);else if(a===qo)m=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=0,l[12]=f,l[1]=0,l[5]=d,l[9]=0,l[13]=h,l[2]=0,l[6]=0,l[10]=m,l[14]=y,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Ir=new X,Ti=new vt,rx=new X(0,0,0),ox=new X(1,1,1),Ls=new X,Ja=new X,si=new X,Qd=new vt,ep=new xi,Bs=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],u=s[9],d=s[2],f=s[6],h=s[10];switch(t){case"XYZ":this._y=Math.asin(gt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,h),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,l),this._z=0);break;case"YXZ":this._x=Math.asin(-gt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,h),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(gt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-d,h),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-gt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(f,h),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(gt(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-u,l),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,h));break;case"XZY":this._z=Math.asin(-gt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,h),this._y=0);break;default:Ye("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Qd.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Qd,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return ep.setFromEuler(this),this.setFromQuaternion(ep,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Bs.DEFAULT_ORDER="XYZ";var Zo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},ax=0,tp=new X,Lr=new xi,as=new vt,Ka=new X,Oo=new X,lx=new X,cx=new xi,np=new X(1,0,0),ip=new X(0,1,0),sp=new X(0,0,1),rp={type:"added"},ux={type:"removed"},Dr={type:"childadded",child:null},Qu={type:"childremoved",child:null},ai=class i extends Zi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:ax++}),this.uuid=_a(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new X,t=new Bs,n=new xi,s=new X(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new vt},normalMatrix:{value:new et}}),this.matrix=new vt,this.matrixWorld=new vt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Zo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Lr.setFromAxisAngle(e,t),this.quaternion.multiply(Lr),this}rotateOnWorldAxis(e,t){return Lr.setFromAxisAngle(e,t),this.quaternion.premultiply(Lr),this}rotateX(e){return this.rotateOnAxis(np,e)}rotateY(e){return this.rotateOnAxis(ip,e)}rotateZ(e){return this.rotateOnAxis(sp,e)}translateOnAxis(e,t){return tp.copy(e).applyQuaternion(this.quaternion),this.position.add(tp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(np,e)}translateY(e){return this.translateOnAxis(ip,e)}translateZ(e){return this.translateOnAxis(sp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(as.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Ka.copy(e):Ka.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Oo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?as.lookAt(Oo,Ka,this.up):as.lookAt(Ka,Oo,this.up),this.quaternion.setFromRotationMatrix(as),s&&(as.extractRotation(s.matrixWorld),Lr.setFromRotationMatrix(as),this.quaternion.premultiply(Lr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Qe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(rp),Dr.child=e,this.dispatchEvent(Dr),Dr.child=null):Qe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(ux),Qu.child=e,this.dispatchEvent(Qu),Qu.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),as.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),as.multiply(e.parent.matrixWorld)),e.applyMatrix4(as),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(rp),Dr.child=e,this.dispatchEvent(Dr),Dr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Oo,e,lx),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Oo,cx,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(e)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,u=c.length;l<u;l++){let d=c[l];r(e.shapes,d)}else r(e.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(e.materials,this.material[c]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(e.animations,c))}}if(t){let a=o(e.geometries),c=o(e.materials),l=o(e.textures),u=o(e.images),d=o(e.shapes),f=o(e.skeletons),h=o(e.animations),m=o(e.nodes);a.length>0&&(n.geometries=a),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),u.length>0&&(n.images=u),d.length>0&&(n.shapes=d),f.length>0&&(n.skeletons=f),h.length>0&&(n.animations=h),m.length>0&&(n.nodes=m)}return n.object=s,n;function o(a){let c=[];for(let l in a){let u=a[l];delete u.metadata,c.push(u)}return c}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};ai.DEFAULT_UP=new X(0,1,0);ai.DEFAULT_MATRIX_AUTO_UPDATE=!0;ai.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var nn=class extends ai{constructor(){super(),this.isGroup=!0,this.type="Group"}},hx={type:"move"},$r=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new nn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new nn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new nn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(l&&e.hand){o=!0;for(let y of e.hand.values()){let g=t.getJointPose(y,n),p=this._getHandJoint(l,y);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let u=l.joints["index-finger-tip"],d=l.joints["thumb-tip"],f=u.position.distanceTo(d.position),h=.02,m=.005;l.inputState.pinching&&f>h+m?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!l.inputState.pinching&&f<=h-m&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else c!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(hx)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new nn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},im={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ds={h:0,s:0,l:0},ja={h:0,s:0,l:0};function eh(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var rt=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Yn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,pt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=pt.workingColorSpace){return this.r=e,this.g=t,this.b=n,pt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=pt.workingColorSpace){if(e=Q_(e,1),t=gt(t,0,1),n=gt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=eh(o,r,e+1/3),this.g=eh(o,r,e),this.b=eh(o,r,e-1/3)}return pt.colorSpaceToWorking(this,s),this}setStyle(e,t=Yn){function n(r){r!==void 0&&parseFloat(r)<1&&Ye("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ye("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ye("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Yn){let n=im[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ye("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=fs(e.r),this.g=fs(e.g),this.b=fs(e.b),this}copyLinearToSRGB(e){return this.r=Gr(e.r),this.g=Gr(e.g),this.b=Gr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Yn){return pt.workingToColorSpace(zn.copy(this),e),Math.round(gt(zn.r*255,0,255))*65536+Math.round(gt(zn.g*255,0,255))*256+Math.round(gt(zn.b*255,0,255))}getHexString(e=Yn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=pt.workingColorSpace){pt.workingToColorSpace(zn.copy(this),t);let n=zn.r,s=zn.g,r=zn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),c,l,u=(a+o)/2;if(a===o)c=0,l=0;else{let d=o-a;switch(l=u<=.5?d/(o+a):d/(2-o-a),o){case n:c=(s-r)/d+(s<r?6:0);break;case s:c=(r-n)/d+2;break;case r:c=(n-s)/d+4;break}c/=6}return e.h=c,e.s=l,e.l=u,e}getRGB(e,t=pt.workingColorSpace){return pt.workingToColorSpace(zn.copy(this),t),e.r=zn.r,e.g=zn.g,e.b=zn.b,e}getStyle(e=Yn){pt.workingToColorSpace(zn.copy(this),e);let t=zn.r,n=zn.g,s=zn.b;return e!==Yn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Ds),this.setHSL(Ds.h+e,Ds.s+t,Ds.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Ds),e.getHSL(ja);let n=$u(Ds.h,ja.h,t),s=$u(Ds.s,ja.s,t),r=$u(Ds.l,ja.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},zn=new rt;rt.NAMES=im;var Jo=class extends ai{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Bs,this.environmentIntensity=1,this.environmentRotation=new Bs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ai=new X,ls=new X,th=new X,cs=new X,Nr=new X,Fr=new X,op=new X,nh=new X,ih=new X,sh=new X,rh=new Ht,oh=new Ht,ah=new Ht,Os=class i{constructor(e=new X,t=new X,n=new X){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Ai.subVectors(e,t),s.cross(Ai);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Ai.subVectors(s,t),ls.subVectors(n,t),th.subVectors(e,t);let o=Ai.dot(Ai),a=Ai.dot(ls),c=Ai.dot(th),l=ls.dot(ls),u=ls.dot(th),d=o*l-a*a;if(d===0)return r.set(0,0,0),null;let f=1/d,h=(l*c-a*u)*f,m=(o*u-a*c)*f;return r.set(1-h-m,m,h)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,cs)===null?!1:cs.x>=0&&cs.y>=0&&cs.x+cs.y<=1}static getInterpolation(e,t,n,s,r,o,a,c){return this.getBarycoord(e,t,n,s,cs)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,cs.x),c.addScaledVector(o,cs.y),c.addScaledVector(a,cs.z),c)}static getInterpolatedAttribute(e,t,n,s,r,o){return rh.setScalar(0),oh.setScalar(0),ah.setScalar(0),rh.fromBufferAttribute(e,t),oh.fromBufferAttribute(e,n),ah.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(rh,r.x),o.addScaledVector(oh,r.y),o.addScaledVector(ah,r.z),o}static isFrontFacing(e,t,n,s){return Ai.subVectors(n,t),ls.subVectors(e,t),Ai.cross(ls).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ai.subVectors(this.c,this.b),ls.subVectors(this.a,this.b),Ai.cross(ls).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Nr.subVectors(s,n),Fr.subVectors(r,n),nh.subVectors(e,n);let c=Nr.dot(nh),l=Fr.dot(nh);if(c<=0&&l<=0)return t.copy(n);ih.subVectors(e,s);let u=Nr.dot(ih),d=Fr.dot(ih);if(u>=0&&d<=u)return t.copy(s);let f=c*d-u*l;if(f<=0&&c>=0&&u<=0&&c-u>0)return o=c/(c-u),t.copy(n).addScaledVector(Nr,o);sh.subVectors(e,r);let h=Nr.dot(sh),m=Fr.dot(sh);if(m>=0&&h<=m)return t.copy(r);let y=h*l-c*m;if(y<=0&&l>=0&&m<=0)return a=l/(l-m),t.copy(n).addScaledVector(Fr,a);let g=u*m-h*d;if(g<=0&&d-u>=0&&h-m>=0)return op.subVectors(r,s),a=(d-u)/(d-u+(h-m)),t.copy(s).addScaledVector(op,a);let p=1/(g+y+f);return o=y*p,a=f*p,t.copy(n).addScaledVector(Nr,o).addScaledVector(Fr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},jn=class{constructor(e=new X(1/0,1/0,1/0),t=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Ri.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Ri.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Ri.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ri):Ri.fromBufferAttribute(r,o),Ri.applyMatrix4(e.matrixWorld),this.expandByPoint(Ri);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Qa.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Qa.copy(n.boundingBox)),Qa.applyMatrix4(e.matrixWorld),this.union(Qa)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ri),Ri.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Bo),el.subVectors(this.max,Bo),Ur.subVectors(e.a,Bo),Or.subVectors(e.b,Bo),Br.subVectors(e.c,Bo),Ns.subVectors(Or,Ur),Fs.subVectors(Br,Or),Qs.subVectors(Ur,Br);let t=[0,-Ns.z,Ns.y,0,-Fs.z,Fs.y,0,-Qs.z,Qs.y,Ns.z,0,-Ns.x,Fs.z,0,-Fs.x,Qs.z,0,-Qs.x,-Ns.y,Ns.x,0,-Fs.y,Fs.x,0,-Qs.y,Qs.x,0];return!lh(t,Ur,Or,Br,el)||(t=[1,0,0,0,1,0,0,0,1],!lh(t,Ur,Or,Br,el))?!1:(tl.crossVectors(Ns,Fs),t=[tl.x,tl.y,tl.z],lh(t,Ur,Or,Br,el))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ri).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ri).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(us[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),us[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),us[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),us[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),us[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),us[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),us[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),us[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(us),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},us=[new X,new X,new X,new X,new X,new X,new X,new X],Ri=new X,Qa=new jn,Ur=new X,Or=new X,Br=new X,Ns=new X,Fs=new X,Qs=new X,Bo=new X,el=new X,tl=new X,er=new X;function lh(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){er.fromArray(i,r);let a=s.x*Math.abs(er.x)+s.y*Math.abs(er.y)+s.z*Math.abs(er.z),c=e.dot(er),l=t.dot(er),u=n.dot(er);if(Math.max(-Math.max(c,l,u),Math.min(c,l,u))>a)return!1}return!0}var hn=new X,nl=new _t,fx=0,qt=class extends Zi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:fx++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Kp,this.updateRanges=[],this.gpuType=Ii,this.version=0,this._normalizationScale=e!==void 0?Qh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)nl.fromBufferAttribute(this,t),nl.applyMatrix3(e),this.setXY(t,nl.x,nl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)hn.fromBufferAttribute(this,t),hn.applyMatrix3(e),this.setXYZ(t,hn.x,hn.y,hn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)hn.fromBufferAttribute(this,t),hn.applyMatrix4(e),this.setXYZ(t,hn.x,hn.y,hn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)hn.fromBufferAttribute(this,t),hn.applyNormalMatrix(e),this.setXYZ(t,hn.x,hn.y,hn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)hn.fromBufferAttribute(this,t),hn.transformDirection(e),this.setXYZ(t,hn.x,hn.y,hn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):ex(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):tx(e,this.array)}};var Ko=class extends qt{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var jo=class extends qt{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Qt=class extends qt{constructor(e,t,n){super(new Float32Array(e),t,n)}},dx=new jn,ko=new X,ch=new X,Zn=class{constructor(e=new X,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):dx.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ko.subVectors(e,this.center);let t=ko.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(ko,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(ch.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ko.copy(e.center).add(ch)),this.expandByPoint(ko.copy(e.center).sub(ch))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},px=0,gi=new vt,uh=new ai,kr=new X,ri=new jn,zo=new jn,An=new X,Rn=class i extends Zi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:px++}),this.uuid=_a(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(K_(e)?jo:Ko)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new et().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return gi.makeRotationFromQuaternion(e),this.applyMatrix4(gi),this}rotateX(e){return gi.makeRotationX(e),this.applyMatrix4(gi),this}rotateY(e){return gi.makeRotationY(e),this.applyMatrix4(gi),this}rotateZ(e){return gi.makeRotationZ(e),this.applyMatrix4(gi),this}translate(e,t,n){return gi.makeTranslation(e,t,n),this.applyMatrix4(gi),this}scale(e,t,n){return gi.makeScale(e,t,n),this.applyMatrix4(gi),this}lookAt(e){return uh.lookAt(e),uh.updateMatrix(),this.applyMatrix4(uh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(kr).negate(),this.translate(kr.x,kr.y,kr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Qt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ye("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new jn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];ri.setFromBufferAttribute(r),this.morphTargetsRelative?(An.addVectors(this.boundingBox.min,ri.min),this.boundingBox.expandByPoint(An),An.addVectors(this.boundingBox.max,ri.max),this.boundingBox.expandByPoint(An)):(this.boundingBox.expandByPoint(ri.min),this.boundingBox.expandByPoint(ri.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Zn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(e){let n=this.boundingSphere.center;if(ri.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];zo.setFromBufferAttribute(a),this.morphTargetsRelative?(An.addVectors(ri.min,zo.min),ri.expandByPoint(An),An.addVectors(ri.max,zo.max),ri.expandByPoint(An)):(ri.expandByPoint(zo.min),ri.expandByPoint(zo.max))}ri.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)An.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(An));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],c=this.morphTargetsRelative;for(let l=0,u=a.count;l<u;l++)An.fromBufferAttribute(a,l),c&&(kr.fromBufferAttribute(e,l),An.add(kr)),s=Math.max(s,n.distanceToSquared(An))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Qe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new qt(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(n.count);for(let F=0;F<n.count;F++)a[F]=new X,c[F]=new X;let u=new X,d=new X,f=new X,h=new _t,m=new _t,y=new _t,g=new X,p=new X;function v(F,L,I){l[F]=l[L]=l[I]=1,u.fromBufferAttribute(n,F),d.fromBufferAttribute(n,L),f.fromBufferAttribute(n,I),h.fromBufferAttribute(r,F),m.fromBufferAttribute(r,L),y.fromBufferAttribute(r,I),d.sub(u),f.sub(u),m.sub(h),y.sub(h);let O=1/(m.x*y.y-y.x*m.y);isFinite(O)&&(g.copy(d).multiplyScalar(y.y).addScaledVector(f,-m.y).multiplyScalar(O),p.copy(f).multiplyScalar(m.x).addScaledVector(d,-y.x).multiplyScalar(O),a[F].add(g),a[L].add(g),a[I].add(g),c[F].add(p),c[L].add(p),c[I].add(p))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let F=0,L=A.length;F<L;++F){let I=A[F],O=I.start,k=I.count;for(let D=O,G=O+k;D<G;D+=3)v(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let b=new X,R=new X,T=new X,_=new X;function w(F){T.fromBufferAttribute(s,F),_.copy(T);let L=a[F];b.copy(L),b.sub(T.multiplyScalar(T.dot(L))).normalize(),R.crossVectors(_,L);let O=R.dot(c[F])<0?-1:1;o.setXYZW(F,b.x,b.y,b.z,O)}for(let F=0,L=n.count;F<L;++F)l[F]&&w(F);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new qt(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let f=0,h=n.count;f<h;f++)n.setXYZ(f,0,0,0);let s=new X,r=new X,o=new X,a=new X,c=new X,l=new X,u=new X,d=new X;if(e)for(let f=0,h=e.count;f<h;f+=3){let m=e.getX(f+0),y=e.getX(f+1),g=e.getX(f+2);s.fromBufferAttribute(t,m),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,g),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),a.fromBufferAttribute(n,m),c.fromBufferAttribute(n,y),l.fromBufferAttribute(n,g),a.add(u),c.add(u),l.add(u),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(y,c.x,c.y,c.z),n.setXYZ(g,l.x,l.y,l.z)}else for(let f=0,h=t.count;f<h;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)An.fromBufferAttribute(e,t),An.normalize(),e.setXYZ(t,An.x,An.y,An.z)}toNonIndexed(){function e(a,c){let l=a.array,u=a.itemSize,d=a.normalized,f=new l.constructor(c.length*u),h=0,m=0;for(let y=0,g=c.length;y<g;y++){a.isInterleavedBufferAttribute?h=c[y]*a.data.stride+a.offset:h=c[y]*u;for(let p=0;p<u;p++)f[m++]=l[h++]}return new qt(f,u,d)}if(this.index===null)return Ye("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=e(c,n);t.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let u=0,d=l.length;u<d;u++){let f=l[u],h=e(f,n);c.push(h)}t.morphAttributes[a]=c}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];t.addGroup(l.start,l.count,l.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(e[l]=c[l]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let c in n){let l=n[c];e.data.attributes[c]=l.toJSON(e.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],u=[];for(let d=0,f=l.length;d<f;d++){let h=l[d];u.push(h.toJSON(e.data))}u.length>0&&(s[c]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let l in s){let u=s[l];this.setAttribute(l,u.clone(t))}let r=e.morphAttributes;for(let l in r){let u=[],d=r[l];for(let f=0,h=d.length;f<h;f++)u.push(d[f].clone(t));this.morphAttributes[l]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let l=0,u=o.length;l<u;l++){let d=o[l];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=e.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var hh=new X,mx=new X,gx=new et,Ci=class{constructor(e=new X(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=hh.subVectors(n,t).cross(mx.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(hh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||gx.getNormalMatrix(e),s=this.coplanarPoint(hh).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},_x=0,ks=class extends Zi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:_x++}),this.uuid=_a(),this.name="",this.type="Material",this.blending=so,this.side=yi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Eh,this.blendDst=Th,this.blendEquation=or,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new rt(0,0,0),this.blendAlpha=0,this.depthFunc=Wr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Fc,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=vl,this.stencilZFail=vl,this.stencilZPass=vl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ye(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new rt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Ci().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new _t().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new _t().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var hs=new X,fh=new X,il=new X,sl=new X,Ji=class{constructor(e=new X,t=new X(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,hs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=hs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(hs.copy(this.origin).addScaledVector(this.direction,t),hs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){fh.copy(e).add(t).multiplyScalar(.5),il.copy(t).sub(e).normalize(),sl.copy(this.origin).sub(fh);let r=e.distanceTo(t)*.5,o=-this.direction.dot(il),a=sl.dot(this.direction),c=-sl.dot(il),l=sl.lengthSq(),u=Math.abs(1-o*o),d,f,h,m;if(u>0)if(d=o*c-a,f=o*a-c,m=r*u,d>=0)if(f>=-m)if(f<=m){let y=1/u;d*=y,f*=y,h=d*(d+o*f+2*a)+f*(o*d+f+2*c)+l}else f=r,d=Math.max(0,-(o*f+a)),h=-d*d+f*(f+2*c)+l;else f=-r,d=Math.max(0,-(o*f+a)),h=-d*d+f*(f+2*c)+l;else f<=-m?(d=Math.max(0,-(-o*r+a)),f=d>0?-r:Math.min(Math.max(-r,-c),r),h=-d*d+f*(f+2*c)+l):f<=m?(d=0,f=Math.min(Math.max(-r,-c),r),h=f*(f+2*c)+l):(d=Math.max(0,-(o*r+a)),f=d>0?r:Math.min(Math.max(-r,-c),r),h=-d*d+f*(f+2*c)+l);else f=o>0?-r:r,d=Math.max(0,-(o*f+a)),h=-d*d+f*(f+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(fh).addScaledVector(il,f),h}intersectSphere(e,t){if(e.radius<0)return null;hs.subVectors(e.center,this.origin);let n=hs.dot(this.direction),s=hs.dot(hs)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,c=n+o;return c<0?null:a<0?this.at(c,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,c,l=1/this.direction.x,u=1/this.direction.y,d=1/this.direction.z,f=this.origin;return l>=0?(n=(e.min.x-f.x)*l,s=(e.max.x-f.x)*l):(n=(e.max.x-f.x)*l,s=(e.min.x-f.x)*l),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(e.min.z-f.z)*d,c=(e.max.z-f.z)*d):(a=(e.max.z-f.z)*d,c=(e.min.z-f.z)*d),n>c||a>s)||((a>n||n!==n)&&(n=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,hs)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,u=a.z,d=e.x-o.x,f=e.y-o.y,h=e.z-o.z,m=t.x-o.x,y=t.y-o.y,g=t.z-o.z,p=n.x-o.x,v=n.y-o.y,A=n.z-o.z,b=Math.abs(c),R=Math.abs(l),T=Math.abs(u),_,w,F,L,I,O,k,D,G,Y,H,le;if(b>=R&&b>=T?(F=c,O=d,G=m,le=p,c>=0?(_=l,w=u,L=f,I=h,k=y,D=g,Y=v,H=A):(_=u,w=l,L=h,I=f,k=g,D=y,Y=A,H=v)):R>=T?(F=l,O=f,G=y,le=v,l>=0?(_=u,w=c,L=h,I=d,k=g,D=m,Y=A,H=p):(_=c,w=u,L=d,I=h,k=m,D=g,Y=p,H=A)):(F=u,O=h,G=g,le=A,u>=0?(_=c,w=l,L=d,I=f,k=m,D=y,Y=p,H=v):(_=l,w=c,L=f,I=d,k=y,D=m,Y=v,H=p)),F===0)return null;let J=_/F,Q=w/F,ie=1/F,fe=L-J*O,he=I-Q*O,ee=k-J*G,me=D-Q*G,ge=Y-J*le,Me=H-Q*le,ve=ge*me-Me*ee,He=fe*Me-he*ge,Ze=ee*he-me*fe;if(s){if(ve<0||He<0||Ze<0)return null}else if((ve<0||He<0||Ze<0)&&(ve>0||He>0||Ze>0))return null;let Oe=ve+He+Ze;if(Oe===0)return null;let ct=ie*(ve*O+He*G+Ze*le);return(Oe>0?ct<0:ct>0)?null:this.at(ct/Oe,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},zs=class extends ks{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new rt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Bs,this.combine=Ah,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},ap=new vt,tr=new Ji,rl=new Zn,lp=new X,ol=new X,al=new X,ll=new X,dh=new X,cl=new X,cp=new X,ul=new X,Ut=class extends ai{constructor(e=new Rn,t=new zs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){cl.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let u=a[c],d=r[c];u!==0&&(dh.fromBufferAttribute(d,e),o?cl.addScaledVector(dh,u):cl.addScaledVector(dh.sub(t),u))}t.add(cl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),rl.copy(n.boundingSphere),rl.applyMatrix4(r),tr.copy(e.ray).recast(e.near),!(rl.containsPoint(tr.origin)===!1&&(tr.intersectSphere(rl,lp)===null||tr.origin.distanceToSquared(lp)>(e.far-e.near)**2))&&(ap.copy(r).invert(),tr.copy(e.ray).applyMatrix4(ap),!(n.boundingBox!==null&&tr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,tr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,u=r.attributes.uv1,d=r.attributes.normal,f=r.groups,h=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,y=f.length;m<y;m++){let g=f[m],p=o[g.materialIndex],v=Math.max(g.start,h.start),A=Math.min(a.count,Math.min(g.start+g.count,h.start+h.count));for(let b=v,R=A;b<R;b+=3){let T=a.getX(b),_=a.getX(b+1),w=a.getX(b+2);s=hl(this,p,e,n,l,u,d,T,_,w),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let m=Math.max(0,h.start),y=Math.min(a.count,h.start+h.count);for(let g=m,p=y;g<p;g+=3){let v=a.getX(g),A=a.getX(g+1),b=a.getX(g+2);s=hl(this,o,e,n,l,u,d,v,A,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let m=0,y=f.length;m<y;m++){let g=f[m],p=o[g.materialIndex],v=Math.max(g.start,h.start),A=Math.min(c.count,Math.min(g.start+g.count,h.start+h.count));for(let b=v,R=A;b<R;b+=3){let T=b,_=b+1,w=b+2;s=hl(this,p,e,n,l,u,d,T,_,w),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let m=Math.max(0,h.start),y=Math.min(c.count,h.start+h.count);for(let g=m,p=y;g<p;g+=3){let v=g,A=g+1,b=g+2;s=hl(this,o,e,n,l,u,d,v,A,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function xx(i,e,t,n,s,r,o,a){let c;if(e.side===Dn?c=n.intersectTriangle(o,r,s,!0,a):c=n.intersectTriangle(s,r,o,e.side===yi,a),c===null)return null;ul.copy(a),ul.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(ul);return l<t.near||l>t.far?null:{distance:l,point:ul.clone(),object:i}}function hl(i,e,t,n,s,r,o,a,c,l){i.getVertexPosition(a,ol),i.getVertexPosition(c,al),i.getVertexPosition(l,ll);let u=xx(i,e,t,n,ol,al,ll,cp);if(u){let d=new X;Os.getBarycoord(cp,ol,al,ll,d),s&&(u.uv=Os.getInterpolatedAttribute(s,a,c,l,d,new _t)),r&&(u.uv1=Os.getInterpolatedAttribute(r,a,c,l,d,new _t)),o&&(u.normal=Os.getInterpolatedAttribute(o,a,c,l,d,new X),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:c,c:l,normal:new X,materialIndex:0};Os.getNormal(ol,al,ll,f.normal),u.face=f,u.barycoord=d}return u}var Zr=class extends Kn{constructor(e=null,t=1,n=1,s,r,o,a,c,l=fn,u=fn,d,f){super(null,o,a,c,l,u,s,r,d,f),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Qo=class extends qt{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var nr=new Zn,vx=new _t(.5,.5),fl=new X,ps=class{constructor(e=new Ci,t=new Ci,n=new Ci,s=new Ci,r=new Ci,o=new Ci){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=_i,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],c=r[2],l=r[3],u=r[4],d=r[5],f=r[6],h=r[7],m=r[8],y=r[9],g=r[10],p=r[11],v=r[12],A=r[13],b=r[14],R=r[15];if(s[0].setComponents(l-o,h-u,p-m,R-v).normalize(),s[1].setComponents(l+o,h+u,p+m,R+v).normalize(),s[2].setComponents(l+a,h+d,p+y,R+A).normalize(),s[3].setComponents(l-a,h-d,p-y,R-A).normalize(),n)s[4].setComponents(c,f,g,b).normalize(),s[5].setComponents(l-c,h-f,p-g,R-b).normalize();else if(s[4].setComponents(l-c,h-f,p-g,R-b).normalize(),t===_i)s[5].setComponents(l+c,h+f,p+g,R+b).normalize();else if(t===qo)s[5].setComponents(c,f,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),nr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),nr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(nr)}intersectsSprite(e){nr.center.set(0,0,0);let t=vx.distanceTo(e.center);return nr.radius=.7071067811865476+t,nr.applyMatrix4(e.matrixWorld),this.intersectsSphere(nr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(fl.x=s.normal.x>0?e.max.x:e.min.x,fl.y=s.normal.y>0?e.max.y:e.min.y,fl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(fl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},up=new vt,Dl=class i{constructor(){this.coordinateSystem=_i,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];up.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new ps),n[s].setFromProjectionMatrix(up,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new ps),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Jr=class extends ks{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new rt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Nl=new X,Fl=new X,hp=new vt,Vo=new Ji,dl=new Zn,ph=new X,fp=new X,ea=class extends ai{constructor(e=new Rn,t=new Jr){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Nl.fromBufferAttribute(t,s-1),Fl.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Nl.distanceTo(Fl);e.setAttribute("lineDistance",new Qt(n,1))}else Ye("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),dl.copy(n.boundingSphere),dl.applyMatrix4(s),dl.radius+=r,e.ray.intersectsSphere(dl)===!1)return;hp.copy(s).invert(),Vo.copy(e.ray).applyMatrix4(hp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){let h=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let y=h,g=m-1;y<g;y+=l){let p=u.getX(y),v=u.getX(y+1),A=pl(this,e,Vo,c,p,v,y);A&&t.push(A)}if(this.isLineLoop){let y=u.getX(m-1),g=u.getX(h),p=pl(this,e,Vo,c,y,g,m-1);p&&t.push(p)}}else{let h=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let y=h,g=m-1;y<g;y+=l){let p=pl(this,e,Vo,c,y,y+1,y);p&&t.push(p)}if(this.isLineLoop){let y=pl(this,e,Vo,c,m-1,h,m-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function pl(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Nl.fromBufferAttribute(a,s),Fl.fromBufferAttribute(a,r),t.distanceSqToSegment(Nl,Fl,ph,fp)>n)return;ph.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(ph);if(!(l<e.near||l>e.far))return{distance:l,point:fp.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var dp=new X,pp=new X,Kr=class extends ea{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)dp.fromBufferAttribute(t,s),pp.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+dp.distanceTo(pp);e.setAttribute("lineDistance",new Qt(n,1))}else Ye("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},ta=class extends ea{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}};var na=class extends Kn{constructor(e=[],t=ar,n,s,r,o,a,c,l,u){super(e,t,n,s,r,o,a,c,l,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var ms=class extends Kn{constructor(e,t,n=Pi,s,r,o,a=fn,c=fn,l,u=ds,d=1){if(u!==ds&&u!==_s)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:d};super(f,s,r,o,a,c,u,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Yr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},ia=class extends ms{constructor(e,t=Pi,n=ar,s,r,o=fn,a=fn,c,l=ds){let u={width:e,height:e,depth:1},d=[u,u,u,u,u,u];super(e,e,t,n,s,r,o,a,c,l),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},sa=class extends Kn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},jr=class i extends Rn{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],u=[],d=[],f=0,h=0;m("z","y","x",-1,-1,n,t,e,o,r,0),m("z","y","x",1,-1,n,t,-e,o,r,1),m("x","z","y",1,1,e,n,t,s,o,2),m("x","z","y",1,-1,e,n,-t,s,o,3),m("x","y","z",1,-1,e,t,n,s,r,4),m("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new Qt(l,3)),this.setAttribute("normal",new Qt(u,3)),this.setAttribute("uv",new Qt(d,2));function m(y,g,p,v,A,b,R,T,_,w,F){let L=b/_,I=R/w,O=b/2,k=R/2,D=T/2,G=_+1,Y=w+1,H=0,le=0,J=new X;for(let Q=0;Q<Y;Q++){let ie=Q*I-k;for(let fe=0;fe<G;fe++){let he=fe*L-O;J[y]=he*v,J[g]=ie*A,J[p]=D,l.push(J.x,J.y,J.z),J[y]=0,J[g]=0,J[p]=T>0?1:-1,u.push(J.x,J.y,J.z),d.push(fe/_),d.push(1-Q/w),H+=1}}for(let Q=0;Q<w;Q++)for(let ie=0;ie<_;ie++){let fe=f+ie+G*Q,he=f+ie+G*(Q+1),ee=f+(ie+1)+G*(Q+1),me=f+(ie+1)+G*Q;c.push(fe,he,me),c.push(he,ee,me),le+=6}a.addGroup(h,le,F),h+=le,f+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Qr=class i extends Rn{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let u=[],d=[],f=[],h=[],m=0,y=[],g=n/2,p=0;v(),o===!1&&(e>0&&A(!0),t>0&&A(!1)),this.setIndex(u),this.setAttribute("position",new Qt(d,3)),this.setAttribute("normal",new Qt(f,3)),this.setAttribute("uv",new Qt(h,2));function v(){let b=new X,R=new X,T=0,_=(t-e)/n;for(let w=0;w<=r;w++){let F=[],L=w/r,I=L*(t-e)+e;for(let O=0;O<=s;O++){let k=O/s,D=k*c+a,G=Math.sin(D),Y=Math.cos(D);R.x=I*G,R.y=-L*n+g,R.z=I*Y,d.push(R.x,R.y,R.z),b.set(G,_,Y).normalize(),f.push(b.x,b.y,b.z),h.push(k,1-L),F.push(m++)}y.push(F)}for(let w=0;w<s;w++)for(let F=0;F<r;F++){let L=y[F][w],I=y[F+1][w],O=y[F+1][w+1],k=y[F][w+1];(e>0||F!==0)&&(u.push(L,I,k),T+=3),(t>0||F!==r-1)&&(u.push(I,O,k),T+=3)}l.addGroup(p,T,0),p+=T}function A(b){let R=m,T=new _t,_=new X,w=0,F=b===!0?e:t,L=b===!0?1:-1;for(let O=1;O<=s;O++)d.push(0,g*L,0),f.push(0,L,0),h.push(.5,.5),m++;let I=m;for(let O=0;O<=s;O++){let D=O/s*c+a,G=Math.cos(D),Y=Math.sin(D);_.x=F*Y,_.y=g*L,_.z=F*G,d.push(_.x,_.y,_.z),f.push(0,L,0),T.x=G*.5+.5,T.y=Y*.5*L+.5,h.push(T.x,T.y),m++}for(let O=0;O<s;O++){let k=R+O,D=I+O;b===!0?u.push(D,D+1,k):u.push(D+1,D,k),w+=3}l.addGroup(p,w,b===!0?1:2),p+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},ir=class i extends Qr{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var sr=class i extends Rn{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),c=Math.floor(s),l=a+1,u=c+1,d=e/a,f=t/c,h=[],m=[],y=[],g=[];for(let p=0;p<u;p++){let v=p*f-o;for(let A=0;A<l;A++){let b=A*d-r;m.push(b,-v,0),y.push(0,0,1),g.push(A/a),g.push(1-p/c)}}for(let p=0;p<c;p++)for(let v=0;v<a;v++){let A=v+l*p,b=v+l*(p+1),R=v+1+l*(p+1),T=v+1+l*p;h.push(A,b,T),h.push(b,R,T)}this.setIndex(h),this.setAttribute("position",new Qt(m,3)),this.setAttribute("normal",new Qt(y,3)),this.setAttribute("uv",new Qt(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var ra=class i extends Rn{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let c=Math.min(o+a,Math.PI),l=0,u=[],d=new X,f=new X,h=[],m=[],y=[],g=[];for(let p=0;p<=n;p++){let v=[],A=p/n,b=o+A*a,R=e*Math.cos(b),T=Math.sqrt(e*e-R*R),_=0;p===0&&o===0?_=.5/t:p===n&&c===Math.PI&&(_=-.5/t);for(let w=0;w<=t;w++){let F=w/t,L=s+F*r;d.x=-T*Math.cos(L),d.y=R,d.z=T*Math.sin(L),m.push(d.x,d.y,d.z),f.copy(d).normalize(),y.push(f.x,f.y,f.z),g.push(F+_,1-A),v.push(l++)}u.push(v)}for(let p=0;p<n;p++)for(let v=0;v<t;v++){let A=u[p][v+1],b=u[p][v],R=u[p+1][v],T=u[p+1][v+1];(p!==0||o>0)&&h.push(A,b,T),(p!==n-1||c<Math.PI)&&h.push(b,R,T)}this.setIndex(h),this.setAttribute("position",new Qt(m,3)),this.setAttribute("normal",new Qt(y,3)),this.setAttribute("uv",new Qt(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function cr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(mp(s))s.isRenderTargetTexture?(Ye("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(mp(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Vn(i){let e={};for(let t=0;t<i.length;t++){let n=cr(i[t]);for(let s in n)e[s]=n[s]}return e}function mp(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function yx(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function ef(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:pt.workingColorSpace}var sm={clone:cr,merge:Vn},bx=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Sx=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,vi=class extends ks{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=bx,this.fragmentShader=Sx,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=cr(e.uniforms),this.uniformsGroups=yx(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new rt().setHex(s.value);break;case"v2":this.uniforms[n].value=new _t().fromArray(s.value);break;case"v3":this.uniforms[n].value=new X().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Ht().fromArray(s.value);break;case"m3":this.uniforms[n].value=new et().fromArray(s.value);break;case"m4":this.uniforms[n].value=new vt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Ul=class extends vi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ol=class extends ks{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Wp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Bl=class extends ks{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function zr(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function ml(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Vs=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=t[--n-1],e>=r)break t}o=n,n=0;break n}break e}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},kl=class extends Vs{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:gh,endingEnd:gh}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case _h:r=e,a=2*t-n;break;case xh:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(c===void 0)switch(this.getSettings_().endingEnd){case _h:o=e,c=2*n-t;break;case xh:o=1,c=n+s[1]-s[0];break;default:o=e-1,c=t}let l=(n-t)*.5,u=this.valueSize;this._weightPrev=l/(t-a),this._weightNext=l/(c-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,u=this._offsetPrev,d=this._offsetNext,f=this._weightPrev,h=this._weightNext,m=(n-t)/(s-t),y=m*m,g=y*m,p=-f*g+2*f*y-f*m,v=(1+f)*g+(-1.5-2*f)*y+(-.5+f)*m+1,A=(-1-h)*g+(1.5+h)*y+.5*m,b=h*g-h*y;for(let R=0;R!==a;++R)r[R]=p*o[u+R]+v*o[l+R]+A*o[c+R]+b*o[d+R];return r}},zl=class extends Vs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,u=(n-t)/(s-t),d=1-u;for(let f=0;f!==a;++f)r[f]=o[l+f]*d+o[c+f]*u;return r}},Vl=class extends Vs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Hl=class extends Vs{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,u=this.inTangents,d=this.outTangents;if(!u||!d){let m=(n-t)/(s-t),y=1-m;for(let g=0;g!==a;++g)r[g]=o[l+g]*y+o[c+g]*m;return r}let f=a*2,h=e-1;for(let m=0;m!==a;++m){let y=o[l+m],g=o[c+m],p=h*f+m*2,v=d[p],A=d[p+1],b=e*f+m*2,R=u[b],T=u[b+1],_=wx(n,t,v,R,s);r[m]=rm(_,y,A,T,g)}return r}};function rm(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function Mx(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function wx(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=rm(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let c=Mx(r,e,t,n,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var li=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=zr(t,this.TimeBufferType),this.values=zr(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:zr(e.times,Array),values:zr(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),ml(e.settings)&&(n.settings={inTangents:zr(e.settings.inTangents,Array),outTangents:zr(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Vl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new zl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new kl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Hl(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Go:t=this.InterpolantFactoryMethodDiscrete;break;case Rl:t=this.InterpolantFactoryMethodLinear;break;case xl:t=this.InterpolantFactoryMethodSmooth;break;case mh:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ye("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Go;case this.InterpolantFactoryMethodLinear:return Rl;case this.InterpolantFactoryMethodSmooth:return xl;case this.InterpolantFactoryMethodBezier:return mh}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;ml(this.settings)&&(gp(this.settings.inTangents,e),gp(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;ml(this.settings)&&(_p(this.settings.inTangents,e),_p(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Qe("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Qe("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let c=n[a];if(typeof c=="number"&&isNaN(c)){Qe("KeyframeTrack: Time is not a valid number.",this,a,c),e=!1;break}if(o!==null&&o>c){Qe("KeyframeTrack: Out of order keys.",this,a,c,o),e=!1;break}o=c}if(s!==void 0&&j_(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){Qe("KeyframeTrack: Value is not a valid number.",this,a,l),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===xl,r=e.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=e[a],u=e[a+1];if(l!==u&&(a!==1||l!==e[0]))if(s)c=!0;else{let d=a*n,f=d-n,h=d+n;for(let m=0;m!==n;++m){let y=t[d+m];if(y!==t[f+m]||y!==t[h+m]){c=!0;break}}}if(c){if(a!==o){e[o]=e[a];let d=a*n,f=o*n;for(let h=0;h!==n;++h)t[f+h]=t[d+h]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,c=o*n,l=0;l!==n;++l)t[c+l]=t[a+l];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,ml(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function gp(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function _p(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}li.prototype.ValueTypeName="";li.prototype.TimeBufferType=Float32Array;li.prototype.ValueBufferType=Float32Array;li.prototype.DefaultInterpolation=Rl;var Hs=class extends li{constructor(e,t,n){super(e,t,n)}};Hs.prototype.ValueTypeName="bool";Hs.prototype.ValueBufferType=Array;Hs.prototype.DefaultInterpolation=Go;Hs.prototype.InterpolantFactoryMethodLinear=void 0;Hs.prototype.InterpolantFactoryMethodSmooth=void 0;var Gl=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};Gl.prototype.ValueTypeName="color";var Wl=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};Wl.prototype.ValueTypeName="number";var Xl=class extends Vs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(n-t)/(s-t),l=e*a;for(let u=l+a;l!==u;l+=4)xi.slerpFlat(r,0,o,l-a,o,l,c);return r}},oa=class extends li{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Xl(this.times,this.values,this.getValueSize(),e)}};oa.prototype.ValueTypeName="quaternion";oa.prototype.InterpolantFactoryMethodSmooth=void 0;var Gs=class extends li{constructor(e,t,n){super(e,t,n)}};Gs.prototype.ValueTypeName="string";Gs.prototype.ValueBufferType=Array;Gs.prototype.DefaultInterpolation=Go;Gs.prototype.InterpolantFactoryMethodLinear=void 0;Gs.prototype.InterpolantFactoryMethodSmooth=void 0;var ql=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};ql.prototype.ValueTypeName="vector";var Yl=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),c?c(u):u},this.setURLModifier=function(u){return c=u,this},this.addHandler=function(u,d){return l.push(u,d),this},this.removeHandler=function(u){let d=l.indexOf(u);return d!==-1&&l.splice(d,2),this},this.getHandler=function(u){for(let d=0,f=l.length;d<f;d+=2){let h=l[d],m=l[d+1];if(h.global&&(h.lastIndex=0),h.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},om=new Yl,$l=class{constructor(e){this.manager=e!==void 0?e:om,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};$l.DEFAULT_MATERIAL_NAME="__DEFAULT";var gl=new X,_l=new xi,Yi=new X,aa=class extends ai{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new vt,this.projectionMatrix=new vt,this.projectionMatrixInverse=new vt,this.coordinateSystem=_i,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(gl,_l,Yi),Yi.x===1&&Yi.y===1&&Yi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(gl,_l,Yi.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(gl,_l,Yi),Yi.x===1&&Yi.y===1&&Yi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(gl,_l,Yi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Us=new X,xp=new _t,vp=new _t,$n=class extends aa{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Cl*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Yu*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Cl*2*Math.atan(Math.tan(Yu*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Us.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Us.x,Us.y).multiplyScalar(-e/Us.z),Us.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Us.x,Us.y).multiplyScalar(-e/Us.z)}getViewSize(e,t){return this.getViewBounds(e,xp,vp),t.subVectors(vp,xp)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Yu*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,t-=o.offsetY*n/l,s*=o.width/c,n*=o.height/l}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var eo=class extends aa{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,c=s-t;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=u*this.view.offsetY,c=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var to=class extends Rn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Vr=-90,Hr=1,no=class extends ai{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new $n(Vr,Hr,e,t);s.layers=this.layers,this.add(s);let r=new $n(Vr,Hr,e,t);r.layers=this.layers,this.add(r);let o=new $n(Vr,Hr,e,t);o.layers=this.layers,this.add(o);let a=new $n(Vr,Hr,e,t);a.layers=this.layers,this.add(a);let c=new $n(Vr,Hr,e,t);c.layers=this.layers,this.add(c);let l=new $n(Vr,Hr,e,t);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,c]=t;for(let l of t)this.remove(l);if(e===_i)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(e===qo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let l of t)this.add(l),l.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,u]=this.children,d=e.getRenderTarget(),f=e.getActiveCubeFace(),h=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(n,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),n.texture.mipmapsAutoUpdate=y,e.setRenderTarget(n,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(d,f,h),e.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},Zl=class extends $n{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var tf="\\[\\]\\.:\\/",Ex=new RegExp("["+tf+"]","g"),nf="[^"+tf+"]",Tx="[^"+tf.replace("\\.","")+"]",Ax=/((?:WC+[\/:])*)/.source.replace("WC",nf),Rx=/(WCOD+)?/.source.replace("WCOD",Tx),Cx=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",nf),Px=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",nf),Ix=new RegExp("^"+Ax+Rx+Cx+Px+"$"),Lx=["material","materials","bones","map"],vh=class{constructor(e,t,n){let s=n||Vt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Vt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Ex,"")}static parseTrackName(e){let t=Ix.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Lx.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let c=n(a.children);if(c)return c}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ye("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=t.objectIndex;switch(n){case"materials":if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Qe("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Qe("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===l){l=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Qe("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){Qe("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(l!==void 0){if(e[l]===void 0){Qe("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[l]}}let o=e[s];if(o===void 0){let l=t.nodeName;Qe("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Vt.Composite=vh;Vt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Vt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Vt.prototype.GetterByBindingType=[Vt.prototype._getValue_direct,Vt.prototype._getValue_array,Vt.prototype._getValue_arrayElement,Vt.prototype._getValue_toArray];Vt.prototype.SetterByBindingTypeAndVersioning=[[Vt.prototype._setValue_direct,Vt.prototype._setValue_direct_setNeedsUpdate,Vt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Vt.prototype._setValue_array,Vt.prototype._setValue_array_setNeedsUpdate,Vt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Vt.prototype._setValue_arrayElement,Vt.prototype._setValue_arrayElement_setNeedsUpdate,Vt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Vt.prototype._setValue_fromArray,Vt.prototype._setValue_fromArray_setNeedsUpdate,Vt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var O1=new Float32Array(1);var yh=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};function sf(i,e,t,n){let s=Dx(n);switch(t){case zh:return i*e;case Hh:return i*e/s.components*s.byteLength;case nc:return i*e/s.components*s.byteLength;case Ws:return i*e*2/s.components*s.byteLength;case ic:return i*e*2/s.components*s.byteLength;case Vh:return i*e*3/s.components*s.byteLength;case ui:return i*e*4/s.components*s.byteLength;case sc:return i*e*4/s.components*s.byteLength;case ua:case ha:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case fa:case da:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case oc:case lc:return Math.max(i,16)*Math.max(e,8)/4;case rc:case ac:return Math.max(i,8)*Math.max(e,8)/2;case cc:case uc:case fc:case dc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case hc:case pa:case pc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case mc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case gc:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case _c:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case xc:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case vc:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case yc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case bc:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Sc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Mc:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case wc:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Ec:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Tc:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Ac:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Rc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Cc:case Pc:case Ic:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Lc:case Dc:return Math.ceil(i/4)*Math.ceil(e/4)*8;case ma:case Nc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Dx(i){switch(i){case ci:case Uh:return{byteLength:1,components:1};case oo:case Oh:case Li:return{byteLength:2,components:1};case ec:case tc:return{byteLength:2,components:4};case Pi:case Ql:case Ii:return{byteLength:4,components:1};case Bh:case kh:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ye("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Rm(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function Fx(i){let e=new WeakMap;function t(a,c){let l=a.array,u=a.usage,d=l.byteLength,f=i.createBuffer();i.bindBuffer(c,f),i.bufferData(c,l,u),a.onUploadCallback();let h;if(l instanceof Float32Array)h=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)h=i.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?h=i.HALF_FLOAT:h=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)h=i.SHORT;else if(l instanceof Uint32Array)h=i.UNSIGNED_INT;else if(l instanceof Int32Array)h=i.INT;else if(l instanceof Int8Array)h=i.BYTE;else if(l instanceof Uint8Array)h=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)h=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:f,type:h,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:d}}function n(a,c,l){let u=c.array,d=c.updateRanges;if(i.bindBuffer(l,a),d.length===0)i.bufferSubData(l,0,u);else{d.sort((h,m)=>h.start-m.start);let f=0;for(let h=1;h<d.length;h++){let m=d[f],y=d[h];y.start<=m.start+m.count+1?m.count=Math.max(m.count,y.start+y.count-m.start):(++f,d[f]=y)}d.length=f+1;for(let h=0,m=d.length;h<m;h++){let y=d[h];i.bufferSubData(l,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=e.get(a);c&&(i.deleteBuffer(c.buffer),e.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=e.get(a);if(l===void 0)e.set(a,t(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var Ux=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Ox=`#ifdef USE_ALPHAHASH
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
#endif`,Bx=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,kx=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,zx=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Vx=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Hx=`#ifdef USE_AOMAP
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
#endif`,Gx=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Wx=`#ifdef USE_BATCHING
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
#endif`,Xx=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,qx=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Yx=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,$x=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Zx=`#ifdef USE_IRIDESCENCE
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
#endif`,Jx=`#ifdef USE_BUMPMAP
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
#endif`,Kx=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,jx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Qx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ev=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,tv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,nv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,iv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,sv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,rv=`#define PI 3.141592653589793
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
} // validated`,ov=`vec3 transformedNormal = objectNormal;
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
#endif`,av=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,lv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,cv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,uv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,hv="gl_FragColor = linearToOutputTexel( gl_FragColor );",fv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,dv=`#ifdef USE_ENVMAP
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
#endif`,pv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,mv=`#ifdef USE_ENVMAP
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
#endif`,gv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,_v=`#ifdef USE_ENVMAP
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
#endif`,xv=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,vv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,yv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,bv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Sv=`#ifdef USE_GRADIENTMAP
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
}`,Mv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,wv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Ev=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Tv=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Av=`#ifdef USE_ENVMAP
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
#endif`,Rv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Cv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Pv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Iv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Lv=`PhysicalMaterial material;
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
#endif`,Dv=`uniform sampler2D dfgLUT;
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
}`,Nv=`
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
#endif`,Fv=`#if defined( RE_IndirectDiffuse )
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
#endif`,Uv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Ov=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Bv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,kv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,zv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Vv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Hv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Gv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Wv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Xv=`#if defined( USE_POINTS_UV )
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
#endif`,qv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Yv=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,$v=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Zv=`#if defined( USE_MORPHCOLORS )
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
#endif`,Jv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Kv=`#ifdef USE_MORPHTARGETS
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
#endif`,jv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Qv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,ey=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,ty=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ny=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,iy=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,sy=`#ifdef USE_NORMALMAP
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
#endif`,ry=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,oy=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,ay=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,ly=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,cy=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,uy=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,hy=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,fy=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,dy=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,py=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,my=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,gy=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,_y=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,xy=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,vy=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,yy=`float getShadowMask() {
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
}`,by=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Sy=`#ifdef USE_SKINNING
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
#endif`,My=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,wy=`#ifdef USE_SKINNING
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
#endif`,Ey=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Ty=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Ay=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Ry=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Cy=`#ifdef USE_TRANSMISSION
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
#endif`,Py=`#ifdef USE_TRANSMISSION
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
#endif`,Iy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Ly=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Dy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Ny=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Fy=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Uy=`uniform sampler2D t2D;
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
}`,Oy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,By=`uniform float backgroundBlurriness;
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
}`,ky=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,zy=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Vy=`#include <common>
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
}`,Hy=`#if DEPTH_PACKING == 3200
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
}`,Gy=`#define DISTANCE
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
}`,Wy=`#define DISTANCE
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
}`,Xy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,qy=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Yy=`uniform float scale;
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
}`,$y=`uniform vec3 diffuse;
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
}`,Zy=`#include <common>
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
}`,Jy=`uniform vec3 diffuse;
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
}`,Ky=`#define LAMBERT
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
}`,jy=`#define LAMBERT
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
}`,Qy=`#define MATCAP
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
}`,eb=`#define MATCAP
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
}`,tb=`#define NORMAL
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
}`,nb=`#define NORMAL
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
}`,ib=`#define PHONG
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
}`,sb=`#define PHONG
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
}`,rb=`#define STANDARD
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
}`,ob=`#define STANDARD
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
}`,ab=`#define TOON
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
}`,lb=`#define TOON
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
}`,cb=`uniform float size;
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
}`,ub=`uniform vec3 diffuse;
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
}`,hb=`#include <common>
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
}`,fb=`uniform vec3 color;
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
}`,db=`uniform float rotation;
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
}`,pb=`uniform vec3 diffuse;
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
}`,lt={alphahash_fragment:Ux,alphahash_pars_fragment:Ox,alphamap_fragment:Bx,alphamap_pars_fragment:kx,alphatest_fragment:zx,alphatest_pars_fragment:Vx,aomap_fragment:Hx,aomap_pars_fragment:Gx,batching_pars_vertex:Wx,batching_vertex:Xx,begin_vertex:qx,beginnormal_vertex:Yx,bsdfs:$x,iridescence_fragment:Zx,bumpmap_pars_fragment:Jx,clipping_planes_fragment:Kx,clipping_planes_pars_fragment:jx,clipping_planes_pars_vertex:Qx,clipping_planes_vertex:ev,color_fragment:tv,color_pars_fragment:nv,color_pars_vertex:iv,color_vertex:sv,common:rv,defaultnormal_vertex:ov,displacementmap_pars_vertex:av,displacementmap_vertex:lv,emissivemap_fragment:cv,emissivemap_pars_fragment:uv,colorspace_fragment:hv,colorspace_pars_fragment:fv,envmap_fragment:dv,envmap_common_pars_fragment:pv,envmap_pars_fragment:mv,envmap_pars_vertex:gv,envmap_physical_pars_fragment:Av,envmap_vertex:_v,fog_vertex:xv,fog_pars_vertex:vv,fog_fragment:yv,fog_pars_fragment:bv,gradientmap_pars_fragment:Sv,lightmap_pars_fragment:Mv,lights_lambert_fragment:wv,lights_lambert_pars_fragment:Ev,lights_pars_begin:Tv,lights_toon_fragment:Rv,lights_toon_pars_fragment:Cv,lights_phong_fragment:Pv,lights_phong_pars_fragment:Iv,lights_physical_fragment:Lv,lights_physical_pars_fragment:Dv,lights_fragment_begin:Nv,lights_fragment_maps:Fv,lights_fragment_end:Uv,lightprobes_pars_fragment:Ov,logdepthbuf_fragment:Bv,logdepthbuf_pars_fragment:kv,logdepthbuf_pars_vertex:zv,logdepthbuf_vertex:Vv,map_fragment:Hv,map_pars_fragment:Gv,map_particle_fragment:Wv,map_particle_pars_fragment:Xv,metalnessmap_fragment:qv,metalnessmap_pars_fragment:Yv,morphinstance_vertex:$v,morphcolor_vertex:Zv,morphnormal_vertex:Jv,morphtarget_pars_vertex:Kv,morphtarget_vertex:jv,normal_fragment_begin:Qv,normal_fragment_maps:ey,normal_pars_fragment:ty,normal_pars_vertex:ny,normal_vertex:iy,normalmap_pars_fragment:sy,clearcoat_normal_fragment_begin:ry,clearcoat_normal_fragment_maps:oy,clearcoat_pars_fragment:ay,iridescence_pars_fragment:ly,opaque_fragment:cy,packing:uy,premultiplied_alpha_fragment:hy,project_vertex:fy,dithering_fragment:dy,dithering_pars_fragment:py,roughnessmap_fragment:my,roughnessmap_pars_fragment:gy,shadowmap_pars_fragment:_y,shadowmap_pars_vertex:xy,shadowmap_vertex:vy,shadowmask_pars_fragment:yy,skinbase_vertex:by,skinning_pars_vertex:Sy,skinning_vertex:My,skinnormal_vertex:wy,specularmap_fragment:Ey,specularmap_pars_fragment:Ty,tonemapping_fragment:Ay,tonemapping_pars_fragment:Ry,transmission_fragment:Cy,transmission_pars_fragment:Py,uv_pars_fragment:Iy,uv_pars_vertex:Ly,uv_vertex:Dy,worldpos_vertex:Ny,background_vert:Fy,background_frag:Uy,backgroundCube_vert:Oy,backgroundCube_frag:By,cube_vert:ky,cube_frag:zy,depth_vert:Vy,depth_frag:Hy,distance_vert:Gy,distance_frag:Wy,equirect_vert:Xy,equirect_frag:qy,linedashed_vert:Yy,linedashed_frag:$y,meshbasic_vert:Zy,meshbasic_frag:Jy,meshlambert_vert:Ky,meshlambert_frag:jy,meshmatcap_vert:Qy,meshmatcap_frag:eb,meshnormal_vert:tb,meshnormal_frag:nb,meshphong_vert:ib,meshphong_frag:sb,meshphysical_vert:rb,meshphysical_frag:ob,meshtoon_vert:ab,meshtoon_frag:lb,points_vert:cb,points_frag:ub,shadow_vert:hb,shadow_frag:fb,sprite_vert:db,sprite_frag:pb},Le={common:{diffuse:{value:new rt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new et}},envmap:{envMap:{value:null},envMapRotation:{value:new et},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new et}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new et}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new et},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new et},normalScale:{value:new _t(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new et},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new et}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new et}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new et}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new rt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new rt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0},uvTransform:{value:new et}},sprite:{diffuse:{value:new rt(16777215)},opacity:{value:1},center:{value:new _t(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}}},Qi={basic:{uniforms:Vn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:lt.meshbasic_vert,fragmentShader:lt.meshbasic_frag},lambert:{uniforms:Vn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new rt(0)},envMapIntensity:{value:1}}]),vertexShader:lt.meshlambert_vert,fragmentShader:lt.meshlambert_frag},phong:{uniforms:Vn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new rt(0)},specular:{value:new rt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:lt.meshphong_vert,fragmentShader:lt.meshphong_frag},standard:{uniforms:Vn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new rt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:lt.meshphysical_vert,fragmentShader:lt.meshphysical_frag},toon:{uniforms:Vn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new rt(0)}}]),vertexShader:lt.meshtoon_vert,fragmentShader:lt.meshtoon_frag},matcap:{uniforms:Vn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:lt.meshmatcap_vert,fragmentShader:lt.meshmatcap_frag},points:{uniforms:Vn([Le.points,Le.fog]),vertexShader:lt.points_vert,fragmentShader:lt.points_frag},dashed:{uniforms:Vn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:lt.linedashed_vert,fragmentShader:lt.linedashed_frag},depth:{uniforms:Vn([Le.common,Le.displacementmap]),vertexShader:lt.depth_vert,fragmentShader:lt.depth_frag},normal:{uniforms:Vn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:lt.meshnormal_vert,fragmentShader:lt.meshnormal_frag},sprite:{uniforms:Vn([Le.sprite,Le.fog]),vertexShader:lt.sprite_vert,fragmentShader:lt.sprite_frag},background:{uniforms:{uvTransform:{value:new et},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:lt.background_vert,fragmentShader:lt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new et}},vertexShader:lt.backgroundCube_vert,fragmentShader:lt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:lt.cube_vert,fragmentShader:lt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:lt.equirect_vert,fragmentShader:lt.equirect_frag},distance:{uniforms:Vn([Le.common,Le.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:lt.distance_vert,fragmentShader:lt.distance_frag},shadow:{uniforms:Vn([Le.lights,Le.fog,{color:{value:new rt(0)},opacity:{value:1}}]),vertexShader:lt.shadow_vert,fragmentShader:lt.shadow_frag}};Qi.physical={uniforms:Vn([Qi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new et},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new et},clearcoatNormalScale:{value:new _t(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new et},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new et},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new et},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new et},sheen:{value:0},sheenColor:{value:new rt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new et},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new et},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new et},transmissionSamplerSize:{value:new _t},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new et},attenuationDistance:{value:0},attenuationColor:{value:new rt(0)},specularColor:{value:new rt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new et},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new et},anisotropyVector:{value:new _t},anisotropyMap:{value:null},anisotropyMapTransform:{value:new et}}]),vertexShader:lt.meshphysical_vert,fragmentShader:lt.meshphysical_frag};var Uc={r:0,b:0,g:0},mb=new vt,Cm=new et;Cm.set(-1,0,0,0,1,0,0,0,1);function gb(i,e,t,n,s,r){let o=new rt(0),a=s===!0?0:1,c,l,u=null,d=0,f=null;function h(v){let A=v.isScene===!0?v.background:null;if(A&&A.isTexture){let b=v.backgroundBlurriness>0;A=e.get(A,b)}return A}function m(v){let A=!1,b=h(v);b===null?g(o,a):b&&b.isColor&&(g(b,1),A=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(v,A){let b=h(A);b&&b.isCubeTexture?(l===void 0&&(l=new Ut(new jr(1,1,1),new vi({name:"BackgroundCubeMaterial",uniforms:cr(Qi.backgroundCube.uniforms),vertexShader:Qi.backgroundCube.vertexShader,fragmentShader:Qi.backgroundCube.fragmentShader,side:Dn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(R,T,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=b,l.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(mb.makeRotationFromEuler(A.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(Cm),l.material.toneMapped=pt.getTransfer(b.colorSpace)!==wt,(u!==b||d!==b.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,u=b,d=b.version,f=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null)):b&&b.isTexture&&(c===void 0&&(c=new Ut(new sr(2,2),new vi({name:"BackgroundMaterial",uniforms:cr(Qi.background.uniforms),vertexShader:Qi.background.vertexShader,fragmentShader:Qi.background.fragmentShader,side:yi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=b,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.toneMapped=pt.getTransfer(b.colorSpace)!==wt,b.matrixAutoUpdate===!0&&b.updateMatrix(),c.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||d!==b.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,u=b,d=b.version,f=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null))}function g(v,A){v.getRGB(Uc,ef(i)),t.buffers.color.setClear(Uc.r,Uc.g,Uc.b,A,r)}function p(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,A=1){o.set(v),a=A,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,g(o,a)},render:m,addToRenderList:y,dispose:p}}function _b(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(I,O,k,D,G){let Y=!1,H=d(I,D,k,O);r!==H&&(r=H,l(r.object)),Y=h(I,D,k,G),Y&&m(I,D,k,G),G!==null&&e.update(G,i.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,b(I,O,k,D),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function c(){return i.createVertexArray()}function l(I){return i.bindVertexArray(I)}function u(I){return i.deleteVertexArray(I)}function d(I,O,k,D){let G=D.wireframe===!0,Y=n[O.id];Y===void 0&&(Y={},n[O.id]=Y);let H=I.isInstancedMesh===!0?I.id:0,le=Y[H];le===void 0&&(le={},Y[H]=le);let J=le[k.id];J===void 0&&(J={},le[k.id]=J);let Q=J[G];return Q===void 0&&(Q=f(c()),J[G]=Q),Q}function f(I){let O=[],k=[],D=[];for(let G=0;G<t;G++)O[G]=0,k[G]=0,D[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:k,attributeDivisors:D,object:I,attributes:{},index:null}}function h(I,O,k,D){let G=r.attributes,Y=O.attributes,H=0,le=k.getAttributes();for(let J in le)if(le[J].location>=0){let ie=G[J],fe=Y[J];if(fe===void 0&&(J==="instanceMatrix"&&I.instanceMatrix&&(fe=I.instanceMatrix),J==="instanceColor"&&I.instanceColor&&(fe=I.instanceColor)),ie===void 0||ie.attribute!==fe||fe&&ie.data!==fe.data)return!0;H++}return r.attributesNum!==H||r.index!==D}function m(I,O,k,D){let G={},Y=O.attributes,H=0,le=k.getAttributes();for(let J in le)if(le[J].location>=0){let ie=Y[J];ie===void 0&&(J==="instanceMatrix"&&I.instanceMatrix&&(ie=I.instanceMatrix),J==="instanceColor"&&I.instanceColor&&(ie=I.instanceColor));let fe={};fe.attribute=ie,ie&&ie.data&&(fe.data=ie.data),G[J]=fe,H++}r.attributes=G,r.attributesNum=H,r.index=D}function y(){let I=r.newAttributes;for(let O=0,k=I.length;O<k;O++)I[O]=0}function g(I){p(I,0)}function p(I,O){let k=r.newAttributes,D=r.enabledAttributes,G=r.attributeDivisors;k[I]=1,D[I]===0&&(i.enableVertexAttribArray(I),D[I]=1),G[I]!==O&&(i.vertexAttribDivisor(I,O),G[I]=O)}function v(){let I=r.newAttributes,O=r.enabledAttributes;for(let k=0,D=O.length;k<D;k++)O[k]!==I[k]&&(i.disableVertexAttribArray(k),O[k]=0)}function A(I,O,k,D,G,Y,H){H===!0?i.vertexAttribIPointer(I,O,k,G,Y):i.vertexAttribPointer(I,O,k,D,G,Y)}function b(I,O,k,D){y();let G=D.attributes,Y=k.getAttributes(),H=O.defaultAttributeValues;for(let le in Y){let J=Y[le];if(J.location>=0){let Q=G[le];if(Q===void 0&&(le==="instanceMatrix"&&I.instanceMatrix&&(Q=I.instanceMatrix),le==="instanceColor"&&I.instanceColor&&(Q=I.instanceColor)),Q!==void 0){let ie=Q.normalized,fe=Q.itemSize,he=e.get(Q);if(he===void 0)continue;let ee=he.buffer,me=he.type,ge=he.bytesPerElement,Me=me===i.INT||me===i.UNSIGNED_INT||Q.gpuType===Ql;if(Q.isInterleavedBufferAttribute){let ve=Q.data,He=ve.isInterleavedBuffer===!0?ve.stride:ve.itemSize,Ze=Q.offset;if(ve.isInstancedInterleavedBuffer||ve.isInstancedBufferAttribute){for(let Oe=0;Oe<J.locationSize;Oe++)p(J.location+Oe,ve.meshPerAttribute);I.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=ve.meshPerAttribute*ve.count)}else for(let Oe=0;Oe<J.locationSize;Oe++)g(J.location+Oe);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Oe=0;Oe<J.locationSize;Oe++)A(J.location+Oe,fe/J.locationSize,me,ie,He*ge,(Ze+fe/J.locationSize*Oe)*ge,Me)}else{if(Q.isInstancedBufferAttribute){for(let ve=0;ve<J.locationSize;ve++)p(J.location+ve,Q.meshPerAttribute);I.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let ve=0;ve<J.locationSize;ve++)g(J.location+ve);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let ve=0;ve<J.locationSize;ve++)A(J.location+ve,fe/J.locationSize,me,ie,fe*ge,fe/J.locationSize*ve*ge,Me)}}else if(H!==void 0){let ie=H[le];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv(J.location,ie);break;case 3:i.vertexAttrib3fv(J.location,ie);break;case 4:i.vertexAttrib4fv(J.location,ie);break;default:i.vertexAttrib1fv(J.location,ie)}}}}v()}function R(){F();for(let I in n){let O=n[I];for(let k in O){let D=O[k];for(let G in D){let Y=D[G];for(let H in Y)u(Y[H].object),delete Y[H];delete D[G]}}delete n[I]}}function T(I){if(n[I.id]===void 0)return;let O=n[I.id];for(let k in O){let D=O[k];for(let G in D){let Y=D[G];for(let H in Y)u(Y[H].object),delete Y[H];delete D[G]}}delete n[I.id]}function _(I){for(let O in n){let k=n[O];for(let D in k){let G=k[D];if(G[I.id]===void 0)continue;let Y=G[I.id];for(let H in Y)u(Y[H].object),delete Y[H];delete G[I.id]}}}function w(I){for(let O in n){let k=n[O],D=I.isInstancedMesh===!0?I.id:0,G=k[D];if(G!==void 0){for(let Y in G){let H=G[Y];for(let le in H)u(H[le].object),delete H[le];delete G[Y]}delete k[D],Object.keys(k).length===0&&delete n[O]}}}function F(){L(),o=!0,r!==s&&(r=s,l(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:F,resetDefaultState:L,dispose:R,releaseStatesOfGeometry:T,releaseStatesOfObject:w,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:g,disableUnusedAttributes:v}}function xb(i,e,t){let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),t.update(l,n,1)}function o(c,l,u){u!==0&&(i.drawArraysInstanced(n,c,l,u),t.update(l,n,u))}function a(c,l,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,u);let f=0;for(let h=0;h<u;h++)f+=l[h];t.update(f,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function vb(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==ui&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let w=_===Li&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==ci&&_!==Ii&&!w&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=t.precision!==void 0?t.precision:"highp",u=c(l);u!==l&&(Ye("WebGLRenderer:",l,"not supported, using",u,"instead."),l=u);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&Ye("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&Ye("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let h=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),T=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:f,reversedDepthBuffer:d,maxTextures:h,maxVertexTextures:m,maxTextureSize:y,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:v,maxVaryings:A,maxFragmentUniforms:b,maxSamples:R,samples:T}}function yb(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Ci,a=new et,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(d,f){let h=d.length!==0||f||n!==0||s;return s=f,n=d.length,h},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,f){t=u(d,f,0)},this.setState=function(d,f,h){let m=d.clippingPlanes,y=d.clipIntersection,g=d.clipShadows,p=i.get(d);if(!s||m===null||m.length===0||r&&!g)r?u(null):l();else{let v=r?0:n,A=v*4,b=p.clippingState||null;c.value=b,b=u(m,f,A,h);for(let R=0;R!==A;++R)b[R]=t[R];p.clippingState=b,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function l(){c.value!==t&&(c.value=t,c.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(d,f,h,m){let y=d!==null?d.length:0,g=null;if(y!==0){if(g=c.value,m!==!0||g===null){let p=h+y*4,v=f.matrixWorldInverse;a.getNormalMatrix(v),(g===null||g.length<p)&&(g=new Float32Array(p));for(let A=0,b=h;A!==y;++A,b+=4)o.copy(d[A]).applyMatrix4(v,a),o.normal.toArray(g,b),g[b+3]=o.constant}c.value=g,c.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,g}}var ya=class extends oi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new na(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new jr(5,5,5),r=new vi({name:"CubemapFromEquirect",uniforms:cr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Dn,blending:rr});r.uniforms.tEquirect.value=t;let o=new Ut(s,r),a=t.minFilter;return t.minFilter===gs&&(t.minFilter=Ln),new no(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},am=256,bb=3,Sb=20,Pm=256,Im=16,Mb=3,wb=new X,Eb=new rt,Bc=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new no(1,10,null),this._boxMesh=new Ut(new jr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=wb}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let d=c.autoClear,f=c.autoClearColor,h=c.autoClearDepth,m=c.autoClearStencil,y=e.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,y===null&&(e.background=c.getClearColor(Eb));let g=new no(n,s,u);return g.position.copy(a),g.update(c,e),c.autoClear=d,c.autoClearColor=f,c.autoClearDepth=h,c.autoClearStencil=m,e.background=y,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(l,t)),this._applyPMREM(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=um(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=cm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(am,nm(e))}_fromTexture(e,t){e.mapping===ar||e.mapping===ro?this._setSize(e.image.length===0?am:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=lm(e,!1,!1),n=Math.log2(e)-bb;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=lm(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===ar||e.mapping===ro?(this._cubemapMaterial===null&&(this._cubemapMaterial=um()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=cm()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=Tb(),this._integrationMaterial=Ab());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Im);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-Mb)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let c=a>0?Math.log2(t)+.5*Math.log2(6/(Pm*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=Rb());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function lm(i,e,t){return new ya(i,{minFilter:gs,generateMipmaps:e,type:Li,colorSpace:Wo,depthBuffer:t})}function ba(i,e,t){return new vi({name:i,uniforms:e,vertexShader:lt.cube_vert,fragmentShader:t,side:Dn,blending:rr,depthTest:!1,depthWrite:!1})}function Tb(){return ba("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Pm}u

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
	`)}function Ab(){return ba("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Im}},`

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
	`)}function Rb(){return ba("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Sb}
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
	`)}function cm(){return ba("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function um(){return ba("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Cb(i){let e=new WeakMap,t=new WeakMap,n=null;function s(f,h=!1){return f==null?null:h?o(f):r(f)}function r(f){if(f&&f.isTexture){let h=f.mapping;if(h===Jl||h===Kl)if(e.has(f)){let m=e.get(f).texture;return a(m,f.mapping)}else{let m=f.image;if(m&&m.height>0){let y=new ya(m.height);return y.fromEquirectangularTexture(i,f),e.set(f,y),f.addEventListener("dispose",l),a(y.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let h=f.mapping,m=h===Jl||h===Kl,y=h===ar||h===ro;if(m||y){let g=t.get(f),p=g!==void 0?g.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==p)return n===null&&(n=new Bc(i)),g=m?n.fromEquirectangular(f,g):n.fromCubemap(f,g),g.texture.pmremVersion=f.pmremVersion,t.set(f,g),g.texture;if(g!==void 0)return g.texture;{let v=f.image;return m&&v&&v.height>0||y&&v&&c(v)?(n===null&&(n=new Bc(i)),g=m?n.fromEquirectangular(f):n.fromCubemap(f),g.texture.pmremVersion=f.pmremVersion,t.set(f,g),f.addEventListener("dispose",u),g.texture):null}}}return f}function a(f,h){return h===Jl?f.mapping=ar:h===Kl&&(f.mapping=ro),f}function c(f){let h=0,m=6;for(let y=0;y<m;y++)f[y]!==void 0&&h++;return h===m}function l(f){let h=f.target;h.removeEventListener("dispose",l);let m=e.get(h);m!==void 0&&(e.delete(h),m.dispose())}function u(f){let h=f.target;h.removeEventListener("dispose",u);let m=t.get(h);m!==void 0&&(t.delete(h),m.dispose())}function d(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:d}}function Pb(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Ho("WebGLRenderer: "+n+" extension not supported."),s}}}function Ib(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){c(m.target)}function c(m){m.index!==null&&e.remove(m.index);for(let g in m.attributes)e.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let y=r.get(m);y&&(e.remove(y),r.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function l(m,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function u(m){let y=m.attributes;for(let g in y)e.update(y[g],i.ARRAY_BUFFER)}function d(m){let y=m.index,g=m.attributes.position,p=0;if(g===void 0)return;let v=y!==null?y.array.length:g.array.length/3-1,A=g.count>=65535?jo:Ko,b=new A(Math.ceil(v/3)*6,1),R=b.array;if(y!==null){let _=y.array;p=y.version;for(let w=0,F=0;w<v;w+=3){let L=_[w+0],I=_[w+1],O=_[w+2];R[F++]=L,R[F++]=I,R[F++]=I,R[F++]=O,R[F++]=O,R[F++]=L}}else{p=g.version;for(let _=0,w=0;_<v;_+=3){let F=_+0,L=_+1,I=_+2;R[w++]=F,R[w++]=L,R[w++]=L,R[w++]=I,R[w++]=I,R[w++]=F}}b.version=p;let T=r.get(m);T&&e.remove(T),r.set(m,b)}function f(m){let y=r.get(m);if(y){let g=m.index;g!==null&&y.version<g.version&&d(m)}else d(m);return r.get(m)}function h(){for(let m in s){let y=s[m].deref();y!==void 0&&c(y)}}return{get:l,update:u,getWireframeAttribute:f,dispose:h}}function Lb(i,e,t){let n;function s(d){n=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function c(d,f){i.drawElements(n,f,r,d*o),t.update(f,n,1)}function l(d,f,h){h!==0&&(i.drawElementsInstanced(n,f,r,d*o,h),t.update(f,n,h))}function u(d,f,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,d,0,h);let y=0;for(let g=0;g<h;g++)y+=f[g];t.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=u}function Db(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:Qe("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function Nb(i,e,t){let n=new WeakMap,s=new Ht;function r(o,a,c){let l=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=u!==void 0?u.length:0,f=n.get(a);if(f===void 0||f.count!==d){let F=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",F)};f!==void 0&&f.texture.dispose();let h=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],A=0;h===!0&&(A=1),m===!0&&(A=2),y===!0&&(A=3);let b=a.attributes.position.count*A,R=1;b>e.maxTextureSize&&(R=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let T=new Float32Array(b*R*4*d),_=new $o(T,b,R,d);_.type=Ii,_.needsUpdate=!0;let w=A*4;for(let L=0;L<d;L++){let I=g[L],O=p[L],k=v[L],D=b*R*4*L;for(let G=0;G<I.count;G++){let Y=G*w;h===!0&&(s.fromBufferAttribute(I,G),T[D+Y+0]=s.x,T[D+Y+1]=s.y,T[D+Y+2]=s.z,T[D+Y+3]=0),m===!0&&(s.fromBufferAttribute(O,G),T[D+Y+4]=s.x,T[D+Y+5]=s.y,T[D+Y+6]=s.z,T[D+Y+7]=0),y===!0&&(s.fromBufferAttribute(k,G),T[D+Y+8]=s.x,T[D+Y+9]=s.y,T[D+Y+10]=s.z,T[D+Y+11]=k.itemSize===4?s.w:1)}}f={count:d,texture:_,size:new _t(b,R)},n.set(a,f),a.addEventListener("dispose",F)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let h=0;for(let y=0;y<l.length;y++)h+=l[y];let m=a.morphTargetsRelative?1:1-h;c.getUniforms().setValue(i,"morphTargetBaseInfluence",m),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",f.texture,t),c.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function Fb(i,e,t,n,s){let r=new WeakMap;function o(l){let u=s.render.frame,d=l.geometry,f=e.get(l,d);if(r.get(f)!==u&&(e.update(f),r.set(f,u)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==u&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),r.set(l,u))),l.isSkinnedMesh){let h=l.skeleton;r.get(h)!==u&&(h.update(),r.set(h,u))}return f}function a(){r=new WeakMap}function c(l){let u=l.target;u.removeEventListener("dispose",c),n.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var Ub={[Rh]:"LINEAR_TONE_MAPPING",[Ch]:"REINHARD_TONE_MAPPING",[Ph]:"CINEON_TONE_MAPPING",[Ih]:"ACES_FILMIC_TONE_MAPPING",[Dh]:"AGX_TONE_MAPPING",[Nh]:"NEUTRAL_TONE_MAPPING",[Lh]:"CUSTOM_TONE_MAPPING"};function Ob(i,e,t,n,s,r){let o=new oi(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,u=new Rn;u.setAttribute("position",new Qt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Qt([0,2,0,0,2,0],2));let d=new Ul({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new Ut(u,d),h=new eo(-1,1,1,-1,0,1),m=null,y=null,g=!1,p,v=null,A=[],b=!1;this.setSize=function(R,T){o.setSize(R,T),a!==null&&a.setSize(R,T),c!==null&&c.setSize(R,T);for(let _=0;_<A.length;_++){let w=A[_];w.setSize&&w.setSize(R,T)}},this.setEffects=function(R){A=R,b=A.length>0&&A[0].isRenderPass===!0;let T=o.width,_=o.height;A.length>0&&a===null&&(a=new oi(T,_,{type:Li,depthBuffer:!1,stencilBuffer:!1}),c=new oi(T,_,{type:Li,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&A.some(F=>F.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&l===null&&(l=new ms(T,_),r===!0&&(l.format=_s,l.type=lr)),o.dispose(),o.depthTexture=w?l:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let F=0;F<A.length;F++){let L=A[F];L.setSize&&L.setSize(T,_),w&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(l)}},this.begin=function(R,T){if(g||R.toneMapping===Ki&&A.length===0)return!1;if(v=T,T!==null){let _=T.width,w=T.height;(o.width!==_||o.height!==w)&&this.setSize(_,w)}return b===!1&&R.setRenderTarget(o),p=R.toneMapping,R.toneMapping=Ki,!0},this.hasRenderPass=function(){return b},this.end=function(R,T){R.toneMapping=p,g=!0;let _=o,w=a;for(let F=0;F<A.length;F++){let L=A[F];L.enabled!==!1&&(L.render(R,w,_,T),L.needsSwap!==!1&&(_=w,w=w===a?c:a))}if(m!==R.outputColorSpace||y!==R.toneMapping){m=R.outputColorSpace,y=R.toneMapping,d.defines={},pt.getTransfer(m)===wt&&(d.defines.SRGB_TRANSFER="");let F=Ub[y];F&&(d.defines[F]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=_.texture,R.setRenderTarget(v),R.render(f,h),v=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),u.dispose(),d.dispose()}}var Lm=new Kn,Dm=new ms(1,1),Nm=new ia(1),Fm=new $o,Um=new Ll,Om=new na,hm=[],fm=[],dm=new Float32Array(16),pm=new Float32Array(9),mm=new Float32Array(4);function lo(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=hm[s];if(r===void 0&&(r=new Float32Array(s),hm[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function xn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function vn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function zc(i,e){let t=fm[e];t===void 0&&(t=new Int32Array(e),fm[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function Bb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function kb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(xn(t,e))return;i.uniform2fv(this.addr,e),vn(t,e)}}function zb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(xn(t,e))return;i.uniform3fv(this.addr,e),vn(t,e)}}function Vb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(xn(t,e))return;i.uniform4fv(this.addr,e),vn(t,e)}}function Hb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(xn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),vn(t,e)}else{if(xn(t,n))return;mm.set(n),i.uniformMatrix2fv(this.addr,!1,mm),vn(t,n)}}function Gb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(xn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),vn(t,e)}else{if(xn(t,n))return;pm.set(n),i.uniformMatrix3fv(this.addr,!1,pm),vn(t,n)}}function Wb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(xn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),vn(t,e)}else{if(xn(t,n))return;dm.set(n),i.uniformMatrix4fv(this.addr,!1,dm),vn(t,n)}}function Xb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function qb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(xn(t,e))return;i.uniform2iv(this.addr,e),vn(t,e)}}function Yb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(xn(t,e))return;i.uniform3iv(this.addr,e),vn(t,e)}}function $b(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(xn(t,e))return;i.uniform4iv(this.addr,e),vn(t,e)}}function Zb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function Jb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(xn(t,e))return;i.uniform2uiv(this.addr,e),vn(t,e)}}function Kb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(xn(t,e))return;i.uniform3uiv(this.addr,e),vn(t,e)}}function jb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(xn(t,e))return;i.uniform4uiv(this.addr,e),vn(t,e)}}function Vc(i){return i.version===0&&(i.compareFunction=Zh,i.needsUpdate=!0),i}function Qb(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Vc(Dm):r=Lm,t.setTexture2D(e||r,s)}function eS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Um,s)}function tS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Vc(Nm):r=Om,t.setTextureCube(e||r,s)}function nS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Fm,s)}function iS(i){switch(i){case 5126:return Bb;case 35664:return kb;case 35665:return zb;case 35666:return Vb;case 35674:return Hb;case 35675:return Gb;case 35676:return Wb;case 5124:case 35670:return Xb;case 35667:case 35671:return qb;case 35668:case 35672:return Yb;case 35669:case 35673:return $b;case 5125:return Zb;case 36294:return Jb;case 36295:return Kb;case 36296:return jb;case 35678:case 36198:case 36298:case 36306:case 35682:return Qb;case 35679:case 36299:case 36307:return eS;case 35680:case 36300:case 36308:case 36293:return tS;case 36289:case 36303:case 36311:case 36292:return nS}}function sS(i,e){i.uniform1fv(this.addr,e)}function rS(i,e){let t=lo(e,this.size,2);i.uniform2fv(this.addr,t)}function oS(i,e){let t=lo(e,this.size,3);i.uniform3fv(this.addr,t)}function aS(i,e){let t=lo(e,this.size,4);i.uniform4fv(this.addr,t)}function lS(i,e){let t=lo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function cS(i,e){let t=lo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function uS(i,e){let t=lo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function hS(i,e){i.uniform1iv(this.addr,e)}function fS(i,e){i.uniform2iv(this.addr,e)}function dS(i,e){i.uniform3iv(this.addr,e)}function pS(i,e){i.uniform4iv(this.addr,e)}function mS(i,e){i.uniform1uiv(this.addr,e)}function gS(i,e){i.uniform2uiv(this.addr,e)}function _S(i,e){i.uniform3uiv(this.addr,e)}function xS(i,e){i.uniform4uiv(this.addr,e)}function vS(i,e,t){let n=this.cache,s=e.length,r=zc(t,s);xn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Vc(Dm):o=Lm;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function yS(i,e,t){let n=this.cache,s=e.length,r=zc(t,s);xn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Um,r[o])}function bS(i,e,t){let n=this.cache,s=e.length,r=zc(t,s);xn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Vc(Nm):o=Om;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function SS(i,e,t){let n=this.cache,s=e.length,r=zc(t,s);xn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Fm,r[o])}function MS(i){switch(i){case 5126:return sS;case 35664:return rS;case 35665:return oS;case 35666:return aS;case 35674:return lS;case 35675:return cS;case 35676:return uS;case 5124:case 35670:return hS;case 35667:case 35671:return fS;case 35668:case 35672:return dS;case 35669:case 35673:return pS;case 5125:return mS;case 36294:return gS;case 36295:return _S;case 36296:return xS;case 35678:case 36198:case 36298:case 36306:case 35682:return vS;case 35679:case 36299:case 36307:return yS;case 35680:case 36300:case 36308:case 36293:return bS;case 36289:case 36303:case 36311:case 36292:return SS}}var af=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=iS(t.type)}},lf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=MS(t.type)}},cf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},rf=/(\w+)(\])?(\[|\.)?/g;function gm(i,e){i.seq.push(e),i.map[e.id]=e}function wS(i,e,t){let n=i.name,s=n.length;for(rf.lastIndex=0;;){let r=rf.exec(n),o=rf.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){gm(t,l===void 0?new af(a,i,e):new lf(a,i,e));break}else{let d=t.map[a];d===void 0&&(d=new cf(a),gm(t,d)),t=d}}}var ao=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),c=e.getUniformLocation(t,a.name);wS(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],c=n[a.id];c.needsUpdate!==!1&&a.setValue(e,c.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function _m(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var ES=37297,TS=0;function AS(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var xm=new et;function RS(i){pt._getMatrix(xm,pt.workingColorSpace,i);let e=`mat3( ${xm.elements.map(t=>t.toFixed(4))} )`;switch(pt.getTransfer(i)){case Xo:return[e,"LinearTransferOETF"];case wt:return[e,"sRGBTransferOETF"];default:return Ye("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function vm(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+AS(i.getShaderSource(e),a)}else return r}function CS(i,e){let t=RS(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var PS={[Rh]:"Linear",[Ch]:"Reinhard",[Ph]:"Cineon",[Ih]:"ACESFilmic",[Dh]:"AgX",[Nh]:"Neutral",[Lh]:"Custom"};function IS(i,e){let t=PS[e];return t===void 0?(Ye("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Oc=new X;function LS(){pt.getLuminanceCoefficients(Oc);let i=Oc.x.toFixed(4),e=Oc.y.toFixed(4),t=Oc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function DS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(va).join(`
`)}function NS(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function FS(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function va(i){return i!==""}function ym(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function bm(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var US=/^[ \t]*#include +<([\w\d./]+)>/gm;function uf(i){return i.replace(US,OS)}function OS(i,e){let t=lt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return uf(t)}var BS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Sm(i){return i.replace(BS,kS)}function kS(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Mm(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var zS={[la]:"SHADOWMAP_TYPE_PCF",[io]:"SHADOWMAP_TYPE_VSM"};function VS(i){return zS[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var HS={[ro]:"ENVMAP_MODE_REFRACTION"};function GS(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":HS[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var WS={[Ah]:"ENVMAP_BLENDING_MULTIPLY",[Vp]:"ENVMAP_BLENDING_MIX",[Hp]:"ENVMAP_BLENDING_ADD"};function XS(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":WS[i.combine]||"ENVMAP_BLENDING_NONE"}function qS(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,c=VS(t),l=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=GS(t),d=XS(t),f=DS(t),h=NS(r),m=s.createProgram(),y,g,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,h].filter(va).join(`
`),y.length>0&&(y+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,h].filter(va).join(`
`),g.length>0&&(g+=`
`)):(y=[Mm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,h,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(va).join(`
`),g=[Mm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,h,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+l:"",t.envMap?"#define "+u:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Ki?"#define TONE_MAPPING":"",t.toneMapping!==Ki?lt.tonemapping_pars_fragment:"",t.toneMapping!==Ki?IS("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",lt.colorspace_pars_fragment,CS("linearToOutputTexel",t.outputColorSpace),LS(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(va).join(`
`)),o=uf(o),o=ym(o,t),o=bm(o,t),a=uf(a),a=ym(a,t),a=bm(a,t),o=Sm(o),a=Sm(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,y=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,g=["#define varying in",t.glslVersion===Kh?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Kh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let v=p+y+o,A=p+g+a,b=_m(s,s.VERTEX_SHADER,v),R=_m(s,s.FRAGMENT_SHADER,A);s.attachShader(m,b),s.attachShader(m,R),t.index0AttributeName!==void 0?s.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function T(L){if(i.debug.checkShaderErrors){let I=s.getProgramInfoLog(m)||"",O=s.getShaderInfoLog(b)||"",k=s.getShaderInfoLog(R)||"",D=I.trim(),G=O.trim(),Y=k.trim(),H=!0,le=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,m,b,R);else{let J=vm(s,b,"vertex"),Q=vm(s,R,"fragment");Qe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+D+`
`+J+`
`+Q)}else D!==""?Ye("WebGLProgram: Program Info Log:",D):(G===""||Y==="")&&(le=!1);le&&(L.diagnostics={runnable:H,programLog:D,vertexShader:{log:G,prefix:y},fragmentShader:{log:Y,prefix:g}})}s.deleteShader(b),s.deleteShader(R),_=new ao(s,m),w=FS(s,m)}let _;this.getUniforms=function(){return _===void 0&&T(this),_};let w;this.getAttributes=function(){return w===void 0&&T(this),w};let F=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return F===!1&&(F=s.getProgramParameter(m,ES)),F},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=TS++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=b,this.fragmentShader=R,this}var YS=0,hf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new ff(e),t.set(e,n)),n}},ff=class{constructor(e){this.id=YS++,this.code=e,this.usedTimes=0}};function $S(i){return i===Ws||i===pa||i===ma}function ZS(i,e,t,n,s,r){let o=new Zo,a=new hf,c=new Set,l=[],u=new Map,d=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function h(_){return c.add(_),_===0?"uv":`uv${_}`}function m(_,w,F,L,I,O){let k=L.fog,D=I.geometry,G=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?L.environment:null,Y=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,H=e.get(_.envMap||G,Y),le=f[_.type],J=n.precision;_.precision!==null&&(J=n.getMaxPrecision(_.precision),J!==_.precision&&Ye("WebGLProgram.getParameters:",_.precision,"not supported, using",J,"instead."));let Q=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,ie=Q!==void 0?Q.length:0,fe=0;D.morphAttributes.position!==void 0&&(fe=1),D.morphAttributes.normal!==void 0&&(fe=2),D.morphAttributes.color!==void 0&&(fe=3);let he,ee,me,ge;if(le){let Re=Qi[le];he=Re.vertexShader,ee=Re.fragmentShader}else{he=_.vertexShader,ee=_.fragmentShader;let Re=a.getVertexShaderStage(_),st=a.getFragmentShaderStage(_);a.update(_,Re,st),me=Re.id,ge=st.id}let Me=i.getRenderTarget(),ve=i.state.buffers.depth.getReversed(),He=I.isInstancedMesh===!0,Ze=I.isBatchedMesh===!0,Oe=!!_.map,ct=!!_.matcap,ot=!!H,tt=ot&&H.isPMREMTexture===!0,Wt=!!_.aoMap,Ft=!!_.lightMap,rn=!!_.bumpMap&&_.wireframe===!1,Pt=!!_.normalMap,Sn=!!_.displacementMap,xt=!!_.emissiveMap,gn=!!_.metalnessMap,$t=!!_.roughnessMap,on=_.anisotropy>0,B=_.clearcoat>0,Ce=_.diffuseRoughness>0,qe=_.dispersion>0,it=_.retroreflectivity>0,we=_.iridescence>0,Lt=_.sheen>0,Ve=_.transmission>0,Xe=on&&!!_.anisotropyMap,C=B&&!!_.clearcoatMap,S=B&&!!_.clearcoatNormalMap,q=B&&!!_.clearcoatRoughnessMap,ue=Ce&&!!_.diffuseRoughnessMap,oe=we&&!!_.iridescenceMap,xe=we&&!!_.iridescenceThicknessMap,ye=Lt&&!!_.sheenColorMap,te=Lt&&!!_.sheenRoughnessMap,se=!!_.specularMap,pe=!!_.specularColorMap,U=!!_.specularIntensityMap,re=Ve&&!!_.transmissionMap,ne=Ve&&!!_.thicknessMap,Ee=!!_.gradientMap,_e=!!_.alphaMap,Se=_.alphaTest>0,Ge=!!_.alphaHash,Je=!!_.extensions,ce=Ki;_.toneMapped&&(Me===null||Me.isXRRenderTarget===!0)&&(ce=i.toneMapping);let Be=tt?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,Ke={shaderID:le,shaderType:_.type,shaderName:_.name,vertexShader:he,fragmentShader:ee,defines:_.defines,customVertexShaderID:me,customFragmentShaderID:ge,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:J,batching:Ze,batchingColor:Ze&&I._colorsTexture!==null,instancing:He,instancingColor:He&&I.instanceColor!==null,instancingMorph:He&&I.morphTexture!==null,outputColorSpace:Me===null?i.outputColorSpace:Me.isXRRenderTarget===!0?Me.texture.colorSpace:pt.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Oe,matcap:ct,envMap:ot,envMapMode:ot&&H.mapping,envMapPMREM:tt,envMapMaxLod:tt?Be.length-1:null,envMapSize:tt?Be[0].width:null,aoMap:Wt,lightMap:Ft,bumpMap:rn,normalMap:Pt,displacementMap:Sn,emissiveMap:xt,normalMapObjectSpace:Pt&&_.normalMapType===Xp,normalMapTangentSpace:Pt&&_.normalMapType===Gh,packedNormalMap:Pt&&_.normalMapType===Gh&&$S(_.normalMap.format),metalnessMap:gn,roughnessMap:$t,anisotropy:on,anisotropyMap:Xe,clearcoat:B,clearcoatMap:C,clearcoatNormalMap:S,clearcoatRoughnessMap:q,diffuseRoughness:Ce,diffuseRoughnessMap:ue,dispersion:qe,retroreflection:it,iridescence:we,iridescenceMap:oe,iridescenceThicknessMap:xe,sheen:Lt,sheenColorMap:ye,sheenRoughnessMap:te,specularMap:se,specularColorMap:pe,specularIntensityMap:U,transmission:Ve,transmissionMap:re,thicknessMap:ne,gradientMap:Ee,opaque:_.transparent===!1&&_.blending===so&&_.alphaToCoverage===!1,alphaMap:_e,alphaTest:Se,alphaHash:Ge,combine:_.combine,mapUv:Oe&&h(_.map.channel),aoMapUv:Wt&&h(_.aoMap.channel),lightMapUv:Ft&&h(_.lightMap.channel),bumpMapUv:rn&&h(_.bumpMap.channel),normalMapUv:Pt&&h(_.normalMap.channel),displacementMapUv:Sn&&h(_.displacementMap.channel),emissiveMapUv:xt&&h(_.emissiveMap.channel),metalnessMapUv:gn&&h(_.metalnessMap.channel),roughnessMapUv:$t&&h(_.roughnessMap.channel),anisotropyMapUv:Xe&&h(_.anisotropyMap.channel),clearcoatMapUv:C&&h(_.clearcoatMap.channel),clearcoatNormalMapUv:S&&h(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&h(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&h(_.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&h(_.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&h(_.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&h(_.sheenColorMap.channel),sheenRoughnessMapUv:te&&h(_.sheenRoughnessMap.channel),specularMapUv:se&&h(_.specularMap.channel),specularColorMapUv:pe&&h(_.specularColorMap.channel),specularIntensityMapUv:U&&h(_.specularIntensityMap.channel),transmissionMapUv:re&&h(_.transmissionMap.channel),thicknessMapUv:ne&&h(_.thicknessMap.channel),alphaMapUv:_e&&h(_.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Pt||on),vertexNormals:!!D.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!D.attributes.uv&&(Oe||_e),fog:!!k,useFog:_.fog===!0,fogExp2:!!k&&k.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||D.attributes.normal===void 0&&Pt===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:ve,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:fe,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:O.filter(Re=>Re.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&F.length>0,shadowMapType:i.shadowMap.type,toneMapping:ce,decodeVideoTexture:Oe&&_.map.isVideoTexture===!0&&pt.getTransfer(_.map.colorSpace)===wt,decodeVideoTextureEmissive:xt&&_.emissiveMap.isVideoTexture===!0&&pt.getTransfer(_.emissiveMap.colorSpace)===wt,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Nn,flipSided:_.side===Dn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Je&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Je&&_.extensions.multiDraw===!0||Ze)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Ke.vertexUv1s=c.has(1),Ke.vertexUv2s=c.has(2),Ke.vertexUv3s=c.has(3),c.clear(),Ke}function y(_){let w=[];if(_.shaderID?w.push(_.shaderID):(w.push(_.customVertexShaderID),w.push(_.customFragmentShaderID)),_.defines!==void 0)for(let F in _.defines)w.push(F),w.push(_.defines[F]);return _.isRawShaderMaterial===!1&&(g(w,_),p(w,_),w.push(i.outputColorSpace)),w.push(_.customProgramCacheKey),w.join()}function g(_,w){_.push(w.precision),_.push(w.outputColorSpace),_.push(w.envMapMode),_.push(w.envMapPMREM),_.push(w.envMapMaxLod),_.push(w.envMapSize),_.push(w.mapUv),_.push(w.alphaMapUv),_.push(w.lightMapUv),_.push(w.aoMapUv),_.push(w.bumpMapUv),_.push(w.normalMapUv),_.push(w.displacementMapUv),_.push(w.emissiveMapUv),_.push(w.metalnessMapUv),_.push(w.roughnessMapUv),_.push(w.anisotropyMapUv),_.push(w.clearcoatMapUv),_.push(w.clearcoatNormalMapUv),_.push(w.clearcoatRoughnessMapUv),_.push(w.diffuseRoughnessMapUv),_.push(w.iridescenceMapUv),_.push(w.iridescenceThicknessMapUv),_.push(w.sheenColorMapUv),_.push(w.sheenRoughnessMapUv),_.push(w.specularMapUv),_.push(w.specularColorMapUv),_.push(w.specularIntensityMapUv),_.push(w.transmissionMapUv),_.push(w.thicknessMapUv),_.push(w.combine),_.push(w.fogExp2),_.push(w.sizeAttenuation),_.push(w.morphTargetsCount),_.push(w.numSunLights),_.push(w.numDirLights),_.push(w.numPointLights),_.push(w.numSpotLights),_.push(w.numSpotLightMaps),_.push(w.numHemiLights),_.push(w.numRectAreaLights),_.push(w.numSunLightShadows),_.push(w.numDirLightShadows),_.push(w.numPointLightShadows),_.push(w.numSpotLightShadows),_.push(w.numSpotLightShadowsWithMaps),_.push(w.numLightProbes),_.push(w.numLightProbeGrids),_.push(w.shadowMapType),_.push(w.toneMapping),_.push(w.numClippingPlanes),_.push(w.numClipIntersection),_.push(w.depthPacking)}function p(_,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let w=f[_.type],F;if(w){let L=Qi[w];F=sm.clone(L.uniforms)}else F=_.uniforms;return F}function A(_,w){let F=u.get(w);return F!==void 0?++F.usedTimes:(F=new qS(i,w,_,s),l.push(F),u.set(w,F)),F}function b(_){if(--_.usedTimes===0){let w=l.indexOf(_);l[w]=l[l.length-1],l.pop(),u.delete(_.cacheKey),_.destroy()}}function R(_){a.remove(_)}function T(){a.dispose()}return{getParameters:m,getProgramCacheKey:y,getUniforms:v,acquireProgram:A,releaseProgram:b,releaseShaderCache:R,programs:l,dispose:T}}function JS(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,c){i.get(o)[a]=c}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function KS(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function wm(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Em(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(f){let h=0;return f.isInstancedMesh&&(h+=2),f.isSkinnedMesh&&(h+=1),h}function a(f,h,m,y,g,p){let v=i[e];return v===void 0?(v={id:f.id,object:f,geometry:h,material:m,materialVariant:o(f),groupOrder:y,renderOrder:f.renderOrder,z:g,group:p},i[e]=v):(v.id=f.id,v.object=f,v.geometry=h,v.material=m,v.materialVariant=o(f),v.groupOrder=y,v.renderOrder=f.renderOrder,v.z=g,v.group=p),e++,v}function c(f,h,m,y,g,p,v){v.reversedDepth===!0&&(g=-g);let A=a(f,h,m,y,g,p);m.transmission>0?n.push(A):m.transparent===!0?s.push(A):t.push(A)}function l(f,h,m,y,g,p){let v=a(f,h,m,y,g,p);m.transmission>0?n.unshift(v):m.transparent===!0?s.unshift(v):t.unshift(v)}function u(f,h){t.length>1&&t.sort(f||KS),n.length>1&&n.sort(h||wm),s.length>1&&s.sort(h||wm)}function d(){for(let f=e,h=i.length;f<h;f++){let m=i[f];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:c,unshift:l,finish:d,sort:u}}function jS(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new Em,i.set(n,[o])):s>=r.length?(o=new Em,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function QS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new X,color:new rt};break;case"SpotLight":t={position:new X,direction:new X,color:new rt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new X,color:new rt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new X,skyColor:new rt,groundColor:new rt};break;case"RectAreaLight":t={color:new rt,position:new X,halfWidth:new X,halfHeight:new X};break}return i[e.id]=t,t}}}function eM(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var tM=0;function nM(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function iM(i){let e=new QS,t=eM(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new X);let s=new X,r=new vt,o=new vt;function a(l){let u=0,d=0,f=0;for(let O=0;O<9;O++)n.probe[O].set(0,0,0);let h=0,m=0,y=0,g=0,p=0,v=0,A=0,b=0,R=0,T=0,_=0,w=0,F=0,L=0;l.sort(nM);for(let O=0,k=l.length;O<k;O++){let D=l[O],G=D.color,Y=D.intensity,H=D.distance,le=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Ws?le=D.shadow.map.texture:le=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)u+=G.r*Y,d+=G.g*Y,f+=G.b*Y;else if(D.isLightProbe){for(let J=0;J<9;J++)n.probe[J].addScaledVector(D.sh.coefficients[J],Y);L++}else if(D.isSunLight){let J=e.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,ie=t.get(D);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[m]=ie,n.sunShadowMap[m]=le;let fe=Q.getViewportCount();for(let he=0;he<fe;he++)n.sunShadowMatrix[y+he]=Q.getMatrix(he),n.sunShadowCascade[y+he]=Q._cascadeData[he];y+=fe,m++}n.sun[h]=J,h++}else if(D.isDirectionalLight){let J=e.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,ie=t.get(D);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,n.directionalShadow[g]=ie,n.directionalShadowMap[g]=le,n.directionalShadowMatrix[g]=D.shadow.matrix,R++}n.directional[g]=J,g++}else if(D.isSpotLight){let J=e.get(D);J.position.setFromMatrixPosition(D.matrixWorld),J.color.copy(G).multiplyScalar(Y),J.distance=H,J.coneCos=Math.cos(D.angle),J.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),J.decay=D.decay,n.spot[v]=J;let Q=D.shadow;if(D.map&&(n.spotLightMap[w]=D.map,w++,Q.updateMatrices(D),D.castShadow&&F++),n.spotLightMatrix[v]=Q.matrix,D.castShadow){let ie=t.get(D);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,n.spotShadow[v]=ie,n.spotShadowMap[v]=le,_++}v++}else if(D.isRectAreaLight){let J=e.get(D);J.color.copy(G).multiplyScalar(Y),J.halfWidth.set(D.width*.5,0,0),J.halfHeight.set(0,D.height*.5,0),n.rectArea[A]=J,A++}else if(D.isPointLight){let J=e.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),J.distance=D.distance,J.decay=D.decay,D.castShadow){let Q=D.shadow,ie=t.get(D);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,n.pointShadow[p]=ie,n.pointShadowMap[p]=le,n.pointShadowMatrix[p]=D.shadow.matrix,T++}n.point[p]=J,p++}else if(D.isHemisphereLight){let J=e.get(D);J.skyColor.copy(D.color).multiplyScalar(Y),J.groundColor.copy(D.groundColor).multiplyScalar(Y),n.hemi[b]=J,b++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Le.LTC_FLOAT_1,n.rectAreaLTC2=Le.LTC_FLOAT_2):(n.rectAreaLTC1=Le.LTC_HALF_1,n.rectAreaLTC2=Le.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=d,n.ambient[2]=f;let I=n.hash;(I.sunLength!==h||I.directionalLength!==g||I.pointLength!==p||I.spotLength!==v||I.rectAreaLength!==A||I.hemiLength!==b||I.numSunShadows!==m||I.numDirectionalShadows!==R||I.numPointShadows!==T||I.numSpotShadows!==_||I.numSpotMaps!==w||I.numLightProbes!==L)&&(n.sun.length=h,n.directional.length=g,n.spot.length=v,n.rectArea.length=A,n.point.length=p,n.hemi.length=b,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=T,n.pointShadowMap.length=T,n.pointShadowMatrix.length=T,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+w-F,n.spotLightMap.length=w,n.numSpotLightShadowsWithMaps=F,n.numLightProbes=L,I.sunLength=h,I.directionalLength=g,I.pointLength=p,I.spotLength=v,I.rectAreaLength=A,I.hemiLength=b,I.numSunShadows=m,I.numDirectionalShadows=R,I.numPointShadows=T,I.numSpotShadows=_,I.numSpotMaps=w,I.numLightProbes=L,n.version=tM++)}function c(l,u){let d=0,f=0,h=0,m=0,y=0,g=0,p=u.matrixWorldInverse;for(let v=0,A=l.length;v<A;v++){let b=l[v];if(b.isSunLight){let R=n.sun[d];R.direction.setFromMatrixPosition(b.matrixWorld),R.direction.transformDirection(p),d++}else if(b.isDirectionalLight){let R=n.directional[f];R.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),f++}else if(b.isSpotLight){let R=n.spot[m];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(p),R.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),m++}else if(b.isRectAreaLight){let R=n.rectArea[y];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(p),o.identity(),r.copy(b.matrixWorld),r.premultiply(p),o.extractRotation(r),R.halfWidth.set(b.width*.5,0,0),R.halfHeight.set(0,b.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),y++}else if(b.isPointLight){let R=n.point[h];R.position.setFromMatrixPosition(b.matrixWorld),R.position.applyMatrix4(p),h++}else if(b.isHemisphereLight){let R=n.hemi[g];R.direction.setFromMatrixPosition(b.matrixWorld),R.direction.transformDirection(p),g++}}}return{setup:a,setupView:c,state:n}}function Tm(i){let e=new iM(i),t=[],n=[],s=[];function r(d){u.camera=d,t.length=0,n.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):t.push(d)}function a(d){n.push(d)}function c(){e.setup(t),s.sort((d,f)=>d.priority-f.priority||d.id-f.id)}function l(d){e.setupView(t,d)}let u={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function sM(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Tm(i),e.set(s,[a])):r>=o.length?(a=new Tm(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var rM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,oM=`uniform sampler2D shadow_pass;
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
}`,aM=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],lM=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],Am=new vt,xa=new X,of=new X;function cM(i,e,t){let n=new ps,s=new _t,r=new _t,o=new Ht,a=new Ol,c=new Bl,l={},u=t.maxTextureSize,d={[yi]:Dn,[Dn]:yi,[Nn]:Nn},f=new vi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new _t},radius:{value:4}},vertexShader:rM,fragmentShader:oM}),h=f.clone();h.defines.HORIZONTAL_PASS=1;let m=new Rn;m.setAttribute("position",new qt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Ut(m,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=la;let p=this.type;this.render=function(T,_,w){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||T.length===0)return;this.type===Sp&&(Ye("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=la);let F=i.getRenderTarget(),L=i.getActiveCubeFace(),I=i.getActiveMipmapLevel(),O=i.state;O.setBlending(rr),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let k=p!==this.type;k&&_.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(G=>G.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,G=T.length;D<G;D++){let Y=T[D],H=Y.shadow;if(H===void 0){Ye("WebGLShadowMap:",Y,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let le=H.getFrameExtents();s.multiply(le),r.copy(H.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,H.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,H.mapSize.y=r.y));let J=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=J,H.map===null||k===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===io){if(Y.isPointLight){Ye("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new oi(s.x,s.y,{format:Ws,type:Li,minFilter:Ln,magFilter:Ln,generateMipmaps:!1}),H.map.texture.name=Y.name+".shadowMap",H.map.depthTexture=new ms(s.x,s.y,Ii),H.map.depthTexture.name=Y.name+".shadowMapDepth",H.map.depthTexture.format=ds,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=fn,H.map.depthTexture.magFilter=fn}else Y.isPointLight?(H.map=new ya(s.x),H.map.depthTexture=new ia(s.x,Pi)):(H.map=new oi(s.x,s.y),H.map.depthTexture=new ms(s.x,s.y,Pi)),H.map.depthTexture.name=Y.name+".shadowMap",H.map.depthTexture.format=ds,this.type===la?(H.map.depthTexture.compareFunction=J?$h:Yh,H.map.depthTexture.minFilter=Ln,H.map.depthTexture.magFilter=Ln):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=fn,H.map.depthTexture.magFilter=fn);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();Y.isPointLight!==!0&&H.updateMatrices(Y,w);let ie=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:w.layers;for(let fe=0;fe<Q;fe++){let he=H.getCamera(fe);if(Y.isPointLight){let ee=H.camera,me=H.matrix,ge=Y.distance||ee.far;ge!==ee.far&&(ee.far=ge,ee.updateProjectionMatrix()),xa.setFromMatrixPosition(Y.matrixWorld),ee.position.copy(xa),of.copy(ee.position),of.add(aM[fe]),ee.up.copy(lM[fe]),ee.lookAt(of),ee.updateMatrixWorld(),me.makeTranslation(-xa.x,-xa.y,-xa.z),Am.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Am,ee.coordinateSystem,ee.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,fe),i.clear();else{fe===0&&(i.setRenderTarget(H.map),i.clear());let ee=H.getViewport(fe);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),O.viewport(o)}n=H.getFrustum(fe),b(_,w,he,Y,ie,this.type)}H.isPointLightShadow!==!0&&this.type===io&&v(H,w),H.needsUpdate=!1}p=this.type,g.needsUpdate=!1,i.setRenderTarget(F,L,I)};function v(T,_){let w=e.update(y);f.defines.VSM_SAMPLES!==T.blurSamples&&(f.defines.VSM_SAMPLES=T.blurSamples,h.defines.VSM_SAMPLES=T.blurSamples,f.needsUpdate=!0,h.needsUpdate=!0),T.mapPass===null?T.mapPass=new oi(s.x,s.y,{format:Ws,type:Li}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),f.uniforms.shadow_pass.value=T.map.depthTexture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,i.setRenderTarget(T.mapPass),i.clear(),i.renderBufferDirect(_,null,w,f,y,null),h.uniforms.shadow_pass.value=T.mapPass.texture,h.uniforms.resolution.value.set(T.map.width,T.map.height),h.uniforms.radius.value=T.radius,i.setRenderTarget(T.map),i.clear(),i.renderBufferDirect(_,null,w,h,y,null)}function A(T,_,w,F){let L=null,I=w.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(I!==void 0)L=I;else if(L=w.isPointLight===!0?c:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let O=L.uuid,k=_.uuid,D=l[O];D===void 0&&(D={},l[O]=D);let G=D[k];G===void 0&&(G=L.clone(),D[k]=G,_.addEventListener("dispose",R)),L=G}if(L.visible=_.visible,L.wireframe=_.wireframe,F===io?L.side=_.shadowSide!==null?_.shadowSide:_.side:L.side=_.shadowSide!==null?_.shadowSide:d[_.side],L.alphaMap=_.alphaMap,L.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,L.map=_.map,L.clipShadows=_.clipShadows,L.clippingPlanes=_.clippingPlanes,L.clipIntersection=_.clipIntersection,L.displacementMap=_.displacementMap,L.displacementScale=_.displacementScale,L.displacementBias=_.displacementBias,L.wireframeLinewidth=_.wireframeLinewidth,L.linewidth=_.linewidth,w.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let O=i.properties.get(L);O.light=w}return L}function b(T,_,w,F,L,I){if(T.visible===!1)return;if(T.layers.test(L)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&I===io)&&(!T.frustumCulled||T.intersectsFrustum(n))){T.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,T.matrixWorld);let D=e.update(T),G=T.material;if(Array.isArray(G)){let Y=D.groups;for(let H=0,le=Y.length;H<le;H++){let J=Y[H],Q=G[J.materialIndex];if(Q&&Q.visible){let ie=A(T,Q,F,I);T.onBeforeShadow(i,T,_,w,D,ie,J),i.renderBufferDirect(w,null,D,ie,T,J),T.onAfterShadow(i,T,_,w,D,ie,J)}}}else if(G.visible){let Y=A(T,G,F,I);T.onBeforeShadow(i,T,_,w,D,Y,null),i.renderBufferDirect(w,null,D,Y,T,null),T.onAfterShadow(i,T,_,w,D,Y,null)}}let k=T.children;for(let D=0,G=k.length;D<G;D++)b(k[D],_,w,F,L,I)}function R(T){T.target.removeEventListener("dispose",R);for(let w in l){let F=l[w],L=T.target.uuid;L in F&&(F[L].dispose(),delete F[L])}}}function uM(i,e){function t(){let U=!1,re=new Ht,ne=null,Ee=new Ht(0,0,0,0);return{setMask:function(_e){ne!==_e&&!U&&(i.colorMask(_e,_e,_e,_e),ne=_e)},setLocked:function(_e){U=_e},setClear:function(_e,Se,Ge,Je,ce){ce===!0&&(_e*=Je,Se*=Je,Ge*=Je),re.set(_e,Se,Ge,Je),Ee.equals(re)===!1&&(i.clearColor(_e,Se,Ge,Je),Ee.copy(re))},reset:function(){U=!1,ne=null,Ee.set(-1,0,0,0)}}}function n(){let U=!1,re=!1,ne=null,Ee=null,_e=null;return{setReversed:function(Se){if(re!==Se){let Ge=e.get("EXT_clip_control");Se?Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.ZERO_TO_ONE_EXT):Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.NEGATIVE_ONE_TO_ONE_EXT),re=Se;let Je=_e;_e=null,this.setClear(Je)}},getReversed:function(){return re},setTest:function(Se){Se?ve(i.DEPTH_TEST):He(i.DEPTH_TEST)},setMask:function(Se){ne!==Se&&!U&&(i.depthMask(Se),ne=Se)},setFunc:function(Se){if(re&&(Se=tm[Se]),Ee!==Se){switch(Se){case yl:i.depthFunc(i.NEVER);break;case bl:i.depthFunc(i.ALWAYS);break;case Sl:i.depthFunc(i.LESS);break;case Wr:i.depthFunc(i.LEQUAL);break;case Ml:i.depthFunc(i.EQUAL);break;case wl:i.depthFunc(i.GEQUAL);break;case Xr:i.depthFunc(i.GREATER);break;case El:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ee=Se}},setLocked:function(Se){U=Se},setClear:function(Se){_e!==Se&&(_e=Se,re&&(Se=1-Se),i.clearDepth(Se))},reset:function(){U=!1,ne=null,Ee=null,_e=null,re=!1}}}function s(){let U=!1,re=null,ne=null,Ee=null,_e=null,Se=null,Ge=null,Je=null,ce=null;return{setTest:function(Be){U||(Be?ve(i.STENCIL_TEST):He(i.STENCIL_TEST))},setMask:function(Be){re!==Be&&!U&&(i.stencilMask(Be),re=Be)},setFunc:function(Be,Ke,Re){(ne!==Be||Ee!==Ke||_e!==Re)&&(i.stencilFunc(Be,Ke,Re),ne=Be,Ee=Ke,_e=Re)},setOp:function(Be,Ke,Re){(Se!==Be||Ge!==Ke||Je!==Re)&&(i.stencilOp(Be,Ke,Re),Se=Be,Ge=Ke,Je=Re)},setLocked:function(Be){U=Be},setClear:function(Be){ce!==Be&&(i.clearStencil(Be),ce=Be)},reset:function(){U=!1,re=null,ne=null,Ee=null,_e=null,Se=null,Ge=null,Je=null,ce=null}}}let r=new t,o=new n,a=new s,c={},l=new WeakMap,u={},d={},f={},h=new WeakMap,m=[],y=null,g=!1,p=null,v=null,A=null,b=null,R=null,T=null,_=null,w=new rt(0,0,0),F=0,L=!1,I=null,O=null,k=null,D=null,G=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,le=0,J=i.getParameter(i.VERSION);J.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(J)[1]),H=le>=1):J.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),H=le>=2);let Q=null,ie={},fe=i.getParameter(i.SCISSOR_BOX),he=i.getParameter(i.VIEWPORT),ee=new Ht().fromArray(fe),me=new Ht().fromArray(he);function ge(U,re,ne,Ee){let _e=new Uint8Array(4),Se=i.createTexture();i.bindTexture(U,Se),i.texParameteri(U,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(U,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ge=0;Ge<ne;Ge++)U===i.TEXTURE_3D||U===i.TEXTURE_2D_ARRAY?i.texImage3D(re,0,i.RGBA,1,1,Ee,0,i.RGBA,i.UNSIGNED_BYTE,_e):i.texImage2D(re+Ge,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,_e);return Se}let Me={};Me[i.TEXTURE_2D]=ge(i.TEXTURE_2D,i.TEXTURE_2D,1),Me[i.TEXTURE_CUBE_MAP]=ge(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Me[i.TEXTURE_2D_ARRAY]=ge(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Me[i.TEXTURE_3D]=ge(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ve(i.DEPTH_TEST),o.setFunc(Wr),rn(!1),Pt(bh),ve(i.CULL_FACE),Wt(rr);function ve(U){u[U]!==!0&&(i.enable(U),u[U]=!0)}function He(U){u[U]!==!1&&(i.disable(U),u[U]=!1)}function Ze(U,re){return f[U]!==re?(i.bindFramebuffer(U,re),f[U]=re,U===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=re),U===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=re),!0):!1}function Oe(U,re){let ne=m,Ee=!1;if(U){ne=h.get(re),ne===void 0&&(ne=[],h.set(re,ne));let _e=U.textures;if(ne.length!==_e.length||ne[0]!==i.COLOR_ATTACHMENT0){for(let Se=0,Ge=_e.length;Se<Ge;Se++)ne[Se]=i.COLOR_ATTACHMENT0+Se;ne.length=_e.length,Ee=!0}}else ne[0]!==i.BACK&&(ne[0]=i.BACK,Ee=!0);Ee&&i.drawBuffers(ne)}function ct(U){return y!==U?(i.useProgram(U),y=U,!0):!1}let ot={[or]:i.FUNC_ADD,[wp]:i.FUNC_SUBTRACT,[Ep]:i.FUNC_REVERSE_SUBTRACT};ot[Tp]=i.MIN,ot[Ap]=i.MAX;let tt={[Rp]:i.ZERO,[Cp]:i.ONE,[Pp]:i.SRC_COLOR,[Eh]:i.SRC_ALPHA,[Up]:i.SRC_ALPHA_SATURATE,[Np]:i.DST_COLOR,[Lp]:i.DST_ALPHA,[Ip]:i.ONE_MINUS_SRC_COLOR,[Th]:i.ONE_MINUS_SRC_ALPHA,[Fp]:i.ONE_MINUS_DST_COLOR,[Dp]:i.ONE_MINUS_DST_ALPHA,[Op]:i.CONSTANT_COLOR,[Bp]:i.ONE_MINUS_CONSTANT_COLOR,[kp]:i.CONSTANT_ALPHA,[zp]:i.ONE_MINUS_CONSTANT_ALPHA};function Wt(U,re,ne,Ee,_e,Se,Ge,Je,ce,Be){if(U===rr){g===!0&&(He(i.BLEND),g=!1);return}if(g===!1&&(ve(i.BLEND),g=!0),U!==Mp){if(U!==p||Be!==L){if((v!==or||R!==or)&&(i.blendEquation(i.FUNC_ADD),v=or,R=or),Be)switch(U){case so:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Sh:i.blendFunc(i.ONE,i.ONE);break;case Mh:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case wh:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Qe("WebGLState: Invalid blending: ",U);break}else switch(U){case so:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Sh:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Mh:Qe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case wh:Qe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qe("WebGLState: Invalid blending: ",U);break}A=null,b=null,T=null,_=null,w.set(0,0,0),F=0,p=U,L=Be}return}_e=_e||re,Se=Se||ne,Ge=Ge||Ee,(re!==v||_e!==R)&&(i.blendEquationSeparate(ot[re],ot[_e]),v=re,R=_e),(ne!==A||Ee!==b||Se!==T||Ge!==_)&&(i.blendFuncSeparate(tt[ne],tt[Ee],tt[Se],tt[Ge]),A=ne,b=Ee,T=Se,_=Ge),(Je.equals(w)===!1||ce!==F)&&(i.blendColor(Je.r,Je.g,Je.b,ce),w.copy(Je),F=ce),p=U,L=!1}function Ft(U,re){U.side===Nn?He(i.CULL_FACE):ve(i.CULL_FACE);let ne=U.side===Dn;re&&(ne=!ne),rn(ne),U.blending===so&&U.transparent===!1?Wt(rr):Wt(U.blending,U.blendEquation,U.blendSrc,U.blendDst,U.blendEquationAlpha,U.blendSrcAlpha,U.blendDstAlpha,U.blendColor,U.blendAlpha,U.premultipliedAlpha),o.setFunc(U.depthFunc),o.setTest(U.depthTest),o.setMask(U.depthWrite),r.setMask(U.colorWrite);let Ee=U.stencilWrite;a.setTest(Ee),Ee&&(a.setMask(U.stencilWriteMask),a.setFunc(U.stencilFunc,U.stencilRef,U.stencilFuncMask),a.setOp(U.stencilFail,U.stencilZFail,U.stencilZPass)),xt(U.polygonOffset,U.polygonOffsetFactor,U.polygonOffsetUnits),U.alphaToCoverage===!0?ve(i.SAMPLE_ALPHA_TO_COVERAGE):He(i.SAMPLE_ALPHA_TO_COVERAGE)}function rn(U){I!==U&&(U?i.frontFace(i.CW):i.frontFace(i.CCW),I=U)}function Pt(U){U!==yp?(ve(i.CULL_FACE),U!==O&&(U===bh?i.cullFace(i.BACK):U===bp?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):He(i.CULL_FACE),O=U}function Sn(U){U!==k&&(H&&i.lineWidth(U),k=U)}function xt(U,re,ne){U?(ve(i.POLYGON_OFFSET_FILL),(D!==re||G!==ne)&&(D=re,G=ne,o.getReversed()&&(re=-re,ne=-ne),i.polygonOffset(re,ne))):He(i.POLYGON_OFFSET_FILL)}function gn(U){U?ve(i.SCISSOR_TEST):He(i.SCISSOR_TEST)}function $t(U){U===void 0&&(U=i.TEXTURE0+Y-1),Q!==U&&(i.activeTexture(U),Q=U)}function on(U,re,ne){ne===void 0&&(Q===null?ne=i.TEXTURE0+Y-1:ne=Q);let Ee=ie[ne];Ee===void 0&&(Ee={type:void 0,texture:void 0},ie[ne]=Ee),(Ee.type!==U||Ee.texture!==re)&&(Q!==ne&&(i.activeTexture(ne),Q=ne),i.bindTexture(U,re||Me[U]),Ee.type=U,Ee.texture=re)}function B(){let U=ie[Q];U!==void 0&&U.type!==void 0&&(i.bindTexture(U.type,null),U.type=void 0,U.texture=void 0)}function Ce(){try{i.compressedTexImage2D(...arguments)}catch(U){Qe("WebGLState:",U)}}function qe(){try{i.compressedTexImage3D(...arguments)}catch(U){Qe("WebGLState:",U)}}function it(){try{i.texSubImage2D(...arguments)}catch(U){Qe("WebGLState:",U)}}function we(){try{i.texSubImage3D(...arguments)}catch(U){Qe("WebGLState:",U)}}function Lt(){try{i.compressedTexSubImage2D(...arguments)}catch(U){Qe("WebGLState:",U)}}function Ve(){try{i.compressedTexSubImage3D(...arguments)}catch(U){Qe("WebGLState:",U)}}function Xe(){try{i.texStorage2D(...arguments)}catch(U){Qe("WebGLState:",U)}}function C(){try{i.texStorage3D(...arguments)}catch(U){Qe("WebGLState:",U)}}function S(){try{i.texImage2D(...arguments)}catch(U){Qe("WebGLState:",U)}}function q(){try{i.texImage3D(...arguments)}catch(U){Qe("WebGLState:",U)}}function ue(U){return d[U]!==void 0?d[U]:i.getParameter(U)}function oe(U,re){d[U]!==re&&(i.pixelStorei(U,re),d[U]=re)}function xe(U){ee.equals(U)===!1&&(i.scissor(U.x,U.y,U.z,U.w),ee.copy(U))}function ye(U){me.equals(U)===!1&&(i.viewport(U.x,U.y,U.z,U.w),me.copy(U))}function te(U,re){let ne=l.get(re);ne===void 0&&(ne=new WeakMap,l.set(re,ne));let Ee=ne.get(U);Ee===void 0&&(Ee=i.getUniformBlockIndex(re,U.name),i.uniformBlockBinding(re,Ee,Ee),ne.set(U,Ee))}function se(U,re,ne){let _e=l.get(re).get(U);c[_e]!==ne&&(i.bindBufferBase(i.UNIFORM_BUFFER,_e,ne),c[_e]=ne)}function pe(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},d={},Q=null,ie={},f={},c={},h=new WeakMap,m=[],y=null,g=!1,p=null,v=null,A=null,b=null,R=null,T=null,_=null,w=new rt(0,0,0),F=0,L=!1,I=null,O=null,k=null,D=null,G=null,ee.set(0,0,i.canvas.width,i.canvas.height),me.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ve,disable:He,bindFramebuffer:Ze,drawBuffers:Oe,useProgram:ct,setBlending:Wt,setMaterial:Ft,setFlipSided:rn,setCullFace:Pt,setLineWidth:Sn,setPolygonOffset:xt,setScissorTest:gn,activeTexture:$t,bindTexture:on,unbindTexture:B,compressedTexImage2D:Ce,compressedTexImage3D:qe,texImage2D:S,texImage3D:q,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:Xe,texStorage3D:C,texSubImage2D:it,texSubImage3D:we,compressedTexSubImage2D:Lt,compressedTexSubImage3D:Ve,scissor:xe,viewport:ye,reset:pe}}function hM(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new _t,u=new WeakMap,d=new Set,f,h=new WeakMap,m=new Set,y=new FinalizationRegistry(C=>m.delete(C)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(C,S){return g?new OffscreenCanvas(C,S):Yo("canvas")}function v(C,S,q){let ue=1,oe=Xe(C);if((oe.width>q||oe.height>q)&&(ue=q/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let xe=Math.floor(ue*oe.width),ye=Math.floor(ue*oe.height);f===void 0&&(f=p(xe,ye));let te=S?p(xe,ye):f;return te.width=xe,te.height=ye,te.getContext("2d").drawImage(C,0,0,xe,ye),Ye("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+xe+"x"+ye+")."),te}else return"data"in C&&Ye("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),C;return C}function A(C){return C.generateMipmaps}function b(C){i.generateMipmap(C)}function R(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function T(C,S,q,ue,oe,xe=!1){if(C!==null){if(i[C]!==void 0)return i[C];Ye("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||Ye("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=S;if(S===i.RED&&(q===i.FLOAT&&(te=i.R32F),q===i.HALF_FLOAT&&(te=i.R16F),q===i.UNSIGNED_BYTE&&(te=i.R8),q===i.UNSIGNED_SHORT&&ye&&(te=ye.R16_EXT),q===i.SHORT&&ye&&(te=ye.R16_SNORM_EXT)),S===i.RED_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.R8UI),q===i.UNSIGNED_SHORT&&(te=i.R16UI),q===i.UNSIGNED_INT&&(te=i.R32UI),q===i.BYTE&&(te=i.R8I),q===i.SHORT&&(te=i.R16I),q===i.INT&&(te=i.R32I)),S===i.RG&&(q===i.FLOAT&&(te=i.RG32F),q===i.HALF_FLOAT&&(te=i.RG16F),q===i.UNSIGNED_BYTE&&(te=i.RG8),q===i.UNSIGNED_SHORT&&ye&&(te=ye.RG16_EXT),q===i.SHORT&&ye&&(te=ye.RG16_SNORM_EXT)),S===i.RG_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.RG8UI),q===i.UNSIGNED_SHORT&&(te=i.RG16UI),q===i.UNSIGNED_INT&&(te=i.RG32UI),q===i.BYTE&&(te=i.RG8I),q===i.SHORT&&(te=i.RG16I),q===i.INT&&(te=i.RG32I)),S===i.RGB_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.RGB8UI),q===i.UNSIGNED_SHORT&&(te=i.RGB16UI),q===i.UNSIGNED_INT&&(te=i.RGB32UI),q===i.BYTE&&(te=i.RGB8I),q===i.SHORT&&(te=i.RGB16I),q===i.INT&&(te=i.RGB32I)),S===i.RGBA_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),q===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),q===i.UNSIGNED_INT&&(te=i.RGBA32UI),q===i.BYTE&&(te=i.RGBA8I),q===i.SHORT&&(te=i.RGBA16I),q===i.INT&&(te=i.RGBA32I)),S===i.RGB&&(q===i.UNSIGNED_SHORT&&ye&&(te=ye.RGB16_EXT),q===i.SHORT&&ye&&(te=ye.RGB16_SNORM_EXT),q===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),q===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),S===i.RGBA){let se=xe?Xo:pt.getTransfer(oe);q===i.FLOAT&&(te=i.RGBA32F),q===i.HALF_FLOAT&&(te=i.RGBA16F),q===i.UNSIGNED_BYTE&&(te=se===wt?i.SRGB8_ALPHA8:i.RGBA8),q===i.UNSIGNED_SHORT&&ye&&(te=ye.RGBA16_EXT),q===i.SHORT&&ye&&(te=ye.RGBA16_SNORM_EXT),q===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),q===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function _(C,S){let q;return C?S===null||S===Pi||S===lr?q=i.DEPTH24_STENCIL8:S===Ii?q=i.DEPTH32F_STENCIL8:S===oo&&(q=i.DEPTH24_STENCIL8,Ye("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Pi||S===lr?q=i.DEPTH_COMPONENT24:S===Ii?q=i.DEPTH_COMPONENT32F:S===oo&&(q=i.DEPTH_COMPONENT16),q}function w(C,S){return A(C)===!0||C.isFramebufferTexture&&C.minFilter!==fn&&C.minFilter!==Ln?Math.log2(Math.max(S.width,S.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?S.mipmaps.length:1}function F(C){let S=new WeakRef(C);n.get(C).__ref=S,m.add(S),y.register(C,S,S)}function L(C){let S=n.get(C).__ref;S!==void 0&&(m.delete(S),y.unregister(S))}function I(C){k(C.target)}function O(C){D(C.target)}function k(C){C.removeEventListener("dispose",I),L(C),Y(C),C.isVideoTexture&&u.delete(C),C.isHTMLTexture&&d.delete(C)}function D(C){C.removeEventListener("dispose",O),L(C),le(C)}function G(){for(let C of m){let S=C.deref();S!==void 0&&(S.isRenderTarget===!0?D(S):k(S))}m.clear(),d.clear()}function Y(C){let S=n.get(C);if(S.__webglInit===void 0)return;let q=C.source,ue=h.get(q);if(ue){let oe=ue[S.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&H(C),Object.keys(ue).length===0&&h.delete(q)}n.remove(C)}function H(C){let S=n.get(C);i.deleteTexture(S.__webglTexture);let q=C.source,ue=h.get(q);delete ue[S.__cacheKey],o.memory.textures--}function le(C){let S=n.get(C);S.__depthDisposeCallback&&S.__depthDisposeCallback();let q=C.depthTexture;if(q&&q.renderTarget===C&&k(q),C.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(S.__webglFramebuffer[oe]))for(let xe=0;xe<S.__webglFramebuffer[oe].length;xe++)i.deleteFramebuffer(S.__webglFramebuffer[oe][xe]);else i.deleteFramebuffer(S.__webglFramebuffer[oe]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[oe])}else{if(Array.isArray(S.__webglFramebuffer))for(let oe=0;oe<S.__webglFramebuffer.length;oe++)i.deleteFramebuffer(S.__webglFramebuffer[oe]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let oe=0;oe<S.__webglColorRenderbuffer.length;oe++)S.__webglColorRenderbuffer[oe]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[oe]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ue=C.textures;for(let oe=0,xe=ue.length;oe<xe;oe++){let ye=n.get(ue[oe]);ye.__webglTexture&&(i.deleteTexture(ye.__webglTexture),o.memory.textures--),n.remove(ue[oe])}n.remove(C)}let J=0;function Q(){J=0}function ie(){return J}function fe(C){J=C}function he(){let C=J;return C>=s.maxTextures&&Ye("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,C}function ee(C){let S=[];return S.push(C.wrapS),S.push(C.wrapT),S.push(C.wrapR||0),S.push(C.magFilter),S.push(C.minFilter),S.push(C.anisotropy),S.push(C.internalFormat),S.push(C.format),S.push(C.type),S.push(C.generateMipmaps),S.push(C.mipmapsAutoUpdate),S.push(C.premultiplyAlpha),S.push(C.flipY),S.push(C.unpackAlignment),S.push(C.colorSpace),S.join()}function me(C,S){let q=n.get(C);if(C.isVideoTexture&&Lt(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&q.__version!==C.version){let ue=C.image;if(ue===null)Ye("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Ye("WebGLRenderer: Texture marked for update but image is incomplete");else{Ft(q,C,S);return}}else C.isExternalTexture&&(q.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,q.__webglTexture,i.TEXTURE0+S)}function ge(C,S){let q=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&q.__version!==C.version){Ft(q,C,S);return}else C.isExternalTexture&&(q.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,q.__webglTexture,i.TEXTURE0+S)}function Me(C,S){let q=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&q.__version!==C.version){Ft(q,C,S);return}t.bindTexture(i.TEXTURE_3D,q.__webglTexture,i.TEXTURE0+S)}function ve(C,S){let q=n.get(C);if(C.version>0&&q.__version!==C.version){rn(q,C,S);return}t.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture,i.TEXTURE0+S)}let He={[Tl]:i.REPEAT,[$i]:i.CLAMP_TO_EDGE,[Al]:i.MIRRORED_REPEAT},Ze={[fn]:i.NEAREST,[Gp]:i.NEAREST_MIPMAP_NEAREST,[ca]:i.NEAREST_MIPMAP_LINEAR,[Ln]:i.LINEAR,[jl]:i.LINEAR_MIPMAP_NEAREST,[gs]:i.LINEAR_MIPMAP_LINEAR},Oe={[qp]:i.NEVER,[Zh]:i.ALWAYS,[Yp]:i.LESS,[Yh]:i.LEQUAL,[$p]:i.EQUAL,[$h]:i.GEQUAL,[Zp]:i.GREATER,[Jp]:i.NOTEQUAL};function ct(C,S){if(S.type===Ii&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===Ln||S.magFilter===jl||S.magFilter===ca||S.magFilter===gs||S.minFilter===Ln||S.minFilter===jl||S.minFilter===ca||S.minFilter===gs)&&Ye("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,He[S.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,He[S.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,He[S.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,Ze[S.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,Ze[S.minFilter]),S.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,Oe[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===fn||S.minFilter!==ca&&S.minFilter!==gs||S.type===Ii&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");i.texParameterf(C,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function ot(C,S){let q=!1;C.__webglInit===void 0&&(C.__webglInit=!0,S.addEventListener("dispose",I),F(S));let ue=S.source,oe=h.get(ue);oe===void 0&&(oe={},h.set(ue,oe));let xe=ee(S);if(xe!==C.__cacheKey){oe[xe]===void 0&&(oe[xe]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[xe].usedTimes++;let ye=oe[C.__cacheKey];ye!==void 0&&(oe[C.__cacheKey].usedTimes--,ye.usedTimes===0&&H(S)),C.__cacheKey=xe,C.__webglTexture=oe[xe].texture}return q}function tt(C,S,q){return Math.floor(Math.floor(C/q)/S)}function Wt(C,S,q,ue){let xe=C.updateRanges;if(xe.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,S.width,S.height,q,ue,S.data);else{xe.sort((U,re)=>U.start-re.start);let ye=0;for(let U=1;U<xe.length;U++){let re=xe[ye],ne=xe[U],Ee=re.start+re.count,_e=tt(ne.start,S.width,4),Se=tt(re.start,S.width,4);ne.start<=Ee+1&&_e===Se&&tt(ne.start+ne.count-1,S.width,4)===_e?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++ye,xe[ye]=ne)}xe.length=ye+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),se=t.getParameter(i.UNPACK_SKIP_PIXELS),pe=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,S.width);for(let U=0,re=xe.length;U<re;U++){let ne=xe[U],Ee=Math.floor(ne.start/4),_e=Math.ceil(ne.count/4),Se=Ee%S.width,Ge=Math.floor(Ee/S.width),Je=_e,ce=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ge),t.texSubImage2D(i.TEXTURE_2D,0,Se,Ge,Je,ce,q,ue,S.data)}C.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,se),t.pixelStorei(i.UNPACK_SKIP_ROWS,pe)}}function Ft(C,S,q){let ue=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ue=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ue=i.TEXTURE_3D);let oe=ot(C,S),xe=S.source;t.bindTexture(ue,C.__webglTexture,i.TEXTURE0+q);let ye=n.get(xe);if(xe.version!==ye.__version||oe===!0){if(t.activeTexture(i.TEXTURE0+q),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let ce=pt.getPrimaries(pt.workingColorSpace),Be=S.colorSpace===xs?null:pt.getPrimaries(S.colorSpace),Ke=S.colorSpace===xs||ce===Be?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ke)}t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment);let se=v(S.image,!1,s.maxTextureSize);se=Ve(S,se);let pe=r.convert(S.format,S.colorSpace),U=r.convert(S.type),re=T(S.internalFormat,pe,U,S.normalized,S.colorSpace,S.isVideoTexture);ct(ue,S);let ne,Ee=S.mipmaps,_e=S.isVideoTexture!==!0,Se=ye.__version===void 0||oe===!0,Ge=xe.dataReady,Je=w(S,se);if(S.isDepthTexture)re=_(S.format===_s,S.type),Se&&(_e?t.texStorage2D(i.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,pe,U,null));else if(S.isDataTexture)if(Ee.length>0){_e&&Se&&t.texStorage2D(i.TEXTURE_2D,Je,re,Ee[0].width,Ee[0].height);for(let ce=0,Be=Ee.length;ce<Be;ce++)ne=Ee[ce],_e?Ge&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,U,ne.data):t.texImage2D(i.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,U,ne.data);S.generateMipmaps=!1}else _e?(Se&&t.texStorage2D(i.TEXTURE_2D,Je,re,se.width,se.height),Ge&&Wt(S,se,pe,U)):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,pe,U,se.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){_e&&Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Je,re,Ee[0].width,Ee[0].height,se.depth);for(let ce=0,Be=Ee.length;ce<Be;ce++)if(ne=Ee[ce],S.format!==ui)if(pe!==null)if(_e){if(Ge)if(S.layerUpdates.size>0){let Ke=sf(ne.width,ne.height,S.format,S.type);for(let Re of S.layerUpdates){let st=ne.data.subarray(Re*Ke/ne.data.BYTES_PER_ELEMENT,(Re+1)*Ke/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,Re,ne.width,ne.height,1,pe,st)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,ne.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,ne.data,0,0);else Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?Ge&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,U,ne.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,pe,U,ne.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{_e&&Se&&t.texStorage2D(i.TEXTURE_2D,Je,re,Ee[0].width,Ee[0].height);for(let ce=0,Be=Ee.length;ce<Be;ce++)ne=Ee[ce],S.format!==ui?pe!==null?_e?Ge&&t.compressedTexSubImage2D(i.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(i.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?Ge&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,U,ne.data):t.texImage2D(i.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,U,ne.data)}else if(S.isDataArrayTexture)if(_e){if(Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Je,re,se.width,se.height,se.depth),Ge)if(S.layerUpdates.size>0){let ce=sf(se.width,se.height,S.format,S.type);for(let Be of S.layerUpdates){let Ke=se.data.subarray(Be*ce/se.data.BYTES_PER_ELEMENT,(Be+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Be,se.width,se.height,1,pe,U,Ke)}S.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,pe,U,se.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,pe,U,se.data);else if(S.isData3DTexture)_e?(Se&&t.texStorage3D(i.TEXTURE_3D,Je,re,se.width,se.height,se.depth),Ge&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,pe,U,se.data)):t.texImage3D(i.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,pe,U,se.data);else if(S.isFramebufferTexture){if(Se)if(_e)t.texStorage2D(i.TEXTURE_2D,Je,re,se.width,se.height);else{let ce=se.width,Be=se.height;for(let Ke=0;Ke<Je;Ke++)t.texImage2D(i.TEXTURE_2D,Ke,re,ce,Be,0,pe,U,null),ce>>=1,Be>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in i){let ce=i.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),d.add(S),ce.onpaint=Be=>{let Ke=Be.changedElements;for(let Re of d)Ke.includes(Re.image)&&(Re.needsUpdate=!0)},ce.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,se);else{let Ke=i.RGBA,Re=i.RGBA,st=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Ke,Re,st,se)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Ee.length>0){if(_e&&Se){let ce=Xe(Ee[0]);t.texStorage2D(i.TEXTURE_2D,Je,re,ce.width,ce.height)}for(let ce=0,Be=Ee.length;ce<Be;ce++)ne=Ee[ce],_e?Ge&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,pe,U,ne):t.texImage2D(i.TEXTURE_2D,ce,re,pe,U,ne);S.generateMipmaps=!1}else if(_e){if(Se){let ce=Xe(se);t.texStorage2D(i.TEXTURE_2D,Je,re,ce.width,ce.height)}Ge&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,pe,U,se)}else t.texImage2D(i.TEXTURE_2D,0,re,pe,U,se);A(S)&&S.mipmapsAutoUpdate===!0&&b(ue),ye.__version=xe.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function rn(C,S,q){if(S.image.length!==6)return;let ue=ot(C,S),oe=S.source;t.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+q);let xe=n.get(oe);if(oe.version!==xe.__version||ue===!0){t.activeTexture(i.TEXTURE0+q);let ye=pt.getPrimaries(pt.workingColorSpace),te=S.colorSpace===xs?null:pt.getPrimaries(S.colorSpace),se=S.colorSpace===xs||ye===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let pe=S.isCompressedTexture||S.image[0].isCompressedTexture,U=S.image[0]&&S.image[0].isDataTexture,re=[];for(let Re=0;Re<6;Re++)!pe&&!U?re[Re]=v(S.image[Re],!0,s.maxCubemapSize):re[Re]=U?S.image[Re].image:S.image[Re],re[Re]=Ve(S,re[Re]);let ne=re[0],Ee=r.convert(S.format,S.colorSpace),_e=r.convert(S.type),Se=T(S.internalFormat,Ee,_e,S.normalized,S.colorSpace),Ge=S.isVideoTexture!==!0,Je=xe.__version===void 0||ue===!0,ce=oe.dataReady,Be=w(S,ne);ct(i.TEXTURE_CUBE_MAP,S);let Ke;if(S.isDepthTexture){if(Se=_(S.format===_s,S.type),Je)if(Ge)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Se,ne.width,ne.height);else for(let Re=0;Re<6;Re++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,ne.width,ne.height,0,Ee,_e,null)}else if(pe){Ge&&Je&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Be,Se,ne.width,ne.height);for(let Re=0;Re<6;Re++){Ke=re[Re].mipmaps;for(let st=0;st<Ke.length;st++){let Ot=Ke[st];S.format!==ui?Ee!==null?Ge?ce&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st,0,0,Ot.width,Ot.height,Ee,Ot.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st,Se,Ot.width,Ot.height,0,Ot.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ge?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st,0,0,Ot.width,Ot.height,Ee,_e,Ot.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st,Se,Ot.width,Ot.height,0,Ee,_e,Ot.data)}}}else{if(Ke=S.mipmaps,Ge&&Je){Ke.length>0&&Be++;let Re=Xe(re[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Be,Se,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(U){Ge?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,re[Re].width,re[Re].height,Ee,_e,re[Re].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,re[Re].width,re[Re].height,0,Ee,_e,re[Re].data);for(let st=0;st<Ke.length;st++){let Hn=Ke[st].image[Re].image;Ge?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st+1,0,0,Hn.width,Hn.height,Ee,_e,Hn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st+1,Se,Hn.width,Hn.height,0,Ee,_e,Hn.data)}}else{Ge?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,Ee,_e,re[Re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,Ee,_e,re[Re]);for(let st=0;st<Ke.length;st++){let Ot=Ke[st];Ge?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st+1,0,0,Ee,_e,Ot.image[Re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st+1,Se,Ee,_e,Ot.image[Re])}}}A(S)&&S.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),xe.__version=oe.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function Pt(C,S,q,ue,oe,xe){let ye=r.convert(q.format,q.colorSpace),te=r.convert(q.type),se=T(q.internalFormat,ye,te,q.normalized,q.colorSpace),pe=n.get(S),U=n.get(q);if(U.__renderTarget=S,!pe.__hasExternalTextures){let re=Math.max(1,S.width>>xe),ne=Math.max(1,S.height>>xe);oe===i.TEXTURE_3D||oe===i.TEXTURE_2D_ARRAY?t.texImage3D(oe,xe,se,re,ne,S.depth,0,ye,te,null):t.texImage2D(oe,xe,se,re,ne,0,ye,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,C),we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ue,oe,U.__webglTexture,0,it(S)):(oe===i.TEXTURE_2D||oe>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ue,oe,U.__webglTexture,xe),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Sn(C,S,q){if(i.bindRenderbuffer(i.RENDERBUFFER,C),S.depthBuffer){let ue=S.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,xe=_(S.stencilBuffer,oe),ye=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;we(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,it(S),xe,S.width,S.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,it(S),xe,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,xe,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ye,i.RENDERBUFFER,C)}else{let ue=S.textures;for(let oe=0;oe<ue.length;oe++){let xe=ue[oe],ye=r.convert(xe.format,xe.colorSpace),te=r.convert(xe.type),se=T(xe.internalFormat,ye,te,xe.normalized,xe.colorSpace);we(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,it(S),se,S.width,S.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,it(S),se,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,se,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xt(C,S,q){let ue=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,C),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=n.get(S.depthTexture);oe.__renderTarget=S;let xe=ue?S.depthTexture.image[0]:S.depthTexture.image;(!oe.__webglTexture||xe.width!==S.width||xe.height!==S.height)&&(xe.width=S.width,xe.height=S.height,S.depthTexture.needsUpdate=!0),ue?ve(S.depthTexture,0):me(S.depthTexture,0);let ye=oe.__webglTexture,te=it(S),se=ue?i.TEXTURE_CUBE_MAP_POSITIVE_X+q:i.TEXTURE_2D,pe=S.depthTexture.format===_s?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(S.depthTexture.format===ds)we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,se,ye,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,pe,se,ye,0);else if(S.depthTexture.format===_s)we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,se,ye,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,pe,se,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function gn(C){let S=n.get(C),q=C.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==C.depthTexture){let ue=C.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ue){let oe=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),S.__depthDisposeCallback=oe}S.__boundDepthTexture=ue}if(C.depthTexture&&!S.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)xt(S.__webglFramebuffer[ue],C,ue);else C.texture.mipmaps.length>0?xt(S.__webglFramebuffer[0],C,0):xt(S.__webglFramebuffer,C,0);else if(q){S.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[ue]),S.__webglDepthbuffer[ue]===void 0)S.__webglDepthbuffer[ue]=i.createRenderbuffer(),Sn(S.__webglDepthbuffer[ue],C,!1);else{let oe=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=S.__webglDepthbuffer[ue];i.bindRenderbuffer(i.RENDERBUFFER,xe),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,xe)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),Sn(S.__webglDepthbuffer,C,!1);else{let oe=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,xe),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,xe)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function $t(C,S,q){let ue=n.get(C);S!==void 0&&Pt(ue.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),q!==void 0&&gn(C)}function on(C){let S=C.texture,q=n.get(C),ue=n.get(S);C.addEventListener("dispose",O),F(C);let oe=C.textures,xe=C.isWebGLCubeRenderTarget===!0,ye=oe.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=i.createTexture()),ue.__version=S.version,o.memory.textures++),xe){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(S.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let se=0;se<S.mipmaps.length;se++)q.__webglFramebuffer[te][se]=i.createFramebuffer()}else q.__webglFramebuffer[te]=i.createFramebuffer()}else{if(S.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<S.mipmaps.length;te++)q.__webglFramebuffer[te]=i.createFramebuffer()}else q.__webglFramebuffer=i.createFramebuffer();if(ye)for(let te=0,se=oe.length;te<se;te++){let pe=n.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&we(C)===!1){q.__webglMultisampledFramebuffer=i.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let se=oe[te];q.__webglColorRenderbuffer[te]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let pe=r.convert(se.format,se.colorSpace),U=r.convert(se.type),re=T(se.internalFormat,pe,U,se.normalized,se.colorSpace,C.isXRRenderTarget===!0),ne=it(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,ne,re,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,q.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(q.__webglDepthRenderbuffer=i.createRenderbuffer(),Sn(q.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(xe){t.bindTexture(i.TEXTURE_CUBE_MAP,ue.__webglTexture),ct(i.TEXTURE_CUBE_MAP,S);for(let te=0;te<6;te++)if(S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)Pt(q.__webglFramebuffer[te][se],C,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else Pt(q.__webglFramebuffer[te],C,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);A(S)?b(i.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let te=0,se=oe.length;te<se;te++){let pe=oe[te],U=n.get(pe),re=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(re=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(re,U.__webglTexture),ct(re,pe),Pt(q.__webglFramebuffer,C,pe,i.COLOR_ATTACHMENT0+te,re,0),A(pe)&&b(re)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(te=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),ct(te,S),S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)Pt(q.__webglFramebuffer[se],C,S,i.COLOR_ATTACHMENT0,te,se);else Pt(q.__webglFramebuffer,C,S,i.COLOR_ATTACHMENT0,te,0);A(S)?b(te):S.mipmaps.length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&gn(C)}function B(C){let S=C.textures;for(let q=0,ue=S.length;q<ue;q++){let oe=S[q];if(A(oe)&&oe.mipmapsAutoUpdate===!0){let xe=R(C),ye=n.get(oe).__webglTexture;t.bindTexture(xe,ye),b(xe),t.unbindTexture()}}}let Ce=[];function qe(C){if(C.samples>0){if(we(C)===!1){let S=C.textures,q=C.width,ue=C.height,oe=i.COLOR_BUFFER_BIT,xe=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=n.get(C),te=S.length>1;if(te)for(let pe=0;pe<S.length;pe++)t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let pe=0;pe<S.length;pe++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(oe|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(oe|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let U=n.get(S[pe]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,U,0)}i.blitFramebuffer(0,0,q,ue,0,0,q,ue,oe,i.NEAREST),c===!0&&(Ce.length=0,Ce.push(i.COLOR_ATTACHMENT0+pe),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Ce.push(xe),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ce))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<S.length;pe++){t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let U=n.get(S[pe]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,U,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&c){let S=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function it(C){return Math.min(s.maxSamples,C.samples)}function we(C){let S=n.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Lt(C){let S=o.render.frame;u.get(C)!==S&&(u.set(C,S),C.update())}function Ve(C,S){let q=C.colorSpace,ue=C.format,oe=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||q!==Wo&&q!==xs&&(pt.getTransfer(q)===wt?(ue!==ui||oe!==ci)&&Ye("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qe("WebGLTextures: Unsupported texture color space:",q)),S}function Xe(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(l.width=C.naturalWidth||C.width,l.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(l.width=C.displayWidth,l.height=C.displayHeight):(l.width=C.width,l.height=C.height),l}this.allocateTextureUnit=he,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=fe,this.setTexture2D=me,this.setTexture2DArray=ge,this.setTexture3D=Me,this.setTextureCube=ve,this.rebindTextures=$t,this.setupRenderTarget=on,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=qe,this.setupDepthRenderbuffer=gn,this.setupFrameBufferTexture=Pt,this.useMultisampledRTT=we,this.dispose=G}function fM(i,e){function t(n,s=xs){let r,o=pt.getTransfer(s);if(n===ci)return i.UNSIGNED_BYTE;if(n===ec)return i.UNSIGNED_SHORT_4_4_4_4;if(n===tc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Bh)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===kh)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Uh)return i.BYTE;if(n===Oh)return i.SHORT;if(n===oo)return i.UNSIGNED_SHORT;if(n===Ql)return i.INT;if(n===Pi)return i.UNSIGNED_INT;if(n===Ii)return i.FLOAT;if(n===Li)return i.HALF_FLOAT;if(n===zh)return i.ALPHA;if(n===Vh)return i.RGB;if(n===ui)return i.RGBA;if(n===ds)return i.DEPTH_COMPONENT;if(n===_s)return i.DEPTH_STENCIL;if(n===Hh)return i.RED;if(n===nc)return i.RED_INTEGER;if(n===Ws)return i.RG;if(n===ic)return i.RG_INTEGER;if(n===sc)return i.RGBA_INTEGER;if(n===ua||n===ha||n===fa||n===da)if(o===wt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===ua)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ha)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===fa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===da)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===ua)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ha)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===fa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===da)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===rc||n===oc||n===ac||n===lc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===rc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===oc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===ac)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===lc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===cc||n===uc||n===hc||n===fc||n===dc||n===pa||n===pc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===cc||n===uc)return o===wt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===hc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===fc)return r.COMPRESSED_R11_EAC;if(n===dc)return r.COMPRESSED_SIGNED_R11_EAC;if(n===pa)return r.COMPRESSED_RG11_EAC;if(n===pc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===mc||n===gc||n===_c||n===xc||n===vc||n===yc||n===bc||n===Sc||n===Mc||n===wc||n===Ec||n===Tc||n===Ac||n===Rc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===mc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===gc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===_c)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===xc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===vc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===yc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===bc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Sc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Mc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===wc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Ec)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Tc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Ac)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Rc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Cc||n===Pc||n===Ic)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Cc)return o===wt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Pc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Ic)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Lc||n===Dc||n===ma||n===Nc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Lc)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Dc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===ma)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Nc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===lr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var dM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,pM=`
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

}`,df=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new sa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new vi({vertexShader:dM,fragmentShader:pM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ut(new sr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},pf=class extends Zi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,u=null,d=null,f=null,h=null,m=null,y=typeof XRWebGLBinding<"u",g=new df,p={},v=t.getContextAttributes(),A=null,b=null,R=[],T=[],_=new _t,w=null,F=null,L=new $n;L.viewport=new Ht;let I=new $n;I.viewport=new Ht;let O=[L,I],k=new Zl,D=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=R[ee];return me===void 0&&(me=new $r,R[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=R[ee];return me===void 0&&(me=new $r,R[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=R[ee];return me===void 0&&(me=new $r,R[ee]=me),me.getHandSpace()};function Y(ee){let me=T.indexOf(ee.inputSource);if(me===-1)return;let ge=R[me];ge!==void 0&&(ge.update(ee.inputSource,ee.frame,l||o),ge.dispatchEvent({type:ee.type,data:ee.inputSource}))}function H(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",le);for(let ee=0;ee<R.length;ee++){let me=T[ee];me!==null&&(T[ee]=null,R[ee].disconnect(me))}D=null,G=null,g.reset();for(let ee in p)delete p[ee];if(e.setRenderTarget(A),h=null,f=null,d=null,s=null,b=null,he.stop(),n.isPresenting=!1,e.setPixelRatio(w),e.setSize(_.width,_.height,!1),F!==null){let ee=F.camera;ee.fov=F.fov,ee.zoom=F.zoom,ee.updateProjectionMatrix(),F=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===!0&&Ye("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,n.isPresenting===!0&&Ye("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(ee){l=ee},this.getBaseLayer=function(){return f!==null?f:h},this.getBinding=function(){return d===null&&y&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",H),s.addEventListener("inputsourceschange",le),v.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,Me=null,ve=null;v.depth&&(ve=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=v.stencil?_s:ds,Me=v.stencil?lr:Pi);let He={colorFormat:t.RGBA8,depthFormat:ve,scaleFactor:r};d=this.getBinding(),f=d.createProjectionLayer(He),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),b=new oi(f.textureWidth,f.textureHeight,{format:ui,type:ci,depthTexture:new ms(f.textureWidth,f.textureHeight,Me,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let ge={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};h=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:h}),e.setPixelRatio(1),e.setSize(h.framebufferWidth,h.framebufferHeight,!1),b=new oi(h.framebufferWidth,h.framebufferHeight,{format:ui,type:ci,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function le(ee){for(let me=0;me<ee.removed.length;me++){let ge=ee.removed[me],Me=T.indexOf(ge);Me>=0&&(T[Me]=null,R[Me].disconnect(ge))}for(let me=0;me<ee.added.length;me++){let ge=ee.added[me],Me=T.indexOf(ge);if(Me===-1){for(let He=0;He<R.length;He++)if(He>=T.length){T.push(ge),Me=He;break}else if(T[He]===null){T[He]=ge,Me=He;break}if(Me===-1)break}let ve=R[Me];ve&&ve.connect(ge)}}function J(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ge=ee.far;g.texture!==null&&(g.depthNear>0&&(me=g.depthNear),g.depthFar>0&&(ge=g.depthFar)),k.near=I.near=L.near=me,k.far=I.far=L.far=ge,(D!==k.near||G!==k.far)&&(s.updateRenderState({depthNear:k.near,depthFar:k.far}),D=k.near,G=k.far),k.layers.mask=ee.layers.mask|6,L.layers.mask=k.layers.mask&-5,I.layers.mask=k.layers.mask&-3;let Me=ee.parent,ve=k.cameras;J(k,Me);for(let He=0;He<ve.length;He++)J(ve[He],Me);k.projectionMatrix.copy(L.projectionMatrix),k.projectionMatrixInverse.copy(L.projectionMatrixInverse),F===null&&ee.isPerspectiveCamera&&(F={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,k,Me)};function Q(ee,me,ge){ge===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ge.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Cl*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(f===null&&h===null))return c},this.setFoveation=function(ee){c=ee,f!==null&&(f.fixedFoveation=ee),h!==null&&h.fixedFoveation!==void 0&&(h.fixedFoveation=ee)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(k)},this.getCameraTexture=function(ee){return p[ee]};let ie=null;function fe(ee,me){if(u=me.getViewerPose(l||o),m=me,u!==null){let ge=u.views;h!==null&&(e.setRenderTargetFramebuffer(b,h.framebuffer),e.setRenderTarget(b));let Me=!1;ge.length!==k.cameras.length&&(k.cameras.length=0,Me=!0);for(let Oe=0;Oe<ge.length;Oe++){let ct=ge[Oe],ot=null;if(h!==null)ot=h.getViewport(ct);else{let Wt=d.getViewSubImage(f,ct);ot=Wt.viewport,Oe===0&&(e.setRenderTargetTextures(b,Wt.colorTexture,Wt.depthStencilTexture),e.setRenderTarget(b))}let tt=O[Oe];tt===void 0&&(tt=new $n,tt.layers.enable(Oe),tt.viewport=new Ht,O[Oe]=tt),tt.matrix.fromArray(ct.transform.matrix),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.projectionMatrix.fromArray(ct.projectionMatrix),tt.projectionMatrixInverse.copy(tt.projectionMatrix).invert(),tt.viewport.set(ot.x,ot.y,ot.width,ot.height),Oe===0&&(k.matrix.copy(tt.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),Me===!0&&k.cameras.push(tt)}let ve=s.enabledFeatures;if(ve&&ve.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){d=n.getBinding();let Oe=d.getDepthInformation(ge[0]);Oe&&Oe.isValid&&Oe.texture&&g.init(Oe,s.renderState)}if(ve&&ve.includes("camera-access")&&y){e.state.unbindTexture(),d=n.getBinding();for(let Oe=0;Oe<ge.length;Oe++){let ct=ge[Oe].camera;if(ct){let ot=p[ct];ot||(ot=new sa,p[ct]=ot);let tt=d.getCameraImage(ct);ot.sourceTexture=tt}}}}for(let ge=0;ge<R.length;ge++){let Me=T[ge],ve=R[ge];Me!==null&&ve!==void 0&&ve.update(Me,me,l||o)}ie&&ie(ee,me),me.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:me}),m=null}let he=new Rm;he.setAnimationLoop(fe),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},mM=new vt,Bm=new et;Bm.set(-1,0,0,0,1,0,0,0,1);function gM(i,e){function t(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function n(g,p){p.color.getRGB(g.fogColor.value,ef(i)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function s(g,p,v,A,b){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(g,p):p.isMeshLambertMaterial?(r(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(g,p),d(g,p)):p.isMeshPhongMaterial?(r(g,p),u(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(g,p),f(g,p),p.isMeshPhysicalMaterial&&h(g,p,b)):p.isMeshMatcapMaterial?(r(g,p),m(g,p)):p.isMeshDepthMaterial?r(g,p):p.isMeshDistanceMaterial?(r(g,p),y(g,p)):p.isMeshNormalMaterial?r(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?c(g,p,v,A):p.isSpriteMaterial?l(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,t(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,t(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===Dn&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,t(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===Dn&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,t(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,t(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let v=e.get(p),A=v.envMap,b=v.envMapRotation;A&&(g.envMap.value=A,g.envMapRotation.value.setFromMatrix4(mM.makeRotationFromEuler(b)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Bm),g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,t(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function c(g,p,v,A){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*v,g.scale.value=A*.5,p.map&&(g.map.value=p.map,t(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function l(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,t(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function u(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function d(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function f(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function h(g,p,v){g.ior.value=p.ior,p.diffuseRoughness>0&&(g.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Dn&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.retroreflectivity>0&&(g.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=v.texture,g.transmissionSamplerSize.value.set(v.width,v.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function y(g,p){let v=e.get(p).light;g.referencePosition.value.setFromMatrixPosition(v.matrixWorld),g.nearDistance.value=v.shadow.camera.near,g.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function _M(i,e,t,n){let s={},r={};function o(v,A){let b=A.program;n.uniformBlockBinding(v,b,s[v.id])}function a(v,A){let b=s[v.id];b===void 0&&(m(v),b=c(v),s[v.id]=b,v.addEventListener("dispose",g));let R=A.program;n.updateUBOMapping(v,R);let T=e.render.frame;r[v.id]!==T&&(l(v),r[v.id]=T)}function c(v){let A=i.createBuffer(),b=v.__size,R=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,b,R),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function l(v){let A=s[v.id],b=v.uniforms,R=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let T=0,_=b.length;T<_;T++){let w=b[T];if(Array.isArray(w))for(let F=0,L=w.length;F<L;F++)u(w[F],T,F,R);else u(w,T,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(v,A,b,R){if(f(v,A,b,R)===!0){let T=v.__offset,_=v.value;if(Array.isArray(_)){let w=0;for(let F=0;F<_.length;F++){let L=_[F],I=y(L,!0);d(L,v.__data,w),w+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else d(_,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,T,v.__data)}}function d(v,A,b){typeof v=="number"||typeof v=="boolean"?A[b]=v:v.isMatrix3?(A[b]=v.elements[0],A[b+1]=v.elements[1],A[b+2]=v.elements[2],A[b+3]=0,A[b+4]=v.elements[3],A[b+5]=v.elements[4],A[b+6]=v.elements[5],A[b+7]=0,A[b+8]=v.elements[6],A[b+9]=v.elements[7],A[b+10]=v.elements[8],A[b+11]=0):ArrayBuffer.isView(v)?A.set(v.subarray(0,A.length-b),b):v.toArray(A,b)}function f(v,A,b,R){let T=v.value,_=A+"_"+b;if(Array.isArray(T)){R[_]===void 0&&(R[_]=[]);let w=R[_],F=!1;for(let L=0;L<T.length;L++)h(T[L],w,L)===!0&&(F=!0);return F}return h(T,R,_)}function h(v,A,b){if(A[b]===void 0)return typeof v=="number"||typeof v=="boolean"?A[b]=v:ArrayBuffer.isView(v)?A[b]=v.slice():A[b]=v.clone(),!0;{let R=A[b];if(typeof v=="number"||typeof v=="boolean"){if(R!==v)return A[b]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(R.equals(v)===!1)return R.copy(v),!0}}return!1}function m(v){let A=v.uniforms,b=0,R=16;for(let _=0,w=A.length;_<w;_++){let F=Array.isArray(A[_])?A[_]:[A[_]];for(let L=0,I=F.length;L<I;L++){let O=F[L],k=Array.isArray(O.value)?O.value:[O.value],D=Array.isArray(A[_])||Array.isArray(O.value),G=b;for(let H=0,le=k.length;H<le;H++){let J=k[H],Q=y(J,D),ie=b%R,fe=ie%Q.boundary,he=ie+fe;b+=fe,he!==0&&R-he<Q.storage&&(b+=R-he),H===0&&(G=b),b+=Q.storage}let Y=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new Y((b-G)/Float32Array.BYTES_PER_ELEMENT),O.__offset=G}}let T=b%R;return T>0&&(b+=R-T),v.__size=b,v.__cache={},this}function y(v,A){let b={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(b.boundary=4,b.storage=4):v.isVector2?(b.boundary=8,b.storage=8):v.isVector3||v.isColor?(b.boundary=16,b.storage=12):v.isVector4?(b.boundary=16,b.storage=16):v.isMatrix3?(b.boundary=16,b.storage=48):v.isMatrix4?(b.boundary=16,b.storage=64):v.isTexture?Ye("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(b.boundary=16,b.storage=v.byteLength):Ye("WebGLRenderer: Unsupported uniform value type.",v),A===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(v){let A=v.target;A.removeEventListener("dispose",g),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function p(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:p}}var xM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ji=null;function vM(){return ji===null&&(ji=new Zr(xM,16,16,Ws,Li),ji.name="DFG_LUT",ji.minFilter=Ln,ji.magFilter=Ln,ji.wrapS=$i,ji.wrapT=$i,ji.generateMipmaps=!1,ji.needsUpdate=!0),ji}var kc=class{constructor(e={}){let{canvas:t=jp(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:f=!1,outputBufferType:h=ci}=e;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let y=h,g=new Set([sc,ic,nc]),p=new Set([ci,Pi,oo,lr,ec,tc]),v=new Uint32Array(4),A=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},R=null,T=null,_=[],w=[],F=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ki,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,I=!1,O=null,k=null,D=null,G=null;this._outputColorSpace=Yn;let Y=0,H=0,le=null,J=-1,Q=null,ie=new Ht,fe=new Ht,he=null,ee=new rt(0),me=0,ge=t.width,Me=t.height,ve=1,He=null,Ze=null,Oe=new Ht(0,0,ge,Me),ct=new Ht(0,0,ge,Me),ot=!1,tt=new ps,Wt=new Dl,Ft=!1,rn=!1,Pt=new vt,Sn=new X,xt=new Ht,gn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},$t=!1;function on(){return le===null?ve:1}let B=n;function Ce(E,z){return t.getContext(E,z)}let qe,it,we,Lt,Ve,Xe,C,S,q,ue,oe,xe,ye,te,se,pe,U,re,ne,Ee,_e,Se,Ge;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:u,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",Ke,!1),t.addEventListener("webglcontextcreationerror",Re,!1),B===null){let z="webgl2";if(B=Ce(z,E),B===null)throw Ce(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Je()}catch(E){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",Ke,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),Qe("WebGLRenderer: "+E.message),E}function Je(){qe=new Pb(B),qe.init(),_e=new fM(B,qe),it=new vb(B,qe,e,_e),we=new uM(B,qe),it.reversedDepthBuffer&&f&&we.buffers.depth.setReversed(!0),k=B.createFramebuffer(),D=B.createFramebuffer(),G=B.createFramebuffer(),Lt=new Db(B),Ve=new JS,Xe=new hM(B,qe,we,Ve,it,_e,Lt),C=new Cb(L),S=new Fx(B),Se=new _b(B,S),q=new Ib(B,S,Lt,Se),ue=new Fb(B,q,S,Se,Lt),re=new Nb(B,it,Xe),se=new yb(Ve),oe=new ZS(L,C,qe,it,Se,se),xe=new gM(L,Ve),ye=new jS,te=new sM(qe),U=new gb(L,C,we,ue,m,c),pe=new cM(L,ue,it),Ge=new _M(B,Lt,it,we),ne=new xb(B,qe,Lt),Ee=new Lb(B,qe,Lt),Lt.programs=oe.programs,L.capabilities=it,L.extensions=qe,L.properties=Ve,L.renderLists=ye,L.shadowMap=pe,L.state=we,L.info=Lt}y!==ci&&(F=new Ob(y,t.width,t.height,a,s,r));let ce=new pf(L,B);this.xr=ce,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let E=qe.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=qe.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return ve},this.setPixelRatio=function(E){E!==void 0&&(ve=E,this.setSize(ge,Me,!1))},this.getSize=function(E){return E.set(ge,Me)},this.setSize=function(E,z,j=!0){if(ce.isPresenting){Ye("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=E,Me=z,t.width=Math.floor(E*ve),t.height=Math.floor(z*ve),j===!0&&(t.style.width=E+"px",t.style.height=z+"px"),F!==null&&F.setSize(t.width,t.height),this.setViewport(0,0,E,z)},this.getDrawingBufferSize=function(E){return E.set(ge*ve,Me*ve).floor()},this.setDrawingBufferSize=function(E,z,j){ge=E,Me=z,ve=j,t.width=Math.floor(E*j),t.height=Math.floor(z*j),this.setViewport(0,0,E,z)},this.setEffects=function(E){if(y===ci){Qe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let z=0;z<E.length;z++)if(E[z].isOutputPass===!0){Ye("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}F.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(ie)},this.getViewport=function(E){return E.copy(Oe)},this.setViewport=function(E,z,j,$){E.isVector4?Oe.set(E.x,E.y,E.z,E.w):Oe.set(E,z,j,$),we.viewport(ie.copy(Oe).multiplyScalar(on()).round())},this.getScissor=function(E){return E.copy(ct)},this.setScissor=function(E,z,j,$){E.isVector4?ct.set(E.x,E.y,E.z,E.w):ct.set(E,z,j,$),we.scissor(fe.copy(ct).multiplyScalar(on()).round())},this.getScissorTest=function(){return ot},this.setScissorTest=function(E){we.setScissorTest(ot=E)},this.setOpaqueSort=function(E){He=E},this.setTransparentSort=function(E){Ze=E},this.getClearColor=function(E){return E.copy(U.getClearColor())},this.setClearColor=function(){U.setClearColor(...arguments)},this.getClearAlpha=function(){return U.getClearAlpha()},this.setClearAlpha=function(){U.setClearAlpha(...arguments)},this.clear=function(E=!0,z=!0,j=!0){let $=0;if(E){let Z=!1;if(le!==null){let Te=le.texture.format;Z=g.has(Te)}if(Z){let Te=le.texture.type,Pe=p.has(Te),Ae=U.getClearColor(),Ie=U.getClearAlpha(),ze=Ae.r,je=Ae.g,ut=Ae.b;Pe?(v[0]=ze,v[1]=je,v[2]=ut,v[3]=Ie,B.clearBufferuiv(B.COLOR,0,v)):(A[0]=ze,A[1]=je,A[2]=ut,A[3]=Ie,B.clearBufferiv(B.COLOR,0,A))}else $|=B.COLOR_BUFFER_BIT}z&&($|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&($|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&B.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),O=E},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",Ke,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),U.dispose(),ye.dispose(),te.dispose(),Xe.dispose(),Ve.dispose(),C.dispose(),ue.dispose(),q.dispose(),Se.dispose(),Ge.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",Ba),ce.removeEventListener("sessionend",zi),ns.stop()};function Be(E){E.preventDefault(),jh("WebGLRenderer: Context Lost."),I=!0}function Ke(){jh("WebGLRenderer: Context Restored."),I=!1;let E=Lt.autoReset,z=pe.enabled,j=pe.autoUpdate,$=pe.needsUpdate,Z=pe.type;Je(),Lt.autoReset=E,pe.enabled=z,pe.autoUpdate=j,pe.needsUpdate=$,pe.type=Z}function Re(E){Qe("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function st(E){let z=E.target;z.removeEventListener("dispose",st),Ot(z)}function Ot(E){Hn(E),Ve.remove(E)}function Hn(E){let z=Ve.get(E).programs;z!==void 0&&(z.forEach(function(j){oe.releaseProgram(j)}),E.isShaderMaterial&&oe.releaseShaderCache(E))}this.renderBufferDirect=function(E,z,j,$,Z,Te){z===null&&(z=gn);let Pe=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ae=Io(E,z,j,$,Z);we.setMaterial($,Pe);let Ie=j.index,ze=1;if($.wireframe===!0){if(Ie=q.getWireframeAttribute(j),Ie===void 0)return;ze=2}let je=j.drawRange,ut=j.attributes.position,ke=je.start*ze,ht=(je.start+je.count)*ze;Te!==null&&(ke=Math.max(ke,Te.start*ze),ht=Math.min(ht,(Te.start+Te.count)*ze)),Ie!==null?(ke=Math.max(ke,0),ht=Math.min(ht,Ie.count)):ut!=null&&(ke=Math.max(ke,0),ht=Math.min(ht,ut.count));let Yt=ht-ke;if(Yt<0||Yt===1/0)return;Se.setup(Z,$,Ae,j,Ie);let Tt,At=ne;if(Ie!==null&&(Tt=S.get(Ie),At=Ee,At.setIndex(Tt)),Z.isMesh)$.wireframe===!0?(we.setLineWidth($.wireframeLinewidth*on()),At.setMode(B.LINES)):At.setMode(B.TRIANGLES);else if(Z.isLine){let _n=$.linewidth;_n===void 0&&(_n=1),we.setLineWidth(_n*on()),Z.isLineSegments?At.setMode(B.LINES):Z.isLineLoop?At.setMode(B.LINE_LOOP):At.setMode(B.LINE_STRIP)}else Z.isPoints?At.setMode(B.POINTS):Z.isSprite&&At.setMode(B.TRIANGLES);if(Z.isBatchedMesh)if(qe.get("WEBGL_multi_draw"))At.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let _n=Z._multiDrawStarts,Fe=Z._multiDrawCounts,an=Z._multiDrawCount,dt=Ie?S.get(Ie).bytesPerElement:1,ss=Ve.get($).currentProgram.getUniforms();for(let ln=0;ln<an;ln++)ss.setValue(B,"_gl_DrawID",ln),At.render(_n[ln]/dt,Fe[ln])}else if(Z.isInstancedMesh)At.renderInstances(ke,Yt,Z.count);else if(j.isInstancedBufferGeometry){let _n=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Fe=Math.min(j.instanceCount,_n);At.renderInstances(ke,Yt,Fe)}else At.render(ke,Yt)};function Ro(E,z,j,$){O!==null&&E.isNodeMaterial&&O.setObject($,E),Ft===!0&&se.setState(E,j,!1),E.transparent===!0&&E.side===Nn&&E.forceSinglePass===!1?(E.side=Dn,E.needsUpdate=!0,Vi(E,z,$),E.side=yi,E.needsUpdate=!0,Vi(E,z,$),E.side=Nn):Vi(E,z,$)}this.compile=function(E,z,j=null){j===null&&(j=E),O!==null&&O.renderStart(E,z,j),T=te.get(j),T.init(z),w.push(T),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(T.pushLight(Z),Z.castShadow&&T.pushShadow(Z))}),E!==j&&E.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(T.pushLight(Z),Z.castShadow&&T.pushShadow(Z))}),T.setupLights(),O!==null&&O.updateLights(T.state.lightsArray),rn=this.localClippingEnabled,Ft=se.init(this.clippingPlanes,rn),Ft===!0&&se.setGlobalState(this.clippingPlanes,z),O!==null&&pe.render(T.state.shadowsArray,j,z);let $=new Set;return E.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Te=Z.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let Ae=Te[Pe];Ro(Ae,j,z,Z),$.add(Ae)}else Ro(Te,j,z,Z),$.add(Te)}),T=w.pop(),O!==null&&O.renderEnd(),$},this.compileAsync=function(E,z,j=null){let $=this.compile(E,z,j);return new Promise(Z=>{function Te(){if($.forEach(function(Pe){let Ie=Ve.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&$.delete(Pe)}),$.size===0){Z(E);return}setTimeout(Te,10)}qe.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let vr=null;function Cu(E){vr&&vr(E)}function Ba(){ns.stop()}function zi(){ns.start()}let ns=new Rm;ns.setAnimationLoop(Cu),typeof self<"u"&&ns.setContext(self),this.setAnimationLoop=function(E){vr=E,ce.setAnimationLoop(E),E===null?ns.stop():ns.start()},ce.addEventListener("sessionstart",Ba),ce.addEventListener("sessionend",zi),this.render=function(E,z){if(z!==void 0&&z.isCamera!==!0){Qe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;O!==null&&O.renderStart(E,z);let j=ce.enabled===!0&&ce.isPresenting===!0,$=F!==null&&(le===null||j)&&F.begin(L,le);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(F===null||F.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(z),z=ce.getCamera()),E.isScene===!0&&E.onBeforeRender(L,E,z,le),T=te.get(E,w.length),T.init(z),T.state.textureUnits=Xe.getTextureUnits(),w.push(T),Pt.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Wt.setFromArrayCamera(z):tt.setFromProjectionMatrix(Pt,_i,z.reversedDepth),rn=this.localClippingEnabled,Ft=se.init(this.clippingPlanes,rn),R=ye.get(E,_.length),R.init(),_.push(R),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Pe=L.xr.getDepthSensingMesh();Pe!==null&&is(Pe,z,-1/0,L.sortObjects)}is(E,z,0,L.sortObjects),R.finish(),O!==null&&O.updateLights(T.state.lightsArray),L.sortObjects===!0&&R.sort(He,Ze),$t=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,$t&&U.addToRenderList(R,E),this.info.autoReset===!0&&this.info.reset(),Ft===!0&&se.beginShadows();let Z=T.state.shadowsArray;if(pe.render(Z,E,z),Ft===!0&&se.endShadows(),($&&F.hasRenderPass())===!1){let Pe=R.opaque,Ae=R.transmissive;if(T.setupLights(),z.isArrayCamera){let Ie=z.cameras;if(Ae.length>0)for(let ze=0,je=Ie.length;ze<je;ze++){let ut=Ie[ze];Mi(Pe,Ae,E,ut)}$t&&U.render(E);for(let ze=0,je=Ie.length;ze<je;ze++){let ut=Ie[ze];Co(R,E,ut,ut.viewport)}}else Ae.length>0&&Mi(Pe,Ae,E,z),$t&&U.render(E),Co(R,E,z)}le!==null&&H===0&&(Xe.updateMultisampleRenderTarget(le),Xe.updateRenderTargetMipmap(le)),$&&F.end(L),E.isScene===!0&&E.onAfterRender(L,E,z),Se.resetDefaultState(),J=-1,Q=null,w.pop(),w.length>0?(T=w[w.length-1],Xe.setTextureUnits(T.state.textureUnits),Ft===!0&&se.setGlobalState(L.clippingPlanes,T.state.camera)):T=null,_.pop(),_.length>0?R=_[_.length-1]:R=null,O!==null&&O.renderEnd()};function is(E,z,j,$){if(E.visible===!1)return;if(E.layers.test(z.layers)){if(E.isGroup)j=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(z);else if(E.isLight)T.pushLight(E),E.castShadow&&T.pushShadow(E);else if(E.isSprite){let Pe=z.isArrayCamera?Wt:tt;if(!E.frustumCulled||E.intersectsFrustum(Pe)){$&&xt.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Pt);let Ae=ue.update(E),Ie=E.material;Ie.visible&&R.push(E,Ae,Ie,j,xt.z,null,z)}}else if(E.isMesh||E.isLine||E.isPoints){let Pe=z.isArrayCamera?Wt:tt;if(!E.frustumCulled||E.intersectsFrustum(Pe)){let Ae=ue.update(E),Ie=E.material;if($&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),xt.copy(E.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),xt.copy(Ae.boundingSphere.center)),xt.applyMatrix4(E.matrixWorld).applyMatrix4(Pt)),Array.isArray(Ie)){let ze=Ae.groups;for(let je=0,ut=ze.length;je<ut;je++){let ke=ze[je],ht=Ie[ke.materialIndex];ht&&ht.visible&&R.push(E,Ae,ht,j,xt.z,ke,z)}}else Ie.visible&&R.push(E,Ae,Ie,j,xt.z,null,z)}}}let Te=E.children;for(let Pe=0,Ae=Te.length;Pe<Ae;Pe++)is(Te[Pe],z,j,$)}function Co(E,z,j,$){let{opaque:Z,transmissive:Te,transparent:Pe}=E;T.setupLightsView(j),Ft===!0&&se.setGlobalState(L.clippingPlanes,j),$&&we.viewport(ie.copy($)),Z.length>0&&Zt(Z,z,j),Te.length>0&&Zt(Te,z,j),Pe.length>0&&Zt(Pe,z,j),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Mi(E,z,j,$){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[$.id]===void 0){let ke=qe.has("EXT_color_buffer_half_float")||qe.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[$.id]=new oi(1,1,{generateMipmaps:!0,type:ke?Li:ci,minFilter:gs,samples:Math.max(4,it.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:pt.workingColorSpace})}let Te=T.state.transmissionRenderTarget[$.id],Pe=$.viewport||ie;Te.setSize(Pe.z*L.transmissionResolutionScale,Pe.w*L.transmissionResolutionScale);let Ae=L.getRenderTarget(),Ie=L.getActiveCubeFace(),ze=L.getActiveMipmapLevel();L.setRenderTarget(Te),L.getClearColor(ee),me=L.getClearAlpha(),me<1&&L.setClearColor(16777215,.5),L.clear(),$t&&U.render(j);let je=L.toneMapping;L.toneMapping=Ki;let ut=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),T.setupLightsView($),Ft===!0&&se.setGlobalState(L.clippingPlanes,$),Zt(E,j,$),Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te),qe.has("WEBGL_multisampled_render_to_texture")===!1){let ke=!1;for(let ht=0,Yt=z.length;ht<Yt;ht++){let Tt=z[ht],{object:At,geometry:_n,material:Fe,group:an}=Tt;if(Fe.side===Nn&&At.layers.test($.layers)){let dt=Fe.side;Fe.side=Dn,Fe.needsUpdate=!0,en(At,j,$,_n,Fe,an),Fe.side=dt,Fe.needsUpdate=!0,ke=!0}}ke===!0&&(Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te))}L.setRenderTarget(Ae,Ie,ze),L.setClearColor(ee,me),ut!==void 0&&($.viewport=ut),L.toneMapping=je}function Zt(E,z,j){let $=z.isScene===!0?z.overrideMaterial:null;for(let Z=0,Te=E.length;Z<Te;Z++){let Pe=E[Z],{object:Ae,geometry:Ie,group:ze}=Pe,je=Pe.material;je.allowOverride===!0&&$!==null&&(je=$),Ae.layers.test(j.layers)&&en(Ae,z,j,Ie,je,ze)}}function en(E,z,j,$,Z,Te){O!==null&&Z.isNodeMaterial&&O.setObject(E,Z),E.onBeforeRender(L,z,j,$,Z,Te),E.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),Z.onBeforeRender(L,z,j,$,E,Te),Z.transparent===!0&&Z.side===Nn&&Z.forceSinglePass===!1?(Z.side=Dn,Z.needsUpdate=!0,L.renderBufferDirect(j,z,$,Z,E,Te),Z.side=yi,Z.needsUpdate=!0,L.renderBufferDirect(j,z,$,Z,E,Te),Z.side=Nn):L.renderBufferDirect(j,z,$,Z,E,Te),E.onAfterRender(L,z,j,$,Z,Te)}function tn(E){let z=0;for(let j of E)j.texture!==null&&z++;return z}function Vi(E,z,j){z.isScene!==!0&&(z=gn);let $=Ve.get(E),Z=T.state.lights,Te=T.state.shadowsArray,Pe=Z.state.version,Ae=oe.getParameters(E,Z.state,Te,z,j,T.state.lightProbeGridArray),Ie=oe.getProgramCacheKey(Ae),ze=$.programs;$.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?z.environment:null,$.fog=z.fog;let je=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;$.envMap=C.get(E.envMap||$.environment,je),$.envMapRotation=$.environment!==null&&E.envMap===null?z.environmentRotation:E.envMapRotation,ze===void 0&&(E.addEventListener("dispose",st),ze=new Map,$.programs=ze,$.programVariants=new Map);let ut=ze.get(Ie);if(ut!==void 0){if($.currentProgram===ut&&$.lightsStateVersion===Pe)return Po(E,Ae),ut}else Ae.uniforms=oe.getUniforms(E),O!==null&&E.isNodeMaterial&&O.build(E,j,Ae),E.onBeforeCompile(Ae,L),ut=oe.acquireProgram(Ae,Ie),ze.set(Ie,ut),$.uniforms=Ae.uniforms;let ke=$.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(ke.clippingPlanes=se.uniform),Po(E,Ae),$.needsLights=Es(E),$.lightsStateVersion=Pe,$.needsLights&&(ke.ambientLightColor.value=Z.state.ambient,ke.lightProbe.value=Z.state.probe,ke.sunLights.value=Z.state.sun,ke.sunLightShadows.value=Z.state.sunShadow,ke.directionalLights.value=Z.state.directional,ke.directionalLightShadows.value=Z.state.directionalShadow,ke.spotLights.value=Z.state.spot,ke.spotLightShadows.value=Z.state.spotShadow,ke.rectAreaLights.value=Z.state.rectArea,ke.ltc_1.value=Z.state.rectAreaLTC1,ke.ltc_2.value=Z.state.rectAreaLTC2,ke.pointLights.value=Z.state.point,ke.pointLightShadows.value=Z.state.pointShadow,ke.hemisphereLights.value=Z.state.hemi,ke.sunShadowMatrix.value=Z.state.sunShadowMatrix,ke.sunShadowCascade.value=Z.state.sunShadowCascade,ke.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,ke.spotLightMatrix.value=Z.state.spotLightMatrix,ke.spotLightMap.value=Z.state.spotLightMap,ke.pointShadowMatrix.value=Z.state.pointShadowMatrix),$.numLightProbeGrids=tn(T.state.lightProbeGridArray),$.currentProgram=ut,$.uniformsList=null,ut}function ei(E,z,j,$,Z){let Te=Ve.get(E),Pe=Te.currentProgram.id+","+$+","+Z,Ae=Te.programVariants.get(Pe);return Ae===void 0?(Ae=Vi(E,z,j),Te.programVariants.set(Pe,Ae)):(Te.currentProgram=Ae,Te.uniformsList=null,Te.outputColorSpace=$,Te.toneMapping=Z),Ae}function ws(E){if(E.uniformsList===null){let z=E.currentProgram.getUniforms();E.uniformsList=ao.seqWithValue(z.seq,E.uniforms)}return E.uniformsList}function Po(E,z){let j=Ve.get(E);j.outputColorSpace=z.outputColorSpace,j.batching=z.batching,j.batchingColor=z.batchingColor,j.instancing=z.instancing,j.instancingColor=z.instancingColor,j.instancingMorph=z.instancingMorph,j.skinning=z.skinning,j.morphTargets=z.morphTargets,j.morphNormals=z.morphNormals,j.morphColors=z.morphColors,j.morphTargetsCount=z.morphTargetsCount,j.numClippingPlanes=z.numClippingPlanes,j.numIntersection=z.numClipIntersection,j.vertexAlphas=z.vertexAlphas,j.vertexTangents=z.vertexTangents,j.toneMapping=z.toneMapping}function Io(E,z,j,$,Z){z.isScene!==!0&&(z=gn),Xe.resetTextureUnits();let Te=z.fog,Pe=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?z.environment:null,Ae=le===null?L.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:pt.workingColorSpace,Ie=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,ze=C.get($.envMap||Pe,Ie),je=$.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,ut=!!j.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),ke=!!j.morphAttributes.position,ht=!!j.morphAttributes.normal,Yt=!!j.morphAttributes.color,Tt=Ki;$.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Tt=L.toneMapping);let At=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,_n=At!==void 0?At.length:0,Fe=Ve.get($),an=T.state.lights;if(Ft===!0&&(rn===!0||E!==Q)){let Rt=E===Q&&$.id===J;se.setState($,E,Rt)}let dt=!1,ss=!1;$.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==an.state.version||Z.isBatchedMesh&&Fe.batching===!1||!Z.isBatchedMesh&&Fe.batching===!0||Z.isBatchedMesh&&Fe.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Fe.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Fe.instancing===!1||!Z.isInstancedMesh&&Fe.instancing===!0||Z.isSkinnedMesh&&Fe.skinning===!1||!Z.isSkinnedMesh&&Fe.skinning===!0||Z.isInstancedMesh&&Fe.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Fe.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Fe.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Fe.instancingMorph===!1&&Z.morphTexture!==null||Fe.envMap!==ze||$.fog===!0&&Fe.fog!==Te||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==se.numPlanes||Fe.numIntersection!==se.numIntersection)||Fe.vertexAlphas!==je||Fe.vertexTangents!==ut||Fe.morphTargets!==ke||Fe.morphNormals!==ht||Fe.morphColors!==Yt||Fe.morphTargetsCount!==_n||Fe.numLightProbeGrids!==tn(T.state.lightProbeGridArray)?dt=!0:(Fe.outputColorSpace!==Ae||Fe.toneMapping!==Tt)&&(ss=!0):(dt=!0,Fe.__version=$.version);let ln=Fe.currentProgram;(dt===!0||ss===!0)&&(ln=ss===!0?ei($,z,Z,Ae,Tt):Vi($,z,Z),O&&$.isNodeMaterial&&O.onUpdateProgram($,ln,Fe));let Sr=!1,Hi=!1,rs=!1,at=ln.getUniforms(),Jt=Fe.uniforms;if(we.useProgram(ln.program)&&(Sr=!0,Hi=!0,rs=!0),$.id!==J&&(J=$.id,Hi=!0),Sr||Q!==E){we.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),at.setValue(B,"projectionMatrix",E.projectionMatrix),at.setValue(B,"viewMatrix",E.matrixWorldInverse);let cn=at.map.cameraPosition;cn!==void 0&&cn.setValue(B,Sn.setFromMatrixPosition(E.matrixWorld)),it.logarithmicDepthBuffer&&at.setValue(B,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&at.setValue(B,"isOrthographic",E.isOrthographicCamera===!0),Q!==E&&(Q=E,Hi=!0,rs=!0)}if(Fe.needsLights&&(an.state.sunShadowMap.length>0&&at.setValue(B,"sunShadowMap",an.state.sunShadowMap,Xe),an.state.directionalShadowMap.length>0&&at.setValue(B,"directionalShadowMap",an.state.directionalShadowMap,Xe),an.state.spotShadowMap.length>0&&at.setValue(B,"spotShadowMap",an.state.spotShadowMap,Xe),an.state.pointShadowMap.length>0&&at.setValue(B,"pointShadowMap",an.state.pointShadowMap,Xe)),Z.isSkinnedMesh){at.setOptional(B,Z,"bindMatrix"),at.setOptional(B,Z,"bindMatrixInverse");let Rt=Z.skeleton;Rt&&(Rt.boneTexture===null&&Rt.computeBoneTexture(),at.setValue(B,"boneTexture",Rt.boneTexture,Xe))}Z.isBatchedMesh&&(at.setOptional(B,Z,"batchingTexture"),at.setValue(B,"batchingTexture",Z._matricesTexture,Xe),at.setOptional(B,Z,"batchingIdTexture"),at.setValue(B,"batchingIdTexture",Z._indirectTexture,Xe),at.setOptional(B,Z,"batchingColorTexture"),Z._colorsTexture!==null&&at.setValue(B,"batchingColorTexture",Z._colorsTexture,Xe));let Gn=j.morphAttributes;if((Gn.position!==void 0||Gn.normal!==void 0||Gn.color!==void 0)&&re.update(Z,j,ln),(Hi||Fe.receiveShadow!==Z.receiveShadow)&&(Fe.receiveShadow=Z.receiveShadow,at.setValue(B,"receiveShadow",Z.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&z.environment!==null&&(Jt.envMapIntensity.value=z.environmentIntensity),Jt.dfgLUT!==void 0&&(Jt.dfgLUT.value=vM()),Hi){if(at.setValue(B,"toneMappingExposure",L.toneMappingExposure),Fe.needsLights&&yr(Jt,rs),Te&&$.fog===!0&&xe.refreshFogUniforms(Jt,Te),xe.refreshMaterialUniforms(Jt,$,ve,Me,T.state.transmissionRenderTarget[E.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Rt=b,cn=0;for(let Bn of T.state.lightProbeGridArray)Bn.texture!==null&&(Rt.textures[cn]=Bn.texture,Rt.min[cn]=Bn.boundingBox.min,Rt.max[cn]=Bn.boundingBox.max,Rt.resolution[cn]=Bn.resolution,cn++);for(let Bn in Rt)Rt[Bn].length=cn;Jt.probesSH.value=Rt.textures,Jt.probesMin.value=Rt.min,Jt.probesMax.value=Rt.max,Jt.probesResolution.value=Rt.resolution}ao.upload(B,ws(Fe),Jt,Xe)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(ao.upload(B,ws(Fe),Jt,Xe),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&at.setValue(B,"center",Z.center),at.setValue(B,"modelViewMatrix",Z.modelViewMatrix),at.setValue(B,"normalMatrix",Z.normalMatrix),at.setValue(B,"modelMatrix",Z.matrixWorld),$.uniformsGroups!==void 0){let Rt=$.uniformsGroups;for(let cn=0,Bn=Rt.length;cn<Bn;cn++){let ka=Rt[cn];Ge.update(ka,ln),Ge.bind(ka,ln)}}return ln}function yr(E,z){E.ambientLightColor.needsUpdate=z,E.lightProbe.needsUpdate=z,E.sunLights.needsUpdate=z,E.sunLightShadows.needsUpdate=z,E.directionalLights.needsUpdate=z,E.directionalLightShadows.needsUpdate=z,E.pointLights.needsUpdate=z,E.pointLightShadows.needsUpdate=z,E.spotLights.needsUpdate=z,E.spotLightShadows.needsUpdate=z,E.rectAreaLights.needsUpdate=z,E.hemisphereLights.needsUpdate=z}function Es(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(E,z,j){let $=Ve.get(E);$.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Ve.get(E.texture).__webglTexture=z,Ve.get(E.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:j,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,z){let j=Ve.get(E);j.__webglFramebuffer=z,j.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(E,z=0,j=0){le=E,Y=z,H=j;let $=null,Z=!1,Te=!1;if(E){let Ae=Ve.get(E);if(Ae.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(B.FRAMEBUFFER,Ae.__webglFramebuffer),ie.copy(E.viewport),fe.copy(E.scissor),he=E.scissorTest,we.viewport(ie),we.scissor(fe),we.setScissorTest(he),J=-1;return}else if(Ae.__webglFramebuffer===void 0)Xe.setupRenderTarget(E);else if(Ae.__hasExternalTextures)Xe.rebindTextures(E,Ve.get(E.texture).__webglTexture,Ve.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let je=E.depthTexture;if(Ae.__boundDepthTexture!==je){if(je!==null&&Ve.has(je)&&(E.width!==je.image.width||E.height!==je.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xe.setupDepthRenderbuffer(E)}}let Ie=E.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Te=!0);let ze=Ve.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(ze[z])?$=ze[z][j]:$=ze[z],Z=!0):E.samples>0&&Xe.useMultisampledRTT(E)===!1?$=Ve.get(E).__webglMultisampledFramebuffer:Array.isArray(ze)?$=ze[j]:$=ze,ie.copy(E.viewport),fe.copy(E.scissor),he=E.scissorTest}else ie.copy(Oe).multiplyScalar(ve).floor(),fe.copy(ct).multiplyScalar(ve).floor(),he=ot;if(j!==0&&($=k),we.bindFramebuffer(B.FRAMEBUFFER,$)&&we.drawBuffers(E,$),we.viewport(ie),we.scissor(fe),we.setScissorTest(he),Z){let Ae=Ve.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ae.__webglTexture,j)}else if(Te){let Ae=z;for(let Ie=0;Ie<E.textures.length;Ie++){let ze=Ve.get(E.textures[Ie]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ie,ze.__webglTexture,j,Ae)}}else if(E!==null&&j!==0){let Ae=Ve.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ae.__webglTexture,j)}J=-1};function br(E){let z=Ve.get(E);return(z.__readFormat!==E.format||z.__readType!==E.type)&&(z.__readFormat=E.format,z.__readType=E.type,z.__formatReadable=it.textureFormatReadable(E.format),z.__typeReadable=it.textureTypeReadable(E.type)),z}this.readRenderTargetPixels=function(E,z,j,$,Z,Te,Pe,Ae=0){if(!(E&&E.isWebGLRenderTarget)){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=Ve.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){we.bindFramebuffer(B.FRAMEBUFFER,Ie);try{let ze=E.textures[Ae],je=ze.format,ut=ze.type;E.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ae);let ke=br(ze);if(ke.__formatReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ke.__typeReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=E.width-$&&j>=0&&j<=E.height-Z&&B.readPixels(z,j,$,Z,_e.convert(je),_e.convert(ut),Te)}finally{let ze=le!==null?Ve.get(le).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(E,z,j,$,Z,Te,Pe,Ae=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=Ve.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(z>=0&&z<=E.width-$&&j>=0&&j<=E.height-Z){we.bindFramebuffer(B.FRAMEBUFFER,Ie);let ze=E.textures[Ae],je=ze.format,ut=ze.type;E.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ae);let ke=br(ze);if(ke.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ke.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ht=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,ht),B.bufferData(B.PIXEL_PACK_BUFFER,Te.byteLength,B.STREAM_READ),B.readPixels(z,j,$,Z,_e.convert(je),_e.convert(ut),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let Yt=le!==null?Ve.get(le).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,Yt);let Tt=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await em(B,Tt,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,ht),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Te),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(ht),B.deleteSync(Tt),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,z=null,j=0){let $=Math.pow(2,-j),Z=Math.floor(E.image.width*$),Te=Math.floor(E.image.height*$),Pe=z!==null?z.x:0,Ae=z!==null?z.y:0;Xe.setTexture2D(E,0),B.copyTexSubImage2D(B.TEXTURE_2D,j,0,0,Pe,Ae,Z,Te),we.unbindTexture()},this.copyTextureToTexture=function(E,z,j=null,$=null,Z=0,Te=0){let Pe,Ae,Ie,ze,je,ut,ke,ht,Yt,Tt=E.isCompressedTexture?E.mipmaps[Te]:E.image;if(j!==null)Pe=j.max.x-j.min.x,Ae=j.max.y-j.min.y,Ie=j.isBox3?j.max.z-j.min.z:1,ze=j.min.x,je=j.min.y,ut=j.isBox3?j.min.z:0;else{let at=Math.pow(2,-Z);Pe=Math.floor(Tt.width*at),Ae=Math.floor(Tt.height*at),E.isDataArrayTexture?Ie=Tt.depth:E.isData3DTexture?Ie=Math.floor(Tt.depth*at):Ie=1,ze=0,je=0,ut=0}$!==null?(ke=$.x,ht=$.y,Yt=$.z):(ke=0,ht=0,Yt=0);let At=_e.convert(z.format),_n=_e.convert(z.type),Fe;z.isData3DTexture?(Xe.setTexture3D(z,0),Fe=B.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Xe.setTexture2DArray(z,0),Fe=B.TEXTURE_2D_ARRAY):(Xe.setTexture2D(z,0),Fe=B.TEXTURE_2D),we.activeTexture(B.TEXTURE0),we.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,z.flipY),we.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),we.pixelStorei(B.UNPACK_ALIGNMENT,z.unpackAlignment);let an=we.getParameter(B.UNPACK_ROW_LENGTH),dt=we.getParameter(B.UNPACK_IMAGE_HEIGHT),ss=we.getParameter(B.UNPACK_SKIP_PIXELS),ln=we.getParameter(B.UNPACK_SKIP_ROWS),Sr=we.getParameter(B.UNPACK_SKIP_IMAGES);we.pixelStorei(B.UNPACK_ROW_LENGTH,Tt.width),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Tt.height),we.pixelStorei(B.UNPACK_SKIP_PIXELS,ze),we.pixelStorei(B.UNPACK_SKIP_ROWS,je),we.pixelStorei(B.UNPACK_SKIP_IMAGES,ut);let Hi=E.isDataArrayTexture||E.isData3DTexture,rs=z.isDataArrayTexture||z.isData3DTexture;if(E.isDepthTexture){let at=Ve.get(E),Jt=Ve.get(z),Gn=Ve.get(at.__renderTarget),Rt=Ve.get(Jt.__renderTarget);we.bindFramebuffer(B.READ_FRAMEBUFFER,Gn.__webglFramebuffer),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,Rt.__webglFramebuffer);for(let cn=0;cn<Ie;cn++)Hi&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ve.get(E).__webglTexture,Z,ut+cn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ve.get(z).__webglTexture,Te,Yt+cn)),B.blitFramebuffer(ze,je,ze+Pe,je+Ae,ke,ht,ke+Pe,ht+Ae,B.DEPTH_BUFFER_BIT,B.NEAREST);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(Z!==0||E.isRenderTargetTexture||Ve.has(E)){let at=Ve.get(E),Jt=Ve.get(z);we.bindFramebuffer(B.READ_FRAMEBUFFER,D),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,G);for(let Gn=0;Gn<Ie;Gn++)Hi?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,at.__webglTexture,Z,ut+Gn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,at.__webglTexture,Z),rs?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Jt.__webglTexture,Te,Yt+Gn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Jt.__webglTexture,Te),Z!==0?B.blitFramebuffer(ze,je,ze+Pe,je+Ae,ke,ht,ke+Pe,ht+Ae,B.COLOR_BUFFER_BIT,B.NEAREST):rs?B.copyTexSubImage3D(Fe,Te,ke,ht,Yt+Gn,ze,je,Pe,Ae):B.copyTexSubImage2D(Fe,Te,ke,ht,ze,je,Pe,Ae);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else rs?E.isDataTexture||E.isData3DTexture?B.texSubImage3D(Fe,Te,ke,ht,Yt,Pe,Ae,Ie,At,_n,Tt.data):z.isCompressedArrayTexture?B.compressedTexSubImage3D(Fe,Te,ke,ht,Yt,Pe,Ae,Ie,At,Tt.data):B.texSubImage3D(Fe,Te,ke,ht,Yt,Pe,Ae,Ie,At,_n,Tt):E.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Te,ke,ht,Pe,Ae,At,_n,Tt.data):E.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Te,ke,ht,Tt.width,Tt.height,At,Tt.data):B.texSubImage2D(B.TEXTURE_2D,Te,ke,ht,Pe,Ae,At,_n,Tt);we.pixelStorei(B.UNPACK_ROW_LENGTH,an),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,dt),we.pixelStorei(B.UNPACK_SKIP_PIXELS,ss),we.pixelStorei(B.UNPACK_SKIP_ROWS,ln),we.pixelStorei(B.UNPACK_SKIP_IMAGES,Sr),Te===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&B.generateMipmap(Fe),we.unbindTexture()},this.initRenderTarget=function(E){Ve.get(E).__webglFramebuffer===void 0&&Xe.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Xe.setTextureCube(E,0):E.isData3DTexture?Xe.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Xe.setTexture2DArray(E,0):Xe.setTexture2D(E,0),we.unbindTexture()},this.resetState=function(){Y=0,H=0,le=null,we.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return _i}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=pt._getDrawingBufferColorSpace(e),t.unpackColorSpace=pt._getUnpackColorSpace()}};var mf=1e30,yM="1e20",bM=`
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
  #ifdef DEFORMED
  p += deformation * displacement;
  #endif
  #ifdef COPIES
  p = vec3(copyRotation.x * p.x - copyRotation.y * p.y, copyRotation.y * p.x + copyRotation.x * p.y, p.z);
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
`,SM=`
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
    base = vField > ${yM} ? noValue : texture2D(scale, vec2(clamp(fraction, 0.0, 1.0) * 0.99609375 + 0.001953125, 0.5)).rgb;
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
  base *= mix(0.80, 1.0, smoothstep(0.35, 1.1, stripe));
  #endif
  gl_FragColor = vec4(base, opacity);
  #include <colorspace_fragment>
}
`,Di=class extends vi{cuttable;constructor(e,t,n={},s){super({vertexShader:bM,fragmentShader:SM,defines:Object.fromEntries(t.map(r=>[r,""])),...n}),this.uniforms={cutPlane:e.cutPlane,deformation:e.deformation,limits:e.limits,scale:e.scale,noValue:e.noValue,pixelRatio:e.pixelRatio,colour:s??{value:new rt},opacity:{value:1},useField:{value:!1},bias:{value:0}},this.cuttable=!t.includes("CAP")}get colour(){return this.uniforms.colour.value}set alpha(e){this.uniforms.opacity.value=e,this.transparent=e<1}set useField(e){this.uniforms.useField.value=e}set bias(e){this.uniforms.bias.value=e}set cut(e){!this.cuttable||e==="CUT"in this.defines||(e?this.defines.CUT="":delete this.defines.CUT,this.needsUpdate=!0)}};function km(i){return{cutPlane:{value:new Ht(0,0,1,0)},deformation:{value:0},limits:{value:new _t(0,1)},scale:{value:i},noValue:{value:new rt("#9a9a9a")},lineColour:{value:new rt("#1c2733")},edgeColour:{value:new rt("#1c2733")},pixelRatio:{value:1}}}function gf(i,e){let t=e?["DEFORMED"]:["COPIES"],n=(r,o)=>new Di(i,t,{side:r,colorWrite:!1,depthWrite:!1,depthTest:!1,stencilWrite:!0,stencilFunc:Fc,stencilFail:o,stencilZFail:o,stencilZPass:o}),s=(r,o)=>{let a=new Di(i,t,{depthWrite:!1},r);return a.alpha=o,a};return{surface:new Di(i,e?["DEFORMED","FIELD","LIT"]:["COPIES","LIT"],{polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),features:s(i.lineColour,.55),edges:s(i.edgeColour,.3),stencilBack:n(Dn,Wh),stencilFront:n(yi,Xh)}}function zm(i){return new Di(i,["CAP"],{side:Nn,stencilWrite:!0,stencilRef:0,stencilFunc:qh,stencilFail:ga,stencilZFail:ga,stencilZPass:ga})}var Hc=class{group=new nn;materials;#e=new Rn;#t;#n=null;#i;constructor(e){let t=new Di(e,["FIELD"],{side:Nn}),n=new Di(e,["FIELD"],{side:Nn,depthFunc:Xr,depthWrite:!1});n.alpha=.5,t.useField=n.useField=!0,this.#i=n,this.materials=[t,n];let s=this.materials.map(r=>new Ut(this.#e,r));for(let r of s)r.frustumCulled=!1,r.matrixAutoUpdate=!1,this.group.add(r);this.#t=s[1],this.#t.renderOrder=99999,s[0].renderOrder=5}setBias(e){for(let t of this.materials)t.bias=e;this.#i.bias=0}setBehind(e){this.#t.visible=e}get contacts(){return this.#n}set(e,t){if(this.#n=e,this.#e.dispose(),this.group.visible=e!==null,!e)return;let n=[];for(let a=0;a<e.count;a++)e.pressures[a]>0&&t(a)&&n.push(a);let s=new Float32Array(12*n.length),r=new Float32Array(4*n.length),o=new Uint32Array(6*n.length);n.forEach((a,c)=>{s.set(e.corners.subarray(12*a,12*a+12),12*c),r.fill(e.pressures[a],4*c,4*c+4);let l=4*c;o.set([l,l+1,l+2,l,l+2,l+3],6*c)}),this.#e.setAttribute("position",new qt(s,3)),this.#e.setAttribute("field",new qt(r,1)),this.#e.setIndex(new qt(o,1))}dispose(){this.#e.dispose();for(let e of this.materials)e.dispose()}};function Vm(i){let e=new Map,t=i.corners;for(let n=0;n<i.count;n++){let s=12*n,r=t[s+6]-t[s],o=t[s+7]-t[s+1],a=t[s+8]-t[s+2],c=t[s+9]-t[s+3],l=t[s+10]-t[s+4],u=t[s+11]-t[s+5],d=.5*Math.hypot(o*u-a*l,a*c-r*u,r*l-o*c),f=`${i.parts[2*n]} ${i.parts[2*n+1]}`;e.set(f,(e.get(f)??0)+i.pressures[n]*d)}return e}var Gc=class{constructor(e){this.core=e}core;playing=!1;#e=0;toggle(){this.playing?this.stop():this.start()}start(){let e=this.core.positions?.list.length??0;this.playing||e<2||(this.playing=!0,this.play(++this.#e),this.core.changed(!1))}stop(){this.playing&&(this.playing=!1,this.#e++,this.core.changed(!1))}step(e){this.stop();let t=this.next(e,!0);t!==null&&this.core.goTo(t)}next(e,t){let n=this.core.positions?.list.length??0;if(n===0)return null;let s=this.core.state.position+e;return s>=0&&s<n?s:t?(s+n)%n:null}async play(e){let{core:t}=this,n=t.positions?.list.length??0;for(!t.state.animation.loop&&t.state.position===n-1&&await t.goTo(0);e===this.#e;){let s=performance.now()+1e3/Math.max(.1,t.state.animation.speed),r=this.next(1,t.state.animation.loop);if(r===null)break;if(await t.positions?.load(r).catch(()=>null),await new Promise(o=>setTimeout(o,Math.max(0,s-performance.now()))),e!==this.#e)return;await t.goTo(r),await new Promise(requestAnimationFrame)}e===this.#e&&this.stop()}};var Hm="CALYXARR";var dn=class extends Error{constructor(t,n){super(`${t}: ${n}`);this.file=t;this.reason=n;this.name="FileError"}file;reason},Sa=class i{constructor(e,t,n,s){this.name=e;this.header=t;this.buffer=n;this.start=s}name;header;buffer;start;static parse(e,t){if(t.byteLength<16)throw new dn(e,`the file is truncated: it has ${t.byteLength} bytes, the header needs 16`);let n=new DataView(t);if(new TextDecoder("latin1").decode(new Uint8Array(t,0,8))!==Hm)throw new dn(e,`not an array file: it does not begin with ${Hm}`);let r=n.getUint32(8,!0);if(r!==1)throw new dn(e,`version ${r} of the format is not supported; this viewer reads version 1`);let o=n.getUint32(12,!0),a=16+o;if(a>t.byteLength)throw new dn(e,`the file is truncated: it has ${t.byteLength} bytes, the header ends at ${a}`);let c;try{c=JSON.parse(new TextDecoder("utf-8",{fatal:!0}).decode(new Uint8Array(t,16,o)))}catch{throw new dn(e,"the header is not valid JSON")}if(typeof c!="object"||c===null||Array.isArray(c))throw new dn(e,"the header is not a JSON object");return new i(e,c,t,a)}f32(e,t,n){let{offset:s,length:r}=this.locate(e,"f32",t,n);return new Float32Array(this.buffer,s,r)}f64(e,t,n){let{offset:s,length:r}=this.locate(e,"f64",t,n);return s%8===0?new Float64Array(this.buffer,s,r):new Float64Array(this.buffer.slice(s,s+8*r))}u32(e,t,n){let{offset:s,length:r}=this.locate(e,"u32",t,n);return new Uint32Array(this.buffer,s,r)}locate(e,t,n,s){let r=m=>{throw new dn(this.name,`${s}: ${m}`)};if(typeof e!="object"||e===null)return r("the array is missing");let o=e;if(o.type!==t)return r(`the array has type ${String(o.type)}, expected ${t}`);if(o.components!==n)return r(`the array has ${String(o.components)} components, expected ${n}`);let{count:a,offset:c}=o,l=m=>Number.isSafeInteger(m)&&m>=0;if(!l(a)||!l(c))return r("the size or the offset of the array is not a whole number");let u=t==="f64"?8:4;if(c%u!==0)return r(`the offset ${c} is not aligned`);let d=a*n,f=this.start+c+d*u;if(f>this.buffer.byteLength)return r(`the file is truncated: it has ${this.buffer.byteLength} bytes, the array ends at ${f}`);let h=this.start+c;return h%u!==0?r("the header's length is not a multiple of 8"):{offset:h,length:d}}};var Wc=256,_f={viridis:{label:"Viridis",colours:["#440154","#482475","#414487","#355f8d","#2a788e","#21918c","#22a884","#44bf70","#7ad151","#bddf26","#fde725"]},cividis:{label:"Cividis",colours:["#00224e","#123570","#3b496c","#575d6d","#707173","#8a8678","#a59c74","#c3b369","#e1cc55","#fee838"]},turbo:{label:"Turbo",colours:["#30123b","#4145ab","#4675ed","#39a2fc","#1bcfd4","#24eca6","#61fc6c","#a4fc3b","#d1e834","#f3c63a","#fe9b2d","#f36315","#d93806","#b11901","#7a0402"]},grey:{label:"Grey",colours:["#1a1a1a","#f2f2f2"]}},Wm=Object.entries(_f).map(([i,{label:e}])=>({name:i,label:e}));function Gm(i){let e=parseInt(i.slice(1),16);return[e>>16&255,e>>8&255,e&255]}function co(i,e){let{colours:t}=_f[i]??_f.viridis,n=Math.min(Math.max(e,0),1)*(t.length-1),s=Math.min(Math.floor(n),t.length-2),r=Gm(t[s]),o=Gm(t[s+1]),a=n-s;return r.map((c,l)=>Math.round(c+a*(o[l]-c)))}function Ma(i,e){if(e<1)return i;let t=Math.min(Math.max(Math.floor(i*e),0),e-1);return e===1?.5:t/(e-1)}function wa([i,e,t]){return`rgb(${i} ${e} ${t})`}function Xm(i,e,t){let n=i.image.data;for(let r=0;r<Wc;r++){let[o,a,c]=co(e,Ma(r/(Wc-1),t));n.set([o,a,c,255],4*r)}let s=t>0?fn:Ln;i.minFilter=s,i.magFilter=s,i.needsUpdate=!0}function qm(){let i=new Zr(new Uint8Array(4*Wc),Wc,1,ui);return i.colorSpace=Yn,i}var Ym=["#7f9db9","#c9a66b","#8fb09a","#b58a9b","#9a95bd","#b9b08a","#76a9ae","#c08f76"],MM={gear:Ym,shaft:["#a9adb3","#b7b2aa","#9ea6ac"],bearing:["#8a8f98","#969089"],body:["#b4bcc4","#c0b9ae","#aab7b0"]};function $m(i,e){let t=MM[i]??Ym;return t[e%t.length]}var Zm={x:[1,0,0],y:[0,1,0],z:[0,0,1]},Xc=class{group=new nn;capGeometry=new sr(2,2);capMatrix=new vt;normal=new X(0,0,1);range=[-1,1];offset=0;#e;#t=new nn;#n=new X;#i=1;#s=new X;constructor(){let e=[-1,-1,0,1,-1,0,1,1,0,-1,1,0],t=new Rn;t.setAttribute("position",new Qt(e,3)),this.#e=new ta(t,new Jr({color:"#e07b1f",transparent:!0,opacity:.8}));let n=new zs({color:"#e07b1f",transparent:!0,depthTest:!1}),s=new ir(.022,.05,20).rotateX(Math.PI/2),r=new Ut(s.clone().translate(0,0,.062),n),o=new Ut(s.clone().rotateY(Math.PI).translate(0,0,-.062),n),a=new Ut(new ra(.021,20,14),n);this.#t.add(r,o,a);for(let c of this.#t.children)c.renderOrder=3e5;this.group.add(this.#e,this.#t),this.group.visible=!1}setBounds(e,t){this.#n.copy(e),this.#i=t}apply(e,t){let n=typeof e.normal=="string"?Zm[e.normal]??Zm.z:e.normal;this.normal.set(n[0],n[1],n[2]),this.normal.lengthSq()>0||this.normal.set(0,0,1),this.normal.normalize();let s=this.normal.dot(this.#n);this.range=[s-this.#i,s+this.#i],this.offset=e.offset??s;let r=e.flipped?-1:1;t.set(r*this.normal.x,r*this.normal.y,r*this.normal.z,-r*this.offset),this.group.visible=e.on;let o=this.#n.clone().addScaledVector(this.normal,this.offset-s),a=new xi().setFromUnitVectors(new X(0,0,1),this.normal),c=1.02*this.#i;this.capMatrix.compose(o,a,new X(1.5*c,1.5*c,1)),this.#e.position.copy(o),this.#e.quaternion.copy(a),this.#e.scale.set(.86*c,.86*c,1),this.#t.quaternion.copy(a),this.#t.position.set(.86*c,.86*c,0).applyQuaternion(a).add(o),this.#t.scale.setScalar(c)}get handle(){return this.#t.position}setHighlight(e){for(let t of this.#t.children)t.material.color.set(e?"#ffa648":"#e07b1f")}drag(e,t,n,s,r){let o=.01*this.#i,a=this.#s.copy(this.handle).project(n),c=a.x,l=a.y,u=this.#s.copy(this.handle).addScaledVector(this.normal,o).project(n),d=(u.x-c)*s/2,f=-(u.y-l)*r/2,h=d*d+f*f;return h<.02?-t*o/2:(e*d+t*f)/h*o}};function wM(i,e,t,n,s,r){let o=Math.max(Math.abs(i),Math.abs(e),Math.abs(t),Math.abs(n),Math.abs(s),Math.abs(r));if(!Number.isFinite(o))return[NaN,NaN,NaN];if(o===0)return[0,0,0];let a=(i+e+t)/3,c=(i-e)/o,l=(e-t)/o,u=(t-i)/o,d=(c-u)/3,f=(l-c)/3,h=(u-l)/3,m=n/o,y=s/o,g=r/o,p=(c*c+l*l+u*u)/6+m*m+y*y+g*g;if(p===0)return[a,a,a];let v=d*(f*h-m*m)-g*(g*h-m*y)+y*(g*m-f*y),A=2*p/3,b=Math.SQRT2,R=d*d+g*g+y*y-A,T=f*f+g*g+m*m-A,_=h*h+m*m+y*y-A,w=b*(y*g-d*m),F=b*(m*g-f*y),L=b*(m*y-h*g),I=b*m,O=b*y,k=b*g,D=(d*T-f*R)**2+(d*_-h*R)**2+(f*_-h*T)**2+(d*w-I*R)**2+(d*F-O*R)**2+(d*L-k*R)**2+(f*w-I*T)**2+(f*F-O*T)**2+(f*L-k*T)**2+(h*w-I*_)**2+(h*F-O*_)**2+(h*L-k*_)**2+(I*F-O*w)**2+(I*L-k*w)**2+(O*L-k*F)**2,G=Math.atan2(Math.sqrt(3*D),Math.sqrt(27)*v)/3,Y=2*Math.sqrt(p/3)*o,H=2*Math.PI/3;return[a+Y*Math.cos(G),a+Y*Math.cos(G-H),a+Y*Math.cos(G+H)]}function EM(i,e,t,n,s,r){let o=i-e,a=e-t,c=t-i;return Math.sqrt(.5*(o*o+a*a+c*c)+3*(n*n+s*s+r*r))}function Ni(i){return i!=="plain"&&i!=="contact_pressure"}var Fi={plain:{label:"Plain",quantity:"none"},contact_pressure:{label:"Contact pressure",quantity:"stress"},max_principal:{label:"Maximum principal stress",quantity:"stress"},min_principal:{label:"Minimum principal stress",quantity:"stress"},von_mises:{label:"Von Mises stress",quantity:"stress"},displacement:{label:"Displacement",quantity:"length"}};function TM(i,e,t){if(e==="displacement"){let f=i.displacements;return Math.hypot(f[3*t],f[3*t+1],f[3*t+2])}let n=i.stresses,s=6*t,[r,o,a,c,l,u]=[n[s],n[s+1],n[s+2],n[s+3],n[s+4],n[s+5]];if(e==="von_mises")return EM(r,o,a,c,l,u);let d=wM(r,o,a,c,l,u);return e==="max_principal"?d[0]:d[2]}function Jm(i){let e={min:1/0,max:-1/0,minIndex:-1,maxIndex:-1};for(let t=0;t<i.length;t++){let n=i[t];n<e.min&&n!==-1/0&&(e.min=n,e.minIndex=t),n>e.max&&n!==1/0&&(e.max=n,e.maxIndex=t)}return e.minIndex<0||e.maxIndex<0?null:e}function Km(i){let e=new Uint8Array(i.points.length/3);for(let t=0;t<i.triangles.length;t++)e[i.triangles[t]]=1;return e}function jm(i,e){let t=i.points.length/3,n=new Float64Array(t);for(let s=0;s<t;s++)n[s]=TM(i,e,s);return n}var AM={Pa:[[1e6,"MPa",1e-6],[1e3,"kPa",.001],[0,"Pa",1]],m:[[1e-4,"mm",1e3],[1e-7,"µm",1e6],[0,"nm",1e9]],N:[[1e3,"kN",.001],[0,"N",1]],"N m":[[1e3,"kN m",.001],[0,"N m",1]],W:[[1e3,"kW",.001],[0,"W",1]],s:[[1,"s",1],[.001,"ms",1e3],[0,"µs",1e6]],rad:[[.1,"rad",1],[1e-4,"mrad",1e3],[0,"µrad",1e6]]};function Ui(i,e){let t=AM[i.replace("·"," ")];if(!t)return{symbol:i==="1"?"":i,factor:1};let n=Math.abs(e);if(!(n>0))return{symbol:t[0][1],factor:t[0][2]};let s=t.find(([r])=>n>=r)??t[t.length-1];return{symbol:s[1],factor:s[2]}}var qc={symbol:"MPa",factor:1e-6},RM="−";function Fn(i,e=4){if(Number.isNaN(i))return"no value";if(i===0)return"0";let t=Math.abs(i),n;if(t>=1e6||t<1e-4)n=i.toExponential(e-1).replace("e+","e");else{let s=Math.max(0,e-1-Math.floor(Math.log10(t)));n=i.toFixed(Math.min(s,12)),n.includes(".")&&(n=n.replace(/\.?0+$/,""))}return n.replaceAll("-",RM)}function Qm(i,e,t=4){if(!Number.isFinite(i))return"no value";let n=Ui(e,i);return`${Fn(i*n.factor,t)} ${n.symbol}`.trim()}function eg(i){if(!(i>0)||!Number.isFinite(i))return i;let e=10**Math.floor(Math.log10(i)),t=i/e,n=t>=5?5:t>=2?2:1;return Number((n*e).toPrecision(3))}var tg={bearing:"#2f6fb5",mesh:"#c2502b"},CM=new X(0,1,0),Yc=class{group=new nn;labels=[];#e=new Qr(1,1,1,20).translate(0,.5,0);#t=new ir(1,1,24).translate(0,.5,0);#n;#i=new Ut(new Rn,new zs({transparent:!0}));constructor(e){let t=n=>{let s=new Di(e,["LIT"],{transparent:!0});return s.colour.set(n),s};this.#n={bearing:t(tg.bearing),mesh:t(tg.mesh)},this.#i.renderOrder=2e5,this.#i.frustumCulled=!1,this.#i.onBeforeRender=n=>n.clearDepth()}set(e,t){this.group.clear(),this.labels=[];let n=0;for(let{force:s}of e)n=Math.max(n,Math.hypot(...s));if(n>0){this.group.add(this.#i);for(let s of e){if(s.kind==="bearing"?!t.bearings:!t.meshes)continue;let r=Math.hypot(...s.force);if(!(r>0))continue;let o=t.scale*.5*t.radius*r/n,a=this.arrow(s,o,t.radius*.011);this.group.add(a);let c=new X(...s.force).multiplyScalar(o/r).add(new X(...s.point));if(t.labels){let l=`${s.name?`${s.name}: `:""}${Qm(r,"N",3)}`;this.labels.push({text:l,point:c,kind:s.kind})}}}}arrow(e,t,n){let s=this.#n[e.kind],r=new nn,o=Math.min(5.2*n,.45*t),a=new Ut(this.#e,s);a.scale.set(.55*n,t-o,.55*n);let c=new Ut(this.#t,s);c.scale.set(.33*o,o,.33*o),c.position.y=t-o,r.add(a,c),r.position.set(...e.point),r.quaternion.setFromUnitVectors(CM,new X(...e.force).normalize());for(let l of[a,c])l.renderOrder=200001;return r}dispose(){this.#e.dispose(),this.#t.dispose(),this.#i.geometry.dispose(),this.#i.material.dispose();for(let e of Object.values(this.#n))e.dispose()}};var xf=[48,32,16,8],PM=1.6;function ng(i){let e=-1;return xf.forEach((t,n)=>{i<=PM*t&&(e=n)}),e}function IM(i,e,t){let[n,s,r]=[Math.abs(i),Math.abs(e),Math.abs(t)];return n>=s&&n>=r?i>0?0:1:s>=r?e>0?2:3:t>0?4:5}function ig(i,e,t){let{nodes:n,normals:s,triangles:r,open:o}=e,a=LM(i),c=new Map,l=[],u=new Map,d=[],f=[],h=new Uint32Array(n.length);for(let p=0;p<n.length;p++){let v=3*n[p],[A,b,R]=[i[v],i[v+1],i[v+2]],T=o[n[p]]?`${DM(A,b,a)} ${Math.floor(Math.hypot(A,b)/t+1e-6)} ${Math.floor(R/t+1e-6)}`:`${Math.floor(A/t)},${Math.floor(b/t)},${Math.floor(R/t)}`,_=c.get(T);_===void 0&&(_=c.size,c.set(T,_),l.push(0,0,0,0)),l[4*_]+=A,l[4*_+1]+=b,l[4*_+2]+=R,l[4*_+3]+=1;let[w,F,L]=[s[3*p],s[3*p+1],s[3*p+2]],I=6*_+IM(w,F,L),O=u.get(I);O===void 0&&(O=u.size,u.set(I,O),d.push(_),f.push(0,0,0)),f[3*O]+=w,f[3*O+1]+=F,f[3*O+2]+=L,h[p]=O}let m=new Float32Array(3*d.length),y=new Float32Array(3*d.length);d.forEach((p,v)=>{let A=Math.hypot(f[3*v],f[3*v+1],f[3*v+2])||1;for(let b=0;b<3;b++)m[3*v+b]=l[4*p+b]/l[4*p+3],y[3*v+b]=f[3*v+b]/A});let g=[];for(let p=0;p<r.length;p+=3){let[v,A,b]=[h[r[p]],h[r[p+1]],h[r[p+2]]];d[v]===d[A]||d[A]===d[b]||d[b]===d[v]||g.push(v,A,b)}return{points:m,normals:y,triangles:Uint32Array.from(g)}}function LM(i){let e=0,t=0;for(let n=0;n<i.length;n+=3)e+=i[n],t+=i[n+1];return Math.atan2(t,e)}function DM(i,e,t){return Math.sin(Math.atan2(e,i)-t)>0?"l":"r"}var vf=Math.cos(32*Math.PI/180),uo=i=>i===2147483648?0:i;function NM(i){let e=i.length/3,t=new Uint32Array(i.buffer,i.byteOffset,i.length),n=1;for(;n<2*e;)n*=2;let s=new Uint32Array(n),r=new Uint32Array(e);for(let o=0;o<e;o++){let[a,c,l]=[uo(t[3*o]),uo(t[3*o+1]),uo(t[3*o+2])],u=Math.imul(a,2654435761)^Math.imul(c,2246822507)^Math.imul(l,3266489909);for(u=(u^u>>>15)&n-1;;){let d=s[u];if(d===0){s[u]=o+1,r[o]=o;break}let f=3*(d-1);if(uo(t[f])===a&&uo(t[f+1])===c&&uo(t[f+2])===l){r[o]=d-1;break}u=u+1&n-1}}return r}function FM(i,e){let t=new Uint32Array(e+1);for(let r=0;r<i.length;r++)t[i[r]+1]++;for(let r=0;r<e;r++)t[r+1]+=t[r];let n=t.slice(0,e),s=new Uint32Array(i.length);for(let r=0;r<i.length;r++)s[n[i[r]]++]=r;return{starts:t,corners:s}}function UM(i,e){let t=new Float32Array(e.length);for(let n=0;n<e.length;n+=3){let s=3*e[n],r=3*e[n+1],o=3*e[n+2],a=i[r]-i[s],c=i[r+1]-i[s+1],l=i[r+2]-i[s+2],u=i[o]-i[s],d=i[o+1]-i[s+1],f=i[o+2]-i[s+2];t[n]=c*f-l*d,t[n+1]=l*u-a*f,t[n+2]=a*d-c*u}return t}function OM(i,e,t,n,s){for(let r=e[n];r<e[n+1];r++){let o=t[r],a=o-o%3;if(i[a+(o+1)%3]===s)return a}return-1}function BM(i,e,t){let n=new Map,s=[],r=0;for(let l=0;l<e.length;l++)e[l]&&(s.push(l),r=Math.max(r,Math.abs(i[3*l]),Math.abs(i[3*l+1]),Math.abs(i[3*l+2])));if(s.length===0||!(r>0))return n;let o=r*2e-5,a=(l,u,d)=>`${Math.round(l/o)},${Math.round(u/o)},${Math.round(d/o)}`,c=new Map;for(let l of s)c.set(a(i[3*l],i[3*l+1],i[3*l+2]),l);for(let l of[1,-1]){let u=l*2*Math.PI/t,d=Math.cos(u),f=Math.sin(u);for(let h of s){let m=d*i[3*h]-f*i[3*h+1],y=f*i[3*h]+d*i[3*h+1],g=i[3*h+2],p;for(let v=0;v<27&&p===void 0;v++){let A=(v%3-1)*o*.5,b=(Math.floor(v/3)%3-1)*o*.5,R=(Math.floor(v/9)-1)*o*.5;p=c.get(a(m+A,y+b,g+R))}p!==void 0&&n.set(h,[...n.get(h)??[],[p,-l]])}}return n}function $c(i,e,t){let n=i.length/3,s=NM(i),r=e.map(m=>s[m]),{starts:o,corners:a}=FM(r,n),c=UM(i,e),l=new Uint8Array(n),u=[];for(let m=0;m<e.length;m++){let y=m-m%3,g=r[m],p=r[y+(m+1)%3];if(g===p)continue;let v=OM(r,o,a,p,g);v<0?(l[g]=l[p]=1,t===1&&u.push(m)):y<v&&yf(c,y,c,v)<vf&&u.push(m)}let d=t>1?BM(i,l,t):new Map,f=kM(e,s,t,o,a,c,d),h=new Uint32Array(2*u.length);u.forEach((m,y)=>{let g=m-m%3;h[2*y]=f.triangles[m],h[2*y+1]=f.triangles[g+(m+1)%3]});for(let m=0;m<n;m++)l[m]=l[s[m]];return{...f,features:h,open:l}}function yf(i,e,t,n){let s=i[e]*t[n]+i[e+1]*t[n+1]+i[e+2]*t[n+2],r=Math.hypot(i[e],i[e+1],i[e+2])*Math.hypot(t[n],t[n+1],t[n+2]);return r>0?s/r:1}function kM(i,e,t,n,s,r,o){let a=e.length,c=[],l=[],u=new Uint32Array(a),d=new Uint32Array(i.length),f=2*Math.PI/t;for(let h=0;h<a;h++){let m=c.length;u[h]=m;let y=e[h],g=VM(y,o,n,s,r,f);for(let p=n[y];p<n[y+1];p++){let v=s[p];if(i[v]!==h)continue;let A=v-v%3,b=0,R=0,T=0;for(let F=n[y];F<n[y+1];F++){let L=s[F]-s[F]%3;L!==A&&yf(r,A,r,L)<vf||(b+=r[L],R+=r[L+1],T+=r[L+2])}for(let F=0;F<g.length;F+=3)yf(r,A,g,F)<vf||(b+=g[F],R+=g[F+1],T+=g[F+2]);let _=Math.hypot(b,R,T)||1;b/=_,R/=_,T/=_;let w=m;for(;w<c.length;){let F=3*w;if(l[F]*b+l[F+1]*R+l[F+2]*T>.99999)break;w++}w===c.length&&(c.push(h),l.push(b,R,T)),d[v]=w}c.length===m&&(c.push(h),l.push(0,0,1))}return{nodes:Uint32Array.from(c),firstVertex:u,normals:Float32Array.from(l),triangles:d}}var zM=[];function VM(i,e,t,n,s,r){let o=e.get(i);if(!o)return zM;let a=[];for(let[c,l]of o){let u=Math.cos(l*r),d=Math.sin(l*r);for(let f=t[c];f<t[c+1];f++){let h=n[f]-n[f]%3;a.push(u*s[h]-d*s[h+1],d*s[h]+u*s[h+1],s[h+2])}}return a}function sg(i,e){let t=new Float32Array(3*e.length);for(let n=0;n<e.length;n++){let s=3*e[n];t[3*n]=i[s],t[3*n+1]=i[s+1],t[3*n+2]=i[s+2]}return t}var ho=class{constructor(e,t,n){this.input=e;let{surface:s,points:r}=e;this.#s=n??1,this.#r=s.nodes,this.triangleCount=s.triangles.length/3;let o=new qt(sg(r,s.nodes),3),a={position:o};e.displacements&&(a.displacement=new qt(sg(e.displacements,s.nodes),3),this.#o=new qt(new Float32Array(s.nodes.length).fill(mf),1),a.field=this.#o),this.box=new jn().setFromBufferAttribute(o),this.sphere=this.box.getBoundingSphere(new Zn),n!==null&&(this.#c=n,this.#a=new Qo(new Float32Array(2*n),2),this.#a.setUsage(Jh),a.copyRotation=this.#a);let c=(h,m=!1)=>{let y=new to;for(let[g,p]of Object.entries(a))y.setAttribute(g,p);return m&&y.setAttribute("normal",new qt(s.normals,3)),y.setIndex(new qt(h,1)),y.instanceCount=n??1,y},l=Uint32Array.from(e.edges,h=>s.firstVertex[h]),u=c(s.triangles,!0),d=c(s.features),f=c(l);this.#e=[u,d,f],this.#t=u,this.surface=new Ut(u,t.surface),this.features=new Kr(d,t.features),this.edges=new Kr(f,t.edges),this.stencils=[new Ut(u,t.stencilBack),new Ut(u,t.stencilFront)];for(let h of[this.surface,this.features,this.edges,...this.stencils])h.frustumCulled=!1,h.matrixAutoUpdate=!1,this.group.add(h);this.group.matrixAutoUpdate=!1,n!==null&&this.setCopies(Array.from({length:n},(h,m)=>m),n)}input;group=new nn;surface;features;edges;stencils;triangleCount;sphere;box;#e;#t;#n=[];#i=-1;#s;#r;#o=null;#a=null;#c=1;setLevel(e){if(e===this.#i||!this.#a)return;this.#i=e;let t=e<0?this.#t:this.#n[e];if(!t){let n=2*this.sphere.radius/xf[e],s=ig(this.input.points,this.input.surface,n);t=new to,t.setAttribute("position",new qt(s.points,3)),t.setAttribute("normal",new qt(s.normals,3)),t.setAttribute("copyRotation",this.#a),t.setIndex(new qt(s.triangles,1)),this.#n[e]=t,this.#e.push(t)}t.instanceCount=this.#s;for(let n of[this.surface,...this.stencils])n.geometry=t}get drawnTriangles(){return this.surface.geometry.index.count/3}setCopies(e,t){let n=this.#a;if(!n)return;let s=n.array;for(let r=0;r<t;r++){let o=2*Math.PI*e[r]/this.#c;s[2*r]=Math.cos(o),s[2*r+1]=Math.sin(o)}n.clearUpdateRanges(),n.addUpdateRange(0,2*t),n.needsUpdate=!0,this.#s=t;for(let r of this.#e)r.instanceCount=t;this.group.visible=t>0}setField(e){if(!this.#o)return;let t=this.#o.array;for(let n=0;n<this.#r.length;n++){let s=e?e[this.#r[n]]:NaN;t[n]=Number.isFinite(s)?s:mf}this.#o.needsUpdate=!0}dispose(){for(let e of this.#e)e.dispose()}};var HM=.28,rg=7,GM=6e4,Jc=class{constructor(e,t,n,s){this.part=e;this.#i=new rt(s),this.#s=new rt("#b4b9bf").lerp(this.#i,.4),this.#e=gf(t,!1),this.#t=gf(t,!0),this.#n=zm(t),this.surface=$c(e.points,e.triangles,e.copies),this.copies=new ho({...e,surface:this.surface},this.#e,e.copies),this.#r=Array.from({length:e.copies},(o,a)=>a),this.#o=new Uint32Array(e.copies);let r=0;for(let o=0;o<e.points.length;o+=3)r=Math.max(r,e.points[o]**2+e.points[o+1]**2+e.points[o+2]**2);this.radius=Math.sqrt(r),this.group.matrixAutoUpdate=!1,this.group.add(this.copies.group),this.cap=new Ut(n,this.#n),this.cap.frustumCulled=!1,this.cap.matrixAutoUpdate=!1,this.cap.onAfterRender=o=>o.clearStencil(),this.#f=e.index,this.refresh()}part;group=new nn;cap;copies;surface;radius;meshes=[];visibility="visible";#e;#t;#n;#i;#s;#r;#o;#a=-1;#c=NaN;#u=!1;#l=!1;#h=!1;#f;get materials(){return[...Object.values(this.#e),...Object.values(this.#t),this.#n]}setMeshes(e,t){for(let n of this.meshes)this.group.remove(n.group);this.meshes=e;for(let n of e)this.group.add(n.group);this.#r=[];for(let n=0;n<this.part.copies;n++)t.has(n)||this.#r.push(n);this.#c=NaN,this.refresh()}get meshMaterials(){return this.#t}get presentCopies(){return this.#r}setVisibility(e){this.visibility=e,this.refresh()}setFieldMode(e){this.#u=e,this.refresh()}setEdges(e){this.#l=e,this.refresh()}setCut(e){this.#h=e;for(let t of this.materials)t.cut=e;this.refresh()}refresh(){let e=this.visibility==="translucent",t=this.visibility!=="hidden";this.group.visible=t,this.cap.visible=t&&this.#h;let n=e?HM:1;for(let r of[this.#e,this.#t]){r.surface.alpha=n,r.surface.depthWrite=!e;let o=this.#h||this.meshes.length>0;r.surface.side=o&&!e?Nn:yi,r.surface.colour.copy(this.#u?this.#s:this.#i),r.features.alpha=e?.25:.5,r.edges.alpha=e?.12:.34,r.stencilBack.transparent=r.stencilFront.transparent=e}this.#t.surface.useField=this.#u,this.#n.alpha=e?.5:1,this.#n.depthWrite=!e,this.#n.colour.copy(this.#u?this.#s:this.#i).multiplyScalar(.86);let s=10+3*this.#f;this.cap.renderOrder=s+2;for(let r of[this.copies,...this.meshes])r.edges.visible=this.#l,r.surface.renderOrder=e?1e5:0,r.features.renderOrder=r.edges.renderOrder=100001,r.stencils.forEach((o,a)=>{o.visible=this.#h,o.renderOrder=s+a})}prepare(e,t){if(this.visibility==="hidden")return 0;let{sphere:n}=this.copies,s=0,r=0,o=0,a=this.group.matrixWorld;Zc.radius=n.radius;for(let d of this.#r){let f=2*Math.PI*d/this.part.copies,h=Math.cos(f),m=Math.sin(f),{x:y,y:g,z:p}=n.center;Zc.center.set(h*y-m*g,m*y+h*g,p).applyMatrix4(a),e.intersectsSphere(Zc)&&(this.#o[s++]=d,r=(r*31+d+1)%4294967291,o=Math.max(o,n.radius*2*t(Zc.center)))}(s!==this.#a||r!==this.#c)&&(this.copies.setCopies(this.#o,s),this.#a=s,this.#c=r);let c=this.part.copies>1?2*Math.PI*this.radius/this.part.copies:2*n.radius,l=o*Math.min(c,2*n.radius)/(2*n.radius||1);this.copies.features.visible=l>rg,this.copies.edges.visible=this.#l&&l>2*rg,this.copies.setLevel(s*this.copies.triangleCount>GM?ng(o):-1);let u=s*this.copies.drawnTriangles;for(let d of this.meshes)u+=d.triangleCount;return u}dispose(){this.copies.dispose();for(let e of this.materials)e.dispose()}},Zc=new Zn;var WM=.05,Kc=class{constructor(e){this.scene=e;this.contacts=new Hc(e.uniforms),this.forces=new Yc(e.uniforms),e.root.add(this.contacts.group,this.forces.group),e.scene.add(this.cut.group)}scene;views=[];position=null;meshes=[];colours=[];factor=0;limits=null;triangles=0;cut=new Xc;contacts;forces;centre=new X;radius=1;#e=new WeakMap;#t=new WeakMap;#n=new WeakMap;#i=null;#s=new vt;#r=!1;setParts(e,t){this.clear();let n=new Map;this.#i=t?.poses??null,this.colours=e.map(({kind:r})=>{let o=n.get(r)??0;return n.set(r,o+1),$m(r,o)}),this.views=e.map((r,o)=>{let a=new Jc(r,this.scene.uniforms,this.cut.capGeometry,this.colours[o]);return this.scene.root.add(a.group),this.scene.scene.add(a.cap),a}),this.meshes=e.map(()=>[]);let s=new jn().setFromPoints(this.views.flatMap(r=>this.outline(r))).getBoundingSphere(new Zn);this.centre.copy(s.center),this.radius=s.radius>0?s.radius:1,this.contacts.setBias(8e-4*this.radius),this.cut.setBounds(this.centre,this.radius),this.updateBounds()}updateBounds(){let e=this.views.filter(n=>n.visibility!=="hidden"),t=(e.length>0?e:this.views).flatMap(n=>this.outline(n));this.scene.camera.setBounds(this.centre,this.radius*1.1,t)}outline(e){let t=ur(this.#i,e.part.index,new vt),{min:n,max:s}=e.copies.box,r=[];if(e.part.points.length===0)return r;if(e.part.copies>1){let o=0,a=e.part.points;for(let c=0;c<a.length;c+=3)o=Math.max(o,Math.hypot(a[c],a[c+1]));for(let c=0;c<24;c++){let l=2*Math.PI*c/24;for(let u of[n.z,s.z])r.push(new X(o*Math.cos(l),o*Math.sin(l),u))}}else for(let o=0;o<8;o++)r.push(new X(o&1?s.x:n.x,o&2?s.y:n.y,o&4?s.z:n.z));return r.map(o=>o.applyMatrix4(t))}setPosition(e){this.position=e,this.meshes=this.views.map(()=>[]);let t=this.views.map(()=>[]),n=this.views.map(()=>new Set);if(e){let{views:s}=this.prepare(e);e.meshes.forEach((r,o)=>{this.meshes[r.part].push(r),t[r.part].push(s[o]);for(let a of r.copies)n[r.part].add(a)})}this.views.forEach((s,r)=>{ur(e?.poses??null,r,s.group.matrix),s.setMeshes(t[r],n[r])})}prepare(e){let t=this.#e.get(e);return t||(t={views:e.meshes.map(s=>{let r=$c(s.points,s.triangles,1);return new ho({...s,surface:r},this.views[s.part].meshMaterials,null)}),field:null},this.#e.set(e,t)),t}release(e){for(let t of this.#e.get(e)?.views??[])t.dispose()}values(e,t){let n=this.#t.get(e);n||this.#t.set(e,n=new Map);let s=n.get(t);return s||n.set(t,s=jm(e,t)),s}limitsOf(e,t){let n=this.extremes(e,t);return n?[n.min.value,n.max.value]:null}shown(e,t){let n=this.views[t]?.part.name;return n!==void 0&&e.parts[n]!=="hidden"}cellShown(e,t,n){let s=t.contacts.parts;return this.shown(e,s[2*n])||this.shown(e,s[2*n+1])}extremes(e,t){let{field:n}=t.colours,s=null,r=null;if(Ni(n))for(let o of e.meshes){if(!this.shown(t,o.part))continue;let a=this.values(o,n),c=this.#n.get(o);c||this.#n.set(o,c=Km(o));for(let l=0;l<a.length;l++){let u=a[l];!c[l]||!Number.isFinite(u)||((!s||u<s.value)&&(s={value:u,mesh:o,index:l}),(!r||u>r.value)&&(r={value:u,mesh:o,index:l}))}}else if(n==="contact_pressure"&&e.contacts){let o=Float64Array.from(e.contacts.pressures,(c,l)=>c>0&&this.cellShown(t,e,l)?c:NaN),a=Jm(o);a&&(s={value:0,mesh:null,index:a.minIndex},r={value:a.max,mesh:null,index:a.maxIndex})}return s&&r?{min:s,max:r}:null}extremePoint(e,t){let n=new X,{mesh:s,index:r}=e;if(s){let a=new X().fromArray(s.displacements,3*r).multiplyScalar(this.factor);return n.fromArray(s.points,3*r).add(a).applyMatrix4(ur(t.poses,s.part,this.#s))}let o=t.contacts.corners;for(let a=0;a<4;a++)n.x+=o[12*r+3*a]/4,n.y+=o[12*r+3*a+1]/4,n.z+=o[12*r+3*a+2]/4;return n}apply(e,t){let{uniforms:n}=this.scene,{colours:s}=e,r=this.position,o=Ni(s.field);for(let u of this.views){let d=e.parts[u.part.name]??"visible";u.setVisibility(d),u.setFieldMode(o),u.setEdges(e.mesh_edges)}if(this.applyFrame(e),this.factor=this.deformationFactor(e),n.deformation.value=this.factor,r&&o){let u=this.prepare(r);u.field!==s.field&&(u.field=s.field,u.views.forEach((d,f)=>d.setField(this.values(r.meshes[f],u.field))))}let a=r&&s.field==="contact_pressure"?r.contacts:null;this.contacts.set(a,u=>this.cellShown(e,r,u)),this.contacts.setBehind(e.hidden_contacts);let c=r?this.extremes(r,e):null;this.limits=this.chooseLimits(e,c,t),this.limits&&n.limits.value.set(...this.limits),Xm(this.scene.scaleTexture,s.scale,s.bands),this.forces.set(r?.forces??[],{...e.forces,radius:this.radius}),this.applyCut(e);let l=[...this.forces.labels];if(r&&c&&e.extremes){let u=Math.max(Math.abs(c.min.value),Math.abs(c.max.value)),d=Fi[s.field].quantity==="length"?Ui("m",u):qc,f=(h,m,y)=>{let g=Math.abs(h.value)<1e-9*u?0:h.value*d.factor,p=this.extremePoint(h,r);this.isCutAway(p)||l.push({kind:m,text:`${y} ${Fn(g)} ${d.symbol}`,point:p})};f(c.max,"maximum","max"),o&&f(c.min,"minimum","min")}return l}chooseLimits(e,t,n){let{colours:s}=e;return s.field==="plain"?null:s.limits==="fixed"?[Math.min(s.min,s.max),Math.max(s.min,s.max)]:s.limits==="all"&&n?n:t?[t.min.value,t.max.value]:null}deformationFactor(e){let{mode:t,factor:n}=e.deformation;if(t==="factor")return Number.isFinite(n)?n:0;if(!Ni(e.colours.field))return 0;let s=0;for(let{displacements:r}of this.position?.meshes??[])for(let o=0;o<r.length;o+=3){let a=r[o]**2+r[o+1]**2+r[o+2]**2;a>s&&(s=a)}return s>0?eg(WM*2*this.radius/Math.sqrt(s)):1}applyFrame(e){let{root:t}=this.scene;t.matrix.identity();let n=this.views.findIndex(s=>s.part.name===e.frame);n>=0&&this.position&&this.#i&&(ur(this.#i,n,t.matrix),t.matrix.multiply(ur(this.position.poses,n,this.#s).invert())),t.updateMatrixWorld(!0)}applyCut(e){this.cut.apply(e.cut,this.scene.uniforms.cutPlane.value);for(let t of this.views)t.cap.matrix.copy(this.cut.capMatrix),t.cap.updateMatrixWorld(!0);if(this.#r!==e.cut.on){this.#r=e.cut.on;for(let t of this.views)t.setCut(this.#r);for(let t of this.contacts.materials)t.cut=this.#r}}isCutAway(e){let t=this.cutPlane,n=og.copy(e).applyMatrix4(this.scene.root.matrix);return t!==null&&t.x*n.x+t.y*n.y+t.z*n.z+t.w>0}get cutPlane(){return this.#r?this.scene.uniforms.cutPlane.value:null}prepareFrame(){let e=this.scene.frustum(),{active:t,state:n,direction:s}=this.scene.camera,r=this.scene.height/n.height,o=t.position.distanceTo(XM.fromArray(n.target)),a=n.projection==="orthographic",c=l=>{if(a)return r;let u=og.copy(t.position).sub(l).dot(s);return u>0?r*o/u:r};this.triangles=0;for(let l of this.views)this.triangles+=l.prepare(e,c)}clear(){for(let e of this.views)e.group.removeFromParent(),e.cap.removeFromParent(),e.dispose();this.views=[],this.position=null,this.#r=!1;for(let e of this.contacts.materials)e.cut=!1}dispose(){this.clear(),this.contacts.dispose(),this.forces.dispose()}},XM=new X,og=new X;function ur(i,e,t){if(!i)return t.identity();let[n,s,r,o,a,c,l,u,d,f,h,m]=i.subarray(12*e,12*e+12);return t.set(n,s,r,f,o,a,c,h,l,u,d,m,0,0,0,1)}var jc=class{element=document.createElement("div");#e=[];#t=[];#n=new X;constructor(){this.element.className="cv-labels"}set(e){for(this.#e=e;this.#t.length>e.length;)this.#t.pop().remove();e.forEach((t,n)=>{let s=this.#t[n];s||(s=document.createElement("div"),s.append(document.createElement("i"),document.createElement("span")),this.#t.push(s),this.element.append(s)),s.className=`cv-label cv-label-${t.kind}`,s.lastElementChild.textContent=t.text})}update(e,t,n,s){this.#e.forEach((r,o)=>{let a=this.#n.copy(r.point).applyMatrix4(t).project(e),c=a.z>-1&&a.z<1&&Math.abs(a.x)<1.02&&Math.abs(a.y)<1.02,{style:l}=this.#t[o];l.display=c?"":"none",c&&(l.transform=`translate(${(.5+.5*a.x)*n}px, ${(.5-.5*a.y)*s}px)`)})}placed(e,t,n,s){return this.#e.map(r=>{let o=r.point.clone().applyMatrix4(t).project(e);return{...r,x:(.5+.5*o.x)*n,y:(.5-.5*o.y)*s,depth:o.z}}).filter(r=>r.depth>-1&&r.depth<1&&r.x>0&&r.x<n&&r.y>0&&r.y<s)}};function Sf(i,e,t,n,s,r){let[o,a,c]=i.origin,[l,u,d]=i.direction,f=n!==null&&s!==0,h=null,m=1/0;for(let y=0;y<t.length;y+=3){let g=3*t[y],p=3*t[y+1],v=3*t[y+2],A=e[g],b=e[g+1],R=e[g+2],T=e[p],_=e[p+1],w=e[p+2],F=e[v],L=e[v+1],I=e[v+2];f&&(A+=s*n[g],b+=s*n[g+1],R+=s*n[g+2],T+=s*n[p],_+=s*n[p+1],w+=s*n[p+2],F+=s*n[v],L+=s*n[v+1],I+=s*n[v+2]);let O=T-A,k=_-b,D=w-R,G=F-A,Y=L-b,H=I-R,le=u*H-d*Y,J=d*G-l*H,Q=l*Y-u*G,ie=O*le+k*J+D*Q;if(ie===0)continue;let fe=1/ie,he=o-A,ee=a-b,me=c-R,ge=(he*le+ee*J+me*Q)*fe;if(ge<-1e-9||ge>1+1e-9)continue;let Me=ee*D-me*k,ve=me*O-he*D,He=he*k-ee*O,Ze=(l*Me+u*ve+d*He)*fe;if(Ze<-1e-9||ge+Ze>1+1e-9)continue;let Oe=(G*Me+Y*ve+H*He)*fe;Oe<=r||Oe>=m||(m=Oe,h={distance:Oe,triangle:y,u:ge,v:Ze,facing:ie>0})}return h}function wf(i,e,t){if(!t)return[0,1/0];let n=t.x*i.x+t.y*i.y+t.z*i.z+t.w,s=t.x*e.x+t.y*e.y+t.z*e.z;if(s===0)return n>0?[1/0,1/0]:[0,1/0];let r=-n/s;return s<0?[Math.max(0,r),1/0]:[0,r]}var bf=new vt,hr=new X,fr=new X,Xs=new Ji,ag=new Zn;function lg(i,e,t,n,s){let[r,o]=wf(i.origin,i.direction,s),a=null,c=(l,u,d,f,h)=>{if(!f||f.distance>o||a&&f.distance>=a.distance)return;let m=f.triangle;a={view:l,copy:u,mesh:d,nodes:[h[m],h[m+1],h[m+2]],weights:[1-f.u-f.v,f.u,f.v],distance:f.distance,point:i.at(f.distance,new X),cap:s!==null&&!f.facing}};for(let l of e){if(l.visibility!=="visible")continue;bf.copy(l.group.matrixWorld).invert(),hr.copy(i.origin).applyMatrix4(bf),fr.copy(i.direction).transformDirection(bf);let u=l.copies.sphere;for(let f of l.presentCopies){let h=-2*Math.PI*f/l.part.copies,m=Math.cos(h),y=Math.sin(h);if(Xs.origin.set(m*hr.x-y*hr.y,y*hr.x+m*hr.y,hr.z),Xs.direction.set(m*fr.x-y*fr.y,y*fr.x+m*fr.y,fr.z),ag.copy(u),!Xs.intersectsSphere(ag)||!Xs.intersectsBox(l.copies.box))continue;let g=Sf(Mf(Xs),l.part.points,l.part.triangles,null,0,r);c(l,f,-1,g,l.part.triangles)}Xs.origin.copy(hr),Xs.direction.copy(fr),(t[l.part.index]??[]).forEach((f,h)=>{let m=Sf(Mf(Xs),f.points,f.triangles,f.displacements,n,r);c(l,-1,h,m,f.triangles)})}return a}function Mf(i){return{origin:[i.origin.x,i.origin.y,i.origin.z],direction:[i.direction.x,i.direction.y,i.direction.z]}}function cg(i,e,t,n){let s=null,r=Mf(i);for(let o=0;o<e.count;o++){if(!(e.pressures[o]>0)||!t(o))continue;let a=e.corners.subarray(12*o,12*o+12),c=Sf(r,a,qM,null,0,n[0]);c&&c.distance<n[1]&&(!s||c.distance<s.distance)&&(s={cell:o,distance:c.distance})}return s}var qM=new Uint32Array([0,1,2,0,2,3]);var YM=6,Ea=new Ji,Ef=new Ji,fg=new vt;function dg(i,e,t){let{scene:n,display:s,state:r}=i;if(!n||!s)return null;n.ray(e,t,Ea);let o=s.cutPlane,a=lg(Ea,s.views,s.meshes,s.factor,o),c=KM(i,e,t,a?.distance??1/0);if(c)return c;if(!a)return null;let{part:l}=a.view,u=new X,d=s.meshes[l.index]?.[a.mesh],f=r.colours.field==="plain"?null:NaN,h=null,m=null;if(a.cap)return u.copy(a.point),{x:e,y:t,part:l.name,tooth:m,value:null,node:h,point:u};if(d){if(ug(d.points,a,u),h=ZM(i,d,a,e,t),h!==null&&u.fromArray(d.points,3*h),Ni(r.colours.field)){let y=s.values(d,r.colours.field);f=h!==null?y[h]:a.nodes.reduce((g,p,v)=>g+a.weights[v]*y[p],0)}m=JM(d,a,u)}else ug(l.points,a,u),u.applyAxisAngle($M,2*Math.PI*a.copy/l.copies),m=l.copies>1?a.copy:null;return u.applyMatrix4(ur(s.position?.poses??null,l.index,fg)),{x:e,y:t,part:l.name,tooth:m,value:f,node:h,point:u}}var $M=new X(0,0,1);function ug(i,e,t){t.set(0,0,0),e.nodes.forEach((n,s)=>{let r=e.weights[s];t.x+=r*i[3*n],t.y+=r*i[3*n+1],t.z+=r*i[3*n+2]})}function ZM(i,e,t,n,s){let r=i.scene,o=i.display.factor,a=null,c=YM,l=new X;for(let u of t.nodes){l.fromArray(e.displacements,3*u).multiplyScalar(o),l.x+=e.points[3*u],l.y+=e.points[3*u+1],l.z+=e.points[3*u+2],l.applyMatrix4(t.view.group.matrixWorld).project(r.camera.active);let d=Math.hypot((.5+.5*l.x)*r.width-n,(.5-.5*l.y)*r.height-s);d<=c&&(c=d,a=u)}return a}function JM(i,e,t){let{part:n,copies:s}=e.view;if(n.copies<=1)return null;let{center:r}=s.sphere,o=Math.atan2(t.y,t.x)-Math.atan2(r.y,r.x),a=2*Math.PI/n.copies,c=null,l=1/0;for(let u of i.copies){let d=Math.abs(Math.atan2(Math.sin(o-u*a),Math.cos(o-u*a)));d<l&&(l=d,c=u)}return c}function KM(i,e,t,n){let{display:s,state:r}=i,o=s?.position,a=r.colours.field==="contact_pressure"?o?.contacts:null;if(!a||!o||!s)return null;let c=fg.copy(i.scene.root.matrixWorld).invert();Ef.copy(Ea).applyMatrix4(c);let l=wf(Ea.origin,Ea.direction,s.cutPlane);r.hidden_contacts||(l[1]=Math.min(l[1],n+.002*s.radius));let u=cg(Ef,a,m=>s.cellShown(r,o,m),l);if(!u)return null;let d=Ef.at(u.distance,new X),f=r.parts[hg(i,a.parts[2*u.cell])]==="hidden"?1:0,h=a.parts[2*u.cell+f];return{x:e,y:t,part:hg(i,h),tooth:a.teeth[2*u.cell+f],value:a.pressures[u.cell],node:null,point:d}}function hg(i,e){return i.parts?.parts[e]?.name??`part ${e}`}var jM=["gear","shaft","bearing","body"];function tu(i){return typeof i=="object"&&i!==null&&!Array.isArray(i)?i:null}function Qc(i){return Array.isArray(i)?i:[]}function eu(i,e,t,n){for(let s=0;s<t.length;s++)if(t[s]>=n)throw new dn(i,`${e}: index ${t[s]} exceeds the ${n} points`)}function pg(i){let e=Sa.parse("parts.bin",i);if(!Array.isArray(e.header.parts))throw new dn(e.name,"the list of parts is missing");let t=e.header.parts.map((n,s)=>{let r=tu(n);if(!r)throw new dn(e.name,`part ${s} is not an object`);let o=typeof r.name=="string"?r.name:`part ${s}`,a=Number(r.copies??1);if(!Number.isInteger(a)||a<1)throw new dn(e.name,`${o}: the number of copies is not valid`);let c=e.f32(r.points,3,`${o}, points`),l=e.u32(r.triangles,3,`${o}, triangles`),u=r.edges?e.u32(r.edges,2,`${o}, edges`):new Uint32Array;eu(e.name,`${o}, triangles`,l,c.length/3),eu(e.name,`${o}, edges`,u,c.length/3);let d=jM.includes(String(r.kind))?r.kind:"body";return{index:s,name:o,kind:d,copies:a,points:c,triangles:l,edges:u}});return{model:String(e.header.model??""),fidelity:String(e.header.fidelity??""),parts:t}}function Tf(i){if(!Array.isArray(i)||i.length!==3)return null;let e=i.map(t=>typeof t=="number"?t:NaN);return e.every(Number.isFinite)?e:null}function QM(i,e){let t=tu(i),n=Tf(t?.point),s=Tf(t?.force);return!t||!n||!s?null:{kind:t.kind==="mesh"?"mesh":"bearing",name:String(t.name??""),point:n,force:s,moment:Tf(t.moment)??[0,0,0],parts:Qc(t.parts).filter(r=>typeof r=="number"&&r>=0&&r<e)}}function ew(i,e){let t=tu(e);if(!t)return null;let n=i.f32(t.corners,12,"contacts, corners"),s=i.f32(t.pressures,1,"contacts, pressures"),r=i.u32(t.parts,2,"contacts, parts"),o=i.u32(t.teeth,2,"contacts, teeth"),a=s.length;if(n.length!==12*a||r.length!==2*a||o.length!==2*a)throw new dn(i.name,"contacts: the arrays have different lengths");return a>0?{count:a,corners:n,pressures:s,parts:r,teeth:o}:null}function tw(i,e,t,n){let s=tu(e),r=n[Number(s?.part)];if(!s||!r)throw new dn(i.name,`mesh ${t}: the part does not exist`);let o=`mesh of ${r.name}`,a=i.f32(s.points,3,`${o}, points`),c=i.f32(s.displacements,3,`${o}, displacements`),l=i.f32(s.stresses,6,`${o}, stresses`),u=i.u32(s.triangles,3,`${o}, triangles`),d=s.edges?i.u32(s.edges,2,`${o}, edges`):new Uint32Array,f=a.length/3;if(c.length!==3*f||l.length!==6*f)throw new dn(i.name,`${o}: the arrays have different lengths`);eu(i.name,`${o}, triangles`,u,f),eu(i.name,`${o}, edges`,d,f);let h=Qc(s.copies).filter(m=>typeof m=="number"&&m>=0&&m<r.copies);return{part:r.index,copies:h,points:a,displacements:c,stresses:l,triangles:u,edges:d}}function mg(i,e,t){let n=Sa.parse(i,e),{header:s}=n,r=n.f64(s.poses,12,"poses");if(r.length!==12*t.length)throw new dn(i,`${r.length/12} poses for ${t.length} parts; the files are from different runs`);return{position:Number(s.position??0),time:Number(s.time??0),poses:r,contacts:ew(n,s.contacts),forces:Qc(s.forces).map(o=>QM(o,t.length)).filter(o=>o!==null),meshes:Qc(s.meshes).map((o,a)=>tw(n,o,a,t)),bytes:e.byteLength}}async function gg(i,e){try{let t=atob(i),n=new Uint8Array(t.length);for(let r=0;r<t.length;r++)n[r]=t.charCodeAt(r);let s=new Blob([n]).stream().pipeThrough(new DecompressionStream("gzip"));return await new Response(s).arrayBuffer()}catch(t){let n=t instanceof Error?t.message:String(t);throw new Error(`${e}: the compressed data are damaged (${n})`)}}function Af(i){let e=i.positions??[];return{title:i.title,provenance:i.provenance,outputs:i.outputs,parts:()=>gg(i.parts,"parts.bin"),positions:async()=>e.map(({position:t,time:n})=>({position:t,time:n})),position:t=>{let n=e[t];return n?gg(n.data,nu(n.position)):Promise.reject(new Error(`position ${t} does not exist`))}}}function nu(i){return`position-${String(i).padStart(4,"0")}.bin`}var nw=384e6,iu=class{constructor(e,t){this.source=e;this.parts=t}source;parts;list=[];onEvict=null;#e=new Map;#t=new Map;#n=0;async update(){this.list=await this.source.positions()}cached(e){return this.#e.get(e)}load(e){let t=this.#e.get(e);if(t)return this.#e.delete(e),this.#e.set(e,t),Promise.resolve(t);let n=this.#t.get(e);if(n)return n;let s=this.read(e).finally(()=>this.#t.delete(e));return this.#t.set(e,s),s}async read(e){let t=this.list[e],n=nu(t?.position??e),s=mg(n,await this.source.position(e),this.parts);this.#e.set(e,s),this.#n+=s.bytes;for(let[r,o]of this.#e){if(this.#n<=nw||r===e)break;this.#e.delete(r),this.#n-=o.bytes,this.onEvict?.(o)}return s}dispose(){for(let e of this.#e.values())this.onEvict?.(e);this.#e.clear(),this.#n=0}};var Rf=24,iw=260,sw={front:[-90,0],back:[90,0],left:[180,0],right:[0,0],top:[-90,90],bottom:[-90,-90],isometric:[-50,30]},su=class{perspective=new $n(Rf);orthographic=new eo;onChange=null;#e={projection:"perspective",target:[0,0,0],azimuth:-50,elevation:30,height:1};#t=1;#n=new X;#i=1;#s=[];#r=!1;#o=!1;#a=0;#c=new X;#u=new X;#l=new X;get active(){return this.#e.projection==="perspective"?this.perspective:this.orthographic}get state(){return{...this.#e,target:[...this.#e.target]}}setBounds(e,t,n){this.#n.copy(e),this.#i=t>0?t:1,this.#s=n,this.update()}setFitPoints(e){this.#s=e}setAspect(e){this.#t=e>0?e:1,this.#r&&Object.assign(this.#e,this.fitted(this.#e.azimuth,this.#e.elevation)),this.update()}set(e,t=!1){this.interrupt(),this.#e={...e,target:[...e.target]},this.changed(t)}setProjection(e){this.#e.projection=e,this.changed(!0)}orbit(e,t){this.interrupt(),this.#e.azimuth=Pf(this.#e.azimuth+e),this.#e.elevation=Cf(this.#e.elevation+t,-90,90),this.changed(!0)}pan(e,t){this.interrupt(),this.shift(e,t),this.changed(!0)}zoom(e,t=0,n=0){this.interrupt();let s=Cf(this.#e.height*e,this.#i*1e-4,this.#i*40),r=s/this.#e.height;this.shift(-t*(1-r),-n*(1-r)),this.#e.height=s,this.changed(!0)}view(e,t=!0){let[n,s]=sw[e],r={...this.#e,azimuth:n,elevation:s};this.#o=t,t&&Object.assign(r,this.fitted(n,s)),this.animateTo(r)}fit(e=!0){let t={...this.#e,...this.fitted(this.#e.azimuth,this.#e.elevation)};this.#o=!0,e?this.animateTo(t):(this.set(t,!0),this.#r=!0)}interrupt(){cancelAnimationFrame(this.#a),this.#r=!1}fitted(e,t){if(this.#s.length===0){let h=2.1*this.#i/Math.min(1,this.#t);return{target:[this.#n.x,this.#n.y,this.#n.z],height:h}}let[n,s,r]=[new X,new X,new X];_g(e,t,n,s,r);let o=new jn,a=new X,c=this.#s.map(h=>new X(h.dot(n),h.dot(s),h.dot(r)));for(let h of c)o.expandByPoint(h);let l=o.getCenter(a),u=this.#e.projection==="perspective"?Math.tan(Rf*Math.PI/360):0,d=.001*this.#i;for(let h of c){let m=(h.z-l.z)*u;d=Math.max(d,2*(Math.abs(h.y-l.y)+m),2*(Math.abs(h.x-l.x)/this.#t+m))}d*=1.1;let f=n.multiplyScalar(l.x).addScaledVector(s,l.y).addScaledVector(r,l.z);return{target:[f.x,f.y,f.z],height:d}}animateTo(e){if(cancelAnimationFrame(this.#a),matchMedia("(prefers-reduced-motion: reduce)").matches){this.set(e,!0),this.#r=this.#o;return}let t=this.state,n=Pf(e.azimuth-t.azimuth),s=performance.now(),r=o=>{let a=Cf((o-s)/iw,0,1),c=a*a*(3-2*a);this.#e.azimuth=Pf(t.azimuth+c*n),this.#e.elevation=t.elevation+c*(e.elevation-t.elevation),this.#e.height=t.height*(e.height/t.height)**c;for(let l=0;l<3;l++)this.#e.target[l]=t.target[l]+c*(e.target[l]-t.target[l]);a===1&&(this.#e={...e,target:[...e.target]},this.#r=this.#o),this.changed(!0),a<1&&(this.#a=requestAnimationFrame(r))};this.#a=requestAnimationFrame(r)}shift(e,t){let{height:n,target:s}=this.#e;for(let r=0;r<3;r++){let o=this.#c.getComponent(r),a=this.#u.getComponent(r);s[r]-=n*(e*o+t*a)}}changed(e){this.update(),this.onChange?.(e)}get direction(){return this.#l}update(){let{azimuth:e,elevation:t,height:n,target:s}=this.#e;_g(e,t,this.#c,this.#u,this.#l);let r=n/(2*Math.tan(Rf*Math.PI/360)),o=s[0],a=s[1],c=s[2],l=r-(this.#n.x-o)*this.#l.x-(this.#n.y-a)*this.#l.y-(this.#n.z-c)*this.#l.z,u=1.3*this.#i+.02*n;for(let f of[this.perspective,this.orthographic])f.position.set(o+r*this.#l.x,a+r*this.#l.y,c+r*this.#l.z),f.matrix.makeBasis(this.#c,this.#u,this.#l),f.quaternion.setFromRotationMatrix(f.matrix),f.updateMatrixWorld();this.perspective.near=Math.max(l-u,r*.02),this.perspective.far=Math.max(l+u,this.perspective.near*1.1),this.perspective.aspect=this.#t,this.perspective.updateProjectionMatrix();let d=this.orthographic;d.near=l-u,d.far=l+u,d.top=n/2,d.bottom=-n/2,d.right=n/2*this.#t,d.left=-d.right,d.updateProjectionMatrix()}};function _g(i,e,t,n,s){let r=i*Math.PI/180,o=e*Math.PI/180;t.set(-Math.sin(r),Math.cos(r),0),s.set(Math.cos(o)*Math.cos(r),Math.cos(o)*Math.sin(r),Math.sin(o)),n.crossVectors(s,t)}function Cf(i,e,t){return Math.min(Math.max(i,e),t)}function Pf(i){return((i+180)%360+360)%360-180}var fo=class extends Error{constructor(){super("This browser cannot draw three-dimensional pictures: WebGL 2 is not available. Turn on hardware acceleration in the browser's settings, or use another browser."),this.name="NoWebGlError"}},ru=class{constructor(e){this.container=e;this.uniforms=km(this.scaleTexture);let t=this.canvas.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0,depth:!0,powerPreference:"high-performance"});if(!t)throw new fo;this.#e=new kc({canvas:this.canvas,context:t,stencil:!0,alpha:!0}),this.#e.setClearColor(0,0),this.root.matrixAutoUpdate=!1,this.scene.add(this.root),e.append(this.canvas),this.#t=new ResizeObserver(()=>this.resize()),this.#t.observe(e),this.canvas.addEventListener("webglcontextrestored",()=>this.invalidate()),this.resize()}container;canvas=document.createElement("canvas");camera=new su;scene=new Jo;root=new nn;uniforms;scaleTexture=qm();onPrepare=null;onFrame=null;frames=0;width=1;height=1;#e;#t;#n=0;#i=new ps;#s=new vt;resize(){this.width=Math.max(this.container.clientWidth,1),this.height=Math.max(this.container.clientHeight,1);let e=Math.min(window.devicePixelRatio||1,2);this.uniforms.pixelRatio.value=e,this.#e.setPixelRatio(e),this.#e.setSize(this.width,this.height),this.camera.setAspect(this.width/this.height),this.draw()}invalidate(){this.#n||(this.#n=requestAnimationFrame(()=>{this.#n=0,this.draw()}))}frustum(){let{active:e}=this.camera;return this.#s.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this.#i.setFromProjectionMatrix(this.#s)}draw(){this.scene.updateMatrixWorld(),this.onPrepare?.(),this.#e.render(this.scene,this.camera.active),this.frames++,this.onFrame?.()}snapshot(e){let t=this.#e.getPixelRatio(),n=document.createElement("canvas");try{this.uniforms.pixelRatio.value=e,this.#e.setPixelRatio(e),this.#e.setSize(this.width,this.height,!1),this.draw(),n.width=this.canvas.width,n.height=this.canvas.height,n.getContext("2d").drawImage(this.canvas,0,0)}finally{this.uniforms.pixelRatio.value=t,this.#e.setPixelRatio(t),this.#e.setSize(this.width,this.height),this.draw()}return n}ray(e,t,n){let{active:s}=this.camera,r=2*e/this.width-1,o=1-2*t/this.height;return n.origin.set(r,o,-1).unproject(s),n.direction.set(r,o,1).unproject(s).sub(n.origin).normalize(),n}dispose(){cancelAnimationFrame(this.#n),this.#t.disconnect(),this.scaleTexture.dispose(),this.#e.dispose(),this.#e.forceContextLoss(),this.canvas.remove()}};function ou(){return{version:1,camera:null,parts:{},colours:{field:"plain",scale:"viridis",bands:0,limits:"position",min:0,max:1},deformation:{mode:"automatic",factor:1},mesh_edges:!1,hidden_contacts:!0,extremes:!0,forces:{bearings:!1,meshes:!1,labels:!0,scale:1},cut:{on:!1,normal:"z",offset:null,flipped:!1},frame:null,position:0,animation:{speed:10,loop:!0},theme:"system",panels:{parts:!0,settings:!1,plots:!1},plotted:[]}}function au(i,e=ou()){let t=structuredClone(e),n=i??{};for(let[s,r]of Object.entries(t)){let o=n[s];if(o===void 0||s==="version")continue;If(r)&&s!=="parts"&&s!=="camera"?If(o)&&(t[s]=rw(r,o)):s==="camera"?ow(o)&&(t[s]=o):s==="frame"?(o===null||typeof o=="string")&&(t[s]=o):typeof o==typeof r&&o!==null&&(t[s]=o)}return structuredClone(t)}function If(i){return typeof i=="object"&&i!==null&&!Array.isArray(i)}function rw(i,e){let t={...i};for(let n of Object.keys(i)){let s=e[n];s!==void 0&&(n==="normal"||n==="offset"||typeof s==typeof i[n])&&(t[n]=s)}return t}function ow(i){return!If(i)||!Array.isArray(i.target)||i.target.length!==3?!1:[...i.target,i.azimuth,i.elevation,i.height].every(t=>typeof t=="number"&&Number.isFinite(t))&&(i.projection==="perspective"||i.projection==="orthographic")}var lu=class{constructor(e,t){this.element=e;this.changed=t;this.#t.addEventListener("change",this.#n)}element;changed;theme="light";#e="system";#t=matchMedia("(prefers-color-scheme: dark)");#n=()=>{this.set(this.#e),this.changed()};set(e){this.#e=e,this.theme=e==="system"?this.#t.matches?"dark":"light":e,this.element.dataset.theme=this.theme}dispose(){this.#t.removeEventListener("change",this.#n)}};var uu=class{constructor(e,t,n){this.element=e;this.state=au(n,ou()),this.#i=n.colours?.field!==void 0,this.theme=new lu(e,()=>this.changed()),this.theme.set(this.state.theme);try{this.scene=new ru(t),this.display=new Kc(this.scene)}catch(o){this.fail(o instanceof fo?o:new fo);return}let{scene:s,display:r}=this;t.append(this.labels.element),s.onPrepare=()=>r.prepareFrame(),s.onFrame=()=>this.labels.update(s.camera.active,s.root.matrix,s.width,s.height),s.camera.onChange=o=>{this.state.camera=s.camera.state,this.probe=null,s.invalidate(),this.changed(o)}}element;state;status="empty";failure="";notice="";source=null;parts=null;positions=null;probe=null;help=!1;progress=null;scene=null;display=null;labels=new jc;animation=new Gc(this);theme;onChange=null;#e=new Set;#t=0;#n=0;#i;#s=new Map;#r="";subscribe(e){return this.#e.add(e),()=>this.#e.delete(e)}changed(e=!0){e&&(this.#o=!0),!this.#t&&(this.#t=requestAnimationFrame(()=>{this.#t=0;for(let t of this.#e)t();this.#o&&this.onChange?.(structuredClone(this.state)),this.#o=!1}))}#o=!1;fail(e){this.status="failed",this.failure=e instanceof Error?e.message:String(e),this.changed(!1)}async show(e){this.scene&&(this.source=e,this.status="loading",this.notice="",this.changed(!1),await this.load(!0))}async reload(){this.source&&this.scene&&await this.load(!1)}async load(e){let{source:t,display:n,scene:s}=this;if(!t||!n||!s)return;let r=++this.#n,o=()=>r!==this.#n;e&&this.animation.stop();try{let a=pg(await t.parts()),c=new iu(t,a.parts),l="";try{await c.update()}catch(d){l=`The list of positions cannot be read: ${cu(d)}`}let u=c.list.length>0?await c.load(0).catch(d=>(l=cu(d),null)):null;if(o())return;this.positions?.dispose(),this.parts=a,this.positions=c,c.onEvict=d=>n.release(d),this.#s.clear(),this.notice=l,n.setParts(a.parts,u),n.setPosition(u),this.#i||(this.#i=!0,u?.meshes.length?this.state.colours.field="von_mises":u?.contacts&&(this.state.colours.field="contact_pressure")),this.state.position=Math.min(Math.max(0,Math.trunc(this.state.position)),Math.max(0,c.list.length-1)),this.status="ready",this.apply(),n.updateBounds(),this.state.camera?s.camera.set(this.state.camera):a.parts.length>0&&s.camera.fit(!1),this.state.position>0&&await this.goTo(this.state.position),this.changed()}catch(a){o()||this.fail(a)}}async updatePositions(){let{positions:e}=this;if(!e)return;let t=e.list.length===0;try{await e.update()}catch(n){this.notice=`The list of positions cannot be read: ${cu(n)}`}this.#s.clear(),t&&e.list.length>0?await this.load(!0):this.update({})}update(e){let t=this.state;this.state=au(e,t),e.colours?.field&&(this.#i=!0),this.probe=null,this.theme.set(this.state.theme),e.camera&&this.scene&&this.scene.camera.set(this.state.camera),this.apply(),e.parts&&this.display?.updateBounds(),e.position!==void 0&&this.goTo(this.state.position),this.changed()}apply(){let{display:e,scene:t}=this;if(!e||!t||this.status!=="ready")return;let n=e.apply(this.state,this.#s.get(this.limitsKey())??null);this.labels.set(n),t.invalidate(),this.state.colours.limits==="all"&&this.findAllLimits()}setVisibility(e,t){let n={...this.state.parts};for(let s of e)t==="visible"?delete n[s]:n[s]=t;this.update({parts:n})}async goTo(e){let{positions:t,display:n}=this;if(!t||!n||t.list.length===0)return;let s=Math.min(Math.max(0,e),t.list.length-1);this.state.position=s,this.changed();try{let r=await t.load(s);if(t!==this.positions||this.state.position!==s)return;this.notice="",n.position!==r&&n.setPosition(r),this.probe=null,this.apply()}catch(r){if(t!==this.positions||this.state.position!==s)return;this.animation.stop(),this.notice=`${cu(r)}. The picture shows another position.`}this.changed()}limitsKey(){let e=Object.entries(this.state.parts).filter(([,t])=>t==="hidden");return JSON.stringify([this.state.colours.field,e.map(([t])=>t).sort()])}async findAllLimits(){let{positions:e,display:t,state:n}=this,s=this.limitsKey();if(!e||!t||n.colours.field==="plain"||this.#s.has(s)||this.#r===s)return;this.#r=s;let r=()=>this.#r===s&&e===this.positions&&this.state.colours.limits==="all",o=null;for(let c=0;c<e.list.length&&r();c++){this.progress=c/e.list.length,this.changed(!1);let l=await e.load(c).catch(()=>null),u=l&&r()?t.limitsOf(l,this.state):null;u&&(o=o?[Math.min(o[0],u[0]),Math.max(o[1],u[1])]:u)}if(this.#r!==s)return;let a=r();this.#r="",this.progress=null,a&&(o?this.#s.set(s,o):this.#s.set(s,[0,1]),this.apply()),this.changed(!1)}probePointer(e,t){this.probe=this.status==="ready"?dg(this,e,t):null,this.changed(!1)}clearProbe(){this.probe&&(this.probe=null,this.changed(!1))}get hasMeshes(){return(this.display?.position?.meshes.length??0)>0}get missingField(){let{field:e}=this.state.colours,t=this.display?.position;return e==="plain"||this.status!=="ready"?!1:Ni(e)?!t?.meshes.length:!t?.contacts}project(e,t){let{scene:n,display:s}=this,r=s?.views.find(c=>c.part.name===e);if(!n||!r)return null;let o=new X(...t).applyMatrix4(r.group.matrixWorld).project(n.camera.active),a=n.canvas.getBoundingClientRect();return{x:a.left+(.5+.5*o.x)*n.width,y:a.top+(.5-.5*o.y)*n.height}}nodalValue(e,t){let{display:n,parts:s}=this,r=s?.parts.findIndex(c=>c.name===e)??-1,o=n?.meshes[r]?.[0],{field:a}=this.state.colours;return o&&n&&Ni(a)?n.values(o,a)[t]??NaN:NaN}dispose(){this.#n++,cancelAnimationFrame(this.#t),this.animation.stop(),this.positions?.dispose(),this.display?.dispose(),this.scene?.dispose(),this.theme.dispose(),this.#e.clear()}};function cu(i){return i instanceof dn||i instanceof Error?i.message:String(i)}var xg=.35,aw=18;function vg(i,e){let t=i.scene,n=new Map,s=null,r=0,o=0,a=0,c=new X,l=h=>{let m=e.getBoundingClientRect();return{x:h.clientX-m.left,y:h.clientY-m.top}},u=(h,m)=>{if(!i.state.cut.on)return!1;let y=c.copy(i.display.cut.handle).project(t.camera.active);return Math.hypot((.5+.5*y.x)*t.width-h,(.5-.5*y.y)*t.height-m)<aw};e.addEventListener("pointerdown",h=>{e.setPointerCapture(h.pointerId),e.focus({preventScroll:!0});let{x:m,y}=l(h);n.set(h.pointerId,{x:m,y}),n.size>1?s="pan":h.button===0&&u(m,y)?s="cut":s=h.button===0&&!h.shiftKey?"orbit":"pan",i.clearProbe(),e.dataset.drag=s}),e.addEventListener("pointermove",h=>{let{x:m,y}=l(h),g=n.get(h.pointerId);if(!g||!s){let A=u(m,y);e.dataset.handle=String(A),i.display?.cut.setHighlight(A),o=m,a=y,r||=requestAnimationFrame(()=>{r=0,i.probePointer(o,a)});return}let p=m-g.x,v=y-g.y;if(n.size===2){let A=[...n].find(([T])=>T!==h.pointerId)[1],b=Math.hypot(g.x-A.x,g.y-A.y),R=Math.hypot(m-A.x,y-A.y);t.camera.pan(p/2/t.height,-v/2/t.height),b>0&&R>0&&t.camera.zoom(b/R,...f((m+A.x)/2,(y+A.y)/2))}else if(s==="orbit")t.camera.orbit(-p*xg,v*xg);else if(s==="pan")t.camera.pan(p/t.height,-v/t.height);else{let{cut:A}=i.display;yg(i,A.drag(p,v,t.camera.active,t.width,t.height))}g.x=m,g.y=y});let d=h=>{n.delete(h.pointerId),n.size===0&&(s=null,delete e.dataset.drag)};e.addEventListener("pointerup",d),e.addEventListener("pointercancel",d),e.addEventListener("pointerleave",()=>{cancelAnimationFrame(r),r=0,i.clearProbe()}),e.addEventListener("contextmenu",h=>h.preventDefault()),e.addEventListener("dblclick",()=>t.camera.fit());let f=(h,m)=>[(h-t.width/2)/t.height,(t.height/2-m)/t.height];e.addEventListener("wheel",h=>{h.preventDefault();let{x:m,y}=l(h),g=h.deltaY*(h.deltaMode===1?16:1);t.camera.zoom(Math.exp(Math.min(Math.max(g,-240),240)*.0016),...f(m,y))},{passive:!1})}function yg(i,e){let{cut:t}=i.display,n=Math.min(Math.max(t.offset+e,t.range[0]),t.range[1]);i.update({cut:{offset:n}})}var bg=[["View",[{keys:"F",label:"Fit the parts into the picture"},{keys:"1 … 6",label:"Front, back, left, right, top, bottom"},{keys:"7",label:"Isometric"},{keys:"P",label:"Perspective or orthographic"},{keys:"Arrow keys",label:"Orbit (picture focused)"},{keys:"Shift + arrow keys",label:"Pan (picture focused)"},{keys:"+ −",label:"Zoom"}]],["Display",[{keys:"M",label:"Edges of the finite elements"},{keys:"V",label:"Force vectors"},{keys:"C",label:"Cutting plane"},{keys:"[ ]",label:"Move the cutting plane"},{keys:"D",label:"Undeformed, true or automatic deformation"}]],["Animation",[{keys:"K",label:"Play or pause"},{keys:", .",label:"Previous or next position"}]],["Panels",[{keys:"B",label:"Parts"},{keys:"S",label:"Settings"},{keys:"G",label:"Plots"},{keys:"?",label:"This help"},{keys:"Esc",label:"Close"}]],["Pointer",[{keys:"Drag",label:"Orbit"},{keys:"Right or Shift + drag",label:"Pan"},{keys:"Wheel",label:"Zoom at the pointer"},{keys:"Double click",label:"Fit"}]]],lw={1:"front",2:"back",3:"left",4:"right",5:"top",6:"bottom",7:"isometric"};function Sg(i,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let t=e.target;if(t.closest("input:not([type=checkbox]):not([type=range]), select, textarea"))return!1;let{scene:n,state:s,animation:r}=i;if(e.key==="?")return i.help=!i.help,i.changed(!1),!0;if(e.key==="Escape"&&i.help)return i.help=!1,i.changed(!1),!0;if(!n||i.status!=="ready")return!1;let{camera:o}=n;if(t===n.canvas&&e.key.startsWith("Arrow")){let u=e.key==="ArrowRight"?1:e.key==="ArrowLeft"?-1:0,d=e.key==="ArrowUp"?1:e.key==="ArrowDown"?-1:0;return e.shiftKey?o.pan(.05*u,.05*d):o.orbit(-6*u,-6*d),!0}let a=lw[e.key];if(a)return o.view(a),!0;let{panels:c,forces:l}=s;switch(e.key.toLowerCase()){case"f":o.fit();break;case"p":o.setProjection(s.camera?.projection==="orthographic"?"perspective":"orthographic");break;case"+":case"=":o.zoom(.85);break;case"-":case"_":o.zoom(1/.85);break;case"m":i.update({mesh_edges:!s.mesh_edges});break;case"v":{let u=!(l.bearings||l.meshes);i.update({forces:{bearings:u,meshes:u}});break}case"c":i.update({cut:{on:!s.cut.on}});break;case"[":case"]":s.cut.on&&yg(i,(e.key==="["?-.04:.04)*i.display.radius);break;case"d":i.update({deformation:cw(i)});break;case"k":r.toggle();break;case",":r.step(-1);break;case".":r.step(1);break;case"b":i.update({panels:{parts:!c.parts}});break;case"s":i.update({panels:{settings:!c.settings}});break;case"g":i.update({panels:{plots:!c.plots}});break;default:return!1}return!0}function cw(i){let{mode:e,factor:t}=i.state.deformation;return e==="automatic"?{mode:"factor",factor:0}:t===0?{mode:"factor",factor:1}:{mode:"automatic",factor:1}}function Ta(i){let{field:e}=i.state.colours;if(Fi[e].quantity==="stress")return qc;if(Fi[e].quantity==="none")return{symbol:"",factor:1};let t=i.display?.limits;return Ui("m",t?Math.max(Math.abs(t[0]),Math.abs(t[1])):0)}function po(i){return Fi[i.state.colours.field].label}function hu(i){let e=Ta(i),t=i.display?.limits;if(!t)return{ticks:[],unit:e.symbol};let{bands:n}=i.state.colours,s=n>0&&n<=12?n:5,r=t[0]*e.factor,o=t[1]*e.factor;return r===o?{ticks:[{fraction:.5,text:Fn(r)}],unit:e.symbol}:{ticks:Array.from({length:s+1},(c,l)=>{let u=l/s,d=r+u*(o-r);return{fraction:u,text:Fn(Math.abs(d)<1e-9*Math.abs(o-r)?0:d,4)}}),unit:e.symbol}}function Mg(i,e,t,n){let s=new TextEncoder,r=[],o=[],a=0,c=h=>{let m=typeof h=="string"?s.encode(h):h;r.push(m),a+=m.length},l=(h,m)=>{o.push(a),c(`${o.length} 0 obj
${h}
`),m!==void 0&&(c(`stream
`),c(m),c(`
endstream
`)),c(`endobj
`)},u=Math.round(842*t/e),d=`q 842 0 0 ${u} 0 0 cm /Picture Do Q`;c(`%PDF-1.4
`),l("<< /Type /Catalog /Pages 2 0 R >>"),l("<< /Type /Pages /Kids [3 0 R] /Count 1 >>"),l(`<< /Type /Page /Parent 2 0 R /MediaBox [0 0 842 ${u}] /Resources << /XObject << /Picture 4 0 R >> >> /Contents 5 0 R >>`),l(`<< /Type /XObject /Subtype /Image /Width ${e} /Height ${t} /ColorSpace /DeviceRGB /BitsPerComponent 8 /Filter /DCTDecode /Length ${i.length} >>`,i),l(`<< /Length ${d.length} >>`,d),l(`<< /Title <${uw(n)}> /Producer (Calyx) >>`);let f=a;c(`xref
0 ${o.length+1}
0000000000 65535 f 
`);for(let h of o)c(`${String(h).padStart(10,"0")} 00000 n 
`);return c(`trailer
<< /Size ${o.length+1} /Root 1 0 R /Info 6 0 R >>
startxref
${f}
%%EOF
`),new Blob(r,{type:"application/pdf"})}function uw(i){let e="FEFF";for(let t=0;t<i.length;t++)e+=i.charCodeAt(t).toString(16).padStart(4,"0").toUpperCase();return e}var hw=2,fw="system-ui, -apple-system, 'Segoe UI', Roboto, Helvetica, Arial, sans-serif",vs={width:16,height:200,right:92,top:56};function dw(i){let{width:e,height:t}=i.scene,n=getComputedStyle(i.element),s=r=>n.getPropertyValue(r).trim();return{width:e,height:t,text:s("--cv-text"),muted:s("--cv-muted"),background:s("--cv-stage"),halo:s("--cv-stage")}}function Eg(i,e){let{scene:t,labels:n,state:s,display:r}=i,o=[],a=(f,h,m,y="")=>o.push(`<text x="${f.toFixed(1)}" y="${h.toFixed(1)}" fill="${e.text}" stroke="${e.halo}" stroke-width="3" stroke-linejoin="round" paint-order="stroke" ${y}>${pw(m)}</text>`);for(let f of n.placed(t.camera.active,t.root.matrix,e.width,e.height))(f.kind==="maximum"||f.kind==="minimum")&&o.push(`<circle cx="${f.x.toFixed(1)}" cy="${f.y.toFixed(1)}" r="4" fill="none" stroke="${e.text}" stroke-width="1.6"/>`),a(f.x+9,f.y+4,f.text,'font-weight="600"');let{limits:c}=r,{colours:l}=s;if(c&&l.field!=="plain"){let f=e.width-vs.right,h=l.bands>0?l.bands:64;for(let g=0;g<h;g++){let p=wa(co(l.scale,l.bands>0?Ma((g+.5)/h,h):g/(h-1))),v=vs.height/h,A=vs.top+vs.height-(g+1)*v;o.push(`<rect x="${f}" y="${A.toFixed(2)}" width="${vs.width}" height="${(v+.4).toFixed(2)}" fill="${p}"/>`)}let{ticks:m,unit:y}=hu(i);for(let g of m)a(f+vs.width+7,vs.top+vs.height*(1-g.fraction)+4,g.text);a(e.width-16,vs.top-18,`${po(i)}${y?` in ${y}`:""}`,'text-anchor="end" font-weight="600"')}let u=i.positions?.list[s.position],d=[i.source?.title,u?`position ${u.position}`:""].filter(Boolean).join(", ");return d&&a(16,e.height-16,d),i.hasMeshes&&a(16,e.height-36,`deformation × ${r.factor}`),o.join(`
`)}function pw(i){return i.replace(/[&<>"]/g,e=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[e])}function Tg(i,e){return`<svg xmlns="http://www.w3.org/2000/svg" width="${i.width}" height="${i.height}" viewBox="0 0 ${i.width} ${i.height}" font-family="${fw}" font-size="12">
${e}
</svg>
`}function Ag(i,e){let t=i.scene.snapshot(hw),n=document.createElement("canvas");n.width=t.width,n.height=t.height;let s=n.getContext("2d");return s.fillStyle=e.background,s.fillRect(0,0,n.width,n.height),s.drawImage(t,0,0),n}async function mw(i,e){let t=Ag(i,e),n=new Image;return n.src=`data:image/svg+xml;charset=utf-8,${encodeURIComponent(Tg(e,Eg(i,e)))}`,await n.decode(),t.getContext("2d").drawImage(n,0,0,t.width,t.height),t}function wg(i,e,t){return new Promise((n,s)=>{i.toBlob(r=>r?n(r):s(new Error("the picture cannot be encoded")),e,t)})}async function Lf(i,e){if(!i.scene||i.status!=="ready")throw new Error("there is no picture to export");let t=dw(i);if(e==="svg"){let r=Ag(i,t).toDataURL("image/png"),o=`<image width="${t.width}" height="${t.height}" href="${r}"/>
${Eg(i,t)}`;return new Blob([Tg(t,o)],{type:"image/svg+xml"})}let n=await mw(i,t);if(e==="png")return wg(n,"image/png");let s=await wg(n,"image/jpeg",.94);return Mg(new Uint8Array(await s.arrayBuffer()),n.width,n.height,i.source?.title??"")}async function Rg(i,e){let t=await Lf(i,e),n=document.createElement("a"),s=(i.source?.title??"view").replace(/[^\p{L}\p{N}._-]+/gu,"_")||"view";n.href=URL.createObjectURL(t),n.download=`${s}.${e}`,n.click(),setTimeout(()=>URL.revokeObjectURL(n.href),1e4)}var mo,pn,Df,Cg,Nf=Object.is,fu=0,Bg=[],Ff=[],sn=Ct,Pg=sn.__b,Ig=sn.__r,Lg=sn.diffed,Dg=sn.__c,Ng=sn.unmount,Fg=sn.__;function du(i,e){sn.__h&&sn.__h(pn,i,fu||e),fu=0;var t=pn.__H||(pn.__H={__:[],__h:[]});return i>=t.__.length&&t.__.push({}),t.__[i]}function go(i){return fu=1,Of(zg,i)}function Of(i,e,t){var n=du(mo++,2);if(n.t=i,!n.__c&&(n.__=[t?t(e):zg(void 0,e),function(r){var o=(n.__N||n.__)[0],a=n.t(o,r);Nf(o,a)||(n.__N=[a,n.__[1]],n.__c.setState({}))}],n.__c=pn,!pn.__f)){pn.__f=!0;var s=pn.shouldComponentUpdate;pn.shouldComponentUpdate=function(r,o,a){var c=this.__H;if(!c)return!0;var l=!1,u=this.props!=r;if(c.__.some(function(f){f.__N&&(l=!0,Nf(f.__[0],f.__N[0])||(u=!0))}),s){var d=s.call(this,r,o,a);return l?d||u:d}return!l||u}}return n.__}function ys(i,e){var t=du(mo++,3);!sn.__s&&Bf(t.__H,e)&&(t.__P=!0,t.__=i,t.u=e,pn.__H.__h.push(t))}function kg(i,e){var t=du(mo++,4);!sn.__s&&Bf(t.__H,e)&&(t.__P=!1,t.__=i,t.u=e,pn.__h.push(t))}function bs(i){return fu=5,gw(function(){return{current:i}},[])}function gw(i,e){var t=du(mo++,7);return Bf(t.__H,e)&&(t.__=i(),t.__H=e),t.__}function _w(){var i;do{for(;i=Ff.shift();)try{Aa(i)}catch(t){sn.__e(t,{__:(i=i.__P)&&i.__v})}for(;i=Bg.shift();){var e=i.__H;if(i.__P&&e)try{e.__h.some(Aa),e.__h.some(Uf),e.__h=[]}catch(t){e.__h=[],sn.__e(t,i.__v)}}}while(Ff.length)}sn.__b=function(i){pn=null,Pg&&Pg(i)},sn.__=function(i,e){i&&e.__k&&e.__k.__m&&(i.__m=e.__k.__m),Fg&&Fg(i,e)},sn.__r=function(i){Ig&&Ig(i),mo=0;var e=(pn=i.__c).__H;e&&(Df==pn?pn.__h=[]:(e.__h.some(Aa),e.__h.some(Uf),mo=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),Df=pn},sn.diffed=function(i){Lg&&Lg(i);var e=i.__c;e&&e.__H&&(e.__H.__h.length&&Og(Bg.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),Df=pn=null},sn.__c=function(i,e){e.some(function(t){try{t.__h.some(Aa),t.__h=t.__h.filter(function(n){return!n.__||Uf(n)})}catch(n){t.__h=[function(){throw n}]}}),Dg&&Dg(i,e)},sn.unmount=function(i){Ng&&Ng(i);var e,t,n=i.__c;n&&n.__H&&(n.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=i.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,Og(Ff.push(s))}else Aa(s)}catch(r){e=r}}),n.__H=void 0,e&&sn.__e(e,n.__v))};var Ug=typeof requestAnimationFrame=="function";function xw(i){var e,t=function(){clearTimeout(n),Ug&&cancelAnimationFrame(e),setTimeout(i)},n=setTimeout(t,35);Ug&&(e=requestAnimationFrame(t))}function Og(i){i!=1&&Cg==sn.requestAnimationFrame||((Cg=sn.requestAnimationFrame)||xw)(_w)}function Aa(i){var e=pn,t=i.__c;typeof t=="function"&&(i.__c=void 0,t()),pn=e}function Uf(i){var e=pn;i.__c=i.__(),pn=e}function Bf(i,e){return!i||i.length!=e.length||e.some(function(t,n){return!Nf(t,i[n])})}function zg(i,e){return typeof e=="function"?e(i):e}var vw=Symbol.for("pv"),yw=0;function V(i,e,t,n,s,r){e||(e={});var o,a,c=e;if("ref"in c&&typeof i!="function")for(a in c={},e)a=="ref"?o=e[a]:c[a]=e[a];var l={type:i,props:c,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:vw,__v:--yw,__i:-1,__u:0};return(s||r)&&(l.__source=s,l.__self=r),Ct.vnode&&Ct.vnode(l),l}function Vg(i){let[,e]=Of(t=>t+1,0);ys(()=>(e(0),i.subscribe(()=>e(0))),[i])}var bw={parts:"M2.5 3.5h4M2.5 8h4M2.5 12.5h4M9 3.5h4.5M9 8h4.5M9 12.5h4.5",settings:"M2 4.5h7M12 4.5h2M2 11.5h2M7 11.5h7M10.5 3v3M5.5 10v3",fit:"M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10",cube:"M8 1.8l5.5 3v6.4L8 14.2l-5.5-3V4.8zM2.5 4.8L8 8l5.5-3.2M8 8v6.2",perspective:"M2 3.5l12 2v5l-12 2zM8 4.5v7",orthographic:"M2.5 3.5h11v9h-11zM8 3.5v9",mesh:"M2.5 2.5h11v11h-11zM2.5 6.2h11M2.5 9.8h11M6.2 2.5v11M9.8 2.5v11",force:"M3 13L12.5 3.5M7.5 3h5.5v5.5",cut:"M1.5 10.5l5-7h8l-5 7zM3 13.5h4M9.5 13.5h4",plot:"M2.5 2.5v11h11M4.5 10.5l3-4 2.5 2 3.5-5",download:"M8 2v8M4.8 7L8 10.2 11.2 7M2.5 13.5h11",help:"M5.5 6a2.5 2.5 0 1 1 3.6 2.2c-.8.4-1.1.9-1.1 1.8M8 12.6v.4",sun:"M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6M8 1.2v1.6M8 13.2v1.6M1.2 8h1.6M13.2 8h1.6M3.2 3.2l1.1 1.1M11.7 11.7l1.1 1.1M12.8 3.2l-1.1 1.1M4.3 11.7l-1.1 1.1",moon:"M13.2 9.6A5.8 5.8 0 0 1 6.4 2.8a5.6 5.6 0 1 0 6.8 6.8",play:"M5 3l8 5-8 5z",pause:"M5 3v10M11 3v10",next:"M4 3.5l6 4.5-6 4.5zM12.2 3.5v9",previous:"M12 3.5L6 8l6 4.5zM3.8 3.5v9",loop:"M11.5 2l2 2-2 2M13.5 4H5a3 3 0 0 0-3 3M4.5 14l-2-2 2-2M2.5 12H11a3 3 0 0 0 3-3",eye:"M1.5 8S4 3.8 8 3.8 14.5 8 14.5 8 12 12.2 8 12.2 1.5 8 1.5 8M8 6.2a1.8 1.8 0 1 0 0 3.6 1.8 1.8 0 0 0 0-3.6",half:"M8 2.5a5.5 5.5 0 1 0 0 11zM8 2.5a5.5 5.5 0 0 1 0 11M8 5h4.6M8 8h5.5M8 11h4.6",hidden:"M2 2l12 12M6.2 4.1A6 6 0 0 1 8 3.8c4 0 6.5 4.2 6.5 4.2a12 12 0 0 1-1.9 2.3M4 5.2A11 11 0 0 0 1.5 8S4 12.2 8 12.2a6 6 0 0 0 3-.8",pin:"M8 9.5V14M5 9.5h6l-1.3-2V3.3h.8M6.3 7.5L5 9.5M6.3 7.5V3.3h-.8M6.3 3.3h3.4",chevron:"M5.5 3.5L10 8l-4.5 4.5",close:"M3.5 3.5l9 9M12.5 3.5l-9 9"};function Ra({name:i}){return V("svg",{class:"cv-icon",viewBox:"0 0 16 16","aria-hidden":"true",children:V("path",{d:bw[i]})})}function Cn({icon:i,label:e,shortcut:t,pressed:n,disabled:s,onClick:r}){return V("button",{type:"button",class:"cv-tool","aria-label":e,"aria-pressed":n,disabled:s,title:t?`${e} (${t})`:e,onClick:r,children:V(Ra,{name:i})})}function Un({label:i,value:e,options:t,onChange:n,quiet:s}){return V("label",{class:"cv-field",children:[V("span",{class:s?"cv-hidden":"",children:i}),V("select",{"aria-label":i,value:e,onChange:r=>n(r.currentTarget.value),children:t.map(r=>V("option",{value:r.value,disabled:r.disabled,selected:r.value===e,children:r.label},r.value))})]})}function es({label:i,value:e,onChange:t}){return V("label",{class:"cv-check",children:[V("input",{type:"checkbox",checked:e,onChange:n=>t(n.currentTarget.checked)}),V("span",{children:i})]})}function Ca({label:i,value:e,unit:t,min:n,max:s,disabled:r,onChange:o}){let a=Number.isFinite(e)?String(Number(e.toPrecision(6))):"",[c,l]=go(null),u=()=>{if(c===null)return;let d=Number(c.trim().replace(",",".").replace("−","-"));l(null),!(c.trim()===""||!Number.isFinite(d))&&o(Math.min(Math.max(d,n??-1/0),s??1/0))};return V("label",{class:"cv-field",children:[V("span",{children:i}),V("span",{class:"cv-number",children:[V("input",{type:"text",inputMode:"decimal",value:c??a,disabled:r,onInput:d=>l(d.currentTarget.value),onBlur:u,onKeyDown:d=>{d.key==="Enter"&&u(),d.key==="Escape"&&l(null)}}),t?V("span",{class:"cv-unit",children:t}):null]})]})}function kf({label:i,value:e,min:t,max:n,step:s="any",text:r,onInput:o}){return V("label",{class:"cv-field cv-slider",children:[V("span",{children:i}),V("input",{type:"range",min:t,max:n,step:s,value:e,"aria-valuetext":r,onInput:a=>o(Number(a.currentTarget.value))})]})}function _o({title:i,children:e}){return V("section",{class:"cv-section",children:[V("h3",{children:i}),e]})}function Hg({core:i}){let e=bs(null);kg(()=>{e.current.showModal()},[]);let t=()=>{i.help=!1,i.changed(!1)};return V("dialog",{class:"cv-help",ref:e,"aria-labelledby":"cv-help-title",onClose:t,onClick:n=>n.target===e.current&&t(),children:[V("div",{class:"cv-help-head",children:[V("h2",{id:"cv-help-title",children:"Shortcuts"}),V(Cn,{icon:"close",label:"Close",onClick:t})]}),V("div",{class:"cv-help-grid",children:bg.map(([n,s])=>V("section",{children:[V("h3",{children:n}),V("dl",{children:s.map(({keys:r,label:o})=>V("div",{children:[V("dt",{children:V("kbd",{children:r})}),V("dd",{children:o})]},r))})]},n))})]})}function Sw(i){let{scale:e,bands:t}=i.state.colours,n=[];if(t>0)for(let s=0;s<t;s++){let r=wa(co(e,Ma((s+.5)/t,t)));n.push(`${r} ${100*s/t}% ${100*(s+1)/t}%`)}else for(let s=0;s<=20;s++)n.push(`${wa(co(e,s/20))} ${5*s}%`);return`linear-gradient(to top, ${n.join(", ")})`}function Gg({core:i}){let{field:e}=i.state.colours;if(e==="plain")return null;let{ticks:t,unit:n}=hu(i);if(i.missingField||t.length===0)return V("div",{class:"cv-legend cv-legend-empty",role:"note",children:[V("strong",{children:po(i)}),V("span",{children:"No values in this position"})]});let{limits:s}=i.state.colours,r=s==="all"?"all positions":s==="fixed"?"fixed limits":"this position";return V("button",{type:"button",class:"cv-legend","aria-label":`Legend: ${po(i)} from ${t[0].text} to ${t[t.length-1].text} ${n}. Opens the settings.`,title:"Settings of the colours",onClick:()=>i.update({panels:{settings:!i.state.panels.settings}}),children:[V("span",{class:"cv-legend-title",children:[V("strong",{children:po(i)}),n?V("span",{class:"cv-legend-unit",children:n}):null]}),V("span",{class:"cv-scale",children:[V("span",{class:"cv-bar",style:{background:Sw(i)}}),V("span",{class:"cv-ticks",children:t.map((o,a)=>V("span",{style:{bottom:`${100*o.fraction}%`},children:o.text},a))})]}),V("span",{class:"cv-range",children:i.progress!==null?`reading … ${Math.round(100*i.progress)} %`:r})]})}var Mw=[{kind:"gear",label:"Gears"},{kind:"shaft",label:"Shafts"},{kind:"bearing",label:"Bearings"},{kind:"body",label:"Bodies"}],Wg={visible:"translucent",translucent:"hidden",hidden:"visible"},ww={visible:"eye",translucent:"half",hidden:"hidden"};function Xg({core:i}){let e=i.parts?.parts??[];return V("aside",{class:"cv-panel cv-parts","aria-label":"Parts",children:[V("div",{class:"cv-scroll",children:Mw.map(({kind:t,label:n})=>{let s=e.filter(r=>r.kind===t);return s.length>0?V(Ew,{core:i,label:n,parts:s},t):null})}),V("div",{class:"cv-foot",children:V(Un,{label:"Fixed frame",value:i.state.frame??"",options:[{value:"",label:"Ground"},...e.map(({name:t})=>({value:t,label:t}))],onChange:t=>i.update({frame:t||null})})}),i.source?.provenance?.length?V("details",{class:"cv-provenance",children:[V("summary",{children:"Provenance"}),V("dl",{children:i.source.provenance.map(([t,n])=>V("div",{children:[V("dt",{children:t}),V("dd",{title:n,children:n})]},t))})]}):null]})}function Ew({core:i,label:e,parts:t}){let[n,s]=go(!0),r=t.map(({name:c})=>c),o=new Set(r.map(c=>i.state.parts[c]??"visible")),a=o.size===1?[...o][0]:"translucent";return V("div",{class:"cv-group",role:"group","aria-label":e,children:[V("div",{class:"cv-row cv-row-group",children:[V("button",{type:"button",class:"cv-fold","aria-expanded":n,onClick:()=>s(!n),children:[V(Ra,{name:"chevron"}),V("span",{children:e}),V("span",{class:"cv-count",children:t.length})]}),V(qg,{name:e,value:a,onChange:c=>i.setVisibility(r,c)})]}),n?t.map(c=>V(Tw,{core:i,part:c},c.name)):null]})}function Tw({core:i,part:e}){let t=i.state.parts[e.name]??"visible";return V("div",{class:`cv-row cv-row-${t}`,children:[V("span",{class:"cv-swatch",style:{background:i.display?.colours[e.index]}}),V("span",{class:"cv-name",title:e.name,children:e.name}),e.copies>1?V("span",{class:"cv-count",title:`${e.copies} teeth`,children:["z ",e.copies]}):null,i.state.frame===e.name?V("span",{class:"cv-pin",title:"Fixed frame",children:V(Ra,{name:"pin"})}):null,V(qg,{name:e.name,value:t,onChange:n=>i.setVisibility([e.name],n)})]})}function qg({name:i,value:e,onChange:t}){return V("button",{type:"button",class:"cv-eye","aria-label":`${i}: ${e}`,title:`${e}; click for ${Wg[e]}, Alt and click for hidden`,onClick:n=>t(n.altKey?e==="hidden"?"visible":"hidden":Wg[e]),children:V(Ra,{name:ww[e]})})}var Aw="uplot",Rw="u-hz",Cw="u-vt",Pw="u-title",Iw="u-wrap",Lw="u-under",Dw="u-over",Nw="u-axis",mr="u-off",Fw="u-select",Uw="u-cursor-x",Ow="u-cursor-y",Bw="u-cursor-pt",kw="u-legend",zw="u-live",Vw="u-inline",Hw="u-series",Gw="u-marker",Yg="u-label",Ww="u-value",Ia="width",La="height";var $g="bottom",xo="left",zf="right",id="#000",Zg=id+"0",Vf="mousemove",Jg="mousedown",Hf="mouseup",Kg="mouseenter",jg="mouseleave",Qg="dblclick",Xw="resize",qw="scroll",e0="change",xu="dppxchange",sd="--",Eo=typeof window<"u",Yf=Eo?document:null,yo=Eo?window:null,Yw=Eo?navigator:null,Mt,pu;function $f(){let i=devicePixelRatio;Mt!=i&&(Mt=i,pu&&Jf(e0,pu,$f),pu=matchMedia(`(min-resolution: ${Mt-.001}dppx) and (max-resolution: ${Mt+.001}dppx)`),gr(e0,pu,$f),yo.dispatchEvent(new CustomEvent(xu)))}function hi(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Zf(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Gt(i,e,t){i.style[e]=t+"px"}function Oi(i,e,t,n){let s=Yf.createElement(i);return e!=null&&hi(s,e),t?.insertBefore(s,n),s}function bi(i,e){return Oi("div",i,e)}var t0=new WeakMap;function ts(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=t0.get(i);r!=o&&(i.style.transform=r,t0.set(i,r),e<0||t<0||e>n||t>s?hi(i,mr):Zf(i,mr))}var n0=new WeakMap;function i0(i,e,t){let n=e+t,s=n0.get(i);n!=s&&(n0.set(i,n),i.style.background=e,i.style.borderColor=t)}var s0=new WeakMap;function r0(i,e,t,n){let s=e+""+t,r=s0.get(i);s!=r&&(s0.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var rd={passive:!0},$w={...rd,capture:!0};function gr(i,e,t,n){e.addEventListener(i,t,n?$w:rd)}function Jf(i,e,t,n){e.removeEventListener(i,t,rd)}Eo&&$f();function Bi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:fi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function D0(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var N0=i=>i!=null,F0=i=>i!=null&&i>0,bu=D0(N0),Zw=D0(F0);function Jw(i,e,t,n=0,s=!1){let r=s?Zw:bu,o=s?F0:N0;[e,t]=r(i,e,t);let a=i[e],c=i[e];if(e>-1)if(n==1)a=i[e],c=i[t];else if(n==-1)a=i[t],c=i[e];else for(let l=e;l<=t;l++){let u=i[l];o(u)&&(u<a?a=u:u>c&&(c=u))}return[a??Dt,c??-Dt]}function Su(i,e,t,n){let s=l0(i),r=l0(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?Ss:U0,a=s==1?fi:Si,c=r==1?Si:fi,l=a(o(bn(i))),u=c(o(bn(e))),d=bo(t,l),f=bo(t,u);return t==10&&(l<0&&(d=Nt(d,-l)),u<0&&(f=Nt(f,-u))),n||t==2?(i=d*s,e=f*r):(i=z0(i,d),e=Mu(e,f)),[i,e]}function od(i,e,t,n){let s=Su(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var ad=.1,o0={mode:3,pad:ad},Na={pad:0,soft:null,mode:0},Kw={min:Na,max:Na};function vu(i,e,t,n){return wu(t)?a0(i,e,t):(Na.pad=t,Na.soft=n?0:null,Na.mode=n?3:0,a0(i,e,Kw))}function bt(i,e){return i??e}function jw(i,e,t){for(e=bt(e,0),t=bt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function a0(i,e,t){let n=t.min,s=t.max,r=bt(n.pad,0),o=bt(s.pad,0),a=bt(n.hard,-Dt),c=bt(s.hard,Dt),l=bt(n.soft,Dt),u=bt(s.soft,-Dt),d=bt(n.mode,0),f=bt(s.mode,0),h=e-i,m=Ss(h),y=Jn(bn(i),bn(e)),g=Ss(y),p=bn(g-m);(h<1e-24||p>10)&&(h=0,(i==0||e==0)&&(h=1e-24,d==2&&l!=Dt&&(r=0),f==2&&u!=-Dt&&(o=0)));let v=h||y||1e3,A=Ss(v),b=bo(10,fi(A)),R=v*(h==0?i==0?.1:1:r),T=Nt(z0(i-R,b/10),24),_=i>=l&&(d==1||d==3&&T<=l||d==2&&T>=l)?l:Dt,w=Jn(a,T<_&&i>=_?_:ki(_,T)),F=v*(h==0?e==0?.1:1:o),L=Nt(Mu(e+F,b/10),24),I=e<=u&&(f==1||f==3&&L>=u||f==2&&L<=u)?u:-Dt,O=ki(c,L>I&&e<=I?I:Jn(I,L));return w==O&&w==0&&(O=100),[w,O]}var Qw=new Intl.NumberFormat(Eo?Yw.language:"en-US"),ld=i=>Qw.format(i),di=Math,_u=di.PI,bn=di.abs,fi=di.floor,yn=di.round,Si=di.ceil,ki=di.min,Jn=di.max,bo=di.pow,l0=di.sign,Ss=di.log10,U0=di.log2,eE=(i,e=1)=>di.sinh(i)*e,Gf=(i,e=1)=>di.asinh(i/e),Dt=1/0;function c0(i){return(Ss((i^i>>31)-(i>>31))|0)+1}function Kf(i,e,t){return ki(Jn(i,e),t)}function O0(i){return typeof i=="function"}function mt(i){return O0(i)?i:()=>i}var tE=()=>{},B0=i=>i,k0=(i,e)=>e,nE=i=>null,u0=i=>!0,h0=(i,e)=>i==e,iE=/\.\d*?(?=9{6,}|0{6,})/gm,_r=i=>{if(H0(i)||Ys.has(i))return i;let e=`${i}`,t=e.match(iE);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${_r(s)}e${r}`}return Nt(i,n)};function dr(i,e){return _r(Nt(_r(i/e))*e)}function Mu(i,e){return _r(Si(_r(i/e))*e)}function z0(i,e){return _r(fi(_r(i/e))*e)}function Nt(i,e=0){if(H0(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return yn(n)/t}var Ys=new Map;function V0(i){return((""+i).split(".")[1]||"").length}function Ua(i,e,t,n){let s=[],r=n.map(V0);for(let o=e;o<t;o++){let a=bn(o),c=Nt(bo(i,o),a);for(let l=0;l<n.length;l++){let u=i==10?+`${n[l]}e${o}`:n[l]*c,d=(o>=0?0:a)+(o>=r[l]?0:r[l]),f=i==10?u:Nt(u,d);s.push(f),Ys.set(f,d)}}return s}var Fa={},cd=[],So=[null,null],qs=Array.isArray,H0=Number.isInteger,sE=i=>i===void 0;function f0(i){return typeof i=="string"}function wu(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function rE(i){return i!=null&&typeof i=="object"}var oE=Object.getPrototypeOf(Uint8Array),G0="__proto__";function Mo(i,e=wu){let t;if(qs(i)){let n=i.find(s=>s!=null);if(qs(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=Mo(i[s],e)}else t=i.slice()}else if(i instanceof oE)t=i.slice();else if(e(i)){t={};for(let n in i)n!=G0&&(t[n]=Mo(i[n],e))}else t=i;return t}function mn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=G0&&(wu(i[s])?mn(i[s],Mo(n[s])):i[s]=Mo(n[s]))}return i}var aE=0,lE=1,cE=2;function uE(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function hE(i,e){if(pE(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return mE(o[0])||(o=dE(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let c=i[o][0],l=c.length;for(let u=0;u<l;u++)t.add(c[u])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],c=a[0];for(let l=1;l<a.length;l++){let u=a[l],d=Array(s).fill(void 0),f=e?e[o][l]:lE,h=[];for(let m=0;m<u.length;m++){let y=u[m],g=r.get(c[m]);y===null?f!=aE&&(d[g]=y,f==cE&&h.push(g)):d[g]=y}uE(d,h,s),n.push(d)}}return n}var fE=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function dE(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let c=0;c<t;c++)a[c]=o[n[c]];s.push(a)}return s}function pE(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function mE(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Jn(1,fi((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let c=i[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var W0=["January","February","March","April","May","June","July","August","September","October","November","December"],X0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function q0(i){return i.slice(0,3)}var gE=X0.map(q0),_E=W0.map(q0),xE={MMMM:W0,MMM:_E,WWWW:X0,WWW:gE};function Pa(i){return(i<10?"0":"")+i}function vE(i){return(i<10?"00":i<100?"0":"")+i}var yE={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Pa(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Pa(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Pa(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Pa(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Pa(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>vE(i.getMilliseconds())};function ud(i,e){e=e||xE;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?yE[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var bE=new Intl.DateTimeFormat().resolvedOptions().timeZone;function SE(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==bE?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var Y0=i=>i%1==0,yu=[1,2,2.5,5],ME=Ua(10,-32,0,yu),$0=Ua(10,0,32,yu),wE=$0.filter(Y0),pr=ME.concat($0),hd=`
`,Z0="{YYYY}",d0=hd+Z0,J0="{M}/{D}",Da=hd+J0,mu=Da+"/{YY}",K0="{aa}",EE="{h}:{mm}",vo=EE+K0,p0=hd+vo,m0=":{ss}",Et=null;function j0(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,c=(i==1?Ua(10,0,3,yu).filter(Y0):Ua(10,-3,0,yu)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,Z0,Et,Et,Et,Et,Et,Et,1],[s*28,"{MMM}",d0,Et,Et,Et,Et,Et,1],[s,J0,d0,Et,Et,Et,Et,Et,1],[n,"{h}"+K0,mu,Et,Da,Et,Et,Et,1],[t,vo,mu,Et,Da,Et,Et,Et,1],[e,m0,mu+" "+vo,Et,Da+" "+vo,Et,p0,Et,1],[i,m0+".{fff}",mu+" "+vo,Et,Da+" "+vo,Et,p0,Et,1]];function u(d){return(f,h,m,y,g,p)=>{let v=[],A=g>=o,b=g>=r&&g<o,R=d(m),T=Nt(R*i,3),_=Wf(R.getFullYear(),A?0:R.getMonth(),b||A?1:R.getDate()),w=Nt(_*i,3);if(b||A){let F=b?g/r:0,L=A?g/o:0,I=T==w?T:Nt(Wf(_.getFullYear()+L,_.getMonth()+F,1)*i,3),O=new Date(yn(I/i)),k=O.getFullYear(),D=O.getMonth();for(let G=0;I<=y;G++){let Y=Wf(k+L*G,D+F*G,1),H=Y-d(Nt(Y*i,3));I=Nt((+Y+H)*i,3),I<=y&&v.push(I)}}else{let F=g>=s?s:g,L=fi(m)-fi(T),I=w+L+Mu(T-w,F);v.push(I);let O=d(I),k=O.getHours()+O.getMinutes()/t+O.getSeconds()/n,D=g/n,G=f.axes[h]._space,Y=p/G;for(;I=Nt(I+g,i==1?0:3),!(I>y);)if(D>1){let H=fi(Nt(k+D,6))%24,Q=d(I).getHours()-H;Q>1&&(Q=-1),I-=Q*n,k=(k+D)%24;let ie=v[v.length-1];Nt((I-ie)/g,3)*Y>=.7&&v.push(I)}else v.push(I)}return v}}return[c,l,u]}var[TE,AE,RE]=j0(1),[CE,PE,IE]=j0(.001);Ua(2,-53,53,[1]);function g0(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function _0(i,e){return(t,n,s,r,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],c,l,u,d,f,h;return n.map(m=>{let y=i(m),g=y.getFullYear(),p=y.getMonth(),v=y.getDate(),A=y.getHours(),b=y.getMinutes(),R=y.getSeconds(),T=g!=c&&a[2]||p!=l&&a[3]||v!=u&&a[4]||A!=d&&a[5]||b!=f&&a[6]||R!=h&&a[7]||a[1];return c=g,l=p,u=v,d=A,f=b,h=R,T(y)})}}function LE(i,e){let t=ud(e);return(n,s,r,o,a)=>s.map(c=>t(i(c)))}function Wf(i,e,t){return new Date(i,e,t)}function x0(i,e){return e(i)}var DE="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function v0(i,e){return(t,n,s,r)=>r==null?sd:e(i(n))}function NE(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function FE(i,e){return i.series[e].fill(i,e)}var UE={show:!0,live:!0,isolate:!1,mount:tE,markers:{show:!0,width:2,stroke:NE,fill:FE,dash:"solid"},idx:null,idxs:null,values:[]};function OE(i,e){let t=i.cursor.points,n=bi(),s=t.size(i,e);Gt(n,Ia,s),Gt(n,La,s);let r=s/-2;Gt(n,"marginLeft",r),Gt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Gt(n,"borderWidth",o),n}function BE(i,e){let t=i.series[e].points;return t._fill||t._stroke}function kE(i,e){let t=i.series[e].points;return t._stroke||t._fill}function zE(i,e){return i.series[e].points.size}var Xf=[0,0];function VE(i,e,t){return Xf[0]=e,Xf[1]=t,Xf}function gu(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function qf(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var HE={show:!0,x:!0,y:!0,lock:!1,move:VE,points:{one:!1,show:OE,size:zE,width:0,stroke:kE,fill:BE},bind:{mousedown:gu,mouseup:gu,click:gu,dblclick:gu,mousemove:qf,mouseleave:qf,mouseenter:qf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Q0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},fd=mn({},Q0,{filter:k0}),e_=mn({},fd,{size:10}),t_=mn({},Q0,{show:!1}),dd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',n_="bold "+dd,i_=1.5,y0={show:!0,scale:"x",stroke:id,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:n_,side:2,grid:fd,ticks:e_,border:t_,font:dd,lineGap:i_,rotate:0},GE="Value",WE="Time",b0={show:!0,scale:"x",auto:!1,sorted:1,min:Dt,max:-Dt,idxs:[]};function XE(i,e,t,n,s){return e.map(r=>r==null?"":ld(r))}function qE(i,e,t,n,s,r,o){let a=[],c=Ys.get(s)||0;t=o?t:Nt(Mu(t,s),c);for(let l=t;l<=n;l=Nt(l+s,c))a.push(Object.is(l,-0)?0:l);return a}function jf(i,e,t,n,s,r,o){let a=[],c=i.scales[i.axes[e].scale].log,l=c==10?Ss:U0,u=fi(l(t));s=bo(c,u),c==10&&(s=pr[Bi(s,pr)]);let d=t,f=s*c;c==10&&(f=pr[Bi(f,pr)]);do a.push(d),d=d+s,c==10&&!Ys.has(d)&&(d=Nt(d,Ys.get(s))),d>=f&&(s=d,f=s*c,c==10&&(f=pr[Bi(f,pr)]));while(d<=n);return a}function YE(i,e,t,n,s,r,o){let c=i.scales[i.axes[e].scale].asinh,l=n>c?jf(i,e,Jn(c,t),n,s):[c],u=n>=0&&t<=0?[0]:[];return(t<-c?jf(i,e,Jn(c,-n),-t,s):[c]).reverse().map(f=>-f).concat(u,l)}var s_=/./,$E=/[12357]/,ZE=/[125]/,S0=/1/,Qf=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function JE(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],c=i.valToPos,l=r._space,u=c(10,o),d=c(9,o)-u>=l?s_:c(7,o)-u>=l?$E:c(5,o)-u>=l?ZE:S0;if(d==S0){let f=bn(c(1,o)-u);if(f<l)return Qf(e.slice().reverse(),a.distr,d,Si(l/f)).reverse()}return Qf(e,a.distr,d,1)}function KE(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,c=i.valToPos,l=bn(c(1,o)-c(2,o));return l<a?Qf(e.slice().reverse(),3,s_,Si(a/l)).reverse():e}function jE(i,e,t,n){return n==null?sd:e==null?"":ld(e)}var M0={show:!0,scale:"y",stroke:id,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:n_,side:3,grid:fd,ticks:e_,border:t_,font:dd,lineGap:i_,rotate:0};function QE(i,e){let t=3+(i||1)*2;return Nt(t*e,3)}function e1(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=bn(o-r),c=i.series[e],l=a/(c.points.space*Mt);return n[1]-n[0]<=l}var w0={scale:null,auto:!0,sorted:0,min:Dt,max:-Dt},r_=(i,e,t,n,s)=>s,E0={show:!0,auto:!0,sorted:0,gaps:r_,alpha:1,facets:[mn({},w0,{scale:"x"}),mn({},w0,{scale:"y"})]},T0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:r_,alpha:1,points:{show:e1,filter:null},values:null,min:Dt,max:-Dt,idxs:[],path:null,clip:null};function t1(i,e,t,n,s){return t/10}var o_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},n1=mn({},o_,{time:!1,ori:1}),A0={};function a_(i,e){let t=A0[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,c,l){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,o,a,c,l)}},i!=null&&(A0[i]=t)),t}var wo=1,ed=2;function xr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,c=r[0],l=n==2?r[1]:r[e],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],d=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,h=a.top,m=a.width,y=a.height,g=i.valToPosH,p=i.valToPosV;return u.ori==0?t(s,c,l,u,d,g,p,f,h,m,y,Tu,To,Ru,c_,h_):t(s,c,l,u,d,p,g,h,f,y,m,Au,Ao,gd,u_,f_)}function pd(i,e){let t=0,n=0,s=bt(i.bands,cd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function i1(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,c=i.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function Ms(i,e,t,n,s,r){return xr(i,e,(o,a,c,l,u,d,f,h,m,y,g)=>{let p=o.pxRound,v=l.dir*(l.ori==0?1:-1),A=l.ori==0?To:Ao,b,R;v==1?(b=t,R=n):(b=n,R=t);let T=p(d(a[b],l,y,h)),_=p(f(c[b],u,g,m)),w=p(d(a[R],l,y,h)),F=p(f(r==1?u.max:u.min,u,g,m)),L=new Path2D(s);return A(L,w,F),A(L,T,F),A(L,T,_),L})}function Eu(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Ru:gd,c=t;for(let d=0;d<i.length;d++){let f=i[d];if(f[1]>f[0]){let h=f[0]-c;h>0&&a(o,c,n,h,n+r),c=f[1]}}let l=t+s-c,u=10;l>0&&a(o,c,n-u/2,l,n+r+u)}return o}function s1(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function md(i,e,t,n,s,r,o){let a=[],c=i.length;for(let l=s==1?t:n;l>=t&&l<=n;l+=s)if(e[l]===null){let d=l,f=l;if(s==1)for(;++l<=n&&e[l]===null;)f=l;else for(;--l>=t&&e[l]===null;)f=l;let h=r(i[d]),m=f==d?h:r(i[f]),y=d-s;h=o<=0&&y>=0&&y<c?r(i[y]):h;let p=f+s;m=o>=0&&p>=0&&p<c?r(i[p]):m,m>=h&&a.push([h,m])}return a}function R0(i){return i==0?B0:i==1?yn:e=>dr(e,i)}function l_(i){let e=i==0?Tu:Au,t=i==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},n=i==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,u=0)=>{l==0&&u==0?n(s,r,o,a,c):(l=ki(l,a/2,c/2),u=ki(u,a/2,c/2),e(s,r+l,o),t(s,r+a,o,r+a,o+c,l),t(s,r+a,o+c,r,o+c,u),t(s,r,o+c,r,o,u),t(s,r,o,r+a,o,l),s.closePath())}}var Tu=(i,e,t)=>{i.moveTo(e,t)},Au=(i,e,t)=>{i.moveTo(t,e)},To=(i,e,t)=>{i.lineTo(e,t)},Ao=(i,e,t)=>{i.lineTo(t,e)},Ru=l_(0),gd=l_(1),c_=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},u_=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},h_=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},f_=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function d_(i){return(e,t,n,s,r)=>xr(e,t,(o,a,c,l,u,d,f,h,m,y,g)=>{let{pxRound:p,points:v}=o,A,b;l.ori==0?(A=Tu,b=c_):(A=Au,b=u_);let R=Nt(v.width*Mt,3),T=(v.size-v.width)/2*Mt,_=Nt(T*2,3),w=new Path2D,F=new Path2D,{left:L,top:I,width:O,height:k}=e.bbox;Ru(F,L-_,I-_,O+_*2,k+_*2);let D=G=>{if(c[G]!=null){let Y=p(d(a[G],l,y,h)),H=p(f(c[G],u,g,m));A(w,Y+T,H),b(w,Y,H,T,0,_u*2)}};if(r)r.forEach(D);else for(let G=n;G<=s;G++)D(G);return{stroke:R>0?w:null,fill:w,clip:F,flags:wo|ed}})}function p_(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var r1=p_(To),o1=p_(Ao);function m_(i){let e=bt(i?.alignGaps,0);return(t,n,s,r)=>xr(t,n,(o,a,c,l,u,d,f,h,m,y,g)=>{[s,r]=bu(c,s,r);let p=o.pxRound,v=k=>p(d(k,l,y,h)),A=k=>p(f(k,u,g,m)),b,R;l.ori==0?(b=To,R=r1):(b=Ao,R=o1);let T=l.dir*(l.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:wo},w=_.stroke,F=!1;if(r-s>=y*4){let k=he=>t.posToVal(he,l.key,!0),D=null,G=null,Y,H,le,J=v(a[T==1?s:r]),Q=v(a[s]),ie=v(a[r]),fe=k(T==1?Q+1:ie-1);for(let he=T==1?s:r;he>=s&&he<=r;he+=T){let ee=a[he],ge=(T==1?ee<fe:ee>fe)?J:v(ee),Me=c[he];ge==J?Me!=null?(H=Me,D==null?(b(w,ge,A(H)),Y=D=G=H):H<D?D=H:H>G&&(G=H)):Me===null&&(F=!0):(D!=null&&R(w,J,A(D),A(G),A(Y),A(H)),Me!=null?(H=Me,b(w,ge,A(H)),D=G=Y=H):(D=G=null,Me===null&&(F=!0)),J=ge,fe=k(J+T))}D!=null&&D!=G&&le!=J&&R(w,J,A(D),A(G),A(Y),A(H))}else for(let k=T==1?s:r;k>=s&&k<=r;k+=T){let D=c[k];D===null?F=!0:D!=null&&b(w,v(a[k]),A(D))}let[I,O]=pd(t,n);if(o.fill!=null||I!=0){let k=_.fill=new Path2D(w),D=o.fillTo(t,n,o.min,o.max,I),G=A(D),Y=v(a[s]),H=v(a[r]);T==-1&&([H,Y]=[Y,H]),b(k,H,G),b(k,Y,G)}if(!o.spanGaps){let k=[];F&&k.push(...md(a,c,s,r,T,v,e)),_.gaps=k=o.gaps(t,n,s,r,k),_.clip=Eu(k,l.ori,h,m,y,g)}return O!=0&&(_.band=O==2?[Ms(t,n,s,r,w,-1),Ms(t,n,s,r,w,1)]:Ms(t,n,s,r,w,O)),_})}function a1(i){let e=bt(i.align,1),t=bt(i.ascDesc,!1),n=bt(i.alignGaps,0),s=bt(i.extend,!1);return(r,o,a,c)=>xr(r,o,(l,u,d,f,h,m,y,g,p,v,A)=>{[a,c]=bu(d,a,c);let b=l.pxRound,{left:R,width:T}=r.bbox,_=Q=>b(m(Q,f,v,g)),w=Q=>b(y(Q,h,A,p)),F=f.ori==0?To:Ao,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:wo},I=L.stroke,O=f.dir*(f.ori==0?1:-1),k=w(d[O==1?a:c]),D=_(u[O==1?a:c]),G=D,Y=D;s&&e==-1&&(Y=R,F(I,Y,k)),F(I,D,k);for(let Q=O==1?a:c;Q>=a&&Q<=c;Q+=O){let ie=d[Q];if(ie==null)continue;let fe=_(u[Q]),he=w(ie);e==1?F(I,fe,k):F(I,G,he),F(I,fe,he),k=he,G=fe}let H=G;s&&e==1&&(H=R+T,F(I,H,k));let[le,J]=pd(r,o);if(l.fill!=null||le!=0){let Q=L.fill=new Path2D(I),ie=l.fillTo(r,o,l.min,l.max,le),fe=w(ie);F(Q,H,fe),F(Q,Y,fe)}if(!l.spanGaps){let Q=[];Q.push(...md(u,d,a,c,O,_,n));let ie=l.width*Mt/2,fe=t||e==1?ie:-ie,he=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=fe,ee[1]+=he}),L.gaps=Q=l.gaps(r,o,a,c,Q),L.clip=Eu(Q,f.ori,g,p,v,A)}return J!=0&&(L.band=J==2?[Ms(r,o,a,c,I,-1),Ms(r,o,a,c,I,1)]:Ms(r,o,a,c,I,J)),L})}function C0(i,e,t,n,s,r,o=Dt){if(i.length>1){let a=null;for(let c=0,l=1/0;c<i.length;c++)if(e[c]!==void 0){if(a!=null){let u=bn(i[c]-i[a]);u<l&&(l=u,o=bn(t(i[c],n,s,r)-t(i[a],n,s,r)))}a=c}}return o}function l1(i){i=i||Fa;let e=bt(i.size,[.6,Dt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=mt(s),o=1-e[0],a=bt(e[1],Dt),c=bt(e[2],1),l=bt(i.disp,Fa),u=bt(i.each,h=>{}),{fill:d,stroke:f}=l;return(h,m,y,g)=>xr(h,m,(p,v,A,b,R,T,_,w,F,L,I)=>{let O=p.pxRound,k=t,D=n*Mt,G=a*Mt,Y=c*Mt,H,le;b.ori==0?[H,le]=r(h,m):[le,H]=r(h,m);let J=b.dir*(b.ori==0?1:-1),Q=b.ori==0?Ru:gd,ie=b.ori==0?u:(Ce,qe,it,we,Lt,Ve,Xe)=>{u(Ce,qe,it,Lt,we,Xe,Ve)},fe=bt(h.bands,cd).find(Ce=>Ce.series[0]==m),he=fe!=null?fe.dir:0,ee=p.fillTo(h,m,p.min,p.max,he),me=O(_(ee,R,I,F)),ge,Me,ve,He=L,Ze=O(p.width*Mt),Oe=!1,ct=null,ot=null,tt=null,Wt=null;d!=null&&(Ze==0||f!=null)&&(Oe=!0,ct=d.values(h,m,y,g),ot=new Map,new Set(ct).forEach(Ce=>{Ce!=null&&ot.set(Ce,new Path2D)}),Ze>0&&(tt=f.values(h,m,y,g),Wt=new Map,new Set(tt).forEach(Ce=>{Ce!=null&&Wt.set(Ce,new Path2D)})));let{x0:Ft,size:rn}=l;if(Ft!=null&&rn!=null){k=1,v=Ft.values(h,m,y,g),Ft.unit==2&&(v=v.map(it=>h.posToVal(w+it*L,b.key,!0)));let Ce=rn.values(h,m,y,g);rn.unit==2?Me=Ce[0]*L:Me=T(Ce[0],b,L,w)-T(0,b,L,w),He=C0(v,A,T,b,L,w,He),ve=He-Me+D}else He=C0(v,A,T,b,L,w,He),ve=He*o+D,Me=He-ve;ve<1&&(ve=0),Ze>=Me/2&&(Ze=0),ve<5&&(O=B0);let Pt=ve>0,Sn=He-ve-(Pt?Ze:0);Me=O(Kf(Sn,Y,G)),ge=(k==0?Me/2:k==J?0:Me)-k*J*((k==0?D/2:0)+(Pt?Ze/2:0));let xt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},gn=Oe?null:new Path2D,$t=null;if(fe!=null)$t=h.data[fe.series[1]];else{let{y0:Ce,y1:qe}=l;Ce!=null&&qe!=null&&(A=qe.values(h,m,y,g),$t=Ce.values(h,m,y,g))}let on=H*Me,B=le*Me;for(let Ce=J==1?y:g;Ce>=y&&Ce<=g;Ce+=J){let qe=A[Ce];if(qe==null)continue;if($t!=null){let q=$t[Ce]??0;if(qe-q==0)continue;me=_(q,R,I,F)}let it=b.distr!=2||l!=null?v[Ce]:Ce,we=T(it,b,L,w),Lt=_(bt(qe,ee),R,I,F),Ve=O(we-ge),Xe=O(Jn(Lt,me)),C=O(ki(Lt,me)),S=Xe-C;if(qe!=null){let q=qe<0?B:on,ue=qe<0?on:B;Oe?(Ze>0&&tt[Ce]!=null&&Q(Wt.get(tt[Ce]),Ve,C+fi(Ze/2),Me,Jn(0,S-Ze),q,ue),ct[Ce]!=null&&Q(ot.get(ct[Ce]),Ve,C+fi(Ze/2),Me,Jn(0,S-Ze),q,ue)):Q(gn,Ve,C+fi(Ze/2),Me,Jn(0,S-Ze),q,ue),ie(h,m,Ce,Ve-Ze/2,C,Me+Ze,S)}}return Ze>0?xt.stroke=Oe?Wt:gn:Oe||(xt._fill=p.width==0?p._fill:p._stroke??p._fill,xt.width=0),xt.fill=Oe?ot:gn,xt})}function c1(i,e){let t=bt(e?.alignGaps,0);return(n,s,r,o)=>xr(n,s,(a,c,l,u,d,f,h,m,y,g,p)=>{[r,o]=bu(l,r,o);let v=a.pxRound,A=H=>v(f(H,u,g,m)),b=H=>v(h(H,d,p,y)),R,T,_;u.ori==0?(R=Tu,_=To,T=h_):(R=Au,_=Ao,T=f_);let w=u.dir*(u.ori==0?1:-1),F=A(c[w==1?r:o]),L=F,I=[],O=[];for(let H=w==1?r:o;H>=r&&H<=o;H+=w)if(l[H]!=null){let J=c[H],Q=A(J);I.push(L=Q),O.push(b(l[H]))}let k={stroke:i(I,O,R,_,T,v),fill:null,clip:null,band:null,gaps:null,flags:wo},D=k.stroke,[G,Y]=pd(n,s);if(a.fill!=null||G!=0){let H=k.fill=new Path2D(D),le=a.fillTo(n,s,a.min,a.max,G),J=b(le);_(H,L,J),_(H,F,J)}if(!a.spanGaps){let H=[];H.push(...md(c,l,r,o,w,A,t)),k.gaps=H=a.gaps(n,s,r,o,H),k.clip=Eu(H,u.ori,m,y,g,p)}return Y!=0&&(k.band=Y==2?[Ms(n,s,r,o,D,-1),Ms(n,s,r,o,D,1)]:Ms(n,s,r,o,D,Y)),k})}function u1(i){return c1(h1,i)}function h1(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let c=Array(o),l=Array(o-1),u=Array(o-1),d=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],d[f]=i[f+1]-i[f],l[f]=u[f]/d[f];c[0]=l[0];for(let f=1;f<o-1;f++)l[f]===0||l[f-1]===0||l[f-1]>0!=l[f]>0?c[f]=0:(c[f]=3*(d[f-1]+d[f])/((2*d[f]+d[f-1])/l[f-1]+(d[f]+2*d[f-1])/l[f]),isFinite(c[f])||(c[f]=0));c[o-1]=l[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+d[f]/3,e[f]+c[f]*d[f]/3,i[f+1]-d[f]/3,e[f+1]-c[f+1]*d[f]/3,i[f+1],e[f+1])}return a}var td=new Set;function P0(){for(let i of td)i.syncRect(!0)}Eo&&(gr(Xw,yo,P0),gr(qw,yo,P0,!0),gr(xu,yo,()=>{On.pxRatio=Mt}));var f1=m_(),d1=d_();function I0(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>nd(r,o,e,t))}function p1(i,e){return i.map((t,n)=>n==0?{}:mn({},e,t))}function nd(i,e,t,n){return mn({},e==0?t:n,i)}function g_(i,e,t){return e==null?So:[e,t]}var m1=g_;function g1(i,e,t){return e==null?So:vu(e,t,ad,!0)}function __(i,e,t,n){return e==null?So:Su(e,t,i.scales[n].log,!1)}var _1=__;function x_(i,e,t,n){return e==null?So:od(e,t,i.scales[n].log,!1)}var x1=x_;function v1(i,e,t,n,s){let r=Jn(c0(i),c0(e)),o=e-i,a=Bi(s/n*o,t);do{let c=t[a],l=n*c/o;if(l>=s&&r+(c<5?Ys.get(c):0)<=17)return[c,l]}while(++a<t.length);return[0,0]}function L0(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=yn((t=+s)*Mt))+"px"),[i,e,t]}function y1(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Nt(e[2]*Mt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function On(i,e,t){let n={mode:bt(i.mode,1)},s=n.mode;function r(x,M,P,N){let W=M.valToPct(x);return N+P*(M.dir==-1?1-W:W)}function o(x,M,P,N){let W=M.valToPct(x);return N+P*(M.dir==-1?W:1-W)}function a(x,M,P,N){return M.ori==0?r(x,M,P,N):o(x,M,P,N)}n.valToPosH=r,n.valToPosV=o;let c=!1;n.status=0;let l=n.root=bi(Aw);if(i.id!=null&&(l.id=i.id),hi(l,i.class),i.title){let x=bi(Pw,l);x.textContent=i.title}let u=Oi("canvas"),d=n.ctx=u.getContext("2d"),f=bi(Iw,l);gr("click",f,x=>{x.target===m&&(Bt!=Er||Xt!=Tr)&&Pn.click(n,x)},!0);let h=n.under=bi(Lw,f);f.appendChild(u);let m=n.over=bi(Dw,f);i=Mo(i);let y=+bt(i.pxAlign,1),g=R0(y);(i.plugins||[]).forEach(x=>{x.opts&&(i=x.opts(n,i)||i)});let p=i.ms||.001,v=n.series=s==1?I0(i.series||[],b0,T0,!1):p1(i.series||[null],E0),A=n.axes=I0(i.axes||[],y0,M0,!0),b=n.scales={},R=n.bands=i.bands||[];R.forEach(x=>{x.fill=mt(x.fill||null),x.dir=bt(x.dir,-1)});let T=s==2?v[1].facets[0].scale:v[0].scale,_={axes:rs,series:ht},w=(i.drawOrder||["axes","series"]).map(x=>_[x]);function F(x){let M=x.distr==3?P=>Ss(P>0?P:x.clamp(n,P,x.min,x.max,x.key)):x.distr==4?P=>Gf(P,x.asinh):x.distr==100?P=>x.fwd(P):P=>P;return P=>{let N=M(P),{_min:W,_max:K}=x,ae=K-W;return(N-W)/ae}}function L(x){let M=b[x];if(M==null){let P=(i.scales||Fa)[x]||Fa;if(P.from!=null){L(P.from);let N=mn({},b[P.from],P,{key:x});N.valToPct=F(N),b[x]=N}else{M=b[x]=mn({},x==T?o_:n1,P),M.key=x;let N=M.time,W=M.range,K=qs(W);if((x!=T||s==2&&!N)&&(K&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?o0:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?o0:{mode:1,hard:W[1],soft:W[1]}},K=!1),!K&&wu(W))){let ae=W;W=(de,be,De)=>be==null?So:vu(be,De,ae)}M.range=mt(W||(N?m1:x==T?M.distr==3?_1:M.distr==4?x1:g_:M.distr==3?__:M.distr==4?x_:g1)),M.auto=mt(K?!1:M.auto),M.clamp=mt(M.clamp||t1),M._min=M._max=null,M.valToPct=F(M)}}}L("x"),L("y"),s==1&&v.forEach(x=>{L(x.scale)}),A.forEach(x=>{L(x.scale)});for(let x in i.scales)L(x);let I=b[T],O=I.distr,k,D;I.ori==0?(hi(l,Rw),k=r,D=o):(hi(l,Cw),k=o,D=r);let G={};for(let x in b){let M=b[x];(M.min!=null||M.max!=null)&&(G[x]={min:M.min,max:M.max},M.min=M.max=null)}let Y=i.tzDate||(x=>new Date(yn(x/p))),H=i.fmtDate||ud,le=p==1?RE(Y):IE(Y),J=_0(Y,g0(p==1?AE:PE,H)),Q=v0(Y,x0(DE,H)),ie=[],fe=n.legend=mn({},UE,i.legend),he=n.cursor=mn({},HE,{drag:{y:s==2}},i.cursor),ee=fe.show,me=he.show,ge=fe.markers;fe.idxs=ie,ge.width=mt(ge.width),ge.dash=mt(ge.dash),ge.stroke=mt(ge.stroke),ge.fill=mt(ge.fill);let Me,ve,He,Ze=[],Oe=[],ct,ot=!1,tt={};if(fe.live){let x=v[1]?v[1].values:null;ot=x!=null,ct=ot?x(n,1,0):{_:0};for(let M in ct)tt[M]=sd}if(ee)if(Me=Oi("table",kw,l),He=Oi("tbody",null,Me),fe.mount(n,Me),ot){ve=Oi("thead",null,Me,He);let x=Oi("tr",null,ve);Oi("th",null,x);for(var Wt in ct)Oi("th",Yg,x).textContent=Wt}else hi(Me,Vw),fe.live&&hi(Me,zw);let Ft={show:!0},rn={show:!1};function Pt(x,M){if(M==0&&(ot||!fe.live||s==2))return So;let P=[],N=Oi("tr",Hw,He,He.childNodes[M]);hi(N,x.class),x.show||hi(N,mr);let W=Oi("th",null,N);if(ge.show){let de=bi(Gw,W);if(M>0){let be=ge.width(n,M);be&&(de.style.border=be+"px "+ge.dash(n,M)+" "+ge.stroke(n,M)),de.style.background=ge.fill(n,M)}}let K=bi(Yg,W);x.label instanceof HTMLElement?K.appendChild(x.label):K.textContent=x.label,M>0&&(ge.show||(K.style.color=x.width>0?ge.stroke(n,M):ge.fill(n,M)),xt("click",W,de=>{if(he._lock)return;Je(de);let be=v.indexOf(x);if((de.ctrlKey||de.metaKey)!=fe.isolate){let De=v.some((Ne,Ue)=>Ue>0&&Ue!=be&&Ne.show);v.forEach((Ne,Ue)=>{Ue>0&&Gi(Ue,De?Ue==be?Ft:rn:Ft,!0,un.setSeries)})}else Gi(be,{show:!x.show},!0,un.setSeries)},!1),Ke&&xt(Kg,W,de=>{he._lock||(Je(de),Gi(v.indexOf(x),Rr,!0,un.setSeries))},!1));for(var ae in ct){let de=Oi("td",Ww,N);de.textContent="--",P.push(de)}return[N,P]}let Sn=new Map;function xt(x,M,P,N=!0){let W=Sn.get(M)||{},K=he.bind[x](n,M,P,N);K&&(gr(x,M,W[x]=K),Sn.set(M,W))}function gn(x,M,P){let N=Sn.get(M)||{};for(let W in N)(x==null||W==x)&&(Jf(W,M,N[W]),delete N[W]);x==null&&Sn.delete(M)}let $t=0,on=0,B=0,Ce=0,qe=0,it=0,we=qe,Lt=it,Ve=B,Xe=Ce,C=0,S=0,q=0,ue=0;n.bbox={};let oe=!1,xe=!1,ye=!1,te=!1,se=!1,pe=!1;function U(x,M,P){(P||x!=n.width||M!=n.height)&&re(x,M),at(!1),ye=!0,xe=!0,Bn()}function re(x,M){n.width=$t=B=x,n.height=on=Ce=M,qe=it=0,Se(),Ge();let P=n.bbox;C=P.left=dr(qe*Mt,.5),S=P.top=dr(it*Mt,.5),q=P.width=dr(B*Mt,.5),ue=P.height=dr(Ce*Mt,.5)}let ne=3;function Ee(){let x=!1,M=0;for(;!x;){M++;let P=Sr(M),N=Hi(M);x=M==ne||P&&N,x||(re(n.width,n.height),xe=!0)}}function _e({width:x,height:M}){U(x,M)}n.setSize=_e;function Se(){let x=!1,M=!1,P=!1,N=!1;A.forEach((W,K)=>{if(W.show&&W._show){let{side:ae,_size:de}=W,be=ae%2,De=W.label!=null?W.labelSize:0,Ne=de+De;Ne>0&&(be?(B-=Ne,ae==3?(qe+=Ne,N=!0):P=!0):(Ce-=Ne,ae==0?(it+=Ne,x=!0):M=!0))}}),zi[0]=x,zi[1]=P,zi[2]=M,zi[3]=N,B-=Mi[1]+Mi[3],qe+=Mi[3],Ce-=Mi[2]+Mi[0],it+=Mi[0]}function Ge(){let x=qe+B,M=it+Ce,P=qe,N=it;function W(K,ae){switch(K){case 1:return x+=ae,x-ae;case 2:return M+=ae,M-ae;case 3:return P-=ae,P+ae;case 0:return N-=ae,N+ae}}A.forEach((K,ae)=>{if(K.show&&K._show){let de=K.side;K._pos=W(de,K._size),K.label!=null&&(K._lpos=W(de,K.labelSize))}})}if(he.dataIdx==null){let x=he.hover,M=x.skip=new Set(x.skip??[]);M.add(void 0);let P=x.prox=mt(x.prox),N=x.bias??=0;he.dataIdx=(W,K,ae,de)=>{if(K==0)return ae;let be=ae,De=P(W,K,ae,de)??Dt,Ne=De>=0&&De<Dt,Ue=I.ori==0?B:Ce,nt=he.left,St=e[0],yt=e[K];if(M.has(yt[ae])){be=null;let ft=null,$e=null,We;if(N==0||N==-1)for(We=ae;ft==null&&We-- >0;)M.has(yt[We])||(ft=We);if(N==0||N==1)for(We=ae;$e==null&&We++<yt.length;)M.has(yt[We])||($e=We);if(ft!=null||$e!=null)if(Ne){let zt=ft==null?-1/0:k(St[ft],I,Ue,0),Kt=$e==null?1/0:k(St[$e],I,Ue,0),Tn=nt-zt,It=Kt-nt;Tn<=It?Tn<=De&&(be=ft):It<=De&&(be=$e)}else be=$e==null?ft:ft==null?$e:ae-ft<=$e-ae?ft:$e}else Ne&&bn(nt-k(St[ae],I,Ue,0))>De&&(be=null);return be}}let Je=x=>{he.event=x};he.idxs=ie,he._lock=!1;let ce=he.points;ce.show=mt(ce.show),ce.size=mt(ce.size),ce.stroke=mt(ce.stroke),ce.width=mt(ce.width),ce.fill=mt(ce.fill);let Be=n.focus=mn({},i.focus||{alpha:.3},he.focus),Ke=Be.prox>=0,Re=Ke&&ce.one,st=[],Ot=[],Hn=[];function Ro(x,M){let P=ce.show(n,M);if(P instanceof HTMLElement)return hi(P,Bw),hi(P,x.class),ts(P,-10,-10,B,Ce),m.insertBefore(P,st[M]),P}function vr(x,M){if(s==1||M>0){let P=s==1&&b[x.scale].time,N=x.value;x.value=P?f0(N)?v0(Y,x0(N,H)):N||Q:N||jE,x.label=x.label||(P?WE:GE)}if(Re||M>0){x.width=x.width==null?1:x.width,x.paths=x.paths||f1||nE,x.fillTo=mt(x.fillTo||i1),x.pxAlign=+bt(x.pxAlign,y),x.pxRound=R0(x.pxAlign),x.stroke=mt(x.stroke||null),x.fill=mt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let P=QE(Jn(1,x.width),1),N=x.points=mn({},{size:P,width:Jn(1,P*.2),stroke:x.stroke,space:P*2,paths:d1,_stroke:null,_fill:null},x.points);N.show=mt(N.show),N.filter=mt(N.filter),N.fill=mt(N.fill),N.stroke=mt(N.stroke),N.paths=mt(N.paths),N.pxAlign=x.pxAlign}if(ee){let P=Pt(x,M);Ze.splice(M,0,P[0]),Oe.splice(M,0,P[1]),fe.values.push(null)}if(me){ie.splice(M,0,null);let P=null;Re?M==0&&(P=Ro(x,M)):M>0&&(P=Ro(x,M)),st.splice(M,0,P),Ot.splice(M,0,0),Hn.splice(M,0,0)}En("addSeries",M)}function Cu(x,M){M=M??v.length,x=s==1?nd(x,M,b0,T0):nd(x,M,{},E0),v.splice(M,0,x),vr(v[M],M)}n.addSeries=Cu;function Ba(x){if(v.splice(x,1),ee){fe.values.splice(x,1),Oe.splice(x,1);let M=Ze.splice(x,1)[0];gn(null,M.firstChild),M.remove()}me&&(ie.splice(x,1),st.splice(x,1)[0].remove(),Ot.splice(x,1),Hn.splice(x,1)),En("delSeries",x)}n.delSeries=Ba;let zi=[!1,!1,!1,!1];function ns(x,M){if(x._show=x.show,x.show){let P=x.side%2,N=b[x.scale];N==null&&(x.scale=P?v[1].scale:T,N=b[x.scale]);let W=N.time;x.size=mt(x.size),x.space=mt(x.space),x.rotate=mt(x.rotate),qs(x.incrs)&&x.incrs.forEach(ae=>{!Ys.has(ae)&&Ys.set(ae,V0(ae))}),x.incrs=mt(x.incrs||(N.distr==2?wE:W?p==1?TE:CE:pr)),x.splits=mt(x.splits||(W&&N.distr==1?le:N.distr==3?jf:N.distr==4?YE:qE)),x.stroke=mt(x.stroke),x.grid.stroke=mt(x.grid.stroke),x.ticks.stroke=mt(x.ticks.stroke),x.border.stroke=mt(x.border.stroke);let K=x.values;x.values=qs(K)&&!qs(K[0])?mt(K):W?qs(K)?_0(Y,g0(K,H)):f0(K)?LE(Y,K):K||J:K||XE,x.filter=mt(x.filter||(N.distr>=3&&N.log==10?JE:N.distr==3&&N.log==2?KE:k0)),x.font=L0(x.font),x.labelFont=L0(x.labelFont),x._size=x.size(n,null,M,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(zi[M]=!0,x._el=bi(Nw,f))}}function is(x,M,P,N){let[W,K,ae,de]=P,be=M%2,De=0;return be==0&&(de||K)&&(De=M==0&&!W||M==2&&!ae?yn(y0.size/3):0),be==1&&(W||ae)&&(De=M==1&&!K||M==3&&!de?yn(M0.size/2):0),De}let Co=n.padding=(i.padding||[is,is,is,is]).map(x=>mt(bt(x,is))),Mi=n._padding=Co.map((x,M)=>x(n,M,zi,0)),Zt,en=null,tn=null,Vi=s==1?v[0].idxs:null,ei=null,ws=!1;function Po(x,M){if(e=x??[],n.data=n._data=e,s==2){Zt=0;for(let P=1;P<v.length;P++)Zt+=e[P][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),ei=e[0],Zt=ei.length;let P=e;if(O==2){P=e.slice();let N=P[0]=Array(Zt);for(let W=0;W<Zt;W++)N[W]=W}n._data=e=P}if(at(!0),En("setData"),O==2&&(ye=!0),M!==!1){let P=I;P.auto(n,ws)?Io():As(T,P.min,P.max),te=te||he.left>=0,pe=!0,Bn()}}n.setData=Po;function Io(){ws=!0;let x,M;s==1&&(Zt>0?(en=Vi[0]=0,tn=Vi[1]=Zt-1,x=e[0][en],M=e[0][tn],O==2?(x=en,M=tn):x==M&&(O==3?[x,M]=Su(x,x,I.log,!1):O==4?[x,M]=od(x,x,I.log,!1):I.time?M=x+yn(86400/p):[x,M]=vu(x,M,ad,!0))):(en=Vi[0]=x=null,tn=Vi[1]=M=null)),As(T,x,M)}let yr,Es,br,E,z,j,$,Z,Te,Pe;function Ae(x,M,P,N,W,K){x??=Zg,P??=cd,N??="butt",W??=Zg,K??="round",x!=yr&&(d.strokeStyle=yr=x),W!=Es&&(d.fillStyle=Es=W),M!=br&&(d.lineWidth=br=M),K!=z&&(d.lineJoin=z=K),N!=j&&(d.lineCap=j=N),P!=E&&d.setLineDash(E=P)}function Ie(x,M,P,N){M!=Es&&(d.fillStyle=Es=M),x!=$&&(d.font=$=x),P!=Z&&(d.textAlign=Z=P),N!=Te&&(d.textBaseline=Te=N)}function ze(x,M,P,N,W=0){if(N.length>0&&x.auto(n,ws)&&(M==null||M.min==null)){let K=bt(en,0),ae=bt(tn,N.length-1),de=P.min==null?Jw(N,K,ae,W,x.distr==3):[P.min,P.max];x.min=ki(x.min,P.min=de[0]),x.max=Jn(x.max,P.max=de[1])}}let je={min:null,max:null};function ut(){for(let N in b){let W=b[N];G[N]==null&&(W.min==null||G[T]!=null&&W.auto(n,ws))&&(G[N]=je)}for(let N in b){let W=b[N];G[N]==null&&W.from!=null&&G[W.from]!=null&&(G[N]=je)}G[T]!=null&&at(!0);let x={};for(let N in G){let W=G[N];if(W!=null){let K=x[N]=Mo(b[N],rE);if(W.min!=null)mn(K,W);else if(N!=T||s==2)if(Zt==0&&K.from==null){let ae=K.range(n,null,null,N);K.min=ae[0],K.max=ae[1]}else K.min=Dt,K.max=-Dt}}if(Zt>0){v.forEach((N,W)=>{if(s==1){let K=N.scale,ae=G[K];if(ae==null)return;let de=x[K];if(W==0){let be=de.range(n,de.min,de.max,K);de.min=be[0],de.max=be[1],en=Bi(de.min,e[0]),tn=Bi(de.max,e[0]),tn-en>1&&(e[0][en]<de.min&&en++,e[0][tn]>de.max&&tn--),N.min=ei[en],N.max=ei[tn]}else N.show&&N.auto&&ze(de,ae,N,e[W],N.sorted);N.idxs[0]=en,N.idxs[1]=tn}else if(W>0&&N.show&&N.auto){let[K,ae]=N.facets,de=K.scale,be=ae.scale,[De,Ne]=e[W],Ue=x[de],nt=x[be];Ue!=null&&ze(Ue,G[de],K,De,K.sorted),nt!=null&&ze(nt,G[be],ae,Ne,ae.sorted),N.min=ae.min,N.max=ae.max}});for(let N in x){let W=x[N],K=G[N];if(W.from==null&&(K==null||K.min==null)){let ae=W.range(n,W.min==Dt?null:W.min,W.max==-Dt?null:W.max,N);W.min=ae[0],W.max=ae[1]}}}for(let N in x){let W=x[N];if(W.from!=null){let K=x[W.from];if(K.min==null)W.min=W.max=null;else{let ae=W.range(n,K.min,K.max,N);W.min=ae[0],W.max=ae[1]}}}let M={},P=!1;for(let N in x){let W=x[N],K=b[N];if(K.min!=W.min||K.max!=W.max){K.min=W.min,K.max=W.max;let ae=K.distr;K._min=ae==3?Ss(K.min):ae==4?Gf(K.min,K.asinh):ae==100?K.fwd(K.min):K.min,K._max=ae==3?Ss(K.max):ae==4?Gf(K.max,K.asinh):ae==100?K.fwd(K.max):K.max,M[N]=P=!0}}if(P){v.forEach((N,W)=>{s==2?W>0&&M.y&&(N._paths=null):M[N.scale]&&(N._paths=null)});for(let N in M)ye=!0,En("setScale",N);me&&he.left>=0&&(te=pe=!0)}for(let N in G)G[N]=null}function ke(x){let M=Kf(en-1,0,Zt-1),P=Kf(tn+1,0,Zt-1);for(;x[M]==null&&M>0;)M--;for(;x[P]==null&&P<Zt-1;)P++;return[M,P]}function ht(){if(Zt>0){let x=v.some(M=>M._focus)&&Pe!=Be.alpha;x&&(d.globalAlpha=Pe=Be.alpha),v.forEach((M,P)=>{if(P>0&&M.show&&(Yt(P,!1),Yt(P,!0),M._paths==null)){let N=Pe;Pe!=M.alpha&&(d.globalAlpha=Pe=M.alpha);let W=s==2?[0,e[P][0].length-1]:ke(e[P]);M._paths=M.paths(n,P,W[0],W[1]),Pe!=N&&(d.globalAlpha=Pe=N)}}),v.forEach((M,P)=>{if(P>0&&M.show){let N=Pe;Pe!=M.alpha&&(d.globalAlpha=Pe=M.alpha),M._paths!=null&&Tt(P,!1);{let W=M._paths!=null?M._paths.gaps:null,K=M.points.show(n,P,en,tn,W),ae=M.points.filter(n,P,K,W);(K||ae)&&(M.points._paths=M.points.paths(n,P,en,tn,ae),Tt(P,!0))}Pe!=N&&(d.globalAlpha=Pe=N),En("drawSeries",P)}}),x&&(d.globalAlpha=Pe=1)}}function Yt(x,M){let P=M?v[x].points:v[x];P._stroke=P.stroke(n,x),P._fill=P.fill(n,x)}function Tt(x,M){let P=M?v[x].points:v[x],{stroke:N,fill:W,clip:K,flags:ae,_stroke:de=P._stroke,_fill:be=P._fill,_width:De=P.width}=P._paths;De=Nt(De*Mt,3);let Ne=null,Ue=De%2/2;M&&be==null&&(be=De>0?"#fff":de);let nt=P.pxAlign==1&&Ue>0;if(nt&&d.translate(Ue,Ue),!M){let St=C-De/2,yt=S-De/2,ft=q+De,$e=ue+De;Ne=new Path2D,Ne.rect(St,yt,ft,$e)}M?Fe(de,De,P.dash,P.cap,be,N,W,ae,K):At(x,de,De,P.dash,P.cap,be,N,W,ae,Ne,K),nt&&d.translate(-Ue,-Ue)}function At(x,M,P,N,W,K,ae,de,be,De,Ne){let Ue=!1;be!=0&&R.forEach((nt,St)=>{if(nt.series[0]==x){let yt=v[nt.series[1]],ft=e[nt.series[1]],$e=(yt._paths||Fa).band;qs($e)&&($e=nt.dir==1?$e[0]:$e[1]);let We,zt=null;yt.show&&$e&&jw(ft,en,tn)?(zt=nt.fill(n,St)||K,We=yt._paths.clip):$e=null,Fe(M,P,N,W,zt,ae,de,be,De,Ne,We,$e),Ue=!0}}),Ue||Fe(M,P,N,W,K,ae,de,be,De,Ne)}let _n=wo|ed;function Fe(x,M,P,N,W,K,ae,de,be,De,Ne,Ue){Ae(x,M,P,N,W),(be||De||Ue)&&(d.save(),be&&d.clip(be),De&&d.clip(De)),Ue?(de&_n)==_n?(d.clip(Ue),Ne&&d.clip(Ne),dt(W,ae),an(x,K,M)):de&ed?(dt(W,ae),d.clip(Ue),an(x,K,M)):de&wo&&(d.save(),d.clip(Ue),Ne&&d.clip(Ne),dt(W,ae),d.restore(),an(x,K,M)):(dt(W,ae),an(x,K,M)),(be||De||Ue)&&d.restore()}function an(x,M,P){P>0&&(M instanceof Map?M.forEach((N,W)=>{d.strokeStyle=yr=W,d.stroke(N)}):M!=null&&x&&d.stroke(M))}function dt(x,M){M instanceof Map?M.forEach((P,N)=>{d.fillStyle=Es=N,d.fill(P)}):M!=null&&x&&d.fill(M)}function ss(x,M,P,N){let W=A[x],K;if(N<=0)K=[0,0];else{let ae=W._space=W.space(n,x,M,P,N),de=W._incrs=W.incrs(n,x,M,P,N,ae);K=v1(M,P,de,N,ae)}return W._found=K}function ln(x,M,P,N,W,K,ae,de,be,De){let Ne=ae%2/2;y==1&&d.translate(Ne,Ne),Ae(de,ae,be,De,de),d.beginPath();let Ue,nt,St,yt,ft=W+(N==0||N==3?-K:K);P==0?(nt=W,yt=ft):(Ue=W,St=ft);for(let $e=0;$e<x.length;$e++)M[$e]!=null&&(P==0?Ue=St=x[$e]:nt=yt=x[$e],d.moveTo(Ue,nt),d.lineTo(St,yt));d.stroke(),y==1&&d.translate(-Ne,-Ne)}function Sr(x){let M=!0;return A.forEach((P,N)=>{if(!P.show)return;let W=b[P.scale];if(W.min==null){P._show&&(M=!1,P._show=!1,at(!1));return}else P._show||(M=!1,P._show=!0,at(!1));let K=P.side,ae=K%2,{min:de,max:be}=W,[De,Ne]=ss(N,de,be,ae==0?B:Ce);if(Ne==0)return;let Ue=W.distr==2,nt=P._splits=P.splits(n,N,de,be,De,Ne,Ue),St=W.distr==2?nt.map(We=>ei[We]):nt,yt=W.distr==2?ei[nt[1]]-ei[nt[0]]:De,ft=P._values=P.values(n,P.filter(n,St,N,Ne,yt),N,Ne,yt);P._rotate=K==2?P.rotate(n,ft,N,Ne):0;let $e=P._size;P._size=Si(P.size(n,ft,N,x)),$e!=null&&P._size!=$e&&(M=!1)}),M}function Hi(x){let M=!0;return Co.forEach((P,N)=>{let W=P(n,N,zi,x);W!=Mi[N]&&(M=!1),Mi[N]=W}),M}function rs(){for(let x=0;x<A.length;x++){let M=A[x];if(!M.show||!M._show)continue;let P=M.side,N=P%2,W,K,ae=M.stroke(n,x),de=P==0||P==3?-1:1,[be,De]=M._found;if(M.label!=null){let Xn=M.labelGap*de,ii=yn((M._lpos+Xn)*Mt);Ie(M.labelFont[0],ae,"center",P==2?"top":$g),d.save(),N==1?(W=K=0,d.translate(ii,yn(S+ue/2)),d.rotate((P==3?-_u:_u)/2)):(W=yn(C+q/2),K=ii);let Js=O0(M.label)?M.label(n,x,be,De):M.label;d.fillText(Js,W,K),d.restore()}if(De==0)continue;let Ne=b[M.scale],Ue=N==0?q:ue,nt=N==0?C:S,St=M._splits,yt=Ne.distr==2?St.map(Xn=>ei[Xn]):St,ft=Ne.distr==2?ei[St[1]]-ei[St[0]]:be,$e=M.ticks,We=M.border,zt=$e.show?$e.size:0,Kt=yn(zt*Mt),Tn=yn((M.alignTo==2?M._size-zt-M.gap:M.gap)*Mt),It=M._rotate*-_u/180,jt=g(M._pos*Mt),ti=(Kt+Tn)*de,Wn=jt+ti;K=N==0?Wn:0,W=N==1?Wn:0;let pi=M.font[0],wi=M.align==1?xo:M.align==2?zf:It>0?xo:It<0?zf:N==0?"center":P==3?zf:xo,Xi=It||N==1?"middle":P==2?"top":$g;Ie(pi,ae,wi,Xi);let ni=M.font[1]*M.lineGap,mi=St.map(Xn=>g(a(Xn,Ne,Ue,nt))),Ei=M._values;for(let Xn=0;Xn<Ei.length;Xn++){let ii=Ei[Xn];if(ii!=null){N==0?W=mi[Xn]:K=mi[Xn],ii=""+ii;let Js=ii.indexOf(`
`)==-1?[ii]:ii.split(/\n/gm);for(let qn=0;qn<Js.length;qn++){let Ud=Js[qn];It?(d.save(),d.translate(W,K+qn*ni),d.rotate(It),d.fillText(Ud,0,0),d.restore()):d.fillText(Ud,W,K+qn*ni)}}}$e.show&&ln(mi,$e.filter(n,yt,x,De,ft),N,P,jt,Kt,Nt($e.width*Mt,3),$e.stroke(n,x),$e.dash,$e.cap);let qi=M.grid;qi.show&&ln(mi,qi.filter(n,yt,x,De,ft),N,N==0?2:1,N==0?S:C,N==0?ue:q,Nt(qi.width*Mt,3),qi.stroke(n,x),qi.dash,qi.cap),We.show&&ln([jt],[1],N==0?1:0,N==0?1:2,N==1?S:C,N==1?ue:q,Nt(We.width*Mt,3),We.stroke(n,x),We.dash,We.cap)}En("drawAxes")}function at(x){v.forEach((M,P)=>{P>0&&(M._paths=null,x&&(s==1?(M.min=null,M.max=null):M.facets.forEach(N=>{N.min=null,N.max=null})))})}let Jt=!1,Gn=!1,Rt=[];function cn(){Gn=!1;for(let x=0;x<Rt.length;x++)En(...Rt[x]);Rt.length=0}function Bn(){Jt||(fE(xd),Jt=!0)}function ka(x,M=!1){Jt=!0,Gn=M,x(n),xd(),M&&Rt.length>0&&queueMicrotask(cn)}n.batch=ka;function xd(){if(oe&&(ut(),oe=!1),ye&&(Ee(),ye=!1),xe){if(Gt(h,xo,qe),Gt(h,"top",it),Gt(h,Ia,B),Gt(h,La,Ce),Gt(m,xo,qe),Gt(m,"top",it),Gt(m,Ia,B),Gt(m,La,Ce),Gt(f,Ia,$t),Gt(f,La,on),u.width=yn($t*Mt),u.height=yn(on*Mt),A.forEach(({_el:x,_show:M,_size:P,_pos:N,side:W})=>{if(x!=null)if(M){let K=W===3||W===0?P:0,ae=W%2==1;Gt(x,ae?"left":"top",N-K),Gt(x,ae?"width":"height",P),Gt(x,ae?"top":"left",ae?it:qe),Gt(x,ae?"height":"width",ae?Ce:B),Zf(x,mr)}else hi(x,mr)}),yr=Es=br=z=j=$=Z=Te=E=null,Pe=1,No(!0),qe!=we||it!=Lt||B!=Ve||Ce!=Xe){at(!1);let x=B/Ve,M=Ce/Xe;if(me&&!te&&he.left>=0){he.left*=x,he.top*=M,Mr&&ts(Mr,yn(he.left),0,B,Ce),wr&&ts(wr,0,yn(he.top),B,Ce);for(let P=0;P<st.length;P++){let N=st[P];N!=null&&(Ot[P]*=x,Hn[P]*=M,ts(N,Si(Ot[P]),Si(Hn[P]),B,Ce))}}if(kt.show&&!se&&kt.left>=0&&kt.width>0){kt.left*=x,kt.width*=x,kt.top*=M,kt.height*=M;for(let P in Fu)Gt(Ar,P,kt[P])}we=qe,Lt=it,Ve=B,Xe=Ce}En("setSize"),xe=!1}$t>0&&on>0&&(d.clearRect(0,0,u.width,u.height),En("drawClear"),w.forEach(x=>x()),En("draw")),kt.show&&se&&(za(kt),se=!1),me&&te&&(Zs(null,!0,!1),te=!1),fe.show&&fe.live&&pe&&(Du(),pe=!1),c||(c=!0,n.status=1,En("ready")),ws=!1,Jt=!1}n.redraw=(x,M)=>{ye=M||!1,x!==!1?As(T,I.min,I.max):Bn()};function Pu(x,M){let P=b[x];if(P.from==null){if(Zt==0){let N=P.range(n,M.min,M.max,x);M.min=N[0],M.max=N[1]}if(M.min>M.max){let N=M.min;M.min=M.max,M.max=N}if(Zt>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;x==T&&P.distr==2&&Zt>0&&(M.min=Bi(M.min,e[0]),M.max=Bi(M.max,e[0]),M.min==M.max&&M.max++),G[x]=M,oe=!0,Bn()}}n.setScale=Pu;let Iu,Lu,Mr,wr,vd,yd,Er,Tr,bd,Sd,Bt,Xt,Ts=!1,Pn=he.drag,Mn=Pn.x,wn=Pn.y;me&&(he.x&&(Iu=bi(Uw,m)),he.y&&(Lu=bi(Ow,m)),I.ori==0?(Mr=Iu,wr=Lu):(Mr=Lu,wr=Iu),Bt=he.left,Xt=he.top);let kt=n.select=mn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Ar=kt.show?bi(Fw,kt.over?m:h):null;function za(x,M){if(kt.show){for(let P in x)kt[P]=x[P],P in Fu&&Gt(Ar,P,x[P]);M!==!1&&En("setSelect")}}n.setSelect=za;function P_(x){if(v[x].show)ee&&Zf(Ze[x],mr);else if(ee&&hi(Ze[x],mr),me){let P=Re?st[0]:st[x];P!=null&&ts(P,-10,-10,B,Ce)}}function As(x,M,P){Pu(x,{min:M,max:P})}function Gi(x,M,P,N){M.focus!=null&&F_(x),M.show!=null&&v.forEach((W,K)=>{K>0&&(x==K||x==null)&&(W.show=M.show,P_(K),s==2?(As(W.facets[0].scale,null,null),As(W.facets[1].scale,null,null)):As(W.scale,null,null),Bn())}),P!==!1&&En("setSeries",x,M),N&&Fo("setSeries",n,x,M)}n.setSeries=Gi;function I_(x,M){mn(R[x],M)}function L_(x,M){x.fill=mt(x.fill||null),x.dir=bt(x.dir,-1),M=M??R.length,R.splice(M,0,x)}function D_(x){x==null?R.length=0:R.splice(x,1)}n.addBand=L_,n.setBand=I_,n.delBand=D_;function N_(x,M){v[x].alpha=M,me&&st[x]!=null&&(st[x].style.opacity=M),ee&&Ze[x]&&(Ze[x].style.opacity=M)}let os,Rs,$s,Rr={focus:!0};function F_(x){if(x!=$s){let M=x==null,P=Be.alpha!=1;v.forEach((N,W)=>{if(s==1||W>0){let K=M||W==0||W==x;N._focus=M?null:K,P&&N_(W,K?1:Be.alpha)}}),$s=x,P&&Bn()}}ee&&Ke&&xt(jg,Me,x=>{he._lock||(Je(x),$s!=null&&Gi(null,Rr,!0,un.setSeries))});function Wi(x,M,P){let N=b[M];P&&(x=x/Mt-(N.ori==1?it:qe));let W=B;N.ori==1&&(W=Ce,x=W-x),N.dir==-1&&(x=W-x);let K=N._min,ae=N._max,de=x/W,be=K+(ae-K)*de,De=N.distr;return De==3?bo(10,be):De==4?eE(be,N.asinh):De==100?N.bwd(be):be}function U_(x,M){let P=Wi(x,T,M);return Bi(P,e[0],en,tn)}n.valToIdx=x=>Bi(x,e[0]),n.posToIdx=U_,n.posToVal=Wi,n.valToPos=(x,M,P)=>b[M].ori==0?r(x,b[M],P?q:B,P?C:0):o(x,b[M],P?ue:Ce,P?S:0),n.setCursor=(x,M,P)=>{Bt=x.left,Xt=x.top,Zs(null,M,P)};function Md(x,M){Gt(Ar,xo,kt.left=x),Gt(Ar,Ia,kt.width=M)}function wd(x,M){Gt(Ar,"top",kt.top=x),Gt(Ar,La,kt.height=M)}let Lo=I.ori==0?Md:wd,Do=I.ori==1?Md:wd;function O_(){if(ee&&fe.live)for(let x=s==2?1:0;x<v.length;x++){if(x==0&&ot)continue;let M=fe.values[x],P=0;for(let N in M)Oe[x][P++].firstChild.nodeValue=M[N]}}function Du(x,M){if(x!=null&&(x.idxs?x.idxs.forEach((P,N)=>{ie[N]=P}):sE(x.idx)||ie.fill(x.idx),fe.idx=ie[0]),ee&&fe.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!ot)&&B_(P,ie[P]);O_()}pe=!1,M!==!1&&En("setLegend")}n.setLegend=Du;function B_(x,M){let P=v[x],N=x==0&&O==2?ei:e[x],W;ot?W=P.values(n,x,M)??tt:(W=P.value(n,M==null?null:N[M],x,M),W=W==null?tt:{_:W}),fe.values[x]=W}function Zs(x,M,P){bd=Bt,Sd=Xt,[Bt,Xt]=he.move(n,Bt,Xt),he.left=Bt,he.top=Xt,me&&(Mr&&ts(Mr,yn(Bt),0,B,Ce),wr&&ts(wr,0,yn(Xt),B,Ce));let N,W=en>tn;os=Dt,Rs=null;let K=I.ori==0?B:Ce,ae=I.ori==1?B:Ce;if(Bt<0||Zt==0||W){N=he.idx=null;for(let de=0;de<v.length;de++){let be=st[de];be!=null&&ts(be,-10,-10,B,Ce)}Ke&&Gi(null,Rr,!0,x==null&&un.setSeries),fe.live&&(ie.fill(N),pe=!0)}else{let de,be,De;s==1&&(de=I.ori==0?Bt:Xt,be=Wi(de,T),N=he.idx=Bi(be,e[0],en,tn),De=k(e[0][N],I,K,0));let Ne=-10,Ue=-10,nt=0,St=0,yt=!0,ft="",$e="";for(let We=s==2?1:0;We<v.length;We++){let zt=v[We],Kt=ie[We],Tn=Kt==null?null:s==1?e[We][Kt]:e[We][1][Kt],It=he.dataIdx(n,We,N,be),jt=It==null?null:s==1?e[We][It]:e[We][1][It];if(pe=pe||jt!=Tn||It!=Kt,ie[We]=It,We>0&&zt.show){let ti=It==null?-10:It==N?De:k(s==1?e[0][It]:e[We][0][It],I,K,0),Wn=jt==null?-10:D(jt,s==1?b[zt.scale]:b[zt.facets[1].scale],ae,0);if(Ke&&jt!=null){let pi=I.ori==1?Bt:Xt,wi=bn(Be.dist(n,We,It,Wn,pi));if(wi<os){let Xi=Be.bias;if(Xi!=0){let ni=Wi(pi,zt.scale),mi=jt>=0?1:-1,Ei=ni>=0?1:-1;Ei==mi&&(Ei==1?Xi==1?jt>=ni:jt<=ni:Xi==1?jt<=ni:jt>=ni)&&(os=wi,Rs=We)}else os=wi,Rs=We}}if(pe||Re){let pi,wi;I.ori==0?(pi=ti,wi=Wn):(pi=Wn,wi=ti);let Xi,ni,mi,Ei,qi,Xn,ii=!0,Js=ce.bbox;if(Js!=null){ii=!1;let qn=Js(n,We);mi=qn.left,Ei=qn.top,Xi=qn.width,ni=qn.height}else mi=pi,Ei=wi,Xi=ni=ce.size(n,We);if(Xn=ce.fill(n,We),qi=ce.stroke(n,We),Re)We==Rs&&os<=Be.prox&&(Ne=mi,Ue=Ei,nt=Xi,St=ni,yt=ii,ft=Xn,$e=qi);else{let qn=st[We];qn!=null&&(Ot[We]=mi,Hn[We]=Ei,r0(qn,Xi,ni,ii),i0(qn,Xn,qi),ts(qn,Si(mi),Si(Ei),B,Ce))}}}}if(Re){let We=Be.prox,zt=$s==null?os<=We:os>We||Rs!=$s;if(pe||zt){let Kt=st[0];Kt!=null&&(Ot[0]=Ne,Hn[0]=Ue,r0(Kt,nt,St,yt),i0(Kt,ft,$e),ts(Kt,Si(Ne),Si(Ue),B,Ce))}}}if(kt.show&&Ts)if(x!=null){let[de,be]=un.scales,[De,Ne]=un.match,[Ue,nt]=x.cursor.sync.scales,St=x.cursor.drag;if(Mn=St._x,wn=St._y,Mn||wn){let{left:yt,top:ft,width:$e,height:We}=x.select,zt=x.scales[Ue].ori,Kt=x.posToVal,Tn,It,jt,ti,Wn,pi=de!=null&&De(de,Ue),wi=be!=null&&Ne(be,nt);pi&&Mn?(zt==0?(Tn=yt,It=$e):(Tn=ft,It=We),jt=b[de],ti=k(Kt(Tn,Ue),jt,K,0),Wn=k(Kt(Tn+It,Ue),jt,K,0),Lo(ki(ti,Wn),bn(Wn-ti))):Lo(0,K),wi&&wn?(zt==1?(Tn=yt,It=$e):(Tn=ft,It=We),jt=b[be],ti=D(Kt(Tn,nt),jt,ae,0),Wn=D(Kt(Tn+It,nt),jt,ae,0),Do(ki(ti,Wn),bn(Wn-ti))):Do(0,ae)}else Uu()}else{let de=bn(bd-vd),be=bn(Sd-yd);if(I.ori==1){let nt=de;de=be,be=nt}Mn=Pn.x&&de>=Pn.dist,wn=Pn.y&&be>=Pn.dist;let De=Pn.uni;De!=null?Mn&&wn&&(Mn=de>=De,wn=be>=De,!Mn&&!wn&&(be>de?wn=!0:Mn=!0)):Pn.x&&Pn.y&&(Mn||wn)&&(Mn=wn=!0);let Ne,Ue;Mn&&(I.ori==0?(Ne=Er,Ue=Bt):(Ne=Tr,Ue=Xt),Lo(ki(Ne,Ue),bn(Ue-Ne)),wn||Do(0,ae)),wn&&(I.ori==1?(Ne=Er,Ue=Bt):(Ne=Tr,Ue=Xt),Do(ki(Ne,Ue),bn(Ue-Ne)),Mn||Lo(0,K)),!Mn&&!wn&&(Lo(0,0),Do(0,0))}if(Pn._x=Mn,Pn._y=wn,x==null){if(P){if(Fd!=null){let[de,be]=un.scales;un.values[0]=de!=null?Wi(I.ori==0?Bt:Xt,de):null,un.values[1]=be!=null?Wi(I.ori==1?Bt:Xt,be):null}Fo(Vf,n,Bt,Xt,B,Ce,N)}if(Ke){let de=P&&un.setSeries,be=Be.prox;$s==null?os<=be&&Gi(Rs,Rr,!0,de):os>be?Gi(null,Rr,!0,de):Rs!=$s&&Gi(Rs,Rr,!0,de)}}pe&&(fe.idx=N,Du()),M!==!1&&En("setCursor")}let Cs=null;Object.defineProperty(n,"rect",{get(){return Cs==null&&No(!1),Cs}});function No(x=!1){x?Cs=null:(Cs=m.getBoundingClientRect(),En("syncRect",Cs))}function Ed(x,M,P,N,W,K,ae){he._lock||Ts&&x!=null&&x.movementX==0&&x.movementY==0||(Nu(x,M,P,N,W,K,ae,!1,x!=null),x!=null?Zs(null,!0,!0):Zs(M,!0,!1))}function Nu(x,M,P,N,W,K,ae,de,be){if(Cs==null&&No(!1),Je(x),x!=null)P=x.clientX-Cs.left,N=x.clientY-Cs.top;else{if(P<0||N<0){Bt=-10,Xt=-10;return}let[De,Ne]=un.scales,Ue=M.cursor.sync,[nt,St]=Ue.values,[yt,ft]=Ue.scales,[$e,We]=un.match,zt=M.axes[0].side%2==1,Kt=I.ori==0?B:Ce,Tn=I.ori==1?B:Ce,It=zt?K:W,jt=zt?W:K,ti=zt?N:P,Wn=zt?P:N;if(yt!=null?P=$e(De,yt)?a(nt,b[De],Kt,0):-10:P=Kt*(ti/It),ft!=null?N=We(Ne,ft)?a(St,b[Ne],Tn,0):-10:N=Tn*(Wn/jt),I.ori==1){let pi=P;P=N,N=pi}}be&&(M==null||M.cursor.event.type==Vf)&&((P<=1||P>=B-1)&&(P=dr(P,B)),(N<=1||N>=Ce-1)&&(N=dr(N,Ce))),de?(vd=P,yd=N,[Er,Tr]=he.move(n,P,N)):(Bt=P,Xt=N)}let Fu={width:0,height:0,left:0,top:0};function Uu(){za(Fu,!1)}let Td,Ad,Rd,Cd;function Pd(x,M,P,N,W,K,ae){Ts=!0,Mn=wn=Pn._x=Pn._y=!1,Nu(x,M,P,N,W,K,ae,!0,!1),x!=null&&(xt(Hf,Yf,Id,!1),Fo(Jg,n,Er,Tr,B,Ce,null));let{left:de,top:be,width:De,height:Ne}=kt;Td=de,Ad=be,Rd=De,Cd=Ne}function Id(x,M,P,N,W,K,ae){Ts=Pn._x=Pn._y=!1,Nu(x,M,P,N,W,K,ae,!1,!0);let{left:de,top:be,width:De,height:Ne}=kt,Ue=De>0||Ne>0,nt=Td!=de||Ad!=be||Rd!=De||Cd!=Ne;if(Ue&&nt&&za(kt),Pn.setScale&&Ue&&nt){let St=de,yt=De,ft=be,$e=Ne;if(I.ori==1&&(St=be,yt=Ne,ft=de,$e=De),Mn&&As(T,Wi(St,T),Wi(St+yt,T)),wn)for(let We in b){let zt=b[We];We!=T&&zt.from==null&&zt.min!=Dt&&As(We,Wi(ft+$e,We),Wi(ft,We))}Uu()}else he.lock&&(he._lock=!he._lock,Zs(M,!0,x!=null));x!=null&&(gn(Hf,Yf),Fo(Hf,n,Bt,Xt,B,Ce,null))}function k_(x,M,P,N,W,K,ae){if(he._lock)return;Je(x);let de=Ts;if(Ts){let be=!0,De=!0,Ne=10,Ue,nt;I.ori==0?(Ue=Mn,nt=wn):(Ue=wn,nt=Mn),Ue&&nt&&(be=Bt<=Ne||Bt>=B-Ne,De=Xt<=Ne||Xt>=Ce-Ne),Ue&&be&&(Bt=Bt<Er?0:B),nt&&De&&(Xt=Xt<Tr?0:Ce),Zs(null,!0,!0),Ts=!1}Bt=-10,Xt=-10,ie.fill(null),Zs(null,!0,!0),de&&(Ts=de)}function Ld(x,M,P,N,W,K,ae){he._lock||(Je(x),Io(),Uu(),x!=null&&Fo(Qg,n,Bt,Xt,B,Ce,null))}function Dd(){A.forEach(y1),U(n.width,n.height,!0)}gr(xu,yo,Dd);let Cr={};Cr.mousedown=Pd,Cr.mousemove=Ed,Cr.mouseup=Id,Cr.dblclick=Ld,Cr.setSeries=(x,M,P,N)=>{let W=un.match[2];P=W(n,M,P),P!=-1&&Gi(P,N,!0,!1)},me&&(xt(Jg,m,Pd),xt(Vf,m,Ed),xt(Kg,m,x=>{Je(x),No(!1)}),xt(jg,m,k_),xt(Qg,m,Ld),td.add(n),n.syncRect=No);let Va=n.hooks=i.hooks||{};function En(x,M,P){Gn?Rt.push([x,M,P]):x in Va&&Va[x].forEach(N=>{N.call(null,n,M,P)})}(i.plugins||[]).forEach(x=>{for(let M in x.hooks)Va[M]=(Va[M]||[]).concat(x.hooks[M])});let Nd=(x,M,P)=>P,un=mn({key:null,setSeries:!1,filters:{pub:u0,sub:u0},scales:[T,v[1]?v[1].scale:null],match:[h0,h0,Nd],values:[null,null]},he.sync);un.match.length==2&&un.match.push(Nd),he.sync=un;let Fd=un.key,Ou=a_(Fd);function Fo(x,M,P,N,W,K,ae){un.filters.pub(x,M,P,N,W,K,ae)&&Ou.pub(x,M,P,N,W,K,ae)}Ou.sub(n);function z_(x,M,P,N,W,K,ae){un.filters.sub(x,M,P,N,W,K,ae)&&Cr[x](null,M,P,N,W,K,ae)}n.pub=z_;function V_(){Ou.unsub(n),td.delete(n),Sn.clear(),Jf(xu,yo,Dd),l.remove(),Me?.remove(),En("destroy")}n.destroy=V_;function Bu(){En("init",i,e),Po(e||i.data,!1),G[T]?Pu(T,G[T]):Io(),se=kt.show&&(kt.width>0||kt.height>0),te=pe=!0,U(i.width,i.height)}return v.forEach(vr),A.forEach(ns),t?t instanceof HTMLElement?(t.appendChild(l),Bu()):t(n,Bu):Bu(),n}On.assign=mn;On.fmtNum=ld;On.rangeNum=vu;On.rangeLog=Su;On.rangeAsinh=od;On.orient=xr;On.pxRatio=Mt;On.join=hE;On.fmtDate=ud,On.tzDate=SE;On.sync=a_;{On.addGap=s1,On.clipGaps=Eu;let i=On.paths={points:d_};i.linear=m_,i.stepped=a1,i.bars=l1,i.spline=u1}var b1=new Set(["step","time","cycle","roll_angle","position"]);function _d(i){return i.values.reduce((e,t)=>t!==null&&Number.isFinite(t)?Math.max(e,Math.abs(t)):e,0)}function v_({core:i}){let e=i.source?.outputs?.columns??[],t=e.filter(o=>!b1.has(o.name)&&o.values.some(a=>typeof a=="number"&&Number.isFinite(a))),n=t.find(o=>i.state.plotted.includes(o.name))?.name??t[0]?.name??"",s=t.find(o=>o.name===n),r=e.find(o=>o.name==="time");return V("section",{class:"cv-plots","aria-label":"Plots",children:s?V(In,{children:[V("div",{class:"cv-plots-head",children:[V(Un,{quiet:!0,label:"Output",value:n,options:t.map(o=>({value:o.name,label:o.name.replaceAll("_"," ")})),onChange:o=>i.update({plotted:[o]})}),V(S1,{core:i,column:s,time:r})]}),V(M1,{core:i,column:s,time:r})]}):V("div",{class:"cv-muted",children:"This run has no outputs over the positions."})})}function y_(i,e){let t=i.positions?.list[i.state.position];if(!t||!e)return i.state.position;let n=0;return e.values.forEach((s,r)=>{Math.abs((s??1/0)-t.time)<Math.abs((e.values[n]??1/0)-t.time)&&(n=r)}),n}function S1({core:i,column:e,time:t}){let n=e.values[y_(i,t)]??NaN,s=Ui(e.unit,_d(e));return V("output",{class:"cv-muted",children:Number.isFinite(n)?`${Fn(n*s.factor,5)} ${s.symbol}`:"no value"})}function M1({core:i,column:e,time:t}){let n=bs(null),s=bs(null),r=y_(i,t),{theme:o}=i.theme;return ys(()=>{let a=n.current,c=getComputedStyle(i.element),l=p=>c.getPropertyValue(p).trim(),u=Ui(e.unit,_d(e)),d=Ui("s",t?_d(t):0),f=t?t.values.map(p=>(p??NaN)*d.factor):e.values.map((p,v)=>v),h=e.values.map(p=>p===null||!Number.isFinite(p)?null:p*u.factor),m=p=>({label:p,labelSize:18,size:44,font:"11px system-ui, sans-serif",labelFont:"11px system-ui, sans-serif",stroke:l("--cv-muted"),grid:{stroke:l("--cv-line"),width:1},ticks:{stroke:l("--cv-line"),width:1,size:4}}),y=new On({width:a.clientWidth,height:a.clientHeight,scales:{x:{time:!1}},legend:{show:!1},cursor:{y:!1,points:{size:7},drag:{x:!1,y:!1}},series:[{},{stroke:l("--cv-accent"),width:1.75,points:{show:f.length<60}}],axes:[{...m(t?`time in ${d.symbol}`:"position"),size:30},{...m(u.symbol),size:56}],hooks:{drawAxes:[p=>w1(p,l("--cv-mark"))]}},[f,h],a);s.current=y,y.over.addEventListener("click",()=>{let p=y.cursor.idx,v=i.positions?.list??[];if(p==null||v.length===0)return;let A=t?t.values[p]??0:p,b=0;v.forEach((R,T)=>{let _=w=>Math.abs((t?v[w].time:w)-A);_(T)<_(b)&&(b=T)}),i.animation.stop(),i.goTo(b)});let g=new ResizeObserver(()=>y.setSize({width:a.clientWidth,height:a.clientHeight}));return g.observe(a),()=>{g.disconnect(),y.destroy(),s.current=null}},[i,e,t,o]),ys(()=>{b_.set(s.current,r),s.current?.redraw(!1)},[r,e,t,o]),V("div",{class:"cv-plot",ref:n,role:"img","aria-label":`${e.name.replaceAll("_"," ")} over ${t?"time":"positions"}`})}var b_=new WeakMap;function w1(i,e){let t=b_.get(i),n=t===void 0?void 0:i.data[0][t];if(n===void 0)return;let s=Math.round(i.valToPos(n,"x",!0))+.5,{ctx:r,bbox:o}=i;r.save(),r.strokeStyle=e,r.lineWidth=1.5*(window.devicePixelRatio||1),r.beginPath(),r.moveTo(s,o.top),r.lineTo(s,o.top+o.height),r.stroke(),r.restore()}function S_({core:i}){return V("aside",{class:"cv-panel cv-settings","aria-label":"Settings",children:V("div",{class:"cv-scroll",children:[i.state.colours.field!=="plain"?V(E1,{core:i}):null,i.hasMeshes?V(T1,{core:i}):null,V(A1,{core:i}),V(R1,{core:i}),V(_o,{title:"Display",children:[V(es,{label:"Mesh edges",value:i.state.mesh_edges,onChange:e=>i.update({mesh_edges:e})}),V(Un,{label:"Theme",value:i.state.theme,options:[{value:"system",label:"As the system"},{value:"light",label:"Light"},{value:"dark",label:"Dark"}],onChange:e=>i.update({theme:e})})]})]})})}function E1({core:i}){let{colours:e}=i.state,t=Ta(i),n=i.display?.limits??[0,1],s=(r,o)=>i.update({colours:{limits:"fixed",min:r,max:o}});return V(_o,{title:"Colours",children:[V(Un,{label:"Limits",value:e.limits,options:[{value:"position",label:"This position"},{value:"all",label:"All positions"},{value:"fixed",label:"Fixed"}],onChange:r=>r==="fixed"?s(n[0],n[1]):i.update({colours:{limits:r}})}),V(Ca,{label:"Maximum",unit:t.symbol,value:n[1]*t.factor,onChange:r=>s(n[0],r/t.factor)}),V(Ca,{label:"Minimum",unit:t.symbol,value:n[0]*t.factor,onChange:r=>s(r/t.factor,n[1])}),V(Un,{label:"Scale",value:e.scale,options:Wm.map(({name:r,label:o})=>({value:r,label:o})),onChange:r=>i.update({colours:{scale:r}})}),V(Un,{label:"Bands",value:String(e.bands),options:["0","6","8","10","12","16","24"].map(r=>({value:r,label:r==="0"?"Continuous":r})),onChange:r=>i.update({colours:{bands:Number(r)}})}),V(es,{label:"Mark the extreme values",value:i.state.extremes,onChange:r=>i.update({extremes:r})}),Ni(e.field)?null:V(es,{label:"Show contacts behind surfaces",value:i.state.hidden_contacts,onChange:r=>i.update({hidden_contacts:r})})]})}function T1({core:i}){let{mode:e}=i.state.deformation;return V(_o,{title:"Deformation",children:[V(es,{label:"Automatic factor",value:e==="automatic",onChange:t=>i.update({deformation:{mode:t?"automatic":"factor",factor:i.display.factor}})}),V(Ca,{label:"Factor",unit:"×",value:i.display.factor,onChange:t=>i.update({deformation:{mode:"factor",factor:t}})})]})}function A1({core:i}){let{cut:e}=i.state,t=i.display.cut,n=()=>{let r=i.scene.camera.direction;return[r.x,r.y,r.z]},s=typeof e.normal=="string"?e.normal:"view";return V(_o,{title:"Cutting plane",children:[V(es,{label:"Cut",value:e.on,onChange:r=>i.update({cut:{on:r}})}),e.on?V(In,{children:[V(Un,{label:"Normal",value:s,options:[{value:"x",label:"x"},{value:"y",label:"y"},{value:"z",label:"z"},{value:"view",label:"View direction"}],onChange:r=>i.update({cut:{normal:r==="view"?n():r,offset:null}})}),V(kf,{label:"Location",min:t.range[0],max:t.range[1],value:t.offset,text:`${Fn(t.offset*1e3,4)} mm`,onInput:r=>i.update({cut:{offset:r}})}),V(Ca,{label:"Coordinate",unit:"mm",value:t.offset*1e3,onChange:r=>i.update({cut:{offset:r/1e3}})}),V(es,{label:"Flip",value:e.flipped,onChange:r=>i.update({cut:{flipped:r}})})]}):null]})}function R1({core:i}){let{forces:e}=i.state,t=e.bearings||e.meshes;return V(_o,{title:"Forces",children:[V(es,{label:"At bearings",value:e.bearings,onChange:n=>i.update({forces:{bearings:n}})}),V(es,{label:"At meshes",value:e.meshes,onChange:n=>i.update({forces:{meshes:n}})}),t?V(In,{children:[V(es,{label:"Labels",value:e.labels,onChange:n=>i.update({forces:{labels:n}})}),V(kf,{label:"Length",min:.2,max:4,value:e.scale,onInput:n=>i.update({forces:{scale:n}})})]}):null]})}var C1=[1,2,5,10,20,30,60];function M_({core:i}){let e=i.positions?.list??[],{state:t,animation:n}=i;if(e.length===0)return V("div",{class:"cv-timeline cv-muted",children:"No positions yet"});let s=e[Math.min(t.position,e.length-1)],r=e[e.length-1],o=Ui("s",Math.max(Math.abs(r.time),Math.abs(e[0].time))),a=`${Fn(s.time*o.factor)} ${o.symbol}`,c=e.length>1;return V("div",{class:"cv-timeline",role:"group","aria-label":"Animation",children:[V(Cn,{icon:"previous",label:"Previous position",shortcut:",",disabled:!c,onClick:()=>n.step(-1)}),V(Cn,{icon:n.playing?"pause":"play",label:n.playing?"Pause":"Play",shortcut:"K",disabled:!c,onClick:()=>n.toggle()}),V(Cn,{icon:"next",label:"Next position",shortcut:".",disabled:!c,onClick:()=>n.step(1)}),V("input",{class:"cv-time",type:"range",min:0,max:e.length-1,step:1,value:t.position,disabled:!c,"aria-label":"Position","aria-valuetext":`position ${s.position}, ${a}`,onInput:l=>{n.stop(),i.goTo(Number(l.currentTarget.value))}}),V("output",{class:"cv-clock",children:[V("span",{children:s.position}),V("span",{class:"cv-muted",children:[" / ",r.position]}),V("span",{class:"cv-clock-time",children:a})]}),V(Un,{quiet:!0,label:"Speed, positions per second",value:String(t.animation.speed),options:[...new Set([...C1,t.animation.speed])].sort((l,u)=>l-u).map(l=>({value:String(l),label:`${l} / s`})),onChange:l=>i.update({animation:{speed:Number(l)}})}),V(Cn,{icon:"loop",label:"Loop",pressed:t.animation.loop,onClick:()=>i.update({animation:{loop:!t.animation.loop}})})]})}var P1=[{value:"",label:"View"},{value:"isometric",label:"Isometric"},{value:"front",label:"Front"},{value:"back",label:"Back"},{value:"left",label:"Left"},{value:"right",label:"Right"},{value:"top",label:"Top"},{value:"bottom",label:"Bottom"}],I1=Object.keys(Fi);function w_({core:i,showTitle:e,showTheme:t}){let{state:n,scene:s,status:r}=i,o=r==="ready"&&s!==null,a=n.camera?.projection==="orthographic",c=n.forces.bearings||n.forces.meshes,l=i.theme.theme==="dark";return V("div",{class:"cv-toolbar",role:"toolbar","aria-label":"View",children:[V(Cn,{icon:"parts",label:"Parts",shortcut:"B",pressed:n.panels.parts,onClick:()=>i.update({panels:{parts:!n.panels.parts}})}),e?V("h1",{class:"cv-title",title:i.source?.title,children:i.source?.title??"Calyx"}):null,o?V(In,{children:[V("span",{class:"cv-rule"}),V(Cn,{icon:"fit",label:"Fit",shortcut:"F",onClick:()=>s.camera.fit()}),V(Un,{quiet:!0,label:"Standard view",value:"",options:P1,onChange:u=>{u&&s.camera.view(u),i.changed(!1)}}),V(Cn,{icon:a?"orthographic":"perspective",label:"Orthographic projection",shortcut:"P",pressed:a,onClick:()=>s.camera.setProjection(a?"perspective":"orthographic")}),V("span",{class:"cv-rule"}),V(Un,{quiet:!0,label:"Colours",value:n.colours.field,options:I1.map(u=>({value:u,label:Fi[u].label})),onChange:u=>i.update({colours:{field:u,limits:n.colours.limits==="fixed"?"position":n.colours.limits}})}),i.hasMeshes?V(L1,{core:i}):null,V("span",{class:"cv-rule"}),V(Cn,{icon:"mesh",label:"Mesh edges",shortcut:"M",pressed:n.mesh_edges,onClick:()=>i.update({mesh_edges:!n.mesh_edges})}),V(Cn,{icon:"force",label:"Force vectors",shortcut:"V",pressed:c,onClick:()=>i.update({forces:{bearings:!c,meshes:!c}})}),V(Cn,{icon:"cut",label:"Cutting plane",shortcut:"C",pressed:n.cut.on,onClick:()=>{let u=!n.cut.on;i.update({cut:{on:u},panels:{settings:u||n.panels.settings}})}})]}):null,V("span",{class:"cv-space"}),o?V(In,{children:[V(Cn,{icon:"plot",label:"Plots",shortcut:"G",pressed:n.panels.plots,onClick:()=>i.update({panels:{plots:!n.panels.plots}})}),V(D1,{core:i}),V(Cn,{icon:"settings",label:"Settings",shortcut:"S",pressed:n.panels.settings,onClick:()=>i.update({panels:{settings:!n.panels.settings}})})]}):null,t?V(Cn,{icon:l?"sun":"moon",label:l?"Light theme":"Dark theme",onClick:()=>i.update({theme:l?"light":"dark"})}):null,V(Cn,{icon:"help",label:"Help",shortcut:"?",pressed:i.help,onClick:()=>{i.help=!i.help,i.changed(!1)}})]})}function L1({core:i}){let{mode:e,factor:t}=i.state.deformation,n=e==="automatic"?"automatic":t===0||t===1?String(t):"other";return V(In,{children:[V(Un,{quiet:!0,label:"Deformation",value:n,options:[{value:"automatic",label:"Deformation: automatic"},{value:"0",label:"Undeformed"},{value:"1",label:"True deformation"},{value:"other",label:"Other factor …"}],onChange:s=>{s==="automatic"?i.update({deformation:{mode:"automatic"}}):s==="other"?i.update({deformation:{mode:"factor",factor:i.display.factor||10},panels:{settings:!0}}):i.update({deformation:{mode:"factor",factor:Number(s)}})}}),V("output",{class:"cv-factor","aria-label":"Factor of the deformation",title:"Factor of the displayed deformation",children:["× ",Fn(i.display.factor,3)]})]})}function D1({core:i}){let[e,t]=go("");return V("span",{class:"cv-export",children:V(Un,{quiet:!0,label:e?`Export. ${e}`:"Export the picture",value:"",options:[{value:"",label:"Export"},{value:"png",label:"PNG"},{value:"svg",label:"SVG"},{value:"pdf",label:"PDF"}],onChange:n=>{n&&Rg(i,n).catch(s=>t(String(s))),i.changed(!1)}})})}function E_({core:i}){let{probe:e,scene:t}=i;if(!e||!t)return null;let n=Ta(i),{x:s,y:r,z:o}=e.point,a=e.x>t.width-240?{right:t.width-e.x+16}:{left:e.x+16},c=e.y>t.height-120?{bottom:t.height-e.y+12}:{top:e.y+16},l=e.value!==null&&Number.isFinite(e.value);return V("div",{class:"cv-tooltip",role:"status","aria-label":"Value at the pointer","data-value":e.value===null?"":String(e.value),style:{...a,...c},children:[e.value!==null?V("div",{class:"cv-tooltip-value",children:[V("span",{class:"cv-muted",children:Fi[i.state.colours.field].label}),V("strong",{children:l?`${Fn(e.value*n.factor,6)} ${n.symbol}`:"no value"})]}):null,V("div",{children:[e.part,e.tooth!==null?`, tooth ${e.tooth}`:"",e.node!==null?`, node ${e.node}`:""]}),V("div",{class:"cv-muted",children:[[s,r,o].map(u=>Fn(Math.round(u*1e6)/1e3,6)).join("  ")," mm"]})]})}var T_=[{name:"x",azimuth:0,elevation:0,v:[1,0,0]},{name:"y",azimuth:90,elevation:0,v:[0,1,0]},{name:"z",azimuth:-90,elevation:90,v:[0,0,1]}];function A_({core:i}){let e=bs(null);return ys(()=>N1(i,e.current)),V("svg",{class:"cv-triad",viewBox:"-34 -34 68 68",ref:e,"aria-hidden":"true",children:T_.map(({name:t})=>V("g",{class:`cv-axis-${t}`,children:[V("line",{}),V("text",{"text-anchor":"middle","dominant-baseline":"central",children:t})]},t))})}function N1(i,e){let t=i.state.camera??i.scene?.camera.state;if(!t)return;let n=t.azimuth*Math.PI/180,s=t.elevation*Math.PI/180,r=[-Math.sin(n),Math.cos(n),0],o=[-Math.sin(s)*Math.cos(n),-Math.sin(s)*Math.sin(n),Math.cos(s)];T_.forEach(({v:a},c)=>{let l=a[0]*r[0]+a[1]*r[1]+a[2]*r[2],u=-(a[0]*o[0]+a[1]*o[1]+a[2]*o[2]),d=e.children[c],[f,h]=[d.children[0],d.children[1]];f.setAttribute("x2",String(20*l)),f.setAttribute("y2",String(20*u)),h.setAttribute("x",String(28*l)),h.setAttribute("y",String(28*u)),d.setAttribute("opacity",Math.hypot(l,u)<.12?"0.15":"1")})}function R_({core:i,stage:e,showTitle:t,showTheme:n}){Vg(i);let{status:s,state:r}=i,o=s==="ready";return V(In,{children:[V(w_,{core:i,showTitle:t,showTheme:n}),V("div",{class:"cv-body",children:[o&&r.panels.parts?V(Xg,{core:i}):null,V("div",{class:"cv-centre",children:[V("div",{class:"cv-view",children:[V(F1,{stage:e}),o?V(A_,{core:i}):null,o?V(Gg,{core:i}):null,o?V(E_,{core:i}):null,i.notice?V("div",{class:"cv-notice",role:"alert",children:i.notice}):null,s==="loading"?V("div",{class:"cv-message",role:"status",children:"Reading the shapes …"}):null,o&&i.parts?.parts.length===0?V("div",{class:"cv-message",children:"This run has no parts to display."}):null,s==="failed"?V("div",{class:"cv-message",role:"alert",children:[V("strong",{children:"The view cannot be displayed."}),V("span",{children:i.failure})]}):null]}),o&&r.panels.plots?V(v_,{core:i}):null,o?V(M_,{core:i}):null]}),o&&r.panels.settings?V(S_,{core:i}):null]}),i.help?V(Hg,{core:i}):null]})}function F1({stage:i}){let e=bs(null);return ys(()=>{e.current.append(i)},[i]),V("div",{class:"cv-holder",ref:e})}var Oa=class{onChange=null;#e;#t;#n=new AbortController;#i=new Set;constructor(e,t={}){let n=document.createElement("div");n.className="calyx-viewer";let s=document.createElement("div");s.className="cv-stage",e.append(n),this.#t=n;let r=new uu(n,s,t.state??{});if(this.#e=r,r.onChange=a=>this.onChange?.(a),qu(V(R_,{core:r,stage:s,showTitle:t.showTitle??!0,showTheme:t.showTheme??!0}),n),r.scene){let{canvas:a,camera:c}=r.scene;a.tabIndex=0,a.setAttribute("role","img"),a.setAttribute("aria-label","Three-dimensional view. Arrow keys orbit, plus and minus zoom, question mark shows all shortcuts."),vg(r,a);let l=c.onChange;c.onChange=u=>{if(l?.(u),u)for(let d of this.#i)d.#e.scene?.camera.set(c.state)}}let o=a=>{Sg(r,a)&&a.preventDefault()};n.addEventListener("keydown",o),t.pageKeys&&document.addEventListener("keydown",a=>a.target===document.body&&o(a),{signal:this.#n.signal})}fail(e){this.#e.fail(new Error(e))}show(e){return this.#e.show(e)}reload(){return this.#e.reload()}updatePositions(){return this.#e.updatePositions()}get state(){return structuredClone(this.#e.state)}restore(e){this.#e.update(e)}linkCamera(e){this.#i.add(e),e.#i.add(this);let{camera:t}=this.#e.state;return t&&e.#e.scene?.camera.set(t),()=>{this.#i.delete(e),e.#i.delete(this)}}image(e){return Lf(this.#e,e)}get frames(){return this.#e.scene?.frames??0}get triangles(){return this.#e.display?.triangles??0}draw(){this.#e.scene?.draw()}project(e,t){return this.#e.project(e,t)}nodalValue(e,t){return this.#e.nodalValue(e,t)}contactLoads(){let e=this.#e.display?.position?.contacts,t=this.#e.parts?.parts.map(({name:n})=>n)??[];return e?[...Vm(e)].map(([n,s])=>{let[r,o]=n.split(" ").map(Number);return{parts:[t[r]??"",t[o]??""],load:s}}):[]}dispose(){for(let e of this.#i)e.#i.delete(this);this.#i.clear(),this.#n.abort(),qu(null,this.#t),this.#e.dispose(),this.#t.remove()}};function C_(){let i=document.getElementById("calyx-viewer")??document.body,e=new Oa(i,{pageKeys:!0});window.calyxViewer=e;let t=document.getElementById("calyx-view"),n;try{n=JSON.parse(t?.textContent??"")}catch{e.fail("The data embedded in this page are missing or damaged.");return}n.title&&(document.title=n.title),e.show(Af(n))}document.readyState==="loading"?document.addEventListener("DOMContentLoaded",C_):C_();})();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
