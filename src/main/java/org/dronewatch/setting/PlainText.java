package org.dronewatch.setting;

import java.util.List;
import java.util.Locale;

/**
 * Makes text from files and users safe for messages. The result cannot control a terminal or reorder the line: control
 * characters, line separators and marks that change the direction of the text are escaped, as in {@code \u001b}. A
 * value longer than {@value #LONGEST} characters is shortened in its middle.
 */
public final class PlainText {
    /** Maximum number of characters of a value repeated in a message. */
    public static final int LONGEST = 200;

    /** Maximum number of characters of a message; its end, which states the limit, is kept. */
    private static final int LONGEST_LINE = 600;

    private static final String GAP = "...";

    private PlainText() {}

    /** A value for a message: all characters are visible, and there are at most {@value #LONGEST} of them. */
    public static String value(Object value) {
        return shortened(visible(String.valueOf(value).strip(), false), LONGEST);
    }

    /**
     * The beginning of a text, followed by an ellipsis if it was cut; never splits a character.
     *
     * @param longest maximum number of characters, not counting the ellipsis
     */
    public static String beginning(String text, int longest) {
        if (text.length() <= longest) {
            return text;
        }
        int end = Character.isHighSurrogate(text.charAt(longest - 1)) ? longest - 1 : longest;
        return text.substring(0, end) + GAP;
    }

    /**
     * A message on one line: all characters are visible, with at most {@value #LONGEST} characters of every quoted
     * value and every word, and at most 600 in all. Line breaks and tabs become spaces.
     */
    public static String line(String message) {
        String visible = visible(message.strip(), false);
        return shortened(withShortWords(withShortQuotes(visible)), LONGEST_LINE);
    }

    /** A text of several lines: all characters are visible; line breaks and tabs are unchanged. */
    public static String lines(String text) {
        return visible(text, true);
    }

    /** Words as a list in a sentence, {@code a, b and c}; an empty text if there are no words. */
    public static String list(List<String> words) {
        int last = words.size() - 1;
        return last < 1
                ? String.join("", words)
                : String.join(", ", words.subList(0, last)) + " and " + words.get(last);
    }

    /** Whether a character could control a terminal, break a line or change the direction of the text. */
    private static boolean isHidden(int c) {
        return switch (Character.getType(c)) {
            case Character.CONTROL, Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR, Character.SURROGATE ->
                true;
            default ->
                c == 0x061C
                        || c == 0x200E
                        || c == 0x200F
                        || c >= 0x202A && c <= 0x202E
                        || c >= 0x2066 && c <= 0x2069
                        || c == 0xFEFF;
        };
    }

    private static boolean isBreak(int c) {
        return c >= '\t' && c <= '\r' || c == 0x85 || c == 0x2028 || c == 0x2029;
    }

    private static String visible(String text, boolean withBreaks) {
        if (text.codePoints().noneMatch(PlainText::isHidden)) {
            return text;
        }
        StringBuilder shown = new StringBuilder(text.length());
        for (int i = 0, c; i < text.length(); i += Character.charCount(c)) {
            c = text.codePointAt(i);
            if (!isHidden(c) || withBreaks && (c == '\n' || c == '\t' || text.startsWith("\r\n", i))) {
                shown.appendCodePoint(c);
            } else if (isBreak(c)) {
                // One space for the two characters of a Windows line break, and for blank lines.
                shown.append(shown.isEmpty() || shown.charAt(shown.length() - 1) == ' ' ? "" : " ");
            } else {
                shown.append(String.format(Locale.ROOT, "\\u%04x", c));
            }
        }
        return shown.toString();
    }

    /** Shortens text between single quotes; an apostrophe within a word is not a quote. */
    private static String withShortQuotes(String text) {
        StringBuilder shown = new StringBuilder(text.length());
        int done = 0;
        for (int open = opening(text, 0); open >= 0; open = opening(text, done)) {
            int close = closing(text, open + 1);
            if (close < 0) {
                break;
            }
            shown.append(text, done, open + 1).append(shortened(text.substring(open + 1, close), LONGEST));
            shown.append('\'');
            done = close + 1;
        }
        return shown.append(text.substring(done)).toString();
    }

    private static int opening(String text, int from) {
        for (int at = text.indexOf('\'', from); at >= 0; at = text.indexOf('\'', at + 1)) {
            if (at == 0 || !Character.isLetterOrDigit(text.charAt(at - 1))) {
                return at;
            }
        }
        return -1;
    }

    private static int closing(String text, int from) {
        for (int at = text.indexOf('\'', from); at >= 0; at = text.indexOf('\'', at + 1)) {
            if (at + 1 == text.length() || !Character.isLetterOrDigit(text.charAt(at + 1))) {
                return at;
            }
        }
        return -1;
    }

    private static String withShortWords(String text) {
        StringBuilder shown = new StringBuilder(text.length());
        int start = 0;
        while (start <= text.length()) {
            int end = text.indexOf(' ', start);
            end = end < 0 ? text.length() : end;
            shown.append(start == 0 ? "" : " ").append(shortened(text.substring(start, end), LONGEST));
            start = end + 1;
        }
        return shown.toString();
    }

    /** Leaves out the middle of what is too long; never half of a character. */
    private static String shortened(String text, int longest) {
        if (text.length() <= longest) {
            return text;
        }
        int tail = longest / 4;
        int head = longest - tail - GAP.length();
        int until = Character.isHighSurrogate(text.charAt(head - 1)) ? head - 1 : head;
        int from = text.length() - tail;
        from = Character.isLowSurrogate(text.charAt(from)) ? from + 1 : from;
        return text.substring(0, until) + GAP + text.substring(from);
    }
}
