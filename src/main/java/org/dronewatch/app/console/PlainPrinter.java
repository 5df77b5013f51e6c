package org.dronewatch.app.console;

import java.io.PrintWriter;
import java.io.Writer;
import java.util.Locale;
import org.dronewatch.setting.PlainText;

/**
 * Prints for terminals and scripts: no character in a name can control the terminal, and no locale can change a number.
 */
public final class PlainPrinter extends PrintWriter {

    public PlainPrinter(Writer target) {
        super(target, true);
    }

    @Override
    public void write(int c) {
        write(Character.toString(c));
    }

    @Override
    public void write(char[] text, int from, int length) {
        write(new String(text, from, length));
    }

    @Override
    public void write(String text, int from, int length) {
        String shown = PlainText.lines(text.substring(from, from + length));
        super.write(shown, 0, shown.length());
    }

    @Override
    public PrintWriter format(String pattern, Object... values) {
        return super.format(Locale.ROOT, pattern, values);
    }
}
