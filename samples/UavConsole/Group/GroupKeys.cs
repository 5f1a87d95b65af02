using System;
using System.Globalization;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;
using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>
/// The keys that command a group by its ground station: all of it, or the vehicle that was chosen with a number and
/// g.
/// </summary>
internal sealed class GroupKeys(SimulatedGroundStation station) : IKeyCommands
{
    private byte _vehicle; // 0: all

    /// <inheritdoc/>
    public string Hint => $"{Who}: r return  h hold  c continue  s skip lane  ll land | 2g to vehicle 2  g to all  "
        + "qq quit";

    /// <inheritdoc/>
    public string NumberName => "number";

    /// <inheritdoc/>
    public string NumberHint => $"g commands go to that vehicle | track of {Who}: v revisit  y is a target  n is none";

    private string Who => _vehicle == 0 ? "all" : "vehicle " + FlightText.Number(_vehicle);

    /// <inheritdoc/>
    public IKeyAnswer? Do(char key, string digits)
    {
        bool hasNumber = int.TryParse(digits, NumberStyles.None, CultureInfo.InvariantCulture, out int number);
        if (key == 'g')
            return Choose(hasNumber ? number : 0);
        OperatorCommand? command = key switch
        {
            'r' => OperatorCommand.Return,
            'h' => OperatorCommand.Hold,
            'c' => OperatorCommand.Continue,
            'l' => OperatorCommand.Land,
            's' => OperatorCommand.SkipLane,
            'v' when hasNumber => OperatorCommand.Revisit,
            'y' when hasNumber => OperatorCommand.Confirm,
            'n' when hasNumber => OperatorCommand.Reject,
            _ => null,
        };
        bool isOfTrack = command is OperatorCommand.Revisit or OperatorCommand.Confirm or OperatorCommand.Reject;
        return command is not { } given ? null
            : !isOfTrack ? new Given(station.Command(_vehicle, given))
            : _vehicle == 0 ? new Said("each vehicle numbers its tracks itself: first a vehicle, with 2g say")
            : number < 1 ? new Said("tracks are numbered from 1 on")
            : new Given(station.Command(_vehicle, given, number));
    }

    private Said Choose(int vehicle)
    {
        if (vehicle != 0 && (vehicle > byte.MaxValue || !station.Vehicles.Contains((byte)vehicle)))
        {
            string received = string.Join(", ", station.Vehicles);
            return new Said($"there is no vehicle {FlightText.Number(vehicle)}"
                + (received.Length == 0 ? ": none was received yet" : "; received were " + received));
        }

        _vehicle = (byte)vehicle;
        return new Said("commands go to " + Who);
    }

    private sealed class Given(StationCommand command) : IKeyAnswer
    {
        public bool IsAnswered => command.IsDone;

        public string Text => command.IsDone || command.Answers.Length > 0
            ? $"{command.Name}: {command.Answer}"
            : command.Name + " ...";
    }

    private sealed class Said(string text) : IKeyAnswer
    {
        public bool IsAnswered => true;

        public string Text => text;
    }
}
