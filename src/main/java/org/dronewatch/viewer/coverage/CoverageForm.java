package org.dronewatch.viewer.coverage;

import java.awt.FlowLayout;
import java.awt.GridLayout;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldHeading;
import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingText;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.part.Texts;
import org.dronewatch.world.World;

/**
 * A form for the inputs of a coverage, with the defaults of the {@code coverage} command, except where all sensors are
 * under a roof and the site is smaller than the default area: the side is then that of the site, and the heights are
 * below the ceiling.
 */
public final class CoverageForm extends JPanel {
    private static final long serialVersionUID = 1L;

    private final JComboBox<String> drones = new JComboBox<>();
    private final JComboBox<String> headings = new JComboBox<>();
    private final JTextField heights = field(text(CoverageProposal.OUTDOORS.heights()), 10);
    private final JTextField side = field(Texts.value(CoverageProposal.OUTDOORS.side()), 3);
    private final JTextField cell = field("", 5);
    private transient CoverageProposal proposed = CoverageProposal.OUTDOORS;
    private transient SceneSettings settings;

    /** What was chosen. */
    record Inputs(String drone, FieldHeading heading, FieldGrid grid) {}

    /**
     * An empty form.
     *
     * @param button button that starts the computation
     * @param entered called when the user presses Enter in a field
     */
    CoverageForm(JButton button, Runnable entered) {
        super(new GridLayout(0, 1));
        for (FieldHeading heading : FieldHeading.values()) {
            headings.addItem(heading.word());
        }
        cell.putClientProperty("JTextField.placeholderText", "side / 100");
        add(row(
                named("Drone", drones, "The drone that is placed in every cell"),
                drones,
                named(
                        "Heading",
                        headings,
                        "The heading on which the sensors are least or most likely to detect the drone, or the one"
                                + " towards the protected zone (towards the sensors if there is no zone)"),
                headings,
                button));
        add(row(
                named("Heights (m)", heights, "Heights above the ground, in ascending order"),
                heights,
                named("Side (m)", side, "Length of a side of the area, which is centred on the sensors"),
                side,
                named("Cell (m)", cell, "Length of a cell's side; if left empty, a hundredth of the area's side"),
                cell));
        List.of(heights, side, cell).forEach(field -> field.addActionListener(e -> entered.run()));
    }

    /** A label for an input; the explanation becomes the tooltip of the input. */
    public static JLabel named(String name, JComponent part, String explanation) {
        JLabel label = new JLabel(name);
        label.setLabelFor(part);
        part.setToolTipText(explanation);
        return label;
    }

    /** Components side by side, from the left. */
    public static JPanel row(JComponent... parts) {
        JPanel row = new JPanel(new FlowLayout(FlowLayout.LEADING, Scaled.px(5), Scaled.px(2)));
        List.of(parts).forEach(row::add);
        return row;
    }

    /** A text field of a number of columns; keys typed without modifiers do not trigger menu items. */
    public static JTextField field(String text, int columns) {
        JTextField field = new JTextField(text, columns);
        // Keys without modifiers belong to the menus, except while the user is typing.
        field.addKeyListener(new KeyAdapter() {
            @Override
            public void keyPressed(KeyEvent e) {
                boolean isTyped = e.getKeyChar() != KeyEvent.CHAR_UNDEFINED && !Character.isISOControl(e.getKeyChar());
                if (isTyped && !e.isControlDown() && !e.isMetaDown() && !e.isAltDown()) {
                    e.consume();
                }
            }
        });
        return field;
    }

    private static String text(List<Double> heights) {
        return heights.stream().map(Texts::value).collect(Collectors.joining(", "));
    }

    /** Offers the drones of a scene, and proposes heights and a side unless the user has entered others. */
    void show(SceneSettings next, World world) {
        settings = next;
        CoverageProposal better = CoverageProposal.of(next, world);
        if (heights.getText().equals(text(proposed.heights())) && side.getText().equals(Texts.value(proposed.side()))) {
            heights.setText(text(better.heights()));
            side.setText(Texts.value(better.side()));
            proposed = better;
        }
        drones.setModel(
                new DefaultComboBoxModel<>(next.individualDrones().keySet().toArray(String[]::new)));
        FieldRequest.firstDrone(next).ifPresent(drones::setSelectedItem);
    }

    /** Whether there is anything to compute. */
    boolean isPossible() {
        return settings != null
                && drones.getItemCount() > 0
                && !settings.enabledSensors().isEmpty();
    }

    /**
     * What the user has chosen.
     *
     * @throws InputException when a value is not possible, with its name, the value and the limit
     */
    Inputs inputs() {
        double length = length("side", side.getText());
        double edge = cell.getText().isBlank() ? length / FieldGrid.DEFAULT_CELLS : length("cell", cell.getText());
        Position middle = InboundTarget.sensors(settings);
        try {
            return new Inputs(
                    (String) drones.getSelectedItem(),
                    FieldHeading.values()[headings.getSelectedIndex()],
                    FieldGrid.square(middle.x(), middle.y(), length, edge, heights()));
        } catch (IllegalArgumentException e) {
            throw new InputException(e.getMessage(), e);
        }
    }

    private static double length(String name, String text) {
        RecordComponent part = SettingsForm.of(FieldGrid.class).part(name).orElseThrow();
        try {
            Object value = SettingText.parse(part, text.strip());
            Limits.check(part, value);
            return (double) value;
        } catch (IllegalArgumentException e) {
            throw new InputException(name + " " + PlainText.value(text) + ": " + e.getMessage(), e);
        }
    }

    private List<Double> heights() {
        List<Double> parsed = new ArrayList<>();
        for (String one : heights.getText().split(",", -1)) {
            try {
                parsed.add(Quantity.LENGTH.parse(one.strip()));
            } catch (IllegalArgumentException e) {
                throw new InputException("height " + PlainText.value(one.strip()) + ": " + e.getMessage(), e);
            }
        }
        return parsed;
    }

    /** Replaces the texts in the fields for the heights, the side of the area and the side of a cell. */
    public void set(String newHeights, String newSide, String newCell) {
        heights.setText(newHeights);
        side.setText(newSide);
        cell.setText(newCell);
    }

    /** Chooses a heading. */
    void setHeading(FieldHeading heading) {
        headings.setSelectedIndex(heading.ordinal());
    }

    @Override
    public void setEnabled(boolean enabled) {
        super.setEnabled(enabled);
        List.of(drones, headings, heights, side, cell).forEach(part -> part.setEnabled(enabled));
    }
}
