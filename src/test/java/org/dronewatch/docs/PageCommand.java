package org.dronewatch.docs;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A command of dronewatch that a page shows, in whichever way it is started.
 *
 * @param page name of the page's file
 * @param words its words, as a shell parts them, without the name of the program
 */
record PageCommand(String page, List<String> words) {
    private static final Pattern COMMAND =
            Pattern.compile("(?m)^ {4}(?:mvn .*compile exec:java -Dexec\\.args=\"([^\"]*)\""
                    + "|dronewatch ([^|\\n]*)(?: \\| .*)?|java .*-all\\.jar (.*))$");
    private static final Pattern SHELL = Pattern.compile("(?ms)^```shell\n(.*?)^```");
    private static final Pattern WORD = Pattern.compile("(?:[^\\s\"']|\"[^\"]*\"|'[^']*')+");

    /** The commands of all pages, page by page. */
    static List<PageCommand> all() throws IOException {
        Set<PageCommand> commands = new LinkedHashSet<>();
        for (Path page : SitePages.sources(Path.of("").toAbsolutePath())) {
            String name = page.startsWith("models")
                    ? page.toString()
                    : page.getFileName().toString();
            String text = SHELL.matcher(Files.readString(page))
                    .replaceAll(block -> Matcher.quoteReplacement(block.group(1).indent(4)));
            Matcher found = COMMAND.matcher(text);
            while (found.find()) {
                int group = found.group(1) != null ? 1 : found.group(2) != null ? 2 : 3;
                commands.add(new PageCommand(name, words(found.group(group))));
            }
        }
        return new ArrayList<>(commands);
    }

    /** As a shell parts them. */
    static List<String> words(String line) {
        return WORD.matcher(line)
                .results()
                .map(word -> word.group().replaceAll("[\"']", ""))
                .toList();
    }

    @Override
    public String toString() {
        return page + ": " + String.join(" ", words);
    }
}
