package org.dronewatch.setting;

import java.util.Locale;

/** Numbers of things in messages and reports, where number and noun agree: {@code 1 sensor}, {@code 1,200 sensors}. */
public final class Counted {
    private Counted() {}

    /** A number of things whose plural ends in s, such as {@code 3 sensors}. */
    public static String of(long count, String noun) {
        return of(count, noun, noun + "s");
    }

    /** A number followed by the singular for 1, otherwise by the plural. */
    public static String of(long count, String singular, String plural) {
        return String.format(Locale.ROOT, "%,d %s", count, count == 1 ? singular : plural);
    }
}
