package org.dronewatch.viewer.settings;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.event.KeyEvent;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.DefaultCellEditor;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.UIManager;
import javax.swing.table.DefaultTableCellRenderer;
import org.dronewatch.viewer.coverage.CoverageForm;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.part.WrappedText;
import org.dronewatch.viewer.run.SensorLayout;

/**
 * The settings of the selected sensor, with their units and limits. They are edited in place; edits can be undone, and
 * the scene can be run again with them.
 */
public final class SettingsPanel extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int[] WIDTHS = {170, 130, 230};

    /** Text in red on light and on dark backgrounds, both with a contrast of at least 4.5. */
    private static final Color ON_LIGHT = new Color(0xb3261e);

    private static final Color ON_DARK = new Color(0xff9c94);
    private static final int DARKEST_OF_LIGHT = 128;

    private final JLabel heading = new JLabel();
    private final JTable table;
    private final JButton undo = new JButton("Undo");
    private final JButton redo = new JButton("Redo");
    private final JButton again = new JButton("Run again");
    private final JButton save = new JButton("Save scene as ...");
    private final WrappedText said = new WrappedText("last change to the setting");
    private final transient SensorLayout layout;
    private final transient SettingsModel model;
    private final transient Consumer<String> messages;
    private transient Optional<Runnable> running = Optional.empty();
    private transient Runnable saving = () -> {};

    /**
     * An empty panel.
     *
     * @param messages receives a line about each edit
     */
    public SettingsPanel(SensorLayout layout, Consumer<String> messages) {
        super(new BorderLayout());
        this.layout = layout;
        this.messages = messages;
        this.model = new SettingsModel(layout, this::tell);
        this.table = new JTable(model);
        setUpTable();
        said.setBorder(BorderFactory.createEmptyBorder(Scaled.px(2), Scaled.px(8), Scaled.px(2), Scaled.px(8)));
        add(CoverageForm.row(heading, undo, redo, again, save), BorderLayout.NORTH);
        add(new JScrollPane(table), BorderLayout.CENTER);
        add(said, BorderLayout.SOUTH);
        getAccessibleContext().setAccessibleName("settings");
        undo.setToolTipText("Undoes the last change to a sensor");
        redo.setToolTipText("Redoes the last change that was undone");
        again.setToolTipText("Runs the scene in this window with the sensors as they are now");
        save.setToolTipText("Writes a scene file with the sensors as they are now");
        undo.addActionListener(e -> layout.undo());
        redo.addActionListener(e -> layout.redo());
        again.addActionListener(e -> running.ifPresent(Runnable::run));
        save.addActionListener(e -> saving.run());
        layout.listen(this::update);
        update();
    }

    private void setUpTable() {
        table.getAccessibleContext().setAccessibleName("settings of the selected sensor");
        table.setDefaultEditor(Object.class, new DefaultCellEditor(CoverageForm.field("", 1)));
        table.setDefaultRenderer(Object.class, new Renderer());
        table.putClientProperty("terminateEditOnFocusLost", Boolean.TRUE);
        // Keys without modifiers belong to the menus: Enter begins to edit, and ends it.
        table.putClientProperty("JTable.autoStartsEdit", Boolean.FALSE);
        table.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                .put(KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0), "startEditing");
        table.setSurrendersFocusOnKeystroke(true);
        for (int i = 0; i < WIDTHS.length; i++) {
            table.getColumnModel().getColumn(i).setPreferredWidth(Scaled.px(WIDTHS[i]));
        }
    }

    /** Shows the texts of the table, which tooltips give in full; a refused value is red. */
    private final class Renderer extends DefaultTableCellRenderer {
        private static final long serialVersionUID = 1L;

        @Override
        public Component getTableCellRendererComponent(
                JTable owner, Object value, boolean isSelected, boolean hasFocus, int row, int column) {
            super.getTableCellRendererComponent(owner, value, isSelected, hasFocus, row, column);
            setToolTipText(String.valueOf(value));
            if (!isSelected) {
                setForeground(column > 0 && model.isRefused(row) ? red() : owner.getForeground());
            }
            return this;
        }
    }

    private static Color red() {
        Color background = UIManager.getColor("Table.background");
        return background != null && background.getGreen() < DARKEST_OF_LIGHT ? ON_DARK : ON_LIGHT;
    }

    /** Shows the settings of the sensor with this id; none if the id is null or not that of a sensor. */
    public void select(String id) {
        stopEditing();
        model.select(Optional.ofNullable(id));
        said.setText("");
        update();
    }

    private void stopEditing() {
        if (table.isEditing()) {
            table.getCellEditor().cancelCellEditing();
        }
    }

    /** Sets the action that saves the scene. */
    public void onSave(Runnable target) {
        saving = target;
    }

    /** Sets the action that runs the scene again. */
    public void onRun(Runnable target) {
        running = Optional.of(target);
        update();
    }

    /** Updates the panel to the current settings. */
    public void update() {
        model.update();
        heading.setText(model.sensor()
                .map(id -> "'" + id + "'")
                .orElse("Select a sensor: click on its symbol or on its row in the Sensors tab"));
        boolean isChanged = layout.isThere() && !layout.moved().isEmpty();
        undo.setEnabled(layout.isUndoable());
        redo.setEnabled(layout.isRedoable());
        again.setEnabled(running.isPresent() && isChanged);
        save.setEnabled(layout.isThere());
    }

    private void tell(String line) {
        said.setText(line + ".");
        messages.accept(line);
    }

    /** The table: setting, value, limits. */
    public JTable table() {
        return table;
    }

    /** The button that runs the scene again. */
    public JButton again() {
        return again;
    }

    /** The line about the last edit. */
    public String said() {
        return said.getText();
    }
}
