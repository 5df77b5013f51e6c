package org.dronewatch.viewer.coverage;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.part.WrappedText;
import org.dronewatch.viewer.run.SensorLayout;
import org.dronewatch.viewer.run.ViewedRun;

/**
 * Computes a coverage and shows it as an overlay on the site: a slider chooses the height, a check box for each sensor
 * shows what is lost without it, and the cell under the pointer is described.
 */
public final class CoveragePanel extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int PARTS = 1000;

    private final JButton button = new JButton("Compute");
    private final CoverageForm form = new CoverageForm(button, this::compute);
    private final JProgressBar progress = new JProgressBar(0, PARTS);
    private final WrappedText message = new WrappedText("coverage summary");
    private final CoverageLegend legend = new CoverageLegend();
    private final CoverageHeights heights = new CoverageHeights(this::update, this::choose);
    private final CoverageSwitches switches = new CoverageSwitches(this::update);
    private final WrappedText cell = new WrappedText("the cell under the pointer");
    private final transient CoverageComputing computing;
    private final transient CoveragePictures pictures;
    private final transient SensorLayout layout;
    private final transient PointedCell pointed;
    private final transient SkinPainter painter;
    private transient ViewedRun run;
    private transient ViewedCoverage coverage;
    private transient Optional<CoverageSkinning.Shown> shown = Optional.empty();
    private transient CoverageForm.Inputs awaited;
    private transient Runnable changed = () -> {};
    private boolean isWanted;

    /**
     * An empty panel.
     *
     * @param threads number of threads that compute
     * @param layout where the user has put the sensors
     * @param stores returns the store of coverages computed before, for the settings of a run
     * @param painter paints the overlay
     * @param failed receives what went wrong
     */
    public CoveragePanel(
            int threads,
            SensorLayout layout,
            Function<SceneSettings, LayerStore> stores,
            SkinPainter painter,
            Consumer<Throwable> failed) {
        super(new BorderLayout(Scaled.px(8), 0));
        this.painter = painter;
        this.computing = new CoverageComputing(threads, stores, failed);
        this.layout = layout;
        this.pictures = new CoveragePictures(threads, painter::isPainting, failed);
        layout.listen(this::update);
        this.pointed = new PointedCell(this::describe, failed);
        button.setToolTipText("Computes where the sensors detect the drone, and why they do not elsewhere");
        button.addActionListener(e -> {
            if (awaited == null) {
                compute();
            } else {
                cancel();
            }
        });
        progress.setVisible(false);
        progress.setStringPainted(true);
        progress.getAccessibleContext().setAccessibleName("coverage progress");
        setBorder(BorderFactory.createEmptyBorder(Scaled.px(2), Scaled.px(4), Scaled.px(4), Scaled.px(4)));
        add(controls(), BorderLayout.NORTH);
        add(CoverageSwitches.scrolling(legend), BorderLayout.WEST);
        add(CoverageSwitches.scrolling(switches), BorderLayout.CENTER);
        add(cell, BorderLayout.SOUTH);
        getAccessibleContext().setAccessibleName("coverage");
        clear("");
    }

    /** The part above the texts that change with the pointer: the inputs, and the height that is shown. */
    private JComponent controls() {
        JPanel said = new JPanel(new BorderLayout());
        said.add(progress, BorderLayout.NORTH);
        said.add(message, BorderLayout.CENTER);
        JPanel controls = new JPanel(new BorderLayout());
        controls.add(form, BorderLayout.NORTH);
        controls.add(heights, BorderLayout.CENTER);
        controls.add(said, BorderLayout.SOUTH);
        return controls;
    }

    /** Takes the drones and sensors of another run. */
    public void show(ViewedRun next) {
        if (awaited != null) {
            cancel();
        }
        awaited = null;
        run = next;
        form.show(next.settings(), next.stage().world());
        clear(form.isPossible() ? "Nothing has been computed yet." : "The scene has no drone or no sensor.");
        if (isWanted) {
            isWanted = false;
            compute();
        }
    }

    private void clear(String words) {
        coverage = null;
        pictures.stop();
        shown = Optional.empty();
        message.setText(words);
        cell.setText("");
        legend.show(List.of());
        switches.show(List.of());
        pointed.show(shown);
        heights.show(List.of());
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

    /** Computes with the defaults as soon as the site has been loaded. */
    public void computeSoon() {
        if (run == null) {
            isWanted = true;
        } else {
            compute();
        }
    }

    /** Computes the coverage with the inputs of the form. */
    public void compute() {
        if (run == null || awaited != null || !form.isPossible()) {
            return;
        }
        try {
            CoverageForm.Inputs inputs = form.inputs();
            awaited = inputs;
            message.setText("");
            setComputing(true);
            computing.compute(run, layout.settings(), inputs, found -> {
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
            message.setText("The computation ended before any height was complete.");
            return;
        }
        coverage = found.get();
        shown = Optional.empty();
        pointed.show(shown);
        heights.show(coverage.grid().heights());
        switches.show(coverage.all().field().sensors());
        update();
    }

    /** Shows another height, the coverage of other sensors, or of sensors that were moved. */
    private void update() {
        if (coverage != null) {
            pictures.show(coverage, heights.chosen(), switches.off(), layout.settings(), this::take);
        }
    }

    private void take(CoverageSkinning.Shown next) {
        shown = Optional.of(next);
        legend.show(next.legend());
        // A scroll pane keeps its width until the panel around it is laid out anew.
        revalidate();
        message.setText(next.words());
        pointed.show(shown);
        choose();
        changed.run();
    }

    /** Sets the action that runs whenever another coverage is shown. */
    public void onShown(Runnable target) {
        changed = target;
    }

    private void choose() {
        painter.setSkin(heights.isShown() ? shown.map(CoverageSkinning.Shown::skin) : Optional.empty());
    }

    /** Shows or hides the overlay. */
    public void toggle() {
        heights.toggle();
    }

    /** Describes the cell at a point of the site; none if the point is empty. */
    public void point(Optional<Position> place) {
        pointed.point(place);
    }

    private void describe() {
        String nothing = shown.isEmpty()
                ? ""
                : "Point at a cell to see which sensors detect the drone there, and why the others miss it.";
        cell.setText(pointed.cell().map(switches::describe).orElse(nothing));
        if (pointed.cell().isEmpty()) {
            switches.clearCell();
        }
    }

    /** What is known about the cell under the pointer, for the status line; empty if there is none. */
    public Optional<String> hint() {
        return pointed.cell().map(there -> there.words().summary());
    }

    /** Updates the progress bar. */
    public void tick() {
        if (awaited != null) {
            int part = (int) (PARTS * computing.progress());
            progress.setValue(part);
            progress.setString(String.format(Locale.ROOT, "%.0f %%", 100.0 * part / PARTS));
        }
    }

    public CoverageForm form() {
        return form;
    }

    public CoverageSwitches switches() {
        return switches;
    }

    public CoverageHeights heights() {
        return heights;
    }

    /** The overlay that is shown, with its coverage; empty until a coverage has been computed. */
    public Optional<CoverageSkinning.Shown> shown() {
        return shown;
    }

    /** The text about the coverage. */
    String message() {
        return message.getText();
    }

    /** The text about the cell under the pointer. */
    public String cell() {
        return cell.getText();
    }

    /** Whether nothing is being computed. */
    public boolean isIdle() {
        return awaited == null && computing.isIdle() && pictures.isIdle() && pointed.isIdle();
    }

    /** Ends all threads. */
    public void close() {
        computing.close();
        pictures.close();
        pointed.close();
    }
}
