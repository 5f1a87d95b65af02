using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

// Listing all parameters.
public sealed partial class MavlinkParameterClient
{
    private uint? _knownHash;
    private bool _mustStopList;
    private bool _hasCount;
    private int _restarts;
    private int _emptyRounds;
    private int _leftInRound;
    private int _unansweredInRound;
    private int _cursor;
    private TimeSpan _listenFrom;

    /// <summary>Starts to read all parameters.</summary>
    /// <param name="now">The time, by a clock that never goes back.</param>
    /// <param name="knownHash">
    /// The <see cref="Hash"/> that the vehicle sent with a list that the caller has kept: where it sends the same
    /// again, the list is stopped and the outcome is <see cref="MavlinkParameterStatus.Unchanged"/>;
    /// <see cref="Parameters"/> stays as it is. Null: read in any case.
    /// </param>
    /// <returns>Whether it has started; false while <see cref="IsBusy"/>.</returns>
    public bool TryStartList(TimeSpan now, uint? knownHash = null)
    {
        if (IsBusy)
            return false;
        _operation = Operation.List;
        _knownHash = knownHash;
        _mustStopList = _hasCount = false;
        _restarts = _emptyRounds = _leftInRound = _unansweredInRound = _cursor = _tries = _sent = 0;
        _name = default;
        _index = -1;
        _due = _listenFrom = now;
        return true;
    }

    private bool TryNextOfList(TimeSpan now, out MavlinkFrame frame)
    {
        frame = default;
        if (_leftInRound == 0)
        {
            if (_tries > 0 && ++_emptyRounds > _options.EmptyRounds)
            {
                End(MavlinkParameterStatus.Incomplete, default, now);
                return false;
            }

            _tries = 1;
            _leftInRound = _hasCount ? Math.Max(1, Math.Min(_options.RoundSize, Parameters.Missing)) : 1;
            _unansweredInRound = _leftInRound;
        }

        frame = _hasCount ? AskForMissing() : ListRequest();
        _leftInRound--;
        if (_leftInRound == 0)
            _due = now + (_hasCount ? _options.AnswerTimeout : _options.GapTimeout);
        return true;
    }

    private MavlinkFrame ListRequest()
    {
        _sent++;
        return _sender.Create(
            new ParamRequestList { TargetSystem = _target.SystemId, TargetComponent = _target.ComponentId });
    }

    private MavlinkFrame AskForMissing()
    {
        int index = Parameters.NextMissing(_cursor);
        _cursor = index + 1;
        return Request(default, index);
    }

    private void TakeListed(in MavlinkParameter parameter, int count, TimeSpan now)
    {
        if (now < _listenFrom)
            return;
        if (parameter.Index == MavlinkParameter.NoIndex || parameter.Index >= count)
        {
            if (_hasCount)
                Parameters.Update(parameter);
            return;
        }

        if (!_hasCount || count != Parameters.Count)
        {
            if (_hasCount)
            {
                Restart(now);
                return;
            }

            Parameters.Reset(count);
            _hasCount = true;
        }

        if (!Parameters.TryEnter(parameter, out bool isNew))
        {
            // Another name is at this index: parameters were added in front of it, or taken away.
            Restart(now);
            return;
        }

        if (Parameters.Missing == 0)
            End(MavlinkParameterStatus.Done, default, now);
        else if (isNew)
            GoOn(now);
    }

    private void GoOn(TimeSpan now)
    {
        _emptyRounds = 0;
        if (_leftInRound > 0)
            return;
        _unansweredInRound--;
        _due = now + _options.GapTimeout;

        // All that were requested have arrived: the next round at once. The stream itself is not hurried.
        if (_unansweredInRound == 0 && _cursor > 0)
        {
            _due = now;
            _emptyRounds = -1;   // the round to come is not one that failed
        }
    }

    // Not before values of the old list can arrive no more: they would look like the next change.
    private void Restart(TimeSpan now)
    {
        if (++_restarts > _options.Restarts)
        {
            End(MavlinkParameterStatus.Incomplete, default, now);
            return;
        }

        _hasCount = false;
        _tries = _emptyRounds = _leftInRound = _unansweredInRound = _cursor = 0;
        _due = _listenFrom = now + _options.LateAnswerTime;
    }

    private void TakeHash(uint hash, TimeSpan now)
    {
        Hash = hash;
        if (_operation != Operation.List || _tries == 0 || _knownHash != hash || _hasCount)
            return;
        _mustStopList = true;
        _due = now;
        End(MavlinkParameterStatus.Unchanged, default, now);
    }

    // PX4 stops the list when it gets the hash back.
    private bool TryStopList(out MavlinkFrame frame)
    {
        frame = default;
        if (!_mustStopList)
            return false;
        _mustStopList = false;
        frame = SetRequest(HashText, MavParamType.Uint32, Hash.GetValueOrDefault());
        return true;
    }
}
