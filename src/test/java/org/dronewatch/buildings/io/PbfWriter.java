package org.dronewatch.buildings.io;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.Deflater;

/** Writes OpenStreetMap's binary format, for tests: a header, and blocks of nodes, ways and relations. */
public final class PbfWriter implements OsmElements {
    private final boolean isDense;
    private final Map<String, Integer> strings = new LinkedHashMap<>();
    private final List<Node> nodes = new ArrayList<>();
    private final ByteArrayOutputStream ways = new ByteArrayOutputStream();
    private final ByteArrayOutputStream relations = new ByteArrayOutputStream();

    private record Node(long id, long latitude, long longitude, List<Long> tags) {}

    PbfWriter(boolean isDense) {
        this.isDense = isDense;
        strings.put("", 0);
    }

    @Override
    public void node(long id, double longitude, double latitude) {
        nodes.add(new Node(id, Math.round(latitude * 1e7), Math.round(longitude * 1e7), new ArrayList<>()));
    }

    @Override
    public void taggedNode(Map<String, String> tags) {
        tags.forEach((key, value) -> {
            nodes.get(nodes.size() - 1).tags.add(number(key));
            nodes.get(nodes.size() - 1).tags.add(number(value));
        });
    }

    private long number(String text) {
        return strings.computeIfAbsent(text, any -> strings.size());
    }

    @Override
    public void way(long id, long[] refs, Map<String, String> tags) {
        ByteArrayOutputStream way = new ByteArrayOutputStream();
        field(way, 1, id);
        tags(way, tags);
        bytes(way, 8, differences(refs));
        bytes(ways, 3, way.toByteArray());
    }

    @Override
    public void relation(long id, List<Member> members, Map<String, String> tags) {
        ByteArrayOutputStream relation = new ByteArrayOutputStream();
        field(relation, 1, id);
        tags(relation, tags);
        // A node comes first, which is no way.
        ByteArrayOutputStream roles = new ByteArrayOutputStream();
        ByteArrayOutputStream types = new ByteArrayOutputStream();
        long[] ids = new long[members.size() + 1];
        ids[0] = 77;
        varint(roles, number("entrance"));
        varint(types, 0);
        for (int i = 0; i < members.size(); i++) {
            ids[i + 1] = members.get(i).way();
            varint(roles, number(members.get(i).role()));
            varint(types, 1);
        }
        bytes(relation, 8, roles.toByteArray());
        bytes(relation, 9, differences(ids));
        bytes(relation, 10, types.toByteArray());
        bytes(relations, 4, relation.toByteArray());
    }

    private void tags(ByteArrayOutputStream target, Map<String, String> tags) {
        ByteArrayOutputStream keys = new ByteArrayOutputStream();
        ByteArrayOutputStream values = new ByteArrayOutputStream();
        tags.forEach((key, value) -> {
            varint(keys, number(key));
            varint(values, number(value));
        });
        bytes(target, 2, keys.toByteArray());
        bytes(target, 3, values.toByteArray());
    }

    byte[] bytes() throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        ByteArrayOutputStream features = new ByteArrayOutputStream();
        features.writeBytes(text(4, "OsmSchema-V0.6"));
        features.writeBytes(text(4, "DenseNodes"));
        file.writeBytes(blob("OSMHeader", features.toByteArray(), -1));
        file.writeBytes(blob("SomethingElse", new byte[] {1, 2, 3}, -1));
        for (byte[] block : blocks()) {
            file.writeBytes(blob("OSMData", block, -1));
        }
        return file.toByteArray();
    }

    private List<byte[]> blocks() {
        List<byte[]> blocks = new ArrayList<>();
        ByteArrayOutputStream group = new ByteArrayOutputStream();
        if (isDense) {
            bytes(group, 2, dense());
        } else {
            nodes.forEach(node -> bytes(group, 1, plain(node)));
        }
        for (byte[] part : List.of(group.toByteArray(), ways.toByteArray(), relations.toByteArray())) {
            ByteArrayOutputStream table = new ByteArrayOutputStream();
            strings.keySet().forEach(text -> table.writeBytes(text(1, text)));
            ByteArrayOutputStream block = new ByteArrayOutputStream();
            bytes(block, 1, table.toByteArray());
            bytes(block, 2, part);
            blocks.add(block.toByteArray());
        }
        return blocks;
    }

    /** A file with one house of 20 m x 10 m. */
    public static byte[] house(double latitude, double longitude, boolean isDense, Map<String, String> tags) {
        try {
            return ofAHouse(latitude, longitude, isDense, tags).bytes();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Its blocks of data, not packed. */
    public static List<byte[]> blocksOfAHouse(
            double latitude, double longitude, boolean isDense, Map<String, String> tags) {
        return ofAHouse(latitude, longitude, isDense, tags).blocks();
    }

    private static PbfWriter ofAHouse(double latitude, double longitude, boolean isDense, Map<String, String> tags) {
        PbfWriter writer = new PbfWriter(isDense);
        double[][] corners = {{0, 0}, {0, 2.8e-4}, {0.9e-4, 2.8e-4}, {0.9e-4, 0}};
        for (int i = 0; i < corners.length; i++) {
            writer.node(i + 1, longitude + corners[i][1], latitude + corners[i][0]);
        }
        writer.way(10, new long[] {1, 2, 3, 4, 1}, tags);
        writer.relation(20, List.of(new Member(10, "outer")), Map.of("type", "multipolygon", "building", "yes"));
        return writer;
    }

    private byte[] plain(Node node) {
        ByteArrayOutputStream target = new ByteArrayOutputStream();
        field(target, 1, zigzag(node.id));
        field(target, 8, zigzag(node.latitude));
        field(target, 9, zigzag(node.longitude));
        ByteArrayOutputStream keys = new ByteArrayOutputStream();
        ByteArrayOutputStream values = new ByteArrayOutputStream();
        for (int i = 0; i < node.tags.size(); i += 2) {
            varint(keys, node.tags.get(i));
            varint(values, node.tags.get(i + 1));
        }
        bytes(target, 2, keys.toByteArray());
        bytes(target, 3, values.toByteArray());
        return target.toByteArray();
    }

    private byte[] dense() {
        ByteArrayOutputStream target = new ByteArrayOutputStream();
        ByteArrayOutputStream tags = new ByteArrayOutputStream();
        nodes.forEach(node -> {
            node.tags.forEach(number -> varint(tags, number));
            varint(tags, 0);
        });
        bytes(target, 1, differences(nodes.stream().mapToLong(Node::id).toArray()));
        bytes(target, 8, differences(nodes.stream().mapToLong(Node::latitude).toArray()));
        bytes(target, 9, differences(nodes.stream().mapToLong(Node::longitude).toArray()));
        bytes(target, 10, tags.toByteArray());
        return target.toByteArray();
    }

    private static byte[] differences(long[] numbers) {
        ByteArrayOutputStream target = new ByteArrayOutputStream();
        long before = 0;
        for (long number : numbers) {
            varint(target, zigzag(number - before));
            before = number;
        }
        return target.toByteArray();
    }

    /** A block; states another size than it has if that is not negative. */
    public static byte[] blob(String type, byte[] content, int stated) throws IOException {
        Deflater deflater = new Deflater();
        deflater.setInput(content);
        deflater.finish();
        byte[] packed = new byte[content.length + 100];
        int length = deflater.deflate(packed);
        deflater.end();
        ByteArrayOutputStream blob = new ByteArrayOutputStream();
        field(blob, 2, stated < 0 ? content.length : stated);
        bytes(blob, 3, Arrays.copyOf(packed, length));
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        all.writeBytes(header(type, blob.size()));
        all.writeBytes(blob.toByteArray());
        return all.toByteArray();
    }

    static byte[] header(String type, int size) throws IOException {
        ByteArrayOutputStream header = new ByteArrayOutputStream();
        header.writeBytes(text(1, type));
        field(header, 3, size);
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        new DataOutputStream(all).writeInt(header.size());
        all.writeBytes(header.toByteArray());
        return all.toByteArray();
    }

    public static byte[] text(int number, String text) {
        ByteArrayOutputStream target = new ByteArrayOutputStream();
        bytes(target, number, text.getBytes(StandardCharsets.UTF_8));
        return target.toByteArray();
    }

    private static void field(ByteArrayOutputStream target, int number, long value) {
        varint(target, (long) number << 3);
        varint(target, value);
    }

    private static void bytes(ByteArrayOutputStream target, int number, byte[] content) {
        varint(target, (long) number << 3 | 2);
        varint(target, content.length);
        target.writeBytes(content);
    }

    private static long zigzag(long value) {
        return value << 1 ^ value >> 63;
    }

    private static void varint(ByteArrayOutputStream target, long value) {
        long left = value;
        while ((left & ~0x7FL) != 0) {
            target.write((int) (left & 0x7F | 0x80));
            left >>>= 7;
        }
        target.write((int) left);
    }
}
