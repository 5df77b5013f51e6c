package org.dronewatch.sound;

import java.util.Set;

/** The library's acoustic media, each with its source. */
public final class Media {
    private static final CsvTable<Medium> TABLE = new CsvTable<>(
            "media.csv",
            "medium",
            row -> new Medium(
                    row.getField("name"),
                    Double.parseDouble(row.getField("density")),
                    Double.parseDouble(row.getField("speed")),
                    row.getField("source")));

    private Media() {}

    /** The names, in the order of the table. */
    public static Set<String> names() {
        return TABLE.names();
    }

    /**
     * The medium with this name.
     *
     * @throws org.dronewatch.setting.InputException when there is none; its message names the closest matches
     */
    public static Medium get(String name) {
        return TABLE.get(name);
    }
}
