namespace Rabit.Uav.SensorFusion.Metrics;

/// <summary>
/// The generalised OSPA distance and its parts, see <see cref="TrackingMetrics.Gospa"/>. The parts are sums of powers:
/// with order p, <see cref="Distance"/> to the power of p is their sum. A plain value.
/// </summary>
/// <param name="Distance">The distance, metres.</param>
/// <param name="Localisation">Of the pairs: the sum of their distances to the power of p.</param>
/// <param name="Missed">Of the targets without an estimate: half the cutoff's power for each.</param>
/// <param name="False">Of the estimates without a target: half the cutoff's power for each.</param>
public readonly record struct GospaScore(double Distance, double Localisation, double Missed, double False);
