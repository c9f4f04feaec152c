;;; calyx-mode-tests.el --- Tests of calyx-mode  -*- lexical-binding: t; -*-

;;; Commentary:

;; emacs --batch -L .. -l calyx-mode-tests.el --eval "(calyx-tests-run 'mode)"
;;
;; The session with the real server, (calyx-tests-run 'server), requires Eglot, and the
;; path of the `calyx' program in the environment variable CALYX.

;;; Code:

(require 'ert)
(require 'imenu)
(require 'calyx-mode)
(require 'package)

(defun calyx-tests-run (tag)
  "Run the tests with TAG and leave Emacs."
  (ert-run-tests-batch-and-exit `(tag ,tag)))

(defconst calyx-tests--project
  (expand-file-name "../../../../" (file-name-directory (or load-file-name buffer-file-name)))
  "The root of the project.")

(defun calyx-tests--models ()
  "Models in the formatter's layout."
  (append (directory-files (expand-file-name "examples" calyx-tests--project) t "\\.cx\\'")
          (directory-files (expand-file-name "stdlib-gears/calyx" calyx-tests--project) t "\\.cx\\'")))

(defmacro calyx-tests--with (text &rest body)
  "Run BODY in a buffer of the mode that holds TEXT, coloured."
  (declare (indent 1))
  `(with-temp-buffer
     (insert ,text)
     (calyx-mode)
     (font-lock-ensure)
     (goto-char (point-min))
     ,@body))

(defun calyx-tests--faces (text &rest expected)
  "Assert of TEXT that pieces, in order, have faces: EXPECTED is piece, face, and so on."
  (calyx-tests--with text
    (while expected
      (let ((piece (pop expected)) (face (pop expected)))
        (should (search-forward piece nil t))
        (let ((found (get-text-property (match-beginning 0) 'face)))
          (should (equal (list piece found) (list piece face))))))))

(ert-deftest calyx-declarations ()
  :tags '(mode)
  (calyx-tests--faces "param torque = 1000 lbf*inch in 0 N*m .. 5 kN*m;"
                      "param" 'font-lock-keyword-face "torque" 'font-lock-variable-name-face
                      "1000" nil "lbf" 'font-lock-type-face "inch" 'font-lock-type-face
                      "in" 'font-lock-keyword-face "N" 'font-lock-type-face)
  (calyx-tests--faces "private extern pure function area(in d: Length) -> Area;"
                      "private" 'font-lock-keyword-face "extern" 'font-lock-keyword-face
                      "pure" 'font-lock-keyword-face "area" 'font-lock-function-name-face
                      "in" 'font-lock-keyword-face "d" 'font-lock-variable-name-face
                      "Length" 'font-lock-type-face "Area" 'font-lock-type-face)
  (calyx-tests--faces "function area was surface(in d was width: Length) {}"
                      "area" 'font-lock-function-name-face "was" 'font-lock-keyword-face
                      "d" 'font-lock-variable-name-face "was" 'font-lock-keyword-face
                      "Length" 'font-lock-type-face)
  (calyx-tests--faces "var at = test + unit;" "at" 'font-lock-variable-name-face "test" nil "unit" nil))

(ert-deftest calyx-expressions ()
  :tags '(mode)
  (calyx-tests--faces "output e := (x at Time = 3 s) * sin(pi);"
                      ":=" 'font-lock-keyword-face "at" 'font-lock-keyword-face
                      "Time" 'font-lock-constant-face "s" 'font-lock-type-face
                      "sin" 'font-lock-builtin-face "pi" 'font-lock-constant-face)
  (calyx-tests--faces "var x = if (a) 1 else 2;"
                      "if" 'font-lock-keyword-face "1" nil "else" 'font-lock-keyword-face))

(ert-deftest calyx-comments-and-texts ()
  :tags '(mode)
  (calyx-tests--faces "/// Torque.\n// plain\nvar a = 1; /* var\n */"
                      "Torque" 'font-lock-doc-face "plain" 'font-lock-comment-face
                      "var a" 'font-lock-keyword-face "var" 'font-lock-comment-face)
  ;; Strings may contain strings, and end with their line.
  (calyx-tests--faces "print(\"{\"ab\" : 4}|\", x);\nvar open = \"never {\nvar next = 1;"
                      "ab" 'font-lock-string-face "|" 'font-lock-string-face ", x" nil
                      "never" 'font-lock-string-face "var" 'font-lock-keyword-face)
  (calyx-tests--faces "// says \"no\nvar a = 1;" "no" 'font-lock-comment-face
                      "var" 'font-lock-keyword-face))

(ert-deftest calyx-indentation-is-the-formatters ()
  :tags '(mode)
  (dolist (model (calyx-tests--models))
    (with-temp-buffer
      (insert-file-contents model)
      (let ((original (buffer-string)) (inhibit-message t))
        (calyx-mode)
        (goto-char (point-min))
        (while (not (eobp))
          (delete-horizontal-space)
          (forward-line 1))
        (indent-region (point-min) (point-max))
        (delete-trailing-whitespace)
        (should (equal (list model (buffer-string)) (list model original)))))))

(ert-deftest calyx-outline ()
  :tags '(mode)
  (calyx-tests--with "param a = 1;\ntest function b() {}\noutput c := a;\nrecord D { e = 1; }\n"
    (let ((outline (funcall imenu-create-index-function)))
      (should (equal (sort (mapcar #'car outline) #'string<) '("Function" "Output" "Param" "Record"))))))

;;; A session with the server

(defun calyx-tests--eventually (what ask)
  "Wait until ASK returns non-nil, and return it; WHAT says what was waited for."
  (let ((deadline (+ (float-time) 30)) answer)
    (while (not (or (setq answer (funcall ask)) (> (float-time) deadline)))
      (accept-process-output nil 0.02))
    (unless answer (ert-fail (list what (mapcar #'flymake-diagnostic-text (flymake-diagnostics)))))
    answer))

(ert-deftest calyx-with-the-server ()
  :tags '(server)
  (package-initialize)
  (require 'eglot)
  (let* ((calyx-program (getenv "CALYX"))
         (eglot-sync-connect 30)
         (eglot-autoshutdown t)
         (enable-local-variables nil)
         (model (expand-file-name "examples/spur_pair.cx" calyx-tests--project))
         (auto-save-default nil)
         (create-lockfiles nil)
         (buffer (find-file-noselect model)))
    (with-current-buffer buffer
      (should (eq major-mode 'calyx-mode))
      (apply #'eglot--connect (eglot--guess-contact))
      (calyx-tests--eventually "the server takes the model" #'eglot-managed-p)
      (flymake-mode 1)
      ;; A wrong unit is reported.
      (goto-char (point-min))
      (search-forward "pressure_angle = 20 deg")
      (delete-char -3)
      (insert "mm")
      (eglot--signal-textDocument/didChange)
      (calyx-tests--eventually
       "the error is reported"
       (lambda ()
         (flymake-start)
         (seq-find (lambda (d) (eq (flymake-diagnostic-type d) 'eglot-error)) (flymake-diagnostics))))
      (delete-char -2)
      (insert "deg")
      (eglot--signal-textDocument/didChange)
      (calyx-tests--eventually "the error goes" (lambda () (flymake-start) (null (flymake-diagnostics))))
      ;; A function of the library is shown in its source.
      (goto-char (point-min))
      (search-forward "gears.external")
      (backward-char 2)
      (let ((found (xref-backend-definitions (xref-find-backend)
                                             (xref-backend-identifier-at-point (xref-find-backend)))))
        (should found)
        (should (string-suffix-p "gears.cx" (xref-location-group (xref-item-location (car found))))))
      ;; An untidy line is formatted.
      (goto-char (point-min))
      (search-forward "var speed = 3 rpm;")
      (replace-match "var   speed=3 rpm ;")
      (calyx-format)
      (should (search-backward "var speed = 3 rpm;" nil t))
      (eglot-shutdown (eglot-current-server))
      (set-buffer-modified-p nil))
    (kill-buffer buffer)))

(provide 'calyx-mode-tests)
;;; calyx-mode-tests.el ends here
