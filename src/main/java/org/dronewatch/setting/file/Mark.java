package org.dronewatch.setting.file;

import java.util.Comparator;

/**
 * A location in a file.
 *
 * @param file name of the file
 * @param line number of the line, from 1
 * @param column number of the column, from 1
 */
public record Mark(String file, int line, int column) implements Comparable<Mark> {
    private static final Comparator<Mark> ORDER =
            Comparator.comparing(Mark::file).thenComparing(Mark::line).thenComparing(Mark::column);

    @Override
    public int compareTo(Mark other) {
        return ORDER.compare(this, other);
    }

    @Override
    public String toString() {
        return file + ":" + line + ":" + column;
    }
}
