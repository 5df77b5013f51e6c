package org.dronewatch.report.labels;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** Images and annotations keep their order and their numbers over all parts. */
class LabelPartTest {
    @TempDir
    private Path directory;

    private static ObjectNode node(String name, String value) {
        return JsonNodeFactory.instance.objectNode().put(name, value);
    }

    private LabelPart part(String name) throws IOException {
        return new LabelPart(directory.resolve(name + "-i"), directory.resolve(name + "-a"));
    }

    @Test
    void numbersRunOverAllParts() throws IOException {
        LabelPart one = part("one");
        LabelPart two = part("two");
        try (one;
                two) {
            one.add(node("look", "0"), List.of());
            // An annotation may begin like an image and hold the separator.
            one.add(node("look", "1"), List.of(node("file_name", "a b"), node("drone", "7 8")));
            two.add(node("look", "2"), List.of(node("drone", "c")));
        }
        StringWriter text = new StringWriter();
        try (BufferedWriter coco = new BufferedWriter(text)) {
            assertThat(one.images()).isEqualTo(2);
            assertThat(two.copyImages(coco, one.copyImages(coco, 0))).isEqualTo(3);
            assertThat(one.copyAnnotations(coco, 0, 0)).isEqualTo(2);
            assertThat(two.copyAnnotations(coco, 2, 2)).isEqualTo(3);
        }

        assertThat(text.toString().replace(",\n", "\n").strip().lines())
                .containsExactly(
                        "{\"id\":1,\"look\":\"0\"}",
                        "{\"id\":2,\"look\":\"1\"}",
                        "{\"id\":3,\"look\":\"2\"}",
                        "{\"id\":1,\"image_id\":2,\"file_name\":\"a b\"}",
                        "{\"id\":2,\"image_id\":2,\"drone\":\"7 8\"}",
                        "{\"id\":3,\"image_id\":3,\"drone\":\"c\"}");
        one.delete();
        two.delete();
        try (Stream<Path> left = Files.list(directory)) {
            assertThat(left).isEmpty();
        }
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void linesThatCannotBeWrittenAreReportedWhenThePartIsClosed() throws IOException {
        LabelPart full = new LabelPart(directory.resolve("i"), Path.of("/dev/full"));
        full.add(node("look", "0"), List.of(node("drone", "a")));

        assertThatExceptionOfType(IOException.class).isThrownBy(full::close);
        assertThat(Files.readString(directory.resolve("i"))).isEqualTo("{\"look\":\"0\"}\n");
    }
}
