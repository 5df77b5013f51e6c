package org.dronewatch.report.file;

import java.io.File;
import java.nio.file.Path;
import org.dronewatch.setting.PlainText;

/** A word as it is typed on a command line. */
public final class ShellWord {
    private ShellWord() {}

    /** The word, in quotation marks if it has characters that shells may take for something else. */
    public static String of(String word) {
        String plain = PlainText.lines(word);
        if (plain.matches("[\\w./:=,%+\\\\-]+")) {
            return plain;
        }
        // Within double quotation marks, these still have a meaning for most shells, but not for that of Windows.
        boolean hasMeaning = File.separatorChar == '/' && plain.matches("(?s).*[\"$`\\\\!].*");
        return hasMeaning ? "'" + plain.replace("'", "'\\''") + "'" : '"' + plain + '"';
    }

    /** A path as it is typed in the current directory: relative to it if it leads to it or below it. */
    public static String of(Path path) {
        Path here = Path.of("").toAbsolutePath().normalize();
        Path absolute = path.toAbsolutePath().normalize();
        if (absolute.equals(here)) {
            return ".";
        }
        return of((absolute.startsWith(here) ? here.relativize(absolute) : path.normalize()).toString());
    }
}
