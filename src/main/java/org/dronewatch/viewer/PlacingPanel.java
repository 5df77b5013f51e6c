package org.dronewatch.viewer;

import java.awt.BorderLayout;
import java.awt.GridLayout;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.JTextField;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.coverage.table.MoveWords;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Aim;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Quantity;
import org.dronewatch.viewer.coverage.CoverageForm;
import org.dronewatch.viewer.coverage.CoveragePanel;
import org.dronewatch.viewer.coverage.CoverageSkinning;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.part.WrappedText;
import org.dronewatch.viewer.run.SensorLayout;
import org.dronewatch.viewer.run.ViewedRun;

/**
 * Places one sensor by numbers: the point over which it stands, its height above the surface there, and where it
 * points.
 */
final class PlacingPanel extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final String DEGREES = " deg";

    private final JComboBox<String> sensors = new JComboBox<>();
    private final JTextField east = CoverageForm.field("", 6);
    private final JTextField north = CoverageForm.field("", 6);
    private final JTextField above = CoverageForm.field("", 5);
    private final JTextField azimuth = CoverageForm.field("", 5);
    private final JTextField tilt = CoverageForm.field("", 5);
    private final JButton undo = new JButton("Undo");
    private final JButton redo = new JButton("Redo");
    private final JButton reset = new JButton("Reset all");
    private final JButton save = new JButton("Save scene as ...");
    private final WrappedText said = new WrappedText("last change to the sensor");
    private final WrappedText covered = new WrappedText("current coverage");
    private final transient SensorLayout layout;
    private final transient SensorMover mover;
    private final transient CoveragePanel coverage;
    private transient Consumer<String> messages = line -> {};
    private transient Runnable saving = () -> {};
    private transient BooleanSupplier mayLeave = () -> true;
    private boolean isUpdating;

    /**
     * An empty panel.
     *
     * @param coverage shows what the sensors cover
     * @param selection receives the sensor that is chosen
     */
    PlacingPanel(SensorLayout layout, CoveragePanel coverage, Consumer<String> selection) {
        super(new BorderLayout());
        this.layout = layout;
        this.coverage = coverage;
        this.mover = new SensorMover(layout, this::tell);
        JPanel rows = new JPanel(new GridLayout(0, 1));
        rows.add(CoverageForm.row(
                CoverageForm.named("Sensor", sensors, "The sensor to be placed"), sensors, undo, redo, reset));
        rows.add(CoverageForm.row(
                CoverageForm.named("East (m)", east, "Distance east of the origin"),
                east,
                CoverageForm.named("North (m)", north, "Distance north of the origin"),
                north,
                CoverageForm.named("Above (m)", above, "Height above the ground, floor or roof below the sensor"),
                above));
        rows.add(CoverageForm.row(
                CoverageForm.named("Azimuth (deg)", azimuth, "Direction of the axis, clockwise from north"),
                azimuth,
                CoverageForm.named("Tilt (deg)", tilt, "Angle of the axis above the horizon, negative below it"),
                tilt,
                save));
        JPanel texts = new JPanel(new BorderLayout(0, Scaled.px(4)));
        texts.setBorder(BorderFactory.createEmptyBorder(Scaled.px(4), Scaled.px(8), 0, Scaled.px(8)));
        texts.add(said, BorderLayout.NORTH);
        texts.add(covered, BorderLayout.CENTER);
        add(rows, BorderLayout.NORTH);
        add(texts, BorderLayout.CENTER);
        getAccessibleContext().setAccessibleName("placing");
        listen(selection);
        update();
    }

    private void listen(Consumer<String> selection) {
        undo.setToolTipText("Undoes the last change to a sensor");
        redo.setToolTipText("Redoes the last change that was undone");
        reset.setToolTipText("Undoes all changes to sensors; Undo brings them back");
        save.setToolTipText("Writes a scene file with the sensors as they are now");
        undo.addActionListener(e -> undo());
        redo.addActionListener(e -> redo());
        reset.addActionListener(e -> layout.reset());
        save.addActionListener(e -> saving.run());
        sensors.addActionListener(e -> {
            if (!isUpdating) {
                selection.accept((String) sensors.getSelectedItem());
            }
        });
        List.of(east, north, above).forEach(field -> field.addActionListener(e -> place()));
        List.of(azimuth, tilt).forEach(field -> field.addActionListener(e -> aim()));
        layout.listen(this::update);
        coverage.onShown(this::updateCovered);
    }

    /** Takes the sensors of another run. */
    void show(ViewedRun next) {
        mover.show(next.settings(), next.stage().world());
        isUpdating = true;
        sensors.setModel(
                new DefaultComboBoxModel<>(next.settings().sensors().keySet().toArray(String[]::new)));
        isUpdating = false;
        said.setText(sensors.getItemCount() == 0 ? "The scene has no sensor." : "");
        update();
    }

    /** Sets what receives a line about each move. */
    void onTold(Consumer<String> target) {
        messages = target;
    }

    /** Sets what saves the scene. */
    void onSave(Runnable target) {
        saving = target;
    }

    private void tell(String line) {
        said.setText(line + ".");
        messages.accept(line);
    }

    /** Selects a sensor, or something else; null for nothing. */
    void select(String id) {
        mover.select(id);
        update();
        mover.selected().ifPresent(sensor -> said.setText(mover.movable().isEmpty() ? mover.obstacle() + "." : ""));
    }

    private void update() {
        isUpdating = true;
        sensors.setSelectedItem(mover.selected().orElse(null));
        isUpdating = false;
        Optional<Position> at = mover.movable().map(sensor -> sensor.position());
        east.setText(at.map(place -> metres(place.x())).orElse(""));
        north.setText(at.map(place -> metres(place.y())).orElse(""));
        above.setText(at.map(place -> metres(mover.above())).orElse(""));
        Optional<Aim.Direction> direction = mover.direction();
        azimuth.setText(
                direction.map(to -> degrees(SensorMover.degrees(to.azimuth()))).orElse(""));
        tilt.setText(
                direction.map(to -> degrees(Math.toDegrees(to.elevation()))).orElse(""));
        List.of(east, north, above).forEach(field -> field.setEnabled(at.isPresent()));
        List.of(azimuth, tilt).forEach(field -> field.setEnabled(direction.isPresent()));
        boolean isMoved = layout.isThere() && !layout.moved().isEmpty();
        reset.setEnabled(isMoved);
        undo.setEnabled(layout.isUndoable());
        redo.setEnabled(layout.isRedoable());
        save.setEnabled(layout.isThere());
        updateCovered();
    }

    private static String metres(double value) {
        return Quantity.LENGTH.inBrief(Math.rint(100.0 * value) / 100.0);
    }

    private static String degrees(double value) {
        return String.format(Locale.ROOT, "%.1f", value).replaceFirst("\\.0$", "");
    }

    private void updateCovered() {
        boolean isMoved = layout.isThere() && !layout.moved().isEmpty();
        covered.setText(coverage.shown()
                .map(CoverageSkinning.Shown::words)
                .orElse(isMoved ? "Compute the coverage (Ctrl+Shift+K) to see what the sensors cover." : ""));
    }

    /** What the title of the site says about sensors that were moved. */
    String note() {
        String fineness = coverage.shown()
                .flatMap(CoverageSkinning.Shown::fineness)
                .filter(its -> its != MoveWords.Fineness.COMPLETE)
                .map(its -> ", " + its.word() + " coverage")
                .orElse("");
        return ": sensors changed" + fineness;
    }

    private void place() {
        try {
            mover.place(
                    parsed("east", east, Quantity.LENGTH, ""),
                    parsed("north", north, Quantity.LENGTH, ""),
                    parsed("above", above, Quantity.LENGTH, ""));
        } catch (IllegalArgumentException e) {
            tell(e.getMessage());
        }
    }

    private void aim() {
        try {
            mover.aim(
                    parsed("azimuth", azimuth, Quantity.ANGLE, DEGREES), parsed("tilt", tilt, Quantity.ANGLE, DEGREES));
        } catch (IllegalArgumentException e) {
            tell(e.getMessage());
        }
    }

    private static double parsed(String name, JTextField field, Quantity quantity, String unit) {
        String text = field.getText().strip();
        boolean isBare = text.matches("[-+.\\d]+");
        try {
            return quantity.parse(isBare ? text + unit : text);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(name + " " + PlainText.value(text) + ": " + e.getMessage(), e);
        }
    }

    /** Undoes the last move. */
    void undo() {
        tell(layout.undo() ? "The last change was undone" : "There is no change to undo");
    }

    /** Redoes the move undone last. */
    void redo() {
        tell(layout.redo() ? "The change was redone" : "There is no change to redo");
    }

    /** The settings of the displayed run, with its sensors as the user has placed them; null before there is a run. */
    SceneSettings settings() {
        return layout.settings();
    }

    SensorMover mover() {
        return mover;
    }

    /** Where the user has put the sensors. */
    SensorLayout layoutOfSensors() {
        return layout;
    }

    /** Sets the condition on which another scene or run, which has none of the moves, may be shown. */
    void onLeaving(BooleanSupplier decision) {
        mayLeave = decision;
    }

    /** Whether another scene or run may be shown. */
    boolean mayLeave() {
        return mayLeave.getAsBoolean();
    }

    /** The line about the last move. */
    String said() {
        return said.getText();
    }

    /** The text about what is covered. */
    String covered() {
        return covered.getText();
    }
}
