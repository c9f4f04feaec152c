" Highlighting of Calyx where there is no server, or until it answers: then its semantic tokens say more.

if exists('b:current_syntax')
  finish
endif

syn case match
syn sync minlines=100
syn iskeyword @,48-57,_,181,192-255

" Words of the language. Those of the second group are words only before another name.
syn keyword calyxConditional if else switch
syn keyword calyxRepeat for while do
syn keyword calyxLabel case default
syn keyword calyxStatement break continue return goto
syn keyword calyxException throw try catch
syn keyword calyxStorage var function
syn keyword calyxMode in out inout
syn keyword calyxBoolean TRUE FALSE
syn match calyxInclude "\<\%(import\|units\)\>\ze\s\+\h"
syn match calyxDeclaration "\<\%(param\|output\|const\|record\|component\|enum\|dimension\|unit\)\>\ze\s\+\K"
syn match calyxModifier "\<\%(extern\|private\)\>\ze\s\+\h"
syn match calyxModifier "\<extern\s\+\%(pure\|scene\|effect\)\>"
syn match calyxModifier "\<\%(host\|test\)\>\ze\s\+function\>"
syn match calyxModifier "\%(\k\s\+\)\@<=was\>\ze\s\+\K"
syn match calyxOperatorWord "\%([[:alnum:]_)\]\"%.]\s\+\)\@<=is\>\ze\s\+none\>"
syn match calyxOperatorWord "\%([[:alnum:]_)\]\"%.]\s\+\)\@<=at\>\ze\s\+\K\k*\s*=[^=]"

" What is named.
syn match calyxFunction "\%(\<function\s\+\)\@<=\K\k*"
syn match calyxName "\%(\<\%(param\|output\|const\|unit\)\s\+\)\@<=\K\k*"
syn match calyxType "\%(\<\%(record\|component\|enum\|dimension\)\s\+\)\@<=\K\k*"
syn match calyxCall "\K\k*\ze\s*(" contains=calyxBuiltin,calyxConditional,calyxRepeat,calyxException,calyxStatement,calyxStorage,calyxMode
syn match calyxNamedArgument "\%([(,]\_s*\)\@<=\K\k*\ze\s*:\?=[^=]"
syn match calyxUserLabel "\%(^\|[;{}]\)\s*\zs\%(default\>\)\@!\K\k*\ze\s*:[^=]"
syn match calyxUserLabel "\%(\<goto\s\+\)\@<=\K\k*"

" Names of the language.
syn keyword calyxBuiltin sin cos tan asin acos atan atan2 exp log abs floor ceil round dot cross norm
syn keyword calyxBuiltin Translate Rotate inverse origin direction velocity acceleration angular_velocity
syn keyword calyxBuiltin angular_acceleration max sqrt derivative gradient print assert len push sum sort solve minimize spline
syn match calyxBuiltin "\<min\>\ze\s*("
syn keyword calyxConstant Time e1 e2 e3 pi inf nan
syn keyword calyxDimension Number Length Mass Angle Temperature Area Volume SecondMomentOfArea Curvature Velocity
syn keyword calyxDimension Acceleration AngularVelocity AngularAcceleration Frequency Force Moment Pressure Stiffness
syn keyword calyxDimension RotationalStiffness Compliance Density MomentOfInertia Damping RotationalDamping Viscosity
syn keyword calyxDimension KinematicViscosity Momentum Power Torque Energy Stress LineLoad Duration
syn keyword calyxDimension Bool String Vector Transform Array Symbolic Observable

" Numbers, and a unit on the same line; `in` and `else` are never units.
syn match calyxNumber "\%(\<\d\+\%(\.\.\@!\d*\)\?\|\.\d\+\)\%([eE][+-]\?\d\+\)\?" nextgroup=calyxUnit skipwhite
syn match calyxUnit "%\|\%(\%(in\|else\)\>\|at\s\+\K\)\@!\K\k*\%(\^-\?\d\+\)\?" contained nextgroup=calyxUnitOperator
syn match calyxUnitOperator "\s*[*/]\s*" contained nextgroup=calyxUnitFactor
syn keyword calyxUnitFactor contained nextgroup=calyxUnitPower,calyxUnitOperator
      \ m meter meters metre metres cm mm um µm μm micron microns km inch inches ft foot feet mil mils microinch uinch
      \ microinches kg g gram grams tonne tonnes lbm slug slugs s sec second seconds ms us µs μs min minute minutes hour
      \ hours rad radian radians mrad urad µrad μrad deg degree degrees arcmin arcsec rev turn turns rpm Hz kHz N newton
      \ newtons kN MN lbf kgf Pa kPa MPa GPa bar psi ksi Msi J joule joules W watt watts kW hp K kelvin percent
syn match calyxUnitPower "\^-\?\d\+" contained nextgroup=calyxUnitOperator

" Operators.
syn match calyxOperator "[-+*/^<>!&|]\|[<>=!]=\|->\|\.\."
syn match calyxBind ":="

" Strings with what is put into them: one line, and strings inside.
syn region calyxString start=+"+ end=+"+ end=+$+ contains=calyxEscape,calyxInterpolation,@Spell
syn match calyxEscape +\\[nt"\\]\|{{\|}}+ contained
syn region calyxInterpolation matchgroup=calyxEscape start="{{\@!" end="}" contained oneline
      \ contains=calyxFormat,calyxString,calyxNumber,calyxCall,calyxConditional,calyxConstant,calyxOperator,calyxBind,calyxBoolean
syn match calyxFormat ":=\@!\s*\d*\%(\.\d*\)\?e\?\>\?" contained nextgroup=calyxUnit skipwhite

" Comments.
syn keyword calyxTodo TODO FIXME NOTE contained
syn region calyxComment start="//" end="$" contains=calyxTodo,@Spell keepend
syn region calyxComment start="/\*" end="\*/" contains=calyxTodo,@Spell
syn region calyxDocComment start="////\@!" end="$" contains=calyxTodo,calyxCode,@Spell keepend
syn match calyxCode "`[^`]*`" contained

hi def link calyxConditional Conditional
hi def link calyxRepeat Repeat
hi def link calyxLabel Label
hi def link calyxStatement Statement
hi def link calyxException Exception
hi def link calyxStorage StorageClass
hi def link calyxMode StorageClass
hi def link calyxBoolean Boolean
hi def link calyxInclude Include
hi def link calyxDeclaration Keyword
hi def link calyxModifier StorageClass
hi def link calyxOperatorWord Operator
hi def link calyxFunction Function
hi def link calyxName Identifier
hi def link calyxType Type
hi def link calyxCall Function
hi def link calyxNamedArgument Identifier
hi def link calyxUserLabel Label
hi def link calyxBuiltin Function
hi def link calyxConstant Constant
hi def link calyxDimension Type
hi def link calyxNumber Number
hi def link calyxUnit Special
hi def link calyxUnitFactor Special
hi def link calyxUnitPower Special
hi def link calyxUnitOperator Operator
hi def link calyxOperator Operator
hi def link calyxBind Operator
hi def link calyxString String
hi def link calyxEscape SpecialChar
hi def link calyxFormat SpecialChar
hi def link calyxTodo Todo
hi def link calyxComment Comment
hi def link calyxDocComment SpecialComment
hi def link calyxCode Special

let b:current_syntax = 'calyx'
