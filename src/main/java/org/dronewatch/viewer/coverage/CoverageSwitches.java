package org.dronewatch.viewer.coverage;

import java.awt.BorderLayout;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ScrollPaneConstants;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.survey.CellExaminer.CellEvidence;
import org.dronewatch.report.coverage.table.CellWords;
import org.dronewatch.viewer.part.Scaled;

/**
 * A check box for each sensor of a coverage, with a note on whether the sensor detects the drone in the cell under the
 * pointer.
 */
public final class CoverageSwitches extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final String NONE = " ";

    private final transient Runnable switched;
    private final JPanel rows = new JPanel(new GridBagLayout());
    private final transient List<Row> sensors = new ArrayList<>();

    /** One sensor. */
    private record Row(JCheckBox box, JLabel probability, JLabel margin, JLabel reason) {
        void write(String p, String m, String why) {
            probability.setText(p);
            margin.setText(m);
            reason.setText(why);
            reason.setToolTipText(why.isBlank() ? null : why);
        }
    }

    /**
     * No switches yet.
     *
     * @param switched called when the user has switched a sensor on or off
     */
    CoverageSwitches(Runnable switched) {
        super(new BorderLayout());
        this.switched = switched;
        add(rows, BorderLayout.NORTH);
        getAccessibleContext().setAccessibleName("sensors of the coverage");
    }

    /** A switch for each sensor, all of them on. */
    void show(List<String> names) {
        rows.removeAll();
        sensors.clear();
        head("sensor", 0, "Uncheck a sensor to see what is lost without it");
        head("p", 1, "Probability that one look detects the drone in the cell under the pointer");
        head("margin", 2, "Signal minus threshold in the cell under the pointer");
        head("in this cell", 3, "Whether the sensor detects the drone in the cell under the pointer, or why not");
        for (String name : names) {
            JCheckBox box = new JCheckBox(name, true);
            box.setToolTipText("Switches '" + name + "' on or off in the coverage");
            box.addActionListener(e -> switched.run());
            Row row = new Row(box, new JLabel(NONE), new JLabel(NONE), new JLabel(NONE));
            sensors.add(row);
            int number = sensors.size();
            add(box, 0, number);
            add(row.probability(), 1, number);
            add(row.margin(), 2, number);
            add(row.reason(), 3, number);
        }
        revalidate();
        repaint();
    }

    private void head(String text, int column, String explanation) {
        JLabel label = new JLabel(text);
        label.setFont(Scaled.font(0.9));
        label.setToolTipText(explanation);
        add(label, column, 0);
    }

    private void add(JComponent part, int column, int row) {
        rows.add(
                part,
                new GridBagConstraints(
                        column,
                        row,
                        1,
                        1,
                        column == 3 ? 1 : 0,
                        0,
                        GridBagConstraints.LINE_START,
                        GridBagConstraints.NONE,
                        new Insets(0, Scaled.px(2), 0, Scaled.px(8)),
                        0,
                        0));
    }

    /** The sensors that are switched off. */
    Set<String> off() {
        Set<String> off = new LinkedHashSet<>();
        for (Row row : sensors) {
            if (!row.box().isSelected()) {
                off.add(row.box().getText());
            }
        }
        return off;
    }

    /** The check boxes, in the order of the sensors. */
    public List<JCheckBox> boxes() {
        return sensors.stream().map(Row::box).toList();
    }

    /** Whether each sensor detects the drone, or why not, in the cell under the pointer. */
    public List<String> reasons() {
        return sensors.stream().map(row -> row.reason().getText()).toList();
    }

    /**
     * Shows for each sensor what is known about a cell; returns a sentence on the state of the cell, and on the sensor
     * that determines the cause.
     */
    String describe(PointedCell.Cell there) {
        CellWords words = there.words();
        if (there.evidence().isEmpty()) {
            describe(words, there.coverage());
            return "At " + words.deciding();
        }
        describe(words, there.coverage(), there.evidence().get());
        return "At " + words.deciding(there.evidence().get());
    }

    /** States at once what the field holds about a cell; margins, in dB, are bounds in most cells. */
    private void describe(CellWords words, FieldCoverage coverage) {
        for (Row row : sensors) {
            int sensor = coverage.field().sensors().indexOf(row.box().getText());
            if (sensor < 0) {
                row.write("-", NONE, "off");
            } else {
                row.write(words.probability(sensor), words.margin(sensor), words.cause(sensor));
            }
        }
    }

    /** Adds exact margins, and what hides the drone. */
    private void describe(CellWords words, FieldCoverage coverage, CellEvidence evidence) {
        for (Row row : sensors) {
            int sensor = coverage.field().sensors().indexOf(row.box().getText());
            if (sensor >= 0) {
                row.write(
                        words.probability(sensor),
                        CellWords.margin(evidence.sensors().get(sensor)),
                        words.reason(sensor, evidence.sensors().get(sensor)));
            }
        }
    }

    /** Clears what is shown about a cell, because none is pointed at. */
    void clearCell() {
        sensors.forEach(row -> row.write(NONE, NONE, NONE));
    }

    /** Puts a component into a pane that scrolls up and down. */
    static JScrollPane scrolling(JComponent content) {
        JScrollPane pane = new JScrollPane(
                content,
                ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED,
                ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        pane.setBorder(null);
        pane.getVerticalScrollBar().setUnitIncrement(Scaled.px(16));
        return pane;
    }
}
