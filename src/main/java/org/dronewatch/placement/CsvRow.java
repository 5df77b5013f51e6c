package org.dronewatch.placement;

import java.util.List;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/** One record of a CSV file: values by the names of their columns. */
final class CsvRow {
    private final String location;
    private final List<String> columns;
    private final List<String> values;

    CsvRow(String location, List<String> columns, List<String> values) {
        this.location = location;
        this.columns = columns;
        this.values = values;
    }

    /** A value; empty where the file has no such column. */
    String text(String column) {
        int at = columns.indexOf(column);
        return at < 0 ? "" : values.get(at);
    }

    /** A value that must not be empty. */
    String name(String column) {
        String text = text(column);
        if (text.isEmpty()) {
            throw fault(column, "is empty");
        }
        return text;
    }

    /** A number of 0 or more. */
    double number(String column, double otherwise) {
        String text = text(column);
        if (text.isEmpty()) {
            return otherwise;
        }
        try {
            double number = Double.parseDouble(text);
            if (number >= 0.0 && !Double.isInfinite(number)) {
                return number;
            }
        } catch (NumberFormatException e) {
            throw new InputException(message(column, "must be a number of 0 or more"), e);
        }
        throw fault(column, "must be a number of 0 or more");
    }

    /** Yes or no; no if it is empty. */
    boolean isTrue(String column) {
        String text = text(column);
        if (!List.of("", "true", "false").contains(text)) {
            throw fault(column, "must be true or false");
        }
        return text.equals("true");
    }

    /** What is wrong with a value, with its location in the file. */
    InputException fault(String column, String problem) {
        return new InputException(message(column, problem));
    }

    private String message(String column, String problem) {
        String text = text(column);
        return location + ": " + column + (text.isEmpty() ? " " : " '" + PlainText.value(text) + "': ") + problem;
    }
}
