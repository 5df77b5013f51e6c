package org.dronewatch.docs;

import java.io.IOException;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Looks for links, pictures and anchors of a built site that lead nowhere. Addresses of other sites are left alone: no
 * network.
 *
 * <p>The build runs this file after the site: {@code java SiteLinks.java DIRECTORY}. It therefore needs nothing but the
 * JDK.
 */
final class SiteLinks {
    private static final Pattern TAG = Pattern.compile("<[a-zA-Z][^<>]*>");
    private static final Pattern ATTRIBUTE =
            Pattern.compile("\\s(href|src|id|name)\\s*=\\s*(?:\"([^\"]*)\"|'([^']*)')");
    private static final Pattern SCRIPT = Pattern.compile("<!--[\\s\\S]*?-->|(<script[^>]*>)[\\s\\S]*?</script>");

    private final Path site;
    /** Written by javadoc, which checks its references and whose own anchors are not all there. */
    private final Path api;

    private final Map<Path, Set<String>> anchors = new HashMap<>();

    SiteLinks(Path site) {
        this.site = site.toAbsolutePath().normalize();
        this.api = this.site.resolve("apidocs");
    }

    /** A line for each link that leads nowhere: the page, and the link as it is written there. */
    List<String> broken() throws IOException {
        List<String> broken = new ArrayList<>();
        List<Path> pages;
        try (Stream<Path> files = Files.walk(site)) {
            pages = files.filter(SiteLinks::isPage).sorted().toList();
        }
        for (Path page : pages) {
            for (String link : attributes(Files.readString(page), Set.of("href", "src"))) {
                if (!leadsSomewhere(page, link)) {
                    broken.add(site.relativize(page) + ": " + link);
                }
            }
        }
        return broken;
    }

    /** How many pages there are. */
    long pages() throws IOException {
        try (Stream<Path> files = Files.walk(site)) {
            return files.filter(SiteLinks::isPage).count();
        }
    }

    private static boolean isPage(Path file) {
        // Coverage has directories of that name.
        return file.toString().endsWith(".html") && Files.isRegularFile(file);
    }

    private boolean leadsSomewhere(Path page, String link) throws IOException {
        if (link.matches("(?i)([a-z][a-z0-9+.-]*:|//).*")) {
            return true;
        }
        int sign = link.indexOf('#');
        String name = decoded((sign < 0 ? link : link.substring(0, sign)).replaceFirst("\\?.*", ""));
        Path file = name.isEmpty() ? page : page.resolveSibling(name).normalize();
        if (!file.startsWith(site)) {
            return false;
        }
        if (Files.isDirectory(file)) {
            file = file.resolve("index.html");
        }
        if (!Files.isRegularFile(file)) {
            return false;
        }
        String anchor = sign < 0 ? "" : link.substring(sign + 1);
        return anchor.isEmpty()
                || !isPage(file)
                || file.startsWith(api)
                || anchors(file).contains(anchor)
                || anchors(file).contains(decoded(anchor));
    }

    private Set<String> anchors(Path page) throws IOException {
        Set<String> known = anchors.get(page);
        if (known == null) {
            known = new HashSet<>(attributes(Files.readString(page), Set.of("id", "name")));
            anchors.put(page, known);
        }
        return known;
    }

    /** The values of some attributes of all tags. */
    private static List<String> attributes(String html, Set<String> names) {
        List<String> values = new ArrayList<>();
        Matcher tag = TAG.matcher(SCRIPT.matcher(html).replaceAll("$1"));
        while (tag.find()) {
            Matcher attribute = ATTRIBUTE.matcher(tag.group());
            while (attribute.find()) {
                if (names.contains(attribute.group(1))) {
                    values.add(unescaped(attribute.group(2) != null ? attribute.group(2) : attribute.group(3)));
                }
            }
        }
        return values;
    }

    private static String unescaped(String value) {
        return value.replace("&lt;", "<")
                .replace("&gt;", ">")
                .replace("&quot;", "\"")
                .replace("&#39;", "'")
                .replace("&amp;", "&");
    }

    private static String decoded(String address) {
        return URLDecoder.decode(address.replace("+", "%2B"), StandardCharsets.UTF_8);
    }

    public static void main(String[] arguments) throws IOException {
        SiteLinks links = new SiteLinks(Path.of(arguments[0]));
        List<String> broken = links.broken();
        broken.forEach(System.err::println);
        if (!broken.isEmpty() || links.pages() == 0) {
            System.err.println(broken.size() + " broken links in " + links.pages() + " pages of " + arguments[0]);
            System.exit(1);
        }
    }
}
