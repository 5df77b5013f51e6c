package org.dronewatch.viewer;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Color;
import java.awt.Component;
import javax.swing.JTable;
import javax.swing.table.DefaultTableCellRenderer;

/** Gives an amber background to the rows of pairs in which the sensor detects the drone. */
final class DetectionRenderer extends DefaultTableCellRenderer {
    private static final long serialVersionUID = 1L;
    private static final Color DETECTS = new Color(255, 190, 40, 90);

    private final transient PairTable pairs;

    DetectionRenderer(PairTable pairs) {
        this.pairs = pairs;
    }

    @Override
    public Component getTableCellRendererComponent(
            JTable table, Object value, boolean isSelected, boolean hasFocus, int row, int column) {
        Component cell = super.getTableCellRendererComponent(table, value, isSelected, false, row, column);
        // Names of kinds from other jars may be long.
        boolean cut = cell.getPreferredSize().width
                > table.getColumnModel().getColumn(column).getWidth();
        setToolTipText(cut ? String.valueOf(value) : null);
        boolean detects = pairs.isDetected(table.convertRowIndexToModel(row));
        if (!isSelected) {
            cell.setBackground(detects ? mixed(table.getBackground()) : table.getBackground());
        }
        return cell;
    }

    private static Color mixed(Color below) {
        // Light text needs a darker background.
        double share = (FlatLaf.isLafDark() ? 0.5 : 1.0) * DETECTS.getAlpha() / 255.0;
        return new Color(
                (int) (below.getRed() + share * (DETECTS.getRed() - below.getRed())),
                (int) (below.getGreen() + share * (DETECTS.getGreen() - below.getGreen())),
                (int) (below.getBlue() + share * (DETECTS.getBlue() - below.getBlue())));
    }
}
