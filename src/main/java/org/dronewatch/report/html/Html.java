package org.dronewatch.report.html;

import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Builds pieces of a page in well-formed mark-up; plain text is escaped. */
public final class Html {
    private static final int LONGEST_NAME = 16;

    /** A number with its unit, {@code 61.2 s}. */
    private static final Pattern MEASURED = Pattern.compile("[-<]? ?[0-9][0-9.,]* \\S{1,5}");

    private Html() {}

    /** Plain text, escaped so that nothing in it is read as mark-up. */
    public static String text(String plain) {
        return plain.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /** An element that contains mark-up. */
    public static String element(String name, String inside) {
        return "<" + name + ">" + inside + "</" + name + ">\n";
    }

    /** A heading or a paragraph of plain text. */
    public static String plain(String name, String text) {
        return element(name, text(text));
    }

    /** A table of plain texts. */
    public static String table(List<String> head, List<List<String>> rows) {
        String body = rows.stream().map(row -> element("tr", cells("td", row))).collect(Collectors.joining());
        String table = element("table", element("thead", element("tr", cells("th", head))) + element("tbody", body));
        return "<div class=\"wide\">" + table + "</div>\n";
    }

    /** A table of two columns without a header row: names, and a text for each. */
    public static String definitions(Map<String, String> texts) {
        StringBuilder rows = new StringBuilder();
        texts.forEach((name, text) ->
                rows.append(element("tr", "<td>" + text(name) + "</td><td class=\"hash\">" + text(text) + "</td>")));
        return "<div class=\"wide\">" + element("table", element("tbody", rows.toString())) + "</div>\n";
    }

    /** A section that a reader can expand; a printout always shows its contents. */
    public static String fold(String summary, String inside, boolean open) {
        return "<details" + (open ? " open=\"open\"" : "") + ">\n<summary>" + text(summary) + "</summary>\n" + inside
                + "</details>\n";
    }

    private static String cells(String name, List<String> texts) {
        return texts.stream()
                .map(text -> "<" + name + styled(text) + ">" + text(text) + "</" + name + ">")
                .collect(Collectors.joining());
    }

    private static String styled(String text) {
        boolean longWord = Stream.of(text.split("[ -]")).anyMatch(word -> word.length() > LONGEST_NAME);
        return isName(text) || MEASURED.matcher(text).matches() ? " class=\"n\"" : longWord ? " class=\"long\"" : "";
    }

    /** Whether a text is to stay on one line, which could otherwise be broken at a hyphen. */
    private static boolean isName(String text) {
        return text.contains("-") && !text.contains(" ") && text.length() <= LONGEST_NAME;
    }

    /** A picture embedded in the page, with its caption. */
    public static String figure(byte[] png, String caption) {
        String data = Base64.getEncoder().encodeToString(png);
        return "<figure><img alt=\"" + text(caption) + "\" src=\"data:image/png;base64," + data + "\"/>"
                + "<figcaption>" + text(caption) + "</figcaption></figure>\n";
    }
}
