package org.dronewatch.setting.file;

/**
 * A place in a file.
 *
 * @param file name of the file
 * @param line from 1
 * @param column from 1
 */
record Mark(String file, int line, int column) {
    @Override
    public String toString() {
        return file + ":" + line + ":" + column;
    }
}
