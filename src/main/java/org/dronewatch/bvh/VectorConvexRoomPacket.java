package org.dronewatch.bvh;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorSpecies;
import org.dronewatch.kdtree.LeafOrderTriangles;
import org.dronewatch.kdtree.RayTracer;

/** A {@link ConvexRoomPacket} that finds walls with vector instructions, one ray in each lane. */
final class VectorConvexRoomPacket extends ConvexRoomPacket {
    private static final VectorSpecies<Double> DOUBLES = DoubleVector.SPECIES_256;
    private static final VectorSpecies<Long> LONGS = LongVector.SPECIES_256;

    VectorConvexRoomPacket(LeafOrderTriangles inLeafOrder, ConvexRoom room, RayTracer one) {
        super(inLeafOrder, room, one);
    }

    @Override
    void findWalls() {
        double[] walls = planes;
        double[] ts = parameters;
        DoubleVector originX = load(0);
        DoubleVector originY = load(RAYS);
        DoubleVector originZ = load(2 * RAYS);
        DoubleVector directionX = load(3 * RAYS);
        DoubleVector directionY = load(4 * RAYS);
        DoubleVector directionZ = load(5 * RAYS);
        LongVector best = LongVector.broadcast(LONGS, Long.MAX_VALUE);
        LongVector signs = LongVector.broadcast(LONGS, -1L);
        int wall = 0;
        for (int at = 0; at < walls.length; at += PLANE) {
            DoubleVector x = DoubleVector.broadcast(DOUBLES, walls[at]);
            DoubleVector y = DoubleVector.broadcast(DOUBLES, walls[at + 1]);
            DoubleVector z = DoubleVector.broadcast(DOUBLES, walls[at + 2]);
            DoubleVector height = x.mul(originX)
                    .add(y.mul(originY))
                    .add(z.mul(originZ))
                    .sub(DoubleVector.broadcast(DOUBLES, walls[at + 3]));
            DoubleVector rise = x.mul(directionX).add(y.mul(directionY)).add(z.mul(directionZ));
            DoubleVector t = height.div(rise);
            t.intoArray(ts, RAYS * wall);
            best = best.min(t.reinterpretAsLongs().and(~NUMBER).or((long) wall));
            signs = signs.and(height.reinterpretAsLongs());
            wall++;
        }
        best.intoArray(nearest, 0);
        signs.intoArray(inside, 0);
    }

    private DoubleVector load(int at) {
        return DoubleVector.fromArray(DOUBLES, lanes, at);
    }
}
