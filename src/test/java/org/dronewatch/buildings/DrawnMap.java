package org.dronewatch.buildings;

import java.util.Locale;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;

/** A map of OpenStreetMap that is drawn in metres about an origin. */
public final class DrawnMap {
    private static final int FIRST_WAY = 1000;

    private final Geodesy geodesy;
    private final double level;
    private final StringBuilder nodes = new StringBuilder();
    private final StringBuilder ways = new StringBuilder();
    private int count;
    private int relations;

    /** An empty map about an origin with a height. */
    public DrawnMap(Origin origin) {
        this.geodesy = new Geodesy(origin);
        this.level = origin.height().orElseThrow();
    }

    /**
     * A closed way through points in metres, with tags as in {@code building=yes height=10~m}, where ~
     * is a space; returns its number.
     */
    public int area(double[] ring, String tags) {
        return way(ring, true, tags);
    }

    /** An open way through points in metres. */
    public int line(double[] points, String tags) {
        return way(points, false, tags);
    }

    private int way(double[] points, boolean isClosed, String tags) {
        StringBuilder refs = new StringBuilder();
        int first = count + 1;
        for (int i = 0; i < points.length; i += 2) {
            GeoPoint place = new GeoPoint(0, 0, 0);
            double z = 0.0;
            for (int step = 0; step < 3; step++) {
                place = geodesy.onEarth(new Position(points[i], points[i + 1], z));
                z += level - place.height();
            }
            nodes.append(String.format(
                    Locale.ROOT,
                    "<node id='%d' lat='%.12f' lon='%.12f'/>%n",
                    ++count,
                    place.latitude(),
                    place.longitude()));
            refs.append("<nd ref='").append(count).append("'/>");
        }
        if (isClosed) {
            refs.append("<nd ref='").append(first).append("'/>");
        }
        return way(FIRST_WAY + first, refs.toString(), tags);
    }

    /** A way through nodes that are there, or are missing. */
    public int wayThrough(int id, String tags, int... itsNodes) {
        StringBuilder refs = new StringBuilder();
        for (int node : itsNodes) {
            refs.append("<nd ref='").append(node).append("'/>");
        }
        return way(id, refs.toString(), tags);
    }

    private int way(int id, String refs, String tags) {
        ways.append("<way id='").append(id).append("'>").append(refs).append(tags(tags));
        ways.append("</way>\n");
        return id;
    }

    private static String tags(String tags) {
        StringBuilder text = new StringBuilder();
        for (String tag : tags.isEmpty() ? new String[0] : tags.split(" ")) {
            String[] pair = tag.split("=");
            text.append("<tag k='").append(pair[0]).append("' v='").append(pair[1].replace('~', ' '));
            text.append("'/>");
        }
        return text.toString();
    }

    /** A relation of ways, as in {@code outer=1001 inner=1005}. */
    public void relation(String members, String tags) {
        ways.append("<relation id='").append(9 + relations++).append("'>");
        for (String member : members.split(" ")) {
            String[] pair = member.split("=");
            ways.append("<member type='way' ref='")
                    .append(pair[1])
                    .append("' role='")
                    .append(pair[0])
                    .append("'/>");
        }
        ways.append(tags(tags)).append("</relation>\n");
    }

    /** The map as a file of OpenStreetMap. */
    public String osm() {
        return "<osm version='0.6'>" + nodes + ways + "</osm>";
    }

    /** The same with the ways before their nodes, as Overpass writes them. */
    public String osmOfOverpass() {
        return "<osm version='0.6'>" + ways + nodes + "</osm>";
    }
}
