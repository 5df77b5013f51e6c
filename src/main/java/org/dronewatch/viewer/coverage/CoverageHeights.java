package org.dronewatch.viewer.coverage;

import java.awt.BorderLayout;
import java.util.Dictionary;
import java.util.Hashtable;
import java.util.List;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.part.Texts;

/** Chooses which height of a coverage is shown, and whether the coverage is shown at all. */
public final class CoverageHeights extends JPanel {
    private static final long serialVersionUID = 1L;

    private final JCheckBox box = new JCheckBox("Show", true);
    private final JSlider slider = new JSlider(0, 1, 0);

    /**
     * A chooser without heights.
     *
     * @param chosen called when the user has chosen another height
     * @param shown called when the user has shown or hidden the coverage
     */
    CoverageHeights(Runnable chosen, Runnable shown) {
        super(new BorderLayout(Scaled.px(6), 0));
        box.setToolTipText("Shows or hides the coverage over the site");
        box.addActionListener(e -> shown.run());
        slider.setToolTipText("Height above the ground, m");
        slider.setSnapToTicks(true);
        slider.setPaintTicks(true);
        slider.setMajorTickSpacing(1);
        slider.addChangeListener(e -> chosen.run());
        JLabel label = new JLabel("height above the ground (m)");
        label.setLabelFor(slider);
        JPanel names = new JPanel(new BorderLayout(Scaled.px(10), 0));
        names.add(box, BorderLayout.WEST);
        names.add(label, BorderLayout.CENTER);
        add(names, BorderLayout.WEST);
        add(slider, BorderLayout.CENTER);
    }

    /** Offers heights, m, and chooses the lowest; none while there is no coverage. */
    void show(List<Double> heights) {
        box.setEnabled(!heights.isEmpty());
        slider.setEnabled(!heights.isEmpty());
        if (heights.isEmpty()) {
            return;
        }
        Dictionary<Integer, JLabel> labels = new Hashtable<>();
        for (int i = 0; i < heights.size(); i++) {
            labels.put(i, new JLabel(Texts.value(heights.get(i))));
        }
        slider.setMaximum(heights.size() - 1);
        slider.setValue(0);
        slider.setLabelTable(labels);
        slider.setPaintLabels(true);
    }

    /** Whether the coverage is shown. */
    boolean isShown() {
        return box.isSelected();
    }

    /** Shows or hides the coverage, if there is one. */
    void toggle() {
        if (box.isEnabled()) {
            box.doClick(0);
        }
    }

    /** The index of the chosen height, counted from the lowest. */
    int chosen() {
        return slider.getValue();
    }

    /** Chooses a height by its index, from 0 for the lowest. */
    public void choose(int number) {
        slider.setValue(number);
    }
}
