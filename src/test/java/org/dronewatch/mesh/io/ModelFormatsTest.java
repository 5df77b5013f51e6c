package org.dronewatch.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.TreeSet;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A wedge of 4 m x 3 m x 2 m, of 12 m3, in each format, by writers of the test's own. */
class ModelFormatsTest {
    /** The wedge stands on z = 0: a rectangle 4 m along x and 3 m along y, and a ridge 2 m over its side x = 0. */
    private static final double[][] CORNERS = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, {0, 0, 2}, {0, 3, 2}};

    private static final int[][] FACES = {
        {0, 2, 1}, {0, 3, 2}, {0, 4, 5}, {0, 5, 3}, {1, 2, 5}, {1, 5, 4}, {0, 1, 4}, {3, 5, 2}
    };

    @TempDir
    private Path directory;

    private LoadedModel load(String name, byte[] bytes) throws IOException {
        Files.write(directory.resolve(name), bytes);
        return new ModelLoader(directory).load(ModelSettings.of(name).withUpAxis(UpAxis.Z));
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    private static byte[] binaryStl(String title) {
        ByteBuffer bytes = ByteBuffer.allocate(84 + 50 * FACES.length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put(ascii(title));
        bytes.position(80);
        bytes.putInt(FACES.length);
        for (int[] face : FACES) {
            bytes.putFloat(0).putFloat(0).putFloat(0);
            for (int corner : face) {
                for (double value : CORNERS[corner]) {
                    bytes.putFloat((float) value);
                }
            }
            bytes.putShort((short) 0);
        }
        return bytes.array();
    }

    private static String textStl() {
        StringBuilder text = new StringBuilder("solid wedge\n");
        for (int[] face : FACES) {
            text.append("facet normal 0 0 0\n outer loop\n");
            for (int corner : face) {
                text.append(String.format(
                        Locale.ROOT,
                        "  vertex %s %s %e%n",
                        CORNERS[corner][0],
                        CORNERS[corner][1],
                        CORNERS[corner][2]));
            }
            text.append(" endloop\nendfacet\n");
        }
        return text + "endsolid wedge\n";
    }

    private static String plyHeader(String format) {
        return "ply\nformat " + format + " 1.0\ncomment made by hand\nelement camera 1\nproperty float f\n"
                + "element vertex 6\nproperty uchar red\nproperty double x\nproperty float y\nproperty short z\n"
                + "element face 8\nproperty list uchar uint vertex_indices\nproperty list uchar float texcoord\nend_header\n";
    }

    private static String textPly() {
        StringBuilder text = new StringBuilder(plyHeader("ascii")).append("50\n");
        for (double[] corner : CORNERS) {
            text.append("7 " + corner[0] + " " + corner[1] + " " + (int) corner[2] + "\n");
        }
        for (int[] face : FACES) {
            text.append("3 " + face[0] + " " + face[1] + " " + face[2] + "  2 0.5 0.5\n");
        }
        return text.toString();
    }

    private static byte[] binaryPly(ByteOrder order) {
        ByteBuffer bytes = ByteBuffer.allocate(2000).order(order);
        bytes.put(ascii(plyHeader(order == ByteOrder.BIG_ENDIAN ? "binary_big_endian" : "binary_little_endian")));
        bytes.putFloat(50);
        for (double[] corner : CORNERS) {
            bytes.put((byte) 7).putDouble(corner[0]).putFloat((float) corner[1]).putShort((short) corner[2]);
        }
        for (int[] face : FACES) {
            bytes.put((byte) 3).putInt(face[0]).putInt(face[1]).putInt(face[2]);
            bytes.put((byte) 2).putFloat(0.5f).putFloat(0.5f);
        }
        return Arrays.copyOf(bytes.array(), bytes.position());
    }

    /** Positions as floats, then indices as 16-bit numbers. */
    private static byte[] gltfBuffer() {
        ByteBuffer bytes = ByteBuffer.allocate(72 + 48).order(ByteOrder.LITTLE_ENDIAN);
        for (double[] corner : CORNERS) {
            for (double value : corner) {
                bytes.putFloat((float) value);
            }
        }
        for (int[] face : FACES) {
            for (int corner : face) {
                bytes.putShort((short) corner);
            }
        }
        return bytes.array();
    }

    private static String gltf(String buffer, String node) {
        return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[" + node
                + "],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1,\"material\":0}]}],"
                + "\"materials\":[{\"name\":\"stone\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0.2159,0,1]}}],"
                + "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":6,\"type\":\"VEC3\"},"
                + "{\"bufferView\":1,\"componentType\":5123,\"count\":24,\"type\":\"SCALAR\"}],"
                + "\"bufferViews\":[{\"buffer\":0,\"byteLength\":72},{\"buffer\":0,\"byteOffset\":72,\"byteLength\":48}],"
                + "\"buffers\":[{" + buffer + "\"byteLength\":120}]}";
    }

    private static String inline() {
        return "\"uri\":\"data:application/octet-stream;base64,"
                + Base64.getEncoder().encodeToString(gltfBuffer()) + "\",";
    }

    private static byte[] glb(String json) throws IOException {
        byte[] text = ascii(json + " ".repeat((4 - json.length() % 4) % 4));
        byte[] buffer = gltfBuffer();
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        ByteBuffer head = ByteBuffer.allocate(20).order(ByteOrder.LITTLE_ENDIAN);
        head.put(ascii("glTF")).putInt(2).putInt(28 + text.length + buffer.length);
        head.putInt(text.length).put(ascii("JSON"));
        all.writeBytes(head.array());
        all.writeBytes(text);
        ByteBuffer chunk = ByteBuffer.allocate(8).order(ByteOrder.LITTLE_ENDIAN);
        chunk.putInt(buffer.length).put(new byte[] {'B', 'I', 'N', 0});
        all.writeBytes(chunk.array());
        all.writeBytes(buffer);
        return all.toByteArray();
    }

    private static double volume(TriangleMesh mesh) {
        double sixfold = 0.0;
        for (int i = 0; i < mesh.triangleCount(); i++) {
            Position a = mesh.triangle(i).a();
            Position b = mesh.triangle(i).b();
            Position c = mesh.triangle(i).c();
            sixfold += a.x() * (b.y() * c.z() - b.z() * c.y())
                    + a.y() * (b.z() * c.x() - b.x() * c.z())
                    + a.z() * (b.x() * c.y() - b.y() * c.x());
        }
        return sixfold / 6.0;
    }

    private static void assertWedge(LoadedModel model, double volume, double... extent) {
        AABB box = model.mesh().bounds();
        assertThat(model.mesh().triangleCount()).isEqualTo(8);
        assertThat(volume(model.mesh())).isCloseTo(volume, within(1e-4));
        assertThat(new double[] {box.maxX() - box.minX(), box.maxY() - box.minY(), box.maxZ() - box.minZ()})
                .containsExactly(extent, within(1e-4));
    }

    /** Whatever the first words of a binary file are. */
    @ParameterizedTest
    @ValueSource(strings = {"made by a scanner", "solid wedge", ""})
    void stlAsBytes(String title) throws IOException {
        LoadedModel model = load("wedge.STL", binaryStl(title));
        assertWedge(model, 12.0, 4, 3, 2);
        assertThat(model.warnings()).singleElement().asString().contains("STL states no unit", "scale: 0.001");
        ModelSettings millimetres =
                ModelSettings.of("wedge.STL").withUpAxis(UpAxis.Z).withScale(0.001);
        assertThat(new ModelLoader(directory).load(millimetres).warnings())
                .singleElement()
                .asString()
                .contains("is 0.0040 m x 0.0030 m x 0.0020 m, too small to hide anything");
    }

    /** Its first word is that of text, and its length is not what it states; the zero bytes of its title tell. */
    @Test
    void stlAsBytesThatBeginsLikeText() throws IOException {
        byte[] whole = binaryStl("solid wedge");
        assertWedge(load("wedge.stl", Arrays.copyOf(whole, whole.length + 7)), 12.0, 4, 3, 2);
        assertThatThrownBy(() -> load("wedge.stl", Arrays.copyOf(whole, whole.length - 1)))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(
                        "states 8 facets, which would take 484 bytes, but has 483: not STL, or truncated");
    }

    @Test
    void stlAsText() throws IOException {
        assertWedge(load("wedge.stl", ascii(textStl())), 12.0, 4, 3, 2);
        assertWedge(load("wedge.stl", ascii(textStl().toUpperCase(Locale.ROOT))), 12.0, 4, 3, 2);
    }

    @Test
    void plyAsTextAndInBothOrders() throws IOException {
        for (byte[] bytes :
                new byte[][] {ascii(textPly()), binaryPly(ByteOrder.BIG_ENDIAN), binaryPly(ByteOrder.LITTLE_ENDIAN)}) {
            assertWedge(load("wedge.ply", bytes), 12.0, 4, 3, 2);
        }
    }

    /** In one file, with the buffer in the text, and with the buffer beside it, whose name is encoded. */
    @Test
    void gltfInItsThreeForms() throws IOException {
        Files.write(directory.resolve("the buffer.bin"), gltfBuffer());
        for (LoadedModel model : new LoadedModel[] {
            load("wedge.glb", glb(gltf("", "{\"mesh\":0}"))),
            load("wedge.gltf", ascii(gltf(inline(), "{\"mesh\":0}"))),
            load("wedge.gltf", ascii(gltf("\"uri\":\"the%20buffer.bin\",", "{\"mesh\":0}")))
        }) {
            assertWedge(model, 12.0, 4, 3, 2);
            assertThat(model.mesh().materialNames()).containsExactly("stone");
            // 0.2159 of the light is half of the range of a screen.
            assertThat(model.colours()).isEqualTo(Map.of("stone", 0xFF8000));
        }
    }

    /**
     * A quarter turn about x as a quaternion or a matrix; a scale; a mirror, which must not turn the solid inside out.
     */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "\"rotation\":[0.70710678118,0,0,0.70710678118] | 12 | 4 | 2 | 3",
                "\"matrix\":[1,0,0,0, 0,0,1,0, 0,-1,0,0, 5,6,7,1] | 12 | 4 | 2 | 3",
                "\"scale\":[2,1,-3] | 72 | 8 | 3 | 6",
                "\"translation\":[9,9,9] | 12 | 4 | 3 | 2",
            })
    void nodesTransformTheirMeshes(String transform, double volume, double x, double y, double z) throws IOException {
        assertWedge(load("wedge.gltf", ascii(gltf(inline(), "{\"mesh\":0," + transform + "}"))), volume, x, y, z);
    }

    /** The child is moved by 1 along its own y, which its parent has turned to z and doubled. */
    @Test
    void aChildFollowsItsParent() throws IOException {
        String nodes = "{\"children\":[1],\"scale\":[2,2,2],\"rotation\":[0.70710678118,0,0,0.70710678118]},"
                + "{\"mesh\":0,\"translation\":[0,1,0]}";
        LoadedModel model = load("wedge.gltf", ascii(gltf(inline(), nodes)));
        assertWedge(model, 96.0, 8, 4, 6);
        assertThat(model.mesh().bounds().minZ()).isCloseTo(2.0, within(1e-6));
    }

    /** As the format prescribes, y is up and the front looks to +z: with upAxis y, north is -z. */
    @Test
    void gltfHasYUp() throws IOException {
        Files.write(directory.resolve("wedge.gltf"), ascii(gltf(inline(), "{\"mesh\":0}")));
        AABB box = new ModelLoader(directory)
                .load(ModelSettings.of("wedge.gltf"))
                .mesh()
                .bounds();
        assertThat(box.maxZ()).isEqualTo(3.0);
        assertThat(box.minY()).isEqualTo(-2.0);
    }

    /**
     * A node places the wedge on the grid: one corner at latitude 50.08 and longitude 14.42 degrees, one 3 m above it,
     * one 5 km to the east and one 5 km to the north (PROJ 9.5.1).
     */
    @Test
    void glbInANationalGrid() throws IOException {
        String node = "{\"mesh\":0,\"matrix\":[1240.8605,0,170.185,0,0,1,0,0,341.1905,0,-2479.1,0,"
                + "-743011.7235,250,1043823.1814,1]}";
        Files.write(directory.resolve("wedge.glb"), glb(gltf("", node)));
        Origin prague = Origin.at(Math.toRadians(50.08), Math.toRadians(14.42)).withHeight(250.0);
        TriangleMesh mesh = new ModelLoader(directory)
                .load(ModelSettings.of("wedge.glb").withCrs("EPSG:5514"), Optional.of(prague))
                .mesh();
        double[][] expected = {{0, 0, 0}, {5010.565, 2.347, -1.964}, {0, 0, 3}, {0, 5005.593, -1.966}};
        for (double[] place : expected) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int i = 0; i < mesh.vertexCount(); i++) {
                nearest = Math.min(
                        nearest,
                        new Position(
                                        mesh.vertexCoordinate(i, 0),
                                        mesh.vertexCoordinate(i, 1),
                                        mesh.vertexCoordinate(i, 2))
                                .distance(new Position(place[0], place[1], place[2])));
            }
            assertThat(nearest).as(Arrays.toString(place)).isLessThan(0.1);
        }
    }

    @Test
    void stripsAndFansAreTriangles() throws IOException {
        String strip = gltf(inline(), "{\"mesh\":0}")
                .replace("\"indices\":1", "\"mode\":5")
                .replace("\"count\":6", "\"count\":4");
        assertThat(load("strip.gltf", ascii(strip)).mesh().triangleCount()).isEqualTo(2);
        assertThat(load("fan.gltf", ascii(strip.replace("\"mode\":5", "\"mode\":6")))
                        .mesh()
                        .triangleCount())
                .isEqualTo(2);
        assertThatThrownBy(() -> load("points.gltf", ascii(strip.replace("\"mode\":5", "\"mode\":0"))))
                .hasMessageContaining("not a mesh");
    }

    /** A hundredth of a millimetre is kept 463 km from the grid's origin, where a float loses 3 cm. */
    @ParameterizedTest
    @ValueSource(strings = {"obj", "ply", "stl"})
    void coordinatesOfANationalGridLoseNothing(String format) throws IOException {
        double[][] corners = {{155000.12345, 463000.45678, 3.5}, {155010, 463000, 3.5}, {155000, 463010, 3.5}};
        StringBuilder text = new StringBuilder();
        switch (format) {
            case "obj" -> {
                for (double[] corner : corners) {
                    text.append("v " + corner[0] + " " + corner[1] + " " + corner[2] + "\n");
                }
                text.append("f 1 2 3\n");
            }
            case "ply" -> {
                text.append("ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
                        + "property double z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n");
                for (double[] corner : corners) {
                    text.append(corner[0] + " " + corner[1] + " " + corner[2] + "\n");
                }
                text.append("3 0 1 2\n");
            }
            default -> {
                text.append("solid\nfacet normal 0 0 1\nouter loop\n");
                for (double[] corner : corners) {
                    text.append("vertex " + corner[0] + " " + corner[1] + " " + corner[2] + "\n");
                }
                text.append("endloop\nendfacet\nendsolid\n");
            }
        }
        Files.writeString(directory.resolve("grid." + format), text);
        ModelSettings onSite = ModelSettings.of("grid." + format)
                .withUpAxis(UpAxis.Z)
                .withOrigin(new FilePoint(155000, 463000, 0))
                .withPosition(new Position(2, 3, 0));
        LoadedModel model = new ModelLoader(directory).load(onSite);
        Position first = model.mesh().triangle(0).a();
        assertThat(first.x()).isCloseTo(2.12345, within(1e-6));
        assertThat(first.y()).isCloseTo(3.45678, within(1e-6));
        // A quarter turn clockwise about that point: east becomes south, north becomes east.
        Position turned = new ModelLoader(directory)
                .load(onSite.withHeading(Math.PI / 2.0))
                .mesh()
                .triangle(0)
                .a();
        assertThat(turned.x()).isCloseTo(2.45678, within(1e-6));
        assertThat(turned.y()).isCloseTo(2.87655, within(1e-6));
        // In units of the file: had the grid been in millimetres, the point would lie within a millimetre of the
        // position.
        Position small = new ModelLoader(directory)
                .load(onSite.withScale(0.001))
                .mesh()
                .triangle(0)
                .a();
        assertThat(small.x()).isCloseTo(2.00012345, within(1e-6));
        assertThat(model.warnings()).noneMatch(line -> line.contains("national grid"));
        assertThat(new ModelLoader(directory)
                        .load(onSite.withOrigin(new FilePoint(0, 0, 0)))
                        .warnings())
                .anyMatch(line ->
                        line.contains("lies 463 km from the scene's origin, where coordinates are rounded to 0.031 m"));
    }

    /** With y up, the file's own axes count: north is -z there. */
    @Test
    void theOriginOfAFileWithYUp() throws IOException {
        Files.writeString(
                directory.resolve("up.obj"),
                "v 155000.25 7 -463000.5\nv 155010 7 -463000\nv 155000 7 -463010\nf 1 2 3\n");
        Position first = new ModelLoader(directory)
                .load(ModelSettings.of("up.obj").withOrigin(new FilePoint(155000, 5, -463000)))
                .mesh()
                .triangle(0)
                .a();
        assertThat(first).isEqualTo(new Position(0.25, 0.5, 2));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "a.stl | solid a%nfacet normal 0 0 1%nvertex 1 2%n | a.stl:3: a vertex needs three coordinates",
                "a.stl | solid a%nvertex 1 2 x%n | a.stl:2: not a number: 'x'",
                "a.stl | solid a%nendloop%n | a.stl:2: a facet has 0 corners but needs 3",
                "a.stl | solid a%nblob%n | a.stl:2: unknown keyword 'blob'",
                "a.stl | solid a%nvertex 1 2 NaN%n | a.stl:2: a coordinate must be finite, not NaN",
                "a.stl | solid a%nfacet normal 0 0 1%nvertex 1 2 3%n | ends without 'endsolid': it is truncated",
                "a.stl | abc | ends too early",
                "a.ply | ply%nformat ascii 1.0%nelement vertex 1%nproperty float x%nproperty float y%nproperty float z%nend_header%n0 1 0.00000000000000000000000000000000000000000000000000000000000000000000001%n | a number of more than 64 characters",
                "a.ply | ply%nformat binary 1.0%n | a.ply:2: format must be ascii, binary_little_endian",
                "a.ply | ply%nelement vertex 99999999999%n | 99999999999 elements 'vertex' in a file of 31 bytes",
                "a.ply | ply%nformat ascii 1.0%nelement vertex 1%nproperty float x%nend_header%n1%n | its vertices have no 'y'",
                "a.ply | ply%nformat ascii 1.0%nend_header%n | has no faces: a point cloud is not a mesh",
                "a.ply | plx | a.ply:1: the header does not end",
                "a.gltf | {} | asset.version is '' but must be 2.0: not glTF",
                "a.gltf | [ | not glTF",
                "a.glb | glTF | ends too early",
                "a.ifc | ISO-10303-21; | IFC files are not supported: IfcOpenShell converts them, as in 'IfcConvert",
            })
    void whatIsWrongIsNamed(String name, String text, String message) {
        assertThatThrownBy(() -> load(name, ascii(text.replace("%n", "\n"))))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(message)
                .hasMessageNotContaining("\n");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "\"count\":6 | \"count\":7 | accessor 0 of 7 values does not lie within its buffer",
                "\"count\":6 | \"count\":2147483647 | does not lie within its buffer",
                "\"count\":6 | \"count\":-1 | does not lie within its buffer",
                "\"count\":6 | \"byteOffset\":-12,\"count\":6 | does not lie within its buffer",
                "\"byteLength\":120 | \"byteLength\":121 | buffer 0 states 121 bytes but has 120",
                "\"componentType\":5126 | \"componentType\":1 | has components of type 1",
                "\"nodes\":[{\"mesh\":0}] | \"nodes\":[{\"mesh\":4}] | mesh 4 does not exist",
                "\"nodes\":[{\"mesh\":0}] | \"nodes\":[{\"children\":[0]}] | node 0 is a child twice, or its own ancestor",
                "\"nodes\":[{\"mesh\":0}] | \"nodes\":[{\"children\":[1,1]},{\"mesh\":0}] | node 1 is a child twice",
                "\"scene\":0 | \"scene\":3 | scene 3 does not exist",
                "\"material\":0 | \"material\":7 | material 7 does not exist",
                "\"count\":24 | \"count\":23 | a primitive of 23 corners, not a whole number of triangles",
                "\"count\":6 | \"count\":5 | accessor 1: vertex index 5 must be 0 to 4",
                "\"version\":\"2.0\"} | \"version\":\"2.0\"},\"extensionsRequired\":[\"EXT_mesh_gpu_instancing\"] | requires the extension 'EXT_mesh_gpu_instancing', which is not supported",
                "\"nodes\":[0] | \"nodes\":[5] | node 5 does not exist",
                "\"version\":\"2.0\"} | \"version\":\"2.0\"},\"extensionsRequired\":[\"KHR_draco_mesh_compression\"] | is compressed with",
                "\"count\":6 | \"sparse\":{},\"count\":6 | accessor 0 is sparse",
            })
    void gltfThatLiesIsRefused(String part, String lie, String message) {
        String honest = gltf(inline(), "{\"mesh\":0}");
        assertThat(honest).contains(part);
        assertThatThrownBy(() -> load("a.gltf", ascii(honest.replace(part, lie))))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(message);
    }

    /** Without scenes the roots are the nodes that are nobody's children; a child is still moved by its parent. */
    @Test
    void nodesWithoutAScene() throws IOException {
        String nodes = "{\"mesh\":0,\"translation\":[0,1,0]},{\"children\":[0],\"translation\":[100,0,0]}";
        String text = gltf(inline(), nodes).replace("\"scene\":0,\"scenes\":[{\"nodes\":[0]}],", "");
        LoadedModel model = load("wedge.gltf", ascii(text));
        assertWedge(model, 12.0, 4, 3, 2);
        assertThat(model.mesh().bounds().minX()).isEqualTo(100.0);
        assertThat(model.mesh().bounds().minY()).isEqualTo(1.0);
    }

    /** What would change the shape and is not read is said. */
    @Test
    void skinsAndInstancesWarn() throws IOException {
        String node = "{\"mesh\":0,\"skin\":0,\"extensions\":{\"EXT_mesh_gpu_instancing\":{}}}";
        assertThat(load("wedge.gltf", ascii(gltf(inline(), node))).warnings())
                .hasSize(2)
                .anyMatch(line -> line.endsWith("skipped skins (1)"))
                .anyMatch(line -> line.endsWith("skipped EXT_mesh_gpu_instancing lists of mesh instances (1)"));
    }

    /**
     * Many primitives take one triangle each from the same 100,000 positions: the model has the vertices of its corners
     * only.
     */
    @Test
    void primitivesThatShareManyPositions() throws IOException {
        int many = 100_000;
        byte[] buffer = Arrays.copyOf(gltfBuffer(), 120 + 12 * many);
        System.arraycopy(gltfBuffer(), 72, buffer, 12 * many, 48);
        Files.write(directory.resolve("many.bin"), buffer);
        String one = "{\"attributes\":{\"POSITION\":0},\"indices\":1,\"material\":0}";
        String text = gltf("\"uri\":\"many.bin\",", "{\"mesh\":0}")
                .replace(one, one + ("," + one).repeat(4999))
                .replace("\"count\":6", "\"count\":" + many)
                .replace("\"count\":24", "\"count\":3")
                .replace("\"byteLength\":72}", "\"byteLength\":" + 12 * many + "}")
                .replace("\"byteOffset\":72", "\"byteOffset\":" + 12 * many)
                .replace("\"byteLength\":120", "\"byteLength\":" + (12 * many + 48));
        LoadedModel model = load("many.gltf", ascii(text));
        assertThat(model.mesh().triangleCount()).isEqualTo(5000);
        assertThat(model.mesh().vertexCount()).isEqualTo(15_000);
    }

    /** A buffer is read from the model's own directory only. */
    @Test
    void aBufferElsewhereIsRefused() throws IOException {
        Files.createDirectory(directory.resolve("inner"));
        Files.write(directory.resolve("secret.bin"), gltfBuffer());
        assertThatThrownBy(() -> load("inner/a.gltf", ascii(gltf("\"uri\":\"../secret.bin\",", "{\"mesh\":0}"))))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("leads out of the model's directory");
    }

    /** Cut off anywhere, or with a few bits flipped, a file gives a model or one line. */
    @Test
    void damagedFilesGiveOneLine() throws IOException {
        long seed = 24_11L;
        Random random = new Random(seed);
        Map<String, byte[]> files = Map.of(
                "a.stl", binaryStl("x"),
                "b.stl", ascii(textStl()),
                "a.ply", binaryPly(ByteOrder.LITTLE_ENDIAN),
                "b.ply", ascii(textPly()),
                "a.glb", glb(gltf("", "{\"mesh\":0}")));
        for (String name : new TreeSet<>(files.keySet())) {
            for (int i = 0; i < 300; i++) {
                byte[] whole = files.get(name);
                byte[] damaged = i % 2 == 0 ? Arrays.copyOf(whole, random.nextInt(whole.length)) : whole.clone();
                for (int flips = i % 2 == 0 ? 0 : 1 + random.nextInt(3); flips > 0; flips--) {
                    damaged[random.nextInt(damaged.length)] ^= (byte) (1 << random.nextInt(8));
                }
                try {
                    load(name, damaged);
                } catch (InputException e) {
                    assertThat(e.getMessage())
                            .as("seed %d, %s, case %d", seed, name, i)
                            .doesNotContain("\n");
                }
            }
        }
    }
}
