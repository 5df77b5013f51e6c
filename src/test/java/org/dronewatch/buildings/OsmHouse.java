package org.dronewatch.buildings;

/** A house in the text of an OpenStreetMap file, for tests of scenes. */
public final class OsmHouse {
    private OsmHouse() {}

    /**
     * Nodes and outline of a house that spans 0.0001 degrees to the north and 0.0002 about longitude 15.
     *
     * @param first number of its first node, and of the outline
     * @param south latitude of its southern wall, deg
     * @param tags more tags of the outline
     */
    public static String text(int first, double south, String tags) {
        double[][] corners = {{0, -0.0001}, {0, 0.0001}, {0.0001, 0.0001}, {0.0001, -0.0001}};
        StringBuilder text = new StringBuilder();
        StringBuilder refs = new StringBuilder();
        for (int i = 0; i < 4; i++) {
            text.append("<node id='").append(first + i).append("' lat='").append(south + corners[i][0]);
            text.append("' lon='").append(15.0 + corners[i][1]).append("'/>");
            refs.append("<nd ref='").append(first + i).append("'/>");
        }
        return text + "<way id='" + first + "'>" + refs + "<nd ref='" + first + "'/><tag k='building' v='yes'/>" + tags
                + "</way>";
    }
}
