;;; calyx-mode.el --- Editing Calyx gear models  -*- lexical-binding: t; -*-

;; Version: 0.1.0
;; Package-Requires: ((emacs "27.1"))
;; Keywords: languages, tools
;; SPDX-License-Identifier: MIT OR Apache-2.0

;;; Commentary:

;; Font lock, indentation and comments for Calyx models (`.cx'), and the language
;; server `calyx lsp' through Eglot, which Emacs has since version 29 and GNU ELPA
;; before:
;;
;;   (require 'calyx-mode)
;;   (add-hook 'calyx-mode-hook #'eglot-ensure)
;;
;; `calyx-run' saves the model and runs it, `calyx-plan' shows the plan of the
;; analysis, `calyx-cancel' stops a run, `calyx-format' formats the text.

;;; Code:

(require 'subr-x)
(require 'url-util)

(declare-function eglot-current-server "ext:eglot")
(declare-function eglot-format-buffer "ext:eglot")
(declare-function jsonrpc-async-request "jsonrpc")
(defvar eglot-server-programs)

(defgroup calyx nil
  "Editing Calyx gear models."
  :group 'languages
  :prefix "calyx-")

(defcustom calyx-program "calyx"
  "The `calyx' program, whose subcommand `lsp' is the language server."
  :type 'string)

(defcustom calyx-server-arguments nil
  "Further arguments after `calyx lsp'."
  :type '(repeat string))

(defcustom calyx-indent-offset 4
  "How many columns a step of indentation is.
The formatter's is 4."
  :type 'integer
  :safe #'integerp)

;;; Words

(defconst calyx--keywords
  '("var" "if" "else" "for" "while" "do" "switch" "case" "default" "break"
    "continue" "return" "goto" "throw" "try" "catch" "function" "in" "out" "inout")
  "Words that are never names.")

(defconst calyx--booleans '("TRUE" "FALSE")
  "The truth values.")

(defconst calyx--contextual
  '("import" "units" "param" "output" "extern" "at" "private" "test" "host"
    "const" "record" "component" "enum" "dimension" "unit" "is")
  "Words of the language only where another name follows.")

(defconst calyx--constants '("Time" "e1" "e2" "e3" "pi" "inf" "nan")
  "Names with a fixed meaning.")

(defconst calyx--builtins
  '("sin" "cos" "tan" "asin" "acos" "atan" "atan2" "exp" "log" "abs" "floor" "ceil"
    "round" "dot" "cross" "norm" "Translate" "Rotate" "inverse" "origin" "direction"
    "velocity" "acceleration" "angular_velocity" "angular_acceleration" "min" "max"
    "sqrt" "derivative" "gradient" "print" "assert" "len" "push"
    "sum" "sort" "solve" "minimize" "spline")
  "Functions of the language.")

(defconst calyx--types
  '("Number" "Length" "Mass" "Time" "Angle" "Temperature" "Area" "Volume"
    "SecondMomentOfArea" "Curvature" "Velocity" "Acceleration" "AngularVelocity"
    "AngularAcceleration" "Frequency" "Force" "Moment" "Pressure" "Stiffness"
    "RotationalStiffness" "Compliance" "Density" "MomentOfInertia" "Damping"
    "RotationalDamping" "Viscosity" "KinematicViscosity" "Momentum" "Power" "Torque"
    "Energy" "Stress" "LineLoad" "Duration"
    "Bool" "String" "Vector" "Transform" "Array" "Symbolic" "Observable")
  "Names of dimensions and types.")

(defconst calyx--units
  '("m" "meter" "meters" "metre" "metres" "cm" "mm" "um" "µm" "μm" "micron" "microns"
    "km" "inch" "inches" "ft" "foot" "feet" "mil" "mils" "microinch" "uinch"
    "microinches" "kg" "g" "gram" "grams" "tonne" "tonnes" "lbm" "slug" "slugs" "s"
    "sec" "second" "seconds" "ms" "us" "µs" "μs" "min" "minute" "minutes" "hour"
    "hours" "rad" "radian" "radians" "mrad" "urad" "µrad" "μrad" "deg" "degree"
    "degrees" "arcmin" "arcsec" "rev" "turn" "turns" "rpm" "Hz" "kHz" "N" "newton"
    "newtons" "kN" "MN" "lbf" "kgf" "Pa" "kPa" "MPa" "GPa" "bar" "psi" "ksi" "Msi" "J"
    "joule" "joules" "W" "watt" "watts" "kW" "hp" "K" "kelvin" "percent")
  "Units that a quantity may be multiplied with or divided by.")

;;; Syntax

(defvar calyx-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?_ "_" table)
    (modify-syntax-entry ?/ ". 124b" table)
    (modify-syntax-entry ?* ". 23" table)
    (modify-syntax-entry ?\n "> b" table)
    (modify-syntax-entry ?\" "\"" table)
    (modify-syntax-entry ?\\ "\\" table)
    (dolist (operator '(?+ ?- ?^ ?< ?> ?= ?! ?& ?| ?% ?:))
      (modify-syntax-entry operator "." table))
    table)
  "Syntax of Calyx: two kinds of comments, texts in double quotes.")

(defconst calyx--name "[[:alpha:]_][[:alnum:]_]*")

(defconst calyx--number
  "\\_<[0-9]+\\(?:\\.[0-9]*\\)?\\(?:[eE][+-]?[0-9]+\\)?")

(defconst calyx--doc-comment "///\\(?:[^/\n]\\|$\\)"
  "How a comment begins that documents what follows.")

(defun calyx--match-unit (limit)
  "Find the next unit of a number up to LIMIT.
Its first group is the unit with its exponent, its second what that unit is
multiplied with or divided by."
  (let ((unit (concat calyx--number "[ \t]*\\(\\(?:%\\|" calyx--name "\\)\\(?:\\^-?[0-9]+\\)?\\)"
                      "\\(\\(?:[ \t]*[*/][ \t]*" (regexp-opt calyx--units 'symbols)
                      "\\(?:\\^-?[0-9]+\\)?\\)*\\)"))
        found)
    (while (and (not found) (re-search-forward unit limit t))
      ;; `2 in`, `1 else` and `3 at Time` continue with a keyword.
      (setq found (not (member (match-string 1) '("in" "else" "at")))))
    found))

(defconst calyx--font-lock-keywords
  `((,(regexp-opt calyx--keywords 'symbols) . font-lock-keyword-face)
    ;; Contextual keywords, which require a name after them.
    (,(concat "\\_<\\(param\\|output\\|const\\|unit\\)\\_>[ \t]+\\(" calyx--name "\\)")
     (1 font-lock-keyword-face) (2 font-lock-variable-name-face))
    (,(concat "\\_<\\(record\\|component\\|enum\\|dimension\\)\\_>[ \t]+\\(" calyx--name "\\)")
     (1 font-lock-keyword-face) (2 font-lock-type-face))
    (,(concat "\\_<\\(import\\|units\\)\\_>[ \t]+\\([[:alpha:]_][[:alnum:]_.]*\\)")
     (1 font-lock-keyword-face) (2 font-lock-constant-face))
    ("\\_<\\(extern\\)\\_>[ \t]+\\(?:\\(pure\\|scene\\|effect\\)\\_>\\)?"
     (1 font-lock-keyword-face) (2 font-lock-keyword-face nil t))
    ("\\_<\\(private\\)\\_>[ \t]+[[:alpha:]_]" 1 font-lock-keyword-face)
    ("\\_<\\(host\\|test\\)\\_>[ \t]+function\\_>" 1 font-lock-keyword-face)
    (,(concat calyx--name "[ \t]+\\(was\\)[ \t]+[[:alpha:]_]") 1 font-lock-keyword-face)
    (,(concat "[])[:alnum:]_\"%.][ \t]+\\(at\\)[ \t]+" calyx--name "[ \t]*=[^=]")
     1 font-lock-keyword-face)
    ;; Declared names.
    (,(concat "\\_<function\\_>[ \t]+\\(" calyx--name "\\)") 1 font-lock-function-name-face)
    (,(concat "\\_<\\(?:in\\|out\\|inout\\)\\_>[ \t]+\\(" calyx--name "\\)")
     1 font-lock-variable-name-face)
    (,(concat "\\_<var\\_>[ \t]+\\(" calyx--name "\\)") 1 font-lock-variable-name-face)
    (,(concat "\\_<goto\\_>[ \t]+\\(" calyx--name "\\)") 1 font-lock-constant-face)
    (,(concat "^[ \t]*\\(" calyx--name "\\):[ \t]+" calyx--name "[ \t]*(")
     1 font-lock-constant-face)
    ;; Builtin names.
    (,(concat (regexp-opt calyx--builtins 'symbols) "[ \t]*(") 1 font-lock-builtin-face)
    (,(regexp-opt (append calyx--constants calyx--booleans) 'symbols) . font-lock-constant-face)
    (,(concat "[:>(,/*][ \t]*" (regexp-opt calyx--types 'symbols)) 1 font-lock-type-face)
    (":=" . font-lock-keyword-face)
    (calyx--match-unit (1 font-lock-type-face) (2 font-lock-type-face nil t)))
  "What font lock shows; Eglot's semantic tokens are not needed for it.")

(defun calyx--syntactic-face (state)
  "The face of a comment or text whose parse STATE is given."
  (cond ((nth 3 state) font-lock-string-face)
        ((save-excursion (goto-char (nth 8 state)) (looking-at-p calyx--doc-comment))
         font-lock-doc-face)
        (t font-lock-comment-face)))

;; A string ends on its line, and may contain interpolations with strings: only the
;; outermost quotes are string delimiters for Emacs.

(defun calyx--text-end ()
  "Move from behind the opening quote of a text to its closing one.
Stops at the end of the line if there is none.  Quotes between are no quotes."
  (let ((inside '(text)) (end (line-end-position)))
    (while (and inside (< (point) end))
      (let ((next (char-after)) (in-text (eq (car inside) 'text)))
        (cond
         ((and in-text (looking-at-p "\\\\.\\|{{\\|}}")) (forward-char))
         ((and in-text (eq next ?{)) (push 'expression inside))
         ((and (not in-text) (eq next ?})) (pop inside))
         ((not (eq next ?\")))
         (in-text (pop inside))
         (t (push 'text inside)))
        (when inside
          (when (eq next ?\")
            (put-text-property (point) (1+ (point)) 'syntax-table (string-to-syntax ".")))
          (forward-char))))
    (when (> (point) end) (goto-char end))))

(defun calyx--propertize (begin end)
  "Mark where texts begin and end between BEGIN and END, which are ends of lines."
  (goto-char begin)
  (while (search-forward "\"" end t)
    (let ((open (1- (point))))
      (unless (nth 4 (save-excursion (syntax-ppss open)))
        (put-text-property open (point) 'syntax-table (string-to-syntax "|"))
        (calyx--text-end)
        (unless (eobp)
          (put-text-property (point) (1+ (point)) 'syntax-table (string-to-syntax "|"))
          (forward-char))))))

;;; Indentation

(defun calyx--code-before (limit)
  "The last line of code above this one and below LIMIT, or nil."
  (save-excursion
    (let (found)
      (while (and (not found) (> (line-beginning-position) limit) (zerop (forward-line -1)))
        (unless (<= (line-end-position) limit)
          (let ((text (calyx--code-here limit)))
            (unless (string-empty-p text) (setq found text)))))
      found)))

(defun calyx--code-here (limit)
  "The line without comments and blanks around it, from LIMIT on."
  (save-excursion
    (let* ((begin (max limit (line-beginning-position)))
           (end (line-end-position))
           (state (syntax-ppss end))
           (comment (and (nth 4 state) (nth 8 state))))
      (string-trim (buffer-substring-no-properties begin (max begin (min end (or comment end))))))))

(defun calyx--indentation ()
  "How many columns the line is to be indented."
  (save-excursion
    (back-to-indentation)
    ;; `syntax-ppss' may move point to its argument.
    (let* ((here (buffer-substring-no-properties (point) (line-end-position)))
           (open (nth 1 (syntax-ppss (line-beginning-position))))
           (opening (and open (save-excursion (goto-char open) (current-indentation))))
           (base (if open (+ opening calyx-indent-offset) 0))
           (limit (if open (save-excursion (goto-char open) (line-end-position)) (point-min)))
           (in-switch (and open
                           (save-excursion
                             (goto-char open)
                             (and (eq (char-after) ?\{)
                                  (progn (back-to-indentation) (looking-at-p "switch\\_>")))))))
      (cond
       ((string-match-p "\\`[])}]" here) (or opening 0))
       ((and in-switch (string-match-p "\\`\\(?:case\\|default\\)\\_>" here)) base)
       (t
        (let ((before (calyx--code-before limit))
              (base (if in-switch (+ base calyx-indent-offset) base)))
          ;; A continuation line is indented one step further.
          (if (and before
                   (not (string-match-p "[;{},:]\\'" before))
                   (not (string-prefix-p "{" here)))
              (+ base calyx-indent-offset)
            base)))))))

(defun calyx-indent-line ()
  "Indent the line as the formatter would."
  (interactive)
  (let ((column (if (nth 3 (syntax-ppss (line-beginning-position)))
                    (current-indentation)
                  (calyx--indentation))))
    (if (<= (current-column) (current-indentation))
        (indent-line-to column)
      (save-excursion (indent-line-to column)))))

;;; Commands

(defun calyx--execute (command &optional answer)
  "Ask the server to carry out COMMAND on this model; ANSWER takes the result."
  (require 'eglot)
  (let ((server (eglot-current-server)))
    (unless server
      (user-error "The server does not run here; start it with M-x eglot"))
    (jsonrpc-async-request
     server :workspace/executeCommand
     (list :command command
           :arguments (vector (concat "file://" (url-hexify-string buffer-file-name
                                                                  url-path-allowed-chars))))
     :success-fn (or answer #'ignore)
     :error-fn (lambda (problem) (message "Calyx: %s" (plist-get problem :message)))
     :timeout 3600)))

;;;###autoload
(defun calyx-run ()
  "Save the model and run it; its results appear next to the outputs."
  (interactive)
  (when (buffer-modified-p) (save-buffer))
  (calyx--execute "calyx.run"))

;;;###autoload
(defun calyx-plan ()
  "Show what the engine would model, and why."
  (interactive)
  (let ((name (format "*Calyx plan: %s*" (buffer-name))))
    (calyx--execute
     "calyx.plan"
     (lambda (text)
       (when (stringp text)
         (with-current-buffer (get-buffer-create name)
           (let ((inhibit-read-only t))
             (erase-buffer)
             (insert text)
             (goto-char (point-min)))
           (special-mode)
           (display-buffer (current-buffer))))))))

;;;###autoload
(defun calyx-cancel ()
  "Stop the run of the model."
  (interactive)
  (calyx--execute "calyx.cancel"))

(defun calyx-format ()
  "Lay the model out: by the server if it runs, else by `calyx fmt --stdin'."
  (interactive)
  (if (and (fboundp 'eglot-current-server) (eglot-current-server))
      (eglot-format-buffer)
    (calyx--format-by-program)))

(defun calyx--format-by-program ()
  "Replace the text by what `calyx fmt --stdin' makes of it."
  (let ((output (generate-new-buffer " *calyx fmt*" t)))
    (unwind-protect
        (if (zerop (call-process-region nil nil calyx-program nil (list output nil) nil "fmt" "--stdin"))
            (replace-buffer-contents output)
          (user-error "The model has errors of syntax and is left as it is"))
      (kill-buffer output))))

;;; The mode

(defvar calyx-mode-map
  (let ((map (make-sparse-keymap)))
    (define-key map (kbd "C-c C-c") #'calyx-run)
    (define-key map (kbd "C-c C-p") #'calyx-plan)
    (define-key map (kbd "C-c C-k") #'calyx-cancel)
    (define-key map (kbd "C-c C-f") #'calyx-format)
    map)
  "Keys of `calyx-mode'.")

(defconst calyx--outline
  `(("Param" ,(concat "^param[ \t]+\\(" calyx--name "\\)") 1)
    ("Output" ,(concat "^output[ \t]+\\(" calyx--name "\\)") 1)
    ("Function" ,(concat "^[a-z \t]*\\_<function[ \t]+\\(" calyx--name "\\)") 1)
    ("Record" ,(concat "^\\(?:private[ \t]+\\)?record[ \t]+\\(" calyx--name "\\)") 1))
  "What `imenu' lists where no server does.")

;;;###autoload
(define-derived-mode calyx-mode prog-mode "Calyx"
  "Mode for gear models in Calyx."
  (setq-local comment-start "// ")
  (setq-local comment-end "")
  (setq-local comment-start-skip "\\(?://+\\|/\\*+\\)[ \t]*")
  (setq-local font-lock-defaults
              '(calyx--font-lock-keywords
                nil nil nil nil
                (font-lock-syntactic-face-function . calyx--syntactic-face)))
  (setq-local syntax-propertize-function #'calyx--propertize)
  (setq-local indent-line-function #'calyx-indent-line)
  (setq-local indent-tabs-mode nil)
  (setq-local tab-width 4)
  (setq-local fill-column 100)
  (setq-local electric-indent-chars (append '(?\} ?\) ?\]) electric-indent-chars))
  (setq-local imenu-generic-expression calyx--outline))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.cx\\'" . calyx-mode))

(defun calyx--contact (&optional _interactive)
  "How Eglot starts the server."
  (append (list calyx-program "lsp") calyx-server-arguments))

(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs '(calyx-mode . calyx--contact)))

(provide 'calyx-mode)
;;; calyx-mode.el ends here
