package org.dronewatch.viewer.beside;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Font;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.swing.BorderFactory;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.table.DefaultTableCellRenderer;
import org.dronewatch.viewer.coverage.CoverageForm;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.part.Texts;
import org.dronewatch.viewer.part.WrappedText;
import org.dronewatch.viewer.run.RecordedRun;

/**
 * Chooses another run, and states how it differs from the displayed one: in the settings of sensors, and in the time at
 * which each drone is first detected, by any sensor and by each sensor. For the event thread.
 */
public final class ComparisonPanel extends JPanel {
    private static final long serialVersionUID = 1L;

    private static final int[] WIDTHS = {56, 88, 104, 104, 94, 60};

    /** The sentence is about at most this many drones. */
    private static final int DRONES_IN_WORDS = 3;

    private static final String NOTHING = "nothing";
    private static final String HOW =
            "There is no other run yet. Change a sensor and press Run again in the Settings tab, "
                    + "open a scene with a sweep, or start with 'view SCENE --beside OTHER'.";

    private final JComboBox<Object> choice = new JComboBox<>(new Object[] {NOTHING});
    private final JCheckBox beside = new JCheckBox("Show it beside this run");
    private final WrappedText said = new WrappedText("differences between the two runs");
    private final transient ComparisonTable model = new ComparisonTable();
    private final JTable table = new JTable(model);
    private transient List<OtherRun> offered = List.of();
    private transient Runnable changed = () -> {};
    private transient RecordedRun described;
    private transient RecordedRun describedOther;
    private transient String settings = "";
    private boolean updating;

    /**
     * A panel with nothing to compare.
     *
     * @param selection receives the sensor or drone whose row was clicked on
     */
    public ComparisonPanel(Consumer<String> selection) {
        super(new BorderLayout());
        said.setBorder(BorderFactory.createEmptyBorder(Scaled.px(2), Scaled.px(8), Scaled.px(2), Scaled.px(8)));
        said.setText(HOW);
        beside.setToolTipText("Shows the site of the other run at the same time, from the same viewpoint (B)");
        setUpTable(selection);
        JPanel top = new JPanel(new BorderLayout());
        top.add(
                CoverageForm.row(
                        CoverageForm.named("Compare with", choice, "The run with which this one is compared"),
                        choice,
                        beside),
                BorderLayout.NORTH);
        top.add(said, BorderLayout.CENTER);
        add(top, BorderLayout.NORTH);
        add(new JScrollPane(table), BorderLayout.CENTER);
        getAccessibleContext().setAccessibleName("comparison of two runs");
        choice.getAccessibleContext().setAccessibleName("run to compare with");
        choice.addActionListener(e -> {
            if (!updating) {
                changed.run();
            }
        });
        beside.addActionListener(e -> changed.run());
        beside.setEnabled(false);
        choice.setEnabled(false);
    }

    private void setUpTable(Consumer<String> selection) {
        table.getAccessibleContext().setAccessibleName("first detections in both runs");
        table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        table.setDefaultRenderer(Object.class, new Renderer());
        for (int i = 0; i < WIDTHS.length; i++) {
            table.getColumnModel().getColumn(i).setPreferredWidth(Scaled.px(WIDTHS[i]));
        }
        table.getSelectionModel().addListSelectionListener(e -> {
            if (!e.getValueIsAdjusting() && table.getSelectedRow() >= 0) {
                DetectionComparison row = model.rows().get(table.getSelectedRow());
                selection.accept(row.sensor().orElse(row.drone()));
            }
        });
    }

    /** Shows rows that differ in bold, in addition to the words that say so. */
    private final class Renderer extends DefaultTableCellRenderer {
        private static final long serialVersionUID = 1L;

        @Override
        public Component getTableCellRendererComponent(
                JTable owner, Object value, boolean isSelected, boolean hasFocus, int row, int column) {
            super.getTableCellRendererComponent(owner, value, isSelected, hasFocus, row, column);
            boolean differs = model.rows().get(row).isDifferent();
            setFont(owner.getFont().deriveFont(differs ? Font.BOLD : Font.PLAIN));
            boolean isCut = getPreferredSize().width
                    > owner.getColumnModel().getColumn(column).getWidth();
            setToolTipText(isCut ? String.valueOf(value) : null);
            return this;
        }
    }

    /** Sets the action that runs whenever another run is chosen, or is shown or hidden beside this one. */
    public void onChange(Runnable target) {
        changed = target;
    }

    /** Offers runs to choose from; the chosen one remains chosen as long as it is among them. */
    public void offer(List<OtherRun> runs) {
        if (runs.equals(offered)) {
            return;
        }
        Optional<OtherRun> before = chosen();
        offered = List.copyOf(runs);
        List<Object> items = new ArrayList<>(runs);
        items.add(0, NOTHING);
        updating = true;
        choice.setModel(new DefaultComboBoxModel<>(items.toArray()));
        choice.setSelectedItem(
                before.filter(runs::contains).<Object>map(run -> run).orElse(NOTHING));
        updating = false;
        choice.setEnabled(!runs.isEmpty());
        changed.run();
    }

    /** The runs that can be chosen. */
    public List<OtherRun> offered() {
        return offered;
    }

    /** Chooses a run among those that are offered, as if the user had done so. */
    public void choose(OtherRun run) {
        choice.setSelectedItem(run);
    }

    /** The run that is chosen; empty if none is. */
    public Optional<OtherRun> chosen() {
        return choice.getSelectedItem() instanceof OtherRun run ? Optional.of(run) : Optional.empty();
    }

    /** Whether the chosen run is to be shown beside this one. */
    public boolean isBeside() {
        return chosen().isPresent() && beside.isSelected();
    }

    /** Sets whether the chosen run is shown beside this one, as if the user had done so. */
    public void setBeside(boolean shown) {
        if (beside.isSelected() != shown) {
            beside.setSelected(shown);
            changed.run();
        }
    }

    /** Compares the run that is shown with the chosen one, both at the given time, s. */
    public void show(RecordedRun shown, double time) {
        Optional<OtherRun> other = chosen();
        beside.setEnabled(other.isPresent());
        if (other.isEmpty()) {
            model.clear();
            tell(offered.isEmpty() ? HOW : "");
            return;
        }
        RecordedRun run = other.get().run();
        model.show(shown, run, time);
        if (described != shown || describedOther != run) {
            described = shown;
            describedOther = run;
            settings = ChangedSettings.text(shown.info().settings(), run.info().settings());
        }
        tell(settings + " " + firstDetections() + progress(run));
    }

    private String firstDetections() {
        List<DetectionComparison> any =
                model.rows().stream().filter(row -> row.sensor().isEmpty()).toList();
        String more = any.size() > DRONES_IN_WORDS ? " The table lists the other drones." : "";
        return any.stream()
                        .limit(DRONES_IN_WORDS)
                        .map(row ->
                                "First detection of '" + row.drone() + "': " + row.hereText() + "; in the other run "
                                        + row.thereText()
                                        + (row.difference().isEmpty() ? "" : " (" + row.difference() + ")") + ".")
                        .collect(Collectors.joining(" "))
                + more;
    }

    private static String progress(RecordedRun run) {
        return run.isFinished() ? "" : " The other run has been simulated up to " + Texts.time(run.reached()) + ".";
    }

    private void tell(String text) {
        if (!text.equals(said.getText())) {
            said.setText(text);
        }
    }

    /** The table of first detections. */
    public JTable table() {
        return table;
    }

    /** The sentences that state what differs. */
    public String said() {
        return said.getText();
    }
}
