"use strict";(()=>{var Lt,qp,Uv,Os,Sh,al,$p,il,Yp,Eh,wh,Ov,Ko=Symbol.for("pv"),ll={},cl=[],Bv=/^m(i|n|o|s|text|space)$/,Th=Array.isArray,Zp=cl.slice,ur=Object.assign;function cr(n){n&&n.parentNode&&n.remove()}function sl(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Ko,__v:s||++qp,__i:-1,__u:0};return!s&&Lt.vnode&&Lt.vnode(r),r}function Dt(n){return n.children}function rl(n,e){this.props=n,this.context=e,this.__g=0}function Bs(n,e){if(e==null)return n.__&&Bs(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:Bs(n)}function kv(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=ur({constructor:Ko},t)).__v=t.__v+1,Lt.vnode&&Lt.vnode(e),Ah(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||Bs(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,tm(s,e,r),t.__=t.__e=null,e.__e!=i&&Jp(e))}function Jp(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),Jp(n)}function Wp(n){(8&n.__g||(n.__g|=8,Os.push(n),al++))&&Sh==Lt.debounceRendering||((Sh=Lt.debounceRendering)||queueMicrotask)(Kp)}function Kp(){try{for(var n,e=1;Os.length;)Os.length>e&&Os.sort($p),n=Os.shift(),e=Os.length,8&n.__g&&kv(n)}finally{(al=Os.length)&&(Sh||queueMicrotask)(Kp)}}function jp(n,e,t,i,s,r,o,a,l,c,u){var d,h,f,p,_,m,g=i.__k||cl,x=e.length;for(l=zv(t,e,g,l,x),d=0;d<x;d++)(f=t.__k[d])!=null&&(h=~f.__i&&g[f.__i]||ll,f.__i=d,m=Ah(n,f,h,s,r,o,a,l,c,u),p=f.__e,(h.ref!=f.ref||8&h.__u)&&(h.ref&&Ch(h.ref,null,f,h),f.ref&&u.push(f.ref,f.__c||p,f)),_=_||p,4&f.__u?(l=Qp(f,l,n,!h.__v),h.__e&&(h.__e=null)):typeof f.type=="function"&&m!==void 0?l=m:p&&(l=p.nextSibling),f.__u&=-21);return t.__e=_,l}function zv(n,e,t,i,s){var r,o,a,l,c,u,d,h,f,p=t.length,_=p,m=0,g=0,x=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=x[r]=sl(null,o):Th(o)?o=x[r]=sl(Dt,{children:o}):o.constructor===Ko&&o.__b?o=x[r]=sl(o.type,o.props,o.key,o.ref,o.__v):x[r]=o,l=r+m,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=Hv(o,t,l,_))&&(_--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?m--:c==l+1?m++:c!=l&&(c>l?m--:m++,g=1)):(~c||(s>p?m--:s<p&&m++),typeof o.type!="function"&&(o.__u|=4))):x[r]=null;if(g){for(u=[],d=[],r=0;r<s;r++)if((o=x[r])&&16&o.__u){for(m=0,h=u.length;m<h;)u[f=m+h>>1]<o.__i?m=f+1:h=f;u[m]=o.__i,d[r]=m+1}for(m=u.length;r--;)d[r]&&(d[r]==m?m--:x[r].__u|=4)}if(_)for(r=0;r<p;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=Bs(a)),Rh(a,a));return i}function Qp(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=Qp(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=Bs(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Hv(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function Xp(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function nl(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Xp(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Xp(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=wh[e]||(wh[e]=Vv(e)),(n.__a||(n.__a={}))[e]=Eh,r=e!=(e=e.replace(Yp,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function Vv(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[il]==null)e[il]=Eh++;else if(e[il]<this.__a[n])return;return t(Lt.event?Lt.event(e):e)}}}function Ah(n,e,t,i,s,r,o,a,l,c){var u,d,h,f,p,_,m,g,x,M,y,C,A,v,w,U,L,I,O=e.type;if(e.constructor!==Ko)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,d=r=[],u.nodeType==8?a=ol(u,r):r.push(u),a=r[0]||a),(u=Lt.__b)&&u(e);e:if(typeof O=="function"){h=o.length;try{if(g=e.props,x=(u=O.prototype)&&u.render,M=(u=O.contextType)&&i[u.__c],y=u?M?M.props.value:u.__:i,(f=t.__c)?(e.__c=f,2&f.__g&&(f.__g|=1)):(x?e.__c=f=new O(g,y):(e.__c=f=new rl(g,y),f.constructor=O,f.render=Wv),M&&M.sub(f),f.state||(f.state={}),f.__n=i,f.__g|=8,f.__h=[],f.__k=[]),x&&(f.__s||(f.__s=f.state),O.getDerivedStateFromProps&&(f.__s==f.state&&(f.__s=ur({},f.__s)),ur(f.__s,O.getDerivedStateFromProps(g,f.__s)))),p=f.props,_=f.state,f.__v=e,t.__c){if(g!==p&&x&&!O.getDerivedStateFromProps&&f.componentWillReceiveProps&&f.componentWillReceiveProps(g,y),e.__v==t.__v&&!(8&f.__g)||!(4&f.__g)&&f.shouldComponentUpdate&&f.shouldComponentUpdate(g,f.__s,y)===!1){e.__v!=t.__v&&(f.props=g,f.state=f.__s,f.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(z){z&&(z.__=e)}),cl.push.apply(f.__h,f.__k),f.__k=[],f.__h.length&&o.push(f),a=Bs(t);break e}f.componentWillUpdate&&f.componentWillUpdate(g,f.__s,y),x&&f.componentDidUpdate&&f.__h.push(function(){f.componentDidUpdate(p,_,m)})}else x&&!O.getDerivedStateFromProps&&f.componentWillMount&&f.componentWillMount(),x&&f.componentDidMount&&f.__h.push(f.componentDidMount);f.context=y,f.props=g,f.__P=n,f.__g&=-5,C=Lt.__r,A=x?25:0;do f.__g&=-9,C&&C(e),u=f.render(f.props,f.state=f.__s,f.context);while(8&f.__g&&++A<25);x&&(cl.push.apply(f.__h,f.__k),f.__k=[]),f.state=f.__s,f.getChildContext&&(i=ur({},i,f.getChildContext())),x&&t.__c&&f.getSnapshotBeforeUpdate&&(m=f.getSnapshotBeforeUpdate(p,_)),v=u&&u.type===Dt&&u.key==null?u.props.children:u,g.__P&&(u=a,s=(n=g.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(z){z&&Rh(z,z)}),t.__k=null),a=t.__k?Bs(t,0):null),a=jp(n,Th(v)?v:[v],e,t,i,s,r,o,a,l,c),g.__P&&(e.__e=null,a=u),e.__u&=-161,d&&d.some(cr),f.__h.length&&o.push(f),1&f.__g&&(f.__g&=-4)}catch(z){if(o.length=h,e.__v=null,l||r)if(z&&z.then){if(e.__u|=128|l,r){for(~(L=r.indexOf(a||void 0))||(L=r.length);(I=r[L-1])&&I.nodeType==8;)L--;for(;L<r.length;L++)if(I=r[L])if(r[L]=null,w){if(I==U)break}else{if(I.nodeType!=8)break;I.data.startsWith("$s")&&(U=ol(w=I))}}if(!w){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;w=a}(u=ol(w=e.__c.__z||(e.__c.__z=w)))?(e.__e=w,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(cr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),z&&z.then||em(e),Lt.__e(z,e,t)}}else a=e.__e=Gv(t.__e,e,t,i,s,r,o,l,c,n);return(u=Lt.diffed)&&u(e),a}function ol(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function em(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(em))}function tm(n,e,t){for(var i=0;i<t.length;)Ch(t[i++],t[i++],t[i++]);Lt.__c&&Lt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Lt.__e(r,s.__v)}})}function Gv(n,e,t,i,s,r,o,a,l,c){var u,d,h,f,p,_,m,g,x=t.props||ll,M=e.props,y=e.type;if(y=="svg"?s="http://www.w3.org/2000/svg":y=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((p=r[u])&&(y?p.localName==y:p.nodeType==3)){n=p,r[u]=null;break}}if(!n){if(g=c.ownerDocument||document,!y)return g.createTextNode(M);n=g.createElementNS(s,y,M.is?M:c),a&&(Lt.__m&&Lt.__m(e,r),a=!1),r=null}if(y){if(c=y=="template"&&n.content||n,r=y=="textarea"&&M.defaultValue!=null?null:r&&Zp.call(c.childNodes),!a&&r)for(x={},u=0;u<n.attributes.length;u++)x[(p=n.attributes[u]).name]=p.value;for(u in x)p=x[u],u=="dangerouslySetInnerHTML"?h=p:u=="children"||u in M||u=="value"&&"defaultValue"in M||u=="checked"&&"defaultChecked"in M||nl(n,u,null,p,s);for(u in M)p=M[u],u=="children"?f=p:u=="dangerouslySetInnerHTML"?d=p:u=="value"?_=p:u=="checked"?m=p:a&&typeof p!="function"||x[u]===p||nl(n,u,p,x[u],s);d?(a||h&&(d.__html==h.__html||d.__html==n.innerHTML)||(n.innerHTML=d.__html),e.__k=[]):(h&&(n.textContent=""),(y=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Bv.test(y))&&(s="http://www.w3.org/1999/xhtml"),jp(c,Th(f)?f:[f],e,t,i,s,r,o,r?r[0]:t.__k&&Bs(t,0),a,l),r&&r.some(cr)),a&&y!="textarea"||(u="value",y=="progress"&&_==null?n.removeAttribute(u):_==null||_===n[u]&&(y!="progress"||_)||nl(n,u,_,x[u],s),u="checked",m!=null&&m!=n[u]&&nl(n,u,m,x[u],s))}else x===M||a&&n.data==M||(n.data=M);return n}function Ch(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Lt.__e(s,t)}}function Rh(n,e,t){var i,s,r,o;if(Lt.unmount&&Lt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||Ch(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Lt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&Rh(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=ol(i,r=[]))&&(i==n.__e&&r.some(cr),cr(s),cr(i)),t||cr(n.__e),n.__e=n.__c=n.__=null}function Wv(n,e,t){return this.constructor(n,t)}function Ph(n,e){var t,i,s,r;Lt.__&&Lt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=sl(Dt,{children:[n]}),s=[],r=[],Ah(e,e.__k,i||ll,ll,e.namespaceURI,i?null:e.firstChild?Zp.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),tm(s,e.__k,r),e.__k.props.children=null}Lt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw al=0,n}},qp=0,Uv=function(n){return n!=null&&n.constructor===Ko},rl.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=ur({},this.state)),typeof n=="function"&&(n=n(ur({},t),this.props)),n&&(ur(t,n),this.__v&&(e&&this.__k.push(e),Wp(this)))},rl.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),Wp(this))},rl.prototype.render=Dt,Os=[],al=0,$p=function(n,e){return n.__v.__b-e.__v.__b},il=Symbol(),Yp=/(PointerCapture)$|Capture$/i,Eh=0,wh={},Ov=0;var Am=0,of=1,Cm=2;var ba=1,Rm=2,go=3,Si=0,kn=1,Nn=2,xr=0,_o=1,af=2,lf=3,cf=4,Pm=5;var vr=100,Im=101,Lm=102,Dm=103,Nm=104,Fm=200,Um=201,Om=202,Bm=203,uf=204,hf=205,km=206,zm=207,Hm=208,Vm=209,Gm=210,Wm=211,Xm=212,qm=213,$m=214,Nl=0,Fl=1,Ul=2,ro=3,Ol=4,Bl=5,oo=6,kl=7,ff=0,Ym=1,Zm=2,ns=0,df=1,pf=2,mf=3,gf=4,_f=5,xf=6,vf=7;var yf=300,yr=301,xo=302,uc=303,hc=304,zl=1e3,es=1001,Hl=1002,_n=1003,Jm=1004;var Ma=1005;var Bn=1006,fc=1007;var Ss=1008;var hi=1009,bf=1010,Mf=1011,vo=1012,dc=1013,ki=1014,zi=1015,Hi=1016,pc=1017,mc=1018,br=1020,Sf=35902,wf=35899,Ef=1021,Tf=1022,fi=1023,vs=1026,ws=1027,Af=1028,gc=1029,js=1030,_c=1031;var xc=1033,Sa=33776,wa=33777,Ea=33778,Ta=33779,vc=35840,yc=35841,bc=35842,Mc=35843,Sc=36196,wc=37492,Ec=37496,Tc=37488,Ac=37489,Aa=37490,Cc=37491,Rc=37808,Pc=37809,Ic=37810,Lc=37811,Dc=37812,Nc=37813,Fc=37814,Uc=37815,Oc=37816,Bc=37817,kc=37818,zc=37819,Hc=37820,Vc=37821,Gc=36492,Wc=36494,Xc=36495,qc=36283,$c=36284,Ca=36285,Yc=36286;var sa=2300,Vl=2301,Ll=2302,Qh=2303,ef=2400,tf=2401,nf=2402;var Km=3200;var Cf=0,jm=1,Es="",Jn="srgb",ra="srgb-linear",oa="linear",Tt="srgb";var Dl=7680,Ra=7681;var Rf=34055,Pf=34056;var If=517;var Zc=519,Qm=512,eg=513,tg=514,Lf=515,ng=516,ig=517,Df=518,Nf=519,sg=35044,Qs=35048;var Ff="300 es",vi=2e3,aa=2001;function Xv(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function qv(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function la(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function rg(){let n=la("canvas");return n.style.display="block",n}var nm={},ao=null;function Uf(...n){let e="THREE."+n.shift();ao?ao("log",e,...n):console.log(e,...n)}function og(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ye(...n){n=og(n);let e="THREE."+n.shift();if(ao)ao("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function nt(...n){n=og(n);let e="THREE."+n.shift();if(ao)ao("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function ia(...n){let e=n.join(" ");e in nm||(nm[e]=!0,Ye(...n))}function ag(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var lg={[Nl]:Nl,[Ul]:oo,[Ol]:Ol,[ro]:Bl,[Fl]:Fl,[oo]:Ul,[kl]:kl,[Bl]:ro},ts=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Vn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Ih=Math.PI/180,Gl=180/Math.PI;function Pa(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Vn[n&255]+Vn[n>>8&255]+Vn[n>>16&255]+Vn[n>>24&255]+"-"+Vn[e&255]+Vn[e>>8&255]+"-"+Vn[e>>16&15|64]+Vn[e>>24&255]+"-"+Vn[t&63|128]+Vn[t>>8&255]+"-"+Vn[t>>16&255]+Vn[t>>24&255]+Vn[i&255]+Vn[i>>8&255]+Vn[i>>16&255]+Vn[i>>24&255]).toLowerCase()}function gt(n,e,t){return Math.max(e,Math.min(t,n))}function $v(n,e){return(n%e+e)%e}function Lh(n,e,t){return(1-t)*n+t*e}function cg(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Of(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Yv(n,e){if(e.constructor===Float32Array)return n;let t=Of(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Zv(n,e){if(e.constructor===Float32Array)return n;let t=Of(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var _t=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(gt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(gt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},yi=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],d=i[s+3],h=r[o+0],f=r[o+1],p=r[o+2],_=r[o+3];if(d!==_||l!==h||c!==f||u!==p){let m=l*h+c*f+u*p+d*_;m<0&&(h=-h,f=-f,p=-p,_=-_,m=-m);let g=1-a;if(m<.9995){let x=Math.acos(m),M=Math.sin(x);g=Math.sin(g*x)/M,a=Math.sin(a*x)/M,l=l*g+h*a,c=c*g+f*a,u=u*g+p*a,d=d*g+_*a}else{l=l*g+h*a,c=c*g+f*a,u=u*g+p*a,d=d*g+_*a;let x=1/Math.sqrt(l*l+c*c+u*u+d*d);l*=x,c*=x,u*=x,d*=x}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=d}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],d=r[o],h=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+u*d+l*f-c*h,e[t+1]=l*p+u*h+c*d-a*f,e[t+2]=c*p+u*f+a*h-l*d,e[t+3]=u*p-a*d-l*h-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),d=a(r/2),h=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*u*d+c*f*p,this._y=c*f*d-h*u*p,this._z=c*u*p+h*f*d,this._w=c*u*d-h*f*p;break;case"YXZ":this._x=h*u*d+c*f*p,this._y=c*f*d-h*u*p,this._z=c*u*p-h*f*d,this._w=c*u*d+h*f*p;break;case"ZXY":this._x=h*u*d-c*f*p,this._y=c*f*d+h*u*p,this._z=c*u*p+h*f*d,this._w=c*u*d-h*f*p;break;case"ZYX":this._x=h*u*d-c*f*p,this._y=c*f*d+h*u*p,this._z=c*u*p-h*f*d,this._w=c*u*d+h*f*p;break;case"YZX":this._x=h*u*d+c*f*p,this._y=c*f*d+h*u*p,this._z=c*u*p-h*f*d,this._w=c*u*d-h*f*p;break;case"XZY":this._x=h*u*d-c*f*p,this._y=c*f*d-h*u*p,this._z=c*u*p+h*f*d,this._w=c*u*d+h*f*p;break;default:Ye("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],d=t[10],h=i+a+d;if(h>0){let f=.5/Math.sqrt(h+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>d){let f=2*Math.sqrt(1+i-a-d);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-i-d);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+d-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(gt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(im.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(im.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),d=2*(r*i-o*t);return this.x=t+l*c+o*d-a*u,this.y=i+l*u+a*c-r*d,this.z=s+l*d+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this.z=gt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this.z=gt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(gt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Dh.copy(this).projectOnVector(e),this.sub(Dh)}reflect(e){return this.sub(Dh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(gt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Dh=new G,im=new yi,it=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],d=i[7],h=i[2],f=i[5],p=i[8],_=s[0],m=s[3],g=s[6],x=s[1],M=s[4],y=s[7],C=s[2],A=s[5],v=s[8];return r[0]=o*_+a*x+l*C,r[3]=o*m+a*M+l*A,r[6]=o*g+a*y+l*v,r[1]=c*_+u*x+d*C,r[4]=c*m+u*M+d*A,r[7]=c*g+u*y+d*v,r[2]=h*_+f*x+p*C,r[5]=h*m+f*M+p*A,r[8]=h*g+f*y+p*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],d=u*o-a*c,h=a*l-u*r,f=c*r-o*l,p=t*d+i*h+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/p;return e[0]=d*_,e[1]=(s*c-u*i)*_,e[2]=(a*i-s*o)*_,e[3]=h*_,e[4]=(u*t-s*l)*_,e[5]=(s*r-a*t)*_,e[6]=f*_,e[7]=(i*l-c*t)*_,e[8]=(o*t-i*r)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return ia("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Nh.makeScale(e,t)),this}rotate(e){return ia("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Nh.makeRotation(-e)),this}translate(e,t){return ia("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Nh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Nh=new it,sm=new it().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),rm=new it().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Jv(){let n={enabled:!0,workingColorSpace:ra,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Tt&&(s.r=xs(s.r),s.g=xs(s.g),s.b=xs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Tt&&(s.r=so(s.r),s.g=so(s.g),s.b=so(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Es?oa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ra]:{primaries:e,whitePoint:i,transfer:oa,toXYZ:sm,fromXYZ:rm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Jn},outputColorSpaceConfig:{drawingBufferColorSpace:Jn}},[Jn]:{primaries:e,whitePoint:i,transfer:Tt,toXYZ:sm,fromXYZ:rm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Jn}}}),n}var pt=Jv();function xs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function so(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Xr,Wl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Xr===void 0&&(Xr=la("canvas")),Xr.width=e.width,Xr.height=e.height;let s=Xr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Xr}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=la("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=xs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(xs(t[i]/255)*255):t[i]=xs(t[i]);return{data:t,width:e.width,height:e.height}}else return Ye("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Kv=0,lo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Kv++}),this.uuid=Pa(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Fh(s[o].image)):r.push(Fh(s[o]))}else r=Fh(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Fh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Wl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ye("Texture: Unable to serialize Texture."),{})}var jv=0,Uh=new G,ei=class n extends ts{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=es,s=es,r=Bn,o=Ss,a=fi,l=hi,c=n.DEFAULT_ANISOTROPY,u=Es){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:jv++}),this.uuid=Pa(),this.name="",this.source=new lo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new _t(0,0),this.repeat=new _t(1,1),this.center=new _t(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new it,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Uh).x}get height(){return this.source.getSize(Uh).y}get depth(){return this.source.getSize(Uh).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ye(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==yf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case zl:e.x=e.x-Math.floor(e.x);break;case es:e.x=e.x<0?0:1;break;case Hl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case zl:e.y=e.y-Math.floor(e.y);break;case es:e.y=e.y<0?0:1;break;case Hl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ei.DEFAULT_IMAGE=null;ei.DEFAULT_MAPPING=yf;ei.DEFAULT_ANISOTROPY=1;var $t=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],d=l[8],h=l[1],f=l[5],p=l[9],_=l[2],m=l[6],g=l[10];if(Math.abs(u-h)<.01&&Math.abs(d-_)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+h)<.1&&Math.abs(d+_)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,y=(f+1)/2,C=(g+1)/2,A=(u+h)/4,v=(d+_)/4,w=(p+m)/4;return M>y&&M>C?M<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(M),s=A/i,r=v/i):y>C?y<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),i=A/s,r=w/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=v/r,s=w/r),this.set(i,s,r,t),this}let x=Math.sqrt((m-p)*(m-p)+(d-_)*(d-_)+(h-u)*(h-u));return Math.abs(x)<.001&&(x=1),this.x=(m-p)/x,this.y=(d-_)/x,this.z=(h-u)/x,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this.z=gt(this.z,e.z,t.z),this.w=gt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this.z=gt(this.z,e,t),this.w=gt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(gt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Xl=class extends ts{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Bn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new $t(0,0,e,t),this.scissorTest=!1,this.viewport=new $t(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ei({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Bn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new lo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},li=class extends Xl{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},ca=class extends ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=_n,this.minFilter=_n,this.wrapR=es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var ql=class extends ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=_n,this.minFilter=_n,this.wrapR=es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var vt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,d,h,f,p,_,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,d,h,f,p,_,m)}set(e,t,i,s,r,o,a,l,c,u,d,h,f,p,_,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=d,g[14]=h,g[3]=f,g[7]=p,g[11]=_,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/qr.setFromMatrixColumn(e,0).length(),r=1/qr.setFromMatrixColumn(e,1).length(),o=1/qr.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let h=o*u,f=o*d,p=a*u,_=a*d;t[0]=l*u,t[4]=-l*d,t[8]=c,t[1]=f+p*c,t[5]=h-_*c,t[9]=-a*l,t[2]=_-h*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,f=l*d,p=c*u,_=c*d;t[0]=h+_*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*d,t[5]=o*u,t[9]=-a,t[2]=f*a-p,t[6]=_+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,f=l*d,p=c*u,_=c*d;t[0]=h-_*a,t[4]=-o*d,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*u,t[9]=_-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,f=o*d,p=a*u,_=a*d;t[0]=l*u,t[4]=p*c-f,t[8]=h*c+_,t[1]=l*d,t[5]=_*c+h,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,f=o*c,p=a*l,_=a*c;t[0]=l*u,t[4]=_-h*d,t[8]=p*d+f,t[1]=d,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*d+p,t[10]=h-_*d}else if(e.order==="XZY"){let h=o*l,f=o*c,p=a*l,_=a*c;t[0]=l*u,t[4]=-d,t[8]=c*u,t[1]=h*d+_,t[5]=o*u,t[9]=f*d-p,t[2]=p*d-f,t[6]=a*u,t[10]=_*d+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Qv,e,ey)}lookAt(e,t,i){let s=this.elements;return oi.subVectors(e,t),oi.lengthSq()===0&&(oi.z=1),oi.normalize(),ks.crossVectors(i,oi),ks.lengthSq()===0&&(Math.abs(i.z)===1?oi.x+=1e-4:oi.z+=1e-4,oi.normalize(),ks.crossVectors(i,oi)),ks.normalize(),ul.crossVectors(oi,ks),s[0]=ks.x,s[4]=ul.x,s[8]=oi.x,s[1]=ks.y,s[5]=ul.y,s[9]=oi.y,s[2]=ks.z,s[6]=ul.z,s[10]=oi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],d=i[5],h=i[9],f=i[13],p=i[2],_=i[6],m=i[10],g=i[14],x=i[3],M=i[7],y=i[11],C=i[15],A=s[0],v=s[4],w=s[8],U=s[12],L=s[1],I=s[5],O=s[9],z=s[13],N=s[2],W=s[6],$=s[10],V=s[14],le=s[3],J=s[7],Q=s[11],ie=s[15];return r[0]=o*A+a*L+l*N+c*le,r[4]=o*v+a*I+l*W+c*J,r[8]=o*w+a*O+l*$+c*Q,r[12]=o*U+a*z+l*V+c*ie,r[1]=u*A+d*L+h*N+f*le,r[5]=u*v+d*I+h*W+f*J,r[9]=u*w+d*O+h*$+f*Q,r[13]=u*U+d*z+h*V+f*ie,r[2]=p*A+_*L+m*N+g*le,r[6]=p*v+_*I+m*W+g*J,r[10]=p*w+_*O+m*$+g*Q,r[14]=p*U+_*z+m*V+g*ie,r[3]=x*A+M*L+y*N+C*le,r[7]=x*v+M*I+y*W+C*J,r[11]=x*w+M*O+y*$+C*Q,r[15]=x*U+M*z+y*V+C*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],d=e[6],h=e[10],f=e[14],p=e[3],_=e[7],m=e[11],g=e[15],x=l*f-c*h,M=a*f-c*d,y=a*h-l*d,C=o*f-c*u,A=o*h-l*u,v=o*d-a*u;return t*(_*x-m*M+g*y)-i*(p*x-m*C+g*A)+s*(p*M-_*C+g*v)-r*(p*y-_*A+m*v)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],d=e[9],h=e[10],f=e[11],p=e[12],_=e[13],m=e[14],g=e[15],x=t*a-i*o,M=t*l-s*o,y=t*c-r*o,C=i*l-s*a,A=i*c-r*a,v=s*c-r*l,w=u*_-d*p,U=u*m-h*p,L=u*g-f*p,I=d*m-h*_,O=d*g-f*_,z=h*g-f*m,N=x*z-M*O+y*I+C*L-A*U+v*w;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/N;return e[0]=(a*z-l*O+c*I)*W,e[1]=(s*O-i*z-r*I)*W,e[2]=(_*v-m*A+g*C)*W,e[3]=(h*A-d*v-f*C)*W,e[4]=(l*L-o*z-c*U)*W,e[5]=(t*z-s*L+r*U)*W,e[6]=(m*y-p*v-g*M)*W,e[7]=(u*v-h*y+f*M)*W,e[8]=(o*O-a*L+c*w)*W,e[9]=(i*L-t*O-r*w)*W,e[10]=(p*A-_*y+g*x)*W,e[11]=(d*y-u*A-f*x)*W,e[12]=(a*U-o*I-l*w)*W,e[13]=(t*I-i*U+s*w)*W,e[14]=(_*M-p*C-m*x)*W,e[15]=(u*C-d*M+h*x)*W,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,d=a+a,h=r*c,f=r*u,p=r*d,_=o*u,m=o*d,g=a*d,x=l*c,M=l*u,y=l*d,C=i.x,A=i.y,v=i.z;return s[0]=(1-(_+g))*C,s[1]=(f+y)*C,s[2]=(p-M)*C,s[3]=0,s[4]=(f-y)*A,s[5]=(1-(h+g))*A,s[6]=(m+x)*A,s[7]=0,s[8]=(p+M)*v,s[9]=(m-x)*v,s[10]=(1-(h+_))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=qr.set(s[0],s[1],s[2]).length(),a=qr.set(s[4],s[5],s[6]).length(),l=qr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Di.copy(this);let c=1/o,u=1/a,d=1/l;return Di.elements[0]*=c,Di.elements[1]*=c,Di.elements[2]*=c,Di.elements[4]*=u,Di.elements[5]*=u,Di.elements[6]*=u,Di.elements[8]*=d,Di.elements[9]*=d,Di.elements[10]*=d,t.setFromRotationMatrix(Di),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=vi,l=!1){let c=this.elements,u=2*r/(t-e),d=2*r/(i-s),h=(t+e)/(t-e),f=(i+s)/(i-s),p,_;if(l)p=r/(o-r),_=o*r/(o-r);else if(a===vi)p=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===aa)p=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=vi,l=!1){let c=this.elements,u=2/(t-e),d=2/(i-s),h=-(t+e)/(t-e),f=-(i+s)/(i-s),p,_;if(l)p=1/(o-r),_=o/(o-r);else if(a===vi)p=-2/(o-r),_=-(o+r)/(o-r);else if(a===aa)p=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},qr=new G,Di=new vt,Qv=new G(0,0,0),ey=new G(1,1,1),ks=new G,ul=new G,oi=new G,om=new vt,am=new yi,Xs=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],d=s[2],h=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(gt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-gt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(gt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-gt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(h,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(gt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-gt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Ye("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return om.makeRotationFromQuaternion(e),this.setFromRotationMatrix(om,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return am.setFromEuler(this),this.setFromQuaternion(am,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Xs.DEFAULT_ORDER="XYZ";var ua=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},ty=0,lm=new G,$r=new yi,ds=new vt,hl=new G,jo=new G,ny=new G,iy=new yi,cm=new G(1,0,0),um=new G(0,1,0),hm=new G(0,0,1),fm={type:"added"},sy={type:"removed"},Yr={type:"childadded",child:null},Oh={type:"childremoved",child:null},ci=class n extends ts{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:ty++}),this.uuid=Pa(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new G,t=new Xs,i=new yi,s=new G(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new vt},normalMatrix:{value:new it}}),this.matrix=new vt,this.matrixWorld=new vt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ua,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return $r.setFromAxisAngle(e,t),this.quaternion.multiply($r),this}rotateOnWorldAxis(e,t){return $r.setFromAxisAngle(e,t),this.quaternion.premultiply($r),this}rotateX(e){return this.rotateOnAxis(cm,e)}rotateY(e){return this.rotateOnAxis(um,e)}rotateZ(e){return this.rotateOnAxis(hm,e)}translateOnAxis(e,t){return lm.copy(e).applyQuaternion(this.quaternion),this.position.add(lm.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(cm,e)}translateY(e){return this.translateOnAxis(um,e)}translateZ(e){return this.translateOnAxis(hm,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ds.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?hl.copy(e):hl.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),jo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ds.lookAt(jo,hl,this.up):ds.lookAt(hl,jo,this.up),this.quaternion.setFromRotationMatrix(ds),s&&(ds.extractRotation(s.matrixWorld),$r.setFromRotationMatrix(ds),this.quaternion.premultiply($r.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(nt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(fm),Yr.child=e,this.dispatchEvent(Yr),Yr.child=null):nt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(sy),Oh.child=e,this.dispatchEvent(Oh),Oh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ds.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ds.multiply(e.parent.matrixWorld)),e.applyMatrix4(ds),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(fm),Yr.child=e,this.dispatchEvent(Yr),Yr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(jo,e,ny),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(jo,iy,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),d=o(e.shapes),h=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),d.length>0&&(i.shapes=d),h.length>0&&(i.skeletons=h),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};ci.DEFAULT_UP=new G(0,1,0);ci.DEFAULT_MATRIX_AUTO_UPDATE=!0;ci.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Qt=class extends ci{constructor(){super(),this.isGroup=!0,this.type="Group"}},ry={type:"move"},co=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Qt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Qt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Qt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let _ of e.hand.values()){let m=t.getJointPose(_,i),g=this._getHandJoint(c,_);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let u=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],h=u.position.distanceTo(d.position),f=.02,p=.005;c.inputState.pinching&&h>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(ry)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Qt;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},ug={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},zs={h:0,s:0,l:0},fl={h:0,s:0,l:0};function Bh(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var at=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Jn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,pt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=pt.workingColorSpace){return this.r=e,this.g=t,this.b=i,pt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=pt.workingColorSpace){if(e=$v(e,1),t=gt(t,0,1),i=gt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Bh(o,r,e+1/3),this.g=Bh(o,r,e),this.b=Bh(o,r,e-1/3)}return pt.colorSpaceToWorking(this,s),this}setStyle(e,t=Jn){function i(r){r!==void 0&&parseFloat(r)<1&&Ye("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ye("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ye("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Jn){let i=ug[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ye("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=xs(e.r),this.g=xs(e.g),this.b=xs(e.b),this}copyLinearToSRGB(e){return this.r=so(e.r),this.g=so(e.g),this.b=so(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Jn){return pt.workingToColorSpace(Gn.copy(this),e),Math.round(gt(Gn.r*255,0,255))*65536+Math.round(gt(Gn.g*255,0,255))*256+Math.round(gt(Gn.b*255,0,255))}getHexString(e=Jn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=pt.workingColorSpace){pt.workingToColorSpace(Gn.copy(this),t);let i=Gn.r,s=Gn.g,r=Gn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=u<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=pt.workingColorSpace){return pt.workingToColorSpace(Gn.copy(this),t),e.r=Gn.r,e.g=Gn.g,e.b=Gn.b,e}getStyle(e=Jn){pt.workingToColorSpace(Gn.copy(this),e);let t=Gn.r,i=Gn.g,s=Gn.b;return e!==Jn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(zs),this.setHSL(zs.h+e,zs.s+t,zs.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(zs),e.getHSL(fl);let i=Lh(zs.h,fl.h,t),s=Lh(zs.s,fl.s,t),r=Lh(zs.l,fl.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Gn=new at;at.NAMES=ug;var ha=class extends ci{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Xs,this.environmentIntensity=1,this.environmentRotation=new Xs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ni=new G,ps=new G,kh=new G,ms=new G,Zr=new G,Jr=new G,dm=new G,zh=new G,Hh=new G,Vh=new G,Gh=new $t,Wh=new $t,Xh=new $t,Ws=class n{constructor(e=new G,t=new G,i=new G){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Ni.subVectors(e,t),s.cross(Ni);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Ni.subVectors(s,t),ps.subVectors(i,t),kh.subVectors(e,t);let o=Ni.dot(Ni),a=Ni.dot(ps),l=Ni.dot(kh),c=ps.dot(ps),u=ps.dot(kh),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let h=1/d,f=(c*l-a*u)*h,p=(o*u-a*l)*h;return r.set(1-f-p,p,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,ms)===null?!1:ms.x>=0&&ms.y>=0&&ms.x+ms.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,ms)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ms.x),l.addScaledVector(o,ms.y),l.addScaledVector(a,ms.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Gh.setScalar(0),Wh.setScalar(0),Xh.setScalar(0),Gh.fromBufferAttribute(e,t),Wh.fromBufferAttribute(e,i),Xh.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Gh,r.x),o.addScaledVector(Wh,r.y),o.addScaledVector(Xh,r.z),o}static isFrontFacing(e,t,i,s){return Ni.subVectors(i,t),ps.subVectors(e,t),Ni.cross(ps).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ni.subVectors(this.c,this.b),ps.subVectors(this.a,this.b),Ni.cross(ps).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Zr.subVectors(s,i),Jr.subVectors(r,i),zh.subVectors(e,i);let l=Zr.dot(zh),c=Jr.dot(zh);if(l<=0&&c<=0)return t.copy(i);Hh.subVectors(e,s);let u=Zr.dot(Hh),d=Jr.dot(Hh);if(u>=0&&d<=u)return t.copy(s);let h=l*d-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Zr,o);Vh.subVectors(e,r);let f=Zr.dot(Vh),p=Jr.dot(Vh);if(p>=0&&f<=p)return t.copy(r);let _=f*c-l*p;if(_<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(Jr,a);let m=u*p-f*d;if(m<=0&&d-u>=0&&f-p>=0)return dm.subVectors(r,s),a=(d-u)/(d-u+(f-p)),t.copy(s).addScaledVector(dm,a);let g=1/(m+_+h);return o=_*g,a=h*g,t.copy(i).addScaledVector(Zr,o).addScaledVector(Jr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ti=class{constructor(e=new G(1/0,1/0,1/0),t=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Fi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Fi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Fi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Fi):Fi.fromBufferAttribute(r,o),Fi.applyMatrix4(e.matrixWorld),this.expandByPoint(Fi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),dl.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),dl.copy(i.boundingBox)),dl.applyMatrix4(e.matrixWorld),this.union(dl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Fi),Fi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Qo),pl.subVectors(this.max,Qo),Kr.subVectors(e.a,Qo),jr.subVectors(e.b,Qo),Qr.subVectors(e.c,Qo),Hs.subVectors(jr,Kr),Vs.subVectors(Qr,jr),hr.subVectors(Kr,Qr);let t=[0,-Hs.z,Hs.y,0,-Vs.z,Vs.y,0,-hr.z,hr.y,Hs.z,0,-Hs.x,Vs.z,0,-Vs.x,hr.z,0,-hr.x,-Hs.y,Hs.x,0,-Vs.y,Vs.x,0,-hr.y,hr.x,0];return!qh(t,Kr,jr,Qr,pl)||(t=[1,0,0,0,1,0,0,0,1],!qh(t,Kr,jr,Qr,pl))?!1:(ml.crossVectors(Hs,Vs),t=[ml.x,ml.y,ml.z],qh(t,Kr,jr,Qr,pl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Fi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Fi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(gs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),gs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),gs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),gs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),gs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),gs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),gs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),gs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(gs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},gs=[new G,new G,new G,new G,new G,new G,new G,new G],Fi=new G,dl=new ti,Kr=new G,jr=new G,Qr=new G,Hs=new G,Vs=new G,hr=new G,Qo=new G,pl=new G,ml=new G,fr=new G;function qh(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){fr.fromArray(n,r);let a=s.x*Math.abs(fr.x)+s.y*Math.abs(fr.y)+s.z*Math.abs(fr.z),l=e.dot(fr),c=t.dot(fr),u=i.dot(fr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var gn=new G,gl=new _t,oy=0,bt=class extends ts{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:oy++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=sg,this.updateRanges=[],this.gpuType=zi,this.version=0,this._normalizationScale=e!==void 0?Of(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)gl.fromBufferAttribute(this,t),gl.applyMatrix3(e),this.setXY(t,gl.x,gl.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix3(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix4(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.applyNormalMatrix(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.transformDirection(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Yv(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Zv(e,this.array)}};var fa=class extends bt{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var da=class extends bt{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Ht=class extends bt{constructor(e,t,i){super(new Float32Array(e),t,i)}},ay=new ti,ea=new G,$h=new G,jn=class{constructor(e=new G,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):ay.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ea.subVectors(e,this.center);let t=ea.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(ea,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):($h.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ea.copy(e.center).add($h)),this.expandByPoint(ea.copy(e.center).sub($h))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},ly=0,xi=new vt,Yh=new ci,eo=new G,ai=new ti,ta=new ti,Dn=new G,on=class n extends ts{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:ly++}),this.uuid=Pa(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Xv(e)?da:fa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new it().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return xi.makeRotationFromQuaternion(e),this.applyMatrix4(xi),this}rotateX(e){return xi.makeRotationX(e),this.applyMatrix4(xi),this}rotateY(e){return xi.makeRotationY(e),this.applyMatrix4(xi),this}rotateZ(e){return xi.makeRotationZ(e),this.applyMatrix4(xi),this}translate(e,t,i){return xi.makeTranslation(e,t,i),this.applyMatrix4(xi),this}scale(e,t,i){return xi.makeScale(e,t,i),this.applyMatrix4(xi),this}lookAt(e){return Yh.lookAt(e),Yh.updateMatrix(),this.applyMatrix4(Yh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(eo).negate(),this.translate(eo.x,eo.y,eo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ht(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ye("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ti);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];ai.setFromBufferAttribute(r),this.morphTargetsRelative?(Dn.addVectors(this.boundingBox.min,ai.min),this.boundingBox.expandByPoint(Dn),Dn.addVectors(this.boundingBox.max,ai.max),this.boundingBox.expandByPoint(Dn)):(this.boundingBox.expandByPoint(ai.min),this.boundingBox.expandByPoint(ai.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&nt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new jn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(e){let i=this.boundingSphere.center;if(ai.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ta.setFromBufferAttribute(a),this.morphTargetsRelative?(Dn.addVectors(ai.min,ta.min),ai.expandByPoint(Dn),Dn.addVectors(ai.max,ta.max),ai.expandByPoint(Dn)):(ai.expandByPoint(ta.min),ai.expandByPoint(ta.max))}ai.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Dn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Dn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Dn.fromBufferAttribute(a,c),l&&(eo.fromBufferAttribute(e,c),Dn.add(eo)),s=Math.max(s,i.distanceToSquared(Dn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&nt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){nt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new bt(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new G,l[U]=new G;let u=new G,d=new G,h=new G,f=new _t,p=new _t,_=new _t,m=new G,g=new G;function x(U,L,I){c[U]=c[L]=c[I]=1,u.fromBufferAttribute(i,U),d.fromBufferAttribute(i,L),h.fromBufferAttribute(i,I),f.fromBufferAttribute(r,U),p.fromBufferAttribute(r,L),_.fromBufferAttribute(r,I),d.sub(u),h.sub(u),p.sub(f),_.sub(f);let O=1/(p.x*_.y-_.x*p.y);isFinite(O)&&(m.copy(d).multiplyScalar(_.y).addScaledVector(h,-p.y).multiplyScalar(O),g.copy(h).multiplyScalar(p.x).addScaledVector(d,-_.x).multiplyScalar(O),a[U].add(m),a[L].add(m),a[I].add(m),l[U].add(g),l[L].add(g),l[I].add(g))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let U=0,L=M.length;U<L;++U){let I=M[U],O=I.start,z=I.count;for(let N=O,W=O+z;N<W;N+=3)x(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let y=new G,C=new G,A=new G,v=new G;function w(U){A.fromBufferAttribute(s,U),v.copy(A);let L=a[U];y.copy(L),y.sub(A.multiplyScalar(A.dot(L))).normalize(),C.crossVectors(v,L);let O=C.dot(l[U])<0?-1:1;o.setXYZW(U,y.x,y.y,y.z,O)}for(let U=0,L=i.count;U<L;++U)c[U]&&w(U);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new bt(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,f=i.count;h<f;h++)i.setXYZ(h,0,0,0);let s=new G,r=new G,o=new G,a=new G,l=new G,c=new G,u=new G,d=new G;if(e)for(let h=0,f=e.count;h<f;h+=3){let p=e.getX(h+0),_=e.getX(h+1),m=e.getX(h+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,_),o.fromBufferAttribute(t,m),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let h=0,f=t.count;h<f;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Dn.fromBufferAttribute(e,t),Dn.normalize(),e.setXYZ(t,Dn.x,Dn.y,Dn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,d=a.normalized,h=new c.constructor(l.length*u),f=0,p=0;for(let _=0,m=l.length;_<m;_++){a.isInterleavedBufferAttribute?f=l[_]*a.data.stride+a.offset:f=l[_]*u;for(let g=0;g<u;g++)h[p++]=c[f++]}return new bt(h,u,d)}if(this.index===null)return Ye("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,d=c.length;u<d;u++){let h=c[u],f=e(h,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let d=0,h=c.length;d<h;d++){let f=c[d];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],d=r[c];for(let h=0,f=d.length;h<f;h++)u.push(d[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Zh=new G,cy=new G,uy=new it,Ui=class{constructor(e=new G(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Zh.subVectors(i,t).cross(cy.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Zh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||uy.getNormalMatrix(e),s=this.coplanarPoint(Zh).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},hy=0,qs=class extends ts{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:hy++}),this.uuid=Pa(),this.name="",this.type="Material",this.blending=_o,this.side=Si,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=uf,this.blendDst=hf,this.blendEquation=vr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new at(0,0,0),this.blendAlpha=0,this.depthFunc=ro,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Zc,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Dl,this.stencilZFail=Dl,this.stencilZPass=Dl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ye(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new at().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Ui().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new _t().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new _t().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var _s=new G,Jh=new G,_l=new G,xl=new G,bi=class{constructor(e=new G,t=new G(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,_s)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=_s.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(_s.copy(this.origin).addScaledVector(this.direction,t),_s.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Jh.copy(e).add(t).multiplyScalar(.5),_l.copy(t).sub(e).normalize(),xl.copy(this.origin).sub(Jh);let r=e.distanceTo(t)*.5,o=-this.direction.dot(_l),a=xl.dot(this.direction),l=-xl.dot(_l),c=xl.lengthSq(),u=Math.abs(1-o*o),d,h,f,p;if(u>0)if(d=o*l-a,h=o*a-l,p=r*u,d>=0)if(h>=-p)if(h<=p){let _=1/u;d*=_,h*=_,f=d*(d+o*h+2*a)+h*(o*d+h+2*l)+c}else h=r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;else h=-r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;else h<=-p?(d=Math.max(0,-(-o*r+a)),h=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+h*(h+2*l)+c):h<=p?(d=0,h=Math.min(Math.max(-r,-l),r),f=h*(h+2*l)+c):(d=Math.max(0,-(o*r+a)),h=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+h*(h+2*l)+c);else h=o>0?-r:r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Jh).addScaledVector(_l,h),f}intersectSphere(e,t){if(e.radius<0)return null;_s.subVectors(e.center,this.origin);let i=_s.dot(this.direction),s=_s.dot(_s)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,d=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(e.min.z-h.z)*d,l=(e.max.z-h.z)*d):(a=(e.max.z-h.z)*d,l=(e.min.z-h.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,_s)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,d=e.x-o.x,h=e.y-o.y,f=e.z-o.z,p=t.x-o.x,_=t.y-o.y,m=t.z-o.z,g=i.x-o.x,x=i.y-o.y,M=i.z-o.z,y=Math.abs(l),C=Math.abs(c),A=Math.abs(u),v,w,U,L,I,O,z,N,W,$,V,le;if(y>=C&&y>=A?(U=l,O=d,W=p,le=g,l>=0?(v=c,w=u,L=h,I=f,z=_,N=m,$=x,V=M):(v=u,w=c,L=f,I=h,z=m,N=_,$=M,V=x)):C>=A?(U=c,O=h,W=_,le=x,c>=0?(v=u,w=l,L=f,I=d,z=m,N=p,$=M,V=g):(v=l,w=u,L=d,I=f,z=p,N=m,$=g,V=M)):(U=u,O=f,W=m,le=M,u>=0?(v=l,w=c,L=d,I=h,z=p,N=_,$=g,V=x):(v=c,w=l,L=h,I=d,z=_,N=p,$=x,V=g)),U===0)return null;let J=v/U,Q=w/U,ie=1/U,fe=L-J*O,he=I-Q*O,ee=z-J*W,me=N-Q*W,ge=$-J*le,Se=V-Q*le,xe=ge*me-Se*ee,He=fe*Se-he*ge,qe=ee*he-me*fe;if(s){if(xe<0||He<0||qe<0)return null}else if((xe<0||He<0||qe<0)&&(xe>0||He>0||qe>0))return null;let Fe=xe+He+qe;if(Fe===0)return null;let Je=ie*(xe*O+He*W+qe*le);return(Fe>0?Je<0:Je>0)?null:this.at(Je/Fe,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},$s=class extends qs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new at(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Xs,this.combine=ff,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},pm=new vt,dr=new bi,vl=new jn,mm=new G,yl=new G,bl=new G,Ml=new G,Kh=new G,Sl=new G,gm=new G,wl=new G,yt=class extends ci{constructor(e=new on,t=new $s){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Sl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],d=r[l];u!==0&&(Kh.fromBufferAttribute(d,e),o?Sl.addScaledVector(Kh,u):Sl.addScaledVector(Kh.sub(t),u))}t.add(Sl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),vl.copy(i.boundingSphere),vl.applyMatrix4(r),dr.copy(e.ray).recast(e.near),!(vl.containsPoint(dr.origin)===!1&&(dr.intersectSphere(vl,mm)===null||dr.origin.distanceToSquared(mm)>(e.far-e.near)**2))&&(pm.copy(r).invert(),dr.copy(e.ray).applyMatrix4(pm),!(i.boundingBox!==null&&dr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,dr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,d=r.attributes.normal,h=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,_=h.length;p<_;p++){let m=h[p],g=o[m.materialIndex],x=Math.max(m.start,f.start),M=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let y=x,C=M;y<C;y+=3){let A=a.getX(y),v=a.getX(y+1),w=a.getX(y+2);s=El(this,g,e,i,c,u,d,A,v,w),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let m=p,g=_;m<g;m+=3){let x=a.getX(m),M=a.getX(m+1),y=a.getX(m+2);s=El(this,o,e,i,c,u,d,x,M,y),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,_=h.length;p<_;p++){let m=h[p],g=o[m.materialIndex],x=Math.max(m.start,f.start),M=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let y=x,C=M;y<C;y+=3){let A=y,v=y+1,w=y+2;s=El(this,g,e,i,c,u,d,A,v,w),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(l.count,f.start+f.count);for(let m=p,g=_;m<g;m+=3){let x=m,M=m+1,y=m+2;s=El(this,o,e,i,c,u,d,x,M,y),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function fy(n,e,t,i,s,r,o,a){let l;if(e.side===kn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Si,a),l===null)return null;wl.copy(a),wl.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(wl);return c<t.near||c>t.far?null:{distance:c,point:wl.clone(),object:n}}function El(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,yl),n.getVertexPosition(l,bl),n.getVertexPosition(c,Ml);let u=fy(n,e,t,i,yl,bl,Ml,gm);if(u){let d=new G;Ws.getBarycoord(gm,yl,bl,Ml,d),s&&(u.uv=Ws.getInterpolatedAttribute(s,a,l,c,d,new _t)),r&&(u.uv1=Ws.getInterpolatedAttribute(r,a,l,c,d,new _t)),o&&(u.normal=Ws.getInterpolatedAttribute(o,a,l,c,d,new G),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new G,materialIndex:0};Ws.getNormal(yl,bl,Ml,h.normal),u.face=h,u.barycoord=d}return u}var uo=class extends ei{constructor(e=null,t=1,i=1,s,r,o,a,l,c=_n,u=_n,d,h){super(null,o,a,l,c,u,s,r,d,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ys=class extends bt{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var pr=new jn,dy=new _t(.5,.5),Tl=new G,bs=class{constructor(e=new Ui,t=new Ui,i=new Ui,s=new Ui,r=new Ui,o=new Ui){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=vi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],d=r[5],h=r[6],f=r[7],p=r[8],_=r[9],m=r[10],g=r[11],x=r[12],M=r[13],y=r[14],C=r[15];if(s[0].setComponents(c-o,f-u,g-p,C-x).normalize(),s[1].setComponents(c+o,f+u,g+p,C+x).normalize(),s[2].setComponents(c+a,f+d,g+_,C+M).normalize(),s[3].setComponents(c-a,f-d,g-_,C-M).normalize(),i)s[4].setComponents(l,h,m,y).normalize(),s[5].setComponents(c-l,f-h,g-m,C-y).normalize();else if(s[4].setComponents(c-l,f-h,g-m,C-y).normalize(),t===vi)s[5].setComponents(c+l,f+h,g+m,C+y).normalize();else if(t===aa)s[5].setComponents(l,h,m,y).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),pr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),pr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(pr)}intersectsSprite(e){pr.center.set(0,0,0);let t=dy.distanceTo(e.center);return pr.radius=.7071067811865476+t,pr.applyMatrix4(e.matrixWorld),this.intersectsSphere(pr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Tl.x=s.normal.x>0?e.max.x:e.min.x,Tl.y=s.normal.y>0?e.max.y:e.min.y,Tl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Tl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},_m=new vt,$l=class n{constructor(){this.coordinateSystem=vi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];_m.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new bs),i[s].setFromProjectionMatrix(_m,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new bs),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Ys=class extends qs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new at(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Yl=new G,Zl=new G,xm=new vt,na=new bi,Al=new jn,jh=new G,vm=new G,pa=class extends ci{constructor(e=new on,t=new Ys){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Yl.fromBufferAttribute(t,s-1),Zl.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Yl.distanceTo(Zl);e.setAttribute("lineDistance",new Ht(i,1))}else Ye("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Al.copy(i.boundingSphere),Al.applyMatrix4(s),Al.radius+=r,e.ray.intersectsSphere(Al)===!1)return;xm.copy(s).invert(),na.copy(e.ray).applyMatrix4(xm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let _=f,m=p-1;_<m;_+=c){let g=u.getX(_),x=u.getX(_+1),M=Cl(this,e,na,l,g,x,_);M&&t.push(M)}if(this.isLineLoop){let _=u.getX(p-1),m=u.getX(f),g=Cl(this,e,na,l,_,m,p-1);g&&t.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let _=f,m=p-1;_<m;_+=c){let g=Cl(this,e,na,l,_,_+1,_);g&&t.push(g)}if(this.isLineLoop){let _=Cl(this,e,na,l,p-1,f,p-1);_&&t.push(_)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Cl(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Yl.fromBufferAttribute(a,s),Zl.fromBufferAttribute(a,r),t.distanceSqToSegment(Yl,Zl,jh,vm)>i)return;jh.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(jh);if(!(c<e.near||c>e.far))return{distance:c,point:vm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var ym=new G,bm=new G,Oi=class extends pa{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)ym.fromBufferAttribute(t,s),bm.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+ym.distanceTo(bm);e.setAttribute("lineDistance",new Ht(i,1))}else Ye("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},mr=class extends pa{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}};var ma=class extends ei{constructor(e=[],t=yr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ms=class extends ei{constructor(e,t,i=ki,s,r,o,a=_n,l=_n,c,u=vs,d=1){if(u!==vs&&u!==ws)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:d};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new lo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},ga=class extends Ms{constructor(e,t=ki,i=yr,s,r,o=_n,a=_n,l,c=vs){let u={width:e,height:e,depth:1},d=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},_a=class extends ei{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},ho=class n extends on{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],d=[],h=0,f=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Ht(c,3)),this.setAttribute("normal",new Ht(u,3)),this.setAttribute("uv",new Ht(d,2));function p(_,m,g,x,M,y,C,A,v,w,U){let L=y/v,I=C/w,O=y/2,z=C/2,N=A/2,W=v+1,$=w+1,V=0,le=0,J=new G;for(let Q=0;Q<$;Q++){let ie=Q*I-z;for(let fe=0;fe<W;fe++){let he=fe*L-O;J[_]=he*x,J[m]=ie*M,J[g]=N,c.push(J.x,J.y,J.z),J[_]=0,J[m]=0,J[g]=A>0?1:-1,u.push(J.x,J.y,J.z),d.push(fe/v),d.push(1-Q/w),V+=1}}for(let Q=0;Q<w;Q++)for(let ie=0;ie<v;ie++){let fe=h+ie+W*Q,he=h+ie+W*(Q+1),ee=h+(ie+1)+W*(Q+1),me=h+(ie+1)+W*Q;l.push(fe,he,me),l.push(he,ee,me),le+=6}a.addGroup(f,le,U),f+=le,h+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var fo=class n extends on{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],d=[],h=[],f=[],p=0,_=[],m=i/2,g=0;x(),o===!1&&(e>0&&M(!0),t>0&&M(!1)),this.setIndex(u),this.setAttribute("position",new Ht(d,3)),this.setAttribute("normal",new Ht(h,3)),this.setAttribute("uv",new Ht(f,2));function x(){let y=new G,C=new G,A=0,v=(t-e)/i;for(let w=0;w<=r;w++){let U=[],L=w/r,I=L*(t-e)+e;for(let O=0;O<=s;O++){let z=O/s,N=z*l+a,W=Math.sin(N),$=Math.cos(N);C.x=I*W,C.y=-L*i+m,C.z=I*$,d.push(C.x,C.y,C.z),y.set(W,v,$).normalize(),h.push(y.x,y.y,y.z),f.push(z,1-L),U.push(p++)}_.push(U)}for(let w=0;w<s;w++)for(let U=0;U<r;U++){let L=_[U][w],I=_[U+1][w],O=_[U+1][w+1],z=_[U][w+1];(e>0||U!==0)&&(u.push(L,I,z),A+=3),(t>0||U!==r-1)&&(u.push(I,O,z),A+=3)}c.addGroup(g,A,0),g+=A}function M(y){let C=p,A=new _t,v=new G,w=0,U=y===!0?e:t,L=y===!0?1:-1;for(let O=1;O<=s;O++)d.push(0,m*L,0),h.push(0,L,0),f.push(.5,.5),p++;let I=p;for(let O=0;O<=s;O++){let N=O/s*l+a,W=Math.cos(N),$=Math.sin(N);v.x=U*$,v.y=m*L,v.z=U*W,d.push(v.x,v.y,v.z),h.push(0,L,0),A.x=W*.5+.5,A.y=$*.5*L+.5,f.push(A.x,A.y),p++}for(let O=0;O<s;O++){let z=C+O,N=I+O;y===!0?u.push(N,N+1,z):u.push(N+1,N,z),w+=3}c.addGroup(g,w,y===!0?1:2),g+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},gr=class n extends fo{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var _r=class n extends on{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,d=e/a,h=t/l,f=[],p=[],_=[],m=[];for(let g=0;g<u;g++){let x=g*h-o;for(let M=0;M<c;M++){let y=M*d-r;p.push(y,-x,0),_.push(0,0,1),m.push(M/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let x=0;x<a;x++){let M=x+c*g,y=x+c*(g+1),C=x+1+c*(g+1),A=x+1+c*g;f.push(M,y,A),f.push(y,C,A)}this.setIndex(f),this.setAttribute("position",new Ht(p,3)),this.setAttribute("normal",new Ht(_,3)),this.setAttribute("uv",new Ht(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var xa=class n extends on{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],d=new G,h=new G,f=[],p=[],_=[],m=[];for(let g=0;g<=i;g++){let x=[],M=g/i,y=o+M*a,C=e*Math.cos(y),A=Math.sqrt(e*e-C*C),v=0;g===0&&o===0?v=.5/t:g===i&&l===Math.PI&&(v=-.5/t);for(let w=0;w<=t;w++){let U=w/t,L=s+U*r;d.x=-A*Math.cos(L),d.y=C,d.z=A*Math.sin(L),p.push(d.x,d.y,d.z),h.copy(d).normalize(),_.push(h.x,h.y,h.z),m.push(U+v,1-M),x.push(c++)}u.push(x)}for(let g=0;g<i;g++)for(let x=0;x<t;x++){let M=u[g][x+1],y=u[g][x],C=u[g+1][x],A=u[g+1][x+1];(g!==0||o>0)&&f.push(M,y,A),(g!==i-1||l<Math.PI)&&f.push(y,C,A)}this.setIndex(f),this.setAttribute("position",new Ht(p,3)),this.setAttribute("normal",new Ht(_,3)),this.setAttribute("uv",new Ht(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Mr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(Mm(s))s.isRenderTargetTexture?(Ye("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(Mm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Wn(n){let e={};for(let t=0;t<n.length;t++){let i=Mr(n[t]);for(let s in i)e[s]=i[s]}return e}function Mm(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function py(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Bf(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:pt.workingColorSpace}var hg={clone:Mr,merge:Wn},my=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,gy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Mi=class extends qs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=my,this.fragmentShader=gy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Mr(e.uniforms),this.uniformsGroups=py(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new at().setHex(s.value);break;case"v2":this.uniforms[i].value=new _t().fromArray(s.value);break;case"v3":this.uniforms[i].value=new G().fromArray(s.value);break;case"v4":this.uniforms[i].value=new $t().fromArray(s.value);break;case"m3":this.uniforms[i].value=new it().fromArray(s.value);break;case"m4":this.uniforms[i].value=new vt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Jl=class extends Mi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Kl=class extends qs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Km,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},jl=class extends qs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function to(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Rl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Zs=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ql=class extends Zs{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:ef,endingEnd:ef}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case tf:r=e,a=2*t-i;break;case nf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case tf:o=e,l=2*i-t;break;case nf:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,d=this._offsetNext,h=this._weightPrev,f=this._weightNext,p=(i-t)/(s-t),_=p*p,m=_*p,g=-h*m+2*h*_-h*p,x=(1+h)*m+(-1.5-2*h)*_+(-.5+h)*p+1,M=(-1-f)*m+(1.5+f)*_+.5*p,y=f*m-f*_;for(let C=0;C!==a;++C)r[C]=g*o[u+C]+x*o[c+C]+M*o[l+C]+y*o[d+C];return r}},ec=class extends Zs{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),d=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*d+o[l+h]*u;return r}},tc=class extends Zs{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},nc=class extends Zs{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,d=this.outTangents;if(!u||!d){let p=(i-t)/(s-t),_=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*_+o[l+m]*p;return r}let h=a*2,f=e-1;for(let p=0;p!==a;++p){let _=o[c+p],m=o[l+p],g=f*h+p*2,x=d[g],M=d[g+1],y=e*h+p*2,C=u[y],A=u[y+1],v=xy(i,t,x,C,s);r[p]=fg(v,_,M,A,m)}return r}};function fg(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function _y(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function xy(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=fg(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=_y(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ui=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=to(t,this.TimeBufferType),this.values=to(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:to(e.times,Array),values:to(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Rl(e.settings)&&(i.settings={inTangents:to(e.settings.inTangents,Array),outTangents:to(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new tc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new ec(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Ql(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new nc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case sa:t=this.InterpolantFactoryMethodDiscrete;break;case Vl:t=this.InterpolantFactoryMethodLinear;break;case Ll:t=this.InterpolantFactoryMethodSmooth;break;case Qh:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ye("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return sa;case this.InterpolantFactoryMethodLinear:return Vl;case this.InterpolantFactoryMethodSmooth:return Ll;case this.InterpolantFactoryMethodBezier:return Qh}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Rl(this.settings)&&(Sm(this.settings.inTangents,e),Sm(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Rl(this.settings)&&(wm(this.settings.inTangents,e),wm(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(nt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(nt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){nt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){nt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&qv(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){nt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Ll,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let d=a*i,h=d-i,f=d+i;for(let p=0;p!==i;++p){let _=t[d+p];if(_!==t[h+p]||_!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let d=a*i,h=o*i;for(let f=0;f!==i;++f)t[h+f]=t[d+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Rl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Sm(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function wm(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}ui.prototype.ValueTypeName="";ui.prototype.TimeBufferType=Float32Array;ui.prototype.ValueBufferType=Float32Array;ui.prototype.DefaultInterpolation=Vl;var Js=class extends ui{constructor(e,t,i){super(e,t,i)}};Js.prototype.ValueTypeName="bool";Js.prototype.ValueBufferType=Array;Js.prototype.DefaultInterpolation=sa;Js.prototype.InterpolantFactoryMethodLinear=void 0;Js.prototype.InterpolantFactoryMethodSmooth=void 0;var ic=class extends ui{constructor(e,t,i,s){super(e,t,i,s)}};ic.prototype.ValueTypeName="color";var sc=class extends ui{constructor(e,t,i,s){super(e,t,i,s)}};sc.prototype.ValueTypeName="number";var rc=class extends Zs{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)yi.slerpFlat(r,0,o,c-a,o,c,l);return r}},va=class extends ui{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new rc(this.times,this.values,this.getValueSize(),e)}};va.prototype.ValueTypeName="quaternion";va.prototype.InterpolantFactoryMethodSmooth=void 0;var Ks=class extends ui{constructor(e,t,i){super(e,t,i)}};Ks.prototype.ValueTypeName="string";Ks.prototype.ValueBufferType=Array;Ks.prototype.DefaultInterpolation=sa;Ks.prototype.InterpolantFactoryMethodLinear=void 0;Ks.prototype.InterpolantFactoryMethodSmooth=void 0;var oc=class extends ui{constructor(e,t,i,s){super(e,t,i,s)}};oc.prototype.ValueTypeName="vector";var ac=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,d){return c.push(u,d),this},this.removeHandler=function(u){let d=c.indexOf(u);return d!==-1&&c.splice(d,2),this},this.getHandler=function(u){for(let d=0,h=c.length;d<h;d+=2){let f=c[d],p=c[d+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},dg=new ac,lc=class{constructor(e){this.manager=e!==void 0?e:dg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};lc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Pl=new G,Il=new yi,Qi=new G,ya=class extends ci{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new vt,this.projectionMatrix=new vt,this.projectionMatrixInverse=new vt,this.coordinateSystem=vi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Pl,Il,Qi),Qi.x===1&&Qi.y===1&&Qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Pl,Il,Qi.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Pl,Il,Qi),Qi.x===1&&Qi.y===1&&Qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Pl,Il,Qi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Gs=new G,Em=new _t,Tm=new _t,Kn=class extends ya{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Gl*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ih*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Gl*2*Math.atan(Math.tan(Ih*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Gs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Gs.x,Gs.y).multiplyScalar(-e/Gs.z),Gs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Gs.x,Gs.y).multiplyScalar(-e/Gs.z)}getViewSize(e,t){return this.getViewBounds(e,Em,Tm),t.subVectors(Tm,Em)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ih*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var po=class extends ya{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Bi=class extends on{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var no=-90,io=1,mo=class extends ci{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Kn(no,io,e,t);s.layers=this.layers,this.add(s);let r=new Kn(no,io,e,t);r.layers=this.layers,this.add(r);let o=new Kn(no,io,e,t);o.layers=this.layers,this.add(o);let a=new Kn(no,io,e,t);a.layers=this.layers,this.add(a);let l=new Kn(no,io,e,t);l.layers=this.layers,this.add(l);let c=new Kn(no,io,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===vi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===aa)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,d=e.getRenderTarget(),h=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=_,e.setRenderTarget(i,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(d,h,f),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},cc=class extends Kn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var kf="\\[\\]\\.:\\/",vy=new RegExp("["+kf+"]","g"),zf="[^"+kf+"]",yy="[^"+kf.replace("\\.","")+"]",by=/((?:WC+[\/:])*)/.source.replace("WC",zf),My=/(WCOD+)?/.source.replace("WCOD",yy),Sy=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",zf),wy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",zf),Ey=new RegExp("^"+by+My+Sy+wy+"$"),Ty=["material","materials","bones","map"],sf=class{constructor(e,t,i){let s=i||qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},qt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(vy,"")}static parseTrackName(e){let t=Ey.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Ty.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ye("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){nt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){nt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){nt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){nt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){nt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;nt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qt.Composite=sf;qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qt.prototype.GetterByBindingType=[qt.prototype._getValue_direct,qt.prototype._getValue_array,qt.prototype._getValue_arrayElement,qt.prototype._getValue_toArray];qt.prototype.SetterByBindingTypeAndVersioning=[[qt.prototype._setValue_direct,qt.prototype._setValue_direct_setNeedsUpdate,qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_array,qt.prototype._setValue_array_setNeedsUpdate,qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_arrayElement,qt.prototype._setValue_arrayElement_setNeedsUpdate,qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_fromArray,qt.prototype._setValue_fromArray_setNeedsUpdate,qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var SC=new Float32Array(1);var rf=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};function Hf(n,e,t,i){let s=Ay(i);switch(t){case Ef:return n*e;case Af:return n*e/s.components*s.byteLength;case gc:return n*e/s.components*s.byteLength;case js:return n*e*2/s.components*s.byteLength;case _c:return n*e*2/s.components*s.byteLength;case Tf:return n*e*3/s.components*s.byteLength;case fi:return n*e*4/s.components*s.byteLength;case xc:return n*e*4/s.components*s.byteLength;case Sa:case wa:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Ea:case Ta:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case yc:case Mc:return Math.max(n,16)*Math.max(e,8)/4;case vc:case bc:return Math.max(n,8)*Math.max(e,8)/2;case Sc:case wc:case Tc:case Ac:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Ec:case Aa:case Cc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Rc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Pc:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Ic:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Lc:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Dc:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Nc:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Fc:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Uc:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Oc:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Bc:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case kc:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case zc:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Hc:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Vc:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Gc:case Wc:case Xc:return Math.ceil(n/4)*Math.ceil(e/4)*16;case qc:case $c:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Ca:case Yc:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Ay(n){switch(n){case hi:case bf:return{byteLength:1,components:1};case vo:case Mf:case Hi:return{byteLength:2,components:1};case pc:case mc:return{byteLength:2,components:4};case ki:case dc:case zi:return{byteLength:4,components:1};case Sf:case wf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ye("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Fg(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function Ry(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,d=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let u=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,u);else{d.sort((f,p)=>f.start-p.start);let h=0;for(let f=1;f<d.length;f++){let p=d[h],_=d[f];_.start<=p.start+p.count+1?p.count=Math.max(p.count,_.start+_.count-p.start):(++h,d[h]=_)}d.length=h+1;for(let f=0,p=d.length;f<p;f++){let _=d[f];n.bufferSubData(c,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Py=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Iy=`#ifdef USE_ALPHAHASH
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
#endif`,Ly=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Dy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ny=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Fy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Uy=`#ifdef USE_AOMAP
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
#endif`,Oy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,By=`#ifdef USE_BATCHING
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
#endif`,ky=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,zy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Hy=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Vy=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Gy=`#ifdef USE_IRIDESCENCE
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
#endif`,Wy=`#ifdef USE_BUMPMAP
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
#endif`,Xy=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,qy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,$y=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Yy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Zy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Jy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Ky=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,jy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Qy=`#define PI 3.141592653589793
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
} // validated`,eb=`vec3 transformedNormal = objectNormal;
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
#endif`,tb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,nb=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,ib=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,sb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,rb="gl_FragColor = linearToOutputTexel( gl_FragColor );",ob=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,ab=`#ifdef USE_ENVMAP
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
#endif`,lb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,cb=`#ifdef USE_ENVMAP
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
#endif`,ub=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,hb=`#ifdef USE_ENVMAP
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
#endif`,fb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,db=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,pb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,mb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,gb=`#ifdef USE_GRADIENTMAP
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
}`,_b=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,xb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,vb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,yb=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,bb=`#ifdef USE_ENVMAP
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
#endif`,Mb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Sb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,wb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Eb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Tb=`PhysicalMaterial material;
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
#endif`,Ab=`uniform sampler2D dfgLUT;
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
}`,Cb=`
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
#endif`,Rb=`#if defined( RE_IndirectDiffuse )
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
#endif`,Pb=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Ib=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Lb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Db=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Nb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Fb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Ub=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Ob=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Bb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,kb=`#if defined( USE_POINTS_UV )
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
#endif`,zb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Hb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Vb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Gb=`#if defined( USE_MORPHCOLORS )
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
#endif`,Wb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Xb=`#ifdef USE_MORPHTARGETS
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
#endif`,qb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,$b=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Yb=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Zb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Jb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Kb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,jb=`#ifdef USE_NORMALMAP
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
#endif`,Qb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,eM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,tM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,nM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,iM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,sM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,rM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,oM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,aM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,lM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,cM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,uM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,hM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,fM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,dM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,pM=`float getShadowMask() {
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
}`,mM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,gM=`#ifdef USE_SKINNING
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
#endif`,_M=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,xM=`#ifdef USE_SKINNING
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
#endif`,vM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,yM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,bM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,MM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,SM=`#ifdef USE_TRANSMISSION
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
#endif`,wM=`#ifdef USE_TRANSMISSION
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
#endif`,EM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,TM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,AM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,CM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,RM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,PM=`uniform sampler2D t2D;
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
}`,IM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,LM=`uniform float backgroundBlurriness;
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
}`,DM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,NM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,FM=`#include <common>
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
}`,UM=`#if DEPTH_PACKING == 3200
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
}`,OM=`#define DISTANCE
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
}`,BM=`#define DISTANCE
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
}`,kM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,zM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,HM=`uniform float scale;
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
}`,VM=`uniform vec3 diffuse;
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
}`,GM=`#include <common>
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
}`,WM=`uniform vec3 diffuse;
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
}`,XM=`#define LAMBERT
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
}`,qM=`#define LAMBERT
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
}`,$M=`#define MATCAP
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
}`,YM=`#define MATCAP
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
}`,ZM=`#define NORMAL
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
}`,JM=`#define NORMAL
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
}`,KM=`#define PHONG
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
}`,jM=`#define PHONG
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
}`,QM=`#define STANDARD
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
}`,eS=`#define STANDARD
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
}`,tS=`#define TOON
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
}`,nS=`#define TOON
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
}`,iS=`uniform float size;
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
}`,sS=`uniform vec3 diffuse;
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
}`,rS=`#include <common>
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
}`,oS=`uniform vec3 color;
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
}`,aS=`uniform float rotation;
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
}`,lS=`uniform vec3 diffuse;
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
}`,ct={alphahash_fragment:Py,alphahash_pars_fragment:Iy,alphamap_fragment:Ly,alphamap_pars_fragment:Dy,alphatest_fragment:Ny,alphatest_pars_fragment:Fy,aomap_fragment:Uy,aomap_pars_fragment:Oy,batching_pars_vertex:By,batching_vertex:ky,begin_vertex:zy,beginnormal_vertex:Hy,bsdfs:Vy,iridescence_fragment:Gy,bumpmap_pars_fragment:Wy,clipping_planes_fragment:Xy,clipping_planes_pars_fragment:qy,clipping_planes_pars_vertex:$y,clipping_planes_vertex:Yy,color_fragment:Zy,color_pars_fragment:Jy,color_pars_vertex:Ky,color_vertex:jy,common:Qy,defaultnormal_vertex:eb,displacementmap_pars_vertex:tb,displacementmap_vertex:nb,emissivemap_fragment:ib,emissivemap_pars_fragment:sb,colorspace_fragment:rb,colorspace_pars_fragment:ob,envmap_fragment:ab,envmap_common_pars_fragment:lb,envmap_pars_fragment:cb,envmap_pars_vertex:ub,envmap_physical_pars_fragment:bb,envmap_vertex:hb,fog_vertex:fb,fog_pars_vertex:db,fog_fragment:pb,fog_pars_fragment:mb,gradientmap_pars_fragment:gb,lightmap_pars_fragment:_b,lights_lambert_fragment:xb,lights_lambert_pars_fragment:vb,lights_pars_begin:yb,lights_toon_fragment:Mb,lights_toon_pars_fragment:Sb,lights_phong_fragment:wb,lights_phong_pars_fragment:Eb,lights_physical_fragment:Tb,lights_physical_pars_fragment:Ab,lights_fragment_begin:Cb,lights_fragment_maps:Rb,lights_fragment_end:Pb,lightprobes_pars_fragment:Ib,logdepthbuf_fragment:Lb,logdepthbuf_pars_fragment:Db,logdepthbuf_pars_vertex:Nb,logdepthbuf_vertex:Fb,map_fragment:Ub,map_pars_fragment:Ob,map_particle_fragment:Bb,map_particle_pars_fragment:kb,metalnessmap_fragment:zb,metalnessmap_pars_fragment:Hb,morphinstance_vertex:Vb,morphcolor_vertex:Gb,morphnormal_vertex:Wb,morphtarget_pars_vertex:Xb,morphtarget_vertex:qb,normal_fragment_begin:$b,normal_fragment_maps:Yb,normal_pars_fragment:Zb,normal_pars_vertex:Jb,normal_vertex:Kb,normalmap_pars_fragment:jb,clearcoat_normal_fragment_begin:Qb,clearcoat_normal_fragment_maps:eM,clearcoat_pars_fragment:tM,iridescence_pars_fragment:nM,opaque_fragment:iM,packing:sM,premultiplied_alpha_fragment:rM,project_vertex:oM,dithering_fragment:aM,dithering_pars_fragment:lM,roughnessmap_fragment:cM,roughnessmap_pars_fragment:uM,shadowmap_pars_fragment:hM,shadowmap_pars_vertex:fM,shadowmap_vertex:dM,shadowmask_pars_fragment:pM,skinbase_vertex:mM,skinning_pars_vertex:gM,skinning_vertex:_M,skinnormal_vertex:xM,specularmap_fragment:vM,specularmap_pars_fragment:yM,tonemapping_fragment:bM,tonemapping_pars_fragment:MM,transmission_fragment:SM,transmission_pars_fragment:wM,uv_pars_fragment:EM,uv_pars_vertex:TM,uv_vertex:AM,worldpos_vertex:CM,background_vert:RM,background_frag:PM,backgroundCube_vert:IM,backgroundCube_frag:LM,cube_vert:DM,cube_frag:NM,depth_vert:FM,depth_frag:UM,distance_vert:OM,distance_frag:BM,equirect_vert:kM,equirect_frag:zM,linedashed_vert:HM,linedashed_frag:VM,meshbasic_vert:GM,meshbasic_frag:WM,meshlambert_vert:XM,meshlambert_frag:qM,meshmatcap_vert:$M,meshmatcap_frag:YM,meshnormal_vert:ZM,meshnormal_frag:JM,meshphong_vert:KM,meshphong_frag:jM,meshphysical_vert:QM,meshphysical_frag:eS,meshtoon_vert:tS,meshtoon_frag:nS,points_vert:iS,points_frag:sS,shadow_vert:rS,shadow_frag:oS,sprite_vert:aS,sprite_frag:lS},Le={common:{diffuse:{value:new at(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new it}},envmap:{envMap:{value:null},envMapRotation:{value:new it},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new it}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new it}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new it},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new it},normalScale:{value:new _t(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new it},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new it}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new it}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new it}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new at(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new at(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0},uvTransform:{value:new it}},sprite:{diffuse:{value:new at(16777215)},opacity:{value:1},center:{value:new _t(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}}},ss={basic:{uniforms:Wn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:ct.meshbasic_vert,fragmentShader:ct.meshbasic_frag},lambert:{uniforms:Wn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new at(0)},envMapIntensity:{value:1}}]),vertexShader:ct.meshlambert_vert,fragmentShader:ct.meshlambert_frag},phong:{uniforms:Wn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new at(0)},specular:{value:new at(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ct.meshphong_vert,fragmentShader:ct.meshphong_frag},standard:{uniforms:Wn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new at(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ct.meshphysical_vert,fragmentShader:ct.meshphysical_frag},toon:{uniforms:Wn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new at(0)}}]),vertexShader:ct.meshtoon_vert,fragmentShader:ct.meshtoon_frag},matcap:{uniforms:Wn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:ct.meshmatcap_vert,fragmentShader:ct.meshmatcap_frag},points:{uniforms:Wn([Le.points,Le.fog]),vertexShader:ct.points_vert,fragmentShader:ct.points_frag},dashed:{uniforms:Wn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ct.linedashed_vert,fragmentShader:ct.linedashed_frag},depth:{uniforms:Wn([Le.common,Le.displacementmap]),vertexShader:ct.depth_vert,fragmentShader:ct.depth_frag},normal:{uniforms:Wn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:ct.meshnormal_vert,fragmentShader:ct.meshnormal_frag},sprite:{uniforms:Wn([Le.sprite,Le.fog]),vertexShader:ct.sprite_vert,fragmentShader:ct.sprite_frag},background:{uniforms:{uvTransform:{value:new it},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ct.background_vert,fragmentShader:ct.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new it}},vertexShader:ct.backgroundCube_vert,fragmentShader:ct.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ct.cube_vert,fragmentShader:ct.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ct.equirect_vert,fragmentShader:ct.equirect_frag},distance:{uniforms:Wn([Le.common,Le.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ct.distance_vert,fragmentShader:ct.distance_frag},shadow:{uniforms:Wn([Le.lights,Le.fog,{color:{value:new at(0)},opacity:{value:1}}]),vertexShader:ct.shadow_vert,fragmentShader:ct.shadow_frag}};ss.physical={uniforms:Wn([ss.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new it},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new it},clearcoatNormalScale:{value:new _t(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new it},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new it},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new it},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new it},sheen:{value:0},sheenColor:{value:new at(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new it},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new it},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new it},transmissionSamplerSize:{value:new _t},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new it},attenuationDistance:{value:0},attenuationColor:{value:new at(0)},specularColor:{value:new at(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new it},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new it},anisotropyVector:{value:new _t},anisotropyMap:{value:null},anisotropyMapTransform:{value:new it}}]),vertexShader:ct.meshphysical_vert,fragmentShader:ct.meshphysical_frag};var Jc={r:0,b:0,g:0},cS=new vt,Ug=new it;Ug.set(-1,0,0,0,1,0,0,0,1);function uS(n,e,t,i,s,r){let o=new at(0),a=s===!0?0:1,l,c,u=null,d=0,h=null;function f(x){let M=x.isScene===!0?x.background:null;if(M&&M.isTexture){let y=x.backgroundBlurriness>0;M=e.get(M,y)}return M}function p(x){let M=!1,y=f(x);y===null?m(o,a):y&&y.isColor&&(m(y,1),M=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(x,M){let y=f(M);y&&y.isCubeTexture?(c===void 0&&(c=new yt(new ho(1,1,1),new Mi({name:"BackgroundCubeMaterial",uniforms:Mr(ss.backgroundCube.uniforms),vertexShader:ss.backgroundCube.vertexShader,fragmentShader:ss.backgroundCube.fragmentShader,side:kn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,A,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=y,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(cS.makeRotationFromEuler(M.backgroundRotation)).transpose(),y.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Ug),c.material.toneMapped=pt.getTransfer(y.colorSpace)!==Tt,(u!==y||d!==y.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=y,d=y.version,h=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):y&&y.isTexture&&(l===void 0&&(l=new yt(new _r(2,2),new Mi({name:"BackgroundMaterial",uniforms:Mr(ss.background.uniforms),vertexShader:ss.background.vertexShader,fragmentShader:ss.background.fragmentShader,side:Si,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=y,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=pt.getTransfer(y.colorSpace)!==Tt,y.matrixAutoUpdate===!0&&y.updateMatrix(),l.material.uniforms.uvTransform.value.copy(y.matrix),(u!==y||d!==y.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=y,d=y.version,h=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function m(x,M){x.getRGB(Jc,Bf(n)),t.buffers.color.setClear(Jc.r,Jc.g,Jc.b,M,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,M=1){o.set(x),a=M,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,m(o,a)},render:p,addToRenderList:_,dispose:g}}function hS(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(I,O,z,N,W){let $=!1,V=d(I,N,z,O);r!==V&&(r=V,c(r.object)),$=f(I,N,z,W),$&&p(I,N,z,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,y(I,O,z,N),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function d(I,O,z,N){let W=N.wireframe===!0,$=i[O.id];$===void 0&&($={},i[O.id]=$);let V=I.isInstancedMesh===!0?I.id:0,le=$[V];le===void 0&&(le={},$[V]=le);let J=le[z.id];J===void 0&&(J={},le[z.id]=J);let Q=J[W];return Q===void 0&&(Q=h(l()),J[W]=Q),Q}function h(I){let O=[],z=[],N=[];for(let W=0;W<t;W++)O[W]=0,z[W]=0,N[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:z,attributeDivisors:N,object:I,attributes:{},index:null}}function f(I,O,z,N){let W=r.attributes,$=O.attributes,V=0,le=z.getAttributes();for(let J in le)if(le[J].location>=0){let ie=W[J],fe=$[J];if(fe===void 0&&(J==="instanceMatrix"&&I.instanceMatrix&&(fe=I.instanceMatrix),J==="instanceColor"&&I.instanceColor&&(fe=I.instanceColor)),ie===void 0||ie.attribute!==fe||fe&&ie.data!==fe.data)return!0;V++}return r.attributesNum!==V||r.index!==N}function p(I,O,z,N){let W={},$=O.attributes,V=0,le=z.getAttributes();for(let J in le)if(le[J].location>=0){let ie=$[J];ie===void 0&&(J==="instanceMatrix"&&I.instanceMatrix&&(ie=I.instanceMatrix),J==="instanceColor"&&I.instanceColor&&(ie=I.instanceColor));let fe={};fe.attribute=ie,ie&&ie.data&&(fe.data=ie.data),W[J]=fe,V++}r.attributes=W,r.attributesNum=V,r.index=N}function _(){let I=r.newAttributes;for(let O=0,z=I.length;O<z;O++)I[O]=0}function m(I){g(I,0)}function g(I,O){let z=r.newAttributes,N=r.enabledAttributes,W=r.attributeDivisors;z[I]=1,N[I]===0&&(n.enableVertexAttribArray(I),N[I]=1),W[I]!==O&&(n.vertexAttribDivisor(I,O),W[I]=O)}function x(){let I=r.newAttributes,O=r.enabledAttributes;for(let z=0,N=O.length;z<N;z++)O[z]!==I[z]&&(n.disableVertexAttribArray(z),O[z]=0)}function M(I,O,z,N,W,$,V){V===!0?n.vertexAttribIPointer(I,O,z,W,$):n.vertexAttribPointer(I,O,z,N,W,$)}function y(I,O,z,N){_();let W=N.attributes,$=z.getAttributes(),V=O.defaultAttributeValues;for(let le in $){let J=$[le];if(J.location>=0){let Q=W[le];if(Q===void 0&&(le==="instanceMatrix"&&I.instanceMatrix&&(Q=I.instanceMatrix),le==="instanceColor"&&I.instanceColor&&(Q=I.instanceColor)),Q!==void 0){let ie=Q.normalized,fe=Q.itemSize,he=e.get(Q);if(he===void 0)continue;let ee=he.buffer,me=he.type,ge=he.bytesPerElement,Se=me===n.INT||me===n.UNSIGNED_INT||Q.gpuType===dc;if(Q.isInterleavedBufferAttribute){let xe=Q.data,He=xe.isInterleavedBuffer===!0?xe.stride:xe.itemSize,qe=Q.offset;if(xe.isInstancedInterleavedBuffer||xe.isInstancedBufferAttribute){for(let Fe=0;Fe<J.locationSize;Fe++)g(J.location+Fe,xe.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=xe.meshPerAttribute*xe.count)}else for(let Fe=0;Fe<J.locationSize;Fe++)m(J.location+Fe);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Fe=0;Fe<J.locationSize;Fe++)M(J.location+Fe,fe/J.locationSize,me,ie,He*ge,(qe+fe/J.locationSize*Fe)*ge,Se)}else{if(Q.isInstancedBufferAttribute){for(let xe=0;xe<J.locationSize;xe++)g(J.location+xe,Q.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let xe=0;xe<J.locationSize;xe++)m(J.location+xe);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let xe=0;xe<J.locationSize;xe++)M(J.location+xe,fe/J.locationSize,me,ie,fe*ge,fe/J.locationSize*xe*ge,Se)}}else if(V!==void 0){let ie=V[le];if(ie!==void 0)switch(ie.length){case 2:n.vertexAttrib2fv(J.location,ie);break;case 3:n.vertexAttrib3fv(J.location,ie);break;case 4:n.vertexAttrib4fv(J.location,ie);break;default:n.vertexAttrib1fv(J.location,ie)}}}}x()}function C(){U();for(let I in i){let O=i[I];for(let z in O){let N=O[z];for(let W in N){let $=N[W];for(let V in $)u($[V].object),delete $[V];delete N[W]}}delete i[I]}}function A(I){if(i[I.id]===void 0)return;let O=i[I.id];for(let z in O){let N=O[z];for(let W in N){let $=N[W];for(let V in $)u($[V].object),delete $[V];delete N[W]}}delete i[I.id]}function v(I){for(let O in i){let z=i[O];for(let N in z){let W=z[N];if(W[I.id]===void 0)continue;let $=W[I.id];for(let V in $)u($[V].object),delete $[V];delete W[I.id]}}}function w(I){for(let O in i){let z=i[O],N=I.isInstancedMesh===!0?I.id:0,W=z[N];if(W!==void 0){for(let $ in W){let V=W[$];for(let le in V)u(V[le].object),delete V[le];delete W[$]}delete z[N],Object.keys(z).length===0&&delete i[O]}}}function U(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:L,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfObject:w,releaseStatesOfProgram:v,initAttributes:_,enableAttribute:m,disableUnusedAttributes:x}}function fS(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let f=0;f<u;f++)h+=c[f];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function dS(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==fi&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let w=v===Hi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==hi&&v!==zi&&!w&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ye("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&Ye("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&Ye("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),M=n.getParameter(n.MAX_VARYING_VECTORS),y=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:p,maxTextureSize:_,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:x,maxVaryings:M,maxFragmentUniforms:y,maxSamples:C,samples:A}}function pS(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Ui,a=new it,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,h){let f=d.length!==0||h||i!==0||s;return s=h,i=d.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,h){t=u(d,h,0)},this.setState=function(d,h,f){let p=d.clippingPlanes,_=d.clipIntersection,m=d.clipShadows,g=n.get(d);if(!s||p===null||p.length===0||r&&!m)r?u(null):c();else{let x=r?0:i,M=x*4,y=g.clippingState||null;l.value=y,y=u(p,h,M,f);for(let C=0;C!==M;++C)y[C]=t[C];g.clippingState=y,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(d,h,f,p){let _=d!==null?d.length:0,m=null;if(_!==0){if(m=l.value,p!==!0||m===null){let g=f+_*4,x=h.matrixWorldInverse;a.getNormalMatrix(x),(m===null||m.length<g)&&(m=new Float32Array(g));for(let M=0,y=f;M!==_;++M,y+=4)o.copy(d[M]).applyMatrix4(x,a),o.normal.toArray(m,y),m[y+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,m}}var Da=class extends li{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new ma(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ho(5,5,5),r=new Mi({name:"CubemapFromEquirect",uniforms:Mr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:kn,blending:xr});r.uniforms.tEquirect.value=t;let o=new yt(s,r),a=t.minFilter;return t.minFilter===Ss&&(t.minFilter=Bn),new mo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},pg=256,mS=3,gS=20,Og=256,Bg=16,_S=3,xS=new G,vS=new at,jc=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new mo(1,10,null),this._boxMesh=new yt(new ho(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=xS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,h=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,_=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(e.background=l.getClearColor(vS));let m=new mo(i,s,u);return m.position.copy(a),m.update(l,e),l.autoClear=d,l.autoClearColor=h,l.autoClearDepth=f,l.autoClearStencil=p,e.background=_,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=_g(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=gg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(pg,cg(e))}_fromTexture(e,t){e.mapping===yr||e.mapping===xo?this._setSize(e.image.length===0?pg:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=mg(e,!1,!1),i=Math.log2(e)-mS;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=mg(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===yr||e.mapping===xo?(this._cubemapMaterial===null&&(this._cubemapMaterial=_g()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=gg()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=yS(),this._integrationMaterial=bS());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Bg);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-_S)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Og*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=MS());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function mg(n,e,t){return new Da(n,{minFilter:Ss,generateMipmaps:e,type:Hi,colorSpace:ra,depthBuffer:t})}function Na(n,e,t){return new Mi({name:n,uniforms:e,vertexShader:ct.cube_vert,fragmentShader:t,side:kn,blending:xr,depthTest:!1,depthWrite:!1})}function yS(){return Na("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Og}u

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
	`)}function bS(){return Na("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Bg}},`

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
	`)}function MS(){return Na("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${gS}
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
	`)}function gg(){return Na("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function _g(){return Na("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function SS(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,f=!1){return h==null?null:f?o(h):r(h)}function r(h){if(h&&h.isTexture){let f=h.mapping;if(f===uc||f===hc)if(e.has(h)){let p=e.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let _=new Da(p.height);return _.fromEquirectangularTexture(n,h),e.set(h,_),h.addEventListener("dispose",c),a(_.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let f=h.mapping,p=f===uc||f===hc,_=f===yr||f===xo;if(p||_){let m=t.get(h),g=m!==void 0?m.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==g)return i===null&&(i=new jc(n)),m=p?i.fromEquirectangular(h,m):i.fromCubemap(h,m),m.texture.pmremVersion=h.pmremVersion,t.set(h,m),m.texture;if(m!==void 0)return m.texture;{let x=h.image;return p&&x&&x.height>0||_&&x&&l(x)?(i===null&&(i=new jc(n)),m=p?i.fromEquirectangular(h):i.fromCubemap(h),m.texture.pmremVersion=h.pmremVersion,t.set(h,m),h.addEventListener("dispose",u),m.texture):null}}}return h}function a(h,f){return f===uc?h.mapping=yr:f===hc&&(h.mapping=xo),h}function l(h){let f=0,p=6;for(let _=0;_<p;_++)h[_]!==void 0&&f++;return f===p}function c(h){let f=h.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(h){let f=h.target;f.removeEventListener("dispose",u);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function d(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function wS(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&ia("WebGLRenderer: "+i+" extension not supported."),s}}}function ES(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let _=r.get(p);_&&(e.remove(_),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),t.memory.geometries++),_}function u(p){let _=p.attributes;for(let m in _)e.update(_[m],n.ARRAY_BUFFER)}function d(p){let _=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let x=_!==null?_.array.length:m.array.length/3-1,M=m.count>=65535?da:fa,y=new M(Math.ceil(x/3)*6,1),C=y.array;if(_!==null){let v=_.array;g=_.version;for(let w=0,U=0;w<x;w+=3){let L=v[w+0],I=v[w+1],O=v[w+2];C[U++]=L,C[U++]=I,C[U++]=I,C[U++]=O,C[U++]=O,C[U++]=L}}else{g=m.version;for(let v=0,w=0;v<x;v+=3){let U=v+0,L=v+1,I=v+2;C[w++]=U,C[w++]=L,C[w++]=L,C[w++]=I,C[w++]=I,C[w++]=U}}y.version=g;let A=r.get(p);A&&e.remove(A),r.set(p,y)}function h(p){let _=r.get(p);if(_){let m=p.index;m!==null&&_.version<m.version&&d(p)}else d(p);return r.get(p)}function f(){for(let p in s){let _=s[p].deref();_!==void 0&&l(_)}}return{get:c,update:u,getWireframeAttribute:h,dispose:f}}function TS(n,e,t){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,h){n.drawElements(i,h,r,d*o),t.update(h,i,1)}function c(d,h,f){f!==0&&(n.drawElementsInstanced(i,h,r,d*o,f),t.update(h,i,f))}function u(d,h,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,d,0,f);let _=0;for(let m=0;m<f;m++)_+=h[m];t.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function AS(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:nt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function CS(n,e,t){let i=new WeakMap,s=new $t;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==d){let U=function(){v.dispose(),i.delete(a),a.removeEventListener("dispose",U)};h!==void 0&&h.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],M=0;f===!0&&(M=1),p===!0&&(M=2),_===!0&&(M=3);let y=a.attributes.position.count*M,C=1;y>e.maxTextureSize&&(C=Math.ceil(y/e.maxTextureSize),y=e.maxTextureSize);let A=new Float32Array(y*C*4*d),v=new ca(A,y,C,d);v.type=zi,v.needsUpdate=!0;let w=M*4;for(let L=0;L<d;L++){let I=m[L],O=g[L],z=x[L],N=y*C*4*L;for(let W=0;W<I.count;W++){let $=W*w;f===!0&&(s.fromBufferAttribute(I,W),A[N+$+0]=s.x,A[N+$+1]=s.y,A[N+$+2]=s.z,A[N+$+3]=0),p===!0&&(s.fromBufferAttribute(O,W),A[N+$+4]=s.x,A[N+$+5]=s.y,A[N+$+6]=s.z,A[N+$+7]=0),_===!0&&(s.fromBufferAttribute(z,W),A[N+$+8]=s.x,A[N+$+9]=s.y,A[N+$+10]=s.z,A[N+$+11]=z.itemSize===4?s.w:1)}}h={count:d,texture:v,size:new _t(y,C)},i.set(a,h),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let _=0;_<c.length;_++)f+=c[_];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function RS(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,d=c.geometry,h=e.get(c,d);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var PS={[df]:"LINEAR_TONE_MAPPING",[pf]:"REINHARD_TONE_MAPPING",[mf]:"CINEON_TONE_MAPPING",[gf]:"ACES_FILMIC_TONE_MAPPING",[xf]:"AGX_TONE_MAPPING",[vf]:"NEUTRAL_TONE_MAPPING",[_f]:"CUSTOM_TONE_MAPPING"};function IS(n,e,t,i,s,r){let o=new li(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new on;u.setAttribute("position",new Ht([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Ht([0,2,0,0,2,0],2));let d=new Jl({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new yt(u,d),f=new po(-1,1,1,-1,0,1),p=null,_=null,m=!1,g,x=null,M=[],y=!1;this.setSize=function(C,A){o.setSize(C,A),a!==null&&a.setSize(C,A),l!==null&&l.setSize(C,A);for(let v=0;v<M.length;v++){let w=M[v];w.setSize&&w.setSize(C,A)}},this.setEffects=function(C){M=C,y=M.length>0&&M[0].isRenderPass===!0;let A=o.width,v=o.height;M.length>0&&a===null&&(a=new li(A,v,{type:Hi,depthBuffer:!1,stencilBuffer:!1}),l=new li(A,v,{type:Hi,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&M.some(U=>U.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Ms(A,v),r===!0&&(c.format=ws,c.type=br)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let U=0;U<M.length;U++){let L=M[U];L.setSize&&L.setSize(A,v),w&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(C,A){if(m||C.toneMapping===ns&&M.length===0)return!1;if(x=A,A!==null){let v=A.width,w=A.height;(o.width!==v||o.height!==w)&&this.setSize(v,w)}return y===!1&&C.setRenderTarget(o),g=C.toneMapping,C.toneMapping=ns,!0},this.hasRenderPass=function(){return y},this.end=function(C,A){C.toneMapping=g,m=!0;let v=o,w=a;for(let U=0;U<M.length;U++){let L=M[U];L.enabled!==!1&&(L.render(C,w,v,A),L.needsSwap!==!1&&(v=w,w=w===a?l:a))}if(p!==C.outputColorSpace||_!==C.toneMapping){p=C.outputColorSpace,_=C.toneMapping,d.defines={},pt.getTransfer(p)===Tt&&(d.defines.SRGB_TRANSFER="");let U=PS[_];U&&(d.defines[U]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=v.texture,C.setRenderTarget(x),C.render(h,f),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),d.dispose()}}var kg=new ei,zg=new Ms(1,1),Hg=new ga(1),Vg=new ca,Gg=new ql,Wg=new ma,xg=[],vg=[],yg=new Float32Array(16),bg=new Float32Array(9),Mg=new Float32Array(4);function bo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=xg[s];if(r===void 0&&(r=new Float32Array(s),xg[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function wn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function En(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function eu(n,e){let t=vg[e];t===void 0&&(t=new Int32Array(e),vg[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function LS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function DS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wn(t,e))return;n.uniform2fv(this.addr,e),En(t,e)}}function NS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(wn(t,e))return;n.uniform3fv(this.addr,e),En(t,e)}}function FS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wn(t,e))return;n.uniform4fv(this.addr,e),En(t,e)}}function US(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),En(t,e)}else{if(wn(t,i))return;Mg.set(i),n.uniformMatrix2fv(this.addr,!1,Mg),En(t,i)}}function OS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),En(t,e)}else{if(wn(t,i))return;bg.set(i),n.uniformMatrix3fv(this.addr,!1,bg),En(t,i)}}function BS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),En(t,e)}else{if(wn(t,i))return;yg.set(i),n.uniformMatrix4fv(this.addr,!1,yg),En(t,i)}}function kS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function zS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wn(t,e))return;n.uniform2iv(this.addr,e),En(t,e)}}function HS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(wn(t,e))return;n.uniform3iv(this.addr,e),En(t,e)}}function VS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wn(t,e))return;n.uniform4iv(this.addr,e),En(t,e)}}function GS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function WS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wn(t,e))return;n.uniform2uiv(this.addr,e),En(t,e)}}function XS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(wn(t,e))return;n.uniform3uiv(this.addr,e),En(t,e)}}function qS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wn(t,e))return;n.uniform4uiv(this.addr,e),En(t,e)}}function tu(n){return n.version===0&&(n.compareFunction=Nf,n.needsUpdate=!0),n}function $S(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=tu(zg):r=kg,t.setTexture2D(e||r,s)}function YS(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||Gg,s)}function ZS(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=tu(Hg):r=Wg,t.setTextureCube(e||r,s)}function JS(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||Vg,s)}function KS(n){switch(n){case 5126:return LS;case 35664:return DS;case 35665:return NS;case 35666:return FS;case 35674:return US;case 35675:return OS;case 35676:return BS;case 5124:case 35670:return kS;case 35667:case 35671:return zS;case 35668:case 35672:return HS;case 35669:case 35673:return VS;case 5125:return GS;case 36294:return WS;case 36295:return XS;case 36296:return qS;case 35678:case 36198:case 36298:case 36306:case 35682:return $S;case 35679:case 36299:case 36307:return YS;case 35680:case 36300:case 36308:case 36293:return ZS;case 36289:case 36303:case 36311:case 36292:return JS}}function jS(n,e){n.uniform1fv(this.addr,e)}function QS(n,e){let t=bo(e,this.size,2);n.uniform2fv(this.addr,t)}function ew(n,e){let t=bo(e,this.size,3);n.uniform3fv(this.addr,t)}function tw(n,e){let t=bo(e,this.size,4);n.uniform4fv(this.addr,t)}function nw(n,e){let t=bo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function iw(n,e){let t=bo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function sw(n,e){let t=bo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function rw(n,e){n.uniform1iv(this.addr,e)}function ow(n,e){n.uniform2iv(this.addr,e)}function aw(n,e){n.uniform3iv(this.addr,e)}function lw(n,e){n.uniform4iv(this.addr,e)}function cw(n,e){n.uniform1uiv(this.addr,e)}function uw(n,e){n.uniform2uiv(this.addr,e)}function hw(n,e){n.uniform3uiv(this.addr,e)}function fw(n,e){n.uniform4uiv(this.addr,e)}function dw(n,e,t){let i=this.cache,s=e.length,r=eu(t,s);wn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=tu(zg):o=kg;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function pw(n,e,t){let i=this.cache,s=e.length,r=eu(t,s);wn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Gg,r[o])}function mw(n,e,t){let i=this.cache,s=e.length,r=eu(t,s);wn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=tu(Hg):o=Wg;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function gw(n,e,t){let i=this.cache,s=e.length,r=eu(t,s);wn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Vg,r[o])}function _w(n){switch(n){case 5126:return jS;case 35664:return QS;case 35665:return ew;case 35666:return tw;case 35674:return nw;case 35675:return iw;case 35676:return sw;case 5124:case 35670:return rw;case 35667:case 35671:return ow;case 35668:case 35672:return aw;case 35669:case 35673:return lw;case 5125:return cw;case 36294:return uw;case 36295:return hw;case 36296:return fw;case 35678:case 36198:case 36298:case 36306:case 35682:return dw;case 35679:case 36299:case 36307:return pw;case 35680:case 36300:case 36308:case 36293:return mw;case 36289:case 36303:case 36311:case 36292:return gw}}var Wf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=KS(t.type)}},Xf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=_w(t.type)}},qf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Vf=/(\w+)(\])?(\[|\.)?/g;function Sg(n,e){n.seq.push(e),n.map[e.id]=e}function xw(n,e,t){let i=n.name,s=i.length;for(Vf.lastIndex=0;;){let r=Vf.exec(i),o=Vf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Sg(t,c===void 0?new Wf(a,n,e):new Xf(a,n,e));break}else{let d=t.map[a];d===void 0&&(d=new qf(a),Sg(t,d)),t=d}}}var yo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);xw(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function wg(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var vw=37297,yw=0;function bw(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Eg=new it;function Mw(n){pt._getMatrix(Eg,pt.workingColorSpace,n);let e=`mat3( ${Eg.elements.map(t=>t.toFixed(4))} )`;switch(pt.getTransfer(n)){case oa:return[e,"LinearTransferOETF"];case Tt:return[e,"sRGBTransferOETF"];default:return Ye("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Tg(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+bw(n.getShaderSource(e),a)}else return r}function Sw(n,e){let t=Mw(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var ww={[df]:"Linear",[pf]:"Reinhard",[mf]:"Cineon",[gf]:"ACESFilmic",[xf]:"AgX",[vf]:"Neutral",[_f]:"Custom"};function Ew(n,e){let t=ww[e];return t===void 0?(Ye("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Kc=new G;function Tw(){pt.getLuminanceCoefficients(Kc);let n=Kc.x.toFixed(4),e=Kc.y.toFixed(4),t=Kc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Aw(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(La).join(`
`)}function Cw(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function Rw(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function La(n){return n!==""}function Ag(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Cg(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var Pw=/^[ \t]*#include +<([\w\d./]+)>/gm;function $f(n){return n.replace(Pw,Iw)}function Iw(n,e){let t=ct[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return $f(t)}var Lw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Rg(n){return n.replace(Lw,Dw)}function Dw(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Pg(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var Nw={[ba]:"SHADOWMAP_TYPE_PCF",[go]:"SHADOWMAP_TYPE_VSM"};function Fw(n){return Nw[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Uw={[xo]:"ENVMAP_MODE_REFRACTION"};function Ow(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":Uw[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Bw={[ff]:"ENVMAP_BLENDING_MULTIPLY",[Ym]:"ENVMAP_BLENDING_MIX",[Zm]:"ENVMAP_BLENDING_ADD"};function kw(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":Bw[n.combine]||"ENVMAP_BLENDING_NONE"}function zw(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=Fw(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=Ow(t),d=kw(t),h=Aw(t),f=Cw(r),p=s.createProgram(),_,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(La).join(`
`),_.length>0&&(_+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(La).join(`
`),m.length>0&&(m+=`
`)):(_=[Pg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(La).join(`
`),m=[Pg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ns?"#define TONE_MAPPING":"",t.toneMapping!==ns?ct.tonemapping_pars_fragment:"",t.toneMapping!==ns?Ew("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ct.colorspace_pars_fragment,Sw("linearToOutputTexel",t.outputColorSpace),Tw(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(La).join(`
`)),o=$f(o),o=Ag(o,t),o=Cg(o,t),a=$f(a),a=Ag(a,t),a=Cg(a,t),o=Rg(o),a=Rg(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,_=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,m=["#define varying in",t.glslVersion===Ff?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Ff?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let x=g+_+o,M=g+m+a,y=wg(s,s.VERTEX_SHADER,x),C=wg(s,s.FRAGMENT_SHADER,M);s.attachShader(p,y),s.attachShader(p,C),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function A(L){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(p)||"",O=s.getShaderInfoLog(y)||"",z=s.getShaderInfoLog(C)||"",N=I.trim(),W=O.trim(),$=z.trim(),V=!0,le=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(V=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,y,C);else{let J=Tg(s,y,"vertex"),Q=Tg(s,C,"fragment");nt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+N+`
`+J+`
`+Q)}else N!==""?Ye("WebGLProgram: Program Info Log:",N):(W===""||$==="")&&(le=!1);le&&(L.diagnostics={runnable:V,programLog:N,vertexShader:{log:W,prefix:_},fragmentShader:{log:$,prefix:m}})}s.deleteShader(y),s.deleteShader(C),v=new yo(s,p),w=Rw(s,p)}let v;this.getUniforms=function(){return v===void 0&&A(this),v};let w;this.getAttributes=function(){return w===void 0&&A(this),w};let U=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(p,vw)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=yw++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=y,this.fragmentShader=C,this}var Hw=0,Yf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Zf(e),t.set(e,i)),i}},Zf=class{constructor(e){this.id=Hw++,this.code=e,this.usedTimes=0}};function Vw(n){return n===js||n===Aa||n===Ca}function Gw(n,e,t,i,s,r){let o=new ua,a=new Yf,l=new Set,c=[],u=new Map,d=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(v){return l.add(v),v===0?"uv":`uv${v}`}function p(v,w,U,L,I,O){let z=L.fog,N=I.geometry,W=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?L.environment:null,$=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,V=e.get(v.envMap||W,$),le=h[v.type],J=i.precision;v.precision!==null&&(J=i.getMaxPrecision(v.precision),J!==v.precision&&Ye("WebGLProgram.getParameters:",v.precision,"not supported, using",J,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ie=Q!==void 0?Q.length:0,fe=0;N.morphAttributes.position!==void 0&&(fe=1),N.morphAttributes.normal!==void 0&&(fe=2),N.morphAttributes.color!==void 0&&(fe=3);let he,ee,me,ge;if(le){let Ce=ss[le];he=Ce.vertexShader,ee=Ce.fragmentShader}else{he=v.vertexShader,ee=v.fragmentShader;let Ce=a.getVertexShaderStage(v),ot=a.getFragmentShaderStage(v);a.update(v,Ce,ot),me=Ce.id,ge=ot.id}let Se=n.getRenderTarget(),xe=n.state.buffers.depth.getReversed(),He=I.isInstancedMesh===!0,qe=I.isBatchedMesh===!0,Fe=!!v.map,Je=!!v.matcap,Ze=!!V,je=Ze&&V.isPMREMTexture===!0,Ot=!!v.aoMap,Ct=!!v.lightMap,un=!!v.bumpMap&&v.wireframe===!1,Ft=!!v.normalMap,Cn=!!v.displacementMap,xt=!!v.emissiveMap,Mn=!!v.metalnessMap,en=!!v.roughnessMap,hn=v.anisotropy>0,k=v.clearcoat>0,Re=v.diffuseRoughness>0,$e=v.dispersion>0,rt=v.retroreflectivity>0,we=v.iridescence>0,Bt=v.sheen>0,Ve=v.transmission>0,Xe=hn&&!!v.anisotropyMap,R=k&&!!v.clearcoatMap,S=k&&!!v.clearcoatNormalMap,q=k&&!!v.clearcoatRoughnessMap,ue=Re&&!!v.diffuseRoughnessMap,oe=we&&!!v.iridescenceMap,ve=we&&!!v.iridescenceThicknessMap,ye=Bt&&!!v.sheenColorMap,te=Bt&&!!v.sheenRoughnessMap,se=!!v.specularMap,pe=!!v.specularColorMap,B=!!v.specularIntensityMap,re=Ve&&!!v.transmissionMap,ne=Ve&&!!v.thicknessMap,Ee=!!v.gradientMap,_e=!!v.alphaMap,Me=v.alphaTest>0,Ge=!!v.alphaHash,Qe=!!v.extensions,ce=ns;v.toneMapped&&(Se===null||Se.isXRRenderTarget===!0)&&(ce=n.toneMapping);let Be=je?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,et={shaderID:le,shaderType:v.type,shaderName:v.name,vertexShader:he,fragmentShader:ee,defines:v.defines,customVertexShaderID:me,customFragmentShaderID:ge,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:J,batching:qe,batchingColor:qe&&I._colorsTexture!==null,instancing:He,instancingColor:He&&I.instanceColor!==null,instancingMorph:He&&I.morphTexture!==null,outputColorSpace:Se===null?n.outputColorSpace:Se.isXRRenderTarget===!0?Se.texture.colorSpace:pt.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Fe,matcap:Je,envMap:Ze,envMapMode:Ze&&V.mapping,envMapPMREM:je,envMapMaxLod:je?Be.length-1:null,envMapSize:je?Be[0].width:null,aoMap:Ot,lightMap:Ct,bumpMap:un,normalMap:Ft,displacementMap:Cn,emissiveMap:xt,normalMapObjectSpace:Ft&&v.normalMapType===jm,normalMapTangentSpace:Ft&&v.normalMapType===Cf,packedNormalMap:Ft&&v.normalMapType===Cf&&Vw(v.normalMap.format),metalnessMap:Mn,roughnessMap:en,anisotropy:hn,anisotropyMap:Xe,clearcoat:k,clearcoatMap:R,clearcoatNormalMap:S,clearcoatRoughnessMap:q,diffuseRoughness:Re,diffuseRoughnessMap:ue,dispersion:$e,retroreflection:rt,iridescence:we,iridescenceMap:oe,iridescenceThicknessMap:ve,sheen:Bt,sheenColorMap:ye,sheenRoughnessMap:te,specularMap:se,specularColorMap:pe,specularIntensityMap:B,transmission:Ve,transmissionMap:re,thicknessMap:ne,gradientMap:Ee,opaque:v.transparent===!1&&v.blending===_o&&v.alphaToCoverage===!1,alphaMap:_e,alphaTest:Me,alphaHash:Ge,combine:v.combine,mapUv:Fe&&f(v.map.channel),aoMapUv:Ot&&f(v.aoMap.channel),lightMapUv:Ct&&f(v.lightMap.channel),bumpMapUv:un&&f(v.bumpMap.channel),normalMapUv:Ft&&f(v.normalMap.channel),displacementMapUv:Cn&&f(v.displacementMap.channel),emissiveMapUv:xt&&f(v.emissiveMap.channel),metalnessMapUv:Mn&&f(v.metalnessMap.channel),roughnessMapUv:en&&f(v.roughnessMap.channel),anisotropyMapUv:Xe&&f(v.anisotropyMap.channel),clearcoatMapUv:R&&f(v.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&f(v.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&f(v.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&f(v.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&f(v.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(v.sheenRoughnessMap.channel),specularMapUv:se&&f(v.specularMap.channel),specularColorMapUv:pe&&f(v.specularColorMap.channel),specularIntensityMapUv:B&&f(v.specularIntensityMap.channel),transmissionMapUv:re&&f(v.transmissionMap.channel),thicknessMapUv:ne&&f(v.thicknessMap.channel),alphaMapUv:_e&&f(v.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Ft||hn),vertexNormals:!!N.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!N.attributes.uv&&(Fe||_e),fog:!!z,useFog:v.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||N.attributes.normal===void 0&&Ft===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:xe,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:fe,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:O.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:Fe&&v.map.isVideoTexture===!0&&pt.getTransfer(v.map.colorSpace)===Tt,decodeVideoTextureEmissive:xt&&v.emissiveMap.isVideoTexture===!0&&pt.getTransfer(v.emissiveMap.colorSpace)===Tt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Nn,flipSided:v.side===kn,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Qe&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qe&&v.extensions.multiDraw===!0||qe)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return et.vertexUv1s=l.has(1),et.vertexUv2s=l.has(2),et.vertexUv3s=l.has(3),l.clear(),et}function _(v){let w=[];if(v.shaderID?w.push(v.shaderID):(w.push(v.customVertexShaderID),w.push(v.customFragmentShaderID)),v.defines!==void 0)for(let U in v.defines)w.push(U),w.push(v.defines[U]);return v.isRawShaderMaterial===!1&&(m(w,v),g(w,v),w.push(n.outputColorSpace)),w.push(v.customProgramCacheKey),w.join()}function m(v,w){v.push(w.precision),v.push(w.outputColorSpace),v.push(w.envMapMode),v.push(w.envMapPMREM),v.push(w.envMapMaxLod),v.push(w.envMapSize),v.push(w.mapUv),v.push(w.alphaMapUv),v.push(w.lightMapUv),v.push(w.aoMapUv),v.push(w.bumpMapUv),v.push(w.normalMapUv),v.push(w.displacementMapUv),v.push(w.emissiveMapUv),v.push(w.metalnessMapUv),v.push(w.roughnessMapUv),v.push(w.anisotropyMapUv),v.push(w.clearcoatMapUv),v.push(w.clearcoatNormalMapUv),v.push(w.clearcoatRoughnessMapUv),v.push(w.diffuseRoughnessMapUv),v.push(w.iridescenceMapUv),v.push(w.iridescenceThicknessMapUv),v.push(w.sheenColorMapUv),v.push(w.sheenRoughnessMapUv),v.push(w.specularMapUv),v.push(w.specularColorMapUv),v.push(w.specularIntensityMapUv),v.push(w.transmissionMapUv),v.push(w.thicknessMapUv),v.push(w.combine),v.push(w.fogExp2),v.push(w.sizeAttenuation),v.push(w.morphTargetsCount),v.push(w.numSunLights),v.push(w.numDirLights),v.push(w.numPointLights),v.push(w.numSpotLights),v.push(w.numSpotLightMaps),v.push(w.numHemiLights),v.push(w.numRectAreaLights),v.push(w.numSunLightShadows),v.push(w.numDirLightShadows),v.push(w.numPointLightShadows),v.push(w.numSpotLightShadows),v.push(w.numSpotLightShadowsWithMaps),v.push(w.numLightProbes),v.push(w.numLightProbeGrids),v.push(w.shadowMapType),v.push(w.toneMapping),v.push(w.numClippingPlanes),v.push(w.numClipIntersection),v.push(w.depthPacking)}function g(v,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function x(v){let w=h[v.type],U;if(w){let L=ss[w];U=hg.clone(L.uniforms)}else U=v.uniforms;return U}function M(v,w){let U=u.get(w);return U!==void 0?++U.usedTimes:(U=new zw(n,w,v,s),c.push(U),u.set(w,U)),U}function y(v){if(--v.usedTimes===0){let w=c.indexOf(v);c[w]=c[c.length-1],c.pop(),u.delete(v.cacheKey),v.destroy()}}function C(v){a.remove(v)}function A(){a.dispose()}return{getParameters:p,getProgramCacheKey:_,getUniforms:x,acquireProgram:M,releaseProgram:y,releaseShaderCache:C,programs:c,dispose:A}}function Ww(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function Xw(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Ig(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Lg(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let f=0;return h.isInstancedMesh&&(f+=2),h.isSkinnedMesh&&(f+=1),f}function a(h,f,p,_,m,g){let x=n[e];return x===void 0?(x={id:h.id,object:h,geometry:f,material:p,materialVariant:o(h),groupOrder:_,renderOrder:h.renderOrder,z:m,group:g},n[e]=x):(x.id=h.id,x.object=h,x.geometry=f,x.material=p,x.materialVariant=o(h),x.groupOrder=_,x.renderOrder=h.renderOrder,x.z=m,x.group=g),e++,x}function l(h,f,p,_,m,g,x){x.reversedDepth===!0&&(m=-m);let M=a(h,f,p,_,m,g);p.transmission>0?i.push(M):p.transparent===!0?s.push(M):t.push(M)}function c(h,f,p,_,m,g){let x=a(h,f,p,_,m,g);p.transmission>0?i.unshift(x):p.transparent===!0?s.unshift(x):t.unshift(x)}function u(h,f){t.length>1&&t.sort(h||Xw),i.length>1&&i.sort(f||Ig),s.length>1&&s.sort(f||Ig)}function d(){for(let h=e,f=n.length;h<f;h++){let p=n[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:u}}function qw(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Lg,n.set(i,[o])):s>=r.length?(o=new Lg,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function $w(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new G,color:new at};break;case"SpotLight":t={position:new G,direction:new G,color:new at,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new G,color:new at,distance:0,decay:0};break;case"HemisphereLight":t={direction:new G,skyColor:new at,groundColor:new at};break;case"RectAreaLight":t={color:new at,position:new G,halfWidth:new G,halfHeight:new G};break}return n[e.id]=t,t}}}function Yw(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var Zw=0;function Jw(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function Kw(n){let e=new $w,t=Yw(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new G);let s=new G,r=new vt,o=new vt;function a(c){let u=0,d=0,h=0;for(let O=0;O<9;O++)i.probe[O].set(0,0,0);let f=0,p=0,_=0,m=0,g=0,x=0,M=0,y=0,C=0,A=0,v=0,w=0,U=0,L=0;c.sort(Jw);for(let O=0,z=c.length;O<z;O++){let N=c[O],W=N.color,$=N.intensity,V=N.distance,le=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===js?le=N.shadow.map.texture:le=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=W.r*$,d+=W.g*$,h+=W.b*$;else if(N.isLightProbe){for(let J=0;J<9;J++)i.probe[J].addScaledVector(N.sh.coefficients[J],$);L++}else if(N.isSunLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=ie,i.sunShadowMap[p]=le;let fe=Q.getViewportCount();for(let he=0;he<fe;he++)i.sunShadowMatrix[_+he]=Q.getMatrix(he),i.sunShadowCascade[_+he]=Q._cascadeData[he];_+=fe,p++}i.sun[f]=J,f++}else if(N.isDirectionalLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.directionalShadow[m]=ie,i.directionalShadowMap[m]=le,i.directionalShadowMatrix[m]=N.shadow.matrix,C++}i.directional[m]=J,m++}else if(N.isSpotLight){let J=e.get(N);J.position.setFromMatrixPosition(N.matrixWorld),J.color.copy(W).multiplyScalar($),J.distance=V,J.coneCos=Math.cos(N.angle),J.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),J.decay=N.decay,i.spot[x]=J;let Q=N.shadow;if(N.map&&(i.spotLightMap[w]=N.map,w++,Q.updateMatrices(N),N.castShadow&&U++),i.spotLightMatrix[x]=Q.matrix,N.castShadow){let ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.spotShadow[x]=ie,i.spotShadowMap[x]=le,v++}x++}else if(N.isRectAreaLight){let J=e.get(N);J.color.copy(W).multiplyScalar($),J.halfWidth.set(N.width*.5,0,0),J.halfHeight.set(0,N.height*.5,0),i.rectArea[M]=J,M++}else if(N.isPointLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),J.distance=N.distance,J.decay=N.decay,N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,i.pointShadow[g]=ie,i.pointShadowMap[g]=le,i.pointShadowMatrix[g]=N.shadow.matrix,A++}i.point[g]=J,g++}else if(N.isHemisphereLight){let J=e.get(N);J.skyColor.copy(N.color).multiplyScalar($),J.groundColor.copy(N.groundColor).multiplyScalar($),i.hemi[y]=J,y++}}M>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=d,i.ambient[2]=h;let I=i.hash;(I.sunLength!==f||I.directionalLength!==m||I.pointLength!==g||I.spotLength!==x||I.rectAreaLength!==M||I.hemiLength!==y||I.numSunShadows!==p||I.numDirectionalShadows!==C||I.numPointShadows!==A||I.numSpotShadows!==v||I.numSpotMaps!==w||I.numLightProbes!==L)&&(i.sun.length=f,i.directional.length=m,i.spot.length=x,i.rectArea.length=M,i.point.length=g,i.hemi.length=y,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+w-U,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=L,I.sunLength=f,I.directionalLength=m,I.pointLength=g,I.spotLength=x,I.rectAreaLength=M,I.hemiLength=y,I.numSunShadows=p,I.numDirectionalShadows=C,I.numPointShadows=A,I.numSpotShadows=v,I.numSpotMaps=w,I.numLightProbes=L,i.version=Zw++)}function l(c,u){let d=0,h=0,f=0,p=0,_=0,m=0,g=u.matrixWorldInverse;for(let x=0,M=c.length;x<M;x++){let y=c[x];if(y.isSunLight){let C=i.sun[d];C.direction.setFromMatrixPosition(y.matrixWorld),C.direction.transformDirection(g),d++}else if(y.isDirectionalLight){let C=i.directional[h];C.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),h++}else if(y.isSpotLight){let C=i.spot[p];C.position.setFromMatrixPosition(y.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),p++}else if(y.isRectAreaLight){let C=i.rectArea[_];C.position.setFromMatrixPosition(y.matrixWorld),C.position.applyMatrix4(g),o.identity(),r.copy(y.matrixWorld),r.premultiply(g),o.extractRotation(r),C.halfWidth.set(y.width*.5,0,0),C.halfHeight.set(0,y.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),_++}else if(y.isPointLight){let C=i.point[f];C.position.setFromMatrixPosition(y.matrixWorld),C.position.applyMatrix4(g),f++}else if(y.isHemisphereLight){let C=i.hemi[m];C.direction.setFromMatrixPosition(y.matrixWorld),C.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function Dg(n){let e=new Kw(n),t=[],i=[],s=[];function r(d){u.camera=d,t.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):t.push(d)}function a(d){i.push(d)}function l(){e.setup(t),s.sort((d,h)=>d.priority-h.priority||d.id-h.id)}function c(d){e.setupView(t,d)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function jw(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Dg(n),e.set(s,[a])):r>=o.length?(a=new Dg(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var Qw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,e1=`uniform sampler2D shadow_pass;
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
}`,t1=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],n1=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],Ng=new vt,Ia=new G,Gf=new G;function i1(n,e,t){let i=new bs,s=new _t,r=new _t,o=new $t,a=new Kl,l=new jl,c={},u=t.maxTextureSize,d={[Si]:kn,[kn]:Si,[Nn]:Nn},h=new Mi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new _t},radius:{value:4}},vertexShader:Qw,fragmentShader:e1}),f=h.clone();f.defines.HORIZONTAL_PASS=1;let p=new on;p.setAttribute("position",new bt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new yt(p,h),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ba;let g=this.type;this.render=function(A,v,w){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;this.type===Rm&&(Ye("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ba);let U=n.getRenderTarget(),L=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),O=n.state;O.setBlending(xr),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let z=g!==this.type;z&&v.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(W=>W.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,W=A.length;N<W;N++){let $=A[N],V=$.shadow;if(V===void 0){Ye("WebGLShadowMap:",$,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let le=V.getFrameExtents();s.multiply(le),r.copy(V.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,V.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,V.mapSize.y=r.y));let J=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=J,V.map===null||z===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===go){if($.isPointLight){Ye("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new li(s.x,s.y,{format:js,type:Hi,minFilter:Bn,magFilter:Bn,generateMipmaps:!1}),V.map.texture.name=$.name+".shadowMap",V.map.depthTexture=new Ms(s.x,s.y,zi),V.map.depthTexture.name=$.name+".shadowMapDepth",V.map.depthTexture.format=vs,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=_n,V.map.depthTexture.magFilter=_n}else $.isPointLight?(V.map=new Da(s.x),V.map.depthTexture=new ga(s.x,ki)):(V.map=new li(s.x,s.y),V.map.depthTexture=new Ms(s.x,s.y,ki)),V.map.depthTexture.name=$.name+".shadowMap",V.map.depthTexture.format=vs,this.type===ba?(V.map.depthTexture.compareFunction=J?Df:Lf,V.map.depthTexture.minFilter=Bn,V.map.depthTexture.magFilter=Bn):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=_n,V.map.depthTexture.magFilter=_n);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let Q=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();$.isPointLight!==!0&&V.updateMatrices($,w);let ie=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:w.layers;for(let fe=0;fe<Q;fe++){let he=V.getCamera(fe);if($.isPointLight){let ee=V.camera,me=V.matrix,ge=$.distance||ee.far;ge!==ee.far&&(ee.far=ge,ee.updateProjectionMatrix()),Ia.setFromMatrixPosition($.matrixWorld),ee.position.copy(Ia),Gf.copy(ee.position),Gf.add(t1[fe]),ee.up.copy(n1[fe]),ee.lookAt(Gf),ee.updateMatrixWorld(),me.makeTranslation(-Ia.x,-Ia.y,-Ia.z),Ng.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),V._frustum.setFromProjectionMatrix(Ng,ee.coordinateSystem,ee.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,fe),n.clear();else{fe===0&&(n.setRenderTarget(V.map),n.clear());let ee=V.getViewport(fe);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),O.viewport(o)}i=V.getFrustum(fe),y(v,w,he,$,ie,this.type)}V.isPointLightShadow!==!0&&this.type===go&&x(V,w),V.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(U,L,I)};function x(A,v){let w=e.update(_);h.defines.VSM_SAMPLES!==A.blurSamples&&(h.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,h.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new li(s.x,s.y,{format:js,type:Hi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),h.uniforms.shadow_pass.value=A.map.depthTexture,h.uniforms.resolution.value.set(A.map.width,A.map.height),h.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(v,null,w,h,_,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(v,null,w,f,_,null)}function M(A,v,w,U){let L=null,I=w.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(I!==void 0)L=I;else if(L=w.isPointLight===!0?l:a,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let O=L.uuid,z=v.uuid,N=c[O];N===void 0&&(N={},c[O]=N);let W=N[z];W===void 0&&(W=L.clone(),N[z]=W,v.addEventListener("dispose",C)),L=W}if(L.visible=v.visible,L.wireframe=v.wireframe,U===go?L.side=v.shadowSide!==null?v.shadowSide:v.side:L.side=v.shadowSide!==null?v.shadowSide:d[v.side],L.alphaMap=v.alphaMap,L.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,L.map=v.map,L.clipShadows=v.clipShadows,L.clippingPlanes=v.clippingPlanes,L.clipIntersection=v.clipIntersection,L.displacementMap=v.displacementMap,L.displacementScale=v.displacementScale,L.displacementBias=v.displacementBias,L.wireframeLinewidth=v.wireframeLinewidth,L.linewidth=v.linewidth,w.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let O=n.properties.get(L);O.light=w}return L}function y(A,v,w,U,L,I){if(A.visible===!1)return;if(A.layers.test(L)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&I===go)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,A.matrixWorld);let N=e.update(A),W=A.material;if(Array.isArray(W)){let $=N.groups;for(let V=0,le=$.length;V<le;V++){let J=$[V],Q=W[J.materialIndex];if(Q&&Q.visible){let ie=M(A,Q,U,I);A.onBeforeShadow(n,A,v,w,N,ie,J),n.renderBufferDirect(w,null,N,ie,A,J),A.onAfterShadow(n,A,v,w,N,ie,J)}}}else if(W.visible){let $=M(A,W,U,I);A.onBeforeShadow(n,A,v,w,N,$,null),n.renderBufferDirect(w,null,N,$,A,null),A.onAfterShadow(n,A,v,w,N,$,null)}}let z=A.children;for(let N=0,W=z.length;N<W;N++)y(z[N],v,w,U,L,I)}function C(A){A.target.removeEventListener("dispose",C);for(let w in c){let U=c[w],L=A.target.uuid;L in U&&(U[L].dispose(),delete U[L])}}}function s1(n,e){function t(){let B=!1,re=new $t,ne=null,Ee=new $t(0,0,0,0);return{setMask:function(_e){ne!==_e&&!B&&(n.colorMask(_e,_e,_e,_e),ne=_e)},setLocked:function(_e){B=_e},setClear:function(_e,Me,Ge,Qe,ce){ce===!0&&(_e*=Qe,Me*=Qe,Ge*=Qe),re.set(_e,Me,Ge,Qe),Ee.equals(re)===!1&&(n.clearColor(_e,Me,Ge,Qe),Ee.copy(re))},reset:function(){B=!1,ne=null,Ee.set(-1,0,0,0)}}}function i(){let B=!1,re=!1,ne=null,Ee=null,_e=null;return{setReversed:function(Me){if(re!==Me){let Ge=e.get("EXT_clip_control");Me?Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.ZERO_TO_ONE_EXT):Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.NEGATIVE_ONE_TO_ONE_EXT),re=Me;let Qe=_e;_e=null,this.setClear(Qe)}},getReversed:function(){return re},setTest:function(Me){Me?xe(n.DEPTH_TEST):He(n.DEPTH_TEST)},setMask:function(Me){ne!==Me&&!B&&(n.depthMask(Me),ne=Me)},setFunc:function(Me){if(re&&(Me=lg[Me]),Ee!==Me){switch(Me){case Nl:n.depthFunc(n.NEVER);break;case Fl:n.depthFunc(n.ALWAYS);break;case Ul:n.depthFunc(n.LESS);break;case ro:n.depthFunc(n.LEQUAL);break;case Ol:n.depthFunc(n.EQUAL);break;case Bl:n.depthFunc(n.GEQUAL);break;case oo:n.depthFunc(n.GREATER);break;case kl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ee=Me}},setLocked:function(Me){B=Me},setClear:function(Me){_e!==Me&&(_e=Me,re&&(Me=1-Me),n.clearDepth(Me))},reset:function(){B=!1,ne=null,Ee=null,_e=null,re=!1}}}function s(){let B=!1,re=null,ne=null,Ee=null,_e=null,Me=null,Ge=null,Qe=null,ce=null;return{setTest:function(Be){B||(Be?xe(n.STENCIL_TEST):He(n.STENCIL_TEST))},setMask:function(Be){re!==Be&&!B&&(n.stencilMask(Be),re=Be)},setFunc:function(Be,et,Ce){(ne!==Be||Ee!==et||_e!==Ce)&&(n.stencilFunc(Be,et,Ce),ne=Be,Ee=et,_e=Ce)},setOp:function(Be,et,Ce){(Me!==Be||Ge!==et||Qe!==Ce)&&(n.stencilOp(Be,et,Ce),Me=Be,Ge=et,Qe=Ce)},setLocked:function(Be){B=Be},setClear:function(Be){ce!==Be&&(n.clearStencil(Be),ce=Be)},reset:function(){B=!1,re=null,ne=null,Ee=null,_e=null,Me=null,Ge=null,Qe=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},d={},h={},f=new WeakMap,p=[],_=null,m=!1,g=null,x=null,M=null,y=null,C=null,A=null,v=null,w=new at(0,0,0),U=0,L=!1,I=null,O=null,z=null,N=null,W=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,le=0,J=n.getParameter(n.VERSION);J.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(J)[1]),V=le>=1):J.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),V=le>=2);let Q=null,ie={},fe=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),ee=new $t().fromArray(fe),me=new $t().fromArray(he);function ge(B,re,ne,Ee){let _e=new Uint8Array(4),Me=n.createTexture();n.bindTexture(B,Me),n.texParameteri(B,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(B,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ge=0;Ge<ne;Ge++)B===n.TEXTURE_3D||B===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,Ee,0,n.RGBA,n.UNSIGNED_BYTE,_e):n.texImage2D(re+Ge,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_e);return Me}let Se={};Se[n.TEXTURE_2D]=ge(n.TEXTURE_2D,n.TEXTURE_2D,1),Se[n.TEXTURE_CUBE_MAP]=ge(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Se[n.TEXTURE_2D_ARRAY]=ge(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Se[n.TEXTURE_3D]=ge(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),xe(n.DEPTH_TEST),o.setFunc(ro),un(!1),Ft(of),xe(n.CULL_FACE),Ot(xr);function xe(B){u[B]!==!0&&(n.enable(B),u[B]=!0)}function He(B){u[B]!==!1&&(n.disable(B),u[B]=!1)}function qe(B,re){return h[B]!==re?(n.bindFramebuffer(B,re),h[B]=re,B===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=re),B===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Fe(B,re){let ne=p,Ee=!1;if(B){ne=f.get(re),ne===void 0&&(ne=[],f.set(re,ne));let _e=B.textures;if(ne.length!==_e.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let Me=0,Ge=_e.length;Me<Ge;Me++)ne[Me]=n.COLOR_ATTACHMENT0+Me;ne.length=_e.length,Ee=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,Ee=!0);Ee&&n.drawBuffers(ne)}function Je(B){return _!==B?(n.useProgram(B),_=B,!0):!1}let Ze={[vr]:n.FUNC_ADD,[Im]:n.FUNC_SUBTRACT,[Lm]:n.FUNC_REVERSE_SUBTRACT};Ze[Dm]=n.MIN,Ze[Nm]=n.MAX;let je={[Fm]:n.ZERO,[Um]:n.ONE,[Om]:n.SRC_COLOR,[uf]:n.SRC_ALPHA,[Gm]:n.SRC_ALPHA_SATURATE,[Hm]:n.DST_COLOR,[km]:n.DST_ALPHA,[Bm]:n.ONE_MINUS_SRC_COLOR,[hf]:n.ONE_MINUS_SRC_ALPHA,[Vm]:n.ONE_MINUS_DST_COLOR,[zm]:n.ONE_MINUS_DST_ALPHA,[Wm]:n.CONSTANT_COLOR,[Xm]:n.ONE_MINUS_CONSTANT_COLOR,[qm]:n.CONSTANT_ALPHA,[$m]:n.ONE_MINUS_CONSTANT_ALPHA};function Ot(B,re,ne,Ee,_e,Me,Ge,Qe,ce,Be){if(B===xr){m===!0&&(He(n.BLEND),m=!1);return}if(m===!1&&(xe(n.BLEND),m=!0),B!==Pm){if(B!==g||Be!==L){if((x!==vr||C!==vr)&&(n.blendEquation(n.FUNC_ADD),x=vr,C=vr),Be)switch(B){case _o:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case af:n.blendFunc(n.ONE,n.ONE);break;case lf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case cf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:nt("WebGLState: Invalid blending: ",B);break}else switch(B){case _o:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case af:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case lf:nt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case cf:nt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:nt("WebGLState: Invalid blending: ",B);break}M=null,y=null,A=null,v=null,w.set(0,0,0),U=0,g=B,L=Be}return}_e=_e||re,Me=Me||ne,Ge=Ge||Ee,(re!==x||_e!==C)&&(n.blendEquationSeparate(Ze[re],Ze[_e]),x=re,C=_e),(ne!==M||Ee!==y||Me!==A||Ge!==v)&&(n.blendFuncSeparate(je[ne],je[Ee],je[Me],je[Ge]),M=ne,y=Ee,A=Me,v=Ge),(Qe.equals(w)===!1||ce!==U)&&(n.blendColor(Qe.r,Qe.g,Qe.b,ce),w.copy(Qe),U=ce),g=B,L=!1}function Ct(B,re){B.side===Nn?He(n.CULL_FACE):xe(n.CULL_FACE);let ne=B.side===kn;re&&(ne=!ne),un(ne),B.blending===_o&&B.transparent===!1?Ot(xr):Ot(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let Ee=B.stencilWrite;a.setTest(Ee),Ee&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),xt(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?xe(n.SAMPLE_ALPHA_TO_COVERAGE):He(n.SAMPLE_ALPHA_TO_COVERAGE)}function un(B){I!==B&&(B?n.frontFace(n.CW):n.frontFace(n.CCW),I=B)}function Ft(B){B!==Am?(xe(n.CULL_FACE),B!==O&&(B===of?n.cullFace(n.BACK):B===Cm?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):He(n.CULL_FACE),O=B}function Cn(B){B!==z&&(V&&n.lineWidth(B),z=B)}function xt(B,re,ne){B?(xe(n.POLYGON_OFFSET_FILL),(N!==re||W!==ne)&&(N=re,W=ne,o.getReversed()&&(re=-re,ne=-ne),n.polygonOffset(re,ne))):He(n.POLYGON_OFFSET_FILL)}function Mn(B){B?xe(n.SCISSOR_TEST):He(n.SCISSOR_TEST)}function en(B){B===void 0&&(B=n.TEXTURE0+$-1),Q!==B&&(n.activeTexture(B),Q=B)}function hn(B,re,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+$-1:ne=Q);let Ee=ie[ne];Ee===void 0&&(Ee={type:void 0,texture:void 0},ie[ne]=Ee),(Ee.type!==B||Ee.texture!==re)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(B,re||Se[B]),Ee.type=B,Ee.texture=re)}function k(){let B=ie[Q];B!==void 0&&B.type!==void 0&&(n.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Re(){try{n.compressedTexImage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function $e(){try{n.compressedTexImage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function rt(){try{n.texSubImage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function we(){try{n.texSubImage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function Bt(){try{n.compressedTexSubImage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function Ve(){try{n.compressedTexSubImage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function Xe(){try{n.texStorage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function R(){try{n.texStorage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function S(){try{n.texImage2D(...arguments)}catch(B){nt("WebGLState:",B)}}function q(){try{n.texImage3D(...arguments)}catch(B){nt("WebGLState:",B)}}function ue(B){return d[B]!==void 0?d[B]:n.getParameter(B)}function oe(B,re){d[B]!==re&&(n.pixelStorei(B,re),d[B]=re)}function ve(B){ee.equals(B)===!1&&(n.scissor(B.x,B.y,B.z,B.w),ee.copy(B))}function ye(B){me.equals(B)===!1&&(n.viewport(B.x,B.y,B.z,B.w),me.copy(B))}function te(B,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let Ee=ne.get(B);Ee===void 0&&(Ee=n.getUniformBlockIndex(re,B.name),n.uniformBlockBinding(re,Ee,Ee),ne.set(B,Ee))}function se(B,re,ne){let _e=c.get(re).get(B);l[_e]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,_e,ne),l[_e]=ne)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},d={},Q=null,ie={},h={},l={},f=new WeakMap,p=[],_=null,m=!1,g=null,x=null,M=null,y=null,C=null,A=null,v=null,w=new at(0,0,0),U=0,L=!1,I=null,O=null,z=null,N=null,W=null,ee.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:xe,disable:He,bindFramebuffer:qe,drawBuffers:Fe,useProgram:Je,setBlending:Ot,setMaterial:Ct,setFlipSided:un,setCullFace:Ft,setLineWidth:Cn,setPolygonOffset:xt,setScissorTest:Mn,activeTexture:en,bindTexture:hn,unbindTexture:k,compressedTexImage2D:Re,compressedTexImage3D:$e,texImage2D:S,texImage3D:q,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:Xe,texStorage3D:R,texSubImage2D:rt,texSubImage3D:we,compressedTexSubImage2D:Bt,compressedTexSubImage3D:Ve,scissor:ve,viewport:ye,reset:pe}}function r1(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new _t,u=new WeakMap,d=new Set,h,f=new WeakMap,p=new Set,_=new FinalizationRegistry(R=>p.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,S){return m?new OffscreenCanvas(R,S):la("canvas")}function x(R,S,q){let ue=1,oe=Xe(R);if((oe.width>q||oe.height>q)&&(ue=q/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let ve=Math.floor(ue*oe.width),ye=Math.floor(ue*oe.height);h===void 0&&(h=g(ve,ye));let te=S?g(ve,ye):h;return te.width=ve,te.height=ye,te.getContext("2d").drawImage(R,0,0,ve,ye),Ye("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+ve+"x"+ye+")."),te}else return"data"in R&&Ye("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),R;return R}function M(R){return R.generateMipmaps}function y(R){n.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(R,S,q,ue,oe,ve=!1){if(R!==null){if(n[R]!==void 0)return n[R];Ye("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||Ye("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=S;if(S===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.R16_EXT),q===n.SHORT&&ye&&(te=ye.R16_SNORM_EXT)),S===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),S===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RG16_EXT),q===n.SHORT&&ye&&(te=ye.RG16_SNORM_EXT)),S===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),S===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),S===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),S===n.RGB&&(q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGB16_EXT),q===n.SHORT&&ye&&(te=ye.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),S===n.RGBA){let se=ve?oa:pt.getTransfer(oe);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=se===Tt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGBA16_EXT),q===n.SHORT&&ye&&(te=ye.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function v(R,S){let q;return R?S===null||S===ki||S===br?q=n.DEPTH24_STENCIL8:S===zi?q=n.DEPTH32F_STENCIL8:S===vo&&(q=n.DEPTH24_STENCIL8,Ye("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===ki||S===br?q=n.DEPTH_COMPONENT24:S===zi?q=n.DEPTH_COMPONENT32F:S===vo&&(q=n.DEPTH_COMPONENT16),q}function w(R,S){return M(R)===!0||R.isFramebufferTexture&&R.minFilter!==_n&&R.minFilter!==Bn?Math.log2(Math.max(S.width,S.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?S.mipmaps.length:1}function U(R){let S=new WeakRef(R);i.get(R).__ref=S,p.add(S),_.register(R,S,S)}function L(R){let S=i.get(R).__ref;S!==void 0&&(p.delete(S),_.unregister(S))}function I(R){z(R.target)}function O(R){N(R.target)}function z(R){R.removeEventListener("dispose",I),L(R),$(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&d.delete(R)}function N(R){R.removeEventListener("dispose",O),L(R),le(R)}function W(){for(let R of p){let S=R.deref();S!==void 0&&(S.isRenderTarget===!0?N(S):z(S))}p.clear(),d.clear()}function $(R){let S=i.get(R);if(S.__webglInit===void 0)return;let q=R.source,ue=f.get(q);if(ue){let oe=ue[S.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&V(R),Object.keys(ue).length===0&&f.delete(q)}i.remove(R)}function V(R){let S=i.get(R);n.deleteTexture(S.__webglTexture);let q=R.source,ue=f.get(q);delete ue[S.__cacheKey],o.memory.textures--}function le(R){let S=i.get(R);S.__depthDisposeCallback&&S.__depthDisposeCallback();let q=R.depthTexture;if(q&&q.renderTarget===R&&z(q),R.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(S.__webglFramebuffer[oe]))for(let ve=0;ve<S.__webglFramebuffer[oe].length;ve++)n.deleteFramebuffer(S.__webglFramebuffer[oe][ve]);else n.deleteFramebuffer(S.__webglFramebuffer[oe]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[oe])}else{if(Array.isArray(S.__webglFramebuffer))for(let oe=0;oe<S.__webglFramebuffer.length;oe++)n.deleteFramebuffer(S.__webglFramebuffer[oe]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let oe=0;oe<S.__webglColorRenderbuffer.length;oe++)S.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[oe]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ue=R.textures;for(let oe=0,ve=ue.length;oe<ve;oe++){let ye=i.get(ue[oe]);ye.__webglTexture&&(n.deleteTexture(ye.__webglTexture),o.memory.textures--),i.remove(ue[oe])}i.remove(R)}let J=0;function Q(){J=0}function ie(){return J}function fe(R){J=R}function he(){let R=J;return R>=s.maxTextures&&Ye("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,R}function ee(R){let S=[];return S.push(R.wrapS),S.push(R.wrapT),S.push(R.wrapR||0),S.push(R.magFilter),S.push(R.minFilter),S.push(R.anisotropy),S.push(R.internalFormat),S.push(R.format),S.push(R.type),S.push(R.generateMipmaps),S.push(R.mipmapsAutoUpdate),S.push(R.premultiplyAlpha),S.push(R.flipY),S.push(R.unpackAlignment),S.push(R.colorSpace),S.join()}function me(R,S){let q=i.get(R);if(R.isVideoTexture&&Bt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let ue=R.image;if(ue===null)Ye("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Ye("WebGLRenderer: Texture marked for update but image is incomplete");else{Ct(q,R,S);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+S)}function ge(R,S){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Ct(q,R,S);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+S)}function Se(R,S){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Ct(q,R,S);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+S)}function xe(R,S){let q=i.get(R);if(R.version>0&&q.__version!==R.version){un(q,R,S);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+S)}let He={[zl]:n.REPEAT,[es]:n.CLAMP_TO_EDGE,[Hl]:n.MIRRORED_REPEAT},qe={[_n]:n.NEAREST,[Jm]:n.NEAREST_MIPMAP_NEAREST,[Ma]:n.NEAREST_MIPMAP_LINEAR,[Bn]:n.LINEAR,[fc]:n.LINEAR_MIPMAP_NEAREST,[Ss]:n.LINEAR_MIPMAP_LINEAR},Fe={[Qm]:n.NEVER,[Nf]:n.ALWAYS,[eg]:n.LESS,[Lf]:n.LEQUAL,[tg]:n.EQUAL,[Df]:n.GEQUAL,[ng]:n.GREATER,[ig]:n.NOTEQUAL};function Je(R,S){if(S.type===zi&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===Bn||S.magFilter===fc||S.magFilter===Ma||S.magFilter===Ss||S.minFilter===Bn||S.minFilter===fc||S.minFilter===Ma||S.minFilter===Ss)&&Ye("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,He[S.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,He[S.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,He[S.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,qe[S.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,qe[S.minFilter]),S.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,Fe[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===_n||S.minFilter!==Ma&&S.minFilter!==Ss||S.type===zi&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function Ze(R,S){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,S.addEventListener("dispose",I),U(S));let ue=S.source,oe=f.get(ue);oe===void 0&&(oe={},f.set(ue,oe));let ve=ee(S);if(ve!==R.__cacheKey){oe[ve]===void 0&&(oe[ve]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[ve].usedTimes++;let ye=oe[R.__cacheKey];ye!==void 0&&(oe[R.__cacheKey].usedTimes--,ye.usedTimes===0&&V(S)),R.__cacheKey=ve,R.__webglTexture=oe[ve].texture}return q}function je(R,S,q){return Math.floor(Math.floor(R/q)/S)}function Ot(R,S,q,ue){let ve=R.updateRanges;if(ve.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,q,ue,S.data);else{ve.sort((B,re)=>B.start-re.start);let ye=0;for(let B=1;B<ve.length;B++){let re=ve[ye],ne=ve[B],Ee=re.start+re.count,_e=je(ne.start,S.width,4),Me=je(re.start,S.width,4);ne.start<=Ee+1&&_e===Me&&je(ne.start+ne.count-1,S.width,4)===_e?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++ye,ve[ye]=ne)}ve.length=ye+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),se=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let B=0,re=ve.length;B<re;B++){let ne=ve[B],Ee=Math.floor(ne.start/4),_e=Math.ceil(ne.count/4),Me=Ee%S.width,Ge=Math.floor(Ee/S.width),Qe=_e,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Me),t.pixelStorei(n.UNPACK_SKIP_ROWS,Ge),t.texSubImage2D(n.TEXTURE_2D,0,Me,Ge,Qe,ce,q,ue,S.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,se),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function Ct(R,S,q){let ue=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ue=n.TEXTURE_3D);let oe=Ze(R,S),ve=S.source;t.bindTexture(ue,R.__webglTexture,n.TEXTURE0+q);let ye=i.get(ve);if(ve.version!==ye.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let ce=pt.getPrimaries(pt.workingColorSpace),Be=S.colorSpace===Es?null:pt.getPrimaries(S.colorSpace),et=S.colorSpace===Es||ce===Be?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,et)}t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let se=x(S.image,!1,s.maxTextureSize);se=Ve(S,se);let pe=r.convert(S.format,S.colorSpace),B=r.convert(S.type),re=A(S.internalFormat,pe,B,S.normalized,S.colorSpace,S.isVideoTexture);Je(ue,S);let ne,Ee=S.mipmaps,_e=S.isVideoTexture!==!0,Me=ye.__version===void 0||oe===!0,Ge=ve.dataReady,Qe=w(S,se);if(S.isDepthTexture)re=v(S.format===ws,S.type),Me&&(_e?t.texStorage2D(n.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,B,null));else if(S.isDataTexture)if(Ee.length>0){_e&&Me&&t.texStorage2D(n.TEXTURE_2D,Qe,re,Ee[0].width,Ee[0].height);for(let ce=0,Be=Ee.length;ce<Be;ce++)ne=Ee[ce],_e?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,B,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,B,ne.data);S.generateMipmaps=!1}else _e?(Me&&t.texStorage2D(n.TEXTURE_2D,Qe,re,se.width,se.height),Ge&&Ot(S,se,pe,B)):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,B,se.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){_e&&Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Qe,re,Ee[0].width,Ee[0].height,se.depth);for(let ce=0,Be=Ee.length;ce<Be;ce++)if(ne=Ee[ce],S.format!==fi)if(pe!==null)if(_e){if(Ge)if(S.layerUpdates.size>0){let et=Hf(ne.width,ne.height,S.format,S.type);for(let Ce of S.layerUpdates){let ot=ne.data.subarray(Ce*et/ne.data.BYTES_PER_ELEMENT,(Ce+1)*et/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Ce,ne.width,ne.height,1,pe,ot)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,ne.data,0,0);else Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?Ge&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,B,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,pe,B,ne.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{_e&&Me&&t.texStorage2D(n.TEXTURE_2D,Qe,re,Ee[0].width,Ee[0].height);for(let ce=0,Be=Ee.length;ce<Be;ce++)ne=Ee[ce],S.format!==fi?pe!==null?_e?Ge&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,B,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,B,ne.data)}else if(S.isDataArrayTexture)if(_e){if(Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Qe,re,se.width,se.height,se.depth),Ge)if(S.layerUpdates.size>0){let ce=Hf(se.width,se.height,S.format,S.type);for(let Be of S.layerUpdates){let et=se.data.subarray(Be*ce/se.data.BYTES_PER_ELEMENT,(Be+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Be,se.width,se.height,1,pe,B,et)}S.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,pe,B,se.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,pe,B,se.data);else if(S.isData3DTexture)_e?(Me&&t.texStorage3D(n.TEXTURE_3D,Qe,re,se.width,se.height,se.depth),Ge&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,pe,B,se.data)):t.texImage3D(n.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,pe,B,se.data);else if(S.isFramebufferTexture){if(Me)if(_e)t.texStorage2D(n.TEXTURE_2D,Qe,re,se.width,se.height);else{let ce=se.width,Be=se.height;for(let et=0;et<Qe;et++)t.texImage2D(n.TEXTURE_2D,et,re,ce,Be,0,pe,B,null),ce>>=1,Be>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),d.add(S),ce.onpaint=Be=>{let et=Be.changedElements;for(let Ce of d)et.includes(Ce.image)&&(Ce.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,se);else{let et=n.RGBA,Ce=n.RGBA,ot=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,et,Ce,ot,se)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ee.length>0){if(_e&&Me){let ce=Xe(Ee[0]);t.texStorage2D(n.TEXTURE_2D,Qe,re,ce.width,ce.height)}for(let ce=0,Be=Ee.length;ce<Be;ce++)ne=Ee[ce],_e?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,pe,B,ne):t.texImage2D(n.TEXTURE_2D,ce,re,pe,B,ne);S.generateMipmaps=!1}else if(_e){if(Me){let ce=Xe(se);t.texStorage2D(n.TEXTURE_2D,Qe,re,ce.width,ce.height)}Ge&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,B,se)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,B,se);M(S)&&S.mipmapsAutoUpdate===!0&&y(ue),ye.__version=ve.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function un(R,S,q){if(S.image.length!==6)return;let ue=Ze(R,S),oe=S.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+q);let ve=i.get(oe);if(oe.version!==ve.__version||ue===!0){t.activeTexture(n.TEXTURE0+q);let ye=pt.getPrimaries(pt.workingColorSpace),te=S.colorSpace===Es?null:pt.getPrimaries(S.colorSpace),se=S.colorSpace===Es||ye===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let pe=S.isCompressedTexture||S.image[0].isCompressedTexture,B=S.image[0]&&S.image[0].isDataTexture,re=[];for(let Ce=0;Ce<6;Ce++)!pe&&!B?re[Ce]=x(S.image[Ce],!0,s.maxCubemapSize):re[Ce]=B?S.image[Ce].image:S.image[Ce],re[Ce]=Ve(S,re[Ce]);let ne=re[0],Ee=r.convert(S.format,S.colorSpace),_e=r.convert(S.type),Me=A(S.internalFormat,Ee,_e,S.normalized,S.colorSpace),Ge=S.isVideoTexture!==!0,Qe=ve.__version===void 0||ue===!0,ce=oe.dataReady,Be=w(S,ne);Je(n.TEXTURE_CUBE_MAP,S);let et;if(S.isDepthTexture){if(Me=v(S.format===ws,S.type),Qe)if(Ge)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Me,ne.width,ne.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,ne.width,ne.height,0,Ee,_e,null)}else if(pe){Ge&&Qe&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Me,ne.width,ne.height);for(let Ce=0;Ce<6;Ce++){et=re[Ce].mipmaps;for(let ot=0;ot<et.length;ot++){let Vt=et[ot];S.format!==fi?Ee!==null?Ge?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot,0,0,Vt.width,Vt.height,Ee,Vt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot,Me,Vt.width,Vt.height,0,Vt.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot,0,0,Vt.width,Vt.height,Ee,_e,Vt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot,Me,Vt.width,Vt.height,0,Ee,_e,Vt.data)}}}else{if(et=S.mipmaps,Ge&&Qe){et.length>0&&Be++;let Ce=Xe(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Me,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(B){Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,re[Ce].width,re[Ce].height,Ee,_e,re[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,re[Ce].width,re[Ce].height,0,Ee,_e,re[Ce].data);for(let ot=0;ot<et.length;ot++){let Xn=et[ot].image[Ce].image;Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot+1,0,0,Xn.width,Xn.height,Ee,_e,Xn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot+1,Me,Xn.width,Xn.height,0,Ee,_e,Xn.data)}}else{Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Ee,_e,re[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,Ee,_e,re[Ce]);for(let ot=0;ot<et.length;ot++){let Vt=et[ot];Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot+1,0,0,Ee,_e,Vt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot+1,Me,Ee,_e,Vt.image[Ce])}}}M(S)&&S.mipmapsAutoUpdate===!0&&y(n.TEXTURE_CUBE_MAP),ve.__version=oe.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function Ft(R,S,q,ue,oe,ve){let ye=r.convert(q.format,q.colorSpace),te=r.convert(q.type),se=A(q.internalFormat,ye,te,q.normalized,q.colorSpace),pe=i.get(S),B=i.get(q);if(B.__renderTarget=S,!pe.__hasExternalTextures){let re=Math.max(1,S.width>>ve),ne=Math.max(1,S.height>>ve);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,ve,se,re,ne,S.depth,0,ye,te,null):t.texImage2D(oe,ve,se,re,ne,0,ye,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,oe,B.__webglTexture,0,rt(S)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,oe,B.__webglTexture,ve),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Cn(R,S,q){if(n.bindRenderbuffer(n.RENDERBUFFER,R),S.depthBuffer){let ue=S.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,ve=v(S.stencilBuffer,oe),ye=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,rt(S),ve,S.width,S.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,rt(S),ve,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,ve,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ye,n.RENDERBUFFER,R)}else{let ue=S.textures;for(let oe=0;oe<ue.length;oe++){let ve=ue[oe],ye=r.convert(ve.format,ve.colorSpace),te=r.convert(ve.type),se=A(ve.internalFormat,ye,te,ve.normalized,ve.colorSpace);we(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,rt(S),se,S.width,S.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,rt(S),se,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,se,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function xt(R,S,q){let ue=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(S.depthTexture);oe.__renderTarget=S;let ve=ue?S.depthTexture.image[0]:S.depthTexture.image;(!oe.__webglTexture||ve.width!==S.width||ve.height!==S.height)&&(ve.width=S.width,ve.height=S.height,S.depthTexture.needsUpdate=!0),ue?xe(S.depthTexture,0):me(S.depthTexture,0);let ye=oe.__webglTexture,te=rt(S),se=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,pe=S.depthTexture.format===ws?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===vs)we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,ye,0);else if(S.depthTexture.format===ws)we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Mn(R){let S=i.get(R),q=R.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==R.depthTexture){let ue=R.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ue){let oe=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),S.__depthDisposeCallback=oe}S.__boundDepthTexture=ue}if(R.depthTexture&&!S.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)xt(S.__webglFramebuffer[ue],R,ue);else R.texture.mipmaps.length>0?xt(S.__webglFramebuffer[0],R,0):xt(S.__webglFramebuffer,R,0);else if(q){S.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[ue]),S.__webglDepthbuffer[ue]===void 0)S.__webglDepthbuffer[ue]=n.createRenderbuffer(),Cn(S.__webglDepthbuffer[ue],R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=S.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ve)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),Cn(S.__webglDepthbuffer,R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ve)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function en(R,S,q){let ue=i.get(R);S!==void 0&&Ft(ue.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&Mn(R)}function hn(R){let S=R.texture,q=i.get(R),ue=i.get(S);R.addEventListener("dispose",O),U(R);let oe=R.textures,ve=R.isWebGLCubeRenderTarget===!0,ye=oe.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=S.version,o.memory.textures++),ve){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(S.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let se=0;se<S.mipmaps.length;se++)q.__webglFramebuffer[te][se]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(S.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<S.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ye)for(let te=0,se=oe.length;te<se;te++){let pe=i.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&we(R)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let se=oe[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let pe=r.convert(se.format,se.colorSpace),B=r.convert(se.type),re=A(se.internalFormat,pe,B,se.normalized,se.colorSpace,R.isXRRenderTarget===!0),ne=rt(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),Cn(q.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ve){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),Je(n.TEXTURE_CUBE_MAP,S);for(let te=0;te<6;te++)if(S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)Ft(q.__webglFramebuffer[te][se],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else Ft(q.__webglFramebuffer[te],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);M(S)?y(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let te=0,se=oe.length;te<se;te++){let pe=oe[te],B=i.get(pe),re=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(re=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,B.__webglTexture),Je(re,pe),Ft(q.__webglFramebuffer,R,pe,n.COLOR_ATTACHMENT0+te,re,0),M(pe)&&y(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),Je(te,S),S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)Ft(q.__webglFramebuffer[se],R,S,n.COLOR_ATTACHMENT0,te,se);else Ft(q.__webglFramebuffer,R,S,n.COLOR_ATTACHMENT0,te,0);M(S)?y(te):S.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Mn(R)}function k(R){let S=R.textures;for(let q=0,ue=S.length;q<ue;q++){let oe=S[q];if(M(oe)&&oe.mipmapsAutoUpdate===!0){let ve=C(R),ye=i.get(oe).__webglTexture;t.bindTexture(ve,ye),y(ve),t.unbindTexture()}}}let Re=[];function $e(R){if(R.samples>0){if(we(R)===!1){let S=R.textures,q=R.width,ue=R.height,oe=n.COLOR_BUFFER_BIT,ve=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=i.get(R),te=S.length>1;if(te)for(let pe=0;pe<S.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let pe=0;pe<S.length;pe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let B=i.get(S[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,B,0)}n.blitFramebuffer(0,0,q,ue,0,0,q,ue,oe,n.NEAREST),l===!0&&(Re.length=0,Re.push(n.COLOR_ATTACHMENT0+pe),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Re.push(ve),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<S.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let B=i.get(S[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,B,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let S=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function rt(R){return Math.min(s.maxSamples,R.samples)}function we(R){let S=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Bt(R){let S=o.render.frame;u.get(R)!==S&&(u.set(R,S),R.update())}function Ve(R,S){let q=R.colorSpace,ue=R.format,oe=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==ra&&q!==Es&&(pt.getTransfer(q)===Tt?(ue!==fi||oe!==hi)&&Ye("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):nt("WebGLTextures: Unsupported texture color space:",q)),S}function Xe(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=fe,this.setTexture2D=me,this.setTexture2DArray=ge,this.setTexture3D=Se,this.setTextureCube=xe,this.rebindTextures=en,this.setupRenderTarget=hn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=$e,this.setupDepthRenderbuffer=Mn,this.setupFrameBufferTexture=Ft,this.useMultisampledRTT=we,this.dispose=W}function o1(n,e){function t(i,s=Es){let r,o=pt.getTransfer(s);if(i===hi)return n.UNSIGNED_BYTE;if(i===pc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===mc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Sf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===wf)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===bf)return n.BYTE;if(i===Mf)return n.SHORT;if(i===vo)return n.UNSIGNED_SHORT;if(i===dc)return n.INT;if(i===ki)return n.UNSIGNED_INT;if(i===zi)return n.FLOAT;if(i===Hi)return n.HALF_FLOAT;if(i===Ef)return n.ALPHA;if(i===Tf)return n.RGB;if(i===fi)return n.RGBA;if(i===vs)return n.DEPTH_COMPONENT;if(i===ws)return n.DEPTH_STENCIL;if(i===Af)return n.RED;if(i===gc)return n.RED_INTEGER;if(i===js)return n.RG;if(i===_c)return n.RG_INTEGER;if(i===xc)return n.RGBA_INTEGER;if(i===Sa||i===wa||i===Ea||i===Ta)if(o===Tt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Sa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ea)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ta)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Sa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===wa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ea)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ta)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===vc||i===yc||i===bc||i===Mc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===vc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===yc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===bc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Mc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Sc||i===wc||i===Ec||i===Tc||i===Ac||i===Aa||i===Cc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Sc||i===wc)return o===Tt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Ec)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Tc)return r.COMPRESSED_R11_EAC;if(i===Ac)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Aa)return r.COMPRESSED_RG11_EAC;if(i===Cc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Rc||i===Pc||i===Ic||i===Lc||i===Dc||i===Nc||i===Fc||i===Uc||i===Oc||i===Bc||i===kc||i===zc||i===Hc||i===Vc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Rc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Pc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Ic)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Lc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Dc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Nc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Fc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Uc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Oc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Bc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===kc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===zc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Hc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Vc)return o===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Gc||i===Wc||i===Xc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Gc)return o===Tt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Wc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Xc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===qc||i===$c||i===Ca||i===Yc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===qc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===$c)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ca)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Yc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===br?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var a1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,l1=`
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

}`,Jf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new _a(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Mi({vertexShader:a1,fragmentShader:l1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new yt(new _r(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Kf=class extends ts{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,d=null,h=null,f=null,p=null,_=typeof XRWebGLBinding<"u",m=new Jf,g={},x=t.getContextAttributes(),M=null,y=null,C=[],A=[],v=new _t,w=null,U=null,L=new Kn;L.viewport=new $t;let I=new Kn;I.viewport=new $t;let O=[L,I],z=new cc,N=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=C[ee];return me===void 0&&(me=new co,C[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=C[ee];return me===void 0&&(me=new co,C[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=C[ee];return me===void 0&&(me=new co,C[ee]=me),me.getHandSpace()};function $(ee){let me=A.indexOf(ee.inputSource);if(me===-1)return;let ge=C[me];ge!==void 0&&(ge.update(ee.inputSource,ee.frame,c||o),ge.dispatchEvent({type:ee.type,data:ee.inputSource}))}function V(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",le);for(let ee=0;ee<C.length;ee++){let me=A[ee];me!==null&&(A[ee]=null,C[ee].disconnect(me))}N=null,W=null,m.reset();for(let ee in g)delete g[ee];if(e.setRenderTarget(M),f=null,h=null,d=null,s=null,y=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(w),e.setSize(v.width,v.height,!1),U!==null){let ee=U.camera;ee.fov=U.fov,ee.zoom=U.zoom,ee.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Ye("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Ye("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return h!==null?h:f},this.getBinding=function(){return d===null&&_&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",V),s.addEventListener("inputsourceschange",le),x.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(v),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,Se=null,xe=null;x.depth&&(xe=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=x.stencil?ws:vs,Se=x.stencil?br:ki);let He={colorFormat:t.RGBA8,depthFormat:xe,scaleFactor:r};d=this.getBinding(),h=d.createProjectionLayer(He),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),y=new li(h.textureWidth,h.textureHeight,{format:fi,type:hi,depthTexture:new Ms(h.textureWidth,h.textureHeight,Se,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let ge={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),y=new li(f.framebufferWidth,f.framebufferHeight,{format:fi,type:hi,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function le(ee){for(let me=0;me<ee.removed.length;me++){let ge=ee.removed[me],Se=A.indexOf(ge);Se>=0&&(A[Se]=null,C[Se].disconnect(ge))}for(let me=0;me<ee.added.length;me++){let ge=ee.added[me],Se=A.indexOf(ge);if(Se===-1){for(let He=0;He<C.length;He++)if(He>=A.length){A.push(ge),Se=He;break}else if(A[He]===null){A[He]=ge,Se=He;break}if(Se===-1)break}let xe=C[Se];xe&&xe.connect(ge)}}function J(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ge=ee.far;m.texture!==null&&(m.depthNear>0&&(me=m.depthNear),m.depthFar>0&&(ge=m.depthFar)),z.near=I.near=L.near=me,z.far=I.far=L.far=ge,(N!==z.near||W!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),N=z.near,W=z.far),z.layers.mask=ee.layers.mask|6,L.layers.mask=z.layers.mask&-5,I.layers.mask=z.layers.mask&-3;let Se=ee.parent,xe=z.cameras;J(z,Se);for(let He=0;He<xe.length;He++)J(xe[He],Se);z.projectionMatrix.copy(L.projectionMatrix),z.projectionMatrixInverse.copy(L.projectionMatrixInverse),U===null&&ee.isPerspectiveCamera&&(U={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,z,Se)};function Q(ee,me,ge){ge===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ge.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Gl*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(h===null&&f===null))return l},this.setFoveation=function(ee){l=ee,h!==null&&(h.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(z)},this.getCameraTexture=function(ee){return g[ee]};let ie=null;function fe(ee,me){if(u=me.getViewerPose(c||o),p=me,u!==null){let ge=u.views;f!==null&&(e.setRenderTargetFramebuffer(y,f.framebuffer),e.setRenderTarget(y));let Se=!1;ge.length!==z.cameras.length&&(z.cameras.length=0,Se=!0);for(let Fe=0;Fe<ge.length;Fe++){let Je=ge[Fe],Ze=null;if(f!==null)Ze=f.getViewport(Je);else{let Ot=d.getViewSubImage(h,Je);Ze=Ot.viewport,Fe===0&&(e.setRenderTargetTextures(y,Ot.colorTexture,Ot.depthStencilTexture),e.setRenderTarget(y))}let je=O[Fe];je===void 0&&(je=new Kn,je.layers.enable(Fe),je.viewport=new $t,O[Fe]=je),je.matrix.fromArray(Je.transform.matrix),je.matrix.decompose(je.position,je.quaternion,je.scale),je.projectionMatrix.fromArray(Je.projectionMatrix),je.projectionMatrixInverse.copy(je.projectionMatrix).invert(),je.viewport.set(Ze.x,Ze.y,Ze.width,Ze.height),Fe===0&&(z.matrix.copy(je.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),Se===!0&&z.cameras.push(je)}let xe=s.enabledFeatures;if(xe&&xe.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){d=i.getBinding();let Fe=d.getDepthInformation(ge[0]);Fe&&Fe.isValid&&Fe.texture&&m.init(Fe,s.renderState)}if(xe&&xe.includes("camera-access")&&_){e.state.unbindTexture(),d=i.getBinding();for(let Fe=0;Fe<ge.length;Fe++){let Je=ge[Fe].camera;if(Je){let Ze=g[Je];Ze||(Ze=new _a,g[Je]=Ze);let je=d.getCameraImage(Je);Ze.sourceTexture=je}}}}for(let ge=0;ge<C.length;ge++){let Se=A[ge],xe=C[ge];Se!==null&&xe!==void 0&&xe.update(Se,me,c||o)}ie&&ie(ee,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),p=null}let he=new Fg;he.setAnimationLoop(fe),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},c1=new vt,Xg=new it;Xg.set(-1,0,0,0,1,0,0,0,1);function u1(n,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,Bf(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,x,M,y){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),d(m,g)):g.isMeshPhongMaterial?(r(m,g),u(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),h(m,g),g.isMeshPhysicalMaterial&&f(m,g,y)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),_(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,x,M):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===kn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===kn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let x=e.get(g),M=x.envMap,y=x.envMapRotation;M&&(m.envMap.value=M,m.envMapRotation.value.setFromMatrix4(c1.makeRotationFromEuler(y)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Xg),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,x,M){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*x,m.scale.value=M*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function u(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function d(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function h(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,x){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===kn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function _(m,g){let x=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function h1(n,e,t,i){let s={},r={};function o(x,M){let y=M.program;i.uniformBlockBinding(x,y,s[x.id])}function a(x,M){let y=s[x.id];y===void 0&&(p(x),y=l(x),s[x.id]=y,x.addEventListener("dispose",m));let C=M.program;i.updateUBOMapping(x,C);let A=e.render.frame;r[x.id]!==A&&(c(x),r[x.id]=A)}function l(x){let M=n.createBuffer(),y=x.__size,C=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,M),n.bufferData(n.UNIFORM_BUFFER,y,C),n.bindBuffer(n.UNIFORM_BUFFER,null),M}function c(x){let M=s[x.id],y=x.uniforms,C=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,M);for(let A=0,v=y.length;A<v;A++){let w=y[A];if(Array.isArray(w))for(let U=0,L=w.length;U<L;U++)u(w[U],A,U,C);else u(w,A,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,M,y,C){if(h(x,M,y,C)===!0){let A=x.__offset,v=x.value;if(Array.isArray(v)){let w=0;for(let U=0;U<v.length;U++){let L=v[U],I=_(L,!0);d(L,x.__data,w),w+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else d(v,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,x.__data)}}function d(x,M,y){typeof x=="number"||typeof x=="boolean"?M[y]=x:x.isMatrix3?(M[y]=x.elements[0],M[y+1]=x.elements[1],M[y+2]=x.elements[2],M[y+3]=0,M[y+4]=x.elements[3],M[y+5]=x.elements[4],M[y+6]=x.elements[5],M[y+7]=0,M[y+8]=x.elements[6],M[y+9]=x.elements[7],M[y+10]=x.elements[8],M[y+11]=0):ArrayBuffer.isView(x)?M.set(x.subarray(0,M.length-y),y):x.toArray(M,y)}function h(x,M,y,C){let A=x.value,v=M+"_"+y;if(Array.isArray(A)){C[v]===void 0&&(C[v]=[]);let w=C[v],U=!1;for(let L=0;L<A.length;L++)f(A[L],w,L)===!0&&(U=!0);return U}return f(A,C,v)}function f(x,M,y){if(M[y]===void 0)return typeof x=="number"||typeof x=="boolean"?M[y]=x:ArrayBuffer.isView(x)?M[y]=x.slice():M[y]=x.clone(),!0;{let C=M[y];if(typeof x=="number"||typeof x=="boolean"){if(C!==x)return M[y]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(C.equals(x)===!1)return C.copy(x),!0}}return!1}function p(x){let M=x.uniforms,y=0,C=16;for(let v=0,w=M.length;v<w;v++){let U=Array.isArray(M[v])?M[v]:[M[v]];for(let L=0,I=U.length;L<I;L++){let O=U[L],z=Array.isArray(O.value)?O.value:[O.value],N=Array.isArray(M[v])||Array.isArray(O.value),W=y;for(let V=0,le=z.length;V<le;V++){let J=z[V],Q=_(J,N),ie=y%C,fe=ie%Q.boundary,he=ie+fe;y+=fe,he!==0&&C-he<Q.storage&&(y+=C-he),V===0&&(W=y),y+=Q.storage}let $=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new $((y-W)/Float32Array.BYTES_PER_ELEMENT),O.__offset=W}}let A=y%C;return A>0&&(y+=C-A),x.__size=y,x.__cache={},this}function _(x,M){let y={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(y.boundary=4,y.storage=4):x.isVector2?(y.boundary=8,y.storage=8):x.isVector3||x.isColor?(y.boundary=16,y.storage=12):x.isVector4?(y.boundary=16,y.storage=16):x.isMatrix3?(y.boundary=16,y.storage=48):x.isMatrix4?(y.boundary=16,y.storage=64):x.isTexture?Ye("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(y.boundary=16,y.storage=x.byteLength):Ye("WebGLRenderer: Unsupported uniform value type.",x),M===!0&&(y.boundary=16,y.storage=Math.ceil(y.storage/16)*16),y}function m(x){let M=x.target;M.removeEventListener("dispose",m),n.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function g(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:g}}var f1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),is=null;function d1(){return is===null&&(is=new uo(f1,16,16,js,Hi),is.name="DFG_LUT",is.minFilter=Bn,is.magFilter=Bn,is.wrapS=es,is.wrapT=es,is.generateMipmaps=!1,is.needsUpdate=!0),is}var Qc=class{constructor(e={}){let{canvas:t=rg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:h=!1,outputBufferType:f=hi}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let _=f,m=new Set([xc,_c,gc]),g=new Set([hi,ki,vo,br,pc,mc]),x=new Uint32Array(4),M=new Int32Array(4),y={textures:[],min:[],max:[],resolution:[]},C=null,A=null,v=[],w=[],U=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ns,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,I=!1,O=null,z=null,N=null,W=null;this._outputColorSpace=Jn;let $=0,V=0,le=null,J=-1,Q=null,ie=new $t,fe=new $t,he=null,ee=new at(0),me=0,ge=t.width,Se=t.height,xe=1,He=null,qe=null,Fe=new $t(0,0,ge,Se),Je=new $t(0,0,ge,Se),Ze=!1,je=new bs,Ot=new $l,Ct=!1,un=!1,Ft=new vt,Cn=new G,xt=new $t,Mn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},en=!1;function hn(){return le===null?xe:1}let k=i;function Re(T,H){return t.getContext(T,H)}let $e,rt,we,Bt,Ve,Xe,R,S,q,ue,oe,ve,ye,te,se,pe,B,re,ne,Ee,_e,Me,Ge;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",et,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),k===null){let H="webgl2";if(k=Re(H,T),k===null)throw Re(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Qe()}catch(T){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),nt("WebGLRenderer: "+T.message),T}function Qe(){$e=new wS(k),$e.init(),_e=new o1(k,$e),rt=new dS(k,$e,e,_e),we=new s1(k,$e),rt.reversedDepthBuffer&&h&&we.buffers.depth.setReversed(!0),z=k.createFramebuffer(),N=k.createFramebuffer(),W=k.createFramebuffer(),Bt=new AS(k),Ve=new Ww,Xe=new r1(k,$e,we,Ve,rt,_e,Bt),R=new SS(L),S=new Ry(k),Me=new hS(k,S),q=new ES(k,S,Bt,Me),ue=new RS(k,q,S,Me,Bt),re=new CS(k,rt,Xe),se=new pS(Ve),oe=new Gw(L,R,$e,rt,Me,se),ve=new u1(L,Ve),ye=new qw,te=new jw($e),B=new uS(L,R,we,ue,p,l),pe=new i1(L,ue,rt),Ge=new h1(k,Bt,rt,we),ne=new fS(k,$e,Bt),Ee=new TS(k,$e,Bt),Bt.programs=oe.programs,L.capabilities=rt,L.extensions=$e,L.properties=Ve,L.renderLists=ye,L.shadowMap=pe,L.state=we,L.info=Bt}_!==hi&&(U=new IS(_,t.width,t.height,a,s,r));let ce=new Kf(L,k);this.xr=ce,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let T=$e.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=$e.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return xe},this.setPixelRatio=function(T){T!==void 0&&(xe=T,this.setSize(ge,Se,!1))},this.getSize=function(T){return T.set(ge,Se)},this.setSize=function(T,H,j=!0){if(ce.isPresenting){Ye("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=T,Se=H,t.width=Math.floor(T*xe),t.height=Math.floor(H*xe),j===!0&&(t.style.width=T+"px",t.style.height=H+"px"),U!==null&&U.setSize(t.width,t.height),this.setViewport(0,0,T,H)},this.getDrawingBufferSize=function(T){return T.set(ge*xe,Se*xe).floor()},this.setDrawingBufferSize=function(T,H,j){ge=T,Se=H,xe=j,t.width=Math.floor(T*j),t.height=Math.floor(H*j),this.setViewport(0,0,T,H)},this.setEffects=function(T){if(_===hi){nt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let H=0;H<T.length;H++)if(T[H].isOutputPass===!0){Ye("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(ie)},this.getViewport=function(T){return T.copy(Fe)},this.setViewport=function(T,H,j,Y){T.isVector4?Fe.set(T.x,T.y,T.z,T.w):Fe.set(T,H,j,Y),we.viewport(ie.copy(Fe).multiplyScalar(hn()).round())},this.getScissor=function(T){return T.copy(Je)},this.setScissor=function(T,H,j,Y){T.isVector4?Je.set(T.x,T.y,T.z,T.w):Je.set(T,H,j,Y),we.scissor(fe.copy(Je).multiplyScalar(hn()).round())},this.getScissorTest=function(){return Ze},this.setScissorTest=function(T){we.setScissorTest(Ze=T)},this.setOpaqueSort=function(T){He=T},this.setTransparentSort=function(T){qe=T},this.getClearColor=function(T){return T.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(T=!0,H=!0,j=!0){let Y=0;if(T){let Z=!1;if(le!==null){let Te=le.texture.format;Z=m.has(Te)}if(Z){let Te=le.texture.type,Pe=g.has(Te),Ae=B.getClearColor(),Ie=B.getClearAlpha(),ze=Ae.r,tt=Ae.g,ut=Ae.b;Pe?(x[0]=ze,x[1]=tt,x[2]=ut,x[3]=Ie,k.clearBufferuiv(k.COLOR,0,x)):(M[0]=ze,M[1]=tt,M[2]=ut,M[3]=Ie,k.clearBufferiv(k.COLOR,0,M))}else Y|=k.COLOR_BUFFER_BIT}H&&(Y|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&k.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),O=T},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),B.dispose(),ye.dispose(),te.dispose(),Xe.dispose(),Ve.dispose(),R.dispose(),ue.dispose(),q.dispose(),Me.dispose(),Ge.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",ja),ce.removeEventListener("sessionend",qi),ls.stop()};function Be(T){T.preventDefault(),Uf("WebGLRenderer: Context Lost."),I=!0}function et(){Uf("WebGLRenderer: Context Restored."),I=!1;let T=Bt.autoReset,H=pe.enabled,j=pe.autoUpdate,Y=pe.needsUpdate,Z=pe.type;Qe(),Bt.autoReset=T,pe.enabled=H,pe.autoUpdate=j,pe.needsUpdate=Y,pe.type=Z}function Ce(T){nt("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function ot(T){let H=T.target;H.removeEventListener("dispose",ot),Vt(H)}function Vt(T){Xn(T),Ve.remove(T)}function Xn(T){let H=Ve.get(T).programs;H!==void 0&&(H.forEach(function(j){oe.releaseProgram(j)}),T.isShaderMaterial&&oe.releaseShaderCache(T))}this.renderBufferDirect=function(T,H,j,Y,Z,Te){H===null&&(H=Mn);let Pe=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ae=qo(T,H,j,Y,Z);we.setMaterial(Y,Pe);let Ie=j.index,ze=1;if(Y.wireframe===!0){if(Ie=q.getWireframeAttribute(j),Ie===void 0)return;ze=2}let tt=j.drawRange,ut=j.attributes.position,ke=tt.start*ze,ht=(tt.start+tt.count)*ze;Te!==null&&(ke=Math.max(ke,Te.start*ze),ht=Math.min(ht,(Te.start+Te.count)*ze)),Ie!==null?(ke=Math.max(ke,0),ht=Math.min(ht,Ie.count)):ut!=null&&(ke=Math.max(ke,0),ht=Math.min(ht,ut.count));let jt=ht-ke;if(jt<0||jt===1/0)return;Me.setup(Z,Y,Ae,j,Ie);let Rt,Pt=ne;if(Ie!==null&&(Rt=S.get(Ie),Pt=Ee,Pt.setIndex(Rt)),Z.isMesh)Y.wireframe===!0?(we.setLineWidth(Y.wireframeLinewidth*hn()),Pt.setMode(k.LINES)):Pt.setMode(k.TRIANGLES);else if(Z.isLine){let Sn=Y.linewidth;Sn===void 0&&(Sn=1),we.setLineWidth(Sn*hn()),Z.isLineSegments?Pt.setMode(k.LINES):Z.isLineLoop?Pt.setMode(k.LINE_LOOP):Pt.setMode(k.LINE_STRIP)}else Z.isPoints?Pt.setMode(k.POINTS):Z.isSprite&&Pt.setMode(k.TRIANGLES);if(Z.isBatchedMesh)if($e.get("WEBGL_multi_draw"))Pt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let Sn=Z._multiDrawStarts,Ue=Z._multiDrawCounts,fn=Z._multiDrawCount,dt=Ie?S.get(Ie).bytesPerElement:1,us=Ve.get(Y).currentProgram.getUniforms();for(let dn=0;dn<fn;dn++)us.setValue(k,"_gl_DrawID",dn),Pt.render(Sn[dn]/dt,Ue[dn])}else if(Z.isInstancedMesh)Pt.renderInstances(ke,jt,Z.count);else if(j.isInstancedBufferGeometry){let Sn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ue=Math.min(j.instanceCount,Sn);Pt.renderInstances(ke,jt,Ue)}else Pt.render(ke,jt)};function Go(T,H,j,Y){O!==null&&T.isNodeMaterial&&O.setObject(Y,T),Ct===!0&&se.setState(T,j,!1),T.transparent===!0&&T.side===Nn&&T.forceSinglePass===!1?(T.side=kn,T.needsUpdate=!0,$i(T,H,Y),T.side=Si,T.needsUpdate=!0,$i(T,H,Y),T.side=Nn):$i(T,H,Y)}this.compile=function(T,H,j=null){j===null&&(j=T),O!==null&&O.renderStart(T,H,j),A=te.get(j),A.init(H),w.push(A),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(H.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),T!==j&&T.traverseVisible(function(Z){Z.isLight&&Z.layers.test(H.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),A.setupLights(),O!==null&&O.updateLights(A.state.lightsArray),un=this.localClippingEnabled,Ct=se.init(this.clippingPlanes,un),Ct===!0&&se.setGlobalState(this.clippingPlanes,H),O!==null&&pe.render(A.state.shadowsArray,j,H);let Y=new Set;return T.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Te=Z.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let Ae=Te[Pe];Go(Ae,j,H,Z),Y.add(Ae)}else Go(Te,j,H,Z),Y.add(Te)}),A=w.pop(),O!==null&&O.renderEnd(),Y},this.compileAsync=function(T,H,j=null){let Y=this.compile(T,H,j);return new Promise(Z=>{function Te(){if(Y.forEach(function(Pe){let Ie=Ve.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&Y.delete(Pe)}),Y.size===0){Z(T);return}setTimeout(Te,10)}$e.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let Nr=null;function dh(T){Nr&&Nr(T)}function ja(){ls.stop()}function qi(){ls.start()}let ls=new Fg;ls.setAnimationLoop(dh),typeof self<"u"&&ls.setContext(self),this.setAnimationLoop=function(T){Nr=T,ce.setAnimationLoop(T),T===null?ls.stop():ls.start()},ce.addEventListener("sessionstart",ja),ce.addEventListener("sessionend",qi),this.render=function(T,H){if(H!==void 0&&H.isCamera!==!0){nt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;O!==null&&O.renderStart(T,H);let j=ce.enabled===!0&&ce.isPresenting===!0,Y=U!==null&&(le===null||j)&&U.begin(L,le);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(H),H=ce.getCamera()),T.isScene===!0&&T.onBeforeRender(L,T,H,le),A=te.get(T,w.length),A.init(H),A.state.textureUnits=Xe.getTextureUnits(),w.push(A),Ft.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?Ot.setFromArrayCamera(H):je.setFromProjectionMatrix(Ft,vi,H.reversedDepth),un=this.localClippingEnabled,Ct=se.init(this.clippingPlanes,un),C=ye.get(T,v.length),C.init(),v.push(C),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Pe=L.xr.getDepthSensingMesh();Pe!==null&&cs(Pe,H,-1/0,L.sortObjects)}cs(T,H,0,L.sortObjects),C.finish(),O!==null&&O.updateLights(A.state.lightsArray),L.sortObjects===!0&&C.sort(He,qe),en=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,en&&B.addToRenderList(C,T),this.info.autoReset===!0&&this.info.reset(),Ct===!0&&se.beginShadows();let Z=A.state.shadowsArray;if(pe.render(Z,T,H),Ct===!0&&se.endShadows(),(Y&&U.hasRenderPass())===!1){let Pe=C.opaque,Ae=C.transmissive;if(A.setupLights(),H.isArrayCamera){let Ie=H.cameras;if(Ae.length>0)for(let ze=0,tt=Ie.length;ze<tt;ze++){let ut=Ie[ze];Pi(Pe,Ae,T,ut)}en&&B.render(T);for(let ze=0,tt=Ie.length;ze<tt;ze++){let ut=Ie[ze];Wo(C,T,ut,ut.viewport)}}else Ae.length>0&&Pi(Pe,Ae,T,H),en&&B.render(T),Wo(C,T,H)}le!==null&&V===0&&(Xe.updateMultisampleRenderTarget(le),Xe.updateRenderTargetMipmap(le)),Y&&U.end(L),T.isScene===!0&&T.onAfterRender(L,T,H),Me.resetDefaultState(),J=-1,Q=null,w.pop(),w.length>0?(A=w[w.length-1],Xe.setTextureUnits(A.state.textureUnits),Ct===!0&&se.setGlobalState(L.clippingPlanes,A.state.camera)):A=null,v.pop(),v.length>0?C=v[v.length-1]:C=null,O!==null&&O.renderEnd()};function cs(T,H,j,Y){if(T.visible===!1)return;if(T.layers.test(H.layers)){if(T.isGroup)j=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(H);else if(T.isLight)A.pushLight(T),T.castShadow&&A.pushShadow(T);else if(T.isSprite){let Pe=H.isArrayCamera?Ot:je;if(!T.frustumCulled||T.intersectsFrustum(Pe)){Y&&xt.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Ft);let Ae=ue.update(T),Ie=T.material;Ie.visible&&C.push(T,Ae,Ie,j,xt.z,null,H)}}else if(T.isMesh||T.isLine||T.isPoints){let Pe=H.isArrayCamera?Ot:je;if(!T.frustumCulled||T.intersectsFrustum(Pe)){let Ae=ue.update(T),Ie=T.material;if(Y&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),xt.copy(T.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),xt.copy(Ae.boundingSphere.center)),xt.applyMatrix4(T.matrixWorld).applyMatrix4(Ft)),Array.isArray(Ie)){let ze=Ae.groups;for(let tt=0,ut=ze.length;tt<ut;tt++){let ke=ze[tt],ht=Ie[ke.materialIndex];ht&&ht.visible&&C.push(T,Ae,ht,j,xt.z,ke,H)}}else Ie.visible&&C.push(T,Ae,Ie,j,xt.z,null,H)}}}let Te=T.children;for(let Pe=0,Ae=Te.length;Pe<Ae;Pe++)cs(Te[Pe],H,j,Y)}function Wo(T,H,j,Y){let{opaque:Z,transmissive:Te,transparent:Pe}=T;A.setupLightsView(j),Ct===!0&&se.setGlobalState(L.clippingPlanes,j),Y&&we.viewport(ie.copy(Y)),Z.length>0&&tn(Z,H,j),Te.length>0&&tn(Te,H,j),Pe.length>0&&tn(Pe,H,j),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Pi(T,H,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[Y.id]===void 0){let ke=$e.has("EXT_color_buffer_half_float")||$e.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[Y.id]=new li(1,1,{generateMipmaps:!0,type:ke?Hi:hi,minFilter:Ss,samples:Math.max(4,rt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:pt.workingColorSpace})}let Te=A.state.transmissionRenderTarget[Y.id],Pe=Y.viewport||ie;Te.setSize(Pe.z*L.transmissionResolutionScale,Pe.w*L.transmissionResolutionScale);let Ae=L.getRenderTarget(),Ie=L.getActiveCubeFace(),ze=L.getActiveMipmapLevel();L.setRenderTarget(Te),L.getClearColor(ee),me=L.getClearAlpha(),me<1&&L.setClearColor(16777215,.5),L.clear(),en&&B.render(j);let tt=L.toneMapping;L.toneMapping=ns;let ut=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),A.setupLightsView(Y),Ct===!0&&se.setGlobalState(L.clippingPlanes,Y),tn(T,j,Y),Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te),$e.has("WEBGL_multisampled_render_to_texture")===!1){let ke=!1;for(let ht=0,jt=H.length;ht<jt;ht++){let Rt=H[ht],{object:Pt,geometry:Sn,material:Ue,group:fn}=Rt;if(Ue.side===Nn&&Pt.layers.test(Y.layers)){let dt=Ue.side;Ue.side=kn,Ue.needsUpdate=!0,an(Pt,j,Y,Sn,Ue,fn),Ue.side=dt,Ue.needsUpdate=!0,ke=!0}}ke===!0&&(Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te))}L.setRenderTarget(Ae,Ie,ze),L.setClearColor(ee,me),ut!==void 0&&(Y.viewport=ut),L.toneMapping=tt}function tn(T,H,j){let Y=H.isScene===!0?H.overrideMaterial:null;for(let Z=0,Te=T.length;Z<Te;Z++){let Pe=T[Z],{object:Ae,geometry:Ie,group:ze}=Pe,tt=Pe.material;tt.allowOverride===!0&&Y!==null&&(tt=Y),Ae.layers.test(j.layers)&&an(Ae,H,j,Ie,tt,ze)}}function an(T,H,j,Y,Z,Te){O!==null&&Z.isNodeMaterial&&O.setObject(T,Z),T.onBeforeRender(L,H,j,Y,Z,Te),T.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),Z.onBeforeRender(L,H,j,Y,T,Te),Z.transparent===!0&&Z.side===Nn&&Z.forceSinglePass===!1?(Z.side=kn,Z.needsUpdate=!0,L.renderBufferDirect(j,H,Y,Z,T,Te),Z.side=Si,Z.needsUpdate=!0,L.renderBufferDirect(j,H,Y,Z,T,Te),Z.side=Nn):L.renderBufferDirect(j,H,Y,Z,T,Te),T.onAfterRender(L,H,j,Y,Z,Te)}function ln(T){let H=0;for(let j of T)j.texture!==null&&H++;return H}function $i(T,H,j){H.isScene!==!0&&(H=Mn);let Y=Ve.get(T),Z=A.state.lights,Te=A.state.shadowsArray,Pe=Z.state.version,Ae=oe.getParameters(T,Z.state,Te,H,j,A.state.lightProbeGridArray),Ie=oe.getProgramCacheKey(Ae),ze=Y.programs;Y.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?H.environment:null,Y.fog=H.fog;let tt=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;Y.envMap=R.get(T.envMap||Y.environment,tt),Y.envMapRotation=Y.environment!==null&&T.envMap===null?H.environmentRotation:T.envMapRotation,ze===void 0&&(T.addEventListener("dispose",ot),ze=new Map,Y.programs=ze,Y.programVariants=new Map);let ut=ze.get(Ie);if(ut!==void 0){if(Y.currentProgram===ut&&Y.lightsStateVersion===Pe)return Xo(T,Ae),ut}else Ae.uniforms=oe.getUniforms(T),O!==null&&T.isNodeMaterial&&O.build(T,j,Ae),T.onBeforeCompile(Ae,L),ut=oe.acquireProgram(Ae,Ie),ze.set(Ie,ut),Y.uniforms=Ae.uniforms;let ke=Y.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(ke.clippingPlanes=se.uniform),Xo(T,Ae),Y.needsLights=Ls(T),Y.lightsStateVersion=Pe,Y.needsLights&&(ke.ambientLightColor.value=Z.state.ambient,ke.lightProbe.value=Z.state.probe,ke.sunLights.value=Z.state.sun,ke.sunLightShadows.value=Z.state.sunShadow,ke.directionalLights.value=Z.state.directional,ke.directionalLightShadows.value=Z.state.directionalShadow,ke.spotLights.value=Z.state.spot,ke.spotLightShadows.value=Z.state.spotShadow,ke.rectAreaLights.value=Z.state.rectArea,ke.ltc_1.value=Z.state.rectAreaLTC1,ke.ltc_2.value=Z.state.rectAreaLTC2,ke.pointLights.value=Z.state.point,ke.pointLightShadows.value=Z.state.pointShadow,ke.hemisphereLights.value=Z.state.hemi,ke.sunShadowMatrix.value=Z.state.sunShadowMatrix,ke.sunShadowCascade.value=Z.state.sunShadowCascade,ke.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,ke.spotLightMatrix.value=Z.state.spotLightMatrix,ke.spotLightMap.value=Z.state.spotLightMap,ke.pointShadowMatrix.value=Z.state.pointShadowMatrix),Y.numLightProbeGrids=ln(A.state.lightProbeGridArray),Y.currentProgram=ut,Y.uniformsList=null,ut}function ni(T,H,j,Y,Z){let Te=Ve.get(T),Pe=Te.currentProgram.id+","+Y+","+Z,Ae=Te.programVariants.get(Pe);return Ae===void 0?(Ae=$i(T,H,j),Te.programVariants.set(Pe,Ae)):(Te.currentProgram=Ae,Te.uniformsList=null,Te.outputColorSpace=Y,Te.toneMapping=Z),Ae}function Is(T){if(T.uniformsList===null){let H=T.currentProgram.getUniforms();T.uniformsList=yo.seqWithValue(H.seq,T.uniforms)}return T.uniformsList}function Xo(T,H){let j=Ve.get(T);j.outputColorSpace=H.outputColorSpace,j.batching=H.batching,j.batchingColor=H.batchingColor,j.instancing=H.instancing,j.instancingColor=H.instancingColor,j.instancingMorph=H.instancingMorph,j.skinning=H.skinning,j.morphTargets=H.morphTargets,j.morphNormals=H.morphNormals,j.morphColors=H.morphColors,j.morphTargetsCount=H.morphTargetsCount,j.numClippingPlanes=H.numClippingPlanes,j.numIntersection=H.numClipIntersection,j.vertexAlphas=H.vertexAlphas,j.vertexTangents=H.vertexTangents,j.toneMapping=H.toneMapping}function qo(T,H,j,Y,Z){H.isScene!==!0&&(H=Mn),Xe.resetTextureUnits();let Te=H.fog,Pe=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?H.environment:null,Ae=le===null?L.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:pt.workingColorSpace,Ie=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,ze=R.get(Y.envMap||Pe,Ie),tt=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,ut=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),ke=!!j.morphAttributes.position,ht=!!j.morphAttributes.normal,jt=!!j.morphAttributes.color,Rt=ns;Y.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Rt=L.toneMapping);let Pt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,Sn=Pt!==void 0?Pt.length:0,Ue=Ve.get(Y),fn=A.state.lights;if(Ct===!0&&(un===!0||T!==Q)){let It=T===Q&&Y.id===J;se.setState(Y,T,It)}let dt=!1,us=!1;Y.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==fn.state.version||Z.isBatchedMesh&&Ue.batching===!1||!Z.isBatchedMesh&&Ue.batching===!0||Z.isBatchedMesh&&Ue.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ue.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ue.instancing===!1||!Z.isInstancedMesh&&Ue.instancing===!0||Z.isSkinnedMesh&&Ue.skinning===!1||!Z.isSkinnedMesh&&Ue.skinning===!0||Z.isInstancedMesh&&Ue.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ue.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ue.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ue.instancingMorph===!1&&Z.morphTexture!==null||Ue.envMap!==ze||Y.fog===!0&&Ue.fog!==Te||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==se.numPlanes||Ue.numIntersection!==se.numIntersection)||Ue.vertexAlphas!==tt||Ue.vertexTangents!==ut||Ue.morphTargets!==ke||Ue.morphNormals!==ht||Ue.morphColors!==jt||Ue.morphTargetsCount!==Sn||Ue.numLightProbeGrids!==ln(A.state.lightProbeGridArray)?dt=!0:(Ue.outputColorSpace!==Ae||Ue.toneMapping!==Rt)&&(us=!0):(dt=!0,Ue.__version=Y.version);let dn=Ue.currentProgram;(dt===!0||us===!0)&&(dn=us===!0?ni(Y,H,Z,Ae,Rt):$i(Y,H,Z),O&&Y.isNodeMaterial&&O.onUpdateProgram(Y,dn,Ue));let Or=!1,Yi=!1,hs=!1,lt=dn.getUniforms(),nn=Ue.uniforms;if(we.useProgram(dn.program)&&(Or=!0,Yi=!0,hs=!0),Y.id!==J&&(J=Y.id,Yi=!0),Or||Q!==T){we.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),lt.setValue(k,"projectionMatrix",T.projectionMatrix),lt.setValue(k,"viewMatrix",T.matrixWorldInverse);let pn=lt.map.cameraPosition;pn!==void 0&&pn.setValue(k,Cn.setFromMatrixPosition(T.matrixWorld)),rt.logarithmicDepthBuffer&&lt.setValue(k,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&lt.setValue(k,"isOrthographic",T.isOrthographicCamera===!0),Q!==T&&(Q=T,Yi=!0,hs=!0)}if(Ue.needsLights&&(fn.state.sunShadowMap.length>0&&lt.setValue(k,"sunShadowMap",fn.state.sunShadowMap,Xe),fn.state.directionalShadowMap.length>0&&lt.setValue(k,"directionalShadowMap",fn.state.directionalShadowMap,Xe),fn.state.spotShadowMap.length>0&&lt.setValue(k,"spotShadowMap",fn.state.spotShadowMap,Xe),fn.state.pointShadowMap.length>0&&lt.setValue(k,"pointShadowMap",fn.state.pointShadowMap,Xe)),Z.isSkinnedMesh){lt.setOptional(k,Z,"bindMatrix"),lt.setOptional(k,Z,"bindMatrixInverse");let It=Z.skeleton;It&&(It.boneTexture===null&&It.computeBoneTexture(),lt.setValue(k,"boneTexture",It.boneTexture,Xe))}Z.isBatchedMesh&&(lt.setOptional(k,Z,"batchingTexture"),lt.setValue(k,"batchingTexture",Z._matricesTexture,Xe),lt.setOptional(k,Z,"batchingIdTexture"),lt.setValue(k,"batchingIdTexture",Z._indirectTexture,Xe),lt.setOptional(k,Z,"batchingColorTexture"),Z._colorsTexture!==null&&lt.setValue(k,"batchingColorTexture",Z._colorsTexture,Xe));let qn=j.morphAttributes;if((qn.position!==void 0||qn.normal!==void 0||qn.color!==void 0)&&re.update(Z,j,dn),(Yi||Ue.receiveShadow!==Z.receiveShadow)&&(Ue.receiveShadow=Z.receiveShadow,lt.setValue(k,"receiveShadow",Z.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&H.environment!==null&&(nn.envMapIntensity.value=H.environmentIntensity),nn.dfgLUT!==void 0&&(nn.dfgLUT.value=d1()),Yi){if(lt.setValue(k,"toneMappingExposure",L.toneMappingExposure),Ue.needsLights&&Fr(nn,hs),Te&&Y.fog===!0&&ve.refreshFogUniforms(nn,Te),ve.refreshMaterialUniforms(nn,Y,xe,Se,A.state.transmissionRenderTarget[T.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let It=y,pn=0;for(let Hn of A.state.lightProbeGridArray)Hn.texture!==null&&(It.textures[pn]=Hn.texture,It.min[pn]=Hn.boundingBox.min,It.max[pn]=Hn.boundingBox.max,It.resolution[pn]=Hn.resolution,pn++);for(let Hn in It)It[Hn].length=pn;nn.probesSH.value=It.textures,nn.probesMin.value=It.min,nn.probesMax.value=It.max,nn.probesResolution.value=It.resolution}yo.upload(k,Is(Ue),nn,Xe)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(yo.upload(k,Is(Ue),nn,Xe),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&lt.setValue(k,"center",Z.center),lt.setValue(k,"modelViewMatrix",Z.modelViewMatrix),lt.setValue(k,"normalMatrix",Z.normalMatrix),lt.setValue(k,"modelMatrix",Z.matrixWorld),Y.uniformsGroups!==void 0){let It=Y.uniformsGroups;for(let pn=0,Hn=It.length;pn<Hn;pn++){let Qa=It[pn];Ge.update(Qa,dn),Ge.bind(Qa,dn)}}return dn}function Fr(T,H){T.ambientLightColor.needsUpdate=H,T.lightProbe.needsUpdate=H,T.sunLights.needsUpdate=H,T.sunLightShadows.needsUpdate=H,T.directionalLights.needsUpdate=H,T.directionalLightShadows.needsUpdate=H,T.pointLights.needsUpdate=H,T.pointLightShadows.needsUpdate=H,T.spotLights.needsUpdate=H,T.spotLightShadows.needsUpdate=H,T.rectAreaLights.needsUpdate=H,T.hemisphereLights.needsUpdate=H}function Ls(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(T,H,j){let Y=Ve.get(T);Y.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Ve.get(T.texture).__webglTexture=H,Ve.get(T.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,H){let j=Ve.get(T);j.__webglFramebuffer=H,j.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(T,H=0,j=0){le=T,$=H,V=j;let Y=null,Z=!1,Te=!1;if(T){let Ae=Ve.get(T);if(Ae.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(k.FRAMEBUFFER,Ae.__webglFramebuffer),ie.copy(T.viewport),fe.copy(T.scissor),he=T.scissorTest,we.viewport(ie),we.scissor(fe),we.setScissorTest(he),J=-1;return}else if(Ae.__webglFramebuffer===void 0)Xe.setupRenderTarget(T);else if(Ae.__hasExternalTextures)Xe.rebindTextures(T,Ve.get(T.texture).__webglTexture,Ve.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let tt=T.depthTexture;if(Ae.__boundDepthTexture!==tt){if(tt!==null&&Ve.has(tt)&&(T.width!==tt.image.width||T.height!==tt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xe.setupDepthRenderbuffer(T)}}let Ie=T.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Te=!0);let ze=Ve.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(ze[H])?Y=ze[H][j]:Y=ze[H],Z=!0):T.samples>0&&Xe.useMultisampledRTT(T)===!1?Y=Ve.get(T).__webglMultisampledFramebuffer:Array.isArray(ze)?Y=ze[j]:Y=ze,ie.copy(T.viewport),fe.copy(T.scissor),he=T.scissorTest}else ie.copy(Fe).multiplyScalar(xe).floor(),fe.copy(Je).multiplyScalar(xe).floor(),he=Ze;if(j!==0&&(Y=z),we.bindFramebuffer(k.FRAMEBUFFER,Y)&&we.drawBuffers(T,Y),we.viewport(ie),we.scissor(fe),we.setScissorTest(he),Z){let Ae=Ve.get(T.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+H,Ae.__webglTexture,j)}else if(Te){let Ae=H;for(let Ie=0;Ie<T.textures.length;Ie++){let ze=Ve.get(T.textures[Ie]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Ie,ze.__webglTexture,j,Ae)}}else if(T!==null&&j!==0){let Ae=Ve.get(T.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Ae.__webglTexture,j)}J=-1};function Ur(T){let H=Ve.get(T);return(H.__readFormat!==T.format||H.__readType!==T.type)&&(H.__readFormat=T.format,H.__readType=T.type,H.__formatReadable=rt.textureFormatReadable(T.format),H.__typeReadable=rt.textureTypeReadable(T.type)),H}this.readRenderTargetPixels=function(T,H,j,Y,Z,Te,Pe,Ae=0){if(!(T&&T.isWebGLRenderTarget)){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=Ve.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){we.bindFramebuffer(k.FRAMEBUFFER,Ie);try{let ze=T.textures[Ae],tt=ze.format,ut=ze.type;T.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Ae);let ke=Ur(ze);if(ke.__formatReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ke.__typeReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=T.width-Y&&j>=0&&j<=T.height-Z&&k.readPixels(H,j,Y,Z,_e.convert(tt),_e.convert(ut),Te)}finally{let ze=le!==null?Ve.get(le).__webglFramebuffer:null;we.bindFramebuffer(k.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(T,H,j,Y,Z,Te,Pe,Ae=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=Ve.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(H>=0&&H<=T.width-Y&&j>=0&&j<=T.height-Z){we.bindFramebuffer(k.FRAMEBUFFER,Ie);let ze=T.textures[Ae],tt=ze.format,ut=ze.type;T.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Ae);let ke=Ur(ze);if(ke.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ke.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ht=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,ht),k.bufferData(k.PIXEL_PACK_BUFFER,Te.byteLength,k.STREAM_READ),k.readPixels(H,j,Y,Z,_e.convert(tt),_e.convert(ut),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let jt=le!==null?Ve.get(le).__webglFramebuffer:null;we.bindFramebuffer(k.FRAMEBUFFER,jt);let Rt=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await ag(k,Rt,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,ht),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Te),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(ht),k.deleteSync(Rt),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,H=null,j=0){let Y=Math.pow(2,-j),Z=Math.floor(T.image.width*Y),Te=Math.floor(T.image.height*Y),Pe=H!==null?H.x:0,Ae=H!==null?H.y:0;Xe.setTexture2D(T,0),k.copyTexSubImage2D(k.TEXTURE_2D,j,0,0,Pe,Ae,Z,Te),we.unbindTexture()},this.copyTextureToTexture=function(T,H,j=null,Y=null,Z=0,Te=0){let Pe,Ae,Ie,ze,tt,ut,ke,ht,jt,Rt=T.isCompressedTexture?T.mipmaps[Te]:T.image;if(j!==null)Pe=j.max.x-j.min.x,Ae=j.max.y-j.min.y,Ie=j.isBox3?j.max.z-j.min.z:1,ze=j.min.x,tt=j.min.y,ut=j.isBox3?j.min.z:0;else{let lt=Math.pow(2,-Z);Pe=Math.floor(Rt.width*lt),Ae=Math.floor(Rt.height*lt),T.isDataArrayTexture?Ie=Rt.depth:T.isData3DTexture?Ie=Math.floor(Rt.depth*lt):Ie=1,ze=0,tt=0,ut=0}Y!==null?(ke=Y.x,ht=Y.y,jt=Y.z):(ke=0,ht=0,jt=0);let Pt=_e.convert(H.format),Sn=_e.convert(H.type),Ue;H.isData3DTexture?(Xe.setTexture3D(H,0),Ue=k.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(Xe.setTexture2DArray(H,0),Ue=k.TEXTURE_2D_ARRAY):(Xe.setTexture2D(H,0),Ue=k.TEXTURE_2D),we.activeTexture(k.TEXTURE0),we.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,H.flipY),we.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),we.pixelStorei(k.UNPACK_ALIGNMENT,H.unpackAlignment);let fn=we.getParameter(k.UNPACK_ROW_LENGTH),dt=we.getParameter(k.UNPACK_IMAGE_HEIGHT),us=we.getParameter(k.UNPACK_SKIP_PIXELS),dn=we.getParameter(k.UNPACK_SKIP_ROWS),Or=we.getParameter(k.UNPACK_SKIP_IMAGES);we.pixelStorei(k.UNPACK_ROW_LENGTH,Rt.width),we.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Rt.height),we.pixelStorei(k.UNPACK_SKIP_PIXELS,ze),we.pixelStorei(k.UNPACK_SKIP_ROWS,tt),we.pixelStorei(k.UNPACK_SKIP_IMAGES,ut);let Yi=T.isDataArrayTexture||T.isData3DTexture,hs=H.isDataArrayTexture||H.isData3DTexture;if(T.isDepthTexture){let lt=Ve.get(T),nn=Ve.get(H),qn=Ve.get(lt.__renderTarget),It=Ve.get(nn.__renderTarget);we.bindFramebuffer(k.READ_FRAMEBUFFER,qn.__webglFramebuffer),we.bindFramebuffer(k.DRAW_FRAMEBUFFER,It.__webglFramebuffer);for(let pn=0;pn<Ie;pn++)Yi&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Ve.get(T).__webglTexture,Z,ut+pn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Ve.get(H).__webglTexture,Te,jt+pn)),k.blitFramebuffer(ze,tt,ze+Pe,tt+Ae,ke,ht,ke+Pe,ht+Ae,k.DEPTH_BUFFER_BIT,k.NEAREST);we.bindFramebuffer(k.READ_FRAMEBUFFER,null),we.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(Z!==0||T.isRenderTargetTexture||Ve.has(T)){let lt=Ve.get(T),nn=Ve.get(H);we.bindFramebuffer(k.READ_FRAMEBUFFER,N),we.bindFramebuffer(k.DRAW_FRAMEBUFFER,W);for(let qn=0;qn<Ie;qn++)Yi?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,lt.__webglTexture,Z,ut+qn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,lt.__webglTexture,Z),hs?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,nn.__webglTexture,Te,jt+qn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,nn.__webglTexture,Te),Z!==0?k.blitFramebuffer(ze,tt,ze+Pe,tt+Ae,ke,ht,ke+Pe,ht+Ae,k.COLOR_BUFFER_BIT,k.NEAREST):hs?k.copyTexSubImage3D(Ue,Te,ke,ht,jt+qn,ze,tt,Pe,Ae):k.copyTexSubImage2D(Ue,Te,ke,ht,ze,tt,Pe,Ae);we.bindFramebuffer(k.READ_FRAMEBUFFER,null),we.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else hs?T.isDataTexture||T.isData3DTexture?k.texSubImage3D(Ue,Te,ke,ht,jt,Pe,Ae,Ie,Pt,Sn,Rt.data):H.isCompressedArrayTexture?k.compressedTexSubImage3D(Ue,Te,ke,ht,jt,Pe,Ae,Ie,Pt,Rt.data):k.texSubImage3D(Ue,Te,ke,ht,jt,Pe,Ae,Ie,Pt,Sn,Rt):T.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Te,ke,ht,Pe,Ae,Pt,Sn,Rt.data):T.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Te,ke,ht,Rt.width,Rt.height,Pt,Rt.data):k.texSubImage2D(k.TEXTURE_2D,Te,ke,ht,Pe,Ae,Pt,Sn,Rt);we.pixelStorei(k.UNPACK_ROW_LENGTH,fn),we.pixelStorei(k.UNPACK_IMAGE_HEIGHT,dt),we.pixelStorei(k.UNPACK_SKIP_PIXELS,us),we.pixelStorei(k.UNPACK_SKIP_ROWS,dn),we.pixelStorei(k.UNPACK_SKIP_IMAGES,Or),Te===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&k.generateMipmap(Ue),we.unbindTexture()},this.initRenderTarget=function(T){Ve.get(T).__webglFramebuffer===void 0&&Xe.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Xe.setTextureCube(T,0):T.isData3DTexture?Xe.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Xe.setTexture2DArray(T,0):Xe.setTexture2D(T,0),we.unbindTexture()},this.resetState=function(){$=0,V=0,le=null,we.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return vi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=pt._getDrawingBufferColorSpace(e),t.unpackColorSpace=pt._getUnpackColorSpace()}};var Fa=1e30,p1="1e20",m1=`
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
`,g1=`
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
    base = vField > ${p1} ? noValue : texture2D(scale, vec2(clamp(fraction, 0.0, 1.0) * 0.99609375 + 0.001953125, 0.5)).rgb;
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
`,wi=class extends Mi{cuttable;constructor(e,t,i={},s){super({vertexShader:m1,fragmentShader:g1,defines:Object.fromEntries(t.map(r=>[r,""])),...i}),this.uniforms={cutPlane:e.cutPlane,deformation:e.deformation,limits:e.limits,scale:e.scale,noValue:e.noValue,pixelRatio:e.pixelRatio,colour:s??{value:new at},opacity:{value:1},useField:{value:!1},bias:{value:0}},this.cuttable=!t.includes("CAP")&&!t.includes("ON_PLANE")}get colour(){return this.uniforms.colour.value}set alpha(e){this.uniforms.opacity.value=e,this.transparent=e<1}set useField(e){this.uniforms.useField.value=e}set bias(e){this.uniforms.bias.value=e}set cut(e){!this.cuttable||e==="CUT"in this.defines||(e?this.defines.CUT="":delete this.defines.CUT,this.needsUpdate=!0)}};function qg(n){return{cutPlane:{value:new $t(0,0,1,0)},deformation:{value:0},limits:{value:new _t(0,1)},scale:{value:n},noValue:{value:new at("#9a9a9a")},lineColour:{value:new at("#1c2733")},edgeColour:{value:new at("#1c2733")},pixelRatio:{value:1}}}function jf(n,e){let t=e?["COPIES","DEFORMED"]:["COPIES"],i=(r,o)=>new wi(n,t,{side:r,colorWrite:!1,depthWrite:!1,depthTest:!1,stencilWrite:!0,stencilFunc:Zc,stencilFail:o,stencilZFail:o,stencilZPass:o}),s=(r,o,a=t)=>{let l=new wi(n,a,{depthWrite:!1},r);return l.alpha=o,l};return{surface:new wi(n,e?["COPIES","DEFORMED","FIELD","LIT"]:["COPIES","LIT"],{polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),features:s(n.lineColour,.55),edges:s(n.edgeColour,.3),stencilBack:i(kn,Rf),stencilFront:i(Si,Pf),section:new wi(n,["FIELD","CAP"],{side:Nn,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),sectionEdges:s(n.edgeColour,.34,["ON_PLANE"])}}function $g(n){return new wi(n,["CAP"],{side:Nn,stencilWrite:!0,stencilRef:0,stencilFunc:If,stencilFail:Ra,stencilZFail:Ra,stencilZPass:Ra})}var nu=class{group=new Qt;materials;#e=new on;#t;#n=null;#i;#s="";markLine=new mr(new on,new Ys({color:"#e07b1f",transparent:!0,depthTest:!1}));constructor(e){let t=new wi(e,["FIELD"],{side:Nn}),i=new wi(e,["FIELD"],{side:Nn,depthFunc:oo,depthWrite:!1});i.alpha=.5,t.useField=i.useField=!0,this.#i=i,this.materials=[t,i];let s=this.materials.map(r=>new yt(this.#e,r));for(let r of s)r.frustumCulled=!1,r.matrixAutoUpdate=!1,this.group.add(r);this.#t=s[1],this.#t.renderOrder=99999,s[0].renderOrder=5,this.markLine.geometry.setAttribute("position",new bt(new Float32Array(12),3)),this.markLine.frustumCulled=!1,this.markLine.matrixAutoUpdate=!1,this.markLine.renderOrder=25e4,this.markLine.visible=!1}mark(e,t){let i=e!==null&&t>=0&&t<e.count;if(!i&&!this.markLine.visible)return!1;if(this.markLine.visible=i,!i)return!0;let s=this.markLine.geometry.getAttribute("position");return s.array.set(e.corners.subarray(12*t,12*t+12)),s.needsUpdate=!0,!0}setBias(e){for(let t of this.materials)t.bias=e;this.#i.bias=0}setBehind(e){this.#t.visible=e}get contacts(){return this.#n}set(e,t,i){if(e===this.#n&&t===this.#s||(this.#n=e,this.#s=t,this.mark(null,-1),this.#e.dispose(),this.group.visible=e!==null,!e))return;let s=[];for(let l=0;l<e.count;l++)e.pressures[l]>0&&i(l)&&s.push(l);let r=new Float32Array(12*s.length),o=new Float32Array(4*s.length),a=new Uint32Array(6*s.length);s.forEach((l,c)=>{r.set(e.corners.subarray(12*l,12*l+12),12*c),o.fill(e.pressures[l],4*c,4*c+4);let u=4*c;a.set([u,u+1,u+2,u,u+2,u+3],6*c)}),this.#e.setAttribute("position",new bt(r,3)),this.#e.setAttribute("field",new bt(o,1)),this.#e.setIndex(new bt(a,1))}dispose(){this.#e.dispose(),this.markLine.geometry.dispose();for(let e of this.materials)e.dispose()}},Yg={Flank:0,Edge:1};function Oa(n,e,t){return t==="all"||n.zones[e]===(t==="edges"?Yg.Edge:Yg.Flank)}var _1=1.5;function Ua(n,e){return n.pressures.reduce((t,i,s)=>Oa(n,s,e)?Math.max(t,i):t,0)}function Zg(n){let e=Ua(n,"flanks");return e>0&&Ua(n,"all")>_1*e}function Jg(n){let e=new Map,t=n.corners;for(let i=0;i<n.count;i++){let s=12*i,r=t[s+6]-t[s],o=t[s+7]-t[s+1],a=t[s+8]-t[s+2],l=t[s+9]-t[s+3],c=t[s+10]-t[s+4],u=t[s+11]-t[s+5],d=.5*Math.hypot(o*u-a*c,a*l-r*u,r*c-o*l),h=`${n.parts[2*i]} ${n.parts[2*i+1]}`;e.set(h,(e.get(h)??0)+n.pressures[i]*d)}return e}var iu=class{constructor(e){this.core=e}core;playing=!1;#e=0;toggle(){this.playing?this.stop():this.start()}start(){let e=this.core.positions?.list.length??0;this.playing||e<2||(this.playing=!0,this.play(++this.#e),this.core.changed(!1))}stop(){this.playing&&(this.playing=!1,this.#e++,this.core.changed(!1))}step(e){this.stop();let t=this.next(e,!0);t!==null&&this.core.goTo(t)}next(e,t){let i=this.core.positions?.list.length??0;if(i===0)return null;let s=this.core.state.position+e;return s>=0&&s<i?s:t?(s+i)%i:null}async play(e){let{core:t}=this,i=t.positions?.list.length??0;for(!t.state.animation.loop&&t.state.position===i-1&&await t.goTo(0);e===this.#e;){let s=performance.now()+1e3/Math.max(.1,t.state.animation.speed),r=this.next(1,t.state.animation.loop);if(r===null)break;if(await t.positions?.load(r).catch(()=>null),await new Promise(o=>setTimeout(o,Math.max(0,s-performance.now()))),e!==this.#e)return;await t.goTo(r),await new Promise(requestAnimationFrame)}e===this.#e&&this.stop()}};var Kg="CALYXARR";var Kt=class extends Error{constructor(t,i){super(`${t}: ${i}`);this.file=t;this.reason=i;this.name="FileError"}file;reason},Mo=class n{constructor(e,t,i,s){this.name=e;this.header=t;this.buffer=i;this.start=s}name;header;buffer;start;static parse(e,t){if(t.byteLength<16)throw new Kt(e,`the file is truncated: it has ${t.byteLength} bytes, the header needs 16`);let i=new DataView(t);if(new TextDecoder("latin1").decode(new Uint8Array(t,0,8))!==Kg)throw new Kt(e,`not an array file: it does not begin with ${Kg}`);let r=i.getUint32(8,!0);if(r<4)throw new Kt(e,"written by an older version of Calyx: run the model again");if(r>4)throw new Kt(e,`version ${r} of the format is not supported; this viewer reads version 4`);let o=i.getUint32(12,!0),a=16+o;if(a>t.byteLength)throw new Kt(e,`the file is truncated: it has ${t.byteLength} bytes, the header ends at ${a}`);let l;try{l=JSON.parse(new TextDecoder("utf-8",{fatal:!0}).decode(new Uint8Array(t,16,o)))}catch{throw new Kt(e,"the header is not valid JSON")}if(typeof l!="object"||l===null||Array.isArray(l))throw new Kt(e,"the header is not a JSON object");return new n(e,l,t,a)}f32(e,t,i){let{offset:s,length:r}=this.locate(e,"f32",t,i);return new Float32Array(this.buffer,s,r)}f64(e,t,i){let{offset:s,length:r}=this.locate(e,"f64",t,i);return s%8===0?new Float64Array(this.buffer,s,r):new Float64Array(this.buffer.slice(s,s+8*r))}u32(e,t,i){let{offset:s,length:r}=this.locate(e,"u32",t,i);return new Uint32Array(this.buffer,s,r)}locate(e,t,i,s){let r=p=>{throw new Kt(this.name,`${s}: ${p}`)};if(typeof e!="object"||e===null)return r("the array is missing");let o=e;if(o.type!==t)return r(`the array has type ${String(o.type)}, expected ${t}`);if(o.components!==i)return r(`the array has ${String(o.components)} components, expected ${i}`);let{count:a,offset:l}=o,c=p=>Number.isSafeInteger(p)&&p>=0;if(!c(a)||!c(l))return r("the size or the offset of the array is not a whole number");let u=t==="f64"?8:4;if(l%u!==0)return r(`the offset ${l} is not aligned`);let d=a*i,h=this.start+l+d*u;if(h>this.buffer.byteLength)return r(`the file is truncated: it has ${this.buffer.byteLength} bytes, the array ends at ${h}`);let f=this.start+l;return f%u!==0?r("the header's length is not a multiple of 8"):{offset:f,length:d}}};var su=256,Qf={viridis:{label:"Viridis",colours:["#440154","#482475","#414487","#355f8d","#2a788e","#21918c","#22a884","#44bf70","#7ad151","#bddf26","#fde725"]},cividis:{label:"Cividis",colours:["#00224e","#123570","#3b496c","#575d6d","#707173","#8a8678","#a59c74","#c3b369","#e1cc55","#fee838"]},turbo:{label:"Turbo",colours:["#30123b","#4145ab","#4675ed","#39a2fc","#1bcfd4","#24eca6","#61fc6c","#a4fc3b","#d1e834","#f3c63a","#fe9b2d","#f36315","#d93806","#b11901","#7a0402"]},grey:{label:"Grey",colours:["#1a1a1a","#f2f2f2"]}},Qg=Object.entries(Qf).map(([n,{label:e}])=>({name:n,label:e}));function jg(n){let e=parseInt(n.slice(1),16);return[e>>16&255,e>>8&255,e&255]}function er(n,e){let{colours:t}=Qf[n]??Qf.viridis,i=Math.min(Math.max(e,0),1)*(t.length-1),s=Math.min(Math.floor(i),t.length-2),r=jg(t[s]),o=jg(t[s+1]),a=i-s;return r.map((l,c)=>Math.round(l+a*(o[c]-l)))}function Sr(n,e){if(e<1)return n;let t=Math.min(Math.max(Math.floor(n*e),0),e-1);return e===1?.5:t/(e-1)}function wr([n,e,t]){return`rgb(${n} ${e} ${t})`}function e0(n,e,t){let i=n.image.data;for(let r=0;r<su;r++){let[o,a,l]=er(e,Sr(r/(su-1),t));i.set([o,a,l,255],4*r)}let s=t>0?_n:Bn;n.minFilter=s,n.magFilter=s,n.needsUpdate=!0}function t0(){let n=new uo(new Uint8Array(4*su),su,1,fi);return n.colorSpace=Jn,n}var n0=["#7f9db9","#c9a66b","#8fb09a","#b58a9b","#9a95bd","#b9b08a","#76a9ae","#c08f76"],x1={gear:n0,shaft:["#a9adb3","#b7b2aa","#9ea6ac"],bearing:["#8a8f98","#969089"],body:["#b4bcc4","#c0b9ae","#aab7b0"]};function i0(n,e){let t=x1[n]??n0;return t[e%t.length]}var s0={x:[1,0,0],y:[0,1,0],z:[0,0,1]},ru=class{group=new Qt;capGeometry=new _r(2,2);capMatrix=new vt;normal=new G(0,0,1);range=[-1,1];offset=0;#e;#t=new Qt;#n=new G;#i=1;#s=new G;constructor(){let e=[-1,-1,0,1,-1,0,1,1,0,-1,1,0],t=new on;t.setAttribute("position",new Ht(e,3)),this.#e=new mr(t,new Ys({color:"#e07b1f",transparent:!0,opacity:.8}));let i=new $s({color:"#e07b1f",transparent:!0,depthTest:!1}),s=new gr(.022,.05,20).rotateX(Math.PI/2),r=new yt(s.clone().translate(0,0,.062),i),o=new yt(s.clone().rotateY(Math.PI).translate(0,0,-.062),i),a=new yt(new xa(.021,20,14),i);this.#t.add(r,o,a);for(let l of this.#t.children)l.renderOrder=3e5;this.group.add(this.#e,this.#t),this.group.visible=!1}setBounds(e,t){this.#n.copy(e),this.#i=t}apply(e,t){let i=typeof e.normal=="string"?s0[e.normal]??s0.z:e.normal;this.normal.set(i[0],i[1],i[2]),this.normal.lengthSq()>0||this.normal.set(0,0,1),this.normal.normalize();let s=this.normal.dot(this.#n);this.range=[s-this.#i,s+this.#i],this.offset=e.offset??s;let r=e.flipped?-1:1;t.set(r*this.normal.x,r*this.normal.y,r*this.normal.z,-r*this.offset),this.group.visible=e.on;let o=this.#n.clone().addScaledVector(this.normal,this.offset-s),a=new yi().setFromUnitVectors(new G(0,0,1),this.normal),l=1.02*this.#i;this.capMatrix.compose(o,a,new G(1.5*l,1.5*l,1)),this.#e.position.copy(o),this.#e.quaternion.copy(a),this.#e.scale.set(.86*l,.86*l,1),this.#t.quaternion.copy(a),this.#t.position.set(.86*l,.86*l,0).applyQuaternion(a).add(o),this.#t.scale.setScalar(l)}get handle(){return this.#t.position}setHighlight(e){for(let t of this.#t.children)t.material.color.set(e?"#ffa648":"#e07b1f")}drag(e,t,i,s,r){let o=.01*this.#i,a=this.#s.copy(this.handle).project(i),l=a.x,c=a.y,u=this.#s.copy(this.handle).addScaledVector(this.normal,o).project(i),d=(u.x-l)*s/2,h=-(u.y-c)*r/2,f=d*d+h*h;return f<.02?-t*o/2:(e*d+t*h)/f*o}};function v1(n,e,t,i,s,r){let o=Math.max(Math.abs(n),Math.abs(e),Math.abs(t),Math.abs(i),Math.abs(s),Math.abs(r));if(!Number.isFinite(o))return[NaN,NaN,NaN];if(o===0)return[0,0,0];let a=(n+e+t)/3,l=(n-e)/o,c=(e-t)/o,u=(t-n)/o,d=(l-u)/3,h=(c-l)/3,f=(u-c)/3,p=i/o,_=s/o,m=r/o,g=(l*l+c*c+u*u)/6+p*p+_*_+m*m;if(g===0)return[a,a,a];let x=d*(h*f-p*p)-m*(m*f-p*_)+_*(m*p-h*_),M=2*g/3,y=Math.SQRT2,C=d*d+m*m+_*_-M,A=h*h+m*m+p*p-M,v=f*f+p*p+_*_-M,w=y*(_*m-d*p),U=y*(p*m-h*_),L=y*(p*_-f*m),I=y*p,O=y*_,z=y*m,N=(d*A-h*C)**2+(d*v-f*C)**2+(h*v-f*A)**2+(d*w-I*C)**2+(d*U-O*C)**2+(d*L-z*C)**2+(h*w-I*A)**2+(h*U-O*A)**2+(h*L-z*A)**2+(f*w-I*v)**2+(f*U-O*v)**2+(f*L-z*v)**2+(I*U-O*w)**2+(I*L-z*w)**2+(O*L-z*U)**2,W=Math.atan2(Math.sqrt(3*N),Math.sqrt(27)*x)/3,$=2*Math.sqrt(g/3)*o,V=2*Math.PI/3;return[a+$*Math.cos(W),a+$*Math.cos(W-V),a+$*Math.cos(W+V)]}function y1(n,e,t,i,s,r){let o=n-e,a=e-t,l=t-n;return Math.sqrt(.5*(o*o+a*a+l*l)+3*(i*i+s*s+r*r))}function Un(n){return n!=="plain"&&n!=="contact_pressure"}var Vi={plain:{label:"Plain",quantity:"none"},contact_pressure:{label:"Contact pressure",quantity:"stress"},max_principal:{label:"Maximum principal stress",quantity:"stress"},min_principal:{label:"Minimum principal stress",quantity:"stress"},von_mises:{label:"Von Mises stress",quantity:"stress"},stress_error:{label:"Stress error",quantity:"stress"},displacement:{label:"Displacement",quantity:"length"}},So={stress_error:"Estimated error of the stresses, as von Mises stress: the difference between the averaged stresses at a node and those of its elements (Zienkiewicz and Zhu). Where it is large, a finer mesh changes the stresses. It is largest at contacts, whose loads are concentrated at nodes: automatic limits leave out the largest values, so that the fillets and the body are visible."},ou="Contact pressure and plain colours show the undeformed shape, because contact cells and plain parts have no elastic displacements. Choose a stress or the displacement to see the deformation, or set a factor.";function ed(n){return n==="stress_error"?.9:1}function o0(n){return n==="min_principal"?"minimum":"maximum"}function b1(n,e,t){if(e==="displacement"){let h=n.displacements;return Math.hypot(h[3*t],h[3*t+1],h[3*t+2])}if(e==="stress_error")return n.stressErrors?.[t]??NaN;let i=n.stresses,s=6*t,[r,o,a,l,c,u]=[i[s],i[s+1],i[s+2],i[s+3],i[s+4],i[s+5]];if(e==="von_mises")return y1(r,o,a,l,c,u);let d=v1(r,o,a,l,c,u);return e==="max_principal"?d[0]:d[2]}function a0(n){let e={min:1/0,max:-1/0,minIndex:-1,maxIndex:-1};for(let t=0;t<n.length;t++){let i=n[t];i<e.min&&i!==-1/0&&(e.min=i,e.minIndex=t),i>e.max&&i!==1/0&&(e.max=i,e.maxIndex=t)}return e.minIndex<0||e.maxIndex<0?null:e}var r0=new WeakMap;function td(n){let e=r0.get(n);if(e)return e;e=new Uint8Array(n.points.length/3);for(let t=0;t<n.triangles.length;t++)e[n.triangles[t]]=1;return r0.set(n,e),e}function l0(n,e){let t=n.shape.points.length/3,i=new Float64Array(t);for(let s=0;s<t;s++)i[s]=b1(n,e,s);return i}function M1(n){return n.match(/[\s.:/]*[^\s.:/]+/g)??[n]}function c0(n){let e=0;for(;n.every(t=>e+1<t.length&&t[e]===n[0][e]);)e++;return e}function u0(n){let e=[...new Set(n)],t=new Map;if(e.length<2)return new Map(e.map(a=>[a,a]));let i=e.map(M1),s=c0(i),r=i.map(a=>a.slice(s).reverse()),o=c0(r);return e.forEach((a,l)=>t.set(a,r[l].slice(o).reverse().join("").replace(/^[\s.:/]+/,""))),t}var nd=12;function h0(n){return n.length>nd+4?[n.slice(0,-nd),n.slice(-nd)]:["",n]}var S1={Pa:[[1e6,"MPa",1e-6],[1e3,"kPa",.001],[0,"Pa",1]],m:[[1e-4,"mm",1e3],[1e-7,"µm",1e6],[0,"nm",1e9]],N:[[1e3,"kN",.001],[0,"N",1]],"N m":[[1e3,"kN m",.001],[0,"N m",1]],W:[[1e3,"kW",.001],[0,"W",1]],s:[[1,"s",1],[.001,"ms",1e3],[0,"µs",1e6]],rad:[[.1,"rad",1],[1e-4,"mrad",1e3],[0,"µrad",1e6]]},w1={Pa:[[0,"psi",1/6894.757293168361]],m:[[0,"inch",1/.0254]],N:[[0,"lbf",1/4.4482216152605]],"N m":[[0,"lbf inch",1/.1129848290276167]]},f0=!1;function d0(n){f0=/^(inch|ft|foot)_/.test(n)}function xn(n,e){let t=n.replace("·"," "),i=(f0?w1[t]:void 0)??S1[t];if(!i)return{symbol:n==="1"?"":n,factor:1};let s=Math.abs(e);if(!(s>0))return{symbol:i[0][1],factor:i[0][2]};let r=i.find(([o])=>s>=o)??i[i.length-1];return{symbol:r[1],factor:r[2]}}function Ei(){return xn("Pa",0)}var E1="−";function Nt(n,e=4){if(Number.isNaN(n))return"no value";if(n===0)return"0";let t=Math.abs(n),i;if(t>=1e6||t<1e-4)i=n.toExponential(e-1).replace("e+","e");else{let s=Math.max(0,e-1-Math.floor(Math.log10(t)));i=n.toFixed(Math.min(s,12)),i.includes(".")&&(i=i.replace(/\.?0+$/,""))}return i.replaceAll("-",E1)}function p0(n,e,t=4){if(!Number.isFinite(n))return"no value";let i=xn(e,n);return`${Nt(n*i.factor,t)} ${i.symbol}`.trim()}function m0(n){if(!(n>0)||!Number.isFinite(n))return n;let e=10**Math.floor(Math.log10(n)),t=n/e,i=t>=5?5:t>=2?2:1;return Number((i*e).toPrecision(3))}var g0={bearing:"#2f6fb5",mesh:"#c2502b"},T1=new G(0,1,0),au=class{group=new Qt;labels=[];#e=new fo(1,1,1,20).translate(0,.5,0);#t=new gr(1,1,24).translate(0,.5,0);#n;#i=new yt(new on,new $s({transparent:!0}));constructor(e){let t=i=>{let s=new wi(e,["LIT"],{transparent:!0});return s.colour.set(i),s};this.#n={bearing:t(g0.bearing),mesh:t(g0.mesh)},this.#i.renderOrder=2e5,this.#i.frustumCulled=!1,this.#i.onBeforeRender=i=>i.clearDepth()}set(e,t){this.group.clear(),this.labels=[];let i=({kind:o,parts:a})=>o==="mesh"?t.names[a[0]??-1]:void 0,s=u0(e.flatMap(o=>[o.name,i(o)??""]).filter(o=>o!=="")),r=0;for(let{force:o}of e)r=Math.max(r,Math.hypot(...o));if(r>0){this.group.add(this.#i);for(let o of e){if(o.kind==="bearing"?!t.bearings:!t.meshes)continue;let a=Math.hypot(...o.force);if(!(a>0))continue;let l=t.scale*.5*t.radius*a/r,c=this.arrow(o,l,t.radius*.011);this.group.add(c);let u=new G(...o.force).multiplyScalar(l/a).add(new G(...o.point));if(t.labels){let d=s.get(o.name)??o.name,h=i(o),f=h&&s.get(h),p=`${d?`${d}: `:""}${p0(a,"N",3)}${f?` on ${f}`:""}`;this.labels.push({text:p,point:u,kind:o.kind,weight:a})}}}}arrow(e,t,i){let s=this.#n[e.kind],r=new Qt,o=Math.min(5.2*i,.45*t),a=new yt(this.#e,s);a.scale.set(.55*i,t-o,.55*i);let l=new yt(this.#t,s);l.scale.set(.33*o,o,.33*o),l.position.y=t-o,r.add(a,l),r.position.set(...e.point),r.quaternion.setFromUnitVectors(T1,new G(...e.force).normalize());for(let c of[a,l])c.renderOrder=200001;return r}dispose(){this.#e.dispose(),this.#t.dispose(),this.#i.geometry.dispose(),this.#i.material.dispose();for(let e of Object.values(this.#n))e.dispose()}};function _0(n,e){let t=[],i=x0(n,e);for(let s=0;s<n.length;s+=2){for(let r of[n[s+1],n[s]])t.push(e[3*r],e[3*r+1],e[3*r+2]);t.push(...i)}return t}function x0(n,e){return[0,1,2].map(t=>n.reduce((i,s)=>i+e[3*s+t],0)/Math.max(n.length,1))}function A1(n){let e=new Map,t=s=>{let r=s;for(let o=e.get(r);o!==void 0&&o!==r;o=e.get(r))r=o;return e.set(s,r),r};for(let s=0;s<n.length;s+=2)e.set(t(n[s]),t(n[s+1]));let i=new Map;for(let s=0;s<n.length;s+=2){let r=t(n[s]),o=i.get(r)??[];o.push(n[s],n[s+1]),i.set(r,o)}return[...i.values()]}function v0(n,e){return[e.stencilBack,e.stencilFront].map(t=>{let i=new yt(n,t);return i.frustumCulled=!1,i.matrixAutoUpdate=!1,i})}var lu=class{geometry=new Bi;meshes;#e;#t;constructor(e,t,i,s){this.#e=A1(e.openEdges);let r=this.#e.flatMap(o=>_0(o,t));this.#t=new Ht(new Float32Array(r.length),3),this.geometry.setAttribute("position",new Ht(r,3)),this.geometry.setAttribute("displacement",this.#t),this.geometry.setAttribute("copyRotation",i),this.geometry.instanceCount=r.length>0?1:0,this.meshes=v0(this.geometry,s)}setDisplacements(e){let t=this.#t.array,i=0;for(let s of this.#e){let r=x0(s,e);for(let o=0;o<s.length;o+=2){for(let a of[s[o+1],s[o]])for(let l=0;l<3;l++)t[i++]=e[3*a+l];for(let a=0;a<3;a++)t[i++]=r[a]}}this.#t.needsUpdate=!0}};function C1(n,e,t){let i=[];for(let l=0;l<n.length;l+=2){let[c,u]=[3*n[l],3*n[l+1]];i.push([e[c]+e[u],e[c+1]+e[u+1],e[c+2]+e[u+2]])}let[s,r]=[Math.cos(2*Math.PI/t),Math.sin(2*Math.PI/t)],o=([l,c,u],d)=>{let[h,f]=[s*l+d*r*c,s*c-d*r*l],p=1/0;for(let[_,m,g]of i)p=Math.min(p,(_-h)**2+(m-f)**2+(g-u)**2);return p},a={1:[],[-1]:[]};return i.forEach((l,c)=>{let u=o(l,1)<=o(l,-1)?1:-1;a[u].push(n[2*c],n[2*c+1])}),a}var cu=class{constructor(e,t,i,s){this.copies=i;let r=C1(e.openEdges,t,i);this.#e=[1,-1].map(o=>{let a=r[o],l=new Bi;l.setAttribute("position",new Ht(_0(a,t),3));let c=new ys(new Float32Array(2*i),2);return l.setAttribute("copyRotation",c),l.instanceCount=0,{geometry:l,rotation:c,next:o}}),this.meshes=this.#e.flatMap(({geometry:o})=>v0(o,s))}copies;meshes;#e;set(e){for(let{geometry:t,rotation:i,next:s}of this.#e){let r=0;if(e.size>0){for(let o=0;o<this.copies;o++){if(e.has(o)||!e.has((o+s+this.copies)%this.copies))continue;let a=2*Math.PI*o/this.copies;i.setXY(r++,Math.cos(a),Math.sin(a))}i.needsUpdate=!0}t.instanceCount=r}}dispose(){for(let{geometry:e}of this.#e)e.dispose()}};function b0({tetrahedra:n,wedges:e,hexahedra:t}){return n.length+e.length+t.length>0}var R1=[[0,1,2],[3,4,5],[0,1,4,3],[1,2,5,4],[2,0,3,5]],P1=[[0,1,2,3],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]];function I1(n,e,t,i){let s=0;for(let a=1;a<n.length;a++)n[a]<n[s]&&(s=a);let r=e.map(a=>a.reduce((l,c)=>l|1<<c,0)),o=(...a)=>{let l=a.reduce((c,u)=>c|1<<u,0);return r.some(c=>(c&l)===l)};for(let a of e){if(a.includes(s))continue;let l=0;a.forEach((c,u)=>l=n[c]<n[a[l]]?u:l);for(let c=1;c+1<a.length;c++){let[u,d,h]=[a[l],a[(l+c)%a.length],a[(l+c+1)%a.length]];t.push(n[s],n[u],n[d],n[h]),i.push(1|(o(s,d,h)?2:0)|(o(s,u,h)?4:0)|(o(s,u,d)?8:0))}}}var y0=new WeakMap;function M0(n){let e=y0.get(n);if(e)return e;let t=[],i=[];for(let[a,l,c]of[[n.wedges,6,R1],[n.hexahedra,8,P1]])for(let u=0;u<a.length;u+=l)I1(a.subarray(u,u+l),c,t,i);let{tetrahedra:s}=n,r=new Uint32Array(s.length+t.length);r.set(s),r.set(t,s.length);let o=new Uint8Array(r.length/4).fill(15);return o.set(i,s.length/4),e={nodes:r,borders:o},y0.set(n,e),e}var L1=1e-13,hu=class{points=new Float32Array(9*1024);values=new Float32Array(3*1024);sources=new Uint32Array(1024);count=0;edges=new Float32Array(6*2048);edgeCount=0;#e=new Float64Array;#t=new Float64Array(12);#n=new Float64Array(4);compute(e,t,i,s,r,o){let{nodes:a,borders:l}=M0(e.shape),c=this.measure(e,i,s);this.count=0,this.edgeCount=0;for(let u=0;u<a.length;u+=4){let d=(c[a[u]]<0?1:0)|(c[a[u+1]]<0?2:0)|(c[a[u+2]]<0?4:0)|(c[a[u+3]]<0?8:0);if(d===0||d===15)continue;let h=r?l[u/4]:0,f=D1[d],p=f.length/3;for(let _=0;_<p;_++)this.cross(e,t,s,o,a[u+f[3*_]],a[u+f[3*_+1]],_);this.push(u/4,0,1,2),p===4&&this.push(u/4,0,2,3);for(let _=0;h&&_<p;_++)h&1<<f[3*_+2]&&this.pushEdge(_,(_+1)%p)}}measure(e,[t,i,s,r],o){let{points:a}=e.shape,{cos:l,sin:c,displacements:u}=e,d=a.length/3;this.#e.length<d&&(this.#e=new Float64Array(d));let h=this.#e,f=l*t+c*i,p=l*i-c*t;for(let _=0,m=0;_<d;_++,m+=3)h[_]=f*a[m]+p*a[m+1]+s*a[m+2]+r+o*(t*u[m]+i*u[m+1]+s*u[m+2]);return h}cross(e,t,i,s,r,o,a){let{points:l}=e.shape,{cos:c,sin:u,displacements:d}=e,h=this.#e[r],f=h/(h-this.#e[o]),p=3*r,_=3*o,m=l[p]+f*(l[_]-l[p]),g=l[p+1]+f*(l[_+1]-l[p+1]),x=this.#t;x[3*a]=c*m-u*g+i*(d[p]+f*(d[_]-d[p])),x[3*a+1]=u*m+c*g+i*(d[p+1]+f*(d[_+1]-d[p+1])),x[3*a+2]=l[p+2]+f*(l[_+2]-l[p+2])+i*(d[p+2]+f*(d[_+2]-d[p+2]));let M=t?t[r]+f*(t[o]-t[r]):NaN;this.#n[a]=Number.isFinite(M)?M:s}push(e,t,i,s){this.count===this.sources.length&&(this.points=uu(this.points,Float32Array),this.values=uu(this.values,Float32Array),this.sources=uu(this.sources,Uint32Array));let r=this.count++,o=this.#t;this.sources[r]=e;for(let a=0;a<3;a++){let l=a===0?t:a===1?i:s;this.values[3*r+a]=this.#n[l];for(let c=0;c<3;c++)this.points[9*r+3*a+c]=o[3*l+c]}}pushEdge(e,t){6*this.edgeCount===this.edges.length&&(this.edges=uu(this.edges,Float32Array));let i=6*this.edgeCount++;for(let s=0;s<3;s++)this.edges[i+s]=this.#t[3*e+s],this.edges[i+3+s]=this.#t[3*t+s]}find(e,t,i,s){let r=[Math.abs(s[0]),Math.abs(s[1]),Math.abs(s[2])],o=r[0]>=r[1]&&r[0]>=r[2]?0:r[1]>=r[2]?1:2,[a,l]=o===0?[1,2]:o===1?[2,0]:[0,1],c=[e,t,i],[u,d]=[c[a],c[l]];for(let h=0;h<this.count;h++){let f=9*h,{points:p}=this,[_,m]=[p[f+a]-u,p[f+l]-d],[g,x]=[p[f+3+a]-u,p[f+3+l]-d],[M,y]=[p[f+6+a]-u,p[f+6+l]-d],C=_*x-m*g,A=g*y-x*M,v=M*m-y*_;if(!(Math.abs(C+A+v)<=L1*(_*_+m*m+g*g+x*x+M*M+y*y))&&(C>=0&&A>=0&&v>=0||C<=0&&A<=0&&v<=0))return h}return-1}};function uu(n,e){let t=new e(2*n.length);return t.set(n),t}var D1=Array.from({length:16},(n,e)=>{let t=[0,1,2,3].filter(c=>e&1<<c),i=[0,1,2,3].filter(c=>!(e&1<<c));if(t.length===2&&i.length===2){let[c,u,d,h]=[t[0],t[1],i[0],i[1]];return[c,d,u,c,h,d,u,h,c,u,d,h]}let[s,r]=t.length===1?[t[0],i]:[i[0],t];if(r.length!==3)return[];let[o,a,l]=r;return[s,o,l,s,a,o,s,l,a]});function S0(n,e,t,i){let s=M0(n.shape).nodes,r=[0,1,2,3].map(_=>s[4*e+_]),{cos:o,sin:a,displacements:l}=n,{points:c}=n.shape,u=r.map(_=>{let m=3*_,[g,x]=[c[m],c[m+1]];return[o*g-a*x+t*l[m],a*g+o*x+t*l[m+1],c[m+2]+t*l[m+2]]}),d=(_,m)=>[m[0]-_[0],m[1]-_[1],m[2]-_[2]],h=(_,m,g,x)=>{let[M,y,C]=[d(_,m),d(_,g),d(_,x)];return M[0]*(y[1]*C[2]-y[2]*C[1])+M[1]*(y[2]*C[0]-y[0]*C[2])+M[2]*(y[0]*C[1]-y[1]*C[0])},f=h(u[0],u[1],u[2],u[3]),p=[0,1,2,3].map(_=>{let m=u.map((g,x)=>x===_?i:g);return h(m[0],m[1],m[2],m[3])/f});return{nodes:r,weights:p}}var fu=class{section=new hu;objects;plane=null;#e=[];#t=new on;#n=new on;constructor(e){this.objects=[new yt(this.#t,e.section),new Oi(this.#n,e.sectionEdges)],this.objects.forEach((t,i)=>{t.frustumCulled=!1,t.matrixAutoUpdate=!1,t.visible=!1,t.renderOrder=1e5+2*i})}hide(){this.plane=null;for(let e of this.objects)e.visible=!1}update(e,t,i,s,r){this.plane=i;let o=[e,t,...i,s,r],a=o.every((l,c)=>l===this.#e[c]);if(!a){this.#e=o,this.section.compute(e,t,i,s,r,Fa);let{points:l,values:c,count:u,edges:d,edgeCount:h}=this.section;id(this.#t,"position",l,3,3*u),id(this.#t,"field",c,1,3*u),id(this.#n,"position",d,3,2*h),this.#t.setDrawRange(0,3*u),this.#n.setDrawRange(0,2*h)}return this.objects[0].visible=this.section.count>0,this.objects[1].visible=r&&this.section.edgeCount>0,!a}dispose(){this.#t.dispose(),this.#n.dispose()}};function id(n,e,t,i,s){let r=n.getAttribute(e);r?.array!==t&&(n.dispose(),r=new bt(t,i).setUsage(Qs),n.setAttribute(e,r)),r.clearUpdateRanges(),r.addUpdateRange(0,i*s),r.needsUpdate=!0}var sd=Math.cos(32*Math.PI/180),wo=n=>n===2147483648?0:n;function N1(n){let e=n.length/3,t=new Uint32Array(n.buffer,n.byteOffset,n.length),i=1;for(;i<2*e;)i*=2;let s=new Uint32Array(i),r=new Uint32Array(e);for(let o=0;o<e;o++){let[a,l,c]=[wo(t[3*o]),wo(t[3*o+1]),wo(t[3*o+2])],u=Math.imul(a,2654435761)^Math.imul(l,2246822507)^Math.imul(c,3266489909);for(u=(u^u>>>15)&i-1;;){let d=s[u];if(d===0){s[u]=o+1,r[o]=o;break}let h=3*(d-1);if(wo(t[h])===a&&wo(t[h+1])===l&&wo(t[h+2])===c){r[o]=d-1;break}u=u+1&i-1}}return r}function F1(n,e){let t=new Uint32Array(e+1);for(let r=0;r<n.length;r++)t[n[r]+1]++;for(let r=0;r<e;r++)t[r+1]+=t[r];let i=t.slice(0,e),s=new Uint32Array(n.length);for(let r=0;r<n.length;r++)s[i[n[r]]++]=r;return{starts:t,corners:s}}function U1(n,e){let t=new Float32Array(e.length);for(let i=0;i<e.length;i+=3){let s=3*e[i],r=3*e[i+1],o=3*e[i+2],a=n[r]-n[s],l=n[r+1]-n[s+1],c=n[r+2]-n[s+2],u=n[o]-n[s],d=n[o+1]-n[s+1],h=n[o+2]-n[s+2];t[i]=l*h-c*d,t[i+1]=c*u-a*h,t[i+2]=a*d-l*u}return t}function O1(n,e,t,i,s){for(let r=e[i];r<e[i+1];r++){let o=t[r],a=o-o%3;if(n[a+(o+1)%3]===s)return a}return-1}function B1(n,e,t){let i=new Map,s=[],r=0;for(let c=0;c<e.length;c++)e[c]&&(s.push(c),r=Math.max(r,Math.abs(n[3*c]),Math.abs(n[3*c+1]),Math.abs(n[3*c+2])));if(s.length===0||!(r>0))return i;let o=r*2e-5,a=(c,u,d)=>`${Math.round(c/o)},${Math.round(u/o)},${Math.round(d/o)}`,l=new Map;for(let c of s)l.set(a(n[3*c],n[3*c+1],n[3*c+2]),c);for(let c of[1,-1]){let u=c*2*Math.PI/t,d=Math.cos(u),h=Math.sin(u);for(let f of s){let p=d*n[3*f]-h*n[3*f+1],_=h*n[3*f]+d*n[3*f+1],m=n[3*f+2],g;for(let x=0;x<27&&g===void 0;x++){let M=(x%3-1)*o*.5,y=(Math.floor(x/3)%3-1)*o*.5,C=(Math.floor(x/9)-1)*o*.5;g=l.get(a(p+M,_+y,m+C))}g!==void 0&&i.set(f,[...i.get(f)??[],[g,-c]])}}return i}function du(n,e,t){let i=n.length/3,s=N1(n),r=e.map(_=>s[_]),{starts:o,corners:a}=F1(r,i),l=U1(n,e),c=new Uint8Array(i),u=[],d=[];for(let _=0;_<e.length;_++){let m=_-_%3,g=r[_],x=r[m+(_+1)%3];if(g===x)continue;let M=O1(r,o,a,x,g);M<0?(c[g]=c[x]=1,d.push(g,x),t===1&&u.push(_)):m<M&&od(l,m,l,M)<sd&&u.push(_)}let h=t>1?B1(n,c,t):new Map,f=k1(e,s,t,o,a,l,h),p=new Uint32Array(2*u.length);u.forEach((_,m)=>{let g=_-_%3;p[2*m]=f.triangles[_],p[2*m+1]=f.triangles[g+(_+1)%3]});for(let _=0;_<i;_++)c[_]=c[s[_]];return{...f,features:p,open:c,openEdges:Uint32Array.from(d)}}var rd=(n,e,t)=>Math.sqrt(n*n+e*e+t*t);function od(n,e,t,i){let s=n[e]*t[i]+n[e+1]*t[i+1]+n[e+2]*t[i+2],r=rd(n[e],n[e+1],n[e+2])*rd(t[i],t[i+1],t[i+2]);return r>0?s/r:1}function k1(n,e,t,i,s,r,o){let a=e.length,l=[],c=[],u=new Uint32Array(a),d=new Uint32Array(n.length),h=2*Math.PI/t;for(let f=0;f<a;f++){let p=l.length;u[f]=p;let _=e[f],m=H1(_,o,i,s,r,h);for(let g=i[_];g<i[_+1];g++){let x=s[g];if(n[x]!==f)continue;let M=x-x%3,y=0,C=0,A=0;for(let U=i[_];U<i[_+1];U++){let L=s[U]-s[U]%3;L!==M&&od(r,M,r,L)<sd||(y+=r[L],C+=r[L+1],A+=r[L+2])}for(let U=0;U<m.length;U+=3)od(r,M,m,U)<sd||(y+=m[U],C+=m[U+1],A+=m[U+2]);let v=rd(y,C,A)||1;y/=v,C/=v,A/=v;let w=p;for(;w<l.length;){let U=3*w;if(c[U]*y+c[U+1]*C+c[U+2]*A>.99999)break;w++}w===l.length&&(l.push(f),c.push(y,C,A)),d[x]=w}l.length===p&&(l.push(f),c.push(0,0,1))}return{nodes:Uint32Array.from(l),firstVertex:u,normals:Float32Array.from(c),triangles:d}}var z1=[];function H1(n,e,t,i,s,r){let o=e.get(n);if(!o)return z1;let a=[];for(let[l,c]of o){let u=Math.cos(c*r),d=Math.sin(c*r);for(let h=t[l];h<t[l+1];h++){let f=i[h]-i[h]%3;a.push(u*s[f]-d*s[f+1],d*s[f]+u*s[f+1],s[f+2])}}return a}var ad=[48,32,16,8],V1=1.6;function w0(n){let e=-1;return ad.forEach((t,i)=>{n<=V1*t&&(e=i)}),e}function G1(n,e,t){let[i,s,r]=[Math.abs(n),Math.abs(e),Math.abs(t)];return i>=s&&i>=r?n>0?0:1:s>=r?e>0?2:3:t>0?4:5}function E0(n,e,t){let{nodes:i,normals:s,triangles:r,open:o}=e,a=W1(n),l=new Map,c=[],u=new Map,d=[],h=[],f=new Uint32Array(i.length);for(let g=0;g<i.length;g++){let x=3*i[g],[M,y,C]=[n[x],n[x+1],n[x+2]],A=o[i[g]]?`${X1(M,y,a)} ${Math.floor(Math.hypot(M,y)/t+1e-6)} ${Math.floor(C/t+1e-6)}`:`${Math.floor(M/t)},${Math.floor(y/t)},${Math.floor(C/t)}`,v=l.get(A);v===void 0&&(v=l.size,l.set(A,v),c.push(0,0,0,0)),c[4*v]+=M,c[4*v+1]+=y,c[4*v+2]+=C,c[4*v+3]+=1;let[w,U,L]=[s[3*g],s[3*g+1],s[3*g+2]],I=6*v+G1(w,U,L),O=u.get(I);O===void 0&&(O=u.size,u.set(I,O),d.push(v),h.push(0,0,0)),h[3*O]+=w,h[3*O+1]+=U,h[3*O+2]+=L,f[g]=O}let p=new Float32Array(3*d.length),_=new Float32Array(3*d.length);d.forEach((g,x)=>{let M=Math.hypot(h[3*x],h[3*x+1],h[3*x+2])||1;for(let y=0;y<3;y++)p[3*x+y]=c[4*g+y]/c[4*g+3],_[3*x+y]=h[3*x+y]/M});let m=[];for(let g=0;g<r.length;g+=3){let[x,M,y]=[f[r[g]],f[r[g+1]],f[r[g+2]]];d[x]===d[M]||d[M]===d[y]||d[y]===d[x]||m.push(x,M,y)}return{points:p,normals:_,triangles:Uint32Array.from(m)}}function W1(n){let e=0,t=0;for(let i=0;i<n.length;i+=3)e+=n[i],t+=n[i+1];return Math.atan2(t,e)}function X1(n,e,t){return Math.sin(Math.atan2(e,n)-t)>0?"l":"r"}function mu(n,e,t=new Float32Array(3*e.length)){for(let i=0;i<e.length;i++){let s=3*e[i];t[3*i]=n[s],t[3*i+1]=n[s+1],t[3*i+2]=n[s+2]}return t}var pu=class{constructor(e,t,i){this.input=e;this.total=i;let{surface:s,points:r}=e;this.#s=i,this.triangleCount=s.triangles.length/3;let o=new bt(mu(r,s.nodes),3);this.box=new ti().setFromBufferAttribute(o),this.sphere=this.box.getBoundingSphere(new jn),this.#r=new ys(new Float32Array(2*i),2),this.#r.setUsage(Qs);let a=(h,f=!1)=>{let p=new Bi;return p.setAttribute("position",o),p.setAttribute("copyRotation",this.#r),f&&p.setAttribute("normal",new bt(s.normals,3)),p.setIndex(new bt(h,1)),p.instanceCount=i,p},l=Uint32Array.from(e.edges,h=>s.firstVertex[h]),c=a(s.triangles,!0),u=a(s.features),d=a(l);this.#e=[c,u,d],this.#t=c,this.surface=new yt(c,t.surface),this.features=new Oi(u,t.features),this.edges=new Oi(d,t.edges),this.stencils=[new yt(c,t.stencilBack),new yt(c,t.stencilFront)];for(let h of[this.surface,this.features,this.edges,...this.stencils])h.frustumCulled=!1,h.matrixAutoUpdate=!1,this.group.add(h);this.group.matrixAutoUpdate=!1,this.setCopies(Array.from({length:i},(h,f)=>f),i)}input;total;group=new Qt;surface;features;edges;stencils;triangleCount;sphere;box;#e;#t;#n=[];#i=-1;#s;#r;setLevel(e){if(e===this.#i)return;this.#i=e;let t=e<0?this.#t:this.#n[e];if(!t){let i=2*this.sphere.radius/ad[e],s=E0(this.input.points,this.input.surface,i);t=new Bi,t.setAttribute("position",new bt(s.points,3)),t.setAttribute("normal",new bt(s.normals,3)),t.setAttribute("copyRotation",this.#r),t.setIndex(new bt(s.triangles,1)),this.#n[e]=t,this.#e.push(t)}t.instanceCount=this.#s;for(let i of[this.surface,...this.stencils])i.geometry=t}get drawnTriangles(){return this.surface.geometry.index.count/3}setCopies(e,t){let i=this.#r,s=i.array;for(let r=0;r<t;r++){let o=2*Math.PI*e[r]/this.total;s[2*r]=Math.cos(o),s[2*r+1]=Math.sin(o)}i.clearUpdateRanges(),i.addUpdateRange(0,2*t),i.needsUpdate=!0,this.#s=t;for(let r of this.#e)r.instanceCount=t;this.group.visible=t>0}dispose(){for(let e of this.#e)e.dispose()}};var T0=new WeakMap;function q1(n){let e=T0.get(n);return e||T0.set(n,e=du(n.points,n.triangles,1)),e}var ld=class{constructor(e){this.shape=e;let t=q1(e);this.surface=t,this.position=new bt(mu(e.points,t.nodes),3),this.normal=new bt(t.normals,3),this.triangles=new bt(t.triangles,1),this.features=new bt(t.features,1),this.edges=new bt(Uint32Array.from(e.edges,i=>t.firstVertex[i]),1)}shape;surface;position;normal;triangles;features;edges},cd=class{constructor(e,t){this.buffers=e;let{surface:i,shape:s}=e,r=i.nodes.length;this.triangleCount=s.triangles.length/3,this.#t=new bt(new Float32Array(3*r),3).setUsage(Qs),this.#n=new bt(new Float32Array(r).fill(Fa),1).setUsage(Qs);let o=u=>{let d=new Bi;return d.setAttribute("position",e.position),d.setAttribute("normal",e.normal),d.setAttribute("displacement",this.#t),d.setAttribute("field",this.#n),d.setAttribute("copyRotation",this.#i),d.setIndex(u),d.instanceCount=1,d},a=o(e.triangles),l=o(e.features),c=o(e.edges);this.surface=new yt(a,t.surface),this.features=new Oi(l,t.features),this.edges=new Oi(c,t.edges),this.stencils=[new yt(a,t.stencilBack),new yt(a,t.stencilFront)],this.#s=new lu(i,s.points,this.#i,t),this.closures=this.#s.meshes,this.#e=[a,l,c,this.#s.geometry],this.section=b0(s)?new fu(t):null;for(let u of[this.surface,this.features,this.edges,...this.stencils,...this.closures])u.frustumCulled=!1,u.matrixAutoUpdate=!1,this.group.add(u);this.section&&this.group.add(...this.section.objects),this.group.matrixAutoUpdate=!1}buffers;group=new Qt;surface;features;edges;stencils;closures;section;triangleCount;mesh=null;values=null;#e;#t;#n;#i=new ys(new Float32Array(2),2);#s;get open(){return this.buffers.shape.open}set(e){e!==this.mesh&&(this.mesh=e,this.values=null,this.#i.setXY(0,e.cos,e.sin),this.#i.needsUpdate=!0,mu(e.displacements,this.buffers.surface.nodes,this.#t.array),this.#t.needsUpdate=!0,this.#s.setDisplacements(e.displacements))}setField(e){if(e===this.values)return;this.values=e;let t=this.#n.array,{nodes:i}=this.buffers.surface;for(let s=0;s<i.length;s++){let r=e[i[s]];t[s]=Number.isFinite(r)?r:Fa}this.#n.needsUpdate=!0}dispose(){for(let e of this.#e)e.dispose();this.section?.dispose()}},gu=class{#e=new Map;#t=new Map;display(e,t){let i=new Map([...this.#t].map(([o,a])=>[o,[...a]])),s=o=>`${o.part} ${o.shape.name}`,r=e.map(o=>{let a=i.get(s(o))??[],l=a.findIndex(c=>c.mesh?.copy===o.copy&&c.mesh.shape===o.shape);return l<0?null:a.splice(l,1)[0]});return e.map((o,a)=>{let l=i.get(s(o))??[],c=r[a]?-1:l.findIndex(d=>d.mesh?.shape===o.shape),u=r[a]??(c<0?this.create(o,t(o.part)):l.splice(c,1)[0]);return u.set(o),u})}create(e,t){let i=this.#e.get(e.shape);i||this.#e.set(e.shape,i=new ld(e.shape));let s=new cd(i,t),r=`${e.part} ${e.shape.name}`;return this.#t.set(r,[...this.#t.get(r)??[],s]),s}dispose(){for(let e of this.#t.values())for(let t of e)t.dispose();this.#t.clear(),this.#e.clear()}};var $1=.28,A0=7,Y1=6e4,xu=class{constructor(e,t,i,s){this.part=e;this.#i=new at(s),this.#s=new at("#b4b9bf").lerp(this.#i,.4),this.#e=jf(t,!1),this.#t=jf(t,!0),this.#n=$g(t),this.surface=du(e.points,e.triangles,e.copies),this.copies=new pu({...e,surface:this.surface},this.#e,e.copies),this.#r=Array.from({length:e.copies},(o,a)=>a),this.#a=new Uint32Array(e.copies);let r=0;for(let o=0;o<e.points.length;o+=3)r=Math.max(r,e.points[o]**2+e.points[o+1]**2+e.points[o+2]**2);this.radius=Math.sqrt(r),this.group.matrixAutoUpdate=!1,this.#o=new cu(this.surface,e.points,e.copies,this.#e),this.group.add(this.copies.group,...this.#o.meshes),this.cap=new yt(i,this.#n),this.cap.frustumCulled=!1,this.cap.matrixAutoUpdate=!1,this.cap.onAfterRender=o=>o.clearStencil(),this.#p=e.index,this.#t.section.polygonOffsetUnits-=Z1*e.index,this.refresh()}part;group=new Qt;cap;copies;surface;radius;meshes=[];visibility="visible";present=!0;#e;#t;#n;#i;#s;#r;#o;#a;#l=-1;#u=NaN;#c=!1;#d=!1;#h=!1;#f=!1;#p;get materials(){return[...Object.values(this.#e),...Object.values(this.#t),this.#n]}setMeshes(e,t){for(let i of this.meshes)e.includes(i)||this.group.remove(i.group);for(let i of e)i.group.parent!==this.group&&this.group.add(i.group);this.meshes=e,this.#r=[];for(let i=0;i<this.part.copies;i++)t.has(i)||this.#r.push(i);this.#u=NaN,this.#o.set(t),this.refresh()}get meshMaterials(){return this.#t}get presentCopies(){return this.#r}setVisibility(e){this.visibility=e,this.refresh()}setFieldMode(e){this.#c=e,this.refresh()}setEdges(e){this.#d=e,this.refresh()}setSections(e){e!==this.#f&&(this.#f=e,this.refresh())}get showsField(){return this.#c}get showsSections(){return this.#f&&this.#h&&this.group.visible}setCut(e){this.#h=e;for(let t of this.materials)t.cut=e;this.refresh()}setPresent(e){this.present=e,this.refresh()}refresh(){let e=this.visibility==="translucent",t=this.visibility!=="hidden"&&this.present;this.group.visible=t,this.cap.visible=t&&this.#h&&!this.part.open;let i=e?$1:1;for(let r of[this.#e,this.#t]){r.surface.alpha=i,r.surface.depthWrite=!e;let o=this.part.open||this.#h||this.meshes.length>0;r.surface.side=o&&!e?Nn:Si,r.surface.colour.copy(this.#c?this.#s:this.#i),r.features.alpha=e?.25:.5,r.edges.alpha=e?.12:.34,r.stencilBack.transparent=r.stencilFront.transparent=e}this.#t.surface.useField=this.#t.section.useField=this.#c,this.#t.section.colour.copy(this.#c?this.#s:this.#i).multiplyScalar(.86),this.#n.alpha=e?.5:1,this.#n.depthWrite=!e,this.#n.colour.copy(this.#c?this.#s:this.#i).multiplyScalar(.86);let s=10+3*this.#p;this.cap.renderOrder=s+2;for(let r of[this.copies,...this.meshes])r.edges.visible=this.#d,r.surface.renderOrder=e?1e5:0,r.features.renderOrder=r.edges.renderOrder=100001;this.refreshStencils(this.copies.stencils,s,!0);for(let r of this.meshes){let o=!r.open&&!(this.#f&&r.section);this.refreshStencils(r.stencils,s,o),this.refreshStencils(r.closures,s,o)}this.#o.meshes.forEach((r,o)=>{r.visible=this.#h&&this.meshes.length>0&&!this.part.open,r.renderOrder=s+o%2})}refreshStencils(e,t,i){e.forEach((s,r)=>{s.visible=i&&this.#h&&!this.part.open,s.renderOrder=t+r})}prepare(e,t){if(!this.group.visible)return 0;let{sphere:i}=this.copies,s=0,r=0,o=0,a=this.group.matrixWorld;_u.radius=i.radius;for(let d of this.#r){let h=2*Math.PI*d/this.part.copies,f=Math.cos(h),p=Math.sin(h),{x:_,y:m,z:g}=i.center;_u.center.set(f*_-p*m,p*_+f*m,g).applyMatrix4(a),e.intersectsSphere(_u)&&(this.#a[s++]=d,r=(r*31+d+1)%4294967291,o=Math.max(o,i.radius*2*t(_u.center)))}(s!==this.#l||r!==this.#u)&&(this.copies.setCopies(this.#a,s),this.#l=s,this.#u=r);let l=this.part.copies>1?2*Math.PI*this.radius/this.part.copies:2*i.radius,c=o*Math.min(l,2*i.radius)/(2*i.radius||1);this.copies.features.visible=c>A0,this.copies.edges.visible=this.#d&&c>2*A0,this.copies.setLevel(s*this.copies.triangleCount>Y1?w0(o):-1);let u=s*this.copies.drawnTriangles;for(let d of this.meshes)u+=d.triangleCount;return u}dispose(){this.copies.dispose(),this.#o.dispose();for(let e of this.materials)e.dispose()}},Z1=8,_u=new jn;var J1=1e5,K1=["gear","shaft","bearing","body"];function yu(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)?n:null}function hd(n){return Array.isArray(n)?n:[]}function fd(n,e,t,i){for(let s=0;s<t.length;s++)if(t[s]>=i)throw new Kt(n,`${e}: index ${t[s]} exceeds the ${i} points`)}function C0(n){let e=Mo.parse("parts.bin",n);if(!Array.isArray(e.header.parts))throw new Kt(e.name,"the list of parts is missing");let t=e.header.parts.map((i,s)=>{let r=yu(i);if(!r)throw new Kt(e.name,`part ${s} is not an object`);let o=typeof r.name=="string"?r.name:`part ${s}`,a=Number(r.copies??1);if(!Number.isInteger(a)||a<1||a>J1)throw new Kt(e.name,`${o}: the number of copies is not valid`);let l=e.f32(r.points,3,`${o}, points`),c=e.u32(r.triangles,3,`${o}, triangles`),u=r.edges?e.u32(r.edges,2,`${o}, edges`):new Uint32Array;fd(e.name,`${o}, triangles`,c,l.length/3),fd(e.name,`${o}, edges`,u,l.length/3);let d=K1.includes(String(r.kind))?r.kind:"body";return{index:s,name:o,kind:d,copies:a,open:r.open===!0,points:l,triangles:c,edges:u}});return{model:String(e.header.model??""),units:String(e.header.units??""),parts:t}}function ud(n){if(!Array.isArray(n)||n.length!==3)return null;let e=n.map(t=>typeof t=="number"?t:NaN);return e.every(Number.isFinite)?e:null}function j1(n,e){let t=yu(n),i=ud(t?.point),s=ud(t?.force);return!t||!i||!s?null:{kind:t.kind==="mesh"?"mesh":"bearing",name:String(t.name??""),point:i,force:s,moment:ud(t.moment)??[0,0,0],parts:hd(t.parts).filter(r=>typeof r=="number"&&r>=0&&r<e)}}function Q1(n,e){let t=yu(e);if(!t)return null;let i=n.f32(t.corners,12,"contacts, corners"),s=n.f32(t.pressures,1,"contacts, pressures"),r=n.u32(t.parts,2,"contacts, parts"),o=n.u32(t.teeth,2,"contacts, teeth"),a=n.u32(t.zones,1,"contacts, zones"),l=n.u32(t.surfaces,2,"contacts, surfaces"),c=s.length,u=[r,o,l].every(({length:d})=>d===2*c);if(i.length!==12*c||a.length!==c||!u)throw new Kt(n.name,"contacts: the arrays have different lengths");return c>0?{count:c,corners:i,pressures:s,zones:a,parts:r,teeth:o,surfaces:l}:null}function Er(n,e,t){let{cos:i,sin:s,displacements:r}=n,{points:o}=n.shape,a=3*e,[l,c,u]=[o[a],o[a+1],o[a+2]];return[i*l-s*c+t*r[a],s*l+i*c+t*r[a+1],u+t*r[a+2]]}function R0(n,e){let t=Mo.parse(n,e),{header:i}=t,s=t.f32(i.points,3,"points"),r=(a,l,c)=>{if(!c&&!i[a])return new Uint32Array;let u=t.u32(i[a],l,a);return fd(n,a,u,s.length/3),u},o=i.extruded===!0;if(o&&s.length%6!==0)throw new Kt(n,"points: an extruded mesh needs an even number of them");return{name:n,open:i.open===!0,extruded:o,points:s,triangles:r("triangles",3,!0),edges:r("edges",2,!1),tetrahedra:r("tetrahedra",4,!1),wedges:r("wedges",6,!1),hexahedra:r("hexahedra",8,!1)}}var eE=/^mesh-[0-9A-Za-z_-]+\.bin$/;async function tE(n,e,t,i,s){let r=yu(e),o=i[Number(r?.part)];if(!r||!o)throw new Kt(n.name,`mesh ${t}: the part does not exist`);let a=`mesh of ${o.name}`,l=Number(r.copy??0);if(!Number.isInteger(l)||l<0||l>=o.copies)throw new Kt(n.name,`${a}: the copy does not exist`);let c=String(r.mesh);if(!eE.test(c))throw new Kt(n.name,`${a}: the name of the mesh is not valid`);let u=await s(c),d=(g,x,M)=>{let y=`${a}, ${g.replace("_"," ")}`;return u.extruded?nE(n.f32(r[g],M.length,y),x,M):n.f32(r[g],x,y)},h=d("displacements",3,[0,1]),f=d("stresses",6,[0,1,2,5]),p=r.stress_errors?d("stress_errors",1,[0]):null,_=u.points.length/3;if(h.length!==3*_||f.length!==6*_||p&&p.length!==_)throw new Kt(n.name,`${a}: the values do not fit the ${_} points of ${c}`);let m=2*Math.PI*l/o.copies;return{part:o.index,copy:l,cos:Math.cos(m),sin:Math.sin(m),shape:u,displacements:h,stresses:f,stressErrors:p}}function nE(n,e,t){let i=n.length/t.length,s=new Float32Array(2*e*i);for(let r=0;r<i;r++)t.forEach((o,a)=>{s[e*r+o]=n[t.length*r+a]});return s.copyWithin(e*i,0,e*i),s}async function P0(n,e,t,i){let s=Mo.parse(n,e),{header:r}=s,o=s.f64(r.poses,12,"poses");if(o.length!==12*t.length)throw new Kt(n,`${o.length/12} poses for ${t.length} parts; the files are from different runs`);let a="",l=u=>i(u).catch(d=>{throw a=d instanceof Error?d.message:String(d),new vu(a)}),c=await Promise.all(hd(r.meshes).map((u,d)=>tE(s,u,d,t,l).catch(h=>{if(h instanceof vu)return null;throw h})));return{position:Number(r.position??0),time:Number(r.time??0),poses:o,contacts:Q1(s,r.contacts),forces:hd(r.forces).map(u=>j1(u,t.length)).filter(u=>u!==null),meshes:c.filter(u=>u!==null),bytes:e.byteLength,problem:a}}var vu=class extends Error{};function bu(){return{version:1,camera:null,parts:{},colours:{field:"plain",scale:"viridis",bands:0,limits:"position",min:0,max:1,cells:"all"},deformation:{mode:"automatic",factor:1},mesh_edges:!1,hidden_contacts:!0,extremes:!0,forces:{bearings:!1,meshes:!1,labels:!0,scale:1},cut:{on:!1,normal:"z",offset:null,flipped:!1},frame:null,position:0,animation:{speed:10,loop:!0},theme:"system",panels:{parts:!0,settings:!1,plots:!1,pattern:!1},pattern:{gear:"",tooth:"all",flank:"automatic",envelope:!1},plotted:[]}}function Mu(n,e=bu()){let t=structuredClone(e),i=n??{};for(let[s,r]of Object.entries(t)){let o=i[s];if(o===void 0||s==="version")continue;dd(r)&&s!=="parts"&&s!=="camera"?dd(o)&&(t[s]=iE(r,o)):s==="camera"?sE(o)&&(t[s]=o):s==="frame"?(o===null||typeof o=="string")&&(t[s]=o):typeof o==typeof r&&o!==null&&(t[s]=o)}return structuredClone(t)}function dd(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)}function iE(n,e){let t={...n};for(let i of Object.keys(n)){let s=e[i];s!==void 0&&(i==="normal"||i==="offset"||typeof s==typeof n[i])&&(t[i]=s)}return t}function sE(n){return!dd(n)||!Array.isArray(n.target)||n.target.length!==3?!1:[...n.target,n.azimuth,n.elevation,n.height].every(t=>typeof t=="number"&&Number.isFinite(t))&&(n.projection==="perspective"||n.projection==="orthographic")}function Ba(n,e){return n.parts[e.name]??(e.kind==="body"?"translucent":"visible")}var rE=.05,oE=30,aE=1e-4,wu=class{constructor(e){this.scene=e;this.contacts=new nu(e.uniforms),this.forces=new au(e.uniforms),e.root.add(this.contacts.group,this.contacts.markLine,this.forces.group),e.scene.add(this.cut.group)}scene;views=[];position=null;meshes=[];colours=[];factor=0;limits=null;clipped=null;triangles=0;cut=new ru;contacts;forces;centre=new G;radius=1;sectionTime=0;#e=new gu;#t=[];#n=new WeakMap;#i=new WeakMap;#s=!1;#r=!1;#o=null;#a=new vt;#l=!1;setParts(e,t){this.clear();let i=new Map;this.#o=t?.poses??null,this.colours=e.map(({kind:r})=>{let o=i.get(r)??0;return i.set(r,o+1),i0(r,o)}),this.views=e.map((r,o)=>{let a=new xu(r,this.scene.uniforms,this.cut.capGeometry,this.colours[o]);return this.scene.root.add(a.group),this.scene.scene.add(a.cap),a}),this.meshes=e.map(()=>[]);let s=new ti().setFromPoints(this.views.flatMap(r=>this.outline(r))).getBoundingSphere(new jn);this.centre.copy(s.center),this.radius=s.radius>0?s.radius:1,this.contacts.setBias(8e-4*this.radius),this.cut.setBounds(this.centre,this.radius),this.updateBounds()}updateBounds(){let e=this.views.filter(i=>i.visibility!=="hidden"),t=(e.length>0?e:this.views).flatMap(i=>this.outline(i));this.scene.camera.setBounds(this.centre,this.radius*1.1,t)}outline(e){let t=Ts(this.#o,e.part.index,new vt),{min:i,max:s}=e.copies.box,r=[];if(e.part.points.length===0||!Su(this.#o,e.part.index))return r;if(e.part.copies>1){let o=0,a=e.part.points;for(let l=0;l<a.length;l+=3)o=Math.max(o,Math.hypot(a[l],a[l+1]));for(let l=0;l<24;l++){let c=2*Math.PI*l/24;for(let u of[i.z,s.z])r.push(new G(o*Math.cos(c),o*Math.sin(c),u))}}else for(let o=0;o<8;o++)r.push(new G(o&1?s.x:i.x,o&2?s.y:i.y,o&4?s.z:i.z));return r.map(o=>o.applyMatrix4(t))}setPosition(e){this.position=e,this.meshes=this.views.map(()=>[]);let t=this.views.map(()=>[]),i=this.views.map(()=>new Set);this.#t=this.#e.display(e?.meshes??[],s=>this.views[s].meshMaterials),e?.meshes.forEach((s,r)=>{this.meshes[s.part].push(s),t[s.part].push(this.#t[r]),i[s.part].add(s.copy)}),this.views.forEach((s,r)=>{Ts(e?.poses??null,r,s.group.matrix),s.setPresent(Su(e?.poses??null,r)),s.setMeshes(t[r],i[r])})}values(e,t){let i=this.#n.get(e);i||this.#n.set(e,i=new Map);let s=i.get(t);return s||i.set(t,s=l0(e,t)),s}limitsOf(e,t){return this.automaticLimits(e,t,this.extremes(e,t))}automaticLimits(e,t,i){if(!i)return null;let s=ed(t.colours.field);if(s===1)return[i.min.value,i.max.value];let r=this.surfaceValues(e,t).filter(o=>o>aE*i.max.value).sort();return[i.min.value,r[Math.floor(s*(r.length-1))]??i.max.value]}surfaceValues(e,t){let i=t.colours.field,s=e.meshes.filter(({part:a})=>this.shown(t,a)),r=new Float64Array(s.reduce((a,l)=>a+l.shape.points.length/3,0)),o=0;for(let a of s){let l=td(a.shape);this.values(a,i).forEach((c,u)=>{l[u]&&Number.isFinite(c)&&(r[o++]=c)})}return r.subarray(0,o)}clippedBy(e,t,i){let{field:s,limits:r}=t.colours;if(!e||!i||!this.position||r==="fixed"||ed(s)===1)return null;let o=this.surfaceValues(this.position,t),a=o.reduce((l,c)=>l+(c>e[1]?1:0),0);return a>0?{share:a/o.length,largest:i.max.value}:null}shown(e,t){let i=this.views[t]?.part.name;return i!==void 0&&e.parts[i]!=="hidden"}cellShown(e,t,i){let s=t.contacts,{parts:r}=s;return Oa(s,i,e.colours.cells)?this.shown(e,r[2*i])||this.shown(e,r[2*i+1]):!1}extremes(e,t){let{field:i}=t.colours,s=null,r=null;if(Un(i))for(let o of e.meshes){if(!this.shown(t,o.part))continue;let a=this.values(o,i),l=td(o.shape);for(let c=0;c<a.length;c++){let u=a[c];!l[c]||!Number.isFinite(u)||((!s||u<s.value)&&(s={value:u,mesh:o,index:c}),(!r||u>r.value)&&(r={value:u,mesh:o,index:c}))}}else if(i==="contact_pressure"&&e.contacts){let o=Float64Array.from(e.contacts.pressures,(l,c)=>l>0&&this.cellShown(t,e,c)?l:NaN),a=a0(o);a&&(s={value:0,mesh:null,index:a.minIndex},r={value:a.max,mesh:null,index:a.maxIndex})}return s&&r?{min:s,max:r}:null}extremePoint(e,t){let i=new G,{mesh:s,index:r}=e;if(s)return i.set(...Er(s,r,this.factor)).applyMatrix4(Ts(t.poses,s.part,this.#a));let o=t.contacts.corners;for(let a=0;a<4;a++)i.x+=o[12*r+3*a]/4,i.y+=o[12*r+3*a+1]/4,i.z+=o[12*r+3*a+2]/4;return i}apply(e,t){let{uniforms:i}=this.scene,{colours:s}=e,r=this.position,o=Un(s.field);for(let h of this.views)h.setVisibility(Ba(e,h.part)),h.setFieldMode(o),h.setEdges(e.mesh_edges),h.setSections(this.sectionsShown(e));if(this.applyFrame(e),this.factor=this.deformationFactor(e),i.deformation.value=this.factor,o)for(let h of this.#t)h.setField(this.values(h.mesh,s.field));this.#s=e.mesh_edges;let a=r&&s.field==="contact_pressure"?r.contacts:null,l=JSON.stringify([s.cells,Object.entries(e.parts).filter(([,h])=>h==="hidden")]);this.contacts.set(a,l,h=>this.cellShown(e,r,h)),this.contacts.setBehind(e.hidden_contacts);let c=r?this.extremes(r,e):null;this.limits=this.chooseLimits(e,c,t),this.clipped=this.clippedBy(this.limits,e,c),this.limits&&i.limits.value.set(...this.limits),e0(this.scene.scaleTexture,s.scale,s.bands);let u=this.views.map(({part:h})=>h.name);this.forces.set(r?.forces??[],{...e.forces,radius:this.radius,names:u}),this.applyCut(e);let d=[...this.forces.labels];if(r&&c&&e.extremes){let h=Math.max(Math.abs(c.min.value),Math.abs(c.max.value)),f=Vi[s.field].quantity==="length"?xn("m",h):Ei(),p=(_,m,g)=>{let x=Math.abs(_.value)<1e-9*h?0:_.value*f.factor,M=this.extremePoint(_,r);this.isCutAway(M)||d.push({kind:m,text:`${g} ${Nt(x)} ${f.symbol}`,point:M})};o0(s.field)==="maximum"?p(c.max,"maximum","max"):p(c.min,"minimum","min")}return d}chooseLimits(e,t,i){let{colours:s}=e;return s.field==="plain"?null:s.limits==="fixed"?[Math.min(s.min,s.max),Math.max(s.min,s.max)]:s.limits==="all"&&i?i:this.position&&this.automaticLimits(this.position,e,t)}deformationFactor(e){let{mode:t,factor:i}=e.deformation;if(t==="factor")return Number.isFinite(i)?i:0;if(!Un(e.colours.field))return 0;let s=this.position?this.largestDisplacement(this.position):0;return s>0?m0(rE*2*this.radius/s):1}largestDisplacement(e){let t=this.#i.get(e);if(t===void 0){t=0;for(let{displacements:i}of e.meshes)for(let s=0;s<i.length;s+=3)t=Math.max(t,i[s]**2+i[s+1]**2+i[s+2]**2||0);this.#i.set(e,t)}return Math.sqrt(t)}applyFrame(e){let{root:t}=this.scene;t.matrix.identity();let i=this.views.findIndex(r=>r.part.name===e.frame),s=r=>r&&Su(r,i);i>=0&&this.position&&s(this.#o)&&s(this.position.poses)&&(Ts(this.#o,i,t.matrix),t.matrix.multiply(Ts(this.position.poses,i,this.#a).invert())),t.updateMatrixWorld(!0)}applyCut(e){this.cut.apply(e.cut,this.scene.uniforms.cutPlane.value);for(let t of this.views)t.cap.matrix.copy(this.cut.capMatrix),t.cap.updateMatrixWorld(!0);if(this.#l!==e.cut.on){this.#l=e.cut.on;for(let t of this.views)t.setCut(this.#l);for(let t of this.contacts.materials)t.cut=this.#l}}isCutAway(e){let t=this.cutPlane,i=I0.copy(e).applyMatrix4(this.scene.root.matrix);return t!==null&&t.x*i.x+t.y*i.y+t.z*i.z+t.w>0}get cutPlane(){return this.#l?this.scene.uniforms.cutPlane.value:null}setDragging(e,t){if(e!==this.#r){this.#r=e;for(let i of this.views)i.setSections(this.sectionsShown(t));this.scene.invalidate()}}sectionsShown(e){return(Un(e.colours.field)||e.mesh_edges)&&!(this.#r&&this.sectionTime>oE)}updateSections(){let e=performance.now(),t=!1;for(let i of this.views){let s=i.showsSections?this.planeOf(i):null;for(let r of i.meshes)if(r.section)if(s&&r.mesh){let o=i.showsField?r.values:null;t=r.section.update(r.mesh,o,s,this.factor,this.#s)||t}else r.section.hide()}t&&(this.sectionTime=performance.now()-e)}planeOf(e){let{x:t,y:i,z:s,w:r}=this.scene.uniforms.cutPlane.value,o=e.group.matrixWorld.elements;return[o[0]*t+o[1]*i+o[2]*s,o[4]*t+o[5]*i+o[6]*s,o[8]*t+o[9]*i+o[10]*s,o[12]*t+o[13]*i+o[14]*s+r]}prepareFrame(){this.updateSections();let e=this.scene.frustum(),{active:t,state:i,direction:s}=this.scene.camera,r=this.scene.height/i.height,o=t.position.distanceTo(lE.fromArray(i.target)),a=i.projection==="orthographic",l=c=>{if(a)return r;let u=I0.copy(t.position).sub(c).dot(s);return u>0?r*o/u:r};this.triangles=0;for(let c of this.views)this.triangles+=c.prepare(e,l)}clear(){for(let e of this.views)e.group.removeFromParent(),e.cap.removeFromParent(),e.dispose();this.#e.dispose(),this.#t=[],this.views=[],this.position=null,this.#l=!1;for(let e of this.contacts.materials)e.cut=!1}dispose(){this.clear(),this.contacts.dispose(),this.forces.dispose()}},lE=new G,I0=new G;function Su(n,e){return!n||n.subarray(12*e,12*e+12).every(Number.isFinite)}function Ts(n,e,t){if(!n||!Su(n,e))return t.identity();let[i,s,r,o,a,l,c,u,d,h,f,p]=n.subarray(12*e,12*e+12);return t.set(i,s,r,h,o,a,l,f,c,u,d,p,0,0,0,1)}var cE=(n,e)=>n.left<e.right&&e.left<n.right&&n.top<e.bottom&&e.top<n.bottom,[Eu,pd]=[9,9];function L0(n,e,t,i){let s=n==="right"?e+Eu:n==="left"?e-Eu-i:e-i/2,r=n==="above"?t-Eu-2*pd:n==="below"?t+Eu:t-pd;return{left:s,top:r,right:s+i,bottom:r+2*pd}}var Tu=class{element=document.createElement("div");#e=[];#t=[];#n=[];#i=new G;constructor(){this.element.className="cv-labels"}set(e){for(let t of e)t.hidden??=this.#e.find(({kind:i})=>i===t.kind)?.hidden;for(this.#e=e;this.#t.length>e.length;)this.#t.pop().remove();e.forEach((t,i)=>{let s=this.#t[i];s||(s=document.createElement("div"),s.append(document.createElement("i"),document.createElement("span")),this.#t.push(s),this.element.append(s)),s.className=`cv-label cv-label-${t.kind}${t.hidden?" cv-label-hidden":""} ${D0(this.#n[i])}`,s.lastElementChild.textContent=t.text})}hide(e){this.#e.forEach((t,i)=>{t.kind!=="maximum"&&t.kind!=="minimum"||(t.hidden=e(t.point),this.#t[i].classList.toggle("cv-label-hidden",t.hidden))})}arrange(e,t,i){let{left:s,top:r}=this.element.getBoundingClientRect(),o=i?[{left:i.left-s,top:i.top-r,right:i.right-s,bottom:i.bottom-r}]:[],a=({kind:h})=>h==="maximum"||h==="minimum",l=h=>a(h)?1/0:h.weight??0,c=this.#e.map((h,f)=>f).sort((h,f)=>l(this.#e[f])-l(this.#e[h])||h-f),u=this.#t.map(h=>h.lastElementChild.offsetWidth),d=this.#t.map(h=>h.getBoundingClientRect());for(let h of c){if(this.#t[h].style.display==="none")continue;let[f,p]=[d[h].x-s,d[h].y-r],_=x=>x.left>=0&&x.right<=e&&x.top>=0&&x.bottom<=t&&!o.some(M=>cE(x,M)),g=["right","left","above","below"].filter(x=>_(L0(x,f,p,u[h])))[0]??(a(this.#e[h])?"right":null);g&&o.push(L0(g,f,p,u[h])),this.#t[h].classList.remove(...uE),this.#t[h].classList.add(D0(g)),this.#n[h]=g}}update(e,t,i,s){this.#e.forEach((r,o)=>{let a=this.#i.copy(r.point).applyMatrix4(t).project(e),l=a.z>-1&&a.z<1&&Math.abs(a.x)<1.02&&Math.abs(a.y)<1.02,{style:c}=this.#t[o];c.display=l?"":"none",l&&(c.transform=`translate(${(.5+.5*a.x)*i}px, ${(.5-.5*a.y)*s}px)`)})}placed(e,t,i,s){return this.#e.map((r,o)=>{let a=r.point.clone().applyMatrix4(t).project(e);return{...r,x:(.5+.5*a.x)*i,y:(.5-.5*a.y)*s,depth:a.z,side:this.#n[o]===void 0?"right":this.#n[o]}}).filter(r=>r.side!==null&&r.depth>-1&&r.depth<1&&r.x>0&&r.x<i&&r.y>0&&r.y<s)}},uE=["right","left","above","below","unplaced"].map(n=>`cv-label-${n}`);function D0(n){return`cv-label-${n===void 0?"right":n??"unplaced"}`}function gd(n,e,t,i,s){let[r,o,a]=n.origin,[l,c,u]=n.direction,d=null,h=1/0;for(let f=0;f<t.length;f+=3){let p=3*t[f],_=3*t[f+1],m=3*t[f+2],g=e[p],x=e[p+1],M=e[p+2],y=e[_],C=e[_+1],A=e[_+2],v=e[m],w=e[m+1],U=e[m+2];if(i){let{cos:qe,sin:Fe,displacements:Je,factor:Ze}=i,[je,Ot,Ct]=[g,y,v];g=qe*je-Fe*x+Ze*Je[p],x=Fe*je+qe*x+Ze*Je[p+1],M+=Ze*Je[p+2],y=qe*Ot-Fe*C+Ze*Je[_],C=Fe*Ot+qe*C+Ze*Je[_+1],A+=Ze*Je[_+2],v=qe*Ct-Fe*w+Ze*Je[m],w=Fe*Ct+qe*w+Ze*Je[m+1],U+=Ze*Je[m+2]}let L=y-g,I=C-x,O=A-M,z=v-g,N=w-x,W=U-M,$=c*W-u*N,V=u*z-l*W,le=l*N-c*z,J=L*$+I*V+O*le;if(J===0)continue;let Q=1/J,ie=r-g,fe=o-x,he=a-M,ee=(ie*$+fe*V+he*le)*Q;if(ee<-1e-9||ee>1+1e-9)continue;let me=fe*O-he*I,ge=he*L-ie*O,Se=ie*I-fe*L,xe=(l*me+c*ge+u*Se)*Q;if(xe<-1e-9||ee+xe>1+1e-9)continue;let He=(z*me+N*ge+W*Se)*Q;He<=s||He>=h||(h=He,d={distance:He,triangle:f,u:ee,v:xe,facing:J>0})}return d}function Au(n,e,t){if(!t)return[0,1/0];let i=t.x*n.x+t.y*n.y+t.z*n.z+t.w,s=t.x*e.x+t.y*e.y+t.z*e.z;if(s===0)return i>0?[1/0,1/0]:[0,1/0];let r=-i/s;return s<0?[Math.max(0,r),1/0]:[0,r]}var md=new vt,Tr=new G,Ar=new G,tr=new bi,N0=new jn;function Cu(n,e,t,i,s){let[r,o]=Au(n.origin,n.direction,s),a=null,l=(c,u,d,h,f,p)=>{if(!h)return;let _=s!==null&&r>0&&!h.facing&&!p,m=_?r:h.distance;if(m>o||a&&m>=a.distance)return;let g=h.triangle;a={view:c,copy:u,mesh:d,nodes:[f[g],f[g+1],f[g+2]],weights:[1-h.u-h.v,h.u,h.v],distance:m,point:n.at(m,new G),cap:_}};for(let c of e){if(c.visibility!=="visible"||!c.present)continue;md.copy(c.group.matrixWorld).invert(),Tr.copy(n.origin).applyMatrix4(md),Ar.copy(n.direction).transformDirection(md);let u=c.copies.sphere;for(let h of c.presentCopies){let f=-2*Math.PI*h/c.part.copies,p=Math.cos(f),_=Math.sin(f);if(tr.origin.set(p*Tr.x-_*Tr.y,_*Tr.x+p*Tr.y,Tr.z),tr.direction.set(p*Ar.x-_*Ar.y,_*Ar.x+p*Ar.y,Ar.z),N0.copy(u),!tr.intersectsSphere(N0)||!tr.intersectsBox(c.copies.box))continue;let m=gd(_d(tr),c.part.points,c.part.triangles,null,r);l(c,h,-1,m,c.part.triangles,c.part.open)}tr.origin.copy(Tr),tr.direction.copy(Ar),(t[c.part.index]??[]).forEach((h,f)=>{let{points:p,triangles:_}=h.shape,{cos:m,sin:g,displacements:x}=h,M=gd(_d(tr),p,_,{cos:m,sin:g,displacements:x,factor:i},r);l(c,-1,f,M,_,h.shape.open)})}return a}function _d(n){return{origin:[n.origin.x,n.origin.y,n.origin.z],direction:[n.direction.x,n.direction.y,n.direction.z]}}function F0(n,e,t,i){let s=null,r=_d(n);for(let o=0;o<e.count;o++){if(!(e.pressures[o]>0)||!t(o))continue;let a=e.corners.subarray(12*o,12*o+12),l=gd(r,a,hE,null,i[0]);l&&l.distance<i[1]&&(!s||l.distance<s.distance)&&(s={cell:o,distance:l.distance})}return s}var hE=new Uint32Array([0,1,2,0,2,3]);var Ru=new bi,xd=new G,Pu=new G;function U0(n,e,t){xd.copy(t).applyMatrix4(n.root.matrixWorld),Pu.copy(xd).project(n.camera.active),n.ray((.5+.5*Pu.x)*n.width,(.5-.5*Pu.y)*n.height,Ru);let i=Cu(Ru,e.views,e.meshes,e.factor,e.cutPlane);if(!i)return!1;let s=Pu.copy(xd).sub(Ru.origin).dot(Ru.direction),r=.001*e.radius;return i.distance<s-r}var O0=2*Math.PI/180,B0=new WeakMap;function nr(n){let e=B0.get(n);return e===void 0&&B0.set(n,e=n.copies>1?fE(n):null),e}function fE({points:n,triangles:e}){let t=gE(n,e),i=e.length/3,s=dE(n,e),r=new Float64Array(i),o=new Float64Array(i);for(let f=0;f<i;f++){let[p,_,m]=[3*e[3*f],3*e[3*f+1],3*e[3*f+2]],[g,x,M]=[n[_]-n[p],n[_+1]-n[p+1],n[_+2]-n[p+2]],[y,C,A]=[n[m]-n[p],n[m+1]-n[p+1],n[m+2]-n[p+2]],[v,w,U]=[x*A-M*C,M*y-g*A,g*C-x*y],L=Math.hypot(v,w,U),[I,O]=[n[p]+n[_]+n[m],n[p+1]+n[_+1]+n[m+1]];L>0&&(o[f]=L/2,r[f]=(w*I-v*O)/(Math.hypot(I,O)||1))}let a=r.map((f,p)=>{let _=s[p];return _<0?f/(2*o[p]||1):(f+r[_])/(2*(o[p]+o[_])||1)}),l=a.reduce((f,p)=>Math.max(f,Math.abs(p)),0),c=f=>{let p=[];for(let m=0;m<i;m++)o[m]>0&&f*a[m]>.35*l&&p.push(m);let _=_E(n,e,t,o,p);return _&&{outline:xE(n,e,p),angle:_}},[u,d]=[c(1),c(-1)];if(!u||!d)return null;let h=pE(u.angle,d.angle);return{flanks:{left:u,right:d},direction:h,tip:mE(u,d,h)}}function dE(n,e){let t=new Int32Array(e.length/3).fill(-1),i=new Map,s=(r,o)=>Math.hypot(n[3*r]-n[3*o],n[3*r+1]-n[3*o+1],n[3*r+2]-n[3*o+2]);for(let r=0;r<t.length;r++){let o=[...e.subarray(3*r,3*r+3)],a=o.map((h,f)=>[h,o[(f+1)%3]]),[l,c]=a.reduce((h,f)=>s(...f)>s(...h)?f:h),u=l<c?`${l} ${c}`:`${c} ${l}`,d=i.get(u);d===void 0?i.set(u,r):[t[r],t[d]]=[d,r]}return t}function pE(n,e){let t=n[1]-e[1],i=n[2]-e[2];if(!(Math.hypot(t,i)>0))return 0;let s=Math.atan2(i>=0?-t:t,Math.abs(i));return Math.abs(s)<O0?0:Math.abs(s)>Math.PI/2-O0?Math.PI/2:s}function mE(n,e,t){let i=n.outline[0]??[],s=a=>i.reduce((l,c,u)=>u%2===a?l+2*c/i.length:l,0),r=ka(n.angle,s(0),s(1))-ka(e.angle,s(0),s(1));return(Math.cos(t)*(n.angle[2]-e.angle[2])-Math.sin(t)*(n.angle[1]-e.angle[1]))*r<=0?1:-1}function gE(n,e){let t=n.length/3,[i,s]=[0,0];for(let h=0;h<n.length;h+=3)i+=n[h],s+=n[h+1];let r=Math.atan2(s,i),o=(h,f)=>h-2*Math.PI*Math.round((h-f)/(2*Math.PI)),a=h=>Math.atan2(n[3*h+1],n[3*h]),l=new Uint32Array(t+1);for(let h of e)l[h+1]++;for(let h=0;h<t;h++)l[h+1]+=l[h];let c=l.slice(0,t),u=new Uint32Array(e.length);e.forEach((h,f)=>u[c[h]++]=f);let d=new Float64Array(t).fill(NaN);for(let h=0;h<t;h++){if(!Number.isNaN(d[h]))continue;d[h]=o(a(h),r);let f=[h];for(let p=f.pop();p!==void 0;p=f.pop())for(let _=l[p];_<l[p+1];_++){let m=u[_]-u[_]%3;for(let g=0;g<3;g++){let x=e[m+g];Number.isNaN(d[x])&&(d[x]=o(a(x),d[p]),f.push(x))}}}return d}function _E(n,e,t,i,s){let r=s.map(m=>{let[g,x,M]=[0,0,0];for(let y=0;y<3;y++){let C=e[3*m+y];g+=n[3*C+2]/3,x+=Math.hypot(n[3*C],n[3*C+1])/3,M+=t[C]/3}return[i[m],g,x,M]}),o=r.reduce((m,[g])=>m+g,0);if(!(o>0))return null;let a=[1,2,3].map(m=>r.reduce((g,x)=>g+x[0]*x[m],0)/o),[l,c,u,d,h]=[0,0,0,0,0];for(let[m,g,x,M]of r){let[y,C,A]=[g-a[0],x-a[1],M-a[2]];l+=m*y*y,c+=m*y*C,u+=m*C*C,d+=m*y*A,h+=m*C*A}let f=l*u-c*c,[p,_]=f>1e-12*(l+u)**2?[(d*u-h*c)/f,(h*l-d*c)/f]:[0,0];return[a[2]-p*a[0]-_*a[1],p,_]}function xE(n,e,t){let i=new Map,s=c=>{let u=`${n[3*c]} ${n[3*c+1]} ${n[3*c+2]}`,d=i.get(u);return d===void 0&&i.set(u,c),d??c},r=new Set;for(let c of t){let u=[0,1,2].map(d=>s(e[3*c+d]));for(let d=0;d<3;d++){let[h,f]=[u[d],u[(d+1)%3]];r.delete(`${f} ${h}`)||r.add(`${h} ${f}`)}}let o=new Map;for(let c of r){let[u,d]=c.split(" ").map(Number);o.set(u,[...o.get(u)??[],d])}let a=[];for(let c of o.keys()){let u=[];for(let d=c;d!==void 0&&!(u.length>0&&d===c);d=o.get(d)?.pop())u.push(n[3*d+2],Math.hypot(n[3*d],n[3*d+1]));u.length>4&&a.push(u)}let l=Math.max(...a.map(k0),0);return a.filter(c=>k0(c)>.02*l)}function k0(n){let e=0;for(let t=0;t<n.length;t+=2){let[i,s,r,o]=[n[t],n[t+1],n[(t+2)%n.length],n[(t+3)%n.length]];e+=i*o-s*r}return Math.abs(e)/2}function ka([n,e,t],i,s){return n+e*i+t*s}function vd(n,e,t){let{contacts:i,poses:s}=n;if(!i)return[];let r=s.subarray(12*e.index,12*e.index+12),o=nr(e),a=[];for(let u=0;u<i.count;u++){let d=i.pressures[u];if(!(!(d>0)||!Oa(i,u,t)))for(let h=0;h<2;h++){if(i.parts[2*u+h]!==e.index)continue;let f=[],[p,_]=[0,0];for(let A=0;A<4;A++){let v=vE(r,i.corners.subarray(12*u+3*A,12*u+3*A+3));f.push(v[2],Math.hypot(v[0],v[1])),p+=v[0]/4,_+=v[1]/4}let[m,g]=yE(f),x=i.teeth[2*u+h],M=o?(ka(o.flanks.left.angle,m,g)+ka(o.flanks.right.angle,m,g))/2:0,y=Math.atan2(_,p)-2*Math.PI*x/e.copies-M,C=Math.atan2(Math.sin(y),Math.cos(y));a.push({cell:u,tooth:x,side:"left",pressure:d,corners:f,surface:i.surfaces[2*u+h],offset:C})}}let l=new Map,c=u=>`${u.tooth} ${u.surface}`;for(let u of a)l.set(c(u),(l.get(c(u))??0)+u.pressure*u.offset);return a.map(({surface:u,offset:d,...h})=>({...h,side:l.get(c({...h,surface:u}))>=0?"left":"right"})).sort((u,d)=>u.pressure-d.pressure)}function vE(n,e){let[t,i,s]=[e[0]-n[9],e[1]-n[10],e[2]-n[11]];return[n[0]*t+n[3]*i+n[6]*s,n[1]*t+n[4]*i+n[7]*s,n[2]*t+n[5]*i+n[8]*s]}function yE(n){return[(n[0]+n[2]+n[4]+n[6])/4,(n[1]+n[3]+n[5]+n[7])/4]}function z0(n){let e=0;for(let{side:t,pressure:i,corners:s}of n){let r=Math.abs((s[4]-s[0])*(s[7]-s[3])-(s[5]-s[1])*(s[6]-s[2]))/2;e+=(t==="left"?1:-1)*i*r}return e>=0?"left":"right"}function yd(n,{tooth:e,side:t}){return n.side===t&&(e===null||n.tooth===e)}var Iu=class{constructor(e,t=1){this.direction=e;this.tip=t;this.cos=Math.cos(e),this.sin=Math.sin(e),this.#e=this.sin<0?-1:1,this.#t=e===0?1:t}direction;tip;cos;sin;#e;#t;along(e,t){return this.#e*(this.cos*e+this.sin*t)}across(e,t){return this.#t*(this.cos*t-this.sin*e)}inverse(e,t){let[i,s]=[this.#e*e,this.#t*t];return[this.cos*i-this.sin*s,this.sin*i+this.cos*s]}get ends(){return this.direction!==0?["toe","heel","root","tip"]:this.tip>0?["−z end","+z end","root","tip"]:["−z end","+z end","tip","root"]}};function bd(n,e,t){let i={u0:1/0,u1:-1/0,v0:1/0,v1:-1/0},s=(o,a)=>{let[l,c]=[t.along(o,a),t.across(o,a)];i.u0=Math.min(i.u0,l),i.u1=Math.max(i.u1,l),i.v0=Math.min(i.v0,c),i.v1=Math.max(i.v1,c)},r=nr(n)?.flanks[e].outline??[];for(let o of r)for(let a=0;a<o.length;a+=2)s(o[a],o[a+1]);if(r.length===0){let o=n.points;for(let a=0;a<o.length;a+=3)s(o[a+2],Math.hypot(o[a],o[a+1]))}return!(i.u1>i.u0)||!(i.v1>i.v0)?{u0:-.001,u1:.001,v0:0,v1:.001}:i}function H0(n,e,t){let i=bd(n,e,t),s=.03*Math.max(i.u1-i.u0,i.v1-i.v0);return{u0:i.u0-s,u1:i.u1+s,v0:i.v0-s,v1:i.v1+s}}function V0(n,e,t){let[i,s]=[!1,!1];for(let r=0;r<8;r+=2){let[o,a,l,c]=[n[r],n[r+1],n[(r+2)%8],n[(r+3)%8]],u=(l-o)*(t-a)-(c-a)*(e-o);u>0&&(i=!0),u<0&&(s=!0)}return!(i&&s)}function G0(n,e,t){for(let i=n.length-1;i>=0;i--)if(V0(n[i].corners,e,t))return n[i];return null}var Lu=class{constructor(e,t,i=320){this.bounds=e;this.axes=t;this.columns=i,this.rows=Math.min(Math.max(Math.round(i*(e.v1-e.v0)/(e.u1-e.u0)),40),640),this.values=new Float32Array(this.columns*this.rows)}bounds;axes;columns;rows;values;included=new Set;largest=0;column(e){return(e-this.bounds.u0)/(this.bounds.u1-this.bounds.u0)*this.columns}row(e){return(e-this.bounds.v0)/(this.bounds.v1-this.bounds.v0)*this.rows}add(e){let{columns:t,rows:i,values:s}=this;for(let{corners:r,pressure:o}of e){this.largest=Math.max(this.largest,o);let a=[];for(let h=0;h<8;h+=2){let[f,p]=[r[h],r[h+1]];a.push(this.column(this.axes.along(f,p)),this.row(this.axes.across(f,p)))}let l=[a[0],a[2],a[4],a[6]],c=[a[1],a[3],a[5],a[7]],u=!1,d=(h,f)=>{if(u=!0,h<0||f<0||h>=t||f>=i)return;let p=f*t+h;o>s[p]&&(s[p]=o)};for(let h=Math.max(0,Math.floor(Math.min(...c)));h<=Math.min(i-1,Math.floor(Math.max(...c)));h++)for(let f=Math.max(0,Math.floor(Math.min(...l)));f<=Math.min(t-1,Math.floor(Math.max(...l)));f++)V0(a,f+.5,h+.5)&&d(f,h);u||d(Math.floor(l.reduce((h,f)=>h+f)/4),Math.floor(c.reduce((h,f)=>h+f)/4))}}at(e,t){let[i,s]=[Math.floor(this.column(e)),Math.floor(this.row(t))];return i<0||s<0||i>=this.columns||s>=this.rows?0:this.values[s*this.columns+i]}};var bE=25,Du=class{constructor(e){this.core=e}core;pointed=new Map;hovered=-1;#e=null;#t=null;#n="";#i=null;#s=0;#r=!1;gears(){let e=this.core.display?.position?.contacts,t=this.core.parts?.parts??[],i=new Set(e?.parts),s=this.core.state.pattern.gear;return t.filter(r=>r.kind==="gear"&&(i.has(r.index)||r.name===s))}teeth(e){return[...new Set(this.cellsOf(e).map(({tooth:t})=>t))].sort((t,i)=>t-i)}pattern(){let{core:e}=this,{display:t,state:i}=e,s=this.gears(),r=s.find(({name:_})=>_===i.pattern.gear)??s[0];if(!r||!t)return null;let o=new Iu(nr(r)?.direction??0,nr(r)?.tip),a=this.cellsOf(r),l=this.tooth(r),c=i.pattern.flank==="automatic"?z0(a.filter(_=>l===null||_.tooth===l)):i.pattern.flank,u=H0(r,c,o),d=i.pattern.envelope?this.envelope(r,o,u,{tooth:l,side:c}):null,h=d?[]:a.filter(_=>yd(_,{tooth:l,side:c})),f=d?.largest??h[h.length-1]?.pressure??0,p=i.colours.field==="contact_pressure"?t.limits:null;return{part:r,axes:o,bounds:u,tooth:l,side:c,cells:h,envelope:d,largest:f,limits:p??[0,f>0?f:1]}}tooth(e){let{tooth:t}=this.core.state.pattern;return t==="pointer"?this.pointed.get(e.index)??null:t!=="all"&&/^\d+$/.test(t)?Number(t):null}cellsOf(e){let t=this.core.display?.position;if(!t)return[];let i=this.core.state.colours.cells,s=this.#e;if(s?.position===t&&s.part===e&&s.choice===i)return s.cells;let r=vd(t,e,i);return this.#e={position:t,part:e,choice:i,cells:r},r}envelope(e,t,i,s){let{positions:r,state:o}=this.core,a=JSON.stringify([e.name,s,o.colours.cells]);return!this.#t||a!==this.#n||r!==this.#i?(this.#t=new Lu(i,t),this.#n=a,this.#i=r,this.#s++,this.fill(this.#t,e,s,this.#s)):this.#t.included.size<(r?.list.length??0)&&!this.#r&&(this.#s++,this.fill(this.#t,e,s,this.#s)),this.#t}async fill(e,t,i,s){let{core:r}=this,{positions:o}=r,a=()=>s===this.#s&&o===r.positions&&r.state.panels.pattern&&r.state.pattern.envelope;this.#r=!0;let l=performance.now();for(let c=0;o&&c<o.list.length&&a();c++){if(e.included.has(c))continue;let u=await o.load(c).catch(()=>null);if(!a())break;e.included.add(c),u&&e.add(vd(u,t,r.state.colours.cells).filter(d=>yd(d,i))),!(performance.now()-l<bE)&&(r.changed(!1),await new Promise(d=>setTimeout(d)),l=performance.now())}s===this.#s&&(this.#r=!1),r.changed(!1)}};var ME=6,ir=new bi,Md=new bi,Eo=new vt;function X0(n,e,t){let{scene:i,display:s,state:r}=n;if(!i||!s)return null;i.ray(e,t,ir);let o=s.cutPlane,a=o&&Un(r.colours.field)?wE(n,e,t,o):null;if(a)return a;let l=Cu(ir,s.views,s.meshes,s.factor,o),c=AE(n,e,t,l?.distance??1/0);if(c)return c;if(!l)return null;let{part:u}=l.view,d=new G,h=s.meshes[u.index]?.[l.mesh],f=r.colours.field==="plain"?null:NaN,p=null,_=null;if(l.cap)return d.copy(l.point).applyMatrix4(Eo.copy(l.view.group.matrixWorld).invert()),d.applyMatrix4(Ts(s.position?.poses??null,u.index,Eo)),_=u.copies>1?h?.copy??l.copy:null,{x:e,y:t,part:u.name,tooth:_,value:null,node:p,point:d};if(h){if(p=TE(n,h,l,e,t),p!==null?d.set(...Er(h,p,0)):l.nodes.forEach((m,g)=>d.addScaledVector(q0.set(...Er(h,m,0)),l.weights[g])),Un(r.colours.field)){let m=s.values(h,r.colours.field);f=p!==null?m[p]:l.nodes.reduce((g,x,M)=>g+l.weights[M]*m[x],0)}_=u.copies>1?h.copy:null}else EE(u.points,l,d),d.applyAxisAngle(SE,2*Math.PI*l.copy/u.copies),_=u.copies>1?l.copy:null;return d.applyMatrix4(Ts(s.position?.poses??null,u.index,Eo)),{x:e,y:t,part:u.name,tooth:_,value:f,node:p,point:d}}var SE=new G(0,0,1),q0=new G;function wE(n,e,t,i){let{display:s,state:r}=n,{field:o}=r.colours;if(!s||!Un(o))return null;let[a]=Au(ir.origin,ir.direction,i);if(!(a>0)||!Number.isFinite(a))return null;let l=ir.at(a,new G);for(let c of s.views){if(!c.showsSections)continue;let u=l.clone().applyMatrix4(Eo.copy(c.group.matrixWorld).invert());for(let{mesh:d,section:h}of c.meshes){if(!d||!h?.plane)continue;let f=h.section.find(u.x,u.y,u.z,h.plane);if(f<0)continue;let{nodes:p,weights:_}=S0(d,h.section.sources[f],s.factor,[u.x,u.y,u.z]),m=s.values(d,o),g=new G;p.forEach((M,y)=>g.addScaledVector(q0.set(...Er(d,M,0)),_[y])),g.applyMatrix4(Ts(s.position?.poses??null,c.part.index,Eo));let x=p.reduce((M,y,C)=>M+_[C]*m[y],0);return{x:e,y:t,part:c.part.name,tooth:c.part.copies>1?d.copy:null,value:x,node:null,point:g}}}return null}function EE(n,e,t){t.set(0,0,0),e.nodes.forEach((i,s)=>{let r=e.weights[s];t.x+=r*n[3*i],t.y+=r*n[3*i+1],t.z+=r*n[3*i+2]})}function TE(n,e,t,i,s){let r=n.scene,o=n.display.factor,a=null,l=ME,c=new G;for(let u of t.nodes){c.set(...Er(e,u,o)),c.applyMatrix4(t.view.group.matrixWorld).project(r.camera.active);let d=Math.hypot((.5+.5*c.x)*r.width-i,(.5-.5*c.y)*r.height-s);d<=l&&(l=d,a=u)}return a}function AE(n,e,t,i){let{display:s,state:r}=n,o=s?.position,a=r.colours.field==="contact_pressure"?o?.contacts:null;if(!a||!o||!s)return null;let l=Eo.copy(n.scene.root.matrixWorld).invert();Md.copy(ir).applyMatrix4(l);let c=Au(ir.origin,ir.direction,s.cutPlane);r.hidden_contacts||(c[1]=Math.min(c[1],i+.002*s.radius));let u=F0(Md,a,p=>s.cellShown(r,o,p),c);if(!u)return null;let d=Md.at(u.distance,new G),h=r.parts[W0(n,a.parts[2*u.cell])]==="hidden"?1:0,f=a.parts[2*u.cell+h];return{x:e,y:t,part:W0(n,f),tooth:a.teeth[2*u.cell+h],cell:u.cell,value:a.pressures[u.cell],node:null,point:d}}function W0(n,e){return n.parts?.parts[e]?.name??`part ${e}`}var To=new Map;function $0(n,e,t){let i=To.get(n);if(!i){let s=t(n).then(o=>R0(n,o)),r={shape:s,users:new Set};To.set(n,r),s.catch(()=>To.get(n)===r&&To.delete(n)),i=r}return i.users.add(e),i.shape}function Sd(n){for(let[e,{users:t}]of To)t.delete(n)&&t.size===0&&To.delete(e)}async function wd(n,e){try{let t=atob(n),i=new Uint8Array(t.length);for(let r=0;r<t.length;r++)i[r]=t.charCodeAt(r);let s=new Blob([i]).stream().pipeThrough(new DecompressionStream("gzip"));return await new Response(s).arrayBuffer()}catch(t){let i=t instanceof Error?t.message:String(t);throw new Error(`${e}: the compressed data are damaged (${i})`)}}function Ed(n){let e=n.positions??[];return{title:n.title,provenance:n.provenance,outputs:n.outputs,parts:()=>wd(n.parts,"parts.bin"),positions:async()=>e.map(({position:t,time:i})=>({position:t,time:i})),position:t=>{let i=e[t];return i?wd(i.data,Nu(i.position)):Promise.reject(new Error(`position ${t} does not exist`))},mesh:t=>{let i=n.meshes?.[t];return i===void 0?Promise.reject(new Error(`${t}: the page does not contain this file`)):wd(i,t)}}}function Nu(n){return`position-${String(n).padStart(4,"0")}.bin`}var CE=384e6,Fu=class{constructor(e,t){this.source=e;this.parts=t}source;parts;list=[];#e=new Map;#t=new Map;#n=0;#i=!1;async update(){this.list=await this.source.positions()}cached(e){return this.#e.get(e)}load(e){let t=this.#e.get(e);if(t)return this.#e.delete(e),this.#e.set(e,t),Promise.resolve(t);let i=this.#t.get(e);if(i)return i;let s=this.read(e).finally(()=>this.#t.delete(e));return this.#t.set(e,s),s}async read(e){let t=this.list[e],i=Nu(t?.position??e),s=await P0(i,await this.source.position(e),this.parts,r=>$0(r,this,async o=>{if(!this.source.mesh)throw new Error(`${o}: this source contains no meshes`);return this.source.mesh(o)}));if(this.#i&&Sd(this),this.#i||s.problem)return s;this.#e.set(e,s),this.#n+=s.bytes;for(let[r,o]of this.#e){if(this.#n<=CE||r===e)break;this.#e.delete(r),this.#n-=o.bytes}return s}dispose(){this.#i=!0,Sd(this),this.#e.clear(),this.#n=0}};var Td=24,RE=260,PE={front:[-90,0],back:[90,0],left:[180,0],right:[0,0],top:[-90,90],bottom:[-90,-90],isometric:[-50,30]},Uu=class{perspective=new Kn(Td);orthographic=new po;onChange=null;#e={projection:"perspective",target:[0,0,0],azimuth:-50,elevation:30,height:1};#t=1;#n=new G;#i=1;#s=[];#r=!1;#o=!1;#a=0;#l=new G;#u=new G;#c=new G;get active(){return this.#e.projection==="perspective"?this.perspective:this.orthographic}get state(){let e={...this.#e,target:[...this.#e.target]};return this.#r?e.fitted=!0:delete e.fitted,e}setBounds(e,t,i){this.#n.copy(e),this.#i=t>0?t:1,this.#s=i,this.update()}setFitPoints(e){this.#s=e}setAspect(e){this.#t=e>0?e:1,this.#r&&Object.assign(this.#e,this.fitted(this.#e.azimuth,this.#e.elevation)),this.update()}set(e,t=!1){this.interrupt(),this.#e={...e,target:[...e.target]},e.fitted&&(Object.assign(this.#e,this.fitted(e.azimuth,e.elevation)),this.#r=!0),this.changed(t)}setProjection(e){this.#e.projection=e,this.changed(!0)}orbit(e,t){this.interrupt(),this.#e.azimuth=Cd(this.#e.azimuth+e),this.#e.elevation=Ad(this.#e.elevation+t,-90,90),this.changed(!0)}pan(e,t){this.interrupt(),this.shift(e,t),this.changed(!0)}zoom(e,t=0,i=0){this.interrupt();let s=Ad(this.#e.height*e,this.#i*1e-4,this.#i*40),r=s/this.#e.height;this.shift(-t*(1-r),-i*(1-r)),this.#e.height=s,this.changed(!0)}view(e,t=!0){let[i,s]=PE[e],r={...this.#e,azimuth:i,elevation:s};this.#o=t,t&&Object.assign(r,this.fitted(i,s)),this.animateTo(r)}fit(e=!0){let t={...this.#e,...this.fitted(this.#e.azimuth,this.#e.elevation)};this.#o=!0,e?this.animateTo(t):this.set({...t,fitted:!0},!0)}interrupt(){cancelAnimationFrame(this.#a),this.#r=!1}fitted(e,t){if(this.#s.length===0){let f=2.1*this.#i/Math.min(1,this.#t);return{target:[this.#n.x,this.#n.y,this.#n.z],height:f}}let[i,s,r]=[new G,new G,new G];Y0(e,t,i,s,r);let o=new ti,a=new G,l=this.#s.map(f=>new G(f.dot(i),f.dot(s),f.dot(r)));for(let f of l)o.expandByPoint(f);let c=o.getCenter(a),u=this.#e.projection==="perspective"?Math.tan(Td*Math.PI/360):0,d=.001*this.#i;for(let f of l){let p=(f.z-c.z)*u;d=Math.max(d,2*(Math.abs(f.y-c.y)+p),2*(Math.abs(f.x-c.x)/this.#t+p))}d*=1.1;let h=i.multiplyScalar(c.x).addScaledVector(s,c.y).addScaledVector(r,c.z);return{target:[h.x,h.y,h.z],height:d}}animateTo(e){if(cancelAnimationFrame(this.#a),matchMedia("(prefers-reduced-motion: reduce)").matches){this.set({...e,fitted:this.#o},!0);return}let t=this.state,i=Cd(e.azimuth-t.azimuth),s=performance.now(),r=o=>{let a=Ad((o-s)/RE,0,1),l=a*a*(3-2*a);this.#e.azimuth=Cd(t.azimuth+l*i),this.#e.elevation=t.elevation+l*(e.elevation-t.elevation),this.#e.height=t.height*(e.height/t.height)**l;for(let c=0;c<3;c++)this.#e.target[c]=t.target[c]+l*(e.target[c]-t.target[c]);a===1&&(this.#e={...e,target:[...e.target]},this.#r=this.#o),this.changed(!0),a<1&&(this.#a=requestAnimationFrame(r))};this.#a=requestAnimationFrame(r)}shift(e,t){let{height:i,target:s}=this.#e;for(let r=0;r<3;r++){let o=this.#l.getComponent(r),a=this.#u.getComponent(r);s[r]-=i*(e*o+t*a)}}changed(e){this.update(),this.onChange?.(e)}get direction(){return this.#c}update(){let{azimuth:e,elevation:t,height:i,target:s}=this.#e;Y0(e,t,this.#l,this.#u,this.#c);let r=i/(2*Math.tan(Td*Math.PI/360)),o=s[0],a=s[1],l=s[2],c=r-(this.#n.x-o)*this.#c.x-(this.#n.y-a)*this.#c.y-(this.#n.z-l)*this.#c.z,u=1.3*this.#i+.02*i;for(let h of[this.perspective,this.orthographic])h.position.set(o+r*this.#c.x,a+r*this.#c.y,l+r*this.#c.z),h.matrix.makeBasis(this.#l,this.#u,this.#c),h.quaternion.setFromRotationMatrix(h.matrix),h.updateMatrixWorld();this.perspective.near=Math.max(c-u,r*.02),this.perspective.far=Math.max(c+u,this.perspective.near*1.1),this.perspective.aspect=this.#t,this.perspective.updateProjectionMatrix();let d=this.orthographic;d.near=c-u,d.far=c+u,d.top=i/2,d.bottom=-i/2,d.right=i/2*this.#t,d.left=-d.right,d.updateProjectionMatrix()}};function Y0(n,e,t,i,s){let r=n*Math.PI/180,o=e*Math.PI/180;t.set(-Math.sin(r),Math.cos(r),0),s.set(Math.cos(o)*Math.cos(r),Math.cos(o)*Math.sin(r),Math.sin(o)),i.crossVectors(s,t)}function Ad(n,e,t){return Math.min(Math.max(n,e),t)}function Cd(n){return((n+180)%360+360)%360-180}var Ao=class extends Error{constructor(){super("This browser cannot draw three-dimensional pictures: WebGL 2 is not available. Turn on hardware acceleration in the browser's settings, or use another browser."),this.name="NoWebGlError"}},Ou=class{constructor(e){this.container=e;this.uniforms=qg(this.scaleTexture);let t=this.canvas.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0,depth:!0,powerPreference:"high-performance"});if(!t)throw new Ao;this.#e=new Qc({canvas:this.canvas,context:t,stencil:!0,alpha:!0}),this.#e.setClearColor(0,0),this.root.matrixAutoUpdate=!1,this.scene.add(this.root),e.append(this.canvas),this.#t=new ResizeObserver(()=>this.resize()),this.#t.observe(e),this.canvas.addEventListener("webglcontextrestored",()=>this.invalidate()),this.resize()}container;canvas=document.createElement("canvas");camera=new Uu;scene=new ha;root=new Qt;uniforms;scaleTexture=t0();onPrepare=null;onFrame=null;frames=0;width=1;height=1;#e;#t;#n=0;#i=new bs;#s=new vt;resize(){this.width=Math.max(this.container.clientWidth,1),this.height=Math.max(this.container.clientHeight,1);let e=Math.min(window.devicePixelRatio||1,2);this.uniforms.pixelRatio.value=e,this.#e.setPixelRatio(e),this.#e.setSize(this.width,this.height),this.camera.setAspect(this.width/this.height),this.draw()}invalidate(){this.#n||(this.#n=requestAnimationFrame(()=>{this.#n=0,this.draw()}))}frustum(){let{active:e}=this.camera;return this.#s.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this.#i.setFromProjectionMatrix(this.#s)}draw(){this.scene.updateMatrixWorld(),this.onPrepare?.(),this.#e.render(this.scene,this.camera.active),this.frames++,this.onFrame?.()}snapshot(e){let t=this.#e.getPixelRatio(),i=document.createElement("canvas");try{this.uniforms.pixelRatio.value=e,this.#e.setPixelRatio(e),this.#e.setSize(this.width,this.height,!1),this.draw(),i.width=this.canvas.width,i.height=this.canvas.height,i.getContext("2d").drawImage(this.canvas,0,0)}finally{this.uniforms.pixelRatio.value=t,this.#e.setPixelRatio(t),this.#e.setSize(this.width,this.height),this.draw()}return i}ray(e,t,i){let{active:s}=this.camera,r=2*e/this.width-1,o=1-2*t/this.height;return i.origin.set(r,o,-1).unproject(s),i.direction.set(r,o,1).unproject(s).sub(i.origin).normalize(),i}dispose(){cancelAnimationFrame(this.#n),this.#t.disconnect(),this.scaleTexture.dispose(),this.#e.dispose(),this.#e.forceContextLoss(),this.canvas.remove()}};var Bu=class{constructor(e,t){this.element=e;this.changed=t;this.#t.addEventListener("change",this.#n)}element;changed;theme="light";#e="system";#t=matchMedia("(prefers-color-scheme: dark)");#n=()=>{this.set(this.#e),this.changed()};set(e){this.#e=e,this.theme=e==="system"?this.#t.matches?"dark":"light":e,this.element.dataset.theme=this.theme}dispose(){this.#t.removeEventListener("change",this.#n)}};var IE=640,LE=900,DE=100,zu=class{constructor(e,t,i){this.element=e;this.state=Mu(i,bu()),this.#i=i.colours?.field!==void 0,this.#s=i.colours?.cells!==void 0,this.theme=new Bu(e,()=>this.changed()),this.theme.set(this.state.theme),this.#l.observe(e);try{this.scene=new Ou(t),this.display=new wu(this.scene)}catch(o){this.fail(o instanceof Ao?o:new Ao);return}let{scene:s,display:r}=this;t.append(this.labels.element),s.onPrepare=()=>r.prepareFrame(),s.onFrame=()=>{this.labels.update(s.camera.active,s.root.matrix,s.width,s.height),this.#a||=window.setTimeout(()=>this.updateMarks(),DE)},s.camera.onChange=o=>{this.state.camera=s.camera.state,this.probe=null,s.invalidate(),this.changed(o)}}element;state;status="empty";failure="";notice="";source=null;parts=null;positions=null;probe=null;help=!1;narrow=!1;drawers=!1;drawer=null;progress=null;scene=null;display=null;labels=new Tu;animation=new iu(this);pattern=new Du(this);theme;onChange=null;#e=new Set;#t=0;#n=0;#i;#s;#r=new Map;#o="";#a=0;#l=new ResizeObserver(()=>this.resize());resize(){let e=this.element.clientWidth,t=e>0&&e<IE,i=e>0&&e<LE;t===this.narrow&&i===this.drawers||(this.narrow=t,this.drawers=i,this.drawer=null,this.element.toggleAttribute("data-narrow",t),this.element.toggleAttribute("data-drawers",i),this.changed(!1))}isOpen(e){return this.drawers?this.drawer===e:this.state.panels[e]}toggle(e,t=!this.isOpen(e)){this.drawers?this.setDrawer(t?e:null):this.update({panels:{[e]:t}})}setDrawer(e){this.drawer=e,this.changed(!1)}subscribe(e){return this.#e.add(e),()=>this.#e.delete(e)}changed(e=!0){e&&(this.#u=!0),!this.#t&&(this.#t=requestAnimationFrame(()=>{this.#t=0;for(let t of this.#e)t();this.#u&&this.onChange?.(structuredClone(this.state)),this.#u=!1}))}#u=!1;fail(e){this.status="failed",this.failure=e instanceof Error?e.message:String(e),this.changed(!1)}async show(e){this.scene&&(this.source=e,this.status!=="ready"&&(this.status="loading"),this.notice="",this.changed(!1),await this.load(!0))}async reload(){this.source&&this.scene&&await this.load(!1)}async load(e){let{source:t,display:i,scene:s}=this;if(!t||!i||!s)return;let r=++this.#n,o=()=>r!==this.#n;e&&this.animation.stop();try{let a=C0(await t.parts()),l=new Fu(t,a.parts),c="";try{await l.update()}catch(d){c=`The list of positions cannot be read: ${ku(d)}`}let u=l.list.length>0?await l.load(0).catch(d=>(c=ku(d),null)):null;if(o()){l.dispose();return}u?.problem&&(c=Z0(u)),this.positions?.dispose(),this.parts=a,d0(a.units),this.positions=l,this.#r.clear(),this.notice=c,i.setParts(a.parts,u),i.setPosition(u),!this.#i&&(u?.meshes.length||u?.contacts)&&(this.#i=!0,this.state.colours.field=u.meshes.length?"von_mises":"contact_pressure"),!this.#s&&u?.contacts&&(this.#s=!0,Zg(u.contacts)&&(this.state.colours.cells="flanks")),this.state.position=Math.min(Math.max(0,Math.trunc(this.state.position)),Math.max(0,l.list.length-1)),this.status="ready",this.apply(),i.updateBounds(),this.state.camera?s.camera.set(this.state.camera):a.parts.length>0&&s.camera.fit(!1),this.state.position>0&&await this.goTo(this.state.position),this.changed()}catch(a){o()||this.fail(a)}}async updatePositions(){let{positions:e}=this;if(!e)return;let t=e.list.length===0;try{await e.update()}catch(i){this.notice=`The list of positions cannot be read: ${ku(i)}`}this.#r.clear(),t&&e.list.length>0?await this.load(!0):this.update({})}update(e){let t=this.state;this.state=Mu(e,t),e.colours?.field&&(this.#i=!0),e.colours?.cells&&(this.#s=!0),this.probe=null,this.theme.set(this.state.theme),e.camera&&this.scene&&this.scene.camera.set(this.state.camera),this.apply(),e.parts&&this.display?.updateBounds(),e.position!==void 0&&this.goTo(this.state.position),this.changed()}apply(){let{display:e,scene:t}=this;if(!e||!t||this.status!=="ready")return;let i=e.apply(this.state,this.#r.get(this.limitsKey())??null);this.labels.set(i),t.invalidate(),this.state.colours.limits==="all"&&this.findAllLimits()}setVisibility(e,t){let i={...this.state.parts};for(let s of e)i[s]=t;this.update({parts:i})}async goTo(e){let{positions:t,display:i}=this;if(!t||!i||t.list.length===0)return;let s=Math.min(Math.max(0,e),t.list.length-1);this.state.position=s,this.changed();try{let r=await t.load(s);if(t!==this.positions||this.state.position!==s)return;this.notice=Z0(r),i.position!==r&&i.setPosition(r),this.probe=null,this.apply()}catch(r){if(t!==this.positions||this.state.position!==s)return;this.animation.stop(),this.notice=`${ku(r)}. The picture shows another position.`}this.changed()}limitsKey(){let e=Object.entries(this.state.parts).filter(([,t])=>t==="hidden");return JSON.stringify([this.state.colours.field,this.state.colours.cells,e.map(([t])=>t).sort()])}async findAllLimits(){let{positions:e,display:t,state:i}=this,s=this.limitsKey();if(!e||!t||i.colours.field==="plain"||this.#r.has(s)||this.#o===s)return;this.#o=s;let r=()=>this.#o===s&&e===this.positions&&this.state.colours.limits==="all",o=null;for(let l=0;l<e.list.length&&r();l++){this.progress=l/e.list.length,this.changed(!1);let c=await e.load(l).catch(()=>null),u=c&&r()?t.limitsOf(c,this.state):null;u&&(o=o?[Math.min(o[0],u[0]),Math.max(o[1],u[1])]:u)}if(this.#o!==s)return;let a=r();this.#o="",this.progress=null,a&&(o?this.#r.set(s,o):this.#r.set(s,[0,1]),this.apply()),this.changed(!1)}probePointer(e,t){this.probe=this.status==="ready"?X0(this,e,t):null,this.state.panels.pattern&&this.followPointer(),this.changed(!1)}followPointer(){let{probe:e,pattern:t}=this,i=e?.cell??-1,s=this.display?.position?.contacts;for(let o=0;s&&i>=0&&o<2;o++)t.pointed.set(s.parts[2*i+o],s.teeth[2*i+o]);let r=this.parts?.parts.find(({name:o})=>o===e?.part);e&&i<0&&r&&e.tooth!==null&&t.pointed.set(r.index,e.tooth),this.hover(i)}hover(e){let{display:t,scene:i,pattern:s}=this;s.hovered=e,t?.contacts.mark(t.position?.contacts??null,e)&&i?.invalidate(),this.changed(!1)}updateMarks(){clearTimeout(this.#a),this.#a=0;let{scene:e,display:t}=this;!e||!t||this.status!=="ready"||(this.labels.hide(i=>U0(e,t,i)),this.labels.arrange(e.width,e.height,this.element.querySelector(".cv-legend")?.getBoundingClientRect()??null))}clearProbe(){this.pattern.hovered>=0&&this.hover(-1),this.probe&&(this.probe=null,this.changed(!1))}get hasMeshes(){return(this.display?.position?.meshes.length??0)>0}get missingField(){let{field:e}=this.state.colours,t=this.display?.position;return e==="plain"||this.status!=="ready"?!1:Un(e)?!t?.meshes.length:!t?.contacts}project(e,t){let{scene:i,display:s}=this,r=s?.views.find(l=>l.part.name===e);if(!i||!r)return null;let o=new G(...t).applyMatrix4(r.group.matrixWorld).project(i.camera.active),a=i.canvas.getBoundingClientRect();return{x:a.left+(.5+.5*o.x)*i.width,y:a.top+(.5-.5*o.y)*i.height}}nodalValue(e,t){let{display:i,parts:s}=this,r=s?.parts.findIndex(l=>l.name===e)??-1,o=i?.meshes[r]?.[0],{field:a}=this.state.colours;return o&&i&&Un(a)?i.values(o,a)[t]??NaN:NaN}dispose(){this.#n++,cancelAnimationFrame(this.#t),clearTimeout(this.#a),this.#l.disconnect(),this.animation.stop(),this.positions?.dispose(),this.display?.dispose(),this.scene?.dispose(),this.theme.dispose(),this.#e.clear()}};function Z0({problem:n}){return n&&`${n}. The mesh is not displayed.`}function ku(n){return n instanceof Kt||n instanceof Error?n.message:String(n)}var J0=.35,NE=18;function K0(n,e){let t=n.scene,i=new Map,s=null,r=0,o=0,a=0,l=new G,c=f=>{let p=e.getBoundingClientRect();return{x:f.clientX-p.left,y:f.clientY-p.top}},u=(f,p)=>{if(!n.state.cut.on)return!1;let _=l.copy(n.display.cut.handle).project(t.camera.active);return Math.hypot((.5+.5*_.x)*t.width-f,(.5-.5*_.y)*t.height-p)<NE};e.addEventListener("pointerdown",f=>{e.setPointerCapture(f.pointerId),e.focus({preventScroll:!0}),n.drawer&&n.setDrawer(null);let{x:p,y:_}=c(f);i.set(f.pointerId,{x:p,y:_}),i.size>1?s="pan":f.button===0&&u(p,_)?s="cut":s=f.button===0&&!f.shiftKey?"orbit":"pan",n.clearProbe(),n.display?.setDragging(s==="cut",n.state),e.dataset.drag=s}),e.addEventListener("pointermove",f=>{let{x:p,y:_}=c(f),m=i.get(f.pointerId);if(!m||!s){let M=u(p,_);e.dataset.handle=String(M),n.display?.cut.setHighlight(M),o=p,a=_,r||=requestAnimationFrame(()=>{r=0,n.probePointer(o,a)});return}let g=p-m.x,x=_-m.y;if(i.size===2){let M=[...i].find(([A])=>A!==f.pointerId)[1],y=Math.hypot(m.x-M.x,m.y-M.y),C=Math.hypot(p-M.x,_-M.y);t.camera.pan(g/2/t.height,-x/2/t.height),y>0&&C>0&&t.camera.zoom(y/C,...h((p+M.x)/2,(_+M.y)/2))}else if(s==="orbit")t.camera.orbit(-g*J0,x*J0);else if(s==="pan")t.camera.pan(g/t.height,-x/t.height);else{let{cut:M}=n.display;j0(n,M.drag(g,x,t.camera.active,t.width,t.height))}m.x=p,m.y=_});let d=f=>{i.delete(f.pointerId),i.size===0&&(s=null,n.display?.setDragging(!1,n.state),delete e.dataset.drag)};e.addEventListener("pointerup",d),e.addEventListener("pointercancel",d),e.addEventListener("pointerleave",()=>{cancelAnimationFrame(r),r=0,n.clearProbe()}),e.addEventListener("contextmenu",f=>f.preventDefault()),e.addEventListener("dblclick",()=>t.camera.fit());let h=(f,p)=>[(f-t.width/2)/t.height,(t.height/2-p)/t.height];e.addEventListener("wheel",f=>{f.preventDefault();let{x:p,y:_}=c(f),m=f.deltaY*(f.deltaMode===1?16:1);t.camera.zoom(Math.exp(Math.min(Math.max(m,-240),240)*.0016),...h(p,_))},{passive:!1})}function j0(n,e){let{cut:t}=n.display,i=Math.min(Math.max(t.offset+e,t.range[0]),t.range[1]);n.update({cut:{offset:i}})}function Co(n,e){let t=e.normal??n.state.cut.normal,i=n.scene.camera.direction,s=typeof t=="string"?i[t]:i.x*t[0]+i.y*t[1]+i.z*t[2];n.update({cut:{...e,...e.normal?{offset:null}:{},...e.on===!1?{}:{flipped:s<0}}})}var Q0=[["View",[{keys:"F",label:"Fit the parts into the picture"},{keys:"1 … 6",label:"Front, back, left, right, top, bottom"},{keys:"7",label:"Isometric"},{keys:"P",label:"Perspective or orthographic"},{keys:"Arrow keys",label:"Orbit (picture focused)"},{keys:"Shift + arrow keys",label:"Pan (picture focused)"},{keys:"+ −",label:"Zoom"}]],["Display",[{keys:"M",label:"Edges of the finite elements"},{keys:"V",label:"Force vectors"},{keys:"C",label:"Cutting plane"},{keys:"[ ]",label:"Move the cutting plane"},{keys:"D",label:"Undeformed, true or automatic deformation"}]],["Animation",[{keys:"K",label:"Play or pause"},{keys:", .",label:"Previous or next position"}]],["Panels",[{keys:"B",label:"Parts"},{keys:"S",label:"Settings"},{keys:"G",label:"Plots"},{keys:"U",label:"Contact pattern on the unrolled flank"},{keys:"?",label:"This help"},{keys:"Esc",label:"Close"}]],["Pointer",[{keys:"Drag",label:"Orbit"},{keys:"Right or Shift + drag",label:"Pan"},{keys:"Wheel",label:"Zoom at the pointer"},{keys:"Double click",label:"Fit"}]]],FE={1:"front",2:"back",3:"left",4:"right",5:"top",6:"bottom",7:"isometric"};function e_(n,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let t=e.target;if(t.closest("input:not([type=checkbox]):not([type=range]), select, textarea"))return!1;let{scene:i,state:s,animation:r}=n;if(e.key==="?")return n.help=!n.help,n.changed(!1),!0;if(e.key==="Escape"&&n.help)return n.help=!1,n.changed(!1),!0;if(e.key==="Escape"&&n.drawer)return n.setDrawer(null),!0;if(!i||n.status!=="ready")return!1;let{camera:o}=i;if(t===i.canvas&&e.key.startsWith("Arrow")){let u=e.key==="ArrowRight"?1:e.key==="ArrowLeft"?-1:0,d=e.key==="ArrowUp"?1:e.key==="ArrowDown"?-1:0;return e.shiftKey?o.pan(.05*u,.05*d):o.orbit(-6*u,-6*d),!0}let a=FE[e.key];if(a)return o.view(a),!0;let{panels:l,forces:c}=s;switch(e.key.toLowerCase()){case"f":o.fit();break;case"p":o.setProjection(s.camera?.projection==="orthographic"?"perspective":"orthographic");break;case"+":case"=":o.zoom(.85);break;case"-":case"_":o.zoom(1/.85);break;case"m":n.update({mesh_edges:!s.mesh_edges});break;case"v":{let u=!(c.bearings||c.meshes);n.update({forces:{bearings:u,meshes:u}});break}case"c":Co(n,{on:!s.cut.on});break;case"[":case"]":s.cut.on&&j0(n,(e.key==="["?-.04:.04)*n.display.radius);break;case"d":n.update({deformation:UE(n)});break;case"k":r.toggle();break;case",":r.step(-1);break;case".":r.step(1);break;case"b":n.toggle("parts");break;case"s":n.toggle("settings");break;case"g":n.update({panels:{plots:!l.plots}});break;case"u":n.update({panels:{pattern:!l.pattern}});break;default:return!1}return!0}function UE(n){let{mode:e,factor:t}=n.state.deformation;return e==="automatic"?{mode:"factor",factor:0}:t===0?{mode:"factor",factor:1}:{mode:"automatic",factor:1}}function Hu(n,e,t){let i=(e-n)/Math.max(t,1),s=10**Math.floor(Math.log10(i)),r=[1,2,5,10].map(a=>a*s).find(a=>a>=i)??10*s,o=[];for(let a=Math.ceil(n/r-1e-9);a*r<=e+1e-9*r;a++)o.push(a*r);return o}var OE=.09;function Vu(n,e,t){let i=OE*(e-n);return[n,...Hu(n,e,t).filter(s=>s>n+i&&s<e-i),e]}function za(n){let{field:e}=n.state.colours;if(Vi[e].quantity==="stress")return Ei();if(Vi[e].quantity==="none")return{symbol:"",factor:1};let t=n.display?.limits;return xn("m",t?Math.max(Math.abs(t[0]),Math.abs(t[1])):0)}function Ro(n){return Vi[n.state.colours.field].label}function Gu(n){let e=za(n),t=n.display?.limits;if(!t)return{ticks:[],unit:e.symbol};let{bands:i}=n.state.colours,s=t[0]*e.factor,r=t[1]*e.factor;return s===r?{ticks:[{fraction:.5,text:Nt(s)}],unit:e.symbol}:{ticks:(i>0&&i<=12?Array.from({length:i+1},(l,c)=>s+c/i*(r-s)):Vu(s,r,5)).map(l=>({fraction:(l-s)/(r-s),text:Nt(Math.abs(l)<1e-9*Math.abs(r-s)?0:l,4)})),unit:e.symbol}}var As={left:58,right:92,top:20,bottom:36},Rd=14,n_=.6,Po=class{constructor(e,t,{bounds:i},s=!0){this.width=e;this.height=t;this.bar=s;let r=Math.max(e-As.left-(s?As.right:12),40),o=Math.max(t-As.top-As.bottom,30);this.scale=Math.min(r/(i.u1-i.u0),o/(i.v1-i.v0)),this.left=As.left+(r-this.scale*(i.u1-i.u0))/2,this.bottom=As.top+(o+this.scale*(i.v1-i.v0))/2,this.right=this.left+this.scale*(i.u1-i.u0),this.top=this.bottom-this.scale*(i.v1-i.v0),this.#e=this.left-this.scale*i.u0,this.#t=this.bottom+this.scale*i.v0}width;height;bar;scale;#e;#t;right;top;left;bottom;x(e){return this.#e+this.scale*e}y(e){return this.#t-this.scale*e}inverse(e,t){return[(e-this.#e)/this.scale,(this.#t-t)/this.scale]}};function Wu(n,[e,t],i){let s=Math.min(Math.max((n-e)/(t-e||1),0),1);return wr(er(i.scale,Sr(s,i.bands)))}function $u(n,e,t,i,s,r=-1){let{axes:o,side:a,part:l,limits:c}=t,u=f=>{let p=[];for(let _=0;_<f.length;_+=2){let[m,g]=[f[_],f[_+1]];p.push(e.x(o.along(m,g)),e.y(o.across(m,g)))}return p},d=(nr(l)?.flanks[a].outline??[]).map(u);n.fill(d,s.flank),t.envelope&&BE(n,e,t,i);for(let{corners:f,pressure:p}of t.cells)n.fill([u(f)],Wu(p,c,i),!0);for(let f of d)n.stroke(f,s.muted,1,!0);let h=t.cells.find(({cell:f})=>f===r);h&&n.stroke(u(h.corners),s.mark,2,!0),kE(n,e,t,s),e.bar&&zE(n,e,c,i,s)}function BE(n,e,{envelope:t,limits:i},s){let{bounds:r,columns:o,rows:a,values:l}=t,c=(r.u1-r.u0)/o,u=(r.v1-r.v0)/a;for(let d=0;d<a;d++){let h=e.y(r.v0+(d+1)*u),f=e.y(r.v0+d*u);for(let p=0;p<o;){let _=l[d*o+p],m=p++;if(!(_>0))continue;let g=Wu(_,i,s);for(;p<o&&l[d*o+p]>0&&Wu(l[d*o+p],i,s)===g;)p++;let[x,M]=[e.x(r.u0+m*c),e.x(r.u0+p*c)];n.fill([[x,h,M,h,M,f,x,f]],g,!0)}}}function Pd({part:n,side:e,axes:t}){if(t.direction===0)return[0,0];let{u0:i,v0:s}=bd(n,e,t);return[i,s]}function kE(n,e,t,i){let{left:s,right:r,top:o,bottom:a}=e,{factor:l,symbol:c}=xn("m",1),{bounds:u,axes:d}=t,[h,f]=Pd(t),p=d.direction===0;n.stroke([s,o,s,a,r,a],i.muted,1);for(let M of Hu((u.u0-h)*l,(u.u1-h)*l,Math.min((r-s)/60,10))){let y=e.x(M/l+h);n.stroke([y,a,y,a+4],i.muted,1),n.text(y,a+15,Nt(M),i.muted,"middle")}for(let M of Hu((u.v0-f)*l,(u.v1-f)*l,Math.min((a-o)/26,8))){let y=e.y(M/l+f);n.stroke([s-4,y,s,y],i.muted,1),n.text(s-7,y+4,Nt(M),i.muted,"end")}let[_,m,g,x]=d.ends;n.text(s,a+30,_,i.muted,"start"),n.text(r,a+30,m,i.muted,"end"),n.text(s-16,a+16,g,i.muted,"end"),n.text(s-16,o-8,x,i.muted,"end"),n.text((s+r)/2,a+30,`${p?"z":"along the face"} in ${c}`,i.text,"middle"),n.text(s-44,(o+a)/2,`${p?"radius":"across the face"} in ${c}`,i.text,"middle",!0)}function zE(n,e,t,i,s){let r=e.width-As.right+22,[o,a]=[As.top+16,e.height-As.bottom],l=Ei(),c=i.bands>0?i.bands:48;for(let h=0;h<c;h++){let f=t[0]+(h+.5)/c*(t[1]-t[0]),[p,_]=[a-h*(a-o)/c,a-(h+1)*(a-o)/c];n.fill([[r,p,r+Rd,p,r+Rd,_,r,_]],Wu(f,t,i),!0)}n.text(r,o-7,l.symbol,s.text,"start");let[u,d]=[t[0]*l.factor,t[1]*l.factor];for(let h of Vu(u,d,a-o<90?2:4)){let f=a-(h-u)/(d-u||1)*(a-o);n.text(r+Rd+6,f+4,Nt(h),s.muted,"start")}}var Xu=class{constructor(e){this.context=e}context;fill(e,t,i=!1){let{context:s}=this;s.fillStyle=t,s.beginPath();for(let r of e)this.path(r,!0);s.fill("evenodd"),i&&(s.strokeStyle=t,s.lineWidth=n_,s.stroke())}stroke(e,t,i,s=!1){let{context:r}=this;r.strokeStyle=t,r.lineWidth=i,r.beginPath(),this.path(e,s),r.stroke()}path(e,t){let{context:i}=this;for(let s=0;s<e.length;s+=2)s===0?i.moveTo(e[0],e[1]):i.lineTo(e[s],e[s+1]);t&&i.closePath()}text(e,t,i,s,r,o=!1){let{context:a}=this;a.fillStyle=s,a.textAlign=r==="middle"?"center":r,a.save(),a.translate(e,t),o&&a.rotate(-Math.PI/2),a.fillText(i,0,0),a.restore()}},qu=class{elements=[];fill(e,t,i=!1){e.length!==0&&this.elements.push(`<path d="${e.map(s=>t_(s,!0)).join("")}" fill="${t}"${i?` stroke="${t}" stroke-width="${n_}"`:' fill-rule="evenodd"'}/>`)}stroke(e,t,i,s=!1){this.elements.push(`<path d="${t_(e,s)}" fill="none" stroke="${t}" stroke-width="${i}"/>`)}text(e,t,i,s,r,o=!1){let a=o?` transform="rotate(-90 ${e.toFixed(1)} ${t.toFixed(1)})"`:"";this.elements.push(`<text x="${e.toFixed(1)}" y="${t.toFixed(1)}" fill="${s}" text-anchor="${r}"${a}>${Yu(i)}</text>`)}};function t_(n,e){let t="";for(let i=0;i<n.length;i+=2)t+=`${i===0?"M":"L"}${n[i].toFixed(2)} ${n[i+1].toFixed(2)}`;return e?`${t}Z`:t}function Yu(n){return n.replace(/[&<>"]/g,e=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[e])}function i_(n,e,t,i){let s=new TextEncoder,r=[],o=[],a=0,l=f=>{let p=typeof f=="string"?s.encode(f):f;r.push(p),a+=p.length},c=(f,p)=>{o.push(a),l(`${o.length} 0 obj
${f}
`),p!==void 0&&(l(`stream
`),l(p),l(`
endstream
`)),l(`endobj
`)},u=Math.round(842*t/e),d=`q 842 0 0 ${u} 0 0 cm /Picture Do Q`;l(`%PDF-1.4
`),c("<< /Type /Catalog /Pages 2 0 R >>"),c("<< /Type /Pages /Kids [3 0 R] /Count 1 >>"),c(`<< /Type /Page /Parent 2 0 R /MediaBox [0 0 842 ${u}] /Resources << /XObject << /Picture 4 0 R >> >> /Contents 5 0 R >>`),c(`<< /Type /XObject /Subtype /Image /Width ${e} /Height ${t} /ColorSpace /DeviceRGB /BitsPerComponent 8 /Filter /DCTDecode /Length ${n.length} >>`,n),c(`<< /Length ${d.length} >>`,d),c(`<< /Title <${HE(i)}> /Producer (Calyx) >>`);let h=a;l(`xref
0 ${o.length+1}
0000000000 65535 f 
`);for(let f of o)l(`${String(f).padStart(10,"0")} 00000 n 
`);return l(`trailer
<< /Size ${o.length+1} /Root 1 0 R /Info 6 0 R >>
startxref
${h}
%%EOF
`),new Blob(r,{type:"application/pdf"})}function HE(n){let e="FEFF";for(let t=0;t<n.length;t++)e+=n.charCodeAt(t).toString(16).padStart(4,"0").toUpperCase();return e}var VE={right:[9,4,"start"],left:[-9,4,"end"],above:[0,-14,"middle"],below:[0,22,"middle"]},Id=2,GE="system-ui, -apple-system, 'Segoe UI', Roboto, Helvetica, Arial, sans-serif",Cs={width:16,height:200,right:92,top:56};function WE(n){let{width:e,height:t}=n.scene,i=getComputedStyle(n.element),s=r=>i.getPropertyValue(r).trim();return{width:e,height:t,text:s("--cv-text"),muted:s("--cv-muted"),background:s("--cv-stage"),halo:s("--cv-stage")}}function s_(n,e){let{scene:t,labels:i,state:s,display:r}=n,o=[],a=(h,f,p,_="")=>o.push(`<text x="${h.toFixed(1)}" y="${f.toFixed(1)}" fill="${e.text}" stroke="${e.halo}" stroke-width="3" stroke-linejoin="round" paint-order="stroke" ${_}>${Yu(p)}</text>`);for(let h of i.placed(t.camera.active,t.root.matrix,e.width,e.height)){let f=h.hidden?'stroke-dasharray="3 2" opacity="0.6"':"";(h.kind==="maximum"||h.kind==="minimum")&&o.push(`<circle cx="${h.x.toFixed(1)}" cy="${h.y.toFixed(1)}" r="4" fill="none" stroke="${e.text}" stroke-width="1.6" ${f}/>`);let[p,_,m]=VE[h.side];a(h.x+p,h.y+_,h.text,`font-weight="600" text-anchor="${m}"${h.hidden?' opacity="0.7"':""}`)}let{limits:l}=r,{colours:c}=s;if(l&&c.field!=="plain"){let h=e.width-Cs.right,f=c.bands>0?c.bands:64;for(let m=0;m<f;m++){let g=wr(er(c.scale,c.bands>0?Sr((m+.5)/f,f):m/(f-1))),x=Cs.height/f,M=Cs.top+Cs.height-(m+1)*x;o.push(`<rect x="${h}" y="${M.toFixed(2)}" width="${Cs.width}" height="${(x+.4).toFixed(2)}" fill="${g}"/>`)}let{ticks:p,unit:_}=Gu(n);for(let m of p)a(h+Cs.width+7,Cs.top+Cs.height*(1-m.fraction)+4,m.text);a(e.width-16,Cs.top-18,`${Ro(n)}${_?` in ${_}`:""}`,'text-anchor="end" font-weight="600"')}let u=n.positions?.list[s.position],d=[n.source?.title,u?`position ${u.position}`:""].filter(Boolean).join(", ");return d&&a(16,e.height-16,d),n.hasMeshes&&a(16,e.height-36,`deformation × ${r.factor}`),o.join(`
`)}function Ld(n,e){return`<svg xmlns="http://www.w3.org/2000/svg" width="${n.width}" height="${n.height}" viewBox="0 0 ${n.width} ${n.height}" font-family="${GE}" font-size="12">
${e}
</svg>
`}function r_(n,e){let t=n.display.cut.group,i=t.visible;t.visible=!1;let s=n.scene.snapshot(Id);t.visible=i,n.scene.invalidate();let r=document.createElement("canvas");r.width=s.width,r.height=s.height;let o=r.getContext("2d");return o.fillStyle=e.background,o.fillRect(0,0,r.width,r.height),o.drawImage(s,0,0),r}async function l_(n,e){let t=new Image,i=URL.createObjectURL(new Blob([e],{type:"image/svg+xml"}));try{t.src=i,await t.decode(),n.getContext("2d").drawImage(t,0,0,n.width,n.height)}finally{URL.revokeObjectURL(i)}return n}function o_(n,e,t){return new Promise((i,s)=>{n.toBlob(r=>r?i(r):s(new Error("the picture cannot be encoded")),e,t)})}async function Dd(n,e){if(!n.scene||n.status!=="ready")throw new Error("there is no picture to export");n.updateMarks();let t=WE(n);if(e==="svg"){let s=r_(n,t).toDataURL("image/png"),r=`<image width="${t.width}" height="${t.height}" href="${s}"/>
${s_(n,t)}`;return new Blob([Ld(t,r)],{type:"image/svg+xml"})}let i=await l_(r_(n,t),Ld(t,s_(n,t)));return c_(i,e,n.source?.title??"")}async function c_(n,e,t){if(e==="png")return o_(n,"image/png");let i=await o_(n,"image/jpeg",.94);return i_(new Uint8Array(await i.arrayBuffer()),n.width,n.height,t)}function Nd(n){let e=getComputedStyle(n.element),t=i=>e.getPropertyValue(i).trim();return{text:t("--cv-text"),muted:t("--cv-muted"),line:t("--cv-line"),flank:t("--cv-flank"),mark:t("--cv-mark")}}function Fd(n,{part:e,tooth:t,side:i,envelope:s}){let r=n.positions?.list[n.state.position],o=n.positions?.list.length??0,a=s?`maximum over ${s.included.size<o?`${s.included.size} of `:""}${o} positions`:`position ${r?.position??0}`,l={all:"",flanks:", without edges",edges:", edges only"}[n.state.colours.cells];return`Contact pattern of ${e.name}, ${t===null?"all teeth":`tooth ${t}`}, ${i} flank, ${a}${l}`}var a_={width:960,height:420,title:34};async function Ud(n,e){let t=n.pattern.pattern();if(!t)throw new Error("there is no contact pattern to export");let{width:i,height:s,title:r}=a_,o=new qu,a=Nd(n);$u(o,new Po(i,s-r,t),t,n.state.colours,a);let l=getComputedStyle(n.element).getPropertyValue("--cv-bg").trim(),c=[n.source?.title,Fd(n,t)].filter(Boolean).join(": "),u=Ld(a_,`<rect width="${i}" height="${s}" fill="${l}"/>
<text x="16" y="22" fill="${a.text}" font-weight="600">${Yu(c)}</text>
<g transform="translate(0 ${r})">
${o.elements.join(`
`)}
</g>`);if(e==="svg")return new Blob([u],{type:"image/svg+xml"});let d=document.createElement("canvas");return d.width=Id*i,d.height=Id*s,c_(await l_(d,u),e,c)}async function u_(n,e){f_(n,await Dd(n,e),e)}async function h_(n,e){f_(n,await Ud(n,e),`pattern.${e}`)}function f_(n,e,t){let i=document.createElement("a"),s=(n.source?.title??"view").replace(/[^\p{L}\p{N}._-]+/gu,"_")||"view";i.href=URL.createObjectURL(e),i.download=`${s}.${t}`,i.click(),setTimeout(()=>URL.revokeObjectURL(i.href),1e4)}var Io,vn,Od,d_,Bd=Object.is,Zu=0,M_=[],kd=[],cn=Lt,p_=cn.__b,m_=cn.__r,g_=cn.diffed,__=cn.__c,x_=cn.unmount,v_=cn.__;function Ju(n,e){cn.__h&&cn.__h(vn,n,Zu||e),Zu=0;var t=vn.__H||(vn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function rs(n){return Zu=1,Hd(w_,n)}function Hd(n,e,t){var i=Ju(Io++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):w_(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);Bd(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=vn,!vn.__f)){vn.__f=!0;var s=vn.shouldComponentUpdate;vn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(h){h.__N&&(c=!0,Bd(h.__[0],h.__N[0])||(u=!0))}),s){var d=s.call(this,r,o,a);return c?d||u:d}return!c||u}}return i.__}function Ti(n,e){var t=Ju(Io++,3);!cn.__s&&Vd(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,vn.__H.__h.push(t))}function S_(n,e){var t=Ju(Io++,4);!cn.__s&&Vd(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,vn.__h.push(t))}function Ai(n){return Zu=5,XE(function(){return{current:n}},[])}function XE(n,e){var t=Ju(Io++,7);return Vd(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function qE(){var n;do{for(;n=kd.shift();)try{Ha(n)}catch(t){cn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=M_.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(Ha),e.__h.some(zd),e.__h=[]}catch(t){e.__h=[],cn.__e(t,n.__v)}}}while(kd.length)}cn.__b=function(n){vn=null,p_&&p_(n)},cn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),v_&&v_(n,e)},cn.__r=function(n){m_&&m_(n),Io=0;var e=(vn=n.__c).__H;e&&(Od==vn?vn.__h=[]:(e.__h.some(Ha),e.__h.some(zd),Io=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),Od=vn},cn.diffed=function(n){g_&&g_(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&b_(M_.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),Od=vn=null},cn.__c=function(n,e){e.some(function(t){try{t.__h.some(Ha),t.__h=t.__h.filter(function(i){return!i.__||zd(i)})}catch(i){t.__h=[function(){throw i}]}}),__&&__(n,e)},cn.unmount=function(n){x_&&x_(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,b_(kd.push(s))}else Ha(s)}catch(r){e=r}}),i.__H=void 0,e&&cn.__e(e,i.__v))};var y_=typeof requestAnimationFrame=="function";function $E(n){var e,t=function(){clearTimeout(i),y_&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);y_&&(e=requestAnimationFrame(t))}function b_(n){n!=1&&d_==cn.requestAnimationFrame||((d_=cn.requestAnimationFrame)||$E)(qE)}function Ha(n){var e=vn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),vn=e}function zd(n){var e=vn;n.__c=n.__(),vn=e}function Vd(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!Bd(t,n[i])})}function w_(n,e){return typeof e=="function"?e(n):e}var YE=Symbol.for("pv"),ZE=0;function D(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:YE,__v:--ZE,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),Lt.vnode&&Lt.vnode(c),c}function E_(n){let[,e]=Hd(t=>t+1,0);Ti(()=>(e(0),n.subscribe(()=>e(0))),[n])}var JE={parts:"M2.5 3.5h4M2.5 8h4M2.5 12.5h4M9 3.5h4.5M9 8h4.5M9 12.5h4.5",settings:"M2 4.5h7M12 4.5h2M2 11.5h2M7 11.5h7M10.5 3v3M5.5 10v3",fit:"M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10",cube:"M8 1.8l5.5 3v6.4L8 14.2l-5.5-3V4.8zM2.5 4.8L8 8l5.5-3.2M8 8v6.2",perspective:"M2 3.5l12 2v5l-12 2zM8 4.5v7",orthographic:"M2.5 3.5h11v9h-11zM8 3.5v9",mesh:"M2.5 2.5h11v11h-11zM2.5 6.2h11M2.5 9.8h11M6.2 2.5v11M9.8 2.5v11",force:"M3 13L12.5 3.5M7.5 3h5.5v5.5",cut:"M1.5 10.5l5-7h8l-5 7zM3 13.5h4M9.5 13.5h4",plot:"M2.5 2.5v11h11M4.5 10.5l3-4 2.5 2 3.5-5",pattern:"M1.8 3.5h12.4v9H1.8zM4 8c0-1.6 1.8-2.4 4-2.4S12 6.4 12 8s-1.8 2.4-4 2.4S4 9.6 4 8",more:"M2.6 8h1.2M7.4 8h1.2M12.2 8h1.2",download:"M8 2v8M4.8 7L8 10.2 11.2 7M2.5 13.5h11",help:"M5.5 6a2.5 2.5 0 1 1 3.6 2.2c-.8.4-1.1.9-1.1 1.8M8 12.6v.4",sun:"M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6M8 1.2v1.6M8 13.2v1.6M1.2 8h1.6M13.2 8h1.6M3.2 3.2l1.1 1.1M11.7 11.7l1.1 1.1M12.8 3.2l-1.1 1.1M4.3 11.7l-1.1 1.1",moon:"M13.2 9.6A5.8 5.8 0 0 1 6.4 2.8a5.6 5.6 0 1 0 6.8 6.8",play:"M5 3l8 5-8 5z",pause:"M5 3v10M11 3v10",next:"M4 3.5l6 4.5-6 4.5zM12.2 3.5v9",previous:"M12 3.5L6 8l6 4.5zM3.8 3.5v9",loop:"M11.5 2l2 2-2 2M13.5 4H5a3 3 0 0 0-3 3M4.5 14l-2-2 2-2M2.5 12H11a3 3 0 0 0 3-3",eye:"M1.5 8S4 3.8 8 3.8 14.5 8 14.5 8 12 12.2 8 12.2 1.5 8 1.5 8M8 6.2a1.8 1.8 0 1 0 0 3.6 1.8 1.8 0 0 0 0-3.6",half:"M8 2.5a5.5 5.5 0 1 0 0 11zM8 2.5a5.5 5.5 0 0 1 0 11M8 5h4.6M8 8h5.5M8 11h4.6",hidden:"M2 2l12 12M6.2 4.1A6 6 0 0 1 8 3.8c4 0 6.5 4.2 6.5 4.2a12 12 0 0 1-1.9 2.3M4 5.2A11 11 0 0 0 1.5 8S4 12.2 8 12.2a6 6 0 0 0 3-.8",pin:"M8 9.5V14M5 9.5h6l-1.3-2V3.3h.8M6.3 7.5L5 9.5M6.3 7.5V3.3h-.8M6.3 3.3h3.4",chevron:"M5.5 3.5L10 8l-4.5 4.5",close:"M3.5 3.5l9 9M12.5 3.5l-9 9"};function Va({name:n}){return D("svg",{class:"cv-icon",viewBox:"0 0 16 16","aria-hidden":"true",children:D("path",{d:JE[n]})})}function Ku(n,e,t,i){let s=n>t-240&&n>t/2,r=e>i-120&&e>i/2;return{[s?"right":"left"]:`${(s?t-n:n)+14}px`,[r?"bottom":"top"]:`${(r?i-e:e)+12}px`,"max-width":`${Math.max(120,(s?n:t-n)-20)}px`}}function yn({icon:n,label:e,shortcut:t,pressed:i,disabled:s,onClick:r}){return D("button",{type:"button",class:"cv-tool","aria-label":e,"aria-pressed":i,disabled:s,title:t?`${e} (${t})`:e,onClick:r,children:D(Va,{name:n})})}function Yt({label:n,value:e,options:t,onChange:i,quiet:s,title:r}){return D("label",{class:"cv-field",title:r,children:[D("span",{class:s?"cv-hidden":"",children:n}),D("select",{"aria-label":n,value:e,onChange:o=>i(o.currentTarget.value),children:t.map(o=>D("option",{value:o.value,disabled:o.disabled,selected:o.value===e,children:o.label},o.value))})]})}function os({label:n,value:e,onChange:t}){return D("label",{class:"cv-check",children:[D("input",{type:"checkbox",checked:e,onChange:i=>t(i.currentTarget.checked)}),D("span",{children:n})]})}function Ga({label:n,value:e,unit:t,min:i,max:s,disabled:r,onChange:o}){let a=Number.isFinite(e)?String(Number(e.toPrecision(6))):"",[l,c]=rs(null),u=()=>{if(l===null)return;let d=Number(l.trim().replace(",",".").replace("−","-"));c(null),!(l.trim()===""||!Number.isFinite(d))&&o(Math.min(Math.max(d,i??-1/0),s??1/0))};return D("label",{class:"cv-field",children:[D("span",{children:n}),D("span",{class:"cv-number",children:[D("input",{type:"text",inputMode:"decimal",value:l??a,disabled:r,onInput:d=>c(d.currentTarget.value),onBlur:u,onKeyDown:d=>{d.key==="Enter"&&u(),d.key==="Escape"&&c(null)}}),t?D("span",{class:"cv-unit",children:t}):null]})]})}function Gd({label:n,value:e,min:t,max:i,step:s="any",text:r,onInput:o,onEnd:a}){return D("label",{class:"cv-field cv-slider",children:[D("span",{children:n}),D("input",{type:"range",min:t,max:i,step:s,value:e,"aria-valuetext":r,onInput:l=>o(Number(l.currentTarget.value)),onChange:a})]})}function Lo({title:n,children:e}){return D("section",{class:"cv-section",children:[D("h3",{children:n}),e]})}function T_({core:n}){let e=Ai(null);S_(()=>{e.current.showModal()},[]);let t=()=>{n.help=!1,n.changed(!1)};return D("dialog",{class:"cv-help",ref:e,"aria-labelledby":"cv-help-title",onClose:t,onClick:i=>i.target===e.current&&t(),children:[D("div",{class:"cv-help-head",children:[D("h2",{id:"cv-help-title",children:"Shortcuts"}),D(yn,{icon:"close",label:"Close",onClick:t})]}),D("div",{class:"cv-help-grid",children:Q0.map(([i,s])=>D("section",{children:[D("h3",{children:i}),D("dl",{children:s.map(({keys:r,label:o})=>D("div",{children:[D("dt",{children:D("kbd",{children:r})}),D("dd",{children:o})]},r))})]},i))})]})}var A_={all:"of cells, edges included",flanks:"flanks only",edges:"edges only"},KE={stress_error:"estimated, as von Mises stress"};function jE(n){let{scale:e,bands:t}=n.state.colours,i=[];if(t>0)for(let s=0;s<t;s++){let r=wr(er(e,Sr((s+.5)/t,t)));i.push(`${r} ${100*s/t}% ${100*(s+1)/t}%`)}else for(let s=0;s<=20;s++)i.push(`${wr(er(e,s/20))} ${5*s}%`);return`linear-gradient(to top, ${i.join(", ")})`}function QE({share:n,largest:e},t){return`${Nt(100*n,2)} % of the nodes are above, up to ${Nt(e*Ei().factor,3)} ${t}`}function eT(n,e){let{field:t,cells:i}=n.state.colours,s=n.display?.position?.contacts;if(t!=="contact_pressure"||i!=="flanks"||!s)return null;let r=Ua(s,"all");return r>Ua(s,"flanks")?`edges, not shown: up to ${Nt(r*Ei().factor,4)} ${e}`:null}function tT(n){let e=n.display?.position;return e?n.state.colours.field!=="contact_pressure"?e.meshes.length===0?"No values: the run stored no meshes with stresses (--vtu), or its fidelity level has no finite elements.":"No values: the parts with meshes are hidden.":e.contacts?n.state.colours.cells==="all"?"No values: the gears in contact are hidden.":`No values: no visible loaded cells, ${A_[n.state.colours.cells]}.`:'No values: no contact is loaded in this position, or the fidelity level is "rigid".':"No values: the run has no positions."}function C_({core:n}){let{field:e}=n.state.colours;if(e==="plain")return null;let{ticks:t,unit:i}=Gu(n);if(n.missingField||t.length===0)return D("div",{class:"cv-legend cv-legend-empty",role:"note",children:[D("strong",{children:Ro(n)}),D("span",{children:tT(n)})]});let s=n.narrow?Math.ceil(t.length/6):1,{limits:r}=n.state.colours,o=n.display?.clipped,a=eT(n,i),l=r==="all"?"all positions":r==="fixed"?"fixed limits":"this position";return D("button",{type:"button",class:"cv-legend","aria-label":`Legend: ${Ro(n)} from ${t[0].text} to ${t[t.length-1].text} ${i}. Opens the settings.`,title:So[e]??"Settings of the colours",onClick:()=>n.toggle("settings"),children:[D("span",{class:"cv-legend-title",children:[D("strong",{children:Ro(n)}),i?D("span",{class:"cv-legend-unit",children:i}):null]}),D("span",{class:"cv-scale",children:[D("span",{class:"cv-bar",style:{background:jE(n)}}),D("span",{class:"cv-ticks",children:t.filter((c,u)=>u%s===0).map((c,u)=>D("span",{style:{bottom:`${100*c.fraction}%`},children:c.text},u))})]}),So[e]?D("span",{class:"cv-range",children:KE[e]}):null,a?D("span",{class:"cv-range",children:a}):null,o?D("span",{class:"cv-range",children:QE(o,i)}):null,D("span",{class:"cv-range",children:[e==="contact_pressure"?`${A_[n.state.colours.cells]}; `:"",n.progress!==null?`reading … ${Math.round(100*n.progress)} %`:l]})]})}var nT=[{kind:"gear",label:"Gears"},{kind:"shaft",label:"Shafts"},{kind:"bearing",label:"Bearings"},{kind:"body",label:"Bodies"}],R_={mixed:"visible",visible:"translucent",translucent:"hidden",hidden:"visible"},iT={mixed:"half",visible:"eye",translucent:"half",hidden:"hidden"};function P_({core:n}){let e=n.parts?.parts??[];return D("aside",{class:"cv-panel cv-parts","aria-label":"Parts",children:[D("div",{class:"cv-scroll",children:nT.map(({kind:t,label:i})=>{let s=e.filter(r=>r.kind===t);return s.length>0?D(sT,{core:n,label:i,parts:s},t):null})}),D("div",{class:"cv-foot",children:D(Yt,{label:"Fixed frame",value:n.state.frame??"",options:[{value:"",label:"Ground"},...e.map(({name:t})=>({value:t,label:t}))],onChange:t=>n.update({frame:t||null})})}),n.source?.provenance?.length?D("details",{class:"cv-provenance",children:[D("summary",{children:"Provenance"}),D("dl",{children:n.source.provenance.map(([t,i])=>D("div",{children:[D("dt",{children:t}),D("dd",{title:i,children:i})]},t))})]}):null]})}function sT({core:n,label:e,parts:t}){let[i,s]=rs(!0),r=t.map(({name:l})=>l),o=new Set(t.map(l=>Ba(n.state,l))),a=o.size===1?[...o][0]:"mixed";return D("div",{class:"cv-group",role:"group","aria-label":e,children:[D("div",{class:"cv-row cv-row-group",children:[D("button",{type:"button",class:"cv-fold","aria-expanded":i,onClick:()=>s(!i),children:[D(Va,{name:"chevron"}),D("span",{children:e}),D("span",{class:"cv-count",children:t.length})]}),D(I_,{name:e,value:a,onChange:l=>n.setVisibility(r,l)})]}),i?t.map(l=>D(rT,{core:n,part:l},l.name)):null]})}function rT({core:n,part:e}){let t=Ba(n.state,e);return D("div",{class:`cv-row cv-row-${t}`,children:[D("span",{class:"cv-swatch",style:{background:n.display?.colours[e.index]}}),D("span",{class:"cv-name",title:e.name,children:D(oT,{name:e.name})}),e.copies>1?D("span",{class:"cv-count",title:`${e.copies} teeth`,children:["z ",e.copies]}):null,n.state.frame===e.name?D("span",{class:"cv-pin",title:"Fixed frame",children:D(Va,{name:"pin"})}):null,D(I_,{name:e.name,value:t,onChange:i=>n.setVisibility([e.name],i)})]})}function oT({name:n}){let[e,t]=h0(n);return e?D(Dt,{children:[D("span",{class:"cv-name-start",children:e}),D("span",{class:"cv-name-end",children:t})]}):D(Dt,{children:t})}function I_({name:n,value:e,onChange:t}){return D("button",{type:"button",class:"cv-eye","aria-label":`${n}: ${e}`,title:`${e}; click for ${R_[e]}, Alt and click for hidden`,onClick:i=>t(i.altKey?e==="hidden"?"visible":"hidden":R_[e]),children:D(Va,{name:iT[e]})})}function D_({core:n}){let e=n.pattern.pattern();return D("section",{class:"cv-pattern","aria-label":"Contact pattern",children:e?D(Dt,{children:[D(aT,{core:n,pattern:e}),D(cT,{core:n,pattern:e})]}):D("div",{class:"cv-muted",children:"No gear has contacts in this position."})})}function aT({core:n,pattern:e}){let{state:t}=n,{part:i}=e,[s,r]=rs(""),o=t.pattern.tooth,a=n.pattern.teeth(i).map(String);/^\d+$/.test(o)&&!a.includes(o)&&a.push(o);let l=n.pattern.pointed.get(i.index);return D("div",{class:"cv-pattern-head",children:[D(Yt,{quiet:!0,label:"Gear",value:i.name,options:n.pattern.gears().map(({name:c})=>({value:c,label:c})),onChange:c=>n.update({pattern:{gear:c}})}),D(Yt,{quiet:!0,label:"Tooth",value:o,options:[{value:"all",label:"All teeth"},{value:"pointer",label:l===void 0?"At the pointer":`At the pointer: ${l}`},...a.map(c=>({value:c,label:`Tooth ${c}`}))],onChange:c=>n.update({pattern:{tooth:c}})}),D(Yt,{quiet:!0,label:"Flank",value:t.pattern.flank,options:[{value:"automatic",label:`Loaded: ${e.side}`},{value:"left",label:"Left flank"},{value:"right",label:"Right flank"}],onChange:c=>n.update({pattern:{flank:c}})}),D(Yt,{quiet:!0,label:"Positions of the pattern",value:t.pattern.envelope?"all":"current",options:[{value:"current",label:"This position"},{value:"all",label:"All positions"}],onChange:c=>n.update({pattern:{envelope:c==="all"}})}),D(Yt,{quiet:!0,label:s?`Export the pattern. ${s}`:"Export the pattern",value:"",options:[{value:"",label:"Export"},{value:"png",label:"PNG"},{value:"svg",label:"SVG"},{value:"pdf",label:"PDF"}],onChange:c=>{c&&h_(n,c).catch(u=>r(String(u))),n.changed(!1)}}),D(lT,{core:n,pattern:e})]})}function lT({core:n,pattern:e}){let t=n.positions?.list.length??0,{envelope:i,limits:s,largest:r}=e,o=[];i&&i.included.size<t&&o.push(`read ${i.included.size} of ${t} positions …`),r===0&&!(i&&i.included.size<t)&&o.push("no loaded cells");let a=Ei();return r>s[1]*(1+1e-9)&&o.push(`up to ${Nt(r*a.factor)} ${a.symbol}, above the scale`),o.length>0?D("span",{class:"cv-muted",role:"note",children:o.join("; ")}):null}function L_(n,e,t,i){if(t<e.left||t>e.right||i<e.top||i>e.bottom)return null;let[s,r]=e.inverse(t,i),[o,a]=n.axes.inverse(s,r);if(n.envelope)return{value:n.envelope.at(s,r)||NaN,z:o,r:a,cell:null};let l=G0(n.cells,o,a);return{value:l?.pressure??NaN,z:o,r:a,cell:l}}function cT({core:n,pattern:e}){let t=Ai(null),i=Ai(null),[s,r]=rs([0,0]),[o,a]=rs(null),{hovered:l}=n.pattern,c=!(n.drawers&&n.state.colours.field==="contact_pressure"),u=new Po(s[0],s[1],e,c);Ti(()=>{let f=t.current,p=new ResizeObserver(()=>r([f.clientWidth,f.clientHeight]));return p.observe(f),()=>p.disconnect()},[]);let d=JSON.stringify([n.state.colours,e.limits,e.part.name,e.side,e.tooth,l,s,c,n.theme.theme,e.envelope?.included.size]);Ti(()=>{let f=i.current;if(s[0]<1||s[1]<1)return;let p=window.devicePixelRatio||1;f.width=Math.round(s[0]*p),f.height=Math.round(s[1]*p);let _=f.getContext("2d");_&&(_.scale(p,p),_.font="11px system-ui, sans-serif",$u(new Xu(_),u,e,n.state.colours,Nd(n),l))},[d,n.display?.position]);let h=o?L_(e,u,...o):null;return D("div",{class:"cv-pattern-picture",ref:t,children:[D("canvas",{ref:i,role:"img","aria-label":Fd(n,e),onPointerMove:f=>{let p=f.currentTarget.getBoundingClientRect(),_=[f.clientX-p.left,f.clientY-p.top];a(_),n.hover(L_(e,u,..._)?.cell?.cell??-1)},onPointerLeave:()=>{a(null),n.hover(-1)}}),h?D(uT,{pattern:e,reading:h,layout:u,pointer:o}):null]})}function uT({pattern:n,reading:e,layout:t,pointer:i}){let{value:s,z:r,r:o,cell:a}=e,l=Ei(),c=xn("m",1),[u,d]=Pd(n),{axes:h}=n,f=p=>`${Nt(p*c.factor,5)} ${c.symbol}`;return D("div",{class:"cv-tooltip",role:"status","aria-label":"Value in the pattern","data-value":Number.isFinite(s)?String(s):"",style:Ku(...i,t.width,t.height),children:[D("div",{class:"cv-tooltip-value",children:D("strong",{children:Number.isFinite(s)?`${Nt(s*l.factor,6)} ${l.symbol}`:"no contact"})}),a?D("div",{children:["tooth ",a.tooth]}):null,D("div",{class:"cv-muted",children:["z ",f(r),", radius ",f(o)]}),h.direction!==0?D("div",{class:"cv-muted",children:["from the toe ",f(h.along(r,o)-u),", from the root ",f(h.across(r,o)-d)]}):null]})}var hT="uplot",fT="u-hz",dT="u-vt",pT="u-title",mT="u-wrap",gT="u-under",_T="u-over",xT="u-axis",Pr="u-off",vT="u-select",yT="u-cursor-x",bT="u-cursor-y",MT="u-cursor-pt",ST="u-legend",wT="u-live",ET="u-inline",TT="u-series",AT="u-marker",N_="u-label",CT="u-value",Xa="width",qa="height";var F_="bottom",Do="left",Wd="right",ap="#000",U_=ap+"0",Xd="mousemove",O_="mousedown",qd="mouseup",B_="mouseenter",k_="mouseleave",z_="dblclick",RT="resize",PT="scroll",H_="change",nh="dppxchange",lp="--",zo=typeof window<"u",Kd=zo?document:null,Fo=zo?window:null,IT=zo?navigator:null,Et,ju;function jd(){let n=devicePixelRatio;Et!=n&&(Et=n,ju&&ep(H_,ju,jd),ju=matchMedia(`(min-resolution: ${Et-.001}dppx) and (max-resolution: ${Et+.001}dppx)`),Ir(H_,ju,jd),Fo.dispatchEvent(new CustomEvent(nh)))}function di(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Qd(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Zt(n,e,t){n.style[e]=t+"px"}function Gi(n,e,t,i){let s=Kd.createElement(n);return e!=null&&di(s,e),t?.insertBefore(s,i),s}function Ci(n,e){return Gi("div",n,e)}var V_=new WeakMap;function as(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=V_.get(n);r!=o&&(n.style.transform=r,V_.set(n,r),e<0||t<0||e>i||t>s?di(n,Pr):Qd(n,Pr))}var G_=new WeakMap;function W_(n,e,t){let i=e+t,s=G_.get(n);i!=s&&(G_.set(n,i),n.style.background=e,n.style.borderColor=t)}var X_=new WeakMap;function q_(n,e,t,i){let s=e+""+t,r=X_.get(n);s!=r&&(X_.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var cp={passive:!0},LT={...cp,capture:!0};function Ir(n,e,t,i){e.addEventListener(n,t,i?LT:cp)}function ep(n,e,t,i){e.removeEventListener(n,t,cp)}zo&&jd();function Wi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:pi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function yx(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var bx=n=>n!=null,Mx=n=>n!=null&&n>0,rh=yx(bx),DT=yx(Mx);function NT(n,e,t,i=0,s=!1){let r=s?DT:rh,o=s?Mx:bx;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??kt,l??-kt]}function oh(n,e,t,i){let s=Z_(n),r=Z_(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Rs:Sx,a=s==1?pi:Ri,l=r==1?Ri:pi,c=a(o(An(n))),u=l(o(An(e))),d=Uo(t,c),h=Uo(t,u);return t==10&&(c<0&&(d=zt(d,-c)),u<0&&(h=zt(h,-u))),i||t==2?(n=d*s,e=h*r):(n=Ax(n,d),e=ah(e,h)),[n,e]}function up(n,e,t,i){let s=oh(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var hp=.1,$_={mode:3,pad:hp},Ya={pad:0,soft:null,mode:0},FT={min:Ya,max:Ya};function ih(n,e,t,i){return lh(t)?Y_(n,e,t):(Ya.pad=t,Ya.soft=i?0:null,Ya.mode=i?3:0,Y_(n,e,FT))}function St(n,e){return n??e}function UT(n,e,t){for(e=St(e,0),t=St(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Y_(n,e,t){let i=t.min,s=t.max,r=St(i.pad,0),o=St(s.pad,0),a=St(i.hard,-kt),l=St(s.hard,kt),c=St(i.soft,kt),u=St(s.soft,-kt),d=St(i.mode,0),h=St(s.mode,0),f=e-n,p=Rs(f),_=Qn(An(n),An(e)),m=Rs(_),g=An(m-p);(f<1e-24||g>10)&&(f=0,(n==0||e==0)&&(f=1e-24,d==2&&c!=kt&&(r=0),h==2&&u!=-kt&&(o=0)));let x=f||_||1e3,M=Rs(x),y=Uo(10,pi(M)),C=x*(f==0?n==0?.1:1:r),A=zt(Ax(n-C,y/10),24),v=n>=c&&(d==1||d==3&&A<=c||d==2&&A>=c)?c:kt,w=Qn(a,A<v&&n>=v?v:Xi(v,A)),U=x*(f==0?e==0?.1:1:o),L=zt(ah(e+U,y/10),24),I=e<=u&&(h==1||h==3&&L>=u||h==2&&L<=u)?u:-kt,O=Xi(l,L>I&&e<=I?I:Qn(I,L));return w==O&&w==0&&(O=100),[w,O]}var OT=new Intl.NumberFormat(zo?IT.language:"en-US"),fp=n=>OT.format(n),mi=Math,th=mi.PI,An=mi.abs,pi=mi.floor,Tn=mi.round,Ri=mi.ceil,Xi=mi.min,Qn=mi.max,Uo=mi.pow,Z_=mi.sign,Rs=mi.log10,Sx=mi.log2,BT=(n,e=1)=>mi.sinh(n)*e,$d=(n,e=1)=>mi.asinh(n/e),kt=1/0;function J_(n){return(Rs((n^n>>31)-(n>>31))|0)+1}function tp(n,e,t){return Xi(Qn(n,e),t)}function wx(n){return typeof n=="function"}function mt(n){return wx(n)?n:()=>n}var kT=()=>{},Ex=n=>n,Tx=(n,e)=>e,zT=n=>null,K_=n=>!0,j_=(n,e)=>n==e,HT=/\.\d*?(?=9{6,}|0{6,})/gm,Lr=n=>{if(Rx(n)||rr.has(n))return n;let e=`${n}`,t=e.match(HT);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Lr(s)}e${r}`}return zt(n,i)};function Cr(n,e){return Lr(zt(Lr(n/e))*e)}function ah(n,e){return Lr(Ri(Lr(n/e))*e)}function Ax(n,e){return Lr(pi(Lr(n/e))*e)}function zt(n,e=0){if(Rx(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Tn(i)/t}var rr=new Map;function Cx(n){return((""+n).split(".")[1]||"").length}function Ja(n,e,t,i){let s=[],r=i.map(Cx);for(let o=e;o<t;o++){let a=An(o),l=zt(Uo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:zt(u,d);s.push(h),rr.set(h,d)}}return s}var Za={},dp=[],Oo=[null,null],sr=Array.isArray,Rx=Number.isInteger,VT=n=>n===void 0;function Q_(n){return typeof n=="string"}function lh(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function GT(n){return n!=null&&typeof n=="object"}var WT=Object.getPrototypeOf(Uint8Array),Px="__proto__";function Bo(n,e=lh){let t;if(sr(n)){let i=n.find(s=>s!=null);if(sr(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Bo(n[s],e)}else t=n.slice()}else if(n instanceof WT)t=n.slice();else if(e(n)){t={};for(let i in n)i!=Px&&(t[i]=Bo(n[i],e))}else t=n;return t}function bn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=Px&&(lh(n[s])?bn(n[s],Bo(i[s])):n[s]=Bo(i[s]))}return n}var XT=0,qT=1,$T=2;function YT(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function ZT(n,e){if(jT(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return QT(o[0])||(o=KT(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],d=Array(s).fill(void 0),h=e?e[o][c]:qT,f=[];for(let p=0;p<u.length;p++){let _=u[p],m=r.get(l[p]);_===null?h!=XT&&(d[m]=_,h==$T&&f.push(m)):d[m]=_}YT(d,f,s),i.push(d)}}return i}var JT=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function KT(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function jT(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function QT(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Qn(1,pi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Ix=["January","February","March","April","May","June","July","August","September","October","November","December"],Lx=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Dx(n){return n.slice(0,3)}var eA=Lx.map(Dx),tA=Ix.map(Dx),nA={MMMM:Ix,MMM:tA,WWWW:Lx,WWW:eA};function Wa(n){return(n<10?"0":"")+n}function iA(n){return(n<10?"00":n<100?"0":"")+n}var sA={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Wa(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Wa(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Wa(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Wa(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Wa(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>iA(n.getMilliseconds())};function pp(n,e){e=e||nA;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?sA[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var rA=new Intl.DateTimeFormat().resolvedOptions().timeZone;function oA(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==rA?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var Nx=n=>n%1==0,sh=[1,2,2.5,5],aA=Ja(10,-32,0,sh),Fx=Ja(10,0,32,sh),lA=Fx.filter(Nx),Rr=aA.concat(Fx),mp=`
`,Ux="{YYYY}",ex=mp+Ux,Ox="{M}/{D}",$a=mp+Ox,Qu=$a+"/{YY}",Bx="{aa}",cA="{h}:{mm}",No=cA+Bx,tx=mp+No,nx=":{ss}",At=null;function kx(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ja(10,0,3,sh).filter(Nx):Ja(10,-3,0,sh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Ux,At,At,At,At,At,At,1],[s*28,"{MMM}",ex,At,At,At,At,At,1],[s,Ox,ex,At,At,At,At,At,1],[i,"{h}"+Bx,Qu,At,$a,At,At,At,1],[t,No,Qu,At,$a,At,At,At,1],[e,nx,Qu+" "+No,At,$a+" "+No,At,tx,At,1],[n,nx+".{fff}",Qu+" "+No,At,$a+" "+No,At,tx,At,1]];function u(d){return(h,f,p,_,m,g)=>{let x=[],M=m>=o,y=m>=r&&m<o,C=d(p),A=zt(C*n,3),v=Yd(C.getFullYear(),M?0:C.getMonth(),y||M?1:C.getDate()),w=zt(v*n,3);if(y||M){let U=y?m/r:0,L=M?m/o:0,I=A==w?A:zt(Yd(v.getFullYear()+L,v.getMonth()+U,1)*n,3),O=new Date(Tn(I/n)),z=O.getFullYear(),N=O.getMonth();for(let W=0;I<=_;W++){let $=Yd(z+L*W,N+U*W,1),V=$-d(zt($*n,3));I=zt((+$+V)*n,3),I<=_&&x.push(I)}}else{let U=m>=s?s:m,L=pi(p)-pi(A),I=w+L+ah(A-w,U);x.push(I);let O=d(I),z=O.getHours()+O.getMinutes()/t+O.getSeconds()/i,N=m/i,W=h.axes[f]._space,$=g/W;for(;I=zt(I+m,n==1?0:3),!(I>_);)if(N>1){let V=pi(zt(z+N,6))%24,Q=d(I).getHours()-V;Q>1&&(Q=-1),I-=Q*i,z=(z+N)%24;let ie=x[x.length-1];zt((I-ie)/m,3)*$>=.7&&x.push(I)}else x.push(I)}return x}}return[l,c,u]}var[uA,hA,fA]=kx(1),[dA,pA,mA]=kx(.001);Ja(2,-53,53,[1]);function ix(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function sx(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,d,h,f;return i.map(p=>{let _=n(p),m=_.getFullYear(),g=_.getMonth(),x=_.getDate(),M=_.getHours(),y=_.getMinutes(),C=_.getSeconds(),A=m!=l&&a[2]||g!=c&&a[3]||x!=u&&a[4]||M!=d&&a[5]||y!=h&&a[6]||C!=f&&a[7]||a[1];return l=m,c=g,u=x,d=M,h=y,f=C,A(_)})}}function gA(n,e){let t=pp(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Yd(n,e,t){return new Date(n,e,t)}function rx(n,e){return e(n)}var _A="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function ox(n,e){return(t,i,s,r)=>r==null?lp:e(n(i))}function xA(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function vA(n,e){return n.series[e].fill(n,e)}var yA={show:!0,live:!0,isolate:!1,mount:kT,markers:{show:!0,width:2,stroke:xA,fill:vA,dash:"solid"},idx:null,idxs:null,values:[]};function bA(n,e){let t=n.cursor.points,i=Ci(),s=t.size(n,e);Zt(i,Xa,s),Zt(i,qa,s);let r=s/-2;Zt(i,"marginLeft",r),Zt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Zt(i,"borderWidth",o),i}function MA(n,e){let t=n.series[e].points;return t._fill||t._stroke}function SA(n,e){let t=n.series[e].points;return t._stroke||t._fill}function wA(n,e){return n.series[e].points.size}var Zd=[0,0];function EA(n,e,t){return Zd[0]=e,Zd[1]=t,Zd}function eh(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Jd(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var TA={show:!0,x:!0,y:!0,lock:!1,move:EA,points:{one:!1,show:bA,size:wA,width:0,stroke:SA,fill:MA},bind:{mousedown:eh,mouseup:eh,click:eh,dblclick:eh,mousemove:Jd,mouseleave:Jd,mouseenter:Jd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},zx={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},gp=bn({},zx,{filter:Tx}),Hx=bn({},gp,{size:10}),Vx=bn({},zx,{show:!1}),_p='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Gx="bold "+_p,Wx=1.5,ax={show:!0,scale:"x",stroke:ap,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Gx,side:2,grid:gp,ticks:Hx,border:Vx,font:_p,lineGap:Wx,rotate:0},AA="Value",CA="Time",lx={show:!0,scale:"x",auto:!1,sorted:1,min:kt,max:-kt,idxs:[]};function RA(n,e,t,i,s){return e.map(r=>r==null?"":fp(r))}function PA(n,e,t,i,s,r,o){let a=[],l=rr.get(s)||0;t=o?t:zt(ah(t,s),l);for(let c=t;c<=i;c=zt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function np(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Rs:Sx,u=pi(c(t));s=Uo(l,u),l==10&&(s=Rr[Wi(s,Rr)]);let d=t,h=s*l;l==10&&(h=Rr[Wi(h,Rr)]);do a.push(d),d=d+s,l==10&&!rr.has(d)&&(d=zt(d,rr.get(s))),d>=h&&(s=d,h=s*l,l==10&&(h=Rr[Wi(h,Rr)]));while(d<=i);return a}function IA(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?np(n,e,Qn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?np(n,e,Qn(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var Xx=/./,LA=/[12357]/,DA=/[125]/,cx=/1/,ip=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function NA(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),d=l(9,o)-u>=c?Xx:l(7,o)-u>=c?LA:l(5,o)-u>=c?DA:cx;if(d==cx){let h=An(l(1,o)-u);if(h<c)return ip(e.slice().reverse(),a.distr,d,Ri(c/h)).reverse()}return ip(e,a.distr,d,1)}function FA(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=An(l(1,o)-l(2,o));return c<a?ip(e.slice().reverse(),3,Xx,Ri(a/c)).reverse():e}function UA(n,e,t,i){return i==null?lp:e==null?"":fp(e)}var ux={show:!0,scale:"y",stroke:ap,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Gx,side:3,grid:gp,ticks:Hx,border:Vx,font:_p,lineGap:Wx,rotate:0};function OA(n,e){let t=3+(n||1)*2;return zt(t*e,3)}function BA(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=An(o-r),l=n.series[e],c=a/(l.points.space*Et);return i[1]-i[0]<=c}var hx={scale:null,auto:!0,sorted:0,min:kt,max:-kt},qx=(n,e,t,i,s)=>s,fx={show:!0,auto:!0,sorted:0,gaps:qx,alpha:1,facets:[bn({},hx,{scale:"x"}),bn({},hx,{scale:"y"})]},dx={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:qx,alpha:1,points:{show:BA,filter:null},values:null,min:kt,max:-kt,idxs:[],path:null,clip:null};function kA(n,e,t,i,s){return t/10}var $x={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},zA=bn({},$x,{time:!1,ori:1}),px={};function Yx(n,e){let t=px[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(px[n]=t)),t}var ko=1,sp=2;function Dr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,f=a.top,p=a.width,_=a.height,m=n.valToPosH,g=n.valToPosV;return u.ori==0?t(s,l,c,u,d,m,g,h,f,p,_,uh,Ho,fh,Jx,jx):t(s,l,c,u,d,g,m,f,h,_,p,hh,Vo,yp,Kx,Qx)}function xp(n,e){let t=0,i=0,s=St(n.bands,dp);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function HA(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ps(n,e,t,i,s,r){return Dr(n,e,(o,a,l,c,u,d,h,f,p,_,m)=>{let g=o.pxRound,x=c.dir*(c.ori==0?1:-1),M=c.ori==0?Ho:Vo,y,C;x==1?(y=t,C=i):(y=i,C=t);let A=g(d(a[y],c,_,f)),v=g(h(l[y],u,m,p)),w=g(d(a[C],c,_,f)),U=g(h(r==1?u.max:u.min,u,m,p)),L=new Path2D(s);return M(L,w,U),M(L,A,U),M(L,A,v),L})}function ch(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?fh:yp,l=t;for(let d=0;d<n.length;d++){let h=n[d];if(h[1]>h[0]){let f=h[0]-l;f>0&&a(o,l,i,f,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function VA(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function vp(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let d=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let f=r(n[d]),p=h==d?f:r(n[h]),_=d-s;f=o<=0&&_>=0&&_<l?r(n[_]):f;let g=h+s;p=o>=0&&g>=0&&g<l?r(n[g]):p,p>=f&&a.push([f,p])}return a}function mx(n){return n==0?Ex:n==1?Tn:e=>Cr(e,n)}function Zx(n){let e=n==0?uh:hh,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Xi(c,a/2,l/2),u=Xi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var uh=(n,e,t)=>{n.moveTo(e,t)},hh=(n,e,t)=>{n.moveTo(t,e)},Ho=(n,e,t)=>{n.lineTo(e,t)},Vo=(n,e,t)=>{n.lineTo(t,e)},fh=Zx(0),yp=Zx(1),Jx=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},Kx=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},jx=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Qx=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function ev(n){return(e,t,i,s,r)=>Dr(e,t,(o,a,l,c,u,d,h,f,p,_,m)=>{let{pxRound:g,points:x}=o,M,y;c.ori==0?(M=uh,y=Jx):(M=hh,y=Kx);let C=zt(x.width*Et,3),A=(x.size-x.width)/2*Et,v=zt(A*2,3),w=new Path2D,U=new Path2D,{left:L,top:I,width:O,height:z}=e.bbox;fh(U,L-v,I-v,O+v*2,z+v*2);let N=W=>{if(l[W]!=null){let $=g(d(a[W],c,_,f)),V=g(h(l[W],u,m,p));M(w,$+A,V),y(w,$,V,A,0,th*2)}};if(r)r.forEach(N);else for(let W=i;W<=s;W++)N(W);return{stroke:C>0?w:null,fill:w,clip:U,flags:ko|sp}})}function tv(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var GA=tv(Ho),WA=tv(Vo);function nv(n){let e=St(n?.alignGaps,0);return(t,i,s,r)=>Dr(t,i,(o,a,l,c,u,d,h,f,p,_,m)=>{[s,r]=rh(l,s,r);let g=o.pxRound,x=z=>g(d(z,c,_,f)),M=z=>g(h(z,u,m,p)),y,C;c.ori==0?(y=Ho,C=GA):(y=Vo,C=WA);let A=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ko},w=v.stroke,U=!1;if(r-s>=_*4){let z=he=>t.posToVal(he,c.key,!0),N=null,W=null,$,V,le,J=x(a[A==1?s:r]),Q=x(a[s]),ie=x(a[r]),fe=z(A==1?Q+1:ie-1);for(let he=A==1?s:r;he>=s&&he<=r;he+=A){let ee=a[he],ge=(A==1?ee<fe:ee>fe)?J:x(ee),Se=l[he];ge==J?Se!=null?(V=Se,N==null?(y(w,ge,M(V)),$=N=W=V):V<N?N=V:V>W&&(W=V)):Se===null&&(U=!0):(N!=null&&C(w,J,M(N),M(W),M($),M(V)),Se!=null?(V=Se,y(w,ge,M(V)),N=W=$=V):(N=W=null,Se===null&&(U=!0)),J=ge,fe=z(J+A))}N!=null&&N!=W&&le!=J&&C(w,J,M(N),M(W),M($),M(V))}else for(let z=A==1?s:r;z>=s&&z<=r;z+=A){let N=l[z];N===null?U=!0:N!=null&&y(w,x(a[z]),M(N))}let[I,O]=xp(t,i);if(o.fill!=null||I!=0){let z=v.fill=new Path2D(w),N=o.fillTo(t,i,o.min,o.max,I),W=M(N),$=x(a[s]),V=x(a[r]);A==-1&&([V,$]=[$,V]),y(z,V,W),y(z,$,W)}if(!o.spanGaps){let z=[];U&&z.push(...vp(a,l,s,r,A,x,e)),v.gaps=z=o.gaps(t,i,s,r,z),v.clip=ch(z,c.ori,f,p,_,m)}return O!=0&&(v.band=O==2?[Ps(t,i,s,r,w,-1),Ps(t,i,s,r,w,1)]:Ps(t,i,s,r,w,O)),v})}function XA(n){let e=St(n.align,1),t=St(n.ascDesc,!1),i=St(n.alignGaps,0),s=St(n.extend,!1);return(r,o,a,l)=>Dr(r,o,(c,u,d,h,f,p,_,m,g,x,M)=>{[a,l]=rh(d,a,l);let y=c.pxRound,{left:C,width:A}=r.bbox,v=Q=>y(p(Q,h,x,m)),w=Q=>y(_(Q,f,M,g)),U=h.ori==0?Ho:Vo,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ko},I=L.stroke,O=h.dir*(h.ori==0?1:-1),z=w(d[O==1?a:l]),N=v(u[O==1?a:l]),W=N,$=N;s&&e==-1&&($=C,U(I,$,z)),U(I,N,z);for(let Q=O==1?a:l;Q>=a&&Q<=l;Q+=O){let ie=d[Q];if(ie==null)continue;let fe=v(u[Q]),he=w(ie);e==1?U(I,fe,z):U(I,W,he),U(I,fe,he),z=he,W=fe}let V=W;s&&e==1&&(V=C+A,U(I,V,z));let[le,J]=xp(r,o);if(c.fill!=null||le!=0){let Q=L.fill=new Path2D(I),ie=c.fillTo(r,o,c.min,c.max,le),fe=w(ie);U(Q,V,fe),U(Q,$,fe)}if(!c.spanGaps){let Q=[];Q.push(...vp(u,d,a,l,O,v,i));let ie=c.width*Et/2,fe=t||e==1?ie:-ie,he=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=fe,ee[1]+=he}),L.gaps=Q=c.gaps(r,o,a,l,Q),L.clip=ch(Q,h.ori,m,g,x,M)}return J!=0&&(L.band=J==2?[Ps(r,o,a,l,I,-1),Ps(r,o,a,l,I,1)]:Ps(r,o,a,l,I,J)),L})}function gx(n,e,t,i,s,r,o=kt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=An(n[l]-n[a]);u<c&&(c=u,o=An(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function qA(n){n=n||Za;let e=St(n.size,[.6,kt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=mt(s),o=1-e[0],a=St(e[1],kt),l=St(e[2],1),c=St(n.disp,Za),u=St(n.each,f=>{}),{fill:d,stroke:h}=c;return(f,p,_,m)=>Dr(f,p,(g,x,M,y,C,A,v,w,U,L,I)=>{let O=g.pxRound,z=t,N=i*Et,W=a*Et,$=l*Et,V,le;y.ori==0?[V,le]=r(f,p):[le,V]=r(f,p);let J=y.dir*(y.ori==0?1:-1),Q=y.ori==0?fh:yp,ie=y.ori==0?u:(Re,$e,rt,we,Bt,Ve,Xe)=>{u(Re,$e,rt,Bt,we,Xe,Ve)},fe=St(f.bands,dp).find(Re=>Re.series[0]==p),he=fe!=null?fe.dir:0,ee=g.fillTo(f,p,g.min,g.max,he),me=O(v(ee,C,I,U)),ge,Se,xe,He=L,qe=O(g.width*Et),Fe=!1,Je=null,Ze=null,je=null,Ot=null;d!=null&&(qe==0||h!=null)&&(Fe=!0,Je=d.values(f,p,_,m),Ze=new Map,new Set(Je).forEach(Re=>{Re!=null&&Ze.set(Re,new Path2D)}),qe>0&&(je=h.values(f,p,_,m),Ot=new Map,new Set(je).forEach(Re=>{Re!=null&&Ot.set(Re,new Path2D)})));let{x0:Ct,size:un}=c;if(Ct!=null&&un!=null){z=1,x=Ct.values(f,p,_,m),Ct.unit==2&&(x=x.map(rt=>f.posToVal(w+rt*L,y.key,!0)));let Re=un.values(f,p,_,m);un.unit==2?Se=Re[0]*L:Se=A(Re[0],y,L,w)-A(0,y,L,w),He=gx(x,M,A,y,L,w,He),xe=He-Se+N}else He=gx(x,M,A,y,L,w,He),xe=He*o+N,Se=He-xe;xe<1&&(xe=0),qe>=Se/2&&(qe=0),xe<5&&(O=Ex);let Ft=xe>0,Cn=He-xe-(Ft?qe:0);Se=O(tp(Cn,$,W)),ge=(z==0?Se/2:z==J?0:Se)-z*J*((z==0?N/2:0)+(Ft?qe/2:0));let xt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Mn=Fe?null:new Path2D,en=null;if(fe!=null)en=f.data[fe.series[1]];else{let{y0:Re,y1:$e}=c;Re!=null&&$e!=null&&(M=$e.values(f,p,_,m),en=Re.values(f,p,_,m))}let hn=V*Se,k=le*Se;for(let Re=J==1?_:m;Re>=_&&Re<=m;Re+=J){let $e=M[Re];if($e==null)continue;if(en!=null){let q=en[Re]??0;if($e-q==0)continue;me=v(q,C,I,U)}let rt=y.distr!=2||c!=null?x[Re]:Re,we=A(rt,y,L,w),Bt=v(St($e,ee),C,I,U),Ve=O(we-ge),Xe=O(Qn(Bt,me)),R=O(Xi(Bt,me)),S=Xe-R;if($e!=null){let q=$e<0?k:hn,ue=$e<0?hn:k;Fe?(qe>0&&je[Re]!=null&&Q(Ot.get(je[Re]),Ve,R+pi(qe/2),Se,Qn(0,S-qe),q,ue),Je[Re]!=null&&Q(Ze.get(Je[Re]),Ve,R+pi(qe/2),Se,Qn(0,S-qe),q,ue)):Q(Mn,Ve,R+pi(qe/2),Se,Qn(0,S-qe),q,ue),ie(f,p,Re,Ve-qe/2,R,Se+qe,S)}}return qe>0?xt.stroke=Fe?Ot:Mn:Fe||(xt._fill=g.width==0?g._fill:g._stroke??g._fill,xt.width=0),xt.fill=Fe?Ze:Mn,xt})}function $A(n,e){let t=St(e?.alignGaps,0);return(i,s,r,o)=>Dr(i,s,(a,l,c,u,d,h,f,p,_,m,g)=>{[r,o]=rh(c,r,o);let x=a.pxRound,M=V=>x(h(V,u,m,p)),y=V=>x(f(V,d,g,_)),C,A,v;u.ori==0?(C=uh,v=Ho,A=jx):(C=hh,v=Vo,A=Qx);let w=u.dir*(u.ori==0?1:-1),U=M(l[w==1?r:o]),L=U,I=[],O=[];for(let V=w==1?r:o;V>=r&&V<=o;V+=w)if(c[V]!=null){let J=l[V],Q=M(J);I.push(L=Q),O.push(y(c[V]))}let z={stroke:n(I,O,C,v,A,x),fill:null,clip:null,band:null,gaps:null,flags:ko},N=z.stroke,[W,$]=xp(i,s);if(a.fill!=null||W!=0){let V=z.fill=new Path2D(N),le=a.fillTo(i,s,a.min,a.max,W),J=y(le);v(V,L,J),v(V,U,J)}if(!a.spanGaps){let V=[];V.push(...vp(l,c,r,o,w,M,t)),z.gaps=V=a.gaps(i,s,r,o,V),z.clip=ch(V,u.ori,p,_,m,g)}return $!=0&&(z.band=$==2?[Ps(i,s,r,o,N,-1),Ps(i,s,r,o,N,1)]:Ps(i,s,r,o,N,$)),z})}function YA(n){return $A(ZA,n)}function ZA(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),d=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],d[h]=n[h+1]-n[h],c[h]=u[h]/d[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(d[h-1]+d[h])/((2*d[h]+d[h-1])/c[h-1]+(d[h]+2*d[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+d[h]/3,e[h]+l[h]*d[h]/3,n[h+1]-d[h]/3,e[h+1]-l[h+1]*d[h]/3,n[h+1],e[h+1])}return a}var rp=new Set;function _x(){for(let n of rp)n.syncRect(!0)}zo&&(Ir(RT,Fo,_x),Ir(PT,Fo,_x,!0),Ir(nh,Fo,()=>{zn.pxRatio=Et}));var JA=nv(),KA=ev();function xx(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>op(r,o,e,t))}function jA(n,e){return n.map((t,i)=>i==0?{}:bn({},e,t))}function op(n,e,t,i){return bn({},e==0?t:i,n)}function iv(n,e,t){return e==null?Oo:[e,t]}var QA=iv;function eC(n,e,t){return e==null?Oo:ih(e,t,hp,!0)}function sv(n,e,t,i){return e==null?Oo:oh(e,t,n.scales[i].log,!1)}var tC=sv;function rv(n,e,t,i){return e==null?Oo:up(e,t,n.scales[i].log,!1)}var nC=rv;function iC(n,e,t,i,s){let r=Qn(J_(n),J_(e)),o=e-n,a=Wi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?rr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function vx(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Tn((t=+s)*Et))+"px"),[n,e,t]}function sC(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=zt(e[2]*Et,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function zn(n,e,t){let i={mode:St(n.mode,1)},s=i.mode;function r(b,E,P,F){let X=E.valToPct(b);return F+P*(E.dir==-1?1-X:X)}function o(b,E,P,F){let X=E.valToPct(b);return F+P*(E.dir==-1?X:1-X)}function a(b,E,P,F){return E.ori==0?r(b,E,P,F):o(b,E,P,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ci(hT);if(n.id!=null&&(c.id=n.id),di(c,n.class),n.title){let b=Ci(pT,c);b.textContent=n.title}let u=Gi("canvas"),d=i.ctx=u.getContext("2d"),h=Ci(mT,c);Ir("click",h,b=>{b.target===p&&(Gt!=zr||Jt!=Hr)&&On.click(i,b)},!0);let f=i.under=Ci(gT,h);h.appendChild(u);let p=i.over=Ci(_T,h);n=Bo(n);let _=+St(n.pxAlign,1),m=mx(_);(n.plugins||[]).forEach(b=>{b.opts&&(n=b.opts(i,n)||n)});let g=n.ms||.001,x=i.series=s==1?xx(n.series||[],lx,dx,!1):jA(n.series||[null],fx),M=i.axes=xx(n.axes||[],ax,ux,!0),y=i.scales={},C=i.bands=n.bands||[];C.forEach(b=>{b.fill=mt(b.fill||null),b.dir=St(b.dir,-1)});let A=s==2?x[1].facets[0].scale:x[0].scale,v={axes:hs,series:ht},w=(n.drawOrder||["axes","series"]).map(b=>v[b]);function U(b){let E=b.distr==3?P=>Rs(P>0?P:b.clamp(i,P,b.min,b.max,b.key)):b.distr==4?P=>$d(P,b.asinh):b.distr==100?P=>b.fwd(P):P=>P;return P=>{let F=E(P),{_min:X,_max:K}=b,ae=K-X;return(F-X)/ae}}function L(b){let E=y[b];if(E==null){let P=(n.scales||Za)[b]||Za;if(P.from!=null){L(P.from);let F=bn({},y[P.from],P,{key:b});F.valToPct=U(F),y[b]=F}else{E=y[b]=bn({},b==A?$x:zA,P),E.key=b;let F=E.time,X=E.range,K=sr(X);if((b!=A||s==2&&!F)&&(K&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?$_:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?$_:{mode:1,hard:X[1],soft:X[1]}},K=!1),!K&&lh(X))){let ae=X;X=(de,be,De)=>be==null?Oo:ih(be,De,ae)}E.range=mt(X||(F?QA:b==A?E.distr==3?tC:E.distr==4?nC:iv:E.distr==3?sv:E.distr==4?rv:eC)),E.auto=mt(K?!1:E.auto),E.clamp=mt(E.clamp||kA),E._min=E._max=null,E.valToPct=U(E)}}}L("x"),L("y"),s==1&&x.forEach(b=>{L(b.scale)}),M.forEach(b=>{L(b.scale)});for(let b in n.scales)L(b);let I=y[A],O=I.distr,z,N;I.ori==0?(di(c,fT),z=r,N=o):(di(c,dT),z=o,N=r);let W={};for(let b in y){let E=y[b];(E.min!=null||E.max!=null)&&(W[b]={min:E.min,max:E.max},E.min=E.max=null)}let $=n.tzDate||(b=>new Date(Tn(b/g))),V=n.fmtDate||pp,le=g==1?fA($):mA($),J=sx($,ix(g==1?hA:pA,V)),Q=ox($,rx(_A,V)),ie=[],fe=i.legend=bn({},yA,n.legend),he=i.cursor=bn({},TA,{drag:{y:s==2}},n.cursor),ee=fe.show,me=he.show,ge=fe.markers;fe.idxs=ie,ge.width=mt(ge.width),ge.dash=mt(ge.dash),ge.stroke=mt(ge.stroke),ge.fill=mt(ge.fill);let Se,xe,He,qe=[],Fe=[],Je,Ze=!1,je={};if(fe.live){let b=x[1]?x[1].values:null;Ze=b!=null,Je=Ze?b(i,1,0):{_:0};for(let E in Je)je[E]=lp}if(ee)if(Se=Gi("table",ST,c),He=Gi("tbody",null,Se),fe.mount(i,Se),Ze){xe=Gi("thead",null,Se,He);let b=Gi("tr",null,xe);Gi("th",null,b);for(var Ot in Je)Gi("th",N_,b).textContent=Ot}else di(Se,ET),fe.live&&di(Se,wT);let Ct={show:!0},un={show:!1};function Ft(b,E){if(E==0&&(Ze||!fe.live||s==2))return Oo;let P=[],F=Gi("tr",TT,He,He.childNodes[E]);di(F,b.class),b.show||di(F,Pr);let X=Gi("th",null,F);if(ge.show){let de=Ci(AT,X);if(E>0){let be=ge.width(i,E);be&&(de.style.border=be+"px "+ge.dash(i,E)+" "+ge.stroke(i,E)),de.style.background=ge.fill(i,E)}}let K=Ci(N_,X);b.label instanceof HTMLElement?K.appendChild(b.label):K.textContent=b.label,E>0&&(ge.show||(K.style.color=b.width>0?ge.stroke(i,E):ge.fill(i,E)),xt("click",X,de=>{if(he._lock)return;Qe(de);let be=x.indexOf(b);if((de.ctrlKey||de.metaKey)!=fe.isolate){let De=x.some((Ne,Oe)=>Oe>0&&Oe!=be&&Ne.show);x.forEach((Ne,Oe)=>{Oe>0&&Zi(Oe,De?Oe==be?Ct:un:Ct,!0,mn.setSeries)})}else Zi(be,{show:!b.show},!0,mn.setSeries)},!1),et&&xt(B_,X,de=>{he._lock||(Qe(de),Zi(x.indexOf(b),Gr,!0,mn.setSeries))},!1));for(var ae in Je){let de=Gi("td",CT,F);de.textContent="--",P.push(de)}return[F,P]}let Cn=new Map;function xt(b,E,P,F=!0){let X=Cn.get(E)||{},K=he.bind[b](i,E,P,F);K&&(Ir(b,E,X[b]=K),Cn.set(E,X))}function Mn(b,E,P){let F=Cn.get(E)||{};for(let X in F)(b==null||X==b)&&(ep(X,E,F[X]),delete F[X]);b==null&&Cn.delete(E)}let en=0,hn=0,k=0,Re=0,$e=0,rt=0,we=$e,Bt=rt,Ve=k,Xe=Re,R=0,S=0,q=0,ue=0;i.bbox={};let oe=!1,ve=!1,ye=!1,te=!1,se=!1,pe=!1;function B(b,E,P){(P||b!=i.width||E!=i.height)&&re(b,E),lt(!1),ye=!0,ve=!0,Hn()}function re(b,E){i.width=en=k=b,i.height=hn=Re=E,$e=rt=0,Me(),Ge();let P=i.bbox;R=P.left=Cr($e*Et,.5),S=P.top=Cr(rt*Et,.5),q=P.width=Cr(k*Et,.5),ue=P.height=Cr(Re*Et,.5)}let ne=3;function Ee(){let b=!1,E=0;for(;!b;){E++;let P=Or(E),F=Yi(E);b=E==ne||P&&F,b||(re(i.width,i.height),ve=!0)}}function _e({width:b,height:E}){B(b,E)}i.setSize=_e;function Me(){let b=!1,E=!1,P=!1,F=!1;M.forEach((X,K)=>{if(X.show&&X._show){let{side:ae,_size:de}=X,be=ae%2,De=X.label!=null?X.labelSize:0,Ne=de+De;Ne>0&&(be?(k-=Ne,ae==3?($e+=Ne,F=!0):P=!0):(Re-=Ne,ae==0?(rt+=Ne,b=!0):E=!0))}}),qi[0]=b,qi[1]=P,qi[2]=E,qi[3]=F,k-=Pi[1]+Pi[3],$e+=Pi[3],Re-=Pi[2]+Pi[0],rt+=Pi[0]}function Ge(){let b=$e+k,E=rt+Re,P=$e,F=rt;function X(K,ae){switch(K){case 1:return b+=ae,b-ae;case 2:return E+=ae,E-ae;case 3:return P-=ae,P+ae;case 0:return F-=ae,F+ae}}M.forEach((K,ae)=>{if(K.show&&K._show){let de=K.side;K._pos=X(de,K._size),K.label!=null&&(K._lpos=X(de,K.labelSize))}})}if(he.dataIdx==null){let b=he.hover,E=b.skip=new Set(b.skip??[]);E.add(void 0);let P=b.prox=mt(b.prox),F=b.bias??=0;he.dataIdx=(X,K,ae,de)=>{if(K==0)return ae;let be=ae,De=P(X,K,ae,de)??kt,Ne=De>=0&&De<kt,Oe=I.ori==0?k:Re,st=he.left,wt=e[0],Mt=e[K];if(E.has(Mt[ae])){be=null;let ft=null,Ke=null,We;if(F==0||F==-1)for(We=ae;ft==null&&We-- >0;)E.has(Mt[We])||(ft=We);if(F==0||F==1)for(We=ae;Ke==null&&We++<Mt.length;)E.has(Mt[We])||(Ke=We);if(ft!=null||Ke!=null)if(Ne){let Xt=ft==null?-1/0:z(wt[ft],I,Oe,0),sn=Ke==null?1/0:z(wt[Ke],I,Oe,0),Ln=st-Xt,Ut=sn-st;Ln<=Ut?Ln<=De&&(be=ft):Ut<=De&&(be=Ke)}else be=Ke==null?ft:ft==null?Ke:ae-ft<=Ke-ae?ft:Ke}else Ne&&An(st-z(wt[ae],I,Oe,0))>De&&(be=null);return be}}let Qe=b=>{he.event=b};he.idxs=ie,he._lock=!1;let ce=he.points;ce.show=mt(ce.show),ce.size=mt(ce.size),ce.stroke=mt(ce.stroke),ce.width=mt(ce.width),ce.fill=mt(ce.fill);let Be=i.focus=bn({},n.focus||{alpha:.3},he.focus),et=Be.prox>=0,Ce=et&&ce.one,ot=[],Vt=[],Xn=[];function Go(b,E){let P=ce.show(i,E);if(P instanceof HTMLElement)return di(P,MT),di(P,b.class),as(P,-10,-10,k,Re),p.insertBefore(P,ot[E]),P}function Nr(b,E){if(s==1||E>0){let P=s==1&&y[b.scale].time,F=b.value;b.value=P?Q_(F)?ox($,rx(F,V)):F||Q:F||UA,b.label=b.label||(P?CA:AA)}if(Ce||E>0){b.width=b.width==null?1:b.width,b.paths=b.paths||JA||zT,b.fillTo=mt(b.fillTo||HA),b.pxAlign=+St(b.pxAlign,_),b.pxRound=mx(b.pxAlign),b.stroke=mt(b.stroke||null),b.fill=mt(b.fill||null),b._stroke=b._fill=b._paths=b._focus=null;let P=OA(Qn(1,b.width),1),F=b.points=bn({},{size:P,width:Qn(1,P*.2),stroke:b.stroke,space:P*2,paths:KA,_stroke:null,_fill:null},b.points);F.show=mt(F.show),F.filter=mt(F.filter),F.fill=mt(F.fill),F.stroke=mt(F.stroke),F.paths=mt(F.paths),F.pxAlign=b.pxAlign}if(ee){let P=Ft(b,E);qe.splice(E,0,P[0]),Fe.splice(E,0,P[1]),fe.values.push(null)}if(me){ie.splice(E,0,null);let P=null;Ce?E==0&&(P=Go(b,E)):E>0&&(P=Go(b,E)),ot.splice(E,0,P),Vt.splice(E,0,0),Xn.splice(E,0,0)}In("addSeries",E)}function dh(b,E){E=E??x.length,b=s==1?op(b,E,lx,dx):op(b,E,{},fx),x.splice(E,0,b),Nr(x[E],E)}i.addSeries=dh;function ja(b){if(x.splice(b,1),ee){fe.values.splice(b,1),Fe.splice(b,1);let E=qe.splice(b,1)[0];Mn(null,E.firstChild),E.remove()}me&&(ie.splice(b,1),ot.splice(b,1)[0].remove(),Vt.splice(b,1),Xn.splice(b,1)),In("delSeries",b)}i.delSeries=ja;let qi=[!1,!1,!1,!1];function ls(b,E){if(b._show=b.show,b.show){let P=b.side%2,F=y[b.scale];F==null&&(b.scale=P?x[1].scale:A,F=y[b.scale]);let X=F.time;b.size=mt(b.size),b.space=mt(b.space),b.rotate=mt(b.rotate),sr(b.incrs)&&b.incrs.forEach(ae=>{!rr.has(ae)&&rr.set(ae,Cx(ae))}),b.incrs=mt(b.incrs||(F.distr==2?lA:X?g==1?uA:dA:Rr)),b.splits=mt(b.splits||(X&&F.distr==1?le:F.distr==3?np:F.distr==4?IA:PA)),b.stroke=mt(b.stroke),b.grid.stroke=mt(b.grid.stroke),b.ticks.stroke=mt(b.ticks.stroke),b.border.stroke=mt(b.border.stroke);let K=b.values;b.values=sr(K)&&!sr(K[0])?mt(K):X?sr(K)?sx($,ix(K,V)):Q_(K)?gA($,K):K||J:K||RA,b.filter=mt(b.filter||(F.distr>=3&&F.log==10?NA:F.distr==3&&F.log==2?FA:Tx)),b.font=vx(b.font),b.labelFont=vx(b.labelFont),b._size=b.size(i,null,E,0),b._space=b._rotate=b._incrs=b._found=b._splits=b._values=null,b._size>0&&(qi[E]=!0,b._el=Ci(xT,h))}}function cs(b,E,P,F){let[X,K,ae,de]=P,be=E%2,De=0;return be==0&&(de||K)&&(De=E==0&&!X||E==2&&!ae?Tn(ax.size/3):0),be==1&&(X||ae)&&(De=E==1&&!K||E==3&&!de?Tn(ux.size/2):0),De}let Wo=i.padding=(n.padding||[cs,cs,cs,cs]).map(b=>mt(St(b,cs))),Pi=i._padding=Wo.map((b,E)=>b(i,E,qi,0)),tn,an=null,ln=null,$i=s==1?x[0].idxs:null,ni=null,Is=!1;function Xo(b,E){if(e=b??[],i.data=i._data=e,s==2){tn=0;for(let P=1;P<x.length;P++)tn+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),ni=e[0],tn=ni.length;let P=e;if(O==2){P=e.slice();let F=P[0]=Array(tn);for(let X=0;X<tn;X++)F[X]=X}i._data=e=P}if(lt(!0),In("setData"),O==2&&(ye=!0),E!==!1){let P=I;P.auto(i,Is)?qo():Ns(A,P.min,P.max),te=te||he.left>=0,pe=!0,Hn()}}i.setData=Xo;function qo(){Is=!0;let b,E;s==1&&(tn>0?(an=$i[0]=0,ln=$i[1]=tn-1,b=e[0][an],E=e[0][ln],O==2?(b=an,E=ln):b==E&&(O==3?[b,E]=oh(b,b,I.log,!1):O==4?[b,E]=up(b,b,I.log,!1):I.time?E=b+Tn(86400/g):[b,E]=ih(b,E,hp,!0))):(an=$i[0]=b=null,ln=$i[1]=E=null)),Ns(A,b,E)}let Fr,Ls,Ur,T,H,j,Y,Z,Te,Pe;function Ae(b,E,P,F,X,K){b??=U_,P??=dp,F??="butt",X??=U_,K??="round",b!=Fr&&(d.strokeStyle=Fr=b),X!=Ls&&(d.fillStyle=Ls=X),E!=Ur&&(d.lineWidth=Ur=E),K!=H&&(d.lineJoin=H=K),F!=j&&(d.lineCap=j=F),P!=T&&d.setLineDash(T=P)}function Ie(b,E,P,F){E!=Ls&&(d.fillStyle=Ls=E),b!=Y&&(d.font=Y=b),P!=Z&&(d.textAlign=Z=P),F!=Te&&(d.textBaseline=Te=F)}function ze(b,E,P,F,X=0){if(F.length>0&&b.auto(i,Is)&&(E==null||E.min==null)){let K=St(an,0),ae=St(ln,F.length-1),de=P.min==null?NT(F,K,ae,X,b.distr==3):[P.min,P.max];b.min=Xi(b.min,P.min=de[0]),b.max=Qn(b.max,P.max=de[1])}}let tt={min:null,max:null};function ut(){for(let F in y){let X=y[F];W[F]==null&&(X.min==null||W[A]!=null&&X.auto(i,Is))&&(W[F]=tt)}for(let F in y){let X=y[F];W[F]==null&&X.from!=null&&W[X.from]!=null&&(W[F]=tt)}W[A]!=null&&lt(!0);let b={};for(let F in W){let X=W[F];if(X!=null){let K=b[F]=Bo(y[F],GT);if(X.min!=null)bn(K,X);else if(F!=A||s==2)if(tn==0&&K.from==null){let ae=K.range(i,null,null,F);K.min=ae[0],K.max=ae[1]}else K.min=kt,K.max=-kt}}if(tn>0){x.forEach((F,X)=>{if(s==1){let K=F.scale,ae=W[K];if(ae==null)return;let de=b[K];if(X==0){let be=de.range(i,de.min,de.max,K);de.min=be[0],de.max=be[1],an=Wi(de.min,e[0]),ln=Wi(de.max,e[0]),ln-an>1&&(e[0][an]<de.min&&an++,e[0][ln]>de.max&&ln--),F.min=ni[an],F.max=ni[ln]}else F.show&&F.auto&&ze(de,ae,F,e[X],F.sorted);F.idxs[0]=an,F.idxs[1]=ln}else if(X>0&&F.show&&F.auto){let[K,ae]=F.facets,de=K.scale,be=ae.scale,[De,Ne]=e[X],Oe=b[de],st=b[be];Oe!=null&&ze(Oe,W[de],K,De,K.sorted),st!=null&&ze(st,W[be],ae,Ne,ae.sorted),F.min=ae.min,F.max=ae.max}});for(let F in b){let X=b[F],K=W[F];if(X.from==null&&(K==null||K.min==null)){let ae=X.range(i,X.min==kt?null:X.min,X.max==-kt?null:X.max,F);X.min=ae[0],X.max=ae[1]}}}for(let F in b){let X=b[F];if(X.from!=null){let K=b[X.from];if(K.min==null)X.min=X.max=null;else{let ae=X.range(i,K.min,K.max,F);X.min=ae[0],X.max=ae[1]}}}let E={},P=!1;for(let F in b){let X=b[F],K=y[F];if(K.min!=X.min||K.max!=X.max){K.min=X.min,K.max=X.max;let ae=K.distr;K._min=ae==3?Rs(K.min):ae==4?$d(K.min,K.asinh):ae==100?K.fwd(K.min):K.min,K._max=ae==3?Rs(K.max):ae==4?$d(K.max,K.asinh):ae==100?K.fwd(K.max):K.max,E[F]=P=!0}}if(P){x.forEach((F,X)=>{s==2?X>0&&E.y&&(F._paths=null):E[F.scale]&&(F._paths=null)});for(let F in E)ye=!0,In("setScale",F);me&&he.left>=0&&(te=pe=!0)}for(let F in W)W[F]=null}function ke(b){let E=tp(an-1,0,tn-1),P=tp(ln+1,0,tn-1);for(;b[E]==null&&E>0;)E--;for(;b[P]==null&&P<tn-1;)P++;return[E,P]}function ht(){if(tn>0){let b=x.some(E=>E._focus)&&Pe!=Be.alpha;b&&(d.globalAlpha=Pe=Be.alpha),x.forEach((E,P)=>{if(P>0&&E.show&&(jt(P,!1),jt(P,!0),E._paths==null)){let F=Pe;Pe!=E.alpha&&(d.globalAlpha=Pe=E.alpha);let X=s==2?[0,e[P][0].length-1]:ke(e[P]);E._paths=E.paths(i,P,X[0],X[1]),Pe!=F&&(d.globalAlpha=Pe=F)}}),x.forEach((E,P)=>{if(P>0&&E.show){let F=Pe;Pe!=E.alpha&&(d.globalAlpha=Pe=E.alpha),E._paths!=null&&Rt(P,!1);{let X=E._paths!=null?E._paths.gaps:null,K=E.points.show(i,P,an,ln,X),ae=E.points.filter(i,P,K,X);(K||ae)&&(E.points._paths=E.points.paths(i,P,an,ln,ae),Rt(P,!0))}Pe!=F&&(d.globalAlpha=Pe=F),In("drawSeries",P)}}),b&&(d.globalAlpha=Pe=1)}}function jt(b,E){let P=E?x[b].points:x[b];P._stroke=P.stroke(i,b),P._fill=P.fill(i,b)}function Rt(b,E){let P=E?x[b].points:x[b],{stroke:F,fill:X,clip:K,flags:ae,_stroke:de=P._stroke,_fill:be=P._fill,_width:De=P.width}=P._paths;De=zt(De*Et,3);let Ne=null,Oe=De%2/2;E&&be==null&&(be=De>0?"#fff":de);let st=P.pxAlign==1&&Oe>0;if(st&&d.translate(Oe,Oe),!E){let wt=R-De/2,Mt=S-De/2,ft=q+De,Ke=ue+De;Ne=new Path2D,Ne.rect(wt,Mt,ft,Ke)}E?Ue(de,De,P.dash,P.cap,be,F,X,ae,K):Pt(b,de,De,P.dash,P.cap,be,F,X,ae,Ne,K),st&&d.translate(-Oe,-Oe)}function Pt(b,E,P,F,X,K,ae,de,be,De,Ne){let Oe=!1;be!=0&&C.forEach((st,wt)=>{if(st.series[0]==b){let Mt=x[st.series[1]],ft=e[st.series[1]],Ke=(Mt._paths||Za).band;sr(Ke)&&(Ke=st.dir==1?Ke[0]:Ke[1]);let We,Xt=null;Mt.show&&Ke&&UT(ft,an,ln)?(Xt=st.fill(i,wt)||K,We=Mt._paths.clip):Ke=null,Ue(E,P,F,X,Xt,ae,de,be,De,Ne,We,Ke),Oe=!0}}),Oe||Ue(E,P,F,X,K,ae,de,be,De,Ne)}let Sn=ko|sp;function Ue(b,E,P,F,X,K,ae,de,be,De,Ne,Oe){Ae(b,E,P,F,X),(be||De||Oe)&&(d.save(),be&&d.clip(be),De&&d.clip(De)),Oe?(de&Sn)==Sn?(d.clip(Oe),Ne&&d.clip(Ne),dt(X,ae),fn(b,K,E)):de&sp?(dt(X,ae),d.clip(Oe),fn(b,K,E)):de&ko&&(d.save(),d.clip(Oe),Ne&&d.clip(Ne),dt(X,ae),d.restore(),fn(b,K,E)):(dt(X,ae),fn(b,K,E)),(be||De||Oe)&&d.restore()}function fn(b,E,P){P>0&&(E instanceof Map?E.forEach((F,X)=>{d.strokeStyle=Fr=X,d.stroke(F)}):E!=null&&b&&d.stroke(E))}function dt(b,E){E instanceof Map?E.forEach((P,F)=>{d.fillStyle=Ls=F,d.fill(P)}):E!=null&&b&&d.fill(E)}function us(b,E,P,F){let X=M[b],K;if(F<=0)K=[0,0];else{let ae=X._space=X.space(i,b,E,P,F),de=X._incrs=X.incrs(i,b,E,P,F,ae);K=iC(E,P,de,F,ae)}return X._found=K}function dn(b,E,P,F,X,K,ae,de,be,De){let Ne=ae%2/2;_==1&&d.translate(Ne,Ne),Ae(de,ae,be,De,de),d.beginPath();let Oe,st,wt,Mt,ft=X+(F==0||F==3?-K:K);P==0?(st=X,Mt=ft):(Oe=X,wt=ft);for(let Ke=0;Ke<b.length;Ke++)E[Ke]!=null&&(P==0?Oe=wt=b[Ke]:st=Mt=b[Ke],d.moveTo(Oe,st),d.lineTo(wt,Mt));d.stroke(),_==1&&d.translate(-Ne,-Ne)}function Or(b){let E=!0;return M.forEach((P,F)=>{if(!P.show)return;let X=y[P.scale];if(X.min==null){P._show&&(E=!1,P._show=!1,lt(!1));return}else P._show||(E=!1,P._show=!0,lt(!1));let K=P.side,ae=K%2,{min:de,max:be}=X,[De,Ne]=us(F,de,be,ae==0?k:Re);if(Ne==0)return;let Oe=X.distr==2,st=P._splits=P.splits(i,F,de,be,De,Ne,Oe),wt=X.distr==2?st.map(We=>ni[We]):st,Mt=X.distr==2?ni[st[1]]-ni[st[0]]:De,ft=P._values=P.values(i,P.filter(i,wt,F,Ne,Mt),F,Ne,Mt);P._rotate=K==2?P.rotate(i,ft,F,Ne):0;let Ke=P._size;P._size=Ri(P.size(i,ft,F,b)),Ke!=null&&P._size!=Ke&&(E=!1)}),E}function Yi(b){let E=!0;return Wo.forEach((P,F)=>{let X=P(i,F,qi,b);X!=Pi[F]&&(E=!1),Pi[F]=X}),E}function hs(){for(let b=0;b<M.length;b++){let E=M[b];if(!E.show||!E._show)continue;let P=E.side,F=P%2,X,K,ae=E.stroke(i,b),de=P==0||P==3?-1:1,[be,De]=E._found;if(E.label!=null){let Yn=E.labelGap*de,ri=Tn((E._lpos+Yn)*Et);Ie(E.labelFont[0],ae,"center",P==2?"top":F_),d.save(),F==1?(X=K=0,d.translate(ri,Tn(S+ue/2)),d.rotate((P==3?-th:th)/2)):(X=Tn(R+q/2),K=ri);let lr=wx(E.label)?E.label(i,b,be,De):E.label;d.fillText(lr,X,K),d.restore()}if(De==0)continue;let Ne=y[E.scale],Oe=F==0?q:ue,st=F==0?R:S,wt=E._splits,Mt=Ne.distr==2?wt.map(Yn=>ni[Yn]):wt,ft=Ne.distr==2?ni[wt[1]]-ni[wt[0]]:be,Ke=E.ticks,We=E.border,Xt=Ke.show?Ke.size:0,sn=Tn(Xt*Et),Ln=Tn((E.alignTo==2?E._size-Xt-E.gap:E.gap)*Et),Ut=E._rotate*-th/180,rn=m(E._pos*Et),ii=(sn+Ln)*de,$n=rn+ii;K=F==0?$n:0,X=F==1?$n:0;let gi=E.font[0],Ii=E.align==1?Do:E.align==2?Wd:Ut>0?Do:Ut<0?Wd:F==0?"center":P==3?Wd:Do,Ki=Ut||F==1?"middle":P==2?"top":F_;Ie(gi,ae,Ii,Ki);let si=E.font[1]*E.lineGap,_i=wt.map(Yn=>m(a(Yn,Ne,Oe,st))),Li=E._values;for(let Yn=0;Yn<Li.length;Yn++){let ri=Li[Yn];if(ri!=null){F==0?X=_i[Yn]:K=_i[Yn],ri=""+ri;let lr=ri.indexOf(`
`)==-1?[ri]:ri.split(/\n/gm);for(let Zn=0;Zn<lr.length;Zn++){let Gp=lr[Zn];Ut?(d.save(),d.translate(X,K+Zn*si),d.rotate(Ut),d.fillText(Gp,0,0),d.restore()):d.fillText(Gp,X,K+Zn*si)}}}Ke.show&&dn(_i,Ke.filter(i,Mt,b,De,ft),F,P,rn,sn,zt(Ke.width*Et,3),Ke.stroke(i,b),Ke.dash,Ke.cap);let ji=E.grid;ji.show&&dn(_i,ji.filter(i,Mt,b,De,ft),F,F==0?2:1,F==0?S:R,F==0?ue:q,zt(ji.width*Et,3),ji.stroke(i,b),ji.dash,ji.cap),We.show&&dn([rn],[1],F==0?1:0,F==0?1:2,F==1?S:R,F==1?ue:q,zt(We.width*Et,3),We.stroke(i,b),We.dash,We.cap)}In("drawAxes")}function lt(b){x.forEach((E,P)=>{P>0&&(E._paths=null,b&&(s==1?(E.min=null,E.max=null):E.facets.forEach(F=>{F.min=null,F.max=null})))})}let nn=!1,qn=!1,It=[];function pn(){qn=!1;for(let b=0;b<It.length;b++)In(...It[b]);It.length=0}function Hn(){nn||(JT(Ep),nn=!0)}function Qa(b,E=!1){nn=!0,qn=E,b(i),Ep(),E&&It.length>0&&queueMicrotask(pn)}i.batch=Qa;function Ep(){if(oe&&(ut(),oe=!1),ye&&(Ee(),ye=!1),ve){if(Zt(f,Do,$e),Zt(f,"top",rt),Zt(f,Xa,k),Zt(f,qa,Re),Zt(p,Do,$e),Zt(p,"top",rt),Zt(p,Xa,k),Zt(p,qa,Re),Zt(h,Xa,en),Zt(h,qa,hn),u.width=Tn(en*Et),u.height=Tn(hn*Et),M.forEach(({_el:b,_show:E,_size:P,_pos:F,side:X})=>{if(b!=null)if(E){let K=X===3||X===0?P:0,ae=X%2==1;Zt(b,ae?"left":"top",F-K),Zt(b,ae?"width":"height",P),Zt(b,ae?"top":"left",ae?rt:$e),Zt(b,ae?"height":"width",ae?Re:k),Qd(b,Pr)}else di(b,Pr)}),Fr=Ls=Ur=H=j=Y=Z=Te=T=null,Pe=1,Zo(!0),$e!=we||rt!=Bt||k!=Ve||Re!=Xe){lt(!1);let b=k/Ve,E=Re/Xe;if(me&&!te&&he.left>=0){he.left*=b,he.top*=E,Br&&as(Br,Tn(he.left),0,k,Re),kr&&as(kr,0,Tn(he.top),k,Re);for(let P=0;P<ot.length;P++){let F=ot[P];F!=null&&(Vt[P]*=b,Xn[P]*=E,as(F,Ri(Vt[P]),Ri(Xn[P]),k,Re))}}if(Wt.show&&!se&&Wt.left>=0&&Wt.width>0){Wt.left*=b,Wt.width*=b,Wt.top*=E,Wt.height*=E;for(let P in vh)Zt(Vr,P,Wt[P])}we=$e,Bt=rt,Ve=k,Xe=Re}In("setSize"),ve=!1}en>0&&hn>0&&(d.clearRect(0,0,u.width,u.height),In("drawClear"),w.forEach(b=>b()),In("draw")),Wt.show&&se&&(el(Wt),se=!1),me&&te&&(ar(null,!0,!1),te=!1),fe.show&&fe.live&&pe&&(_h(),pe=!1),l||(l=!0,i.status=1,In("ready")),Is=!1,nn=!1}i.redraw=(b,E)=>{ye=E||!1,b!==!1?Ns(A,I.min,I.max):Hn()};function ph(b,E){let P=y[b];if(P.from==null){if(tn==0){let F=P.range(i,E.min,E.max,b);E.min=F[0],E.max=F[1]}if(E.min>E.max){let F=E.min;E.min=E.max,E.max=F}if(tn>1&&E.min!=null&&E.max!=null&&E.max-E.min<1e-16)return;b==A&&P.distr==2&&tn>0&&(E.min=Wi(E.min,e[0]),E.max=Wi(E.max,e[0]),E.min==E.max&&E.max++),W[b]=E,oe=!0,Hn()}}i.setScale=ph;let mh,gh,Br,kr,Tp,Ap,zr,Hr,Cp,Rp,Gt,Jt,Ds=!1,On=he.drag,Rn=On.x,Pn=On.y;me&&(he.x&&(mh=Ci(yT,p)),he.y&&(gh=Ci(bT,p)),I.ori==0?(Br=mh,kr=gh):(Br=gh,kr=mh),Gt=he.left,Jt=he.top);let Wt=i.select=bn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Vr=Wt.show?Ci(vT,Wt.over?p:f):null;function el(b,E){if(Wt.show){for(let P in b)Wt[P]=b[P],P in vh&&Zt(Vr,P,b[P]);E!==!1&&In("setSelect")}}i.setSelect=el;function wv(b){if(x[b].show)ee&&Qd(qe[b],Pr);else if(ee&&di(qe[b],Pr),me){let P=Ce?ot[0]:ot[b];P!=null&&as(P,-10,-10,k,Re)}}function Ns(b,E,P){ph(b,{min:E,max:P})}function Zi(b,E,P,F){E.focus!=null&&Rv(b),E.show!=null&&x.forEach((X,K)=>{K>0&&(b==K||b==null)&&(X.show=E.show,wv(K),s==2?(Ns(X.facets[0].scale,null,null),Ns(X.facets[1].scale,null,null)):Ns(X.scale,null,null),Hn())}),P!==!1&&In("setSeries",b,E),F&&Jo("setSeries",i,b,E)}i.setSeries=Zi;function Ev(b,E){bn(C[b],E)}function Tv(b,E){b.fill=mt(b.fill||null),b.dir=St(b.dir,-1),E=E??C.length,C.splice(E,0,b)}function Av(b){b==null?C.length=0:C.splice(b,1)}i.addBand=Tv,i.setBand=Ev,i.delBand=Av;function Cv(b,E){x[b].alpha=E,me&&ot[b]!=null&&(ot[b].style.opacity=E),ee&&qe[b]&&(qe[b].style.opacity=E)}let fs,Fs,or,Gr={focus:!0};function Rv(b){if(b!=or){let E=b==null,P=Be.alpha!=1;x.forEach((F,X)=>{if(s==1||X>0){let K=E||X==0||X==b;F._focus=E?null:K,P&&Cv(X,K?1:Be.alpha)}}),or=b,P&&Hn()}}ee&&et&&xt(k_,Se,b=>{he._lock||(Qe(b),or!=null&&Zi(null,Gr,!0,mn.setSeries))});function Ji(b,E,P){let F=y[E];P&&(b=b/Et-(F.ori==1?rt:$e));let X=k;F.ori==1&&(X=Re,b=X-b),F.dir==-1&&(b=X-b);let K=F._min,ae=F._max,de=b/X,be=K+(ae-K)*de,De=F.distr;return De==3?Uo(10,be):De==4?BT(be,F.asinh):De==100?F.bwd(be):be}function Pv(b,E){let P=Ji(b,A,E);return Wi(P,e[0],an,ln)}i.valToIdx=b=>Wi(b,e[0]),i.posToIdx=Pv,i.posToVal=Ji,i.valToPos=(b,E,P)=>y[E].ori==0?r(b,y[E],P?q:k,P?R:0):o(b,y[E],P?ue:Re,P?S:0),i.setCursor=(b,E,P)=>{Gt=b.left,Jt=b.top,ar(null,E,P)};function Pp(b,E){Zt(Vr,Do,Wt.left=b),Zt(Vr,Xa,Wt.width=E)}function Ip(b,E){Zt(Vr,"top",Wt.top=b),Zt(Vr,qa,Wt.height=E)}let $o=I.ori==0?Pp:Ip,Yo=I.ori==1?Pp:Ip;function Iv(){if(ee&&fe.live)for(let b=s==2?1:0;b<x.length;b++){if(b==0&&Ze)continue;let E=fe.values[b],P=0;for(let F in E)Fe[b][P++].firstChild.nodeValue=E[F]}}function _h(b,E){if(b!=null&&(b.idxs?b.idxs.forEach((P,F)=>{ie[F]=P}):VT(b.idx)||ie.fill(b.idx),fe.idx=ie[0]),ee&&fe.live){for(let P=0;P<x.length;P++)(P>0||s==1&&!Ze)&&Lv(P,ie[P]);Iv()}pe=!1,E!==!1&&In("setLegend")}i.setLegend=_h;function Lv(b,E){let P=x[b],F=b==0&&O==2?ni:e[b],X;Ze?X=P.values(i,b,E)??je:(X=P.value(i,E==null?null:F[E],b,E),X=X==null?je:{_:X}),fe.values[b]=X}function ar(b,E,P){Cp=Gt,Rp=Jt,[Gt,Jt]=he.move(i,Gt,Jt),he.left=Gt,he.top=Jt,me&&(Br&&as(Br,Tn(Gt),0,k,Re),kr&&as(kr,0,Tn(Jt),k,Re));let F,X=an>ln;fs=kt,Fs=null;let K=I.ori==0?k:Re,ae=I.ori==1?k:Re;if(Gt<0||tn==0||X){F=he.idx=null;for(let de=0;de<x.length;de++){let be=ot[de];be!=null&&as(be,-10,-10,k,Re)}et&&Zi(null,Gr,!0,b==null&&mn.setSeries),fe.live&&(ie.fill(F),pe=!0)}else{let de,be,De;s==1&&(de=I.ori==0?Gt:Jt,be=Ji(de,A),F=he.idx=Wi(be,e[0],an,ln),De=z(e[0][F],I,K,0));let Ne=-10,Oe=-10,st=0,wt=0,Mt=!0,ft="",Ke="";for(let We=s==2?1:0;We<x.length;We++){let Xt=x[We],sn=ie[We],Ln=sn==null?null:s==1?e[We][sn]:e[We][1][sn],Ut=he.dataIdx(i,We,F,be),rn=Ut==null?null:s==1?e[We][Ut]:e[We][1][Ut];if(pe=pe||rn!=Ln||Ut!=sn,ie[We]=Ut,We>0&&Xt.show){let ii=Ut==null?-10:Ut==F?De:z(s==1?e[0][Ut]:e[We][0][Ut],I,K,0),$n=rn==null?-10:N(rn,s==1?y[Xt.scale]:y[Xt.facets[1].scale],ae,0);if(et&&rn!=null){let gi=I.ori==1?Gt:Jt,Ii=An(Be.dist(i,We,Ut,$n,gi));if(Ii<fs){let Ki=Be.bias;if(Ki!=0){let si=Ji(gi,Xt.scale),_i=rn>=0?1:-1,Li=si>=0?1:-1;Li==_i&&(Li==1?Ki==1?rn>=si:rn<=si:Ki==1?rn<=si:rn>=si)&&(fs=Ii,Fs=We)}else fs=Ii,Fs=We}}if(pe||Ce){let gi,Ii;I.ori==0?(gi=ii,Ii=$n):(gi=$n,Ii=ii);let Ki,si,_i,Li,ji,Yn,ri=!0,lr=ce.bbox;if(lr!=null){ri=!1;let Zn=lr(i,We);_i=Zn.left,Li=Zn.top,Ki=Zn.width,si=Zn.height}else _i=gi,Li=Ii,Ki=si=ce.size(i,We);if(Yn=ce.fill(i,We),ji=ce.stroke(i,We),Ce)We==Fs&&fs<=Be.prox&&(Ne=_i,Oe=Li,st=Ki,wt=si,Mt=ri,ft=Yn,Ke=ji);else{let Zn=ot[We];Zn!=null&&(Vt[We]=_i,Xn[We]=Li,q_(Zn,Ki,si,ri),W_(Zn,Yn,ji),as(Zn,Ri(_i),Ri(Li),k,Re))}}}}if(Ce){let We=Be.prox,Xt=or==null?fs<=We:fs>We||Fs!=or;if(pe||Xt){let sn=ot[0];sn!=null&&(Vt[0]=Ne,Xn[0]=Oe,q_(sn,st,wt,Mt),W_(sn,ft,Ke),as(sn,Ri(Ne),Ri(Oe),k,Re))}}}if(Wt.show&&Ds)if(b!=null){let[de,be]=mn.scales,[De,Ne]=mn.match,[Oe,st]=b.cursor.sync.scales,wt=b.cursor.drag;if(Rn=wt._x,Pn=wt._y,Rn||Pn){let{left:Mt,top:ft,width:Ke,height:We}=b.select,Xt=b.scales[Oe].ori,sn=b.posToVal,Ln,Ut,rn,ii,$n,gi=de!=null&&De(de,Oe),Ii=be!=null&&Ne(be,st);gi&&Rn?(Xt==0?(Ln=Mt,Ut=Ke):(Ln=ft,Ut=We),rn=y[de],ii=z(sn(Ln,Oe),rn,K,0),$n=z(sn(Ln+Ut,Oe),rn,K,0),$o(Xi(ii,$n),An($n-ii))):$o(0,K),Ii&&Pn?(Xt==1?(Ln=Mt,Ut=Ke):(Ln=ft,Ut=We),rn=y[be],ii=N(sn(Ln,st),rn,ae,0),$n=N(sn(Ln+Ut,st),rn,ae,0),Yo(Xi(ii,$n),An($n-ii))):Yo(0,ae)}else yh()}else{let de=An(Cp-Tp),be=An(Rp-Ap);if(I.ori==1){let st=de;de=be,be=st}Rn=On.x&&de>=On.dist,Pn=On.y&&be>=On.dist;let De=On.uni;De!=null?Rn&&Pn&&(Rn=de>=De,Pn=be>=De,!Rn&&!Pn&&(be>de?Pn=!0:Rn=!0)):On.x&&On.y&&(Rn||Pn)&&(Rn=Pn=!0);let Ne,Oe;Rn&&(I.ori==0?(Ne=zr,Oe=Gt):(Ne=Hr,Oe=Jt),$o(Xi(Ne,Oe),An(Oe-Ne)),Pn||Yo(0,ae)),Pn&&(I.ori==1?(Ne=zr,Oe=Gt):(Ne=Hr,Oe=Jt),Yo(Xi(Ne,Oe),An(Oe-Ne)),Rn||$o(0,K)),!Rn&&!Pn&&($o(0,0),Yo(0,0))}if(On._x=Rn,On._y=Pn,b==null){if(P){if(Vp!=null){let[de,be]=mn.scales;mn.values[0]=de!=null?Ji(I.ori==0?Gt:Jt,de):null,mn.values[1]=be!=null?Ji(I.ori==1?Gt:Jt,be):null}Jo(Xd,i,Gt,Jt,k,Re,F)}if(et){let de=P&&mn.setSeries,be=Be.prox;or==null?fs<=be&&Zi(Fs,Gr,!0,de):fs>be?Zi(null,Gr,!0,de):Fs!=or&&Zi(Fs,Gr,!0,de)}}pe&&(fe.idx=F,_h()),E!==!1&&In("setCursor")}let Us=null;Object.defineProperty(i,"rect",{get(){return Us==null&&Zo(!1),Us}});function Zo(b=!1){b?Us=null:(Us=p.getBoundingClientRect(),In("syncRect",Us))}function Lp(b,E,P,F,X,K,ae){he._lock||Ds&&b!=null&&b.movementX==0&&b.movementY==0||(xh(b,E,P,F,X,K,ae,!1,b!=null),b!=null?ar(null,!0,!0):ar(E,!0,!1))}function xh(b,E,P,F,X,K,ae,de,be){if(Us==null&&Zo(!1),Qe(b),b!=null)P=b.clientX-Us.left,F=b.clientY-Us.top;else{if(P<0||F<0){Gt=-10,Jt=-10;return}let[De,Ne]=mn.scales,Oe=E.cursor.sync,[st,wt]=Oe.values,[Mt,ft]=Oe.scales,[Ke,We]=mn.match,Xt=E.axes[0].side%2==1,sn=I.ori==0?k:Re,Ln=I.ori==1?k:Re,Ut=Xt?K:X,rn=Xt?X:K,ii=Xt?F:P,$n=Xt?P:F;if(Mt!=null?P=Ke(De,Mt)?a(st,y[De],sn,0):-10:P=sn*(ii/Ut),ft!=null?F=We(Ne,ft)?a(wt,y[Ne],Ln,0):-10:F=Ln*($n/rn),I.ori==1){let gi=P;P=F,F=gi}}be&&(E==null||E.cursor.event.type==Xd)&&((P<=1||P>=k-1)&&(P=Cr(P,k)),(F<=1||F>=Re-1)&&(F=Cr(F,Re))),de?(Tp=P,Ap=F,[zr,Hr]=he.move(i,P,F)):(Gt=P,Jt=F)}let vh={width:0,height:0,left:0,top:0};function yh(){el(vh,!1)}let Dp,Np,Fp,Up;function Op(b,E,P,F,X,K,ae){Ds=!0,Rn=Pn=On._x=On._y=!1,xh(b,E,P,F,X,K,ae,!0,!1),b!=null&&(xt(qd,Kd,Bp,!1),Jo(O_,i,zr,Hr,k,Re,null));let{left:de,top:be,width:De,height:Ne}=Wt;Dp=de,Np=be,Fp=De,Up=Ne}function Bp(b,E,P,F,X,K,ae){Ds=On._x=On._y=!1,xh(b,E,P,F,X,K,ae,!1,!0);let{left:de,top:be,width:De,height:Ne}=Wt,Oe=De>0||Ne>0,st=Dp!=de||Np!=be||Fp!=De||Up!=Ne;if(Oe&&st&&el(Wt),On.setScale&&Oe&&st){let wt=de,Mt=De,ft=be,Ke=Ne;if(I.ori==1&&(wt=be,Mt=Ne,ft=de,Ke=De),Rn&&Ns(A,Ji(wt,A),Ji(wt+Mt,A)),Pn)for(let We in y){let Xt=y[We];We!=A&&Xt.from==null&&Xt.min!=kt&&Ns(We,Ji(ft+Ke,We),Ji(ft,We))}yh()}else he.lock&&(he._lock=!he._lock,ar(E,!0,b!=null));b!=null&&(Mn(qd,Kd),Jo(qd,i,Gt,Jt,k,Re,null))}function Dv(b,E,P,F,X,K,ae){if(he._lock)return;Qe(b);let de=Ds;if(Ds){let be=!0,De=!0,Ne=10,Oe,st;I.ori==0?(Oe=Rn,st=Pn):(Oe=Pn,st=Rn),Oe&&st&&(be=Gt<=Ne||Gt>=k-Ne,De=Jt<=Ne||Jt>=Re-Ne),Oe&&be&&(Gt=Gt<zr?0:k),st&&De&&(Jt=Jt<Hr?0:Re),ar(null,!0,!0),Ds=!1}Gt=-10,Jt=-10,ie.fill(null),ar(null,!0,!0),de&&(Ds=de)}function kp(b,E,P,F,X,K,ae){he._lock||(Qe(b),qo(),yh(),b!=null&&Jo(z_,i,Gt,Jt,k,Re,null))}function zp(){M.forEach(sC),B(i.width,i.height,!0)}Ir(nh,Fo,zp);let Wr={};Wr.mousedown=Op,Wr.mousemove=Lp,Wr.mouseup=Bp,Wr.dblclick=kp,Wr.setSeries=(b,E,P,F)=>{let X=mn.match[2];P=X(i,E,P),P!=-1&&Zi(P,F,!0,!1)},me&&(xt(O_,p,Op),xt(Xd,p,Lp),xt(B_,p,b=>{Qe(b),Zo(!1)}),xt(k_,p,Dv),xt(z_,p,kp),rp.add(i),i.syncRect=Zo);let tl=i.hooks=n.hooks||{};function In(b,E,P){qn?It.push([b,E,P]):b in tl&&tl[b].forEach(F=>{F.call(null,i,E,P)})}(n.plugins||[]).forEach(b=>{for(let E in b.hooks)tl[E]=(tl[E]||[]).concat(b.hooks[E])});let Hp=(b,E,P)=>P,mn=bn({key:null,setSeries:!1,filters:{pub:K_,sub:K_},scales:[A,x[1]?x[1].scale:null],match:[j_,j_,Hp],values:[null,null]},he.sync);mn.match.length==2&&mn.match.push(Hp),he.sync=mn;let Vp=mn.key,bh=Yx(Vp);function Jo(b,E,P,F,X,K,ae){mn.filters.pub(b,E,P,F,X,K,ae)&&bh.pub(b,E,P,F,X,K,ae)}bh.sub(i);function Nv(b,E,P,F,X,K,ae){mn.filters.sub(b,E,P,F,X,K,ae)&&Wr[b](null,E,P,F,X,K,ae)}i.pub=Nv;function Fv(){bh.unsub(i),rp.delete(i),Cn.clear(),ep(nh,Fo,zp),c.remove(),Se?.remove(),In("destroy")}i.destroy=Fv;function Mh(){In("init",n,e),Xo(e||n.data,!1),W[A]?ph(A,W[A]):qo(),se=Wt.show&&(Wt.width>0||Wt.height>0),te=pe=!0,B(n.width,n.height)}return x.forEach(Nr),M.forEach(ls),t?t instanceof HTMLElement?(t.appendChild(c),Mh()):t(i,Mh):Mh(),i}zn.assign=bn;zn.fmtNum=fp;zn.rangeNum=ih;zn.rangeLog=oh;zn.rangeAsinh=up;zn.orient=Dr;zn.pxRatio=Et;zn.join=ZT;zn.fmtDate=pp,zn.tzDate=oA;zn.sync=Yx;{zn.addGap=VA,zn.clipGaps=ch;let n=zn.paths={points:ev};n.linear=nv,n.stepped=XA,n.bars=qA,n.spline=YA}var rC=new Set(["step","time","cycle","roll_angle","position"]);function bp(n){return n.values.reduce((e,t)=>t!==null&&Number.isFinite(t)?Math.max(e,Math.abs(t)):e,0)}function ov({core:n}){let e=n.source?.outputs?.columns??[],t=e.filter(o=>!rC.has(o.name)&&o.values.some(a=>typeof a=="number"&&Number.isFinite(a))),i=t.find(o=>n.state.plotted.includes(o.name))?.name??t[0]?.name??"",s=t.find(o=>o.name===i),r=e.find(o=>o.name==="time");return D("section",{class:"cv-plots","aria-label":"Plots",children:s?D(Dt,{children:[D("div",{class:"cv-plots-head",children:[D(Yt,{quiet:!0,label:"Output",value:i,options:t.map(o=>({value:o.name,label:o.name.replaceAll("_"," ")})),onChange:o=>n.update({plotted:[o]})}),D(oC,{core:n,column:s,time:r})]}),D(aC,{core:n,column:s,time:r})]}):D("div",{class:"cv-muted",children:"This run has no outputs over the positions."})})}function av(n,e){let t=n.positions?.list[n.state.position];if(!t||!e)return n.state.position;let i=0;return e.values.forEach((s,r)=>{Math.abs((s??1/0)-t.time)<Math.abs((e.values[i]??1/0)-t.time)&&(i=r)}),i}function oC({core:n,column:e,time:t}){let i=e.values[av(n,t)]??NaN,s=xn(e.unit,bp(e));return D("output",{class:"cv-muted",children:Number.isFinite(i)?`${Nt(i*s.factor,5)} ${s.symbol}`:"no value"})}function aC({core:n,column:e,time:t}){let i=Ai(null),s=Ai(null),r=av(n,t),{theme:o}=n.theme;return Ti(()=>{let a=i.current,l=getComputedStyle(n.element),c=g=>l.getPropertyValue(g).trim(),u=xn(e.unit,bp(e)),d=xn("s",t?bp(t):0),h=t?t.values.map(g=>(g??NaN)*d.factor):e.values.map((g,x)=>x),f=e.values.map(g=>g===null||!Number.isFinite(g)?null:g*u.factor),p=g=>({label:g,labelSize:18,size:44,font:"11px system-ui, sans-serif",labelFont:"11px system-ui, sans-serif",stroke:c("--cv-muted"),grid:{stroke:c("--cv-line"),width:1},ticks:{stroke:c("--cv-line"),width:1,size:4}}),_=new zn({width:a.clientWidth,height:a.clientHeight,scales:{x:{time:!1}},legend:{show:!1},cursor:{y:!1,points:{size:7},drag:{x:!1,y:!1}},series:[{},{stroke:c("--cv-accent"),width:1.75,points:{show:h.length<60}}],axes:[{...p(t?`time in ${d.symbol}`:"position"),size:30},{...p(u.symbol),size:56}],hooks:{drawAxes:[g=>lC(g,c("--cv-mark"))]}},[h,f],a);s.current=_,_.over.addEventListener("click",()=>{let g=_.cursor.idx,x=n.positions?.list??[];if(g==null||x.length===0)return;let M=t?t.values[g]??0:g,y=0;x.forEach((C,A)=>{let v=w=>Math.abs((t?x[w].time:w)-M);v(A)<v(y)&&(y=A)}),n.animation.stop(),n.goTo(y)});let m=new ResizeObserver(()=>_.setSize({width:a.clientWidth,height:a.clientHeight}));return m.observe(a),()=>{m.disconnect(),_.destroy(),s.current=null}},[n,e,t,o]),Ti(()=>{lv.set(s.current,r),s.current?.redraw(!1)},[r,e,t,o]),D("div",{class:"cv-plot",ref:i,role:"img","aria-label":`${e.name.replaceAll("_"," ")} over ${t?"time":"positions"}`})}var lv=new WeakMap;function lC(n,e){let t=lv.get(n),i=t===void 0?void 0:n.data[0][t];if(i===void 0)return;let s=Math.round(n.valToPos(i,"x",!0))+.5,{ctx:r,bbox:o}=n;r.save(),r.strokeStyle=e,r.lineWidth=1.5*(window.devicePixelRatio||1),r.beginPath(),r.moveTo(s,o.top),r.lineTo(s,o.top+o.height),r.stroke(),r.restore()}var Sp=[{value:"all",label:"All cells"},{value:"flanks",label:"Flanks only"},{value:"edges",label:"Edges only"}];function cv({core:n}){return D("aside",{class:"cv-panel cv-settings","aria-label":"Settings",children:D("div",{class:"cv-scroll",children:[n.state.colours.field!=="plain"?D(cC,{core:n}):null,n.hasMeshes?D(uC,{core:n}):null,D(fC,{core:n}),D(dC,{core:n}),D(Lo,{title:"Display",children:[D(os,{label:"Mesh edges",value:n.state.mesh_edges,onChange:e=>n.update({mesh_edges:e})}),D(Yt,{label:"Theme",value:n.state.theme,options:[{value:"system",label:"As the system"},{value:"light",label:"Light"},{value:"dark",label:"Dark"}],onChange:e=>n.update({theme:e})})]})]})})}function cC({core:n}){let{colours:e}=n.state,t=za(n),[i,s]=n.display?.limits??[0,1],r=1e-9*Math.max(Math.abs(i),Math.abs(s)),o=[Math.abs(i)<r?0:i,Math.abs(s)<r?0:s],a=(l,c)=>n.update({colours:{limits:"fixed",min:l,max:c}});return D(Lo,{title:"Colours",children:[D(Yt,{label:"Limits",value:e.limits,options:[{value:"position",label:"This position"},{value:"all",label:"All positions"},{value:"fixed",label:"Fixed"}],onChange:l=>l==="fixed"?a(o[0],o[1]):n.update({colours:{limits:l}})}),D(Ga,{label:"Maximum",unit:t.symbol,value:o[1]*t.factor,onChange:l=>a(o[0],l/t.factor)}),D(Ga,{label:"Minimum",unit:t.symbol,value:o[0]*t.factor,onChange:l=>a(l/t.factor,o[1])}),D(Yt,{label:"Scale",value:e.scale,options:Qg.map(({name:l,label:c})=>({value:l,label:c})),onChange:l=>n.update({colours:{scale:l}})}),D(Yt,{label:"Bands",value:String(e.bands),options:["0","6","8","10","12","16","24"].map(l=>({value:l,label:l==="0"?"Continuous":l})),onChange:l=>n.update({colours:{bands:Number(l)}})}),Un(e.field)?null:D(Yt,{label:"Contact cells",value:e.cells,options:Sp,onChange:l=>n.update({colours:{cells:l}})}),So[e.field]?D("p",{class:"cv-note",children:So[e.field]}):null,D(os,{label:"Mark the extreme values",value:n.state.extremes,onChange:l=>n.update({extremes:l})}),Un(e.field)?null:D(os,{label:"Show contacts behind surfaces",value:n.state.hidden_contacts,onChange:l=>n.update({hidden_contacts:l})})]})}function uC({core:n}){let{mode:e}=n.state.deformation,t=({index:o})=>(n.display.meshes[o]?.length??0)>0,i=n.parts?.parts??[],[s,r]=[i.filter(t),i.filter(o=>!t(o))];return D(Lo,{title:"Deformation",children:[D(os,{label:"Automatic factor",value:e==="automatic",onChange:o=>n.update({deformation:{mode:o?"automatic":"factor",factor:n.display.factor}})}),D(Ga,{label:"Factor",unit:"×",value:n.display.factor,onChange:o=>n.update({deformation:{mode:"factor",factor:o}})}),e==="automatic"&&!Un(n.state.colours.field)?D("p",{class:"cv-note",children:ou}):null,r.length>0&&n.display.factor>0?D("p",{class:"cv-note",title:r.map(({name:o})=>o).join(", "),children:["Parts with meshes move: ",hC(s),". The other parts stay in place."]}):null]})}var Mp=5;function hC(n){let e=n.slice(0,Mp).map(({name:t})=>t).join(", ");return n.length>Mp?`${e} and ${n.length-Mp} more`:e}function fC({core:n}){let{cut:e}=n.state,t=n.display.cut,i=()=>{let o=n.scene.camera.direction;return[o.x,o.y,o.z]},s=xn("m",1),r=typeof e.normal=="string"?e.normal:"view";return D(Lo,{title:"Cutting plane",children:[D(os,{label:"Cut",value:e.on,onChange:o=>Co(n,{on:o})}),e.on?D(Dt,{children:[D(Yt,{label:"Normal",value:r,options:[{value:"x",label:"x"},{value:"y",label:"y"},{value:"z",label:"z"},{value:"view",label:"View direction"}],onChange:o=>Co(n,{normal:o==="view"?i():o})}),D(Gd,{label:"Location",min:t.range[0],max:t.range[1],value:t.offset,text:`${Nt(t.offset*s.factor,4)} ${s.symbol}`,onInput:o=>{n.display.setDragging(!0,n.state),n.update({cut:{offset:o}})},onEnd:()=>n.display.setDragging(!1,n.state)}),D(Ga,{label:"Coordinate",unit:s.symbol,value:t.offset*s.factor,onChange:o=>n.update({cut:{offset:o/s.factor}})}),D(os,{label:"Flip",value:e.flipped,onChange:o=>n.update({cut:{flipped:o}})})]}):null]})}function dC({core:n}){let{forces:e}=n.state,t=e.bearings||e.meshes;return D(Lo,{title:"Forces",children:[D(os,{label:"At bearings",value:e.bearings,onChange:i=>n.update({forces:{bearings:i}})}),D(os,{label:"At meshes",value:e.meshes,onChange:i=>n.update({forces:{meshes:i}})}),t?D(Dt,{children:[D(os,{label:"Labels",value:e.labels,onChange:i=>n.update({forces:{labels:i}})}),D(Gd,{label:"Length",min:.2,max:4,value:e.scale,onInput:i=>n.update({forces:{scale:i}})})]}):null]})}var pC="Positions count from 0, like the column step of steps.csv",mC=[1,2,5,10,20,30,60];function uv({core:n}){let e=n.positions?.list??[],{state:t,animation:i}=n;if(e.length===0)return D("div",{class:"cv-timeline cv-muted",children:"No positions yet"});let s=e[Math.min(t.position,e.length-1)],r=e[e.length-1],o=xn("s",Math.max(Math.abs(r.time),Math.abs(e[0].time))),a=`${Nt(s.time*o.factor)} ${o.symbol}`,l=e.length>1;return D("div",{class:"cv-timeline",role:"group","aria-label":"Animation",children:[D(yn,{icon:"previous",label:"Previous position",shortcut:",",disabled:!l,onClick:()=>i.step(-1)}),D(yn,{icon:i.playing?"pause":"play",label:i.playing?"Pause":"Play",shortcut:"K",disabled:!l,onClick:()=>i.toggle()}),D(yn,{icon:"next",label:"Next position",shortcut:".",disabled:!l,onClick:()=>i.step(1)}),D("input",{class:"cv-time",type:"range",min:0,max:e.length-1,step:1,value:t.position,disabled:!l,"aria-label":"Position","aria-valuetext":`position ${s.position}, ${a}`,onInput:c=>{i.stop(),n.goTo(Number(c.currentTarget.value))}}),D("output",{class:"cv-clock",children:[D("span",{title:pC,children:[n.narrow?"":"Position ",s.position,l?D("span",{class:"cv-muted",children:[" (",e[0].position," to ",r.position,")"]}):null]}),D("span",{class:"cv-clock-time",children:a})]}),n.narrow?null:D(wp,{core:n})]})}function wp({core:n}){let{state:e}=n;return D(Dt,{children:[D(Yt,{quiet:!0,label:"Speed, positions per second",value:String(e.animation.speed),options:[...new Set([...mC,e.animation.speed])].sort((t,i)=>t-i).map(t=>({value:String(t),label:`${t} / s`})),onChange:t=>n.update({animation:{speed:Number(t)}})}),D(yn,{icon:"loop",label:"Loop",pressed:e.animation.loop,onClick:()=>n.update({animation:{loop:!e.animation.loop}})})]})}var gC=[{value:"",label:"View"},{value:"isometric",label:"Isometric"},{value:"front",label:"Front"},{value:"back",label:"Back"},{value:"left",label:"Left"},{value:"right",label:"Right"},{value:"top",label:"Top"},{value:"bottom",label:"Bottom"}],_C=Object.keys(Vi);function fv({core:n,showTitle:e,showTheme:t}){let{scene:i,status:s,narrow:r}=n,o=s==="ready"&&i!==null;return D("div",{class:"cv-toolbar",role:"toolbar","aria-label":"View",children:[D(yn,{icon:"parts",label:"Parts",shortcut:"B",pressed:n.isOpen("parts"),onClick:()=>n.toggle("parts")}),e&&!r?D("h1",{class:"cv-title",title:n.source?.title,children:n.source?.title??"Calyx"}):null,o&&!r?D(Dt,{children:[D("span",{class:"cv-rule"}),D(pv,{core:n}),D("span",{class:"cv-rule"}),D(hv,{core:n}),D(mv,{core:n}),D("span",{class:"cv-rule"}),D(gv,{core:n})]}):null,o&&r?D("span",{class:"cv-grow",children:D(hv,{core:n})}):D("span",{class:"cv-space"}),D("span",{class:"cv-tool-group",children:[o&&!r?D(_v,{core:n}):null,o?D(yn,{icon:"settings",label:"Settings",shortcut:"S",pressed:n.isOpen("settings"),onClick:()=>n.toggle("settings")}):null,r?D(yn,{icon:"more",label:"More tools",pressed:n.drawer==="tools",onClick:()=>n.setDrawer(n.drawer==="tools"?null:"tools")}):D(xv,{core:n,showTheme:t})]})]})}function dv({core:n,showTheme:e}){let t=n.status==="ready"&&n.scene!==null;return D("div",{class:"cv-tools",role:"group","aria-label":"More tools",children:[t?D(Dt,{children:[D(pv,{core:n}),D(gv,{core:n}),D(mv,{core:n}),D(_v,{core:n}),D(wp,{core:n})]}):null,D(xv,{core:n,showTheme:e})]})}function pv({core:n}){let{camera:e}=n.scene,t=n.state.camera?.projection==="orthographic";return D(Dt,{children:[D(yn,{icon:"fit",label:"Fit",shortcut:"F",onClick:()=>e.fit()}),D(Yt,{quiet:!0,label:"Standard view",value:"",options:gC,onChange:i=>{i&&e.view(i),n.changed(!1)}}),D(yn,{icon:t?"orthographic":"perspective",label:"Orthographic projection",shortcut:"P",pressed:t,onClick:()=>e.setProjection(t?"perspective":"orthographic")})]})}function hv({core:n}){let{colours:e}=n.state;return D(Yt,{quiet:!0,label:"Colours",value:e.field,options:_C.map(t=>({value:t,label:Vi[t].label})),onChange:t=>n.update({colours:{field:t,limits:e.limits==="fixed"?"position":e.limits}})})}function mv({core:n}){let{colours:e}=n.state;return D(Dt,{children:[e.field==="contact_pressure"?D(Yt,{quiet:!0,label:"Contact cells",value:e.cells,options:Sp,onChange:t=>n.update({colours:{cells:t}})}):null,n.hasMeshes?D(xC,{core:n}):null]})}function gv({core:n}){let{state:e}=n,t=e.forces.bearings||e.forces.meshes;return D(Dt,{children:[D(yn,{icon:"mesh",label:"Mesh edges",shortcut:"M",pressed:e.mesh_edges,onClick:()=>n.update({mesh_edges:!e.mesh_edges})}),D(yn,{icon:"force",label:"Force vectors",shortcut:"V",pressed:t,onClick:()=>n.update({forces:{bearings:!t,meshes:!t}})}),D(yn,{icon:"cut",label:"Cutting plane",shortcut:"C",pressed:e.cut.on,onClick:()=>{let i=!e.cut.on;Co(n,{on:i}),i&&!n.drawers&&n.toggle("settings",!0)}})]})}function _v({core:n}){let{panels:e}=n.state;return D(Dt,{children:[D(yn,{icon:"plot",label:"Plots",shortcut:"G",pressed:e.plots,onClick:()=>n.update({panels:{plots:!e.plots}})}),D(yn,{icon:"pattern",label:"Contact pattern",shortcut:"U",pressed:e.pattern,onClick:()=>n.update({panels:{pattern:!e.pattern}})}),D(vC,{core:n})]})}function xv({core:n,showTheme:e}){let t=n.theme.theme==="dark";return D(Dt,{children:[e?D(yn,{icon:t?"sun":"moon",label:t?"Light theme":"Dark theme",onClick:()=>n.update({theme:t?"light":"dark"})}):null,D(yn,{icon:"help",label:"Help",shortcut:"?",pressed:n.help,onClick:()=>{n.help=!n.help,n.changed(!1)}})]})}function xC({core:n}){let{mode:e,factor:t}=n.state.deformation,i=e==="automatic"&&!Un(n.state.colours.field),s=e==="automatic"?"automatic":t===0||t===1?String(t):"other";return D(Dt,{children:[D(Yt,{quiet:!0,label:"Deformation",title:i?ou:void 0,value:s,options:[{value:"automatic",label:i?"No deformation here":"Deformation: automatic"},{value:"0",label:"Undeformed"},{value:"1",label:"True deformation"},{value:"other",label:"Other factor …"}],onChange:r=>{r==="automatic"?n.update({deformation:{mode:"automatic"}}):r==="other"?(n.update({deformation:{mode:"factor",factor:n.display.factor||10}}),n.toggle("settings",!0)):n.update({deformation:{mode:"factor",factor:Number(r)}})}}),i?null:D("output",{class:"cv-factor","aria-label":"Factor of the deformation",title:"Factor of the displayed deformation",children:["× ",Nt(n.display.factor,3)]})]})}function vC({core:n}){let[e,t]=rs("");return D("span",{class:"cv-export",children:D(Yt,{quiet:!0,label:e?`Export. ${e}`:"Export the picture",value:"",options:[{value:"",label:"Export"},{value:"png",label:"PNG"},{value:"svg",label:"SVG"},{value:"pdf",label:"PDF"}],onChange:i=>{i&&u_(n,i).catch(s=>t(String(s))),n.changed(!1)}})})}function vv({core:n}){let{probe:e,scene:t}=n;if(!e||!t)return null;let i=za(n),s=xn("m",1),{x:r,y:o,z:a}=e.point,l=e.value!==null&&Number.isFinite(e.value);return D("div",{class:"cv-tooltip",role:"status","aria-label":"Value at the pointer","data-value":e.value===null?"":String(e.value),style:Ku(e.x,e.y,t.width,t.height),children:[e.value!==null?D("div",{class:"cv-tooltip-value",children:[D("span",{class:"cv-muted",children:Vi[n.state.colours.field].label}),D("strong",{children:l?`${Nt(e.value*i.factor,6)} ${i.symbol}`:"no value"})]}):null,D("div",{children:[e.part,e.tooth!==null?`, tooth ${e.tooth}`:"",e.node!==null?`, node ${e.node}`:""]}),D("div",{class:"cv-muted",children:[[r,o,a].map(c=>Nt(Math.round(c*s.factor*1e3)/1e3,6)).join("  ")," ",s.symbol]})]})}var yv=[{name:"x",azimuth:0,elevation:0,v:[1,0,0]},{name:"y",azimuth:90,elevation:0,v:[0,1,0]},{name:"z",azimuth:-90,elevation:90,v:[0,0,1]}];function bv({core:n}){let e=Ai(null);return Ti(()=>yC(n,e.current)),D("svg",{class:"cv-triad",viewBox:"-34 -34 68 68",ref:e,"aria-hidden":"true",children:yv.map(({name:t})=>D("g",{class:`cv-axis-${t}`,children:[D("line",{}),D("text",{"text-anchor":"middle","dominant-baseline":"central",children:t})]},t))})}function yC(n,e){let t=n.state.camera??n.scene?.camera.state;if(!t)return;let i=t.azimuth*Math.PI/180,s=t.elevation*Math.PI/180,r=[-Math.sin(i),Math.cos(i),0],o=[-Math.sin(s)*Math.cos(i),-Math.sin(s)*Math.sin(i),Math.cos(s)];yv.forEach(({v:a},l)=>{let c=a[0]*r[0]+a[1]*r[1]+a[2]*r[2],u=-(a[0]*o[0]+a[1]*o[1]+a[2]*o[2]),d=e.children[l],[h,f]=[d.children[0],d.children[1]];h.setAttribute("x2",String(20*c)),h.setAttribute("y2",String(20*u)),f.setAttribute("x",String(28*c)),f.setAttribute("y",String(28*u)),d.setAttribute("opacity",Math.hypot(c,u)<.12?"0.15":"1")})}function Mv({core:n,stage:e,showTitle:t,showTheme:i}){E_(n);let{status:s,state:r}=n,o=s==="ready";return D(Dt,{children:[D(fv,{core:n,showTitle:t,showTheme:i}),D("div",{class:"cv-body",children:[o&&n.isOpen("parts")?D(P_,{core:n}):null,D("div",{class:"cv-centre",children:[D("div",{class:"cv-view",children:[D(bC,{stage:e}),o?D(bv,{core:n}):null,o?D(C_,{core:n}):null,o?D(vv,{core:n}):null,n.notice?D("div",{class:"cv-notice",role:"alert",children:n.notice}):null,s==="loading"?D("div",{class:"cv-message",role:"status",children:"Reading the shapes …"}):null,o&&n.parts?.parts.length===0?D("div",{class:"cv-message",children:"This run has no parts to display."}):null,s==="failed"?D("div",{class:"cv-message",role:"alert",children:[D("strong",{children:"The view cannot be displayed."}),D("span",{children:n.failure})]}):null]}),o&&r.panels.pattern?D(D_,{core:n}):null,o&&r.panels.plots?D(ov,{core:n}):null,o?D(uv,{core:n}):null]}),o&&n.isOpen("settings")?D(cv,{core:n}):null,n.narrow&&n.drawer==="tools"?D(dv,{core:n,showTheme:i}):null]}),n.help?D(T_,{core:n}):null]})}function bC({stage:n}){let e=Ai(null);return Ti(()=>{e.current.append(n)},[n]),D("div",{class:"cv-holder",ref:e})}var Ka=class{onChange=null;#e;#t;#n=new AbortController;#i=new Set;constructor(e,t={}){let i=document.createElement("div");i.className="calyx-viewer";let s=document.createElement("div");s.className="cv-stage",e.append(i),this.#t=i;let r=new zu(i,s,t.state??{});if(this.#e=r,r.onChange=a=>this.onChange?.(a),Ph(D(Mv,{core:r,stage:s,showTitle:t.showTitle??!0,showTheme:t.showTheme??!0}),i),r.scene){let{canvas:a,camera:l}=r.scene;a.tabIndex=0,a.setAttribute("role","img"),a.setAttribute("aria-label","Three-dimensional view. Arrow keys orbit, plus and minus zoom, question mark shows all shortcuts."),K0(r,a);let c=l.onChange;l.onChange=u=>{if(c?.(u),u)for(let d of this.#i)d.#e.scene?.camera.set(l.state)}}let o=a=>{e_(r,a)&&a.preventDefault()};i.addEventListener("keydown",o),t.pageKeys&&document.addEventListener("keydown",a=>a.target===document.body&&o(a),{signal:this.#n.signal})}fail(e){this.#e.fail(new Error(e))}show(e){return this.#e.show(e)}reload(){return this.#e.reload()}updatePositions(){return this.#e.updatePositions()}get state(){return structuredClone(this.#e.state)}restore(e){this.#e.update(e)}linkCamera(e){this.#i.add(e),e.#i.add(this);let{camera:t}=this.#e.state;return t&&e.#e.scene?.camera.set(t),()=>{this.#i.delete(e),e.#i.delete(this)}}image(e){return Dd(this.#e,e)}patternImage(e){return Ud(this.#e,e)}get frames(){return this.#e.scene?.frames??0}get triangles(){return this.#e.display?.triangles??0}draw(){this.#e.scene?.draw()}project(e,t){return this.#e.project(e,t)}nodalValue(e,t){return this.#e.nodalValue(e,t)}contactLoads(){let e=this.#e.display?.position?.contacts,t=this.#e.parts?.parts.map(({name:i})=>i)??[];return e?[...Jg(e)].map(([i,s])=>{let[r,o]=i.split(" ").map(Number);return{parts:[t[r]??"",t[o]??""],load:s}}):[]}dispose(){for(let e of this.#i)e.#i.delete(this);this.#i.clear(),this.#n.abort(),Ph(null,this.#t),this.#e.dispose(),this.#t.remove()}};function Sv(){let n=document.getElementById("calyx-viewer")??document.body,e=new Ka(n,{pageKeys:!0});window.calyxViewer=e;let t=document.getElementById("calyx-view"),i;try{i=JSON.parse(t?.textContent??"")}catch{e.fail("The data embedded in this page are missing or damaged.");return}i.title&&(document.title=i.title),e.show(Ed(i))}document.readyState==="loading"?document.addEventListener("DOMContentLoaded",Sv):Sv();})();
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
