package org.dronewatch.viewer.settings;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.SettingsPath;
import org.dronewatch.viewer.part.TitledTable;
import org.dronewatch.viewer.run.SensorLayout;

/**
 * The settings of the selected sensor with their values and limits. A value that does not fit is refused, with the
 * reason beside it, and changes nothing. For the event thread.
 */
final class SettingsModel extends TitledTable {
    static final int VALUE = 1;
    static final int LIMITS = 2;

    private static final long serialVersionUID = 1L;

    private final transient SensorLayout layout;
    private final transient Consumer<String> messages;
    private final transient Map<String, Refusal> refused = new HashMap<>();
    private transient Optional<String> selected = Optional.empty();
    private transient List<SettingRow> rows = List.of();

    private record Refusal(String text, String reason) {}

    /**
     * No settings.
     *
     * @param messages receives a line about each edit
     */
    SettingsModel(SensorLayout layout, Consumer<String> messages) {
        super("setting", "value", "limits");
        this.layout = layout;
        this.messages = messages;
    }

    /** Shows the settings of a sensor; of none for the name of anything else. */
    void select(Optional<String> id) {
        refused.clear();
        selected = id;
        update();
    }

    /** The sensor whose settings are shown. */
    Optional<String> sensor() {
        return selected.filter(
                id -> layout.isThere() && layout.settings().sensors().get(id) instanceof Record);
    }

    /** Takes the settings as they are now. */
    void update() {
        List<SettingRow> now = sensor().map(
                        id -> SettingRow.of((Record) layout.settings().sensors().get(id)))
                .orElse(List.of());
        boolean isSame = now.stream()
                .map(SettingRow::path)
                .toList()
                .equals(rows.stream().map(SettingRow::path).toList());
        rows = now;
        // The selected row stays selected while the same settings are shown.
        if (isSame && !rows.isEmpty()) {
            fireTableRowsUpdated(0, rows.size() - 1);
        } else {
            fireTableDataChanged();
        }
    }

    /** Whether the last value typed into a row was refused. */
    boolean isRefused(int row) {
        return refused.containsKey(rows.get(row).path());
    }

    @Override
    public int getRowCount() {
        return rows.size();
    }

    @Override
    public boolean isCellEditable(int row, int column) {
        return column == VALUE;
    }

    @Override
    public Object getValueAt(int number, int column) {
        SettingRow row = rows.get(number);
        Optional<Refusal> refusal = Optional.ofNullable(refused.get(row.path()));
        return switch (column) {
            case 0 -> row.path();
            case VALUE -> refusal.map(Refusal::text).orElse(row.value());
            default -> refusal.map(Refusal::reason).orElse(row.allowed());
        };
    }

    @Override
    public void setValueAt(Object value, int number, int column) {
        SettingRow row = rows.get(number);
        String text = String.valueOf(value);
        if (text.equals(getValueAt(number, VALUE))) {
            return;
        }
        refused.remove(row.path());
        if (!text.strip().equals(row.value())) {
            write(row, text);
        }
        update();
    }

    private void write(SettingRow row, String text) {
        String id = sensor().orElseThrow();
        SensorSettings<?> before = layout.settings().sensors().get(id);
        String typed = row.withUnit(text);
        try {
            SensorSettings<?> after = new SettingsPath(row.path()).write(before, typed);
            if (!after.equals(before)) {
                layout.remember();
                layout.set(id, after);
                messages.accept("'" + id + "': " + row.path() + " is now " + typed + " instead of " + row.value()
                        + "; the displayed run does not include this change");
            }
        } catch (InputException | IllegalArgumentException e) {
            String reason = e.getMessage().replace(row.path() + "=" + typed + ": ", "");
            refused.put(row.path(), new Refusal(text, reason));
            messages.accept("'" + id + "': " + reason);
        }
    }
}
