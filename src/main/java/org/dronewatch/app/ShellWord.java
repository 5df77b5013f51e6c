package org.dronewatch.app;

import org.dronewatch.setting.PlainText;

/** A word as it is typed on a command line. */
final class ShellWord {
    private ShellWord() {}

    /** The word, in quotation marks if it has characters that shells may take for something else. */
    static String of(String word) {
        String plain = PlainText.lines(word);
        return plain.matches("[\\w./:=,%+\\\\-]+") ? plain : '"' + plain + '"';
    }
}
