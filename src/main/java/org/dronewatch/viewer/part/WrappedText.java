package org.dronewatch.viewer.part;

import javax.swing.JLabel;
import javax.swing.JTextArea;

/** Text that wraps, as a label cannot. */
public final class WrappedText extends JTextArea {
    private static final long serialVersionUID = 1L;

    /** An empty text, with a name for assistive software. */
    public WrappedText(String name) {
        setEditable(false);
        setFocusable(false);
        setLineWrap(true);
        setWrapStyleWord(true);
        setOpaque(false);
        setBorder(null);
        setFont(Scaled.font(1.0));
        // Named by its label: if the name were its own, the text would look for its window at every change.
        new JLabel(name).setLabelFor(this);
    }
}
