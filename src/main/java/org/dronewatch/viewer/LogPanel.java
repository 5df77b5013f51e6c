package org.dronewatch.viewer;

import java.awt.BorderLayout;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.text.BadLocationException;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.run.Events;
import org.dronewatch.viewer.run.RecordedRun;

/** The log of files read, warnings, and detections gained and lost, in chronological order. */
final class LogPanel extends JPanel {
    private static final long serialVersionUID = 1L;

    /** Maximum number of lines; older ones are dropped. */
    private static final int MOST = 5000;

    /** Maximum number of detections of one run that are written at once: a long run must not hold up the window. */
    private static final int AT_ONCE = 200;

    private final JTextArea text = new JTextArea();
    private transient RecordedRun run;
    private int written;

    LogPanel() {
        super(new BorderLayout());
        text.setEditable(false);
        text.setFont(Scaled.monospaced(1.0));
        text.getAccessibleContext().setAccessibleName("log");
        add(new JScrollPane(text));
    }

    /** Writes a line. */
    void write(String line) {
        write(List.of(line));
    }

    private void write(List<String> lines) {
        if (lines.isEmpty()) {
            return;
        }
        text.append(String.join("\n", lines) + "\n");
        if (text.getLineCount() > MOST) {
            try {
                text.replaceRange("", 0, text.getLineStartOffset(text.getLineCount() - MOST));
            } catch (BadLocationException e) {
                throw new IllegalStateException(e);
            }
        }
        text.setCaretPosition(text.getDocument().getLength());
    }

    /** Appends the new detection events of a run. */
    void update(RecordedRun next) {
        if (next != run) {
            run = next;
            written = 0;
        }
        List<String> lines = new ArrayList<>();
        for (DetectionEvent event : run.eventsFrom(written)) {
            if (lines.size() == AT_ONCE) {
                break;
            }
            lines.add(Events.text(event));
        }
        written += lines.size();
        write(lines);
    }

    /** All that is shown. */
    String text() {
        return text.getText();
    }
}
