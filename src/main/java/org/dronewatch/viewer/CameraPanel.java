package org.dronewatch.viewer;

import java.awt.BorderLayout;
import java.awt.GridLayout;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import org.dronewatch.sensor.optics.PictureSettings;
import org.dronewatch.viewer.part.Latest;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.run.PairReading;
import org.dronewatch.viewer.run.ViewedRun;

/** All cameras of a run side by side; a click on one enlarges it, another click shows all again. */
final class CameraPanel extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int GAP = 3;

    private final transient List<CameraVisual> visuals = new ArrayList<>();
    private final transient Latest looks;
    private final transient Consumer<String> hint;
    private final transient Consumer<String> selection;
    private transient CameraVisual enlarged;
    private double time;
    private boolean colour;

    /** Whether a scene is displayed; before that, the number of cameras is unknown. */
    private boolean known;

    /**
     * An empty panel.
     *
     * @param threads number of threads that trace rays
     * @param hint receives what is under the pointer
     * @param selection receives the camera that was clicked on
     * @param failed receives what went wrong
     */
    CameraPanel(int threads, Consumer<String> hint, Consumer<String> selection, Consumer<Throwable> failed) {
        super(new BorderLayout());
        this.hint = hint;
        this.selection = selection;
        this.looks = new Latest("dronewatch-cameras", threads, failed);
        getAccessibleContext().setAccessibleName("cameras");
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                arrange();
                validate();
                show(time);
            }
        });
    }

    /** Shows the cameras of another run. */
    void show(ViewedRun run) {
        visuals.clear();
        enlarged = null;
        known = true;
        run.settings().enabledSensors().forEach((id, sensor) -> {
            if (sensor.as(PictureSettings.class).isPresent()) {
                visuals.add(visual(new CameraEye(
                        id, sensor, run.stage(), moment -> run.run().pointing(id, moment))));
            }
        });
        arrange();
    }

    private CameraVisual visual(CameraEye eye) {
        eye.showColour(colour);
        CameraVisual visual = new CameraVisual(eye);
        visual.onHint(hint);
        visual.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent e) {
                enlarge(enlarged == visual ? null : visual);
                selection.accept(visual.eye().id());
            }
        });
        return visual;
    }

    /** Enlarges the camera with a name, or shows all if there is none. */
    void enlarge(String id) {
        enlarge(visuals.stream()
                .filter(visual -> visual.eye().id().equals(id))
                .findFirst()
                .orElse(null));
    }

    private void enlarge(CameraVisual visual) {
        enlarged = visual;
        arrange();
        validate();
        show(time);
    }

    private void arrange() {
        removeAll();
        if (visuals.isEmpty() && known) {
            add(new JLabel("The scene has no camera.", SwingConstants.CENTER), BorderLayout.CENTER);
        } else if (enlarged != null) {
            add(enlarged, BorderLayout.CENTER);
        } else {
            JPanel grid = new JPanel(new GridLayout(0, columns(), GAP, GAP));
            visuals.forEach(grid::add);
            add(grid, BorderLayout.CENTER);
        }
        revalidate();
        repaint();
    }

    /** The number of columns that makes the images as large as possible. */
    private int columns() {
        int best = 1;
        double largest = 0.0;
        for (int columns = 1; columns <= visuals.size(); columns++) {
            int rows = (visuals.size() + columns - 1) / columns;
            double width = getWidth() / (double) columns;
            double height = getHeight() / (double) rows;
            double shown = 0.0;
            for (CameraVisual visual : visuals) {
                double aspect = visual.eye().settings().width()
                        / (double) visual.eye().settings().height();
                shown += Math.min(width, height * aspect);
            }
            if (shown > largest) {
                largest = shown;
                best = columns;
            }
        }
        return best;
    }

    /** Shows what cameras for visible light would photograph, or distances in blues. */
    void showColour(boolean shown) {
        colour = shown;
        visuals.forEach(visual -> visual.eye().showColour(shown));
        show(time);
    }

    /** The cameras that are shown now. */
    List<CameraVisual> shown() {
        return enlarged == null ? List.copyOf(visuals) : List.of(enlarged);
    }

    /** Shows another time. */
    void show(double next) {
        time = next;
        List<CameraVisual> wanted = shown();
        double density = Scaled.density(this);
        List<int[]> sizes = wanted.stream()
                .map(visual ->
                        new int[] {(int) (visual.frame().width * density), (int) (visual.frame().height * density)})
                .toList();
        // The picture is not abandoned: while time passes, a picture of a moment just past is better than none.
        looks.ask(outdated -> {
            for (int i = 0; i < wanted.size(); i++) {
                CameraVisual visual = wanted.get(i);
                CameraShot shot = visual.eye().look(next, sizes.get(i)[0], sizes.get(i)[1]);
                SwingUtilities.invokeLater(() -> visual.show(shot));
            }
        });
    }

    /**
     * Shows what each camera last measured, and which one is selected.
     *
     * @param readings returns what the camera with a given name measured of each drone
     */
    void mark(Function<String, Map<String, PairReading>> readings, String selected) {
        for (CameraVisual visual : visuals) {
            visual.mark(readings.apply(visual.eye().id()), visual.eye().id().equals(selected));
        }
    }

    /** Whether everything that was requested is drawn. */
    boolean isIdle() {
        return looks.isIdle();
    }

    /** Ends the thread that looks. */
    void close() {
        looks.close();
    }
}
