package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.GZIPOutputStream;
import org.dronewatch.Thorough;
import org.dronewatch.buildings.io.MapArea;
import org.dronewatch.buildings.io.MapFiles;
import org.dronewatch.buildings.io.PbfWriter;
import org.dronewatch.mesh.io.ModelLoader;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Maps and models that unpack to more than a heap of 64 MB holds: each is refused in one line, before memory ends. */
@Execution(ExecutionMode.CONCURRENT)
class SmallHeapTest {
    private static final String HALF = "half of the memory that Java may use";
    private static final String MARKER = "#";

    @TempDir
    private Path directory;

    /** What must be said about each file, by its name; they are written as they are added. */
    private final Map<String, String> refused = new LinkedHashMap<>();

    /** Files that just fit: what must be said, or nothing for those that are read. */
    private final Map<String, String> read = new LinkedHashMap<>();

    private void write(String name, byte[] bytes) throws IOException {
        Files.write(directory.resolve(name), bytes);
    }

    private interface Content {
        void write(OutputStream out) throws IOException;
    }

    private void packed(String name, Content content) throws IOException {
        try (OutputStream out = new GZIPOutputStream(Files.newOutputStream(directory.resolve(name)), 1 << 16)) {
            content.write(out);
        }
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    private static void repeat(OutputStream out, String text, int times) throws IOException {
        byte[] many = ascii(text.repeat(1000));
        for (int i = 0; i < times / 1000; i++) {
            out.write(many);
        }
    }

    private static void nodes(OutputStream out, int count) throws IOException {
        out.write(ascii("<osm version='0.6'>"));
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < count; i++) {
            text.append("<node id='").append(i).append("' lat='50' lon='15'/>");
            if (text.length() > 60_000) {
                out.write(ascii(text.toString()));
                text.setLength(0);
            }
        }
        out.write(ascii(text + "</osm>"));
    }

    private void writeMaps() throws IOException {
        packed("nodes.osm.gz", out -> nodes(out, 340_000));
        refused.put("nodes.osm.gz", HALF);
        packed("attribute.osm.gz", out -> {
            out.write(ascii("<osm version='0.6'><node id='"));
            repeat(out, "1", 5_000_000);
        });
        refused.put("attribute.osm.gz", "more than 1000000 characters without the beginning or the end of an element");
        packed("comment.osm.gz", out -> {
            out.write(ascii("<osm version='0.6'><!--"));
            repeat(out, " ", 5_000_000);
        });
        refused.put("comment.osm.gz", "more than 1000000 characters without");
        packed("tags.osm.gz", out -> {
            out.write(ascii("<osm version='0.6'><node id='1' lat='50' lon='15'>"));
            for (int i = 0; i < 11_000; i++) {
                out.write(ascii("<tag k='" + i + "' v=''/>"));
            }
        });
        refused.put("tags.osm.gz", "an element with more than 10000 tags");
        packed("way.osm.gz", out -> {
            out.write(ascii("<osm version='0.6'><way id='1'>"));
            repeat(out, "<nd ref='1'/>", 1_100_000);
        });
        refused.put("way.osm.gz", "a way with more than 1000000 nodes");
        ByteArrayOutputStream texts = new ByteArrayOutputStream();
        for (int i = 0; i < 3_000_000; i++) {
            texts.write(0x0A);
            texts.write(0);
        }
        ByteArrayOutputStream block = new ByteArrayOutputStream();
        block.writeBytes(PbfWriter.text(1, texts.toString(StandardCharsets.ISO_8859_1)));
        byte[] header = PbfWriter.blob("OSMHeader", PbfWriter.text(4, "DenseNodes"), -1);
        ByteArrayOutputStream pbf = new ByteArrayOutputStream();
        pbf.writeBytes(header);
        pbf.writeBytes(PbfWriter.blob("OSMData", block.toByteArray(), -1));
        write("texts.osm.pbf", pbf.toByteArray());
        refused.put("texts.osm.pbf", "a part of the memory that Java may use (-Xmx)");
    }

    private void writeJson() throws IOException {
        packed("blanks.geojson.gz", out -> {
            out.write('{');
            repeat(out, " ", 9_000_000);
        });
        refused.put("blanks.geojson.gz", "bytes of JSON: clip it to the site, or give Java more memory");
        for (String part : List.of("[]", "{}", "\"\"", "{\"a\":1}", "[1.5,2.5]")) {
            String name = "json" + refused.size() + ".geojson";
            // By the sizes of objects; half of the heap, and what is left of it.
            int perPart = 3 * (part.length() + 1) + 40;
            for (char one : part.toCharArray()) {
                perPart +=
                        one == '[' ? 112 : one == '{' ? 160 : one == ':' ? 136 : one == '"' ? 32 : one == ',' ? 40 : 0;
            }
            int most = 32 * 1024 * 1024 / perPart;
            if ((long) most * (part.length() + 1) < 7_000_000) {
                write(name, ascii("{\"type\":[" + (part + ",").repeat(most + 10) + "0]}"));
                refused.put(name, HALF);
            }
            int fits = (int) Math.min(most, 8_300_000L / (part.length() + 1)) - 10;
            write("fits-" + name, ascii("{\"type\":[" + (part + ",").repeat(fits) + "0]}"));
            read.put("fits-" + name, "must be FeatureCollection or CityJSON");
        }
        write(
                "city.json",
                ascii("{\"type\":\"CityJSON\",\"version\":\"2.0\",\"vertices\":[" + "[1,2,3],".repeat(90_000)
                        + "[1,2,3]],\"CityObjects\":{}}"));
        refused.put("city.json", HALF);
    }

    private static byte[] stl(int facets) {
        ByteBuffer bytes = ByteBuffer.allocate(84 + 50 * facets).order(ByteOrder.LITTLE_ENDIAN);
        bytes.putInt(80, facets);
        for (int i = 0; i < facets; i++) {
            bytes.position(84 + 50 * i + 12);
            bytes.putFloat(i)
                    .putFloat(0)
                    .putFloat(0)
                    .putFloat(i)
                    .putFloat(1)
                    .putFloat(0)
                    .putFloat(i)
                    .putFloat(0);
            bytes.putFloat(1);
        }
        return bytes.array();
    }

    private static byte[] ply(int vertices) {
        byte[] header = ascii("ply\nformat binary_little_endian 1.0\nelement vertex " + vertices
                + "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                + "property list uchar int vertex_index\nend_header\n");
        ByteBuffer bytes =
                ByteBuffer.allocate(header.length + 12 * vertices + 13).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put(header);
        for (int i = 0; i < vertices; i++) {
            bytes.putFloat(i % 10).putFloat(i / 10 % 10).putFloat(0);
        }
        bytes.put((byte) 3).putInt(0).putInt(1).putInt(10);
        return bytes.array();
    }

    /** Primitives that share their positions. */
    private static String gltf(int positions, int primitives, String buffer) {
        return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
                + "\"meshes\":[{\"primitives\":[" + "{\"attributes\":{\"POSITION\":0}},".repeat(primitives - 1)
                + "{\"attributes\":{\"POSITION\":0}}]}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,"
                + "\"count\":" + positions + ",\"type\":\"VEC3\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":"
                + 12 * positions + "}],\"buffers\":[{" + buffer + "\"byteLength\":" + 12 * positions + "}]}";
    }

    private void writeModels() throws IOException {
        write("many.stl", stl(170_000));
        refused.put("many.stl", HALF);
        write("fits.stl", stl(155_000));
        read.put("fits.stl", "");
        write("many.ply", ply(770_000));
        refused.put("many.ply", HALF);
        write("fits.ply", ply(750_000));
        read.put("fits.ply", "");
        write("many.obj", ascii("v 1 2 3\nv 2 2 3\nv 2 3 3\n" + "f 1 2 3\n".repeat(270_000)));
        refused.put("many.obj", HALF);
        write("fits.obj", ascii("v 1 2 3\nv 2 2 3\nv 2 3 3\n" + "f 1 2 3\n".repeat(250_000)));
        read.put("fits.obj", "");
        write("positions.bin", new byte[12 * 3000]);
        write("shared.gltf", ascii(gltf(3000, 300, "\"uri\":\"positions.bin\",")));
        refused.put("shared.gltf", HALF);
        write("large.bin", new byte[17_000_000]);
        write("beside.gltf", ascii(gltf(3000, 1, "\"uri\":\"large.bin\",")));
        refused.put("beside.gltf", HALF);
        ByteBuffer glb = ByteBuffer.allocate(20 + 17_000_000).order(ByteOrder.LITTLE_ENDIAN);
        glb.put(ascii("glTF"))
                .putInt(2)
                .putInt(glb.capacity())
                .putInt(17_000_000)
                .put(ascii("JSON"));
        write("long.glb", glb.array());
        refused.put("long.glb", HALF);
    }

    @Thorough
    @Test
    void whatUnpacksToMoreThanThereIsIsRefusedInOneLine() throws IOException, InterruptedException {
        writeMaps();
        writeJson();
        writeModels();
        List<String> arguments = new ArrayList<>(refused.keySet());
        arguments.add(MARKER);
        arguments.addAll(read.keySet());
        List<String> options = List.of("-Xmx64m", "-Ddronewatch.cache=off");
        try (Program.Child child =
                Program.startClass(Reader.class, directory, List.of(), options, arguments.toArray(String[]::new))) {
            Program.Outcome outcome = child.await();
            assertThat(outcome.code()).as(outcome.err()).isZero();
            List<String> lines = outcome.out().lines().toList();
            assertThat(lines).hasSize(refused.size() + read.size());
            int number = 0;
            for (Map.Entry<String, String> one : refused.entrySet()) {
                assertThat(lines.get(number++))
                        .startsWith(one.getKey() + " 2 1 ")
                        .contains(one.getKey().replace(".gz", ""))
                        .contains(one.getValue());
            }
            for (Map.Entry<String, String> one : read.entrySet()) {
                assertThat(lines.get(number++)).startsWith(one.getKey() + " ").contains(one.getValue());
            }
        }
    }

    /** Checks scenes with the files before the marker, and only reads those after it. */
    static final class Reader {
        private Reader() {}

        public static void main(String[] names) throws IOException {
            boolean isRefused = true;
            for (String name : names) {
                if (name.equals(MARKER)) {
                    isRefused = false;
                } else if (isRefused) {
                    check(name);
                } else {
                    System.out.println(name + " " + read(name));
                }
            }
        }

        private static boolean isModel(String name) {
            return name.matches(".*\\.(obj|stl|ply|glb|gltf)");
        }

        /** The exit code, the number of lines, and the last one. */
        private static void check(String name) throws IOException {
            String world = isModel(name) ? "models: [" + name + "]" : "buildings: {file: " + name + "}";
            Files.writeString(
                    Path.of("scene.yaml"), "world: {origin: {latitude: 50 deg, longitude: 15 deg}, " + world + "}\n");
            Program.Outcome outcome = Program.run("check", "scene.yaml");
            List<String> lines = outcome.complaints();
            System.out.println(
                    name + " " + outcome.code() + " " + lines.size() + " " + (lines.isEmpty() ? "" : lines.get(0)));
        }

        private static String read(String name) {
            try {
                if (isModel(name)) {
                    new ModelLoader(Path.of("")).load(ModelSettings.of(name));
                } else {
                    new MapFiles(Path.of("")).read(name, new MapArea(14, 16, 49, 51));
                }
                return "";
            } catch (InputException e) {
                return e.getMessage();
            }
        }
    }
}
