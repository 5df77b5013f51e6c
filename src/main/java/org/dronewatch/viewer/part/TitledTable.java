package org.dronewatch.viewer.part;

import javax.swing.table.AbstractTableModel;

/** A table whose columns have titles. For the event thread. */
public abstract class TitledTable extends AbstractTableModel {
    private static final long serialVersionUID = 1L;

    private final String[] titles;

    /**
     * A table.
     *
     * @param titles titles of the columns
     */
    protected TitledTable(String... titles) {
        this.titles = titles.clone();
    }

    @Override
    public final int getColumnCount() {
        return titles.length;
    }

    @Override
    public final String getColumnName(int column) {
        return titles[column];
    }
}
