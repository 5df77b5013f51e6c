package org.dronewatch.scenario;

import java.nio.file.Path;
import java.util.regex.Pattern;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.SensorKinds;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.file.SettingsFile;

/** Writes settings as a scene file, whatever their source: Java, another file, overrides, one run of a sweep. */
public final class SceneWriter {
    /** The first line of every file written by this class. */
    public static final Pattern FIRST_LINE = Pattern.compile("# .*, as saved by dronewatch: .*");

    private SceneWriter() {}

    /**
     * An equivalent scene file. Sensors that were taken from a catalogue are written out in full.
     *
     * @param name name of the scene, for the first line
     * @param settings settings of the scene, or of one of its runs
     * @param from directory against which the relative names of its models are resolved
     * @param file the file into which the text will be written; the models must be in its directory or below it
     * @return the text, which has been read back and is equal to the settings
     * @throws org.dronewatch.setting.InputException when a setting cannot be written: a function, or a kind that no
     *     file can name
     */
    public static String text(String name, SceneSettings settings, Path from, Path file) {
        String text = SettingsFile.text(settings, SensorKinds.kinds(Catalog.packaged()), from, file);
        return "# " + PlainText.value(name)
                + ", as saved by dronewatch: positions are in metres, levels of octave bands in decibels.\n" + text;
    }
}
