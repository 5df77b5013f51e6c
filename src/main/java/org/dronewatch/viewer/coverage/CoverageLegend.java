package org.dronewatch.viewer.coverage;

import java.awt.BorderLayout;
import java.awt.GridLayout;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.ImageIcon;
import javax.swing.JLabel;
import javax.swing.JPanel;
import org.dronewatch.report.coverage.CoverageSkin.LegendEntry;
import org.dronewatch.viewer.part.Scaled;

/** The meaning of the colours of a coverage. */
public final class CoverageLegend extends JPanel {
    private static final long serialVersionUID = 1L;

    private final JPanel entries = new JPanel(new GridLayout(0, 1, 0, Scaled.px(2)));

    CoverageLegend() {
        super(new BorderLayout());
        add(entries, BorderLayout.NORTH);
        // So that the scroll bar covers nothing.
        setBorder(BorderFactory.createEmptyBorder(Scaled.px(4), Scaled.px(2), Scaled.px(2), Scaled.px(14)));
        getAccessibleContext().setAccessibleName("coverage legend");
    }

    /** Shows entries in their order; none for no coverage. */
    void show(List<LegendEntry> meanings) {
        entries.removeAll();
        for (LegendEntry entry : meanings) {
            entries.add(new JLabel(entry.words(), new ImageIcon(entry.swatch()), JLabel.LEADING));
        }
        revalidate();
        repaint();
    }
}
