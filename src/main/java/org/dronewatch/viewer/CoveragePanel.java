package org.dronewatch.viewer;

import java.awt.BorderLayout;
import java.util.Dictionary;
import java.util.Hashtable;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JScrollPane;
import javax.swing.JSlider;
import javax.swing.JTextArea;
import javax.swing.ScrollPaneConstants;
import org.dronewatch.analysis.field.CellExaminer.CellEvidence;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.LayerStore;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.SiteSkin;
import org.dronewatch.report.coverage.CellWords;
import org.dronewatch.report.coverage.LossWords;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;

/**
 * Computes a coverage and shows it as a skin over the site: a slider chooses the height, a check box for each sensor
 * shows what is lost without it, and the cell under the pointer is described.
 */
final class CoveragePanel extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int PARTS = 1000;

    private final JButton button = new JButton("Compute");
    private final CoverageForm form = new CoverageForm(button, this::compute);
    private final JProgressBar progress = new JProgressBar(0, PARTS);
    private final JTextArea message = text("what is covered");
    private final CoverageLegend legend = new CoverageLegend();
    private final JCheckBox shownBox = new JCheckBox("Show", true);
    private final JSlider heights = new JSlider(0, 1, 0);
    private final CoverageSwitches switches = new CoverageSwitches(this::update);
    private final JTextArea cell = text("the cell under the pointer");
    private final transient CoverageComputing computing;
    private final transient CoverageSkinning skinning;
    private final transient PointedCell pointed;
    private final transient Consumer<Optional<SiteSkin>> skinChosen;
    private transient ViewedRun run;
    private transient ViewedCoverage coverage;
    private transient Optional<CoverageSkinning.Shown> shown = Optional.empty();
    private transient CoverageForm.Inputs awaited;
    private boolean isWanted;

    /**
     * An empty panel.
     *
     * @param threads how many compute
     * @param stores gives the store of what was computed before
     * @param skinChosen receives the skin that is to be drawn
     * @param failed receives what went wrong
     */
    CoveragePanel(
            int threads,
            Function<SceneSettings, LayerStore> stores,
            Consumer<Optional<SiteSkin>> skinChosen,
            Consumer<Throwable> failed) {
        super(new BorderLayout(Scaled.px(8), 0));
        this.skinChosen = skinChosen;
        this.computing = new CoverageComputing(threads, stores, failed);
        this.skinning = new CoverageSkinning(threads, failed);
        this.pointed = new PointedCell(this::describe, failed);
        button.setToolTipText("Computes where the sensors detect the drone, and why not elsewhere");
        button.addActionListener(e -> {
            if (awaited == null) {
                compute();
            } else {
                cancel();
            }
        });
        progress.setVisible(false);
        progress.setStringPainted(true);
        progress.getAccessibleContext().setAccessibleName("progress of the coverage");
        shownBox.setToolTipText("Shows or hides the coverage in the site");
        shownBox.addActionListener(e -> choose());
        heights.setToolTipText("Height above the ground, m");
        heights.setSnapToTicks(true);
        heights.setPaintTicks(true);
        heights.setMajorTickSpacing(1);
        heights.addChangeListener(e -> update());
        setBorder(BorderFactory.createEmptyBorder(Scaled.px(2), Scaled.px(4), Scaled.px(4), Scaled.px(4)));
        add(controls(), BorderLayout.NORTH);
        add(scrolling(legend), BorderLayout.WEST);
        add(scrolling(switches), BorderLayout.CENTER);
        add(cell, BorderLayout.SOUTH);
        getAccessibleContext().setAccessibleName("coverage");
        clear("");
    }

    /** Above what changes with the pointer: the inputs, and the height that is shown. */
    private JComponent controls() {
        JPanel height = new JPanel(new BorderLayout(Scaled.px(6), 0));
        JLabel label = new JLabel("height above the ground (m)");
        label.setLabelFor(heights);
        JPanel names = new JPanel(new BorderLayout(Scaled.px(10), 0));
        names.add(shownBox, BorderLayout.WEST);
        names.add(label, BorderLayout.CENTER);
        height.add(names, BorderLayout.WEST);
        height.add(heights, BorderLayout.CENTER);
        JPanel said = new JPanel(new BorderLayout());
        said.add(progress, BorderLayout.NORTH);
        said.add(message, BorderLayout.CENTER);
        JPanel controls = new JPanel(new BorderLayout());
        controls.add(form, BorderLayout.NORTH);
        controls.add(height, BorderLayout.CENTER);
        controls.add(said, BorderLayout.SOUTH);
        return controls;
    }

    private static JScrollPane scrolling(JComponent content) {
        JScrollPane pane = new JScrollPane(
                content,
                ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED,
                ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        pane.setBorder(null);
        pane.getVerticalScrollBar().setUnitIncrement(Scaled.px(16));
        return pane;
    }

    /** Lines that wrap, as a label cannot. */
    private static JTextArea text(String name) {
        JTextArea area = new JTextArea();
        area.setEditable(false);
        area.setFocusable(false);
        area.setLineWrap(true);
        area.setWrapStyleWord(true);
        area.setOpaque(false);
        area.setBorder(null);
        area.setFont(Scaled.font(1.0));
        // The name of a text that changes: its own context would look for a window at every change.
        new JLabel(name).setLabelFor(area);
        return area;
    }

    /** Takes the drones and sensors of another run. */
    void show(ViewedRun next) {
        if (awaited != null) {
            cancel();
        }
        awaited = null;
        run = next;
        form.show(next.settings());
        clear(form.isPossible() ? "Nothing has been computed yet." : "The scene has no drone or no sensor.");
        if (isWanted) {
            isWanted = false;
            compute();
        }
    }

    private void clear(String words) {
        coverage = null;
        shown = Optional.empty();
        message.setText(words);
        cell.setText("");
        legend.show(List.of());
        switches.show(List.of());
        pointed.show(shown);
        heights.setEnabled(false);
        shownBox.setEnabled(false);
        setComputing(false);
        choose();
    }

    private void setComputing(boolean is) {
        button.setText(is ? "Cancel" : "Compute");
        button.setEnabled(is || form.isPossible());
        form.setEnabled(!is && form.isPossible());
        progress.setVisible(is);
        progress.setValue(0);
    }

    /** Computes with the defaults as soon as the site is there. */
    void computeSoon() {
        if (run == null) {
            isWanted = true;
        } else {
            compute();
        }
    }

    /** Computes what the form says. */
    void compute() {
        if (run == null || awaited != null || !form.isPossible()) {
            return;
        }
        try {
            CoverageForm.Inputs inputs = form.inputs();
            awaited = inputs;
            message.setText("");
            setComputing(true);
            computing.compute(run, inputs, found -> {
                if (awaited == inputs) {
                    awaited = null;
                    take(found);
                }
            });
        } catch (InputException e) {
            message.setText(e.getMessage());
        }
    }

    /** Ends the computation; the heights that are complete are shown. */
    void cancel() {
        computing.cancel();
    }

    private void take(Optional<ViewedCoverage> found) {
        setComputing(false);
        if (found.isEmpty()) {
            message.setText("No height is complete.");
            return;
        }
        coverage = found.get();
        shown = Optional.empty();
        pointed.show(shown);
        List<Double> all = coverage.grid().heights();
        Dictionary<Integer, JLabel> labels = new Hashtable<>();
        for (int i = 0; i < all.size(); i++) {
            labels.put(i, new JLabel(Texts.value(all.get(i))));
        }
        heights.setMaximum(all.size() - 1);
        heights.setValue(0);
        heights.setLabelTable(labels);
        heights.setPaintLabels(true);
        heights.setEnabled(true);
        shownBox.setEnabled(true);
        switches.show(coverage.all().field().sensors());
        update();
    }

    /** Shows another height, or the coverage of other sensors. */
    private void update() {
        if (coverage == null) {
            return;
        }
        Set<String> off = switches.off();
        skinning.lay(coverage, heights.getValue(), off, next -> {
            if (next.coverage() == coverage) {
                shown = Optional.of(next);
                legend.show(next.legend());
                message.setText(LossWords.sentence(next.remaining(), off) + incomplete());
                pointed.show(shown);
                choose();
            }
        });
    }

    /** That the computation was cancelled, if it was. */
    private String incomplete() {
        return coverage.isWhole()
                ? ""
                : String.format(
                        Locale.ROOT,
                        " Cancelled: %d of %d heights are complete.",
                        coverage.grid().heights().size(),
                        coverage.request().grid().heights().size());
    }

    private void choose() {
        skinChosen.accept(shownBox.isSelected() ? shown.map(CoverageSkinning.Shown::skin) : Optional.empty());
    }

    /** Shows or hides the skin. */
    void toggle() {
        if (shownBox.isEnabled()) {
            shownBox.doClick(0);
        }
    }

    /** Describes the cell at a point of the site. */
    void point(Optional<Position> place) {
        pointed.point(place);
    }

    private void describe() {
        Optional<PointedCell.Cell> there = pointed.cell();
        if (there.isEmpty()) {
            cell.setText(shown.isEmpty() ? "" : "Point at a cell of the site to see what decides there.");
            switches.clearCell();
            return;
        }
        CellWords words = there.get().words();
        FieldCoverage rest = there.get().coverage();
        if (there.get().evidence().isEmpty()) {
            cell.setText("At " + words.summary() + ".");
            switches.describe(words, rest);
        } else {
            CellEvidence evidence = there.get().evidence().get();
            cell.setText("At " + words.deciding(evidence));
            switches.describe(words, rest, evidence);
        }
    }

    /** What is known about the cell under the pointer, for the status line; empty without one. */
    Optional<String> hint() {
        return pointed.cell().map(there -> there.words().summary());
    }

    /** Shows the progress. */
    void tick() {
        if (awaited != null) {
            int part = (int) (PARTS * computing.progress());
            progress.setValue(part);
            progress.setString(String.format(Locale.ROOT, "%.0f %%", 100.0 * part / PARTS));
        }
    }

    CoverageForm form() {
        return form;
    }

    CoverageSwitches switches() {
        return switches;
    }

    JSlider heights() {
        return heights;
    }

    /** The skin and what belongs to it, once there is one. */
    Optional<CoverageSkinning.Shown> shown() {
        return shown;
    }

    /** What it says about the coverage. */
    String message() {
        return message.getText();
    }

    /** What it says about the cell under the pointer. */
    String cell() {
        return cell.getText();
    }

    /** Whether nothing is computed. */
    boolean isIdle() {
        return awaited == null && computing.isIdle() && skinning.isIdle() && pointed.isIdle();
    }

    /** Ends all threads. */
    void close() {
        computing.close();
        skinning.close();
        pointed.close();
    }
}
