/** Places with names, from files of maps. */
package org.dronewatch.geo.features;
