package org.dronewatch.report.html;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;

/**
 * A self-contained HTML file for a browser or for printing, which is also well-formed XML; it loads no external
 * resources.
 */
public final class Page {
    /**
     * Expands every section for printing and collapses it again afterwards; without scripts, the style sheet does it.
     */
    private static final String FOR_PRINT = " onbeforeprint=\"document.querySelectorAll('details:not([open])')"
            + ".forEach(function(d){d.open=true;d.dataset.shut='';})\""
            + " onafterprint=\"document.querySelectorAll('details[data-shut]')"
            + ".forEach(function(d){d.open=false;delete d.dataset.shut;})\"";

    private final Writer writer;

    /**
     * Begins a page.
     *
     * @param target receives the bytes of the page, in UTF-8; it is not closed
     * @param title title of the window
     * @param heading the first line of the page
     */
    public Page(OutputStream target, String title, String heading) throws IOException {
        this.writer = new BufferedWriter(new OutputStreamWriter(target, StandardCharsets.UTF_8));
        writer.append("<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n")
                .append("<meta charset=\"utf-8\"/>\n")
                .append("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n")
                .append(Html.plain("title", title))
                .append(Html.element("style", style()))
                .append("</head>\n<body" + FOR_PRINT + ">\n")
                .append(Html.plain("h1", heading));
    }

    private static String style() throws IOException {
        try (InputStream in = Page.class.getResourceAsStream("report.css")) {
            if (in == null) {
                throw new IllegalStateException("resource report.css is missing");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).replace("\r\n", "\n");
        }
    }

    /** Adds the result: a few sentences of plain text, set off from the rest. */
    public void verdict(String sentences) throws IOException {
        writer.append("<p class=\"verdict\">").append(Html.text(sentences)).append("</p>\n");
    }

    /** Adds a warning: a line of plain text. */
    public void warning(String line) throws IOException {
        writer.append("<p class=\"warning\">")
                .append(Html.text("Warning: " + line + "."))
                .append("</p>\n");
    }

    /** Adds mark-up. */
    public void add(String markUp) throws IOException {
        writer.append(markUp);
    }

    /**
     * Adds a section.
     *
     * @param title plain text
     * @param content mark-up
     */
    public void section(String title, String content) throws IOException {
        writer.append(Html.plain("h2", title)).append(content);
    }

    /** Ends the page. */
    public void end() throws IOException {
        writer.append("</body>\n</html>\n");
        writer.flush();
    }
}
