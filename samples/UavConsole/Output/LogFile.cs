using System;
using System.IO;
using System.Text;

namespace UavConsole;

/// <summary>
/// A file that grows line by line. What was there before is kept beside it, under its date. After the first line that
/// cannot be written none is: the file ends with a whole line, and what is lost is counted.
/// </summary>
internal sealed class LogFile(OutputPath path) : IDisposable
{
    private FileStream? _stream;
    private string? _failure;
    private long _lost;

    /// <summary>What was lost, for people; null where nothing was.</summary>
    public string? Loss => _failure is null
        ? null
        : FormattableString.Invariant($"{_failure} ({_lost} lines were lost)");

    public void WriteLine(string line)
    {
        if (_failure is null)
            _failure = TryWrite(Encoding.UTF8.GetBytes(line + "\n"));
        if (_failure is not null)
            _lost++;
    }

    public void Dispose()
    {
        try
        {
            _stream?.Dispose();
        }
        catch (IOException e)
        {
            // Mono keeps what could not be written, and tries it again.
            _failure ??= path.CannotBeWritten(e);
        }

        _stream = null;
    }

    private string? TryWrite(byte[] line)
    {
        try
        {
            _stream ??= Open();
            long end = _stream.CanSeek ? _stream.Position : 0;
            try
            {
                _stream.Write(line, 0, line.Length);
                _stream.Flush();   // Mono buffers eight bytes all the same
            }
            catch (IOException) when (_stream.CanSeek && !path.IsDevice)
            {
                _stream.SetLength(end);
                throw;
            }

            return null;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            return path.CannotBeWritten(e);
        }
    }

    private FileStream Open()
    {
        if (!path.IsDevice)
            DatedFile.Keep(path.Path);
        return new FileStream(
            path.Path, FileMode.OpenOrCreate, FileAccess.Write, FileShare.ReadWrite, bufferSize: 1);
    }
}
