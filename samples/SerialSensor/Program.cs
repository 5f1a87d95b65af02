using System;
using System.Globalization;
using System.Text;
using Rabit.Core;
using Rabit.Links;

// A range finder that sends a line for each measurement, metres; it may be unplugged and come back at any time.
//     SerialSensor serial:/dev/serial/by-id/usb-range-finder:115200
if (!LinkUrl.TryParse(string.Join(" ", args), out LinkUrl? url, out string? error))
{
    Console.Error.WriteLine($"SerialSensor: {error}");
    return 2;
}

using ReopeningLink link = ReopeningLink.Open(url);
return (await new RabitReactor { new RangeFinder(link) }.RunAsync()).ExitCode;

internal sealed class RangeFinder : RabitManager
{
    private readonly BlockingReader<double> _ranges;
    private readonly IByteLink _link;
    private bool _isOpen;

    public RangeFinder(IByteLink link) : base("range finder")
    {
        (_link, Period) = (link, TimeSpan.FromMilliseconds(50));
        _ranges = AttachReader("ranges", new RangeSource(link), 100, QueueFullMode.DropOldest);
    }

    protected override void ExecuteUnitOfWork()   // woken by each value, and by its period
    {
        if (_isOpen != (_link.State == ByteLinkState.Open))
            Console.WriteLine((_isOpen = !_isOpen) ? "plugged in" : "unplugged");
        while (_ranges.TryPop(out double metres))
            Console.WriteLine(FormattableString.Invariant($"{metres} m"));
    }
}

internal sealed class RangeSource(IByteLink link) : IReaderSource<double>   // runs on the reader's thread
{
    private readonly StringBuilder _line = new();
    private readonly byte[] _byte = new byte[1];
    public bool Blocks => link.Blocks;
    public void Open(ReaderContext context) => _line.Clear();
    public void Unblock() => link.Unblock();
    public void Close() => _line.Clear();

    public ReaderStep Read(out double metres)
    {
        for (metres = 0; link.Read(_byte).Kind == LinkReadKind.Bytes;)   // waits while it is unplugged, too
        {
            string line = _line.Append((char)_byte[0]).ToString();
            if (_byte[0] != '\n' && line.Length < 40) continue;
            _line.Clear();   // also of noise without an end of line
            if (double.TryParse(line, NumberStyles.Float, CultureInfo.InvariantCulture, out metres))
                return ReaderStep.Value;
        }
        return ReaderStep.Ended;   // the program stops
    }
}
