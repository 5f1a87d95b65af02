using System.Globalization;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace UavConsole;

/// <summary>The keys that command the mission of one vehicle.</summary>
internal sealed class MissionKeys(IMissionOperator mission) : IKeyCommands
{
    private const string By = "console";

    /// <inheritdoc/>
    public string Hint => "r return  h hold  c continue  s skip lane  0-9 track  ll land  qq quit";

    /// <inheritdoc/>
    public string NumberName => "track";

    /// <inheritdoc/>
    public string NumberHint => "v revisit  y is a target  n is none";

    /// <inheritdoc/>
    public IKeyAnswer? Do(char key, string digits)
    {
        string why = "key " + key;
        bool hasTrack = int.TryParse(digits, NumberStyles.None, CultureInfo.InvariantCulture, out int track);
        OperatorRequest? request = key switch
        {
            'r' => mission.ReturnToLaunch(By, why),
            'h' => mission.Hold(By, why),
            'c' => mission.ContinueMission(By, why),
            'l' => mission.Land(By, why),
            's' => mission.SkipLane(By, why),
            'v' when hasTrack => mission.Revisit(track, By, why),
            'y' when hasTrack => mission.Confirm(track, By, why),
            'n' when hasTrack => mission.Reject(track, By, why),
            _ => null,
        };
        return request is null ? null : new Given(request);
    }

    private sealed class Given(OperatorRequest request) : IKeyAnswer
    {
        public bool IsAnswered => request.Outcome != OperatorOutcome.InProgress;

        public string Text => request.Outcome switch
        {
            OperatorOutcome.Accepted => request.Name + " accepted",
            OperatorOutcome.Refused => $"{request.Name} refused: {request.Answer}",
            _ => request.Name + " ...",
        };
    }
}
