package org.dronewatch.setting.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.input.BoundedFile;
import org.snakeyaml.engine.v2.api.LoadSettings;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.TokenStreamLocation;
import tools.jackson.core.exc.StreamConstraintsException;
import tools.jackson.dataformat.yaml.YAMLFactory;
import tools.jackson.dataformat.yaml.YAMLParser;

/**
 * Reads one YAML document into nodes. Nothing in it names a class of this program; size, depth and the expansion of
 * aliases are bounded.
 */
final class YamlFile {
    /** Largest size of a file, bytes. */
    static final int MAX_BYTES = 1 << 20;

    /** Maximum number of nodes, with aliases expanded. */
    static final int MAX_NODES = 100_000;

    /** Longest line, characters: longer ones cost the library far more memory than they hold. */
    private static final int MAX_LINE = 20_000;

    private static final int MAX_DEPTH = 32;
    private static final YAMLFactory YAML = YAMLFactory.builder()
            .loadSettings(LoadSettings.builder()
                    .setCodePointLimit(MAX_BYTES)
                    .setAllowDuplicateKeys(true)
                    .build())
            .streamReadConstraints(
                    StreamReadConstraints.builder().maxNestingDepth(MAX_DEPTH).build())
            .build();

    private final String name;
    private final Problems problems;
    private final YAMLParser parser;
    private final Map<String, Node> anchors = new HashMap<>();

    private YamlFile(String name, String text, Problems problems) {
        this.name = name;
        this.problems = problems;
        this.parser = (YAMLParser) YAML.createParser(ObjectReadContext.empty(), text);
    }

    /**
     * Reads a file.
     *
     * @throws InputException when there is no such file, or it is a pipe or a device, or too large, or not text
     */
    static String text(Path file) {
        return text(file.toString(), BoundedFile.read(file, MAX_BYTES));
    }

    /** Reads all that a stream has, as UTF-8. */
    static String text(String name, InputStream in) throws IOException {
        byte[] bytes = in.readNBytes(MAX_BYTES + 1);
        if (bytes.length > MAX_BYTES) {
            throw new InputException(name + ": larger than " + MAX_BYTES + " bytes, the limit for such a file");
        }
        return text(name, bytes);
    }

    private static String text(String name, byte[] bytes) {
        try {
            String text = StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(bytes))
                    .toString();
            checkLines(name, text);
            return text.startsWith("\uFEFF") ? text.substring(1) : text;
        } catch (CharacterCodingException e) {
            throw new InputException(name + ":" + lineOfFirstMistake(bytes) + ": is not text in UTF-8", e);
        }
    }

    private static void checkLines(String name, String text) {
        int number = 0;
        int start = 0;
        while (start < text.length()) {
            number++;
            int end = text.indexOf('\n', start);
            end = end < 0 ? text.length() : end;
            if (end - start > MAX_LINE) {
                throw new InputException(name + ":" + number + ": has " + (end - start)
                        + " characters; a line may have at most " + MAX_LINE);
            }
            start = end + 1;
        }
    }

    private static int lineOfFirstMistake(byte[] bytes) {
        String lenient = new String(bytes, StandardCharsets.UTF_8);
        int at = lenient.indexOf('\uFFFD');
        return 1
                + (int) lenient.substring(0, Math.max(at, 0))
                        .chars()
                        .filter(c -> c == '\n')
                        .count();
    }

    /**
     * The one mapping that a document consists of.
     *
     * @param name what messages call the file
     * @param problems receives names that are given twice
     * @throws InputException when the text is not valid YAML or exceeds a bound
     */
    static Node.Mapping read(String name, String text, Problems problems) {
        YamlFile file = new YamlFile(name, text, problems);
        try (file.parser) {
            return file.document();
        } catch (JacksonException e) {
            throw file.broken(e);
        } catch (StackOverflowError e) {
            throw new InputException(name + ": nested too deeply", e);
        }
    }

    private Node.Mapping document() {
        JsonToken first = parser.nextToken();
        if (first == null) {
            throw new InputException(name + ":1:1: is empty");
        }
        Node root = node(first);
        if (parser.nextToken() != null) {
            throw new InputException(mark() + ": a second document begins; there may be only one");
        }
        if (root instanceof Node.Mapping mapping) {
            return mapping;
        }
        throw new InputException(root.mark() + ": must be named settings, as in 'world:'");
    }

    private Node node(JsonToken token) {
        Mark mark = mark();
        if (parser.isCurrentAlias()) {
            return alias(mark);
        }
        String type = parser.getTypeId() == null ? "" : parser.getTypeId().toString();
        if (!type.isEmpty()) {
            throw new InputException(mark + ": tag '" + type + "' is not allowed: values have no types here");
        }
        String anchor =
                parser.getObjectId() == null ? null : parser.getObjectId().toString();
        Node node =
                switch (token) {
                    case START_OBJECT -> mapping(mark);
                    case START_ARRAY -> sequence(mark);
                    case VALUE_NULL -> new Node.Scalar("", mark);
                    default -> new Node.Scalar(parser.getString(), mark);
                };
        if (node.size() > MAX_NODES) {
            throw new InputException(mark + ": more than " + MAX_NODES + " values, with aliases expanded");
        }
        if (anchor != null) {
            anchors.put(anchor, node);
        }
        return node;
    }

    private Node alias(Mark mark) {
        String anchor = parser.getString();
        Node meant = anchors.get(anchor);
        if (meant == null) {
            throw new InputException(mark + ": alias '*" + anchor
                    + "' must come after the end of a value with the anchor '&" + anchor + "'");
        }
        return meant;
    }

    private Node mapping(Mark mark) {
        Map<String, Node> values = new LinkedHashMap<>();
        Map<String, Mark> keys = new HashMap<>();
        while (parser.nextToken() != JsonToken.END_OBJECT) {
            String key = parser.currentName();
            Mark place = mark();
            Node value = node(parser.nextToken());
            if (values.putIfAbsent(key, value) == null) {
                keys.put(key, place);
            } else {
                problems.add(
                        place,
                        "",
                        "'" + key + "' is given twice; it is first given on line "
                                + keys.get(key).line());
            }
        }
        return Node.Mapping.of(values, keys, mark);
    }

    private Node sequence(Mark mark) {
        List<Node> items = new ArrayList<>();
        for (JsonToken token = parser.nextToken(); token != JsonToken.END_ARRAY; token = parser.nextToken()) {
            items.add(node(token));
        }
        return Node.Sequence.of(items, mark);
    }

    private Mark mark() {
        TokenStreamLocation at = parser.currentTokenLocation();
        return new Mark(name, Math.max(1, at.getLineNr()), Math.max(1, at.getColumnNr()));
    }

    /** The library's message, without the excerpts that it draws under it. */
    private InputException broken(JacksonException e) {
        TokenStreamLocation at = e.getLocation();
        String place = at == null || at.getLineNr() < 1 ? "" : ":" + at.getLineNr() + ":" + at.getColumnNr();
        if (e instanceof StreamConstraintsException) {
            return new InputException(
                    name + place + ": lists and mappings are nested more than " + MAX_DEPTH + " deep", e);
        }
        String message = String.valueOf(e.getOriginalMessage())
                .lines()
                .filter(line -> !line.isBlank() && !line.startsWith(" "))
                .collect(Collectors.joining(", "));
        return new InputException(
                name + place + ": is not valid YAML: " + PlainText.beginning(message, PlainText.LONGEST), e);
    }
}
