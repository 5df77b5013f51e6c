package org.dronewatch.docs;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Writes what the site is built from. In the project, links and pictures are where a code hosting site looks for them;
 * in the built site, all pages lie side by side, pictures in {@code images}, and other files of the project as they lie
 * there. Headings get the anchors that a code hosting site gives them, which the site's own tool writes in another way.
 *
 * <p>The build runs this file before anything is compiled: {@code java SitePages.java PROJECT TARGET}. It therefore
 * needs nothing but the JDK.
 */
final class SitePages {
    private static final Path SITE = Path.of("src", "site");

    /** What every page of the site uses. */
    private static final List<Path> SHARED = List.of(Path.of("css", "site.css"), Path.of("js", "search.js"));

    /** Left out of the search: it names everything. */
    private static final Path CHANGES = Path.of("CHANGELOG.md");

    private final Path project;
    private final Path target;
    /** Where each page is in the project, and its name in the site. */
    private final Map<Path, String> pages = new TreeMap<>();

    SitePages(Path project, Path target) throws IOException {
        this.project = project;
        this.target = target;
        for (Path page : sources(project)) {
            String name = page.getFileName().toString();
            boolean readme = name.equals("README.md") && page.getNameCount() > 1;
            pages.put(page, readme ? page.getName(0) + ".md" : name.toLowerCase(Locale.ROOT));
        }
    }

    /** All pages of a project, relative to it: those of the site, and those that a code hosting site shows first. */
    static List<Path> sources(Path project) throws IOException {
        List<Path> sources =
                new ArrayList<>(List.of(Path.of("README.md"), Path.of("CHANGELOG.md"), Path.of("models", "README.md")));
        Path contributing = Path.of("CONTRIBUTING.md");
        if (Files.exists(project.resolve(contributing))) {
            sources.add(contributing);
        }
        try (Stream<Path> markdown = Files.list(project.resolve(SITE.resolve("markdown")))) {
            markdown.sorted().map(project::relativize).forEach(sources::add);
        }
        return sources;
    }

    /**
     * Writes all pages.
     *
     * @throws IllegalArgumentException for a link to nowhere
     */
    void write() throws IOException {
        copy(SITE.resolve("site.xml"), "site.xml");
        for (Path shared : SHARED) {
            copy(
                    SITE.resolve("resources").resolve(shared),
                    "resources/" + shared.toString().replace('\\', '/'));
        }
        Files.writeString(target.resolve("resources/js/pages.js"), searchable());
        for (Map.Entry<Path, String> page : pages.entrySet()) {
            Path file = target.resolve("markdown").resolve(page.getValue());
            Files.createDirectories(file.getParent());
            Files.writeString(file, page(page.getKey()));
        }
    }

    /** The text of all pages but the changelog, section by section, as a script that {@code search.js} loads. */
    private String searchable() throws IOException {
        StringBuilder script = new StringBuilder("window.dronewatchPages = [\n");
        for (Map.Entry<Path, String> page : pages.entrySet()) {
            if (page.getKey().equals(CHANGES)) {
                continue;
            }
            Text text = new Text(Files.readString(project.resolve(page.getKey())));
            String name = page.getValue().replaceFirst("md$", "html");
            String title = "";
            for (Section section : text.sections()) {
                title = title.isEmpty() ? section.heading() : title;
                script.append("{page: ").append(quoted(name));
                script.append(", anchor: ").append(quoted(section.anchor()));
                script.append(", title: ").append(quoted(title));
                script.append(", heading: ").append(quoted(section.heading()));
                script.append(", text: ").append(quoted(section.text())).append("},\n");
            }
        }
        return script.append("];\n").toString();
    }

    private static String quoted(String text) {
        return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }

    private String page(Path source) throws IOException {
        Text text = new Text(Files.readString(project.resolve(source)));
        TreeMap<Integer, String> anchors = new TreeMap<>();
        text.headings().forEach((anchor, heading) -> anchors.put(heading.start(), "<a id=\"" + anchor + "\"></a>"));
        StringBuilder page = new StringBuilder();
        int done = 0;
        for (Link link : text.links()) {
            for (Map.Entry<Integer, String> anchor :
                    anchors.subMap(done, link.start()).entrySet()) {
                page.append(text.all, done, anchor.getKey()).append(anchor.getValue());
                done = anchor.getKey();
            }
            page.append(text.all, done, link.start()).append(link.isOutside() ? link.to() : inSite(source, link));
            done = link.end();
        }
        for (Map.Entry<Integer, String> anchor : anchors.tailMap(done).entrySet()) {
            page.append(text.all, done, anchor.getKey()).append(anchor.getValue());
            done = anchor.getKey();
        }
        return page.append(text.all, done, text.all.length()).toString();
    }

    /** A link to a file of the project, as it is to be in the site; what is no page is copied there. */
    private String inSite(Path source, Link link) throws IOException {
        if (link.file().isEmpty()) {
            return link.to();
        }
        Path file =
                Path.of("x").resolveSibling(source).resolveSibling(link.file()).normalize();
        if (!Files.isRegularFile(project.resolve(file))) {
            throw new IllegalArgumentException(source + ": link to " + link.to() + ", which is no file of the project");
        }
        String name = pages.get(file);
        if (name == null) {
            boolean picture = file.startsWith(SITE.resolve("images"));
            name = (picture ? SITE.relativize(file) : file).toString().replace('\\', '/');
            copy(file, "resources/" + name);
        }
        return name + link.fragment();
    }

    private void copy(Path file, String name) throws IOException {
        Path copy = target.resolve(name);
        Files.createDirectories(copy.getParent());
        Files.write(copy, Files.readAllBytes(project.resolve(file)));
    }

    /** A link or a picture in a page: from where to where its address is written. */
    record Link(int start, int end, String to) {
        /** Whether it leads out of the project. */
        boolean isOutside() {
            return to.matches("[a-z]+:.*");
        }

        /** Without the anchor; empty for an anchor in the same page. */
        String file() {
            return to.replaceFirst("#.*", "");
        }

        /** The anchor with its sign, or empty. */
        String fragment() {
            return to.substring(file().length());
        }
    }

    /** A heading: where its text begins. */
    record Heading(int start, String text) {}

    /** A heading with the text up to the next one, as words on one line. */
    record Section(String anchor, String heading, String text) {}

    /** A page in Markdown. */
    static final class Text {
        private static final Pattern ADDRESS = Pattern.compile(
                "\\]\\(\\s*([^)\\s]+)[^)]*\\)|^ {0,3}\\[[^\\]]+\\]:\\s*(\\S+)|(?:href|src)=\"([^\"]*)\"",
                Pattern.MULTILINE);
        private static final Pattern HEADING = Pattern.compile("^ {0,3}#{1,6} +(.*?)[ #]*$", Pattern.MULTILINE);
        private static final Pattern CODE =
                Pattern.compile("(?m)^ {0,3}(```+|~~~+)[\\s\\S]*?^ {0,3}\\1|(`+)(?:(?!\n\n)[\\s\\S])+?(?<!`)\\2(?!`)");
        private static final Pattern INDENTED = Pattern.compile("(?<=\n\n)(?: {4}.*\n|\n(?= {4}))+");

        private final String all;
        /** The same with blanks for all code, in which nothing is a link or a heading. */
        private final String prose;

        Text(String all) {
            this.all = all;
            this.prose = blank(CODE, blank(INDENTED, all));
        }

        private static String blank(Pattern code, String text) {
            return code.matcher(text)
                    .replaceAll(found -> Matcher.quoteReplacement(found.group().replaceAll("[^\n]", " ")));
        }

        /** All links and pictures, in their order. */
        List<Link> links() {
            List<Link> links = new ArrayList<>();
            Matcher found = ADDRESS.matcher(prose);
            while (found.find()) {
                int group = found.group(1) != null ? 1 : found.group(2) != null ? 2 : 3;
                links.add(new Link(found.start(group), found.end(group), found.group(group)));
            }
            return links;
        }

        /** All headings by the anchors that a code hosting site gives them. */
        Map<String, Heading> headings() {
            Map<String, Heading> headings = new TreeMap<>();
            Map<String, Integer> times = new HashMap<>();
            Matcher found = HEADING.matcher(prose);
            while (found.find()) {
                String text = all.substring(found.start(1), found.end(1));
                String anchor = anchor(text);
                int before = times.merge(anchor, 1, Integer::sum) - 1;
                headings.put(before == 0 ? anchor : anchor + "-" + before, new Heading(found.start(1), text));
            }
            return headings;
        }

        /** The sections, in their order. */
        List<Section> sections() {
            TreeMap<Integer, Map.Entry<String, Heading>> headings = new TreeMap<>();
            headings()
                    .entrySet()
                    .forEach(heading -> headings.put(heading.getValue().start(), heading));
            List<Section> sections = new ArrayList<>();
            headings.forEach((start, heading) -> {
                Integer next = headings.higherKey(start);
                String text =
                        all.substring(start + heading.getValue().text().length(), next == null ? all.length() : next);
                sections.add(
                        new Section(heading.getKey(), plain(heading.getValue().text()), plain(text)));
            });
            return sections;
        }

        /** Words without mark-up. */
        private static String plain(String text) {
            return text.replaceAll("!?\\[([^\\]]*)\\]\\([^)]*\\)", "$1")
                    .replaceAll("</?(?:a|b|br|div|em|i|img|p|span|strong|sub|sup)\\b[^>]*>|\\*\\*", " ")
                    .replaceAll("(?m)^ {0,3}#{1,6} *$|^ *[|:-]*-{3,}[|: -]*$|```\\w*", " ")
                    .replaceAll("[`|]", " ")
                    .replaceAll("\\s+", " ")
                    .strip();
        }

        /** Lower case, hyphens for blanks, without any other sign. */
        static String anchor(String heading) {
            return heading.replaceAll("\\[([^\\]]*)\\]\\([^)]*\\)", "$1")
                    .toLowerCase(Locale.ROOT)
                    .replaceAll("[^\\p{L}\\p{N} _-]", "")
                    .replace(' ', '-');
        }
    }

    public static void main(String[] arguments) throws IOException {
        new SitePages(Path.of(arguments[0]), Path.of(arguments[1])).write();
    }
}
