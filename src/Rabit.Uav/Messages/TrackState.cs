namespace Rabit.Uav.Messages;

/// <summary>The state of a track.</summary>
public enum TrackState
{
    /// <summary>Observed too rarely to be confirmed.</summary>
    Tentative,

    /// <summary>Observed often enough: see <c>SensorFusionOptions.ConfirmHits</c>.</summary>
    Confirmed,

    /// <summary>Was confirmed, and is not seen any more where it should be.</summary>
    Lost,

    /// <summary>The operator rejected it: it is no target.</summary>
    Rejected,
}
