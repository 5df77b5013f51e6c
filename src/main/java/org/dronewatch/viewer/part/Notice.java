package org.dronewatch.viewer.part;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Insets;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JTextArea;

/** A strip that shows an error message until the user dismisses it. */
public final class Notice extends JPanel {
    private static final long serialVersionUID = 1L;

    private final JTextArea text = new JTextArea();

    public Notice() {
        super(new BorderLayout(8, 0));
        setVisible(false);
        setBackground(new Color(0xb3261e));
        setBorder(BorderFactory.createEmptyBorder(Scaled.px(6), Scaled.px(12), Scaled.px(6), Scaled.px(8)));
        text.setEditable(false);
        text.setOpaque(false);
        text.setLineWrap(true);
        text.setWrapStyleWord(true);
        text.setForeground(Color.WHITE);
        text.setMargin(new Insets(0, 0, 0, 0));
        text.getAccessibleContext().setAccessibleName("error");
        add(text, BorderLayout.CENTER);
        JButton dismiss = new JButton("Dismiss");
        dismiss.addActionListener(e -> setVisible(false));
        add(dismiss, BorderLayout.LINE_END);
    }

    /** Shows a message. */
    public void show(String problem) {
        text.setText(problem);
        setVisible(true);
        revalidate();
    }

    /** The message. */
    public String text() {
        return text.getText();
    }
}
