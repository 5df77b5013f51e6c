package org.dronewatch.viewer;

import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.run.ViewedRun;

/** The tables of a run: one of each sensor with each drone, and one of the drones. A click on a row selects. */
final class RunTablesPanel {
    private static final int[] PAIR_COLUMNS = {100, 57, 79, 60, 58, 72, 70};

    private final PairTable pairs = new PairTable();
    private final DroneTable drones = new DroneTable();
    private final Consumer<String> selection;

    /** Empty tables that report which sensor or drone was clicked on. */
    RunTablesPanel(Consumer<String> selection) {
        this.selection = selection;
    }

    /** The table of sensors with drones. */
    JScrollPane sensors() {
        JTable table = new JTable(pairs);
        table.setAutoCreateRowSorter(true);
        for (int i = 0; i < PAIR_COLUMNS.length; i++) {
            table.getColumnModel().getColumn(i).setPreferredWidth(Scaled.px(PAIR_COLUMNS[i]));
        }
        table.setDefaultRenderer(Object.class, new DetectionRenderer(pairs));
        return prepared(table, "sensors", () -> pairs.sensor(table.convertRowIndexToModel(table.getSelectedRow())));
    }

    /** The table of drones. */
    JScrollPane drones() {
        JTable table = new JTable(drones);
        return prepared(table, "drones", () -> drones.drone(table.getSelectedRow()));
    }

    private JScrollPane prepared(JTable table, String name, Supplier<String> chosen) {
        table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        table.getAccessibleContext().setAccessibleName(name);
        table.getSelectionModel().addListSelectionListener(e -> {
            if (!e.getValueIsAdjusting() && table.getSelectedRow() >= 0) {
                selection.accept(chosen.get());
            }
        });
        return new JScrollPane(table);
    }

    /** Shows a run at a given time. */
    void show(ViewedRun viewed, double time) {
        pairs.show(viewed.run(), time);
        drones.show(viewed.run(), viewed.stage().dronesAt(time), time);
    }
}
