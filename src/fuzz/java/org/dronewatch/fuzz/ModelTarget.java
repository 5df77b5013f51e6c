package org.dronewatch.fuzz;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.Locale;

/** Models in glTF, STL and PLY, as text and as bytes, damaged; in GLB files, also the JSON inside. */
final class ModelTarget implements FuzzTarget {
    private static final int MOST_TRIANGLES = 30;

    @Override
    public String name() {
        return "model";
    }

    @Override
    public FuzzCase generate(Dice dice, long number) {
        float[][] corners = corners(dice);
        return switch ((int) (number % 7)) {
            case 0 -> scene("damaged STL", "a.stl", ByteMutation.of(binaryStl(corners), dice), dice);
            case 1 -> scene("damaged STL text", "a.stl", ByteMutation.of(ascii(textStl(corners)), dice), dice);
            case 2 -> scene("damaged PLY", "a.ply", ByteMutation.of(ply(corners, dice), dice), dice);
            case 3 -> scene("damaged PLY text", "a.ply", ByteMutation.of(ascii(textPly(corners)), dice), dice);
            case 4 ->
                scene(
                        "damaged GLB",
                        "a.glb",
                        ByteMutation.of(glb(ascii(json(corners, "", dice)), corners), dice),
                        dice);
            case 5 ->
                scene(
                        "GLB with damaged JSON",
                        "a.glb",
                        glb(ByteMutation.of(ascii(json(corners, "", dice)), dice), corners),
                        dice);
            default -> {
                String uri = "\"uri\":\"data:application/octet-stream;base64,"
                        + Base64.getEncoder().encodeToString(buffer(corners)) + "\",";
                yield scene("damaged glTF", "a.gltf", ByteMutation.of(ascii(json(corners, uri, dice)), dice), dice);
            }
        };
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private static FuzzCase scene(String what, String file, byte[] content, Dice dice) {
        String others = dice.pick(
                "", ", upAxis: z", ", scale: 0.001", ", origin: [1, 2, 3], heading: 30 deg", ", crs: EPSG:32633");
        String scene = "world:\n  origin: {latitude: 50.08 deg, longitude: 14.42 deg, height: 200}\n  models: [{file: "
                + file + others + "}]\n";
        return FuzzCase.of(what, "scene.yaml", scene, "check", "{}/scene.yaml").with(file, content);
    }

    /** The corners of triangles, three for each; some of them are huge, or not numbers. */
    private static float[][] corners(Dice dice) {
        float[][] corners = new float[3 * dice.between(1, MOST_TRIANGLES)][3];
        for (float[] corner : corners) {
            for (int axis = 0; axis < 3; axis++) {
                corner[axis] = dice.oneIn(60)
                        ? dice.pick(Float.NaN, 1e30f, -1e9f, Float.POSITIVE_INFINITY, 0f)
                        : dice.between(-50, 50);
            }
        }
        return corners;
    }

    private static byte[] binaryStl(float[][] corners) {
        ByteBuffer bytes = ByteBuffer.allocate(84 + 50 * (corners.length / 3)).order(ByteOrder.LITTLE_ENDIAN);
        bytes.position(80);
        bytes.putInt(corners.length / 3);
        for (int i = 0; i < corners.length; i++) {
            if (i % 3 == 0) {
                bytes.position(84 + 50 * (i / 3) + 12);
            }
            put(corners[i], bytes);
        }
        return bytes.array();
    }

    private static void put(float[] corner, ByteBuffer bytes) {
        for (float value : corner) {
            bytes.putFloat(value);
        }
    }

    private static String textStl(float[][] corners) {
        StringBuilder text = new StringBuilder("solid a\n");
        for (int i = 0; i < corners.length; i++) {
            text.append(i % 3 == 0 ? "facet normal 0 0 1\nouter loop\n" : "");
            text.append(String.format(Locale.ROOT, "vertex %s %s %s%n", corners[i][0], corners[i][1], corners[i][2]));
            text.append(i % 3 == 2 ? "endloop\nendfacet\n" : "");
        }
        return text + "endsolid a\n";
    }

    private static String header(String format, int corners) {
        return "ply\nformat " + format + " 1.0\ncomment a\nelement vertex " + corners
                + "\nproperty float x\nproperty float y\nproperty float z\nelement face " + corners / 3
                + "\nproperty list uchar int vertex_indices\nend_header\n";
    }

    private static byte[] ply(float[][] corners, Dice dice) {
        boolean isBig = dice.oneIn(2);
        byte[] header = ascii(header(isBig ? "binary_big_endian" : "binary_little_endian", corners.length));
        ByteBuffer bytes = ByteBuffer.allocate(header.length + 12 * corners.length + 13 * (corners.length / 3))
                .order(isBig ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
        bytes.put(header);
        for (float[] corner : corners) {
            put(corner, bytes);
        }
        for (int i = 0; i < corners.length; i += 3) {
            bytes.put((byte) 3).putInt(i).putInt(i + 1).putInt(i + 2);
        }
        return bytes.array();
    }

    private static String textPly(float[][] corners) {
        StringBuilder text = new StringBuilder(header("ascii", corners.length));
        for (float[] corner : corners) {
            text.append(corner[0])
                    .append(' ')
                    .append(corner[1])
                    .append(' ')
                    .append(corner[2])
                    .append('\n');
        }
        for (int i = 0; i < corners.length; i += 3) {
            text.append("3 ")
                    .append(i)
                    .append(' ')
                    .append(i + 1)
                    .append(' ')
                    .append(i + 2)
                    .append('\n');
        }
        return text.toString();
    }

    /** Positions, then indices of 16 bits. */
    private static byte[] buffer(float[][] corners) {
        ByteBuffer bytes = ByteBuffer.allocate(14 * corners.length).order(ByteOrder.LITTLE_ENDIAN);
        for (float[] corner : corners) {
            put(corner, bytes);
        }
        for (int i = 0; i < corners.length; i++) {
            bytes.putShort((short) i);
        }
        return bytes.array();
    }

    private static String json(float[][] corners, String uri, Dice dice) {
        int count = corners.length;
        String placed = dice.pick(
                "",
                ",\"rotation\":[-0.70710678,0,0,0.70710678]",
                ",\"scale\":[1,-1,2]",
                ",\"translation\":[1,2,3],\"children\":[1]");
        return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0"
                + placed
                + "},{\"mesh\":0,\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,5,6,7,1]}],\"meshes\":[{\"primitives\":[{\"attributes\":"
                + "{\"POSITION\":0},\"indices\":1,\"mode\":" + dice.pick(4, 4, 5, 6, 0) + ",\"material\":0}]}],"
                + "\"materials\":[{\"name\":\"stone\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0.2,0,1]}}],"
                + "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":" + count + ",\"type\":\"VEC3\"},"
                + "{\"bufferView\":1,\"componentType\":5123,\"count\":" + count + ",\"type\":\"SCALAR\"}],"
                + "\"bufferViews\":[{\"buffer\":0,\"byteLength\":" + 12 * count + "},{\"buffer\":0,\"byteOffset\":"
                + 12 * count
                + ",\"byteLength\":" + 2 * count + "}],\"buffers\":[{" + uri + "\"byteLength\":" + 14 * count + "}]}";
    }

    private static byte[] glb(byte[] json, float[][] corners) {
        byte[] padded = Arrays.copyOf(json, json.length + (4 - json.length % 4) % 4);
        Arrays.fill(padded, json.length, padded.length, (byte) ' ');
        byte[] buffer = buffer(corners);
        ByteBuffer bytes =
                ByteBuffer.allocate(28 + padded.length + buffer.length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put(ascii("glTF")).putInt(2).putInt(bytes.capacity());
        bytes.putInt(padded.length).put(ascii("JSON")).put(padded);
        bytes.putInt(buffer.length).put(new byte[] {'B', 'I', 'N', 0}).put(buffer);
        return bytes.array();
    }

    @Override
    public void judge(FuzzCase input, Path directory) {
        Judge.check(CommandRun.of(input.argumentsIn(directory)), directory);
    }
}
