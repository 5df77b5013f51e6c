package org.dronewatch.app.option;

import org.dronewatch.setting.PlainText;

/** A word as it is typed on a command line. */
public final class ShellWord {
    private ShellWord() {}

    /** The word, in quotation marks if it has characters that shells may take for something else. */
    public static String of(String word) {
        String plain = PlainText.lines(word);
        return plain.matches("[\\w./:=,%+\\\\-]+") ? plain : '"' + plain + '"';
    }
}
