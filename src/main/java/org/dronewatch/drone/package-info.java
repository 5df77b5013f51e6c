/** What flies: a mesh with an attitude, its sound, radar, heat and radio signatures, and what it is up to. */
package org.dronewatch.drone;
