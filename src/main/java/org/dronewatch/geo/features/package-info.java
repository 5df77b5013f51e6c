/** Named places from map files. */
package org.dronewatch.geo.features;
