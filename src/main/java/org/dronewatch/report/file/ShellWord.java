package org.dronewatch.report.file;

import java.io.File;
import java.nio.file.Path;
import java.util.regex.Pattern;
import org.dronewatch.setting.PlainText;

/** Quotes arguments as they must be typed on a command line. */
public final class ShellWord {
    /** The backslash separates the names of a path on Windows; it is an escape character in other shells. */
    private static final boolean IS_WINDOWS = File.separatorChar == '\\';

    /** Some shells replace a word that begins with '=' by the path of a command. */
    private static final Pattern PLAIN = Pattern.compile("(?!=)[\\w./:=,%+" + (IS_WINDOWS ? "\\\\" : "") + "-]+");

    private ShellWord() {}

    /** The argument, in quotation marks if it contains characters that have a special meaning in some shells. */
    public static String of(String word) {
        String plain = PlainText.lines(word);
        if (PLAIN.matcher(plain).matches()) {
            return plain;
        }
        // Within double quotation marks, these still have a meaning for most shells, but not for that of Windows.
        boolean hasMeaning = !IS_WINDOWS && plain.matches("(?s).*[\"$`\\\\!].*");
        return hasMeaning ? "'" + plain.replace("'", "'\\''") + "'" : '"' + plain + '"';
    }

    /**
     * A path as it must be typed in the current directory, quoted if necessary: relative if it leads to this directory
     * or below it, otherwise as given.
     */
    public static String of(Path path) {
        Path here = Path.of("").toAbsolutePath().normalize();
        Path absolute = path.toAbsolutePath().normalize();
        if (absolute.equals(here)) {
            return ".";
        }
        String word = (absolute.startsWith(here) ? here.relativize(absolute) : path.normalize()).toString();
        // Commands take a word that begins with '-' for an option.
        return of(word.startsWith("-") ? Path.of(".", word).toString() : word);
    }
}
