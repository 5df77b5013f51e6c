package org.dronewatch.viewer;

import java.awt.FlowLayout;
import java.awt.GridLayout;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;
import javax.swing.SwingUtilities;
import org.dronewatch.render.RayCollector;
import org.dronewatch.render.RayFilter;
import org.dronewatch.render.RecordedRays;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SoundTracing;
import org.dronewatch.setting.Counted;
import org.dronewatch.viewer.part.Latest;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.part.Texts;
import org.dronewatch.viewer.run.Playback;

/** Traces the sound rays to a microphone at the displayed time, counts them, and selects those to be drawn. */
final class RayPanel extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int HIGHEST_ORDER = 1000;

    private final JComboBox<String> sensors = new JComboBox<>();
    private final JComboBox<String> drones = new JComboBox<>();
    private final JButton trace = new JButton("Trace at displayed time");
    private final JButton clear = new JButton("Hide");
    private final JSpinner fewest = new JSpinner(new SpinnerNumberModel(0, 0, HIGHEST_ORDER, 1));
    private final JSpinner most = new JSpinner(new SpinnerNumberModel(HIGHEST_ORDER, 0, HIGHEST_ORDER, 1));
    private final JCheckBox heardOnly = new JCheckBox("only paths that reach the sensor", true);
    private final JLabel count = new JLabel(" ");
    private final transient Latest tracing;
    private final transient Playback playback;
    private final transient Consumer<RayFilter> filtered;
    private transient Consumer<Optional<RecordedRays>> traced = rays -> {};
    private transient Stage stage;
    private transient RecordedRays rays;
    private int drawn;

    /**
     * An empty panel.
     *
     * @param threads number of threads that trace rays
     * @param filtered receives the filter for the rays to be drawn
     * @param failed receives what went wrong
     */
    RayPanel(int threads, Playback playback, Consumer<RayFilter> filtered, Consumer<Throwable> failed) {
        super(new GridLayout(0, 1));
        this.playback = playback;
        this.filtered = filtered;
        this.tracing = new Latest("dronewatch-rays", threads, failed);
        trace.setToolTipText("Traces all sound rays from the drone to the sensor at the displayed time");
        heardOnly.setToolTipText("Hides rays that end elsewhere");
        fewest.setToolTipText("Minimum reflection order");
        most.setToolTipText("Maximum reflection order");
        add(row(new JLabel("Sound from"), drones, new JLabel("to"), sensors, trace, clear));
        add(row(new JLabel("Reflection order: min"), fewest, new JLabel("max"), most, heardOnly));
        add(row(count));
        trace.addActionListener(e -> trace());
        clear.addActionListener(e -> take(null));
        fewest.addChangeListener(e -> filter());
        most.addChangeListener(e -> filter());
        heardOnly.addActionListener(e -> filter());
        playback.listen(this::describe);
        getAccessibleContext().setAccessibleName("rays");
    }

    private static JPanel row(JComponent... parts) {
        JPanel row = new JPanel(new FlowLayout(FlowLayout.LEADING, Scaled.px(6), Scaled.px(4)));
        List.of(parts).forEach(row::add);
        return row;
    }

    /** Sets what receives the rays to draw. */
    void onTraced(Consumer<Optional<RecordedRays>> target) {
        traced = target;
    }

    /** Takes the sensors and drones of another run. */
    void show(SceneSettings settings, Stage next) {
        stage = next;
        sensors.setModel(new DefaultComboBoxModel<>(next.raySensors().toArray(String[]::new)));
        drones.setModel(
                new DefaultComboBoxModel<>(settings.individualDrones().keySet().toArray(String[]::new)));
        boolean possible = sensors.getItemCount() > 0 && drones.getItemCount() > 0;
        trace.setEnabled(possible);
        take(null);
        count.setText(
                possible ? "No rays have been traced yet." : "The scene has no drone, or no sensor that traces rays.");
        next.raySensors().stream()
                .filter(sensor -> settings.sensors()
                        .get(sensor)
                        .as(SoundTracing.class)
                        .filter(SoundTracing::drawRays)
                        .isPresent())
                .findFirst()
                .ifPresent(sensor -> {
                    sensors.setSelectedItem(sensor);
                    trace();
                });
    }

    /** Traces the rays of the selected pair at the displayed time. */
    void trace() {
        String sensor = (String) sensors.getSelectedItem();
        String drone = (String) drones.getSelectedItem();
        if (stage == null || sensor == null || drone == null) {
            return;
        }
        Stage tracedStage = stage;
        double time = playback.time();
        count.setText("Tracing ...");
        tracing.ask(outdated -> {
            RayCollector collector = new RayCollector(sensor, drone, time);
            tracedStage.traceRays(time, sensor, drone, collector);
            RecordedRays set = collector.toRays();
            SwingUtilities.invokeLater(() -> take(set));
        });
    }

    private void take(RecordedRays set) {
        rays = set;
        if (set == null) {
            count.setText("No rays are drawn.");
        }
        traced.accept(Optional.ofNullable(set));
        filter();
    }

    private void filter() {
        RayFilter filter = filter((int) fewest.getValue(), (int) most.getValue());
        drawn = rays == null ? 0 : filter.count(rays);
        describe();
        filtered.accept(filter);
    }

    /** States how many rays are drawn, for which time they were traced, and whether that is still the time shown. */
    private void describe() {
        if (rays == null) {
            return;
        }
        if (rays.count() == 0) {
            // A propagation model of another jar need not trace rays.
            count.setText("'" + rays.sensor() + "' traces no rays from '" + rays.drone() + "' at "
                    + Texts.time(rays.time()) + ".");
            return;
        }
        String more = rays.leftOut() == 0
                ? ""
                : "; " + Counted.of(rays.leftOut(), "more was discarded", "more were discarded");
        String text = String.format(
                Locale.ROOT,
                "Traced at %s: %,d of %,d ray segments drawn, highest order %d%s",
                Texts.time(rays.time()),
                drawn,
                rays.count(),
                rays.maxOrder(),
                more);
        boolean moved = Math.abs(playback.time() - rays.time()) >= 0.005;
        count.setText(moved ? text + ". The displayed time is now " + Texts.time(playback.time()) + "." : text);
    }

    private RayFilter filter(int from, int to) {
        return new RayFilter(from, to, heardOnly.isSelected());
    }

    /** Chooses whether only paths that reached the sensor are drawn. */
    void setHeardOnly(boolean only) {
        heardOnly.setSelected(only);
        filter();
    }

    /** A description of the rays traced and drawn. */
    String count() {
        return count.getText();
    }

    boolean isIdle() {
        return tracing.isIdle();
    }

    /** Ends the thread that traces. */
    void close() {
        tracing.close();
    }
}
