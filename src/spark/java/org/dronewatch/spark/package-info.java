/** Campaigns on the machines of an Apache Spark cluster. */
package org.dronewatch.spark;
