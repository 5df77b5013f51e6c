package org.dronewatch.viewer.part;

import java.awt.BorderLayout;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;

/** The lower edge of the window: a line of text, and the progress of the run. */
public final class StatusBar extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int PARTS = 1000;

    private final JLabel text = new JLabel();
    private final JProgressBar progress = new JProgressBar(0, PARTS);

    /** A status bar that shows a text while a scene is being read. */
    public StatusBar(String reading) {
        super(new BorderLayout());
        setBorder(BorderFactory.createEmptyBorder(Scaled.px(3), Scaled.px(10), Scaled.px(3), Scaled.px(10)));
        add(text, BorderLayout.CENTER);
        add(progress, BorderLayout.LINE_END);
        progress.setIndeterminate(true);
        write(reading);
    }

    /** Replaces the text, which is also shown in a tooltip in case there is no room for all of it. */
    public void write(String line) {
        text.setText(line);
        text.setToolTipText(line);
    }

    /**
     * Shows the progress of a run.
     *
     * @param fraction fraction of the run that has been simulated, 0 to 1
     * @param isFinished whether all runs are over, so that there is no progress to show
     */
    public void progress(double fraction, boolean isFinished) {
        progress.setVisible(!isFinished);
        progress.setIndeterminate(false);
        progress.setValue((int) (PARTS * fraction));
    }

    /** Replaces the text, and no longer shows progress. */
    public void end(String line) {
        progress.setVisible(false);
        write(line);
    }
}
